"""From foreign columns to our channels: a small TOML file says name, unit, sign, scale, offset and delay of each."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Mapping as Mapped
from dataclasses import dataclass, field, fields, replace
from importlib.resources import files
from pathlib import Path
from typing import Any, cast

import numpy as np

from upright.arrays import Array
from upright.errors import InvalidLog, UnknownName
from upright.logs.draft import clock_of, is_clock
from upright.logs.names import (
    BOTH,
    GYRO,
    OTHER_GYRO,
    RATE,
    by_letter,
    direction_of,
    is_motor,
    recognised,
    unit_by_name,
)
from upright.logs.readers import DECIMATION, GAINS, RawTable
from upright.logs.timers import unwrapped
from upright.reading import check_types, parse_toml, read_text, understood
from upright.signals import SIDES, Log
from upright.signals.header import TIME
from upright.signals.signal import KNOWN
from upright.signals.units import UNITS


@dataclass(frozen=True, kw_only=True)
class Source:
    """Where one channel comes from: sign · scale · factor of `unit` · column (· channel `times`) + offset.

    `times` names another mapped channel that multiplies this one: per cent of a battery becomes volts. `integrate` sums
    a rate over the time steps, which inverts the difference quotient exactly; `differentiate` makes a rate of an angle.
    `direction` names a column that is zero or less where this one, a size, acts backwards.
    `delay` [s] is the delay of the reading, which is removed. A time without a column has a `period` [s].
    """

    column: str
    unit: str = ""
    sign: int = 1
    scale: float = 1.0
    offset: float = 0.0
    delay: float = 0.0
    times: str = ""
    integrate: bool = False
    differentiate: bool = False
    direction: str = ""
    period: float = 0.0

    def __post_init__(self) -> None:
        check_types(self)
        if self.unit not in UNITS:
            raise UnknownName("unit", self.unit, [unit for unit in UNITS if unit])
        if self.sign not in (1, -1):
            raise InvalidLog(f"column '{self.column}': sign is {self.sign}", expected="1 or -1")
        if self.integrate and self.differentiate:
            raise InvalidLog(f"column '{self.column}' is to be integrated and differentiated", expected="one of them")
        for name in ("scale", "offset", "delay", "period"):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
                raise InvalidLog(f"column '{self.column}': {name} is {value!r}", expected="a finite number")


@dataclass(frozen=True)
class Mapping:
    """`time`, `channels` (our name → source) and `constants` (our name → value in our unit)."""

    name: str
    time: Source
    channels: Mapped[str, Source]
    constants: Mapped[str, float] = field(default_factory=dict[str, float])
    about: str = ""

    @classmethod
    def preset(cls, name: str) -> Mapping:
        """A shipped mapping by name; `UnknownName` lists them."""
        if name not in mappings():
            raise UnknownName("mapping", name, mappings())
        return _read(files("upright.logs").joinpath("mappings", f"{name}.toml").read_text("utf-8"), name)

    @classmethod
    def load(cls, path: str | Path) -> Mapping:
        """A mapping from a TOML file; raises `InvalidLog`."""
        return _read(read_text(path, InvalidLog, "a mapping in TOML"), str(path))

    def to_toml(self) -> str:
        """The text that `load` reads back as this mapping."""
        lines = [f"name = {_quoted(self.name)}", f"about = {_quoted(self.about)}", "", "[time]", *_lines(self.time)]
        if self.constants:
            lines += ["", "[constants]", *(f"{_quoted(name)} = {value!r}" for name, value in self.constants.items())]
        for name, source in self.channels.items():
            lines += ["", f"[channels.{_quoted(name)}]", *_lines(source)]
        return "\n".join(lines) + "\n"

    def fits(self, table: RawTable) -> bool:
        """Whether the table has every column this mapping reads."""
        return all(source.column in table.columns for source in (self.time, *self.channels.values()))

    def ignored(self, table: RawTable) -> list[str]:
        """The columns that this mapping does not read."""
        sources = self.channels.values()
        read = {self.time.column, *(source.column for source in sources), *(source.direction for source in sources)}
        return [name for name in (*table.columns, *table.text) if name not in read]


def mappings() -> list[str]:
    """Names of the mappings that are shipped."""
    folder = files("upright.logs").joinpath("mappings")
    return sorted(entry.name.removesuffix(".toml") for entry in folder.iterdir() if entry.name.endswith(".toml"))


def find_mapping(name: Mapping | str | Path) -> Mapping:
    """A mapping as given, a shipped one by name, or one from a file."""
    if isinstance(name, Mapping):
        return name
    return Mapping.preset(str(name)) if str(name) in mappings() else _from_file(name)


def _from_file(name: str | Path) -> Mapping:
    if not Path(os.path.expanduser(name)).is_file():
        raise UnknownName("mapping", str(name), mappings())
    return Mapping.load(name)


def _read(text: str, where: str) -> Mapping:
    entries = parse_toml(text, f"mapping {where}", InvalidLog, '[time] and [channels."our/name"] with column = …')
    if not (isinstance(entries.get("time"), dict) and isinstance(entries.get("channels"), dict)):
        raise InvalidLog(f"mapping {where} is incomplete", expected='[time] and [channels."our/name"] with column = …')
    channels = {name: _source(entry, f"{where}, {name}") for name, entry in entries["channels"].items()}
    with understood(f"mapping {where}", InvalidLog, '[constants] with "our/name" = number'):
        constants = {name: float(value) for name, value in entries.get("constants", {}).items()}
    for name, source in channels.items():
        if source.times and source.times not in {*channels, *constants}:
            raise InvalidLog(
                f"mapping {where}: {name} has times = '{source.times}'", expected="a mapped channel or constant"
            )
    return Mapping(str(entries.get("name", "")), _source(entries["time"], f"{where}, time"), channels, constants,
                   str(entries.get("about", "")))  # fmt: skip


def _source(entry: Any, where: str) -> Source:
    known = {f.name for f in fields(Source)}
    if isinstance(entry, dict) and where.endswith(", time") and "period" in entry:
        entry = {"column": "", **cast("dict[str, Any]", entry)}
    if not isinstance(entry, dict) or not isinstance(cast("dict[str, Any]", entry).get("column"), str):
        raise InvalidLog(f"mapping {where}: no column", expected='column = "name in the file"')
    for key in cast("dict[str, Any]", entry):
        if key not in known:
            raise UnknownName(f"entry of mapping {where}", key, known)
    try:
        with understood(f"mapping {where}", InvalidLog, 'column = "name in the file"'):
            return Source(**cast("dict[str, Any]", entry))
    except (InvalidLog, UnknownName) as error:
        raise InvalidLog(f"mapping {where}: {error}") from None


def _lines(source: Source) -> list[str]:
    default = Source(column="")
    values = {f.name: getattr(source, f.name) for f in fields(Source)}
    kept = {name: value for name, value in values.items() if name == "column" or value != getattr(default, name)}
    return [
        f"{name} = {_quoted(value) if isinstance(value, str) else repr(value).lower()}" for name, value in kept.items()
    ]


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def channels_of(mapping: Mapping, table: RawTable) -> tuple[Array, dict[str, Array], dict[str, str]]:
    """Time [s] as in the file, the mapped channels and their units; rows and delays are unchanged."""
    rows = np.arange(len(table), dtype=np.float64)
    t: Array = rows * mapping.time.period
    if mapping.time.column:
        t = _values(mapping.time, replace(table, columns={**table.columns, **unwrapped(mapping.time.column, table)}))
        t = np.cumsum(t) - t[0] if mapping.time.integrate else t
    channels = {name: np.full(len(t), value) for name, value in mapping.constants.items()}
    units = {name: KNOWN[name].unit if name in KNOWN else "" for name in channels}
    for name in sorted(mapping.channels, key=lambda name: bool(mapping.channels[name].times)):
        source = mapping.channels[name]
        values = _values(source, table)
        if source.times:
            values = values * channels[source.times]
        if source.integrate:
            values = _summed(values, t)
        elif source.differentiate:
            values = np.gradient(values, t)
        channels[name] = values + source.offset
        units[name] = _unit(name, source, units)
    return t, {name: channels[name] for name in (*mapping.channels, *mapping.constants)}, units


def apply(mapping: Mapping, table: RawTable) -> Log:
    """The table as a log in our channels. The delays of the mapping are removed, and incomplete rows at the ends
    cut off.

    Raises `InvalidLog` where a column is missing or holds text, or where the time does not increase.
    """
    t, channels, units = channels_of(mapping, table)
    left_out = {DECIMATION: table.decimation[0]} if table.decimation[0] > 1 else {}
    stated = left_out | ({GAINS: table.gains} if table.gains else {})
    log = Log(t, channels, units, {"file": table.source, "mapping": mapping.name, **stated, **table.origin})
    delays = {name: source.delay for name, source in mapping.channels.items() if source.delay}
    return undelayed(log, delays) if delays else log


def undelayed(log: Log, delays: Mapped[str, float]) -> Log:
    """`log` with these channels shifted earlier by their delays [s], cut to the rows that are complete."""
    channels = dict(log.channels)
    for name, delay in delays.items():
        channels[name] = np.interp(log.t + delay, log.t, log[name])
    last = log.t[-1] - max(0.0, *delays.values())
    first = log.t[0] - min(0.0, *delays.values())
    keep = (log.t >= first - 1e-9) & (log.t <= last + 1e-9)
    return Log(log.t[keep], {name: values[keep] for name, values in channels.items()}, log.units, log.origin)


GUESS = "guess"  # name of a mapping by the names of columns
COMMANDS = ("command/left", "command/right", "applied/left", "applied/right")
MOST = 1e30
"""Of a number in a log of any unit, times in nanoseconds included: squares and cubes of it do not overflow."""


def _values(source: Source, table: RawTable) -> Array:
    column = table.column(source.column)
    if len(beyond := np.flatnonzero(np.isfinite(column) & (np.abs(column) > MOST))):
        row = int(beyond[0])
        raise InvalidLog(f"column '{source.column}' holds {column[row]:g} at row {row}", expected=f"up to ±{MOST:g}")
    if source.direction:
        column = np.where(table.column(source.direction) > 0, column, -column)
    return column * (source.sign * source.scale * UNITS[source.unit][0])


def _summed(rates: Array, t: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(rates[1:] * np.diff(t))])


def _unit(name: str, source: Source, units: Mapped[str, str]) -> str:
    if source.times:
        return units[source.times]
    if name in COMMANDS and not source.unit:
        return "1" if unit_by_name(source.column) == "%" else ""  # a duty; volts or torques: nobody says
    si = UNITS[source.unit][1]
    if source.integrate:
        si = si.removesuffix("/s")
    elif source.differentiate:
        si = f"{si}/s"
    if name in KNOWN and si not in ("V", "N m") and not (si in ("1", "rad/s") and name in COMMANDS):
        return KNOWN[name].unit  # the scale converts it: metres per second over the radius are radians per second
    return si


def identity(table: RawTable) -> Mapping:
    """The mapping of a file with our own names: `t`, and channels with a '/'."""
    # A known channel that holds text is mapped too, so that reading it raises the error.
    names = [name for name in table.columns if name != TIME and "/" in name] + [n for n in table.text if n in KNOWN]
    sources = {name: Source(column=name, unit=_stated_unit(name, table)) for name in names}
    return Mapping("ours", Source(column=TIME, unit="s"), sources)


def propose(table: RawTable) -> Mapping:
    """A mapping by the table's columns: ours, a shipped one whose columns are all present, or a guess from the names.

    The guess takes units from the names; wrong signs, units and sides are found by the doctor.
    Raises `InvalidLog` when no time or no channel is recognised.
    """
    if TIME in table.columns and any(name in KNOWN for name in (*table.columns, *table.text)):
        return identity(table)
    for name in mappings():
        preset = Mapping.preset(name)
        if preset.fits(table) and not (preset.time.column == "c1" and len(table.columns) != 18):
            return preset
    return _guess(table)


def _guess(table: RawTable) -> Mapping:
    mapping = by_names(table)
    if mapping.time.column and mapping.channels:
        return mapping
    raise InvalidLog(
        f"no {'channel' if mapping.time.column else 'time'} is recognised among {', '.join(list(table.columns)[:12])}",
        hint="upright doctor LOG --write-mapping m.toml, which drafts a mapping to be edited (docs/logs.md)",
    )


def by_names(table: RawTable, without: Source | None = None) -> Mapping:
    """What the names of the columns say, be it little; the time is `without` where no column that moves is one."""
    sources: dict[str, Source] = {}
    names = recognised(list(table.columns))
    for column in sorted(names, key=is_motor):
        name = names[column]
        if name in sources and is_motor(column):
            name = name.replace("sensor/encoder_", "command/")
        key = name.removeprefix(RATE)
        if key not in sources:
            summed = name.startswith(RATE) and not (key == TIME and is_clock(table.columns[column]))
            sources[key] = Source(column=column, unit=named_unit(column, table), integrate=summed)
    for key in [key for key in sources if key.startswith(BOTH)]:
        one = sources.pop(key)
        sides = [key.removeprefix(BOTH) + side for side in SIDES]
        if not sources.keys() & set(sides):
            sources |= dict.fromkeys(sides, one)
        elif one.unit in ("V", "mV") and (table.columns[one.column] > 0).all():
            sources.setdefault("sensor/battery", one)  # the voltage beside the commands
    for group in ("sensor/encoder_", "command/"):  # one side alone stands for both
        sides = [group + side for side in SIDES]
        if len(one := [sources[side] for side in sides if side in sources]) == 1:
            sources |= dict.fromkeys(sides, one[0])
    for key in [key for key in sources if key.startswith("command/")]:
        sources[key] = _directed(sources[key], table)
    across = sources.pop(OTHER_GYRO, None)
    if across and GYRO not in sources:
        sources[GYRO] = across
    if GYRO in sources and by_letter(sources[GYRO].column, table.columns):
        del sources[GYRO]
    time = sources.pop(TIME, None)
    if time is None or (without and not np.ptp(table.columns[time.column]) > 0):
        time = _clock(table)
    time = _timed(time, table) if time else without or Source(column="")
    return Mapping(GUESS, time, in_volts(sources, table), about="guessed from the names of the columns; check it")


def _directed(command: Source, table: RawTable) -> Source:
    """A command that is never negative, with the column of its direction where one is named."""
    if not (table.columns[command.column] >= 0).all():
        return command
    two = [name for name, values in table.columns.items() if len(np.unique(values)) == 2]
    return replace(command, direction=direction_of(command.column, two))


def _clock(table: RawTable) -> Source | None:
    """A column that is a clock by how it rises, if it does not merely count the rows."""
    name = clock_of(table)
    return Source(column=name) if name and not (np.diff(table.columns[name]) == 1).all() else None


def _timed(time: Source, table: RawTable) -> Source:
    """A time with the unit in which it has a step of a program, where nothing states one."""
    values = table.columns[time.column]
    fine = values[np.isfinite(values)]
    step = float(np.median(fine if time.integrate else np.diff(fine))) if len(fine) > 1 else 0.0
    unit = "" if step < 0.5 else "ms" if step < 500 else "us" if step < 500e3 else "ns"
    return replace(time, unit=time.unit or unit)


def in_volts(sources: Mapped[str, Source], table: RawTable) -> dict[str, Source]:
    """The same sources, with a duty as volts where the battery's voltage and the full duty are known, else as the
    file's numbers: of what they are a part, the log does not say."""
    times = "sensor/battery" if "sensor/battery" in sources else ""
    new = dict(sources)
    for name, source in sources.items():
        if source.unit == "%":
            full = full_duty(table.columns[source.column])
            known = bool(times) and not _of_any_full(source.column, table)
            unit, scale = ("%", 1.0) if full == 100 and known else ("1", 1 / full if known else 1.0)
            new[name] = replace(source, unit=unit, scale=scale, times=times if known else "")
    return new


FULL_DUTIES = (1.0, 100.0, 255.0, 1000.0, 1023.0, 4095.0)  # fraction; per cent; Arduino; thousandths; 10 and 12 bits


def _of_any_full(column: str, table: RawTable) -> bool:
    """Whether nothing says what full duty is: whole numbers, as of a timer, that end at none of the usual ones, under
    no name of per cent."""
    if _stated_unit(column, table) == "%" or "percent" in column.lower() or "%" in column:
        return False
    values = np.abs(table.columns[column])
    values = values[np.isfinite(values)]
    return bool((values == np.rint(values)).all()) and values.max(initial=1.0) not in FULL_DUTIES


def full_duty(values: Array) -> float:
    """The number that means full duty: the smallest usual one that no row exceeds."""
    largest = float(np.nanmax(np.abs(values), initial=0.0))
    return next((full for full in FULL_DUTIES if 0 < largest <= full), 100.0)


def _stated_unit(column: str, table: RawTable) -> str:
    """The unit that the file states of a column, '' where it states none that is known."""
    return unit if (unit := table.units.get(column, "")) in UNITS else ""


def named_unit(column: str, table: RawTable) -> str:
    """The unit that the file states of a column, or its name."""
    return _stated_unit(column, table) or unit_by_name(column)
