"""The predictor in innovation form: one robot and its neighbours through a log, lane by lane.

Time here is that of the command: a sensor of delay d shows at t what the robot did at t − d. So every log is a
sequence of events, commands at t and readings at t − d, gone through in that order; between them the equations of
motion are integrated. Any delay is exact and fractional, clocks may be uneven, readings may be missing, and the
innovations are those of the log's own likelihood, since a command depends only on readings that come before it here
(Forssell and Ljung 1999). Readings are scalars, taken one after the other (Bierman 1977).
"""

from __future__ import annotations

import math
from functools import partial
from typing import Any, NamedTuple

import numba
import numpy as np

from upright.compiled.generated import (
    COULOMB_TORQUE,
    HALF_TRACK,
    LEFT,
    LEVER,
    MOTOR_DAMPING,
    MOTOR_TORQUE,
    PITCH,
    PITCH_INERTIA,
    PITCH_RATE,
    RIGHT,
    ROTOR_COUPLING,
    ROW,
    WHEEL_RATE,
    WORK,
    YAW_MOTOR_TORQUE,
    YAW_RATE,
    YAW_SWING,
    Constants,
)
from upright.compiled.generated_motion import accelerations_free, constants_free, rk4_free
from upright.compiled.jit import get, put

_compile: Any = numba.njit  # its stubs know fewer options than it has
njit: Any = partial(_compile, cache=True, nogil=True, error_model="numpy")
"""A compiled function, kept on disk, that lets other threads run and divides as IEEE says."""

inlined: Any = partial(_compile, error_model="numpy", forceinline=True, no_cpython_wrapper=True)
"""A function for other compiled functions, put into its callers and vectorised there across lanes."""

STATES = 6
MOVING = (PITCH, PITCH_RATE, WHEEL_RATE, YAW_RATE)
"""The states on which the motion depends: angles of wheel and yaw shift nothing on a level floor."""
RATES = (PITCH_RATE, WHEEL_RATE, YAW_RATE)

WIDE = 8
"""Lanes of the filter: the state and four neighbours; eight are moved faster than five."""

DRIVE_LEFT, DRIVE_RIGHT, DEAD_ZONE, SPAN, FRICTION, REVERSAL, STUCK, START, ROWS = (
    WORK + row for row in (0, 1, 2, 3, 4, 5, 6, 7, 7 + STATES)
)
"""Rows of a block after those of the kernel's, one number for each lane: factors of both motors and their dead zone;
the time to move [s]; dry friction as a command; negative where a wheel turned back; whether one has since the row was
cleared; the state before the step."""

SWEEPS = 20  # of Gauss and Seidel over both wheels, at most: each halves the error at least
PASSES = 3  # in which the response to friction, known to a few hundredths, is corrected, at most
SETTLED = 1e-10  # [rad/s] of a wheel, to which friction is solved for

TOPPLED = 3.0  # [rad] pitch beyond which a lane is lost: the sine is right to 1e-7 until there
INSTANT = 1e-12  # [s] events closer than this are one: nothing moves between them
_NUDGE = 1e-6  # a step in the state to differentiate the flow: error and rounding both near 1e-9


class Events(NamedTuple):
    """The n events of a log. Of a reading `kind` is its sensor's row, of a command −1; `when` [s] is the log's time;
    `value` is the reading, or which of the `commands` (c, 2). `order` lists those to go through, in the command's time.
    """

    order: Any
    kind: Any
    when: Any
    value: Any
    commands: Any


class Lanes(NamedTuple):
    """Robots that go through the same events: how each sensor row `reads` the state (rows, states, lanes), the `delays`
    of the rows (rows, lanes) [s], and the `robots` (constants and 3, lanes): the named constants of the equations, the
    factors of both motors and the dead zone."""

    reads: Any
    delays: Any
    robots: Any


class Noise(NamedTuple):
    """Covariance of the first state `start` (s, s); of the process noise a second, `process` (2, s, s): while both
    wheels move, and while one sticks or turns back; variance of the moments at which commands arrive, `jitter` [s²];
    variance of each sensor row, `readings` (rows,)."""

    start: Any
    process: Any
    jitter: Any
    readings: Any


