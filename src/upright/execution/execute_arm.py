"""The C of a program as code of an ARM7TDMI (the NXT's processor), run by Unicorn, with its cycles counted."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from upright.atomic import TemporaryFolder
from upright.compiled.program import Program
from upright.errors import MissingTool
from upright.execution.executor import FLAGS, Values, Words
from upright.firmware.tools import ExecutionFailed, run_tool, tool

FLASH, RAM, STACK, RETURN = 0x0010_0000, 0x0020_0000, 0x0021_0000, 0x0030_0000
"""Where an AT91SAM7S256, the chip of the NXT, has its memories, and an address for functions to return to."""

CLOCK = 48e6  # [Hz] of the NXT
SAVED = 3 * 4096
LONGEST = 48_000_000  # [cycles] a second of the chip: a step that takes more does not end


@dataclass
class Cost:
    """What one step took: `instructions` fetched and `cycles` of an ARM7TDMI without wait states, at most."""

    instructions: int = 0
    cycles: int = 0


class ArmExecutor:
    """One emulated processor; `worst` keeps the most expensive step."""

    def __init__(self, source: Path, program: Program, number: str) -> None:
        self.where = "an emulated ARM7TDMI (soft float)"
        self.numbers = number
        self._words = Words(program, number)
        with TemporaryFolder() as folder:
            binary = Path(folder) / "balance.elf"
            chip = ["-mcpu=arm7tdmi", "-marm", "-ffreestanding", "-nostdlib", "-static"]
            places = [f"-Wl,-Ttext={FLASH:#x},-Tdata={RAM + SAVED:#x},-e,upright_command"]
            run_tool([tool("arm-none-eabi-gcc"), *FLAGS, *chip, *places, "-o", str(binary), str(source), "-lgcc"],
                     source.name)  # fmt: skip
            self._load(binary)
        self.worst, self._step = Cost(), Cost()
        self._blocks: dict[int, tuple[int, int]] = {}
        self._machine.hook_add(self._every_block, self._count)
        self.start()

    def _load(self, binary: Path) -> None:
        """Code and constants into flash, everything else into RAM, and where the functions stand."""
        try:
            import unicorn
            from elftools.elf.elffile import ELFFile
        except ImportError as error:
            raise MissingTool(f"{error.name} is not installed", hint="pip install unicorn pyelftools") from None
        emulator: Any = unicorn
        machine = emulator.Uc(emulator.UC_ARCH_ARM, emulator.UC_MODE_ARM)
        machine.mem_map(FLASH, 0x4_0000)
        machine.mem_map(RAM, 0x1_0000)
        machine.mem_map(RETURN, 0x1000)
        with binary.open("rb") as stream:
            elf: Any = ELFFile(stream)
            sections = [s for s in elf.iter_sections() if s["sh_flags"] & 2 and s["sh_type"] == "SHT_PROGBITS"]
            for section in sections:
                machine.mem_write(section["sh_addr"], section.data())
            self.code_bytes = sum(s["sh_size"] for s in sections)
            symbols = elf.get_section_by_name(".symtab").iter_symbols()
            self._functions = {s.name: s["st_value"] for s in symbols if s.name.startswith("upright_")}
        self._machine = machine
        self._every_block = emulator.UC_HOOK_BLOCK

    def start(self) -> None:
        self._ready = False
        self._step = Cost()
        self._call("reset", (RAM,))

    def step(self, raw: Values) -> Values:
        at = RAM, RAM + SAVED // 3, RAM + 2 * SAVED // 3
        code = self._words.code
        words = self._words.to_words(raw)
        self._machine.mem_write(at[1], struct.pack(f"<{len(words)}{code}", *words))
        self._step = Cost()
        if not self._ready:
            self._call("calibrate", at)
            self._ready = bool(self._results(at[2])["ready"])
            return {}
        self._call("command", at)
        self._call("update", at)
        self.worst = max(self.worst, self._step, key=lambda cost: cost.cycles)
        return self._results(at[2])

    def close(self) -> None:
        """Nothing outlives the object."""

    def _results(self, address: int) -> dict[str, float]:
        count = len(self._words.outputs)
        data = bytes(self._machine.mem_read(address, count * self._words.bytes))
        return self._words.from_words(struct.unpack(f"<{count}{self._words.code}", data))

    def _call(self, name: str, arguments: Sequence[int]) -> None:
        import unicorn
        from unicorn import arm_const

        failed: Any = vars(unicorn)["UcError"]

        registers = (arm_const.UC_ARM_REG_R0, arm_const.UC_ARM_REG_R1, arm_const.UC_ARM_REG_R2)
        for register, value in zip(registers, arguments, strict=False):
            self._machine.reg_write(register, value)
        self._machine.reg_write(arm_const.UC_ARM_REG_SP, STACK)
        self._machine.reg_write(arm_const.UC_ARM_REG_LR, RETURN)
        try:
            self._machine.emu_start(self._functions[f"upright_{name}"], RETURN)
        except failed as error:
            raise ExecutionFailed(f"upright_{name} crashed on the emulated ARM7TDMI: {error}") from None
        if self._step.cycles > LONGEST:
            raise ExecutionFailed(f"upright_{name} does not return within a second of the emulated ARM7TDMI")

    def _count(self, machine: Any, address: int, size: int, _: object) -> None:
        if address not in self._blocks:
            code = struct.unpack(f"<{size // 4}I", bytes(machine.mem_read(address, size // 4 * 4)))
            self._blocks[address] = len(code), sum(map(cycles, code))
        instructions, spent = self._blocks[address]
        self._step.instructions += instructions
        self._step.cycles += spent
        if self._step.cycles > LONGEST:
            machine.emu_stop()


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
