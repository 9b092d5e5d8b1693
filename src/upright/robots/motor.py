"""What a motor makes of a command: gains in torque, volts or duty, and a motor that would make energy."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, read_only
from upright.errors import InvalidRobot, UnknownName
from upright.robots.kit import Kit
from upright.robots.robot import Robot
from upright.robots.uncertainty import deviations


def makes_energy(robot: Robot) -> str:
    """Why the motor would make energy, by more than three deviations of its numbers, and the likely slip; "" where it
    would not. In SI units a torque constant is its back-EMF's at most, both on one side of the gear."""
    n, torque, emf = robot.gear_ratio, robot.torque_constant, robot.back_emf
    gear, turning, induced = (deviations(robot).get(k, 0.0) for k in ("gear_ratio", "torque_constant", "back_emf"))
    if robot.drive != "voltage" or n * torque - emf <= 3 * math.hypot(gear * torque, n * turning, induced):
        return ""
    return (
        f"{robot.name} has a motor that makes energy: gear_ratio · torque_constant is {n * torque:.3g} N m/A, above "
        f"back_emf, {emf:.3g} V s/rad; likely other units (oz in, kg cm, rpm) in one, or the other side of the gear"
    )


def refuse_energy(robot: Robot) -> Robot:
    """The robot, for what drives it; raises `InvalidRobot` where its motor `makes_energy`."""
    if wrong := makes_energy(robot):
        raise InvalidRobot(wrong, hint="correct its file; certify, firmware and fly refuse it until then")
    return robot


COMMAND_UNITS = ("N m", "V", "duty", "%", "PWM")
"""Torque of a motor at its wheel, behind the gear; volts at the motor; parts of the battery's voltage, of 1, of 100 or
of the counts of full PWM."""


class ConvertedGain(NamedTuple):
    """A `gain` (2, 6) of u = −K x in another unit, and what `changes` against the gain that it is of."""

    gain: Array
    changes: tuple[str, ...]


def converted_gain(
    gain: ArrayLike, robot: Robot, kit: Kit, was: str, unit: str, full_pwm: float = 255.0
) -> ConvertedGain:
    """The gain by which commands in `unit` move the robot as `gain` does by commands in the unit that it `was` in.

    A motor gives τ = n K_t/R_m (u − K_b ω) at its wheel, where ω is the wheel's rate less the pitch rate. So a torque
    needs u = R_m/(n K_t) τ + K_b ω: a gain in N m becomes one in volts with a term on ω that no scale replaces.

    `gain` (2, 6), from the state in SI units to [left, right] as u = −K x, or the left motor's row (6,); both units are
    of `COMMAND_UNITS`. Duty is of the `kit`'s battery, and `full_pwm` the count of full duty, 255 of an Arduino. Raises
    `InvalidRobot` for a torque drive, a kit without a battery, or a gain of another shape.
    """
    battery = kit.battery.voltage
    volts_of = {"V": 1.0, "duty": battery, "%": battery / 100, "PWM": battery / full_pwm}
    for name in (was, unit):
        if name not in COMMAND_UNITS:
            raise UnknownName("unit of a command", name, COMMAND_UNITS)
        if volts_of.get(name) == math.inf:
            raise InvalidRobot(f"kit '{kit.name}' states no battery", expected="its voltage, of which duty is a part")
    if robot.drive != "voltage":
        raise InvalidRobot(f"{robot.name} has a {robot.drive} drive", expected="a voltage drive, whose motor is known")
    row = np.array(gain, dtype=np.float64)
    rows = np.array([row, row * [1, 1, 1, 1, -1, -1]]) if row.shape == (6,) else row
    if rows.shape != (2, 6):
        raise InvalidRobot(f"a gain of shape {row.shape}", expected="(2, 6), or (6,) of the left motor")
    if was == unit:
        return ConvertedGain(read_only(rows), ())
    torque = robot.gear_ratio * robot.torque_constant / robot.motor_resistance  # [N m/V]
    turn = robot.track / (2 * robot.wheel_radius)
    back_emf = robot.back_emf * np.array([[0, -1, 0, 1, 0, -turn], [0, -1, 0, 1, 0, turn]])  # K_b ω, from the state
    term = f"the back-EMF, {robot.back_emf:.4g} V s/rad on the wheel's rate less the pitch rate"
    changes: list[str] = []
    if was == "N m":
        rows = rows / torque - back_emf
        changes.append(f"times {1 / torque:.4g} V/(N m), R_m/(n K_t), less {term}")
    elif was != "V":
        rows = rows * volts_of[was]
        changes.append(f"times {volts_of[was]:.4g} V/{was}, of a battery of {battery:g} V")
    if unit == "N m":
        rows = torque * (rows + back_emf)
        changes.append(f"plus {term}, times {torque:.4g} N m/V, n K_t/R_m")
    elif unit != "V":
        rows = rows / volts_of[unit]
        changes.append(f"times {1 / volts_of[unit]:.4g} {unit}/V, of a battery of {battery:g} V")
    if kit.motor.drop:
        changes.append(f"the driver keeps {kit.motor.drop:g} V of each command, which no gain makes up for")
    return ConvertedGain(read_only(rows), tuple(changes))
