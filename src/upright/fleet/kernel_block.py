"""What is done to a block of robots side by side, besides moving them: command, drive, push, read, count.

A block is one array `w` of rows; each row holds one number for each of up to `LANES` robots, and rows start `ROW`
apart. Every loop over robots `i` is straight-line code, which the compiler turns into vector instructions.
"""

from __future__ import annotations

from typing import Any

from upright.fleet.generated import (
    C0,
    FORCE,
    LEFT,
    LIVED,
    MOMENT,
    PITCH,
    PITCH_RATE,
    RIGHT,
    ROW,
    SIN_SLOPE,
    WHEEL,
    YAW,
    H,
)
from upright.fleet.kernel_jit import absolute, fma, inlined, item, mul, njit, positive, put, rint, trunc
from upright.fleet.kernel_rows import (
    ACCEL_FORWARD,
    COMMAND,
    COMPASS,
    COUNTS,
    DEAD_ZONE,
    DRIVEN,
    EFFORT,
    ENCODER_LEFT,
    ENCODER_RIGHT,
    FELT,
    FLOOR,
    GYRO,
    HOLD,
    JITTER,
    KIT,
    LATE,
    LIMIT,
    NEVER,
    OUTSIDE,
    PEAK_PITCH,
    PEAK_WHEEL,
    PEAK_YAW,
    QUANTUM,
    REFERENCE,
    S_NOISE,
    S_OFFSET,
    S_PLAY,
    S_QUANTUM,
    S_RANGE,
    S_SAID,
    S_TOUCH,
    S_WALK,
    S_WHEEL,
    SAG,
    SATURATED,
    SQUARE,
    VOLTAGE,
)
from upright.fleet.random import whole


@njit
def fill(w: Any, count: int, common: Any, rows: Any, table: Any, first: int) -> None:
    """Every row as `common` (r,) has it for all robots, then `rows` (v,) from the columns of `table` (n, v)."""
    for r in range(len(common)):
        value = common[r]
        for i in range(count):
            put(w, r * ROW + i, value)
    for v in range(len(rows)):
        out = rows[v] * ROW
        for i in range(count):
            put(w, out + i, table[first + i, v])


@njit
def copy(w: Any, out: int, source: int, count: int) -> None:
    """Row `source` into row `out`."""
    for i in range(count):
        put(w, out * ROW + i, item(w, source * ROW + i))


@njit
def apply_gains(w: Any, count: int, out: int, end: int, entries: Any, own: int) -> None:
    """Rows from `out` to before `end`: each is the sum of gain times row over `entries` (e, 3): output, row and the row
    of the gain, which is the first number there for all robots, or each one's own."""
    for i in range(out * ROW, end * ROW):
        put(w, i, 0.0)
    for e in range(len(entries)):
        a, b, c = (out + entries[e, 0]) * ROW, entries[e, 1] * ROW, entries[e, 2] * ROW
        if own:
            for i in range(count):
                put(w, a + i, fma(item(w, c + i), item(w, b + i), item(w, a + i)))
        else:
            gain = item(w, c)
            for i in range(count):
                put(w, a + i, fma(gain, item(w, b + i), item(w, a + i)))


@inlined
def driven(u: Any, limit: Any, quantum: Any) -> Any:
    """Saturation, then the driver's quantum, as in `bodies.electronics.drive`."""
    inside = min(max(u, -limit), limit)
    return trunc(inside / quantum) * quantum if positive(quantum) else inside


@njit
def drive(w: Any, count: int) -> None:
    """What of the command reaches the motors; robots that saturate are counted."""
    for i in range(count):
        left, right = item(w, COMMAND * ROW + i), item(w, (COMMAND + 1) * ROW + i)
        dead, full = item(w, (KIT + DEAD_ZONE) * ROW + i), item(w, (KIT + VOLTAGE) * ROW + i)
        left = mul(left, 0.0) if absolute(left) <= dead else left
        right = mul(right, 0.0) if absolute(right) <= dead else right
        load = min(absolute(left), full) + min(absolute(right), full)
        sag = item(w, (KIT + SAG) * ROW + i)
        limit = min(item(w, (KIT + LIMIT) * ROW + i), fma(-sag, load, full) if positive(sag) else full)
        quantum = item(w, (KIT + QUANTUM) * ROW + i)
        put(w, DRIVEN * ROW + i, driven(left, limit, quantum))
        put(w, (DRIVEN + 1) * ROW + i, driven(right, limit, quantum))
        n = item(w, (COUNTS + SATURATED) * ROW + i)
        beyond = max(absolute(left), absolute(right)) > limit
        put(w, (COUNTS + SATURATED) * ROW + i, fma(n, 1.0, 1.0) if beyond & positive(item(w, H * ROW + i)) else n)


