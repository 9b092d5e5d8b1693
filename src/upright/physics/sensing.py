"""What each sensor reads, without its faults; generic over the maths namespace like `dynamics`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any


def wheel_angles(x: Sequence[Any], p: Any) -> tuple[Any, Any]:
    """θ_l and θ_r [rad]: the mean wheel angle minus and plus W φ / (2R)."""
    turn = p.track / (2 * p.wheel_radius) * x[4]
    return x[2] - turn, x[2] + turn


def encoders(x: Sequence[Any], p: Any) -> tuple[Any, Any]:
    """Encoders on the body read θ_l − ψ and θ_r − ψ [rad]."""
    left, right = wheel_angles(x, p)
    return left - x[0], right - x[0]


def accelerometer(x: Sequence[Any], wheel_acc: Any, p: Any, slope: Any = 0.0, xp: Any = math) -> tuple[Any, Any]:
    """Specific force [m/s²] at the middle of the axle along the body's forward and up axes.

    At rest and upright it reads (0, +g). `wheel_acc` is θ̈ [rad/s²].
    """
    cos, sin = xp.cos(x[0]), xp.sin(x[0])
    forward = p.wheel_radius * wheel_acc + p.gravity * xp.sin(slope) * xp.cos(x[4])
    up = p.gravity * xp.cos(slope)
    return forward * cos - up * sin, forward * sin + up * cos


def readings(x: Sequence[Any], wheel_acc: Any, p: Any, slope: Any = 0.0, xp: Any = math) -> tuple[Any, ...]:
    """All ideal sensors but the battery, in the order of `signals.signal.SENSORS`."""
    left, right = encoders(x, p)
    forward, up = accelerometer(x, wheel_acc, p, slope, xp)
    return left, right, x[1], x[4], forward, up
