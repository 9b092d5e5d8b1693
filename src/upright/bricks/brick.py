"""The devices of an NXT brick: ports, motors, buttons, battery, display, and files in its flash.

Numbers of ports, properties, system calls and results are those of the LEGO manuals: "MINDSTORMS NXT Executable File
Specification" 2.0 (appendix) and "NXT Communication Protocol" 1.1.
"""

from __future__ import annotations

import re
import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from upright.bricks.rxe import InvalidProgram
from upright.firmware.targets import BATTERY, ENCODERS
from upright.firmware.targets import COMPASS as BEARING
from upright.links.brick import REST, Wiring

# properties of an input port
KIND, MODE, RAW, NORMALISED, SCALED, INVALID = range(6)
# properties of an output port
FLAGS, OUT_MODE, POWER, ACTUAL, TACHO, TACHO_LIMIT, RUN_STATE, TURN, REGULATION, OVERLOAD = range(10)
BLOCK_TACHO, ROTATION = 13, 14
MOTOR_ON, RUNNING, RESET_TACHO, RESET_BLOCK, RESET_ROTATION = 0x01, 0x20, 0x08, 0x20, 0x40
# results
OK, NO_FILE, FILE_EXISTS, NO_HANDLE, END_OF_FILE, FLASH_FULL = 0, 0x8700, 0x8F00, 0x9300, 0x8500, 0xFB00
ILLEGAL_NAME = 0x9200
BUSY = 0x20  # of a digital sensor that has not answered yet

FLASH = 130_000  # bytes that a user's files may take, about what firmware 1.28 leaves of 256 KiB
HEADING = 0x42  # HiTechnic's compass: half the heading [2 deg], and the odd degree in the register after it
WIRED = Wiring()
UI_MODULE, BATTERY_OFFSET = 0x000C0001, 4  # where a program reads the battery [mV]


@dataclass
class Port:
    """An input: its sensor's `kind` and mode as the program set them, and the converter's `raw` reading."""

    kind: int = 0
    mode: int = 0
    raw: int = 0


@dataclass(kw_only=True)
class MotorPort:
    """An output: `power` [%] while it is on, and the `count` [°] of its encoder; resets only move `zero`.

    Its tacho limit is that of LEGO's published firmware for unregulated motors (d_output.c: dOutputSetTachoLimit,
    dOutputTachoLimitControl, dOutputMotorIdleControl), which looks at it every millisecond in the run state "running".
    A limit moves the `end` of the turn on, from the last end and not from where the motor is; without one (0) the end
    goes along with the motor. At the end the run state falls to idle, and the duty to nothing by 1 % a millisecond
    (`fading`), with the motor left to coast. Left out: regulated and synchronised motors, and that an order to be
    idle fades as well; here it acts at once.
    """

    mode: int = 0
    power: int = 0
    state: int = 0
    count: int = 0
    zero: int = 0
    limit: int = 0
    end: int = 0
    fading: int = 0

    @property
    def running(self) -> bool:
        return bool(self.mode & MOTOR_ON and self.state & RUNNING)

    @property
    def duty(self) -> int:
        """Duty at the motor [%]: its power while it runs, and after its limit what has not faded yet."""
        return self.power if self.running else self.fading

    def turn(self, limit: int) -> None:
        """Set an order's tacho limit [°], after its power."""
        self.limit = limit
        self.end += limit if self.power > 0 else -limit

    def tick(self, milliseconds: int) -> None:
        """Advance the firmware's control of the motor by that time."""
        if not self.running:
            size = max(0, abs(self.fading) - milliseconds)
            self.fading = size if self.fading > 0 else -size
        elif self.power and not self.limit:
            self.end = self.count
        elif self.power and (self.count - self.end) * self.power >= 0:
            self.state = 0
            self.fading = self.power


@dataclass
class OpenFile:
    """A file by name, how far it was read or written, and how much it may hold."""

    name: str
    at: int
    size: int
    writing: bool


