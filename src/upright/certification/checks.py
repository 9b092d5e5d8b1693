"""What a certificate measures: falls of drawn robots under the standard pushes, with more dead time, at other periods.

All of it is the nonlinear model in the batch kernel, with the kit's quanta, noise, dead time, limits and battery.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import KW_ONLY, dataclass, replace
from functools import cached_property
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from upright.arrays import Array, Mask
from upright.certification.pushes import KINDS, StandardPush, standard_pushes
from upright.certification.recovery import means, recoverable
from upright.control.controller import Controller
from upright.control.delay import RAW
from upright.control.linear_controller import Law
from upright.control.splitting import Splitting
from upright.errors import InvalidScenario, SpecMismatch
from upright.fleets.binomial import MOST_FALLS, upper_bound
from upright.fleets.ensemble import SETTLED, tables
from upright.kernel.batch import NAMES, FleetBatch, FleetResult, joined, law_of, parameters_of
from upright.kernel.pack import RESIDUAL
from upright.kernel.simulate import CALLED, simulate
from upright.likelihood.agreement import DrawnRuns
from upright.likelihood.assumptions import BATTERIES, NOISED, Assumptions, Logged, batteries
from upright.pages import Quantity, Say
from upright.robots import Kit, Robot

SECONDS = 8.0  # [s] a push, what follows it, and `TAIL` to see what the robot does at rest
TAIL = 2.0  # [s] at the end, over which the limit cycle is measured: several of its periods
CONFIDENCE = 0.95
MOST_CYCLE = 0.1  # [rad] of a sway at rest: as far as the paper's pushes lean a robot

FEWEST = 100
"""Number of robots below which no certificate is given: even without a fall the bound would exceed 3 %."""

TOGETHER = 512  # runs of several pushes in one batch: the kernel moves 64 robots at a time, and more gain little

DRAWN = 12
"""Number of robots with which a log is compared: the largest of 12 is near the 92 % quantile of all."""

APPLIED = ("applied/left", "applied/right")
PITCH = ("truth/pitch",)
BANDS = (SETTLED, math.inf, math.inf)
STEP = 0.001  # [s] of the body, as everywhere
_MOST = 95  # per cent: what one run in twenty exceeds


@dataclass(frozen=True)
class PushTrial:
    """One push at one battery voltage: `fell` of `runs` fell. The others are 95 % quantiles over the robots that stand:
    `saturated` (fraction of periods), `travel` [m], `peak` pitch [rad], and `cycle`, half of pitch's range in the last
    seconds [rad]. They are zero where every robot fell. `residual` is the largest one of a predictive controller that
    stands: by how much the last iteration of a period still moved a command, over its limit. `size` is that of the push
    [rad or N s], `bound` the largest that any controller could survive on the stated robot (None: unlimited), and
    `beyond` counts the fallen robots that no controller could save. Its `kind` is one of `KINDS`, on a `slope` [rad].
    """

    push: str
    battery: str
    runs: int
    fell: int
    _: KW_ONLY
    saturated: float
    travel: float
    peak: float
    cycle: float
    residual: float = 0.0
    size: float = 0.0
    bound: float | None = None
    beyond: int = 0
    kind: str = "knock"
    slope: float = 0.0

    @property
    def message(self) -> Say:
        """The push."""
        lean = Quantity(-self.size if self.kind == "back" else self.size, "rad", digits=2)
        knock, angle = Quantity(self.size, "N s"), Quantity(self.slope, "rad", digits=2)
        if self.slope:
            if self.kind == "knock":
                return Say("knock of {size} on a slope of {slope}", size=knock, slope=angle)
            return Say("hold at {angle} on a slope of {slope}", angle=lean, slope=angle)
        return Say("knock of {size}", size=knock) if self.kind == "knock" else Say("hold at {angle}", angle=lean)

    @property
    def supply(self) -> Say:
        """The battery."""
        if self.battery == "low":
            return Say("low battery")
        return Say("full battery") if self.battery == "full" else Say("battery at {volts}", volts=self.battery)


class KernelController(NamedTuple):
    """A controller as the kernel runs it: as its compiled `law`, or `called` for each robot where no law describes it,
    which takes a hundred times as long."""

    law: Law
    called: Controller | None = None


def kernel_controller(controller: Controller, robot: Robot, kit: Kit) -> KernelController:
    """The controller in the form that the kernel runs. Raises `SpecMismatch` where it reads the true state on a real
    kit, or commands another unit than the robot's."""
    spec = controller.spec
    if spec.command_unit != robot.command_unit:
        raise SpecMismatch(f"the controller commands {spec.command_unit}", expected=f"{robot.command_unit}")
    if spec.reads_truth and kit.name != "ideal":
        raise SpecMismatch(
            f"a {spec.kind} that reads the true state, on kit '{kit.name}'",
            expected="a controller that reads its sensors", hint="put a filter in front of it, or take the kit 'ideal'",
        )  # fmt: skip
    return KernelController(*law_of(controller))


