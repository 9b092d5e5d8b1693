"""Statements as LLVM's own language, for the kernel: each operation is one on a whole vector of robots.

Products and sums are rounded one by one in the order of the statement, as the C does it, so that a robot's numbers are
the same bits as those of C in double precision, on any processor and in any company. A controller's constants are no
part of the text but stand in a table: controllers with the same places of zeros have one text, and each robot may have
its own numbers. Formulas have the few constants that they are written with in their text.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from upright.compiled.generated import ROW
from upright.compiled.printer import Printer
from upright.compiled.program import Block, Repeat

_INTRINSICS = {"nearest": "rint", "sqrt": "sqrt"}
"""Functions of a program that LLVM computes by itself, and its names for them."""

WIDTH = 8
"""Numbers in one vector: 64 bytes, which the compiler cuts into what the processor has."""

_VECTOR = f"<{WIDTH} x double>"


class RowOf(NamedTuple):
    """The row of a variable in a block, counted from the program's own first row where it is `relative`."""

    row: int
    relative: bool = False


class LanesPrinter(Printer):
    """One module with a function for each of `blocks`: (block, robots, first own row, table of constants).

    What stands for an expression is the name of the vector that holds it, after the lines that compute it.
    """

    def __init__(self, blocks: Sequence[Block], places: Mapping[str, RowOf], *, table: bool) -> None:
        """Without a `table` constants are in the text; with it `constants` are what the text found there, in order."""
        self._blocks = blocks
        self._places = places
        self._table = table
        self._lines = list[str]()
        self._names = dict[str, str]()
        self._count = 0
        self.constants = list[float]()

    def text(self) -> str:
        """The module."""
        functions = "\n".join(map(self._function, self._blocks))
        known = "\n".join(f"declare {_VECTOR} @llvm.{name}({_VECTOR})" for name in ("trunc", "rint", "fabs", "sqrt"))
        return f"{known}\n{functions}"

    def _function(self, block: Block) -> str:
        self._lines = []
        self._names = {}
        label = "loop"
        for statement in block.statements:
            if isinstance(statement, Repeat):
                label = self._repeat(statement, label)
            else:
                self._names[statement.target] = self.right(statement)
        after = [(state, self.read(value)) for state, value in block.commit]
        for name, value in [*((s.target, self._names[s.target]) for s in block.steps), *after]:
            if name in self._places:
                self._lines.append(f"store {_VECTOR} {value}, ptr {self._address(name)}, align 64")
        body = "\n  ".join(self._lines)
        return f"""define void @{block.name}(ptr %w, i64 %count, i64 %first, ptr %constants) {{
start:
  %some = icmp sgt i64 %count, 0
  %below = mul i64 %first, {ROW}
  br i1 %some, label %loop, label %end
loop:
  %i = phi i64 [0, %start], [%next, %{label}]
  %here = getelementptr double, ptr %w, i64 %i
  %own = getelementptr double, ptr %here, i64 %below
  {body}
  %next = add i64 %i, {WIDTH}
  %more = icmp slt i64 %next, %count
  br i1 %more, label %loop, label %end
end:
  ret void
}}"""

    def _repeat(self, loop: Repeat, label: str) -> str:
        """A loop over what it carries, from the block `label` to the one whose name it returns."""
        self._count += 1
        here, then = f"repeat{self._count}", f"after{self._count}"
        first = {name: self.read(name) for name, _ in loop.carry}
        self._lines.append(f"br label %{here}\n{here}:")
        top = len(self._lines)
        self._names |= {name: f"%{here}.{name}" for name in first}
        for step in loop.steps:
            self._names[step.target] = self.right(step)
        for name, value in loop.carry:
            self._names[name] = self.read(value)
        self._lines[top:top] = [
            f"%{here}.pass = phi i64 [0, %{label}], [%{here}.more, %{here}]",
            *(f"%{here}.{n} = phi {_VECTOR} [{v}, %{label}], [{self._names[n]}, %{here}]" for n, v in first.items()),
        ]
        self._lines += [
            f"%{here}.more = add i64 %{here}.pass, 1",
            f"%{here}.again = icmp slt i64 %{here}.more, {loop.count}",
            f"br i1 %{here}.again, label %{here}, label %{then}\n{then}:",
        ]
        return then

    def product(self, first: str, second: str) -> str:
        return self._let(f"fmul {_VECTOR} {first}, {second}")

    def quotient(self, number: str, below: str) -> str:
        return self._let(f"fdiv {_VECTOR} {number}, {below}")

    def sum(self, terms: Sequence[tuple[float, str]], constant: float) -> str:
        parts = [self._times(coefficient, self.read(name)) for coefficient, name in terms]
        parts += [self.number(constant)] if constant or not terms else []
        total, *rest = parts
        for part in rest:
            total = self._let(f"fadd {_VECTOR} {total}, {part}")
        return total

    def _times(self, size: float, name: str) -> str:
        if not self._table and abs(size) == 1:
            return name if size > 0 else self._let(f"fneg {_VECTOR} {name}")
        return self.product(self.number(size), name)

    def limit(self, value: str, low: str, high: str) -> str:
        return self.choose(value, low, low, self.choose(high, value, high, value))

    def absolute(self, value: str) -> str:
        return self._intrinsic("fabs", value)

    def whole(self, value: str) -> str:
        return self._intrinsic("trunc", value)

    def function(self, name: str, value: str) -> str:
        return self.product(value, value) if name == "square" else self._intrinsic(_INTRINSICS[name], value)

    def _intrinsic(self, name: str, value: str) -> str:
        return self._let(f"call {_VECTOR} @llvm.{name}({_VECTOR} {value})")

    def choose(self, left: str, right: str, then: str, other: str) -> str:
        less = self._let(f"fcmp olt {_VECTOR} {left}, {right}")
        return self._let(f"select <{WIDTH} x i1> {less}, {_VECTOR} {then}, {_VECTOR} {other}")

    def read(self, name: str) -> str:
        if name not in self._names:
            self._names[name] = self._let(f"load {_VECTOR}, ptr {self._address(name)}, align 64")
        return self._names[name]

    def _address(self, name: str) -> str:
        row, relative = self._places[name]
        start = "%own" if relative else "%here"
        return self._let(f"getelementptr double, ptr {start}, i64 {row * ROW}")

    def number(self, value: float) -> str:
        """A constant: of the table, the next one of `constants`."""
        if not self._table:
            return f"<{', '.join([f'double {_hexadecimal(value)}'] * WIDTH)}>"
        address = self._let(f"getelementptr double, ptr %constants, i64 {len(self.constants)}")
        self.constants.append(value)
        number = self._let(f"load double, ptr {address}")
        one = self._let(f"insertelement {_VECTOR} poison, double {number}, i64 0")
        return self._let(f"shufflevector {_VECTOR} {one}, {_VECTOR} poison, <{WIDTH} x i32> zeroinitializer")

    def _let(self, expression: str) -> str:
        self._count += 1
        self._lines.append(f"%v{self._count} = {expression}")
        return f"%v{self._count}"


def _hexadecimal(value: float) -> str:
    """The bits of a number, as LLVM reads constants."""
    return f"0x{struct.pack('>d', value).hex().upper()}"
