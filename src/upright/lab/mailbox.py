"""What waits for one client: events in order, and at most the latest snapshot."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable

MOST_EVENTS = 2000
MOST_TEXT = 4 << 20
"""Events, and their characters, that may wait for a client; one that lets more pile up is let go, since none may be
dropped."""


AHEAD = 3  # snapshots on their way: a busy server answers late, but no rarer


class Mailbox:
    """A client that reads slowly delays nobody: `event` and `snapshot` return at once, whatever it does.

    A snapshot is sent only while fewer than `AHEAD` wait to be acknowledged; meanwhile newer ones replace it.
    """

    def __init__(self) -> None:
        self._events: deque[str] = deque()
        self._latest: dict[str, str] = {}
        self._unacknowledged, self._size = 0, 0
        self._wake, self.overflown = asyncio.Event(), asyncio.Event()

    def event(self, text: str) -> None:
        """Put an event at the end."""
        self._size += len(text)
        if len(self._events) >= MOST_EVENTS or self._size > MOST_TEXT:
            self.overflown.set()
            self._events.clear()
        else:
            self._events.append(text)
        self._wake.set()

    def snapshot(self, text: str) -> None:
        """Replace the snapshot that waits."""
        self._latest["snapshot"] = text
        if self._unacknowledged < AHEAD:
            self._wake.set()

    def board(self, text: str) -> None:
        """Replace the board that waits: it is sent without being acknowledged, a few times a second."""
        self._latest["board"] = text
        self._wake.set()

    def acknowledged(self) -> None:
        """The client has drawn what it was sent."""
        self._unacknowledged = max(0, self._unacknowledged - 1)
        if self._latest:
            self._wake.set()

    async def deliver(self, send: Callable[[str], Awaitable[None]]) -> None:
        """Send what there is, for ever; returns where too much has piled up, and raises what `send` raises."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            while self._events:
                text = self._events.popleft()
                await send(text)
                self._size -= len(text)
            if self.overflown.is_set():
                return
            if board := self._latest.pop("board", ""):
                await send(board)
            if self._unacknowledged < AHEAD and (text := self._latest.pop("snapshot", "")):
                self._unacknowledged += 1
                await send(text)
