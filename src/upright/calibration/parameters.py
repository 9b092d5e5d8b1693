"""What a calibration estimates: the robot's numbers and the dead times, in coordinates of the prior.

Every parameter p is a function of one number z that the prior takes for standard normal: p = p₀ exp(z σ/p₀) for what
must be positive, p = p₀ + z σ for what may be zero or negative. So z = 0 is what was known before, |z| = 1 one standard
deviation away, and the information of a log about z is in units of the prior's.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any, Literal

import numpy as np

from upright.arrays import Mask
from upright.errors import UnknownName
from upright.physics.dynamics import motor_damping, motor_gain
from upright.robots import PARAMETERS, Robot
from upright.robots.drives import UNUSED
from upright.robots.robot import LEAST, MAY_BE_ZERO
from upright.robots.uncertainty import GUESS, roll_bounds, stated

NEVER = ("gear_ratio", "stiction_rate", "body_depth", "body_height", "roll_inertia")
"""What no log is asked: a convention, a smoothing (the predictor's friction is dry), two measures for drawing,
and the roll inertia, in whose place stands `ROLL_FRACTION`."""

GEAR = "gear_ratio"
"""Asked only of a torque drive whose file says how uncertain it is: there it is the torque at the wheel over the
commanded torque. Masses that were weighed tell it; without them a log gives every mass and torque up to one factor."""

LOSSES = ("motor_friction", "wheel_friction", "coulomb_friction")
"""Guesses that stand in for what a wrong motor of the file does not brake: on real logs they move by 1.1 deviations."""

ROLLING = "rolling_friction"
"""Asked of every log that no body of ours made, since real wheels resist, and where the robot's file names it. A log of
a body has what the file says."""

ROLL_FRACTION = "roll_fraction"
"""Where the roll inertia lies between |J_ψ − J_φ| and J_ψ + J_φ, its least and its largest in a rigid body."""
ANYWHERE = 1 / math.sqrt(12)
"""Deviation of a share that may be anything from 0 to 1."""

ROUNDING = 1e-12  # of a spread: a parameter that close to its bound is at it, as zero is zero and not 1.7e-21
SOFT = 0.03  # [1] rolling resistance over load: rubber on a hard floor has 0.01 to 0.02, on a carpet up to 0.1
DELAY_SPREAD = 0.02  # [s] one standard deviation of a dead time, about two periods: kits say little of theirs
SENSORS = ("encoder", "gyro", "compass")


@dataclass(frozen=True)
class Parameter:
    """A number to estimate: its `prior`, the prior's `spread` (one standard deviation) and whether z acts on it or on
    its logarithm. `lower` bounds it; `guess` says that nobody measured the prior."""

    name: str
    unit: str
    prior: float
    spread: float
    scale: Literal["linear", "logarithm"]
    lower: float = -math.inf
    guess: bool = False

    def value(self, z: Any) -> Any:
        """The parameter at the coordinate z."""
        return _values(z, self.prior, self.spread, self.rate, self.lower)[()]

    @property
    def rate(self) -> float:
        """How much its logarithm changes by z; 0 where z acts on the number itself."""
        return self.spread / self.prior if self.scale == "logarithm" else 0.0

    def coordinate(self, value: float) -> float:
        """The inverse of `value`."""
        if self.scale == "logarithm":
            return math.log(value / self.prior) * self.prior / self.spread
        return (value - self.prior) / self.spread

    @property
    def least(self) -> float:
        """The smallest z allowed."""
        return (self.lower - self.prior) / self.spread if self.scale == "linear" else -math.inf


def value_at(z: Any, prior: Any, spread: Any, rate: Any, lower: Any) -> Any:
    """A parameter at the coordinate z, of numbers alone: compiled for the coefficients, too."""
    if rate > 0:
        return prior * np.exp(z * rate)
    linear = prior + z * spread
    return lower if abs(linear - lower) < ROUNDING * spread else linear


_values = np.vectorize(value_at, otypes=[np.float64])


def parameters_of(
    robot: Robot,
    delays: Mapping[str, float],
    known: Sequence[str] = (),
    others: Sequence[Parameter] = (),
    *,
    foreign: bool = False,
) -> tuple[Parameter, ...]:
    """What a log of `robot` may tell, with its priors: its numbers, `others`, and the dead time from the command to
    each sensor in `delays`. `foreign` logs are of a robot that rolls on a real floor.

    `known` names what is taken for exact. Raises `UnknownName` for a name that is none of these.
    """
    never = {*NEVER, *UNUSED[robot.drive]}
    if _asks_torque(robot):
        never.remove(GEAR)
    if not (foreign or robot.rolling_friction or ROLLING in robot.provenance):
        never.add(ROLLING)
    names = [n for n in PARAMETERS if n not in never]
    physical = [_physical(robot, name, stated(robot, name)) for name in names]
    delay_parameters = [
        Parameter(f"delay/{name}", "s", d, DELAY_SPREAD, "linear", -DELAY_SPREAD) for name, d in delays.items()
    ]
    known = [ROLL_FRACTION if name == "roll_inertia" else name for name in known]
    every = [p for p in (*physical, _roll_fraction(robot), *others, *delay_parameters) if p.spread > 0]
    for name in known:
        if name not in (p.name for p in every):
            raise UnknownName("parameter", name, [p.name for p in every])
    return tuple(p for p in every if p.name not in known)


def _asks_torque(robot: Robot) -> bool:
    return robot.drive == "torque" and GEAR in robot.provenance and stated(robot, GEAR) != 0


def smooth(robot: Robot) -> Robot:
    """`robot` with friction at least as smooth as that of a file which says nothing: there the search for how sharp it
    is begins. One that began where an earlier calibration ended could never come back."""
    return robot.replace(stiction_rate=max(robot.stiction_rate, Robot.stiction_rate))


def as_guess(robot: Robot, parameter: Parameter) -> Parameter:
    """The same parameter as if nobody had measured it."""
    if parameter.name in PARAMETERS:
        return _physical(robot, parameter.name, None)
    return replace(parameter, spread=GUESS * abs(parameter.prior), guess=True)


def _physical(robot: Robot, name: str, spread: float | None) -> Parameter:
    value = getattr(robot, name)
    unit = PARAMETERS[name][0]
    guess = spread is None
    if name in MAY_BE_ZERO:
        return Parameter(name, unit, value, _scale(robot, name) if spread is None else spread, "linear", 0.0, guess)
    return Parameter(name, unit, value, GUESS * value if spread is None else spread, "logarithm", 0.0, guess)


def _roll_fraction(robot: Robot) -> Parameter:
    low, high = roll_bounds(robot.pitch_inertia, robot.yaw_inertia)
    spread = stated(robot, "roll_inertia")
    size = ANYWHERE if spread is None else min(spread / (high - low), ANYWHERE)
    return Parameter(ROLL_FRACTION, "1", roll_fraction(robot), size, "linear", 0.0, guess=spread is None)


def _scale(robot: Robot, name: str) -> float:
    """How large a loss or a rotor of unknown size may well be [its unit]: what the rest of the robot would notice.

    That is wider than a guess (`robots.uncertainty`), which leaves a zero at zero: a log is to find what no source
    names, and the prior is only to keep the fit finite.
    """
    total = 2 * robot.wheel_mass + robot.body_mass
    mass = total * robot.wheel_radius**2 + 2 * robot.wheel_inertia
    stall = motor_gain(robot) * 0.3 if robot.drive == "voltage" else 0.0  # [N m] what 0.3 V give, a motor's dead zone
    scale = {
        "rotor_inertia": mass / (2 * robot.gear_ratio**2),  # as much as all else that rolls
        "coulomb_friction": max(stall, 0.3 * robot.wheel_radius * robot.wheel_mass * robot.gravity),
        "rolling_friction": SOFT * robot.wheel_radius * total / 2 * robot.gravity,
        "back_emf": robot.back_emf,
    }
    drag = max(motor_damping(robot) / 5, mass / 2)  # a fifth of what is there, or what halts the robot within seconds
    return max(scale.get(name, drag), getattr(robot, name))


def most_friction(robot: Robot) -> float:
    """Dry friction of a wheel [N m] as large as it may well be: its prior, or the prior's spread."""
    p = _physical(robot, "coulomb_friction", stated(robot, "coulomb_friction"))
    return max(p.prior, p.spread)


def _or_zero(name: str, value: float) -> float:
    """The value, or zero where it is smaller than a loss or a rotor that a robot's file may have."""
    return 0.0 if name in MAY_BE_ZERO and value < LEAST else value


def with_values(robot: Robot, values: Mapping[str, float]) -> Robot:
    """`robot` with new numbers, its roll inertia where `ROLL_FRACTION` says between its bounds, or where it stood."""
    physical = {name: _or_zero(name, value) for name, value in values.items() if name in PARAMETERS}
    changed = SimpleNamespace(**robot.numbers() | physical)
    fraction = min(max(values.get(ROLL_FRACTION, roll_fraction(robot)), 0.02), 0.98)
    return robot.replace(**physical, roll_inertia=float(_roll_inertia(changed, fraction)))


def roll_fraction(robot: Robot) -> float:
    """Where the roll inertia of `robot` lies between its bounds, away from their ends."""
    low, high = roll_bounds(robot.pitch_inertia, robot.yaw_inertia)
    return min(max((robot.roll_inertia - low) / (high - low), 0.02), 0.98)


def between(bounds: Any, fraction: Any) -> Any:
    """This `fraction` of the way from the first to the second of `bounds`."""
    return bounds[0] + fraction * (bounds[1] - bounds[0])


def _roll_inertia(p: Any, fraction: Any) -> Any:
    """J_ρ of parameters `p` (numbers or arrays), at this `fraction` of the way between its bounds."""
    return between(roll_bounds(p.pitch_inertia, p.yaw_inertia), fraction)


def columns(robot: Robot, values: Mapping[str, Any]) -> Any:
    """The robot's numbers, with the fields of `Robot`: those of `values` (arrays over lanes) in place of its own."""
    changed = SimpleNamespace(**robot.numbers() | {n: v for n, v in values.items() if n in PARAMETERS})
    fraction = values[ROLL_FRACTION] if ROLL_FRACTION in values else roll_fraction(robot)
    changed.roll_inertia = _roll_inertia(changed, fraction)
    return changed


def rows_of(mask: Mask) -> list[int]:
    """The rows that a mask (n,) keeps."""
    return [int(row) for row in np.flatnonzero(mask)]
