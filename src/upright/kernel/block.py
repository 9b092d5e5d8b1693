"""Operations on a block of robots, besides motion: command, drive, push, slope, sensors, counts.

A block is one array `w` of rows; each row holds one number for each of up to `LANES` robots. Every loop over robots `i`
is straight-line code, which the compiler turns into vector instructions.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from upright.compiled.counter import FOR_JITTER
from upright.compiled.generated import (
    FORCE,
    HALF_TRACK,
    LIVED,
    MOMENT,
    PITCH,
    PITCH_RATE,
    SIN_SLOPE,
    WHEEL,
    YAW,
    H,
)
from upright.compiled.jit import (
    RobotBlock,
    absolute,
    fma,
    get,
    item,
    njit,
    put,
    store,
)
from upright.compiled.lane_math import sincos_any
from upright.compiled.random import whole
from upright.kernel.rows import (
    ACCEL_FORWARD,
    ALL_ROWS,
    ANGLE,
    BEYOND,
    COMPASS,
    DEAD_TIME,
    EFFORT,
    ENCODER_LEFT,
    ENCODER_RIGHT,
    FLOOR,
    GYRO,
    HOLD,
    NEVER,
    OUTSIDE,
    PEAK_PITCH,
    PEAK_WHEEL,
    PEAK_YAW,
    REFERENCE,
    ROBOTS,
    SATURATED,
    SPECIFIC_FORCE,
    SQUARE,
    VARIED,
)


class Trace(NamedTuple):
    """Where a period is recorded: in `out` from `place` on, robots being `size` apart."""

    out: Any
    place: int
    size: int


@njit
def fill(w: Any, count: int, plan: Any, common: Any, rows: Any, table: Any, first: int) -> None:
    """Every row as `common` (r,) has it for all robots, then `rows` (v,) from those of `table` (v, n)."""
    robots = item(plan, ROBOTS)
    for r in range(item(plan, ALL_ROWS)):
        value = item(common, r)
        for i in range(count):
            put(w, r, i, value)
    for v in range(item(plan, VARIED)):
        row = item(rows, v)
        for i in range(count):
            put(w, row, i, item(table, v * robots + first + i))


@njit
def copy(w: Any, out: int, source: int, count: int) -> None:
    """Row `source` into row `out`."""
    for i in range(count):
        put(w, out, i, get(w, source, i))


@njit
def arrive(block: RobotBlock, ring: int, slots: int, k: int, stride: int, seed: Any) -> int:
    """The three commands that a motor may hold during period `k`: six rows from HOLD on in order of arrival, then two
    rows with the steps at which the second and the third arrive. Returns the largest of these steps.

    Rows from DEAD_TIME on: periods and steps of dead time, largest jitter in steps.
    """
    w = block.w
    last = 0
    for i in range(block.robots):
        j = k - int(get(w, DEAD_TIME, i))
        two = int(get(w, DEAD_TIME + 1, i))
        one = two - stride
        jitter = int(get(w, DEAD_TIME + 2, i))
        if jitter > 0:
            robot = item(block.index, block.first + i)
            one += whole((j - 1) * stride, FOR_JITTER, jitter + 1, seed, robot)
            two = max(one, two + whole(j * stride, FOR_JITTER, jitter + 1, seed, robot))
        for m in range(3):
            slot = ring + 2 * ((j - 2 + m) % slots)
            put(w, HOLD + 2 * m, i, get(w, slot, i))
            put(w, HOLD + 2 * m + 1, i, get(w, slot + 1, i))
        put(w, HOLD + 6, i, one)
        put(w, HOLD + 7, i, two)
        last = max(last, two)
    return last


@njit
def arrive_alike(w: Any, count: int, ring: int, slots: int, k: int, stride: int) -> int:
    """`arrive` for robots with one dead time and no jitter: the rows of the first robot count for all."""
    j = k - int(get(w, DEAD_TIME, 0))
    two = get(w, DEAD_TIME + 1, 0)
    for m in range(3):
        slot = ring + 2 * ((j - 2 + m) % slots)
        copy(w, HOLD + 2 * m, slot, count)
        copy(w, HOLD + 2 * m + 1, slot + 1, count)
    for i in range(count):
        put(w, HOLD + 6, i, two - stride)
        put(w, HOLD + 7, i, two)
    return int(two)


@njit
def hold(w: Any, count: int, row: int, step: float) -> None:
    """The command that has arrived by `step` of the period goes to the motors, in two rows from `row` on."""
    for i in range(count):
        before_second, before_third = get(w, HOLD + 6, i) > step, get(w, HOLD + 7, i) > step
        left = get(w, HOLD, i)
        right = get(w, HOLD + 1, i)
        next_left, next_right = get(w, HOLD + 2, i), get(w, HOLD + 3, i)
        last_left, last_right = get(w, HOLD + 4, i), get(w, HOLD + 5, i)
        next_left, next_right = next_left if before_third else last_left, next_right if before_third else last_right
        put(w, row, i, left if before_second else next_left)
        put(w, row + 1, i, right if before_second else next_right)


@njit
def push(w: Any, count: int, rows: int, pushes: int, now: int) -> int:
    """Force and moment of all pushes that act at step `now`; returns the step of their next change.

    Four rows a push: force [N], moment [N m], the step from which on and the one before which it acts.
    """
    change = float(NEVER)
    for i in range(count):
        force, moment = 0.0, 0.0
        for p in range(rows, rows + 4 * pushes, 4):
            start, stop = get(w, p + 2, i), get(w, p + 3, i)
            if start <= now < stop:
                force += get(w, p, i)
                moment += get(w, p + 1, i)
            change = min(change, start if start > now else stop if stop > now else float(NEVER))
        put(w, FORCE, i, force)
        put(w, MOMENT, i, moment)
    return int(change)


@njit
def tilt(w: Any, count: int, now: int) -> int:
    """Sine and cosine of the floor's slope at step `now`; returns the step of their next change.

    Three rows from FLOOR on: sine, cosine, and the step from which on the floor slopes.
    """
    change = float(NEVER)
    for i in range(count):
        start = get(w, FLOOR + 2, i)
        on = start <= now
        put(w, SIN_SLOPE, i, get(w, FLOOR, i) if on else 0.0)
        put(w, SIN_SLOPE + 1, i, get(w, FLOOR + 1, i) if on else 1.0)
        change = change if on else min(change, start)
    return int(change)


@njit
def refer(w: Any, count: int, rows: int, ramps: int, t: float) -> None:
    """The reference state at `t` [s]. Four rows a ramp: wheel rate, yaw rate [rad/s], start and end [s]."""
    for i in range(count):
        wheel, wheel_rate, yaw, yaw_rate = 0.0, 0.0, 0.0, 0.0
        for q in range(rows, rows + 4 * ramps, 4):
            rate = get(w, q, i)
            turn = get(w, q + 1, i)
            start, until = get(w, q + 2, i), get(w, q + 3, i)
            along = min(max(t, start), until) - start
            inside = start <= t < until
            wheel += rate * along
            yaw += turn * along
            wheel_rate += rate if inside else 0.0
            yaw_rate += turn if inside else 0.0
        put(w, REFERENCE + 2, i, wheel)
        put(w, REFERENCE + 3, i, wheel_rate)
        put(w, REFERENCE + 4, i, yaw)
        put(w, REFERENCE + 5, i, yaw_rate)


@njit
def sense(w: Any, count: int, kind: int, out: int) -> None:
    """Row `out`: the present reading of an ideal sensor of this kind."""
    if kind <= ENCODER_RIGHT:
        side = -1.0 if kind == ENCODER_LEFT else 1.0
        for i in range(count):
            turn = get(w, HALF_TRACK, i) * side
            put(w, out, i, fma(turn, get(w, YAW, i), get(w, WHEEL, i)) - get(w, PITCH, i))
    else:
        state = PITCH_RATE if kind == GYRO else YAW if kind == COMPASS else PITCH
        measures_state = kind in (GYRO, COMPASS, ANGLE)
        copy(w, out, state if measures_state else SPECIFIC_FORCE + kind - ACCEL_FORWARD, count)


@njit
def direct(w: Any, count: int, out: int, angle: int) -> None:
    """Rows `out` and `out` + 1: cosine and sine of row `angle`."""
    for i in range(count):
        sine, cosine = sincos_any(get(w, angle, i))
        put(w, out, i, cosine)
        put(w, out + 1, i, sine)


@njit
def add(w: Any, out: int, source: int, count: int, factor: float) -> None:
    """To row `out` that many times row `source`."""
    for i in range(count):
        put(w, out, i, fma(factor, get(w, source, i), get(w, out, i)))


@njit
def clear(w: Any, out: int, count: int) -> None:
    """Row `out`: zeros."""
    for i in range(count):
        put(w, out, i, 0.0)


@njit
def count_period(w: Any, count: int, bands: Any, t: Any) -> None:
    """Peaks, settling, squared pitch and saturation of every robot that stands, at `t` [s], the start of a period."""
    one = item(bands, 0)
    two = item(bands, 1)
    three = item(bands, 2)
    for i in range(count):
        standing = get(w, H, i) > 0.0
        pitch, wheel, yaw = (
            absolute(get(w, PITCH, i)),
            absolute(get(w, WHEEL, i)),
            absolute(get(w, YAW, i)),
        )
        peak = get(w, PEAK_PITCH, i)
        put(w, PEAK_PITCH, i, max(peak, pitch) if standing else peak)
        peak = get(w, PEAK_WHEEL, i)
        put(w, PEAK_WHEEL, i, max(peak, wheel) if standing else peak)
        peak = get(w, PEAK_YAW, i)
        put(w, PEAK_YAW, i, max(peak, yaw) if standing else peak)
        outside = (pitch > one) | (wheel > two) | (yaw > three)
        before = get(w, OUTSIDE, i)
        put(w, OUTSIDE, i, t if outside & standing else before)
        square = get(w, SQUARE, i)
        put(w, SQUARE, i, fma(pitch, pitch, square) if standing else square)
        saturated = get(w, SATURATED, i)
        put(w, SATURATED, i, saturated + get(w, BEYOND, i) if standing else saturated)


@njit
def count_effort(w: Any, count: int, row: int) -> None:
    """Adds the squares of both applied commands, in two rows from `row` on, at the end of this period."""
    for i in range(count):
        left = get(w, row, i)
        right = get(w, row + 1, i)
        sum_ = get(w, EFFORT, i)
        square = fma(left, left, right * right)
        put(w, EFFORT, i, sum_ + square if get(w, H, i) > 0.0 else sum_)


@njit
def standing(w: Any, count: int) -> int:
    """How many robots of the block have not fallen."""
    n = 0
    for i in range(count):
        n += int(get(w, H, i) > 0.0)
    return n


@njit
def record(w: Any, count: int, rows: Any, many: int, trace: Trace, since: float) -> None:
    """The `many` rows of every robot that stands or stood after `since` [s]; entries of the others stay."""
    for m in range(many):
        row = item(rows, m)
        for i in range(count):
            if get(w, H, i) > 0.0 or get(w, LIVED, i) > since:
                store(trace.out, trace.place + i * trace.size + m, get(w, row, i))
