"""What a log's commands go through before they are torque: supply, dead zone, and two motors that differ.

A body of ours says what was really applied, so that only the motors may differ there; in a foreign log the command is
what somebody computed from a duty and a battery, and each of these has its prior.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

from upright.calibration.parameters import Parameter
from upright.calibration.resonance import MEANING as RESONANCE
from upright.logs.recording import foreign
from upright.physics.dynamics import motor_gain
from upright.robots import Kit, Robot
from upright.signals import Log

ASYMMETRY, BATTERY, DEAD_ZONE, CONSTANT = "asymmetry", "battery", "dead_zone", "constant_command"
DROP = "drop"
MISALIGNED = "gyro_misalignment"
MEANING = {
    ASYMMETRY: "strength of the right motor less that of the left, over their mean",
    BATTERY: "fraction of the logged command that reaches the motors",
    DEAD_ZONE: "commands up to this size do not move the motors",
    DROP: "volts that the driver keeps of each command, as the motors get them",
    MISALIGNED: "part of the yaw rate that the gyro reads beside the pitch rate",
    CONSTANT: "what a sloping floor, or an offset of the motors, adds to both commands",
    **RESONANCE,
}

UNEQUAL = 0.05  # [1] spread of the difference of two motors of one make
SLOPE = math.radians(0.5)
"""Spread of the slope of a floor. A robot on a slope leans, so that its weight holds it; what is left of the slope, as
far as sensors without a vertical can tell, is a constant torque of each wheel (to first order)."""
UNMEASURED = 0.1  # [1] spread of a supply that was not logged: a full and an empty battery differ by a quarter
TILTED = 0.15  # [1] spread of the sine of a gyro's tilt: boards are set by eye, some askew by 15°
MEASURED = 0.02  # [1] spread where it was: drop in driver and wires


def electronics_of(robot: Robot, kit: Kit, logs: Sequence[Log]) -> tuple[Parameter, ...]:
    """The parameters between the commands of these logs and the motors, with their priors."""
    strength = (kit.motor.left + kit.motor.right) / 2
    slope = (robot.body_mass + 2 * robot.wheel_mass) * robot.gravity * robot.wheel_radius * math.sin(SLOPE) / 2
    parameters = [
        Parameter(ASYMMETRY, "1", (kit.motor.right - kit.motor.left) / strength, UNEQUAL, "linear"),
        Parameter(CONSTANT, robot.command_unit, 0.0, slope / motor_gain(robot), "linear", guess=True),
    ]
    own = not foreign(logs)
    if robot.drive == "voltage" and (not own or strength != 1):
        measured = own or all("sensor/battery" in log for log in logs)
        parameters.append(Parameter(BATTERY, "1", strength, MEASURED if measured else UNMEASURED, "logarithm"))
    zone = 0.0 if own else kit.motor.dead_zone
    if zone:
        parameters.append(Parameter(DEAD_ZONE, robot.command_unit, zone, zone / 2, "linear", 0.0, True))
    if drop := 0.0 if own else strength * kit.motor.drop:
        parameters.append(Parameter(DROP, robot.command_unit, drop, drop / 2, "linear", 0.0, True))
    gyro = kit.sensors.get("sensor/gyro")
    if gyro and gyro.misalignment:
        parameters.append(Parameter(MISALIGNED, "1", gyro.misalignment, TILTED, "linear", guess=True))
    return tuple(parameters)