def enough_robots(family: Sequence[Robot], robot: Robot) -> Sequence[Robot]:
    """The `family`; raises `InvalidScenario` for fewer than `FEWEST`, `SpecMismatch` for one of another drive."""
    if len(family) < FEWEST:
        raise InvalidScenario(
            f"{len(family)} robots are too few to bound the probability of a fall", expected=f"{FEWEST} or more"
        )
    if stranger := next((r for r in family if r.command_unit != robot.command_unit), None):
        raise SpecMismatch(f"'{stranger.name}' among the robots is commanded in {stranger.command_unit}",
                           expected=f"{robot.command_unit}, as '{robot.name}'")  # fmt: skip
    return family


PUSHES = len(KINDS)


def red(fell: int, runs: int) -> bool:
    """Whether so many falls make a light red."""
    return upper_bound(fell, runs, CONFIDENCE) > MOST_FALLS


@dataclass
class RunCounter:
    """Counts robots that have run, and shows the fraction of `total`."""

    total: int
    show: Callable[[float], None]
    done: int = 0

    def add(self, count: int) -> None:
        self.done += count
        self.show(min(1.0, self.done / max(1, self.total)))


@dataclass(frozen=True, eq=False)
class TrialSetup(Assumptions):
    """A controller, and the robots that it drives as they are assumed, or as the log shows them.

    Pushes are sized for the robot and the kit that were `stated` (None: `robot` and `kit`), whatever a calibration made
    of them."""

    _: KW_ONLY
    controller: KernelController
    threads: int | None = None
    progress: RunCounter | None = None
    stated: tuple[Robot, Kit] | None = None

    def pushes(self, battery: float | None = None, slope: float = 0.0) -> dict[str, StandardPush]:
        """`standard_pushes` of what was stated."""
        return standard_pushes(*(self.stated or (self.robot, self.kit)), battery, slope)

    @cached_property
    def parameters(self) -> Array:
        """Those of all robots (n, 25), with the loads that the log shows."""
        parameters = parameters_of(self.robots)
        return self.logged.weighed(parameters) if self.logged else parameters

    @property
    def runs_of_trials(self) -> int:
        """Number of runs in all trials."""
        return PUSHES * len(conditions(self.robot, self.kit, self.logged)) * len(self.robots)


class Condition(NamedTuple):
    """A `slope` [rad], a `battery` by its name and `voltage` [V], and the expected ones, for which pushes are sized."""

    slope: float
    battery: str
    voltage: float | None
    expected_slope: float
    expected_voltage: float | None


def conditions(robot: Robot, kit: Kit, logged: Logged | None = None) -> list[Condition]:
    """What every push is tried at: the batteries and slopes that are expected of a robot, and those that only a log
    shows."""
    volts, expected = batteries(robot, kit), robot.conditions.slopes
    named = [(name, volts and volts[i]) for i, name in enumerate(BATTERIES)]
    named += [(f"{v:.3g} V", v) for v in logged.batteries] if logged else []
    slopes = [*expected, *(logged.slopes if logged else ())]

    def within(value: float, ends: Sequence[float]) -> float:
        return min(max(value, min(ends)), max(ends))

    return [
        Condition(slope, name, v, within(slope, expected), v if v is None or volts is None else within(v, volts))
        for slope, (name, v) in product(slopes, named)
    ]  # fmt: skip


