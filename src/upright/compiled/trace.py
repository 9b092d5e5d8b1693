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

from upright.compiled.trace_print import (
    COMPLETE,
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
    SIN,
    SIN_SLOPE,
    SIN_YAW,
    SLIP_LEFT,
    SLIP_RIGHT,
    WHEEL_RATE,
    YAW,
    YAW_RATE,
    P,
)
from upright.physics.dynamics import Disturbance, accelerations, mass_matrix


@dataclass(frozen=True)
class Traced:
    """`constants`: name → formula in the robot's parameters, in order. The rest in the names of those constants and of
    `STATE` and `HELD`: `forces` Q_ψ, Q_θ, Q_φ, inertias `a12`, `a22`, `a33`, and the slip `rates` of left and right."""

    constants: dict[str, Any]
    forces: tuple[Any, Any, Any]
    inertias: tuple[Any, Any, Any]
    rates: tuple[Any, Any]


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
        """√(rate² + ω²), written as rate / slip so that the friction is linear in the slip."""
        rate = next(part.base for part in square.args if part.has(WHEEL_RATE))
        slip = (SLIP_LEFT, SLIP_RIGHT)[len(self.slips)]
        self.slips.append(rate)
        return rate / slip


class _Constants:
    """Names for products of parameters alone, each formula once."""

    def __init__(self) -> None:
        self.formulas: dict[Any, Any] = {}

    def of(self, formula: Any) -> Any:
        """A symbol, or minus one, that stands for `formula`."""
        formula = sp.factor_terms(formula)
        if formula.is_number or sp.cancel(formula).is_number:
            return sp.cancel(formula)
        if -formula in self.formulas:
            return -self.formulas[-formula]
        return self.formulas.setdefault(formula, sp.Symbol(f"c{len(self.formulas)}", real=True))

    def polynomial(self, expression: Any, divisor: Any = 1) -> Any:
        """`expression` / `divisor` with the coefficient of every dynamic monomial replaced by a constant."""
        poly = sp.Poly(sp.expand(expression), *DYNAMIC)
        monomials = [(sp.prod(g**e for g, e in zip(DYNAMIC, powers, strict=True)), k) for powers, k in poly.terms()]
        return sp.Add(*[self.of(k / divisor) * m for m, k in monomials])


def _forces(model: str) -> tuple[Any, Any, Any, list[Any]]:
    """Q_ψ, Q_θ, Q_φ of the dynamics, got back from its accelerations, and the slip rates."""
    slope = sp.Symbol("slope", real=True)
    xp = Maths(slope)
    x = (PITCH, PITCH_RATE, sp.Symbol("wheel"), WHEEL_RATE, YAW, YAW_RATE)
    w = Disturbance(FORCE, MOMENT / FORCE, slope)
    pitch_acc, wheel_acc, yaw_acc = accelerations(x, (LEFT, RIGHT), P, w, xp, model)
    a11, a12, a22, a33 = mass_matrix(COS, SIN, P, model)
    b11, b12, b22 = sp.symbols("b11 b12 b22")
    short = {a11: b11, a12: b12, a22: b22}
    determinant = a11 * a22 - a12**2
    one = sp.expand((pitch_acc * determinant).xreplace(short))
    two = sp.expand((wheel_acc * determinant).xreplace(short))
    return one.coeff(b11), two.coeff(b22), yaw_acc * a33, xp.slips


def _either(complete: Any, published: Any) -> Any:
    """The complete model's expression where COMPLETE is 1, the published one's where it is 0."""
    complete, published = sp.expand(complete), sp.expand(published)
    return published + COMPLETE * (complete - published)


@cache
def trace() -> Traced:
    """Both models of `physics.dynamics` in one."""
    *complete, rates = _forces("complete")
    *published, _ = _forces("published")
    pitch_force, wheel_force, yaw_force = map(_either, complete, published)
    a11, a12, a22, a33 = map(_either, mass_matrix(COS, SIN, P), mass_matrix(COS, SIN, P, "published"))
    upright = sp.expand(a33).subs(SIN, 0)
    known = _Constants()
    for formula in (P.track / (2 * P.wheel_radius), P.wheel_radius, P.gravity):
        known.of(formula)  # first, because the sensors read them too
    forces = (
        known.polynomial(pitch_force, a11),
        known.polynomial(wheel_force, a11),
        known.polynomial(yaw_force, upright),
    )
    inertias = (known.polynomial(a12, a11), known.polynomial(a22, a11), known.polynomial(a33, upright))
    slip_rates = tuple(known.polynomial(rate) for rate in rates)
    known.of(P.stiction_rate**2)
    constants = {symbol.name: formula for formula, symbol in known.formulas.items()}
    return Traced(constants, forces, inertias, (slip_rates[0], slip_rates[1]))


ROWS = ("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate", "h", "lived", *map(str, HELD))
"""What a block holds for each robot before its constants, by row."""

STAGE = ("pitch", "pitch_rate", "wheel_rate", "yaw", "yaw_rate")
