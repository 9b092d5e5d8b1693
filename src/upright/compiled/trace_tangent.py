"""The second half of the trace: how the accelerations change with every argument and constant, as source text."""

from __future__ import annotations

from typing import Any

import sympy as sp

from upright.compiled.trace import STAGE, trace
from upright.compiled.trace_print import (
    COS,
    COS_YAW,
    FORCE,
    HELD,
    LEFT,
    MOMENT,
    PITCH,
    PITCH_RATE,
    RIGHT,
    SIN,
    SIN_YAW,
    SLIP_LEFT,
    SLIP_RIGHT,
    WHEEL_RATE,
    YAW,
    YAW_RATE,
    P,
    Printer,
    factored,
    function,
)
from upright.robots.robot import PARAMETERS

IMPORTS = """from math import cos, sin, sqrt


def fma(a, b, c):
    return a * b + c"""


def tangents() -> list[str]:
    """The parts of `generated_tangent.py`."""
    return [IMPORTS, _constants_jacobian_function(), _tangent_function()]


def _constants_jacobian_function() -> str:
    """∂c/∂p (CONSTANTS, parameters), written into `out`, whose other entries are zero."""
    lines = [f"{name} = p[{i}]" for i, name in enumerate(PARAMETERS)]
    symbols = [getattr(P, name) for name in PARAMETERS]
    entries = {
        (k, m): sp.diff(formula, symbol)
        for k, formula in enumerate(trace().constants.values())
        for m, symbol in enumerate(symbols)
        if formula.has(symbol)
    }
    shared, formulas = sp.cse(list(entries.values()), sp.numbered_symbols("t"))
    lines += [f"{name} = {sp.pycode(formula)}" for name, formula in shared]
    lines += [f"out[{k}, {m}] = {sp.pycode(f)}" for (k, m), f in zip(entries, formulas, strict=True)]
    return function("constants_jacobian(p, complete, out)", lines, None)


def _tangent_lines() -> list[str]:
    """ψ̈, θ̈, φ̈ and their derivatives by every argument: M q̈ = Q gives M dq̈ = dQ − dM q̈."""
    traced, out = trace(), Printer()
    for k, name in enumerate(traced.constants):
        out.put(name, f"k[{k}]")
    out.put("s, c", "sin(pitch), cos(pitch)")
    out.put("sin_yaw, cos_yaw", "sin(yaw), cos(yaw)")
    square = list(traced.constants)[-1]
    for side, rate in zip(("left", "right"), traced.rates, strict=True):
        out.put(f"rate_{side}", out.value(rate))
        out.put(f"over_{side}", f"1.0 / sqrt(rate_{side} * rate_{side} + {square})")
        out.put(f"slip_{side}", f"rate_{side} * over_{side}")
    for name, expression in zip(("a12", "a22", "a33"), traced.inertias, strict=True):
        out.put(name, out.value(expression))
    for name, expression in zip(("pitch_force", "wheel_force", "yaw_force"), traced.forces, strict=True):
        out.put(name, out.value(factored(expression)))
    out.put("over", "1.0 / (a22 - a12 * a12)")
    out.put("pitch_acc", "(pitch_force - a12 * wheel_force) * over")
    out.put("wheel_acc", "wheel_force - a12 * pitch_acc")
    out.put("yaw_acc", "yaw_force / a33")
    return out.lines + [line for name, place in _directions() for line in _direction_lines(name, place, out)]


def _directions() -> list[tuple[Any, str]]:
    """What the accelerations are differentiated by, and the columns of the arrays that get the result."""
    states = {PITCH: 0, PITCH_RATE: 1, WHEEL_RATE: 3, YAW: 4, YAW_RATE: 5}
    found = [(symbol, f"fx[{{}}, {i}]") for symbol, i in states.items()]
    found += [(symbol, f"fu[{{}}, {i}]") for i, symbol in enumerate((LEFT, RIGHT))]
    found += [(symbol, f"fw[{{}}, {i}]") for i, symbol in enumerate((FORCE, MOMENT))]
    return found + [(sp.Symbol(name, real=True), f"fc[{{}}, {k}]") for k, name in enumerate(trace().constants)]


def _along(expression: Any, symbol: Any) -> Any:
    """∂expression/∂symbol, through the sines and the slips too."""
    inner = {SIN: (PITCH, COS), COS: (PITCH, -SIN), SIN_YAW: (YAW, COS_YAW), COS_YAW: (YAW, -SIN_YAW)}
    total = sp.diff(expression, symbol)
    for circular, (angle, slope) in inner.items():
        total += sp.diff(expression, circular) * (slope if symbol == angle else 0)
    square = sp.Symbol(list(trace().constants)[-1], real=True)
    for side, slip, rate in zip(("left", "right"), (SLIP_LEFT, SLIP_RIGHT), trace().rates, strict=True):
        over = sp.Symbol(f"over_{side}", real=True)
        by_square = -slip * over**2 / 2 if symbol == square else 0
        total += sp.diff(expression, slip) * (sp.diff(rate, symbol) * square * over**3 + by_square)
    return sp.expand(total)


def _direction_lines(symbol: Any, place: str, out: Printer) -> list[str]:
    traced, before = trace(), len(out.lines)
    accelerations_ = sp.symbols("pitch_acc wheel_acc yaw_acc", real=True)
    pitch_acc, wheel_acc, yaw_acc = accelerations_
    d12, d22, d33 = (_along(inertia, symbol) for inertia in traced.inertias)
    pitch_force, wheel_force, yaw_force = (_along(force, symbol) for force in traced.forces)
    wheel = out.value(factored(sp.expand(wheel_force - d12 * pitch_acc)))
    pitch = out.value(factored(sp.expand(pitch_force - d12 * wheel_acc - d22 * pitch_acc)))
    yaw = out.value(factored(sp.expand(yaw_force - d33 * yaw_acc)))
    lines = [*out.lines[before:]]
    first, third, fifth = (place.format(row) for row in (1, 3, 5))
    lines += [
        f"{first} = ({pitch} - a12 * ({wheel})) * over",
        f"{third} = ({wheel}) - a12 * {first}",
        f"{fifth} = ({yaw}) / a33",
    ]
    return lines


def _tangent_function() -> str:
    """The accelerations, returned, and their derivatives, written into rows 1, 3 and 5 of fx, fu, fw and fc."""
    arguments = f"{', '.join(STAGE)}, {', '.join(map(str, HELD))}, k, fx, fu, fw, fc"
    return function(f"tangent({arguments})", [*_tangent_lines(), "return pitch_acc, wheel_acc, yaw_acc"], None)
