"""Poses: where a robot lies, stands up, balances, falls, or is upside down, from the integrated motion of its body.

The lean is the integrated gyro; an accelerometer at rest, or a pitch estimate that follows it, makes it absolute.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from upright.arrays import Mask
from upright.checkup.body import bent, bodily, commonest, noise_of
from upright.checkup.finding import (
    BALANCING,
    FALLEN,
    FALLING,
    FORWARD,
    GYRO,
    HELD,
    LYING,
    MOVED,
    OFF,
    OVER,
    PITCH,
    RISING,
    STANDING,
    UP,
    Array,
    Record,
    Segment,
)
from upright.checkup.physics import Resampled, smooth, widths
from upright.checkup.time import LONGEST
from upright.logs.outliers import grain_of, runs

TIPPED = 0.5
"""[rad] Lean in which nothing stays that balances, and further than which a fall has turned."""

_LONG = 1.0  # [s] in which a robot that nothing drives falls: what stays upright balances, what has no command is off
LONGEST_THROW = 2.0  # [s] in which a robot that is thrown is back on the floor
_CALMED = 0.05  # [s] of smoothing, over which a resting gyro's noise becomes small
_STILL = 0.4  # [s] shortest rest, longer than the turning points of balancing
_REST = 0.03  # of the pitch rate that one row in five exceeds, below which the body is at rest
_CALM = 0.3  # of that rate, which no rest exceeds where the gyro's noise is well below it
_FLOOR = 1.45  # [rad] lean in which a body touches the floor, where no pose in the log shows it
NEAR_FLOOR = 0.93  # of the lean in which it lies, from which it touches the floor
_STOPS, _STRIKES, _STOPPED = 0.05, 0.5, 0.2  # [s] in which a floor stops a body, least of its fastest rate, most left
_OVER = 2.2  # [rad] lean beyond which a robot is upside down rather than on its side
_SHORTEST = 0.2  # [s] a time on the wheels before a fall that is shorter is part of the fall
_UP = 0.2  # [rad] lean in which a robot that stands up has arrived
_FURTHER = 1.3  # times the largest earlier lean, from which one at the end of a log is a fall
_NO_TILT, _SWUNG, _SWINGS = 1.0, 0.1, 4  # [rad, rad, 1] a mean lean of no robot, and a body that is off the floor there
_USUAL = 5.0  # [s] to both sides, over which the median lean counts as upright
_DRIFT = 0.03  # [rad/s] spread of a gyro's offset before anything is known
_FOLLOWS = 0.7  # R² from which a pitch estimate follows the gyro
_SAME_UNIT = 3.0  # ratio up to which a filter's gain, and no unit, is between them: units differ by 10 or more
_SWING = 0.1  # [rad] a usual swing of a robot that balances
FASTEST_WHEEL = 200.0  # [rad/s] the wheels of robots of 0.2 to 20 kg reach 10 to 40 rad/s, those of scooters 60
_SLOW_WHEEL, _SPUN = 10.0, 3.0  # [rad/s] least full speed of usual wheels, and a change of speed above any backlash
_LARGEST_Q, _LARGEST_P = 15.0, 500.0  # [1, 1/s²] of the pendulum equation, of any robot
LARGEST_OFFSET = 0.35  # [rad/s] 20 degrees per second, that of the chips that people use
_FASTEST, _WIDEST, _COARSEST = 10.0, 1.5, 0.5  # [rad/s, rad, rad/s] rms, swing and step of a gyro in degrees


@dataclass(frozen=True, eq=False)
class Lean:
    """Lean `angle` [rad] of the body, whether it is `absolute`, and the rows in which the body is at rest (`quiet`), or
    the wheels as well (`calm`)."""

    angle: Array
    absolute: bool
    quiet: Mask
    calm: Mask


def segments(record: Record, *, swung: bool = False) -> tuple[Segment, ...]:
    """The poses of a log in the order of time, without gaps between them, a fall with the swing in which it begins if
    `swung`; none for a log without gyro and tilt, or without tilt and encoders, or that is too slow to show a robot
    balancing."""
    m = bodily(record)
    if m is None or m.gyro is None or m.period > LONGEST:
        return ()
    lean = lean_of(record, m)
    parts = _merged(
        _labelled(m, lean, _spinning(record, m, lean.quiet), _off(record, m, lean.calm), swung=swung), m.period
    )
    return tuple(_segment(m, lean, kind, a, b) for kind, a, b in parts)


def _segment(m: Resampled, lean: Lean, kind: str, a: int, b: int) -> Segment:
    stop = float(m.t[b]) if b < len(m.t) else float(m.t[-1]) + m.period
    return Segment(kind, float(m.t[a]), stop, float(np.median(lean.angle[a:b])))


def at_rest(m: Resampled) -> tuple[Mask, Mask]:
    """The rows in which the body rests (the gyro reads noise), and those in which the wheels stand still as well."""
    from scipy.ndimage import uniform_filter1d

    assert m.gyro is not None
    count = max(3, round(0.1 / m.period))
    left, right = (np.abs(smooth(wheel, m.period, 2 * m.period, 1)) for wheel in (m.left, m.right))
    moved = uniform_filter1d(left + right, count, mode="constant")
    calmed = smooth(m.gyro, m.period, _CALMED)
    swings = np.minimum(np.abs(calmed), np.abs(calmed - commonest(calmed)))  # at rest it reads zero, or its offset
    level = max(0.02 * float(np.percentile(left + right, 95)), 1e-6)
    left_over = noise_of(m.gyro) * min(1.0, np.sqrt(m.period / (2 * np.sqrt(np.pi) * _CALMED)))
    usual = float(np.percentile(swings, 80))
    most = _CALM * usual if usual > 3 * left_over else np.inf  # what shakes at half the sampling rate is no noise
    quiet = swings < min(max(4 * left_over, _REST * usual), most)
    return _lasting(quiet, m.period), _lasting(quiet & (moved < level) & m.wheels, m.period)


def _lasting(mask: Mask, period: float, least: float = _STILL) -> Mask:
    lasting = np.zeros(len(mask), dtype=bool)
    for a, b in runs(mask):
        lasting[a:b] = (b - a) * period >= least
    return lasting


def lean_of(record: Record, m: Resampled) -> Lean:
    """The lean by the best reference that the log has."""
    assert m.gyro is not None
    quiet, calm = at_rest(m)
    gyro = m.gyro / _divisor(m)
    swing = _summed(gyro - _offset(gyro, quiet, m.period), m.period)
    for known in (_by_gravity(record, m, swing, calm if m.wheels else quiet), _by_estimate(record, m, gyro)):
        if known is not None and not other_zero(known, quiet):
            return Lean(known, True, quiet, calm)
    still = np.where(quiet, 0.0, gyro - _offset(gyro, quiet, m.period))
    swing = _summed(still, m.period)
    return Lean(swing - _usual(swing, ~quiet, m.period), False, quiet, calm)


def _spinning(record: Record, m: Resampled, quiet: Mask) -> Mask:
    """The rests of the body in which a wheel spins up as it does on no floor: there δ̈ = −q ψ̈ + p ψ, so that a body that
    is seen to rest bounds by how much the wheels change their speed, whatever the robot. What a logged tilt does
    bounds it too, since a gyro may be about another axis."""
    assert m.gyro is not None
    spinning = np.zeros(len(quiet), dtype=bool)
    if not m.wheels:
        return spinning
    tilt = record[PITCH] if PITCH in record and m.gyro_name == GYRO else np.full(len(record.t), np.nan)
    fine = np.isfinite(tilt)
    rates = [smooth(m.gyro / _divisor(m), m.period, _CALMED)]
    rates += [smooth(np.interp(m.t, record.t[fine], tilt[fine]), m.period, _CALMED, 1)] if fine.any() else []
    carried = [(_LARGEST_Q * rate, _LARGEST_P * _summed(_summed(rate, m.period), m.period)) for rate in rates]
    speeds = [smooth(wheel, m.period, _CALMED, 1) for wheel in (m.left, m.right)]
    fastest = max(float(np.percentile(np.abs(speed), 95)) for speed in speeds)
    scale = _SLOW_WHEEL / fastest if fastest > FASTEST_WHEEL else 1.0  # counts, of an unknown number to a turn
    count = max(3, round(_STILL / m.period))
    for a, b in runs(quiet):
        windows = [slice(i, i + count) for i in range(a, b - count + 1, max(1, count // 2))]
        spinning[a:b] = any(
            scale * bent(speed[w]) > max(_SPUN, *(sum(bent(part[w]) for part in parts) for parts in carried))
            for w in windows
            for speed in speeds
        )
    return spinning


def other_zero(angle: Array, quiet: Mask) -> float:
    """The angle [rad] that a tilt has where the robot is upright, if it swings about one at which nothing balances; 0
    elsewhere. On the floor a body does not swing to both sides."""
    moving = angle[~quiet]
    if len(moving) < 0.5 * len(angle):
        return 0.0
    low, middle, high = np.percentile(moving, [10, 50, 90]).tolist()
    beyond = np.sign(moving - middle)[np.abs(moving - middle) > (high - low) / 4]
    swings = int((np.diff(beyond) != 0).sum())
    return middle if abs(middle) > _NO_TILT and high - low > _SWUNG and swings >= _SWINGS else 0.0


def _divisor(m: Resampled) -> float:
    """What makes radians of the gyro, since the poses are read before the units are known: 1, or 180/π where it can
    only be in degrees, or in raw counts what makes its swings usual ones."""
    assert m.gyro is not None
    swing = _summed(m.gyro, m.period)
    fast = swing - smooth(swing, m.period, 8 * widths(m.period)[-1])
    rms, width = float(np.sqrt(np.mean(m.gyro**2))), float(fast.std())
    coarse = m.gyro_name == GYRO and grain_of(m.gyro) >= _COARSEST
    off = m.gyro_name == GYRO and abs(float(np.median(m.gyro))) > LARGEST_OFFSET and m.t[-1] - m.t[0] > _USUAL
    if not (rms > _FASTEST or width > _WIDEST or coarse or off):
        return 1.0
    degrees = 180 / np.pi
    if rms > _FASTEST * degrees or width > _WIDEST * degrees:
        return float(np.percentile(np.abs(fast), 80)) / _SWING
    return degrees


def _summed(rate: Array, period: float) -> Array:
    return np.concatenate([[0.0], np.cumsum((rate[1:] + rate[:-1]) / 2)]) * period


def _offset(gyro: Array, quiet: Mask, period: float) -> float:
    """The gyro's offset [rad/s]: its mean at rest, else the drift of its integral that the swings leave visible."""
    if quiet.sum() * period > 2 * _STILL:
        return float(np.median(gyro[quiet]))
    swing, t = _summed(gyro, period), np.arange(len(gyro)) * period
    keep = np.ones(len(t), dtype=bool)
    slope = spread = 0.0
    for _ in range(3):
        x, y = t[keep] - t[keep].mean(), swing[keep] - swing[keep].mean()
        slope = float(x @ y / max(float(x @ x), 1e-12))
        spread = float((y - slope * x).std())
        left = np.abs(swing - swing[keep].mean() - slope * (t - t[keep].mean()))
        keep = left <= np.quantile(left, 0.8)
    doubt = max(4 * spread / max(float(t[-1]), 1e-9), 1e-9)
    return slope * _DRIFT**2 / (_DRIFT**2 + doubt**2)


