"""A flight of a Pybricks hub: upload, start, watch, stop, and receive the log, whatever goes wrong."""

from __future__ import annotations

import asyncio
import signal
import threading
import time
from collections.abc import Coroutine
from contextlib import suppress
from pathlib import Path
from typing import Any

from upright.compiled.program import Program
from upright.errors import InvalidLog
from upright.flight.flight import INTERRUPTED, STOPS, Clock, Flight, FlightRefused, MotorsMayRun, may_run
from upright.flight.program_logs import HUB, is_signed, read_lines, read_telemetry
from upright.interrupts import SIGNALS
from upright.links.hub import PATIENCE, HubLink, HubLost, HubRefused, Peripheral, linked
from upright.progress import Progress

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

    `where` describes the hub in the log. The program is stopped however this ends, Ctrl-C included; where the hub does
    not confirm that, a note says that motors may be running. Raises `FlightRefused`, `HubLost`, `HubRefused` or
    `MissingTool` where nothing was driven.
    """

    async def flight() -> Flight:
        async with linked(port, patience) as hub:
            check_ready(hub)
            await hub.upload(source)
            flight = await _flown(hub, seconds, progress, clock, source.read_text("utf-8"))
            return _with_log(hub, program, flight, where)

    return _run(flight())


def fetch_hub(program: Program, port: str | Peripheral, *, patience: float = PATIENCE) -> Flight:
    """Stop the program on the hub at `port`, and receive its log."""

    async def fetched() -> Flight:
        async with linked(port, patience) as hub:
            if not hub.running:
                raise FlightRefused(f"no program runs on {hub.name}", likely="its button ended it, log lost")
            flight = Flight(lost=not await _stop(hub))
            flight.notes += [may_run(hub.name)] if flight.lost else []
            return _with_log(hub, program, flight, HUB)

    return _run(fetched())


def _run(flight: Coroutine[Any, Any, Flight]) -> Flight:
    """The result of a flight, in which each Ctrl-C, or other signal to end, cancels one wait and nothing else."""

    async def interruptible() -> Flight:
        loop, task = asyncio.get_running_loop(), asyncio.current_task()
        assert task
        with suppress(NotImplementedError):  # Windows has none
            for number in before:
                loop.add_signal_handler(number, task.cancel)
        return await flight

    main = threading.current_thread() is threading.main_thread()
    before = {number: signal.getsignal(number) for number in SIGNALS} if main else {}
    awake = signal.set_wakeup_fd(-1) if main else -1
    try:
        return asyncio.run(interruptible())
    except asyncio.CancelledError:
        raise KeyboardInterrupt from None
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
        if main:
            signal.set_wakeup_fd(awake)


def check_ready(hub: HubLink) -> None:
    """Refuse a hub with a flat battery, or one that is busy."""
    if hub.flat:
        raise FlightRefused(f"the battery of {hub.name} is low", hint="charge it")
    if hub.running:
        raise FlightRefused(
            f"a program runs on {hub.name} already", expected="no program",
            hint="stop it with its button, or fetch its log with --fetch",
        )  # fmt: skip


async def _flown(
    hub: HubLink,
    seconds: float,
    progress: Progress | None,
    clock: Clock,
    text: str,
) -> Flight:
    flight = Flight()
    trouble = None
    try:
        end = clock() + seconds
        await hub.start()
        await _watch(hub, end, progress, clock)
    except asyncio.CancelledError:  # Ctrl-C: the program is stopped, and its log kept
        _go_on()
        flight.notes.append(INTERRUPTED)
    except (HubLost, HubRefused) as error:
        trouble = error
    except BaseException as error:
        if not await _stop(hub):
            raise MotorsMayRun(f"{may_run(hub.name, text)} ({error})") from error
        raise
    stopped = await _stop(hub, doubtful=not hub.begun)
    if trouble and stopped and not hub.begun:
        raise trouble
    flight.notes += [str(trouble)] if trouble else []
    flight.lost = hub.lost or not stopped
    if not stopped:
        flight.notes.insert(0, f"{may_run(hub.name, text)}; it keeps its log: come nearer, upright fly --fetch")
    elif hub.lost:
        flight.notes.append(f"{hub.name} was lost while it sent its log; its program was stopped before")
    return flight


async def _watch(hub: HubLink, end: float, progress: Progress | None, clock: Clock) -> None:
    """Wait until `end`, or the program's end, or the connection's: a hub silent for its `patience` is lost."""
    began = clock()
    received = 0
    silent = 0.0
    while (now := clock()) < end and not hub.lost and silent < hub.patience:
        came = await hub.news(POLL)
        if not hub.running and (came or hub.begun):  # it may have ended before anybody waited for news
            return
        silent += POLL if received and not came else 0.0  # it prints nothing while it waits to be held still
        if any(line.startswith("S ") for line in hub.lines[received:]):
            return  # it has stopped by itself, and waits for the request of its log
        if len(hub.lines) > received:
            received = len(hub.lines)
            silent = 0.0
        if progress:
            progress((now - began) / (end - began))


async def _stop(hub: HubLink, doubtful: bool = False) -> bool:
    """Stop the program and wait for the end of its output; whether the hub confirms that its motors are off.

    Each attempt stands alone, and Ctrl-C ends no more than one. With `doubtful` a hub that reports no program is
    stopped all the same: its start may be on the way.
    """
    for _ in range(STOPS):
        try:
            if hub.running or doubtful:
                await hub.stop()
                doubtful = False
            await _ended(hub)
        except asyncio.CancelledError:
            _go_on()
        except (HubLost, HubRefused):
            pass
        if (not hub.running and not doubtful) or _sends_log(hub):
            return True
    return False


def _go_on() -> None:
    """Whoever caught a cancellation goes on, and its time limits count again."""
    task = asyncio.current_task()
    if task:
        task.uncancel()


def _sends_log(hub: HubLink) -> bool:
    """Whether its log has begun, which a program sends when its motors are off."""
    return any(line.startswith("H ") for line in hub.lines)


async def _ended(hub: HubLink) -> None:
    """Wait for the end of the program's output."""
    loop = asyncio.get_running_loop()
    quiet = 0.0
    end = loop.time() + DUMP
    while loop.time() < end and quiet < hub.patience and not hub.lost and not _complete(hub):
        if await hub.news(QUIET):
            quiet = 0.0
        elif not hub.running:
            break
        else:
            quiet += QUIET


def _complete(hub: HubLink) -> bool:
    """Whether the log has arrived to its last line."""
    return not hub.running and bool(hub.lines) and hub.lines[-1].startswith("E ")


def _with_log(hub: HubLink, program: Program, flight: Flight, where: str) -> Flight:
    known = {"robot": program.robot, "kit": program.kit, "hash": program.hash, "period": repr(program.period)}
    try:
        flight.keep(read_lines(hub.lines, known, where), program)
    except InvalidLog:
        try:
            flight.keep(read_telemetry(hub.lines, known, where), program)
        except InvalidLog:
            if not flight.notes:
                raise _refusal(hub) from None
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
    likely = "" if words else "the flight was over within the still start of a second"
    return FlightRefused(f"the program ended before it balanced: {last}", expected="a log", likely=likely)
