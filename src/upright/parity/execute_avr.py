"""A program as code of an ATmega328P (Arduino Uno and Nano), run by simavr, with its cycles counted."""

from __future__ import annotations

import struct
import subprocess
import tempfile
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import IO, Any

from upright.compiled.program import Program
from upright.errors import MissingTool
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.parity.executor import FLAGS, Values, Words

CLOCK = 16e6  # [Hz]
FLASH, MEMORY = 32_256, 2048  # [bytes] beside the boot loader of an Uno
RESET, CALIBRATE, BALANCE = 1, 2, 3
LEFT_PWM = 5  # the pin of the sketch; the right one's is the next
HEADER = Path("/usr/include/simavr/sim_avr.h")


class AvrExecutor:
    """One simulated processor with the C of a program, or with its whole sketch among stand-ins for Arduino's core.

    `worst` is the largest number of cycles that a period in balance took, `code_bytes` and `memory_bytes` what the
    program takes of flash and RAM.
    """

    def __init__(self, source: Path, program: Program, number: str) -> None:
        self._sketch = program.target == "arduino"
        self.where, self.numbers = "a simulated ATmega328P", number
        self._words = Words(program, number)
        self._folder = tempfile.TemporaryDirectory(prefix="upright-")
        folder = Path(self._folder.name)
        self._binary = folder / "balance.elf"
        self._build(source, folder)
        self._symbols = self._read_symbols()
        self._runner = _runner(folder)
        self._process: subprocess.Popen[bytes] | None = None
        self.worst = 0
        self.start()

    def _build(self, source: Path, folder: Path) -> None:
        shims = files("upright.parity") / "shims"
        chip = ["-mmcu=atmega328p", f"-DF_CPU={int(CLOCK)}UL", "-Os", "-ffp-contract=off", "-o", str(self._binary)]
        if self._sketch:
            for name, shim in (("Arduino.h", "arduino.h"), ("Wire.h", "arduino.h"), ("main.cpp", "arduino_main.cpp")):
                (folder / name).write_text((shims / shim).read_text("utf-8"), encoding="utf-8")
            (folder / "balance.ino").write_text(source.read_text("utf-8"), encoding="utf-8")
            command = [tool("avr-g++"), "-std=gnu++11", "-Wall", "-Wextra", "-Werror", f"-I{folder}", *chip]
            run_tool([*command, str(folder / "main.cpp")], source.name)
            return
        header = source.with_suffix(".h").read_text("utf-8")
        (folder / "balance.h").write_text(header, encoding="utf-8")
        (folder / "main.c").write_text((shims / "avr_main.c").read_text("utf-8"), encoding="utf-8")
        flags = [flag for flag in FLAGS if flag != "-O2"]
        run_tool([tool("avr-gcc"), *flags, *chip, f"-I{folder}", str(folder / "main.c"), str(source)], source.name)

    def _read_symbols(self) -> Mapping[str, int]:
        """Addresses in the processor's memory, and the sizes of the program."""
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
            return {s.name: s["st_value"] & 0xFFFF for s in symbols if s["st_value"] >= 0x800000}

    def start(self) -> None:
        self._stop()
        self._process = subprocess.Popen(
            [str(self._runner), str(self._binary)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
        )  # fmt: skip
        self._go(RESET)
        self._ready = False

    def step(self, raw: Values) -> Values:
        for name, data in self._readings(raw).items():
            self._say(b"W", self._symbols[name], struct.pack("<I", len(data)) + data)
        if not self._ready:
            self._go(CALIBRATE)
            self._ready = bool(self._results()["ready"])
            return {}
        self.worst = max(self.worst, self._go(BALANCE))
        return self._results()

    def pwm(self) -> list[float]:
        """What both motors of a sketch get now, of 255 and without a sign."""
        self._say(b"R", self._symbols["stub_pwm"] + 2 * LEFT_PWM, struct.pack("<I", 4))
        return list(struct.unpack("<2h", self._hear(4)))

    def close(self) -> None:
        self._stop()
        self._folder.cleanup()

    def _readings(self, raw: Values) -> dict[str, bytes]:
        """What stands where in the processor's memory before a period."""
        if not self._sketch:
            words = self._words.to_words(raw)
            return {"readings": struct.pack(f"<{len(words)}{self._words.code}", *words)}
        sides = {f"encoder_{s}": struct.pack("<i", round(raw[f"raw_encoder_{s}"])) for s in ("left", "right")}
        others = {"stub_gyro": raw["raw_gyro"], "stub_battery": raw["raw_battery"]}
        return sides | {name: struct.pack("<h", round(value)) for name, value in others.items()}

    def _results(self) -> dict[str, float]:
        count = len(self._words.outputs)
        self._say(b"R", self._symbols["results"], struct.pack("<I", 4 * count))
        return self._words.from_words(struct.unpack(f"<{count}{self._words.code}", self._hear(4 * count)))

    def _go(self, what: int) -> int:
        """Run one piece of the program and return its cycles."""
        self._say(b"W", self._symbols["go"], struct.pack("<IB", 1, what))
        self._say(b"G", self._symbols["go"], b"")
        (cycles,) = struct.unpack("<Q", self._hear(8))
        if cycles == 2**64 - 1:
            raise ExecutionFailed("the program hangs or crashes on the simulated ATmega328P")
        return cycles

    def _say(self, what: bytes, address: int, rest: bytes) -> None:
        self._pipes()[0].write(what + struct.pack("<I", address) + rest)

    def _hear(self, count: int) -> bytes:
        given, answers = self._pipes()
        given.flush()
        data = answers.read(count)
        if len(data) != count:
            raise ExecutionFailed("the simulated ATmega328P stopped answering")
        return data

    def _pipes(self) -> tuple[IO[bytes], IO[bytes]]:
        process = self._process
        assert process, "start() comes first"
        assert process.stdin
        assert process.stdout
        return process.stdin, process.stdout

    def _stop(self) -> None:
        if self._process is not None:
            self._process.kill()
            self._process.communicate()


def _runner(folder: Path) -> Path:
    """What drives simavr, built against its library."""
    if not HEADER.exists():
        raise MissingTool("simavr's library is not installed", hint="apt install libsimavr-dev")
    source, runner = folder / "runner.c", folder / "runner"
    source.write_text((files("upright.parity") / "shims" / "runner.c").read_text("utf-8"), encoding="utf-8")
    include = f"-I{HEADER.parent}"  # its own headers name each other without the folder
    run_tool([tool("gcc"), "-O2", include, "-o", str(runner), str(source), "-lsimavr"], "runner.c")
    return runner
