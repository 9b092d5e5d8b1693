"""What a certificate measures: falls of drawn robots under the standard pushes, with more dead time, at other periods.

All of it is the nonlinear model in the batch kernel, with the kit's quanta, noise, dead time, limits and battery.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, replace
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from upright.arrays import Array, Mask
from upright.certify.logged import Logged, delaying, loaded
from upright.certify.pushes import StandardPush, standard_pushes
from upright.certify.recovery import means, recoverable
from upright.control.controller import Controller
from upright.control.law import Law, as_law
from upright.control.mpc import Splitting
from upright.errors import InvalidController, SpecMismatch
from upright.fleet.binomial import upper_bound
from upright.fleet.ensemble import SETTLED, tables
from upright.kernel.batch import NAMES, FleetBatch, FleetResult, parameters_of, silent
from upright.kernel.pack import RESIDUAL
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot

SECONDS = 8.0  # [s] a push, what follows it, and `TAIL` to see what the robot does at rest
TAIL = 2.0  # [s] at the end, over which the limit cycle is measured: several of its periods
BATTERIES = {"low": 0.85, "full": 1.12}
"""Over the kit's voltage: six AA cells under load give 7 to 9 V for 8, two lithium cells 6.4 to 8.4 V for 7.5. The
robot's file may state others (`Robot.conditions`)."""

DELAYS = (0.25, 0.5, 1.0, 1.5, 2.0)
"""Additional dead times that are tried, in periods."""

SLOWER = (0.5, 0.8, 1.0, 1.25, 1.5, 2.0)
"""Periods that are tried, as multiples of the controller's own, which is among them for comparison."""

CONFIDENCE = 0.95
MOST_FALLS = 0.05  # red above: with one such robot in twenty, a class of students breaks one

SWEPT = 100  # drawn robots in the sweeps

CALLED = 128
"""Robots in one batch where the controller is called for each of them: about a second of work."""

PITCH = ("truth/pitch",)
BANDS = (SETTLED, math.inf, math.inf)
_STEP = 0.001  # [s] of the body, as everywhere
_MOST = 95  # per cent: what one run in twenty exceeds


