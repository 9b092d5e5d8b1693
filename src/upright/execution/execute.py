"""Which executor runs a program: by its target, and for C by the chip; and the one of Python programs."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from upright.atomic import write_text
from upright.bricks.script import READINGS, Script
from upright.compiled.program import Program
from upright.errors import UnknownName
from upright.execution.execute_arm import ArmExecutor
from upright.execution.execute_avr import AvrExecutor
from upright.execution.execute_nxc import NxcExecutor
from upright.execution.execute_sketch import SketchExecutor
from upright.execution.executor import Executor, HostExecutor, Values
from upright.firmware.targets import check_time
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.pages import Say


class PythonExecutor:
    """A program as it stands, one period a step: Pybricks' in MicroPython, ev3dev's in CPython, among the stand-ins of
    its `script`. With `compiled`, MicroPython runs the .mpy that `mpy-cross` makes of it; `duties` [%] are what its
    motors got last."""

    def __init__(self, source: Path, program: Program, compiled: bool = False) -> None:
        self._names = program.results()
        micro = program.target == "pybricks"
        self.where = Say("CPython")
        if micro:
            self.where = Say("MicroPython (floats of 64 bits; a hub's have 32)")
        if micro and compiled:
            self.where = Say("MicroPython (.mpy by mpy-cross, floats of 64 bits; a hub's have 32)")
        self.numbers = "double"
        self.duties = (0.0, 0.0)
        self.script = Script(program.target)
        copy = self.script.folder / "balance.py"
        write_text(copy, source.read_text("utf-8"))
        if compiled:
            run_tool([tool("mpy-cross"), "-o", str(copy.with_suffix(".mpy")), str(copy)], source.name)
            copy.unlink()

    def start(self) -> None:
        self.script.start()

    def step(self, raw: Values) -> Values:
        reply = self.script.exchange([raw[name] for name in READINGS])
        if reply is None:
            raise ExecutionFailed(f"the program ended: {' '.join(self.script.lines[-1:]) or 'without output'}")
        self.duties = reply.duties or (0.0, 0.0)
        return dict(zip(self._names, reply.row, strict=True)) if reply.row else {}

    def close(self) -> None:
        self.script.close()


Maker = Callable[[Path, Program, str], Executor]
"""From a program's file, its representation and its arithmetic to what runs it."""

EXECUTORS: dict[str, dict[str, Maker]] = {
    "c": {"host": HostExecutor, "arm7": ArmExecutor, "avr": AvrExecutor},
    "arduino": {"avr": SketchExecutor},
    "pybricks": {
        "micropython": lambda source, program, _: PythonExecutor(source, program),
        "mpy": lambda source, program, _: PythonExecutor(source, program, compiled=True),
    },
    "ev3dev": {"cpython": lambda source, program, _: PythonExecutor(source, program)},
    "nxc": {"nxt": lambda source, program, _: NxcExecutor(source, program)},
}
"""Target → chip or interpreter → what runs its programs, the usual one first."""


def execute(source: Path, program: Program, number: str, chip: str = "") -> Executor:
    """What runs that file; `UnknownName` for a chip the target does not run on, `InvalidController` for one that is
    too slow, `MissingTool` for an absent tool."""
    known = EXECUTORS[program.target]
    name = chip or next(iter(known))
    if name not in known:
        raise UnknownName(f"chip for {program.target}", name, known)
    check_time(program, name)
    return known[name](source, program, number)
