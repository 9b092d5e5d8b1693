"""What a calibration adds to a robot's file: how errors go together, a filter's noise, and which logs were fitted."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import Any, cast

from upright.errors import InvalidRobot
from upright.robots import toml

NOISES = ("encoder", "gyro", "compass", "motor", "push")


@dataclass(frozen=True)
class FittedLog:
    """A log that a robot was fitted to: its name, from `start` to `stop` [s], and some `marks` of its rows
    (`logs.marks`), by which the same rows are known again in any file."""

    name: str
    start: float
    stop: float
    marks: tuple[int, ...] = ()

    def __str__(self) -> str:
        return f"{self.name} ({self.start:.4g} to {self.stop:.4g} s)"

    def to_toml(self) -> str:
        """The table that `fitted_of` reads back."""
        marks = " ".join(f"{mark:08x}" for mark in self.marks)
        return (
            f"\n[[fitted]]\nlog = {toml.quoted(self.name)}\nstart = {self.start!r}\nstop = {self.stop!r}\n"
            f'marks = "{marks}"\n'
        )


def fitted_of(table: toml.Table, where: str) -> tuple[FittedLog, ...]:
    """What the tables `[[fitted]]` say; raises `InvalidRobot`."""
    inner = table.get("fitted", [])
    several = cast("list[Any]", inner) if isinstance(inner, list) else [inner]
    return tuple(_fitted(one, where) for one in several)


def _fitted(table: Any, where: str) -> FittedLog:
    expected = "tables [[fitted]] with log, start, stop and marks, as upright calibrate writes them"
    if not isinstance(table, dict):
        raise InvalidRobot(f"{where}: fitted is {table!r:.80}", expected=expected)
    entry = cast(toml.Table, table)
    toml.check_keys(entry, ("log", "start", "stop", "marks"), where, "fitted.")
    name, (start, stop) = entry.get("log"), (entry.get(key, math.nan) for key in ("start", "stop"))
    if not (isinstance(name, str) and toml.is_number(start) and toml.is_number(stop) and math.isfinite(stop - start)):
        raise InvalidRobot(f"{where}: fitted is {dict(entry)!r:.80}", expected=expected)
    try:
        marks = tuple(int(mark, 16) for mark in str(entry.get("marks", "")).split())
    except ValueError:
        raise InvalidRobot(f"{where}: fitted.marks is {entry['marks']!r:.80}", expected="hexadecimal numbers") from None
    return FittedLog(name, float(start), float(stop), marks)


def noise_of(table: toml.Table, where: str) -> dict[str, float]:
    """What `[noise] gyro = 0.1` says of a filter's noise."""
    toml.check_keys(table, NOISES, where, "noise.")
    for name, value in table.items():
        if not toml.is_number(value) or not 0 < value < math.inf:
            raise InvalidRobot(f"{where}: noise.{name} is {value!r}", expected="a positive standard deviation")
    return {name: float(value) for name, value in table.items()}


def correlation_of(table: toml.Table, where: str, known: Collection[str]) -> dict[tuple[str, str], float]:
    """What `[correlation.one] other = 0.3` says of pairs of the `known` parameters."""
    pairs: dict[tuple[str, str], float] = {}
    for first in table:
        toml.check_keys(table, known, where, "correlation.")
        row = toml.subtable(table, first, where)
        toml.check_keys(row, known, where, f"correlation.{first}.")
        for second, value in row.items():
            if not toml.is_number(value) or not -1 <= value <= 1 or first == second:
                raise InvalidRobot(
                    f"{where}: correlation.{first}.{second} is {value!r}", expected="a number from −1 to 1 of two names"
                )
            pairs[first, second] = float(value)
    return pairs


def learnt(
    noise: Mapping[str, float], correlation: Mapping[tuple[str, str], float], fitted: Collection[FittedLog]
) -> str:
    """These as tables: the noise, each parameter's correlations with others, and the logs."""
    sizes = ["\n[noise]\n", *(f"{name} = {size!r}\n" for name, size in noise.items())] if noise else []
    firsts = dict.fromkeys(first for first, _ in correlation)
    rows = {f: [f"{b} = {r!r}" for (a, b), r in correlation.items() if a == f] for f in firsts}
    pairs = [f"\n[correlation.{first}]\n" + "\n".join(lines) + "\n" for first, lines in rows.items()]
    return "".join([*sizes, *pairs, *(log.to_toml() for log in fitted)])
