"""The connection to an NXT brick: requests to the process that talks to it, each with a time limit."""

from __future__ import annotations

import base64
import json
import queue
import subprocess
import sys
import threading
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

from upright.errors import UprightError, require

SEARCH = 30.0  # [s] to find a brick: the process that looks for it must begin first, on a busy machine too
PATIENCE = 10.0  # [s] for an answer; a file of 30 kB takes 3 s over Bluetooth
REST = 600  # what HiTechnic's gyro reads at rest, as programs take it
GYRO, COMPASS, LEFT, RIGHT = 0, 1, 2, 1  # the ports: S1, S2, OUT_C, OUT_B, as in generated programs
GYRO_KIND = 6  # the sensor type that HiTechnic's gyro is read with: active, as a light sensor


@dataclass(frozen=True)
class Wiring:
    """The ports that a program uses, as generated ones do by default, and the sign with which it reads the gyro."""

    left: int = LEFT
    right: int = RIGHT
    gyro: int = GYRO
    compass: int = COMPASS
    gyro_sign: int = 1


class BrickLost(UprightError):
    """A brick that cannot be reached, or no longer answers."""


class BrickRefused(UprightError):
    """A brick that refuses a request."""


class Connection:
    """A brick at `port`: usb, or the path of a device. Raises `BrickLost`, `BrickRefused` or `MissingTool`."""

    def __init__(self, port: str, patience: float = PATIENCE) -> None:
        require("an NXT", "nxt")
        self._port, self._patience = port, patience
        self.connect()

    def connect(self) -> None:
        """Find the brick, by a new process: whatever was left on the line is not taken for an answer."""
        self._asked = 0
        self._process = subprocess.Popen(
            [sys.executable, str(Path(__file__).with_name("nxt_process.py")), self._port],
            text=True, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
            start_new_session=True, creationflags=getattr(subprocess, "CREATE_NEW_PROCESS_GROUP", 0),
        )  # fmt: skip
        self._answers: queue.Queue[str] = queue.Queue()
        threading.Thread(target=self._listen, args=(self._process.stdout, self._answers), daemon=True).start()
        try:
            self._answer("find a brick", max(self._patience, SEARCH))
        except BrickRefused as error:
            self.close()
            raise BrickLost(
                f"no brick at {self._port}: {error}", likely="it is off, or the cable is out",
                hint="switch it on and plug it in; over Bluetooth name its device, such as /dev/rfcomm0",
            ) from None  # fmt: skip

    def __enter__(self) -> Connection:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def reconnect(self) -> None:
        """Find the brick again, whatever became of the line to it."""
        self.close()
        self.connect()

    def close(self) -> None:
        """End the process that holds the line."""
        self._process.kill()
        self._process.wait()

    def ask(self, request: str, **arguments: Any) -> Any:
        """One request of `nxt_process.REQUESTS`."""
        assert self._process.stdin is not None
        self._asked += 1
        try:
            self._process.stdin.write(json.dumps({"do": request, "number": self._asked, **arguments}) + "\n")
            self._process.stdin.flush()
        except (BrokenPipeError, ValueError):
            raise self._lost(request) from None
        return self._answer(request, self._patience)

    def upload(self, name: str, data: bytes) -> None:
        """Put a file on the brick, in place of one of that name."""
        self.ask("upload", name=name, data=base64.b64encode(data).decode("ascii"))

    def fetch(self, name: str) -> bytes:
        """A file of the brick; `BrickRefused` where it has none of that name."""
        return base64.b64decode(self.ask("fetch", name=name))

    @staticmethod
    def _listen(lines: IO[str], answers: queue.Queue[str]) -> None:
        for line in lines:
            answers.put(line)
        answers.put("")

    def _answer(self, request: str, patience: float) -> Any:
        """The answer to the last request: one to an earlier one, whose wait was interrupted, is left out."""
        answer: dict[str, Any] = {"number": -1}
        while answer["number"] != self._asked:
            try:
                line = self._answers.get(timeout=patience)
            except queue.Empty:
                line = ""
            if not line:
                raise self._lost(request)
            answer = json.loads(line)
        if "error" in answer:
            if answer["error"].startswith(("OSError", "struct.error", "error:", "USB")):
                raise self._lost(request)
            raise BrickRefused(f"the brick refused '{request}': {answer['error']}")
        return answer["ok"]

    def _lost(self, request: str) -> BrickLost:
        self.close()
        return BrickLost(
            f"the brick at {self._port} does not answer ({request})", likely="the cable came out, or it is off",
            hint="plug it in and switch it on; its orange button stops the program",
        )  # fmt: skip
