"""Confidence intervals of a probability from a count."""

from __future__ import annotations

import math
from typing import NamedTuple


class Interval(NamedTuple):
    """A fraction, and the interval that holds the true one with the stated confidence."""

    value: float
    low: float
    high: float

    @property
    def top(self) -> float:
        """The upper end that is shown: where none was counted, that of `upper_bound` at the same confidence (95 %)."""
        return self.high if self.value else 1 - (1 - self.high) ** (math.log(0.05) / math.log(0.025))


def clopper_pearson(count: int, n: int, confidence: float = 0.95) -> Interval:
    """The exact interval of a binomial probability, after `count` of `n` (Clopper and Pearson 1934)."""
    from scipy.special import betaincinv

    tail = (1 - confidence) / 2
    low = float(betaincinv(count, n - count + 1, tail)) if count else 0.0
    high = float(betaincinv(count + 1, n - count, 1 - tail)) if count < n else 1.0
    return Interval(count / n, low, high)


RARE = 0.05  # [1] up to here an upper bound says all; above, both ends of an interval count


def upper_bound(count: int, n: int, confidence: float = 0.95) -> float:
    """Upper confidence bound of the true probability: p with P(no more than `count` of `n` | p) = 1 − `confidence`."""
    return clopper_pearson(count, n, 2 * confidence - 1).high  # one-sided: the whole remainder lies above
