"""The lines of a Pybricks or ev3dev program as a log: every line's CRC is checked, and no row may be missing."""

from __future__ import annotations

import binascii
import struct
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from upright.errors import InvalidLog
from upright.firmware.setup import STATUS
from upright.firmware.targets import DEGREE
from upright.signals import Log

ROW = "<hhhhHbbB"
"""Encoders [deg, modulo 32768], gyro [mrad/s], pitch [0.1 mrad], battery [mV], duties [%], status."""

TURN = 32768  # [deg] after which an encoder's field begins again


def checked_line(line: str) -> tuple[str, str]:
    """Kind and text of a line `KIND text*CRC`; `InvalidLog` where the CRC (CCITT, start FFFF) does not fit."""
    body, star, crc = line.strip().rpartition("*")
    kind, _, text = body.partition(" ")
    try:
        fits = bool(star) and int(crc, 16) == binascii.crc_hqx(body.encode(), 0xFFFF)
    except ValueError:
        fits = False
    if not fits:
        raise InvalidLog(f"the line '{line.strip()[:40]}' is damaged: its CRC does not fit", likely="a lost chunk",
                         mend="fetch the log again")  # fmt: skip
    return kind, text


def read_lines(lines: Iterable[str], partial: bool = False) -> Log:
    """The log that a program dumped after its run; lines of another kind and the program's own words are skipped.

    With `partial`, the rows before the first missing one are enough. Raises `InvalidLog` for a damaged line, missing
    rows, or no log at all.
    """
    facts: dict[str, str] = {}
    data: dict[int, bytes] = {}
    ended = None
    for line in lines:
        if line[:2] not in ("H ", "D ", "E "):
            continue
        kind, text = checked_line(line)
        if kind == "H":
            facts |= dict(part.split("=", 1) for part in text.split(";"))
        elif kind == "D":
            row, _, packed = text.partition(" ")
            data[int(row)] = bytes.fromhex(packed)
        else:
            ended = int(text)
    if partial and data:
        ended = _unbroken(data)
    if ended is None or not {"hash", "first"} <= facts.keys():
        raise InvalidLog("this holds no whole log of a program", expected="its lines from H to E", likely="a cut end")
    rows = struct.iter_unpack(ROW, _joined(data, ended))
    return _log(np.array(list(rows), dtype=np.float64).reshape(-1, 8), facts)


def _unbroken(data: dict[int, bytes]) -> int:
    """Rows before the first that is missing; what comes after it is left out of `data`."""
    size, count = struct.calcsize(ROW), 0
    for row in sorted(data):
        if row != count:
            del data[row]
        else:
            count += len(data[row]) // size
    return count


def _joined(data: dict[int, bytes], count: int) -> bytes:
    size = struct.calcsize(ROW)
    joined = b"".join(packed for _, packed in sorted(data.items()))
    if len(joined) != count * size:
        raise InvalidLog(f"{len(joined) // size} rows arrived", expected=f"{count}", mend="fetch the log again")
    return joined


def _log(rows: Any, facts: dict[str, str]) -> Log:
    period, first = float(facts["period"]), int(facts["first"])
    battery = rows[:, 4] / 1000
    channels = {
        "sensor/encoder_left": _unwrapped(rows[:, 0]) * DEGREE,
        "sensor/encoder_right": _unwrapped(rows[:, 1]) * DEGREE,
        "sensor/gyro": rows[:, 2] / 1000,
        "estimate/pitch": rows[:, 3] / 10_000,
        "sensor/battery": battery,
        "applied/left": rows[:, 5] / 100 * battery,
        "applied/right": rows[:, 6] / 100 * battery,
    }
    units = dict(zip(channels, ("rad", "rad", "rad/s", "rad", "V", "V", "V"), strict=True))
    status = int(facts["status"])
    origin = {
        "robot": {"name": facts["robot"]},
        "body": {"kind": "program", "kit": facts["kit"]},
        "controller": {"hash": facts["hash"], "period": period},
        "outcome": {"status": STATUS[status], "late": int(facts["late"]), "gyro_offset": float(facts["offset"])},
    }
    return Log((first + np.arange(len(rows))) * period, channels, units, origin)


def _unwrapped(degrees: Sequence[float]) -> Any:
    """Encoder counts without the jumps of their 15 bits, beginning within half a turn of them from zero."""
    counts = np.unwrap(np.asarray(degrees, dtype=np.float64), period=TURN)
    return counts - TURN * np.round(counts[0] / TURN) if len(counts) else counts
