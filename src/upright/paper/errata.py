"""Misprints in the equations of Herrera et al. (2015), each proved against the derivation.

Each erratum is tested alone: its printed form has that one misprint and is correct elsewhere. The proof holds when
the corrected form equals the derivation identically and the printed one does not; at `WITNESS` the relative error of
the printed form is stated.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import lru_cache
from types import SimpleNamespace
from typing import Any, NamedTuple

from upright.pages import Say
from upright.paper.derivation import Derivation, derive, plain, tidy
from upright.robots import PARAMETERS, Robot
from upright.signals import STATE_NAMES

WITNESS = dict(zip((*STATE_NAMES, "left", "right"), (0.1, 0.5, 0.0, 4.0, 0.3, 3.0, 1.0, 3.0), strict=True))
"""The state [rad, rad/s] and voltages where NXTway-GS measures each misprint: leaning, rolling and turning at once."""


class Equation(NamedTuple):
    """One equation with the misprint, without it, and as derived."""

    equation: str
    printed: Any
    corrected: Any
    derived: Any


Check = Callable[[Derivation], tuple[Equation, ...]]


@dataclass(frozen=True)
class Erratum:
    """Where (`equations`), what stands there, what should, and why; `check` builds both forms of each equation that
    can be derived, and is None for slips of notation, which carry their reason only."""

    equations: str
    printed: str
    corrected: str
    why: Say
    check: Check | None = field(default=None, repr=False)


@dataclass(frozen=True)
class Proof:
    """Largest errors of the printed and the corrected forms at `WITNESS`, relative to the derived value; the derived
    form of the first equation as plain text; and whether each equation is proved."""

    printed_residual: float
    corrected_residual: float
    derived: str
    holds: bool


def errata() -> tuple[Erratum, ...]:
    """All misprints known, in the order of the paper."""
    return _ERRATA


def prove(erratum: Erratum, derivation: Derivation | None = None) -> Proof | None:
    """The proof against `derivation` (the published model when None), or None where the erratum is one of notation."""
    if erratum.check is None:
        return None
    derivation = derivation or derive("published")
    cases = erratum.check(derivation)
    printed = [_relative_error(case.printed, case.derived, derivation) for case in cases]
    corrected = [_relative_error(case.corrected, case.derived, derivation) for case in cases]
    holds = all(_equal(c.corrected, c.derived) and not _equal(c.printed, c.derived) for c in cases)
    return Proof(max(printed), max(corrected), plain(cases[0].derived), holds and min(printed) > max(corrected))


def _equal(one: Any, other: Any) -> bool:
    """Whether the difference of two expressions vanishes identically."""
    import sympy as sp

    numerator, _ = sp.fraction(sp.together(one - other))
    return bool(tidy(numerator) == 0)


def _relative_error(form: Any, derived: Any, d: Derivation) -> float:
    """|form − derived| / |derived| for NXTway-GS at `WITNESS`."""
    truth = float(derived.subs(_witness(d)))
    return abs(float(form.subs(_witness(d))) - truth) / abs(truth)


@lru_cache(maxsize=2)
def _witness(d: Derivation) -> dict[Any, Any]:
    """A number for each symbol, the accelerations as the derivation gives them there."""
    robot = Robot.preset("nxtway-gs")
    s = d.symbols
    values: dict[Any, Any] = {getattr(s, name): value for name, value in WITNESS.items()}
    values |= {getattr(s, name): getattr(robot, name) for name in PARAMETERS}
    values |= {symbol: value.subs(values) for symbol, value in d.definitions.items()}
    pitch, wheel, yaw = _calm(d)
    accelerations = zip(_second(), (wheel, pitch, yaw), strict=True)
    return values | {symbol: e.subs(values) for symbol, e in accelerations} | {_undefined(s): robot.com_height}


def _second() -> tuple[Any, Any, Any]:
    """Symbols θ̈, ψ̈, φ̈."""
    import sympy as sp

    wheel, pitch, yaw = sp.symbols("θ̈ ψ̈ φ̈", real=True)
    return wheel, pitch, yaw


def _undefined(s: SimpleNamespace) -> Any:
    """The L_2 of eq. (24), which the paper never defines; as a number it is read as L."""
    return s.com_height.func("L_2", positive=True)


def _calm(d: Derivation) -> tuple[Any, Any, Any]:
    """ψ̈, θ̈, φ̈ without push, slope and dry friction, which the paper has not."""
    return tuple(e.subs(d.loads) for e in d.accelerations)  # type: ignore[return-value]


def _side(d: Derivation, row: int) -> tuple[Any, Any]:
    """Equation `row` of `RATES`, split as the paper does: inertia and gravity (1) to (3), and motors (8) to (10)."""
    s = d.symbols
    calm = d.force[row].subs(d.loads)
    free = calm.subs({s.alpha: 0, s.beta: 0, s.wheel_friction: 0})
    return sum(a * acc for a, acc in zip(d.mass[row, :], _second(), strict=True)) - free, calm - free


def _parts(s: SimpleNamespace, **misprints: Any) -> SimpleNamespace:
    """The paper's building blocks, corrected, with `misprints` put in place of some of them."""
    import sympy as sp

    sin = sp.sin(s.pitch)
    cos = sp.cos(s.pitch)
    half = s.track / (2 * s.wheel_radius)
    rotors = s.gear_ratio**2 * s.rotor_inertia
    point = s.body_mass * s.com_height**2
    lever = s.body_mass * s.com_height * s.wheel_radius
    volts = s.left + s.right
    blocks = {
        "a11": (2 * s.wheel_mass + s.body_mass) * s.wheel_radius**2 + 2 * s.wheel_inertia + 2 * rotors,
        "a12": lever * cos - 2 * rotors,
        "a22": point + s.pitch_inertia + 2 * rotors,
        "hub": s.wheel_inertia,
        "swing": point,
        "centrifugal": lever * s.pitch_rate**2 * sin,
        "toppling": s.gravity * s.body_mass * s.com_height * sin + point * s.yaw_rate**2 * sin * cos,
        "coriolis": 2 * point * s.pitch_rate * s.yaw_rate * sin * cos,
        "drive": s.alpha * volts - 2 * (s.beta + s.wheel_friction) * s.wheel_rate + 2 * s.beta * s.pitch_rate,
        "reaction": -s.alpha * volts + 2 * s.beta * (s.wheel_rate - s.pitch_rate),
        "turning": half * s.alpha * (s.right - s.left),
        "drag": 2 * half**2 * (s.beta + s.wheel_friction) * s.yaw_rate,
    } | misprints
    k = SimpleNamespace(**blocks)
    k.a33 = s.wheel_mass * s.track**2 / 2 + s.yaw_inertia + 2 * half**2 * (k.hub + rotors) + k.swing * sin**2
    return k


