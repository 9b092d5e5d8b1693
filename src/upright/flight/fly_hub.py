"""A flight of a Pybricks hub: upload, start, watch, stop, and receive the log, whatever goes wrong."""

from __future__ import annotations

import asyncio
import time
from contextlib import suppress
from pathlib import Path

from upright.compiled.program import Program
from upright.errors import InvalidLog
from upright.flight.flight import Clock, Flight, FlightRefused, Progress, without_connection
from upright.flight.program_logs import HUB, is_signed, read_lines, read_telemetry
from upright.links.hub import PATIENCE, HubLink, HubLost, HubRefused, Peripheral, linked

POLL = 0.05  # [s] between two looks at the hub
DUMP = 60.0  # [s] for the log to come: 500 lines of 70 bytes over Bluetooth take 10 to 20 s
QUIET = 0.5  # [s] without output after which the output of an ended program is complete
NO_DEVICE = "[Errno 19]"
"""What MicroPython says of a port with nothing in it: ENODEV."""


def fly_hub(
    source: Path,
    program: Program,
    port: str | Peripheral,
    seconds: float,
    *,
    progress: Progress | None = None,
    clock: Clock = time.monotonic,
    where: str = HUB,
    patience: float = PATIENCE,
) -> Flight:
    """Upload the MicroPython in `source` to the hub at `port`, and run it for `seconds` [s] of `clock`.

    `where` describes the hub in the log. The program is stopped however this ends, Ctrl-C included; only a lost
    connection prevents that, and a note says so. Raises `FlightRefused`, `HubLost`, `HubRefused` or `MissingTool`
    where nothing was driven.
    """

    async def flight() -> Flight:
        async with linked(port, patience) as hub:
            check_ready(hub)
            await hub.upload(source)
            await hub.start()
            fate = without_connection(source.read_text("utf-8"))
            flight = await _flown(hub, clock() + seconds, progress, clock, fate)
            return _with_log(hub, program, flight, where)

    return asyncio.run(flight())


def fetch_hub(program: Program, port: str | Peripheral, *, where: str = HUB, patience: float = PATIENCE) -> Flight:
    """Stop the program on the hub at `port`, and receive its log."""

    async def fetched() -> Flight:
        async with linked(port, patience) as hub:
            if not hub.running:
                raise FlightRefused(f"no program runs on {hub.name}", likely="its button ended it, log lost")
            await _stop(hub)
            return _with_log(hub, program, Flight(), where)

    return asyncio.run(fetched())


def check_ready(hub: HubLink) -> None:
    """Refuse a hub with a flat battery, or one that is busy."""
    if hub.flat:
        raise FlightRefused(f"the battery of {hub.name} is low", hint="charge it")
    if hub.running:
        raise FlightRefused(
            f"a program runs on {hub.name} already", expected="none",
            hint="stop it with its button, or fetch its log with --fetch",
        )  # fmt: skip


async def _flown(
    hub: HubLink,
    end: float,
    progress: Progress | None,
    clock: Clock,
    fate: str,
) -> Flight:
    flight, stopped = Flight(), False
    try:
        await _watch(hub, end, progress, clock)
    except asyncio.CancelledError:  # Ctrl-C: the program is stopped, and its log kept
        flight.notes.append("stopped by Ctrl-C")
    finally:
        with suppress(HubLost, HubRefused):
            stopped = await _stop(hub)
    flight.lost = hub.lost or hub.running
    if flight.lost and stopped:
        flight.notes.append(f"{hub.name} was lost while it sent its log; its program was stopped before")
    elif flight.lost:
        flight.notes.append(f"{hub.name} does not answer: {fate} and keeps its log; come nearer: upright fly --fetch")
    return flight


async def _watch(hub: HubLink, end: float, progress: Progress | None, clock: Clock) -> None:
    """Wait until `end`, or the program's end, or the connection's: a hub silent for its `patience` is lost."""
    began, received, silent = clock(), 0, 0.0
    while (now := clock()) < end and not hub.lost and silent < hub.patience:
        if not await hub.news(POLL):
            silent += POLL if received else 0.0  # it prints nothing while it waits to be held still
        elif not hub.running:
            return
        if any(line.startswith("S ") for line in hub.lines[received:]):
            return  # it has stopped by itself, and waits for the request of its log
        if len(hub.lines) > received:
            received, silent = len(hub.lines), 0.0
        if progress:
            progress((now - began) / (end - began))


async def _stop(hub: HubLink) -> bool:
    """Stop the program and wait for the end of its output; whether the hub received the request."""
    if hub.lost:
        return False
    if hub.running:
        await hub.stop()
    loop, quiet = asyncio.get_running_loop(), 0.0
    end = loop.time() + DUMP
    while loop.time() < end and quiet < hub.patience and not hub.lost and not _complete(hub):
        if await hub.news(QUIET):
            quiet = 0.0
        elif not hub.running:
            break
        else:
            quiet += QUIET
    return True


def _complete(hub: HubLink) -> bool:
    """Whether the log has arrived to its last line."""
    return not hub.running and bool(hub.lines) and hub.lines[-1].startswith("E ")


def _with_log(hub: HubLink, program: Program, flight: Flight, where: str) -> Flight:
    known = {"robot": program.robot, "kit": program.kit, "hash": program.hash, "period": repr(program.period)}
    try:
        flight.keep(read_lines(hub.lines, known, where), program)
    except InvalidLog:
        if not flight.lost:
            raise _refusal(hub) from None
        with suppress(InvalidLog):
            flight.keep(read_telemetry(hub.lines, known, where), program)
    return flight


def _refusal(hub: HubLink) -> FlightRefused:
    """Why a program has no log, from its last line of output."""
    words = [line for line in hub.lines if line.strip() and not is_signed(line)]
    if any(NO_DEVICE in line for line in words):
        return FlightRefused(
            "a motor or the gyro is not in the port that the program uses",
            hint="the first lines of the program (LEFT, RIGHT, GYRO) name the ports",
        )
    last = words[-1] if words else "without output"
    return FlightRefused(f"the program ended before it balanced: {last}", expected="a log")
