"""Connections of the server: none is held for nothing, none takes the server's time, and there are only so many.

What comes in is an HTTP request or, once upgraded, a WebSocket; `protocols` puts a book-keeper before uvicorn's two
protocols, which have no such limits of their own.
"""

from __future__ import annotations

import asyncio
import contextlib
import time
from collections import Counter
from dataclasses import dataclass, field
from typing import Any

PATIENCE = 10.0  # [s] in which a connection must make a whole request, and a socket must say Hello
MOST, FEWEST = 512, 64  # connections; two fifths of the files that the system allows, within these
WAITING = 100  # that are accepted at once: another two fifths
FILES = 4096  # that are asked of the system, which often gives 256 or 1024
BURST, STEADY = 0.1, 0.02  # [s] of processor time for reading one connection at once, and in every second
UNREAD = 4 << 20  # [bytes] that may wait to be read by a client
READ = 1 << 11  # [bytes] of a socket that are read at once, so that none holds up the others for long
ASKED, ASKING = 200.0, 5.0  # requests of one address at once (a class may come from one), and a second
BARE = 0.25  # requests that a connection counts as, before it asks for anything
FINE = 50.0  # requests that it costs an address to have had a connection cut

Address = tuple[str, int]


@dataclass
class Bucket:
    """What may be used: `most` at once, refilled by `steady` a second."""

    most: float
    steady: float
    _left: float = field(init=False)
    _since: float = field(default_factory=time.monotonic, init=False)

    def __post_init__(self) -> None:
        self._left = self.most

    def take(self, amount: float) -> bool:
        """Whether there was so much left; where there was not, nothing is left."""
        now = time.monotonic()
        left = min(self.most, self._left + self.steady * (now - self._since)) - amount
        self._left = max(left, 0.0)
        self._since = now
        return left >= 0

    def full(self) -> bool:
        """Whether it is as if nothing had ever been taken."""
        return self.take(0.0) and self._left >= self.most


@dataclass
class Book:
    """Every connection by its peer's address, the oldest first. `pages` are those that have said Hello."""

    most: int = MOST
    lines: dict[Address, asyncio.Transport] = field(default_factory=dict[Address, asyncio.Transport])
    pages: set[Address] = field(default_factory=set[Address])
    _asked: dict[str, Bucket] = field(default_factory=dict[str, Bucket])

    def came(self, address: Address, line: asyncio.Transport) -> None:
        """Note a new connection; where there is no room, the oldest of the address that has most of them goes, but no
        page."""
        if len(self.lines) >= self.most:
            idle = [other for other in self.lines if other not in self.pages]
            counts = Counter(host for host, _ in idle)
            if idle:
                self.end(max(idle, key=lambda other: counts[other[0]]))
        self.lines[address] = line
        self.asks(address, BARE)

    def asks(self, address: Address, amount: float = 1.0) -> None:
        """Count a request, or a fine; the connection is cut where its address has made too many."""
        if not self._asked.setdefault(address[0], Bucket(ASKED, ASKING)).take(amount):
            self.end(address)

    def went(self, address: Address) -> None:
        """Forget a connection."""
        self.lines.pop(address, None)
        self.pages.discard(address)

    def end(self, address: Address) -> None:
        """Cut a connection, whatever still waits to be read."""
        line = self.lines.get(address)
        self.went(address)
        if line:
            line.abort()

    def sweep(self) -> None:
        """To be called every second: cut who does not read, and forget addresses that have long been quiet."""
        for address, line in list(self.lines.items()):
            if line.is_closing() or line.get_write_buffer_size() > UNREAD:
                self.end(address)
        self._asked = {host: bucket for host, bucket in self._asked.items() if not bucket.full()}


def files() -> int:
    """How many connections the system's limit of open files allows, which is raised as far as it goes."""
    with contextlib.suppress(ImportError, OSError, ValueError):  # not on Windows, which has no such limit
        import resource

        soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        if 0 <= soft < FILES:
            soft = FILES if hard < 0 else min(hard, FILES)
            resource.setrlimit(resource.RLIMIT_NOFILE, (soft, hard))
        return max(FEWEST, min(MOST, soft * 2 // 5)) if soft >= 0 else MOST
    return MOST


def protocols(book: Book) -> tuple[type[Any], type[Any]]:
    """uvicorn's protocols for requests and for sockets, each of whose connections stands in `book`."""
    from uvicorn.protocols.http.h11_impl import H11Protocol
    from uvicorn.protocols.websockets.auto import AutoWebSocketsProtocol

    class Metered:
        """Reads a connection for a limited time."""

        def connection_made(self, transport: Any) -> None:
            self.address = transport.get_extra_info("peername")[:2]
            self._time = Bucket(BURST, STEADY)
            super().connection_made(transport)  # type: ignore[misc]

        def data_received(self, data: bytes) -> None:
            began = time.thread_time()
            super().data_received(data)  # type: ignore[misc]
            if not self._time.take(time.thread_time() - began):
                book.end(self.address)
                book.asks(self.address, FINE)

        def connection_lost(self, exc: Exception | None) -> None:
            book.went(self.address)
            super().connection_lost(exc)  # type: ignore[misc]

    class Requests(Metered, H11Protocol):
        """Requests, each of which must come whole and in time."""

        def connection_made(self, transport: Any) -> None:
            super().connection_made(transport)
            self._limit = self.loop.call_later(PATIENCE, self._expired)
            book.came(self.address, transport)

        def on_response_complete(self) -> None:
            self._limit.cancel()
            self._limit = self.loop.call_later(PATIENCE, self._expired)
            super().on_response_complete()
            book.asks(self.address)

        def _expired(self) -> None:
            asks: Any = self.cycle  # None before the first request
            if (
                asks is None or asks.response_complete
            ) and self.transport.get_protocol() is self:  # not where a socket has taken its place
                book.end(self.address)

    class Sockets(Metered, AutoWebSocketsProtocol):  # type: ignore[misc, valid-type]
        """Sockets; the application ends those that do not say Hello."""

        def connection_made(self, transport: Any) -> None:
            transport.max_size = READ  # of asyncio's own transports; others read what they read
            super().connection_made(transport)

    return Requests, Sockets