class _Flow(NamedTuple):
    """Room for the flow of one robot: its block, times of start and stop (2, WIDE), ∂x(stop)/∂x(start) (6, 6), and
    what the product of two matrices needs (6, s)."""

    block: Any
    times: Any
    phi: Any
    product: Any


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
    mean, turn = x[3] - x[1], half * x[5]
    return mean - turn, mean + turn


@inlined
def _stepped(w: Any, i: Any, x: Any, d: Any, left: Any, right: Any) -> Any:
    """The state x of lane i one step of d [s] on, under the friction `left` and `right` of its wheels, as commands."""
    new = rk4_free(*x, d, get(w, LEFT, i) - left, get(w, RIGHT, i) - right, *constants_free(w, i))
    return (new[0] if abs(new[0]) < TOPPLED else np.nan, new[1], new[2], new[3], new[4], new[5])


@njit
def _advance(w: Any, count: Any, steps: Any) -> None:
    """One step of span/steps [s] for the first `count` lanes of the block `w`: each wheel's dry friction against its
    motion, and where that would turn it back within the step, what it really gives."""
    for i in range(count):
        d, half, dry = get(w, SPAN, i) / steps, get(w, HALF_TRACK, i), get(w, FRICTION, i)
        x = _state(w, PITCH, i)
        before_left, before_right = _wheel_rates(x, half)
        left = dry if before_left >= 0 else -dry
        right = dry if before_right >= 0 else -dry
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
    first, free = abs(first), sign * free
    last = free - own * dry
    if last < 0:
        left = last / (last - first)
        last = min(0.0, left * (free - first + own * dry))
    return sign * (free - last) / own


@njit
def _stop(w: Any, i: Any, d: Any) -> None:
    """The step of lane i again, in which a wheel stops: friction is such that it sticks or turns back."""
    half, dry = get(w, HALF_TRACK, i), get(w, FRICTION, i)
    start = _state(w, START, i)
    first_left, first_right = _wheel_rates(start, half)
    left, right = dry if first_left >= 0 else -dry, dry if first_right >= 0 else -dry
    own, other = _responses(w, i, d)
    for _ in range(PASSES):
        last_left, last_right = _wheel_rates(_state(w, PITCH, i), half)
        free_left = last_left + own * left + other * right
        free_right = last_right + own * right + other * left
        before_left, before_right = left, right
        for _ in range(SWEEPS):
            before = left
            left = _mean_friction(first_left, free_left - other * right, own, dry)
            right = _mean_friction(first_right, free_right - other * left, own, dry)
            if abs(left - before) * own < SETTLED:
                break
        if (abs(left - before_left) + abs(right - before_right)) * own < SETTLED:
            break
        _put_state(w, PITCH, i, _stepped(w, i, start, d, left, right))


@inlined
def _beyond(command: Any, zone: Any) -> Any:
    """What a dead zone leaves of a command: nothing inside, all of it outside, and between 0.9 and 1.1 of the zone a
    straight line from one to the other, so that its size can be estimated."""
    return command * min(1.0, max(0.0, 5 * abs(command) / max(zone, 1e-9) - 4.5))


@inlined
def _drives(w: Any, i: Any, u: Any) -> Any:
    """What reaches both motors of lane i of the command u (2,)."""
    zone = get(w, DEAD_ZONE, i)
    return get(w, DRIVE_LEFT, i) * _beyond(u[0], zone), get(w, DRIVE_RIGHT, i) * _beyond(u[1], zone)


@njit
def _move(w: Any, count: Any, u: Any, start: Any, stop: Any, longest: Any) -> None:
    """Each lane from its `start` to its `stop` [s], in as many steps as the longest span needs."""
    span = 0.0
    for i in range(count):
        put(w, SPAN, i, stop[i] - start[i])
        span = max(span, abs(stop[i] - start[i]))
        start[i] = stop[i]
    if span >= INSTANT:
        for i in range(count):
            left, right = _drives(w, i, u)
            put(w, LEFT, i, left)
            put(w, RIGHT, i, right)
        steps = max(1, math.ceil(span / longest))
        for _ in range(steps):
            _advance(w, count, steps)


