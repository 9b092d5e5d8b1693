"""Whether two runs of one push differ by more than they do at rest, where each sways by its own noise."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from upright.arrays import Array
from upright.comparison.metrics import nrmse_fit, rms
from upright.comparison.resting import STEADY

LEVEL = 0.05
"""How rarely two runs that differ by their sway alone may be further apart while a push is answered: then they are said
to differ. So 19 windows at rest are needed for each push, or nothing is said."""


class Answered(NamedTuple):
    """Two runs from a push until both are near zero: the fit [%], and whether they differ by no more than they sway."""

    fit: float
    sway_only: bool


def answer(t: Array, one: Array, other: Array, pushes: tuple[tuple[float, float], ...], rest: float) -> Answered | None:
    """Runs `one` and `other` (n,) at the times t (n,) [s] of even steps, each push answered for `rest` [s] more.

    While a push is answered the root mean square of the difference is compared with that of every window of the same
    length at rest: it differs by sway only where no more than `LEVEL` of these are as large. Both must sway alike, to
    the factor that `resting.STEADY` calls steady. None where the runs have too few windows at rest.
    """
    spans = [(start, stop + rest) for start, stop in pushes if stop + rest <= t[-1]]
    if not spans or len(spans) < len(pushes) or not math.isfinite(rest):
        return None
    answered = np.any([(t >= start) & (t < stop) for start, stop in spans], axis=0)
    calm = ~answered & (t >= spans[0][0])
    length = max(int(np.count_nonzero((t >= start) & (t < stop))) for start, stop in spans)
    apart = other - one
    windows = _windows(apart, calm, length)
    if length < 2 or len(windows) < len(spans) / LEVEL - 1:
        return None
    ratio = rms(other[calm] - other[calm].mean()) / max(rms(one[calm] - one[calm].mean()), np.finfo(float).tiny)
    largest = max(rms(apart[(t >= start) & (t < stop)]) for start, stop in spans)
    limit = float(np.quantile(windows, 1 - LEVEL / len(spans)))
    alike = 1 / STEADY <= ratio <= STEADY
    return Answered(nrmse_fit(one[answered], other[answered]), bool(alike and largest <= limit))


def _windows(apart: Array, calm: np.ndarray, length: int) -> Array:
    """Root mean square of each whole window of `length` samples at rest."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], calm.astype(np.int8), [0]])))
    parts = [
        apart[a + k : a + k + length] for a, b in edges.reshape(-1, 2) for k in range(0, b - a - length + 1, length)
    ]
    return np.array([rms(part) for part in parts])