@dataclass(frozen=True)
class PushTrial:
    """One push at one battery voltage: `fell` of `runs` fell. The others are 95 % quantiles over the robots that stand:
    `saturated` (fraction of periods), `travel` [m], `peak` pitch [rad], and `cycle`, half of pitch's range in the last
    seconds [rad]. They are zero where every robot fell. `residual` is the largest one of a predictive controller that
    stands: by how much the last iteration of a period still moved a command, over its limit. `size` is that of the push
    [rad or N s], `bound` the largest that any controller could survive on the stated robot (None: unlimited), and
    `beyond` counts the fallen robots that no controller could save.
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


@dataclass(frozen=True)
class Swept:
    """`fell` of `runs` fell with `value` [s] of additional dead time, or with `value` as the period."""

    value: float
    runs: int
    fell: int


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
    try:
        return KernelController(as_law(controller))
    except InvalidController:
        return KernelController(as_law(silent(controller)), controller)


PUSHES = 3  # number of standard pushes


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
class TrialSetup:
    """A controller, the robots it drives, their kit, the seed of their noise, and the floor's slope (·) [rad].

    Pushes are sized for the robot and the kit that were `stated` (None: `robot` and `kit`), whatever a calibration made
    of them. What a log shows instead is `logged`, and is tried. Its filter expects `disturbed` times the usual noise of
    forces and torques. It asks no mass where that `is_weighed`, and neither mass nor the motors' strength of a robot
    with `dry_friction`, for which it would take that."""

    controller: KernelController
    robot: Robot
    robots: Sequence[Robot]
    kit: Kit
    seed: int = 0
    threads: int | None = None
    progress: RunCounter | None = None
    _: KW_ONLY
    slope: float | Array = 0.0
    logged: Logged | None = None
    disturbed: float = 1.0
    dry_friction: bool = False
    is_weighed: bool = False
    stated: tuple[Robot, Kit] | None = None

    def pushes(self, battery: float | None = None, slope: float = 0.0) -> dict[str, StandardPush]:
        """`standard_pushes` of what was stated."""
        return standard_pushes(*(self.stated or (self.robot, self.kit)), battery, slope)

    @property
    def actual_kit(self) -> Kit:
        """The kit as the log shows it, or as assumed."""
        return self.logged.kit if self.logged else self.kit

    @property
    def actual_robot(self) -> Robot:
        """The nominal robot as the log shows it, or as assumed."""
        return self.actual(self.robot)

    def actual(self, robot: Robot) -> Robot:
        """A robot with the load that the log shows."""
        return loaded(robot, self.logged.load) if self.logged else robot

    @property
    def runs(self) -> int:
        """Number of runs in all trials and sweeps."""
        some = min(SWEPT, len(self.robots))
        return self.runs_of_trials + PUSHES * (len(_extra(self)) + len(_periods(self))) * some

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


class TriedPush(NamedTuple):
    """A `trial`, the push of it, the runs of all robots, batch by batch, and which robots (n,) fell `beyond` what any
    controller could save."""

    trial: PushTrial
    push: Any
    rows: Sequence[FleetResult]
    beyond: Mask

    @property
    def fell(self) -> Mask:
        """Which robots (n,) fell."""
        return np.concatenate([row.fell for row in self.rows])


class Trials(NamedTuple):
    """The trials, which robots (n,) fell in any of them, and which of these no controller could save in one."""

    trials: tuple[PushTrial, ...]
    fell: Mask
    beyond: Mask


def trials(setup: TrialSetup) -> Trials:
    """Every standard push at every battery on all robots."""
    fell, beyond = (np.zeros(len(setup.robots), dtype=np.bool_) for _ in range(2))
    results = list[PushTrial]()
    for one in tried(setup):
        results.append(one.trial)
        fell |= one.fell
        beyond |= one.beyond
    return Trials(tuple(results), fell, beyond)


def tried(setup: TrialSetup) -> Iterator[TriedPush]:
    """Every standard push at every battery, and on every slope, on all robots."""
    law, number, logged = setup.controller.law, 0, setup.logged
    planned = law.nonlinear is not None and isinstance(law.nonlinear.part, Splitting)
    channels = (*PITCH, RESIDUAL) if planned else PITCH
    parameters = parameters_of(setup.robots)
    parameters = logged.weighed(parameters) if logged else parameters
    for kind in range(PUSHES):
        for slope, battery, voltage, expected_slope, expected_voltage in conditions(setup.robot, setup.kit, logged):
            name, standard = list(setup.pushes(expected_voltage, expected_slope).items())[kind]
            changed = {} if voltage is None else {"battery.voltage": [voltage]}
            angles = logged.angles(slope, parameters, setup.actual_robot) if logged else np.full(len(parameters), slope)
            sloped = replace(setup, slope=angles)
            rows = list(_runs(sloped, setup.robots, standard.push, number, changed, setup.controller, channels))
            called = f"{name}, slope {math.degrees(slope):+.1f}°" if slope else name
            fell, beyond = np.concatenate([row.fell for row in rows]), np.zeros(len(parameters), dtype=np.bool_)
            able = means(setup.robot, setup.actual_kit, voltage)
            beyond[fell] = ~recoverable(parameters[fell], able, standard.push, angles[fell], setup.threads)
            trial = replace(
                _trial(called, battery, rows, parameters, law.period), size=standard.size, beyond=int(beyond.sum()),
                bound=standard.bound if math.isfinite(standard.bound) else None,
            )  # fmt: skip
            yield TriedPush(trial, standard.push, rows, beyond)
            number += 1


def delay_sweep(setup: TrialSetup) -> tuple[Swept, ...]:
    """Falls under every standard push with `DELAYS` periods of additional dead time, unknown to the controller."""
    kit = setup.actual_kit
    return tuple(_swept(_on(setup, delaying(kit, more)), more, setup.controller) for more in _extra(setup))


def period_sweep(setup: TrialSetup) -> tuple[Swept, ...]:
    """Falls under every standard push with the same gains at `SLOWER` times the period."""
    law, called = setup.controller
    return tuple(_swept(setup, p, KernelController(law.with_period(p), called)) for p in _periods(setup))


def watched(setup: TrialSetup, push: Any, row: int, channels: Sequence[str]) -> Iterator[FleetResult]:
    """One run of each robot of `setup` under `push`, with `channels` recorded; `row` is the number of the trial."""
    return _runs(setup, setup.robots, push, row, {}, setup.controller, channels)


def _extra(setup: TrialSetup) -> list[float]:
    return sorted({round(fraction * setup.controller.law.period / _STEP) * _STEP for fraction in DELAYS} - {0.0})


def _periods(setup: TrialSetup) -> list[float]:
    """In the kernel no command may be delayed beyond the next one, so that jitter limits the period from below."""
    tried = sorted({max(1, round(fraction * setup.controller.law.period / _STEP)) * _STEP for fraction in SLOWER})
    return [period for period in tried if period >= setup.actual_kit.jitter]


def _on(setup: TrialSetup, kit: Kit) -> TrialSetup:
    """The same pushes on another kit."""
    return replace(setup, logged=replace(setup.logged or Logged.alone(kit), kit=kit))


def _swept(setup: TrialSetup, value: float, controller: KernelController) -> Swept:
    some = setup.robots[:SWEPT]
    fell = runs = 0
    for row, standard in enumerate(setup.pushes().values()):
        for result in _runs(setup, some, standard.push, row, {}, controller):
            fell, runs = fell + int(result.fell.sum()), runs + len(result.fell)
    return Swept(value, runs, fell)


def _runs(
    setup: TrialSetup, robots: Sequence[Robot], push: Any, row: int, changes: Mapping[str, Any],
    controller: KernelController, channels: Sequence[str] = (),
) -> Iterator[FleetResult]:  # fmt: skip
    """One run of each robot, in batches; `row` is the number of the trial, so that each has its own noise."""
    n, part, logged = len(robots), CALLED if controller.called else len(robots), setup.logged
    angles = np.column_stack([np.broadcast_to(setup.slope, n), np.zeros(n)])
    for first in range(0, n, part):
        some = parameters_of(robots[first : first + part])
        some = logged.weighed(some, first) if logged else some
        index = np.arange(row * n + first, row * n + first + len(some), dtype=np.uint64)
        batch = FleetBatch(
            parameters=some, controller=controller.law, kit=setup.actual_kit, seed=setup.seed,
            kit_changes={**(logged.part(first, len(some)) if logged else {}), **changes},
            pushes=tables([push], (), some).pushes, index=index, period=_STEP, slope=angles[first : first + len(some)],
        )  # fmt: skip
        yield simulate(batch, SECONDS, record=int(bool(channels)), channels=channels, bands=BANDS,
                       threads=setup.threads, called=controller.called)  # fmt: skip
        if setup.progress:
            setup.progress.add(len(some))


def batteries(robot: Robot, kit: Kit) -> tuple[float, float] | None:
    """The lowest and the highest voltage [V] that are expected: those of the robot's file, else `BATTERIES` of the
    kit's; None for a torque drive, which has no battery in its equations, or a kit without one."""
    if robot.command_unit != "V" or not math.isfinite(kit.battery.voltage):
        return None
    low, full = (fraction * kit.battery.voltage for fraction in BATTERIES.values())
    return robot.conditions.battery or (low, full)


def _trial(push: str, battery: str, rows: Sequence[FleetResult], parameters: Array, period: float) -> PushTrial:
    fell, saturated, peak, trace = (
        np.concatenate([getattr(row, name) for row in rows]) for name in ("fell", "saturated", "peak", "trace")
    )
    stood = ~fell
    radius = parameters[:, NAMES.index("wheel_radius")]
    ending = trace[stood, -max(1, round(TAIL / period)) :, 0]
    swings = (ending.max(axis=1) - ending.min(axis=1)) / 2
    numbers = (saturated[stood], (peak[:, 1] * radius)[stood], peak[stood, 0], swings)
    most = dict(zip(("saturated", "travel", "peak", "cycle"), map(_most, numbers), strict=True))
    residual = float(trace[stood, :, 1:].max(initial=0.0))
    return PushTrial(push, battery, len(stood), int(fell.sum()), **most, residual=residual)


def _most(values: Array) -> float:
    return float(np.percentile(values, _MOST)) if len(values) else 0.0
