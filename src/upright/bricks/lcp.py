"""A virtual NXT brick on the line: it answers LEGO's telegrams, keeps files, and runs the programs it is given.

Source: LEGO, "MINDSTORMS NXT Communication Protocol" 1.1, and its appendix 2 for direct commands. A telegram is
a type, a command and arguments; the reply is 0x02, the command, a status, and results.
"""

from __future__ import annotations

import fnmatch
import struct
from collections.abc import Callable, Mapping

from upright.bricks.brick import OK, Hardware
from upright.bricks.rxe import InvalidProgram, read_rxe
from upright.bricks.vm import Machine
from upright.errors import UprightError

REPLY, NO_REPLY = 0x02, 0x80  # type of a reply; bit of a telegram that requests none
NO_PROGRAM, UNKNOWN, BAD_DATA, NO_FILE, BROKEN, SHORT, NO_SENSOR = 0xEC, 0xBE, 0xC0, 0x87, 0xE5, 0xBF, 0xDD
"""Statuses: no program runs, unknown command, value out of range, no such file, program error, telegram too short,
nothing on the bus of a digital sensor."""
ANSWER = 16  # bytes that a digital sensor's answer takes

FIRMWARE = (28, 1)  # minor and major version
PROTOCOL = (124, 1)
NAME = b"virtual"
ADDRESS = bytes(range(6))
COST = 1  # [µs] of an instruction by default


class VirtualBrick:
    """A brick with its `hardware`. `telegram` answers a telegram; `run` advances its program.

    With `silent` it does not answer, as without batteries or cable. An error of the program ends it, stops the motors
    and is kept in `failure`.
    """

    def __init__(self, cost: int = COST) -> None:
        self.hardware = Hardware()
        self.cost = cost
        self.silent = False
        self.failure = ""
        self.machine: Machine | None = None
        self._ran = 0.0
        self.running = ""
        self.searches = dict[int, list[str]]()

    @property
    def seconds(self) -> float:
        """Run time [s] of the program, or of the last one."""
        return self._ran if self.machine is None else self.machine.time * 1e-6

    def telegram(self, data: bytes) -> bytes:
        """The reply to one telegram, empty where none is requested."""
        if self.silent or len(data) < 2:
            return b""
        self.hardware.tick(1)  # the firmware takes one telegram in a round of a millisecond
        command = COMMANDS.get((data[0] & 1, data[1]))
        try:
            status, results = (UNKNOWN, b"") if command is None else command(self, data[2:])
        except (struct.error, IndexError):
            status = SHORT
            results = b""
        except InvalidProgram:
            status = BAD_DATA
            results = b""
        return b"" if data[0] & NO_REPLY else bytes([REPLY, data[1], status]) + results

    def run(self, until: float) -> None:
        """Run the program until its clock reads `until` [s] or it ends."""
        machine = self.machine
        if machine is None:
            return
        try:
            machine.run(round(until * 1e6))
        except UprightError as error:
            self.failure = str(error)
            self.stop()
        else:
            if machine.ended:
                self.stop()

    def start(self, name: str) -> int:
        """Begin a program; the status."""
        stored = self.hardware.flash.files.get(name)
        if stored is None:
            return NO_FILE
        try:
            program = read_rxe(bytes(stored))
        except InvalidProgram:
            return BROKEN
        self.stop()
        self.machine = Machine(program, self.hardware, self.cost)
        self.running = name
        self.failure = ""
        return OK

    def stop(self) -> None:
        """End the program, motors first."""
        self.hardware.stop()
        self._ran = self.seconds
        self.machine = None
        self.running = ""


Answer = tuple[int, bytes]


def _name(data: bytes) -> str:
    return data[:20].split(b"\0")[0].decode("ascii", "replace")


def _padded(name: str, size: int = 20) -> bytes:
    return name.encode("ascii", "replace")[: size - 1].ljust(size, b"\0")


def _open_read(brick: VirtualBrick, data: bytes) -> Answer:
    result, handle, size = brick.hardware.flash.open(_name(data))
    return result >> 8, struct.pack("<BI", handle, size)


def _open_write(brick: VirtualBrick, data: bytes) -> Answer:
    (size,) = struct.unpack_from("<I", data, 20)
    result, handle = brick.hardware.flash.create(_name(data), size)
    return result >> 8, bytes([handle])


def _read(brick: VirtualBrick, data: bytes) -> Answer:
    handle, count = struct.unpack_from("<BH", data)
    result, content = brick.hardware.flash.read(handle, count)
    return result >> 8, struct.pack("<BH", handle, len(content)) + content.ljust(count, b"\0")


def _write(brick: VirtualBrick, data: bytes) -> Answer:
    result, count = brick.hardware.flash.write(data[0], data[1:])
    return result >> 8, struct.pack("<BH", data[0], count)


def _close(brick: VirtualBrick, data: bytes) -> Answer:
    if brick.searches.pop(data[0], None) is not None:
        return OK, data[:1]
    return brick.hardware.flash.close(data[0]) >> 8, data[:1]


def _delete(brick: VirtualBrick, data: bytes) -> Answer:
    return brick.hardware.flash.delete(_name(data)) >> 8, data[:20].ljust(20, b"\0")


