"""Statements as C99 in 32-bit integers with binary points of their own."""

from __future__ import annotations

import math

from upright.compiled.fixed import fractions, scaled
from upright.compiled.print_c import CPrinter
from upright.compiled.program import (
    Absolute,
    Choose,
    Function,
    Fused,
    Limit,
    Operand,
    Product,
    Program,
    Quotient,
    Step,
    Sum,
    Variable,
    Whole,
)


class FixedPrinter(CPrinter):
    """Every word is an int32_t; a comment beside it gives its binary point."""

    def __init__(self, program: Program) -> None:
        super().__init__(program, "int32_t")
        self.bits = fractions(program)

    def note(self, variable: Variable) -> str:
        bits = self.bits[variable.name]
        scale = "" if not bits else f" / {2**bits}" if bits != 16 else ", Q16.16"
        return f"{super().note(variable)}{scale}"

    def word(self, value: float, bits: int) -> str:
        """A constant in that format."""
        return str(round(value * 2.0**bits))

    def number(self, value: float) -> str:
        return self.word(value, 0)

    def start(self, name: str, value: float) -> str:
        return self.word(value, self.bits[name])

    def commit(self, state: str, value: str) -> list[str]:
        return [f"{self.read(state)} = {self.moved(value, self.bits[state])};"]

    def moved(self, name: str, bits: int) -> str:
        """A variable brought to another format."""
        shift = self.bits[name] - bits
        text = self.read(name)
        if not shift:
            return text
        return f"rounded({text}, {shift})" if shift > 0 else f"({text} * {2**-shift})"

    def right(self, statement: Step) -> str:  # noqa: PLR0911 (one for each kind of statement)
        bits = self.bits[statement.target]
        match statement:
            case Sum():
                return self._sum(statement)
            case Product(_, first, second):
                product = f"(int64_t){self.read(first)} * {self.read(second)}"
                return self._narrow(product, self.bits[first] + self.bits[second] - bits)
            case Quotient(_, number, below):
                assert not isinstance(number, str), "programs divide numbers alone"
                return f"(int32_t)((int64_t){round(number * 2.0 ** (bits + self.bits[below]))} / {self.read(below)})"
            case Limit(_, value, low, high):
                return self.limit(self.moved(value, bits), self.word(low, bits), self.word(high, bits))
            case Absolute(_, value):
                return self.absolute(self.moved(value, bits))
            case Whole(_, value):
                return f"{self.read(value)} / {2 ** self.bits[value]}"
            case Choose(_, left, right, then, other):
                test = self._test(left, right)
                return f"{test} ? {self._at(then, bits)} : {self._at(other, bits)}"
            case Function() | Fused():
                raise NotImplementedError(f"no controller in fixed point has {statement}")

    def _sum(self, statement: Sum) -> str:
        form = scaled(statement, self.program, self.bits)
        if not form.shift and [f for f, _ in form.terms] == [1] and not form.constant and self._within(statement):
            return self.read(form.terms[0][1])
        parts = [(f, f"(int64_t){abs(f)} * {self.read(n)}" if abs(f) != 1 else f"(int64_t){self.read(n)}")
                 for f, n in form.terms]  # fmt: skip
        parts += [(form.constant, f"{abs(form.constant)}")] if form.constant or not parts else []
        text = ("-" if parts[0][0] < 0 else "") + parts[0][1]
        text += "".join(f" {'-' if f < 0 else '+'} {part}" for f, part in parts[1:])
        if self._within(statement):
            return self._narrow(text, form.shift)
        bits = self.bits[statement.target]
        variable = self.program.variables[statement.target]
        return f"settled({text}, {form.shift}, {self.word(variable.low, bits)}, {self.word(variable.high, bits)})"

    def _within(self, statement: Sum) -> bool:
        """Whether interval arithmetic alone keeps the sum within its variable's range."""
        variables = self.program.variables
        target = self.program.variables[statement.target]
        most = abs(statement.constant) + sum(abs(c) * variables[n].most for c, n in statement.terms)
        return most <= target.most * (1 + 1e-12) and statement.low == -float("inf")

    def _narrow(self, text: str, shift: int) -> str:
        if shift < 0:
            return f"(int32_t)(({text}) * {2**-shift})"
        return f"(int32_t)({text})" if not shift else f"rounded({text}, {shift})"

    def _test(self, left: str, right: Operand) -> str:
        """Both sides of a comparison at the finer of their formats, which 64 bits hold."""
        if not isinstance(right, str):
            return f"{self.read(left)} < {math.ceil(right * 2.0 ** self.bits[left])}"  # whole numbers: x < 0.5 is x < 1
        shift = self.bits[left] - self.bits[right]
        sides = [self.read(left), self.read(right)]
        if shift:
            finer = 1 if shift > 0 else 0
            sides[finer] = f"(int64_t){sides[finer]} * {2 ** abs(shift)}"
        return f"{sides[0]} < {sides[1]}"

    def _at(self, operand: Operand, bits: int) -> str:
        return self.moved(operand, bits) if isinstance(operand, str) else self.word(operand, bits)

    def helpers(self) -> str:
        return HELPERS


HELPERS = """\
/* The shift below must keep the sign, as on every compiler in use: if not, this line does not compile. */
typedef char arithmetic_shift[(-1 >> 1) == -1 ? 1 : -1];

/* x / 2^shift, to the nearest */
static int32_t rounded(int64_t x, int shift)
{
    return (int32_t)((x + ((int64_t)1 << (shift - 1))) >> shift);
}

static int32_t limit(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : x > high ? high : x;
}

/* x / 2^shift, to the nearest and within [low, high] */
static int32_t settled(int64_t x, int shift, int32_t low, int32_t high)
{
    const int64_t near = shift ? (x + ((int64_t)1 << (shift - 1))) >> shift : x;
    return near < low ? low : near > high ? high : (int32_t)near;
}
"""
