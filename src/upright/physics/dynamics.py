"""The equations of motion, written once.

State x = [ψ, ψ̇, θ, θ̇, φ, φ̇], command u = [u_l, u_r] (Herrera et al. 2015, eqs. 17 and 18): ψ pitch from the
floor's normal, θ mean wheel angle from the same line, φ yaw anticlockwise. With α = n K_t / R_m and
β = n K_t K_b / R_m + f_m the motion obeys (eqs. 11 to 13, corrected; see docs/model.md)

    a11 θ̈ + a12 ψ̈ = Q_θ        a11 = (2m + M) R² + 2 J_w + 2 n² J_m      a12 = M L R cos ψ − 2 n² J_m
    a12 θ̈ + a22 ψ̈ = Q_ψ        a22 = M L² + J_ψ + 2 n² J_m
            a33 φ̈ = Q_φ        a33 = m W²/2 + J_yaw(ψ) + W²/(2R²) (J_w + n² J_m) + M L² sin² ψ

A drive by wheel speed gives the torques under which each wheel turns against the body as commanded (`held_at_speed`).

`complete` (the default) adds to the published model what rolling without slip demands (the constraint is
non-holonomic) and the body's roll inertia. Every function is generic over the maths namespace `xp`, which gives
`sin`, `cos` and `sqrt` (`math`, `numpy`, `sympy`, a tracer), and over what the parameters `p` are: any
object with the fields of `Robot`.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

MODELS = ("complete", "published")


class Disturbance(NamedTuple):
    """What the world does to the robot: a horizontal `force` [N] along its heading at `height` [m] above the
    axle, and the floor's `slope` [rad], positive where the world's x axis climbs."""

    force: Any = 0.0
    height: Any = 0.0
    slope: Any = 0.0


CALM = Disturbance()


def motor_gain(p: Any) -> Any:
    """α = n K_t / R_m: torque on a wheel for one unit of command [N m/V]."""
    return p.gear_ratio * p.torque_constant / p.motor_resistance


def motor_damping(p: Any) -> Any:
    """β = n K_t K_b / R_m + f_m: torque lost for each rad/s between body and wheel [N m s/rad]."""
    return motor_gain(p) * p.back_emf + p.motor_friction


def motor_torque(command: Any, rate: Any, p: Any, xp: Any = math) -> Any:
    """Torque of one motor on its wheel [N m] at `rate` = wheel rate minus pitch rate [rad/s]."""
    coulomb = p.coulomb_friction * rate / xp.sqrt(rate**2 + p.stiction_rate**2)
    return motor_gain(p) * command - motor_damping(p) * rate - coulomb


def rolling_friction(rate: Any, p: Any, xp: Any = math) -> Any:
    """Dry torque of the floor against a wheel [N m] that turns over it at `rate` [rad/s]."""
    return p.rolling_friction * rate / xp.sqrt(rate**2 + p.stiction_rate**2)


def mass_matrix(cos: Any, sin: Any, p: Any, model: str = "complete") -> tuple[Any, Any, Any, Any]:
    """The inertias (a11, a12, a22, a33) [kg m²] at the pitch whose cosine and sine are given."""
    rotors = p.gear_ratio**2 * p.rotor_inertia
    a11 = (2 * p.wheel_mass + p.body_mass) * p.wheel_radius**2 + 2 * p.wheel_inertia + 2 * rotors
    a12 = p.body_mass * p.com_height * p.wheel_radius * cos - 2 * rotors
    a22 = p.body_mass * p.com_height**2 + p.pitch_inertia + 2 * rotors
    wheels = p.track**2 * (p.wheel_mass / 2 + (p.wheel_inertia + rotors) / (2 * p.wheel_radius**2))
    a33 = wheels + p.yaw_inertia + yaw_swing(p, model) * sin**2
    return a11, a12, a22, a33


def turn_ratio(p: Any) -> Any:
    """W/(2R): wheel angle, from the mean of both wheels, for one radian of yaw."""
    return p.track / (2 * p.wheel_radius)


def yaw_swing(p: Any, model: str) -> Any:
    """∂a33/∂(sin² ψ) [kg m²]: how much a lean adds to the inertia about the vertical."""
    point_mass = p.body_mass * p.com_height**2
    return point_mass + p.roll_inertia - p.yaw_inertia if model == "complete" else point_mass


class Unpowered(NamedTuple):
    """A robot whose motors give no torque: `rates` of both wheels against the body [rad/s], its accelerations `free`
    [rad/s²], `inertias` (a11, a12, a22, a33) in one unit, and `half_track` W/(2R)."""

    rates: Sequence[Any]
    free: Sequence[Any]
    inertias: Sequence[Any]
    half_track: Any


def drives_speed(p: Any) -> bool:
    """Whether the command is the wheels' speed; of arrays of robots whether it is that of any."""
    lag = p.speed_lag
    return bool(lag.any() if hasattr(lag, "any") else lag)


