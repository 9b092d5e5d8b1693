"""Columns without names, taken for what they behave like: encoders, gyro and commands of a balancing robot.

Two columns that run together, and one that the pendulum equation ties to them, are encoders and gyro. Commands are
those that drive them by the motor equation. Both hold in any unit: names, units and signs may all be unknown.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np

from upright.arrays import Array
from upright.checkup.finding import GYRO, LEFT, PITCH, RIGHT, Finding, Record, error, plain
from upright.checkup.motion import TRUSTED as OBEYED
from upright.checkup.physics import Resampled, motor, resampled
from upright.logs.draft import clock_of, draft, looks, rate_of, still_to_name
from upright.logs.mapping import COMMANDS, GUESS, Mapping, Source, by_names, channels_of, in_volts, named_unit
from upright.logs.names import pairs
from upright.logs.readers import RawTable
from upright.pages import Say, english
from upright.signals.units import UNITS

TRUSTED = 0.95
"""[1] R² of the pendulum equation from which columns are taken for encoders and gyro. Other triples of columns reach
0.9, since all of them follow the robot's motion."""
FEWEST = 200  # rows: in fewer, a few swings fit each other by chance
FEWEST_OF_TILT = 50  # rows, for one column to be the rate of another
NAMED = OBEYED  # of two columns that differ by the side in their names, and by the name
DRIVEN = 0.3  # [1] R² of the motor equation from which columns are taken for commands
EQUAL = 1.5  # how many times more one of two commands may vary
TOGETHER, ALIKE = 0.3, 3.0  # [1] least correlation of two encoders, and how many times more one may vary
SMOOTH = 0.3  # [1] of its deviation: steps of a column that may be an encoder
TWIN, PROPORTIONAL = 0.95, 0.9999  # [1] correlations of the commands of both motors, and of one reading in two units
FASTEST = 35.0  # [rad/s] 2000 degrees per second, the largest range of a gyro
RATE = 0.9  # [1] correlation from which a column is the rate of another
LEANS = 0.7  # [1] of the gyro with the steps of a column, from which that is some estimate of the tilt and no command
MOST = 14  # columns that are tried
VALUES = 5  # different values that a column has at least; fewer are a mode or a flag
ROWS = 3000  # of the log, on which they are tried
_WITHOUT_GYRO = ("time", "columns", "saturation", "channel")
COUPLING = 1.6  # [1] q of the pendulum equation: a22/a11 plus what the rotor adds, of robots that were measured
SPREAD = 1.2  # of its logarithm: beyond that, whole numbers are no degrees
GYROS = ("rad/s", "deg/s", "mrad/s", "mdeg/s")
PERIOD = 0.01  # [s] taken where no column is a clock


def lacking(mapping: Mapping) -> list[Say]:
    """What a mapping lacks of encoders, commands, and a gyro or a tilt."""
    commands = COMMANDS[:2] if COMMANDS[0] in mapping.channels else COMMANDS[2:]
    without = [] if {LEFT, RIGHT} <= mapping.channels.keys() else [Say("encoders")]
    without += [] if {*commands} <= mapping.channels.keys() else [Say("commands")]
    return without + ([] if {GYRO, PITCH} & mapping.channels.keys() else [Say("a gyro")])


def spare(mapping: Mapping, table: RawTable) -> bool:
    """Whether a table has columns that a mapping does not read, from which others may be chosen."""
    return bool(set(mapping.ignored(table)) - set(table.text))


