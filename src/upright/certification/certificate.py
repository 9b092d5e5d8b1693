"""Whether a controller may drive a robot: a light, its reasons in words and numbers, and the measurements behind it.

Robots are drawn from the uncertainty of the robot. Each is tried with every standard push at every battery voltage, in
the nonlinear model with the kit's faults. A robot that falls in any of these trials counts as fallen. The probability
of a fall is bounded from above by Clopper and Pearson (1934).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from types import NoneType
from typing import TYPE_CHECKING, Any, get_args, get_origin, get_type_hints

from upright.atomic import finite, write_json
from upright.certification.checks import (
    RunCounter,
    TrialSetup,
    enough_robots,
    followed_runs,
    kernel_controller,
    trials,
)
from upright.certification.mass import as_weighed
from upright.certification.measured import Measurements
from upright.certification.narrowing import BY_HAND, guessed, narrowing, red
from upright.certification.standing import (
    delay_sweep,
    endured,
    period_sweep,
    runs_of,
    standing,
    strong_enough,
)
from upright.certification.verdict import (
    CONFIDENCE,
    MOST_FALLS,
    RED,
    UNKNOWN,
    Examined,
    judge,
    linear_margins,
)
from upright.checkup.wheels import on_its_wheels
from upright.control import find_controller
from upright.control.controller import Controller
from upright.control.identity import Identity, identity
from upright.errors import InvalidController, InvalidScenario
from upright.fleets.binomial import upper_bound
from upright.languages import ENGLISH, speaking
from upright.likelihood.agreement import agreement
from upright.likelihood.assumptions import Assumptions, as_sent
from upright.likelihood.calibrated import Met, met
from upright.logs.mapping import Mapping as Columns
from upright.logs.raw import LogSource, raw_log
from upright.pages import Result
from upright.progress import Progress
from upright.reading import check_schema, check_types, named, read_json, understood
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.facts import Facts, differences, kit_facts, robot_facts
from upright.robots.motor import refuse_energy
from upright.robots.uncertainty import Uncertainty, at_medians, draw
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page

SCHEMA = "upright/certify/8"
"""8: its file says so by this name; 7: its pushes have a kind and a slope, and its reasons say their limit;
6: it answers whether the robot stands, how hard it may be pushed, and which guess decides;
5: a log that shows what was not assumed, or leaves it open, is amber at most;
4: an unstable loop is the first reason, a free position none for red;
3: pushes are scaled to what any controller could survive; 2: robot and kit are named by their numbers."""


@dataclass(frozen=True, repr=False, kw_only=True)
class Certificate(Result, Measurements):
    """The measurements and the light that follows from them: who asks it may drive a robot or not."""

    def check(self) -> tuple[str, ...]:
        """Contradictions among this certificate's own numbers, as sentences; none where it is consistent."""
        bound = upper_bound(self.fell, self.samples, CONFIDENCE)
        light, _ = judge(self)
        wrong = (
            [f"the bound is {self.bound:g}; its numbers give {bound:g}"] if not math.isclose(bound, self.bound) else []
        )
        wrong += [f"the light is {self.light}; its numbers give {light}"] if light != self.light else []
        most = max(t.fell for t in self.trials)
        fallen, hopeless = (sum(getattr(t, n) for t in self.trials) for n in ("fell", "beyond"))
        fits = most <= self.fell <= fallen and self.beyond <= min(self.fell, hopeless)
        fits &= {t.runs for t in self.trials} == {self.samples}
        return (*wrong, *(() if fits else ("the trials and the number of falls disagree",)))

    def refuses(self, controller: Controller | None = None, robot: Robot | None = None, kit: Kit | None = None) -> str:
        """Why a robot should not be driven with this certificate, as a sentence; empty where it may. It is red or
        unknown, contradicts itself, or is of another controller, robot, kit or period than these, each as far as it is
        known.
        """
        if wrong := self.check():
            return f"the certificate contradicts itself: {wrong[0]}"
        if self.light in (RED, UNKNOWN):
            return f"{self.light}: {self.reasons[0]}".rstrip(".")
        others = [self._period_and_controller(controller)] if controller else []
        others += [self._other("robot", self.robot, robot.name, robot_facts(robot))] if robot else []
        others += [self._other("kit", self.kit, kit.name, kit_facts(kit))] if kit else []
        return f"the certificate is of {'; of '.join(filter(None, others))}" if any(others) else ""

    def _period_and_controller(self, controller: Controller) -> str:
        if not math.isclose(controller.spec.period, self.period):
            return f"another period: period {controller.spec.period:g} s instead of {self.period:g} s"
        return identity(controller).differs(Identity(self.hash, self.asked, self.response))

    def _other(self, what: str, certified: str, name: str, facts: Facts) -> str:
        """The differences of a robot or a kit, led by its name where that differs too."""
        if not (others := differences(facts, self.subject[what])):
            return ""
        return f"another {what}: {f'{what} {name} instead of {certified}, ' if name != certified else ''}{others}"

    def page(self) -> Page:
        """The certificate for people."""
        from upright.certification.certificate_page import certificate_page

        return certificate_page(self)

    def plot(self) -> Figure:
        """How many robots fell [%], or the travel [m] of 95 % of them where none did: a bar for every push at every
        battery, the worst first. Above falls stands the bound on all pushes together, which the limit is for."""
        from upright.certification.certificate_page import bars_of

        return bars_of(self)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers, None for what is unlimited; the reasons, and how to measure what decides, in English."""
        linear = {k: finite(v) for k, v in asdict(self.linear).items()} if self.linear else None
        with speaking(ENGLISH):
            reasons = [str(reason) for reason in self.reasons]
            by_hand = {name: str(BY_HAND[name]) for name in self.to_measure() if name in BY_HAND}
        numbers = asdict(self) | {"linear": linear}
        return {"schema": SCHEMA} | numbers | {"reasons": reasons, "by_hand": by_hand}

    def save(self, path: str | Path) -> Path:
        """Write it as JSON, as `upright firmware` and `upright fly` ask for it. Returns the path."""
        return write_json(path, self.to_json())

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Certificate:
        """The inverse of `to_json`; raises `InvalidController` for one that is broken or contradicts itself."""
        with understood("not a certificate: it", InvalidController, "JSON by upright certify"):
            certificate = _read(cls, data)
            check_types(certificate)
        return certificate


def certify(
    controller: Controller | str,
    robot: Robot | str,
    kit: Kit | str | None = None,
    *,
    samples: int = 1000,
    seed: int = 0,
    robots: Sequence[Robot] | None = None,
    sweeps: bool = True,
    threads: int | None = None,
    log: LogSource | None = None,
    mapping: Columns | str | None = None,
    posterior: Uncertainty | str | Path | None = None,
    weighed: float | None = None,
    period: float | None = None,
    progress: Progress | None = None,
) -> Certificate:
    """The certificate of `controller` for `robot` with `kit`, over `robots` or `samples` draws.

    A named method is designed for a `period` [s] (None: the kit's). `posterior` is an `Uncertainty`, or a file by
    `upright calibrate --save`; its medians are then the nominal robot. By default robots are drawn from the spreads in
    the robot's file. `log` is a recording of this robot, read through `mapping`. Without a `posterior` the robot is
    first calibrated from it. What it contradicts of the assumptions is tried as the log shows it. Body and wheels
    `weighed` so much [kg] together on a scale as the robot stands: then no log is asked the mass. `sweeps` adds further
    dead times and other periods, on which the light does not depend. Controller, robot and kit may be names or files; a
    controller's name is its design for the robot as stated, whatever a log shows. One of your own is called for each
    robot: 1000 samples take minutes. `progress` receives the fraction done. Raises `SpecMismatch`, `InvalidScenario`,
    `InvalidLog` and `InvalidRobot` for what does not fit.
    """
    given = refuse_energy(find_robot(robot))
    nominal, unknown = at_medians(given, posterior)
    parts = find_kit(kit or nominal.kit)
    stated = (nominal, parts)
    recording = None if log is None else on_its_wheels(as_sent(raw_log(log, mapping)))[0]
    design = _controller(controller, *stated, period)
    driving = kernel_controller(design, *stated)
    alone = posterior is None and robots is None
    rubs = nominal.coulomb_friction > 0
    nominal = as_weighed(nominal, weighed, alone=alone, logged=alone and recording is not None)
    family = enough_robots(draw(nominal, samples, seed, unknown) if robots is None else list(robots), nominal)
    assumed = Assumptions(nominal, family, parts, seed, dry_friction=rubs, is_weighed=weighed is not None)
    now = Met(assumed, unknown, (), ())
    if recording:
        now = met(recording, assumed, unknown, alone=alone, progress=progress)
    setup = TrialSetup(**vars(now.assumed), controller=driving, threads=threads, stated=stated)
    setup = replace(setup, progress=progress and RunCounter(runs_of(setup, sweeps=sweeps), progress))
    drawn = (now.unknown or Uncertainty.of(nominal)) if robots is None else None
    judged = _examined(setup, design, recording, now._replace(unknown=drawn), sweeps=sweeps)
    light, _ = judge(judged)
    who = identity(design)
    return Certificate(
        **vars(judged), light=light, bound=upper_bound(judged.fell, judged.samples, CONFIDENCE),
        robot=setup.robot.name, kit=setup.kit.name, controller=design.spec.kind, hash=who.hash, seed=seed,
        subject={"robot": robot_facts(given), "kit": kit_facts(stated[1])}, asked=who.asked, response=who.response,
        endured=endured(setup) if sweeps else (),
        strength=strong_enough(setup) if judged.beyond > MOST_FALLS * len(family) else None,
        delayed=delay_sweep(setup) if sweeps else (), slower=period_sweep(setup) if sweeps else (),
        weighed=weighed, given=controller if isinstance(controller, str) else "",
    )  # fmt: skip


def _controller(controller: Controller | str, robot: Robot, kit: Kit, period: float | None) -> Controller:
    """The controller itself, or the one of that name, for a `period` [s] (None: the kit's)."""
    design = find_controller(controller, robot, kit, period or kit.period)
    if period and not math.isclose(design.spec.period, period):
        raise InvalidScenario(f"a period of {period:g} s for a controller of {design.spec.period:g} s",
                              expected="a name, or a controller of this period",
                              hint="the table of periods tells how its gains fare at others")  # fmt: skip
    return design


def _examined(setup: TrialSetup, design: Controller, recording: Log | None, now: Met, *, sweeps: bool) -> Examined:
    """The trials of `setup`, and what its robots do alone; what is guessed, of the robot as it is `now` known."""
    unknown = now.unknown
    runs, fallen, beyond = trials(setup)
    linear = linear_margins(design, setup.actual_robot, setup.actual_kit, usual=True)
    alone = standing(setup, sweeps=sweeps)
    many = red(int(fallen.sum()), len(fallen)) or red(alone.lost, alone.runs)
    narrowed = sweeps and many and not setup.controller.called
    period = design.spec.period
    return Examined(
        len(fallen), int(fallen.sum()), linear, runs, period,
        agreement(recording, setup, followed_runs(setup), period) if recording else (),
        now.support, beyond=int(beyond.sum()), taken=now.taken, standing=alone,
        guessed=guessed(setup, unknown, fallen, tried=many) if unknown else None,
        narrowing=narrowing(setup, unknown, fallen) if unknown and narrowed else None,
    )  # fmt: skip


def read_certificate(path: str | Path) -> Certificate:
    """The certificate in a file by `upright certify -o`; raises `InvalidController` for what is none."""
    data = read_json(path, InvalidController, "a certificate, JSON by upright certify")
    with named(path, InvalidController):
        return Certificate.from_json(data)


def _read(cls: type[Certificate], data: Mapping[str, Any]) -> Certificate:
    given = dict(data)
    check_schema(given, SCHEMA, InvalidController)
    sentences = {name: given.pop(name) for name in ("reasons", "by_hand")}
    given["subject"] = {what: dict(given["subject"][what]) for what in ("robot", "kit")}
    certificate = _made(cls, given)
    if wrong := certificate.check():
        raise ValueError(wrong[0])
    if sentences != {name: certificate.to_json()[name] for name in sentences}:
        raise ValueError("the reasons do not follow from its numbers")
    return certificate


def _made(kind: Any, data: Any) -> Any:
    """A value of this type from what JSON keeps of it: None for what is unlimited, lists for tuples."""
    inner = get_args(kind)
    if hasattr(kind, "__dataclass_fields__"):
        kinds = get_type_hints(kind)
        return kind(**{name: _made(kinds[name], value) for name, value in data.items()})
    if get_origin(kind) is tuple:
        return tuple(_made(inner[0], value) for value in data)
    if kind is float:
        return math.inf if data is None else data
    return data if data is None or NoneType not in inner else _made(inner[0], data)
