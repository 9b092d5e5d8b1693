"""How well each hypothesis of a bank explains the innovations, and which pushes it needs beside it."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.diagnose.faults import Bank, Column, beside, biases, unknown
from upright.diagnose.path import Tangent, Track

Array = NDArray[np.float64]

SHOWN = 3.0  # standard deviations of a reading
PULSES = 3
"""Pushes that may come beside a fault."""

SEPARATE = 0.1
"""Seconds between two pushes: several at once, up and down, would follow whatever is wrong with the model."""

SUDDEN = {"step": 0.12, "ramp": 0.4}  # [s] after an offset's onset in which it shows itself


@dataclass(frozen=True)
class Pushed:
    """A push from `start` to `stop` [s] of `impulse` [N s] at `height` [m] above the axle, and the `score` it adds."""

    start: float
    stop: float
    impulse: float
    height: float
    score: float


@dataclass(frozen=True, eq=False)
class Fit:
    """A fault that explains the innovations by `score` (log likelihood ratio less its penalty) and the `share` of their
    excess; `size` in the fault's own unit from `onset` [s] on, `pushes` beside it as (start, stop, N s)."""

    fault: str
    way: str
    score: float
    share: float
    onset: float
    size: float
    pushes: tuple[Pushed, ...]
    left: float


def fits(given: Bank) -> list[Fit]:
    """The best of each kind of fault, and of none, each with the pushes that it needs; the likeliest first."""
    kinds = dict.fromkeys((c.fault, c.way) for c in given.columns)
    best = [with_pushes(given)]
    for kind in kinds:
        some = [c for c in given.columns if (c.fault, c.way) == kind]
        some.sort(key=lambda c: _left(given.y, c)[1])
        best.append(max((with_pushes(given, c) for c in some[:3]), key=lambda f: f.score))
    best += [_sudden(given, way) for way in ("step", "ramp")]
    return sorted(best, key=lambda f: -f.score)


def _sudden(given: Bank, way: str) -> Fit:
    """The gyro's offset that explains most of what follows within `SUDDEN` of its onset, before the filter is lost."""
    columns = [c for c in given.columns if (c.fault, c.way) == ("bias", way)]
    onsets = np.array([c.onset for c in columns])
    inside = (given.then[:, None] >= onsets) & (given.then[:, None] < onsets + SUDDEN[way])
    A = np.column_stack([c.values[: len(inside)] for c in columns]) * inside
    dots, squares = A.T @ given.y[: len(inside)], np.maximum((A**2).sum(axis=0), 1e-12)
    i = int(np.argmax(dots**2 / squares))
    return with_pushes(given, columns[i], amplitude=-float(dots[i] / squares[i]))


def _left(y: Array, column: Column) -> tuple[float, float]:
    """The amplitude of least squares, and the squares that it leaves."""
    a = column.values
    amplitude = -float(a @ y) / max(float(a @ a), 1e-12) if column.free else 1.0
    return amplitude, float(((y + amplitude * a) ** 2).sum())


def with_pushes(
    given: Bank, column: Column | None = None, against: Bank | None = None, amplitude: float | None = None
) -> Fit:
    """A hypothesis (None: no fault, or one that the bank's track was freed of before, `against` the bank of the track
    as it was) with the pushes that it needs beside it."""
    y, spent = given.y, 0
    if column is not None:
        amplitude = _left(y, column)[0] if amplitude is None else amplitude
        y, spent = y + amplitude * column.values, 2
    if against is not None:
        spent = 2
    first = against or given
    best, pushes = _score(first, y, spent), list[Pushed]()
    free = np.ones(len(given.pulses), dtype=np.bool_)
    starts, stops = (np.array([getattr(p, edge) for p in given.pulses]) for edge in ("onset", "stop"))
    for _ in range(PULSES):
        dots = given.matrix.T @ y
        i = int(np.argmax(np.where(free, dots**2 / given.squares, 0.0)))
        size = -float(dots[i] / given.squares[i])
        after = y + size * given.matrix[:, i]
        score = _score(first, after, spent + 3)
        if score < best + 3:
            break
        pulse = given.pulses[i]
        impulse = size * (pulse.stop - pulse.onset)
        pushes.append(Pushed(float(pulse.onset), float(pulse.stop), impulse, pulse.size, score - best))
        y, best, spent = after, score, spent + 3
        free &= (starts > pulse.stop + SEPARATE) | (stops < pulse.onset - SEPARATE)
    left = float(y @ y) / len(y)
    share = 1 - left / max(float(first.y @ first.y) / len(first.y), 1e-12)
    if column is None:
        return Fit("none", "", best, share, math.nan, 0.0, tuple(pushes), left)
    assert amplitude is not None
    size = amplitude if column.free else column.size
    onset = _shown(given, column) if column.fault == "slip" else float(column.onset)
    return Fit(column.fault, column.way, best, share, onset, float(size), tuple(pushes), left)


def _shown(given: Bank, column: Column) -> float:
    """When a slip first shows in a reading by more than its noise: a floor may be slippery long before."""
    shows = np.flatnonzero(np.abs(column.values[: len(given.then)]) > SHOWN)
    return float(given.then[shows[0]]) if len(shows) else float(column.onset)


def _score(given: Bank, left: Array, spent: int) -> float:
    """Log likelihood against nothing at all, of readings whose noise has any scale from the usual one up."""
    size = len(given.y)
    n, floor = size / 3, size * given.scale  # three readings of one sample share what is wrong with the model
    now = (left @ left) * size / len(left)
    return n / 2 * math.log((given.y @ given.y + floor) / (now + floor)) - spent * math.log(n)


def bias_left(found: Track, flow: Tangent, fit: Fit) -> float:
    """The gyro's offset that a track still has from the onset of `fit` on, by least squares."""
    use = (found.row >= 0) & np.isfinite(found.s)
    columns = [c for c in biases(found, flow, use, np.array([fit.onset])) if c.way == fit.way]
    basis = unknown(found, flow, use)
    y = beside(basis, found.e[use] / np.sqrt(found.s[use]))
    return _left(y, replace(columns[0], values=beside(basis, columns[0].values)))[0]
