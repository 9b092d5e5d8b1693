"""The equations of motion derived twice from the energies, to prove `physics.dynamics` and the paper's errata.

`published` puts the rolling constraint into the Lagrangian before differentiating, as Yamamoto (2008) does and
Herrera et al. (2015), eqs. (11) to (13), repeat. `complete` differentiates first, in the six coordinates
q = (x, y, φ, ψ, θ_l, θ_r), and then keeps the directions q̇ = S(q) ν in which the wheels can roll:
M q̈ + h = Q + Aᵀλ with A S = 0 leaves Sᵀ M S ν̇ = Sᵀ (Q − h − M Ṡ ν), so that the multipliers drop out
(Maggi 1896; for a rolling constraint only this order is right).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from types import SimpleNamespace
from typing import Any, Literal, NamedTuple

from upright.errors import UnknownName
from upright.languages import superscript
from upright.physics.dynamics import CALM, MODELS, Disturbance
from upright.robots import PARAMETERS
from upright.signals import STATE

Model = Literal["published", "complete"]

RATES = ("wheel_rate", "pitch_rate", "yaw_rate")
"""ν = (θ̇, ψ̇, φ̇): the order of the paper's three equations, and of the rows of the mass matrix."""

_INPUTS = {"left": "v_l", "right": "v_r", "force": "F", "height": "h", "slope": "γ", "alpha": "α", "beta": "β"}
_SIGNS = {"sign_l": "σ_l", "sign_r": "σ_r", "floor_l": "ρ_l", "floor_r": "ρ_r"}
_UNREDUCED = {"x": "x", "y": "y", "vx": "ẋ", "vy": "ẏ", "wl": "θ̇_l", "wr": "θ̇_r", "torque_l": "τ_l", "torque_r": "τ_r"}


class Mechanics(NamedTuple):
    """The unconstrained system M q̈ + h = Q, the rolling constraint A q̇ = 0 and its free directions q̇ = S ν."""

    q: tuple[Any, ...]
    v: tuple[Any, ...]
    energy: Any
    force: Any
    rolling: Any
    motion: Any


@dataclass(frozen=True, eq=False)
class Derivation:
    """mass · (θ̈, ψ̈, φ̈) = force [N m], as SymPy expressions of `symbols`: one attribute for each state, command,
    disturbance and parameter field of `Robot`. The motor's α and β and the smoothed signs of the wheels' rates,
    σ_l, σ_r against the body and ρ_l, ρ_r against the floor, are symbols too; `definitions` writes them out."""

    model: Model
    symbols: SimpleNamespace
    mass: Any
    force: Any

    @property
    def accelerations(self) -> tuple[Any, Any, Any]:
        """ψ̈, θ̈, φ̈ [rad/s²] as expressions, in the order of `physics.dynamics.accelerations`."""
        a, f = self.mass, self.force
        determinant = a[0, 0] * a[1, 1] - a[0, 1] ** 2
        pitch = (a[0, 0] * f[1] - a[0, 1] * f[0]) / determinant
        wheel = (a[1, 1] * f[0] - a[0, 1] * f[1]) / determinant
        return pitch, wheel, f[2] / a[2, 2]

    @property
    def definitions(self) -> dict[Any, Any]:
        """α, β, σ_l, σ_r, ρ_l and ρ_r in the robot's own numbers and the state."""
        import sympy as sp

        s = self.symbols
        alpha = s.gear_ratio * s.torque_constant / s.motor_resistance

        def sign(rate: Any) -> Any:
            return rate / sp.sqrt(rate**2 + s.stiction_rate**2)

        left, right = _wheel_rates(s)
        return {
            s.alpha: alpha,
            s.beta: alpha * s.back_emf + s.motor_friction,
            s.sign_l: sign(left - s.pitch_rate),
            s.sign_r: sign(right - s.pitch_rate),
            s.floor_l: sign(left),
            s.floor_r: sign(right),
        }

    @property
    def loads(self) -> dict[Any, int]:
        """Push, slope and dry friction, which the paper does not model: each to be zero."""
        s = self.symbols
        return dict.fromkeys((s.force, s.slope, s.coulomb_friction, s.rolling_friction), 0)

    @property
    def equations(self) -> tuple[str, str, str]:
        """The θ, ψ and φ equations as one line of plain text each, in N m."""
        a, f = self.mass, self.force
        return (
            f"[{plain(a[0, 0])}] θ̈ + [{plain(a[0, 1])}] ψ̈ = {plain(f[0])}",
            f"[{plain(a[1, 0])}] θ̈ + [{plain(a[1, 1])}] ψ̈ = {plain(f[1])}",
            f"[{plain(a[2, 2])}] φ̈ = {plain(f[2])}",
        )

    def evaluator(self, namespace: str = "numpy") -> Callable[..., tuple[Any, Any, Any]]:
        """`accelerations(x, u, p, w)` compiled for "numpy", "math" or "mpmath" numbers."""
        import sympy as sp

        s = self.symbols
        names = [signal.name for signal in STATE] + ["left", "right", *Disturbance._fields, *PARAMETERS]
        expressions = [e.subs(self.definitions) for e in self.accelerations]
        compiled = sp.lambdify([getattr(s, n) for n in names], expressions, modules=namespace, cse=True, dummify=True)

        def evaluate(x: Sequence[Any], u: Sequence[Any], p: Any, w: Disturbance = CALM) -> tuple[Any, Any, Any]:
            return tuple(compiled(*x, *u, *w, *(getattr(p, n) for n in PARAMETERS)))  # type: ignore[return-value]

        return evaluate