@njit
def arrive(
    w: Any, count: int, ring: int, slots: int, k: int, stride: int, index: Any, first: int, seed: Any
) -> int:  # fmt: skip
    """The three commands that a motor may hold during period `k`, in six rows from HOLD on in order of arrival, and in
    the two rows after them the steps at which the second and the third arrive; returns the last such step.

    Rows from LATE on: periods and steps of dead time, largest jitter in steps.
    """
    last = 0
    for i in range(count):
        j = k - int(item(w, LATE * ROW + i))
        two = int(item(w, (LATE + 1) * ROW + i))
        one, jitter = two - stride, int(item(w, (LATE + 2) * ROW + i))
        if jitter > 0:
            one += whole(index[first + i], j - 1, JITTER, seed, jitter + 1)
            two = max(one, two + whole(index[first + i], j, JITTER, seed, jitter + 1))
        for m in range(3):
            slot = ring + 2 * ((j - 2 + m) % slots)
            put(w, (HOLD + 2 * m) * ROW + i, item(w, slot * ROW + i))
            put(w, (HOLD + 2 * m + 1) * ROW + i, item(w, (slot + 1) * ROW + i))
        put(w, (HOLD + 6) * ROW + i, one)
        put(w, (HOLD + 7) * ROW + i, two)
        last = max(last, two)
    return last


@njit
def arrive_alike(w: Any, count: int, ring: int, slots: int, k: int, stride: int) -> int:
    """`arrive` where every command is equally late for all robots, as the first one's rows say."""
    j, two = k - int(item(w, LATE * ROW)), item(w, (LATE + 1) * ROW)
    for m in range(3):
        slot = ring + 2 * ((j - 2 + m) % slots)
        copy(w, HOLD + 2 * m, slot, count)
        copy(w, HOLD + 2 * m + 1, slot + 1, count)
    for i in range(count):
        put(w, (HOLD + 6) * ROW + i, two - stride)
        put(w, (HOLD + 7) * ROW + i, two)
    return int(two)


@njit
def hold(w: Any, count: int, step: float) -> None:
    """The command that has arrived by `step` of the period goes to the motors."""
    for i in range(count):
        early, later = item(w, (HOLD + 6) * ROW + i) > step, item(w, (HOLD + 7) * ROW + i) > step
        left, right = item(w, HOLD * ROW + i), item(w, (HOLD + 1) * ROW + i)
        next_left, next_right = item(w, (HOLD + 2) * ROW + i), item(w, (HOLD + 3) * ROW + i)
        last_left, last_right = item(w, (HOLD + 4) * ROW + i), item(w, (HOLD + 5) * ROW + i)
        next_left, next_right = next_left if later else last_left, next_right if later else last_right
        put(w, LEFT * ROW + i, left if early else next_left)
        put(w, RIGHT * ROW + i, right if early else next_right)


@njit
def push(w: Any, count: int, rows: int, pushes: int, now: int) -> int:
    """Force and moment of all pushes that act at step `now`; returns the next step at which that changes.

    Four rows a push: force [N], moment [N m], the step from which on and the one before which it acts.
    """
    change = float(NEVER)
    for i in range(count):
        force, moment = 0.0, 0.0
        for p in range(rows, rows + 4 * pushes, 4):
            start, stop = item(w, (p + 2) * ROW + i), item(w, (p + 3) * ROW + i)
            if start <= now < stop:
                force += item(w, p * ROW + i)
                moment += item(w, (p + 1) * ROW + i)
            change = min(change, start if start > now else stop if stop > now else float(NEVER))
        put(w, FORCE * ROW + i, force)
        put(w, MOMENT * ROW + i, moment)
    return int(change)


@njit
def tilt(w: Any, count: int, now: int) -> int:
    """Sine and cosine of the floor's slope at step `now`; returns the next step at which one changes.

    Three rows from FLOOR on: sine, cosine, and the step from which on the floor slopes.
    """
    change = float(NEVER)
    for i in range(count):
        start = item(w, (FLOOR + 2) * ROW + i)
        on = start <= now
        put(w, SIN_SLOPE * ROW + i, item(w, FLOOR * ROW + i) if on else 0.0)
        put(w, (SIN_SLOPE + 1) * ROW + i, item(w, (FLOOR + 1) * ROW + i) if on else 1.0)
        change = change if on else min(change, start)
    return int(change)


@njit
def refer(w: Any, count: int, rows: int, ramps: int, t: float) -> None:
    """The wanted state at `t` [s]. Four rows a ramp: wheel rate, yaw rate [rad/s], start and end [s]."""
    for i in range(count):
        wheel, wheel_rate, yaw, yaw_rate = 0.0, 0.0, 0.0, 0.0
        for q in range(rows, rows + 4 * ramps, 4):
            rate, turn = item(w, q * ROW + i), item(w, (q + 1) * ROW + i)
            start, until = item(w, (q + 2) * ROW + i), item(w, (q + 3) * ROW + i)
            along = min(max(t, start), until) - start
            inside = start <= t < until
            wheel += rate * along
            yaw += turn * along
            wheel_rate += rate if inside else 0.0
            yaw_rate += turn if inside else 0.0
        put(w, (REFERENCE + 2) * ROW + i, wheel)
        put(w, (REFERENCE + 3) * ROW + i, wheel_rate)
        put(w, (REFERENCE + 4) * ROW + i, yaw)
        put(w, (REFERENCE + 5) * ROW + i, yaw_rate)


