"""What the predictor is made of: coefficients of the motion, of what drives it and of the sensors, and what they follow
from.

They are products and quotients of masses, lengths and inertias, and the only thing that a log shows of these.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from upright.arrays import Array, Whole
from upright.calibration.electronics import ASYMMETRY, BATTERY, CONSTANT, DEAD_ZONE, DROP, MISALIGNED
from upright.calibration.parameters import ROLL_FRACTION, Parameter, roll_fraction
from upright.calibration.resonance import DAMPING, FREQUENCY, resonates
from upright.compiled.generated import Constants
from upright.robots import PARAMETERS, Robot

NUDGE = 1e-4  # of the prior's deviation: central differences are right to 1e-8, and rounding stays below
AHEAD = 1e-6  # of the same: differences to one side, of a log's innovations, are right to 1e-5; rounding stays below
ZONE_AHEAD = 0.2
"""[1] of the same, and half of it of a dead zone: commands have levels, and between two of them it changes nothing. So
its slope is a secant over several levels, without which the readings would seem to tell nothing of it."""
AT = Constants(*range(len(Constants._fields)))
"""Where each named constant of the equations stands among the coefficients."""
DRIVEN = len(AT)
TURN_READ = len(AT) + 5
DELAYS = len(AT) + 6
"""Where among the coefficients begins what drives the robot, where what the gyro reads of the yaw rate is, and where
the delays begin."""
ZONE, LOST = DRIVEN + 2, DRIVEN + 4
LEVEL = (
    AT.half_track, AT.motor_damping, AT.centrifugal, AT.weight, AT.coulomb_torque, AT.motor_torque, AT.lever,
    AT.rolling_damping, AT.turning_lever, AT.yaw_coriolis, AT.yaw_lever, AT.yaw_damping, AT.yaw_motor_torque,
    AT.rotor_coupling, AT.pitch_inertia, AT.yaw_swing, AT.stiction_rate_squared,
)  # fmt: skip
"""The constants that a robot on a level floor shows; the rest belong to slopes and pushes."""
ROLLING_DRY = (AT.rolling_torque, AT.yaw_rolling_torque)
"""Those of rolling friction, which have no error of their own: it is far less certain than the equations."""
EXACT = 7e-4
"""How right the equations are (root mean square): with the same numbers they and MuJoCo, whose contacts yield a little,
differ by 0.04 % in pitch and 0.07 % in the wheel rate (docs/model.md), and no real robot is nearer to either."""
TURNED = 1.5e-3
"""How right the coupling is where there is dry friction, of the geometric mean of both inertias: wheels that turn back,
which MuJoCo does at the end of a time step, differ by what a rotor of 0.1 % of all that rolls would do."""
SHARPER = 10.0  # [1] times that rolling friction may be sharper than the file says, with a probability of 95 %
SMOOTH = 2 * math.log(SHARPER) / 1.96
"""Spread of the logarithm of ω_c², below which rolling friction is smooth. Nobody measures it: a file has what keeps
simulations quick. With 0.2 rad/s for the 0.02 of a simulated robot its pitch inertia was off by 13 %."""
EQUATION = "equation/"
EQUATIONS = tuple(
    Parameter(f"{EQUATION}{i}", "1", 0.0, EXACT, "linear", 0.0 if i == AT.stiction_rate_squared else -math.inf)
    for i in LEVEL
)
"""By what share each constant of the equations is off, and by which power of a factor ω_c² is: estimated beside the
parameters, and never reported."""


class Priors(NamedTuple):
    """The `given` numbers (n,): the robot's, with the roll inertia by its fraction, its electronics', dead times, and
    resonance. Of what is asked its `place` among these, and by what it follows from its coordinate: `prior`, `spread`,
    `rate` and `lower`, all (asked,). Whether the robot `rubs`, and whether its gyro `swings`."""

    given: Array
    place: Whole
    prior: Array
    spread: Array
    rate: Array
    lower: Array
    rubs: bool
    swings: bool


class Curves(NamedTuple):
    """How a run's numbers follow from the parameters by `maps` (runs, shared, parameters), not below `least` (shared,),
    and the `priors` of what the coefficients follow from."""

    maps: Array
    least: Array
    priors: Priors


class Bowls(NamedTuple):
    """The readings' part of the objective about the coefficients `at` (runs, coefficients): its `gradient` (runs,
    coefficients) and `hessian` (runs, coefficients, coefficients) by them."""

    at: Array
    gradient: Array
    hessian: Array


def priors_of(
    robot: Robot, asked: Sequence[Parameter], delays: Mapping[str, float], exact: Mapping[str, float]
) -> Priors:
    """The numbers of `robot`, those of its electronics that are `exact`, and the dead times `delays` [s] of its
    sensors, of which some are `asked`."""
    given = {**robot.numbers(), "roll_inertia": roll_fraction(robot)}
    given = {name: given[name] for name in PARAMETERS}
    given |= {ASYMMETRY: 0.0, BATTERY: 1.0, DEAD_ZONE: 0.0, CONSTANT: 0.0, DROP: 0.0, MISALIGNED: 0.0, **exact}
    given |= {f"delay/{name}": delay for name, delay in delays.items()}
    given |= dict.fromkeys([FREQUENCY, DAMPING] if resonates(asked) else [], np.nan)
    place = {name: i for i, name in enumerate(given)}
    place[ROLL_FRACTION] = place["roll_inertia"]
    prior, spread, rate, lower = (
        np.array([getattr(p, name) for p in asked], dtype=np.float64) for name in ("prior", "spread", "rate", "lower")
    )
    places = np.array([place[p.name] for p in asked], dtype=np.int64)
    numbers = np.array([*given.values()], dtype=np.float64)
    rubs = bool(robot.coulomb_friction)
    return Priors(numbers, places, prior, spread, rate, lower, rubs, resonates(asked))


def around(z: Array) -> Array:
    """Lanes (n, 2n + 1) a nudge above z (n,) in each parameter, then a nudge below, then z."""
    n = len(z)
    lanes = np.empty((n, 2 * n + 1))
    for i in range(n):
        lanes[i] = z[i]
        lanes[i, i] += NUDGE
        lanes[i, n + i] -= NUDGE
    return lanes


def slopes_of(values: Array) -> Array:
    """By z (..., n), of what the lanes of `around` give (..., 2n + 1)."""
    n = (values.shape[-1] - 1) // 2
    return (values[..., :n] - values[..., n:-1]) / (2 * NUDGE)
