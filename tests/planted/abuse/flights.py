"""Faults at every moment of a flight, on the virtual brick and the virtual hub.

Each row is a device, a moment and how many faults were planted at it. It holds where after each of them the motors are
off, or the user was told that they may be running, and the log is here, or on the device with a word about it.
"""

from __future__ import annotations

import asyncio
import contextlib
import io
import os
import random
import signal
import struct
import tempfile
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cache, partial
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from upright.bricks.brick import POWER
from upright.bricks.hub import CAPABILITIES, COMMANDS, HubClient, VirtualHub
from upright.bricks.lcp import VirtualBrick
from upright.bricks.line import Line
from upright.control import lqg
from upright.execution.execute_nxc import compile_nxc
from upright.firmware import generate
from upright.firmware.targets import BATTERY, ENCODERS, GYRO
from upright.flight import Flight
from upright.flight import fly_nxt as nxt
from upright.flight.fly_hub import fly_hub
from upright.flight.fly_nxt import fly_nxt
from upright.robots import Kit, Robot

MOMENTS = ("connect", "upload", "start", "running", "stop", "fetch")
PATIENCE = 1.2  # [s] for an answer of a device in this very process
SECONDS = 0.5  # of a flight, of the device's time
STILL = 1.0  # [s] of a hub's program before it drives
NEVER = 10**9
LONGEST = 1200  # [s] of real time for one flight: it takes a few
MAY_RUN = "motors may be running"

NXC = """
#define SECONDS 60
struct log_row { int a; int b; int c; int d; int battery; int e; int f; int time; };
log_row row;
byte handle;
task main() {
  DeleteFile("balance.log");
  CreateFile("balance.log", 3000, handle);
  string head = "robot=bench;kit=nxt;hash=00;period=0.01;every=1\\r\\n";
  int written = StrLen(head);
  WriteString(handle, head, written);
  SetOutput(OUT_B, Power, 30, OutputMode, OUT_MODE_MOTORON, RunState, OUT_RUNSTATE_RUNNING, UpdateFlags, 6);
  SetOutput(OUT_C, Power, 30, OutputMode, OUT_MODE_MOTORON, RunState, OUT_RUNSTATE_RUNNING, UpdateFlags, 6);
  row.battery = 8000;
  while (true) { Write(handle, row); row.time += 10; Wait(10); }
}
"""
"""A program that drives for ever and keeps a log like that of a balancing one, of little work for a virtual brick."""


@dataclass
class Outcome:
    """What a flight came to: its result or its error, and the truth about the device afterwards."""

    flight: Flight | None
    error: BaseException | None
    drove: bool
    off: bool
    stored: bool  # whether the device has a log

    @property
    def words(self) -> str:
        return " | ".join(self.flight.notes) if self.flight else str(self.error)

    @property
    def wrong(self) -> str:
        """What a user would complain of; empty where nothing."""
        if not self.off and MAY_RUN not in self.words:
            return "motors run and nobody is told"
        if "unexpected" in self.words or "\n" in self.words:
            return f"not one line: {self.words}"
        if isinstance(self.error, KeyboardInterrupt):
            return "interrupted without a log" if self.drove else ""
        kept = self.flight is not None and self.flight.log is not None
        if self.drove and self.stored and not kept and "--fetch" not in self.words:
            return "its log is on the device, and nobody is told"
        return "" if kept or self.words else "no log, and no reason"


Fault = Callable[[Any, Callable[[], Any]], Any]
"""What becomes of a request: given the rig and what answers it, the reply."""


@dataclass
class Planted:
    """A `fault` at `moment`, for the first `times` requests of it."""

    fault: Fault | None = None
    moment: str = ""
    times: int = 1
    happened: int = 0

    def answer(self, rig: Any, moment: str, truly: Callable[[], Any]) -> Any:
        if self.fault is None or moment != self.moment or self.happened >= self.times:
            return truly()
        self.happened += 1
        return self.fault(rig, truly)


