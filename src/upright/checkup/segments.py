"""Parts of a log without free balancing: falls, standstill, slip and pushes."""

from __future__ import annotations

import math

import numpy as np

from upright.arrays import Mask
from upright.checkup.body import bodily
from upright.checkup.delays import CLEAR
from upright.checkup.finding import (
    FALLEN,
    FALLING,
    GYRO,
    HELD,
    LEANING,
    LEAVE_OUT,
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
    instant,
    note,
    plain,
    warning,
)
from upright.checkup.fixes import beside
from upright.checkup.physics import FAR, LEAST_ROWS, LOUD, Resampled, motion, resampled, smooth, widths
from upright.checkup.poses import at_rest, lean_of, other_zero
from upright.logs.outliers import runs
from upright.pages import Quantity, Say

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
    evidence = Say("The robot swings about {angle} of it, not about 0°.", angle=Quantity(about, "rad"))
    if abs(about - quarter) > _OFF:
        repair = Say("State its unit, and what it reads upright, in a mapping: `--write-mapping MINE.toml`.")
        return [warning("estimate/zero", PITCH, evidence, repair)]
    repair = Say("Subtract {angle}.", angle=Quantity(quarter, "rad"))
    return [warning("estimate/zero", PITCH, evidence, repair, Fix("offset", (PITCH,), (-quarter,)))]


def _fell(record: Record, segment: Segment) -> Finding:
    m = bodily(record)
    assert m is not None
    assert m.gyro is not None
    rate = smooth(m.gyro, m.period, widths(m.period)[0])[(m.t >= segment.start) & (m.t < segment.stop)]
    turn = abs(float(rate.sum())) * m.period
    fastest = float(np.abs(rate).max())
    evidence = Say(
        "From {start} on the pitch turns by {turn}, at up to {rate}.",
        start=instant(segment.start),
        turn=Quantity(turn, "rad"),
        rate=Quantity(fastest, "rad/s"),
    )
    repair = Say("Log the robot while it stands, too.")
    if segment.start - _BEFORE - record.t[0] >= _LEAST * m.period:
        repair = Say("Use the rows before {time}.", time=instant(segment.start - _BEFORE))
    return warning("segment/fall", m.gyro_name, evidence, repair, span=(segment.start, segment.stop))


_ASIDE = (LYING, FALLEN, OVER, OFF, RISING, MOVED, HELD)


def aside(record: Record) -> list[Finding]:
    """Parts in which the robot neither balances nor stands: no other check reads them."""
    findings: list[Finding] = []
    for segment in [segment for segment in record.segments if segment.kind in _ASIDE][:_MOST]:
        span = segment.start, segment.stop
        when = {"start": instant(segment.start), "stop": instant(segment.stop)}
        evidence = Say("From {start} to {stop}: no other check reads this part.", **when)
        if segment.kind in LEANING:
            lean = Quantity(segment.lean, "rad")
            evidence = Say("From {start} to {stop} at {lean}: no other check reads this part.", **when, lean=lean)
        if segment.kind == HELD:
            evidence = Say(
                "From {start} to {stop} the gyro rests while the wheels spin: held, or its wheels are off the floor.",
                **when,
            )
        code = f"segment/{segment.kind.replace(' ', '-')}"
        findings.append(note(code, GYRO if GYRO in record else PITCH, evidence, LEAVE_OUT, span=span))
    return findings + _kept(record)


def _kept(record: Record) -> list[Finding]:
    """The cut to the longest time on the wheels, where the log has anything else."""
    if all(segment.kind in ON_WHEELS for segment in record.segments):
        return []
    spans = on_wheels(record)
    if not spans:
        evidence = Say("The robot balances nowhere: no sign, unit, delay or offset can be judged.")
        return [warning("segment/none", "t", evidence, Say("Log a robot that balances."))]
    start, stop = max(spans, key=lambda span: span[1] - span[0])
    stop -= _BEFORE if any(s.kind == FALLING and s.start == stop for s in record.segments) else 0.0
    if stop - start < _LEAST * record.period:
        return []
    cut = Fix("cut", numbers=(start, stop))
    evidence = Say("On its wheels longest from {start} to {stop}.", start=instant(start), stop=instant(stop))
    return [Finding("segment/cut", "note", "t", evidence, Say("Use these rows only."), (cut,))]


def short(record: Record) -> list[Finding]:
    """Too few rows on the wheels for any check that needs an equation of motion."""
    m = resampled(record)
    rows = int((m.good & record.on_wheels(m.t)).sum()) if m is not None else 0
    if not 0 < rows < LEAST_ROWS:
        return []
    evidence = Say("Rows on the wheels: {n}; units, signs and delays need {least}.", n=rows, least=LEAST_ROWS)
    return [note("segment/short", "t", evidence, Say("Log for longer."))]


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
        span = part.start, part.stop
        noise = Quantity(float(m.gyro[there].std()), "rad/s")
        when = {"start": instant(part.start), "stop": instant(part.stop), "noise": noise}
        evidence = Say("From {start} to {stop} neither wheels nor body move, and no command drives them.", **when)
        if driven > _IDLE * mean.max():
            command = Quantity(driven, unit)
            evidence = Say(
                "From {start} to {stop} the wheels rest under {command}: held, or stuck by friction.",
                **when,
                command=command,
            )
        findings.append(note("segment/still", m.gyro_name, evidence, LEAVE_OUT, span=span))
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
        evidence = Say(
            "From {start} on the wheels leave the pendulum equation by {times} deviations (limit {limit}).",
            start=instant(span[0]),
            times=round(largest / scatter),
            limit=round(FAR),
            size=plain(largest),
        )
        if both > 0.35 and balance < 0.35:
            findings.append(warning("segment/slip", LEFT, evidence, LEAVE_OUT, span=span))
        else:
            repair = Say("Leave these rows out of a fit, or log the push.")
            findings.append(note("segment/push", LEFT, evidence, repair, span=span))
    return findings
