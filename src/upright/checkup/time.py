"""Time that runs backwards, repeats, jitters, has gaps or the wrong unit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.checkup.finding import FEWEST, GAP, Array, Finding, Fix, Record, error, instant, plain, warning
from upright.errors import InvalidLog
from upright.logs.pace import pace
from upright.logs.recording import jumps
from upright.pages import Quantity, Say

LONGEST, SHORTEST = 0.2, 2e-4
"""Plausible sampling periods [s] of a balancing robot: with a pole at 5 1/s, 0.2 s is too slow to balance."""

_SLOWEST = 2.0  # [s] between the rows of a slow log; longer, and they are no seconds

JITTER = 0.1  # [periods] standard deviation; a clock of whole milliseconds at 10 ms has 0.05
_DISORDER = 20.0  # [periods] rows displaced by more belong to another recording
MISSED = 1.6  # [periods] a longer step lacks a row: jitter alone rarely doubles a step
_COARSE = 0.3  # of the rows: so many repeat the time of the row before with other readings where the clock is coarse


def order(record: Record) -> list[Finding]:
    """Rows without a time, times that repeat, and times that run backwards."""
    bad = ~np.isfinite(record.t)
    if bad.any():
        evidence = Say("Rows without a time: {n}, the first is row {row}.", n=int(bad.sum()), row=int(np.argmax(bad)))
        return [error("time/missing", "t", evidence, Say("Remove these rows."), Fix("finite time"))]
    steps = np.diff(record.t)
    back = np.flatnonzero(steps < 0)
    if len(back):
        return [_backwards(record, back)]
    repeats = int((steps == 0).sum())
    if not repeats:
        return []
    row = int(np.argmax(steps == 0)) + 1
    if _coarse(record, steps):
        tick = Quantity(float(np.median(steps[steps > 0])), "s")
        each = float(repeats / max(1, (steps > 0).sum()) + 1)
        evidence = Say("The clock counts in steps of {tick}, about {rows} rows each.", tick=tick, rows=plain(each, 2))
        return [error("time/coarse", "t", evidence, Say("Space the rows evenly between its steps."), Fix("spread"))]
    evidence = Say("Rows that repeat the time of the row before: {n}, the first is row {row}.", n=repeats, row=row)
    return [error("time/repeated", "t", evidence, Say("Keep the first row of each time."), Fix("unique"))]


def _coarse(record: Record, steps: Array) -> bool:
    """Whether rows with other readings share their time in groups of about one size."""
    changed = np.zeros(len(steps), dtype=bool)
    for values in record.channels.values():
        changed |= np.diff(values) != 0
    groups = np.diff(np.flatnonzero(np.concatenate([[True], steps > 0, [True]])))
    even = len(groups) >= FEWEST and groups.max() < 3 * len(record.t) / len(groups)
    return bool(even) and (changed & (steps == 0)).mean() > _COARSE


def _backwards(record: Record, back: NDArray[np.intp]) -> Finding:
    steps = np.diff(record.t)
    row = int(back[0]) + 1
    period = float(np.median(steps[steps > 0])) if (steps > 0).any() else 0.0
    evidence = Say("Time runs backwards at row {row} ({n} in all).", row=row, n=len(back))
    if float(-steps[back].min()) < _DISORDER * period:
        repair = Say("Sort the rows, and keep one for each time.")
        return error("time/backwards", "t", evidence, repair, Fix("sort"), Fix("unique"))
    repair, fix = _longest(record, back + 1)
    return error("time/backwards", "t", evidence, repair, fix, Fix("unique"))


def _longest(record: Record, starts: NDArray[np.intp]) -> tuple[Say, Fix]:
    """The repair that keeps the longest of the runs that begin at the rows `starts` and at the first."""
    edges = np.concatenate([[0], starts, [len(record.t)]])
    longest = int(np.argmax(np.diff(edges)))
    first = int(edges[longest])
    last = int(edges[longest + 1])
    kept = Say("Keep the longest part, rows {first} to {last}.", first=first, last=last - 1)
    return kept, Fix("rows", numbers=(first, last))


def jump(record: Record) -> list[Finding]:
    """A clock that leaps ahead by more than any pause of a recording; raises `InvalidLog` where it never runs."""
    rows = jumps(record.t)
    if not len(rows):
        return []
    first = int(rows[0])
    repair, fix = _longest(record, rows)
    if fix.numbers[1] - fix.numbers[0] < FEWEST:
        raise InvalidLog(
            f"the clock jumps {len(rows)} times, first at row {first}",
            expected=f"{FEWEST} rows of one run",
            likely="another column is the time",
        )
    evidence = Say("The clock jumps at row {row} ({n} in all): set, or two recordings.", row=first, n=len(rows))
    return [error("time/jump", "t", evidence, repair, fix)]


def unit(record: Record) -> list[Finding]:
    """A median period that is impossible for a balancing robot: milliseconds, microseconds or nanoseconds read as "
    "seconds."""
    period = record.period
    if SHORTEST <= period <= LONGEST:
        return []
    if LONGEST < period <= _SLOWEST:
        evidence = Say(
            "The rows are {period} apart, too slow to show a balance or a fall (limit {limit}).",
            period=Quantity(period, "s"),
            limit=Quantity(LONGEST, "s"),
        )
        repair = Say("Log every 10 to 50 ms; if these are no seconds, state the unit.")
        return [warning("time/slow", "t", evidence, repair)]
    read = Quantity(period, "s", digits=4)
    for name, factor in (("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if 5e-4 <= period * factor <= 0.1:
            true = Quantity(period * factor, "s")
            evidence = Say("The rows are {period} apart; in {unit} they are {true}.", period=read, unit=name, true=true)
            repair = Say("Multiply the time by {factor}.", factor=plain(factor))
            return [error("time/unit", "t", evidence, repair, Fix("time scale", numbers=(factor,)))]
    evidence = Say("The rows are {period} apart, too long or too short to balance.", period=read)
    return [error("time/unit", "t", evidence, Say("State the unit of the time in a mapping."))]


def steps(record: Record) -> list[Finding]:
    """Gaps, dropped rows and jitter; a missing row does not count as jitter."""
    step = np.diff(record.t)
    period = record.period
    ordinary = step[step < MISSED * period]
    jitter = float(ordinary.std() / period)
    findings = _gaps(record, step, period)
    if jitter > JITTER:
        evidence = Say(
            "Steps of {period} scatter by {jitter}; up to {limit} is usual.",
            period=Quantity(period, "s", digits=4),
            jitter=Quantity(jitter * period, "s"),
            limit=Quantity(JITTER * period, "s"),
        )
        even = Fix("even", numbers=(period,))
        return [*findings, warning("time/jitter", "t", evidence, Say("Resample at even times."), even)]
    missed = (step >= MISSED * period) & (step <= GAP * period)
    if missed.any():
        lost = int(np.rint(step[missed] / period - 1).sum())
        first = float(record.t[int(np.argmax(missed))])
        evidence = Say(
            "Rows missing: {n}; places: {places}, the first after {time}.",
            n=lost,
            places=int(missed.sum()),
            time=instant(first),
        )
        lost_rows = Fix("insert", numbers=(period, GAP * period))
        findings.append(warning("time/dropped", "t", evidence, Say("Interpolate these rows."), lost_rows))
    return findings


def _gaps(record: Record, step: Array, period: float) -> list[Finding]:
    gaps = np.flatnonzero(step > GAP * period)
    if not len(gaps):
        return []
    worst = int(gaps[np.argmax(step[gaps])])
    span = float(record.t[worst]), float(record.t[worst + 1])
    evidence = Say(
        "The log pauses for {seconds} after {time} (gaps in all: {n}).",
        seconds=Quantity(float(step[worst]), "s"),
        time=instant(span[0]),
        n=len(gaps),
    )
    return [warning("time/gap", "t", evidence, Say("Use the parts as separate logs."), span=span)]


def paced(t: Array, origin: Mapping[str, Any]) -> list[Finding]:
    """A program whose rows are not its period apart, by their own times."""
    kept = pace(t, origin)
    if kept is None or kept.kept:
        return []
    return [warning("time/pace", "t", kept.in_words(), Say("Use the log's times, not row × period."))]