@dataclass
class Flash:
    """The brick's files: whole ones by name, and the handles of those that are open."""

    files: dict[str, bytearray] = field(default_factory=dict[str, bytearray])
    sizes: dict[str, int] = field(default_factory=dict[str, int])
    handles: dict[int, OpenFile] = field(default_factory=dict[int, OpenFile])
    capacity: int = FLASH

    @property
    def free(self) -> int:
        """Bytes left; a file takes what it was opened for."""
        return self.capacity - sum(self.sizes.values())

    def create(self, name: str, size: int) -> tuple[int, int]:
        """(result, handle) of a new file of at most `size` bytes; its name is 15.3 characters at most."""
        if not re.fullmatch(r"[^.]{1,15}\.[^.]{1,3}", name, re.ASCII):
            return ILLEGAL_NAME, 0
        if name in self.files:
            return FILE_EXISTS, 0
        if size > self.free:
            return FLASH_FULL, 0
        self.files[name], self.sizes[name] = bytearray(), size
        return OK, self._handle(OpenFile(name, 0, size, True))

    def open(self, name: str) -> tuple[int, int, int]:
        """(result, handle, size) of a file to read."""
        if name not in self.files:
            return NO_FILE, 0, 0
        size = len(self.files[name])
        return OK, self._handle(OpenFile(name, 0, size, False)), size

    def write(self, handle: int, data: bytes) -> tuple[int, int]:
        """(result, bytes written); data that do not fit are not written."""
        file = self.handles.get(handle)
        if file is None or not file.writing:
            return NO_HANDLE, 0
        if file.at + len(data) > file.size:
            return END_OF_FILE, 0
        self.files[file.name] += data
        file.at += len(data)
        return OK, len(data)

    def read(self, handle: int, count: int) -> tuple[int, bytes]:
        """(result, data): at most `count` bytes."""
        file = self.handles.get(handle)
        if file is None:
            return NO_HANDLE, b""
        data = bytes(self.files[file.name][file.at : file.at + count])
        file.at += len(data)
        return (OK if len(data) == count else END_OF_FILE), data

    def close(self, handle: int) -> int:
        """Forget a handle."""
        return OK if self.handles.pop(handle, None) else NO_HANDLE

    def delete(self, name: str) -> int:
        """Remove a file."""
        if self.files.pop(name, None) is None:
            return NO_FILE
        self.sizes.pop(name)
        return OK

    def close_all(self) -> None:
        """As the brick does when a program ends."""
        self.handles.clear()

    def _handle(self, opened: OpenFile) -> int:
        handle = next(i for i in range(256) if i not in self.handles)
        self.handles[handle] = opened
        return handle


class Hardware:
    """The devices of a `vm.Machine`. `world(time [µs])` is called before every reading and setting, so that it can move
    the robot on and set `inputs`, `motors`, `registers` (of digital sensors by port), `battery` [mV] and `buttons`."""

    def __init__(self, world: Callable[[int], None] | None = None) -> None:
        self.inputs, self.motors = [Port() for _ in range(4)], [MotorPort() for _ in range(3)]
        self.registers: dict[int, dict[int, int]] = {}
        self.battery = 8000
        self.buttons = set[int]()
        self.lines = dict[int, str]()
        self.flash = Flash()
        self.world = world
        self.asked: dict[int, bytes] = {}  # port → answer of its digital sensor

    def reach(self, time: int) -> None:
        if self.world is not None:
            self.world(time)

    def stop(self) -> None:
        """Motors off and files closed, as the firmware does whenever a program ends."""
        for motor in self.motors:
            motor.mode = motor.power = motor.state = motor.limit = motor.fading = 0
        self.flash.close_all()

    def tick(self, milliseconds: int) -> None:
        """Advance the firmware's control of all motors."""
        for motor in self.motors:
            motor.tick(milliseconds)

    def get_input(self, port: int, item: int) -> int:
        p = self._port(port)
        values = {KIND: p.kind, MODE: p.mode, RAW: p.raw, NORMALISED: p.raw, SCALED: p.raw}
        return values.get(item, 0)

    def set_input(self, port: int, item: int, value: int) -> None:
        if item == KIND:
            self._port(port).kind = value
        elif item == MODE:
            self._port(port).mode = value

    def get_output(self, port: int, item: int) -> int:
        motor = self._motor(port)
        turned = motor.count - motor.zero
        values = {OUT_MODE: motor.mode, POWER: motor.power, ACTUAL: motor.duty, RUN_STATE: motor.state}
        values |= {TACHO_LIMIT: motor.limit}
        return turned if item in (TACHO, BLOCK_TACHO, ROTATION) else values.get(item, 0)

    def set_output(self, ports: Sequence[int], settings: Sequence[tuple[int, int]]) -> None:
        for motor in map(self._motor, ports):
            for item, value in settings:
                if item == POWER:
                    motor.power = max(-100, min(100, value))
                elif item == OUT_MODE:
                    motor.mode = value
                elif item == RUN_STATE:
                    motor.state, motor.fading = value, 0
                elif item == FLAGS and value & (RESET_TACHO | RESET_BLOCK | RESET_ROTATION):
                    motor.zero = motor.count

    def ask(self, port: int, message: bytes, count: int) -> None:
        """A message to a digital sensor: its address and a register; its answer goes into `asked`."""
        registers = self.registers.get(port, {})
        first = message[1] if len(message) > 1 else 0
        self.asked[port] = bytes(registers.get(first + i, 0) for i in range(count))

    def call(self, number: int, arguments: list[Any]) -> None:
        """A system call: `arguments` are the members of its cluster, results among them."""
        if number not in CALLS:
            raise InvalidProgram(f"system call {number} is not emulated", expected="a call that balancing programs use")
        CALLS[number](self, arguments)

    def _port(self, port: int) -> Port:
        if not 0 <= port < len(self.inputs):
            raise InvalidProgram(f"the program uses input {port + 1}", expected="1 to 4")
        return self.inputs[port]

    def _motor(self, port: int) -> MotorPort:
        if not 0 <= port < len(self.motors):
            raise InvalidProgram(f"the program uses motor {port}", expected="A to C")
        return self.motors[port]


