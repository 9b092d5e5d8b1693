"""Robots moved side by side, one in each lane of a block, with sharp dry friction between body and wheels.

A block is that of the fleet's kernel, with rows of its own after the kernel's. On a level floor that pushes nothing the
generated step moves all lanes; where a wheel would turn back within it, the step is taken again with the friction that
holds the wheel. Rolling friction against the floor is smooth, as in the equations, and held over a step.
"""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numpy as np

from upright.calibration.kept import njit
from upright.compiled.electronics import recorded
from upright.compiled.generated import (
    COULOMB_TORQUE,
    HALF_TRACK,
    LEFT,
    LEVER,
    MOTOR_DAMPING,
    MOTOR_TORQUE,
    PITCH,
    PITCH_INERTIA,
    RIGHT,
    ROLLING_TORQUE,
    ROTOR_COUPLING,
    ROW,
    STICTION_RATE_SQUARED,
    WORK,
    YAW_MOTOR_TORQUE,
    YAW_SWING,
    Constants,
)
from upright.compiled.generated_motion import accelerations_free, constants_free, rk4_free
from upright.compiled.jit import get, numba, put
from upright.compiled.tracer import FormulaTracer
from upright.physics.electronics import awake, dropped, turned

inlined: Any = partial(numba.njit, error_model="numpy", forceinline=True, no_cpython_wrapper=True)
"""A function for other compiled functions, put into its callers and vectorised there across lanes."""

STATES = 6


DRIVE_LEFT, DRIVE_RIGHT, DEAD_ZONE, CONSTANT, DROP = range(WORK, WORK + 5)
DRIVES = 5
"""How many numbers of what drives a robot stand behind its constants."""
SPAN, DRY_LEFT, DRY_RIGHT, REVERSAL, STUCK, ROLL_LEFT, ROLL_RIGHT, START = range(WORK + 5, WORK + 13)
ROWS = START + STATES
"""Rows of a block after those of the kernel's, one number for each lane: factors of both motors, their dead zone, what
is added to both commands, and their drop; the time to move [s]; each wheel's dry friction as a command; negative where
a wheel turned back; whether one has since the row was cleared; the smoothed signs of rolling friction; the state before
the step."""

SWEEPS = 20  # of Gauss and Seidel over both wheels, at most, from where both would stand still
PASSES = 3  # in which the response to friction, known to a few hundredths, is corrected, at most
SETTLED = 1e-10  # [rad/s] of a wheel, to which friction is solved for

TOPPLED = 3.0  # [rad] pitch beyond which a lane is lost: the sine is right to 1e-7 until there
INSTANT = 1e-12  # [s] events closer than this are one: nothing moves between them


@inlined
def _state(w: Any, row: Any, i: Any) -> Any:
    """The six numbers of lane i from `row` on."""
    return (
        get(w, row, i), get(w, row + 1, i), get(w, row + 2, i),
        get(w, row + 3, i), get(w, row + 4, i), get(w, row + 5, i),
    )  # fmt: skip


@inlined
def _put_state(w: Any, row: Any, i: Any, x: Any) -> None:
    put(w, row, i, x[0])
    put(w, row + 1, i, x[1])
    put(w, row + 2, i, x[2])
    put(w, row + 3, i, x[3])
    put(w, row + 4, i, x[4])
    put(w, row + 5, i, x[5])


@inlined
def _wheel_rates(x: Any, half: Any) -> Any:
    """Rates of both wheels relative to the body [rad/s] at the state x, for W/(2R) = `half`."""
    mean = x[3] - x[1]
    turn = half * x[5]
    return mean - turn, mean + turn


@inlined
def _stepped(w: Any, i: Any, x: Any, d: Any, left: Any, right: Any) -> Any:
    """The state x of lane i one step of d [s] on, under the friction `left` and `right` of its wheels, as commands."""
    new = rk4_free(
        *x, d, get(w, LEFT, i) - left, get(w, RIGHT, i) - right, get(w, ROLL_LEFT, i), get(w, ROLL_RIGHT, i),
        *constants_free(w, i),
    )  # fmt: skip
    return (new[0] if abs(new[0]) < TOPPLED else np.nan, new[1], new[2], new[3], new[4], new[5])


@inlined
def _signs(left: Any, right: Any, smooth: Any) -> Any:
    """ω / √(ω² + ω_c²) of two rates ω [rad/s], for `smooth` = ω_c²."""
    return left / math.sqrt(left * left + smooth), right / math.sqrt(right * right + smooth)