@lru_cache(maxsize=2)
def derive(model: Model = "complete") -> Derivation:
    """The equations of motion with every input of `physics.dynamics.accelerations`: motors, friction, push, slope.

    `UnknownName` for another model. The yaw equation is uncoupled from the other two in both.
    """
    if model not in MODELS:
        raise UnknownName("model", model, MODELS)
    s = symbols()
    system = mechanics(s, roll=s.roll_inertia if model == "complete" else s.yaw_inertia)
    mass, force = _projected(system, s) if model == "complete" else _reduced(system, s)
    left, right = (s.beta * (rate - s.pitch_rate) for rate in _wheel_rates(s))
    motors = {
        s.torque_l: s.alpha * s.left - left - s.coulomb_friction * s.sign_l,
        s.torque_r: s.alpha * s.right - right - s.coulomb_friction * s.sign_r,
    }
    return Derivation(model, s, mass.as_immutable(), force.subs(motors).applyfunc(tidy).as_immutable())


@lru_cache(maxsize=1)
def symbols() -> SimpleNamespace:
    """One SymPy symbol for each quantity, by its name in this package, printed as in the paper."""
    import sympy as sp

    names = {signal.name: signal.symbol for signal in STATE} | _INPUTS | _SIGNS | _UNREDUCED
    real = {name: sp.Symbol(symbol, real=True) for name, symbol in names.items()}
    positive = {name: sp.Symbol(symbol, positive=True) for name, (_, symbol) in PARAMETERS.items()}
    return SimpleNamespace(**real, **positive)


def mechanics(s: SimpleNamespace, roll: Any) -> Mechanics:
    """Energies, forces and constraint in the six coordinates; `roll` is the body's roll inertia [kg m²]."""
    import sympy as sp

    q = (s.x, s.y, s.yaw, s.pitch, sp.Symbol("θ_l"), sp.Symbol("θ_r"))
    v = (s.vx, s.vy, s.yaw_rate, s.pitch_rate, s.wl, s.wr)
    cos, sin = sp.cos(s.yaw), sp.sin(s.yaw)
    force = [-sp.diff(_potential(s), c) for c in q]
    force[0] += s.force * cos
    force[1] += s.force * sin
    # the pushed point stands h sin ψ ahead of the axle: turning moves it sideways only, which costs no work
    force[3] += s.force * s.height * sp.cos(s.pitch) - s.torque_l - s.torque_r
    force[4] += s.torque_l - s.wheel_friction * s.wl - s.rolling_friction * s.floor_l
    force[5] += s.torque_r - s.wheel_friction * s.wr - s.rolling_friction * s.floor_r
    forward = v[0] * cos + v[1] * sin
    sideways = v[1] * cos - v[0] * sin
    turn = s.track / 2 * s.yaw_rate
    gaps = [sideways, forward - turn - s.wheel_radius * s.wl, forward + turn - s.wheel_radius * s.wr]
    rolling = sp.Matrix(gaps).jacobian(v)
    rates = [s.wheel_radius * s.wheel_rate * cos, s.wheel_radius * s.wheel_rate * sin, s.yaw_rate, s.pitch_rate]
    motion = sp.Matrix([*rates, *_wheel_rates(s)]).jacobian([getattr(s, name) for name in RATES])
    return Mechanics(q, v, _kinetic(s, q, v, roll), sp.Matrix(force), rolling, motion)


def lagrange(energy: Any, q: Sequence[Any], v: Sequence[Any]) -> tuple[Any, Any]:
    """Mass matrix M and bias h of d/dt ∂T/∂q̇ − ∂T/∂q = M q̈ + h, for the kinetic energy T(q, q̇ = v)."""
    import sympy as sp

    momentum = sp.Matrix([sp.diff(energy, rate) for rate in v])
    bias = momentum.jacobian(q) * sp.Matrix(v) - sp.Matrix([sp.diff(energy, c) for c in q])
    return momentum.jacobian(v), bias


