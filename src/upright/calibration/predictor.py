"""The predictor in innovation form: one robot and its neighbours through a log, lane by lane.

Time here is that of the command: a sensor of delay d shows at t what the robot did at t − d. So every log is a
sequence of events, commands at t and readings at t − d, gone through in that order; between them the equations of
motion are integrated. Any delay is exact and fractional, clocks may be uneven, readings may be missing, and the
innovations are those of the log's own likelihood, since a command depends only on readings that come before it here
(Forssell and Ljung 1999). Readings are scalars, taken one after the other (Bierman 1977).
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

from upright.calibration.motion import DRY_LEFT, DRY_RIGHT, INSTANT, STATES, STUCK, TOPPLED, block_of, driven, njit
from upright.calibration.ringing import moved, undriven
from upright.compiled.generated import PITCH, PITCH_RATE, WHEEL_RATE, YAW_RATE
from upright.compiled.generated_motion import accelerations_free, constants_free
from upright.compiled.jit import get, put

MOVING = (PITCH, PITCH_RATE, WHEEL_RATE, YAW_RATE)
"""The states on which the motion depends: angles of wheel and yaw shift nothing on a level floor."""
RATES = (PITCH_RATE, WHEEL_RATE, YAW_RATE)

WIDE = 8
"""Lanes of the filter: the state and four neighbours; eight are moved faster than five."""

PADDED = 12
"""Columns of the filter's covariance: of ten states at most, and as many as fill the vectors of a processor."""

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


class RobotLanes(NamedTuple):
    """Robots that go through the same events: how each sensor row `reads` the state (rows, states, lanes), the `delays`
    of the rows (rows, lanes) [s], and the `robots` (constants and 5, lanes): the named constants of the equations, the
    factors of both motors, the dead zone, the constant command and the drop. `swing` (2, lanes) is ω [rad/s] and ζ of a
    resonance before the gyro, whose two states are then the last; without lanes there is none. `stiff` (3,) is the time
    [s] from which on the left and the right motor of a filter's robot have so much more dry friction, as commands."""

    reads: Any
    delays: Any
    robots: Any
    swing: Any = np.zeros((0, 1))
    stiff: Any = np.array([np.inf, 0.0, 0.0])


class Noise(NamedTuple):
    """Covariance of the first state `start` (s, s); of the process noise a second, `process` (2, s, s): while both
    wheels move, and while one sticks or turns back; variance of the moments at which commands arrive, `jitter` [s²];
    variance of each sensor row, `readings` (rows,); after how many seconds `start` is added again, `restart`."""

    start: Any
    process: Any
    jitter: Any
    readings: Any
    restart: Any


class _Flow(NamedTuple):
    """Room for the flow of one robot: its block, times of start and stop (2, WIDE), ∂x(stop)/∂x(start) (6, 6), and
    for a product and a turned matrix (s, `PADDED`). Of a robot whose gyro swings also its `swing` (2, WIDE), both
    states of that (2, WIDE), and ∂x(stop)/∂x(start) of all states (s, s)."""

    block: Any
    times: Any
    phi: Any
    product: Any
    turned: Any
    swing: Any = np.zeros((0, 1))
    swung: Any = np.zeros((0, 1))
    whole: Any = np.zeros((0, 0))


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
def innovations(events: Events, lanes: RobotLanes, first: Any, gains: Any, longest: Any) -> Any:
    """Innovations (events, lanes) of lanes from their `first` states (states, lanes), all corrected by the same `gains`
    (events, states), in Runge–Kutta steps of at most `longest` [s]; NaN for a lane that toppled and for commands."""
    count = first.shape[1]
    w = block_of(lanes.robots)
    offsets = first[STATES:].copy()
    u = events.commands[0].copy()
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
        moved(w, u, now, then, longest, lanes.swing, offsets)
        if row < 0:
            u[:] = events.commands[int(events.value[event])]
            continue
        _errors(w, offsets, lanes.reads[row], events.value[event], error)
        _shift(w, offsets, gains[event], error)
        result[event] = error
    return result


