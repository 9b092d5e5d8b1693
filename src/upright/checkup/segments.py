"""Parts of a log without free balancing: falls, standstill, slip and pushes."""

from __future__ import annotations

import math

import numpy as np

from upright.arrays import Mask
from upright.checkup.delays import CLEAR
from upright.checkup.finding import (
    FALLEN,
    FALLING,
    GYRO,
    HELD,
    LEANING,
    LEFT,
    LYING,
    MOVED,
    OFF,
    ON_WHEELS,
    OVER,
    PITCH,
    RISING,
    STANDING,
    Array,
    Finding,
    Fix,
    Record,
    Segment,
    during,
    moment,
    note,
    warning,
)
from upright.checkup.fixes import beside
from upright.checkup.physics import FAR, LEAST_ROWS, LOUD, Resampled, motion, resampled, smooth, widths
from upright.checkup.poses import at_rest, bodily, lean_of, other_zero
from upright.logs.outliers import runs

_MOST = 10  # reported events of one kind
_BEFORE = 0.1  # [s] before a fall begins, up to which the rows are used
_LINEAR = 0.4  # [rad] lean beyond which sin ψ differs from ψ by more than slips do
_IDLE = 0.01  # of the largest command, up to which a robot at rest gets none
_OFF = 0.35  # [rad] most that a robot leans as it balances, since its centre of mass is not above the axle
_LEAST = 20  # rows of a cut, below which a log is left whole


def fall(record: Record) -> list[Finding]:
    """Each fall: from where the body leaves its usual lean to the floor or the log's end."""
    return [_fell(record, segment) for segment in record.segments if segment.kind == FALLING][-_MOST:]


def zero(record: Record) -> list[Finding]:
    """A tilt estimate that reads another angle than 0 where the robot is upright."""
    m = bodily(record)
    if m is None or m.gyro is None or PITCH not in record or not np.isfinite(record[PITCH]).all():
        return []
    about = other_zero(record[PITCH], np.interp(record.t, m.t, at_rest(m)[0].astype(float)) > 0.5)
    if not about or abs(about) > math.tau:
        return []
    quarter = math.pi / 2 * round(about / (math.pi / 2))
    evidence = f"the robot swings about {about:.3g} rad of it, and nothing balances so: it counts from another zero"
    if abs(about - quarter) > _OFF:
        repair = "state its unit, and what it reads upright, in a mapping: --write-mapping MINE.toml"
        return [warning("estimate/zero", PITCH, f"{evidence}, or in degrees", repair)]
    fix = Fix("offset", (PITCH,), (-quarter,))
    return [Finding("estimate/zero", "warning", PITCH, evidence, f"subtract {quarter:.4g} rad", (fix,))]


def _fell(record: Record, segment: Segment) -> Finding:
    m = bodily(record)
    assert m is not None
    assert m.gyro is not None
    rate = smooth(m.gyro, m.period, widths(m.period)[0])[(m.t >= segment.start) & (m.t < segment.stop)]
    turn = abs(float(rate.sum())) * m.period
    fastest = float(np.abs(rate).max())
    how = "until the log ends" if segment is record.segments[-1] else "until the robot lies"
    evidence = (
        f"from t = {moment(segment.start)} s the pitch turns by {turn:.2g} rad at up to {fastest:.2g} rad/s, {how}"
    )
    before = segment.start - _BEFORE - record.t[0]
    usable = before >= _LEAST * m.period
    repair = f"use t < {moment(segment.start - _BEFORE)} s" if usable else "record the robot while it stands, too"
    return warning("segment/fall", m.gyro_name, evidence, repair, span=(segment.start, segment.stop))


_ASIDE = {
    LYING: "the robot lies", FALLEN: "the robot lies after its fall", OVER: "the robot is upside down",
    OFF: "both motors are off, and nothing balances", RISING: "the robot stands up",
    MOVED: "the robot is thrown, lifted or carried",
    HELD: "the gyro reads a body at rest while the wheels spin up: it is held, its wheels are off the floor, or this "
    "is no pitch rate",
}  # fmt: skip


def aside(record: Record) -> list[Finding]:
    """Parts in which the robot neither balances nor stands: no other check reads them."""
    findings: list[Finding] = []
    for segment in [segment for segment in record.segments if segment.kind in _ASIDE][:_MOST]:
        leaning = f" at {segment.lean:+.2f} rad" if segment.kind in LEANING else ""
        evidence = (
            f"{during(segment.start, segment.stop)} {_ASIDE[segment.kind]}{leaning}"
            ": signs, units, delays and offsets are not judged there"
        )
        code = f"segment/{segment.kind.replace(' ', '-')}"
        span = segment.start, segment.stop
        findings.append(
            note(code, GYRO if GYRO in record else PITCH, evidence, "leave it out when a model is fitted", span=span)
        )
    return findings + _kept(record)


