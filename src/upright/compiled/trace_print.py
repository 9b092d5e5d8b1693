"""The symbols of a trace, and source text from expressions in them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from types import SimpleNamespace
from typing import Any

import sympy as sp

from upright.robots.robot import PARAMETERS

COMPLETE = sp.Symbol("complete", real=True)
"""1 for the complete and 0 for the published model, so that one kernel serves both."""

P = SimpleNamespace(**{name: sp.Symbol(name, positive=True) for name in PARAMETERS})

SIN, COS, SIN_YAW, COS_YAW, SIN_SLOPE, COS_SLOPE = sp.symbols("s c sin_yaw cos_yaw sin_slope cos_slope", real=True)
PITCH, PITCH_RATE, WHEEL_RATE, YAW, YAW_RATE = sp.symbols("pitch pitch_rate wheel_rate yaw yaw_rate", real=True)
LEFT, RIGHT, FORCE, MOMENT = sp.symbols("left right force moment", real=True)
SLIP = SLIP_LEFT, SLIP_RIGHT = sp.symbols("slip_left slip_right", real=True)
"""rate / √(rate² + ω_c²) of each motor: the smoothed sign in Coulomb's friction."""
ROLL = ROLL_LEFT, ROLL_RIGHT = sp.symbols("roll_left roll_right", real=True)
"""The same of each wheel's rate over the floor, in rolling friction."""

HELD = (LEFT, RIGHT, FORCE, MOMENT, SIN_SLOPE, COS_SLOPE)
STATE = (PITCH_RATE, WHEEL_RATE, YAW_RATE, SIN, COS, SIN_YAW, COS_YAW, *SLIP, *ROLL)
DYNAMIC = (*STATE, *HELD)
FACTOR_FIRST = (SIN, COS, YAW_RATE, PITCH_RATE, WHEEL_RATE)


class LanePrinter:
    """Straight-line source text: every value once, sums of products as chains of `fma`."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self._names: dict[Any, str] = {}

    def put(self, name: str, text: str) -> str:
        self.lines.append(f"{name} = {text}")
        return name

    def value(self, expression: Any) -> str:
        """Text for `expression`: a name, a signed name or a number, with the lines before it that it needs."""
        if expression.is_Symbol:
            return str(expression)
        if expression.is_number:
            return repr(float(expression))
        if _negative(expression):
            return f"-{self.value(-expression)}"
        if expression not in self._names:
            text = self._sum(expression) if expression.is_Add else " * ".join(self._halves(expression))
            self._names[expression] = self.put(f"t{len(self._names)}", text)
        return self._names[expression]

    def _halves(self, product: Any) -> tuple[str, str]:
        """Two factors of a product or power; what changes least is multiplied first, so that it is shared most."""
        if product.is_Pow:
            return self.value(product.base), self.value(product.base ** (product.exp - 1))
        parts = sorted(product.args, key=_rank)
        return self.value(sp.Mul(*parts[:-1])), self.value(parts[-1])

    def _sum(self, expression: Any) -> str:
        terms = sorted(
            expression.args, key=lambda term: (not _single(term), max(map(_rank, term.free_symbols), default=(0, "")))
        )
        text = self.value(terms[0])
        for term in terms[1:]:
            sign, size = ("-", -term) if _negative(term) else ("", term)
            if _single(size):
                text = f"{text} {sign or '+'} {self.value(size)}"
            else:
                first, second = self._halves(size)
                text = f"fma({sign}{first}, {second}, {text})"
        return text


def _negative(expression: Any) -> bool:
    return expression.is_Mul and expression.args[0].is_number and expression.args[0] < 0


def _single(term: Any) -> bool:
    return not (term.is_Mul or term.is_Pow) or (-term).is_Symbol or (-term).is_Add


def _rank(factor: Any) -> tuple[int, str]:
    """Parameters and constants, then what is held over a step, then the state."""
    free = factor.free_symbols
    return (2 if free & set(STATE) else 1 if free & set(HELD) else 0), str(factor)


def factored(expression: Any) -> Any:
    """Common factors taken out, the most common first (a greedy Horner scheme)."""
    terms = list(sp.Add.make_args(expression))
    counts: Counter[Any] = Counter(symbol for term in terms for symbol in term.free_symbols)
    order = {symbol: -i for i, symbol in enumerate(FACTOR_FIRST)}
    best = max(counts, key=lambda symbol: (counts[symbol], order.get(symbol, -9), str(symbol)), default=None)
    if best is None or counts[best] < 2:
        return expression
    inside = [term / best for term in terms if best in term.free_symbols]
    outside = [term for term in terms if best not in term.free_symbols]
    return best * factored(sp.Add(*inside)) + factored(sp.Add(*outside))


def function(head: str, lines: Iterable[str], decorator: str | None = "@inlined") -> str:
    return "\n".join([*([decorator] if decorator else []), f"def {head}:", *(f"    {line}" for line in lines), "", ""])
