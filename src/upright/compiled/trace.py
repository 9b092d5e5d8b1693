"""From `physics.dynamics` to source text: the one definition of the equations, traced and made quick.

The traced functions are called with SymPy symbols. What comes back is brought to the form

    θ̈ = Q_θ − a12 ψ̈,   ψ̈ = (Q_ψ − a12 Q_θ) / (a22 − a12²),   φ̈ = Q_φ / a33

with the first two equations divided by a11 and the third by a33 of an upright robot, so that every product of
parameters alone is a *constant* of the robot, computed once. What is left is factored and printed as chains of
fused multiply-adds by `trace_motion`, and written by `generate`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy as sp

from upright.compiled.trace_constants import A11, A33, NAMED, ConstantNames, either
from upright.compiled.trace_print import (
    COS,
    COS_SLOPE,
    COS_YAW,
    DYNAMIC,
    FORCE,
    HELD,
    LEFT,
    MOMENT,
    PITCH,
    PITCH_RATE,
    RIGHT,
    ROLL,
    SIN,
    SIN_SLOPE,
    SIN_YAW,
    SLIP,
    WHEEL_RATE,
    YAW,
    YAW_RATE,
    P,
)
from upright.physics.dynamics import Disturbance, driven_by_torque, mass_matrix, turn_ratio


@dataclass(frozen=True)
class Traced:
    """The equations in the names of `NAMED`, `STATE` and `HELD`: `forces` Q_ψ, Q_θ, Q_φ, inertias a12, a22, a33, and
    the `rates` of `SLIP` and `ROLL`."""

    forces: tuple[Any, ...]
    inertias: tuple[Any, ...]
    rates: tuple[Any, ...]


class Maths:
    """The namespace `xp` under which the dynamics are traced."""

    def __init__(self, slope: Any) -> None:
        self._sin = {PITCH: SIN, YAW: SIN_YAW, slope: SIN_SLOPE}
        self._cos = {PITCH: COS, YAW: COS_YAW, slope: COS_SLOPE}
        self.slips: list[Any] = []

    def sin(self, angle: Any) -> Any:
        return self._sin[angle]

    def cos(self, angle: Any) -> Any:
        return self._cos[angle]

    def sqrt(self, square: Any) -> Any:
        """√(rate² + ω²), written as rate / slip so that the friction is linear in `SLIP` and `ROLL`."""
        rate = next(part.base for part in square.args if part.has(WHEEL_RATE))
        slip = (*SLIP, *ROLL)[len(self.slips)]
        self.slips.append(rate)
        return rate / slip


def _forces(model: str) -> tuple[Any, Any, Any, list[Any]]:
    """Q_ψ, Q_θ, Q_φ of the dynamics, got back from its accelerations, and the slip rates."""
    slope = sp.Symbol("slope", real=True)
    xp = Maths(slope)
    x = (PITCH, PITCH_RATE, sp.Symbol("wheel"), WHEEL_RATE, YAW, YAW_RATE)
    w = Disturbance(FORCE, MOMENT / FORCE, slope)
    pitch_acc, wheel_acc, yaw_acc = driven_by_torque(x, (LEFT, RIGHT), P, w, xp, model)
    a11, a12, a22, a33 = mass_matrix(COS, SIN, P, model)
    b11, b12, b22 = sp.symbols("b11 b12 b22")
    short = {a11: b11, a12: b12, a22: b22}
    determinant = a11 * a22 - a12**2
    one = sp.expand((pitch_acc * determinant).xreplace(short))
    two = sp.expand((wheel_acc * determinant).xreplace(short))
    return one.coeff(b11), two.coeff(b22), yaw_acc * a33, xp.slips


@cache
def trace() -> Traced:
    """Both models of `physics.dynamics` in one."""
    *complete, rates = _forces("complete")
    *published, _ = _forces("published")
    pitch_force, wheel_force, yaw_force = map(either, complete, published)
    _, a12, a22, a33 = map(either, mass_matrix(COS, SIN, P), mass_matrix(COS, SIN, P, "published"))
    known = ConstantNames()
    for formula in (P.wheel_radius, P.gravity, P.stiction_rate**2):
        known.of(formula)  # what the accelerometer reads, and the smoothing of dry friction
    for formula in (turn_ratio(P), P.speed_lag, P.acceleration_limit, P.slip_torque / A11, A33 / A11):
        known.of(formula)  # what a speed drive is computed with
    forces = tuple(
        known.polynomial(force, DYNAMIC, divisor)
        for force, divisor in ((pitch_force, A11), (wheel_force, A11), (yaw_force, A33))
    )
    inertias = tuple(known.polynomial(a, DYNAMIC, divisor) for a, divisor in ((a12, A11), (a22, A11), (a33, A33)))
    slips = tuple(known.polynomial(rate, DYNAMIC) for rate in rates)
    known.check()
    return Traced(forces, inertias, slips)


ROWS = ("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate", "h", "lived", *map(str, HELD))
"""What a block holds for each robot before its constants, by row."""

CONSTANTS = tuple(NAMED)

STAGE = ("pitch", "pitch_rate", "wheel_rate", "yaw", "yaw_rate")
