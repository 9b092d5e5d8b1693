"""Faults of single channels: dead, full of holes, stale, saturated, biased, coarse, or led by the accelerometer."""

from __future__ import annotations

import numpy as np

from upright.doctor.finding import (
    BATTERY,
    FORWARD,
    GYRO,
    LEFT,
    PITCH,
    RIGHT,
    UP,
    Array,
    Finding,
    Fix,
    Record,
    error,
    note,
    warning,
)
from upright.doctor.fixes import grain_of, stale
from upright.doctor.physics import motion, smooth, widths

_QUIET = 0.012
"""Amplitude of the pitch [rad] below which an inertia hardly shows: gravity then gives less torque than Coulomb
friction in the robots whose friction is known (0.010 N m a motor against MgL of 0.4 to 0.8 N m)."""

_COARSE = 0.06  # [rad] a hundred steps a turn, coarser than any motor that balances

_SENSED = (LEFT, RIGHT, GYRO, "sensor/compass", FORWARD, UP, PITCH)


def dead(record: Record) -> list[Finding]:
    """Channels without a number, with holes, or that never change while others do."""
    commands = record.commands or ()
    moving = (LEFT, RIGHT, GYRO, *commands)
    found: list[Finding] = []
    for name in (name for name in (*_SENSED, *commands) if name in record):
        values, fine = record[name], np.isfinite(record[name])
        if not fine.any():
            found.append(error("channel/empty", name, "it holds no number at all", "drop the channel"))
        elif not fine.all():
            said = f"{int((~fine).sum())} of {len(fine)} readings are missing, the first at row {int(np.argmin(fine))}"
            fix = Fix("fill", (name,))
            found.append(warning("channel/holes", name, said, "bridge them by straight lines", fix))
        elif np.ptp(values) == 0 and name in moving:
            said = f"it is {values[0]:.4g} in all {len(fine)} rows"
            found.append(error("channel/constant", name, said, "look for the cable, or the wrong column"))
    return found


def repeated(record: Record) -> list[Finding]:
    """Readings that repeat the one before more often than a moving channel does by chance.

    Among rows whose neighbours lie six grains apart or more, a step of 0 is by chance as frequent as steps of one or
    two grains; what there is more of is stale. Friction makes a slow robot jerk, hence the factor of two and a half.
    """
    found: list[Finding] = []
    for name in (name for name in _SENSED if name in record and name != "sensor/compass"):
        equal, chance, moving = _equal_steps(record[name])
        if equal < 3 + 2.5 * chance + 4 * np.sqrt(chance) or equal < 0.01 * moving:
            continue
        first = float(record.t[int(np.argmax(stale(record[name])))])
        said = f"{equal} of {moving} readings repeat the one before while the channel moves ({equal / moving:.1%}; "
        said += f"{chance:.0f} would do so by chance), the first near {first:.4g} s"
        fix = Fix("bridge", (name,))
        found.append(warning("samples/repeated", name, said, "bridge them by straight lines", fix))
    return found


def _equal_steps(x: Array) -> tuple[int, float, int]:
    """Steps of exactly 0 among moving rows, how many chance would give, and how many moving rows there are."""
    grain = grain_of(x)
    if grain <= 0 or len(x) < 50:
        return 0, 0.0, 0
    inside = np.abs(x[1:-2]) < np.abs(x).max() * (
        1 - 1e-9
    )  # at the end of its range a reading repeats for another reason
    moving = (np.abs(x[3:] - x[:-3]) >= 6 * grain) & inside
    steps = np.abs(np.diff(x)[1:-1][moving]) / grain
    near = int(((steps > 0.5) & (steps < 2.5)).sum())
    return int((steps == 0).sum()), near / 4, int(moving.sum())


_LEVELS = 10.0  # steps of a gyro below which its largest reading is only a common one


def saturation(record: Record) -> list[Finding]:
    """Commands and gyro that pile up at their largest value."""
    found: list[Finding] = []
    groups: list[tuple[str, ...]] = [names for names in (record.commands, (GYRO,)) if names and names[0] in record]
    for names in groups:
        seen = [np.concatenate([of(record, name) for name in names]) for of in (Record.__getitem__, _of_battery)]
        share, longest = max(_piled(values) for values in seen)
        few = names[0] == GYRO and np.nanmax(np.abs(record[GYRO])) < _LEVELS * grain_of(record[GYRO])
        if share > 0 and not few:
            limit = "gyro's range" if names[0] == GYRO else "largest command"
            top = f"{float(np.abs(record[names[0]]).max()):.4g} {record.units.get(names[0], '')}".rstrip()
            said = f"{share:.1%} of the rows stand at the {limit}, {top}, up to {longest} in a row"
            repair = "a linear fit must leave these rows out, or know the limit"
            found.append(warning("saturation", names[0], said, repair))
    return found


def _of_battery(record: Record, name: str) -> Array:
    """A voltage as a share of the battery where that is known, since that is what has a limit."""
    if name == GYRO or BATTERY not in record or record.torque_driven or not (record[BATTERY] > 1).all():
        return record[name]
    return record[name] / record[BATTERY]


def _piled(values: Array) -> tuple[float, int]:
    """Share of values at the extreme, and the longest run there; 0 where the extreme is only a peak."""
    size = np.abs(values[np.isfinite(values)])
    top = float(size.max()) if len(size) else 0.0
    if top == 0:
        return 0.0, 0
    at, near = size >= top * 0.995, (size >= top * 0.9) & (size < top * 0.995)
    share = float(at.mean())
    edges = np.flatnonzero(np.diff(np.concatenate([[0], at.astype(int), [0]])))
    longest = int((edges[1::2] - edges[::2]).max()) if len(edges) else 0
    piled = at.sum() >= max(5, 2 * near.sum() * 0.05) and at.sum() > 0.5 * near.sum() and longest >= 3
    return (share, longest) if piled and share > 0.003 else (0.0, 0)


