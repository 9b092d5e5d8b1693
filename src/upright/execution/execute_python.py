"""Python programs run as they stand: Pybricks' in MicroPython, ev3dev's in CPython, among stand-ins for its modules."""

from __future__ import annotations

from pathlib import Path

from upright.atomic import write_text
from upright.bricks.script import READINGS, Script
from upright.compiled.program import Program
from upright.execution.executor import Values
from upright.firmware.tools import ExecutionFailed, run_tool, tool


class PythonExecutor:
    """A program, one period a step. With `compiled`, MicroPython runs the .mpy that `mpy-cross` makes of it; `pressed`
    is whether the brick's button is down, `duties` [%] what its motors got last."""

    def __init__(self, source: Path, program: Program, compiled: bool = False) -> None:
        self._names = program.results()
        micro = program.target == "pybricks"
        made = ".mpy by mpy-cross, " if compiled else ""
        self.where = f"MicroPython ({made}floats of 64 bits; a hub's have 32)" if micro else "CPython"
        self.numbers = "double"
        self.pressed = False
        self.duties = (0.0, 0.0)
        self._script = Script(program.target)
        copy = self._script.folder / "balance.py"
        write_text(copy, source.read_text("utf-8"))
        if compiled:
            run_tool([tool("mpy-cross"), "-o", str(copy.with_suffix(".mpy")), str(copy)], source.name)
            copy.unlink()

    @property
    def lines(self) -> list[str]:
        """The program's output."""
        return self._script.lines

    def start(self) -> None:
        self._script.start()

    def step(self, raw: Values) -> Values:
        reply = self._script.exchange([raw[name] for name in READINGS], self.pressed)
        if reply is None:
            raise ExecutionFailed(f"the program ended: {self.lines[-1] if self.lines else 'without output'}")
        self.duties = reply.duties or (0.0, 0.0)
        return dict(zip(self._names, reply.row, strict=True)) if reply.row else {}

    def signal(self, number: int) -> None:
        """Send the program a signal of the system, as a terminal that hangs up does."""
        self._script.signal(number)

    def finish(self) -> list[str]:
        """Press the button and return the program's output, its log last."""
        resting = [0.0, 0.0, 0.0, 8000.0]
        while self._script.exchange(resting, pressed=True):
            pass
        return self.lines

    def close(self) -> None:
        self._script.close()
