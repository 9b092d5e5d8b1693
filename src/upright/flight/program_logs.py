"""The logs that programs leave: lines of a Pybricks or ev3dev program, a file in an NXT's flash, or telemetry alone."""

from __future__ import annotations

import binascii
import struct
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.errors import InvalidLog
from upright.firmware.setup import STATUS
from upright.firmware.targets import DEGREE
from upright.logs.pace import overdue, pace_of
from upright.signals import Log

ROW = "<hhhhHbbBH"
"""Encoders [deg, modulo 32768], gyro [mrad/s], pitch [0.1 mrad], battery [mV], duties [%], status, time [ms, modulo
65536] since the program let go."""
BRICK_ROW = 8  # integers of 16 bits: encoders, gyro, pitch, battery, duties and time in those units
HUB, BRICK = "a hub", "an NXT brick"  # what a program runs on, as its log says it
LINE_TURN, BRICK_TURN = 1 << 15, 1 << 16  # [deg] after which an encoder's field begins again
STAMP_TURN = 1 << 16  # [ms] after which a time begins again
TELEMETRY = ("period", "encoder_left", "encoder_right", "pitch", "duty_left", "duty_right", "battery", "time")
"""The numbers of a line T; encoders [deg], pitch [0.1 mrad], duties [%], battery [mV], time [ms]."""


@dataclass(frozen=True)
class ProgramLog:
    """The `log`, what its head says, how the program `ended` ("" where the log breaks off before it could say), and
    `flaws`, a line for everything that is not whole."""

    log: Log
    head: dict[str, str]
    ended: str
    flaws: tuple[str, ...] = ()


@dataclass(frozen=True)
class SignedLine:
    """A line `KIND text*CRC` of a program whose CRC fits."""

    kind: str
    text: str


def checked_line(line: str) -> SignedLine:
    """The line, or `InvalidLog` where its CRC (CCITT, start FFFF) does not fit."""
    body, star, crc = line.strip().rpartition("*")
    kind, _, text = body.partition(" ")
    try:
        fits = bool(star) and int(crc, 16) == binascii.crc_hqx(body.encode(), 0xFFFF)
    except ValueError:
        fits = False
    if not fits:
        raise InvalidLog(f"the line '{line.strip()[:40]}' is damaged: its CRC does not fit", likely="a lost chunk",
                         hint="fetch the log again")  # fmt: skip
    return SignedLine(kind, text)


def status_text(number: str | float) -> str:
    """The meaning of a status number; an unknown one is the last."""
    return STATUS[min(max(int(number), 0), len(STATUS) - 1)]


def is_signed(line: str) -> bool:
    """Whether a line should carry a CRC: T, S, H, D or E; any other is free text of the program."""
    return line[:2] in ("T ", "S ", "H ", "D ", "E ")


def whole_lines(lines: Iterable[str]) -> tuple[list[SignedLine], int]:
    """The signed lines whose CRC fits, and how many were damaged."""
    whole = list[SignedLine]()
    damaged = 0
    for line in filter(is_signed, lines):
        try:
            whole.append(checked_line(line))
        except InvalidLog:
            damaged += 1
    return whole, damaged


def read_lines(lines: Iterable[str], known: Mapping[str, str] | None = None, where: str = HUB) -> ProgramLog:
    """The log in a program's output. Damaged lines are left out and counted among the `flaws`; every whole row is kept
    at its own time. `known` replaces the head where that is lost.

    Raises `InvalidLog` for less than two whole rows, or without a head.
    """
    try:
        return _read_lines(lines, dict(known or {}), where)
    except (ValueError, struct.error):
        raise InvalidLog("these lines are no log of a balancing program", likely="another program wrote them") from None


def _read_lines(lines: Iterable[str], facts: dict[str, str], where: str) -> ProgramLog:
    whole, damaged = whole_lines(lines)
    for line in whole:
        if line.kind == "H":
            facts |= dict(part.split("=", 1) for part in line.text.split(";"))
    rows = _rows(line.text for line in whole if line.kind == "D")
    if not {"robot", "kit", "hash", "period"} <= facts.keys() or len(rows) < 2:
        raise InvalidLog("this holds no log of a program", expected="its lines from H to E", likely="a cut end")
    sent = next((int(line.text) for line in whole if line.kind == "E"), int(facts.get("rows", 0)))
    flaws = [f"{damaged} damaged lines were left out"] if damaged else []
    flaws += [f"{sent - len(rows)} of {sent} rows did not arrive"] if sent > len(rows) else []
    flaws += [] if "first" in facts else ["the time of its first row is unknown"]
    table = np.array([row for _, row in sorted(rows.items())], dtype=np.float64)
    index = np.array(sorted(rows)) + int(facts.get("first", 0))
    ended = status_text(facts["status"]) if "status" in facts else ""
    period = float(facts["period"])
    t = _clock(table[:, 8], index[0] * period)
    slow = overdue(t, period, np.diff(index) == 1)
    log = program_log(t, table[:, :7], facts, ended=ended, turn=LINE_TURN, where=where, slow=slow)
    return ProgramLog(log, facts, ended, (*flaws, *_paced(log)))


def _rows(packed: Iterable[str]) -> dict[int, tuple[float, ...]]:
    """Rows by number."""
    rows: dict[int, tuple[float, ...]] = {}
    for text in packed:
        first, _, data = text.partition(" ")
        rows |= dict(enumerate(struct.iter_unpack(ROW, bytes.fromhex(data)), int(first)))
    return rows


