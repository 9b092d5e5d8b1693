"""Wheels that slip: what a floor that holds no more than a fraction of the weight does to the innovations."""

from __future__ import annotations

import math

import numpy as np

from upright.arrays import Array, Mask
from upright.diagnose.innovations import FilterRun
from upright.physics.dynamics import motor_damping, motor_torque, rolling_friction, turn_ratio

HELD_BY_ANY = 0.8  # of the weight, that a good floor holds: beyond, wheels slide by the commands alone


def slipping(run: FilterRun, onset: Array, grip: Array) -> tuple[Array, Mask]:
    """What slipping adds to the innovations (events, hypotheses), and whether a hypothesis slips at all.

    The sums of the equations of a robot on a floor of force f, M_t ẍ + M L (ψ̈ cos ψ − ψ̇² sin ψ) = f, are those of
    rolling with a slip s = Rθ̈ − ẍ that acts as the force M_t s at the axle and the moment M L cos ψ s. A slipping
    wheel loses its load and runs up within milliseconds, so that s falls off within a span by the motor's damping.
    """
    p = run.robot
    free, per_force, per_torque = _slip_acceleration(run)
    total = p.body_mass + 2 * p.wheel_mass
    lever = p.body_mass * p.com_height
    damping = 2 * motor_damping(p)
    most = grip * total * p.gravity
    error = np.zeros((run.gains.shape[1], len(grip)))
    response = np.zeros((len(run.t), len(grip)))
    speed = np.zeros(len(grip))
    slipped = np.zeros(len(grip), dtype=np.bool_)
    for i, span in enumerate(run.spans):
        if span > 1e-9:
            own = free[i] - per_torque[i] * damping * (error[3] - error[1])
            needed = -own / per_force[i]
            sliding = (speed != 0) | ((run.t[i] >= onset) & (np.abs(needed) > most))
            way = np.where(speed != 0, np.sign(speed), np.sign(needed))
            rate = per_torque[i] * damping / p.wheel_radius
            falls_off = -math.expm1(-rate * span) / (rate * span) if rate * span > 1e-6 else 1.0
            s = np.where(sliding, (own + per_force[i] * most * way) * falls_off, 0.0)
            grips = sliding & (way * (speed + s * span) <= 0)
            s = np.where(grips, -speed / span, s)
            speed = np.where(grips, 0.0, speed + s * span)
            slipped |= s != 0
            entered = run.tangent.gamma[i][:, 2] * total + run.tangent.gamma[i][:, 3] * lever
            error[:6] = run.tangent.phi[i] @ error[:6] + entered[:, None] * s
        response[i] = run.corrected(i, error)
    return response, slipped


def slid_at(run: FilterRun, start: float, end: float) -> float | None:
    """The first time [s] between two at which a robot that rolls would need more of the floor than a good one holds;
    None where it never does."""
    free, per_force, _ = _slip_acceleration(run)
    weight = (run.robot.body_mass + 2 * run.robot.wheel_mass) * run.robot.gravity
    inside = (run.t > start) & (run.t < end) & (run.spans > 1e-9)
    sliding = np.flatnonzero(inside & (np.abs(free / per_force) > HELD_BY_ANY * weight))
    return float(run.t[sliding[0]]) if len(sliding) else None


def _slip_acceleration(run: FilterRun) -> tuple[Array, Array, Array]:
    """Rθ̈ − ẍ [m/s²] without any force of the floor, and what a newton of it and a newton metre of the motors add
    (events,)."""
    p, x, u = run.robot, run.before, run.command
    cos = np.cos(x[:, 0])
    sin = np.sin(x[:, 0])
    rate = x[:, 3] - x[:, 1]
    turn = turn_ratio(p) * x[:, 5]
    torque = motor_torque(u[:, 0], rate - turn, p, np) + motor_torque(u[:, 1], rate + turn, p, np)
    total = p.body_mass + 2 * p.wheel_mass
    lever = p.body_mass * p.com_height
    rotors = 2 * p.gear_ratio**2 * p.rotor_inertia
    n = len(x)
    M = np.zeros((n, 3, 3))  # of ẍ, θ̈, ψ̈
    M[:, 0, 0], M[:, 0, 2], M[:, 2, 0] = total, lever * cos, lever * cos
    M[:, 1, 1], M[:, 1, 2], M[:, 2, 1] = 2 * p.wheel_inertia + rotors, -rotors, -rotors
    M[:, 2, 2] = lever * p.com_height + p.pitch_inertia + rotors
    drag = 2 * p.wheel_friction * x[:, 3]
    drag += rolling_friction(x[:, 3] - turn, p, np) + rolling_friction(x[:, 3] + turn, p, np)
    forces = np.zeros((n, 3, 3))  # what acts without the floor, a newton of it, a newton metre of the motors
    forces[:, :, 0] = np.stack([lever * x[:, 1] ** 2 * sin, torque - drag, lever * p.gravity * sin - torque], axis=1)
    forces[:, :, 1], forces[:, :, 2] = (1.0, -p.wheel_radius, 0.0), (0.0, 1.0, -1.0)
    accelerations = np.linalg.solve(M, forces)
    slip = p.wheel_radius * accelerations[:, 1] - accelerations[:, 0]
    return slip[:, 0], slip[:, 1], slip[:, 2]
