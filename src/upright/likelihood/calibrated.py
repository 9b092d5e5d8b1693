"""What a calibration hands to a certificate: the robot, how far from it the truth may be, and its dead times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from upright.calibration.calibrate import calibrate
from upright.calibration.calibration import Calibration
from upright.calibration.estimate import HELD
from upright.calibration.knocks import unpushed
from upright.checkup.doctor import contradictions
from upright.errors import InvalidLog
from upright.likelihood.actual import WITHIN, as_logged, doubted, is_beyond
from upright.likelihood.assumptions import LOADED, Assumptions
from upright.likelihood.support import LOAD_KNOWN, MASS, Support, body_mass, slope
from upright.logs.recording import SENSOR
from upright.pages import english
from upright.progress import Progress
from upright.robots import PARAMETERS, Kit, Robot
from upright.robots.robot import MAY_BE_ZERO
from upright.robots.uncertainty import Spread, Uncertainty, draw
from upright.signals import Log

WHITER = 1.25
"""Times the information that a log holds by its innovations' correlation (`Calibration.temper`), from which they are
whiter: with the body's true mass 0.93 and 1.0, with 2.5 times that 0.38 and 0.42."""

WHITE = 0.5
"""From this `temper` on, between those, innovations are near enough to white for a number to be the cause. Where a
dead zone was the cause, a body of 2.2 times its mass raised it from 0.04 to 0.08: the light was green, and the robot
fell."""


@dataclass(frozen=True, eq=False)
class Learnt:
    """A robot with its kit, the posterior of its parameters, what its file states that the log contradicts or leaves
    open, and the slope of the floor with its interval [rad] (None: the log does not tell)."""

    robot: Robot
    kit: Kit
    uncertainty: Uncertainty
    contradicted: tuple[Support, ...] = ()
    floor: tuple[float, float, float] | None = None


def calibrated(log: Log, setup: Assumptions, progress: Progress | None = None) -> tuple[Learnt, tuple[Support, ...]]:
    """The robot of `setup` calibrated from `log`, and what its file and its kit had wrong, beside what they say.

    A calibration doubts no scale, no weighed mass and little of the electronics: where these are wrong it bends other
    numbers. So the log is first compared with the file, and what it contradicts is corrected. The mass is that of a
    calibration which takes it for a guess; one that only the filter of a certificate sees counts as contradicted where
    no other number explains the log. So do innovations that are then far from white. That calibration also says how
    light and how heavy the body may be, where it explains the log without other numbers. Where robots
    within the file's spreads explain as much as one more number would, the log is calibrated with it too, and that
    robot is kept where its innovations are whiter, and nearly white. Of a robot that `is_weighed` no mass is asked.
    Raises `InvalidLog` where the calibration is refused, or a sensor has the other sign, which no scale that is tried
    explains.
    """
    for wrong in contradictions(log, codes=("motion/flipped",)):
        raise InvalidLog(english(wrong).rstrip("."), hint="upright doctor LOG --fix NEW.csv")
    met, _, taken = as_logged(log, setup)
    alone = unloaded(met)
    unsure = unconfirmed(taken)
    asked = None if setup.is_weighed else guessed(log, alone)
    if asked is not None and (own_mass := weighed(asked, alone)):
        return learnt(asked, setup.kit), (*(s for s in taken if s.name != MASS), *own_mass)
    weighed_on = alone
    if unsure:
        alone, _, taken = as_logged(log, replace(setup, is_weighed=True))
    own = _own(log, alone, progress)
    unlike = own.refused or own.temper * WHITER < 1
    if unlike and (doubt := doubted(log, alone, {s.name for s in taken})):
        other = _own(log, doubt[0], progress)
        if not other.refused and (own.refused or other.temper > max(WHITER * own.temper, WHITE)):
            own = other
            taken = (*taken, doubt[1])
            alone = doubt[0]
    if own.refused and taken:
        own = _own(log, setup, progress)
        taken = ()
        alone = replace(setup, is_weighed=True)
    if own.refused:
        raise InvalidLog(
            f"the log does not describe {setup.robot.name}: {own.refused[0]}",
            hint="upright doctor LOG; or certify without the log, or with the robot that it is of",
        )
    white = own.temper >= WHITE
    unsure = () if taken and white else unsure  # the mass was an image of what was taken over instead
    coloured = () if setup.dry_friction or taken or white else (_count(own.temper),)
    result = learnt(own, setup.kit, (*unsure, *coloured))
    if asked is None:
        return result, taken
    if alone.actual_kit != weighed_on.actual_kit:
        asked = guessed(log, alone)
    left = _open(asked, setup, unsure)
    return replace(result, contradicted=(left,)) if left else result, taken


