"""Does the robot stand by itself, at which periods and delays, and how hard may it be pushed?

Left alone, every robot begins at rest at a small lean, as a hand leaves it, with the kit's noise. The hardest pushes
are those of the robot in the file, at the kit's battery.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from upright.bodies.body import FALLEN
from upright.certification.checks import (
    MOST_CYCLE,
    MOST_FALLS,
    STEP,
    KernelController,
    PlannedPush,
    PushTrial,
    TrialSetup,
    simulated,
)
from upright.certification.pushes import MOST_HOLD, MOST_KNOCK, RELEASE
from upright.certification.recovery import (
    KNOCK_DURATION,
    largest_hold,
    largest_knock,
    largest_slope,
    means,
    recoverable,
)
from upright.experiment.pushes import Hold, Impulse
from upright.kernel.batch import NAMES, FleetResult
from upright.likelihood.assumptions import Logged, batteries, delaying
from upright.pages import Quantity, Say

LEAN = math.radians(1.0)
"""[rad] At which a robot is left alone: a hand sets it up no better, and no set point is known better."""
ALONE = 20.0  # [s] left alone: a lean that doubles in 3 s has grown from `LEAN` to a fall
LEFT = 300  # drawn robots that are left alone: without a fall they bound it to 1 %
REPEATED = 4  # runs of the file's robot, each with other noise
SWEPT = 100  # drawn robots in the sweeps
NOTHING = Impulse(impulse=0.0)

DELAYS = (0.25, 0.5, 1.0, 1.5, 2.0)
"""Additional dead times that are tried, in periods."""

SLOWER = (0.5, 0.8, 1.0, 1.25, 1.5, 2.0)
"""Periods that are tried, as multiples of the controller's own, which is among them for comparison."""

SLOWEST = 0.5  # [s] the longest period that is looked for: a robot of a metre falls in that time
STRONGER = (1.1, 1.25, 1.5, 2.0, 3.0)  # times the battery's voltage, or the gear's ratio, that are tried
PARTS = 16  # sizes of a push that are tried, up to what any controller could survive


@dataclass(frozen=True)
class Swept:
    """`fell` of `runs`, left alone, fell with `value` [s] of additional dead time, or with `value` as the period."""

    value: float
    runs: int
    fell: int


@dataclass(frozen=True)
class Standing:
    """Robots left alone for `ALONE` seconds: the one in the file fell at `fell_at` [s] (None: it stands) and `rolled`
    so far [m]; of `runs` that were drawn, `lost` fell. The file's robot stands at periods up to `longest` [s]
    (None: not examined, or not at its own)."""

    fell_at: float | None
    rolled: float
    runs: int
    lost: int
    longest: float | None = None

    def message(self, period: float) -> Say:
        """Whether it stands, under a controller of this `period` [s]."""
        if self.fell_at is not None:
            return Say("no: left alone it falls after {time}", time=Quantity(self.fell_at, "s", digits=2))
        if not self.runs:
            return Say("not tried")
        alone = Quantity(ALONE, "s")
        if self.longest is None:
            return Say(
                "yes, for {time}; left alone, {lost} of {runs} similar robots fell",
                time=alone,
                runs=self.runs,
                lost=self.lost,
            )
        periods = Quantity(None, "s", low=period, high=self.longest)
        return Say("yes, for {time}, at periods of {periods}; left alone, {lost} of {runs} similar robots fell",
                   time=alone, periods=periods, runs=self.runs, lost=self.lost)  # fmt: skip


UNTRIED = Standing(None, 0.0, 0, 0)


def stands(alone: Standing, radius: float, period: float, trials: Sequence[PushTrial]) -> Say:
    """Whether the file's robot stands. Where its loop, of a largest |pole| `radius` every `period` [s], would by itself
    have made a fall of the lean, what bounds it is a limit cycle, as wide as the robots of the `trials` sway."""
    sways = [trial.cycle for trial in trials if trial.fell < trial.runs]
    growth = math.log(radius) * ALONE / period
    if alone.fell_at is not None or not alone.runs or not sways or growth < math.log(FALLEN / LEAN):
        return alone.message(period)
    sway = Quantity(max(sways), "rad", digits=2)
    return Say("yes, for {time}, in a limit cycle of ±{sway}; left alone, {lost} of {runs} similar robots fell",
               time=Quantity(ALONE, "s"), sway=sway, runs=alone.runs, lost=alone.lost)  # fmt: skip