def another_gyro(mapping: Mapping, table: RawTable, findings: Sequence[Finding]) -> list[Finding]:
    """Where the column whose name is a gyro's does not obey the pendulum equation, and one that is not read does: that,
    and those of the findings that do not rest on a gyro. Empty elsewhere."""
    sources = mapping.channels
    if mapping.name != GUESS or not {LEFT, RIGHT, GYRO} <= sources.keys() or len(table) < FEWEST:
        return []
    names = [sources[name].column for name in (LEFT, RIGHT, GYRO)]
    first = max(0, (len(table) - ROWS) // 2)
    rows = slice(first, first + ROWS)
    t = _time(table)[0][rows]
    moving = {n: table.columns[n][rows] for n in (*names, *mapping.ignored(table)[:MOST]) if n in table.columns}
    moving = {n: x for n, x in moving.items() if np.isfinite(x).all() and len(np.unique(x)) >= VALUES}
    for side in (LEFT, RIGHT):
        if sources[side].integrate and sources[side].column in moving:
            moving[sources[side].column] = np.cumsum(moving[sources[side].column]) * float(np.median(np.diff(t)))
    if not set(names) <= moving.keys() or _judged(t, moving, names[0], names[1], names[2]):
        return []
    others = [n for n in moving if n not in names and abs(rate_of(moving[n], moving[names[0]])) < RATE]
    fits = [fit for n in others if (fit := _judged(t, moving, names[0], names[1], n)) and fit.sign > 0]
    if not fits:
        return []
    best = max(fits, key=lambda fit: fit.r2)
    evidence = Say(
        "Column '{best}' obeys the pendulum equation as a gyro (R² {r2}), and '{named}' does not.",
        best=best.gyro,
        r2=plain(best.r2, 2),
        named=names[2],
    )
    repair = Say("Name the right column in a mapping: `--write-mapping MINE.toml`.")
    swapped = error("columns/gyro", GYRO, evidence, repair)
    return [swapped, *(f for f in findings if f.code.split("/")[0] in _WITHOUT_GYRO)]


class _Choice(NamedTuple):
    """Encoders and a gyro among the columns, with R² of the pendulum equation, its q, and the gyro's sign."""

    left: str
    right: str
    gyro: str
    r2: float
    q: float
    sign: int


def by_physics(table: RawTable, named: Mapping | None = None) -> Mapping | None:
    """A mapping of columns by how they move, or None where no three of them move like encoders and gyro. What `named`
    takes by its name stays what it is, if the others then fit."""
    if len(table) < FEWEST:
        return None
    known = dict(named.channels) if named else {}
    t, time = (channels_of(replace(named, channels={}), table)[0], named.time) if named else _time(table)
    t = t[:ROWS]
    taken = {source.column for name, source in known.items() if name not in (LEFT, RIGHT, GYRO)} | {time.column}
    fine = {n: x[:ROWS] for n, x in table.columns.items() if np.isfinite(x[:ROWS]).all() and n not in taken}
    moving = {n: x for n, x in fine.items() if len(np.unique(x)) >= VALUES}
    moving = dict(list(moving.items())[:MOST])
    for source in {known[side].column: known[side] for side in (LEFT, RIGHT) if side in known}.values():
        if source.integrate and source.column in moving:
            moving[source.column] = np.cumsum(moving[source.column]) * float(np.median(np.diff(t)))
    best = _sensors(t, moving, {name: known[name].column for name in (LEFT, RIGHT, GYRO) if name in known})
    if best is None:
        return by_physics(table) if known else None
    channels = {**_sources(table, best), **known}
    if not {*COMMANDS} & known.keys():
        channels |= _commands(t, table, moving, best)
    return Mapping(
        "columns by physics",
        time,
        in_volts(channels, table),
        about=f"by how the columns move (R² {best.r2:.2f}); check it",
    )


def with_tilt(mapping: Mapping, table: RawTable) -> Mapping:
    """The same mapping, with a column for the tilt estimate where it reads none and one has the gyro for its rate."""
    fits = _fits(mapping, table, GYRO, PITCH, rate_of)
    name = max(fits, key=lambda n: fits[n], default="")
    if not name or fits[name] < RATE:
        return mapping
    tilt = Source(column=name, unit=named_unit(name, table))
    return replace(mapping, channels={**mapping.channels, PITCH: tilt})


def with_gyro(mapping: Mapping, table: RawTable) -> Mapping:
    """The same mapping, with a column for the gyro where it reads a tilt and none, and one is the rate of that tilt."""
    fits = _fits(mapping, table, PITCH, GYRO, lambda tilt, x: rate_of(x, tilt))
    name = max(fits, key=lambda n: abs(fits[n]), default="")
    if not name or abs(fits[name]) < RATE or len(table) < FEWEST_OF_TILT:
        return mapping
    unit = named_unit(name, table) or f"{mapping.channels[PITCH].unit}/s"
    gyro = Source(column=name, unit=unit if unit in GYROS else "", sign=1 if fits[name] > 0 else -1)
    return replace(mapping, channels={**mapping.channels, GYRO: gyro})


def _fits(
    mapping: Mapping, table: RawTable, known: str, target: str, fit: Callable[[Array, Array], float]
) -> dict[str, float]:
    """How well each column that is not read goes with the `known` channel; nothing where the mapping has `target`."""
    source = mapping.channels.get(known)
    if source is None or target in mapping.channels:
        return {}
    own = source.sign * table.columns[source.column][:ROWS]
    unread = {n: table.columns[n][:ROWS] for n in mapping.ignored(table)[:MOST] if n in table.columns}
    return {n: fit(own, x) for n, x in unread.items() if np.isfinite(x).all() and np.isfinite(own).all()}


def _sources(table: RawTable, best: _Choice) -> dict[str, Source]:
    """Encoders and gyro, in the units of their names or else those that bring q near to `COUPLING`."""
    counts = _whole(table.columns[best.left]) and np.ptp(table.columns[best.left]) > 20
    named, rate = named_unit(best.left, table), named_unit(best.gyro, table)
    q = abs(best.q)  # of encoders and a gyro in the file's units

    def off(angle: str, rate: str) -> float:
        return abs(math.log(q * UNITS[angle][0] / UNITS[rate][0] / COUPLING))

    either = ["rad", "deg"] if rate in GYROS else ["rad"]
    angles = [named] if UNITS[named][1] in ("rad", "m") else ["deg"] if counts else either
    largest = float(np.nanmax(np.abs(table.columns[best.gyro])))
    rates = [rate] if rate in GYROS else [r for r in GYROS if largest * UNITS[r][0] < FASTEST] or GYROS
    angle, rate = min(((a, r) for a in angles for r in rates), key=lambda units: off(*units))
    if counts and not named and off(angle, rate) > SPREAD:
        angle = ""  # counts of another number to a turn: the doctor asks for it
    sides = {LEFT: Source(column=best.left, unit=angle), RIGHT: Source(column=best.right, unit=angle)}
    return {**sides, GYRO: Source(column=best.gyro, unit=rate, sign=best.sign)}


def _time(table: RawTable) -> tuple[Array, Source]:
    """Times [s] of the rows, and the column that is the clock; without one a period that is assumed."""
    name = clock_of(table)
    if not name:
        return np.arange(len(table), dtype=np.float64) * PERIOD, Source(column="", period=PERIOD)
    step = float(np.median(np.diff(table.columns[name])))
    unit = "s" if step < 0.5 else "ms" if step < 500 else "us"
    return table.columns[name] * UNITS[unit][0], Source(column=name, unit=unit)


def _sensors(t: Array, moving: dict[str, Array], known: dict[str, str]) -> _Choice | None:
    """The best encoders and gyro among the columns, each scaled by its deviation; those that are `known` are these."""
    if not set(known.values()) <= moving.keys():
        return None
    if len(known) == 3:
        return _Choice(known[LEFT], known[RIGHT], known[GYRO], math.nan, COUPLING, 1)
    smooth = [n for n, x in moving.items() if np.std(np.diff(x)) < SMOOTH * np.std(x) and n != known.get(GYRO)]
    size = {name: float(np.std(moving[name])) for name in smooth}
    alike = [(a, b) for a, b in combinations(smooth, 2) if 1 / ALIKE < size[a] / size[b] < ALIKE]
    together = [(a, b) for a, b in alike if _correlation(moving[a], moving[b]) > TOGETHER]
    sided = pairs(smooth) if GYRO in known else []
    if LEFT in known:
        together = sided = [(known[LEFT], known[RIGHT])]
    elif GYRO in known and not together:
        together = [(n, n) for n in smooth]  # one angle for both wheels
    choices: list[_Choice] = []
    alone = [n for n in moving if not _has_twin(n, moving)]
    for left, right in dict.fromkeys([*sided, *together]):
        for gyro in [known[GYRO]] if GYRO in known else [n for n in alone if n not in (left, right)]:
            choice = _judged(t, moving, left, right, gyro, NAMED if (left, right) in sided else TRUSTED)
            choices += [choice] if choice else []
    with_tilt = [c for c in choices if _tilts(moving, c)]  # a command may obey too, of which nothing is the angle
    best = max(with_tilt or choices, key=lambda c: c.r2, default=None)
    if best is None or GYRO in known:
        return best
    rates = {n: rate_of(x, moving[best.gyro]) for n, x in moving.items() if n not in best[:3]}
    rate = max(rates, key=lambda n: rates[n], default="")
    if rate and rates[rate] > RATE:  # the column was the tilt, of which another is the rate
        return _judged(t, moving, best.left, best.right, rate) or best
    return best


def _has_twin(name: str, moving: dict[str, Array]) -> bool:
    """Whether another column is the same, or nearly: so are the commands of both motors, and a gyro in two units only
    exactly in proportion."""
    return any(_alike(moving[name], other) for n, other in moving.items() if n != name)


def _alike(x: Array, other: Array) -> bool:
    return np.array_equal(x, other) or TWIN < abs(_correlation(x, other)) < PROPORTIONAL


def _tilts(moving: dict[str, Array], choice: _Choice) -> list[str]:
    """The columns of which the choice's gyro is the rate."""
    rate = choice.sign * moving[choice.gyro]
    return [n for n, x in moving.items() if n not in choice[:3] and rate_of(rate, x) > RATE]


def _judged(
    t: Array, moving: dict[str, Array], left: str, right: str, gyro: str, trusted: float = TRUSTED
) -> _Choice | None:
    """Whether these columns obey the pendulum equation, with q in the file's units."""
    scale, rate = float(np.std(moving[left])), float(np.std(moving[gyro]))
    m = _resampled(t, {LEFT: moving[left] / scale, RIGHT: moving[right] / scale, GYRO: moving[gyro] / rate})
    if m is None:
        return None
    fit = m.law
    if fit.r2 < trusted or len(fit.values) < 2 or fit.values[0] * fit.values[1] <= 0:
        return None
    return _Choice(left, right, gyro, fit.r2, fit.values[0] * scale / rate, 1 if fit.values[0] > 0 else -1)


def _commands(t: Array, table: RawTable, moving: dict[str, Array], best: _Choice) -> dict[str, Source]:
    """The pair of columns, or the one, that drives the encoders by the motor equation."""
    left, right = moving[best.left], moving[best.right]
    m = _resampled(t, {LEFT: left, RIGHT: right})
    rate = moving[best.gyro]
    others = [n for n in moving if n not in best[:3] and abs(rate_of(rate, moving[n])) < LEANS]
    speeds = [n for n in others if abs(rate_of(moving[n], left)) > RATE]
    rest = [n for n in others if n not in speeds and not any(_alike(moving[n], moving[s]) for s in speeds)]
    tries: dict[tuple[str, str, int], float] = {}
    for names in [*combinations(rest, 2), *((n, n) for n in rest)]:
        one, other = (float(np.std(moving[name])) for name in names)
        if m is not None and 1 / EQUAL < one / other < EQUAL:
            mean = (moving[names[0]] + moving[names[1]]) / 2
            even = np.interp(m.t, t, mean / max(float(np.std(mean)), 1e-300))
            for sign in (1, -1):
                tries[(*names, sign)] = motor(m, sign * even, m.left, m.right, None).r2 + 0.01 * (names[0] != names[1])
    chosen = max(tries, key=lambda one: tries[one], default=None)
    if chosen is None or tries[chosen] < DRIVEN:
        return {}
    *names, sign = chosen
    return {
        f"applied/{side}": _command(str(name), table, sign) for side, name in zip(("left", "right"), names, strict=True)
    }


def _command(name: str, table: RawTable, sign: int) -> Source:
    """In the unit of its name; whole numbers are a duty, others volts or torques: nobody says."""
    unit = named_unit(name, table) or ("%" if _whole(table.columns[name]) else "")
    return Source(column=name, unit=unit if UNITS[unit][1] in ("V", "N m", "1", "") else "", sign=sign)


def _resampled(t: Array, channels: dict[str, Array]) -> Resampled | None:
    return resampled(Record(t, channels, {}))


def _whole(values: Array) -> bool:
    return bool((values[np.isfinite(values)] == np.rint(values[np.isfinite(values)])).all())


def _correlation(a: Array, b: Array) -> float:
    return float(np.corrcoef(a, b)[0, 1])


def _row_time(mapping: Mapping, table: RawTable) -> float:
    """How long a row takes [s] by a tilt's steps and its logged rate, in one unit; 0 where the log does not tell."""
    tilt, gyro = mapping.channels.get(PITCH), mapping.channels.get(GYRO)
    if tilt is None or gyro is None or tilt.column == gyro.column or bool(tilt.unit) != bool(gyro.unit):
        return 0.0
    angle, rate = (table.columns[s.column] * UNITS[s.unit][0] for s in (tilt, gyro))
    steps = (angle[2:] - angle[:-2]) / 2
    middle = rate[1:-1]
    if not (np.isfinite(angle).all() and np.isfinite(rate).all() and np.ptp(steps) > 0 and np.ptp(middle) > 0):
        return 0.0
    sure = abs(_correlation(steps, middle)) > TRUSTED
    return float(f"{np.std(steps) / np.std(middle):.2g}") if sure else 0.0


def drafted(table: RawTable) -> str:
    """A mapping to be edited: the one of `by_physics` or of the names, or an empty one, with what each column looks
    like, and with what is left to be named."""
    mapping = by_physics(table)
    if mapping is None:
        named = by_names(table, Source(column="", period=PERIOD))
        if not named.channels:
            return draft(table)
        mapping = replace(with_tilt(with_gyro(named, table), table), name="mine", about="")
    period = ""
    if not mapping.time.column:
        period = "# No column is a clock: state the period [s] from row to row.\n"
        row = _row_time(mapping, table)
        if row:
            mapping = replace(mapping, time=replace(mapping.time, period=row))
            period += "# By the steps of the tilt and its rate it is about this, if their units agree.\n"
    left = lacking(mapping)
    return f"{looks(table)}\n{period}{mapping.to_toml()}" + (
        still_to_name(" or ".join(map(english, left)), mapping.channels) if left else ""
    )


OF_COUNTS = """
# unit = "deg"
# scale = 0.2406              # 360 over the counts of a turn of the wheel, here 1496"""
OF_GYRO = """
# unit = "deg/s"
# scale = 0.00763             # of the chip's range: 1/131, 1/65.5, 1/32.8 or 1/16.4"""
OF_DUTY = """
# scale = 0.003922            # 1 over full duty, here 255
# times = "sensor/battery"    # a duty of the battery: volts"""
OF_BATTERY = """

# [constants]
# "sensor/battery" = 11.1     # [V] of the battery while it drove, which no column has"""


def to_complete(mapping: Mapping, findings: Sequence[Finding]) -> str:
    """The mapping as a file, with comments where the findings ask for a number: of counts, a gyro, a duty."""
    asked = {(finding.code, finding.channel) for finding in findings if not finding.fixes}
    duty = any(code == "units/command" for code, _ in asked)
    own = replace(mapping, name="mine") if mapping.name == GUESS else mapping
    parts = own.to_toml().rstrip().split("\n\n")
    for k, part in enumerate(parts):
        name = part.partition('"')[2].partition('"')[0] if part.startswith("[channels") else ""
        if ("units/counts", name) in asked:
            parts[k] += OF_GYRO if name == GYRO else OF_COUNTS
        elif duty and name in COMMANDS:
            parts[k] += OF_DUTY
        elif duty and part.startswith("[time]") and "sensor/battery" not in mapping.channels:
            parts[k] += OF_BATTERY
    return "\n\n".join(parts) + "\n"
