"""What a desk can do: each takes a function to report the fraction done, then its arguments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from upright.control import Controller, gain_of
from upright.errors import InvalidController, SpecMismatch
from upright.lab.codec import encode
from upright.lab.display import View
from upright.lab.handin import write_hand_in
from upright.lab.message_types import Job
from upright.lab.messages import Analysed, JobResult, Light, Setup
from upright.lab.plant import design as design_of
from upright.lab.plant import design_part, plant_of
from upright.lab.recording import FILES
from upright.lab.spoken import heads_of, in_each
from upright.languages import speaking
from upright.pages import Message, Page, Result, html
from upright.robots import Kit, Robot
from upright.signals import Log

if TYPE_CHECKING:
    from upright.certification import Certificate
    from upright.loops.loop import Loop


class Report(Protocol):
    """What is called with the fraction done, and with the number of runs where they are counted."""

    def __call__(self, fraction: float, runs: int = 0, /) -> None: ...


QUICK = 300
"""Robots behind the light that follows every change: without a fall they bound its chance to 1 %."""

SHOWN_FREQUENCIES = 160

DISTURBED = 0.03
"""[1] Process noise of the filter that finds the states of an opened log, as a fraction of the commands."""

REMEMBERED = 64
"""Loops whose analysis is kept: a class begins with thirty that are alike."""

_KNOWN: dict[str, tuple[Controller, Analysed]] = {}


def design(report: Report, setup: Setup, keep: bool) -> tuple[Controller | None, Analysed]:
    """The controller where it is to be kept, and what linear theory says of its loop."""
    part = encode(design_part(setup))
    if part not in _KNOWN:
        plant = plant_of(setup)
        controller = design_of(setup, plant.nominal, plant.kit)
        report(0.3)
        _KNOWN[part] = controller, analysed(controller, plant.nominal, plant.kit)
    controller, analysis = _KNOWN[part]
    if len(_KNOWN) > REMEMBERED:
        _KNOWN.pop(next(iter(_KNOWN)))
    return (controller if keep else None), analysis


def analysed(controller: Controller, robot: Robot, kit: Kit) -> Analysed:
    """What a design's page says of the loop, its poles, and the broken loop; only the gains where the controller is not
    linear."""
    from upright.certification.design_page import unknown_margins
    from upright.loops.analysis import analyse

    K = gain_of(controller)
    gain = () if K is None else tuple(tuple(row) for row in K.tolist())
    try:
        analysis = analyse(controller, robot, kit, robots=())
    except (InvalidController, SpecMismatch) as error:
        return Analysed(stable=False, heads=heads_of(unknown_margins(error.parts["came"])), gain=gain)
    return Analysed(
        stable=analysis.loop.stable, heads=heads_of(analysis.page()), gain=gain,
        poles=tuple((round(float(p.real), 5), round(float(p.imag), 5)) for p in analysis.poles),
        L=_curve(analysis.loop),
    )  # fmt: skip


def _curve(loop: Loop) -> tuple[tuple[float, ...], ...]:
    from upright.loops.analysis import INPUTS, broken_input, response_of

    omega, L = response_of(broken_input(loop, INPUTS["both motors"]), SHOWN_FREQUENCIES)
    return tuple(tuple(float(f"{v:.4g}") for v in row) for row in (omega, L.real, L.imag))


def light(report: Report, setup: Setup) -> Light:
    """The light that follows a change, over fewer robots than a certificate."""
    from upright.certification import certify
    from upright.certification.checks import PUSHES, conditions
    from upright.certification.standing import REPEATED

    plant = plant_of(setup)
    runs = QUICK * (PUSHES * len(conditions(plant.nominal, plant.kit)) + 1) + REPEATED
    report(0.0, runs)

    def show(fraction: float) -> None:
        report(fraction, runs)

    controller = design_of(setup, plant.nominal, plant.kit)
    try:
        certificate = certify(
            controller, plant.nominal, plant.kit, samples=QUICK, sweeps=False, threads=1, progress=show
        )
    except SpecMismatch as error:
        return Light(heads=heads_of(Page(Message(error.parts["came"]))))
    return _lit(certificate)


def _lit(certificate: Certificate) -> Light:
    return Light(certificate.light, heads_of(certificate.page()))  # type: ignore[arg-type]


def _page_of(job: Job, result: Result) -> JobResult:
    """The result's page, as it is."""
    page = result.page()
    return JobResult(job, heads_of(page), in_each(lambda: html.shadow(page)))


def certify(report: Report, setup: Setup) -> tuple[Light, JobResult]:
    """The whole certificate, as `upright certify` gives it."""
    from upright.certification import certify as certified

    plant = plant_of(setup)
    report(0.02)
    controller = design_of(setup, plant.nominal, plant.kit)
    certificate = certified(controller, plant.nominal, plant.kit, threads=1, progress=report)
    return _lit(certificate), _page_of("certify", certificate)


