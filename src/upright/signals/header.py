"""What the three file formats share: their columns, units and origin as one line of JSON, and the column `t`."""

from __future__ import annotations

import json
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, cast

import numpy as np
from numpy.typing import NDArray

from upright.errors import InvalidLog
from upright.reading import parse_json

TIME = "t"
"""The column of time in seconds: a channel cannot have this name in a file."""

MOST_NUMBERS = 40_000_000
"""Numbers in one log, all channels together: 30 channels at 100 Hz for almost four hours, 320 MB."""

_TIME_WORDS = {"t", "ts", "time", "times", "timestamp", "stamp", "sec", "secs", "second", "seconds", "clock"}


class Columns(NamedTuple):
    """What a file holds: time `t` (n,) [s], `channels` by name (n,), their `units`, and the `origin` as plain data."""

    t: NDArray[Any]
    channels: Mapping[str, NDArray[Any]]
    units: Mapping[str, str]
    origin: Mapping[str, Any]

    def table(self) -> dict[str, NDArray[Any]]:
        """Time and channels as columns, time first."""
        return {TIME: self.t, **self.channels}


def describe(log: Columns) -> str:
    """Units (in the order of the channels) and origin of a log as one line of ASCII JSON."""
    return json.dumps({"units": dict(log.units), "origin": dict(log.origin)})


def understand(text: str | bytes) -> tuple[dict[str, str], dict[str, Any]]:
    """Units and origin from what `describe` wrote; raises `InvalidLog` for anything else."""
    text = text.decode("utf-8", "replace") if isinstance(text, bytes) else text
    data = parse_json(text, "the note of units and origin", InvalidLog, "the line that upright wrote")
    parts = [data.get(key) for key in ("units", "origin")] if isinstance(data, dict) else []
    if len(parts) != 2 or not all(isinstance(part, dict) for part in parts):
        raise InvalidLog("the note of units and origin is incomplete", expected='{"units": {…}, "origin": {…}}')
    return cast("tuple[dict[str, str], dict[str, Any]]", tuple(parts))


def check_writable(channels: Iterable[str]) -> None:
    """Raise `InvalidLog` for a channel name that no column can have: `t`, or one with line breaks or control codes."""
    for name in channels:
        if name == TIME:
            raise InvalidLog("a channel is called 't'", expected="'t' for time alone", hint="give the channel a path")
        if not name.isprintable():
            raise InvalidLog(f"channel {name!a} cannot be a column name", expected="printable characters")


def check_size(rows: int, columns: int) -> None:
    """Raise `InvalidLog` for a log of more than `MOST_NUMBERS`, before they are read."""
    if rows * columns > MOST_NUMBERS:
        raise InvalidLog(
            f"{rows} rows of {columns} columns are {rows * columns} numbers", expected=f"at most {MOST_NUMBERS}",
            hint="cut the log into parts",
        )  # fmt: skip


def check_lines(path: Path, columns: int) -> None:
    """The same of a text file, whose lines are counted."""
    with path.open("rb") as stream:
        rows = sum(block.count(b"\n") for block in iter(lambda: stream.read(1 << 24), b""))
    check_size(rows, columns)


def check_names(names: Sequence[str]) -> None:
    """Raise `InvalidLog` unless every column has its own name and one of them is `t`."""
    check_twice(names)
    if TIME not in names:
        likely, hint = _where_is_time(names)
        came = f"no column 't' among {', '.join(names[:12])}{', …' if len(names) > 12 else ''}"
        raise InvalidLog(came, expected="time in seconds in a column 't'", likely=likely, hint=hint)


def check_twice(names: Sequence[str]) -> None:
    """Raise `InvalidLog` unless every column has its own name."""
    twice = [name for name, count in Counter(names).items() if count > 1]
    if twice:
        raise InvalidLog(f"column '{twice[0]}' appears {Counter(names)[twice[0]]} times", hint="rename or drop one")


def assemble(table: Mapping[str, NDArray[Any]], units: Mapping[str, str], origin: Mapping[str, Any]) -> Columns:
    """The columns of a table, of which `t` is the time; `check_names` has passed their names."""
    channels = {name: values for name, values in table.items() if name != TIME}
    return Columns(table[TIME], channels, units, origin)


def _where_is_time(names: Sequence[str]) -> tuple[str, str]:
    if len(names) == 1 and any(mark in names[0] for mark in ";\t"):
        return "semicolons or tabs between the columns", "save it with commas, and points in the numbers"
    for name in names:
        if _TIME_WORDS & set(re.split(r"[^a-z]+", name.lower())):
            return f"the time is '{name}'", f"rename it to 't', in seconds, or make Log(table['{name}'], …) yourself"
    if _all_numbers(names):
        return "no header row, or one behind '#'", "begin the file with the names of the columns"
    return "", ""


def _all_numbers(names: Iterable[str]) -> bool:
    try:
        return all(np.isreal(float(name)) for name in names)
    except ValueError:
        return False