def bias(record: Record) -> list[Finding]:
    """A gyro whose mean is more than any net lean explains."""
    if GYRO not in record or len(record.t) < 50:
        return []
    gyro, span = record[GYRO], float(record.t[-1] - record.t[0])
    fine = np.isfinite(gyro)
    step = np.diff(record.t)
    known = step < 5 * record.period  # what happened in a gap nobody knows
    mean = float((np.where(fine, gyro, 0.0)[1:] * step)[known].sum() / step[known].sum())
    lean = min(0.6, 0.1 + 4 * float(_swing(record)))
    limit = max(0.02, lean / span)
    if abs(mean) <= limit:
        return []
    said = (
        f"its mean is {mean:+.3g} rad/s over {span:.3g} s, which would add up to {mean * span:+.3g} rad; a robot that "
    )
    said += f"balances at both ends leaves {limit:.2g} rad/s at most"
    return [warning("gyro/bias", GYRO, said, f"subtract {mean:.4g} rad/s", Fix("offset", (GYRO,), (-mean,)))]


def _swing(record: Record) -> float:
    """Half the usual swing of the pitch [rad], from the gyro without its slow part."""
    period = record.period
    rate = np.where(np.isfinite(record[GYRO]), record[GYRO], 0.0)
    angle = np.cumsum(rate - rate.mean()) * period
    return float((angle - smooth(angle, period, 0.5)).std())


def grain(record: Record) -> list[Finding]:
    """The step of the encoders, and whether it drowns the motion."""
    m = motion(record)
    found: list[Finding] = []
    for name, values in ((LEFT, m.left), (RIGHT, m.right)) if m is not None else ():
        step = grain_of(record[name])
        if m is None or step <= 0:
            continue
        rate = float(smooth(values, m.period, widths(m.period)[0], 1).std())
        noise = step / np.sqrt(6) / m.period
        said = (
            f"it counts in steps of {step:.4g} rad ({2 * np.pi / step:.0f} a turn); differences over one row scatter "
        )
        said += f"by {noise:.3g} rad/s, against {rate:.3g} rad/s of motion"
        if step > _COARSE:
            found.append(warning("encoder/grain", name, said, "fit the counts themselves, never their differences"))
        elif noise > 0.3 * rate and name == LEFT:
            found.append(note("encoder/grain", name, said, "do not difference it row by row"))
    return found


def quiet(record: Record) -> list[Finding]:
    """A robot that stands too still for its inertia to show."""
    m = motion(record)
    if m is None or m.gyro is None:
        return []
    swing = float(np.sqrt(2)) * _swing(record.changed({GYRO: np.interp(record.t, m.t, m.gyro)}))
    if not 0 < swing < _QUIET:
        return []
    said = f"the pitch swings by {swing:.2g} rad only (amplitude): grain and friction weigh as much as the dynamics"
    return [
        Finding("motion/quiet", "note", m.gyro_name, said, "excite the robot before an inertia is identified from it")
    ]


def contaminated(record: Record) -> list[Finding]:
    """A pitch estimate whose drift from the gyro follows what an accelerometer says.

    Where the log has an accelerometer, its own pitch is the suspect; else the acceleration of the wheels, which an
    accelerometer takes for a lean backwards.
    """
    m = motion(record)
    if (
        m is None
        or m.gyro is None
        or m.gyro_name != GYRO
        or PITCH not in record
        or not np.isfinite(record[PITCH]).all()
    ):
        return []
    even, width = np.interp(m.t, record.t, record[PITCH]), widths(m.period)[-1]
    rows = np.arange(int(4 * width / m.period), len(m.t) - int(4 * width / m.period))
    if len(rows) < 50:
        return []
    rate, slope = (smooth(m.gyro, m.period, width, order) for order in (0, 1))
    angle, drift = smooth(even, m.period, width), smooth(even, m.period, width, 1) - rate
    pull = smooth(_suspect(record, m.t), m.period, width) - angle if FORWARD in record and UP in record else None
    wheel = -smooth(m.wheel, m.period, width, 2) - slope
    nuisance = [slope, rate, np.ones(len(m.t))] + ([angle] if pull is None else [])
    Q = np.linalg.qr(np.column_stack(nuisance)[rows])[0]
    source = wheel if pull is None else pull
    own, push = (x[rows] - Q @ (Q.T @ x[rows]) for x in (drift, source))
    power = float(push @ push)
    gain = float(own @ push) / power if power > 0 else 0.0
    share = gain**2 * power / float(own @ own) if own.any() else 0.0
    error = np.cumsum(gain * (source[rows] - source[rows].mean())) * m.period
    largest = float(np.abs(error - smooth(error, m.period, 0.5)).max())
    if share < 0.2 or gain <= 0 or largest < 0.02:
        return []
    which = "the acceleration of the wheels" if pull is None else "the accelerometer's pitch"
    said = f"its drift from the gyro follows {which} (partial R² {share:.2f}); "
    said += f"while accelerating it is off by up to {largest:.2g} rad"
    return [warning("estimate/accelerometer", PITCH, said, "fit gyro and encoders, not this estimate")]


def _suspect(record: Record, t: Array) -> Array:
    """The accelerometer's pitch [rad] at times `t`."""
    return np.interp(t, record.t, np.arctan2(-record[FORWARD], record[UP]))