@njit
def _roll(w: Any, count: Any, steps: Any) -> None:
    """The signs of rolling friction in the middle of the step of span/steps [s] that begins.

    The rates there are foreseen with smooth friction in the motors: that of a wheel that sticks may have either sign.
    """
    for i in range(count):
        x, smooth = _state(w, PITCH, i), get(w, STICTION_RATE_SQUARED, i)
        turn = get(w, HALF_TRACK, i)
        slip_left, slip_right = _signs(*_wheel_rates(x, turn), smooth)
        roll_left, roll_right = _signs(x[3] - turn * x[5], x[3] + turn * x[5], smooth)
        _, wheel_acc, yaw_acc = accelerations_free(
            x[0], x[1], x[3], x[5], get(w, LEFT, i) - get(w, DRY_LEFT, i) * slip_left,
            get(w, RIGHT, i) - get(w, DRY_RIGHT, i) * slip_right, roll_left, roll_right, *constants_free(w, i),
        )  # fmt: skip
        half = get(w, SPAN, i) / steps / 2
        mean = x[3] + half * wheel_acc
        turning = turn * (x[5] + half * yaw_acc)
        left, right = _signs(mean - turning, mean + turning, smooth)
        put(w, ROLL_LEFT, i, left)
        put(w, ROLL_RIGHT, i, right)


@njit
def _advance(w: Any, count: Any, steps: Any) -> None:
    """One step of span/steps [s] for the first `count` lanes of the block `w`: each wheel's dry friction against its
    motion, and where that would turn it back within the step, what it really gives."""
    for i in range(count):
        d = get(w, SPAN, i) / steps
        half = get(w, HALF_TRACK, i)
        x = _state(w, PITCH, i)
        before_left, before_right = _wheel_rates(x, half)
        dry_left, dry_right = get(w, DRY_LEFT, i), get(w, DRY_RIGHT, i)
        left = dry_left if before_left >= 0 else -dry_left
        right = dry_right if before_right >= 0 else -dry_right
        new = _stepped(w, i, x, d, left, right)
        after_left, after_right = _wheel_rates(new, half)
        put(w, REVERSAL, i, min(left * after_left, right * after_right))
        _put_state(w, START, i, x)
        _put_state(w, PITCH, i, new)
    for i in range(count):
        if get(w, REVERSAL, i) < 0:
            _stop(w, i, get(w, SPAN, i) / steps)
            put(w, STUCK, i, 1.0)


@njit
def _responses(w: Any, i: Any, d: Any) -> Any:
    """By how much a unit of command over d [s] changes the wheels' rate relative to the body: its own and the other's.

    From the accelerations' response to equal and to opposite commands, each with the motors' damping over the step.
    """
    sine = math.sin(get(w, START, i))
    a12 = get(w, LEVER, i) * math.sqrt(1 - sine * sine) - get(w, ROTOR_COUPLING, i)
    a22, volt = get(w, PITCH_INERTIA, i), get(w, MOTOR_TORQUE, i)
    mean = 2 * volt * (1 + 2 * a12 + a22) / (a22 - a12 * a12)
    turn = 2 * get(w, YAW_MOTOR_TORQUE, i) * get(w, HALF_TRACK, i) / (1 + get(w, YAW_SWING, i) * sine * sine)
    loss = d * get(w, MOTOR_DAMPING, i) / (2 * volt)
    mean *= d / (1 + mean * loss * (0.5 + mean * loss / 12))
    turn *= d / (1 + turn * loss * (0.5 + turn * loss / 12))
    return (mean + turn) / 2, (mean - turn) / 2


@njit
def _mean_friction(first: Any, free: Any, own: Any, dry: Any) -> Any:
    """Mean dry friction of a wheel over a step, from its first rate and its last rate without friction.

    The rate is taken for straight: up to the moment at which it vanishes friction is full; from there the wheel sticks,
    or turns back if friction cannot hold it.
    """
    sign = 1.0 if first >= 0 else -1.0
    first = abs(first)
    free = sign * free
    last = free - own * dry
    if last < 0:
        left = last / (last - first)
        last = min(0.0, left * (free - first + own * dry))
    return sign * (free - last) / own


@inlined
def _both_held(free_left: Any, free_right: Any, own: Any, other: Any, dry_left: Any, dry_right: Any) -> Any:
    """The friction that brings both wheels to rest at the end of a step, or as much of it as there is."""
    whole = own * own - other * other
    left, right = (own * free_left - other * free_right) / whole, (own * free_right - other * free_left) / whole
    return max(-dry_left, min(dry_left, left)), max(-dry_right, min(dry_right, right))


