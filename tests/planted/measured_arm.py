"""What a program costs on an ARM7TDMI without wait states: its instructions, and its cycles at most."""

from __future__ import annotations

import struct
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from upright.compiled.program import Program
from upright.execution.execute_arm import ArmExecutor
from upright.execution.executor import Values

CLOCK = 48e6  # [Hz] of the NXT


@dataclass
class Cost:
    """What one step took: `instructions` fetched and `cycles`."""

    instructions: int = 0
    cycles: int = 0


class MeasuredArm(ArmExecutor):
    """An emulated processor that counts; `worst` keeps the most expensive step."""

    def __init__(self, source: Path, program: Program, number: str) -> None:
        self.worst = Cost()
        self._step = Cost()
        self._blocks: dict[int, tuple[int, int]] = {}
        super().__init__(source, program, number)

    def step(self, raw: Values) -> Values:
        self._step = Cost()
        results = super().step(raw)
        if results:
            self.worst = max(self.worst, self._step, key=lambda cost: cost.cycles)
        return results

    def _count(self, machine: Any, address: int, size: int, data: object) -> None:
        super()._count(machine, address, size, data)
        if address not in self._blocks:
            code = struct.unpack(f"<{size // 4}I", bytes(machine.mem_read(address, size // 4 * 4)))
            self._blocks[address] = len(code), sum(map(cycles, code))
        instructions, spent = self._blocks[address]
        self._step.instructions += instructions
        self._step.cycles += spent


def cycles(word: int) -> int:  # noqa: PLR0911 (one for each kind of instruction)
    """The most that one ARM instruction takes on an ARM7TDMI with memory that never waits (ARM DDI 0029, chapter 6)."""
    kind = word >> 25 & 7
    to_pc = word >> 12 & 15 == 15
    if kind == 0 and word & 0x0F0 == 0x090:
        return _multiply(word)
    if kind == 0 and word & 0x090 == 0x090:
        return 3 if word >> 20 & 1 else 2  # half words
    if word & 0x0FFFFFF0 == 0x012FFF10:
        return 3  # bx
    if kind in (0, 1):
        by_register = kind == 0 and word >> 4 & 1
        return 1 + by_register + 2 * to_pc
    if kind in (2, 3):
        return (5 if to_pc else 3) if word >> 20 & 1 else 2
    if kind == 4:
        count = (word & 0xFFFF).bit_count()
        return count + (2 if word >> 20 & 1 else 1) + 2 * (word >> 15 & word >> 20 & 1)
    return 3  # branches


def _multiply(word: int) -> int:
    """A multiplication whose second operand fills all four bytes."""
    long, adding = word >> 23 & 1, word >> 21 & 1
    return 5 + long + adding
