"""The log that an NXC program leaves in the brick's flash: a line that says what it is, then rows of integers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.errors import InvalidLog
from upright.firmware.setup import STATUS
from upright.firmware.targets import DEGREE
from upright.signals import Log

END_OF_HEAD = b"\r\n"
COLUMNS = 7
WRAP = 1 << 16  # encoder counts are kept in 16 bits


@dataclass(frozen=True)
class BrickLog:
    """The `log`, what its head says, how the program `ended` ("" where the log breaks off before it could say), and how
    many bytes of a broken row were left over."""

    log: Log
    head: dict[str, str]
    ended: str
    left_over: int


def read_brick_log(data: bytes) -> BrickLog:
    """What a program left behind; raises `InvalidLog` where there is no head or not two rows."""
    text, found, rest = data.partition(END_OF_HEAD)
    head = dict(part.split("=", 1) for part in text.decode("ascii", "replace").split(";") if "=" in part)
    if not found or not {"robot", "hash", "period", "every"} <= head.keys():
        raise InvalidLog("this file of the brick is no log of a balancing program", likely="another program wrote it")
    whole = len(rest) // (2 * COLUMNS)
    table = np.frombuffer(rest, dtype="<i2", count=whole * COLUMNS).reshape(whole, COLUMNS).astype(np.float64)
    ended = ""
    if whole and table[-1, 4] == 0:  # a battery of 0 mV: the program's last words
        ended, table = STATUS[min(max(int(table[-1, 0]), 0), len(STATUS) - 1)], table[:-1]
    if len(table) < 2:
        raise InvalidLog(
            f"the log of the brick has {len(table)} rows", expected="two at least", likely="a fall at once"
        )
    return BrickLog(_log(table, head, ended), head, ended, len(rest) - whole * 2 * COLUMNS)


def _log(table: np.ndarray, head: dict[str, str], ended: str) -> Log:
    period = float(head["period"]) * int(head["every"])
    volts = table[:, 4] / 1000
    channels = {
        "sensor/encoder_left": np.unwrap(table[:, 0], period=WRAP) * DEGREE,
        "sensor/encoder_right": np.unwrap(table[:, 1], period=WRAP) * DEGREE,
        "sensor/gyro": table[:, 2] / 1000,
        "sensor/battery": volts,
        "estimate/pitch": table[:, 3] / 10_000,
        "applied/left": table[:, 5] / 100 * volts,
        "applied/right": table[:, 6] / 100 * volts,
    }
    origin = {
        "body": {"kind": "program on an NXT brick", "kit": head.get("kit", "")},
        "controller": {"hash": head["hash"], "period": float(head["period"])},
        "robot": {"name": head["robot"]},
        "outcome": {"ended": ended or "the log breaks off"},
    }
    return Log(np.arange(len(table)) * period, channels, origin=origin)
