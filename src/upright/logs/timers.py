"""Timers of microcontrollers, which begin again at zero after 16, 24 or 32 bits."""

from __future__ import annotations

import numpy as np

from upright.arrays import Array
from upright.logs.readers import RawTable

TIMERS = tuple(2.0**bits * unit for bits in (16, 24, 32) for unit in (1.0, 1e-3, 1e-6))
"""What a timer counts to: its own counts, or seconds that a program made of its milli- or microseconds."""

_AHEAD = 50.0  # rows that may be missing where one begins again


def unwrapped(clock: str, table: RawTable) -> dict[str, Array]:
    """The clock where its timer began again, going on; empty where it did not."""
    counts = table.columns.get(clock, np.zeros(0))
    steps = np.diff(counts)
    for size in TIMERS:
        back = steps < -size / 2
        if not back.any() or counts.min() < 0 or counts.max() >= size:
            continue
        usual = float(np.median(steps))
        if ((steps[back] + size > 0) & (steps[back] + size < _AHEAD * usual)).all():
            again = np.concatenate([[0.0], np.cumsum(back)]) * size
            return {clock: counts + again}
    return {}