@njit
def _flow(room: _Flow, x: Any, u: Any, start: Any, stop: Any, longest: Any) -> None:
    """Moves x from `start` to `stop` [s] and writes ∂x(stop)/∂x(start) of the six states into `room.phi`, and where the
    gyro swings of all into `room.whole`."""
    w = room.block
    phi = room.phi
    swings = len(room.swing)
    tail = len(x) - swings
    for i in range(WIDE):
        room.times[0, i], room.times[1, i] = start, stop
        for j in range(swings):
            room.swung[j, i] = x[tail + j]
        for j in range(STATES):
            put(w, PITCH + j, i, x[j])
    for i in range(len(MOVING)):
        put(w, MOVING[i], 1 + i, get(w, MOVING[i], 1 + i) + _NUDGE)
    put(w, STUCK, 0, 0.0)
    moved(w, u, room.times[0], room.times[1], longest, room.swing, room.swung)
    for j in range(STATES):
        x[j] = get(w, PITCH + j, 0)
        for i in range(len(MOVING)):
            phi[j, MOVING[i]] = (get(w, PITCH + j, 1 + i) - x[j]) / _NUDGE
        phi[j, 2] = 1.0 if j == 2 else 0.0
        phi[j, 4] = 1.0 if j == 4 else 0.0
    if swings:
        for j in range(STATES):
            for i in range(STATES):
                room.whole[j, i] = phi[j, i]
        undriven(stop - start, room.swing, room.whole)
        for j in range(swings):
            x[tail + j] = room.swung[j, 0]
            for i in range(len(MOVING)):
                room.whole[tail + j, MOVING[i]] = (room.swung[j, 1 + i] - x[tail + j]) / _NUDGE


@njit
def _times(made: Any, left: Any, right: Any, part: Any) -> None:
    """Fills the first rows of `made` (s, s) with a `part` of so many rows and columns of `left` times as many rows of
    `right`. Six at once fill the vectors of a processor."""
    for i in range(part):
        a, b, c, d, e, f = left[i, 0], left[i, 1], left[i, 2], left[i, 3], left[i, 4], left[i, 5]
        for j in range(right.shape[1]):
            first = a * right[0, j] + b * right[1, j] + c * right[2, j]
            made[i, j] = first + d * right[3, j] + e * right[4, j] + f * right[5, j]
        for k in range(STATES, part):
            weight = left[i, k]
            for j in range(right.shape[1]):
                made[i, j] += weight * right[k, j]


@njit
def _predict(P: Any, phi: Any, Q: Any, mode: Any, h: Any, product: Any, turned: Any) -> None:
    """P ← Φ P Φᵀ + Q h, for Φ that is the identity beyond its own states; Q is one of two, (2, s, s). P, and the room
    for Φ P and for Φᵀ, are (s, `PADDED`)."""
    size, part = len(P), len(phi)
    for i in range(part):
        for j in range(part):
            turned[i, j] = phi[j, i]
    _times(product, phi, P, part)
    _times(P, product, turned, part)
    for i in range(part):
        for j in range(part, size):
            P[i, j] = product[i, j]
        for j in range(i + 1, size):
            P[j, i] = P[i, j]
    for i in range(size):
        for j in range(size):
            P[i, j] += Q[mode, i, j] * h


@njit
def _correct(x: Any, P: Any, reads: Any, row: Any, reading: Any, gains: Any, event: Any) -> Any:
    """State and covariance with a scalar `reading` C x and the variance of its noise; C is the first lane of this `row`
    of `reads` (rows, s, lanes). Fills the gain of this `event` in `gains` (events, s), and returns innovation and its
    variance."""
    (error, variance), size = reading, len(x)
    for i in range(size):
        C = reads[row, i, 0]
        error -= C * x[i]
        if C != 0.0:
            for j in range(size):
                gains[event, j] += P[i, j] * C
    for i in range(size):
        variance += reads[row, i, 0] * gains[event, i]
    for i in range(size):
        gain = gains[event, i] / variance
        for j in range(size):
            P[i, j] -= gain * gains[event, j]
    for i in range(size):
        gains[event, i] /= variance
        x[i] += gains[event, i] * error
    return error, variance


@njit
def _silent(P: Any, reads: Any, row: Any, variance: Any) -> Any:
    """The same of a reading that is NaN: it corrects nothing, and is off by one standard deviation."""
    for i in range(len(P)):
        for j in range(len(P)):
            variance += reads[row, i, 0] * P[i, j] * reads[row, j, 0]
    return math.sqrt(variance), variance


@njit
def _response_to_delay(w: Any, x: Any, old: Any, new: Any) -> Any:
    """By how much ψ̇, θ̇ and φ̇ lag for each second that the command `new` arrives late after `old`."""
    constants = constants_free(w, 0)
    before = accelerations_free(x[0], x[1], x[3], x[5], *driven(w, 0, old), 0.0, 0.0, *constants)
    after = accelerations_free(x[0], x[1], x[3], x[5], *driven(w, 0, new), 0.0, 0.0, *constants)
    return after[0] - before[0], after[1] - before[1], after[2] - before[2]


