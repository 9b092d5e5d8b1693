"""A flight: the program onto the brick, started, watched, stopped, and its log brought home, whatever goes wrong."""

from __future__ import annotations

import re
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from upright.compiled.program import Program
from upright.errors import UprightError
from upright.firmware.generate import longest_run
from upright.flight.program_logs import BRICK, BRICK_ROW, ProgramLog, read_brick_log
from upright.links.brick import GYRO, GYRO_KIND, REST, BrickLost, BrickRefused, Connection
from upright.parity.execute_nxc import compile_nxc

FIRMWARE = ([1, 28], [1, 29], [1, 31], [1, 32])
"""Versions that run what nbc makes for 1.28."""

LEAST_BATTERY = 6000  # [mV] below which six cells hardly turn the motors
GYRO_MARGIN = 150  # a resting gyro reads 600 within this; 1023 is an empty port
LOG_HEAD = 200  # bytes of a log that are no rows, as the program opens it
LOOK = 0.2  # [s] from one look at the program to the next
STOPS = 3  # times that stopping is tried


class FlightRefused(UprightError):
    """A robot that is not ready to be driven."""


@dataclass
class Flight:
    """What came of it: the `log` where there is one, whether the line was `lost`, and `notes`, a line for everything
    worth knowing."""

    log: ProgramLog | None = None
    lost: bool = False
    notes: list[str] = field(default_factory=list[str])


def fly(
    source: Path,
    program: Program,
    port: str,
    seconds: float,
    progress: Callable[[float], None] | None = None,
    clock: Callable[[], float] = time.monotonic,
    where: str = BRICK,
) -> Flight:
    """Compile the NXC in `source`, upload it to the brick at `port`, let it drive for `seconds` [s] or until it ends.

    `clock` [s] tells how long that is, `where` what the log says of its brick. The program is stopped however this
    ends, Ctrl-C included; where the line is lost it cannot be, and the notes say so. Raises `FlightRefused`,
    `BrickLost`, `BrickRefused`, `MissingTool` or `ExecutionFailed` where nothing was driven.
    """
    with tempfile.TemporaryDirectory(prefix="upright-") as folder:
        binary = compile_nxc(source, Path(folder)).read_bytes()
    flight, name = Flight(), f"{source.stem[:15]}.rxe"
    with Connection(port) as brick:
        ready(brick)
        brick.upload(name, binary)
        room(brick, source.read_text("utf-8"), program.period)
        began = clock()
        brick.ask("start", name=name)
        try:
            try:
                _watch(brick, began + seconds, progress, clock)
            finally:
                with suppress(BrickLost, BrickRefused):
                    _land(brick)
            bring_home(brick, program, flight, where)
        except BrickLost as error:
            flight.lost = True
            flight.notes.append(f"{error}; {alone(source)}, its log stays on the brick: upright fly --fetch")
    return flight


def fetch(program: Program, port: str) -> Flight:
    """Bring home the log that the brick at `port` keeps; a program that still runs there is stopped first."""
    flight = Flight()
    with Connection(port) as brick:
        if brick.ask("running"):
            _land(brick)
            flight.notes.append("the program still ran; it was stopped")
        bring_home(brick, program, flight)
    return flight


def ready(brick: Connection) -> None:
    """Refuse a brick with another firmware, a flat battery, or no gyro where the program looks for it."""
    version = brick.ask("firmware")
    if version not in FIRMWARE:
        raise FlightRefused(
            f"the brick's firmware is {'.'.join(map(str, version))}", expected="enhanced firmware 1.28 or later",
            hint="put it on the brick with BricxCC or NeXTTool",
        )  # fmt: skip
    if (battery := brick.ask("battery")) < LEAST_BATTERY:
        raise FlightRefused(f"the battery gives {battery / 1000:.1f} V", expected="6 V at least", hint="fresh cells")
    reads = brick.ask("sensor", port=GYRO, kind=GYRO_KIND)
    if abs(reads - REST) > GYRO_MARGIN:
        raise FlightRefused(
            f"input {GYRO + 1} reads {reads}", expected=f"{REST} or so from a gyro at rest",
            likely="the gyro is in another port, or the robot moves", hint=f"put it into port {GYRO + 1}, hold still",
        )  # fmt: skip


def room(brick: Connection, text: str, period: float) -> None:
    """Refuse a brick whose flash has no room for the log that the program `text` opens; what a log of that name takes
    counts as free, since the program deletes it."""
    opened = re.search(r'CreateFile\("(.+)", (\d+),', text)
    if opened is None:
        return
    name, needs, row = opened[1], int(opened[2]), 2 * BRICK_ROW
    free = brick.ask("free") + sum(taken for found, taken in brick.ask("files") if found == name)
    if free >= needs:
        return
    seconds = int((free - LOG_HEAD) // row * period)
    shorter = f", or make one that drives shorter: upright firmware --seconds {seconds}" if seconds > 0 else ""
    raise FlightRefused(
        f"the program's log needs {(needs - LOG_HEAD) // row} rows, {needs} bytes, and the brick has {free} free",
        likely="other files fill its flash", hint=f"delete files on it{shorter}",
    )  # fmt: skip


def bring_home(brick: Connection, program: Program, flight: Flight, where: str = BRICK) -> None:
    """Fetch the log into `flight`; what is odd about it becomes a note."""
    wanted = f"{program.robot}.log"
    if wanted not in [name for name, _ in brick.ask("files")]:
        flight.notes.append("the brick has no log: the program did not come to balance, or the flash was full")
        return
    keep(flight, read_brick_log(brick.fetch(wanted), where), program)


def keep(flight: Flight, found: ProgramLog, program: Program) -> None:
    """Put a log into `flight`, with a note for what is odd about it."""
    flight.log = found
    if found.head["hash"] != program.hash:
        flight.notes.append(
            f"the log is of another controller ({found.head['hash'][:12]}, not {program.hash[:12]}): an older flight's"
        )
    flight.notes += found.flaws
    if found.ended not in ("", "balancing"):
        flight.notes.append(f"the program stopped by itself: {found.ended}")


def alone(source: Path) -> str:
    """What becomes of a program that nobody reaches."""
    longest = longest_run(source.read_text("utf-8"))
    return f"its program stops after {longest} s at most" if longest else "its program goes on until its button"


def _watch(brick: Connection, end: float, progress: Callable[[float], None] | None, clock: Callable[[], float]) -> None:
    began = clock()
    while (now := clock()) < end and brick.ask("running"):
        if progress:
            progress((now - began) / (end - began))
        time.sleep(LOOK)


def _land(brick: Connection) -> None:
    for _ in range(STOPS):
        if not brick.ask("stop"):
            return