@dataclass(frozen=True)
class Endured:
    """The largest push of a `kind` that the file's robot endures, and the largest that any controller could (None:
    without a limit): a knock [N s] and a hold [N] at the centre of mass, and a slope [rad] of the floor."""

    kind: str
    size: float
    best: float | None

    @property
    def sizes(self) -> list[Quantity]:
        """What it endures, and what any controller could, where that has a limit."""
        unit = {"knock": "N s", "hold": "N", "slope": "rad"}[self.kind]
        return [Quantity(size, unit, digits=2) for size in (self.size, self.best) if size is not None]

    @property
    def message(self) -> Say:
        """The push, its largest size, and that which any controller could."""
        size, *best = self.sizes
        if not best:
            return Say("{push} {size}", push=ENDURED[self.kind], size=size)
        return Say("{push} {size} (best possible {best})", push=ENDURED[self.kind], size=size, best=best[0])


ENDURED = {"knock": Say("knock"), "hold": Say("hold"), "slope": Say("slope")}


@dataclass(frozen=True)
class Strength:
    """The battery [V], or the gear's ratio [1], with which the motors would be strong enough (None: none); `full` [V]
    is the most that they get as it is (None: no battery drives them)."""

    battery: float | None
    gear: float | None
    full: float | None = None

    @property
    def message(self) -> Say:
        """What would do."""
        if self.gear:
            return Say("a gear ratio of {ratio} would do", ratio=Quantity(self.gear, "1"))
        if self.full is None:
            return Say("not even three times the gear would do")
        if self.battery is None:
            return Say("neither three times the voltage nor three times the gear would do")
        battery, full = (Quantity(volts, "V") for volts in (self.battery, self.full))
        if self.battery <= self.full:
            return Say("a battery of {battery} would do", battery=battery)
        return Say("a battery of {battery} would do, if motors that now get {full} bear it", battery=battery, full=full)


def standing(setup: TrialSetup, *, sweeps: bool = True) -> Standing:
    """How the file's robot and those of `setup` stand; with `sweeps` also up to which period."""
    own = replace(setup, robots=[setup.robot] * REPEATED)
    alone = left_alone(own)
    drawn = left_alone(replace(setup, robots=setup.robots[:LEFT]))
    fell = float(alone.lived[alone.fell].min()) if alone.fell.any() else None
    rolled = float(alone.peak[:, 1].max()) * setup.robot.wheel_radius
    longest = _longest(own) if sweeps and fell is None else None
    return Standing(fell, rolled, len(drawn.fell), int(drawn.fell.sum()), longest)


def runs_of(setup: TrialSetup, *, sweeps: bool) -> int:
    """About how many runs a certificate takes."""
    some = min(SWEPT, len(setup.robots)) * (len(DELAYS) + len(SLOWER)) + 3 * PARTS * REPEATED
    return setup.runs_of_trials + min(LEFT, len(setup.robots)) + REPEATED + (some if sweeps else 0)


def endured(setup: TrialSetup) -> tuple[Endured, ...]:
    """The largest knock, hold and slope that the file's robot endures, in sixteenths of what any controller could."""
    robot, kit = setup.stated or (setup.robot, setup.kit)
    knock, hold, slope = largest_knock(robot, kit), largest_hold(robot, kit), largest_slope(robot, kit)
    parts = [(k + 1) / PARTS for k in range(PARTS)]
    knocks = [part * min(knock, 2 * MOST_KNOCK * robot.body_mass) for part in parts]
    leans = [part * min(hold, MOST_HOLD) for part in parts]
    slopes = [part * min(slope, MOST_HOLD) for part in parts]
    plan = [PlannedPush(k, Impulse(impulse=size, start=1.0, duration=KNOCK_DURATION)) for k, size in enumerate(knocks)]
    plan += [PlannedPush(k, Hold(pitch=size, until=RELEASE)) for k, size in enumerate(leans)]
    plan += [PlannedPush(k, NOTHING, angles=size, lean=size) for k, size in enumerate(slopes)]
    runs = simulated(replace(setup, robots=[setup.robot] * REPEATED), plan)
    forces = [-Hold(pitch=size, until=RELEASE).force(robot) for size in leans]
    best = -Hold(pitch=hold, until=RELEASE).force(robot) if math.isfinite(hold) else math.inf
    return (
        Endured("knock", _survived(knocks, runs[:PARTS]), _finite(knock)),
        Endured("hold", _survived(forces, runs[PARTS : 2 * PARTS]), _finite(best)),
        Endured("slope", _survived(slopes, runs[2 * PARTS :]), slope if slope < MOST_HOLD else None),
    )


