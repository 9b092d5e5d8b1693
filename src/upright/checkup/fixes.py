"""Repairs: pure functions from a record and numbers to a record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from upright.arrays import Mask
from upright.checkup.finding import Array, Fix, Record
from upright.logs.outliers import bridged, grain_of, single


def repaired(record: Record, fix: Fix) -> Record:
    """`record` with one fix applied; what becomes of a command without a unit is volts."""
    new = FIXES[fix.kind](record, fix)
    volts = {name: "V" for name in fix.channels if fix.kind in ("scale", "percent") and record.units.get(name) == "1"}
    return replace(new, units={**new.units, **volts}) if volts else new


def _each(record: Record, fix: Fix, change: Callable[[Array], Array]) -> Record:
    return record.changed({name: change(record[name]) for name in fix.channels if name in record})


def _scale(record: Record, fix: Fix) -> Record:
    return _each(record, fix, lambda x: x * fix.numbers[0])


def _offset(record: Record, fix: Fix) -> Record:
    return _each(record, fix, lambda x: x + fix.numbers[0])


def _swap(record: Record, fix: Fix) -> Record:
    pairs = list(zip(fix.channels[::2], fix.channels[1::2], strict=True))
    return record.changed({a: record[b] for a, b in pairs} | {b: record[a] for a, b in pairs})


def _differentiate(record: Record, fix: Fix) -> Record:
    return _each(record, fix, lambda x: np.gradient(x, record.t))


def _integrate(record: Record, fix: Fix) -> Record:
    steps = np.diff(record.t)
    return _each(record, fix, lambda x: np.concatenate([[0.0], np.cumsum(x[1:] * steps)]))


def _earlier(record: Record, fix: Fix) -> Record:
    """Shift the channels by `numbers[0]` [s], which removes their delay; the last rows keep the last reading."""
    return _each(record, fix, lambda x: np.interp(record.t + fix.numbers[0], record.t, x))


def _percent(record: Record, fix: Fix) -> Record:
    """Per cent to volts, by the battery voltage (the last channel)."""
    *commands, battery = fix.channels
    return record.changed({name: record[name] * record[battery] / 100 for name in commands})


def _time_scale(record: Record, fix: Fix) -> Record:
    return replace(record, t=record.t * fix.numbers[0])


def _sort(record: Record, fix: Fix) -> Record:  # noqa: ARG001 (every fix has the same form)
    order = np.argsort(record.t, kind="stable")
    return record.rows(order)


def _unique(record: Record, fix: Fix) -> Record:  # noqa: ARG001
    return record.rows(np.concatenate([[True], np.diff(record.t) > 0]))


def _spread(record: Record, fix: Fix) -> Record:  # noqa: ARG001
    """Rows evenly between the steps of a coarse clock: over the whole log where its times allow, else in each step."""
    first = np.flatnonzero(np.concatenate([[True], np.diff(record.t) > 0]))
    if len(first) < 2:
        return record
    rows = np.arange(len(record.t), dtype=np.float64)
    steps = np.diff(record.t[first])
    period, start = np.polyfit(rows, record.t, 1)
    even = start + period * rows
    if float(np.abs(even - record.t).max()) < float(np.median(steps)):
        return replace(record, t=even - even[0] + record.t[0])
    known = np.append(record.t[first], record.t[first[-1]] + period * (len(rows) - first[-1]))
    return replace(record, t=np.interp(rows, np.append(first, len(rows)), known))


def _finite_time(record: Record, fix: Fix) -> Record:  # noqa: ARG001
    return record.rows(np.isfinite(record.t))


def _row_range(record: Record, fix: Fix) -> Record:
    first, last = (int(number) for number in fix.numbers)
    return record.rows(np.arange(first, min(last, len(record.t))))


def _cut(record: Record, fix: Fix) -> Record:
    """Only the rows from `numbers[0]` to `numbers[1]` [s]."""
    keep = (record.t >= fix.numbers[0]) & (record.t < fix.numbers[1])
    return record.rows(keep) if keep.sum() >= 2 else record


def _even(record: Record, fix: Fix) -> Record:
    """Linear interpolation at even steps of `numbers[0]` [s]."""
    t = record.t[0] + np.arange(int((record.t[-1] - record.t[0]) / fix.numbers[0] + 1e-6) + 1) * fix.numbers[0]
    return replace(record, t=t, channels={name: np.interp(t, record.t, x) for name, x in record.channels.items()})


def _insert(record: Record, fix: Fix) -> Record:
    """The rows that are missing at a period of `numbers[0]`, in steps of up to `numbers[1]` [s], by linear
    interpolation, rounded to a channel's own steps. All others stay as they are."""
    period, longest = fix.numbers
    steps = np.diff(record.t)
    rows = np.where(steps <= longest, np.maximum(1, np.rint(steps / period)), 1).astype(np.int64)
    at = np.concatenate([[0], np.cumsum(rows)])
    t = np.interp(np.arange(at[-1] + 1), at, record.t)
    missing = ~np.isin(np.arange(len(t)), at)

    def whole(x: Array) -> Array:
        between = np.interp(t, record.t, x)
        grain = grain_of(x)
        between[missing] = np.rint(between[missing] / grain) * grain if grain else between[missing]
        between[at] = x
        return between

    return replace(record, t=t, channels={name: whole(x) for name, x in record.channels.items()})


