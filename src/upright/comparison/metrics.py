"""Numbers that describe one response, or how far two responses differ; pure functions of arrays.

Time `t` [s] is strictly increasing; signals have shape (n,) like it. What cannot be said is NaN, never a guess.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.errors import InvalidLog
from upright.experiment.outcome import last_part

GROWING = 5
"""Swings, each larger than the one before, that show growth: chance orders as many in one of 120 cases."""


class Peak(NamedTuple):
    """A signal's largest `value` (signed, in the signal's unit) and the `time` [s] it is first reached."""

    value: float
    time: float


def settling_time(
    t: ArrayLike,
    y: ArrayLike,
    target: float = 0.0,
    *,
    band: float = 0.02,
    start: float | None = None,
    scale: float | None = None,
) -> float:
    """Time [s] after `start` from which |y − target| stays within band × scale up to the end of the data.

    `start` [s] is by default the first sample; `scale` (in y's unit) is by default the largest |y − target| from
    then on, so that band = 0.02 is the usual 2 % criterion both for a step and for a release. The crossing into the
    band is interpolated between samples. NaN: still outside at the last sample, NaN in the data, or nothing
    after `start`.
    """
    time, deviation = _after(t, y, start)
    if len(time) == 0 or not np.isfinite(deviation).all():
        return np.nan
    error = np.abs(deviation - target)
    limit = band * (float(error.max()) if scale is None else scale)
    outside = np.flatnonzero(error > limit)
    if len(outside) == 0:
        return 0.0
    last = int(outside[-1])
    if last == len(error) - 1:
        return np.nan
    fraction = (error[last] - limit) / (error[last] - error[last + 1])
    origin = time[0] if start is None else start
    return float(time[last] + fraction * (time[last + 1] - time[last]) - origin)


def settled(t: ArrayLike, y: ArrayLike, *, band: float, start: float) -> float:
    """`settling_time` about zero [s]; NaN where y leaves the band in the last quarter of the record too: then the time
    would be that of the record's end."""
    _, deviation = _after(t, y, start)
    size = np.abs(deviation)
    swings = len(size) == 0 or size[last_part(len(size)) :].max() > band * size.max()
    return np.nan if swings else settling_time(t, y, band=band, start=start)


def doubling(t: ArrayLike, y: ArrayLike, *, start: float) -> float:
    """Time [s] in which the swing of y doubles over the end of the data; NaN where it does not grow clearly.

    A swing goes from one turning point to the next, past the mean. Of those that end the data, `GROWING` or more each
    exceed the one before, and have doubled twice: of records of noise that swings by itself two in a hundred look so.
    """
    time, values = _after(t, y, start)
    deviation = values - values.sum() / max(len(values), 1)
    large = np.abs(deviation) > 0.05 * np.abs(deviation).max(initial=0.0)  # else noise near zero makes turns of its own
    time, deviation = time[large], deviation[large]
    sides = np.flatnonzero(np.diff(np.sign(deviation))) + 1
    peaks = np.maximum.reduceat(np.abs(deviation), sides)[:-1]  # the last has yet to turn
    swings = peaks[1:] + peaks[:-1]
    growing = swings[np.flatnonzero(np.diff(swings) <= 0).max(initial=-1) + 1 :]
    if len(growing) < GROWING or growing[-1] < 4 * growing[0]:
        return np.nan
    return float(np.log(2) * np.ptp(time[sides[:-1][-len(growing) :]]) / np.log(growing[-1] / growing[0]))


def overshoot(y: ArrayLike, target: float = 0.0) -> float:
    """Largest deviation on the far side of `target` over the largest on the side where y starts [1].

    For a step response it is the textbook's (peak − final)/(final − initial); 0 if the target is never
    passed. NaN if y starts on the target or holds a NaN.
    """
    deviation = _array(y) - target
    if len(deviation) == 0 or deviation[0] == 0 or not np.isfinite(deviation).all():
        return np.nan
    near = deviation * np.sign(deviation[0])
    return float(max(0.0, -near.min()) / near.max())


def peak(t: ArrayLike, y: ArrayLike, target: float = 0.0) -> Peak:
    """The deviation of y from `target` with the largest magnitude (sign kept), and when; NaN are passed over."""
    time, values = _pair(t, y)
    deviation = values - target
    if not np.isfinite(deviation).any():
        return Peak(np.nan, np.nan)
    row = int(np.nanargmax(np.abs(deviation)))
    return Peak(float(deviation[row]), float(time[row]))


def rms(y: ArrayLike) -> float:
    """Root of the mean square, in y's unit; NaN for no samples."""
    values = _array(y)
    return float(np.sqrt(np.mean(values**2))) if len(values) else np.nan


def effort(t: ArrayLike, left: ArrayLike, right: ArrayLike) -> float:
    """∫ (u_l² + u_r²) dt, in [V² s] for commands in volts.

    By the trapezium rule: the mean of the two ways in which a held command can belong to its samples.
    """
    time, u_left = _pair(t, left)
    _, u_right = _pair(t, right)
    return float(np.trapezoid(u_left**2 + u_right**2, time))


def saturated_fraction(command: ArrayLike, applied: ArrayLike, margin: float = 0.01) -> float:
    """Fraction of samples [1] whose |command| is more than `margin` above the largest |applied| of the whole record.

    Both have shape (n,) or (n, 2), a row counting if either motor does. A command is not compared with the one
    applied in the same row, since a delay or a quantised duty would then pass for saturation. NaN for no samples.
    """
    requested, given = np.asarray(command, dtype=np.float64), np.asarray(applied, dtype=np.float64)
    if requested.shape != given.shape:
        raise InvalidLog(f"command has shape {requested.shape} and applied {given.shape}", expected="equal shapes")
    if requested.size == 0:
        return np.nan
    beyond = np.abs(requested) > (1 + margin) * np.abs(given).max(axis=0)
    return float(np.mean(beyond.any(axis=1) if beyond.ndim == 2 else beyond))


def held_fraction(command: ArrayLike) -> float:
    """Fraction of samples [1] at which a command stands at its own limit: at exactly its largest size, where it is more
    often than at the next size below, as only a clipped command is."""
    _, counts = np.unique(np.abs(_array(command)), return_counts=True)
    return float(counts[-1] / counts.sum()) if len(counts) > 2 and counts[-1] > 2 * counts[-2] else 0.0


def nrmse_fit(reference: ArrayLike, model: ArrayLike) -> float:
    """Fit 100 (1 − ‖y − ŷ‖ / ‖y − mean y‖) [%] of `model` ŷ to `reference` y (Ljung, System Identification, 1999).

    100 is perfect, 0 no better than the reference's mean, negative worse. NaN for a reference that does not vary.
    """
    y, y_hat = _array(reference), _array(model)
    if y.shape != y_hat.shape:
        raise InvalidLog(f"reference has {len(y)} samples and model {len(y_hat)}", expected="equal lengths")
    spread = float(np.linalg.norm(y - y.mean())) if len(y) else 0.0
    if not spread > 1e-12 * float(np.linalg.norm(y)):  # the rounding of a constant's mean is no variation
        return np.nan
    return 100.0 * (1.0 - float(np.linalg.norm(y - y_hat)) / spread)


def active_intervals(t: ArrayLike, y: ArrayLike) -> tuple[tuple[float, float], ...]:
    """The times (start, stop) [s] over which y is not zero, up to its first zero sample or, at the end, inf."""
    time, values = _pair(t, y)
    edges = np.diff(np.concatenate([[0], values != 0, [0]]).astype(np.int8))
    stops = [float(time[row]) if row < len(time) else np.inf for row in np.flatnonzero(edges == -1)]
    return tuple(zip((float(time[row]) for row in np.flatnonzero(edges == 1)), stops, strict=True))


def _array(values: ArrayLike) -> Array:
    return np.asarray(values, dtype=np.float64)


def _pair(t: ArrayLike, y: ArrayLike) -> tuple[Array, Array]:
    time, values = _array(t), _array(y)
    if time.shape != values.shape or time.ndim != 1:
        raise InvalidLog(f"t has shape {time.shape} and the signal {values.shape}", expected="one number per sample")
    return time, values


def _after(t: ArrayLike, y: ArrayLike, start: float | None) -> tuple[Array, Array]:
    time, values = _pair(t, y)
    keep = slice(None) if start is None else time >= start
    return time[keep], values[keep]
