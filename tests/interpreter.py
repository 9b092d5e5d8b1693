"""A program run statement by statement in double precision: the reference for every printed text."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from upright.compiled.program import (
    Absolute,
    Block,
    Choose,
    Function,
    Fused,
    Kind,
    Limit,
    Operand,
    Product,
    Program,
    Quotient,
    Repeat,
    Statement,
    Step,
    Sum,
    Whole,
)


class Interpreter:
    """`calibrate(raw)`, `command(raw)` and `update()` run one block each and return all variables by name."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self.reset()

    def reset(self) -> None:
        """Every state at its start."""
        self.values = {v.name: v.start for v in self.program.of(Kind.STATE)}

    def calibrate(self, raw: Mapping[str, float]) -> Mapping[str, float]:
        return self._run(self.program.calibrate, raw)

    def command(self, raw: Mapping[str, float]) -> Mapping[str, float]:
        return self._run(self.program.command, raw)

    def update(self) -> Mapping[str, float]:
        return self._run(self.program.update, {})

    def _run(self, block: Block, raw: Mapping[str, float]) -> Mapping[str, float]:
        self.values |= raw
        for statement in block.statements:
            self._do(statement)
        self.values |= {state: self.values[name] for state, name in block.commit}
        return self.values

    def _do(self, statement: Statement) -> None:
        if not isinstance(statement, Repeat):
            self.values[statement.target] = evaluate(statement, self.values)
            return
        for _ in range(statement.count):
            for step in statement.steps:
                self._do(step)
            for name, value in statement.carry:
                self.values[name] = self.values[value]


def evaluate(statement: Step, values: Mapping[str, float]) -> float:  # noqa: PLR0911 (one for each kind of statement)
    """The right side of a statement."""
    match statement:
        case Sum(_, terms, constant, low, high):
            return min(max(sum((c * values[n] for c, n in terms), constant), low), high)
        case Product(_, first, second):
            return values[first] * values[second]
        case Quotient(_, number, below):
            return _value(number, values) / values[below]
        case Limit(_, value, low, high):
            return min(max(values[value], low), high)
        case Absolute(_, value):
            return abs(values[value])
        case Whole(_, value):
            return float(math.trunc(values[value]))
        case Choose(_, left, right, then, other):
            return _value(then if values[left] < _value(right, values) else other, values)
        case Function(_, name, value):
            return _FUNCTIONS[name](values[value])
        case Fused(_, terms, products):  # here each product is rounded too
            parts = [sign * _value(first, values) * _value(second, values) for sign, first, second in products]
            return sum(parts, sum(sign * _value(value, values) for sign, value in terms))


_FUNCTIONS: Mapping[str, Callable[[float], float]] = {
    "sin": math.sin, "cos": math.cos, "sqrt": math.sqrt, "square": lambda x: x * x,
    "nearest": lambda x: float(round(x)),
}  # fmt: skip


def _value(operand: Operand, values: Mapping[str, float]) -> float:
    return values[operand] if isinstance(operand, str) else operand
