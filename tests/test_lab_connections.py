"""Connections to the lab: none is held for nothing, and however many there are, a newcomer gets the page."""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from conftest import PATIENCE
from test_lab_server import HereStage
from upright.cli.main import main
from upright.lab import connections
from upright.lab.classroom import Door
from upright.lab.codec import encode
from upright.lab.hub import Hub
from upright.lab.messages import VERSION, Hello
from upright.lab.server import Lab, listening, server_of
from upright.lab.uploads import MOST_FILES, UploadRefused, receive

UPGRADE = (
    "GET /ws HTTP/1.1\r\nHost: {host}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
    "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n"
)


class Served:
    """A lab in a thread, round a stage that does nothing by itself."""

    def __init__(self) -> None:
        self.lab = Lab(port=0, door=Door())
        sock = listening(self.lab)
        self.hub = Hub(self.lab.door, [HereStage()])
        self.server = server_of(self.lab, self.hub)
        self.thread = threading.Thread(target=lambda: asyncio.run(self.server.serve(sockets=[sock])), daemon=True)
        self.thread.start()
        while not self.server.started:
            time.sleep(0.01)

    def close(self) -> None:
        self.server.should_exit = True
        self.thread.join(WAIT)
        self.hub.close()

    def connect(self, data: str = "") -> socket.socket:
        made = socket.create_connection((self.lab.host, self.lab.port), timeout=WAIT)
        made.sendall(data.format(host=f"{self.lab.host}:{self.lab.port}").encode())
        return made

    def socket(self) -> socket.socket:
        """One whose first message may follow."""
        made, head = self.connect(UPGRADE), b""
        while not head.endswith(b"\r\n\r\n"):
            head += made.recv(1)
        return made

    def page(self) -> bytes:
        """What a newcomer gets."""
        with self.connect("GET / HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n") as made:
            return made.recv(100)


WAIT = PATIENCE


@pytest.fixture
def patient(monkeypatch: Any) -> None:
    monkeypatch.setattr(connections, "PATIENCE", 0.3)


@pytest.fixture
def served(patient: None) -> Iterator[Served]:
    made = Served()
    yield made
    made.close()


def ended(sock: socket.socket, seconds: float = WAIT) -> bool:
    """Whether the server ends the connection, whatever it says before."""
    sock.settimeout(seconds)
    with contextlib.suppress(ConnectionError):
        while sock.recv(4096):
            pass
    return True


@pytest.mark.parametrize("data", [
    "", "GET / HT", "GET / HTTP/1.1\r\nHost: {host}\r\nX-Slow: 1", UPGRADE,
    "GET / HTTP/1.1\r\nHost: {host}\r\n\r\nGET /again HTTP/1.1\r\n", "\x16\x03\x01 this is TLS",
    "POST /upload/none?name=x.csv HTTP/1.1\r\nHost: {host}\r\nContent-Length: 9\r\n\r\nslow",
], ids=["nothing", "half a line", "half a head", "no hello", "half a second head", "junk", "half a body"])  # fmt: skip
def test_a_connection_that_says_nothing_whole_is_ended(served, data):
    """They were held for ever: nothing, half a request, a socket without its Hello."""
    with served.connect(data) as made:
        assert ended(made)


def test_a_page_stays(served, monkeypatch):
    """What has said Hello is kept, whether it says more or not."""
    from websockets.exceptions import WebSocketException
    from websockets.sync.client import connect

    address = f"ws://{served.lab.host}:{served.lab.port}/ws"
    for patience in (0.3, 1.0, 3.0, 10.0):  # [s] a busy machine may not say Hello in the first of them
        monkeypatch.setattr(connections, "PATIENCE", patience)
        with contextlib.suppress(WebSocketException, OSError), connect(address, open_timeout=WAIT) as made:
            made.send(encode(Hello(VERSION)))
            if "Welcome" not in str(made.recv(timeout=WAIT)):
                continue
            for _ in range(2):
                with served.connect() as idle:  # for longer than the patience with who says nothing
                    assert ended(idle)
            made.send("nonsense")
            assert "Notice" in str(made.recv(timeout=WAIT))
            return
    raise AssertionError("it was not kept")


