"""Which of a robot's numbers would have to be known better for a red light to turn, by how much, and what tells them.

Parameters are ranked by the fraction that would fall if each were known twice as well, from the same runs by importance
weights (Owen 2013, chapter 9). The answer is then tried on further robots.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array, Mask
from upright.calibration.parameters import NEVER
from upright.certification.checks import TrialSetup, red
from upright.certification.checks import tried as pushed
from upright.certification.standing import left_alone
from upright.kernel.batch import NAMES, parameters_of
from upright.pages import Quantity, Say
from upright.pages.terms import term
from upright.robots.drives import SPEED_DRIVE
from upright.robots.robot import PARAMETERS
from upright.robots.uncertainty import GUESS, Spread, Uncertainty, draw

TRIED = 300  # robots: without a fall they bound it to 1 %
FEW = 100  # where the controller is called for each, which takes a hundred times as long
FACTORS = (0.1, 0.2, 0.35, 0.5, 0.7)
"""How well a number may have to be known, over how well it is: a tenth is what a good calibration reaches."""
WELL = 0.2  # of the spread as it is: where robots fall that are near the nominal one, half as wide helps little
MOST_NAMES = 3
BY_HAND = {
    "wheel_mass": Say("put a wheel on a scale"),
    "body_mass": Say("put the robot on a scale and take off both wheels"),
    "wheel_radius": Say("roll the robot by ten turns and divide the way by 20 π"),
    "track": Say("measure between the middles of the tyres"),
    "com_height": Say("lay the robot on a table's edge across its axle: where it tips is its centre of mass"),
    "pitch_inertia": Say("hang the robot by its axle, let it swing and time ten swings"),
    "yaw_inertia": Say("hang the robot upright by two parallel threads, turn it a little and time ten swings"),
    "roll_inertia": Say("hang the robot face down by two parallel threads, turn it a little and time ten swings"),
    "wheel_inertia": Say("hang the wheel by its rim on an edge, let it swing and time ten swings"),
    "motor_resistance": Say("hold a wheel and divide a small voltage by its current"),
    "back_emf": Say("turn a wheel at a known speed and read the open motor's voltage"),
    "torque_constant": Say("it is the back-EMF constant, or less: turn a wheel at a known speed and read the voltage"),
    "coulomb_friction": Say("raise the voltage until a wheel in the air begins to turn"),
    "speed_lag": Say("film a wheel in the air at 240 frames a second while the commanded speed jumps"),
    "acceleration_limit": Say("it is the ramp of the program that drives the wheels"),
    "slip_torque": Say(
        "hang weights on a thread round a wheel that is held by its motor: the last weight times the radius"
    ),
}
"""How to measure a parameter in some minutes. A time T of a swing about the axle is 2π √((J + M L²)/(M g L)), on two
threads of length l at a distance d 4π √(J l/(m g d²))."""
UNSEEN = ("wheel_mass", "body_mass", "wheel_radius", "track", "rolling_friction", *NEVER, *SPEED_DRIVE)
"""What no run is asked: no mass (docs/studies/mass.md), no length, and what a calibration leaves as it is."""


@dataclass(frozen=True)
class NeededSpread:
    """The deviation of a parameter as it is, `spread`, and the one that is `needed`, both in its `unit`."""

    name: str
    unit: str
    spread: float
    needed: float

    @property
    def message(self) -> Say:
        """How well it would have to be known."""
        return Say("{name} to ±{size}", name=term(self.name), size=Quantity(self.needed, self.unit, digits=2))


@dataclass(frozen=True)
class Narrowing:
    """If the parameters of `spreads` were known as said, `fell` of `runs` robots would fall. Without any the light
    would stay red, and `everything` says that it would even with every parameter known ten times as well."""

    spreads: tuple[NeededSpread, ...]
    runs: int
    fell: int
    everything: bool = False

    @property
    def message(self) -> Say:
        """What would have to be known better."""
        if self.everything:
            return Say("Measuring more does not help: of robots known ten times as well, {fell} of {runs} fall.",
                       fell=self.fell, runs=self.runs)  # fmt: skip
        if not self.spreads:
            return Say("No {n} numbers decide: more of them have to be known better.", n=MOST_NAMES)
        names = [spread.message for spread in self.spreads]
        return Say("Measure {names}: then {fell} of {runs} robots fall.", names=names, fell=self.fell, runs=self.runs)


def by_run(names: Sequence[str], drive: str) -> list[str]:
    """Which of these parameters a log tells. None of a drive by speed, whose wheels turn as commanded whatever the
    robot is."""
    return [name for name in names if name not in UNSEEN and drive != "speed"]


@dataclass(frozen=True)
class Guessed:
    """The parameters that nobody measured, the one that decides most first: with these `names` as the file has them
    `fell` of `runs` robots fall (0 of 0: not tried, since few fall with them varied)."""

    names: tuple[str, ...]
    runs: int
    fell: int


def guessed(setup: TrialSetup, unknown: Uncertainty, fell: Mask, *, tried: bool) -> Guessed | None:
    """What is only guessed in `unknown`, from which the robots of `setup` were drawn of which `fell` (n,) fell. Where
    it is to be `tried`, how many fall with the guesses as the file has them. None without a guess."""
    names = [s.name for s in unknown.spreads if s.kind == "lognormal" and s.high == GUESS]
    if not names:
        return None
    if not tried:
        return Guessed(tuple(names), 0, 0)
    order = [s.name for s in ranking(unknown, parameters_of(setup.robots), fell)]
    names.sort(key=lambda name: order.index(name) if name in order else len(order))
    runs = FEW if setup.controller.called else TRIED
    known = _known(setup, unknown, dict.fromkeys(names, 0.0), runs)
    lost = left_alone(known).fell.copy()
    for one in pushed(known):
        lost |= one.run.fell & ~one.beyond
    return Guessed(tuple(names), runs, int(lost.sum()))


def narrowing(setup: TrialSetup, unknown: Uncertainty, fell: Mask) -> Narrowing:
    """What would have to be known of the robot of `setup`, `fell` (n,) of whose robots, drawn from `unknown`, fell."""

    def falls(factors: dict[str, float], *, all_pushes: bool = False) -> int:
        """How many fall; by default no push is tried after one that makes it red."""
        lost = np.zeros(TRIED, dtype=np.bool_)
        for one in pushed(_known(setup, unknown, factors, TRIED)):
            lost |= one.run.fell
            if red(int(lost.sum()), TRIED) and not all_pushes:
                break
        return int(lost.sum())

    def answer(chosen: Sequence[Spread]) -> Narrowing | None:
        """How well these would have to be known; None where a tenth is too much, or none is chosen."""
        enough = None
        for factor in FACTORS if chosen else ():
            if red(least := falls(dict.fromkeys((s.name for s in chosen), factor)), TRIED):
                break
            enough = Narrowing(tuple(_needed(s, factor) for s in chosen), TRIED, least)
        return enough

    ranked = [s for s in ranking(unknown, parameters_of(setup.robots), fell) if s.name in PARAMETERS]
    if alone := answer(ranked[:1]):
        return alone
    every = dict.fromkeys((s.name for s in unknown.spreads), FACTORS[0])
    if red(most := falls(every, all_pushes=True), TRIED):
        return Narrowing((), TRIED, most, everything=True)
    several = (answer(ranked[:count]) for count in range(2, min(MOST_NAMES, len(ranked)) + 1))
    return next(filter(None, several), Narrowing((), TRIED, most))


def _known(setup: TrialSetup, unknown: Uncertainty, factors: Mapping[str, float], runs: int) -> TrialSetup:
    """Further robots for `setup`, whose numbers are known so many times as widely as in `unknown`."""
    spreads = tuple(s.scaled(factors.get(s.name, 1.0)) for s in unknown.spreads)
    robots = draw(setup.robot, runs, setup.seed + 1, Uncertainty(spreads, unknown.correlation))
    return replace(setup, robots=robots, progress=None)


def ranking(unknown: Uncertainty, parameters: Array, fell: Mask) -> Sequence[Spread]:
    """The spreads, first the one by which the fraction that falls sinks most where it is known as well as `WELL`."""
    rest: dict[str, float] = {}
    for spread in (s for s in unknown.spreads if s.name in NAMES and s.high != s.low * (s.kind == "uniform")):
        z = _quantile(spread, parameters[:, NAMES.index(spread.name)])
        weights = np.exp((1 - WELL**-2) / 2 * z**2)  # as N(z; 0, WELL) / N(z; 0, 1)
        rest[spread.name] = float(weights @ fell / weights.sum())
    return sorted((s for s in unknown.spreads if s.name in rest), key=lambda s: rest[s.name])


def _quantile(spread: Spread, values: Array) -> Array:
    """The standard normal z (n,) of the values: the inverse of `Spread.at`."""
    if spread.kind == "normal":
        return (values - spread.low) / spread.high
    if spread.kind == "lognormal":
        return np.log(values / spread.low) / spread.high
    from scipy.special import ndtri

    return np.clip(ndtri((values - spread.low) / (spread.high - spread.low)), -4.0, 4.0)


def _needed(spread: Spread, factor: float) -> NeededSpread:
    size = {"normal": spread.high, "lognormal": spread.high * spread.low}.get(spread.kind)
    deviation = (spread.high - spread.low) / 12**0.5 if size is None else size
    return NeededSpread(spread.name, PARAMETERS[spread.name][0], deviation, factor * deviation)