@njit
def sense(w: Any, count: int, kind: int, out: int) -> None:
    """Row `out`: what an ideal sensor of this kind says now."""
    if kind <= ENCODER_RIGHT:
        side = -1.0 if kind == ENCODER_LEFT else 1.0
        for i in range(count):
            turn = mul(item(w, C0 * ROW + i), side)
            put(
                w, out * ROW + i, fma(turn, item(w, YAW * ROW + i), item(w, WHEEL * ROW + i)) - item(w, PITCH * ROW + i)
            )
    else:
        source = PITCH_RATE if kind == GYRO else YAW if kind == COMPASS else FELT + kind - ACCEL_FORWARD
        copy(w, out, source, count)


@njit
def slacken(w: Any, count: int, numbers: int) -> None:
    """Backlash: the wheel moves its encoder only where it reaches the end of the play."""
    for i in range(count):
        value, play = item(w, (numbers + S_WHEEL) * ROW + i), item(w, (numbers + S_PLAY) * ROW + i)
        put(
            w,
            (numbers + S_TOUCH) * ROW + i,
            min(max(item(w, (numbers + S_TOUCH) * ROW + i), value - play), value + play),
        )


@njit
def corrupt(w: Any, count: int, value: int, numbers: int, noise: int, root: float) -> None:
    """The reading that a sensor makes of row `value`; its offset walks by `root` [√s]. Rows `noise` and `noise` + 4
    hold normal numbers for both."""
    for i in range(count):
        walk = mul(item(w, (numbers + S_WALK) * ROW + i), root)
        offset = fma(walk, item(w, (noise + 4) * ROW + i), item(w, (numbers + S_OFFSET) * ROW + i))
        reading = fma(
            item(w, (numbers + S_NOISE) * ROW + i), item(w, noise * ROW + i), item(w, value * ROW + i) + offset
        )
        quantum, end = item(w, (numbers + S_QUANTUM) * ROW + i), item(w, (numbers + S_RANGE) * ROW + i)
        reading = rint(reading / quantum) * quantum if positive(quantum) else reading
        put(w, (numbers + S_OFFSET) * ROW + i, offset)
        put(w, (numbers + S_SAID) * ROW + i, min(max(reading, -end), end))


@njit
def count_period(w: Any, count: int, bands: Any, t: Any) -> None:
    """What happened to every robot that still stands, as it is at the start of a period and under the command of it."""
    one, two, three = bands[0], bands[1], bands[2]
    for i in range(count):
        standing = positive(item(w, H * ROW + i))
        pitch, wheel, yaw = (
            absolute(item(w, PITCH * ROW + i)),
            absolute(item(w, WHEEL * ROW + i)),
            absolute(item(w, YAW * ROW + i)),
        )
        peak = item(w, (COUNTS + PEAK_PITCH) * ROW + i)
        put(w, (COUNTS + PEAK_PITCH) * ROW + i, max(peak, pitch) if standing else peak)
        peak = item(w, (COUNTS + PEAK_WHEEL) * ROW + i)
        put(w, (COUNTS + PEAK_WHEEL) * ROW + i, max(peak, wheel) if standing else peak)
        peak = item(w, (COUNTS + PEAK_YAW) * ROW + i)
        put(w, (COUNTS + PEAK_YAW) * ROW + i, max(peak, yaw) if standing else peak)
        outside = (pitch > one) | (wheel > two) | (yaw > three)
        before = item(w, (COUNTS + OUTSIDE) * ROW + i)
        put(w, (COUNTS + OUTSIDE) * ROW + i, t if outside & standing else before)
        square = item(w, (COUNTS + SQUARE) * ROW + i)
        put(w, (COUNTS + SQUARE) * ROW + i, fma(pitch, pitch, square) if standing else square)


@njit
def count_effort(w: Any, count: int) -> None:
    """Adds the square of what both motors held at the end of this period."""
    for i in range(count):
        left, right = item(w, LEFT * ROW + i), item(w, RIGHT * ROW + i)
        sum_ = item(w, (COUNTS + EFFORT) * ROW + i)
        square = fma(left, left, right * right)
        put(w, (COUNTS + EFFORT) * ROW + i, sum_ + square if positive(item(w, H * ROW + i)) else sum_)


@njit
def standing(w: Any, count: int) -> int:
    """How many robots of the block have not fallen."""
    n = 0
    for i in range(count):
        n += int(positive(item(w, H * ROW + i)))
    return n


@njit
def record(w: Any, count: int, rows: Any, out: Any, first: int, k: int, column: int, since: float) -> None:
    """Row `k` of `out` (n, k, channels), from `column` on, of every robot that stands or stood after `since` [s]; the
    others keep what is there."""
    for m in range(len(rows)):
        for i in range(count):
            if positive(item(w, H * ROW + i)) or item(w, LIVED * ROW + i) > since:
                out[first + i, k, column + m] = item(w, rows[m] * ROW + i)
