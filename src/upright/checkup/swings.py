"""What the gyro says of the swing: its bias, and too little motion to identify an inertia."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.checkup.body import bodily
from upright.checkup.delays import CLEAR
from upright.checkup.finding import GAP, GYRO, LEFT, PITCH, Array, Finding, Fix, Record, note, warning
from upright.checkup.physics import REACH, motion, smooth, trimmed, widths
from upright.checkup.poses import LARGEST_OFFSET, lean_of
from upright.checkup.segments import on_wheels
from upright.pages import Quantity, Say

QUIET = 0.012
"""Amplitude of the pitch [rad] below which inertias are hardly identifiable: gravity then gives less torque than
Coulomb friction in the robots whose friction is known (0.010 N m a motor against MgL of 0.4 to 0.8 N m)."""

_SHORT = 5.0  # [s] of a quiet log, in which neither kinds nor signs nor units are judged
_LEANS = 0.6  # [rad] by which the lean may differ at most between the ends of a log
_BRIEF = 3.0  # [s] of a log that may be one swing, or a fall
_PARTS = 8  # of a log, each of which is left out once
_APART = 2.0  # deviations by which a bias that the wheels tell contradicts the mean


def bias(record: Record) -> list[Finding]:
    """A gyro whose mean over the longest time on the wheels exceeds what a net change of pitch explains.

    Without poses nobody knows whether the robot was upright, nor in which unit the gyro is.
    """
    drifted = drift(record)
    if drifted is None or abs(drifted[0]) <= drifted[1]:
        return []
    mean, limit, span = drifted
    evidence = Say(
        "Its mean is {mean} over {seconds}; a motion explains at most {limit}.",
        mean=Quantity(mean, "rad/s"),
        seconds=Quantity(span, "s"),
        limit=Quantity(limit, "rad/s"),
    )
    repair = Say("Subtract {mean}.", mean=Quantity(mean, "rad/s"))
    return [warning("gyro/bias", GYRO, evidence, repair, Fix("offset", (GYRO,), (-mean,)))]


def drift(record: Record) -> tuple[float, float, float] | None:
    """The gyro's mean [rad/s] over the longest time on the wheels, without a known change of lean; the most that is no
    bias [rad/s]; and how long that time is [s]. None where the robot is nowhere known to be upright.

    Where the mean is more than that, and the wheels tell of less, the body did turn, as in a swing or a fall that the
    log's end cuts: the bias is then theirs.
    """
    spans = on_wheels(record)
    if GYRO not in record or not spans:
        return None
    start, stop = max(spans, key=lambda span: span[1] - span[0])
    whole = record
    record = record.rows((record.t >= start) & (record.t < stop))
    if len(record.t) < 50:
        return None
    gyro = record[GYRO]
    span = float(record.t[-1] - record.t[0])
    fine = np.isfinite(gyro)
    step = np.diff(record.t)
    known = step < GAP * record.period  # the motion within a gap is unknown
    turned = np.where(fine, gyro, 0.0)[1:] * step - np.diff(_turned(whole, record))
    mean = float(turned[known].sum() / step[known].sum())
    lean = min(_LEANS, 0.1 + 4 * float(_swing(record).std())) if span > _BRIEF else _LEANS
    unknown = LEFT not in record and abs(mean) > LARGEST_OFFSET  # no rad/s, and nothing tells what
    if unknown:
        return None
    limit = max(0.02, lean / span)
    measured = _by_wheels(whole, start, stop) if abs(mean) > limit else None
    if measured is not None and abs(measured[0]) <= limit and abs(mean - measured[0]) > _APART * measured[1]:
        mean = measured[0]
    return mean, limit, span


def _by_wheels(record: Record, start: float, stop: float) -> tuple[float, float] | None:
    """The gyro's bias b [rad/s] between two times [s] and its standard deviation, by the pendulum equation
    δ̈ = −q ψ̈ + p (∫gyro − b t) + c; None where that does not hold.

    The deviation is that of the jackknife over parts of the log, since the residual is not white.
    """
    m = motion(record)
    if m is None or m.gyro is None or m.law.r2 < CLEAR:
        return None
    width = widths(m.period)[-1]
    gyro = smooth(np.interp(m.t + m.law.lag, m.t, m.gyro), m.period, width)
    turn = np.gradient(gyro, m.period)
    angle = np.cumsum(gyro) * m.period
    X = np.column_stack([turn, angle, m.t - start])
    y = smooth(m.wheel, m.period, width, 2)
    edge = 4 * width + REACH
    rows = np.flatnonzero(m.good & (m.t >= start + edge) & (m.t < stop - edge))
    if len(rows) < _PARTS * X.shape[1]:
        return None

    def fitted(kept: NDArray[np.intp]) -> float:
        q, p, drifting = trimmed(y[kept], X[kept])[0]
        return float(-drifting / p) if q < 0 < p else np.nan

    parts = np.array_split(rows, _PARTS)
    less = np.array([fitted(np.concatenate([*parts[:i], *parts[i + 1 :]])) for i in range(_PARTS)])
    return fitted(rows), float(np.sqrt((_PARTS - 1) * less.var()))


def _turned(whole: Record, part: Record) -> Array:
    """The lean [rad] in the rows of a part of a log, where it is known by another sensor; else zeros."""
    m = bodily(whole)
    lean = lean_of(whole, m) if m is not None and m.gyro is not None else None
    if m is None or lean is None or not lean.absolute:
        return np.zeros(len(part.t))
    return np.interp(part.t, m.t, lean.angle)


def _swing(record: Record) -> Array:
    """The pitch [rad] without its slow part, from the gyro."""
    period = record.period
    rate = np.where(np.isfinite(record[GYRO]), record[GYRO], 0.0)
    angle = np.cumsum(rate - rate.mean()) * period
    return angle - smooth(angle, period, 0.5)


def quiet(record: Record) -> list[Finding]:
    """Too little motion to identify an inertia."""
    swing = amplitude(record)
    if not 0 < swing < QUIET:
        return []
    evidence = Say(
        "The pitch swings by only {swing}; friction and resolution hide an inertia below {limit}.",
        swing=Quantity(swing, "rad"),
        limit=Quantity(QUIET, "rad"),
    )
    name = GYRO if GYRO in record else PITCH
    return [note("motion/quiet", name, evidence, Say("Add a signal that makes it swing: `upright excite`."))]


def rests(record: Record) -> bool:
    """Whether a short log shows hardly more than resolution and friction: what fits it then is chance."""
    m = motion(record)
    return m is not None and float(m.good.sum()) * m.period < _SHORT and 0 < amplitude(record) < QUIET


def amplitude(record: Record) -> float:
    """Amplitude of the pitch [rad] on the wheels, without its slow part; 0 where no motion can be read."""
    m = motion(record)
    if m is None or m.gyro is None:
        return 0.0
    on = record.on_wheels(record.t)
    swing = _swing(record.changed({GYRO: np.interp(record.t, m.t, m.gyro)}).rows(on))
    return float(np.sqrt(2)) * float(swing.std())