def _delta(k: SimpleNamespace) -> Any:
    """Δ below eq. (13), and Δ_e of eq. (19)."""
    return k.a12**2 - k.a11 * k.a22


def _pitch_acc(k: SimpleNamespace) -> Any:
    """Eqs. (14) and (20)."""
    return ((k.drive + k.centrifugal) * k.a12 - k.a11 * (k.toppling + k.reaction)) / _delta(k)


def _wheel_acc(k: SimpleNamespace) -> Any:
    """Eqs. (15) and (22)."""
    return ((k.toppling + k.reaction) * k.a12 - k.a22 * (k.drive + k.centrifugal)) / _delta(k)


def _yaw_acc(k: SimpleNamespace) -> Any:
    """Eqs. (16) and (24)."""
    return (k.turning - k.drag - k.coriolis) / k.a33


def _second_term(d: Derivation) -> tuple[Equation, ...]:
    k, (wheel, pitch, _) = _parts(d.symbols), _second()
    wrong, right = (k.a11 * wheel + k.a12 * acc - k.centrifugal for acc in (wheel, pitch))
    return (Equation("(1)", wrong, right, _side(d, 0)[0]),)


def _body_inertia(d: Derivation) -> tuple[Equation, ...]:
    s, (wheel, pitch, _) = d.symbols, _second()
    right = _parts(s)
    wrong = _parts(s, a22=right.a22 - s.pitch_inertia + s.wheel_inertia)
    pitch_acc, wheel_acc, _ = _calm(d)
    side_wrong, side_right = (k.a12 * wheel + k.a22 * pitch - k.toppling for k in (wrong, right))
    return (
        Equation("(2), (12)", side_wrong, side_right, _side(d, 1)[0]),
        Equation("Δ, (19)", _delta(wrong), _delta(right), -d.mass[:2, :2].det()),
        Equation("(14)", _pitch_acc(wrong), _pitch_acc(right), pitch_acc),
        Equation("(15), (22)", _wheel_acc(wrong), _wheel_acc(right), wheel_acc),
    )


def _yaw_variable(d: Derivation) -> tuple[Equation, ...]:
    k, (wheel, _, yaw) = _parts(d.symbols), _second()
    wrong, right = (k.a33 * acc + k.coriolis for acc in (wheel, yaw))
    return (Equation("(3), (13)", wrong, right, _side(d, 2)[0]),)


def _yaw_force(d: Derivation) -> tuple[Equation, ...]:
    s = d.symbols
    k = _parts(d.symbols)
    wrong = s.track / (2 * s.wheel_radius) * (s.left - s.right) - k.drag
    return (Equation("(10)", wrong, k.turning - k.drag, _side(d, 2)[1]),)


def _yaw_drag(d: Derivation) -> tuple[Equation, ...]:
    s = d.symbols
    k = _parts(d.symbols)
    return (Equation("(13)", k.turning - k.drag * s.wheel_radius, k.turning - k.drag, _side(d, 2)[1]),)


def _yaw_case(equation: str, d: Derivation, **misprints: Any) -> tuple[Equation, ...]:
    return (Equation(equation, _yaw_acc(_parts(d.symbols, **misprints)), _yaw_acc(_parts(d.symbols)), _calm(d)[2]),)


