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
from typing import Any

from upright.pages import Say
from upright.paper.derivation import Derivation, derive, plain, tidy
from upright.robots import PARAMETERS, Robot
from upright.signals import STATE_NAMES

WITNESS = dict(zip((*STATE_NAMES, "left", "right"), (0.1, 0.5, 0.0, 4.0, 0.3, 3.0, 1.0, 3.0), strict=True))
"""The state [rad, rad/s] and voltages where NXTway-GS measures each misprint: leaning, rolling and turning at once."""


Misprint = Callable[[SimpleNamespace], dict[str, Any]]
"""From the correct `_parts` to those that are printed otherwise."""


@dataclass(frozen=True)
class Erratum:
    """Where (`equations`), what stands there, what should, and why. `misprint` is in each of `forms`, by their names in
    `_forms`; slips of notation have none, and carry their reason only."""

    equations: str
    printed: str
    corrected: str
    why: Say
    forms: tuple[str, ...] = ()
    misprint: Misprint | None = field(default=None, repr=False)


@dataclass(frozen=True)
class Proof:
    """Largest errors of the printed and the corrected forms at `WITNESS`, relative to the derived value; the derived
    form of the first equation as plain text; and whether each equation is proved."""

    printed_residual: float
    corrected_residual: float
    derived: str
    holds: bool


def prove(erratum: Erratum, derivation: Derivation | None = None) -> Proof | None:
    """The proof against `derivation` (the published model when None), or None where the erratum is one of notation."""
    if erratum.misprint is None:
        return None
    d = derivation or derive("published")
    right = _parts(d.symbols)
    truths = _derived(d)
    correct = _forms(right)
    wrong = _forms(_parts(d.symbols, **erratum.misprint(right)))
    printed: list[float] = []
    corrected: list[float] = []
    holds = True
    for name in erratum.forms:
        printed.append(_relative_error(wrong[name], truths[name], d))
        corrected.append(_relative_error(correct[name], truths[name], d))
        holds = holds and _equal(correct[name], truths[name]) and not _equal(wrong[name], truths[name])
    derived = plain(truths[erratum.forms[0]])
    return Proof(max(printed), max(corrected), derived, holds and min(printed) > max(corrected))


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
    pitch, wheel, yaw = d.accelerations
    accelerations = zip(_second(), (wheel, pitch, yaw), strict=True)
    calm = values | d.loads
    return values | {symbol: e.subs(calm) for symbol, e in accelerations} | {_undefined(s): robot.com_height}


def _second() -> tuple[Any, Any, Any]:
    """Symbols θ̈, ψ̈, φ̈."""
    import sympy as sp

    wheel, pitch, yaw = sp.symbols("θ̈ ψ̈ φ̈", real=True)
    return wheel, pitch, yaw


def _undefined(s: SimpleNamespace) -> Any:
    """The L_2 of eq. (24), which the paper never defines; as a number it is read as L."""
    return s.com_height.func("L_2", positive=True)


@lru_cache(maxsize=2)
def _derived(d: Derivation) -> dict[str, Any]:
    """What each of `_forms` is by the derivation, without push, slope and dry friction, which the paper has not."""
    s = d.symbols
    pitch_acc, wheel_acc, yaw_acc = (e.subs(d.loads) for e in d.accelerations)
    force = d.force.subs(d.loads)
    free = force.subs({s.alpha: 0, s.beta: 0, s.wheel_friction: 0})  # (1) to (3) have no motors, (8) to (10) them alone
    inertia = d.mass * type(d.mass)(_second()) - free
    return {
        "(1)": inertia[0],
        "(2)": inertia[1],
        "(3)": inertia[2],
        "(10)": (force - free)[2],
        "Δ": -d.mass[:2, :2].det(),
        "(14)": pitch_acc,
        "(15)": wheel_acc,
        "(16)": yaw_acc,
    }


def _forms(k: SimpleNamespace) -> dict[str, Any]:
    """The paper's equations of such parts, the first of each kind: (12) repeats (2), (20) is (14), (22) is (15), …"""
    delta = k.a12**2 - k.a11 * k.a22
    return {
        "(1)": k.a11 * k.wheel_acc + k.a12 * k.swayed - k.centrifugal,
        "(2)": k.a12 * k.wheel_acc + k.a22 * k.pitch_acc - k.toppling,
        "(3)": k.a33 * k.turned + k.coriolis,
        "(10)": k.turning - k.drag,
        "Δ": delta,
        "(14)": ((k.drive + k.centrifugal) * k.a12 - k.a11 * (k.toppling + k.reaction)) / delta,
        "(15)": ((k.toppling + k.reaction) * k.a12 - k.a22 * (k.drive + k.centrifugal)) / delta,
        "(16)": (k.turning - k.drag - k.coriolis) / k.a33,
    }


