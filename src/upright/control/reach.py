"""How far a robot may lean before its motors cannot bring it back, whatever the controller."""

from __future__ import annotations

import math

import numpy as np

from upright.errors import DesignFailed
from upright.physics.dynamics import motor_gain
from upright.physics.linear import linearise_rolling
from upright.robots import Kit, Robot


def largest_command(robot: Robot, kit: Kit) -> float:
    """What the motors are sure to get: the driver's limit, and for volts the battery under both motors at full."""
    full = kit.battery.voltage
    battery = full * (1 - 2 * kit.battery.sag) if robot.command_unit == "V" and math.isfinite(full) else math.inf
    return min(kit.motor.limit, battery)


def largest_pitch(robot: Robot, kit: Kit, limit: float | None = None) -> float:
    """The largest pitch [rad] at rest from which a command of ± `limit` (None: the kit's) brings the robot back.

    Along the falling mode ξ = wᵀx the linear robot obeys ξ̇ = λ ξ + wᵀB u. It can be brought to rest if and only if
    |ξ| < Σ|wᵀB| limit / λ; beyond, gravity is stronger than the motors (Hu and Lin 2001, theorem 2.3). With dead time
    τ, ξ grows by e^{λτ} before the first command arrives. The bound may lie outside the range of a linear model.
    """
    most = largest_command(robot, kit) if limit is None else limit
    if not most > 0:
        raise DesignFailed(f"limit is {most}", expected="a positive command")
    model = linearise_rolling(robot)
    values, vectors = np.linalg.eig(model.A.T)
    index = int(np.argmax(np.real(values)))
    falling = float(np.real(values)[index])
    w = np.real(vectors)[:, index]
    reach = float(np.abs(w @ model.B).sum()) * most / falling
    return reach / abs(float(w[0])) * float(np.exp(-falling * kit.delay))


def static_pitch(robot: Robot, kit: Kit, limit: float | None = None) -> float:
    """The pitch [rad] at which gravity's moment M g L sin ψ equals what both motors give at standstill, 2 α limit.

    It is π/2 where the motors can lift the body off the floor. A robot leaning on a prop can be held up to here, not
    brought back from it.
    """
    most = largest_command(robot, kit) if limit is None else limit
    ratio = 2 * motor_gain(robot) * most / (robot.body_mass * robot.gravity * robot.com_height)
    return float(np.arcsin(min(ratio, 1.0)))
