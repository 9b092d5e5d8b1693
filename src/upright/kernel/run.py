"""The loop over time for one block of robots after another: the compiled counterpart of `experiment.run`.

Tables are plain addresses here, read by `item`: they are quicker to compile, and to pass on, than arrays.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from upright.compiled.counter import FOR_BIAS, FOR_NOISE, FOR_WALK
from upright.compiled.generated import LANES, LEFT, LIVED, PITCH
from upright.compiled.jit import (
    RobotBlock,
    call_on_block,
    call_program,
    call_to_move,
    get,
    item,
    njit,
    put,
    store,
)
from upright.compiled.random import fill_normals
from upright.kernel import block as b
from upright.kernel.rows import (
    ACCELEROMETER,
    ADVANCE,
    AFTER,
    ALIKE,
    APPLIED_ROW,
    BEFORE,
    CALLED,
    COMMAND,
    COUNTED,
    COUNTS,
    DECIDE,
    DECIDED,
    DRIVE,
    DRIVEN,
    EVERY,
    EXCITATION,
    EXCITATION_COUNT,
    EXCITATION_HOLD,
    FALLEN_AT,
    FUSE,
    H_STEP,
    HELD,
    LOUD_BIAS,
    LOUD_NOISE,
    LOUD_WALK,
    MEASURE,
    NEVER,
    NOISE,
    PERIODS,
    PLAIN,
    PUSH_COUNT,
    PUSHES,
    RAMP_COUNT,
    RAMPS,
    READING,
    RING,
    S_BIAS,
    S_DELAY,
    S_DRIFT,
    S_EVERY,
    S_FUSED,
    S_IDEAL,
    S_KIND,
    S_LINE,
    S_LOUD,
    S_MEMORY,
    S_NORMAL,
    S_PACE,
    S_PLACES,
    S_READING,
    S_ROW,
    S_SENSED,
    S_SENSES,
    S_SPELL,
    S_STEP,
    S_VALUE,
    S_WALKS,
    SEED,
    SENSOR_COLUMNS,
    SENSORS,
    SETTLE,
    SLACK,
    SLACKEN,
    SLOPE,
    SLOTS,
    SPECIFIC_FORCE,
    STEP,
    STRIDE,
    SUBSTEPS,
    SWING,
    SWUNG,
    TRUTHS,
    TURN,
    UPDATE,
    WALK,
)


class Ahead(NamedTuple):
    """Steps of the next sample of a sensor, and of the next change of a push and of the slope."""

    sensed: int
    pushed: int
    tilted: int


@njit
def draw(block: RobotBlock, plan: Any, time: int, purpose: int, pair: int) -> None:
    """Normal numbers of body step `time` for sensors of the kinds 2 `pair` and 2 `pair` + 1, in their rows from NOISE
    on, or from WALK on."""
    out = (WALK if purpose == FOR_WALK else NOISE) + 2 * pair
    fill_normals(block, out, time, purpose + pair // 2, pair % 2, item(plan, SEED))


@njit
def sense_first(block: RobotBlock, plan: Any, sensors: Any) -> None:
    """Sensors of a robot that has been at rest: delay lines are full of the first reading; offsets are drawn."""
    w, count = block.w, block.robots
    if item(plan, ACCELEROMETER) != 0:
        call_on_block(item(plan, ACCELEROMETER), w, count, SPECIFIC_FORCE)
    for s in range(item(plan, SENSORS)):
        t = s * SENSOR_COLUMNS
        kind, row = item(sensors, t + S_KIND), item(sensors, t + S_ROW)
        b.sense(w, count, kind, row + S_SENSED)
        if item(sensors, t + S_SENSES) == SWUNG:
            call_program(item(plan, SETTLE), w, count, row, w)
        for k in range(item(sensors, t + S_PLACES)):
            b.copy(w, row + S_LINE + k, row + S_SENSED, count)
        if item(sensors, t + S_LOUD) & LOUD_BIAS:
            draw(block, plan, 0, FOR_BIAS, kind // 2)
            for i in range(count):
                put(w, row + S_DRIFT, i, get(w, row + S_BIAS, i) * get(w, NOISE + kind, i))


@njit
def sense_own(w: Any, count: int, plan: Any, sensors: Any, t: int) -> None:
    """What the sensor at `t` of the table senses after a step, where that is not only what its kind says."""
    kind, row, senses = item(sensors, t + S_KIND), item(sensors, t + S_ROW), item(sensors, t + S_SENSES)
    if senses == SLACK:
        b.sense(w, count, kind, row + S_MEMORY)
        call_program(item(plan, SLACKEN), w, count, row, w)
    elif senses == SWUNG:
        call_program(item(plan, SWING), w, count, row, w)
    else:
        for k in range(3):  # of which the angle is made, the three before it
            made_of = item(sensors, t + (k - 3) * SENSOR_COLUMNS + S_ROW)
            b.copy(w, row + S_FUSED + k, made_of + S_VALUE, count)
        b.direct(w, count, row + S_MEMORY, row + S_SENSED)
        call_program(item(plan, FUSE), w, count, row, w)


@njit
def read_one(block: RobotBlock, plan: Any, times: Any, sensors: Any, t: int, now: int, drawn: int) -> int:
    """The reading at step `now` of the sensor at `t` of the table. `drawn` says of which step and pair of kinds the
    rows of noise are, -1: of none; returns that for the next sensor."""
    w, count = block.w, block.robots
    spell = item(sensors, t + S_SPELL)
    before = now - (spell if spell > 0 else item(plan, STRIDE)) if now > 0 else -1
    kind, row, every = item(sensors, t + S_KIND), item(sensors, t + S_ROW), item(sensors, t + S_EVERY)
    sample = now // every
    if sample == before // every:
        return drawn
    loud = item(sensors, t + S_LOUD)
    pair = kind // 2
    if loud & LOUD_NOISE:
        if drawn != 4 * sample * every + pair:
            drawn = 4 * sample * every + pair
            draw(block, plan, sample * every, FOR_NOISE, pair)
        b.copy(w, row + S_NORMAL, NOISE + kind, count)
    if loud & LOUD_WALK:
        walks = item(sensors, t + S_WALKS)
        b.clear(w, row + S_STEP, count)
        for step in range(before // walks + 1, now // walks + 1):
            draw(block, plan, step * walks, FOR_WALK, pair)
            b.add(w, row + S_STEP, WALK + kind, count, (walks * item(times, STEP)) ** 0.5)
    b.copy(w, row + S_IDEAL, row + S_LINE + sample % item(sensors, t + S_PLACES), count)
    call_program(item(plan, MEASURE), w, count, row, w)
    b.copy(w, item(sensors, t + S_READING), row + S_VALUE, count)
    return drawn


@njit
def sense_all(block: RobotBlock, plan: Any, times: Any, sensors: Any, now: int) -> int:
    """At body step `now`: every sensor samples that is read at a period's start, or when an angle is made of it, which
    then happens; returns the next such step."""
    w, count = block.w, block.robots
    if item(plan, ACCELEROMETER) != 0 and now > 0:
        call_on_block(item(plan, ACCELEROMETER), w, count, SPECIFIC_FORCE)
    following = NEVER
    drawn = -1
    for s in range(item(plan, SENSORS)):
        t = s * SENSOR_COLUMNS
        kind, row, spell = item(sensors, t + S_KIND), item(sensors, t + S_ROW), item(sensors, t + S_SPELL)
        every, delay = item(sensors, t + S_EVERY), item(sensors, t + S_DELAY)
        stride = spell if spell > 0 else item(plan, STRIDE)
        fresh = now + delay
        sampled = fresh % every == 0 and -(-fresh // stride) * stride < fresh + every
        senses, pace = item(sensors, t + S_SENSES), item(sensors, t + S_PACE)
        if senses != PLAIN:
            if now > 0 and (now % pace == 0 if pace > 0 else sampled):
                sense_own(w, count, plan, sensors, t)
        elif sampled:
            b.sense(w, count, kind, row + S_SENSED)
        if sampled:
            b.copy(w, row + S_LINE + (fresh // every) % item(sensors, t + S_PLACES), row + S_SENSED, count)
        if spell > 0 and now % spell == 0:
            drawn = read_one(block, plan, times, sensors, t, now, drawn)
        fresh = (fresh // every + 1) * every
        while -(-fresh // stride) * stride >= fresh + every:
            fresh += every
        following = min(following, fresh - delay)
        if pace > 0:
            following = min(following, now + pace - now % pace)
    return following


@njit
def read(block: RobotBlock, plan: Any, times: Any, sensors: Any, k: int) -> None:
    """Rows `reading`: the readings at the start of period `k`; a sensor without a new sample holds its last reading."""
    now = k * item(plan, STRIDE)
    drawn = -1
    for s in range(item(plan, SENSORS)):
        t = s * SENSOR_COLUMNS
        if item(sensors, t + S_SPELL) == 0:
            drawn = read_one(block, plan, times, sensors, t, now, drawn)


@njit
def decide(block: RobotBlock, plan: Any, times: Any, constants: Any, k: int) -> int:
    """The command of period `k`, into the delay line; returns the last of its steps at which a command arrives."""
    w, count = block.w, block.robots
    if item(plan, RAMP_COUNT) > 0:
        t = k * item(plan, STRIDE) * item(times, STEP)
        b.refer(w, count, item(plan, RAMPS), item(plan, RAMP_COUNT), t)
    call_program(item(plan, DECIDE), w, count, item(plan, READING), constants)
    if item(plan, CALLED) != 0:
        call_on_block(item(plan, CALLED), w, count, k)
    row = k // item(plan, EXCITATION_HOLD)
    if row < item(plan, EXCITATION_COUNT):
        for side in range(2):
            b.copy(w, DECIDED + side, COMMAND + side, count)
            b.add(w, COMMAND + side, item(plan, EXCITATION) + 2 * row + side, count, 1.0)
    return send(block, plan, k)


@njit
def send(block: RobotBlock, plan: Any, k: int) -> int:
    """The command of period `k` through the drive into the delay line; returns as `decide`."""
    w = block.w
    count = block.robots
    call_program(item(plan, DRIVE), w, count, 0 * k, w)
    slots = item(plan, SLOTS)
    slot = item(plan, RING) + 2 * (k % slots) if slots else item(plan, APPLIED_ROW)
    b.copy(w, slot, DRIVEN + 0 * k, count)
    b.copy(w, slot + 1, DRIVEN + 1 + 0 * k, count)
    if slots == 0:
        return -1
    if item(plan, ALIKE):
        return b.arrive_alike(w, count, item(plan, RING), slots, k, item(plan, STRIDE))
    return b.arrive(block, item(plan, RING), slots, k, item(plan, STRIDE), item(plan, SEED))


@njit
def write(w: Any, count: int, final: Any, lived: Any, counted: Any, first: int) -> None:
    """The block's results."""
    for i in range(count):
        store(lived, first + i, get(w, LIVED, i))
        for j in range(6):
            store(final, (first + i) * 6 + j, get(w, PITCH + j, i))
        for j in range(COUNTED):
            store(counted, (first + i) * COUNTED + j, get(w, COUNTS + j, i))


