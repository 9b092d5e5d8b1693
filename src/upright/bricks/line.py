"""A pseudo terminal with a virtual brick at its other end, as a paired Bluetooth brick has one: /dev/pts/N."""

from __future__ import annotations

import math
import os
import select
import struct
import threading
import time
from types import TracebackType

from upright.bricks.lcp import VirtualBrick
from upright.errors import MissingTool

SLICE = 0.02  # [s] of the brick's time between two looks at the line
IDLE = 0.02  # [s] to wait for a telegram while no program runs


class Line:
    """`path` is what a program on this computer opens; telegrams carry their length in front, as over Bluetooth.

    The brick's time runs as fast as it can, and not beyond `until` [s].
    """

    def __init__(self, brick: VirtualBrick) -> None:
        try:
            import pty
            import tty
        except ImportError:
            raise MissingTool(
                "a virtual NXT needs a pseudo-terminal, which this system does not have",
                hint="Linux, macOS or WSL; or upright parity, which needs none",
            ) from None

        self.brick = brick
        self.until = math.inf
        self._ours, self._theirs = pty.openpty()
        tty.setraw(self._theirs)
        self.path = os.ttyname(self._theirs)
        self._lock, self._over = threading.Lock(), threading.Event()
        self._thread = threading.Thread(target=self._serve, daemon=True, name="virtual brick")

    def __enter__(self) -> Line:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._over.set()
        self._thread.join()
        self.cut()

    def cut(self) -> None:
        """Pull the cable: the next read or write fails."""
        with self._lock:
            for end in (self._ours, self._theirs):
                if end >= 0:
                    os.close(end)
            self._ours = self._theirs = -1

    def _serve(self) -> None:
        received = b""
        while not self._over.is_set():
            running = self.brick.machine is not None
            with self._lock:
                if self._ours >= 0 and select.select([self._ours], [], [], 0.0)[0]:
                    received = self._answer(received + os.read(self._ours, 4096))
                    continue
            if running:
                self._go_on()
            else:
                time.sleep(IDLE / 10)

    def _answer(self, received: bytes) -> bytes:
        """Answer every complete telegram and return the remaining bytes."""
        while len(received) >= 2:
            end = 2 + int.from_bytes(received[:2], "little")
            if len(received) < end:
                break
            reply = self.brick.telegram(received[2:end])
            received = received[end:]
            if reply:
                os.write(self._ours, struct.pack("<H", len(reply)) + reply)
        return received

    def _go_on(self) -> None:
        machine = self.brick.machine
        assert machine is not None
        self.brick.run(min(machine.time * 1e-6 + SLICE, self.until))
        if self.brick.seconds >= self.until:
            time.sleep(IDLE / 10)
