"""Faults of single channels: dead, incomplete, stale, saturated, biased, coarse, or driven by the accelerometer."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from upright.arrays import Mask
from upright.checkup.finding import (
    BATTERY,
    FORWARD,
    GYRO,
    INTERPOLATE,
    LEAVE_OUT,
    LEFT,
    PITCH,
    RIGHT,
    UP,
    Array,
    Finding,
    Fix,
    Record,
    error,
    instant,
    note,
    plain,
    warning,
)
from upright.checkup.fixes import COARSE, levels, stale, switched
from upright.checkup.physics import motion, smooth, widths
from upright.logs.outliers import LEVELS, at_range, grain_of, runs, single
from upright.pages import Quantity, Say

COARSE_ENCODER = 0.06  # [rad] a hundred steps a turn, coarser than any motor that balances

REPEATED = 0.01  # [1] of the rows in which a channel moves


_SENSED = (LEFT, RIGHT, GYRO, "sensor/compass", FORWARD, UP, PITCH)


def idle(record: Record) -> bool:
    """Whether the motors are off in every row: no command is any, and both wheels are logged and stand still."""
    logged = [*(record.commands or ()), LEFT, RIGHT]
    rest = [name in record and bool(np.isfinite(record[name]).all()) and np.ptp(record[name]) == 0 for name in logged]
    return record.commands is not None and all(rest) and not any(record[name].any() for name in record.commands)


def dead(record: Record) -> list[Finding]:
    """Channels without a number, with holes, or that never change while others do."""
    commands = record.commands or ()
    moving = (LEFT, RIGHT, GYRO, *commands)
    findings: list[Finding] = []
    for name in (name for name in (*_SENSED, *commands) if name in record):
        values = record[name]
        fine = np.isfinite(record[name])
        if not fine.any():
            findings.append(error("channel/empty", name, Say("All readings are missing."), Say("Drop the channel.")))
        elif not fine.all():
            evidence = Say(
                "{n} of {rows} readings are missing, the first in row {row}.",
                n=int((~fine).sum()),
                rows=len(fine),
                row=int(np.argmin(fine)),
            )
            findings.append(warning("channel/holes", name, evidence, INTERPOLATE, Fix("fill", (name,))))
        elif np.ptp(values) == 0 and name in moving:
            evidence = Say("It is {value} in each of {n} rows.", value=plain(float(values[0]), 4), n=len(fine))
            repair = Say("Check cable and mapped column, and whether a controller runs.")
            findings.append(error("channel/constant", name, evidence, repair))
    return findings


def unsigned(record: Record) -> list[Finding]:
    """Commands of a balancing robot that are never negative: their direction is missing."""
    m = motion(record)
    if m is None or m.commands is None or record.commands is None:
        return []
    findings: list[Finding] = []
    rate = smooth(m.wheel, m.period, widths(m.period)[-1], 1)[m.good]
    if min(float(rate.max()), -float(rate.min())) < _BOTH_WAYS * float(np.abs(rate).max()):
        return []  # who drives on may need volts of one sign alone
    for name, values in zip(record.commands, m.commands, strict=True):
        on = values[m.good]
        if on.min() >= 0 and (on > 0).mean() > _DRIVEN:
            evidence = Say("It is never negative, {most} at most: nothing balances so.", most=plain(float(on.max())))
            repair = Say("Name the column of its direction in a mapping: direction = …")
            findings.append(error("command/unsigned", name, evidence, repair))
    return findings


_BOTH_WAYS = 0.3  # [1] of the largest rate of the wheels
_DRIVEN = 0.3  # [1] of the rows in which a motor works, from which it must work both ways


_JUMP, _JUMPS = 8.0, 3  # times the largest usual step of a wheel; more jumps are a way of the sensor


def joined(record: Record) -> list[Finding]:
    """Both encoders jump in the same row: counters that were set to zero, or another recording."""
    if LEFT not in record or RIGHT not in record or len(record.t) < 50:
        return []
    steps = np.abs(np.diff(np.column_stack([record[LEFT], record[RIGHT]]), axis=0))
    if not np.isfinite(steps).all():
        return []
    grains = [max(grain_of(record[name]), COARSE_ENCODER / _JUMP) for name in (LEFT, RIGHT)]
    usual = np.maximum(np.quantile(steps, 0.995, axis=0), grains)
    rows = np.flatnonzero((steps > _JUMP * usual).all(axis=1) & (np.diff(record.t) < 5 * record.period)) + 1
    if not 0 < len(rows) <= _JUMPS:
        return []
    edges = [0, *rows.tolist(), len(record.t)]
    first, last = max(pairwise(edges), key=lambda part: part[1] - part[0])
    evidence = Say(
        "Both jump at {time}, the left one by {angle}: set to zero, or two recordings.",
        time=instant(float(record.t[rows[0]])),
        angle=Quantity(float(steps[rows[0] - 1, 0]), "rad"),
    )
    repair = Say("Keep the longest part, rows {first} to {last}.", first=first, last=last - 1)
    return [error("encoder/jump", LEFT, evidence, repair, Fix("rows", numbers=(float(first), float(last))))]


_ALIKE, _UNEQUAL = 0.98, 1.25  # correlation of both wheels' rates, and by how much more one may turn


def unequal(record: Record) -> list[Finding]:
    """One encoder that turns by a factor more than the other, at all times: another scale, or another wheel."""
    m = motion(record)
    if m is None or np.array_equal(m.left, m.right):
        return []
    left, right = (smooth(x, m.period, widths(m.period)[-1], 1)[m.good] for x in (m.left, m.right))
    if not left.std() or not right.std() or float(np.corrcoef(left, right)[0, 1]) < _ALIKE:
        return []
    ratio = float(right.std() / left.std())
    if 1 / _UNEQUAL < ratio < _UNEQUAL:
        return []
    evidence = Say("The right wheel turns {ratio} times as much as the left one, at all times.", ratio=plain(ratio))
    return [warning("encoder/unequal", RIGHT, evidence, Say("Compare unit, counts and wheels of both sides."))]


def repeated(record: Record) -> list[Finding]:
    """Readings that repeat the previous one more often than a moving channel does by chance.

    Among rows whose neighbours differ by six quantisation steps or more, a change of 0 is by chance as frequent as one
    of one or two steps; the excess is stale. Stick-slip adds some, hence the factor 2.5.
    """
    findings: list[Finding] = []
    for name in (name for name in _SENSED if name in record and name != "sensor/compass"):
        equal, chance, moving = _equal_steps(record[name])
        if equal < 3 + 2.5 * chance + 4 * np.sqrt(chance) or equal < REPEATED * moving:
            continue
        first = float(record.t[int(np.argmax(stale(record[name])))])
        evidence = Say(
            "While it moves, {n} of {rows} readings repeat the one before; by chance {chance} would.",
            n=equal,
            rows=moving,
            chance=round(chance),
            first=instant(first),
        )
        fix = Fix("bridge", (name,))
        findings.append(warning("samples/repeated", name, evidence, INTERPOLATE, fix))
    return findings


def outliers(record: Record) -> list[Finding]:
    """Single readings far from those before and after, where no robot is so fast: a bad cable or a lost message."""
    findings: list[Finding] = []
    for name in (name for name in (LEFT, RIGHT, GYRO) if name in record):
        alone = single(record.t, record[name])
        if alone.any():
            row = int(np.argmax(alone))
            evidence = Say(
                "{n} of {rows} readings stand far from those before and after; the first, {value}, at {time}.",
                n=int(alone.sum()),
                rows=len(alone),
                time=instant(float(record.t[row])),
                value=Quantity(float(record[name][row]), record.units.get(name, "")),
            )
            repair = Say("Interpolate them, and check the cable.")
            findings.append(warning("channel/outliers", name, evidence, repair, Fix("single", (name,))))
    return findings


STUCK = 0.5
"""How long [s] a sensor of a robot that moves may hold one reading: a balancing robot turns round twice as often."""
_APART = 0.1  # [s] between three readings whose second difference is what a sensor moves
_ACTIVE = 4.0  # [quantisation steps] of that difference (standard deviation) from which a sensor moves
_AS_BEFORE = 0.3  # of what it moves elsewhere


def stuck(record: Record) -> list[Finding]:
    """A gyro or an encoder that holds one reading while the others move on.

    On the wheels each moves with the others; off them no robot turns for long at one rate other than 0.
    """
    present = [name for name in (LEFT, RIGHT, GYRO) if name in record]
    step = max(1, round(_APART / record.period))
    if len(record.t) <= 2 * step:
        return []
    moved = {n: record[n][2 * step :] - 2 * record[n][step:-step] + record[n][: -2 * step] for n in present}
    grains = {name: grain_of(record[name]) for name in present}

    def moves(name: str, rows: Mask) -> float:
        return float(moved[name][rows].std()) / max(grains[name], 1e-300)

    findings: list[Finding] = []
    for name in present:
        x = record[name]
        others = [other for other in present if other != name]
        first, last = max(runs(np.diff(x) == 0), key=lambda run: run[1] - run[0], default=(0, 0))
        inside = np.zeros(len(record.t) - 2 * step, dtype=bool)
        inside[first : max(first, last - 2 * step)] = True
        if record.t[last] - record.t[first] < STUCK or not others or not inside.any() or inside.all():
            continue
        there = record.on_wheels(record.t[first : last + 1]).all()
        if name == GYRO:
            there |= abs(x[first] - float(np.median(np.delete(x, slice(first, last))))) > _ACTIVE * grains[name]
        at_limit = abs(x[first]) > 0.995 * float(np.abs(x).max())
        if not there or at_limit or moves(name, ~inside) < _ACTIVE:
            continue
        if all(moves(other, inside) > max(_ACTIVE, _AS_BEFORE * moves(other, ~inside)) for other in others):
            evidence = Say(
                "It reads {value} from {start} to {stop}, while the other sensors move on.",
                value=plain(float(x[first])),
                start=instant(float(record.t[first])),
                stop=instant(float(record.t[last])),
            )
            repair = Say("Check the sensor and its cable, and leave these rows out.")
            findings.append(error("channel/stuck", name, evidence, repair))
    return findings


def _equal_steps(x: Array) -> tuple[int, float, int]:
    """Number of unchanged readings among moving rows, the number expected by chance, and the number of moving rows."""
    grain = grain_of(x)
    if grain <= 0 or len(x) < 50:
        return 0, 0.0, 0
    inside = np.abs(x[1:-2]) < np.abs(x).max() * (1 - 1e-9)  # a reading at the end of its range repeats by saturation
    moving = (np.abs(x[3:] - x[:-3]) >= 6 * grain) & inside
    steps = np.abs(np.diff(x)[1:-1][moving]) / grain
    near = int(((steps > 0.5) & (steps < 2.5)).sum())
    return int((steps == 0).sum()), near / 4, int(moving.sum())


def saturation(record: Record) -> list[Finding]:
    """Commands and gyro that stay at their largest value."""
    findings: list[Finding] = []
    groups: list[tuple[str, ...]] = [names for names in (record.commands, (GYRO,)) if names and names[0] in record]
    for names in groups:
        fraction, most = at_limit(record, names)
        if fraction > 0 and (names[0] == GYRO or not all(switched(record[name]) for name in names)):
            top = float(np.abs(record[names[0]]).max())
            a, b = record.t[limited(record, names).any(axis=0)][[0, -1]].tolist()
            evidence = Say(
                "{part} of the rows stand at the largest value, {top}; up to {most} in succession.",
                most=most,
                part=Quantity(fraction, "fraction"),
                top=Quantity(top, record.units.get(names[0], "")),
            )
            repair = Say("`upright calibrate` leaves these readings out.") if names[0] == GYRO else LEAVE_OUT
            findings.append(warning("saturation", names[0], evidence, repair, span=(a, b)))
    return findings


def at_limit(record: Record, names: Sequence[str]) -> tuple[float, int]:
    """Fraction of the values of these channels that are at their largest, alone or over the battery, and the longest
    run there; 0 where the largest is a single peak."""
    at = limited(record, names).ravel()
    return float(at.mean()), max((last - first for first, last in runs(at)), default=0)


def limited(record: Record, names: Sequence[str]) -> Mask:
    """Which values of these channels (channels, n) are at their largest, alone or over the battery."""
    groups = [np.concatenate([of(record, name) for name in names]) for of in (Record.__getitem__, _of_battery)]
    levels = LEVELS if names[0] == GYRO else 0.0
    at = max((at_range(values, levels) for values in groups), key=lambda mask: int(mask.sum()))
    return at.reshape(len(names), -1)


def _of_battery(record: Record, name: str) -> Array:
    """A command relative to the battery voltage where it is logged, since the duty has a limit."""
    if name == GYRO or BATTERY not in record or record.torque_driven or not (record[BATTERY] > 1).all():
        return record[name]
    return record[name] / record[BATTERY]


def grain(record: Record) -> list[Finding]:
    """The resolution of the encoders, compared with the motion; a rate that was summed shows none."""
    m = motion(record)
    findings: list[Finding] = []
    for name, values in ((LEFT, m.left), (RIGHT, m.right)) if m is not None else ():
        step = grain_of(record[name])
        if m is None or step <= 0 or name in record.summed:
            continue
        rate = float(smooth(values, m.period, widths(m.period)[0], 1).std())
        noise = float(step / np.sqrt(6) / m.period)
        if step > COARSE_ENCODER:
            evidence = Say(
                "One count is {step}; an encoder that balances a robot resolves {limit}.",
                step=Quantity(step, "rad"),
                limit=Quantity(COARSE_ENCODER, "rad"),
            )
            repair = Say("Fit the angles, not their differences.")
            findings.append(warning("encoder/grain", name, evidence, repair))
        elif noise > 0.3 * rate and name == LEFT:
            evidence = Say(
                "Their counts make a speed from two rows uncertain by {noise}; the wheels turn at {rate}.",
                noise=Quantity(noise, "rad/s"),
                rate=Quantity(rate, "rad/s"),
            )
            findings.append(
                note("encoder/grain", name, evidence, Say("Compute speeds from readings several rows apart."))
            )
    return findings


_SHAKEN = 0.02  # [rad] least error of an estimate that is shaken


def contaminated(record: Record) -> list[Finding]:
    """A pitch estimate whose difference from the gyro follows the accelerometer.

    Where the log has an accelerometer, its pitch is the regressor; else the acceleration of the wheels, which an
    accelerometer reads as a lean backwards.
    """
    m = motion(record)
    if m is None or m.gyro is None or m.gyro_name != GYRO:
        return []
    if PITCH not in record or not np.isfinite(record[PITCH]).all() or levels(record[PITCH]) <= COARSE:
        return []
    even = np.interp(m.t, record.t, record[PITCH])
    width = widths(m.period)[-1]
    rows = np.arange(int(4 * width / m.period), len(m.t) - int(4 * width / m.period))
    rows = rows[m.good[rows]]
    if len(rows) < 50:
        return []
    rate, slope = (smooth(m.gyro, m.period, width, order) for order in (0, 1))
    angle = smooth(even, m.period, width)
    drift = smooth(even, m.period, width, 1) - rate
    pull = smooth(_suspect(record, m.t), m.period, width) - angle if FORWARD in record and UP in record else None
    wheel = -smooth(m.wheel, m.period, width, 2) - slope
    nuisance = [slope, rate, np.ones(len(m.t))] + ([angle] if pull is None else [])
    Q = np.linalg.qr(np.column_stack(nuisance)[rows])[0]
    source = wheel if pull is None else pull
    own, push = (x[rows] - Q @ (Q.T @ x[rows]) for x in (drift, source))
    power = float(push @ push)
    gain = float(own @ push) / power if power > 0 else 0.0
    fraction = gain**2 * power / float(own @ own) if own.any() else 0.0
    error = np.cumsum(gain * (source[rows] - source[rows].mean())) * m.period
    largest = float(np.abs(error - smooth(error, m.period, 0.5)).max())
    if fraction < 0.2 or gain <= 0 or largest < _SHAKEN:
        return []
    evidence = Say(
        "While the robot accelerates it is wrong by up to {error}; a sound one by less than {limit}.",
        error=Quantity(largest, "rad"),
        limit=Quantity(_SHAKEN, "rad"),
        r2=plain(fraction),
    )
    repair = Say("Fit gyro and encoders, not this estimate.")
    return [warning("estimate/accelerometer", PITCH, evidence, repair)]


def _suspect(record: Record, t: Array) -> Array:
    """The accelerometer's pitch [rad] at times `t`."""
    return np.interp(t, record.t, np.arctan2(-record[FORWARD], record[UP]))
