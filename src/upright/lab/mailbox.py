"""What waits for one client: events in order, and at most the latest snapshot."""

from __future__ import annotations

import asyncio
from collections import deque
from collections.abc import Awaitable, Callable

MOST_EVENTS = 2000
"""Events that may wait for a client; one that lets more pile up is let go, since none may be dropped."""


class Mailbox:
    """A client that reads slowly delays nobody: `event` and `snapshot` return at once, whatever it does.

    A snapshot is sent only after the one before has been acknowledged; meanwhile newer ones replace it.
    """

    def __init__(self) -> None:
        self._events: deque[str] = deque()
        self._latest: dict[str, str] = {}
        self._unacknowledged = False
        self._wake = asyncio.Event()
        self.overflown = False

    def event(self, text: str) -> None:
        """Put an event at the end."""
        self.overflown |= len(self._events) >= MOST_EVENTS
        if not self.overflown:
            self._events.append(text)
        self._wake.set()

    def snapshot(self, text: str) -> None:
        """Replace the snapshot that waits."""
        self._latest["snapshot"] = text
        if not self._unacknowledged:
            self._wake.set()

    def board(self, text: str) -> None:
        """Replace the board that waits: it is sent without being acknowledged, a few times a second."""
        self._latest["board"] = text
        self._wake.set()

    def acknowledged(self) -> None:
        """The client has drawn what it was sent."""
        self._unacknowledged = False
        if self._latest:
            self._wake.set()

    @property
    def waiting(self) -> int:
        """How many messages wait."""
        return len(self._events) + len(self._latest)

    async def deliver(self, send: Callable[[str], Awaitable[None]]) -> None:
        """Send what there is, for ever; returns where too much has piled up, and raises what `send` raises."""
        while True:
            await self._wake.wait()
            self._wake.clear()
            while self._events and not self.overflown:
                await send(self._events.popleft())
            if self.overflown:
                return
            if board := self._latest.pop("board", ""):
                await send(board)
            if not self._unacknowledged and (text := self._latest.pop("snapshot", "")):
                self._unacknowledged = True
                await send(text)
