"""Parts of a log in which the robot does not balance: it falls, lies, stands still, slips, or something pushes it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.doctor.delays import CLEAR
from upright.doctor.finding import LEFT, PITCH, Array, Finding, Fix, Record, note, warning
from upright.doctor.physics import Motion, motion, pendulum, smooth, widths

_STILL = 0.4  # [s] shortest stand that is told: longer than the turning points of any balancing
_MOST = 10  # events of one kind that are told
_TIPPED = 0.5  # [rad] lean from which a robot that stays there, or goes on, has fallen


def runs(mask: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """First and last-plus-one row of each run of True."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], mask.astype(np.int8), [0]])))
    return list(zip(edges[::2].tolist(), edges[1::2].tolist(), strict=True))


def lean(record: Record, m: Motion) -> Array:
    """Pitch [rad] from the gyro, or the logged estimate without one; only differences over seconds are meant."""
    if m.gyro is None:
        return np.interp(m.t, record.t, record[PITCH]) if PITCH in record else np.zeros(len(m.t))
    return np.cumsum(m.gyro - np.median(m.gyro)) * m.period


def fall(record: Record) -> list[Finding]:
    """The last tip-over: a large one-sided turn in which the log ends, or after which the robot lies."""
    m = motion(record)
    if m is None:
        return []
    rate = smooth(_pitch_rate(record, m), m.period, widths(m.period)[0])
    fastest, angle = float(np.abs(rate).max()), np.concatenate([[0.0], np.cumsum(rate)]) * m.period
    turns = np.array(sorted(run for way in (1, -1) for run in runs(way * rate > 0.02 * fastest)), dtype=int)
    if not len(turns):
        return []
    sizes = np.abs(angle[turns[:, 1]] - angle[turns[:, 0]])
    earlier = np.maximum.accumulate(np.concatenate([[0.0], sizes[:-1]]))
    for i in np.flatnonzero((sizes > _TIPPED) & (sizes > 1.3 * earlier)).tolist():
        first, last = turns[i].tolist()
        peak = float(np.abs(rate[first:last]).max())
        ends = last >= len(rate) - round(0.1 / m.period)
        if peak > 0.5 * fastest and (ends or _lies(rate[last:], peak, m.period)):
            return [_fell(m, first, float(sizes[i]), peak, ends)]
    return []


def _lies(rate: Array, peak: float, period: float) -> bool:
    """Whether after the impact and its bounces the rest is still, compared with the fall."""
    rest = rate[round(0.5 / period) :]
    return len(rest) * period > 0.2 and float(np.sqrt(np.mean(rest**2))) < 0.03 * peak


def _fell(m: Motion, first: int, turn: float, fastest: float, ends: bool) -> Finding:
    start = float(m.t[first])
    how = "the log ends in it" if ends else "and then lies still"
    said = f"from t = {start:.3g} s the pitch runs away by {turn:.2g} rad at up to {fastest:.2g} rad/s, {how}"
    cut = Fix("cut", numbers=(float(m.t[0]) - 1.0, start - 0.1))
    span = start, float(m.t[-1])
    return warning("segment/fall", m.gyro_name, said, f"use t < {start - 0.1:.3g} s", cut, span=span)


def _pitch_rate(record: Record, m: Motion) -> Array:
    return m.gyro if m.gyro is not None else np.gradient(lean(record, m), m.period)


def still(record: Record) -> list[Finding]:
    """Stretches in which neither wheel turns and the gyro only makes noise: held, lying, or stuck by friction."""
    m = motion(record)
    if m is None:
        return []
    rate, count = _pitch_rate(record, m), max(3, round(0.1 / m.period))
    left, right = (np.abs(smooth(wheel, m.period, 2 * m.period, 1)) for wheel in (m.left, m.right))
    moved, swings = np.convolve(left + right, np.ones(count) / count, mode="same"), np.abs(smooth(rate, m.period, 0.05))
    level = max(0.02 * float(np.percentile(left + right, 95)), 1e-6)
    calm = (moved < level) & (swings < max(3 * _noise(rate), 0.03 * float(np.percentile(swings, 95))))
    found = [(a, b) for a, b in runs(calm) if (b - a) * m.period >= _STILL]
    if sum(b - a for a, b in found) > 0.98 * len(calm):
        return []
    return [_stood(record, m, a, b, rate) for a, b in found[:_MOST]]