def _kept(record: Record) -> list[Finding]:
    """The cut to the longest time on the wheels, where the log has anything else."""
    if all(segment.kind in ON_WHEELS for segment in record.segments):
        return []
    spans = on_wheels(record)
    if not spans:
        evidence = "the robot balances nowhere in this log: no sign, unit, delay or offset can be judged"
        return [warning("segment/none", "t", evidence, "log a robot that balances")]
    start, stop = max(spans, key=lambda span: span[1] - span[0])
    stop -= _BEFORE if any(s.kind == FALLING and s.start == stop for s in record.segments) else 0.0
    if stop - start < _LEAST * record.period:
        return []
    cut = Fix("cut", numbers=(start, stop))
    evidence = f"the longest time on the wheels is from {moment(start)} to {moment(stop)} s"
    return [Finding("segment/cut", "note", "t", evidence, f"use {moment(start)} ≤ t < {moment(stop)} s", (cut,))]


def short(record: Record) -> list[Finding]:
    """Too few rows on the wheels for any check that needs an equation of motion."""
    m = resampled(record)
    rows = int((m.good & record.on_wheels(m.t)).sum()) if m is not None else 0
    if not 0 < rows < LEAST_ROWS:
        return []
    evidence = f"{rows} rows on the wheels, not {LEAST_ROWS}: units, signs and delays are not judged"
    return [note("segment/short", "t", evidence, "log for longer")]


def on_wheels(record: Record) -> list[tuple[float, float]]:
    """The times [s] of balancing and standing, neighbours joined."""
    spans: list[tuple[float, float]] = []
    for segment in record.segments:
        if segment.kind in ON_WHEELS:
            joined = spans and spans[-1][1] == segment.start
            start = spans.pop()[0] if joined else segment.start
            spans.append((start, segment.stop))
    return spans


def still(record: Record) -> list[Finding]:
    """Times in which neither wheel turns and the gyro reads only noise: held, or stuck by friction."""
    m = motion(record)
    standing = [segment for segment in record.segments if segment.kind == STANDING]
    if m is None or m.gyro is None:
        return []
    findings: list[Finding] = []
    mean = np.abs(m.commands[0] + m.commands[1]) / 2 if m.commands is not None else np.zeros(len(m.t))
    unit = record.units.get(record.commands[0], "") if record.commands else ""
    for part in standing[:_MOST]:
        there = (m.t >= part.start) & (m.t < part.stop)
        driven = float(mean[there].mean())
        evidence = f"wheels at rest {during(part.start, part.stop)}: gyro noise {m.gyro[there].std():.2g} rad/s, "
        evidence += f"mean command {driven:.2g} {unit}".rstrip() if driven > _IDLE * mean.max() else "no command"
        evidence += "; held by hand, or stuck by friction"
        repair = "leave these rows out when a model is fitted"
        findings.append(note("segment/still", m.gyro_name, evidence, repair, span=(part.start, part.stop)))
    return findings


def slips(record: Record) -> list[Finding]:
    """Wheel slip and pushes: short violations of the pendulum equation.

    A push adds momentum, so the residual of δ̈ has one sign; a slipping wheel spins up and is braked when it grips, so
    the residual has both signs and a mean near zero.
    """
    m = motion(record)
    if m is None or m.gyro is None:
        return []
    fit = m.law
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
    loud = np.abs(miss) > max(FAR * scatter, LOUD * usual)
    loud[:edge], loud[-edge:] = False, False
    nonlinear = ~m.good | (np.abs(lean_of(record, m).angle) > _LINEAR)
    loud &= ~beside(nonlinear, edge)
    return _events(m, miss, loud, scatter)


def _events(m: Resampled, miss: Array, loud: Mask, scatter: float) -> list[Finding]:
    join = max(1, round(0.25 / m.period))
    findings: list[Finding] = []
    for a, b in runs(beside(loud, join))[:_MOST]:
        part = miss[a:b]
        largest = float(np.abs(part).max())
        both = min(float(part.max()), float(-part.min())) / largest
        balance = abs(float(part.sum())) / float(np.abs(part).sum())
        span = float(m.t[a + join]), float(m.t[b - 1 - join])
        evidence = (
            f"{during(*span)}: up to {largest:.3g} rad/s² off the pendulum "
            f"equation ({largest / scatter:.0f} standard deviations), in "
        )
        if both > 0.35 and balance < 0.35:
            evidence = f"wheel slip {evidence}both directions"
            findings.append(
                warning("segment/slip", LEFT, evidence, "leave these rows out when a model is fitted", span=span)
            )
        else:
            evidence = f"a push {evidence}one direction"
            repair = "exclude these rows from a fit, or log the push"
            findings.append(note("segment/push", LEFT, evidence, repair, span=span))
    return findings