def _open(asked: Calibration, setup: Assumptions, unsure: Sequence[Support]) -> Support | None:
    """What a calibration that takes the mass for a guess leaves of it, as far as the mass that a filter sees; None if
    that is within what is assumed, or the calibration is refused, or contradicts another number of the robot's file."""
    if asked.refused or learnt(asked, setup.kit).contradicted:
        return None
    e = asked["body_mass"]
    low, high = min([e.low, *(s.low for s in unsure)]), max([e.high, *(s.high for s in unsure)])
    mass = replace(body_mass(setup, e.value, 0.0), low=low, high=high, left_open=True)
    return None if mass.least <= low and high <= mass.most else mass


def _count(temper: float) -> Support:
    """The share of the readings that count: innovations far from white are of something that no number explains."""
    return Support("share of readings that count", "1", temper, temper, temper, WHITE, 1.0)


def unloaded(met: Assumptions) -> Assumptions:
    """The setup without the load that the log shows, whose mass its filter asks no more."""
    logged = met.logged and replace(met.logged, load=1.0, loads=np.ones(1))
    return replace(met, logged=logged, is_weighed=True)


def unconfirmed(taken: Sequence[Support]) -> tuple[Support, ...]:
    """The mass among what was `taken`: the log leaves it open, from there to the one that was assumed."""
    middle = [(s, (s.least + s.most) / 2) for s in taken if s.name == MASS]
    return tuple(replace(s, low=min(s.low, m), high=max(s.high, m), left_open=True) for s, m in middle)


def guessed(log: Log, setup: Assumptions) -> Calibration:
    """The calibration that takes the body's mass for a guess, and weighs every other number within its spread. The
    filter of a certificate does not, and takes dry friction for mass."""
    robot, kit = setup.actual_robot, setup.actual_kit
    guess = robot.replace(provenance={name: s for name, s in robot.provenance.items() if name not in LOADED})
    return calibrate(unpushed(log, robot, kit), guess, kit)


def weighed(own: Calibration, setup: Assumptions) -> list[Support]:
    """The mass that a calibration finds which took it for a guess, where it is not within what was assumed; nothing
    where it is. Innovations far from white may be of another cause, but those of a robot with dry friction always are.
    """
    if own.refused:
        return []
    e = own["body_mass"]
    mass = replace(body_mass(setup, e.value, 0.0), low=e.low, high=e.high)
    white = setup.dry_friction or own.temper > WHITE
    return [mass] if white and is_beyond(mass) else []


def doubtful_mass(log: Log, setup: Assumptions, taken: Sequence[Support]) -> tuple[Support, ...]:
    """The mass that counts as contradicted beside a posterior that is not of this log: of a robot with dry friction
    what a calibration sees, else what the filter of a certificate had `taken` and no calibration sees."""
    if setup.dry_friction:
        return tuple(weighed(guessed(log, setup), setup))
    unsure = unconfirmed(taken)
    alone = unloaded(setup)
    return () if unsure and weighed(guessed(log, alone), alone) else unsure


