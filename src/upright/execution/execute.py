"""Which executor runs a program: by its target, and for C by the chip."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from upright.compiled.program import Program
from upright.errors import UnknownName
from upright.execution.execute_arm import ArmExecutor
from upright.execution.execute_avr import AvrExecutor
from upright.execution.execute_nxc import NxcExecutor
from upright.execution.execute_python import PythonExecutor
from upright.execution.execute_sketch import SketchExecutor
from upright.execution.executor import Executor, HostExecutor
from upright.firmware.targets import check_time

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
