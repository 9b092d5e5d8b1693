"""What a desk can do: each takes a function to report the fraction done, then its arguments."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from upright.atomic import finite
from upright.control import Controller, gain_of
from upright.errors import InvalidController, SpecMismatch
from upright.lab.codec import encode
from upright.lab.display import View
from upright.lab.handin import HandIn, write_hand_in
from upright.lab.messages import Analysed, JobResult, Light, Setup
from upright.lab.page_words import for_page
from upright.lab.plant import design as design_of
from upright.lab.plant import design_part, plant_of
from upright.languages import ENGLISH, speaking
from upright.pages import english
from upright.robots import Kit, Robot
from upright.signals import Log

if TYPE_CHECKING:
    from upright.certification import Certificate
    from upright.certification.verdict import LinearMargins
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
    """Gains, margins, poles and the broken loop; only the gains where the controller is not linear."""
    from upright.loops.analysis import INPUTS
    from upright.loops.loop import robot_loop
    from upright.loops.margins import margins

    K = gain_of(controller)
    gain = () if K is None else tuple(tuple(row) for row in K.tolist())
    try:
        loop = robot_loop(controller, robot, kit)
    except (InvalidController, SpecMismatch) as error:
        return Analysed(stable=False, words=str(error).split(";")[0], gain=gain)
    poles = tuple((round(float(p.real), 5), round(float(p.imag), 5)) for p in loop.poles())
    curve = _curve(loop)
    if not loop.stable:
        words = f"The loop is unstable: its largest pole is at |z| = {abs(loop.poles()[0]):.4f}."
        return Analysed(stable=False, words=words, gain=gain, poles=poles, L=curve)
    m = margins(loop.at_input, INPUTS["both motors"], "both motors")
    m = replace(m, delay=min(m.delay, loop.delay_margin()))  # one number in table and sentence
    return Analysed(
        stable=True, words=m.words(), gain=gain, gain_low=m.gain_low, gain_high=finite(m.gain_high),
        phase=finite(m.phase), delay=finite(m.delay), poles=poles, L=curve,
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
        return Light("none", (str(error).split(";")[0],))
    return _lit(certificate)


def _lit(certificate: Certificate) -> Light:
    light = "amber" if certificate.light == "unknown" else certificate.light  # the page's lamp has three colours
    return Light(light, tuple(map(str, certificate.reasons)), **smallest(certificate.linear))  # type: ignore[arg-type]


def smallest(linear: LinearMargins | None) -> dict[str, Any]:
    """What a `Light` says of the smallest margins of all places; nothing where there are none."""
    if linear is None or not linear.stable:
        return {}
    return {
        "delay": finite(linear.delay), "delay_at": linear.delay_at, "gain_low": linear.gain_low,
        "low_at": linear.low_at, "gain_high": finite(linear.gain_high), "high_at": linear.high_at, "met": linear.met,
    }  # fmt: skip


def certify(report: Report, setup: Setup) -> tuple[Light, JobResult]:
    """The whole certificate, as `upright certify` gives it."""
    from upright.certification import certify as certified

    plant = plant_of(setup)
    report(0.02)
    controller = design_of(setup, plant.nominal, plant.kit)
    certificate = certified(controller, plant.nominal, plant.kit, threads=1, progress=report)
    rows = tuple(
        (t.push, t.battery, f"{t.fell}/{t.runs}", f"{t.saturated:.0%}", f"{t.travel:.2f}", f"{t.peak:.3f}")
        for t in certificate.trials
    )
    header = ("push", "battery", "fell", "saturated", "travel [m]", "peak [rad]")
    title = f"{certificate.controller} on {certificate.robot}: {certificate.light}"
    return _lit(certificate), JobResult(
        "certify",
        title,
        "\n".join(map(str, certificate.reasons)),
        header,
        rows,
        certificate.light not in ("red", "unknown"),
    )


def doctor(report: Report, source: Path | Log, robot: Robot) -> tuple[JobResult]:
    """What is wrong with a log."""
    from upright.checkup.doctor import doctor as examine

    diagnosis = examine(source, robot=robot, progress=report)
    rows = tuple(
        (f.severity, f.code, f.channel, english(f.evidence), for_page(english(f.repair) if f.repair else "", "doctor"))
        for f in diagnosis.findings
    )
    name = Path(diagnosis.source).name if diagnosis.source else "this run"
    title = f"{name}: {diagnosis.rows} rows, {diagnosis.seconds:.1f} s, every {1e3 * diagnosis.period:.3g} ms"
    text = "" if rows else "Nothing found: this log can be used as it is."
    return (JobResult("doctor", title, text, ("", "what", "channel", "evidence", "repair"), rows, diagnosis.healthy),)


def calibrate(report: Report, source: Path | Log, robot: Robot, kit: Kit) -> tuple[Robot, JobResult]:
    """The robot's parameters from a log of raw sensors and commands."""
    from upright.calibration.calibrate import calibrate as learn
    from upright.logs.raw import raw_log

    log = source if isinstance(source, Log) else raw_log(source)
    calibration = learn(_raw(log), robot, kit, progress=report)
    estimates = (*calibration.parameters, *calibration.combinations)
    rows = tuple((e.name, f"{e.value:.4g}", f"{e.low:.4g} … {e.high:.4g}", f"{e.prior:.4g}", e.unit, e.verdict)
                 for e in estimates)  # fmt: skip
    header = ("parameter", "value", "95 %", "prior", "unit", "what the log tells")
    with speaking(ENGLISH):  # the page translates
        remarks = [str(one) for one in (*calibration.check(), *calibration.notes, *calibration.unseen)]
    text = "\n".join(map(for_page, remarks))
    title = f"{robot.name} from {calibration.samples} samples"
    return calibration.robot, JobResult("calibrate", title, text, header, rows, not calibration.check())