@njit
def move(block: RobotBlock, plan: Any, times: Any, sensors: Any, begin: int, last: int, ahead: Ahead) -> Ahead:
    """The bodies' steps of the period that begins at step `begin`, whose last command arrives `last` steps later."""
    w, count = block.w, block.robots
    sensed, pushed, tilted = ahead.sensed, ahead.pushed, ahead.tilted
    substeps, h, fallen = item(plan, SUBSTEPS), item(times, H_STEP), item(times, FALLEN_AT)
    for s in range(item(plan, STRIDE)):
        now = begin + s
        if s > 0 and now >= sensed:
            sensed = sense_all(block, plan, times, sensors, now)
        if s <= last or (s == 0 and item(plan, SLOTS) > 0):
            b.hold(w, count, item(plan, APPLIED_ROW), float(s))
        if item(plan, APPLIED_ROW) != LEFT:
            call_program(item(plan, TURN), w, count, 0 * s, w)
        if now >= pushed:
            pushed = b.push(w, count, item(plan, PUSHES), item(plan, PUSH_COUNT), now)
        if now >= tilted:
            tilted = b.tilt(w, count, now)
        for r in range(substeps):
            call_to_move(item(plan, ADVANCE), w, count, fallen, (now * substeps + r + 1) * h)
    return Ahead(sensed, pushed, tilted)


