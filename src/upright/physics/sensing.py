"""What each sensor reads, without its faults; generic over the maths namespace like `dynamics`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.errors import SpecMismatch
from upright.physics.dynamics import turn_ratio
from upright.physics.electronics import response
from upright.signals import TRUE_STATE


def sensor_matrix(names: Sequence[str], turn: ArrayLike, sensors: Mapping[str, Any] = MappingProxyType({})) -> Array:
    """C (len(names), 6) from the state to the readings of the named channels, for W/(2R) = `turn` (see `turn_ratio`).

    `turn` (k,) of k robots gives C (len(names), 6, k). Readings are without noise, bias and delay; those of `sensors`
    have their response, others are ideal. The true states are channels too. Raises `SpecMismatch` for a channel that no
    matrix gives, such as an accelerometer.
    """
    ratio = np.asarray(turn, dtype=np.float64)
    C = np.zeros((len(names), 6, *ratio.shape))
    for row, name in zip(C, names, strict=True):
        kind = name.removeprefix("sensor/")
        rate = int("_rate" in name)
        if name in TRUE_STATE:
            row[TRUE_STATE.index(name)] = 1.0
        elif kind in ("gyro", "compass"):
            row[1 if kind == "gyro" else 4] = 1.0
        elif kind.removeprefix("encoder_").removeprefix("rate_") in ("left", "right"):
            row[rate], row[2 + rate], row[4 + rate] = -1.0, 1.0, -ratio if kind.endswith("left") else ratio
        else:
            raise SpecMismatch(
                f"no linear row for {name}", expected="an encoder, the gyro, the compass, or a true state"
            )
        if name in sensors:
            row[:] = response(row, sensors[name])
    return C


def wheel_angles(x: Sequence[Any], p: Any) -> tuple[Any, Any]:
    """θ_l and θ_r [rad]: the mean wheel angle minus and plus W φ / (2R)."""
    turn = turn_ratio(p) * x[4]
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
