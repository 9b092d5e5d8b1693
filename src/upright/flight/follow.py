"""A program's lines as they come: of a hub, a virtual hub, a file or a serial device, without driving it."""

from __future__ import annotations

import asyncio
import sys
import time
from collections.abc import Callable
from math import inf
from pathlib import Path
from typing import TextIO

from upright.errors import UprightError
from upright.firmware.generate import head
from upright.firmware.program_file import read_text
from upright.flight.flight import Clock
from upright.links.hub import AIR, PATIENCE, HubLink, HubLost, Peripheral, linked
from upright.robots import find_kit, find_robot

VIRTUAL = "virtual"
"""The port of a brick or hub that is simulated."""
POLL = 0.1  # [s] between two looks at the hub

LONGEST_LINE = 10_000  # [characters] a program sends some hundreds

OnLine = Callable[[str], None]


def is_live(source: str) -> bool:
    """Whether a robot is at that source, real or virtual, and not a file or another command's output."""
    return source == VIRTUAL or source.partition(":")[0] == AIR


def follow(source: str, on_line: OnLine, *, program: str | Path | None = None, seconds: float = inf) -> None:
    """Call `on_line` with every line of a program. `source` is ble, ble:NAME, virtual, a file, a device, or - (stdin).

    A virtual hub runs `program`, for `seconds`. Raises `UprightError` for a program elsewhere, and like `follow_hub`.
    """
    if (program is not None) != (source == VIRTUAL):
        raise UprightError("only a virtual hub needs a program", expected="virtual --program FILE")
    if program is not None:
        from upright.bricks.virtual_robot import virtual_hub

        facts = head(read_text(program))
        with virtual_hub(find_robot(facts["robot"]), find_kit(facts["kit"]), speed=1.0) as hub:
            follow_hub(hub, on_line, program=Path(program), seconds=seconds, clock=lambda: hub.seconds)
    elif is_live(source):
        follow_hub(source, on_line, seconds=seconds)
    elif source == "-":
        _read(sys.stdin, source, on_line)
    else:
        with Path(source).open(encoding="utf-8", errors="replace") as stream:
            _read(stream, source, on_line)


def _read(stream: TextIO, source: str, on_line: OnLine) -> None:
    """Every line to the end; `UprightError` where a device is pulled out before."""
    device = source != "-" and Path(source).is_char_device()
    while True:
        try:
            line = stream.readline(LONGEST_LINE)
        except OSError:  # the system's answer for a device that was pulled out; another is the end of its lines
            line, device = "", True
        if not line and device:
            raise UprightError(f"{source} is gone", likely="the cable came out", hint="plug it in and follow it again")
        if not line:
            return
        on_line(line)


def follow_hub(
    port: str | Peripheral,
    on_line: OnLine,
    *,
    program: Path | None = None,
    seconds: float = inf,
    clock: Clock = time.monotonic,
    patience: float = PATIENCE,
) -> None:
    """Call `on_line` with every line of the program on a hub, from its start by the hub's button to its end.

    A `program` is uploaded and started first, and stopped after `seconds`; without one the hub's program runs on after
    them. Raises `HubLost` where the connection breaks.
    """

    async def followed() -> None:
        async with linked(port, patience) as hub:
            if program:
                await hub.upload(program)
                await hub.start()
            await _listen(hub, on_line, clock() + seconds, clock)
            if program and hub.running:
                await hub.stop()
                await _listen(hub, on_line, inf, clock)

    asyncio.run(followed())


async def _listen(hub: HubLink, on_line: OnLine, end: float, clock: Clock) -> None:
    """Until the program's end, or the time `end`."""
    began = hub.running
    while clock() < end and not (began and not hub.running):
        await hub.news(POLL)
        began = began or hub.running
        lines, hub.lines = hub.lines, []
        for line in lines:
            on_line(line)
        if hub.lost:
            raise HubLost(f"{hub.name} does not answer", likely="it is out of reach, or off", hint="come nearer")