def accelerations(
    x: Sequence[Any], u: Sequence[Any], p: Any, w: Disturbance = CALM, xp: Any = math, model: str = "complete"
) -> tuple[Any, Any, Any]:
    """ψ̈, θ̈, φ̈ [rad/s²] at state `x` under command `u` and disturbance `w`."""
    if not drives_speed(p):
        return driven_by_torque(x, u, p, w, xp, model)
    return held_at_speed(u, _unpowered(x, p, w, xp, model), p, xp)


def slips(x: Sequence[Any], u: Sequence[Any], p: Any, w: Disturbance = CALM, model: str = "complete") -> bool:
    """Whether a motor of a speed drive lacks the torque for the speed that is commanded of it."""
    needed = holding_torques(u, _unpowered(x, p, w, math, model), p, math)
    return max(map(abs, needed)) > p.slip_torque


def _unpowered(x: Sequence[Any], p: Any, w: Disturbance, xp: Any, model: str) -> Unpowered:
    """The robot at state `x` under `w` without its motors."""
    half_track = turn_ratio(p)
    rates = x[3] - half_track * x[5] - x[1], x[3] + half_track * x[5] - x[1]
    free = driven_by_torque(x, (0.0, 0.0), p, w, xp, model)
    return Unpowered(rates, free, mass_matrix(xp.cos(x[0]), xp.sin(x[0]), p, model), half_track)


def driven_by_torque(
    x: Sequence[Any], u: Sequence[Any], p: Any, w: Disturbance = CALM, xp: Any = math, model: str = "complete"
) -> tuple[Any, Any, Any]:
    """The `accelerations` where the command gives the motors' torques."""
    pitch, pitch_rate, _, wheel_rate, yaw, yaw_rate = x
    cos, sin = xp.cos(pitch), xp.sin(pitch)
    a11, a12, a22, a33 = mass_matrix(cos, sin, p, model)
    swing = yaw_swing(p, model)
    half_track = turn_ratio(p)
    left = motor_torque(u[0], wheel_rate - half_track * yaw_rate - pitch_rate, p, xp)
    right = motor_torque(u[1], wheel_rate + half_track * yaw_rate - pitch_rate, p, xp)
    drag = 2 * p.wheel_friction * wheel_rate
    lever = p.body_mass * p.com_height * p.wheel_radius  # MLR
    weight = p.gravity * p.body_mass * p.com_height  # MgL
    uphill = xp.sin(w.slope) * xp.cos(yaw)
    downhill = xp.cos(w.slope)
    climb = (p.body_mass + 2 * p.wheel_mass) * p.gravity * p.wheel_radius * uphill

    wheel_force = left + right - drag + lever * pitch_rate**2 * sin + w.force * p.wheel_radius - climb
    pitch_force = (
        -left
        - right
        + weight * (sin * downhill - cos * uphill)
        + swing * yaw_rate**2 * sin * cos
        + w.force * w.height * cos
    )
    yaw_drag = 2 * half_track**2 * p.wheel_friction * yaw_rate
    side = weight * sin * xp.sin(w.slope) * xp.sin(yaw)
    yaw_force = half_track * (right - left) - yaw_drag - 2 * swing * pitch_rate * yaw_rate * sin * cos + side
    if model == "complete":
        wheel_force = wheel_force + lever * yaw_rate**2 * sin
        yaw_force = yaw_force - lever * yaw_rate * wheel_rate * sin

    if not isinstance(p.rolling_friction, float) or p.rolling_friction:
        floor_left = rolling_friction(wheel_rate - half_track * yaw_rate, p, xp)
        floor_right = rolling_friction(wheel_rate + half_track * yaw_rate, p, xp)
        wheel_force = wheel_force - floor_left - floor_right
        yaw_force = yaw_force - half_track * (floor_right - floor_left)

    determinant = a11 * a22 - a12**2
    pitch_acc = (a11 * pitch_force - a12 * wheel_force) / determinant
    wheel_acc = (a22 * wheel_force - a12 * pitch_force) / determinant
    return pitch_acc, wheel_acc, yaw_force / a33


