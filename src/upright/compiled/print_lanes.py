"""Statements as LLVM's own language, for the kernel: each operation is one on a whole vector of robots.

Products and sums are rounded one by one in the order of the statement, as the C does it, so that a robot's numbers are
the same bits as those of C in double precision, on any processor and in any company. A controller's constants are no
part of the text but stand in a table: controllers with the same places of zeros have one text, and each robot may have
its own numbers. Formulas have the few constants that they are written with in their text.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from upright.compiled.generated import ROW
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
    Program,
    Quotient,
    Repeat,
    Step,
    Sum,
    Whole,
)

_INTRINSICS = {"whole": "trunc", "nearest": "rint", "absolute": "fabs", "sqrt": "sqrt"}
"""What LLVM computes of a number by itself, and its name for it."""

WIDTHS = {"double": 8, "float": 16}
"""Numbers in one vector: 64 bytes, which the compiler cuts into what the processor has."""


class RowOf(NamedTuple):
    """The row of a variable in a block, counted from the program's own first row where it is `relative`."""

    row: int
    relative: bool = False


class LanesPrinter:
    """One module with a function for each of `blocks`: (block, robots, first own row, table of constants)."""

    def __init__(
        self, blocks: Sequence[Block], number: str, places: Mapping[str, RowOf], *, table: bool, own: bool = False
    ) -> None:
        """`number` is "double" or "float". Without a `table` constants are in the text; with `own` constants each one
        of the table is a row of the block, else one number."""
        self._blocks, self._places, self._table, self._own = blocks, places, table, own
        self._number = number
        self._width = WIDTHS[number]
        self._vector = f"<{self._width} x {number}>"
        self._lines = list[str]()
        self._names = dict[str, str]()
        self._count = 0
        self._used = 0

    def text(self) -> str:
        """The module."""
        functions = "\n".join(map(self._function, self._blocks))
        known = "\n".join(f"declare {self._vector} @llvm.{name}({self._vector})" for name in _INTRINSICS.values())
        known += f"\ndeclare {self._vector} @llvm.fma({', '.join([self._vector] * 3)})"
        return f"{known}\n{functions}"

    def _function(self, block: Block) -> str:
        self._lines = []
        self._names = {}
        label = "loop"
        for statement in block.statements:
            if isinstance(statement, Repeat):
                label = self._repeat(statement, label)
            else:
                self._names[statement.target] = self._right(statement)
        after = [(state, self._read(value)) for state, value in block.commit]
        for name, value in [*((s.target, self._names[s.target]) for s in block.steps), *after]:
            if name in self._places:
                self._lines.append(f"store {self._vector} {value}, ptr {self._address(name)}, align 64")
        body = "\n  ".join(self._lines)
        return f"""define void @{block.name}(ptr %w, i64 %count, i64 %first, ptr %constants) {{
start:
  %some = icmp sgt i64 %count, 0
  %below = mul i64 %first, {ROW}
  br i1 %some, label %loop, label %end
loop:
  %i = phi i64 [0, %start], [%next, %{label}]
  %here = getelementptr {self._number}, ptr %w, i64 %i
  %own = getelementptr {self._number}, ptr %here, i64 %below
  %table = getelementptr {self._number}, ptr %constants, i64 {"%i" if self._own else 0}
  {body}
  %next = add i64 %i, {self._width}
  %more = icmp slt i64 %next, %count
  br i1 %more, label %loop, label %end
end:
  ret void
}}"""

    def _repeat(self, loop: Repeat, label: str) -> str:
        """A loop over what it carries, from the block `label` to the one whose name it returns."""
        self._count += 1
        here, then = f"repeat{self._count}", f"after{self._count}"
        first = {name: self._read(name) for name, _ in loop.carry}
        self._lines.append(f"br label %{here}\n{here}:")
        top = len(self._lines)
        self._names |= {name: f"%{here}.{name}" for name in first}
        for step in loop.steps:
            self._names[step.target] = self._right(step)
        for name, value in loop.carry:
            self._names[name] = self._read(value)
        self._lines[top:top] = [
            f"%{here}.pass = phi i64 [0, %{label}], [%{here}.more, %{here}]",
            *(
                f"%{here}.{n} = phi {self._vector} [{v}, %{label}], [{self._names[n]}, %{here}]"
                for n, v in first.items()
            ),
        ]
        self._lines += [
            f"%{here}.more = add i64 %{here}.pass, 1",
            f"%{here}.again = icmp slt i64 %{here}.more, {loop.count}",
            f"br i1 %{here}.again, label %{here}, label %{then}\n{then}:",
        ]
        return then

    def _right(self, statement: Step) -> str:  # noqa: PLR0911 (one for each kind of statement)
        """The name of the vector that holds the right side."""
        match statement:
            case Sum(_, terms, constant, low, high):
                value = self._sum(terms, constant)
                return value if low == -INFINITY else self._limited(value, low, high)
            case Product(_, first, second):
                return self._arithmetic("fmul", self._read(first), self._read(second))
            case Quotient(_, number, below):
                return self._arithmetic("fdiv", self._operand(number), self._read(below))
            case Limit(_, value, low, high):
                return self._limited(self._read(value), low, high)
            case Absolute(_, value):
                return self._intrinsic("absolute", value)
            case Whole(_, value):
                return self._intrinsic("whole", value)
            case Fused(_, terms, products):
                return self._fused(terms, products)
            case Function(_, "square", value):
                return self._arithmetic("fmul", self._read(value), self._read(value))
            case Function(_, name, value):
                return self._intrinsic(name, value)
            case Choose(_, left, right, then, other):
                return self._select(self._read(left), *(self._operand(o) for o in (right, then, other)))

    def _sum(self, terms: Sequence[tuple[float, str]], constant: float) -> str:
        parts = [self._times(coefficient, self._read(name)) for coefficient, name in terms]
        parts += [self._constant(constant)] if constant or not terms else []
        total, *rest = parts
        for part in rest:
            total = self._arithmetic("fadd", total, part)
        return total

    def _fused(self, terms: Sequence[tuple[float, Operand]], products: Sequence[tuple[float, Operand, Operand]]) -> str:
        total, *rest = [self._times(sign, self._operand(value)) for sign, value in terms]
        for part in rest:
            total = self._arithmetic("fadd", total, part)
        for sign, first, second in products:
            given = (self._times(sign, self._operand(first)), self._operand(second), total)
            total = self._let(f"call {self._vector} @llvm.fma({', '.join(f'{self._vector} {v}' for v in given)})")
        return total

    def _times(self, coefficient: float, value: str) -> str:
        if not self._table and abs(coefficient) == 1:
            return value if coefficient > 0 else self._let(f"fneg {self._vector} {value}")
        return self._arithmetic("fmul", self._constant(coefficient), value)

    def _limited(self, value: str, least: float, most: float) -> str:
        low, high = self._constant(least), self._constant(most)
        return self._select(value, low, low, self._select(high, value, high, value))

    def _intrinsic(self, name: str, value: str) -> str:
        return self._let(f"call {self._vector} @llvm.{_INTRINSICS[name]}({self._vector} {self._read(value)})")

    def _select(self, left: str, right: str, then: str, other: str) -> str:
        less = self._let(f"fcmp olt {self._vector} {left}, {right}")
        return self._let(f"select <{self._width} x i1> {less}, {self._vector} {then}, {self._vector} {other}")

    def _arithmetic(self, operation: str, first: str, second: str) -> str:
        return self._let(f"{operation} {self._vector} {first}, {second}")

    def _operand(self, operand: Operand) -> str:
        return self._read(operand) if isinstance(operand, str) else self._constant(operand)

    def _read(self, name: str) -> str:
        if name not in self._names:
            self._names[name] = self._let(f"load {self._vector}, ptr {self._address(name)}, align 64")
        return self._names[name]

    def _address(self, name: str) -> str:
        row, relative = self._places[name]
        start = "%own" if relative else "%here"
        return self._let(f"getelementptr {self._number}, ptr {start}, i64 {row * ROW}")

    def _constant(self, value: float) -> str:
        """A constant: of a table, the next one in the order of `constants`."""
        if not self._table:
            return f"<{', '.join([f'{self._number} {_hexadecimal(value)}'] * self._width)}>"
        place = self._used * (ROW if self._own else 1)
        self._used += 1
        address = self._let(f"getelementptr {self._number}, ptr %table, i64 {place}")
        if self._own:
            return self._let(f"load {self._vector}, ptr {address}, align 64")
        number = self._let(f"load {self._number}, ptr {address}")
        one = self._let(f"insertelement {self._vector} poison, {self._number} {number}, i64 0")
        spread = f"<{self._width} x i32> zeroinitializer"
        return self._let(f"shufflevector {self._vector} {one}, {self._vector} poison, {spread}")

    def _let(self, expression: str) -> str:
        self._count += 1
        self._lines.append(f"%v{self._count} = {expression}")
        return f"%v{self._count}"


def _hexadecimal(value: float) -> str:
    """The bits of a number that a float holds too, as LLVM reads constants of both kinds."""
    (nearest,) = struct.unpack("f", struct.pack("f", value))
    return f"0x{struct.pack('>d', nearest).hex().upper()}"


def constants(program: Program) -> list[float]:
    """The numbers in the statements of `command` and `update`, in the order in which the text reads them."""
    return [value for block in (program.command, program.update) for step in block.steps for value in _constants(step)]


def _constants(statement: Step) -> Iterator[float]:
    match statement:
        case Sum(_, terms, constant, low, high):
            yield from (coefficient for coefficient, _ in terms)
            yield from [constant] if constant or not terms else []
            yield from [] if low == -INFINITY else [low, high]
        case Quotient(_, number, _):
            yield from [] if isinstance(number, str) else [number]
        case Limit(_, _, low, high):
            yield from (low, high)
        case Choose(_, _, right, then, other):
            yield from (operand for operand in (right, then, other) if not isinstance(operand, str))
        case _:
            return