class PlannedPush(NamedTuple):
    """A `push` of all robots at one battery of that `voltage` [V] (None: the kit's), each on a slope of `angles` (·,)
    [rad], which begin at rest at a `lean` [rad]. By its `number` every robot has noise of its own under every push."""

    number: int
    push: Any
    angles: Any = 0.0
    voltage: float | None = None
    lean: float = 0.0


@dataclass(frozen=True, eq=False)
class TriedPush:
    """The `run` of all robots of `setup` under one `planned` push, and what a `trial` says of it."""

    setup: TrialSetup
    planned: PlannedPush
    trial: PushTrial
    run: FleetResult

    @cached_property
    def beyond(self) -> Mask:
        """Which robots (n,) fell though no controller could save them."""
        fell, setup, planned = self.run.fell, self.setup, self.planned
        able, lost = means(setup.robot, setup.actual_kit, planned.voltage), np.zeros(len(fell), dtype=np.bool_)
        lost[fell] = ~recoverable(setup.parameters[fell], able, planned.push, planned.angles[fell], setup.threads)
        return lost

    @property
    def counted(self) -> PushTrial:
        """The trial with the number of those `beyond`."""
        return replace(self.trial, beyond=int(self.beyond.sum()))


class Trials(NamedTuple):
    """The trials, which robots (n,) fell in any, and which of these fell only where no controller could help."""

    trials: tuple[PushTrial, ...]
    fell: Mask
    beyond: Mask


def trials(setup: TrialSetup) -> Trials:
    """Every standard push at every battery on all robots."""
    fell, avoidable = (np.zeros(len(setup.robots), dtype=np.bool_) for _ in range(2))
    results = list[PushTrial]()
    for one in tried(setup):
        results.append(one.counted)
        fell |= one.run.fell
        avoidable |= one.run.fell & ~one.beyond
    return Trials(tuple(results), fell, fell & ~avoidable)


