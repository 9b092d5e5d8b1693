"""The loop over time for one block of robots after another: the compiled counterpart of `experiment.run`."""

from __future__ import annotations

from typing import Any

import numpy as np

from upright.fleet import kernel_block as b
from upright.fleet.generated import LANES, LEFT, LIVED, PITCH, ROW
from upright.fleet.kernel_jit import call_on_block, call_to_move, carray, merged, njit
from upright.fleet.kernel_rows import (
    COMMAND,
    COUNTED,
    COUNTS,
    DRIVEN,
    FELT,
    NEVER,
    NOISE,
    S_BIAS,
    S_EVERY,
    S_KIND,
    S_LATE,
    S_LINE,
    S_LOUD,
    S_OFFSET,
    S_PLACES,
    S_READING,
    S_ROW,
    S_SAID,
    S_SLACK,
    S_TOUCH,
    S_WHEEL,
    SENSOR_COLUMNS,
    Plan,
    Rows,
)
from upright.fleet.random import fill_normals


@njit
def sense_first(w: Any, count: int, plan: Plan, sensors: Any, index: Any, first: int) -> None:
    """Sensors at rest since ever: what is on its way is the first reading; offsets are drawn."""
    if plan.feel != 0:
        call_on_block(plan.feel, w, count, FELT)
    for s in range(len(sensors)):
        kind, row = sensors[s, S_KIND], sensors[s, S_ROW]
        b.sense(w, count, kind, row + S_TOUCH)
        for k in range(sensors[s, S_PLACES]):
            b.copy(w, row + S_LINE + k, row + S_TOUCH, count)
        if sensors[s, S_LOUD]:
            fill_normals(w, NOISE, count, index, first, 0 * s, 4 + kind // 4, plan.seed)
            for i in range(count):
                w[(row + S_OFFSET) * ROW + i] = w[(row + S_BIAS) * ROW + i] * w[(NOISE + kind % 4) * ROW + i]


@njit
def sense_all(w: Any, count: int, plan: Plan, sensors: Any, now: int) -> None:
    """At body step `now`: every sensor takes in what will be read at some period's start."""
    if plan.feel != 0 and now > 0:
        call_on_block(plan.feel, w, count, FELT)
    for s in range(len(sensors)):
        kind, row, every = sensors[s, S_KIND], sensors[s, S_ROW], sensors[s, S_EVERY]
        fresh = now + sensors[s, S_LATE]
        wanted = fresh % every == 0 and -(-fresh // plan.stride) * plan.stride < fresh + every
        if sensors[s, S_SLACK] and now > 0:
            b.sense(w, count, kind, row + S_WHEEL)
            b.slacken(w, count, row)
        elif wanted:
            b.sense(w, count, kind, row + S_TOUCH)
        if wanted:
            b.copy(w, row + S_LINE + (fresh // every) % sensors[s, S_PLACES], row + S_TOUCH, count)


@njit
def read(w: Any, count: int, plan: Plan, sensors: Any, index: Any, first: int, k: int) -> None:
    """Rows `at.reading`: what the sensors say at the start of period `k`; one without a fresh value holds its last."""
    now, drawn = k * plan.stride, -1
    for s in range(len(sensors)):
        kind, row, every = sensors[s, S_KIND], sensors[s, S_ROW], sensors[s, S_EVERY]
        if k > 0 and now // every == (now - plan.stride) // every:
            continue
        if sensors[s, S_LOUD] and drawn != kind // 4:
            drawn = kind // 4
            fill_normals(w, NOISE, count, index, first, k, drawn, plan.seed)
            fill_normals(w, NOISE + 4, count, index, first, k, 2 + drawn, plan.seed)
        passed = max(every, plan.stride) if k > 0 else every
        value = row + S_LINE + (now // every) % sensors[s, S_PLACES]
        b.corrupt(w, count, value, row, NOISE + kind % 4, (passed * plan.step) ** 0.5)
        b.copy(w, sensors[s, S_READING], row + S_SAID, count)


@njit
def decide(w: Any, count: int, at: Rows, plan: Plan, gains: Any, index: Any, first: int, k: int) -> int:
    """The command of period `k`, on its way to the motors; returns the last step of the period at which one arrives."""
    if at.ramp_count > 0:
        b.refer(w, count, at.ramps, at.ramp_count, k * plan.stride * plan.step)
    b.apply_gains(w, count, COMMAND + 0 * k, DRIVEN + 0 * k, gains, plan.own_gains)
    b.drive(w, count)
    slot = at.ring + 2 * (k % at.slots) if at.slots else LEFT
    b.copy(w, slot, DRIVEN + 0 * k, count)
    b.copy(w, slot + 1, DRIVEN + 1 + 0 * k, count)
    if at.slots == 0:
        return -1
    if plan.alike:
        return b.arrive_alike(w, count, at.ring, at.slots, k, plan.stride)
    return b.arrive(w, count, at.ring, at.slots, k, plan.stride, index, first, plan.seed)


@njit
def run_period(
    w: Any, count: int, at: Rows, plan: Plan, sensors: Any, last: int, pushed: int, tilted: int, k: int
) -> tuple[int, int]:
    """The bodies' steps of period `k`, whose last command arrives at step `last`; says when push and floor change."""
    for s in range(plan.stride):
        now = k * plan.stride + s
        if s > 0 and len(sensors) > 0:
            sense_all(w, count, plan, sensors, now)
        if s <= last or (s == 0 and at.slots > 0):
            b.hold(w, count, float(s))
        if now >= pushed:
            pushed = b.push(w, count, at.pushes, at.push_count, now)
        if now >= tilted:
            tilted = b.tilt(w, count, now)
        for r in range(plan.substeps):
            t = (now * plan.substeps + r + 1) * plan.h
            call_to_move(plan.advance, w, count, plan.fallen, t)
    return pushed, tilted


@merged
def run_blocks(
    w: Any, start: int, stop: int, at: Rows, plan: Plan, common: Any, rows: Any, table: Any, index: Any,
    truth: Any, sensors: Any, command: Any, memory: Any, bands: Any, before: Any, after: Any,
    final: Any, lived: Any, counted: Any, trace: Any,
) -> None:  # fmt: skip
    """Robots from `start` to before `stop`, `LANES` at a time, in the working memory `w`; results in the last four.

    `truth` (·, 2): row of a state and of its reading; `sensors` (·, 8): kind, delay and period [steps], first row,
    places in the delay line, row of the reading, whether it has play and noise; `command` and `memory`: see
    `b.apply_gains`.
    """
    end = (plan.periods + 1) * plan.stride * plan.step
    for first in range(start, stop, LANES):
        count = min(LANES, stop - first)
        b.fill(w, count, common, rows, table, first)
        sense_first(w, count, plan, sensors, index, first)
        pushed, tilted = 0 if at.push_count > 0 else NEVER, 0 if plan.slope else NEVER
        for k in range(plan.periods):
            if b.standing(w, count) == 0:
                break
            t = k * plan.stride * plan.step
            for r in range(len(truth)):
                b.copy(w, truth[r, 1], truth[r, 0], count)
            if len(sensors) > 0:
                sense_all(w, count, plan, sensors, k * plan.stride)
                read(w, count, plan, sensors, index, first, k)
            last = decide(w, count, at, plan, command, index, first, k)
            b.count_period(w, count, bands, t)
            kept = plan.every > 0 and k % plan.every == 0
            if kept:
                b.record(w, count, before, trace, first, k // plan.every, 0 * k, end)
            pushed, tilted = run_period(w, count, at, plan, sensors, last, pushed, tilted, k)
            b.count_effort(w, count)
            if kept:
                b.record(w, count, after, trace, first, k // plan.every, len(before), t + plan.h / 2)
            if at.memory_count > 0:
                after_row = at.memory + at.memory_count
                b.apply_gains(w, count, after_row, after_row + at.memory_count, memory, plan.own_gains)
                for j in range(at.memory_count):
                    b.copy(w, at.memory + j, after_row + j, count)
        for i in range(count):
            lived[first + i] = w[LIVED * ROW + i]
            for j in range(6):
                final[first + i, j] = w[(PITCH + j) * ROW + i]
            for j in range(COUNTED):
                counted[first + i, j] = w[(COUNTS + j) * ROW + i]


def entry(
    w: Any, start: int, stop: int, numbers: Any, times: Any, common: Any, rows: Any, table: Any, index: Any,
    truth: Any, sensors: Any, command: Any, memory: Any, bands: Any, before: Any, after: Any,
    final: Any, lived: Any, counted: Any, trace: Any,
) -> None:  # fmt: skip
    """`run_blocks` as the machine calls it: plain addresses. `numbers` holds the fields of `Rows`, those of `Plan` down
    to `seed` and the sizes of what follows; `times` the rest of `Plan`."""
    a, f = carray(numbers, 64), carray(times, 3)
    at = Rows(a[0], a[1], a[2], a[3], a[4], a[5], a[6], a[7], a[8])
    plan = Plan(a[9], a[10], a[11], a[12], a[13], a[14], a[15], a[16], a[17], np.uint64(a[18]), f[0], f[1], f[2])
    n, size, own, held = a[19], a[20], a[21], a[22]
    run_blocks(
        carray(w, size * ROW), start, stop, at, plan, carray(common, size), carray(rows, own), carray(table, (n, own)),
        carray(index, n), carray(truth, (a[23], 2)), carray(sensors, (a[24], SENSOR_COLUMNS)),
        carray(command, (a[25], 3)),
        carray(memory, (a[26], 3)), carray(bands, 3), carray(before, a[27]), carray(after, a[28]),
        carray(final, (n, 6)), carray(lived, n), carray(counted, (n, COUNTED)),
        carray(trace, (n, held, a[27] + a[28])),
    )  # fmt: skip
