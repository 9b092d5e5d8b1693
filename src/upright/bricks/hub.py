"""A virtual Pybricks hub: it speaks the Pybricks profile as a Bluetooth peripheral, keeps a program and runs it.

Source: Pybricks, "Pybricks BLE profile" and `pbio/protocol.h`, version 1.4. The program is the .mpy that the computer
sends; MicroPython runs it among stand-ins for the hub's modules, with the twin round it.
"""

from __future__ import annotations

import asyncio
import math
import struct
from collections import deque
from collections.abc import Callable, Sequence
from enum import IntEnum
from typing import Any

from upright.atomic import write_bytes
from upright.bricks.script import Reply, Script
from upright.bricks.world import World
from upright.firmware.targets import BATTERY, ENCODERS, GYRO

SERVICE = "c5f5{:04x}-8280-46da-89f4-6d8051e4aeef"
STANDARD = "{:08x}-0000-1000-8000-00805f9b34fb"
COMMANDS, CAPABILITIES = SERVICE.format(2), SERVICE.format(3)
FIRMWARE_REVISION, SOFTWARE_REVISION, PNP_ID = (STANDARD.format(n) for n in (0x2A26, 0x2A28, 0x2A50))

FIRMWARE, PROTOCOL = "3.5.0", "1.4.0"
LEGO, PRIME = 0x0397, 0x81  # company, and kind of hub, as Bluetooth's PnP ID has them
# bytes of a command, of a piece of output, of a program
LONGEST_WRITE = 158
LONGEST_NOTE = 100
MEMORY = 255 * 1024
MPY6 = 0b110  # capabilities: programs of several files, in MicroPython's format 6 and 6.1
BATTERY_LOW, RUNNING = 1 << 0, 1 << 6  # status flags
STATUS, OUTPUT = 0, 1  # events
LOW_BATTERY = 6800  # [mV] below which a Prime hub warns (pbio/sys/battery.c)
PACE = 0.005  # [s] of a note of output over the air (guess)
NOTES_AT_ONCE = 5  # notes sent at once; while more are queued the program waits, as on a hub
MOST_STOPS = 100  # stop requests to a program before it is killed
SLICE = 0.005  # [s] of the hub's time between two looks at the line


class Refusal(IntEnum):
    """Errors of the attribute protocol with which a hub answers a command."""

    TOO_LONG = 0x0D
    NOT_ALLOWED = 0x13
    UNKNOWN = 0x80
    BUSY = 0x81


class CommandRefused(Exception):
    """A command that the hub answers with an error code."""