_FIRST, _CONSTANTS = HALF_TRACK, len(Constants._fields)


@njit
def _block(robots: Any) -> Any:
    """The block of lanes of these robots (constants and 3, lanes), their states zero."""
    w = np.zeros(ROWS * ROW)
    for i in range(robots.shape[1]):
        for j in range(_CONSTANTS):
            put(w, _FIRST + j, i, robots[j, i])
        for j in range(3):
            put(w, DRIVE_LEFT + j, i, robots[_CONSTANTS + j, i])
        put(w, FRICTION, i, max(0.0, get(w, COULOMB_TORQUE, i) / get(w, MOTOR_TORQUE, i)))
    return w


@njit
def _errors(w: Any, offsets: Any, C: Any, value: Any, error: Any) -> None:
    """Each lane's `error` (lanes,): the reading `value` less what C (states, lanes) reads of its state."""
    for i in range(len(error)):
        error[i] = value
    for j in range(STATES):
        for i in range(len(error)):
            error[i] -= C[j, i] * get(w, PITCH + j, i)
    for j in range(len(offsets)):
        for i in range(len(error)):
            error[i] -= C[STATES + j, i] * offsets[j, i]


@njit
def _shift(w: Any, offsets: Any, gain: Any, error: Any) -> None:
    """Each lane's state corrected by the `gain` (states,) times its `error` (lanes,)."""
    for j in range(STATES):
        for i in range(len(error)):
            put(w, PITCH + j, i, get(w, PITCH + j, i) + gain[j] * error[i])
    for j in range(len(offsets)):
        for i in range(len(error)):
            offsets[j, i] += gain[STATES + j] * error[i]


@njit
def innovations(events: Events, lanes: Lanes, first: Any, gains: Any, longest: Any) -> Any:
    """Innovations (events, lanes) of lanes from their `first` states (states, lanes), all corrected by the same `gains`
    (events, states), in Runge–Kutta steps of at most `longest` [s]; NaN for a lane that toppled and for commands."""
    count = first.shape[1]
    w, offsets, u = _block(lanes.robots), first[STATES:].copy(), events.commands[0].copy()
    for i in range(count):
        for j in range(STATES):
            put(w, PITCH + j, i, first[j, i])
    now, then, error = np.zeros(count), np.zeros(count), np.zeros(count)
    result = np.full((len(events.kind), count), np.nan)
    for place in range(len(events.order)):
        event = events.order[place]
        row = events.kind[event]
        for i in range(count):
            then[i] = events.when[event] - (lanes.delays[row, i] if row >= 0 else 0.0)
        if place == 0:
            now[:] = then
        _move(w, count, u, now, then, longest)
        if row < 0:
            u[:] = events.commands[int(events.value[event])]
            continue
        _errors(w, offsets, lanes.reads[row], events.value[event], error)
        _shift(w, offsets, gains[event], error)
        result[event] = error
    return result


@njit
def _flow(room: _Flow, x: Any, u: Any, start: Any, stop: Any, longest: Any) -> None:
    """Moves x from `start` to `stop` [s] and writes ∂x(stop)/∂x(start) of the six states into `room.phi`."""
    w, phi = room.block, room.phi
    for i in range(WIDE):
        room.times[0, i], room.times[1, i] = start, stop
        for j in range(STATES):
            put(w, PITCH + j, i, x[j])
    for i in range(len(MOVING)):
        put(w, MOVING[i], 1 + i, get(w, MOVING[i], 1 + i) + _NUDGE)
    put(w, STUCK, 0, 0.0)
    _move(w, WIDE, u, room.times[0], room.times[1], longest)
    for j in range(STATES):
        x[j] = get(w, PITCH + j, 0)
        for i in range(len(MOVING)):
            phi[j, MOVING[i]] = (get(w, PITCH + j, 1 + i) - x[j]) / _NUDGE
        phi[j, 2] = 1.0 if j == 2 else 0.0
        phi[j, 4] = 1.0 if j == 4 else 0.0


