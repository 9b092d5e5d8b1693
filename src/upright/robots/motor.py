"""A motor that no motor is: one that would give more power than it takes."""

from __future__ import annotations

import math

from upright.errors import InvalidRobot
from upright.robots.robot import Robot
from upright.robots.uncertainty import deviations


def makes_energy(robot: Robot) -> str:
    """Why the motor would make energy, by more than three deviations of its numbers, and the likely slip; "" where it
    would not. In SI units a torque constant is its back-EMF's at most, both on one side of the gear."""
    n, torque, emf = robot.gear_ratio, robot.torque_constant, robot.back_emf
    gear, turning, induced = (deviations(robot).get(k, 0.0) for k in ("gear_ratio", "torque_constant", "back_emf"))
    if robot.drive == "torque" or n * torque - emf <= 3 * math.hypot(gear * torque, n * turning, induced):
        return ""
    return (
        f"{robot.name} has a motor that makes energy: gear_ratio · torque_constant is {n * torque:.3g} N m/A, above "
        f"back_emf, {emf:.3g} V s/rad; likely other units (oz in, kg cm, rpm) in one, or the other side of the gear"
    )


def refuse_energy(robot: Robot) -> Robot:
    """The robot, for what drives it; raises `InvalidRobot` where its motor `makes_energy`."""
    if wrong := makes_energy(robot):
        raise InvalidRobot(wrong, hint="correct its file; until then only upright linearise and simulate answer")
    return robot
