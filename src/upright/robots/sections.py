"""What a robot's file says beside its parameters: the batteries and floors that it is to meet, weights that were tuned
for it, and what a calibration learnt (how errors go together, a filter's noise, the logs that were fitted)."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any, NamedTuple, cast

from upright.errors import InvalidRobot
from upright.robots import toml

Range = tuple[float, float]

STEEPEST = 0.5  # [rad] of a floor: on a steeper one wheels slip, which no model here has
NOISES = ("encoder", "gyro", "compass", "motor", "push")
_ENDS = {"low": toml.NUMBER, "high": toml.NUMBER, "unit": toml.TEXT}
_NOISE = toml.BareEntry("a positive standard deviation", toml.POSITIVE.fits)
_RELATED = toml.BareEntry(
    "a number from −1 to 1 of two names", lambda value: toml.is_number(value) and -1 <= value <= 1
)
_ITSELF = toml.BareEntry(_RELATED.expected, lambda value: False)  # noqa: ARG005
_WRITTEN = "tables [[fitted]] with log, start, stop and marks, as upright calibrate writes them"
_TIME = toml.BareEntry(_WRITTEN, toml.NUMBER.fits)
_MARKS = toml.BareEntry("hexadecimal numbers", lambda value: re.fullmatch(r"[0-9a-fA-F ]*", str(value)) is not None)
_FITTED = {"log": toml.TEXT, "start": _TIME, "stop": _TIME, "marks": _MARKS}


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


Rows = Iterable[tuple[str, Mapping[str, Any]]]


class FileSection(NamedTuple):
    """How a section is read from what a file, called so by messages, states under its name; and the tables, each with
    its head, that say it again."""

    read: Callable[[Any, str], Any]
    rows: Callable[[Any], Rows]


def sections(parameters: Collection[str]) -> dict[str, FileSection]:
    """The sections of a robot's file by name; `parameters` are what may be correlated."""
    return {
        "noise": FileSection(_noise, _noise_rows),
        "correlation": FileSection(partial(_correlation, known=parameters), _correlation_rows),
        "fitted": FileSection(_fitted, _fitted_rows),
        "conditions": FileSection(_conditions, _conditions_rows),
        "weights": FileSection(_weights, _weights_rows),
    }


def _noise(table: Any, where: str) -> dict[str, float]:
    return toml.row(table, "noise", where, dict.fromkeys(NOISES, _NOISE))


def _noise_rows(noise: Mapping[str, float]) -> Rows:
    return [("[noise]", noise)]


def _correlation(table: Any, where: str, known: Collection[str]) -> dict[tuple[str, str], float]:
    """`[correlation.one] other = 0.3`, of pairs of the `known` names."""
    firsts = toml.as_table(table, "correlation", where)
    toml.check_keys(firsts, known, where, "correlation.")
    pairs: dict[tuple[str, str], float] = {}
    for first, others in firsts.items():
        seconds = dict.fromkeys(known, _RELATED) | {first: _ITSELF}
        row = toml.row(others, f"correlation.{first}", where, seconds)
        pairs |= {(first, second): value for second, value in row.items()}
    return pairs


def _correlation_rows(pairs: Mapping[tuple[str, str], float]) -> Rows:
    table: dict[str, dict[str, float]] = {}
    for (first, second), value in pairs.items():
        table.setdefault(f"[correlation.{first}]", {})[second] = value
    return table.items()


def _fitted(tables: Any, where: str) -> tuple[FittedLog, ...]:
    several = cast("list[Any]", tables) if isinstance(tables, list) else [tables]
    logs: list[FittedLog] = []
    for table in several:
        row = toml.row(table, "fitted", where, _FITTED, complete=_WRITTEN)
        marks = tuple(int(mark, 16) for mark in row["marks"].split())
        logs.append(FittedLog(row["log"], row["start"], row["stop"], marks))
    return tuple(logs)


def _fitted_rows(logs: Collection[FittedLog]) -> Rows:
    for log in logs:
        marks = " ".join(f"{mark:08x}" for mark in log.marks)
        yield "[[fitted]]", {"log": log.name, "start": log.start, "stop": log.stop, "marks": marks}


def _conditions(table: Any, where: str) -> Conditions:
    """`[conditions.battery]` and `[conditions.slope]`, each with low, high and unit."""
    inner = toml.as_table(table, "conditions", where)
    toml.check_keys(inner, _CONDITIONS, where, "conditions.")
    ranges: dict[str, Range] = {}
    for name, ends in inner.items():
        unit = _CONDITIONS[name].unit
        called = f"conditions.{name}"
        row = toml.row(ends, called, where, _ENDS, complete=f'low = …, high = …, unit = "{unit}"')
        toml.check_unit(row["unit"], (unit,), f"{where}: {called}")
        ranges[name] = (row["low"], row["high"])
    return Conditions(**ranges)


def _conditions_rows(conditions: Conditions) -> Rows:
    for name, (low, high) in conditions.stated().items():
        yield f"[conditions.{name}]", {"low": low, "high": high, "unit": _CONDITIONS[name].unit}


def _weights(table: Any, where: str) -> dict[str, TunedWeights]:
    """`[weights.lqg] pitch = 0.2, …, source = "…"`, by method."""
    result: dict[str, TunedWeights] = {}
    for method, stated in toml.as_table(table, "weights", where).items():
        complete = "the run that the weights are from"
        numbers = toml.row(stated, f"weights.{method}", where, {"source": toml.TEXT}, toml.POSITIVE, complete)
        source = numbers.pop("source")
        result[method] = TunedWeights(numbers, source)
    return result


def _weights_rows(weights: Mapping[str, TunedWeights]) -> Rows:
    for method, tuned in weights.items():
        yield f"[weights.{method}]", {**tuned.numbers, "source": tuned.source}