def strong_enough(setup: TrialSetup) -> Strength:
    """With which battery, or which gear, nearly every robot of `setup` could be saved from the standard pushes."""
    kit, parameters = setup.actual_kit, setup.parameters
    pushes = [standard.push for standard in setup.pushes().values()]

    def enough(volts: float, gear: float) -> bool:
        table = parameters.copy()
        table[:, NAMES.index("gear_ratio")] *= gear
        able = means(setup.robot, kit, volts)
        most = MOST_FALLS * len(table)
        return all((~recoverable(table, able, push)).sum() <= most for push in pushes)

    full = kit.battery.voltage
    now = batteries(setup.robot, kit)  # else no battery limits a command
    battery = next((full * more for more in STRONGER if enough(full * more, 1.0)), None) if now else None
    gear = next((setup.robot.gear_ratio * more for more in STRONGER if enough(full, more)), None)
    return Strength(battery, gear, now and now[1])


def delay_sweep(setup: TrialSetup) -> tuple[Swept, ...]:
    """Falls of robots left alone with `DELAYS` periods of additional dead time, unknown to the controller."""
    kit, known = setup.actual_kit, setup.logged or Logged.alone(setup.kit)
    period = setup.controller.law.period
    extra = sorted({round(fraction * period / STEP) * STEP for fraction in DELAYS} - {0.0})
    slowed = {more: replace(setup, logged=replace(known, kit=delaying(kit, more))) for more in extra}
    return tuple(_swept(one, more) for more, one in slowed.items())


def period_sweep(setup: TrialSetup) -> tuple[Swept, ...]:
    """Falls of robots left alone with the same gains at `SLOWER` times the period.

    In the kernel no command may be delayed beyond the next one, so that jitter limits the period from below.
    """
    period = setup.controller.law.period
    tried = sorted({max(1, round(fraction * period / STEP)) * STEP for fraction in SLOWER})
    return tuple(_swept(_every(setup, p), p) for p in tried if p >= setup.actual_kit.jitter)


def _survived(sizes: Sequence[float], runs: Sequence[FleetResult]) -> float:
    """The last of the ascending `sizes` before the first that fells a robot, zero where that is the first."""
    largest = 0.0
    for size, run in zip(sizes, runs, strict=True):
        if run.fell.any():
            break
        largest = size
    return largest


def _finite(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _every(setup: TrialSetup, period: float) -> TrialSetup:
    """The same gains every `period` [s]."""
    law, called = setup.controller
    return replace(setup, controller=KernelController(law.with_period(period), called))


def left_alone(setup: TrialSetup) -> FleetResult:
    """The robots of `setup`, left alone."""
    return simulated(setup, [PlannedPush(0, NOTHING, lean=LEAN)], seconds=ALONE)[0]


def _longest(own: TrialSetup) -> float | None:
    """The longest period [s] at which the robots of `own` stand without a swing: doubled, then bisected."""

    def stands(steps: int) -> bool:
        run = left_alone(_every(own, steps * STEP))
        return not run.fell.any() and run.peak[:, 0].max() <= MOST_CYCLE

    low = round(own.controller.law.period / STEP)
    if low < 1 or not stands(low):
        return None
    high = 2 * low
    while high * STEP <= SLOWEST and stands(high):
        low = high
        high = 2 * low
    while high - low > 1:
        middle = (low + high) // 2
        if stands(middle):
            low = middle
        else:
            high = middle
    return low * STEP


def _swept(setup: TrialSetup, value: float) -> Swept:
    run = left_alone(replace(setup, robots=setup.robots[:SWEPT]))
    return Swept(value, len(run.fell), int(run.fell.sum()))
