"""Readings that say nothing of the robot: those at the end of a sensor's range, and single ones far from their
neighbours."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from upright.arrays import Array, Mask
from upright.pages import Say
from upright.signals import Log

SENSORS = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro")
FULL, BELOW = 0.995, 0.9  # of the largest size: readings at the end of the range, and those below it
PILED, LONGEST = 0.003, 3  # of all readings, and rows on end, from which it is a range
LEVELS = 10.0  # steps of its resolution that a gyro's range has at least

USUAL = 0.95  # the quantile of the differences from the neighbours' median that counts as usual
FAR = 4.0  # times the usual difference, and steps of the resolution
STEEP = 4.0  # times the upper quartile of the steps beside it: no robot turns round so fast
NEAR = 5  # readings on each side that it is compared with
AWAY, SAME = 0.75, 0.02  # of its height: what both steps beside it have, and how alike two in a row are
GAP = 1.5  # of a usual step of the time, above which rows are missing
CALM = 0.5  # of its height: how far its neighbours may be from the median of those beyond, and these from each other
BACK = 0.25  # of its height to which it comes back
MOST = 0.05  # of the readings: more are a way of the sensor, and no single ones


def at_range(values: Array, levels: float = LEVELS) -> Mask:
    """Which readings (n,) are at the end of the sensor's range: those near the largest size, where they pile up rather
    than being a peak, and last. None of a sensor that moves less than `levels` steps of its resolution."""
    size = np.abs(np.where(np.isfinite(values), values, 0.0))
    top = float(size.max(initial=0.0))
    at = (size >= FULL * top) & np.isfinite(values)
    if top == 0 or top < levels * grain_of(values):
        return np.zeros(len(values), dtype=bool)
    near = int(((size >= BELOW * top) & ~at).sum())
    longest = max((stop - start for start, stop in runs(at)), default=0)
    piled = at.sum() >= max(5, 0.1 * near, PILED * len(values)) and at.sum() > 0.5 * near and longest >= LONGEST
    return at if piled else np.zeros(len(values), dtype=bool)


def single(t: Array, values: Array) -> Mask:
    """Which readings (n,) at the times `t` stand alone for a row or two: far from what was before and comes after,
    where no robot is so fast; the first or the last only beside others. None beside rows that are missing, and none
    where there are many."""
    alone = np.zeros(len(values), dtype=bool)
    fine = np.flatnonzero(np.isfinite(values))
    if len(fine) < 20:
        return alone
    x = values[fine]
    around = np.lib.stride_tricks.sliding_window_view(np.pad(x, 2, mode="reflect"), 5)
    apart = np.abs(x - np.median(around, axis=1))
    limit = FAR * max(float(np.quantile(apart, USUAL)), grain_of(values))
    steps = np.diff(t[fine])
    missing = np.pad(steps > GAP * np.median(steps), 1)
    apart[missing[1:] | missing[:-1]] = 0.0
    for k in np.flatnonzero(apart > limit).tolist():
        alone[fine[k]] = _stands_alone(x, k, float(apart[k]))
    between = int(alone[fine[1:-1]].sum())  # the first reading alone may be of a sensor that has only begun
    return alone if 0 < between <= MOST * len(x) else np.zeros(len(values), dtype=bool)


def _stands_alone(x: Array, k: int, height: float) -> bool:
    """Whether reading k, or the two of one value there, is a step of `height` away and back between calm readings."""
    pair = [k, *(j for j in (k - 1, k + 1) if 0 <= j < len(x) and abs(x[j] - x[k]) < SAME * height)]
    before = x[max(0, min(pair) - 1 - NEAR) : min(pair)]
    after = x[max(pair) + 1 : max(pair) + 2 + NEAR]
    sides = np.concatenate([before[-1:], after[:1]])  # one alone beside the first and the last reading
    middle = float(np.median(np.concatenate([before, after])))
    steps = np.abs(np.concatenate([np.diff(before), np.diff(after)]))
    away = np.abs(x[k] - sides).min() > AWAY * height
    back = np.ptp(sides) < BACK * height
    ranges = [float(np.ptp(side)) for side in (before, after) if len(side)]
    calm = max(float(np.abs(sides - middle).max()), *ranges) < CALM * height
    return bool(away and back and calm and height > STEEP * np.quantile(steps, 0.75))


def left_out(log: Log, name: str) -> Mask:
    """Which rows of a sensor a fit is not to read; read-only."""
    return _left_out(log.t.tobytes(), np.asarray(log[name], dtype=np.float64).tobytes(), name)


@lru_cache(maxsize=8)  # a post-mortem reads the same sensors some hundred times, with other commands
def _left_out(times: bytes, readings: bytes, name: str) -> Mask:
    values = np.frombuffer(readings)
    alone = single(np.frombuffer(times), values) if name in SENSORS else np.zeros(len(values), dtype=bool)
    left = alone | at_range(np.where(alone, np.nan, values)) if name == "sensor/gyro" else alone
    left.setflags(write=False)
    return left


def in_words(log: Log) -> Say | None:
    """How many readings of which sensor are left out; None where none are."""
    counted = {name: int(left_out(log, name).sum()) for name in SENSORS if name in log}
    many = [Say("{sensor}: {n}", sensor=name, n=count) for name, count in counted.items() if count]
    if not many:
        return None
    return Say(
        "Of {n} readings some are left out, far from the others or at the end of a range: {many}.",
        n=len(log),
        many=many,
    )


def bridged(t: Array, values: Array, left: Mask) -> Array:
    """Readings (n,) at the times `t`, where those that are `left` out lie on a line between the others."""
    return np.where(left, np.interp(t, t[~left], values[~left]), values) if left.any() else values


def runs(mask: Mask) -> list[tuple[int, int]]:
    """First and last-plus-one row of each run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(np.int8), [0]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def grain_of(values: Array) -> float:
    """Quantisation step: the 0.1 % quantile of the steps between readings that differ; 0 where there are none."""
    steps = np.sort(np.abs(np.diff(values[np.isfinite(values)])))
    steps = steps[steps > 1e-12 * (1 + float(np.abs(values[np.isfinite(values)]).max(initial=0.0)))]
    return float(steps[len(steps) // 1000]) if len(steps) else 0.0
