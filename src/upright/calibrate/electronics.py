"""What a log's commands go through before they are torque: supply, dead zone, and two motors that differ.

A body of ours says what was really applied, so that only the motors may differ there; in a foreign log the command is
what somebody computed from a duty and a battery, and each of these has its prior.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.parameters import Parameter
from upright.robots import Kit, Robot
from upright.signals import Log

Array = NDArray[np.float64]

ASYMMETRY, BATTERY, DEAD_ZONE = "asymmetry", "battery", "dead_zone"
MEANING = {
    ASYMMETRY: "strength of the right motor less that of the left, over their mean",
    BATTERY: "fraction of the logged command that reaches the motors",
    DEAD_ZONE: "commands up to this size do not move the motors",
}

UNEQUAL = 0.05  # [1] spread of the difference of two motors of one make
UNMEASURED = 0.1  # [1] spread of a supply that was not logged: a full and an empty battery differ by a quarter
MEASURED = 0.02  # [1] spread where it was: drop in driver and wires


def electronics_of(robot: Robot, kit: Kit, logs: Sequence[Log]) -> tuple[Parameter, ...]:
    """The parameters between the commands of these logs and the motors, with their priors."""
    strength = (kit.motor.left + kit.motor.right) / 2
    parameters = [Parameter(ASYMMETRY, "1", (kit.motor.right - kit.motor.left) / strength, UNEQUAL, "linear")]
    own = all("body" in log.origin for log in logs)
    if robot.drive == "voltage" and (not own or strength != 1):
        measured = own or all("sensor/battery" in log for log in logs)
        parameters.append(Parameter(BATTERY, "1", strength, MEASURED if measured else UNMEASURED, "logarithm"))
    zone = 0.0 if own else kit.motor.dead_zone
    if zone:
        parameters.append(Parameter(DEAD_ZONE, robot.command_unit, zone, zone / 2, "linear", 0.0, True))
    return tuple(parameters)


def driven(parameters: Sequence[Parameter], z: Array) -> Array:
    """Factor of the left and of the right motor and dead zone (3, lanes) at z (parameters, lanes)."""
    values = {p.name: np.asarray(p.value(z[i])) for i, p in enumerate(parameters) if p.name in MEANING}
    half = values.get(ASYMMETRY, np.zeros(z.shape[1])) / 2
    supply = values.get(BATTERY, np.ones(z.shape[1]))
    return np.array([supply * (1 - half), supply * (1 + half), values.get(DEAD_ZONE, np.zeros(z.shape[1]))])