def test_more_connections_than_there_may_be_cost_the_oldest_of_who_has_most(monkeypatch):
    monkeypatch.setattr("upright.lab.server.files", lambda: 20)
    monkeypatch.setattr(connections, "PATIENCE", WAIT)  # none ends for itself
    served = Served()
    idle = [served.connect() for _ in range(60)]
    assert b"200 OK" in served.page()
    until(lambda: sum(_open(sock) for sock in idle) <= 20)
    assert _open(idle[-1])
    for sock in idle:
        sock.close()
    served.close()


def _open(sock: socket.socket) -> bool:
    sock.setblocking(False)
    try:
        return sock.recv(1) != b""
    except BlockingIOError:
        return True
    except ConnectionError:
        return False


def test_three_hundred_idle_connections_leave_room_for_a_newcomer():
    """At the 256 files that some systems give a process: the server alone in one, without a stage."""
    program = """import resource, sys
resource.setrlimit(resource.RLIMIT_NOFILE, (256, 256))
from test_lab_connections import Served
served = Served()
print(served.lab.port, flush=True)
sys.stdin.read()
served.close()"""
    pipes: Any = dict.fromkeys(("stdin", "stdout", "stderr"), subprocess.PIPE)
    process = subprocess.Popen([sys.executable, "-c", program], text=True, cwd=Path(__file__).parent, **pipes)
    try:
        assert process.stdout
        port = int(process.stdout.readline())
        idle = [socket.create_connection(("127.0.0.1", port)) for _ in range(300)]
        with socket.create_connection(("127.0.0.1", port), timeout=WAIT) as made:
            made.sendall(f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\n\r\n".encode())
            assert b"200 OK" in made.recv(100)
        for sock in idle:
            sock.close()
    finally:
        complaints = process.communicate(timeout=WAIT)[1]  # which ends it
    assert complaints == ""


def test_a_client_that_never_reads_is_let_go(served, monkeypatch):
    """It sends messages whose answers it does not read: what waits for it is bounded."""
    monkeypatch.setattr(connections, "PATIENCE", WAIT)  # it says Hello, however slowly
    with served.socket() as made:
        made.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
        frame = bytes([0x81, 0x80 | 2, 0, 0, 0, 0]) + b"[]"
        hello = encode(Hello(VERSION)).encode()
        made.sendall(bytes([0x81, 0xFE, *len(hello).to_bytes(2, "big"), 0, 0, 0, 0]) + hello)
        until(lambda: watched(served.hub))
        with contextlib.suppress(OSError):
            for _ in range(200):
                made.sendall(frame * 50)
        until(lambda: not watched(served.hub))


def watched(hub: Hub) -> bool:
    return any(entry.clients for entry in list(hub.entries.values()))


def until(held: Callable[[], bool]) -> None:
    end = time.monotonic() + WAIT
    while not held():
        assert time.monotonic() < end
        time.sleep(0.01)


def test_pings_without_end_are_no_way_to_take_the_server_s_time(served, monkeypatch):
    """Empty frames, so many that no buffer of the system holds them: the line that sends them is cut, and for nothing
    else: there is time for its Hello."""
    monkeypatch.setattr(connections, "PATIENCE", WAIT)
    with served.socket() as made, pytest.raises(ConnectionError):  # noqa: PT012
        while True:
            made.sendall(bytes([0x89, 0x80, 0, 0, 0, 0]) * 10_000)


async def chunks(count: int) -> Any:
    for i in range(count):
        await asyncio.sleep(0)
        yield bytes([i % 256]) * 1000


def test_files_of_one_name_that_arrive_together_all_arrive(tmp_path):
    """Twelve at once: each is written whole, and one of them is what lies there."""

    async def together() -> list[Path]:
        return await asyncio.gather(*(receive(chunks(10 + i), tmp_path, "run.csv", "log") for i in range(12)))

    paths = asyncio.run(together())
    assert {path.name for path in paths} == {"in-run.csv"}
    assert [p.name for p in tmp_path.iterdir()] == ["in-run.csv"]
    assert paths[0].stat().st_size in {1000 * (10 + i) for i in range(12)}


def test_files_that_arrive_together_are_no_more_than_there_may_be(tmp_path):
    async def together() -> list[Any]:
        coming = (receive(chunks(3), tmp_path, f"run{i}.csv", "log") for i in range(MOST_FILES + 10))
        return await asyncio.gather(*coming, return_exceptions=True)

    results = asyncio.run(together())
    assert sum(isinstance(r, UploadRefused) for r in results) == 10
    assert len(list(tmp_path.iterdir())) == MOST_FILES


def test_files_of_pages_leave_room_on_the_disk(tmp_path, monkeypatch):
    monkeypatch.setattr("shutil.disk_usage", lambda _: SimpleNamespace(free=1 << 30))
    with pytest.raises(UploadRefused, match="nearly full"):
        asyncio.run(receive(chunks(3), tmp_path, "run.csv", "log"))
    assert list(tmp_path.iterdir()) == []


def test_a_file_whose_sender_stops_is_given_up(tmp_path, monkeypatch):
    monkeypatch.setattr("upright.lab.uploads.PATIENCE", 0.05)

    async def stalled() -> Any:
        yield b"t,a\n"
        await asyncio.sleep(60)

    with pytest.raises(UploadRefused):
        asyncio.run(receive(stalled(), tmp_path, "run.csv", "log"))
    assert list(tmp_path.iterdir()) == []


def test_a_session_that_ends_while_its_file_arrives_is_one_line(tmp_path):
    folder = tmp_path / "session"
    folder.mkdir()

    async def leaving() -> Any:
        yield b"t,a\n"
        for path in folder.iterdir():
            path.unlink()
        folder.rmdir()
        yield b"1,2\n"

    with pytest.raises(UploadRefused):
        asyncio.run(receive(leaving(), folder, "run.csv", "log"))


@pytest.mark.parametrize("host", [
    "", " ", "0", "0.0", "0.0.0.0", "0x0", "00000000000", "127.1", "127.0.0.2", "2130706433", "localhost", "LOCALHOST",
    "::", "[::]", "::1", "255.255.255.255", "224.0.0.1", "no such name", "1.2.3.4:80", "\ud800", "a\0b",
])  # fmt: skip
def test_a_class_is_served_at_an_address_of_this_machine_alone(host, capsys):
    """Not at all of its addresses, however they are written, nor at one that no student can reach."""
    assert main(["lab", "--class", "--no-browser", "--port", "0", "--host", host]) == 2
    message = capsys.readouterr().err
    assert message.count("\n") == 1
    assert "try:" in message


def test_text_that_is_no_utf_8_is_answered_and_prints_nothing(served, monkeypatch, capfd):
    """A lone surrogate, encoded as bytes: the line is closed with the code that stands for it (RFC 6455, 7.4.1)."""
    monkeypatch.setattr(connections, "PATIENCE", WAIT)
    payload = b'{"kind":"\xed\xa0\x80"}'
    with served.socket() as made:
        made.sendall(bytes([0x81, 0x80 | len(payload), 0, 0, 0, 0]) + payload)
        made.settimeout(WAIT)
        data = b""
        with contextlib.suppress(OSError):
            while more := made.recv(4096):
                data += more
        assert (1007).to_bytes(2, "big") in data
    assert capfd.readouterr().err == ""


def test_a_slow_disk_holds_up_nobody_but_the_file(tmp_path, monkeypatch):
    """A file's move may wait for the disk for seconds; meanwhile the server's loop goes round."""
    moved = threading.Event()
    move = os.replace

    def slow(*args: Any) -> None:
        assert moved.wait(WAIT)
        move(*args)

    monkeypatch.setattr("os.replace", slow)

    async def story() -> Path:
        arriving = asyncio.create_task(receive(chunks(3), tmp_path, "run.csv", "log"))
        done, _ = await asyncio.wait([arriving], timeout=0.05)  # the loop comes back here, and nothing has arrived
        assert not done
        moved.set()
        return await arriving

    assert asyncio.run(story()).read_bytes() == b"".join(bytes([i]) * 1000 for i in range(3))
