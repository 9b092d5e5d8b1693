"""Where the lab is served, to whom, and how it starts and ends."""

from __future__ import annotations

import contextlib
import errno
import gc
import ipaddress
import logging
import socket
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from upright.errors import UprightError
from upright.lab.classroom import Door
from upright.lab.codec import LARGEST
from upright.lab.connections import WAITING, Book, files, protocols
from upright.lab.desk import MODEST
from upright.lab.hub import Hub
from upright.lab.recording import page_text
from upright.lab.stage import Options
from upright.lab.stage_process import StageProcess

LOOPBACK = "127.0.0.1"
PORT = 8765
ALONE = Options(rate=50.0)
CLASS = Options(rate=36.0, coarse=True, certified=False, longest=0.5, modest=MODEST)
CLASS_STAGES = 2  # processes among which thirty robots are shared


@dataclass
class Lab:
    """What is served where: `host` and `port` are the stated address, `door` decides who comes in."""

    host: str = LOOPBACK
    port: int = PORT
    door: Door = field(default_factory=Door)

    @property
    def url(self) -> str:
        """The page's address, with the students' token in a class."""
        return f"http://{self.host}:{self.port}/" + (f"#token={self.door.students}" if self.door.is_class else "")

    @property
    def teacher_url(self) -> str:
        """The teacher's address."""
        return f"http://{self.host}:{self.port}/#token={self.door.teacher}"

    @property
    def hosts(self) -> set[str]:
        """What a browser may call this server: anything else is another site's name for it."""
        names = {self.host} | ({LOOPBACK, "localhost", "[::1]"} if self.host == LOOPBACK else set())
        return {f"{name}:{self.port}" for name in names} | (names if self.port == 80 else set())

    def foreign(self, host: str | None, origin: str | None) -> bool:
        """Whether a request comes from another site. Programs, which are no browsers, send no origin."""
        return host not in self.hosts or (origin is not None and origin.removeprefix("http://") not in self.hosts)


def reachable(host: str) -> str:
    """The address `host` of this machine, as a browser writes it; raises an `UprightError` for one that students cannot
    reach, and for all of this machine's at once, however they are written."""
    try:
        address = ipaddress.IPv4Address(socket.gethostbyname(host.strip()))
    except (OSError, ValueError, TypeError):  # no such name, and what cannot be one
        address = ipaddress.IPv4Address(0)
    if address.is_unspecified or address.is_loopback or address.is_multicast or address.is_reserved:
        raise UprightError(
            f"--class at {host[:60]!r}", expected="one address of this machine that students can reach",
            hint="--class --host ADDRESS, this machine's in the network",
        )  # fmt: skip
    named = any(letter.isalpha() for letter in host.rpartition(".")[2]) and not host.lower().startswith("0x")
    return host.strip().lower() if named else str(address)


def own_address() -> str:
    """The address that this machine has in its network; the loopback's where there is none. Nothing is sent."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # an address kept for documents (RFC 5737): only the way there is looked up
        except OSError:
            return LOOPBACK
        return str(probe.getsockname()[0])


def listening(lab: Lab) -> socket.socket:
    """A socket on the lab's address; port 0 takes any that is free and notes it. Raises an `UprightError`."""
    made = socket.socket(socket.AF_INET, socket.SOCK_STREAM)
    made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        made.bind((lab.host, lab.port))
    except OSError as error:
        made.close()
        taken = error.errno == errno.EADDRINUSE
        raise UprightError(
            f"cannot serve on {lab.host}:{lab.port}: {error.strerror}",
            likely="another lab that runs there" if taken else "",
            hint=f"--port {lab.port + 1}" if taken else "look at --host and --port again",
        ) from None
    lab.port = made.getsockname()[1]
    return made


def serve(lab: Lab, sock: socket.socket, ready: Callable[[], None] | None = None) -> None:
    """Serve until Ctrl-C; `ready` is called when pages are answered."""
    page_text()  # a checkout without a built page fails before anything runs
    options, count = (CLASS, CLASS_STAGES) if lab.door.is_class else (ALONE, 1)
    hub = Hub(lab.door, [StageProcess(options) for _ in range(count)])
    try:
        server = server_of(lab, hub)
        if ready:
            server.startup = _then(server.startup, ready)
        gc.freeze()  # what is there now stays: a search among all of it would hold up every page
        with contextlib.suppress(KeyboardInterrupt):  # Ctrl-C is how a lab ends
            server.run(sockets=[sock])
    finally:
        hub.close()


def server_of(lab: Lab, hub: Hub) -> Any:
    """The web server round a hub, with its limits on connections."""
    import uvicorn

    from upright.lab.app import application

    logging.getLogger("asyncio").setLevel(logging.CRITICAL)  # it warns of every client that went
    book = Book(files())
    requests, sockets = protocols(book)
    config = uvicorn.Config(
        application(lab.foreign, hub, book), http=requests, ws=sockets, log_level="critical", access_log=False,
        ws_max_size=LARGEST, ws_per_message_deflate=False, lifespan="on", timeout_graceful_shutdown=1,
        server_header=False, proxy_headers=False, backlog=WAITING,
    )  # fmt: skip
    return uvicorn.Server(config)


def _then(startup: Any, ready: Callable[[], None]) -> Any:
    async def both(*args: Any, **options: Any) -> None:
        await startup(*args, **options)
        ready()

    return both
