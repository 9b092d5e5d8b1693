"""How finely the motion of a robot must be cut into steps of `integrate.rk4_step`."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from upright.errors import InvalidRobot
from upright.physics.integrate import SIMULATED, substeps
from upright.physics.linear import tangent
from upright.robots import Robot
from upright.robots.robot import unusual

SHORTEST = 2e-6
"""[s] Shortest step of `rk4_step`: 500 of them in a millisecond, where a robot of usual numbers takes one to thirty."""


def steps_of(robot: Robot, period: float, limit: float = SIMULATED, model: str = "complete") -> int:
    """Steps in a `period` [s] that keep |pole|·h of the fastest pole of `robot` within `limit`.

    Raises `InvalidRobot` for a pole that would take steps below `SHORTEST`.
    """
    fastest = float(np.abs(tangent(robot, model=model).poles()).max())
    return steps_for(fastest, period, robot.numbers(), limit)


def steps_for(fastest: float, period: float, numbers: Mapping[str, float], limit: float = SIMULATED) -> int:
    """The same for the `fastest` |pole| [1/s] of the robot with these `numbers`; the error names the one of them that
    is the likely cause."""
    if not fastest * SHORTEST <= limit:
        cause = unusual(numbers) or "inertias, friction and the motor's constants"
        raise InvalidRobot(
            f"a pole of {fastest:.2g} 1/s needs {fastest * period / limit:.3g} steps in a period of {period:g} s",
            expected=f"at most {period / SHORTEST:.3g}", hint=f"check {cause}",
        )  # fmt: skip
    return substeps(period, fastest, limit)