def tried(setup: TrialSetup) -> Iterator[TriedPush]:
    """Every standard push at every battery, and on every slope, on all robots."""
    law = setup.controller.law
    predictive = law.nonlinear is not None and isinstance(law.nonlinear.part, Splitting)
    channels = (*PITCH, RESIDUAL) if predictive else PITCH
    plan, at_once = _plan(setup), max(1, TOGETHER // len(setup.robots))
    for first in range(0, len(plan), at_once):
        some = plan[first : first + at_once]
        runs = simulated(setup, [one for one, *_ in some], channels)
        for (planned, standard, known), run in zip(some, runs, strict=True):
            trial = replace(
                _trial(known, run, setup.parameters, law.period), size=standard.size,
                bound=standard.bound if math.isfinite(standard.bound) else None,
            )  # fmt: skip
            yield TriedPush(setup, planned, trial, run)


def _plan(setup: TrialSetup) -> list[tuple[PlannedPush, StandardPush, dict[str, Any]]]:
    """All that are tried, each with its standard push, and what its trial has of it: push, battery, kind and slope."""
    logged, plan = setup.logged, list[tuple[PlannedPush, StandardPush, dict[str, Any]]]()
    for number, kind in enumerate(KINDS):
        for slope, battery, voltage, expected_slope, expected_voltage in conditions(setup.robot, setup.kit, logged):
            name, standard = list(setup.pushes(expected_voltage, expected_slope).items())[number]
            same = np.full(len(setup.robots), slope)
            angles = logged.angles(slope, setup.parameters, setup.actual_robot) if logged else same
            called = f"{name}, slope {math.degrees(slope):+.1f}°" if slope else name
            known = {"push": called, "battery": battery, "kind": kind, "slope": slope}
            plan.append((PlannedPush(len(plan), standard.push, angles, voltage), standard, known))
    return plan


def watched(setup: TrialSetup, push: Any, number: int, channels: Sequence[str]) -> FleetResult:
    """One run of each robot of `setup` under `push`, with `channels` recorded; `number` is that of the trial."""
    return simulated(setup, [PlannedPush(number, push)], channels)[0]


def followed_runs(setup: TrialSetup) -> list[DrawnRuns]:
    """What the first `DRAWN` robots of `setup` show of themselves under the standard pushes, push by push. Robots that
    fall are left out. Raises `SpecMismatch` for a controller that does not read encoders and gyro."""
    reads = setup.controller.law.linear.reads
    if not set(RAW) <= set(reads):
        raise SpecMismatch(f"the controller reads {', '.join(reads)}", expected="both encoders and the gyro")
    logged = setup.logged  # its kit has the noise that the filter needs: a motion that the model lacks counts as noise
    if logged:
        logged = replace(logged, changes={name: drawn for name, drawn in logged.changes.items() if name != NOISED})
    some = replace(setup, robots=setup.robots[:DRAWN], progress=None, logged=logged)
    motor = setup.actual_kit.motor
    runs = list[DrawnRuns]()
    for number, standard in enumerate(some.pushes().values()):
        result = watched(some, standard.push, number, (*RAW, *APPLIED))
        readings, applied = np.split(result.trace[~result.fell], [3], axis=2)
        runs.append(DrawnRuns(readings, applied * [motor.left, motor.right]))
    return runs


def simulated(
    setup: TrialSetup, pushes: Sequence[PlannedPush], channels: Sequence[str] = (), *, seconds: float = SECONDS
) -> list[FleetResult]:
    """One run of `seconds` of each robot under each push, push by push."""
    batch = _batch(setup, pushes)
    part, results = CALLED if batch.called else batch.n, list[FleetResult]()
    for first in range(0, batch.n, part):
        some = batch if part >= batch.n else batch.part(slice(first, first + part))
        results.append(simulate(
            some, seconds, record=int(bool(channels)), channels=channels, bands=BANDS, threads=setup.threads,
        ))  # fmt: skip
        if setup.progress:
            setup.progress.add(some.n)
    whole, n = joined(results), len(setup.robots)
    return [whole.part(slice(first, first + n)) for first in range(0, batch.n, n)]


def _batch(setup: TrialSetup, pushes: Sequence[PlannedPush]) -> FleetBatch:
    """All robots under one push after another."""
    parameters, kit, logged = setup.parameters, setup.actual_kit, setup.logged
    n, count = len(parameters), len(pushes)
    slope = np.zeros((count * n, 2))
    slope[:, 0] = np.concatenate([np.broadcast_to(one.angles, n) for one in pushes])
    start = np.zeros((count * n, 6))
    start[:, 0] = np.repeat([one.lean for one in pushes], n)
    given = [np.broadcast_to(tables([one.push], (), parameters).pushes, (n, 1, 4)) for one in pushes]
    changes = {name: np.tile(values, count) for name, values in (logged.drawn(n) if logged else {}).items()}
    if any(one.voltage is not None for one in pushes):
        volts = [kit.battery.voltage if one.voltage is None else one.voltage for one in pushes]
        changes["battery.voltage"] = np.repeat(volts, n)
    return FleetBatch(
        parameters=np.tile(parameters, (count, 1)), controller=setup.controller.law, called=setup.controller.called,
        kit=kit, seed=setup.seed, kit_changes=changes,
        start=start, pushes=np.concatenate(given), slope=slope, period=STEP,
        index=np.concatenate([np.arange(n, dtype=np.uint64) + np.uint64(one.number * n) for one in pushes]),
    )  # fmt: skip


def _trial(known: dict[str, Any], run: FleetResult, parameters: Array, period: float) -> PushTrial:
    stood = ~run.fell
    radius = parameters[:, NAMES.index("wheel_radius")]
    ending = run.trace[stood, -max(1, round(TAIL / period)) :, 0]
    swings = (ending.max(axis=1) - ending.min(axis=1)) / 2
    numbers = (run.saturated[stood], (run.peak[:, 1] * radius)[stood], run.peak[stood, 0], swings)
    most = dict(zip(("saturated", "travel", "peak", "cycle"), map(_most, numbers), strict=True))
    residual = float(run.trace[stood, :, 1:].max(initial=0.0))
    return PushTrial(runs=len(stood), fell=int(run.fell.sum()), **known, **most, residual=residual)


def _most(values: Array) -> float:
    return float(np.percentile(values, _MOST)) if len(values) else 0.0
