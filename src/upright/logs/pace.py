"""Whether a program kept its pace: its rows' own times against the period that it is meant to have."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.pages import Quantity, Say
from upright.signals import Log

SLOW = 0.02  # [1] by which the median step of a clock that keeps its pace may differ from the period
OVERDUE = 1.15  # periods after which a row is late: stamps of a millisecond differ by one in ten


@dataclass(frozen=True)
class Pace:
    """The program's `period` [s], the `median` step of its rows [s], and how many of its `rows` were `overdue`."""

    period: float
    median: float
    overdue: int
    rows: int

    @property
    def kept(self) -> bool:
        """Whether the log shows the period that the program is meant to have."""
        return not self.overdue and abs(self.median / self.period - 1) < SLOW

    def in_words(self) -> Say:
        """How many rows came late, and how far they are apart."""
        return Say(
            "{late} of {rows} rows came late: {median} apart, where the program's period is {period}.",
            late=self.overdue,
            rows=self.rows,
            median=Quantity(self.median, "s"),
            period=Quantity(self.period, "s"),
        )


def pace_of(log: Log) -> Pace | None:
    """The pace of the program that wrote a log, None where its period is not known."""
    return pace(log.t, log.origin)


def pace(t: Any, origin: Any) -> Pace | None:
    """The same of the times `t` (n,) [s] under the `origin` of a log."""
    made, outcome = (origin.get(name) if hasattr(origin, "get") else None for name in ("controller", "outcome"))
    period, count = (d.get(k) if isinstance(d, dict) else None for d, k in ((made, "period"), (outcome, "late")))
    steps = np.diff(np.asarray(t, dtype=np.float64))
    if not (isinstance(period, float | int) and period > 0 and isinstance(count, float | int) and len(steps)):
        return None
    return Pace(float(period), float(np.median(steps)), int(count), len(steps))


def overdue(t: Array, period: float, consecutive: Any = True) -> int:
    """How many rows came late after the one before, by their own times `t` (n,) [s]; only after `consecutive` rows
    (n − 1,), since a row may be lost as well."""
    return int(((np.diff(t) > OVERDUE * period) & consecutive).sum())