class Brick(VirtualBrick):
    """A virtual brick with a `planted` fault on its line."""

    def __init__(self, planted: Planted) -> None:
        super().__init__()
        self.planted, self.moment, self.drove, self.request = planted, "connect", False, b""
        self.line: Line | None = None
        self.hardware.inputs[0].raw = 600
        setting = self.hardware.set_output

        def watched(ports: Any, settings: Any) -> None:
            self.drove = self.drove or any(item == POWER and value for item, value in settings)
            setting(ports, settings)

        self.hardware.set_output = watched

    def telegram(self, data: bytes) -> bytes:
        self.request, command = data, (data[0] & 1, data[1]) if len(data) > 1 else (9, 9)
        self.moment = self._moment(command)
        reply = self.planted.answer(self, self.moment, lambda: VirtualBrick.telegram(self, data))
        if command == (0, 0):
            self.moment = "running"
        return reply

    def _moment(self, command: tuple[int, int]) -> str:
        if command == (0, 0):
            return "start"
        if command == (0, 1) and self.moment in ("running", "stop"):
            return "stop"
        if self.moment in ("stop", "running") and command[0] == 1 and command[1] in (0x80, 0x86):
            return "fetch"
        return "upload" if self.moment == "connect" and command[0] == 1 and command[1] == 0x85 else self.moment

    def frame(self, reply: bytes) -> bytes:
        return struct.pack("<H", len(reply)) + reply


def _once(change: Callable[[Brick, bytes], bytes]) -> Fault:
    """A fault of the reply alone: the request is obeyed."""
    return lambda brick, truly: change(brick, truly())


def _status(code: int) -> Fault:
    """The brick refuses the request, and does not obey."""
    return lambda brick, _: bytes([2, brick.request[1], code]) + bytes(25)


def _noise(_: Brick, reply: bytes) -> bytes:
    return random.Random(len(reply)).randbytes(max(3, len(reply)))


def _later(seconds: float, act: Callable[[], Any]) -> None:
    threading.Timer(seconds, act).start()


def _unheard(_: Brick, __: Callable[[], bytes]) -> bytes:
    return b""


def _gone(brick: Brick, _truly: Callable[[], bytes]) -> bytes:
    if brick.line:
        _later(0, brick.line.cut)
    return b""


def _gone_after(brick: Brick, truly: Callable[[], bytes]) -> bytes:
    truly()
    return _gone(brick, truly)


def _slow(part: float) -> Fault:
    """The reply comes after so much of `PATIENCE`."""

    def slow(_: Brick, truly: Callable[[], bytes]) -> bytes:
        reply = truly()
        time.sleep(part * PATIENCE)
        return reply

    return slow


def _raw(make: Callable[[bytes], bytes]) -> Fault:
    """Bytes on the line in place of the framed reply."""

    def written(brick: Brick, truly: Callable[[], bytes]) -> bytes:
        reply = truly()
        if brick.line:
            os.write(brick.line._ours, make(brick.frame(reply)))
        return b""

    return written


def _after(act: Callable[[Brick], Any]) -> Fault:
    """Something happens to the brick, and the request is answered."""

    def acted(brick: Brick, truly: Callable[[], bytes]) -> bytes:
        act(brick)
        return truly()

    return acted


def _interrupt(times: int) -> Callable[[Any], None]:
    def press(_: Any) -> None:
        for k in range(times):
            _later(0.15 * k, lambda: os.kill(os.getpid(), signal.SIGINT))

    return press


def _flat(brick: Brick) -> None:
    brick.hardware.battery = 0


def _forget(brick: Brick) -> None:
    brick.hardware.flash.delete("balance.log")


def _scramble(brick: Brick) -> None:
    if "balance.log" in brick.hardware.flash.files:
        brick.hardware.flash.files["balance.log"][:] = b"\xff" * 100


def _fill(brick: Brick) -> None:
    brick.hardware.flash.capacity = 0


def _restart(brick: Brick) -> None:
    brick.stop()


def _handles(brick: Brick) -> None:
    brick.hardware.flash.close_all()


