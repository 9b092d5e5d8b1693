"""The server's side of a stage's process."""

from __future__ import annotations

import asyncio
import contextlib
import os
import queue
import signal
import threading
import time
from collections.abc import Callable, Sequence
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from typing import Any

from upright.interrupts import without_ctrl_c
from upright.lab.stage import Options, perform

Words = Sequence[tuple[str, str, Any]]

MOST_WORDS = 2000  # that wait for a stage; students' messages beyond it are not passed on
SILENT, STARTING = 10, 120  # [s] after which a stage that says nothing is replaced: it speaks four times a second
HOPELESS = 2.0  # [s] of life of a stage that cannot start


class StageProcess:
    """The server's side of a stage's process: words go into a pipe, and a thread drains what comes back. A process that
    dies, or says nothing for long, is replaced by another."""

    def __init__(self, options: Options) -> None:
        self._options = options
        self._closing = False
        self._lock = threading.Lock()
        self._begin(lambda: None)

    def _begin(self, ready: Callable[[], Any]) -> None:
        """Begin a process; `ready` is called as soon as words to it are kept, which is before it starts."""
        context = get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._words: queue.SimpleQueue[tuple[Any, ...] | None] = queue.SimpleQueue()
        ready()
        self._at_work = context.RawArray("c", 64)
        self._process = context.Process(target=perform, args=(theirs, self._options, self._at_work))
        with without_ctrl_c():
            self._process.start()
        theirs.close()
        self._silent = 0
        self._began = time.monotonic()
        self._greeted = False
        threading.Thread(target=self._talk, args=(self._pipe, self._words), daemon=True).start()

    def listen(
        self, loop: asyncio.AbstractEventLoop, receive: Callable[[Words], None], lost: Callable[[str], None]
    ) -> None:
        """Hand everything the stage says to `receive` on the event loop, and to `lost` where it died."""

        def drain() -> None:
            with contextlib.suppress(RuntimeError):  # the loop has ended
                while not self._closing:
                    with contextlib.suppress(EOFError, OSError):
                        while True:
                            words = self._pipe.recv()
                            self._silent, self._greeted = 0, True
                            loop.call_soon_threadsafe(receive, words)
                    self._replaced(loop, lost)

        threading.Thread(target=drain, daemon=True).start()

    def say(self, *word: Any) -> None:
        """A word to the stage, which listens between its ticks; this returns at once."""
        if word[0] != "message" or self._words.qsize() < MOST_WORDS:
            self._words.put(word)

    def check(self) -> None:
        """To be called every second: a stage that has been silent for too long is killed, which has it replaced."""
        self._silent += 1
        if self._silent > (SILENT if self._greeted else STARTING):
            _kill(self._process)

    def close(self) -> None:
        """End the process."""
        with self._lock:
            self._closing = True
        self._words.put(("quit", ""))
        self._words.put(None)
        self._process.join(3.0)
        _kill(self._process)
        self._pipe.close()

    def _replaced(self, loop: asyncio.AbstractEventLoop, lost: Callable[[str], None]) -> None:
        """Begin another process in the place of one that is gone."""
        culprit = self._at_work.value.decode()
        if time.monotonic() - self._began < HOPELESS:
            time.sleep(1.0)  # it cannot even start: no use to hurry
        with self._lock:
            if not self._closing:
                self._words.put(None)
                self._pipe.close()
                _kill(self._process)
                self._begin(lambda: loop.call_soon_threadsafe(lost, culprit))

    def _talk(self, pipe: Connection, words: queue.SimpleQueue[tuple[Any, ...] | None]) -> None:
        with contextlib.suppress(OSError):
            while (word := words.get()) is not None:
                pipe.send(word)


def _kill(process: BaseProcess) -> None:
    """End a stage with the jobs of its desk, which are of its process group."""
    if hasattr(os, "killpg") and process.pid:
        with contextlib.suppress(OSError):
            os.killpg(process.pid, signal.SIGKILL)
    process.kill()
    process.join(1.0)
