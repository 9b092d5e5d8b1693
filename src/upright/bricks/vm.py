"""The brick's own machine: runs the bytecode of an .rxe, one task with its subroutines, as enhanced firmware 1.28 does.

Every instruction is made a closure once. Where the brick's manual leaves open what happens (a fraction stored in an
integer, a division by zero, an index beyond the end), the machine raises `InvalidProgram`, since a program must not
depend on it.
"""

from __future__ import annotations

from upright.bricks.brick import Hardware
from upright.bricks.processor import Processor
from upright.bricks.rxe import Executable, InvalidProgram
from upright.bricks.vm_instructions import END, INSTRUCTIONS, Step


class Machine(Processor):
    """Runs `program` with `devices`. An instruction takes `cost` [µs]; `executed` counts instructions."""

    def __init__(self, program: Executable, devices: Hardware, cost: int) -> None:
        super().__init__(program, devices)
        self.cost = cost
        self.executed = 0
        self._steps: dict[int, tuple[Step, int]] = {}
        self._at = program.clumps[0]

    @property
    def ended(self) -> bool:
        return self._at == END

    def run(self, until: int) -> None:
        """Run until the program ends or `time` reaches `until` [µs]."""
        steps = self._steps
        while self._at != END and self.time < until:
            decoded = steps.get(self._at)
            if decoded is None:
                decoded = steps[self._at] = self._decode(self._at)
            self.time += self.cost
            self.executed += 1
            jump = decoded[0]()
            self._at = decoded[1] if jump is None else jump
        self.devices.reach(min(self.time, until))

    def _decode(self, at: int) -> tuple[Step, int]:
        """The step of the instruction at that word, and where the next one stands."""
        code = self.program.decode(at)
        if code.number not in INSTRUCTIONS:
            raise InvalidProgram(f"the program uses instruction 0x{code.number:02x}", expected="what a balancer needs")
        return INSTRUCTIONS[code.number](self, code), at + code.length
