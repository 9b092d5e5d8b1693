"""Names for the products of parameters that the traced equations need.

The equations of motion are divided by inertias of the upright robot: those of pitch and wheels by a11, that of yaw by
a33. A constant that the trace needs and the table does not name stops the generator, as does a name that is not needed.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

from upright.compiled.trace_print import COMPLETE, P
from upright.errors import InvalidModel
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain, turn_ratio, yaw_swing


def either(complete: Any, published: Any) -> Any:
    """The complete model's expression where COMPLETE is 1, the published one's where it is 0."""
    complete, published = sp.expand(complete), sp.expand(published)
    return published + COMPLETE * (complete - published)


A11, _, A22, A33 = mass_matrix(1, 0, P)
_HALF = turn_ratio(P)
_LEVER = P.body_mass * P.com_height * P.wheel_radius
_WEIGHT = P.gravity * P.body_mass * P.com_height
_SWING = either(yaw_swing(P, "complete"), yaw_swing(P, "published"))
_DRAG = motor_damping(P) + P.wheel_friction

NAMED: dict[str, tuple[Any, str]] = {
    "half_track": (_HALF, "W/(2R): wheel angle, from the mean, per angle of yaw"),
    "wheel_radius": (P.wheel_radius, "R [m]"),
    "gravity": (P.gravity, "g [m/s²]"),
    "motor_damping": (2 * motor_damping(P) / A11, "2β/a11 [1/s]: both motors' torque lost per rate of wheel and body"),
    "centrifugal": (_SWING / A11, "(ML² + J_ρ − J_φ)/a11: pitch acceleration per yaw rate², times sin ψ cos ψ"),
    "weight": (_WEIGHT / A11, "MgL/a11 [1/s²]: the moment of gravity on the leaning body"),
    "moment_response": (1 / A11, "1/a11 [1/(kg m²)]: what a moment on the body gives"),
    "coulomb_torque": (P.coulomb_friction / A11, "τ_c/a11 [1/s²]: dry friction of one motor"),
    "motor_torque": (motor_gain(P) / A11, "α/a11 [1/(V s²)]: the torque of a volt on one motor"),
    "lever": (_LEVER / A11, "MLR/a11: the coupling of pitch and wheels, times cos ψ"),
    "rolling_damping": (2 * _DRAG / A11, "2(β + f_w)/a11 [1/s]: motors' and wheels' damping of the wheel rate"),
    "turning_lever": (COMPLETE * _LEVER / A11, "MLR/a11, or 0 in the published model: per yaw rate², times sin ψ"),
    "slope_weight": ((P.body_mass + 2 * P.wheel_mass) * P.gravity * P.wheel_radius / A11, "(M + 2m)gR/a11 [1/s²]"),
    "force_response": (P.wheel_radius / A11, "R/a11 [1/(kg m)]: what a horizontal force on the body gives"),
    "yaw_coriolis": (2 * _SWING / A33, "2(ML² + J_ρ − J_φ)/a33: yaw acceleration per pitch rate and yaw rate"),
    "yaw_lever": (COMPLETE * _LEVER / A33, "MLR/a33, or 0 in the published model: per wheel and yaw rate, times sin ψ"),
    "yaw_damping": (2 * _HALF**2 * _DRAG / A33, "2(W/2R)²(β + f_w)/a33 [1/s]: motors' and wheels' damping of yaw"),
    "yaw_weight": (_WEIGHT / A33, "MgL/a33 [1/s²]: gravity's moment about the vertical on a slope"),
    "yaw_coulomb_torque": (_HALF * P.coulomb_friction / A33, "(W/2R)τ_c/a33 [1/s²]: dry friction of one motor, in yaw"),
    "rolling_torque": (P.rolling_friction / A11, "τ_w/a11 [1/s²]: dry friction of one wheel on the floor"),
    "yaw_rolling_torque": (_HALF * P.rolling_friction / A33, "(W/2R)τ_w/a33 [1/s²]: that of one wheel, in yaw"),
    "yaw_motor_torque": (_HALF * motor_gain(P) / A33, "(W/2R)α/a33 [1/(V s²)]: the torque of a volt, in yaw"),
    "rotor_coupling": (2 * P.gear_ratio**2 * P.rotor_inertia / A11, "2n²J_m/a11: the rotors' part of a12"),
    "pitch_inertia": (A22 / A11, "a22/a11: inertia in pitch over that of all that rolls"),
    "yaw_swing": (_SWING / A33, "(ML² + J_ρ − J_φ)/a33: what a lean adds to the inertia in yaw, times sin² ψ"),
    "stiction_rate_squared": (P.stiction_rate**2, "ω_c² [rad²/s²]: of the smoothed dry friction"),
    "speed_lag": (P.speed_lag, "T_v [s]: in which a speed drive takes up a speed"),
    "acceleration_limit": (P.acceleration_limit, "α_max [rad/s²]: of a speed drive"),
    "slip_torque": (P.slip_torque / A11, "τ_max/a11 [1/s²]: what a wheel of a speed drive gets at most"),
    "yaw_inertia": (A33 / A11, "a33/a11: inertia in yaw over that of all that rolls"),
}  # fmt: skip
"""Name → formula in the robot's parameters, and what it is: the order of the kernel's rows."""


class ConstantNames:
    """The named constant that a product of parameters equals."""

    def __init__(self) -> None:
        self._symbols: dict[Any, Any] = {}
        self.used: set[str] = set()
        for name, (formula, _) in NAMED.items():
            symbol = sp.Symbol(name, real=True)
            self._symbols[sp.cancel(formula)] = symbol
            self._symbols[sp.cancel(-formula)] = -symbol

    def of(self, formula: Any) -> Any:
        """The named symbol, minus it, or the number that `formula` is; raises `InvalidModel` for one without a name."""
        formula = sp.cancel(formula)
        if formula.is_number:
            return formula
        if formula not in self._symbols:
            raise InvalidModel(f"the traced equations need {formula}", expected="a product named in NAMED")
        symbol = self._symbols[formula]
        self.used |= {s.name for s in symbol.free_symbols}
        return symbol

    def polynomial(self, expression: Any, generators: tuple[Any, ...], divisor: Any = 1) -> Any:
        """`expression` / `divisor` with the coefficient of every monomial in `generators` replaced by a constant."""
        poly = sp.Poly(sp.expand(expression), *generators)
        monomials = [(sp.prod(g**e for g, e in zip(generators, powers, strict=True)), k) for powers, k in poly.terms()]
        return sp.Add(*[self.of(k / divisor) * m for m, k in monomials])

    def check(self) -> None:
        """Raise `InvalidModel` for names that the equations do not need."""
        unused = NAMED.keys() - self.used
        if unused:
            raise InvalidModel(f"the traced equations do not need {', '.join(sorted(unused))}", expected="names in use")