def _parts(s: SimpleNamespace, **misprints: Any) -> SimpleNamespace:
    """The symbols, accelerations and building blocks of the paper, corrected, with `misprints` in place of some."""
    import sympy as sp

    sin = sp.sin(s.pitch)
    cos = sp.cos(s.pitch)
    half = s.track / (2 * s.wheel_radius)
    rotors = s.gear_ratio**2 * s.rotor_inertia
    point = s.body_mass * s.com_height**2
    lever = s.body_mass * s.com_height * s.wheel_radius
    volts = s.left + s.right
    wheel_acc, pitch_acc, yaw_acc = _second()
    blocks = {
        "wheel_acc": wheel_acc,
        "pitch_acc": pitch_acc,
        "a11": (2 * s.wheel_mass + s.body_mass) * s.wheel_radius**2 + 2 * s.wheel_inertia + 2 * rotors,
        "a12": lever * cos - 2 * rotors,
        "a22": point + s.pitch_inertia + 2 * rotors,
        "hub": s.wheel_inertia,
        "swing": point,
        "swayed": pitch_acc,
        "turned": yaw_acc,
        "centrifugal": lever * s.pitch_rate**2 * sin,
        "toppling": s.gravity * s.body_mass * s.com_height * sin + point * s.yaw_rate**2 * sin * cos,
        "coriolis": 2 * point * s.pitch_rate * s.yaw_rate * sin * cos,
        "drive": s.alpha * volts - 2 * (s.beta + s.wheel_friction) * s.wheel_rate + 2 * s.beta * s.pitch_rate,
        "reaction": -s.alpha * volts + 2 * s.beta * (s.wheel_rate - s.pitch_rate),
        "turning": half * s.alpha * (s.right - s.left),
        "drag": 2 * half**2 * (s.beta + s.wheel_friction) * s.yaw_rate,
    }
    k = SimpleNamespace(**vars(s), **blocks | misprints)
    k.a33 = s.wheel_mass * s.track**2 / 2 + s.yaw_inertia + 2 * half**2 * (k.hub + rotors) + k.swing * sin**2
    return k


ERRATA = (
    Erratum(
        "(1)",
        "[…] θ̈ + (M L R cos ψ − 2 n² J_m) θ̈ − M L R ψ̇² sin ψ",
        "[…] θ̈ + (M L R cos ψ − 2 n² J_m) ψ̈ − M L R ψ̇² sin ψ",
        Say("∂²T/∂θ̇∂ψ̇ multiplies ψ̈; the mass matrix is symmetric with (2), and (11) prints it right."),
        ("(1)",),
        lambda k: {"swayed": k.wheel_acc},
    ),
    Erratum(
        "(2), (12), Δ, (14), (15), (19), (22)",
        "M L² + J_w + 2 n² J_m",
        "M L² + J_ψ + 2 n² J_m",
        Say("The body pitches with its own inertia J_ψ; the wheels' angles do not pitch with it."),
        ("(2)", "Δ", "(14)", "(15)"),
        lambda k: {"a22": k.a22 - k.pitch_inertia + k.wheel_inertia},
    ),
    Erratum(
        "(3), (13)",
        "[m W²/2 + J_φ + W²/(2 R²) (J_w + n² J_m) + M L² sin² ψ] θ̈",
        "[m W²/2 + J_φ + W²/(2 R²) (J_w + n² J_m) + M L² sin² ψ] φ̈",
        Say("It is the equation of yaw: its inertia multiplies the yaw acceleration."),
        ("(3)",),
        lambda k: {"turned": k.wheel_acc},
    ),
    Erratum(
        "(10)",
        "F_φ = W/(2 R) (v_l − v_r) − W²/(2 R²) (β + f_w) φ̇",
        "F_φ = W/(2 R) α (v_r − v_l) − W²/(2 R²) (β + f_w) φ̇",
        Say("By (4) F_φ = W/(2 R) (F_r − F_l), and a volt is a torque only through α."),
        ("(10)",),
        lambda k: {"turning": -k.turning / k.alpha},
    ),
    Erratum(
        "(13)",
        "W²/(2 R) (β + f_w) φ̇",
        "W²/(2 R²) (β + f_w) φ̇",
        Say("The wheels' rates differ by W φ̇/R and their torques act by W/(2 R); the printed term is no torque."),
        ("(10)",),
        lambda k: {"drag": k.drag * k.wheel_radius},
    ),
    Erratum(
        "(16), (24)",
        "φ̈ = (… + 2 M L² ψ̇ φ̇ sin ψ cos ψ) / …",
        "φ̈ = (… − 2 M L² ψ̇ φ̇ sin ψ cos ψ) / …",
        Say("The term stands on the left of (13) with a plus, so it comes to the right with a minus."),
        ("(16)",),
        lambda k: {"coriolis": -k.coriolis},
    ),
    Erratum(
        "(16)",
        "W/(2 R) (v_r − v_l)",
        "W/(2 R) α (v_r − v_l)",
        Say("A volt is a torque only through α, as (13) and (24) have it."),
        ("(16)",),
        lambda k: {"turning": k.turning / k.alpha},
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
        ("Δ",),
        lambda k: {"a11": k.a11 - k.wheel_inertia},
    ),
    Erratum(
        "(24)",
        "W²/(2 R²) (J_m + n² J_m)",
        "W²/(2 R²) (J_w + n² J_m)",
        Say("The wheel's inertia J_w, as in (3), (13) and (16)."),
        ("(16)",),
        lambda k: {"hub": k.rotor_inertia},
    ),
    Erratum(
        "(24)",
        "M L_2 sin² x₁",
        "M L² sin² x₁",
        Say("The exponent has slipped into an index; there is no L_2 (read here as L)."),
        ("(16)",),
        lambda k: {"swing": k.body_mass * _undefined(k)},
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
"""All misprints known, in the order of the paper."""