def _stood(record: Record, m: Motion, a: int, b: int, rate: Array) -> Finding:
    start, end = float(m.t[a]), float(m.t[b - 1])
    driven = float(np.abs((m.commands[0] + m.commands[1])[a:b] / 2).mean()) if m.commands is not None else 0.0
    unit = record.units.get(record.commands[0], "") if record.commands else ""
    said = f"from {start:.3g} to {end:.3g} s (rows {a} to {b - 1}) the wheels stand and the gyro only scatters by "
    said += (
        f"{rate[a:b].std():.2g} rad/s under a mean command of {driven:.2g} {unit}: a free robot would fall, so it is "
    )
    said += "held, lies, or friction holds it"
    return note("segment/still", m.gyro_name, said, "leave these rows out of a fit", span=(start, end))


def _noise(rate: Array) -> float:
    """Standard deviation of white noise from second differences, which motion hardly has."""
    return float(np.median(np.abs(np.diff(rate, 2))) / 0.6745 / np.sqrt(6)) if len(rate) > 3 else 0.0


def slips(record: Record) -> list[Finding]:
    """Wheels that spin without moving the robot, and pushes: where the pendulum's law fails for a moment.

    A push gives its momentum to the robot, so the misfit of δ̈ has one sign; a wheel that slips spins up and is braked
    again when it grips, so the misfit has two that cancel.
    """
    m = motion(record)
    if m is None or m.gyro is None:
        return []
    fit = pendulum(m, m.wheel)
    if fit.r2 < CLEAR or not fit.values or fit.values[0] <= 0:
        return []
    width = widths(m.period)[0]
    gyro = np.interp(m.t + fit.lag, m.t, m.gyro)
    miss = smooth(m.wheel, m.period, width, 2) + fit.values[0] * smooth(gyro, m.period, width, 1)
    miss = miss - fit.values[1] * np.cumsum(smooth(gyro, m.period, width)) * m.period
    miss = miss - smooth(miss, m.period, 0.4)
    edge = int(1.0 / m.period)
    scatter = float(np.median(np.abs(miss))) / 0.6745
    usual = float(np.sqrt(np.median(smooth(m.wheel, m.period, width, 2) ** 2))) / 0.6745
    loud = np.abs(miss) > max(8 * scatter, 3 * usual)
    loud[:edge], loud[-edge:] = False, False
    return _events(m, miss, loud, scatter)


def _events(m: Motion, miss: Array, loud: NDArray[np.bool_], scatter: float) -> list[Finding]:
    join = max(1, round(0.25 / m.period))
    near = np.convolve(loud, np.ones(2 * join + 1), mode="same") > 0.5
    found: list[Finding] = []
    for a, b in runs(near)[:_MOST]:
        part = miss[a:b]
        largest = float(np.abs(part).max())
        both = min(float(part.max()), float(-part.min())) / largest
        balance = abs(float(part.sum())) / float(np.abs(part).sum())
        span = float(m.t[a + join]), float(m.t[b - 1 - join])
        said = f"from {span[0]:.3g} to {span[1]:.3g} s the wheels' acceleration misses the pendulum's law by up to "
        said += f"{largest:.3g} rad/s², {largest / scatter:.0f} times the usual"
        if both > 0.35 and balance < 0.35:
            said += ", forth and back again: the wheels slip"
            found.append(warning("segment/slip", LEFT, said, "leave these rows out of a fit", span=span))
        else:
            said += ": something pushes the robot"
            repair = "leave these rows out of a fit, or say the push"
            found.append(note("segment/push", LEFT, said, repair, span=span))
    return found