@njit
def _stop(w: Any, i: Any, d: Any) -> None:
    """The step of lane i again, in which a wheel stops: friction is such that it sticks or turns back."""
    half, dry_left, dry_right = get(w, HALF_TRACK, i), get(w, DRY_LEFT, i), get(w, DRY_RIGHT, i)
    start = _state(w, START, i)
    first_left, first_right = _wheel_rates(start, half)
    left, right = dry_left if first_left >= 0 else -dry_left, dry_right if first_right >= 0 else -dry_right
    own, other = _responses(w, i, d)
    for _ in range(PASSES):
        last_left, last_right = _wheel_rates(_state(w, PITCH, i), half)
        free_left = last_left + own * left + other * right
        free_right = last_right + own * right + other * left
        before_left, before_right = left, right
        left, right = _both_held(free_left, free_right, own, other, dry_left, dry_right)
        for _ in range(SWEEPS):
            before = left, right
            left = _mean_friction(first_left, free_left - other * right, own, dry_left)
            right = _mean_friction(first_right, free_right - other * left, own, dry_right)
            if (abs(left - before[0]) + abs(right - before[1])) * own < SETTLED:
                break
        if (abs(left - before_left) + abs(right - before_right)) * own < SETTLED:
            break
        _put_state(w, PITCH, i, _stepped(w, i, start, d, left, right))


def _given(t: FormulaTracer, v: Any) -> dict[str, Any]:
    """What a driver without limit and steps leaves of both commands, and what the motors make of it."""
    left, right = turned([dropped(awake(u, v, t), v.drop, t) for u in (v.command_left, v.command_right)], v)
    return {"left": left + v.added, "right": right + v.added}


_give = inlined(recorded("give", "command_left command_right dead_zone drop left right added", _given).function())


@inlined
def driven(w: Any, i: Any, u: Any) -> Any:
    """What reaches both motors of lane i of the command u (2,)."""
    drives = get(w, DRIVE_LEFT, i), get(w, DRIVE_RIGHT, i)
    return _give(u[0], u[1], get(w, DEAD_ZONE, i), get(w, DROP, i), *drives, get(w, CONSTANT, i))


@njit
def begun(w: Any, count: Any, u: Any, start: Any, stop: Any, longest: Any) -> Any:
    """Each lane's motors on the command u (2,) from its `start` to its `stop` [s]; in how many steps, and whether any
    lane has rolling friction."""
    span, rolls = 0.0, False
    for i in range(count):
        put(w, SPAN, i, stop[i] - start[i])
        span = max(span, abs(stop[i] - start[i]))
        start[i] = stop[i]
    if span < INSTANT:
        return 0, rolls
    for i in range(count):
        left, right = driven(w, i, u)
        put(w, LEFT, i, left)
        put(w, RIGHT, i, right)
        rolls |= get(w, ROLLING_TORQUE, i) > 0
    return max(1, math.ceil(span / longest)), rolls


@njit
def step(w: Any, count: Any, steps: Any, rolls: Any) -> None:
    """One of so many `steps` of what has `begun`; `START` has the states before it."""
    if rolls:
        _roll(w, count, steps)
    _advance(w, count, steps)


@njit
def move(w: Any, count: Any, u: Any, start: Any, stop: Any, longest: Any) -> None:
    """Each lane from its `start` to its `stop` [s], in as many steps as the longest span needs."""
    steps, rolls = begun(w, count, u, start, stop, longest)
    for _ in range(steps):
        step(w, count, steps, rolls)


_FIRST = HALF_TRACK
_CONSTANTS = len(Constants._fields)


@njit
def block_of(robots: Any) -> Any:
    """The block of lanes of these robots (constants and 5, lanes), their states zero."""
    w = np.zeros(ROWS * ROW)
    for i in range(robots.shape[1]):
        for j in range(_CONSTANTS):
            put(w, _FIRST + j, i, robots[j, i])
        for j in range(DRIVES):
            put(w, DRIVE_LEFT + j, i, robots[_CONSTANTS + j, i])
        dry = max(0.0, get(w, COULOMB_TORQUE, i) / get(w, MOTOR_TORQUE, i))
        put(w, DRY_LEFT, i, dry)
        put(w, DRY_RIGHT, i, dry)
    return w
