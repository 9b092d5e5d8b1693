"""Marks of a log's rows, by which the same rows are known again: in another file, another format, or a part of it.

A mark is a hash of the readings of sixteen successive rows. Of a log the smallest marks are kept: of those rows of
another log whose marks are as small, the fraction that is among them estimates how much of it is in the first (Broder
1997).
"""

from __future__ import annotations

from collections.abc import Sequence
from hashlib import blake2b

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view

from upright.arrays import Whole
from upright.logs.recording import ROWS
from upright.signals import Log

WINDOW = 16  # rows to a mark
LIVELY = 8  # of these that differ from the row before: coarse sensors of two quiet robots may read the same
KEPT = 32  # marks of a log: a fraction is known to 0.09
CHANCE = 2  # common marks from which it is no chance


def _marks(log: Log) -> Whole:
    """All marks of a log, sorted, each once."""
    names = [name for name in ROWS if name in log and "compass" not in name]
    if len(log) < WINDOW or not names:
        return np.empty(0, np.int64)
    readings = np.nan_to_num(np.column_stack([log[name] for name in names])).astype(np.float32) + 0.0  # no −0
    changed = np.concatenate([[False], (readings[1:] != readings[:-1]).any(axis=1)])
    lively = np.flatnonzero(sliding_window_view(changed, WINDOW).sum(axis=1) >= LIVELY)
    rows = (readings[start : start + WINDOW].tobytes() for start in lively)
    return np.unique([int.from_bytes(blake2b(row, digest_size=4).digest()) for row in rows]).astype(np.int64)


def marks_of(log: Log) -> tuple[int, ...]:
    """The smallest marks of a log, at most `KEPT`; none of one that hardly moves."""
    return tuple(_marks(log)[:KEPT].tolist())


def known_fraction(log: Log, known: Sequence[Sequence[int]]) -> float:
    """Which fraction of the rows of `log` is in the logs whose marks are `known`."""
    own = _marks(log)
    total = 0.0
    for marks in known:
        small = own[own <= marks[-1]] if len(marks) == KEPT else own
        common = int(np.isin(small, marks).sum())
        total += common / len(small) if common >= CHANCE else 0.0
    return min(total, 1.0)