def _by_gravity(record: Record, m: Resampled, swing: Array, calm: Mask) -> Array | None:
    """The integrated gyro, set right by the accelerometer wherever the robot rests."""
    if FORWARD not in record or UP not in record:
        return None
    pulls = np.arctan2(-record[FORWARD], record[UP])
    if not np.isfinite(pulls).all():
        return None
    pull = np.interp(m.t, record.t, np.unwrap(pulls))
    anchors, offsets = list[float](), list[float]()
    for a, b in runs(calm):
        third = max((b - a) // 3, 1)
        for rows in (slice(a, a + third), slice(b - third, b)):
            anchors.append(float(np.mean(m.t[rows])))
            angle = np.angle(np.mean(np.exp(1j * pull[rows])))
            offsets.append(float(angle - np.median(swing[rows])))
    if not anchors:
        return swing + float(np.median(pull - swing))
    angle = swing + np.interp(m.t, anchors, np.unwrap(offsets))
    turns = np.round(angle[int(np.searchsorted(m.t, anchors[0]))] / math.tau)
    return angle - math.tau * turns


def _by_estimate(record: Record, m: Resampled, gyro: Array) -> Array | None:
    """The pitch estimate, in the unit of the gyro; None where it does not follow it or counts from the start pose."""
    if PITCH not in record or not np.isfinite(record[PITCH]).all() or record[PITCH][0] == 0:
        return None
    angle, width = np.interp(m.t, record.t, record[PITCH]), widths(m.period)[-1]
    a, b = smooth(angle, m.period, width, 1), smooth(gyro, m.period, width)
    if m.gyro_name == PITCH:
        return angle / _divisor(m)
    power = float(a @ a) * float(b @ b)
    if power <= 0 or float(a @ b) ** 2 < _FOLLOWS * power:
        return None
    gain = float(a @ b) / float(a @ a)
    return angle * (1.0 if 1 / _SAME_UNIT < gain < _SAME_UNIT else gain)  # else one of them is in another unit


def _usual(swing: Array, moving: Mask, period: float) -> Array:
    """The median of the moving robot's lean about each time: upright, whatever the gyro's drift."""
    reach, n = max(1, round(_USUAL / period)), len(swing)
    rows = np.flatnonzero(moving)
    if not len(rows):
        return np.full(n, float(np.median(swing)))
    knots = np.arange(0, n + reach // 2, max(1, reach // 2))
    at, values = list[int](), list[float]()
    for knot in knots.tolist():
        near = rows[np.searchsorted(rows, knot - reach) : np.searchsorted(rows, knot + reach)]
        if len(near) * period > min(1.0, 0.5 * n * period):
            at.append(knot)
            values.append(float(np.median(swing[near])))
    return np.interp(np.arange(n), at, values) if at else np.full(n, float(np.median(swing[rows])))


def _labelled(m: Resampled, lean: Lean, spinning: Mask, off: Mask, *, swung: bool) -> list[tuple[str, int, int]]:
    """The kinds of pose, row by row, as runs."""
    size, n = np.abs(lean.angle), len(m.t)
    lying = lean.quiet & (size > TIPPED)
    floor = _FLOOR
    if lying.any():
        floor = min(_FLOOR, NEAR_FLOOR * float(np.median(size[lying])))
    down = lying | (size > floor if lean.absolute or lying.any() else np.zeros(n, dtype=bool))
    parts: list[tuple[str, int, int]] = []
    for a, b in _stretches(down):
        if down[a]:
            over = lean.absolute and float(np.median(size[a:b])) > _OVER
            parts.append((OVER if over else LYING if lying[a:b].any() else MOVED, a, b))
        else:
            parts += _upright(m, lean, spinning, off, a, b, from_floor=a > 0, to_floor=b < n, swung=swung)
    return parts


def _stretches(mask: NDArray[np.bool_ | np.int64]) -> Iterator[tuple[int, int]]:
    edges = [0, *(np.flatnonzero(np.diff(mask)) + 1).tolist(), len(mask)]
    yield from pairwise(edges)


def _upright(
    m: Resampled,
    lean: Lean,
    spinning: Mask,
    off: Mask,
    a: int,
    b: int,
    *,
    from_floor: bool,
    to_floor: bool,
    swung: bool,
) -> list[tuple[str, int, int]]:
    """A stretch off the floor: standing up, balancing and falling, or only moved by hand or thrown."""
    size, idle = np.abs(lean.angle[a:b]), bool(off[a:b].all())
    up = np.flatnonzero(size < _UP) if from_floor else [0]
    stays = _lasting(size < TIPPED, m.period, _LONG).any() or (b - a) * m.period > LONGEST_THROW
    if from_floor and (idle or not stays or not len(up)):
        return [(MOVED if idle or to_floor else RISING, a, b)]
    first = a + int(up[0])
    falls = to_floor or _ends_falling(lean.angle[first:b], m.period)
    begins = _fall_start if swung else _leaves
    last = first + begins(lean.angle[first:b], m.period) if falls else b
    lasting = off[a:b] if idle else _lasting(off[a:b], m.period, _LONG)
    doing = np.where(lasting, 3, np.where(spinning, 2, lean.calm)[a:b])[first - a : last - a]
    parts = _stretches(doing) if last > first else ()
    standing = [((BALANCING, STANDING, HELD, OFF)[doing[i]], first + i, first + j) for i, j in parts]
    rising = [(RISING, a, first)] if first > a else []
    return [*rising, *standing, *([(FALLING, last, b)] if last < b else [])]


def _off(record: Record, m: Resampled, calm: Mask) -> Mask:
    """The rows without a command: a dead zone is none, and what stands still may need none."""
    names = [name for name in record.channels if name.startswith(("applied/", "command/"))]
    zero = ~np.any([record[name] for name in names], axis=0) if names else np.zeros(len(record.t))
    off = np.interp(m.t, record.t, zero) > 0.5
    return off & (~calm | off.all())


def _fall_start(angle: Array, period: float) -> int:
    """Where the body began to turn before it had a usual lean for the last time; 0 in a log that is little else."""
    size = np.abs(angle)
    usual = np.flatnonzero(size <= max(float(np.median(size)), 0.05))
    start = int(usual[-1]) if len(usual) else 0
    inward = np.diff(smooth(angle[: start + 1], period, 2 * period)) * np.sign(angle[-1]) <= 0 if start else np.zeros(0)
    start = int(np.flatnonzero(inward)[-1]) + 1 if inward.any() else 0
    return start if start * period > _SHORTEST else 0


def _leaves(angle: Array, period: float) -> int:
    """Where a fall leaves what the rows before it show: the last row of a lean that the robot had before the fall, too;
    0 in a log that is little else. A swing within which a push comes is none of the fall."""
    size = np.abs(angle)
    start = _fall_start(angle, period)
    return int(np.flatnonzero(size <= size[:start].max())[-1]) if start else 0


def _ends_falling(angle: Array, period: float) -> bool:
    """Whether a stretch ends in a lean that it never had before, and leans further or was stopped by the floor."""
    size = np.abs(angle)
    end = size[-1]
    if end < TIPPED:
        return False
    start = _fall_start(angle, period)
    rows = max(2, round(_STOPS / period))
    recent = angle[-rows:]
    outward = float(recent[-1] - recent[0]) * np.sign(angle[-1]) > 0
    earlier = float(size[:start].max()) if start else 0.0
    return bool((outward or _struck(angle[start:] * np.sign(angle[-1]), rows)) and end > _FURTHER * earlier)


def _struck(lean: Array, rows: int) -> bool:
    """Whether the floor stopped a body whose lean [rad] ends on the positive side, and holds it: it turned fast and
    stopped within so many `rows`. Motors that catch a body brake it for longer, and drive it back."""
    if len(lean) < 2:
        return False
    rates, down = np.diff(lean), lean > NEAR_FLOOR * lean.max()
    first = max(int(np.argmax(down)) - 2, 0)  # of the row before: the floor may stop it within one
    fastest = first + int(np.argmax(rates[first:]))
    after = rates[fastest + 1 :][:rows]
    fast = rates[fastest] > _STRIKES * rates.max()
    return bool(down[-1] and fast and after.min(initial=np.inf) < _STOPPED * rates[fastest])


def _merged(parts: list[tuple[str, int, int]], period: float) -> list[tuple[str, int, int]]:
    """Equal neighbours as one; what lies after a fall is fallen; a bounce on the floor is no pose of its own."""
    merged: list[tuple[str, int, int]] = []
    for named, a, b in parts:
        before = merged[-1][0] if merged else ""
        kind = _after(before, named, (b - a) * period)
        if before == kind:
            merged[-1] = (kind, merged[-1][1], b)
        else:
            merged.append((kind, a, b))
    return merged


def _after(before: str, kind: str, seconds: float) -> str:
    """The kind of a part, given the kind of the part before it."""
    if before in (FALLING, FALLEN) and (kind == LYING or (kind == MOVED and seconds < 1.0)):
        return FALLEN
    return MOVED if before == MOVED and kind == LYING and seconds < _STILL else kind