def tidy(expression: Any) -> Any:
    """Expanded, with every cos² written as 1 − sin²: equal polynomials in sines and cosines become identical."""
    import sympy as sp

    def even(power: Any) -> Any:
        return (1 - sp.sin(power.base.args[0]) ** 2) ** (power.exp // 2) * power.base ** (power.exp % 2)

    return sp.expand(sp.expand(expression).replace(_is_cosine_power, even))


def plain(expression: Any) -> str:
    """A SymPy expression as plain text in the paper's letters: `W²/(2 R²)`, `sin² ψ`."""
    text = re.sub(r"(sin|cos)\((\w+)\)\*\*(\d)", r"\1**\3 \2", str(expression))
    text = re.sub(r"(sin|cos)\((\w+)\)", r"\1 \2", text)
    text = re.sub(r"\*\*(\d)", lambda power: superscript(int(power[1])), text)
    return text.replace("sqrt", "√").replace("*", " ").replace("-", "−")


def _kinetic(s: SimpleNamespace, q: Sequence[Any], v: Sequence[Any], roll: Any) -> Any:
    """T: body (moving and turning about its own axes), two wheels, two rotors that spin against the body."""
    import sympy as sp

    cos, sin = sp.cos(s.pitch), sp.sin(s.pitch)
    heading = sp.Matrix([sp.cos(s.yaw), sp.sin(s.yaw), 0])
    left = sp.Matrix([-sp.sin(s.yaw), sp.cos(s.yaw), 0])
    axle = sp.Matrix([s.x, s.y, s.wheel_radius])
    com = axle + s.com_height * (sin * heading + cos * sp.Matrix([0, 0, 1]))

    def squared_speed(point: Any) -> Any:
        velocity = point.jacobian(q) * sp.Matrix(v)
        return velocity.dot(velocity)

    wheels = squared_speed(axle + s.track / 2 * left) + squared_speed(axle - s.track / 2 * left)
    spin = s.pitch_inertia * s.pitch_rate**2 + (s.yaw_inertia * cos**2 + roll * sin**2) * s.yaw_rate**2
    wheel_spin = s.wheel_inertia * (s.wl**2 + s.wr**2)
    rotor_spin = s.gear_ratio**2 * s.rotor_inertia * ((s.wl - s.pitch_rate) ** 2 + (s.wr - s.pitch_rate) ** 2)
    return (s.body_mass * squared_speed(com) + spin + s.wheel_mass * wheels + wheel_spin + rotor_spin) / 2


def _potential(s: SimpleNamespace) -> Any:
    """V: weight times height above the level, in a floor frame whose x axis climbs at γ."""
    import sympy as sp

    along = s.body_mass * (s.x + s.com_height * sp.sin(s.pitch) * sp.cos(s.yaw)) + 2 * s.wheel_mass * s.x
    above = s.body_mass * s.com_height * sp.cos(s.pitch)
    return s.gravity * (along * sp.sin(s.slope) + above * sp.cos(s.slope))


def _projected(system: Mechanics, s: SimpleNamespace) -> tuple[Any, Any]:
    """Differentiate first, then keep the rolling directions: SᵀMS ν̇ = Sᵀ (Q − h − M Ṡ ν)."""
    import sympy as sp

    mass, bias = lagrange(system.energy, system.q, system.v)
    velocity = system.motion * sp.Matrix([getattr(s, name) for name in RATES])
    carried = mass * velocity.jacobian(system.q) * sp.Matrix(system.v)
    force = (system.motion.T * (system.force - bias - carried)).subs(_rolls(system, s))
    return (system.motion.T * mass * system.motion).applyfunc(tidy), force.applyfunc(tidy)


def _reduced(system: Mechanics, s: SimpleNamespace) -> tuple[Any, Any]:
    """Put the constraint into the energy, then differentiate: what the published equations are."""
    import sympy as sp

    rates = [getattr(s, name) for name in RATES]
    mass, bias = lagrange(tidy(system.energy.subs(_rolls(system, s))), (s.wheel, s.pitch, s.yaw), rates)
    force = (system.motion.T * system.force).subs(_rolls(system, s)) - bias
    return sp.Matrix(mass).applyfunc(tidy), force.applyfunc(tidy)


def _rolls(system: Mechanics, s: SimpleNamespace) -> dict[Any, Any]:
    """q̇ = S ν as a substitution, for the rates that are not themselves in ν."""
    import sympy as sp

    velocity = system.motion * sp.Matrix([getattr(s, name) for name in RATES])
    return {old: new for old, new in zip(system.v, velocity, strict=True) if old != new}


def _wheel_rates(s: SimpleNamespace) -> tuple[Any, Any]:
    """θ̇_l and θ̇_r of rolling wheels."""
    difference = s.track / (2 * s.wheel_radius) * s.yaw_rate
    return s.wheel_rate - difference, s.wheel_rate + difference


def _is_cosine_power(term: Any) -> bool:
    import sympy as sp

    return bool(term.is_Pow and isinstance(term.base, sp.cos) and term.exp.is_Integer and term.exp >= 2)
