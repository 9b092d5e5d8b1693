"""Statements as LLVM's own language, for the kernel: each operation is one on a whole vector of robots.

Products and sums are rounded one by one in the order of the statement, as the C does it, so that a robot's numbers are
the same bits as those of C in double precision, on any processor and in any company. Constants are no part of the text
but stand in a table: controllers with the same places of zeros have one text, and each robot may have its own numbers.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import NamedTuple

from upright.compiled.generated import ROW
from upright.compiled.program import (
    INFINITY,
    Absolute,
    Block,
    Choose,
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

WIDTHS = {"double": 8, "float": 16}
"""Numbers in one vector: 64 bytes, which the compiler cuts into what the processor has."""


class RowOf(NamedTuple):
    """The row of a variable in a block, counted from the program's own first row where it is `relative`."""

    row: int
    relative: bool = False


class LanesPrinter:
    """One module of two functions, `command` and `update`: (block, robots, first own row, table of constants)."""

    def __init__(self, program: Program, number: str, places: Mapping[str, RowOf], *, own: bool = False) -> None:
        """`number` is "double" or "float"; with `own` constants each one is a row of the block, else one number."""
        self._program, self._places, self._own = program, places, own
        self._number, self._width = number, WIDTHS[number]
        self._vector = f"<{self._width} x {number}>"
        self._lines, self._names, self._count, self._used = list[str](), dict[str, str](), 0, 0

    def text(self) -> str:
        """The module."""
        functions = "\n".join(self._function(block) for block in (self._program.command, self._program.update))
        return f"declare {self._vector} @llvm.trunc({self._vector})\n{functions}"

    def _function(self, block: Block) -> str:
        self._lines, self._names, label = [], {}, "loop"
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
            case Sum(_, terms, constant, low, _):
                value = self._sum(terms, constant)
                return value if low == -INFINITY else self._limited(value)
            case Product(_, first, second):
                return self._arithmetic("fmul", self._read(first), self._read(second))
            case Quotient(_, _, below):
                return self._arithmetic("fdiv", self._constant(), self._read(below))
            case Limit(_, value, _, _):
                return self._limited(self._read(value))
            case Absolute(_, value):
                inside = self._read(value)
                negative = self._let(f"fneg {self._vector} {inside}")
                return self._select(inside, "zeroinitializer", negative, inside)
            case Whole(_, value):
                return self._let(f"call {self._vector} @llvm.trunc({self._vector} {self._read(value)})")
            case Choose(_, left, right, then, other):
                return self._select(self._read(left), *(self._operand(o) for o in (right, then, other)))

    def _sum(self, terms: Sequence[tuple[float, str]], constant: float) -> str:
        parts = [self._arithmetic("fmul", self._constant(), self._read(name)) for _, name in terms]
        parts += [self._constant()] if constant or not terms else []
        total, *rest = parts
        for part in rest:
            total = self._arithmetic("fadd", total, part)
        return total

    def _limited(self, value: str) -> str:
        low, high = self._constant(), self._constant()
        return self._select(value, low, low, self._select(high, value, high, value))

    def _select(self, left: str, right: str, then: str, other: str) -> str:
        less = self._let(f"fcmp olt {self._vector} {left}, {right}")
        return self._let(f"select <{self._width} x i1> {less}, {self._vector} {then}, {self._vector} {other}")

    def _arithmetic(self, operation: str, first: str, second: str) -> str:
        return self._let(f"{operation} {self._vector} {first}, {second}")

    def _operand(self, operand: Operand) -> str:
        return self._read(operand) if isinstance(operand, str) else self._constant()

    def _read(self, name: str) -> str:
        if name not in self._names:
            self._names[name] = self._let(f"load {self._vector}, ptr {self._address(name)}, align 64")
        return self._names[name]

    def _address(self, name: str) -> str:
        row, relative = self._places[name]
        start = "%own" if relative else "%here"
        return self._let(f"getelementptr {self._number}, ptr {start}, i64 {row * ROW}")

    def _constant(self) -> str:
        """The next constant in the order of `constants`."""
        place = self._used * (ROW if self._own else 1)
        self._used += 1
        address = self._let(f"getelementptr {self._number}, ptr %table, i64 {place}")
        if self._own:
            return self._let(f"load {self._vector}, ptr {address}, align 64")
        value = self._let(f"load {self._number}, ptr {address}")
        one = self._let(f"insertelement {self._vector} poison, {self._number} {value}, i64 0")
        spread = f"<{self._width} x i32> zeroinitializer"
        return self._let(f"shufflevector {self._vector} {one}, {self._vector} poison, {spread}")

    def _let(self, expression: str) -> str:
        self._count += 1
        self._lines.append(f"%v{self._count} = {expression}")
        return f"%v{self._count}"


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
            yield number
        case Limit(_, _, low, high):
            yield from (low, high)
        case Choose(_, _, right, then, other):
            yield from (operand for operand in (right, then, other) if not isinstance(operand, str))
        case _:
            return
