"""The server's side of a stage's process."""

from __future__ import annotations

import asyncio
import contextlib
import queue
import threading
from collections.abc import Callable, Sequence
from multiprocessing import get_context
from typing import Any, Protocol

from upright.lab.stage import Options, perform

Words = Sequence[tuple[str, str, Any]]


class StageLink(Protocol):
    """What the hub needs of a stage: words go in at once, and what it says is handed to `receive` on the event loop."""

    def listen(self, loop: asyncio.AbstractEventLoop, receive: Callable[[Words], None]) -> None: ...

    def say(self, *word: Any) -> None: ...

    def close(self) -> None: ...


class StageProcess:
    """The server's side of a stage's process: words go into a pipe, and a thread drains what comes back."""

    def __init__(self, options: Options) -> None:
        context = get_context("spawn")
        self._pipe, theirs = context.Pipe()
        self._process = context.Process(target=perform, args=(theirs, options))
        self._process.start()
        theirs.close()
        self._words: queue.SimpleQueue[tuple[Any, ...] | None] = queue.SimpleQueue()
        threading.Thread(target=self._talk, daemon=True).start()

    def listen(self, loop: asyncio.AbstractEventLoop, receive: Callable[[Words], None]) -> None:
        """Hand everything the stage says to `receive` on the event loop."""

        def drain() -> None:
            with contextlib.suppress(EOFError, OSError, RuntimeError):
                while True:
                    loop.call_soon_threadsafe(receive, self._pipe.recv())

        threading.Thread(target=drain, daemon=True).start()

    def say(self, *word: Any) -> None:
        """A word to the stage, which listens between its ticks; this returns at once."""
        self._words.put(word)

    def close(self) -> None:
        """End the process."""
        self._words.put(("quit", ""))
        self._words.put(None)
        self._process.join(3.0)
        if self._process.is_alive():
            self._process.kill()
            self._process.join(1.0)
        self._pipe.close()

    def _talk(self) -> None:
        with contextlib.suppress(OSError):
            while (word := self._words.get()) is not None:
                self._pipe.send(word)