REPLIES: dict[str, Fault] = {
    "garbled": _once(_noise),
    "lost reply": _once(lambda _, _reply: b""),
    "lost request": _unheard,
    "cut short": _once(lambda _, reply: reply[:2]),
    "too long": _once(lambda _, reply: reply + bytes(40)),
    "of another request": _once(lambda _, reply: reply[:1] + b"\x77" + reply[2:]),
    "no reply's type": _once(lambda _, reply: b"\x00" + reply[1:]),
    "wrong frame": _raw(lambda frame: b"\xff\xff" + frame),
    "half a frame": _raw(lambda frame: frame[: len(frame) // 2]),
    "two replies": _raw(lambda frame: 2 * frame),
    "noise before it": _raw(lambda frame: b"\x00\x00" + frame),
    "slow": _slow(0.5),
    "too late": _slow(2),
    "busy": _status(0x20),
    "refused": _status(0xDD),
    "out of memory": _status(0xFA),
    "flash full": _status(0xFB),
    "wrong file": _status(0x87),
    "no more handles": _status(0x81),
    "file is busy": _status(0x8B),
    "program error": _status(0xE5),
    "unknown command": _status(0xBE),
    "no status of LEGO's": _status(0x42),
}
"""Faults that may come once, three times, or for ever."""
EVENTS: dict[str, Fault] = {
    "cable out": _gone,
    "cable out after it": _gone_after,
    "battery flat": _after(_flat),
    "program ends": _after(_restart),
    "log deleted": _after(_forget),
    "log overwritten": _after(_scramble),
    "flash filled": _after(_fill),
    "handles closed": _after(_handles),
    "Ctrl-C": _after(_interrupt(1)),
    "Ctrl-C twice": _after(_interrupt(2)),
}
TIMES = {"": 1, " twice": 2, " for ever": NEVER}
ON_BRICK: dict[str, tuple[Fault, int]] = {
    **{name + word: (fault, n) for name, fault in REPLIES.items() for word, n in TIMES.items()},
    **{name: (fault, 1) for name, fault in EVENTS.items()},
}
"""Name → fault on the line to a brick, and how many requests it hits."""


@cache
def _compiled() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "drive.nxc"
        source.write_text(NXC)
        return compile_nxc(source, Path(folder)).read_bytes()


def on_brick(fault: str, moment: str) -> Outcome:
    """The outcome of a flight with the `fault` of `ON_BRICK` at `moment`."""
    planted = Planted(*_at(ON_BRICK[fault], moment))
    brick = Brick(planted)
    program: Any = SimpleNamespace(robot="bench", kit="nxt", hash="00", period=0.01)
    with tempfile.TemporaryDirectory() as folder, Line(brick) as line:
        brick.line, line.until = line, 5.0
        source, binary = Path(folder) / "drive.nxc", Path(folder) / "drive.rxe"
        source.write_text(NXC)
        binary.write_bytes(_compiled())
        compiler, nxt.compile_nxc = nxt.compile_nxc, lambda *_: binary
        try:
            fly = partial(fly_nxt, clock=lambda: brick.seconds, patience=PATIENCE)
            flight, error = _flown(lambda: fly(source, program, line.path, SECONDS))
        finally:
            nxt.compile_nxc = compiler
        off = all(motor.duty == 0 for motor in brick.hardware.motors)
        left = bytes(brick.hardware.flash.files.get("balance.log", b""))
        stored = len(left) > 100 and left.startswith(b"robot=")  # one that was overwritten is lost
    return Outcome(flight, error, brick.drove, off, stored)


def _at(fault: tuple[Fault, int], moment: str) -> tuple[Fault, str, int]:
    return fault[0], moment, fault[1]


def _flown(fly: Callable[[], Flight]) -> tuple[Flight | None, BaseException | None]:
    with contextlib.redirect_stderr(io.StringIO()):
        try:
            flight, error = fly(), None
            time.sleep(0)  # an interrupt that came last is raised here
        except (Exception, KeyboardInterrupt) as raised:
            flight, error = None, raised
    return flight, error


class Bench:
    """A hub's surroundings in which nothing moves."""

    period, fallen, released, yaw = 0.01, False, False, 0.0

    def step(self, _duties: Any, driven: bool) -> None:
        self.released = self.released or driven

    def raw(self) -> dict[str, float]:
        return dict.fromkeys(ENCODERS, 0.0) | {GYRO: 0.0, BATTERY: 8000.0}

    def close(self) -> None: ...


class Client(HubClient):
    """The line to a hub with a planted fault."""

    def __init__(self, hub: Hub) -> None:
        super().__init__(hub)
        self._faulty = hub

    async def connect(self) -> None:
        await self._planted("connect", super().connect)

    async def read_gatt_char(self, uuid: str) -> bytearray:
        if uuid == CAPABILITIES:
            return await super().read_gatt_char(uuid)
        return await self._planted("connect", lambda: super(Client, self).read_gatt_char(uuid))

    async def write_gatt_char(self, uuid: str, data: bytes, response: bool) -> None:
        moment = {0: "stop", 1: "start"}.get(data[0], "upload") if uuid == COMMANDS else "connect"
        self._faulty.moment = moment
        await self._planted(moment, lambda: super(Client, self).write_gatt_char(uuid, data, response))
        if moment == "start":
            self._faulty.moment = "running"

    async def _planted(self, moment: str, truly: Callable[[], Any]) -> Any:
        return await self._faulty.planted.answer(self._faulty, moment, truly)


class Hub(VirtualHub):
    """A virtual hub with a `planted` fault: on the line to it, or, while it runs and sends its log, in the hub."""

    def __init__(self, planted: Planted) -> None:
        super().__init__(Bench())  # type: ignore[arg-type]
        self.planted, self.moment, self.drove, self.deaf = planted, "connect", False, False
        self.garbled = self._sent_piece

    def client(self, lost: Callable[[], None]) -> HubClient:
        super().client(lost)
        return Client(self)

    def write(self, uuid: str, data: bytes) -> None:
        if not (self.deaf and data[:1] == b"\0"):
            super().write(uuid, data)

    def _sent_piece(self, piece: bytes) -> bytes:
        moment = "fetch" if self.moment == "stop" else self.moment
        fault = self.planted.fault
        if moment in ("running", "fetch") and moment == self.planted.moment and fault in PIECES:
            return self.planted.answer(self, moment, lambda: piece)
        return piece

    def _move(self, reply: Any) -> None:
        super()._move(reply)
        self.drove = self.drove or reply.duties is not None
        moment, planted = "fetch" if self.moment == "stop" else self.moment, self.planted
        if moment == planted.moment and moment in ("running", "fetch") and self.seconds > STILL + 0.2:
            fault = INSIDE.get(planted.fault) if planted.fault else None
            if fault and not planted.happened:
                planted.happened += 1
                fault(self)


def _refuse(words: str) -> Fault:
    async def refused(_hub: Hub, _truly: Callable[[], Any]) -> None:
        from bleak.exc import BleakError

        raise BleakError(words)

    return refused


async def _reply_lost(_hub: Hub, truly: Callable[[], Any]) -> None:
    await truly()
    await asyncio.Event().wait()


async def _request_lost(_hub: Hub, _truly: Callable[[], Any]) -> None:
    await asyncio.Event().wait()


def _delayed(part: float) -> Fault:
    """The reply comes after so much of `PATIENCE`."""

    async def delayed(_hub: Hub, truly: Callable[[], Any]) -> Any:
        answer = await truly()
        await asyncio.sleep(part * PATIENCE)
        return answer

    return delayed


def _raise(error: type[Exception]) -> Fault:
    async def raised(_hub: Hub, _truly: Callable[[], Any]) -> None:
        raise error("on the line")

    return raised


def _happens(act: Callable[[Hub], Any], obeyed: bool = True) -> Fault:
    async def happened(hub: Hub, truly: Callable[[], Any]) -> Any:
        if not obeyed:
            act(hub)
            return await truly()
        answer = await truly()
        act(hub)
        return answer

    return happened


def _mute(hub: Hub) -> None:
    hub.silent = True


def _crash(hub: Hub) -> None:
    """The program ends, as the hub finds at its next step."""
    if hub.running:
        hub._script.lines.append("MemoryError: memory allocation failed")
        hub._script.signal(signal.SIGKILL)


def _empty(hub: Hub) -> None:
    hub.battery = 4000.0


def _deaf(hub: Hub) -> None:
    """It takes a stop, and goes on."""
    hub.deaf = True


def _piece(change: Callable[[bytes], bytes]) -> Fault:
    return lambda _, truly: change(truly())


LINK: dict[str, Fault] = {
    "refused": _refuse("the hub answers 0x81, busy"),
    "not allowed": _refuse("the hub answers 0x13, not allowed"),
    "lost reply": _reply_lost,
    "lost request": _request_lost,
    "slow": _delayed(0.5),
    "too late": _delayed(2),
    "input/output error": _raise(OSError),
    "end of the line": _raise(EOFError),
    "wrong answer": _raise(ValueError),
    "runtime error": _raise(RuntimeError),
}
HAPPENS: dict[str, Callable[[Hub], Any]] = {
    "out of reach": VirtualHub.cut,
    "silent": _mute,
    "program ends": VirtualHub.press,
    "out of memory": _crash,
    "battery flat": _empty,
    "deaf to a stop": _deaf,
    "Ctrl-C": _interrupt(1),
    "Ctrl-C twice": _interrupt(2),
}
GARBLED: dict[str, Fault] = {
    "garbled piece": _piece(lambda piece: bytes(b ^ 0x15 for b in piece)),
    "lost piece": _piece(lambda _: b""),
    "doubled piece": _piece(lambda piece: 2 * piece),
    "half a piece": _piece(lambda piece: piece[: len(piece) // 2]),
    "zeros": _piece(lambda piece: bytes(len(piece))),
    "no line ends": _piece(lambda piece: piece.replace(b"\n", b"")),
}
PIECES = set(GARBLED.values())
_EVENTS = {name: _happens(act) for name, act in HAPPENS.items()}
INSIDE = {_EVENTS[name]: act for name, act in HAPPENS.items()}
ON_HUB: dict[str, tuple[Fault, int]] = {
    **{name + word: (fault, n) for name, fault in LINK.items() for word, n in TIMES.items()},
    **{name: (fault, 1) for name, fault in _EVENTS.items()},
    **{name + word: (fault, n) for name, fault in GARBLED.items() for word, n in TIMES.items()},
}
"""Name → fault of a hub or of the line to it, and how many times it comes."""


def fits(fault: str, moment: str) -> bool:
    """Whether a fault of `ON_HUB` can happen at that moment: nothing is requested of a hub that runs or dumps."""
    if moment in ("running", "fetch"):
        return ON_HUB[fault][0] in PIECES or ON_HUB[fault][0] in INSIDE
    return ON_HUB[fault][0] not in PIECES


@cache
def _program() -> tuple[str, Any]:
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("spike")
    made = generate(lqg(robot, kit, kit.period), robot, kit, "pybricks")
    return made.text, made.program


def on_hub(fault: str, moment: str) -> Outcome:
    """The outcome of a flight with the `fault` of `ON_HUB` at `moment`."""
    text, program = _program()
    hub = Hub(Planted(*_at(ON_HUB[fault], moment)))
    hub.until = STILL + SECONDS
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "balance.py"
        source.write_text(text)
        fly = partial(fly_hub, clock=lambda: hub.seconds, patience=PATIENCE)
        flight, error = _flown(lambda: fly(source, program, hub, STILL + SECONDS))
    off = not hub.running
    stored = hub.running  # it keeps its log while its program lives
    hub.close()
    return Outcome(flight, error, hub.drove, off, stored)


DEVICES: dict[str, tuple[dict[str, Any], Callable[[str, str], Outcome]]] = {
    "brick": (ON_BRICK, on_brick),
    "hub": (ON_HUB, on_hub),
}


def cases() -> list[tuple[str, str, str]]:
    """Every device, moment and fault."""
    every = [
        (device, moment, fault) for device, (faults, _) in DEVICES.items() for moment in MOMENTS for fault in faults
    ]
    return [case for case in every if case[0] == "brick" or fits(case[2], case[1])]


def wrong(device: str, moment: str, fault: str) -> str:
    """What is wrong after that fault; empty where nothing."""
    signal.signal(signal.SIGALRM, _too_long)
    signal.alarm(LONGEST)
    try:
        return DEVICES[device][1](fault, moment).wrong
    except BaseException as error:
        return f"{type(error).__name__}: {error}"
    finally:
        signal.alarm(0)


def _too_long(*_: object) -> None:
    raise TimeoutError(f"still waiting after {LONGEST} s")


@dataclass
class Tally:
    """How many faults were planted, and what went wrong."""

    planted: int = 0
    wrong: list[str] = field(default_factory=list[str])


def measure(seed: int, minutes: float | None) -> Iterator[tuple[str, str, str, bool]]:
    """A row for each device and moment; all faults, or as many as fit into `minutes`, in the order of `seed`."""
    order, begun, tallies = cases(), time.monotonic(), dict[tuple[str, str], Tally]()
    random.Random(seed).shuffle(order)
    for device, moment, fault in order:
        if minutes and time.monotonic() - begun > 60 * minutes:
            break
        tally = tallies.setdefault((device, moment), Tally())
        tally.planted += 1
        if complaint := wrong(device, moment, fault):
            tally.wrong.append(fault)
            yield f"{device}, {moment}, {fault}: {complaint}", "", "", False
    for (device, moment), tally in sorted(tallies.items()):
        yield f"{device}, {moment}", f"{tally.planted - len(tally.wrong)} of {tally.planted}", "all", not tally.wrong
