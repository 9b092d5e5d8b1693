"""NXC programs run as the brick runs them: compiled by nbc, executed bytecode by bytecode."""

from __future__ import annotations

from pathlib import Path

from upright.atomic import TemporaryFolder
from upright.bricks.brick import Hardware, set_readings
from upright.bricks.rxe import Executable, read_rxe
from upright.bricks.vm import Machine
from upright.compiled.program import Program
from upright.execution.executor import Values
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.firmware.wiring import nxt_wiring
from upright.pages import Say

COST = 1  # [µs] an instruction takes here; how many there are in a period is what is reported
LOOK = 100  # [µs] from one look at whether the program has come to rest to the next
LONGEST_PERIOD = 1_000_000  # [µs] after which a program that does not rest has lost its way

NBC = ("-EF", "-v=128", "-sm-")
"""Enhanced firmware 1.28, and no chatter."""


def compile_nxc(source: Path, folder: Path) -> Path:
    """The .rxe that nbc makes of NXC, in `folder` with the table of its variables; raises like `run_tool`."""
    made = folder / "balance.rxe"
    run_tool([tool("nbc"), *NBC, f"-O={made}", f"-Y={made.with_suffix('.sym')}", str(source)], source.name)
    return made


def compiled(source: Path, folder: Path) -> tuple[Executable, dict[str, int]]:
    """The compiled program and the number of each of its variables."""
    made = compile_nxc(source, folder)
    return read_rxe(made), _symbols(made.with_suffix(".sym").read_text("ascii", "replace"))


class NxcExecutor:
    """A program of the brick in the brick's own machine, one period a step; `instructions` is the most in a period."""

    def __init__(self, source: Path, program: Program) -> None:
        self.where = Say("the NXT's bytecode machine (nbc)")
        self.numbers = "float"
        self.instructions = 0
        self._program = program
        self.wiring = nxt_wiring(source.read_text("utf-8"))
        with TemporaryFolder() as folder:
            self._executable, self._names = compiled(source, Path(folder))
        missing = [name for name in (*program.results(), "ready") if name not in self._names]
        if missing:
            raise ExecutionFailed(f"the compiled program has no variable {missing[0]}")

    def start(self) -> None:
        self.hardware = Hardware()
        self._machine = Machine(self._executable, self.hardware, COST)

    def step(self, raw: Values) -> Values:
        readings = {channel: raw[name] for name, channel in self._program.channels.items()}
        set_readings(self.hardware, readings, self.wiring)
        calibrated = self._read("ready")
        before = self._machine.executed
        self._until_it_rests()
        if not calibrated:
            return {}
        self.instructions = max(self.instructions, self._machine.executed - before)
        return {name: self._read(name) for name in self._program.results()}

    def close(self) -> None:
        """Nothing is left behind."""

    def _until_it_rests(self) -> None:
        machine = self._machine
        began = self._machine.time
        naps = self._machine.naps
        while machine.naps == naps and not machine.ended:
            machine.run(machine.time + LOOK)
            if machine.time - began > LONGEST_PERIOD:
                raise ExecutionFailed(f"the program does not wait for the next period after {machine.executed} steps")

    def _read(self, name: str) -> float:
        value = self._machine.cells[self._names[name]]
        assert isinstance(value, int | float)
        return float(value)


def _symbols(text: str) -> dict[str, int]:
    """Name → number from the table that nbc writes: number and name in the first two columns."""
    numbers: dict[str, int] = {}
    for line in text.splitlines():
        if line.startswith("#") and numbers:
            break  # the code follows
        columns = line.split("\t")
        if len(columns) >= 3 and columns[0].isdigit():
            numbers[columns[1]] = int(columns[0])
    return numbers
