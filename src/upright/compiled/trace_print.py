"""The symbols of a trace, statements from expressions in them, and their source text for Numba."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import replace
from types import SimpleNamespace
from typing import Any, NamedTuple

import sympy as sp

from upright.compiled.printer import Printer
from upright.compiled.program import Function, Fused, Operand, Product, Step, operands
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


Signed = tuple[float, Operand]
"""1 or −1, and what it is times."""


class AlgebraTracer:
    """Statements of what expressions give: every value once, sums of products as chains of `fma`."""

    def __init__(self) -> None:
        self.steps: list[Step] = []
        self._names: dict[Any, str] = {}

    def put(self, name: str, step: Step) -> str:
        """Records a step, which has no name yet, under this one."""
        self.steps.append(replace(step, target=name))
        return name

    def named(self, name: str, expression: Any) -> str:
        return self.put(name, Fused("", (self.value(expression),)))

    def sine_and_cosine(self, sine: Any, cosine: Any, angle: Any) -> None:
        self.put(str(sine), Function("", "sin", str(angle)))
        self.put(str(cosine), Function("", "cos", str(angle)))

    def value(self, expression: Any) -> Signed:
        """What holds `expression`, after the statements before it that it needs."""
        if expression.is_Symbol:
            return 1.0, str(expression)
        if expression.is_number:
            return 1.0, float(expression)
        if _negative(expression):
            sign, value = self.value(-expression)
            return -sign, value
        if expression not in self._names:
            step = self._sum(expression) if expression.is_Add else self._product(expression)
            self._names[expression] = self.put(f"t{len(self._names)}", step)
        return 1.0, self._names[expression]

    def _product(self, expression: Any) -> Product:
        (one, first), (other, second) = self._halves(expression)
        assert one == other == 1, "a product's sign is its sum's"
        return Product("", str(first), str(second))

    def _halves(self, product: Any) -> tuple[Signed, Signed]:
        """Two factors of a product or power; what changes least is multiplied first, so that it is shared most."""
        if product.is_Pow:
            return self.value(product.base), self.value(product.base ** (product.exp - 1))
        parts = sorted(product.args, key=_rank)
        return self.value(sp.Mul(*parts[:-1])), self.value(parts[-1])

    def _sum(self, expression: Any) -> Fused:
        first, *rest = sorted(
            expression.args, key=lambda term: (not _single(term), max(map(_rank, term.free_symbols), default=(0, "")))
        )
        terms = [self.value(first)]
        products = list[tuple[float, Operand, Operand]]()
        for term in rest:
            sign, size = (-1.0, -term) if _negative(term) else (1.0, term)
            if _single(size):
                own, value = self.value(size)
                terms.append((sign * own, value))
            else:
                (one, factor), (other, second) = self._halves(size)
                products.append((sign * one * other, factor, second))
        return Fused("", tuple(terms), tuple(products))


class LaneSource(Printer):
    """Statements as source text for Numba, on a lane of a block."""

    end = ""

    def fused(self, terms: Sequence[tuple[float, Operand]], products: Sequence[tuple[float, Operand, Operand]]) -> str:
        text = " ".join(f"{'-' if sign < 0 else '+'} {self.operand(value)}" for sign, value in terms)
        text = text.removeprefix("+ ").replace("- ", "-", 1) if text.startswith("- ") else text.removeprefix("+ ")
        for sign, first, second in products:
            text = f"fma({'-' if sign < 0 else ''}{self.operand(first)}, {self.operand(second)}, {text})"
        return text

    def absolute(self, value: str) -> str:
        return f"absolute({value})"

    def lines(self, steps: Iterable[Step]) -> list[SourceLine]:  # type: ignore[override]
        """One line for each statement, but one for a sine and the cosine after it."""
        lines = list[SourceLine]()
        sine = ""
        for step in steps:
            match step:
                case Function(target, "sin", _):
                    sine = target
                case Function(target, "cos", angle):
                    way = "sincos" if angle == str(PITCH) else "sincos_any"
                    lines.append(called((sine, target), way, (angle,)))
                case _:
                    lines.append(SourceLine(self.statement(step)[0], (step.target,), operands(step)))
        return lines


class SourceLine(NamedTuple):
    """Source text, and the names that it makes and reads."""

    text: str
    makes: tuple[str, ...]
    reads: tuple[str, ...]


def called(makes: Iterable[str], function: str, arguments: Iterable[str]) -> SourceLine:
    makes, reads = tuple(makes), tuple(arguments)
    return SourceLine(f"{', '.join(makes)} = {function}({', '.join(reads)})", makes, reads)


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


def function(head: str, lines: Iterable[str | SourceLine], decorator: str | None = "@inlined") -> str:
    texts = (line.text if isinstance(line, SourceLine) else line for line in lines)
    return "\n".join([*([decorator] if decorator else []), f"def {head}:", *(f"    {text}" for text in texts), "", ""])
