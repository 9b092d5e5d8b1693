"""The brick's own machine: runs the bytecode of an .rxe, one task with its subroutines, as enhanced firmware 1.28 does.

Every instruction is made a closure once. Arithmetic is the brick's: integers wrap at the width of what they are stored
in, an operation on a float is done in single precision. Where the brick's manual leaves open what happens (a fraction
stored in an integer, a division by zero, an index beyond the end), the machine stops and says so, since a
program must not depend on it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Protocol

from upright.bricks.rxe import NOTHING, Executable, InvalidProgram, Type, Value
from upright.bricks.vm_instructions import END, INSTRUCTIONS, Step, copied, holder


class Devices(Protocol):
    """What is around the machine: time, ports and the system's calls. Ports and properties are numbered as in the
    LEGO manual; `reach` brings the world to a time [µs] before anything is read or set."""

    def reach(self, time: int) -> None: ...
    def get_input(self, port: int, item: int) -> int: ...
    def set_input(self, port: int, item: int, value: int) -> None: ...
    def get_output(self, port: int, item: int) -> int: ...
    def set_output(self, ports: Sequence[int], settings: Sequence[tuple[int, int]]) -> None: ...
    def call(self, number: int, arguments: list[Value]) -> None: ...


class Machine:
    """Runs `program` with `devices`. An instruction takes `cost` [µs]: `time` [µs] goes on by it, `executed` by one.

    `naps` counts the waits."""

    def __init__(self, program: Executable, devices: Devices, cost: int) -> None:
        self.program, self.devices, self.cost = program, devices, cost
        self.cells: list[Value] = [copied(v) for v in program.values]
        self.time = self.executed = self.naps = 0
        self.returns: dict[int, int] = {}  # the variable of a subroutine's caller → where it goes on
        self._steps: dict[int, tuple[Step, int]] = {}
        self._at = program.clumps[0]

    @property
    def ended(self) -> bool:
        return self._at == END

    def run(self, until: int) -> None:
        """Go on until the program ends or `time` reaches `until` [µs]."""
        steps = self._steps
        while self._at != END and self.time < until:
            found = steps.get(self._at)
            if found is None:
                found = steps[self._at] = self._decode(self._at)
            self.time += self.cost
            self.executed += 1
            jump = found[0]()
            self._at = found[1] if jump is None else jump
        self.devices.reach(min(self.time, until))

    def now(self) -> Devices:
        """The world, brought to this moment."""
        self.devices.reach(self.time)
        return self.devices

    def sleep(self, duration: int) -> None:
        """Do nothing for that long [ms]."""
        self.time += 1000 * duration
        self.naps += 1

    def _decode(self, at: int) -> tuple[Step, int]:
        """The step of the instruction at that word, and where the next one stands."""
        code = self.program.decode(at)
        if code.number not in INSTRUCTIONS:
            raise InvalidProgram(f"the program uses instruction 0x{code.number:02x}", expected="what a balancer needs")
        return INSTRUCTIONS[code.number](self, code), at + code.length

    def store(self, index: int) -> Callable[[Any], None]:
        """What puts a number into the variable `index`, as its type holds it."""
        cells, hold = self.cells, holder(self.program.entries[index].type)
        return lambda x: cells.__setitem__(index, hold(x))

    def number(self, index: int, nothing: int = 0) -> Callable[[], Any]:
        """What reads a number from the variable `index`; `nothing` where the argument stands for no variable."""
        cells = self.cells
        return (lambda: nothing) if index == NOTHING else lambda: cells[index]

    def leaves(self, index: int) -> list[int]:
        """The variables that a cluster is made of, those of clusters in it among them."""
        if self.program.entries[index].type is not Type.CLUSTER:
            return [index]
        return [leaf for member in self.program.members(index) for leaf in self.leaves(member)]