def entry(
    w: Any, start: int, stop: int, plan: Any, times: Any, common: Any, rows: Any, table: Any, index: Any,
    truth: Any, sensors: Any, constants: Any, bands: Any, before: Any, after: Any,
    final: Any, lived: Any, counted: Any, trace: Any,
) -> None:  # fmt: skip
    """Robots from `start` to `stop` − 1, `LANES` at a time, in the working memory `w`; the last four are results.

    `plan` holds the fields of `Rows`, `Plan` and `Sizes`, `times` those of `Times`. `truth` (·, 2): row of a state and
    of its reading; `sensors` (·, SENSOR_COLUMNS); `constants` those of the controller's text.
    """
    stride, every = item(plan, STRIDE), item(plan, EVERY)
    step, h = item(times, STEP), item(times, H_STEP)
    end = (item(plan, PERIODS) + 1) * stride * step
    channels = item(plan, BEFORE) + item(plan, AFTER)
    size = item(plan, HELD) * channels
    for first in range(start, stop, LANES):
        count = min(LANES, stop - first)
        b.fill(w, count, plan, common, rows, table, first)
        block = RobotBlock(w, count, index, first)
        sense_first(block, plan, sensors)
        pushed = 0 if item(plan, PUSH_COUNT) > 0 else NEVER
        tilted = 0 if item(plan, SLOPE) else NEVER
        ahead = Ahead(0 if item(plan, SENSORS) > 0 else NEVER, pushed, tilted)
        for k in range(item(plan, PERIODS)):
            if b.standing(w, count) == 0:
                break
            begin = k * stride
            for r in range(item(plan, TRUTHS)):
                b.copy(w, item(truth, 2 * r + 1), item(truth, 2 * r), count)
            if begin >= ahead.sensed:
                ahead = Ahead(sense_all(block, plan, times, sensors, begin), ahead.pushed, ahead.tilted)
            read(block, plan, times, sensors, k)
            last = decide(block, plan, times, constants, k)
            b.count_period(w, count, bands, begin * step)
            kept = every > 0 and k % every == 0
            place = (first * item(plan, HELD) + k // every) * channels if kept else 0
            if kept:
                b.record(w, count, before, item(plan, BEFORE), b.Trace(trace, place, size), end)
            ahead = move(block, plan, times, sensors, begin, last, ahead)
            b.count_effort(w, count, item(plan, APPLIED_ROW))
            if kept:
                since = begin * step + h / 2
                place = place + item(plan, BEFORE)
                b.record(w, count, after, item(plan, AFTER), b.Trace(trace, place, size), since)
            if k // item(plan, EXCITATION_HOLD) < item(plan, EXCITATION_COUNT):
                for side in range(2):  # the controller remembers what itself has commanded
                    b.copy(w, COMMAND + side, DECIDED + side, count)
            if item(plan, UPDATE) != 0:
                call_program(item(plan, UPDATE), w, count, item(plan, READING), constants)
        write(w, count, final, lived, counted, first)