def doctor(report: Report, source: Path | Log, robot: Robot) -> tuple[JobResult]:
    """What is wrong with a log."""
    from upright.checkup.doctor import doctor as examine

    return (_page_of("doctor", replace(examine(source, robot=robot, progress=report), source=_shown(source))),)


def calibrate(report: Report, source: Path | Log, robot: Robot, kit: Kit) -> tuple[Robot, JobResult]:
    """The robot's parameters from a log of raw sensors and commands."""
    from upright.calibration.calibrate import calibrate as learn
    from upright.logs.raw import raw_log

    log = source if isinstance(source, Log) else raw_log(source)
    calibration = learn(_raw(log), robot, kit, progress=report)
    return calibration.robot, _page_of("calibrate", replace(calibration, sources=(_shown(source),)))


def _shown(source: Path | Log) -> str:
    """The name of an opened log as its owner knows it, or of the run as it is kept."""
    return FILES["csv"] if isinstance(source, Log) else source.name.removeprefix("in-")


def _raw(log: Log) -> Log:
    """Sensors and commands alone: a calibration must not see the truth."""
    measured = {n: x for n, x in log.channels.items() if n.startswith(("sensor/", "command/", "applied/"))}
    return Log(log.t, measured, {n: u for n, u in log.units.items() if n in measured}, log.origin)


def robot(report: Report, path: str) -> Robot:  # noqa: ARG001 (it is over at once)
    """A robot file that was uploaded."""
    return Robot.load(path)


def keep_report(logs: dict[str, Log], language: str, path: Path) -> Path:
    """All bodies compared, as a page."""
    from upright.comparison import compare
    from upright.reports import report as write_report

    with speaking(language):
        return write_report(compare(logs), path)


def keep_comparison(opened: tuple[Path, Robot, Kit], logs: dict[str, Log], language: str, path: Path) -> Path:
    """An opened log compared with the run of every body, as a page; times count from the first push of each."""
    from upright.logs.raw import raw_log

    source, robot, kit = opened
    log = _with_states(raw_log(source), robot, kit)
    name = Path(_shown(source)).stem
    return keep_report({label: _from_push(one) for label, one in {name: log, **logs}.items()}, language, path)


def _from_push(log: Log) -> Log:
    """The log with its time counted from the beginning of its first push, or of itself."""
    pushed = "push/force" in log and log["push/force"].any()
    start = log.t[(log["push/force"] != 0).argmax()] if pushed else log.t[0]
    return Log(log.t - start, log.channels, log.units, log.origin)


def _with_states(log: Log, robot: Robot, kit: Kit) -> Log:
    """The log with its robot's states: its own, or where it has none those of a Kalman filter along its readings."""
    import numpy as np

    from upright.calibration.filter_log import filter_log
    from upright.signals import STATE_NAMES

    if any(all(f"{prefix}/{name}" in log for name in STATE_NAMES) for prefix in ("truth", "estimate")):
        return log
    filtered = filter_log(log, robot, kit, delay=kit.delay, disturbance=DISTURBED)
    latest = np.searchsorted(filtered.sample, np.arange(len(log)), side="right") - 1
    states = filtered.after[np.clip(latest, 0, None), : len(STATE_NAMES)]
    rebuilt = {f"estimate/{name}": states[:, i] for i, name in enumerate(STATE_NAMES)}
    return Log(log.t, {**log.channels, **rebuilt}, log.units, log.origin)


def keep_controller(setup: Setup, path: Path) -> Path:
    """The controller as a file for `upright simulate` and `upright certify`."""
    from upright.control import write_controller

    plant = plant_of(setup)
    return write_controller(design_of(setup, plant.nominal, plant.kit), path)


def keep_replay(recorded: tuple[list[Any], View, Any], path: Path) -> Path:
    """The last minute as a page that replays it without a server, from what it begins with and the display's rows."""
    from upright.lab.recording import replay_page

    begin, view, rows = recorded
    return replay_page([*begin, *(view.snapshot(row, i, 0.0, False) for i, row in enumerate(rows.tolist()))], path)


_KEEPING: dict[str, Callable[..., Path]] = {
    "csv": Log.save, "parquet": Log.save, "report": keep_report, "compare": keep_report, "comparison": keep_comparison,
    "handin": write_hand_in, "controller": keep_controller, "robot": Robot.save, "replay": keep_replay,
}  # fmt: skip


def keep(report: Report, what: str, *args: Any) -> Path:  # noqa: ARG001
    """A file of the session, whose path is the last argument, in its folder, which is made with the first one."""
    args[-1].parent.mkdir(mode=0o700, exist_ok=True)
    return _KEEPING[what](*args)


TASKS: dict[str, Callable[..., Any]] = {
    "design": design, "light": light, "certify": certify, "doctor": doctor, "calibrate": calibrate, "robot": robot,
    "keep": keep,
}  # fmt: skip
"""By the name that a session submits them under."""
