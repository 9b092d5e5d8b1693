"""A class with hostile students in it: what the others get, and whether the lab stands.

Twenty students, each from an address of its own, send junk, floods, hostile numbers and files, never read, hold half a
connection or come and go; eight others watch their robots. Server, watchers and the hostile run in processes of
their own. The hostile one yields to the others: in a class its work is done by other computers.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Awaitable, Callable, Iterator
from dataclasses import replace
from itertools import count
from typing import Any

import httpx
import numpy as np
import psutil

from upright.lab import hub
from upright.lab.classroom import CLASS_SETUP, Door
from upright.lab.codec import encode
from upright.lab.messages import VERSION, Hello, Play, Save, Step, Strike
from upright.lab.server import Lab, listening, serve

TOKEN = "students"
SETTLED = 68.0  # [s] until everybody has come in, every module is loaded and the last minute of every robot is kept
KEPT = 20.0  # [s] that the robot of a student who left is kept here, so that the end shows what stays for ever
YIELDS = 10  # of nice, for those who share the lab's processors here alone
CHOSEN = ("lqg", "pid", "mpc", "lqr", "sliding", "lqi")  # by the others, so that no hostile one loads a module first
Send = Callable[[str], Awaitable[None]]


def measure(
    seed: int, minutes: float | None = None, watchers: int = 8, hostile: int = 20
) -> Iterator[tuple[str, str, str, bool]]:
    """Rows of the table of `abuse.py`, over so many `minutes` (10) of hostility."""
    seconds = 60 * (10.0 if minutes is None else minutes)
    server = _process("serve")
    try:
        port = int(_line(server))
        watching = _process("watch", port, watchers, seconds + SETTLED + 2 * KEPT)
        _line(watching)  # they have come in
        time.sleep(SETTLED)
        stages, before = _stages(server.pid), _memory(server.pid)
        hostility = _process("hostile", port, hostile, seconds, seed)
        sent = json.loads(hostility.communicate(timeout=seconds + 120)[0])
        largest = _memory(server.pid)
        time.sleep(2 * KEPT - 10.0)
        alive, after = set(stages) <= set(_stages(server.pid)), _memory(server.pid)
        pictures = np.array(json.loads(watching.communicate(timeout=60)[0]))
        replaced = _replaced(server.pid)
    finally:
        server.terminate()
        errors = server.communicate(timeout=30)[1]
    yield "messages and connections of the hostile", f"{sum(sent.values())}", "many", sum(sent.values()) > 20 * seconds
    calm = np.median(pictures[:, 2 : int(SETTLED)])
    pictures = pictures[:, int(SETTLED) : int(SETTLED + seconds)]
    yield "pictures a second before the hostile came, median", f"{calm:.0f}", "25", calm >= 25
    slowest = pictures.min(axis=0)  # of each second, the client that got fewest
    yield "pictures a second of the others, median", f"{np.median(pictures):.0f}", "25", np.median(pictures) >= 25
    yield "pictures, the worst second of the worst client", f"{slowest.min()}", "25", slowest.min() >= 25
    below = f"{(slowest < 25).sum()} of {len(slowest)}"
    yield "seconds in which any client got fewer than 25", below, "0", bool((slowest >= 25).all())
    yield (
        "memory before, with all and after",
        f"{before:.0f}, {largest:.0f}, {after:.0f} MB",
        "+20 %",
        after < 1.2 * before,
    )
    yield "a killed stage is replaced after", f"{replaced:.2f} s", "1 s", replaced <= 1
    yield "stages alive", "yes" if alive else "no", "yes", alive
    yield "lines on the teacher's terminal", errors.strip()[:1000] or "0", "0", not errors


def _replaced(server: int) -> float:
    """Seconds until another process stands in the place of a stage that is killed, as for want of memory."""
    before, begun = _stages(server), time.monotonic()
    os.kill(before[0], signal.SIGKILL)
    while set(_stages(server)) <= set(before) and time.monotonic() - begun < 60:
        time.sleep(0.01)
    return time.monotonic() - begun


def _process(role: str, *args: Any) -> subprocess.Popen[str]:
    command = [sys.executable, __file__, role, *map(str, args)]
    return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)


def _line(process: subprocess.Popen[str]) -> str:
    assert process.stdout
    return process.stdout.readline()


def _stages(pid: int) -> list[int]:
    found: list[int] = []
    for child in psutil.Process(pid).children():
        with contextlib.suppress(psutil.NoSuchProcess):  # it ended meanwhile
            found += [child.pid] if "spawn_main" in " ".join(child.cmdline()) else []
    return found


def _memory(pid: int) -> float:
    """[MB] of the server and its stages, without the jobs at their desks."""
    return sum(psutil.Process(p).memory_full_info().uss for p in (pid, *_stages(pid))) / 1e6


def serving() -> None:
    hub.SOON = hub.FORGOTTEN = KEPT
    lab = Lab(port=0, door=Door(TOKEN, "teacher"))
    sock = listening(lab)
    serve(lab, sock, lambda: print(lab.port, flush=True))


async def watching(port: int, clients: int, seconds: float) -> None:
    """Print the pictures that each client got, second by second."""
    came: list[int] = []
    ready = asyncio.Event()

    async def client(i: int) -> list[int]:
        counts = [0] * int(seconds)
        async with _socket(port) as socket:
            await socket.send(_hello(f"Student {i}", CHOSEN[i % len(CHOSEN)]))
            while True:
                message = json.loads(await asyncio.wait_for(socket.recv(), 60))
                if message["kind"] != "Snapshot":
                    continue
                await socket.send(f'{{"kind":"Ack","n":{message["n"]}}}')
                if i not in came:
                    came.append(i)
                    if len(came) == clients:
                        print("here", flush=True)
                        ready.began = time.monotonic()  # type: ignore[attr-defined]
                        ready.set()
                if not ready.is_set():
                    continue
                second = int(time.monotonic() - ready.began)  # type: ignore[attr-defined]
                if second >= len(counts):
                    return counts
                counts[second] += 1
                if counts[second] == 1 and second % 4 == i % 4:
                    await socket.send(encode(Strike("impulse", 0.03)))

    print(json.dumps(await asyncio.gather(*(client(i) for i in range(clients)))))


def _socket(port: int, source: str = "") -> Any:
    from websockets.asyncio.client import connect

    local = {"local_addr": (source, 0)} if source and sys.platform == "linux" else {}
    return connect(f"ws://127.0.0.1:{port}/ws", max_size=None, close_timeout=1, compression=None, **local)


def _hello(name: str, controller: str = CLASS_SETUP.controller) -> str:
    return encode(Hello(VERSION, token=TOKEN, name=name, setup=replace(CLASS_SETUP, controller=controller)))


class Hostile:
    """One of them: what it does to the lab at `port`, from an address of its own, until it is cancelled."""

    def __init__(self, port: int, number: int, seed: int) -> None:
        self.port, self.number, self.source = port, number, f"127.0.{1 + number // 200}.{1 + number % 200}"
        self.rng, self.sent = random.Random(1000 * seed + number), 0

    async def live(self) -> None:
        """Do one thing after the other, whatever comes of it."""
        while True:
            with contextlib.suppress(OSError, EOFError, httpx.HTTPError, Exception):
                await asyncio.wait_for(WAYS[self.number % len(WAYS)](self), 20.0)
            await asyncio.sleep(0.1)

    async def flood(self, text: Callable[[], str], pause: float = 0.005, reads: bool = True) -> None:
        """Send and send, whether anything is read or not."""
        async with _socket(self.port, self.source) as socket:
            await socket.send(_hello(f"X{self.number}"))
            if not reads:
                socket.transport.pause_reading()
            for _ in count():
                await socket.send(text())
                self.sent += 1
                await asyncio.sleep(pause)

    async def junk(self) -> None:
        await self.flood(self._spoilt)

    async def steps(self) -> None:
        await self.flood(lambda: encode(Step(1000)))

    async def numbers(self) -> None:
        await self.flood(self._hostile_numbers, 0.03)

    async def files(self) -> None:
        kinds = ("replay", "csv", "report", "parquet", "controller", "robot")
        await self.flood(lambda: encode(Save(self.rng.choice(kinds))), 0.01)

    async def never_reads(self) -> None:
        await self.flood(lambda: encode(Save("csv")) if self.rng.random() < 0.1 else "[]", 0.01, reads=False)

    async def fast(self) -> None:
        await self.flood(lambda: encode(Play(False, 4.0)), 1.0)

    async def half(self) -> None:
        """Thirty connections of which nothing whole comes."""
        lines = [await asyncio.open_connection("127.0.0.1", self.port, local_addr=(self.source, 0)) for _ in range(30)]
        for _, writer in lines:
            writer.write(self.rng.choice([b"", b"GET / HTTP/1.1\r\nHost:", b"\x16\x03\x01", self.rng.randbytes(50)]))
            self.sent += 1
        await asyncio.sleep(15.0)
        for _, writer in lines:
            writer.close()

    async def comes_and_goes(self) -> None:
        async with _socket(self.port, self.source) as socket:
            await socket.send(_hello(f"X{self.number}"))
            self.sent += 1

    async def pings(self) -> None:
        async with _socket(self.port, self.source) as socket:
            await socket.send(_hello(f"X{self.number}"))
            socket.transport.write(bytes([0x89, 0x80, 0, 0, 0, 0]) * 50_000)
            self.sent += 50_000
            await asyncio.sleep(2.0)

    async def uploads(self) -> None:
        async with _socket(self.port, self.source) as socket, httpx.AsyncClient(timeout=10) as web:
            await socket.send(_hello(f"X{self.number}"))
            session = json.loads(await socket.recv())["session"]
            address = f"http://127.0.0.1:{self.port}/upload/{session}"
            data = self.rng.randbytes(200_000)
            for _ in range(20):
                names = [f"run{self.rng.randrange(3)}.csv" for _ in range(6)]
                await asyncio.gather(*(web.post(address, params={"name": name}, content=data) for name in names))
                self.sent += 6

    def _spoilt(self) -> str:
        text = list(self.rng.choice([self._hostile_numbers(), encode(Step(1000)), encode(Strike("front", 0.1))]))
        for _ in range(self.rng.randrange(3)):
            text[self.rng.randrange(len(text))] = self.rng.choice(['"', "{", "9" * 30, "\x00", "\\ud800", "é", ""])
        return "".join(text)

    def _hostile_numbers(self) -> str:
        rng = self.rng
        names = ("gear_ratio", "wheel_radius", "stiction_rate", "torque_constant", "motor_friction", "body_mass",
                 "coulomb_friction", "pitch_inertia", "rotor_inertia", "track", "com_height")  # fmt: skip

        def number() -> float:
            return rng.choice([5e-324, 1e-6, 7750.0, 1e12, 7630376392.0, 10 ** rng.uniform(-12, 12), rng.random()])

        setup = {"controller": rng.choice(["lqg", "lqi", "sliding", "mpc", "hinf", "robust", "gains", "pid"]),
                 "numbers": {rng.choice(names): number() for _ in range(rng.randrange(3))},
                 "bodies": ["nonlinear", "linear", "published"], "payload": rng.random()}  # fmt: skip
        if rng.random() < 0.3:
            setup["largest"] = [number() for _ in range(7)]
        return json.dumps({"kind": "Change", "setup": setup})


WAYS: tuple[Callable[[Hostile], Awaitable[None]], ...] = (
    Hostile.steps, Hostile.numbers, Hostile.junk, Hostile.files, Hostile.never_reads, Hostile.half,
    Hostile.comes_and_goes, Hostile.uploads, Hostile.fast, Hostile.pings,
)  # fmt: skip


async def attacking(port: int, number: int, seconds: float, seed: int) -> None:
    """Print how much was sent, by what each did."""
    os.nice(YIELDS)
    them = [Hostile(port, i, seed) for i in range(number)]
    lives = [asyncio.create_task(each.live()) for each in them]
    await asyncio.sleep(seconds)
    for life in lives:
        life.cancel()
    await asyncio.wait(lives, timeout=10)  # one that was just about to begin again may miss it
    sent = Counter[str]()
    for each in them:
        sent[WAYS[each.number % len(WAYS)].__name__] += each.sent
    print(json.dumps(sent), flush=True)
    os._exit(0)  # whatever still does not hear that it is to end


def main(role: str, *args: str) -> None:
    if role == "serve":
        serving()
    elif role == "watch":
        asyncio.run(watching(int(args[0]), int(args[1]), float(args[2])))
    else:
        asyncio.run(attacking(int(args[0]), int(args[1]), float(args[2]), int(args[3])))


if __name__ == "__main__":
    main(*sys.argv[1:])
