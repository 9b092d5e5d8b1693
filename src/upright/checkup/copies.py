"""Channels that are a multiple of another, or a sum of two others, in every row: one reading under several names."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from upright.checkup.finding import COMPASS, FORWARD, GYRO, LEFT, PITCH, RIGHT, UP, Array, Finding, Record, error, plain
from upright.checkup.fixes import levels
from upright.checkup.titles import CHANNELS
from upright.logs.outliers import grain_of
from upright.pages import Say

_SENSORS = (COMPASS, PITCH, LEFT, RIGHT, GYRO, FORWARD, UP)  # what is rather made of others first
_KINDS = (PITCH, LEFT, RIGHT, GYRO)  # of two of these that are one, nothing tells which it is
_LEVELS, _LEFT_OVER = 12, 0.1  # different readings, and most of a reading's deviation that its digits may leave


def copies(record: Record) -> list[Finding]:
    """Sensors that tell nothing of their own, to be left out: no physics is read into one reading against itself. Both
    wheels may be one, as on a straight course."""
    read = {n: _as_read(record, n) for n in _SENSORS if n in record and np.isfinite(record[n]).all()}
    read = {name: values for name, values in read.items() if levels(values) > _LEVELS}
    copied: dict[str, Say] = {}
    alike: set[frozenset[str]] = set()
    for size in (2, 3):
        for name, *others in combinations(read, size):
            if any(frozenset(pair) in alike for pair in combinations((name, *others), 2)):
                continue
            factors = _factors(read[name], [read[other] for other in others])
            if not len(factors):
                continue
            alike.add(frozenset((name, *others)))
            if (name, *others) != (LEFT, RIGHT):
                text = _made(name, others, factors)
                copied |= dict.fromkeys([name, *(o for o in others if size == 2 and {name, o} <= {*_KINDS})], text)
    repair = Say("Map the sensor's own column, or leave it out.")
    return [error("columns/copied", name, text, repair) for name, text in copied.items()]


def _made(name: str, others: list[str], factors: Array) -> Say:
    """Of which channels, and by which factors, one is made."""
    own, one, *two = (CHANNELS[channel] for channel in (name, *others))
    by, *more = (plain(float(factor), digits=4) for factor in factors)
    if not two:
        return Say("In every row {own} is {by} times {one}: one reading under two names.", own=own, by=by, one=one)
    return Say(
        "In every row {own} is {by} times {one} plus {more} times {two}: no reading of its own.",
        own=own,
        by=by,
        one=one,
        more=more[0],
        two=two[0],
    )


def _as_read(record: Record, name: str) -> Array:
    """A channel's rows, from the second on, as the log has them: of one that was summed, its rates."""
    return np.diff(record[name]) / np.diff(record.t) if name in record.summed else record[name][1:]


def _factors(target: Array, parts: list[Array]) -> Array:
    """By which factors the parts make the target in every row, but for the steps of all; none where they do not."""
    X = np.column_stack([x - x.mean() for x in parts])
    factors = np.linalg.lstsq(X, target - target.mean(), rcond=None)[0]
    left = np.abs(target - target.mean() - X @ factors)
    size = float(np.std(target))
    steps = grain_of(target) + sum(abs(by) * grain_of(x) for by, x in zip(factors, parts, strict=True))
    least = min(float(np.std(by * x)) for by, x in zip(factors, X.T, strict=True))
    same = left.max() <= max(steps, 1e-6 * size) < size
    return factors if same and left.std() < _LEFT_OVER * min(size, least) else np.zeros(0)