def _own(log: Log, setup: Assumptions, progress: Progress | None) -> Calibration:
    """The calibration of the robot of `setup`, as the log shows it, between knocks."""
    robot, kit = setup.actual_robot, setup.actual_kit
    return calibrate(unpushed(log, robot, kit), _weighed(setup), kit, progress=progress)


def _weighed(met: Assumptions) -> Robot:
    """The robot with the load that the log shows, whose mass and inertias are then known as well as that."""
    robot = met.actual_robot
    if robot is met.robot:
        return robot
    stated = {name: source for name, source in met.robot.provenance.items() if name in LOADED}
    known = {name: replace(source, spread=max(source.spread, LOAD_KNOWN * getattr(robot, name)))
             for name, source in stated.items() if source.spread is not None}  # fmt: skip
    return robot.replace(provenance={**robot.provenance, **known})


def learnt(calibration: Calibration, kit: Kit, others: Sequence[Support] = ()) -> Learnt:
    """The calibrated robot with the posterior of its parameters, on `kit` with the sensor delays of the log; `others`
    are contradicted besides what the calibration moves.

    Where the log's dead times are shorter, those of the kit stay. A log of applied commands does not show all dead
    time.
    """
    rows = [i for i, name in enumerate(calibration.names) if name in PARAMETERS]
    names = [calibration.names[i] for i in rows]
    mean = [getattr(calibration.robot, name) for name in names]
    normal = Uncertainty.joint(names, mean, calibration.covariance[rows][:, rows])
    positive = [s if s.name in MAY_BE_ZERO or s.low <= 0 else _lognormal(s) for s in normal.spreads]
    uncertainty = Uncertainty(tuple(positive), normal.correlation)
    delays = {e.name.removeprefix("delay/"): e.value for e in calibration.delays if e.verdict != HELD}
    dead_time = kit.delay + kit.jitter / 2
    sensors = {
        name: replace(sensor, delay=max(sensor.delay, delays.get(SENSOR.get(name, ""), 0.0) - dead_time))
        for name, sensor in kit.sensors.items()
    }
    contradicted = tuple(Support.of_estimate(e) for e in calibration.parameters if e.surprising)
    return Learnt(
        calibration.robot, replace(kit, sensors=sensors), uncertainty, (*contradicted, *others), slope(calibration)
    )  # fmt: skip


def _lognormal(s: Spread) -> Spread:
    """As a calibration takes what must be positive: its logarithm is normal."""
    return Spread(s.name, "lognormal", s.low, s.high / s.low)


class Met(NamedTuple):
    """What is `assumed` of a robot once its log was read, what is `unknown` of its parameters, what the log says
    of the other numbers, `support`, and those that were `taken` over."""

    assumed: Assumptions
    unknown: Uncertainty | None
    support: tuple[Support, ...]
    taken: tuple[Support, ...]


def met(
    log: Log, assumed: Assumptions, unknown: Uncertainty | None, *, alone: bool, progress: Progress | None = None
) -> Met:
    """The robot that is `assumed`, as its `log` shows it. One that comes from its file `alone` is calibrated first;
    others were drawn from what is `unknown`, or are given (None)."""
    wrong = doubts = tuple[Support, ...]()
    if alone:
        own, wrong = calibrated(log, replace(assumed, robots=assumed.robots[:WITHIN]), progress)
        doubts = own.contradicted
        unknown = own.uncertainty
        robots = draw(own.robot, len(assumed.robots), assumed.seed, unknown)
        assumed = replace(assumed, robot=own.robot, robots=robots, kit=own.kit, is_weighed=True, floor=own.floor)
    assumed, shown, taken = as_logged(log, assumed)
    if unknown and not alone:
        doubts = doubtful_mass(log, assumed, taken)
    names = {s.name for s in taken}
    return Met(assumed, unknown, (*shown, *doubts), (*taken, *(s for s in wrong if s.name not in names)))
