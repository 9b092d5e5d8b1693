"""Parts of a log without free balancing: falls, standstill, slip and pushes."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.doctor.delays import CLEAR
from upright.doctor.finding import LEFT, PITCH, Array, Finding, Fix, Record, note, warning
from upright.doctor.fixes import runs
from upright.doctor.physics import Resampled, motion, pendulum, smooth, widths

_STILL = 0.4  # [s] shortest standstill that is reported, longer than the turning points of balancing
_MOST = 10  # reported events of one kind
_TIPPED = 0.5  # [rad] one-sided turn of the pitch beyond which a robot that does not return has fallen


def lean(record: Record, m: Resampled) -> Array:
    """Pitch [rad] from the gyro, or the logged estimate without one; valid for differences over seconds."""
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
    """Whether the robot is at rest after the impact, compared with the fall."""
    rest = rate[round(0.5 / period) :]
    return len(rest) * period > 0.2 and float(np.sqrt(np.mean(rest**2))) < 0.03 * peak


def _fell(m: Resampled, first: int, turn: float, fastest: float, ends: bool) -> Finding:
    start = float(m.t[first])
    how = "where the log ends" if ends else "and then the robot lies still"
    evidence = f"from t = {start:.3g} s the pitch turns by {turn:.2g} rad at up to {fastest:.2g} rad/s, {how}"
    cut = Fix("cut", numbers=(float(m.t[0]) - 1.0, start - 0.1))
    span = start, float(m.t[-1])
    return warning("segment/fall", m.gyro_name, evidence, f"use t < {start - 0.1:.3g} s", cut, span=span)


def _pitch_rate(record: Record, m: Resampled) -> Array:
    return m.gyro if m.gyro is not None else np.gradient(lean(record, m), m.period)


def still(record: Record) -> list[Finding]:
    """Intervals in which neither wheel turns and the gyro reads only noise: held, lying, or stuck by friction."""
    m = motion(record)
    if m is None:
        return []
    rate, count = _pitch_rate(record, m), max(3, round(0.1 / m.period))
    left, right = (np.abs(smooth(wheel, m.period, 2 * m.period, 1)) for wheel in (m.left, m.right))
    moved, swings = np.convolve(left + right, np.ones(count) / count, mode="same"), np.abs(smooth(rate, m.period, 0.05))
    level = max(0.02 * float(np.percentile(left + right, 95)), 1e-6)
    calm = (moved < level) & (swings < max(3 * _noise(rate), 0.03 * float(np.percentile(swings, 95))))
    intervals = [(a, b) for a, b in runs(calm) if (b - a) * m.period >= _STILL]
    if sum(b - a for a, b in intervals) > 0.98 * len(calm):
        return []
    return [_standing(record, m, a, b, rate) for a, b in intervals[:_MOST]]


def _standing(record: Record, m: Resampled, a: int, b: int, rate: Array) -> Finding:
    start, end = float(m.t[a]), float(m.t[b - 1])
    driven = float(np.abs((m.commands[0] + m.commands[1])[a:b] / 2).mean()) if m.commands is not None else 0.0
    unit = record.units.get(record.commands[0], "") if record.commands else ""
    evidence = (
        f"from {start:.3g} to {end:.3g} s (rows {a} to {b - 1}) the wheels stand still and the gyro reads noise of "
    )
    evidence += (
        f"{rate[a:b].std():.2g} rad/s, with a mean command of {driven:.2g} {unit}: held by hand, lying, or stuck "
    )
    evidence += "by friction"
    return note("segment/still", m.gyro_name, evidence, "exclude these rows from a fit", span=(start, end))


def _noise(rate: Array) -> float:
    """Standard deviation of white noise, from second differences, to which motion contributes little."""
    return float(np.median(np.abs(np.diff(rate, 2))) / 0.6745 / np.sqrt(6)) if len(rate) > 3 else 0.0


def slips(record: Record) -> list[Finding]:
    """Wheel slip and pushes: short violations of the pendulum equation.

    A push adds momentum, so the residual of δ̈ has one sign; a slipping wheel spins up and is braked when it grips, so
    the residual has both signs and a mean near zero.
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


def _events(m: Resampled, miss: Array, loud: NDArray[np.bool_], scatter: float) -> list[Finding]:
    join = max(1, round(0.25 / m.period))
    near = np.convolve(loud, np.ones(2 * join + 1), mode="same") > 0.5
    findings: list[Finding] = []
    for a, b in runs(near)[:_MOST]:
        part = miss[a:b]
        largest = float(np.abs(part).max())
        both = min(float(part.max()), float(-part.min())) / largest
        balance = abs(float(part.sum())) / float(np.abs(part).sum())
        span = float(m.t[a + join]), float(m.t[b - 1 - join])
        evidence = f"from {span[0]:.3g} to {span[1]:.3g} s the wheels deviate from the pendulum equation by up to "
        evidence += f"{largest:.3g} rad/s², {largest / scatter:.0f} standard deviations"
        if both > 0.35 and balance < 0.35:
            evidence += ", in both directions: the wheels slip"
            findings.append(warning("segment/slip", LEFT, evidence, "exclude these rows from a fit", span=span))
        else:
            evidence += ", in one direction: a push"
            repair = "exclude these rows from a fit, or log the push"
            findings.append(note("segment/push", LEFT, evidence, repair, span=span))
    return findings
