"""Statements as Python, for MicroPython on a hub and CPython on ev3dev."""

from __future__ import annotations

from upright.compiled.printer import Printer
from upright.compiled.program import Block, Kind, Program, Repeat


class PythonStatements(Printer):
    """Every variable is a local of one function, which MicroPython reads quickest."""

    end = ""

    def repeat(self, loop: Repeat) -> list[str]:
        return [f"for _ in range({loop.count}):", *(f"    {line}" for line in self.once(loop))]

    def limit(self, value: str, low: str, high: str) -> str:
        return f"min(max({value}, {low}), {high})"

    def absolute(self, value: str) -> str:
        return f"abs({value})"

    def whole(self, value: str) -> str:
        return f"int({value})"

    def choose(self, left: str, right: str, then: str, other: str) -> str:
        return f"{then} if {left} < {right} else {other}"

    def function(self, name: str, value: str) -> str:
        return f"{value} ** 2" if name == "square" else super().function(name, value)


class PythonPrinter(PythonStatements):
    """The blocks of a program."""

    def __init__(self, program: Program) -> None:
        self.program = program

    def indented(self, block: Block, depth: int) -> str:
        """The lines of a block, the first without its indent, since a template has set it."""
        return ("\n" + " " * depth).join(self.lines(block))

    def starts(self, depth: int) -> str:
        """Every state at its start."""
        lines = [f"{v.name} = {self.number(v.start)}" for v in self.program.of(Kind.STATE)]
        return ("\n" + " " * depth).join(lines)
