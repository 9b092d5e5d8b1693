"""A flight of an NXT brick: upload, start, watch, stop, and fetch the log, whatever goes wrong."""

from __future__ import annotations

import re
import time
from pathlib import Path

from upright.atomic import TemporaryFolder
from upright.compiled.program import Program
from upright.errors import InvalidLog, UprightError
from upright.execution.execute_nxc import compile_nxc
from upright.firmware.generate import NXT_LOG
from upright.firmware.wiring import nxt_wiring
from upright.flight.flight import INTERRUPTED, STOPS, Clock, Flight, FlightRefused, MotorsMayRun, may_run
from upright.flight.program_logs import BRICK, BRICK_ROW, read_brick_log
from upright.links.brick import GYRO_KIND, PATIENCE, REST, BrickLost, BrickRefused, Connection
from upright.progress import Progress

FIRMWARE = ([1, 28], [1, 29], [1, 31], [1, 32])
"""Versions that run what nbc makes for 1.28."""

LEAST_BATTERY = 6000  # [mV] of six cells below which the motors are too weak
GYRO_MARGIN = 150  # largest deviation of a resting gyro from 600; an empty port reads 1023
LOG_HEAD = 200  # bytes of a log besides its rows
POLL = 0.2  # [s] between two requests whether the program runs
OPENED = re.compile(r'CreateFile\("(.+)", (\d+),')
"""Name and size [B] of the log that a program in NXC opens."""


def fly_nxt(
    source: Path,
    program: Program,
    port: str,
    seconds: float,
    *,
    progress: Progress | None = None,
    clock: Clock = time.monotonic,
    where: str = BRICK,
    patience: float = PATIENCE,
) -> Flight:
    """Compile the NXC in `source`, upload it to the brick at `port`, and run it for `seconds` [s] of `clock`.

    `where` describes the brick in the log. The program is stopped however this ends, Ctrl-C included; where the brick
    does not confirm that, the first note says that motors may be running. Raises `FlightRefused`, `BrickLost`,
    `BrickRefused`, `MissingTool` or `ExecutionFailed` where nothing was driven.
    """
    with TemporaryFolder() as folder:
        binary = compile_nxc(source, Path(folder)).read_bytes()
    flight = Flight()
    name = program_name(source)
    text = source.read_text("utf-8")
    wiring = nxt_wiring(text)
    with Connection(port, patience) as brick:
        check_ready(brick, wiring.gyro)
        brick.upload(name, binary)
        check_flash(brick, text, program.period)
        trouble: UprightError | None = None
        try:
            end = clock() + seconds
            brick.ask("start", name=name)
            _watch(brick, end, progress, clock)
        except KeyboardInterrupt:
            flight.notes.append(INTERRUPTED)
        except (BrickLost, BrickRefused) as error:
            trouble = error
        except BaseException as error:
            if _stop(brick) is None:
                raise MotorsMayRun(f"{may_run(f'the brick at {port}', text)} ({error})") from error
            raise
        ran = _stop(brick)
        if trouble and ran is False:
            raise trouble
        flight.notes += [str(trouble)] if trouble else []
        _bring(brick, text, program, flight, where)
        if ran is None:
            flight.lost = True
            flight.notes.insert(0, may_run(f"the brick at {port}", text))
    return flight


def fetch_nxt(source: Path, program: Program, port: str) -> Flight:
    """Fetch the log of the NXC in `source` from the brick at `port`; a program that still runs is stopped first."""
    flight = Flight()
    text = source.read_text("utf-8")
    with Connection(port) as brick:
        ran = _stop(brick)
        if ran:
            flight.notes.append("the program still ran; it was stopped")
        _bring(brick, text, program, flight)
        if ran is None:
            flight.lost = True
            flight.notes.insert(0, may_run(f"the brick at {port}", text))
    return flight