class VirtualHub:
    """A hub in the simulated `world`; `absent` names empty ports. `run` advances its program, not beyond `until` [s].

    `speed` is its time over real time (None: as fast as possible). With `silent` it does not answer, `cut` breaks the
    connection, `press` is its button. `garbled` changes each piece of output on the air. A program that prints while
    somebody listens waits for room, at a `pace` [s] for each note of `shims/pybricks.shim`; `tells` is whether the
    firmware tells that there is room, as it does from version 4 on.
    """

    name = "virtual"

    def __init__(
        self,
        world: World,
        absent: Sequence[str] = (),
        speed: float | None = None,
        *,
        pace: float = PACE,
        tells: bool = False,
    ) -> None:
        self.world = world
        self.speed = speed
        self.until = math.inf
        self.firmware = FIRMWARE
        self.protocol = PROTOCOL
        self.capable = MPY6
        self.silent = False
        self.pressed = False
        self.duties = (0.0, 0.0)
        self.battery: float | None = None  # [mV] instead of the world's
        self.garbled: Callable[[bytes], bytes] = bytes
        self.notify: Callable[[bytes], None] | None = None
        self._lost: Callable[[], None] | None = None
        self._notes = deque[bytes]()  # queued for the air
        self._memory = bytearray(MEMORY)
        self._size = 0
        self._typed = b""
        self._stopped = False
        self._script = Script("pybricks", absent, pace, tells)
        self._stops = 0
        self.running = False
        self.seconds = 0.0
        self._clock = 0.0
        self._sent = 0

    def read(self, uuid: str) -> bytes:
        """A characteristic's value."""
        values = {
            FIRMWARE_REVISION: self.firmware.encode(),
            SOFTWARE_REVISION: self.protocol.encode(),
            PNP_ID: struct.pack("<BHHH", 1, LEGO, PRIME, 0),
            CAPABILITIES: struct.pack("<HII", LONGEST_WRITE, self.capable, MEMORY),
        }
        return values[uuid]

    def write(self, uuid: str, data: bytes) -> None:
        """A command; raises `CommandRefused`."""
        if uuid != COMMANDS or not data or data[0] not in HANDLERS:
            raise CommandRefused(Refusal.UNKNOWN)
        if len(data) > LONGEST_WRITE:
            raise CommandRefused(Refusal.TOO_LONG)
        try:
            HANDLERS[data[0]](self, bytes(data[1:]))
        except struct.error:
            raise CommandRefused(Refusal.NOT_ALLOWED) from None

    def run(self, seconds: float) -> None:
        """Run the program for that time [s] or to its end."""
        end = min(self.seconds + seconds, self.until)
        while self.running and (self.seconds < end or self._stopped):
            self._step()

    def press(self) -> None:
        """The button: the program prints its last lines and stops, motors off."""
        self._stopped = self.running
        self.run(0.0)

    def cut(self) -> None:
        """Break the connection; the program runs on."""
        self.notify = None
        lost = self._lost
        self._lost = None
        self._notes.clear()
        if lost:
            lost()

    def client(self, lost: Callable[[], None]) -> HubClient:
        """What bleak's client would be for this hub."""
        self._lost = lost
        return HubClient(self)

    def report(self) -> None:
        """Send the status flags."""
        battery = self.world.raw()[BATTERY] if self.battery is None else self.battery
        flags = (BATTERY_LOW if battery < LOW_BATTERY else 0) | (RUNNING if self.running else 0)
        self._send(bytes([STATUS]) + struct.pack("<IB", flags, 0))

    def close(self) -> None:
        self._script.close()
        self.world.close()

    def begin(self) -> None:
        """Start the program in memory; `CommandRefused` where there is none."""
        if self.running:
            raise CommandRefused(Refusal.BUSY)
        modules = unpacked(bytes(self._memory[: self._size]))
        for old in self._script.folder.glob("*.mpy"):
            old.unlink()
        for name, code in modules.items():
            write_bytes(self._script.folder / f"{'balance' if name == '__main__' else name}.mpy", code)
        self._script.start()
        self.running = True
        self.seconds = 0.0
        self._clock = 0.0
        self._sent = 0
        self._typed = b""
        self._stopped = False
        self._stops = 0
        self.report()

    def _step(self) -> None:
        raw = self.world.raw()
        if self.battery is not None:
            raw[BATTERY] = self.battery
        if self._stopped:
            reply = self._script.interrupt() if self._stops < MOST_STOPS else None
            self._stops += 1
        else:
            readings = [raw[channel] for channel in (*ENCODERS, GYRO, BATTERY)]
            reply = self._script.exchange(readings, self.pressed, self._typed, self.notify is not None)
        self._typed = b""
        self._send_output()
        if reply is None:
            self._ended()
        else:
            self._move(reply)

    def _move(self, reply: Reply) -> None:
        """Let the time of a wait pass, with the duties that were set before it."""
        self.duties = reply.duties or (0.0, 0.0)
        before, now = (round(clock * 1e-3 / self.world.period) for clock in (self._clock, reply.clock))
        for _ in range(now - before):
            self.world.step(self.duties, reply.duties is not None)
        self.seconds += (reply.clock - self._clock) * 1e-3
        self._clock = reply.clock

    def _ended(self) -> None:
        """Motors off and status sent, as the firmware does whenever a program ends."""
        self._script.stop()
        self.running = False
        self._stopped = False
        self.duties = (0.0, 0.0)
        self.report()

    def _send_output(self) -> None:
        """Send the program's new output, in pieces."""
        output = "".join(f"{line}\r\n" for line in self._script.lines[self._sent :]).encode()
        self._sent = len(self._script.lines)
        for at in range(0, len(output), LONGEST_NOTE):
            self._send(bytes([OUTPUT]) + self.garbled(output[at : at + LONGEST_NOTE]))

    def _send(self, note: bytes) -> None:
        if self.notify:
            self._notes.append(note)

    def flush(self) -> bool:
        """Send the next queued notes; whether some are left."""
        for _ in range(min(NOTES_AT_ONCE, len(self._notes))):
            note = self._notes.popleft()
            if self.notify and not self.silent:
                self.notify(note)
        return bool(self._notes)

    def stop(self, _: bytes = b"") -> None:
        """Request a stop; the program stops at its next wait."""
        self._stopped = self.running

    def start(self, _: bytes = b"") -> None:
        if not self._size:
            raise CommandRefused(Refusal.NOT_ALLOWED)
        self.begin()

    def measure(self, data: bytes) -> None:
        """Set the size of the program in memory: 0 while it is being written."""
        (size,) = struct.unpack("<I", data)
        self._idle(size <= MEMORY)
        self._size = size

    def store(self, data: bytes) -> None:
        (at,), code = struct.unpack_from("<I", data), data[4:]
        self._idle(at + len(code) <= MEMORY)
        self._memory[at : at + len(code)] = code

    def type(self, data: bytes) -> None:
        self._typed += data

    def _idle(self, fits: bool) -> None:
        if self.running:
            raise CommandRefused(Refusal.BUSY)
        if not fits:
            raise CommandRefused(Refusal.NOT_ALLOWED)


