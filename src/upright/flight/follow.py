"""A hub's program followed line by line, without driving it."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from pathlib import Path

from upright.links.hub import PATIENCE, HubLink, HubLost, Peripheral, linked

LOOK = 0.1  # [s] from one look at the hub to the next


def follow(
    port: str | Peripheral,
    hear: Callable[[str], None],
    source: Path | None = None,
    seconds: float = float("inf"),
    clock: Callable[[], float] = time.monotonic,
    *,
    patience: float = PATIENCE,
) -> None:
    """Give every line of the program on the hub at `port` to `hear`, from its start by the hub's button to its end.

    A virtual hub has no button: `source` is uploaded and started there, and stopped after `seconds`; on any other it is
    left alone after them. Raises `HubLost` where the line breaks.
    """

    async def followed() -> None:
        async with linked(port, patience) as hub:
            if source:
                await hub.upload(source)
                await hub.start()
            await _listen(hub, hear, clock() + seconds, clock)
            if source and hub.running:
                await hub.stop()
                await _listen(hub, hear, float("inf"), clock)

    asyncio.run(followed())


async def _listen(hub: HubLink, hear: Callable[[str], None], end: float, clock: Callable[[], float]) -> None:
    """Until the program ends, or that time comes."""
    began = hub.running
    while clock() < end and not (began and not hub.running):
        await hub.news(LOOK)
        began = began or hub.running
        lines, hub.heard = hub.heard, []
        for line in lines:
            hear(line)
        if hub.lost:
            raise HubLost(f"{hub.name} does not answer", likely="it is out of reach, or off", hint="come nearer")
