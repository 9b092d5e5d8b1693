"""Statements as lines of a language: the part that all languages share."""

from __future__ import annotations

from collections.abc import Sequence

from upright.compiled.program import (
    INFINITY,
    Absolute,
    Block,
    Choose,
    Function,
    Fused,
    Limit,
    Operand,
    Product,
    Quotient,
    Repeat,
    Statement,
    Step,
    Sum,
    Whole,
)


class Printer:
    """Lines of one language for blocks of statements; a language overrides what differs."""

    end = ";"

    def number(self, value: float) -> str:
        """A constant, exactly."""
        return repr(float(value))

    def read(self, name: str) -> str:
        """A variable on the right of a statement."""
        return name

    def write(self, name: str) -> str:
        """A variable on the left, declared where that is needed."""
        return name

    def lines(self, block: Block) -> list[str]:
        """Every statement, then the states' next values."""
        lines = [line for statement in block.statements for line in self.statement(statement)]
        return [*lines, *(line for state, value in block.commit for line in self.commit(state, value))]

    def commit(self, state: str, value: str) -> list[str]:
        return [f"{self.read(state)} = {self.read(value)}{self.end}"]

    def statement(self, statement: Statement) -> list[str]:
        if isinstance(statement, Repeat):
            return self.repeat(statement)
        return [f"{self.write(statement.target)} = {self.right(statement)}{self.end}"]

    def repeat(self, loop: Repeat) -> list[str]:
        """A loop, written out where the language has none."""
        return [line for _ in range(loop.count) for line in self.once(loop)]

    def once(self, loop: Repeat) -> list[str]:
        """The lines of one pass."""
        lines = [line for step in loop.steps for line in self.statement(step)]
        return [*lines, *(line for name, value in loop.carry for line in self.commit(name, value))]

    def right(self, statement: Step) -> str:  # noqa: PLR0911 (one for each kind of statement)
        """The right side of a statement as one expression."""
        match statement:
            case Sum(_, terms, constant, low, high):
                text = self.sum(terms, constant)
                return text if low == -INFINITY else self.limit(text, self.number(low), self.number(high))
            case Product(_, first, second):
                return self.product(self.read(first), self.read(second))
            case Quotient(_, number, below):
                return self.quotient(self.operand(number), self.read(below))
            case Limit(_, value, low, high):
                return self.limit(self.read(value), self.number(low), self.number(high))
            case Absolute(_, value):
                return self.absolute(self.read(value))
            case Whole(_, value):
                return self.whole(self.read(value))
            case Choose(_, left, right, then, other):
                return self.choose(self.read(left), *(self.operand(o) for o in (right, then, other)))
            case Function(_, name, value):
                return self.function(name, self.read(value))
            case Fused(_, terms, products):
                return self.fused(terms, products)

    def product(self, first: str, second: str) -> str:
        return f"{first} * {second}"

    def quotient(self, number: str, below: str) -> str:
        return f"{number} / {below}"

    def fused(self, terms: Sequence[tuple[float, Operand]], products: Sequence[tuple[float, Operand, Operand]]) -> str:
        """The equations of motion alone have such, in the kernel."""
        raise NotImplementedError

    def operand(self, operand: Operand) -> str:
        return self.read(operand) if isinstance(operand, str) else self.number(operand)

    def sum(self, terms: Sequence[tuple[float, str]], constant: float) -> str:
        """Products joined by their signs, in order, so that every target rounds alike."""
        parts = [*((c, self._times(abs(c), self.read(n))) for c, n in terms)]
        parts += [(constant, self.number(abs(constant)))] if constant or not parts else []
        first = f"-{parts[0][1]}" if parts[0][0] < 0 else parts[0][1]
        return first + "".join(f" {'-' if c < 0 else '+'} {text}" for c, text in parts[1:])

    def _times(self, size: float, name: str) -> str:
        return name if size == 1 else f"{self.number(size)} * {name}"

    def limit(self, value: str, low: str, high: str) -> str:
        return f"limit({value}, {low}, {high})"

    def absolute(self, value: str) -> str:
        return f"({value} < 0 ? -{value} : {value})"

    def whole(self, value: str) -> str:
        raise NotImplementedError

    def choose(self, left: str, right: str, then: str, other: str) -> str:
        return f"{left} < {right} ? {then} : {other}"

    def function(self, name: str, value: str) -> str:
        return self.product(value, value) if name == "square" else f"{name}({value})"
