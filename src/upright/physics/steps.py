"""How finely the motion of a robot must be cut into steps of `integrate.rk4_step`."""

from __future__ import annotations

import math
from collections.abc import Mapping
from types import MappingProxyType

import numpy as np

from upright.errors import InvalidRobot
from upright.physics.integrate import SIMULATED
from upright.physics.linear import tangent
from upright.robots import Robot
from upright.robots.robot import unusual

SHORTEST = 2e-6
"""[s] Shortest step of `rk4_step`: 500 of them in a millisecond, where a robot of usual numbers takes one to thirty."""


_ROUNDING = 1e-6  # of a pole: what an eigenvalue is off by is no reason for another step


def steps_of(robot: Robot, period: float, limit: float = SIMULATED, model: str = "complete") -> int:
    """`substeps` in a `period` [s] for the fastest pole of `robot`."""
    fastest = float(np.abs(tangent(robot, model=model).poles()).max())
    return substeps(period, fastest, limit, numbers=robot.numbers())


def substeps(
    period: float, fastest: float, limit: float = SIMULATED, *, numbers: Mapping[str, float] = MappingProxyType({})
) -> int:
    """Steps in a `period` [s] that keep |pole|·h within `limit` for the `fastest` |pole| [1/s].

    Raises `InvalidRobot` for a pole that would take steps below `SHORTEST`, and names which of the robot's `numbers` is
    the likely cause.
    """
    if not fastest * SHORTEST <= limit:
        cause = unusual(numbers) or "inertias, friction and the motor's constants"
        raise InvalidRobot(
            f"a pole of {fastest:.2g} 1/s needs {fastest * period / limit:.3g} steps in a period of {period:g} s",
            expected=f"at most {period / SHORTEST:.3g}", hint=f"check {cause}",
        )  # fmt: skip
    return max(1, math.ceil(fastest * period / limit * (1 - _ROUNDING)))
