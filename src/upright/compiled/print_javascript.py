"""Equations of motion and programs as JavaScript, whose numbers are the doubles of Python and C.

All of a program lives in arrays of doubles: `z` the memory, `y` the readings in the order of the program's channels,
`r` the reference, `a` what was applied, `k` any other input, `u` the outputs, the two commands first.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from importlib import resources

from upright.compiled.electronics import FUSED_NUMBERS, GYRO_NUMBERS, SENSOR_NUMBERS, TracedFormula
from upright.compiled.printer import Printer
from upright.compiled.program import Kind, Program, Repeat
from upright.compiled.straight_line import blocks
from upright.robots import Robot
from upright.signals import STATE_NAMES


class JavaScriptStatements(Printer):
    """Every variable is a constant of its own, unless it has one of the `places`."""

    def __init__(self, places: Mapping[str, str], changing: Collection[str] = ()) -> None:
        self._places, self._changing = places, changing

    def number(self, value: float) -> str:
        """The shortest text of the double, which JavaScript reads as Python does."""
        return repr(float(value)).removesuffix(".0")

    def read(self, name: str) -> str:
        return self._places.get(name, name)

    def write(self, name: str) -> str:
        place = self.read(name)
        return place if "[" in place else f"{'let' if name in self._changing else 'const'} {name}"

    def repeat(self, loop: Repeat) -> list[str]:
        return [f"for (let pass = 0; pass < {loop.count}; pass++) {{", *self.once(loop), "}"]

    def limit(self, value: str, low: str, high: str) -> str:
        return f"Math.min(Math.max({value}, {low}), {high})"

    def absolute(self, value: str) -> str:
        return f"Math.abs({value})"

    def whole(self, value: str) -> str:
        return f"Math.trunc({value})"


class JavaScriptPrinter(JavaScriptStatements):
    """The blocks `command` and `update` of a program in SI units, as `control.law` writes them."""

    def __init__(self, program: Program) -> None:
        self.program = program
        memory = [*(v.name for v in program.of(Kind.STATE)), *program.carried()]
        inputs = [v.name for v in program.of(Kind.INPUT)]
        applied = [name for name in inputs if name.startswith("applied_")]
        known = {*program.channels, *applied, *(f"reference_{name}" for name in STATE_NAMES)}
        rows = {
            "z": memory, "y": list(program.channels), "r": [f"reference_{name}" for name in STATE_NAMES], "a": applied,
            "k": [name for name in inputs if name not in known], "u": program.results(),
        }  # fmt: skip
        rows["u"].sort(key=lambda name: not name.startswith("command_"))
        places = {name: f"{row}[{i}]" for row, names in rows.items() for i, name in enumerate(names)}
        loops = [s for block in program.blocks for s in block.statements if isinstance(s, Repeat)]
        super().__init__(places, {name for loop in loops for name, _ in loop.carry})
        self.starts = [v.start for v in program.of(Kind.STATE)] + [0.0] * len(program.carried())

    def text(self) -> str:
        """An object literal: `start`, the memory as it begins, and the functions of both blocks."""
        start = f"start: [{', '.join(map(self.number, self.starts))}]"
        blocks = (
            ("command", "z, y, r, u, k", self.program.command),
            ("update", "z, y, r, u, k, a", self.program.update),
        )
        methods = [_method(name, arguments, self.lines(block)) for name, arguments, block in blocks]
        return "{" + ",\n".join([start, *methods]) + "}"


NEAREST = """/**
 * The nearest whole number, halves to the even one.
 * @param {number} v
 */
function nearest(v) {
  const near = Math.round(v);
  return Math.abs(v % 1) === 0.5 && near % 2 ? near - 1 : near;
}
"""


def function(name: str, formula: TracedFormula) -> str:
    """An exported function of the inputs, those of a sensor by name, which writes what the formula gives into the array
    after them."""
    printer = JavaScriptStatements({})
    several = (SENSOR_NUMBERS, GYRO_NUMBERS, FUSED_NUMBERS)
    numbers = next((names for names in several if {*names} <= {*formula.inputs}), ())
    alone = [name for name in formula.inputs if name not in numbers]
    sensor = [name for name in numbers if name in formula.block.reads()]
    given = ", ".join([*alone, *(["{ " + ", ".join(sensor) + " }"] if sensor else []), "out"])
    kinds = [*(f"{n}: number" for n in alone), *(["sensor: Record<string, any>"] if sensor else [])]
    kind = f"({', '.join(kinds)}, out: Float64Array) => void"
    lines = [line for statement in formula.block.statements for line in printer.statement(statement)]
    lines += [f"out[{i}] = {value};" for i, (_, value) in enumerate(formula.block.commit)]
    body = "\n".join(f"  {line}" for line in lines)
    return f"/** @type {{{kind}}} */\nexport const {name} = ({given}) => {{\n{body}\n}};\n"


def functions() -> str:
    """The functions that a printed motion calls, for the head of its script."""
    return (resources.files("upright.compiled") / "sines.js").read_text("utf-8")


def motion(robot: Robot, model: str, period: float, substeps: int) -> str:
    """An object literal: `step(x, u, w, y)` moves the state x (6) by `period` [s] in place, under the command u (2) and
    the disturbance w (3); `read(x, u, w, y)` writes the ideal sensors into y (6), in the order of `readings`."""
    step, sensed = blocks(robot, model, period / substeps)
    printer = JavaScriptStatements({f"y{i}": f"y[{i}]" for i in range(6)})
    given = [f"const {name}{i} = {name}[{i}];" for name, size in (("u", 2), ("w", 3)) for i in range(size)]
    head = f"for (let n = 0; n < {substeps}; n++) {{" if substeps > 1 else "{"
    stored = [f"x[{i}] = x{i};" for i in range(6)]
    state = [f"x{i} = x[{i}];" for i in range(6)]
    move = [*(f"let {s}" for s in state), *given, head, *printer.lines(step), "}", *stored, "this.read(x, u, w, y);"]
    read = [*(f"const {s}" for s in state), *given, *printer.lines(sensed)]
    return "{\n" + ",\n".join(_method(n, "x, u, w, y", lines) for n, lines in (("step", move), ("read", read))) + "}"


def _method(name: str, arguments: str, lines: Sequence[str]) -> str:
    return "\n".join([f"{name}({arguments}) {{", *lines, "}"])