def read_telemetry(lines: Iterable[str], known: Mapping[str, str], where: str = HUB) -> ProgramLog:
    """A log of telemetry alone, where the program's own is lost; raises `InvalidLog` for less than two lines of it."""
    whole, _ = whole_lines(lines)
    rows = {int(v[0]): v[1:] for v in (line.text.split() for line in whole if line.kind == "T")}
    if len(rows) < 2:
        raise InvalidLog("no telemetry arrived", expected="two lines at least", likely="the line was lost at once")
    number = np.array([[float(v) for v in row] for _, row in sorted(rows.items())])
    left, right, pitch, duty_left, duty_right, battery, stamp = number.T
    table = np.column_stack([left, right, np.full(len(left), np.nan), pitch, battery, duty_left, duty_right])
    log = program_log(stamp / 1000, table, known, ended="", turn=0, where=where)
    return ProgramLog(log, dict(known), "", ("telemetry alone: every tenth period, without the gyro",))


def read_brick_log(data: bytes, where: str = BRICK) -> ProgramLog:
    """The log of an NXC program in the brick's flash: a head line, then rows of integers.

    Raises `InvalidLog` where there is no head or not two rows.
    """
    text, newline, rest = data.partition(b"\r\n")
    head = dict(part.split("=", 1) for part in text.decode("utf-8", "replace").split(";") if "=" in part)
    if not newline or not {"robot", "hash", "period", "every"} <= head.keys():
        raise InvalidLog("this file of the brick is no log of a balancing program", likely="another program wrote it")
    whole = len(rest) // (2 * BRICK_ROW)
    table = np.frombuffer(rest, dtype="<i2", count=whole * BRICK_ROW).reshape(whole, BRICK_ROW).astype(np.float64)
    ended = ""
    if whole and table[-1, 4] == 0:  # a battery of 0 mV marks the row with the final status
        ended = status_text(table[-1, 0])
        table = table[:-1]
    if len(table) < 2:
        raise InvalidLog(
            f"the log of the brick has {len(table)} rows", expected="two at least", likely="a fall at once"
        )
    broken = len(rest) - whole * 2 * BRICK_ROW
    flaws = (f"the log breaks off in a row; its {len(table)} whole rows are kept",) if broken else ()
    t = _clock(table[:, 7], 0.0)
    period = float(head["period"]) * int(head["every"])
    slow = overdue(t, period)
    log = program_log(t, table[:, :7], head, ended=ended, turn=BRICK_TURN, where=where, slow=slow)
    return ProgramLog(log, head, ended, (*flaws, *_paced(log)))


def _paced(log: Log) -> tuple[str, ...]:
    """A line where the rows of a program are not its period apart."""
    pace = pace_of(log)
    return (str(pace.in_words()),) if pace and not pace.kept else ()


def _clock(stamps: Array, first: float) -> Array:
    """Times [s] of rows by their `stamps` [ms] (n,), which begin again; the first row is near `first` [s].

    Rows of one millisecond, as after a row that was a whole period late, are spread evenly over it.
    """
    t = np.unwrap(stamps % STAMP_TURN, period=STAMP_TURN)
    t += STAMP_TURN * np.round((1000 * first - t[0]) / STAMP_TURN)
    begin = np.flatnonzero(np.diff(t, prepend=t[0] - 1))
    count = np.diff(begin, append=len(t))
    t += (np.arange(len(t)) - np.repeat(begin, count)) / np.repeat(count, count)
    return t / 1000


def program_log(
    t: Array, table: Array, head: Mapping[str, str], *, ended: str, turn: int, where: str, slow: int | None = None
) -> Log:
    """The `table` (n, 7) of encoders [deg], gyro [mrad/s], pitch [0.1 mrad], battery [mV] and duties [%] as a log.

    `t` (n,) [s] is each row's own time; encoders wrap after `turn` [deg], never where it is 0. `slow` of
    its rows were overdue (None: not known).
    """
    volts = table[:, 4] / 1000
    channels = {
        "sensor/encoder_left": _unwrapped(table[:, 0], turn) * DEGREE,
        "sensor/encoder_right": _unwrapped(table[:, 1], turn) * DEGREE,
        "sensor/gyro": table[:, 2] / 1000,
        "sensor/battery": volts,
        "estimate/pitch": table[:, 3] / 10_000,
        "applied/left": table[:, 5] / 100 * volts,
        "applied/right": table[:, 6] / 100 * volts,
    }
    channels = {name: values for name, values in channels.items() if not np.isnan(values).all()}
    units = {name: "V" for name in channels if name.startswith("applied")}
    period = float(head["period"])
    outcome: dict[str, Any] = {"ended": ended or "the log breaks off"}
    outcome |= {} if slow is None else {"late": slow}
    outcome |= {"gyro_offset": float(head["offset"])} if "offset" in head else {}
    origin = {
        "robot": {"name": head["robot"]},
        "body": {"kind": f"program on {where}", "kit": head.get("kit", "")},
        "controller": {"hash": head["hash"], "period": period},
        "outcome": outcome,
    }
    return Log(t, channels, units, origin)


def _unwrapped(degrees: Array, turn: int) -> Array:
    """Encoder counts without the jumps of their field, beginning within half a turn of it from zero."""
    if not turn:
        return degrees
    counts = np.unwrap(degrees, period=turn)
    return counts - turn * np.round(counts[0] / turn)