def _bridge(record: Record, fix: Fix) -> Record:
    """Replace stale readings (repeated while the channel moves) by linear interpolation."""
    return _each(record, fix, lambda x: bridged(record.t, x, stale(x)))


def _single(record: Record, fix: Fix) -> Record:
    """Replace single readings far from their neighbours by linear interpolation."""
    return _each(record, fix, lambda x: bridged(record.t, x, single(record.t, x)))


def _unwrap(record: Record, fix: Fix) -> Record:
    """Add periods of `numbers[0]` where the readings begin again."""

    def change(x: Array) -> Array:
        fine = np.isfinite(x)
        whole = x.copy()
        whole[fine] = np.unwrap(x[fine], period=fix.numbers[0])
        return whole

    return _each(record, fix, change)


def _fill(record: Record, fix: Fix) -> Record:
    """Replace missing readings by linear interpolation."""
    return _each(record, fix, lambda x: bridged(record.t, x, ~np.isfinite(x)))


def stale(x: Array) -> Mask:
    """Readings that repeat the previous one although their neighbours change by more than three quantisation steps.

    The slope is taken from the other neighbours, x[k−1] and x[k+1]; a slow signal, which repeats by quantisation,
    is not marked.
    """
    repeats = np.zeros(len(x), dtype=bool)
    if len(x) < 5:
        return repeats
    grain = grain_of(x)
    same = x[2:-1] == x[1:-2]
    before = x[1:-2] - x[:-3]
    after = x[3:] - x[2:-1]
    moving = (np.abs(after) >= 4 * grain) & (np.abs(before) >= 1.5 * grain) & (before * after > 0)
    repeats[2:-1] = same & moving
    return repeats


def beside(mask: Mask, reach: int) -> Mask:
    """The rows that are in `mask`, or within `reach` rows of one that is; of any length."""
    from scipy.ndimage import maximum_filter1d

    return maximum_filter1d(mask.astype(np.uint8), 2 * reach + 1, mode="constant").astype(np.bool_)


COARSE = 12  # different readings, up to which a channel is too coarse to differentiate
_FEW = 8  # values of an experiment's commands: steps, or a random binary signal; those of a law are many


def levels(x: Array) -> int:
    """How many different readings there are."""
    return len(np.unique(np.round(x[np.isfinite(x)], 9)))


def switched(command: Array) -> bool:
    """Whether a command only switches between a few levels, as an experiment's does: the largest is one of them, and no
    limit of the motors."""
    return levels(command) <= _FEW


FIXES: dict[str, Callable[[Record, Fix], Record]] = {
    "scale": _scale, "offset": _offset, "swap": _swap, "differentiate": _differentiate, "integrate": _integrate,
    "earlier": _earlier, "percent": _percent, "time scale": _time_scale, "sort": _sort, "unique": _unique,
    "finite time": _finite_time, "rows": _row_range, "cut": _cut, "even": _even, "insert": _insert, "bridge": _bridge,
    "fill": _fill, "unwrap": _unwrap, "single": _single, "spread": _spread,
}  # fmt: skip
