"""Confidence intervals of a probability from a count."""

from __future__ import annotations

from typing import NamedTuple


class Interval(NamedTuple):
    """A fraction, and its bounds: the true one is not below `low`, not above `high`, each with some confidence."""

    value: float
    low: float
    high: float


def clopper_pearson(count: int, n: int, confidence: float = 0.95) -> Interval:
    """The exact bounds of a binomial probability, after `count` of `n` (Clopper and Pearson 1934).

    Each bound alone holds with the `confidence`: `high` is p with P(no more than `count` of `n` | p) =
    1 − `confidence`, as a certificate judges; both together hold with 2 `confidence` − 1.
    """
    from scipy.special import betaincinv

    low = float(betaincinv(count, n - count + 1, 1 - confidence)) if count else 0.0
    high = float(betaincinv(count + 1, n - count, confidence)) if count < n else 1.0
    return Interval(count / n, low, high)


MOST_FALLS = 0.05  # red above: with one such robot in twenty, a class of students breaks one
RARE = 0.05  # [1] up to here the upper bound says all; above, both bounds count


def upper_bound(count: int, n: int, confidence: float = 0.95) -> float:
    """The upper bound of `clopper_pearson`."""
    return clopper_pearson(count, n, confidence).high