HANDLERS: dict[int, Callable[[VirtualHub, bytes], None]] = {
    0: VirtualHub.stop, 1: VirtualHub.start, 3: VirtualHub.measure, 4: VirtualHub.store, 6: VirtualHub.type,
}  # fmt: skip
"""Number of a command → its function."""


def unpacked(program: bytes) -> dict[str, bytes]:
    """Name → .mpy of every module in a program as pybricksdev packs it: size, name, code, and so on."""
    modules: dict[str, bytes] = {}
    while program:
        size = int.from_bytes(program[:4], "little")
        name, zero, rest = program[4:].partition(b"\0")
        if not zero or len(rest) < size:
            raise CommandRefused(Refusal.NOT_ALLOWED)
        modules[name.decode("ascii", "replace").replace("/", "")] = rest[:size]
        program = rest[size:]
    return modules


class HubClient:
    """A hub as bleak's client shows one: the same calls, and while it is connected the hub's time goes on."""

    def __init__(self, hub: VirtualHub) -> None:
        self._hub = hub
        self._life: asyncio.Task[None] | None = None

    async def connect(self) -> None:
        await self._answered()
        self._life = asyncio.create_task(self._live())

    async def disconnect(self) -> None:
        if self._life:
            self._life.cancel()
        self._hub.cut()

    async def read_gatt_char(self, uuid: str) -> bytearray:
        await self._answered()
        return bytearray(self._hub.read(uuid))

    async def write_gatt_char(self, uuid: str, data: bytes, response: bool) -> None:
        from bleak.exc import BleakError

        del response
        await self._answered()
        if self._hub.notify is None:
            raise BleakError("Not connected")
        try:
            self._hub.write(uuid, bytes(data))
        except CommandRefused as error:
            code = Refusal(error.args[0])
            raise BleakError(f"the hub answers {code:#04x}, {code.name.lower().replace('_', ' ')}") from None

    async def start_notify(self, uuid: str, callback: Callable[[Any, bytearray], None]) -> None:
        await self._answered()
        if uuid == COMMANDS:
            self._hub.notify = lambda note: callback(None, bytearray(note))
            self._hub.report()

    async def _answered(self) -> None:
        if self._hub.silent:
            await asyncio.Event().wait()

    async def _live(self) -> None:
        """The hub's time: a slice of it, then whoever waits for the line has a turn."""
        loop = asyncio.get_running_loop()
        while True:
            began = loop.time()
            if not self._hub.flush():
                self._hub.run(SLICE)
            idle = not self._hub.running or self._hub.seconds >= self._hub.until
            pace = SLICE / self._hub.speed if self._hub.speed else 0.0
            await asyncio.sleep(SLICE / 10 if idle else max(0.0, pace - loop.time() + began))
