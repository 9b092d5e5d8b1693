"""A program as code of an ATmega328P (Arduino Uno and Nano), run by simavr, with its cycles counted."""

from __future__ import annotations

import struct
import subprocess
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

from upright.atomic import TemporaryFolder, write_text
from upright.compiled.program import Program
from upright.errors import MissingTool
from upright.execution.executor import FLAGS, Values, Words
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.pages import Say

CLOCK = 16e6  # [Hz]
RESET, CALIBRATE, BALANCE = 1, 2, 3
SHIMS = files("upright.execution") / "shims"
CHIP = ("-mmcu=atmega328p", f"-DF_CPU={int(CLOCK)}UL", "-Os", "-ffp-contract=off")
HEADER = Path("/usr/include/simavr/sim_avr.h")


class Chip:
    """A simulated processor that runs `binary`; `step` and `start` come from its kind.

    `worst` is the largest number of cycles that a period in balance took, `code_bytes` and `memory_bytes` what the
    program takes of flash and RAM.
    """

    where = Say("a simulated ATmega328P")

    def __init__(self, source: Path, program: Program, number: str) -> None:
        self.numbers = number
        self.worst = 0
        self._words = Words(program, number)
        self._folder = TemporaryFolder()
        folder = Path(self._folder.name)
        self._binary = folder / "balance.elf"
        self.build(source, folder)
        self.symbols = self._read_symbols()
        self._runner = _runner()[1]
        self._process: subprocess.Popen[bytes] | None = None
        self.start()

    def build(self, source: Path, folder: Path) -> None:
        """Make the binary of a source."""
        raise NotImplementedError

    def start(self) -> None:
        """Switch the processor on."""
        self._stop()
        self._process = subprocess.Popen(
            [str(self._runner), str(self._binary)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self._ready = False

    def close(self) -> None:
        self._stop()
        self._folder.cleanup()

    def write(self, name: str, data: bytes) -> None:
        """Set a variable of the program."""
        self.request("W", self.symbols[name], len(data), data=data)

    def read(self, at: int, layout: str) -> tuple[Any, ...]:
        """Numbers that stand at an address of the processor's memory."""
        size = struct.calcsize(f"<{layout}")
        return struct.unpack(f"<{layout}", self.request("R", at, size, answer=size))

    def results(self) -> dict[str, float]:
        """The program's outputs by name."""
        layout = f"{len(self._words.outputs)}{self._words.code}"
        return self._words.from_words(self.read(self.symbols["results"], layout))

    def request(self, what: str, *numbers: int, data: bytes = b"", answer: int = 0) -> bytes:
        """Ask the runner (`shims/runner.c`) for something; `answer` bytes come back."""
        process = self._process
        assert process, "start() comes first"
        assert process.stdin
        process.stdin.write(what.encode() + b"".join(struct.pack("<I", n & 0xFFFFFFFF) for n in numbers) + data)
        if not answer:
            return b""
        process.stdin.flush()
        return self.receive(answer)

    def receive(self, count: int) -> bytes:
        """That many bytes of an answer."""
        process = self._process
        assert process
        assert process.stdout
        given = process.stdout.read(count)
        if len(given) != count:
            raise ExecutionFailed("the simulated ATmega328P stopped answering")
        return given

    def _read_symbols(self) -> Mapping[str, int]:
        """Addresses in the processor's memory, or in its flash for functions, and the sizes of the program."""
        try:
            from elftools.elf.elffile import ELFFile
        except ImportError:
            raise MissingTool("elftools is not installed", hint="pip install pyelftools") from None
        with self._binary.open("rb") as stream:
            elf: Any = ELFFile(stream)
            sizes = {s.name: s["sh_size"] for s in elf.iter_sections()}
            self.code_bytes = sizes.get(".text", 0) + sizes.get(".data", 0)
            self.memory_bytes = sizes.get(".data", 0) + sizes.get(".bss", 0)
            symbols = elf.get_section_by_name(".symtab").iter_symbols()
            return {s.name: s["st_value"] & 0xFFFF for s in symbols if s.name}

    def _stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.communicate()


class AvrExecutor(Chip):
    """The C of a program."""

    def build(self, source: Path, folder: Path) -> None:
        header = source.with_suffix(".h").read_text("utf-8")
        write_text(folder / "balance.h", header)
        write_text(folder / "main.c", (SHIMS / "avr_main.c").read_text("utf-8"))
        flags = [flag for flag in FLAGS if flag != "-O2"]
        command = [tool("avr-gcc"), *flags, *CHIP, f"-I{folder}", "-o", str(self._binary)]
        run_tool([*command, str(folder / "main.c"), str(source)], source.name)

    def start(self) -> None:
        super().start()
        self._go(RESET)

    def step(self, raw: Values) -> Values:
        words = self._words.to_words(raw)
        self.write("readings", struct.pack(f"<{len(words)}{self._words.code}", *words))
        if not self._ready:
            self._go(CALIBRATE)
            self._ready = bool(self.results()["ready"])
            return {}
        self.worst = max(self.worst, self._go(BALANCE))
        return self.results()

    def _go(self, what: int) -> int:
        """Run one piece of the program and return its cycles."""
        self.write("go", bytes([what]))
        return spent(self.request("G", self.symbols["go"], answer=8))


def spent(answer: bytes) -> int:
    """The cycles in an answer; `ExecutionFailed` where the program did not come to an end."""
    (cycles,) = struct.unpack("<Q", answer)
    if cycles == 2**64 - 1:
        raise ExecutionFailed("the program hangs or crashes on the simulated ATmega328P")
    return cycles


@cache
def _runner() -> tuple[TemporaryFolder, Path]:
    """What drives simavr, built once against its library, and the folder that it lives in."""
    if not HEADER.exists():
        raise MissingTool("simavr's library is not installed", hint="apt install libsimavr-dev")
    kept = TemporaryFolder()
    source, runner = kept.path / "runner.c", kept.path / "runner"
    for name in (source.name, "board.h"):
        write_text(source.with_name(name), (SHIMS / name).read_text("utf-8"))
    include = f"-I{HEADER.parent}"  # its own headers name each other without the folder
    run_tool([tool("gcc"), "-O2", include, "-o", str(runner), str(source), "-lsimavr"], "runner.c")
    return kept, runner
