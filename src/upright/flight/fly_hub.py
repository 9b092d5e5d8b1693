"""A flight of a Pybricks hub: the program onto it, started, followed, stopped, and its log caught as it is told."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from upright.compiled.program import Program
from upright.errors import InvalidLog
from upright.flight.fly import Flight, FlightRefused, alone, keep
from upright.flight.program_logs import HUB, is_signed, read_lines, read_telemetry
from upright.links.hub import PATIENCE, HubLink, HubLost, HubRefused, Peripheral, linked

LOOK = 0.05  # [s] from one look at the hub to the next
DUMP = 60.0  # [s] for the log to come: 500 lines of 70 bytes over Bluetooth take 10 to 20 s
QUIET = 0.5  # [s] without a word after which a program that has ended has said everything
NO_DEVICE = "[Errno 19]"
"""What MicroPython says of a port with nothing in it: ENODEV."""


def fly_hub(
    source: Path,
    program: Program,
    port: str | Peripheral,
    seconds: float,
    progress: Callable[[float], None] | None = None,
    clock: Callable[[], float] = time.monotonic,
    *,
    where: str = HUB,
    patience: float = PATIENCE,
) -> Flight:
    """Upload the MicroPython in `source` to the hub at `port`, let it drive for `seconds` [s] or until it ends.

    `clock` [s] tells how long that is, `where` what the log says of its hub. The program is stopped however this ends,
    Ctrl-C included; where the line is lost it cannot be, and the notes say so. Raises `FlightRefused`, `HubLost`,
    `HubRefused` or `MissingTool` where nothing was driven.
    """

    async def flight() -> Flight:
        async with linked(port, patience) as hub:
            ready(hub)
            await hub.upload(source)
            await hub.start()
            flight = await _flown(hub, clock() + seconds, progress, clock, alone(source))
            return _kept(hub, program, flight, where)

    return asyncio.run(flight())


def fetch_hub(program: Program, port: str | Peripheral, *, where: str = HUB, patience: float = PATIENCE) -> Flight:
    """Stop the program that runs on the hub at `port`, and keep the log that it then tells."""

    async def fetched() -> Flight:
        async with linked(port, patience) as hub:
            if not hub.running:
                raise FlightRefused(f"no program runs on {hub.name}", likely="its button ended it, and the log with it")
            await _land(hub)
            return _kept(hub, program, Flight(), where)

    return asyncio.run(fetched())


def ready(hub: HubLink) -> None:
    """Refuse a hub with a flat battery, or one that is busy."""
    if hub.flat:
        raise FlightRefused(f"the battery of {hub.name} is low, it says", hint="charge it")
    if hub.running:
        raise FlightRefused(
            f"a program runs on {hub.name} already", expected="none",
            hint="stop it with its button, or bring its log home with --fetch",
        )  # fmt: skip


async def _flown(
    hub: HubLink,
    end: float,
    progress: Callable[[float], None] | None,
    clock: Callable[[], float],
    alone: str,
) -> Flight:
    flight, stopped = Flight(), False
    try:
        await _watch(hub, end, progress, clock)
    except asyncio.CancelledError:  # Ctrl-C: the program is stopped, and what it then tells is kept
        flight.notes.append("stopped by Ctrl-C")
    finally:
        with suppress(HubLost, HubRefused):
            stopped = await _land(hub)
    flight.lost = hub.lost or hub.running
    if flight.lost and stopped:
        flight.notes.append(f"{hub.name} was lost while it told its log; its program was stopped before")
    elif flight.lost:
        flight.notes.append(
            f"{hub.name} does not answer: {alone} and keeps its log until its button; come nearer: upright fly --fetch"
        )
    return flight


async def _watch(
    hub: HubLink, end: float, progress: Callable[[float], None] | None, clock: Callable[[], float]
) -> None:
    """Until `end`, the program's own, or the line's: a hub that spoke and falls silent for its patience is lost."""
    began, heard, silent = clock(), 0, 0.0
    while (now := clock()) < end and not hub.lost and silent < hub.patience:
        if not await hub.news(LOOK):
            silent += LOOK if heard else 0.0  # it says nothing while it waits to be held still
        elif not hub.running:
            return
        if any(line.startswith("S ") for line in hub.heard[heard:]):
            return  # it has stopped by itself, and waits to be asked for its log
        if len(hub.heard) > heard:
            heard, silent = len(hub.heard), 0.0
        if progress:
            progress((now - began) / (end - began))


async def _land(hub: HubLink) -> bool:
    """Stop the program, and wait until it has said its last; whether the hub heard that it is to stop."""
    if hub.lost:
        return False
    if hub.running:
        await hub.stop()
    loop, quiet = asyncio.get_running_loop(), 0.0
    end = loop.time() + DUMP
    while loop.time() < end and quiet < hub.patience and not hub.lost and not _told(hub):
        if await hub.news(QUIET):
            quiet = 0.0
        elif not hub.running:
            break
        else:
            quiet += QUIET
    return True


def _told(hub: HubLink) -> bool:
    """Whether the last line has come."""
    return not hub.running and bool(hub.heard) and hub.heard[-1].startswith("E ")


def _kept(hub: HubLink, program: Program, flight: Flight, where: str) -> Flight:
    known = {"robot": program.robot, "kit": program.kit, "hash": program.hash, "period": repr(program.period)}
    try:
        keep(flight, read_lines(hub.heard, known, where), program)
    except InvalidLog:
        if not flight.lost:
            raise _why(hub) from None
        with suppress(InvalidLog):
            keep(flight, read_telemetry(hub.heard, known, where), program)
    return flight


def _why(hub: HubLink) -> FlightRefused:
    """Why a program came to no log: what it said last."""
    words = [line for line in hub.heard if line.strip() and not is_signed(line)]
    if any(NO_DEVICE in line for line in words):
        return FlightRefused(
            "a motor or the gyro is not in the port where the program looks for it",
            hint="its first lines (LEFT, RIGHT, GYRO) say where each belongs",
        )
    said = words[-1] if words else "it said nothing"
    return FlightRefused(f"the program ended before it balanced: {said}", expected="a log")
