"""Fewer samples of a line that look the same."""

from __future__ import annotations

import numpy as np

from upright.arrays import Array


def decimate(x: Array, y: Array, columns: int) -> tuple[Array, Array]:
    """Keep the first, smallest, largest and last sample of each of `columns` equal parts of x, which looks the same.

    Few samples, and an x that does not increase, come back as they are.
    """
    if len(x) <= 4 * columns or (np.diff(x) <= 0).any():
        return x, y
    column = np.minimum((x - x[0]) / (x[-1] - x[0]) * columns, columns - 1).astype(int)
    starts = np.flatnonzero(np.diff(column, prepend=-1))
    keep: set[int] = set()
    for start, stop in zip(starts, np.append(starts[1:], len(x)), strict=True):
        part = y[start:stop]
        keep |= {int(start), int(start + part.argmin()), int(start + part.argmax()), int(stop - 1)}
    rows = sorted(keep)
    return x[rows], y[rows]
