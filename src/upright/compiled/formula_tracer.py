"""Formulas for any kind of number, such as those of `physics`, called with what stands for one: they write down the
statements of what they would compute, each once and in its order, so that a printed text rounds as they do."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from upright.compiled.program import (
    Absolute,
    Block,
    Choose,
    Function,
    Operand,
    Product,
    Quotient,
    Step,
    Sum,
    Whole,
)


class FormulaTracer:
    """Statements in order, each once; as `xp` the formulas' namespace of mathematics.

    What depends on constants alone is a float, computed at once. Nothing is known of ranges.
    """

    def __init__(self, letter: str = "t") -> None:
        self._letter = letter
        self._known = dict[Step, Number]()

    def number(self, name: str) -> Number:
        """What stands for the variable of that name."""
        return Number(name, self)

    def numbers(self, names: str) -> list[Number]:
        """Those of these names, between spaces."""
        return [Number(name, self) for name in names.split()]

    def record(self, step: Step) -> Number:
        """What a step without a name gives."""
        return self._known.setdefault(step, Number(f"{self._letter}{len(self._known)}", self))

    def block(self, name: str, results: Mapping[str, Any] | None = None) -> Block:
        """All statements, after which each variable of `results` takes its value."""
        statements = tuple(replace(step, target=number.name) for step, number in self._known.items())
        return Block(name, statements, tuple((target, value.name) for target, value in (results or {}).items()))

    def _function(self, name: str, value: Any) -> Number:
        return self.record(Function("", name, value.name))

    def sin(self, angle: Any) -> Number:
        return self._function("sin", angle)

    def cos(self, angle: Any) -> Number:
        return self._function("cos", angle)

    def sqrt(self, square: Any) -> Number:
        """The root; of a square, its size, to the last bit and quicker."""
        whole = next((step for step, number in self._known.items() if number is square), None)
        if isinstance(whole, Function) and whole.name == "square":
            return self.record(Absolute("", whole.value))
        return self._function("sqrt", square)

    def nearest(self, value: Any) -> Number:
        return self._function("nearest", value)

    def whole(self, value: Any) -> Number:
        return self.record(Whole("", value.name))

    def absolute(self, value: Any) -> Number:
        return self.record(Absolute("", value.name))

    def choose(self, left: Any, right: Any, then: Any, other: Any) -> Number:
        return self.record(Choose("", left.name, _operand(right), _operand(then), _operand(other)))


class Number:
    """What stands for a number: arithmetic with it becomes a statement."""

    def __init__(self, name: str, tracer: FormulaTracer) -> None:
        self.name, self._tracer = name, tracer

    def _sum(self, terms: tuple[tuple[float, str], ...], constant: float = 0.0) -> Number:
        return self._tracer.record(Sum("", terms, constant))

    def _with(self, sign: float, other: Any, other_sign: float) -> Number:
        if isinstance(other, Number):
            return self._sum(((sign, self.name), (other_sign, other.name)))
        return self._sum(((sign, self.name),), other_sign * float(other))

    def __add__(self, other: Any) -> Number:
        return self._with(1.0, other, 1.0)

    __radd__ = __add__

    def __sub__(self, other: Any) -> Number:
        return self._with(1.0, other, -1.0)

    def __rsub__(self, other: Any) -> Number:
        return self._with(-1.0, other, 1.0)

    def __neg__(self) -> Number:
        return self._sum(((-1.0, self.name),))

    def __mul__(self, other: Any) -> Number:
        if isinstance(other, Number):
            return self._tracer.record(Product("", self.name, other.name))
        return self._sum(((float(other), self.name),))

    __rmul__ = __mul__

    def __truediv__(self, below: Any) -> Number:
        return self._tracer.record(Quotient("", self.name, below.name))

    def __rtruediv__(self, number: float) -> Number:
        return self._tracer.record(Quotient("", float(number), self.name))

    def __pow__(self, power: int) -> Number:
        assert power == 2, "no other power is written"
        return self._tracer.record(Function("", "square", self.name))


def _operand(value: Any) -> Operand:
    return value.name if isinstance(value, Number) else float(value)
