"""The C of a program as code of an ARM7TDMI (the NXT's processor), run by Unicorn."""

from __future__ import annotations

import struct
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from upright.atomic import TemporaryFolder
from upright.compiled.program import Program
from upright.errors import MissingTool
from upright.execution.executor import FLAGS, CExecutor
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.pages import Say

FLASH, RAM, STACK, RETURN = 0x0010_0000, 0x0020_0000, 0x0021_0000, 0x0030_0000
"""Where an AT91SAM7S256, the chip of the NXT, has its memories, and an address for functions to return to."""

PLACES = (RAM, RAM + 0x1000, RAM + 0x2000)
"""Of the program's state, its inputs and its outputs; its variables come after them."""

LONGEST_CALL = 48_000_000  # [instructions] which take an NXT a second or more: a function that takes more does not end


class ArmExecutor(CExecutor):
    """One emulated processor."""

    def __init__(self, source: Path, program: Program, number: str) -> None:
        super().__init__(program, number)
        self.where = Say("an emulated ARM7TDMI (soft float)")
        with TemporaryFolder() as folder:
            binary = Path(folder) / "balance.elf"
            chip = ["-mcpu=arm7tdmi", "-marm", "-ffreestanding", "-nostdlib", "-static"]
            places = [f"-Wl,-Ttext={FLASH:#x},-Tdata={RAM + 0x3000:#x},-e,upright_command"]
            command = [tool("arm-none-eabi-gcc"), *FLAGS, *chip, *places, "-o", str(binary), str(source), "-lgcc"]
            run_tool(command, source.name)
            self._load(binary)
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
        self._call("reset")

    def close(self) -> None:
        """Nothing outlives the object."""

    def _give(self, words: Sequence[Any]) -> None:
        self._machine.mem_write(PLACES[1], struct.pack(f"<{len(words)}{self._words.code}", *words))

    def _results(self) -> dict[str, float]:
        layout = f"<{len(self._words.outputs)}{self._words.code}"
        data = bytes(self._machine.mem_read(PLACES[2], struct.calcsize(layout)))
        return self._words.from_words(struct.unpack(layout, data))

    def _call(self, name: str) -> None:
        import unicorn
        from unicorn import arm_const

        failed: Any = vars(unicorn)["UcError"]

        registers = (arm_const.UC_ARM_REG_R0, arm_const.UC_ARM_REG_R1, arm_const.UC_ARM_REG_R2)
        for register, place in zip(registers, PLACES, strict=True):
            self._machine.reg_write(register, place)
        self._machine.reg_write(arm_const.UC_ARM_REG_SP, STACK)
        self._machine.reg_write(arm_const.UC_ARM_REG_LR, RETURN)
        self._instructions = 0
        try:
            self._machine.emu_start(self._functions[f"upright_{name}"], RETURN)
        except failed as error:
            raise ExecutionFailed(f"upright_{name} crashed on the emulated ARM7TDMI: {error}") from None
        if self._instructions > LONGEST_CALL:
            raise ExecutionFailed(f"upright_{name} does not return within a second of the emulated ARM7TDMI")

    def _count(self, machine: Any, address: int, size: int, _: object) -> None:  # noqa: ARG002 (as Unicorn calls it)
        self._instructions += size // 4
        if self._instructions > LONGEST_CALL:
            machine.emu_stop()
