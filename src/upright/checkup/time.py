"""Time that runs backwards, repeats, jitters, has gaps or the wrong unit."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.checkup.finding import FEWEST, GAP, Array, Finding, Fix, Record, error, moment, warning
from upright.errors import InvalidLog
from upright.logs.pace import pace
from upright.logs.recording import jumps

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
        evidence = f"{int(bad.sum())} rows have no time, the first is row {int(np.argmax(bad))}"
        return [error("time/missing", "t", evidence, "remove them", Fix("finite time"))]
    steps = np.diff(record.t)
    back = np.flatnonzero(steps < 0)
    if len(back):
        return [_backwards(record, back)]
    repeats = int((steps == 0).sum())
    if not repeats:
        return []
    row = int(np.argmax(steps == 0)) + 1
    if _coarse(record, steps):
        tick = float(np.median(steps[steps > 0]))
        evidence = (
            f"the clock counts in steps of {tick:.3g} s, about {repeats / max(1, (steps > 0).sum()) + 1:.2g} rows each"
        )
        repair = "space the rows evenly between its steps"
        return [error("time/coarse", "t", evidence, repair, Fix("spread"))]
    evidence = (
        f"{repeats} rows repeat the time of the row before, the first is row {row} at {moment(record.t[row], 4)} s"
    )
    return [error("time/repeated", "t", evidence, "keep the first row of each time", Fix("unique"))]


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
    evidence = f"time runs backwards {len(back)} time{'s' if len(back) > 1 else ''}, first at row {row}"
    evidence += f" from {moment(record.t[row - 1], 4)} to {moment(record.t[row], 4)} s"
    if float(-steps[back].min()) < _DISORDER * period:
        evidence += "; the rows are out of order"
        return error(
            "time/backwards", "t", evidence, "sort the rows, keep one for each time", Fix("sort"), Fix("unique")
        )
    repair, fix = _longest(record, back + 1)
    evidence += "; the clock was reset, or the file holds two recordings"
    return error("time/backwards", "t", evidence, repair, fix, Fix("unique"))


def _longest(record: Record, starts: NDArray[np.intp]) -> tuple[str, Fix]:
    """The repair that keeps the longest of the runs that begin at the rows `starts` and at the first."""
    edges = np.concatenate([[0], starts, [len(record.t)]])
    longest = int(np.argmax(np.diff(edges)))
    first = int(edges[longest])
    last = int(edges[longest + 1])
    return f"keep the longest run, rows {first} to {last - 1}", Fix("rows", numbers=(first, last))


def jump(record: Record) -> list[Finding]:
    """A clock that leaps ahead by more than any pause of a recording; raises `InvalidLog` where it never runs."""
    rows = jumps(record.t)
    if not len(rows):
        return []
    first = int(rows[0])
    evidence = f"the clock jumps {len(rows)} time{'s' if len(rows) > 1 else ''}, first at row {first} from "
    evidence += f"{moment(record.t[first - 1], 4)} to {moment(record.t[first], 4)} s"
    repair, fix = _longest(record, rows)
    if fix.numbers[1] - fix.numbers[0] < FEWEST:
        raise InvalidLog(evidence, expected=f"{FEWEST} rows of one run", likely="another column is the time")
    return [error("time/jump", "t", f"{evidence}; it was set, or the file holds two recordings", repair, fix)]


def unit(record: Record) -> list[Finding]:
    """A median period that is impossible for a balancing robot: milliseconds, microseconds or nanoseconds read as "
    "seconds."""
    period = record.period
    if SHORTEST <= period <= LONGEST:
        return []
    if LONGEST < period <= _SLOWEST:
        evidence = f"the rows are {period:.3g} s apart: too slow to show how a robot balances, or how it falls"
        return [warning("time/slow", "t", evidence, "log every 10 to 50 ms; if these are no seconds, state the unit")]
    evidence = f"the sampling period is {period:.4g} s, too long or too short to balance"
    for name, factor in (("milliseconds", 1e-3), ("microseconds", 1e-6), ("nanoseconds", 1e-9)):
        if 5e-4 <= period * factor <= 0.1:
            evidence += f"; read as {name} it is {period * factor * 1e3:.3g} ms"
            return [error("time/unit", "t", evidence, f"multiply by {factor:g}", Fix("time scale", numbers=(factor,)))]
    return [error("time/unit", "t", evidence, "give the unit of the time in a mapping")]


def steps(record: Record) -> list[Finding]:
    """Gaps, dropped rows and jitter; a missing row does not count as jitter."""
    step = np.diff(record.t)
    period = record.period
    ordinary = step[step < MISSED * period]
    jitter = float(ordinary.std() / period)
    findings = _gaps(record, step, period)
    if jitter > JITTER:
        evidence = f"steps of {period * 1e3:.4g} ms scatter by {jitter * period * 1e3:.2g} ms ({jitter:.0%}), "
        evidence += f"from {ordinary.min() * 1e3:.3g} to {ordinary.max() * 1e3:.3g} ms"
        even = Fix("even", numbers=(period,))
        return [*findings, warning("time/jitter", "t", evidence, "resample at even times", even)]
    missed = (step >= MISSED * period) & (step <= GAP * period)
    if missed.any():
        lost = int(np.rint(step[missed] / period - 1).sum())
        first = float(record.t[int(np.argmax(missed))])
        evidence = f"{lost} rows are missing at {int(missed.sum())} places, the first after t = {moment(first, 4)} s"
        evidence += f": steps of two or more periods of {period * 1e3:.4g} ms"
        lost_rows = Fix("insert", numbers=(period, GAP * period))
        findings.append(warning("time/dropped", "t", evidence, "interpolate them linearly", lost_rows))
    return findings


def _gaps(record: Record, step: Array, period: float) -> list[Finding]:
    gaps = np.flatnonzero(step > GAP * period)
    if not len(gaps):
        return []
    worst = int(gaps[np.argmax(step[gaps])])
    span = float(record.t[worst]), float(record.t[worst + 1])
    evidence = f"{len(gaps)} gap{'s' if len(gaps) > 1 else ''}: the longest, {step[worst]:.3g} s or "
    evidence += f"{step[worst] / period:.0f} periods, after t = {moment(span[0], 4)} s"
    return [warning("time/gap", "t", evidence, "use the parts as separate logs", span=span)]


def paced(t: Array, origin: Mapping[str, Any]) -> list[Finding]:
    """A program whose rows are not its period apart, by their own times."""
    kept = pace(t, origin)
    if kept is None or kept.kept:
        return []
    return [warning("time/pace", "t", str(kept), "use the times of the log, as every command does, not row × period")]