@njit
def _predict(P: Any, phi: Any, Q: Any, h: Any, product: Any) -> None:
    """P ← Φ P Φᵀ + Q h, for Φ that is the identity beyond the six states."""
    size = P.shape[0]
    for i in range(STATES):
        for j in range(size):
            total = 0.0
            for k in range(STATES):
                total += phi[i, k] * P[k, j]
            product[i, j] = total
    for i in range(STATES):
        for j in range(i, size):
            total = product[i, j]
            if j < STATES:
                total = 0.0
                for k in range(STATES):
                    total += product[i, k] * phi[j, k]
            P[i, j] = total
            P[j, i] = total
    for i in range(size):
        for j in range(size):
            P[i, j] += Q[i, j] * h


@njit
def _correct(x: Any, P: Any, C: Any, error: Any, variance: Any, gain: Any) -> Any:
    """State and covariance with a scalar reading C x of this noise `variance`, which is off by `error` from zero state;
    fills `gain` and returns innovation and its variance."""
    size = len(x)
    for i in range(size):
        gain[i] = 0.0
        for j in range(size):
            gain[i] += P[i, j] * C[j]
        error -= C[i] * x[i]
    for i in range(size):
        variance += C[i] * gain[i]
    for i in range(size):
        for j in range(size):
            P[i, j] -= gain[i] * gain[j] / variance
    for i in range(size):
        gain[i] /= variance
        x[i] += gain[i] * error
    return error, variance


@njit
def _response_to_delay(w: Any, x: Any, old: Any, new: Any) -> Any:
    """By how much ψ̇, θ̇ and φ̇ lag for each second that the command `new` arrives late after `old`."""
    constants = constants_free(w, 0)
    before = accelerations_free(x[0], x[1], x[3], x[5], *_drives(w, 0, old), *constants)
    after = accelerations_free(x[0], x[1], x[3], x[5], *_drives(w, 0, new), *constants)
    return after[0] - before[0], after[1] - before[1], after[2] - before[2]


@njit
def kalman_path(events: Events, lanes: Lanes, first: Any, noise: Noise, longest: Any, keep: bool) -> Any:
    """The extended Kalman filter along one log, from the state `first` (s,), in steps of at most `longest` [s].

    `lanes` holds the one robot `WIDE` times. Returns innovations (events,), their variances (events,), gains (events,
    s) and, with `keep`, the state after each event (events, s), else none; NaN, or zero, from where it toppled.
    """
    size, many = len(first), len(events.kind)
    x, P, u = first.copy(), noise.start.copy(), events.commands[0].copy()
    w = _block(lanes.robots)
    room = _Flow(w, np.zeros((2, WIDE)), np.zeros((STATES, STATES)), np.zeros((STATES, size)))
    e, s, gains = np.full(many, np.nan), np.full(many, np.nan), np.zeros((many, size))
    states = np.zeros((many if keep else 0, size))
    now = -np.inf
    for event in events.order:
        row = events.kind[event]
        then = events.when[event] - (lanes.delays[row, 0] if row >= 0 else 0.0)
        now = max(now, then) if now == -np.inf else now
        if then - now > INSTANT:
            _flow(room, x, u, now, then, longest)
            _predict(P, room.phi, noise.process[int(get(w, STUCK, 0))], then - now, room.product)
            now = then
        if not abs(x[0]) < TOPPLED:
            break
        if row < 0:
            new = events.commands[int(events.value[event])]
            lag = _response_to_delay(w, x, u, new)
            u[:] = new
            for i in range(len(RATES)):
                for j in range(len(RATES)):
                    P[RATES[i], RATES[j]] += noise.jitter * lag[i] * lag[j]
        else:
            C = lanes.reads[row, :, 0]
            e[event], s[event] = _correct(x, P, C, events.value[event], noise.readings[row], gains[event])
        if keep:
            states[event] = x
    return e, s, gains, states