def _name(text: bytearray) -> str:
    return bytes(text).split(b"\0")[0].decode("ascii", "replace")


def _open_read(brick: Hardware, a: list[Any]) -> None:
    a[0], a[1], a[3] = brick.flash.open(_name(a[2]))


def _open_write(brick: Hardware, a: list[Any]) -> None:
    a[0], a[1] = brick.flash.create(_name(a[2]), a[3])


def _read(brick: Hardware, a: list[Any]) -> None:
    a[0], data = brick.flash.read(a[1], a[3])
    a[2], a[3] = bytearray(data), len(data)


def _write(brick: Hardware, a: list[Any]) -> None:
    a[0], a[3] = brick.flash.write(a[1], bytes(a[2][: a[3]]))


def _close(brick: Hardware, a: list[Any]) -> None:
    a[0] = brick.flash.close(a[1])


def _delete(brick: Hardware, a: list[Any]) -> None:
    a[0] = brick.flash.delete(_name(a[1]))


def _text(brick: Hardware, a: list[Any]) -> None:
    a[0], brick.lines[7 - a[2] // 8] = OK, _name(a[3])


def _button(brick: Hardware, a: list[Any]) -> None:
    a[0], a[2] = OK, a[1] in brick.buttons


def _ask_sensor(brick: Hardware, a: list[Any]) -> None:
    brick.ask(a[1], bytes(a[2]), a[3])
    a[0] = OK


def _sensor_ready(brick: Hardware, a: list[Any]) -> None:
    a[0], a[2] = OK, len(brick.asked.get(a[1], b""))


def _sensor_answer(brick: Hardware, a: list[Any]) -> None:
    data = brick.asked.pop(a[1], b"")
    a[0], a[2], a[3] = (OK if data else BUSY), bytearray(data), len(data)


def _read_module(brick: Hardware, a: list[Any]) -> None:
    if (a[1], a[2]) != (UI_MODULE, BATTERY_OFFSET):
        raise InvalidProgram(f"the program reads module 0x{a[1]:08x} at {a[2]}", expected="the battery alone")
    a[0], a[4] = OK, bytearray(struct.pack("<H", brick.battery)[: a[3]])


def _accepted(_: Hardware, a: list[Any]) -> None:
    """A tone or a cleared screen, without effect on the robot."""
    a[0] = OK


CALLS: Mapping[int, Callable[[Hardware, list[Any]], None]] = {
    0: _open_read, 1: _open_write, 3: _read, 4: _write, 5: _close, 8: _delete, 9: _accepted, 10: _accepted, 13: _text,
    19: _accepted, 20: _button, 21: _ask_sensor, 22: _sensor_answer, 23: _sensor_ready, 31: _accepted, 78: _read_module,
}  # fmt: skip
"""Number of a system call → its function."""


def set_readings(hardware: Hardware, raw: Mapping[str, float], wiring: Wiring = WIRED) -> None:
    """Set the sensors that a generated program reads, at the ports of its `wiring`, to `raw` readings by channel."""
    hardware.inputs[wiring.gyro].raw = REST + wiring.gyro_sign * round(raw["sensor/gyro"])
    hardware.battery = round(raw[BATTERY])
    for port, channel in zip((wiring.left, wiring.right), ENCODERS, strict=True):
        hardware.motors[port].count = round(raw[channel])
    if BEARING in raw:
        upper, lower = divmod(round(raw[BEARING]) % 360, 2)
        hardware.registers[wiring.compass] = {HEADING: upper, HEADING + 1: lower}