def check_ready(brick: Connection, gyro: int) -> None:
    """Refuse a brick that is busy, with another firmware, a flat battery, or no gyro where the program looks for it."""
    busy = brick.ask("running")
    if busy:
        raise FlightRefused(
            f"{busy} runs on the brick already", expected="no program",
            hint="stop it with the orange button, or fetch its log with --fetch",
        )  # fmt: skip
    version = brick.ask("firmware")
    if version not in FIRMWARE:
        raise FlightRefused(
            f"the brick's firmware is {'.'.join(map(str, version))}", expected="enhanced firmware 1.28 or later",
            hint="put it on the brick with BricxCC or NeXTTool",
        )  # fmt: skip
    battery = brick.ask("battery")
    if battery < LEAST_BATTERY:
        raise FlightRefused(
            f"the battery gives {battery / 1000:.1f} V", expected="6 V at least", hint="use fresh cells"
        )
    reads = brick.ask("sensor", port=gyro, kind=GYRO_KIND)
    if abs(reads - REST) > GYRO_MARGIN:
        raise FlightRefused(
            f"input {gyro + 1} reads {reads}", expected=f"{REST} or so from a gyro at rest",
            likely="the gyro is in another port, or the robot moves", hint=f"put it into port {gyro + 1}, hold still",
        )  # fmt: skip


def check_flash(brick: Connection, text: str, period: float) -> None:
    """Refuse a brick whose flash has no room for the log that the program `text` opens; an old log of that name counts
    as free, since the program deletes it."""
    opened = OPENED.search(text)
    if opened is None:
        return
    name = opened[1]
    needs = int(opened[2])
    row = 2 * BRICK_ROW
    free = brick.ask("free") + sum(size for stored, size in brick.ask("files") if stored == name)
    if free >= needs:
        return
    seconds = int((free - LOG_HEAD) // row * period)
    shorter = f", or make one that drives shorter: upright firmware --seconds {seconds}" if seconds > 0 else ""
    raise FlightRefused(
        f"the program's log needs {(needs - LOG_HEAD) // row} rows, {needs} bytes, and the brick has {free} free",
        likely="other files fill its flash", hint=f"delete files on it{shorter}",
    )  # fmt: skip


def program_name(source: Path) -> str:
    """Its name on the brick, which keeps 15.3 characters of ASCII."""
    return re.sub(r"[^A-Za-z0-9_-]", "_", source.stem)[:15] + ".rxe"


def fetch_log(brick: Connection, text: str, program: Program, flight: Flight, where: str = BRICK) -> None:
    """Fetch the log that the program `text` opens into `flight`, with a note for each of its flaws."""
    opened = OPENED.search(text)
    name = opened[1] if opened else NXT_LOG
    if name not in [stored for stored, _ in brick.ask("files")]:
        flight.notes.append(
            "the brick has no log: the program did not come to balance, or the flash was full; "
            "upright fly --fetch asks again"
        )
        return
    flight.keep(read_brick_log(brick.fetch(name), where), program)


def _watch(brick: Connection, end: float, progress: Progress | None, clock: Clock) -> None:
    began = clock()
    while (now := clock()) < end and brick.ask("running"):
        if progress:
            progress((now - began) / (end - began))
        time.sleep(POLL)


def _stop(brick: Connection) -> bool | None:
    """Whether a program was, or may have been, running; None where the brick does not confirm that none does now.

    Each attempt stands alone: it begins with a new connection, and Ctrl-C ends no more than one.
    """
    ran = False
    for attempt in range(STOPS):
        try:
            if attempt:
                brick.reconnect()
            ran = brick.ask("stop") or ran
            if not brick.ask("running"):
                return ran
        except (BrickLost, BrickRefused, KeyboardInterrupt):
            ran = True
    return None


def _bring(brick: Connection, text: str, program: Program, flight: Flight, where: str = BRICK) -> None:
    """Fetch the log into `flight` in as many attempts, or note why there is none and where it is."""
    trouble = ""
    for attempt in range(STOPS):
        try:
            if attempt:
                brick.reconnect()
            return fetch_log(brick, text, program, flight, where)
        except InvalidLog as error:
            flight.notes.append(str(error))
            return None
        except (BrickLost, BrickRefused) as error:
            trouble = str(error)
        except KeyboardInterrupt:
            trouble = INTERRUPTED
    flight.lost = True
    flight.notes.append(f"{trouble}; its log stays on the brick: upright fly --fetch")
    return None