def _find_first(brick: VirtualBrick, data: bytes) -> Answer:
    handle = next(i for i in range(255, 0, -1) if i not in brick.searches)
    brick.searches[handle] = fnmatch.filter(sorted(brick.hardware.flash.files), _name(data))
    return _next_file(brick, handle)


def _find_next(brick: VirtualBrick, data: bytes) -> Answer:
    return _next_file(brick, data[0])


def _next_file(brick: VirtualBrick, handle: int) -> Answer:
    names = brick.searches.get(handle, [])
    if not names:
        return NO_FILE, bytes([handle]) + bytes(24)
    name = names.pop(0)  # with the size it was opened for, as d_loader.c (dLoaderFindNext) has it
    return OK, bytes([handle]) + _padded(name) + struct.pack("<I", brick.hardware.flash.sizes[name])


def _version(_brick: VirtualBrick, _data: bytes) -> Answer:
    return OK, bytes([*PROTOCOL, *FIRMWARE])


def _device_info(brick: VirtualBrick, _: bytes) -> Answer:
    return OK, NAME.ljust(15, b"\0") + ADDRESS + bytes(5) + struct.pack("<I", brick.hardware.flash.free)


def _start(brick: VirtualBrick, data: bytes) -> Answer:
    return brick.start(_name(data)), b""


def _stop(brick: VirtualBrick, _: bytes) -> Answer:
    if not brick.running:
        return NO_PROGRAM, b""
    brick.stop()
    return OK, b""


def _program_name(brick: VirtualBrick, _: bytes) -> Answer:
    return (OK if brick.running else NO_PROGRAM), _padded(brick.running)


def _set_output(brick: VirtualBrick, data: bytes) -> Answer:
    port, power, mode, _, _, state, limit = struct.unpack_from("<BbBBbBI", data)
    ports = range(3) if port == 0xFF else (port,)
    brick.hardware.set_output(ports, [(2, power), (1, mode), (6, state)])
    for number in ports:
        brick.hardware.motors[number].turn(limit)
    return OK, b""


def _get_output(brick: VirtualBrick, data: bytes) -> Answer:
    port = data[0]
    hardware = brick.hardware
    power, mode, state, limit, turned = (hardware.get_output(port, item) for item in (2, 1, 6, 5, 4))
    return OK, struct.pack("<BbBBbBIiii", port, power, mode, 0, 0, state, limit, turned, turned, turned)


def _set_input(brick: VirtualBrick, data: bytes) -> Answer:
    brick.hardware.set_input(data[0], 0, data[1])
    brick.hardware.set_input(data[0], 1, data[2])
    return OK, b""


def _get_input(brick: VirtualBrick, data: bytes) -> Answer:
    kind, mode, raw = (brick.hardware.get_input(data[0], item) for item in (0, 1, 2))
    return OK, struct.pack("<BBBBBHHhh", data[0], 1, 0, kind, mode, raw, raw, raw, raw)


def _ask_sensor(brick: VirtualBrick, data: bytes) -> Answer:
    port, size, count = struct.unpack_from("<BBB", data)
    if port not in brick.hardware.registers:
        return NO_SENSOR, b""
    brick.hardware.ask(port, data[3 : 3 + size], min(count, ANSWER))
    return OK, b""


def _sensor_ready(brick: VirtualBrick, data: bytes) -> Answer:
    return OK, bytes([len(brick.hardware.asked.get(data[0], b""))])


def _sensor_answer(brick: VirtualBrick, data: bytes) -> Answer:
    answer = brick.hardware.asked.pop(data[0], b"")
    return OK, bytes([len(answer)]) + answer.ljust(ANSWER, b"\0")


def _reset_motor(brick: VirtualBrick, data: bytes) -> Answer:
    brick.hardware.set_output((data[0],), [(0, 0x08)])
    return OK, b""


def _battery(brick: VirtualBrick, _: bytes) -> Answer:
    return OK, struct.pack("<H", brick.hardware.battery)


def _keep_alive(_brick: VirtualBrick, _data: bytes) -> Answer:
    return OK, struct.pack("<I", 600_000)  # [ms] until it would switch itself off


def _accepted(_brick: VirtualBrick, _data: bytes) -> Answer:
    return OK, b""


COMMANDS: Mapping[tuple[int, int], Callable[[VirtualBrick, bytes], Answer]] = {
    (1, 0x80): _open_read, (1, 0x81): _open_write, (1, 0x82): _read, (1, 0x83): _write, (1, 0x84): _close,
    (1, 0x85): _delete, (1, 0x86): _find_first, (1, 0x87): _find_next, (1, 0x88): _version, (1, 0x89): _open_write,
    (1, 0x8B): _open_write, (1, 0x9B): _device_info, (0, 0x00): _start, (0, 0x01): _stop, (0, 0x03): _accepted,
    (0, 0x04): _set_output, (0, 0x05): _set_input, (0, 0x06): _get_output, (0, 0x07): _get_input,
    (0, 0x0A): _reset_motor, (0, 0x0B): _battery, (0, 0x0C): _accepted, (0, 0x0D): _keep_alive,
    (0, 0x0E): _sensor_ready, (0, 0x0F): _ask_sensor, (0, 0x10): _sensor_answer, (0, 0x11): _program_name,
}  # fmt: skip
"""(1 for a system command, 0 for a direct one; number) → its function."""
