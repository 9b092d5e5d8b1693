"""Statements as C99 in float or double: constants in hexadecimal, so that nothing is rounded twice."""

from __future__ import annotations

import struct

from upright.compiled.printer import Printer
from upright.compiled.program import Kind, Program, Repeat, Variable


class CPrinter(Printer):
    """`number` is "float" or "double". States, inputs and outputs live in structures, temporaries on the stack."""

    def __init__(self, program: Program, number: str) -> None:
        self.program = program
        self.type = number
        self._single = number == "float"
        self._carried = set(program.carried())
        loops = [s for block in program.blocks for s in block.statements if isinstance(s, Repeat)]
        self._changing = {name for loop in loops for name, _ in loop.carry}

    def number(self, value: float) -> str:
        if float(value).is_integer() and abs(value) < 2**24:
            return f"{value:.1f}{'f' if self._single else ''}"
        nearest = struct.unpack("f", struct.pack("f", value))[0] if self._single else float(value)
        mantissa, _, exponent = nearest.hex().partition("p")
        return f"{mantissa.rstrip('0').rstrip('.')}p{exponent}{'f' if self._single else ''}"

    def read(self, name: str) -> str:
        return self.place(self.program.variables[name])

    def place(self, variable: Variable) -> str:
        """Where a variable lives."""
        if variable.kind is Kind.INPUT:
            return f"in->{variable.name}"
        if variable.kind is Kind.OUTPUT:
            return f"out->{variable.name}"
        return f"s->{variable.name}" if variable.kind is Kind.STATE or variable.name in self._carried else variable.name

    def write(self, name: str) -> str:
        place = self.read(name)
        return place if "->" in place else f"{'' if name in self._changing else 'const '}{self.type} {name}"

    def repeat(self, loop: Repeat) -> list[str]:
        head = f"for (int pass = 0; pass < {loop.count}; pass++) {{"
        return [head, *(f"    {line}" for line in self.once(loop)), "}"]

    def whole(self, value: str) -> str:
        return f"({self.type})(int32_t){value}"

    def function(self, name: str, value: str) -> str:
        return super().function("rint" if name == "nearest" else name, value)

    def fields(self, kind: Kind) -> list[str]:
        """The members of a structure, with units."""
        members = self.program.of(kind)
        if kind is Kind.STATE:
            members += [self.program.variables[name] for name in self.program.carried()]
        return [f"{self.type} {v.name}; /* {self.note(v)} */" for v in members]

    def starts(self) -> list[str]:
        """What sets every member of the state."""
        members = [(v.name, v.start) for v in self.program.of(Kind.STATE)] + [
            (name, 0.0) for name in self.program.carried()
        ]
        return [f"s->{name} = {self.start(name, start)};" for name, start in members]

    def start(self, name: str, value: float) -> str:  # noqa: ARG002 (words in fixed point have a format each)
        """A state's first value."""
        return self.number(value)

    def note(self, variable: Variable) -> str:
        """Unit and range of a variable, for a comment."""
        return f"[{variable.unit}] {variable.low:.6g} to {variable.high:.6g}"

    def helpers(self) -> str:
        """Functions that the statements call."""
        t = self.type
        return f"static {t} limit({t} x, {t} low, {t} high)\n{{\n    return x < low ? low : x > high ? high : x;\n}}\n"