def _coriolis_sign(d: Derivation) -> tuple[Equation, ...]:
    return _yaw_case("(16), (24)", d, coriolis=-_parts(d.symbols).coriolis)


def _missing_alpha(d: Derivation) -> tuple[Equation, ...]:
    return _yaw_case("(16)", d, turning=_parts(d.symbols).turning / d.symbols.alpha)


def _two_wheels(d: Derivation) -> tuple[Equation, ...]:
    s = d.symbols
    right = _parts(d.symbols)
    wrong = _parts(s, a11=right.a11 - s.wheel_inertia)
    return (Equation("(19)", _delta(wrong), _delta(right), -d.mass[:2, :2].det()),)


def _hub(d: Derivation) -> tuple[Equation, ...]:
    return _yaw_case("(24)", d, hub=d.symbols.rotor_inertia)


def _lost_square(d: Derivation) -> tuple[Equation, ...]:
    return _yaw_case("(24)", d, swing=d.symbols.body_mass * _undefined(d.symbols))


_ERRATA = (
    Erratum(
        "(1)",
        "[…] θ̈ + (M L R cos ψ − 2 n² J_m) θ̈ − M L R ψ̇² sin ψ",
        "[…] θ̈ + (M L R cos ψ − 2 n² J_m) ψ̈ − M L R ψ̇² sin ψ",
        Say("∂²T/∂θ̇∂ψ̇ multiplies ψ̈; the mass matrix is symmetric with (2), and (11) prints it right."),
        _second_term,
    ),
    Erratum(
        "(2), (12), Δ, (14), (15), (19), (22)",
        "M L² + J_w + 2 n² J_m",
        "M L² + J_ψ + 2 n² J_m",
        Say("The body pitches with its own inertia J_ψ; the wheels' angles do not pitch with it."),
        _body_inertia,
    ),
    Erratum(
        "(3), (13)",
        "[m W²/2 + J_φ + W²/(2 R²) (J_w + n² J_m) + M L² sin² ψ] θ̈",
        "[m W²/2 + J_φ + W²/(2 R²) (J_w + n² J_m) + M L² sin² ψ] φ̈",
        Say("It is the equation of yaw: its inertia multiplies the yaw acceleration."),
        _yaw_variable,
    ),
    Erratum(
        "(10)",
        "F_φ = W/(2 R) (v_l − v_r) − W²/(2 R²) (β + f_w) φ̇",
        "F_φ = W/(2 R) α (v_r − v_l) − W²/(2 R²) (β + f_w) φ̇",
        Say("By (4) F_φ = W/(2 R) (F_r − F_l), and a volt is a torque only through α."),
        _yaw_force,
    ),
    Erratum(
        "(13)",
        "W²/(2 R) (β + f_w) φ̇",
        "W²/(2 R²) (β + f_w) φ̇",
        Say("The wheels' rates differ by W φ̇/R and their torques act by W/(2 R); the printed term is no torque."),
        _yaw_drag,
    ),
    Erratum(
        "(16), (24)",
        "φ̈ = (… + 2 M L² ψ̇ φ̇ sin ψ cos ψ) / …",
        "φ̈ = (… − 2 M L² ψ̇ φ̇ sin ψ cos ψ) / …",
        Say("The term stands on the left of (13) with a plus, so it comes to the right with a minus."),
        _coriolis_sign,
    ),
    Erratum(
        "(16)",
        "W/(2 R) (v_r − v_l)",
        "W/(2 R) α (v_r − v_l)",
        Say("A volt is a torque only through α, as (13) and (24) have it."),
        _missing_alpha,
    ),
    Erratum(
        "(19)",
        "Δ̇_e = …",
        "Δ_e = …",
        Say("Δ_e is an abbreviation for the Δ of section 2.1.2, not the derivative of a state."),
    ),
    Erratum(
        "(19)",
        "(2 m + M) R² + J_w + 2 n² J_m",
        "(2 m + M) R² + 2 J_w + 2 n² J_m",
        Say("Two wheels spin, as in (1), (11) and Δ."),
        _two_wheels,
    ),
    Erratum(
        "(24)",
        "W²/(2 R²) (J_m + n² J_m)",
        "W²/(2 R²) (J_w + n² J_m)",
        Say("The wheel's inertia J_w, as in (3), (13) and (16)."),
        _hub,
    ),
    Erratum(
        "(24)",
        "M L_2 sin² x₁",
        "M L² sin² x₁",
        Say("The exponent has slipped into an index; there is no L_2 (read here as L)."),
        _lost_square,
    ),
    Erratum(
        "(30), (31)",
        "J = ‖e‖², equal to J = ½ eᵀ e",
        "J = ½ ‖e‖² = ½ eᵀ e",
        Say("A factor of ½ scales the cost and leaves its least-squares solution (33) where it is: harmless."),
    ),
    Erratum(
        "section 3.1",
        "minimizing the performance index as is in Eq. (25)",
        "minimizing the performance index as is in Eq. (37)",
        Say("(25) is the output equation; the performance index of the regulator is (37)."),
    ),
)
