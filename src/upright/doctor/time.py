"""Time that runs backwards, repeats, jitters, has gaps or the wrong unit."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.doctor.finding import Array, Finding, Fix, Record, error, warning

LONGEST, SHORTEST = 0.2, 2e-4
"""Periods [s] outside which no balancing robot is logged: a pole of 5 1/s is lost in 0.2 s."""

_JITTER = 0.1  # of the period: clocks of whole milliseconds at 10 ms scatter by 0.05, sleeping programs by more
_GAP = 5.0  # periods: up to this, rows were dropped; beyond it, the recording paused
_DISORDER = 20.0  # periods: rows that come later than this are another recording
_MISSED = 1.6  # periods: jitter alone rarely doubles a step


def order(record: Record) -> list[Finding]:
    """Rows without a time, times that repeat, and times that run backwards."""
    bad = ~np.isfinite(record.t)
    if bad.any():
        said = f"{int(bad.sum())} rows have no time, the first is row {int(np.argmax(bad))}"
        return [error("time/missing", "t", said, "drop them", Fix("finite time"))]
    steps = np.diff(record.t)
    back = np.flatnonzero(steps < 0)
    if len(back):
        return [_backwards(record, back)]
    repeats = int((steps == 0).sum())
    if not repeats:
        return []
    row = int(np.argmax(steps == 0)) + 1
    said = f"{repeats} rows repeat the time of the row before, the first is row {row} at {record.t[row]:.4g} s"
    return [error("time/repeated", "t", said, "keep the first row of each time", Fix("unique"))]


def _backwards(record: Record, back: NDArray[np.intp]) -> Finding:
    steps, row = np.diff(record.t), int(back[0]) + 1
    period = float(np.median(steps[steps > 0])) if (steps > 0).any() else 0.0
    said = f"time runs backwards {len(back)} time{'s' if len(back) > 1 else ''}, first at row {row}"
    said += f" from {record.t[row - 1]:.4g} to {record.t[row]:.4g} s"
    if float(-steps[back].min()) < _DISORDER * period:
        said += "; rows stand in the wrong order"
        return error("time/backwards", "t", said, "sort the rows, keep one of each time", Fix("sort"), Fix("unique"))
    edges = np.concatenate([[0], back + 1, [len(record.t)]])
    longest = int(np.argmax(np.diff(edges)))
    first, last = int(edges[longest]), int(edges[longest + 1])
    said += "; a clock was set anew, or two recordings are in one file"
    repair = f"keep the longest run, rows {first} to {last - 1}"
    return error("time/backwards", "t", said, repair, Fix("rows", numbers=(first, last)), Fix("unique"))


def unit(record: Record) -> list[Finding]:
    """A median period that no balancing robot has: milliseconds, microseconds or nanoseconds taken for seconds."""
    period = record.period
    if SHORTEST <= period <= LONGEST:
        return []
    said = f"rows are {period:.4g} s apart; no robot balances on such steps"
    for name, factor in (("milliseconds", 1e-3), ("microseconds", 1e-6), ("nanoseconds", 1e-9)):
        if 5e-4 <= period * factor <= 0.1:
            said += f", but on the {period * factor * 1e3:.3g} ms that {name} make of it"
            return [error("time/unit", "t", said, f"multiply by {factor:g}", Fix("time scale", numbers=(factor,)))]
    return [error("time/unit", "t", said, "say the unit of the time in a mapping")]


def steps(record: Record) -> list[Finding]:
    """Gaps, and dropped rows or jitter: a missing row is no jitter."""
    step, period = np.diff(record.t), record.period
    ordinary = step[step < _MISSED * period]
    jitter = float(ordinary.std() / period)
    found = _gaps(record, step, period)
    if jitter > _JITTER:
        said = f"steps scatter by {jitter * period * 1e3:.2g} ms about {period * 1e3:.4g} ms ({jitter:.0%}), "
        said += f"from {ordinary.min() * 1e3:.3g} to {ordinary.max() * 1e3:.3g} ms"
        even = Fix("even", numbers=(period,))
        return [*found, warning("time/jitter", "t", said, "read the rows at even times", even)]
    missed = (step >= _MISSED * period) & (step <= _GAP * period)
    if missed.any():
        lost, first = int(np.rint(step[missed] / period - 1).sum()), float(record.t[int(np.argmax(missed))])
        said = f"{lost} rows are missing at {int(missed.sum())} places, the first after t = {first:.4g} s"
        said += f": steps of two or more periods of {period * 1e3:.4g} ms"
        even = Fix("even", numbers=(period,))
        found.append(warning("time/dropped", "t", said, "fill them by straight lines", even))
    return found


def _gaps(record: Record, step: Array, period: float) -> list[Finding]:
    gaps = np.flatnonzero(step > _GAP * period)
    if not len(gaps):
        return []
    worst = int(gaps[np.argmax(step[gaps])])
    span = float(record.t[worst]), float(record.t[worst + 1])
    said = f"{len(gaps)} gap{'s' if len(gaps) > 1 else ''}: the longest, {step[worst]:.3g} s or "
    said += f"{step[worst] / period:.0f} periods, after t = {span[0]:.4g} s"
    return [warning("time/gap", "t", said, "treat the parts as separate segments", span=span)]
