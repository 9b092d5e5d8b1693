"""What a robot's file says beside its parameters: the batteries and floors that it is to meet, weights that were tuned
for it, and what a calibration learnt (how errors go together, a filter's noise, the logs that were fitted)."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple, cast

from upright.errors import InvalidRobot
from upright.robots import toml

Range = tuple[float, float]

STEEPEST = 0.5  # [rad] of a floor: on a steeper one wheels slip, which no model here has
NOISES = ("encoder", "gyro", "compass", "motor", "push")
_ENDS = ("low", "high", "unit")


class _Condition(NamedTuple):
    """The unit of a range, what it lies within, and the likely slip of one that does not."""

    unit: str
    least: float
    most: float
    likely: str


_CONDITIONS = {
    "battery": _Condition("V", 0.1, 1000.0, "millivolts"),
    "slope": _Condition("rad", -STEEPEST, STEEPEST, "degrees for radians"),
}


@dataclass(frozen=True, kw_only=True)
class Conditions:
    """The range (low, high) of the battery's open-circuit voltage [V] and of the floor's slope [rad]; None where the
    robot's file says nothing: then the kit's battery and a level floor count.

    Raises `InvalidRobot` for a range whose ends are exchanged, or of numbers that cannot be.
    """

    battery: Range | None = None
    slope: Range | None = None

    def __post_init__(self) -> None:
        for name, (low, high) in self.stated().items():
            unit, least, most, likely = _CONDITIONS[name]
            if not (math.isfinite(low) and math.isfinite(high) and least <= low <= high <= most):
                raise InvalidRobot(
                    f"conditions.{name} from {low:g} to {high:g} {unit}",
                    expected=f"low not above high, {least:g} to {most:g} {unit}",
                    likely=likely,
                )
            object.__setattr__(self, name, (float(low), float(high)))

    def stated(self) -> dict[str, Range]:
        """The ranges that the file states, by name."""
        return {name: getattr(self, name) for name in _CONDITIONS if getattr(self, name) is not None}

    @property
    def slopes(self) -> tuple[float, ...]:
        """The slopes [rad] to try: both ends, or level ground where nothing is stated."""
        return tuple(dict.fromkeys(self.slope)) if self.slope else (0.0,)

    def facts(self) -> dict[str, float]:
        """The ends of each stated range, by name."""
        facts: dict[str, float] = {}
        for name, (low, high) in self.stated().items():
            facts |= {f"conditions/{name}/low": low, f"conditions/{name}/high": high}
        return facts


@dataclass(frozen=True)
class TunedWeights:
    """Positive weights of one method by name (`upright tune`, units in docs/fleet.md), and the run they are from."""

    numbers: Mapping[str, float]
    source: str


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


class FileSection(NamedTuple):
    """How a section is read from what a file states under its name, called so by messages, and written again."""

    read: Callable[[Any, str], Any]
    text: Callable[[Any], str]


def sections(parameters: Collection[str]) -> dict[str, FileSection]:
    """The sections of a robot's file by name; `parameters` are what may be correlated."""
    return {
        "noise": FileSection(_noise, partial(toml.rows, "[noise]")),
        "correlation": FileSection(partial(_correlation, known=parameters), _correlation_text),
        "fitted": FileSection(_fitted, _fitted_text),
        "conditions": FileSection(_conditions, _conditions_text),
        "weights": FileSection(_weights, _weights_text),
    }


def _positive(value: float) -> bool:
    return 0 < value < math.inf


def _noise(table: toml.Table, where: str) -> dict[str, float]:
    return toml.values(table, "noise", where, _positive, "a positive standard deviation", NOISES)


def _correlation(table: toml.Table, where: str, known: Collection[str]) -> dict[tuple[str, str], float]:
    """`[correlation.one] other = 0.3`, of pairs of the `known` names."""
    toml.check_keys(table, known, where, "correlation.")
    expected = "a number from −1 to 1 of two names"
    pairs: dict[tuple[str, str], float] = {}
    for first in table:
        called = f"correlation.{first}"
        row = toml.subtable(table, first, where)
        for second, value in toml.values(row, called, where, lambda r: -1 <= r <= 1, expected, known).items():
            if second == first:
                raise InvalidRobot(f"{where}: {called}.{second} is {value!r}", expected=expected)
            pairs[first, second] = value
    return pairs


def _correlation_text(pairs: Mapping[tuple[str, str], float]) -> str:
    table: dict[str, dict[str, float]] = {}
    for (first, second), value in pairs.items():
        table.setdefault(first, {})[second] = value
    return "".join(toml.rows(f"[correlation.{first}]", row) for first, row in table.items())


def _fitted(tables: Any, where: str) -> tuple[FittedLog, ...]:
    several = cast("list[Any]", tables) if isinstance(tables, list) else [tables]
    return tuple(_fitted_log(one, where) for one in several)


def _fitted_log(table: Any, where: str) -> FittedLog:
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


def _fitted_text(logs: Collection[FittedLog]) -> str:
    text = ""
    for log in logs:
        marks = " ".join(f"{mark:08x}" for mark in log.marks)
        text += toml.rows("[[fitted]]", {"log": log.name, "start": log.start, "stop": log.stop, "marks": marks})
    return text


def _conditions(table: toml.Table, where: str) -> Conditions:
    """`[conditions.battery]` and `[conditions.slope]`, each with low, high and unit."""
    toml.check_keys(table, _CONDITIONS, where, "conditions.")
    ranges: dict[str, Range] = {}
    for name in table:
        unit = _CONDITIONS[name].unit
        called = f"conditions.{name}"
        ends = toml.subtable(table, name, where)
        toml.check_keys(ends, _ENDS, where, f"{called}.")
        if missing := [key for key in _ENDS if key not in ends]:
            hint = f'[{called}] low = …, high = …, unit = "{unit}"'
            raise InvalidRobot(
                f"{where}: {called} lacks {', '.join(missing)}", expected="low, high and unit", hint=hint
            )
        low, high = (
            toml.number({"value": ends[key], "unit": ends["unit"]}, f"{called}.{key}", (unit,), where)
            for key in ("low", "high")
        )
        ranges[name] = (low, high)
    return Conditions(**ranges)


def _conditions_text(conditions: Conditions) -> str:
    text = ""
    for name, (low, high) in conditions.stated().items():
        text += toml.rows(f"[conditions.{name}]", {"low": low, "high": high, "unit": _CONDITIONS[name].unit})
    return text


def _weights(table: toml.Table, where: str) -> dict[str, TunedWeights]:
    """`[weights.lqg] pitch = 0.2, …, source = "…"`, by method."""
    result: dict[str, TunedWeights] = {}
    for method in table:
        row = dict(toml.subtable(table, method, where))
        if "source" not in row:
            raise InvalidRobot(f"{where}: weights.{method} lacks source", expected="the run that the weights are from")
        source = toml.word(row, "source", where)
        del row["source"]
        numbers = toml.values(row, f"weights.{method}", where, _positive, "a positive number")
        result[method] = TunedWeights(numbers, source)
    return result


def _weights_text(weights: Mapping[str, TunedWeights]) -> str:
    return "".join(
        toml.rows(f"[weights.{method}]", {**tuned.numbers, "source": tuned.source}) for method, tuned in weights.items()
    )
