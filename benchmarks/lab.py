"""What the lab costs: bytes and CPU of a client, a class of thirty, time to answer and to the first picture, memory.

Run: python benchmarks/lab.py [--seconds N] [--picture], or one of [--wall MINUTES] [--hour] alone. Clients run in a
process of their own; ticks are timed by the stages themselves. `--picture` needs Chromium and Playwright; `--wall`
watches one client for so long; `--hour` simulates an hour as fast as it goes, which takes minutes.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import re
import signal
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path
from typing import Any

import harness
import numpy as np
import psutil

from upright.lab.classroom import Door
from upright.lab.codec import encode
from upright.lab.desk import InlineDesk
from upright.lab.hub import Hub
from upright.lab.messages import VERSION, Setup, Strike
from upright.lab.server import ALONE, CLASS, CLASS_STAGES, Lab, listening, server_of
from upright.lab.stage import Options
from upright.lab.stage_process import StageProcess

STUDENTS = 30
EVERY = 4.0  # [s] between two knocks of every client, so that the numbers move


def main() -> None:
    options = harness.options(__doc__, seconds=20.0, picture=False, wall=float, hour=False, clients=())
    if options.clients:
        address, token, count = options.clients
        print(json.dumps(asyncio.run(watched(address, token, int(count), options.seconds))))
        return
    harness.machine("numpy", "mujoco", "fastapi", "uvicorn", "websockets")
    if options.hour:
        hour()
    if options.wall:
        measured("one client, three bodies, 50 Hz", Door(), ALONE, 1, 1, 60 * options.wall + 8)
    if not (options.hour or options.wall):
        usual(options)


def usual(options: argparse.Namespace) -> None:
    """The measurements that take a minute."""
    print(f"{'upright lab answers':<44}{answered():>9.2f} s      (bar 2)")
    measured("one client, three bodies, 50 Hz", Door(), ALONE, 1, 1, options.seconds)
    measured(
        f"thirty students, {CLASS.rate:.0f} Hz",
        Door("students", "teacher"),
        CLASS,
        CLASS_STAGES,
        STUDENTS,
        options.seconds,
    )
    if options.picture:
        print(f"{'first picture after the page is asked for':<44}{pictured():>9.2f} s      (bar 1.5)")


def answered(repeats: int = 3) -> float:
    """Shortest time [s] from the command to the line with the address, which is printed once pages are answered."""
    times: list[float] = []
    for _ in range(repeats):
        began = time.perf_counter()
        process, _ = started()
        times.append(time.perf_counter() - began)
        stopped(process)
    return min(times)


def started() -> tuple[subprocess.Popen[str], str]:
    command = [sys.executable, "-m", "upright", "lab", "--port", "0", "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    assert process.stdout
    return process, re.findall(r"http://\S+", process.stdout.readline())[0]


def stopped(process: subprocess.Popen[str]) -> None:
    process.send_signal(signal.SIGINT)
    process.wait(timeout=30)


def measured(title: str, door: Door, options: Options, stages: int, clients: int, seconds: float) -> None:
    """Serve `clients` for so long and print what it took."""
    lab = Lab(port=0, door=door)
    sock = listening(lab)
    hub = Hub(door, [StageProcess(options) for _ in range(stages)])
    loop = _served(lab, hub, sock)
    command = [sys.executable, __file__, "--seconds", str(seconds), "--clients", lab.url, door.students, str(clients)]
    load = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
    time.sleep(min(6.0, seconds / 2))  # the loop's first analysis and every import are over
    before, since = _cpu(), time.monotonic()
    time.sleep(max(1.0, seconds - 8.0))
    share = (_cpu() - before) / (time.monotonic() - since)
    said = json.loads(load.communicate()[0])
    late = _late(hub, loop, stages, round(options.rate * max(1.0, seconds - 8.0)))
    hub.close()
    drift = max(abs(d) for d in said["drift"])
    print(f"\n{title}, the last {seconds - 8:g} s")
    print(f"{'  bytes a second to each client':<44}{max(said['bytes']) / 1e3:>9.1f} kB/s   (bar 20 at 50 Hz)")
    print(f"{'  snapshots a second to the slowest client':<44}{min(said['shots']):>9.1f}")
    print(f"{'  CPU of server and loop, all clients':<44}{100 * share:>9.1f} %      (bar 15 for one client)")
    print(f"{'  lateness of ticks: median, 99th percentile':<44}{1e3 * np.median(late):>9.2f} ms, "
          f"{1e3 * np.percentile(late, 99):.2f} ms (bar 10)")  # fmt: skip
    print(f"{'  simulated against wall time, largest drift':<44}{1e3 * drift:>9.1f} ms")


def _served(lab: Lab, hub: Hub, sock: Any) -> asyncio.AbstractEventLoop:
    """The application in a thread of this process, and its event loop."""
    server, box = server_of(lab, hub), list[asyncio.AbstractEventLoop]()
    ready = threading.Event()

    async def serve() -> None:
        box.append(asyncio.get_running_loop())
        ready.set()
        await server.serve(sockets=[sock])

    threading.Thread(target=lambda: asyncio.run(serve()), daemon=True).start()
    ready.wait()
    time.sleep(0.5)
    return box[0]


def _late(hub: Hub, loop: asyncio.AbstractEventLoop, stages: int, ticks: int) -> np.ndarray:
    """How late the last `ticks` of every stage were [s], when all had come in."""

    async def asked() -> list[float]:
        hub.ask_stats()
        return [x for _ in range(stages) for x in (await hub.stats.get())["late"][-ticks:]]

    return np.array(asyncio.run_coroutine_threadsafe(asked(), loop).result(30))


def _cpu() -> float:
    """CPU seconds of this process and of its stages, without the clients."""
    here = psutil.Process()
    whole = [here, *(p for p in here.children(recursive=True) if "--clients" not in p.cmdline())]
    return sum(sum(p.cpu_times()[:2]) for p in whole)


async def watched(address: str, token: str, count: int, seconds: float) -> dict[str, list[float]]:
    """Bytes and snapshots a second of each client, and how simulated drifts from wall time [s]."""
    found = await asyncio.gather(*(_client(address, token, f"S{i}", seconds, i / count) for i in range(count)))
    return {"bytes": [f[0] for f in found], "shots": [f[1] for f in found], "drift": [f[2] for f in found]}


async def _client(address: str, token: str, name: str, seconds: float, phase: float) -> tuple[float, float, float]:
    from websockets.asyncio.client import connect

    async with connect(address.split("#", 1)[0].replace("http", "ws") + "ws", max_size=None) as socket:
        await socket.send(json.dumps({"kind": "Hello", "version": VERSION, "token": token, "name": name}))
        end, size, shots, knock = time.monotonic() + seconds, 0, 0, time.monotonic() + 3 + EVERY * phase
        marks: list[tuple[float, float]] = []
        while (now := time.monotonic()) < end:
            text = await asyncio.wait_for(socket.recv(), 30)
            message = json.loads(text)
            if message["kind"] == "Snapshot":
                await socket.send(f'{{"kind":"Ack","n":{message["n"]}}}')
                size, shots = size + len(text.encode()), shots + 1
                marks.append((now, message["t"]))
            if now > knock:
                knock += EVERY
                await socket.send(encode(Strike("impulse", 0.05)))
        span = marks[-1][0] - marks[0][0]
        settled = [m for m in marks if m[0] > end - (seconds - 8)]
        drift = (settled[-1][1] - settled[0][1]) - (settled[-1][0] - settled[0][0])
        return size / span, shots / span, drift


def pictured(repeats: int = 3) -> float:
    """Shortest time [s] from asking for the page to its first drawn snapshot, in headless Chromium without a GPU."""
    from playwright.sync_api import sync_playwright

    process, address = started()
    time.sleep(3.0)
    flags = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
    times: list[float] = []
    with sync_playwright() as driver:
        browser = driver.chromium.launch(executable_path="/usr/bin/chromium", args=flags)
        for _ in range(repeats):
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            began = time.perf_counter()
            page.goto(address, wait_until="commit")
            while not page.evaluate("Boolean(window.upright?.page.drawnFirst)"):
                time.sleep(0.01)
            times.append(time.perf_counter() - began)
            page.close()
        browser.close()
    stopped(process)
    return min(times)


def hour() -> None:
    """Memory of a session of three bodies, minute by minute, over an hour of simulated time."""
    from upright.lab.session import Session

    session = Session(Setup(), InlineDesk(), Path(tempfile.mkdtemp()))
    sizes: list[float] = []
    began = time.process_time()
    for second in range(3601):
        if second % 60 == 0:
            sizes.append(psutil.Process().memory_info().rss / 1e6)
        if second % 10 == 0:
            session.handle(Strike("impulse", 0.05))
        session.advance(1.0)
        session.events()
        encode(session.snapshot())
    early, late = sizes[2:31], sizes[31:]
    print(f"\nan hour of simulated time in {time.process_time() - began:.0f} s of CPU")
    print(f"{'  memory after 2, 30 and 60 minutes':<44}{sizes[2]:.2f}, {sizes[30]:.2f}, {sizes[60]:.2f} MB")
    print(f"{'  largest in the second half, above the first':<44}{max(late) - max(early):.2f} MB      (bar: flat)")


if __name__ == "__main__":
    main()
