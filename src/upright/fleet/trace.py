"""From `physics.dynamics` to source text: the one definition of the equations, traced and made quick.

The traced functions are called with SymPy symbols. What comes back is brought to the form

    θ̈ = Q_θ − a12 ψ̈,   ψ̈ = (Q_ψ − a12 Q_θ) / (a22 − a12²),   φ̈ = Q_φ / a33

with the first two equations divided by a11 and the third by a33 of an upright robot, so that every product of
parameters alone is a *constant* of the robot, computed once. What is left is factored and printed as chains of
fused multiply-adds. `python -m upright.fleet.trace` writes `generated.py` again.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import sympy as sp

from upright.fleet.trace_print import (
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
    STATE,
    WHEEL_RATE,
    YAW,
    YAW_RATE,
    P,
    Printer,
    factored,
    function,
)
from upright.physics.dynamics import Disturbance, accelerations, mass_matrix
from upright.physics.sensing import accelerometer
from upright.robots.robot import PARAMETERS


@dataclass(frozen=True)
class Traced:
    """`constants`: name → formula in the robot's parameters, in order. The rest in the names of those constants and of
    `STATE` and `HELD`: `forces` Q_ψ, Q_θ, Q_φ, inertias `a12`, `a22`, `a33`, and the slip `rates` of left and right."""

    constants: dict[str, Any]
    forces: tuple[Any, Any, Any]
    inertias: tuple[Any, Any, Any]
    rates: tuple[Any, Any]


class _Maths:
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
    xp = _Maths(slope)
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


def _split(expression: Any) -> Any:
    """Factored, with what is held over a step apart, so that it is computed once for all stages."""
    terms = sp.Add.make_args(sp.expand(expression))
    held = [term for term in terms if not term.free_symbols & set(STATE)]
    return factored(sp.Add(*held)), factored(sp.Add(*[term for term in terms if term not in held]))


def _shorter(expression: Any, *, coulomb: bool, slope: bool) -> Any:
    """Without what a level floor or a robot without Coulomb friction does not need."""
    level = {SIN_SLOPE: 0, COS_SLOPE: 1}
    smooth = {SLIP_LEFT: 0, SLIP_RIGHT: 0}
    return expression.subs({**({} if slope else level), **({} if coulomb else smooth)})


def _acceleration_lines(*, coulomb: bool, slope: bool) -> list[str]:
    """The body of a function that gives ψ̈, θ̈, φ̈, with one reciprocal for all its divisions."""
    traced, out = trace(), Printer()
    out.put("s, c", "sincos(pitch)")
    if slope:
        out.put("sin_yaw, cos_yaw", "sincos_any(yaw)")
    _, a22, a33 = (
        sp.Symbol(out.put(n, out.value(e))) for n, e in zip(("a12", "a22", "a33"), traced.inertias, strict=True)
    )
    below = [out.put("determinant", f"fma(-a12, a12, {a22})"), str(a33)]
    if coulomb:
        for side, rate in zip(("left", "right"), traced.rates, strict=True):
            out.put(f"rate_{side}", out.value(rate))
            square = list(trace().constants)[-1]
            below.append(out.put(f"root_{side}", f"sqrt(fma(rate_{side}, rate_{side}, {square}))"))
    over = _reciprocals(out, below)
    if coulomb:
        out.put("slip_left", f"rate_left * {over[2]}")
        out.put("slip_right", f"rate_right * {over[3]}")
    force = [_split(_shorter(f, coulomb=coulomb, slope=slope)) for f in traced.forces]
    for name, (held, _) in zip(("held_pitch", "held_wheel", "held_yaw"), force, strict=True):
        out.put(name, out.value(held))
    pitch, wheel, yaw = (
        out.value(sp.Symbol(name) + free)
        for name, (_, free) in zip(("held_pitch", "held_wheel", "held_yaw"), force, strict=True)
    )
    out.put("pitch_acc", f"fma(-a12, {wheel}, {pitch}) * {over[0]}")
    return [*out.lines, f"return pitch_acc, fma(-a12, pitch_acc, {wheel}), {yaw} * {over[1]}"]


def _reciprocals(out: Printer, names: Sequence[str]) -> list[str]:
    """1/a, 1/b, … by one division of their product (Montgomery 1987)."""
    before = [names[0]]
    for i, name in enumerate(names[1:]):
        before.append(out.put(f"before_{i}", f"{before[-1]} * {name}"))
    rest, found = out.put("over", f"reciprocal({before[-1]})"), []
    for i in range(len(names) - 1, 0, -1):
        found.append(out.put(f"over_{i}", f"{rest} * {before[i - 1]}"))
        rest = out.put(f"rest_{i}", f"{rest} * {names[i]}")
    return [rest, *reversed(found)]


VARIANTS = {"smooth": (False, False), "coulomb": (True, False), "slope": (False, True), "coulomb_slope": (True, True)}
"""Name → whether with Coulomb friction and whether on a floor that may slope."""

ROWS = ("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate", "h", "lived", *map(str, HELD))
"""What a block holds for each robot before its constants, by row."""

STAGE = ("pitch", "pitch_rate", "wheel_rate", "yaw", "yaw_rate")


def _acceleration_function(name: str, coulomb: bool, slope: bool) -> str:
    arguments = ", ".join([*STAGE, *map(str, HELD), *trace().constants])
    return function(f"accelerations_{name}({arguments})", _acceleration_lines(coulomb=coulomb, slope=slope))


def _load_lines() -> list[str]:
    rows = [*ROWS, *trace().constants]
    return [f"{name} = w[{index} * ROW + i]" for index, name in enumerate(rows)]


def _rk4_lines(name: str, slope: bool) -> list[str]:
    """One step of the classical method, its sums of rates written through the accelerations (Nyström's form)."""
    rest = ", ".join([*map(str, HELD), *trace().constants])
    lines = ["half, sixth = mul(h, 0.5), mul(h, 1 / 6)"]
    names = ("pitch", "wheel", "yaw")

    def stage(k: int, step: str) -> None:
        for n in names:
            if k > 1 and (n == "pitch" or (n == "yaw" and slope)):
                before = f"{n}_rate{k - 1}" if k > 2 else f"{n}_rate"
                lines.append(f"{n}{k} = fma({step}, {before}, {n})")
            if k > 1:
                lines.append(f"{n}_rate{k} = fma({step}, {n}_acc{k - 1}, {n}_rate)")
        moved = [n if k == 1 or (n == "yaw" and not slope) else f"{n}{k}" for n in STAGE]
        found = ", ".join(f"{n}_acc{k}" for n in names)
        lines.append(f"{found} = accelerations_{name}({', '.join(moved)}, {rest})")

    for k, step in ((1, ""), (2, "half"), (3, "half"), (4, "h")):
        stage(k, step)
    for n in names:
        lines.append(f"{n}_middle = {n}_acc2 + {n}_acc3")
        lines.append(f"{n}_sum = {n}_acc1 + {n}_middle")
        lines.append(f"new_{n} = fma(h, fma(sixth, {n}_sum, {n}_rate), {n})")
        lines.append(f"new_{n}_rate = fma(sixth, ({n}_sum + {n}_middle) + {n}_acc4, {n}_rate)")
    return lines


def _advance_function(name: str, slope: bool) -> str:
    """All robots of a block by one step; one whose pitch leaves ±fallen gets a step of zero from then on."""
    state = ROWS[:6]
    store = [f"w[{i} * ROW + i] = new_{n}" for i, n in enumerate(state)]
    lived, step = ROWS.index("lived"), ROWS.index("h")
    body = [
        *_load_lines(),
        *_rk4_lines(name, slope),
        *store,
        f"w[{lived} * ROW + i] = now if h > 0 else lived",
        f"w[{step} * ROW + i] = h if absolute(new_pitch) <= fallen else mul(h, 0.0)",
    ]
    lines = ["w = rows_of(block, SIZE)", "align_stack()", "for i in range(count):", *(f"    {line}" for line in body)]
    return function(f"advance_{name}(block, count, fallen, now)", lines, None)


def _specific_force_function(name: str, slope: bool) -> str:
    """Rows `out` and `out` + 1: what an accelerometer at the axle reads, in motion under what is held."""
    tilt = sp.Symbol("slope", real=True)
    x, wheel_acc = (PITCH, PITCH_RATE, sp.Symbol("wheel"), WHEEL_RATE, YAW, YAW_RATE), sp.Symbol("wheel_acc", real=True)
    forces = accelerometer(x, wheel_acc, P, tilt, _Maths(tilt))
    known = {P.wheel_radius: sp.Symbol("c1"), P.gravity: sp.Symbol("c2")}
    forward, up = (_shorter(sp.expand(f.xreplace(known)), coulomb=False, slope=slope) for f in forces)
    rest = ", ".join([*map(str, HELD), *trace().constants])
    printer = Printer()
    results = [printer.value(factored(forward)), printer.value(factored(up))]
    angles = ["s, c = sincos(pitch)", *(["sin_yaw, cos_yaw = sincos_any(yaw)"] if slope else [])]
    body = [
        *_load_lines(),
        f"_, wheel_acc, _ = accelerations_{name}({', '.join(STAGE)}, {rest})",
        *angles,
        *printer.lines,
    ]
    body += [f"w[(out + {k}) * ROW + i] = {result}" for k, result in enumerate(results)]
    lines = ["w = rows_of(block, SIZE)", "for i in range(count):", *(f"    {line}" for line in body)]
    return function(f"specific_force_{name}(block, count, out)", lines, None)


def _constants_function() -> str:
    """A robot's constants from its parameters, in the order of `PARAMETERS`."""
    lines = [f"{name} = p[{i}]" for i, name in enumerate(PARAMETERS)]
    shared, formulas = sp.cse(list(trace().constants.values()), sp.numbered_symbols("t"))
    lines += [f"{name} = {sp.pycode(formula)}" for name, formula in shared]
    lines.append(f"return ({', '.join(str(sp.pycode(formula)) for formula in formulas)})")
    return function("constants(p, complete)", lines, None)


def sources() -> dict[str, str]:
    """The text of each generated file, by name."""
    from upright.fleet.trace_tangent import tangents

    size = f"LANES, ROW, SIZE = {LANES}, {ROW}, {len(ROWS) + len(trace().constants)} * {ROW}"
    rows = [
        size,
        f"CONSTANTS = {len(trace().constants)}",
        *(f"{n.upper()} = {i}" for i, n in enumerate([*ROWS, "c0"])),
        "",
    ]
    motion = [HEADER, IMPORTS]
    for name, (coulomb, slope) in VARIANTS.items():
        motion += [_acceleration_function(name, coulomb, slope), _advance_function(name, slope)]
        motion.append(_specific_force_function(name, slope))
    return {
        "generated.py": "\n\n".join([HEADER, "\n".join(rows), _constants_function()]).rstrip() + "\n",
        "generated_tangent.py": "\n\n".join([HEADER, *tangents()]).rstrip() + "\n",
        "generated_motion.py": "\n\n".join(motion).rstrip() + "\n",
    }


HEADER = """# Generated from physics.dynamics: do not edit. Written again by: python -m upright.fleet.trace
# ruff: noqa
# fmt: off
# pyright: basic"""

IMPORTS = """from upright.fleet.generated import ROW, SIZE
from upright.fleet.kernel_jit import absolute, align_stack, fma, inlined, mul, reciprocal, rows_of, sqrt
from upright.fleet.kernel_math import sincos, sincos_any"""

LANES, ROW = 64, 80
"""Robots in a block, and numbers from one row to the next: rows 64 apart would meet in the same cache lines."""


def main() -> None:
    """Writes the generated files beside this one."""
    for name, text in sources().items():
        Path(__file__).with_name(name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
