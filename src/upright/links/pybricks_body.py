"""A Pybricks hub commanded from this computer: twenty times a second, too slow for balancing."""

from __future__ import annotations

import asyncio
import binascii
from collections.abc import Sequence
from contextlib import AsyncExitStack, suppress
from importlib.resources import files
from pathlib import Path

from upright.atomic import TemporaryFolder, write_text
from upright.links.hub import HubLink, HubLost, HubRefused, Peripheral, linked
from upright.links.remote import STILL, Reading, RemoteBody
from upright.robots import Robot

PERIOD = 0.05  # [s] as `remote.micropython` has it: a line to a hub and back takes 20 to 40 ms over Bluetooth
FRESH = 8.4  # [V] of two full lithium cells


class PybricksBody(RemoteBody):
    """`robot` on a Pybricks hub at `port`: ble, ble:NAME, or a virtual one. The hub runs a small program that takes
    duties as lines, reads its sensors every `PERIOD`, and stops its motors after half a second without a line.

    Far too slow for balancing, good for measuring motors and sensors on a robot that lies or hangs. There is no truth,
    it cannot be put into a state, and nothing tells whether it has fallen. `program` is that program where the robot is
    built differently. `overruns` counts readings that came while nobody had asked. It connects at the first `reset`,
    for a second of which it must be still. Raises `SpecMismatch`, and like `linked`.
    """

    def __init__(self, robot: Robot, port: str | Peripheral = "ble", *, program: Path | None = None) -> None:
        real = isinstance(port, str)
        kind = "Pybricks hub over Bluetooth" if real else "virtual Pybricks hub with the twin round it"
        super().__init__(kind, robot, PERIOD, FRESH, real)
        self._port = port
        self._program = program
        self._runner = asyncio.Runner()
        self._stack = AsyncExitStack()
        self._hub = None
        self._tick = 0
        self._time = 0
        self._began = 0

    def _begin(self) -> Sequence[Reading]:
        return self._runner.run(self._begun())

    def _exchange(self, duties: Sequence[int]) -> tuple[float, Reading, Sequence[int]]:
        return self._runner.run(self._exchanged(duties))

    def close(self) -> None:
        """End the program, motors first, and let go of the hub."""
        self._runner.run(self._close())

    async def _begun(self) -> Sequence[Reading]:
        hub = self._hub or await self._connected()
        if hub.running:
            await self._ended(hub)
        await hub.start()
        self._tick = 0
        still = [(await self._next(hub))[0] for _ in range(STILL)]
        self._began = self._time
        return still

    async def _exchanged(self, duties: Sequence[int]) -> tuple[float, Reading, Sequence[int]]:
        hub = self._hub or await self._connected()
        order = f"{duties[0]} {duties[1]}".encode()
        await hub.write(order + b"*%04X\n" % binascii.crc_hqx(order, 0xFFFF))
        self._newest(hub)  # readings from before the order arrived
        reading, really = await self._next(hub)
        return (self._time - self._began) / 1000, reading, really

    async def _connected(self) -> HubLink:
        hub = await self._stack.enter_async_context(linked(self._port))
        with TemporaryFolder() as folder:
            source = Path(folder) / "remote.py"
            text = self._program or (files("upright.links") / "remote.micropython")
            write_text(source, text.read_text(encoding="utf-8"))
            if hub.running:
                await self._ended(hub)
            await hub.upload(source)
        self._hub = hub
        return hub

    async def _next(self, hub: HubLink) -> tuple[Reading, tuple[int, int]]:
        """The newest whole reading, once there is one, and the duties it was taken under."""
        while True:
            row = self._newest(hub)
            if row:
                left, right, gyro, battery, *duties = row
                return Reading(left, right, gyro / 1000, battery / 1000), (duties[0], duties[1])
            if hub.lost or not await hub.news(hub.patience):
                raise HubLost(f"{hub.name} does not answer", likely="it is out of reach, or off", hint="come nearer")
            if not hub.running:
                raise HubRefused(f"the program on {hub.name} ended: {' '.join(hub.lines[-1:]) or 'without output'}")

    def _newest(self, hub: HubLink) -> list[int]:
        """The numbers of the newest whole reading that has come, nothing where none has; the older ones are late."""
        lines, hub.lines = hub.lines, []
        rows = [row for row in map(_row, lines) if row]
        if not rows:
            hub.lines = [line for line in lines if line]  # its last words, perhaps
            return []
        tick, *values, self._time = rows[-1]
        self.overruns = self.overruns + tick - self._tick - 1
        self._tick = tick
        return values

    async def _ended(self, hub: HubLink) -> None:
        await hub.stop()
        while hub.running and not hub.lost:
            await hub.news(hub.patience)

    async def _close(self) -> None:
        hub = self._hub
        self._hub = None
        if hub:
            with suppress(HubLost, HubRefused):
                await self._ended(hub)
        await self._stack.aclose()


def _row(line: str) -> list[int]:
    """The numbers of a whole line of readings, nothing for any other."""
    text, _, crc = line.rpartition("*")
    try:
        whole = text.startswith("R ") and int(crc, 16) == binascii.crc_hqx(text.encode(), 0xFFFF)
        return [int(word) for word in text.split()[1:]] if whole else []
    except ValueError:
        return []
