"""A column of a wheel's speed beside one of its angle: two readings of one motion, whose units have to agree."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.finding import LEFT, PITCH, RIGHT, STATE, Array, Finding, error, note, plain
from upright.logs.draft import is_clock, rate_of
from upright.logs.mapping import Mapping, Source, channels_of, named_unit
from upright.logs.readers import RawTable
from upright.pages import Say
from upright.signals.units import UNITS

_FOLLOWS = 0.98  # [1] correlation of an angle with the sum of a speed, each without its line, if the wheel is the same
_APART = 1.3  # ratio of two units of one reading, below which filters and periods explain it; units differ by 6 or more
_FILTER, _DELAYS = 0.3, 15  # [s, 1] longest delay of a speed's filter, and how many are tried
_MOST = 14  # columns that are tried


def against_angles(mapping: Mapping, table: RawTable) -> list[Finding]:
    """Encoders that were read in a stated unit, against a column of the same wheel that was not read: an error where
    the stated units contradict each other, and where only one is stated, what that makes of a turn of the other."""
    if mapping.name == "ours":  # states its units
        return []
    t = channels_of(Mapping("", mapping.time, {}), table)[0]
    if len(t) < 20 or not (np.diff(t) > 0).all():
        return []
    findings: list[Finding] = []
    taken: set[str] = set()
    for channel in (LEFT, RIGHT):
        source = mapping.channels.get(channel)
        if source is None or UNITS[source.unit][1] not in ("rad", "rad/s") or source.column in taken:
            continue
        taken.add(source.column)
        other = _other(source, mapping, table, t)
        if other:
            findings += _compared(channel, source, *other, table)
    return findings


def _other(source: Source, mapping: Mapping, table: RawTable, t: Array) -> tuple[str, float] | None:
    """The column, among those that were not read, that is the angle of a speed or the speed of an angle, and how much
    of the angle one unit of the summed speed is."""
    read = table.columns.get(source.column)
    if read is None or not np.isfinite(read).all() or not np.ptp(read) > 0:
        return None
    unread = {n: table.columns[n] for n in mapping.ignored(table)[:_MOST] if n in table.columns}
    unread = {n: x for n, x in unread.items() if np.isfinite(x).all() and np.ptp(x) > 0 and not is_clock(x)}
    fits = {n: _slope(*((read, x) if source.integrate else (x, read)), t) for n, x in unread.items()}
    best = max(fits, key=lambda n: abs(fits[n][1]), default="")
    tilt = mapping.channels.get(PITCH)
    if not best or abs(fits[best][1]) < _FOLLOWS:
        return None
    speed, angle = (read, unread[best]) if source.integrate else (unread[best], read)
    tilted = tilt is not None and abs(rate_of(speed, table.columns[tilt.column])) > abs(rate_of(speed, angle))
    return None if tilted else (best, abs(fits[best][0]))


def _slope(speed: Array, angle: Array, t: Array) -> tuple[float, float]:
    """How much of the angle one unit of the summed speed is, and the correlation of both about their lines, at the
    delay of the speed's filter at which they agree best."""
    summed = np.concatenate([[0.0], np.cumsum((speed[1:] + speed[:-1]) / 2 * np.diff(t))])
    best = 0.0, 0.0
    most = min(len(t) // 4, round(_FILTER / float(np.median(np.diff(t)))))
    for rows in range(0, most + 1, max(1, most // _DELAYS)):
        n = len(t) - rows
        line = np.column_stack([np.ones(n), t[:n] - t[:n].mean()])
        parts = np.column_stack([summed[rows:], angle[:n]])
        a, b = (parts - line @ np.linalg.lstsq(line, parts, rcond=None)[0]).T
        power = float(a @ a), float(b @ b)
        if min(power) > 1e-12 * max(float(summed @ summed), float(angle @ angle), 1e-300):
            fit = float(a @ b) / power[0], float(a @ b) / math.sqrt(power[0] * power[1])
            best = max(best, fit, key=lambda one: abs(one[1]))
    return best


def _compared(channel: str, source: Source, other: str, slope: float, table: RawTable) -> list[Finding]:
    """What the units of both columns make of each other."""
    names = (source.column, other) if source.integrate else (other, source.column)
    known = UNITS[source.unit][0] * source.scale
    unit = named_unit(other, table)
    if source.integrate:
        of_turn = slope / known * math.tau  # how much of the other a turn is
        ratio = slope * UNITS[unit][0] / known if UNITS[unit][1] == "rad" else 0.0
    else:
        of_turn = 0.0
        ratio = slope * known / UNITS[unit][0] if UNITS[unit][1] == "rad/s" else 0.0
    if ratio and not 1 / _APART < ratio < _APART:
        facts = {"angle": names[1], "speed": names[0], "ratio": plain(ratio)}
        evidence = Say("By its name's unit '{angle}' turns {ratio} times as far as '{speed}' says.", **facts)
        near = _named(ratio, source.unit if source.integrate else unit)
        if near:
            evidence = Say(
                "By its name's unit '{angle}' turns {ratio} times as far as '{speed}'; in {unit} they would agree.",
                **facts,
                unit=near[0],
            )
        return [error("units/contradicted", channel, evidence, STATE)]
    if ratio or not of_turn:
        return []
    evidence = Say(
        "With '{column}' in {unit}, a turn of the wheel is {turn} of '{other}'.",
        column=source.column,
        unit=source.unit,
        turn=plain(of_turn, 4),
        other=other,
    )
    repair = Say("Compare that with the counts of a turn; if it differs, state another unit.")
    return [note("units/turn", channel, evidence, repair)]


def _named(ratio: float, unit: str) -> list[str]:
    """The units in which a speed would agree."""
    return [u for u, (f, si) in UNITS.items() if si == "rad/s" and 1 / 1.1 < UNITS[unit][0] * ratio / f < 1.1]
