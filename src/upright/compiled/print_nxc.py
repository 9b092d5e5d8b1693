"""Statements as NXC: float variables that are all declared, and arithmetic in the brick's own operations.

nbc decides by a literal's look whether an operation is done in integers (`1000.0` counts as the integer 1000), keeps
ten decimals of it, and knows no exponents. So no literal enters a calculation here: each constant is the quotient of
two integers, moved into float variables and divided there, which gives its nearest float exactly; and sums are written
as operations between declared floats, whose type nbc cannot guess wrong.
"""

from __future__ import annotations

import math
import struct

from upright.compiled.printer import Printer
from upright.compiled.program import (
    INFINITY,
    Absolute,
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
    Sum,
    Whole,
)

TERM = "term"  # the variable of one product of a sum
LARGEST_POWER = 60  # of two: beyond it a constant is divided twice


class NxcPrinter(Printer):
    """Lines of assembler; constants are numbered in their order of appearance."""

    def __init__(self, program: Program) -> None:
        self.program = program
        self._constants: dict[float, str] = {}
        self._labels = 0
        self._texts = {block.name: self.lines(block) for block in program.blocks}

    def block(self, name: str) -> list[str]:
        """The lines of a block, the same however often it is asked for."""
        return self._texts[name]

    def number(self, value: float) -> str:
        """The variable that holds the float nearest to `value`."""
        nearest = struct.unpack("f", struct.pack("f", value))[0]
        return self._constants.setdefault(nearest, f"k{len(self._constants)}")

    def declarations(self) -> list[str]:
        """Every variable, one a line, with its unit."""
        variables = [f"float {v.name};  // [{v.unit}]" for v in self.program.variables.values()]
        return [
            *variables,
            f"float {TERM};",
            *(f"float {name};  // {value!r}" for value, name in self._constants.items()),
        ]

    def constants(self) -> list[str]:
        """Lines that give every constant its exact value: mantissa over a power of two, both whole numbers."""
        return [line for value, name in self._constants.items() for line in self._exact(name, value)]

    def starts(self) -> list[str]:
        return [f"mov {v.name}, {v.start:.0f}" for v in self.program.of(Kind.STATE)]

    def commit(self, state: str, value: str) -> list[str]:
        return [f"mov {state}, {value}"]

    def statement(self, statement: Statement) -> list[str]:  # noqa: PLR0911 (one for each kind of statement)
        match statement:
            case Repeat():
                return self.repeat(statement)
            case Sum(target, terms, constant, low, high):
                lines = self._sum(target, terms, constant)
                return lines if low == -INFINITY else [*lines, *self._limited(target, low, high)]
            case Product(target, first, second):
                return [f"mul {target}, {first}, {second}"]
            case Quotient(target, number, below):
                return [f"div {target}, {self._named(number)}, {below}"]
            case Limit(target, value, low, high):
                return [f"mov {target}, {value}", *self._limited(target, low, high)]
            case Absolute(target, value):
                skip = self._label()
                zero = self.number(0.0)
                return [
                    f"mov {target}, {value}",
                    f"brcmp GTEQ, {skip}, {value}, {zero}",
                    f"neg {target}, {value}",
                    f"{skip}:",
                ]
            case Whole(target, value):
                return [f"trunc {target}, {value}"]
            case Choose(target, left, right, then, other):
                skip = self._label()
                names = [self._named(o) for o in (right, then, other)]
                return [f"mov {target}, {names[1]}", f"brcmp LT, {skip}, {left}, {names[0]}",
                        f"mov {target}, {names[2]}", f"{skip}:"]  # fmt: skip
            case Function() | Fused():
                raise NotImplementedError(f"no program on a brick has {statement}")

    def _named(self, operand: Operand) -> str:
        return operand if isinstance(operand, str) else self.number(operand)

    def _sum(self, target: str, terms: tuple[tuple[float, str], ...], constant: float) -> list[str]:
        if not terms:
            return [f"mov {target}, {self.number(constant)}"]
        (first, name), *rest = terms
        lines = [f"mov {target}, {name}" if first == 1 else f"mul {target}, {name}, {self.number(first)}"]
        for coefficient, name in rest:
            if abs(coefficient) == 1:
                lines.append(f"{'add' if coefficient > 0 else 'sub'} {target}, {target}, {name}")
            else:
                lines.append(f"mul {TERM}, {name}, {self.number(abs(coefficient))}")
                lines.append(f"{'add' if coefficient > 0 else 'sub'} {target}, {target}, {TERM}")
        return [*lines, *([f"add {target}, {target}, {self.number(constant)}"] if constant else [])]

    def _limited(self, target: str, low: float, high: float) -> list[str]:
        below, above = self._label(), self._label()
        least, most = self.number(low), self.number(high)
        return [
            f"brcmp GTEQ, {below}, {target}, {least}", f"mov {target}, {least}", f"{below}:",
            f"brcmp LTEQ, {above}, {target}, {most}", f"mov {target}, {most}", f"{above}:",
        ]  # fmt: skip

    def _label(self) -> str:
        self._labels += 1
        return f"at{self._labels}"

    def _exact(self, name: str, value: float) -> list[str]:
        mantissa, exponent = math.frexp(value)
        whole = int(mantissa * 2**24)
        power = 24 - exponent
        while whole and not whole % 2 and power > 0:
            whole = whole // 2
            power = power - 1
        if not whole or power <= 0:
            return [f"mov {name}, {int(value)}"]
        lines = [f"mov {name}, {whole}"]
        while power > 0:
            part = min(power, LARGEST_POWER)
            lines += [f"mov {TERM}, {2**part}", f"div {name}, {name}, {TERM}"]
            power -= part
        return lines