@njit
def _forget(P: Any, start: Any, tail: Any) -> None:
    """Adds what was not known at first of the six states, and of those of a resonance, from `tail` on."""
    for i in range(len(P)):
        for j in range(len(P)):
            if (i < STATES or i >= tail) and (j < STATES or j >= tail):
                P[i, j] += start[i, j]


class Followed(NamedTuple):
    """What the filter leaves of each event: innovations (events,), their variances (events,) and gains (events, s); the
    state (events, s) and its covariance (events, s, s) after it, or none of either."""

    e: Any
    s: Any
    gains: Any
    states: Any
    covariances: Any


@njit
def kalman_path(events: Events, lanes: RobotLanes, first: Any, noise: Noise, longest: Any, keep: bool) -> Any:
    """The extended Kalman filter along one log, from the state `first` (s,), in steps of at most `longest` [s].

    `lanes` holds the one robot `WIDE` times. Returns innovations (events,), their variances (events,), gains (events,
    s) and, with `keep`, the state after each event (events, s), else none; NaN, or zero, from where it toppled.
    """
    size = len(first)
    many = len(events.kind)
    e = np.full(many, np.nan)
    s = np.full(many, np.nan)
    gains = np.zeros((many, size))
    states = np.zeros((many if keep else 0, size))
    kalman_along(events, lanes, first, noise, longest, Followed(e, s, gains, states, np.zeros((0, size, size))))
    return e, s, gains, states


@njit
def kalman_along(events: Events, lanes: RobotLanes, first: Any, noise: Noise, longest: Any, followed: Followed) -> None:
    """The same into what was `followed` so far. No hypothesis gains by readings that say nothing: each is off by one
    standard deviation."""
    size = len(first)
    x = first.copy()
    P = np.zeros((size, PADDED))
    u = events.commands[0].copy()
    P[:, :size] = noise.start
    w = block_of(lanes.robots)
    for i in range(1 + len(MOVING), WIDE):  # no wheel of a lane that nobody reads is stopped
        put(w, DRY_LEFT, i, 0.0)
        put(w, DRY_RIGHT, i, 0.0)
    swings = len(lanes.swing)
    room = _Flow(
        w, np.zeros((2, WIDE)), np.zeros((STATES, STATES)), np.zeros((size, PADDED)), np.zeros((size, PADDED)),
        lanes.swing, np.zeros((swings, WIDE)), np.eye(size),
    )  # fmt: skip
    e, s, gains = followed.e, followed.s, followed.gains
    now = -np.inf
    forget = np.inf
    since = lanes.stiff[0]
    for event in events.order:
        row = events.kind[event]
        then = events.when[event] - (lanes.delays[row, 0] if row >= 0 else 0.0)
        if now == -np.inf:
            now = then
            forget = then + noise.restart
        if then >= forget:
            _forget(P, noise.start, size - swings)
            forget += noise.restart
        if then >= since:  # in the middle of a span: a wheel that is held stops within less
            now = _predicted(room, x, P, u, (now, max(since, now)), longest, noise.process)
            _stiffen(w, lanes.stiff)
            since = np.inf
        now = _predicted(room, x, P, u, (now, then), longest, noise.process)
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
            value, variance = events.value[event], noise.readings[row]
            if math.isnan(value):
                e[event], s[event] = _silent(P, lanes.reads, row, variance)
            else:
                e[event], s[event] = _correct(x, P, lanes.reads, row, (value, variance), gains, event)
        _keep(followed, event, x, P)


@njit
def _predicted(room: _Flow, x: Any, P: Any, u: Any, span: Any, longest: Any, process: Any) -> Any:
    """State and covariance over a span, from one time to another [s]; the time at which they are then."""
    now, then = span
    if not then - now > INSTANT:
        return now
    _flow(room, x, u, now, then, longest)
    phi = room.whole if len(room.swing) else room.phi
    mode = int(get(room.block, STUCK, 0))
    _predict(P, phi, process, mode, then - now, room.product, room.turned)
    return then


@njit
def _stiffen(w: Any, stiff: Any) -> None:
    """More dry friction in the motors of the lanes that are read."""
    for i in range(1 + len(MOVING)):
        put(w, DRY_LEFT, i, max(0.0, get(w, DRY_LEFT, i) + stiff[1]))
        put(w, DRY_RIGHT, i, max(0.0, get(w, DRY_RIGHT, i) + stiff[2]))


@njit
def _keep(followed: Followed, event: int, x: Any, P: Any) -> None:
    if len(followed.states):
        followed.states[event] = x
    if len(followed.covariances):
        followed.covariances[event] = P[:, : len(x)]