def held_at_speed(u: Sequence[Any], idle: Unpowered, p: Any, xp: Any) -> tuple[Any, Any, Any]:
    """The accelerations where motors turn the wheels at `u` against the body, until they slip."""
    pitch_acc, wheel_acc, yaw_acc = idle.free
    a11, a12, a22, a33 = idle.inertias
    needed = holding_torques(u, idle, p, xp)
    left, right = (within(torque, p.slip_torque, xp) for torque in needed)
    both = (left + right) / (a11 * a22 - a12**2)
    return (
        pitch_acc - (a11 + a12) * both,
        wheel_acc + (a12 + a22) * both,
        yaw_acc + idle.half_track * (right - left) / a33,
    )


def holding_torques(u: Sequence[Any], idle: Unpowered, p: Any, xp: Any) -> tuple[Any, Any]:
    """Torque on each wheel [N m] that gives it, against the body, the acceleration δ̈ = (u − δ̇)/T_v within ±α_max.

    Both torques together change δ̈ = θ̈ − ψ̈ by (a11 + 2 a12 + a22)/(a11 a22 − a12²) for each N m, their difference
    changes φ̈ by W/(2R a33).
    """
    pitch_acc, wheel_acc, yaw_acc = idle.free
    a11, a12, a22, a33 = idle.inertias
    left, right = (
        within((speed - rate) * (1 / p.speed_lag), p.acceleration_limit, xp)
        for speed, rate in zip(u, idle.rates, strict=True)
    )
    missing = (left + right) * 0.5 - (wheel_acc - pitch_acc)
    both = missing * (a11 * a22 - a12**2) / (a11 + 2 * a12 + a22)
    turning = ((right - left) * (0.5 / idle.half_track) - yaw_acc) * a33 * (1 / idle.half_track)
    return (both - turning) * 0.5, (both + turning) * 0.5


def within(value: Any, most: Any, xp: Any) -> Any:
    """`value` between −most and most: over the larger of 1 and |value|/most. Roots give |…|, since every namespace has
    them and complex steps pass them."""
    over = xp.sqrt(value**2) * (1 / most)
    return value * 2 / (1 + over + xp.sqrt((over - 1) ** 2))


def derivative(
    x: Sequence[Any], u: Sequence[Any], p: Any, w: Disturbance = CALM, xp: Any = math, model: str = "complete"
) -> tuple[Any, ...]:
    """ẋ = f(x, u, p, w), in the order of the state."""
    pitch_acc, wheel_acc, yaw_acc = accelerations(x, u, p, w, xp, model)
    return (x[1], pitch_acc, x[3], wheel_acc, x[5], yaw_acc)