def _raw(log: Log) -> Log:
    """Sensors and commands alone: a calibration must not see the truth."""
    measured = {n: x for n, x in log.channels.items() if n.startswith(("sensor/", "command/", "applied/"))}
    return Log(log.t, measured, {n: u for n, u in log.units.items() if n in measured}, log.origin)


def robot(report: Report, path: str) -> Robot:  # noqa: ARG001 (it is over at once)
    """A robot file that was uploaded."""
    return Robot.load(path)


def keep_log(report: Report, log: Log, path: Path) -> Path:  # noqa: ARG001
    """The run as a file, by its suffix."""
    return log.save(path)


def keep_report(report: Report, logs: dict[str, Log], path: Path) -> Path:  # noqa: ARG001
    """All bodies compared, as a page."""
    from upright.comparison import compare
    from upright.reports import report as write_report

    return write_report(compare(logs), path)


def keep_comparison(report: Report, opened: tuple[Path, Robot, Kit], logs: dict[str, Log], path: Path) -> Path:
    """An opened log compared with the run of every body, as a page; times count from the first push of each."""
    from upright.logs.raw import raw_log

    source, robot, kit = opened
    log = _with_states(raw_log(source), robot, kit)
    report(0.5)
    name = source.stem.removeprefix("in-")
    return keep_report(report, {label: _from_push(one) for label, one in {name: log, **logs}.items()}, path)


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


def keep_controller(report: Report, setup: Setup, path: Path) -> Path:  # noqa: ARG001
    """The controller as a file for `upright simulate` and `upright certify`."""
    from upright.control import write_controller

    plant = plant_of(setup)
    return write_controller(design_of(setup, plant.nominal, plant.kit), path)


def keep_robot(report: Report, which: Robot, path: Path) -> Path:  # noqa: ARG001
    """The robot as a TOML file."""
    return which.save(path)


def keep_replay(report: Report, recorded: tuple[list[Any], View, Any], path: Path) -> Path:  # noqa: ARG001
    """The last minute as a page that replays it without a server, from what it begins with and the display's rows."""
    from upright.lab.recording import replay_page

    begin, view, rows = recorded
    return replay_page([*begin, *(view.snapshot(row, i, 0.0, False) for i, row in enumerate(rows.tolist()))], path)


def keep_hand_in(report: Report, done: HandIn, path: Path) -> Path:  # noqa: ARG001
    """The run as seed and actions, for `upright grade`."""
    return write_hand_in(done, path)


def _in_folder(keep: Callable[..., Path]) -> Callable[..., Path]:
    """`keep`, whose last argument is a path, after making the session's folder."""

    def made(report: Report, *args: Any) -> Path:
        args[-1].parent.mkdir(mode=0o700, exist_ok=True)
        return keep(report, *args)

    return made


_KEEPING: dict[str, Callable[..., Path]] = {
    "csv": keep_log, "parquet": keep_log, "report": keep_report, "compare": keep_report, "comparison": keep_comparison,
    "handin": keep_hand_in, "controller": keep_controller, "robot": keep_robot, "replay": keep_replay,
}  # fmt: skip

TASKS: dict[str, Callable[..., Any]] = {
    "design": design, "light": light, "certify": certify, "doctor": doctor, "calibrate": calibrate, "robot": robot,
    **{f"keep {what}": _in_folder(keep) for what, keep in _KEEPING.items()},
}  # fmt: skip
"""By the name that a session submits them under."""
