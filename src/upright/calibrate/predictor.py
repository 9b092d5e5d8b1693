"""The predictor in innovation form: one robot and its neighbours through a log, side by side.

Time here is that of the command: a sensor whose dead time is d says at t what the robot did at t − d. So every log is a
sequence of events, commands at t and readings at t − d, gone through in that order; between them the equations of
motion are integrated. Any delay is exact and fractional, clocks may be uneven, readings may be missing, and the
innovations are those of the log's own likelihood, since a command depends only on readings that come before it here
(Forssell and Ljung 1999). Readings are scalars, taken one after the other (Bierman 1977).
"""

from __future__ import annotations

import math
from functools import partial
from typing import Any

import numba
import numpy as np

from upright.compiled.generated import CONSTANTS
from upright.compiled.generated_motion import accelerations_smooth

_compile: Any = numba.njit  # its stubs know fewer options than it has
njit: Any = partial(_compile, cache=True, nogil=True, error_model="numpy")
"""A compiled function, kept on disk, that lets other threads run and divides as IEEE says."""

inlined: Any = partial(_compile, error_model="numpy", forceinline=True, no_cpython_wrapper=True)
"""A function for other compiled functions, put into its callers and vectorised there across lanes."""

STATES = 6
MOVED = (0, 1, 3, 5)
"""The states on which the motion depends: pitch and the three rates."""
RATES = (1, 3, 5)

WIDE = 8
"""Lanes of the filter: the state and four neighbours; eight are moved faster than five."""

LANES = 64
"""Most lanes of one call: beyond, their states leave the fastest memory."""

ROW, SPAN, CONSTANT = LANES, STATES, STATES + 1
DRIVE = CONSTANT + CONSTANTS
DRY, STOPS, LEFT, RIGHT, OLD = DRIVE + 3, DRIVE + 4, DRIVE + 5, DRIVE + 6, DRIVE + 7
STUCK = OLD + STATES
"""A block is one array of rows, `ROW` apart, of one number for each lane: the states, the time to move, the robot's
constants, what drives it (factors of both motors, dead zone), its dry friction as a command, whether a wheel stops, the
commands that arrive, the states before the step, and whether a wheel has stopped. One array and a fixed distance let
the compiler take several lanes at once."""

SWEEPS = 20  # of Gauss and Seidel over both wheels, at most: each halves the error at least
PASSES = 3  # in which the answer to friction, known to a few hundredths, is corrected, at most
SETTLED = 1e-10  # [rad/s] of a wheel, to which friction is found

COMMAND = -1
"""The kind of an event that is a command; any other kind is the row of a sensor."""

TOPPLED = 3.0  # [rad] pitch beyond which a lane is lost: the sine is right to 1e-7 until there
_NUDGE = 1e-6  # a step in the state to differentiate the flow: error and rounding both near 1e-9


@inlined
def _acc(w: Any, i: Any, left: Any, right: Any, pitch: Any, pitch_rate: Any, wheel_rate: Any, yaw_rate: Any) -> Any:
    """ψ̈, θ̈, φ̈ of lane i on a level floor that pushes nothing, without dry friction."""
    return accelerations_smooth(
        pitch, pitch_rate, wheel_rate, 0.0, yaw_rate, left, right, 0.0, 0.0, 0.0, 1.0,
        w[7 * ROW + i], w[8 * ROW + i], w[9 * ROW + i], w[10 * ROW + i], w[11 * ROW + i], w[12 * ROW + i],
        w[13 * ROW + i], w[14 * ROW + i], w[15 * ROW + i], w[16 * ROW + i], w[17 * ROW + i], w[18 * ROW + i],
        w[19 * ROW + i], w[20 * ROW + i], w[21 * ROW + i], w[22 * ROW + i], w[23 * ROW + i], w[24 * ROW + i],
        w[25 * ROW + i], w[26 * ROW + i], w[27 * ROW + i], w[28 * ROW + i], w[29 * ROW + i], w[30 * ROW + i],
    )  # fmt: skip


@inlined
def _runge_kutta(
    w: Any, i: Any, d: Any, left: Any, right: Any, p0: Any, v0: Any, r0: Any, w0: Any, f0: Any, y0: Any
) -> Any:  # fmt: skip
    """One classical Runge–Kutta step of d [s] of lane i. Angles of wheel and yaw drive nothing on a level floor, so
    their slopes are the rates' own."""
    a, b = 0.5 * d, d / 6
    pa, wa, ya = _acc(w, i, left, right, p0, v0, w0, y0)
    v1, w1, y1 = v0 + a * pa, w0 + a * wa, y0 + a * ya
    pb, wb, yb = _acc(w, i, left, right, p0 + a * v0, v1, w1, y1)
    v2, w2, y2 = v0 + a * pb, w0 + a * wb, y0 + a * yb
    pc, wc, yc = _acc(w, i, left, right, p0 + a * v1, v2, w2, y2)
    v3, w3, y3 = v0 + d * pc, w0 + d * wc, y0 + d * yc
    pd, wd, yd = _acc(w, i, left, right, p0 + d * v2, v3, w3, y3)
    pitch = p0 + b * (v0 + 2 * (v1 + v2) + v3)
    return (
        pitch if abs(pitch) < TOPPLED else np.nan, v0 + b * (pa + 2 * (pb + pc) + pd),
        r0 + b * (w0 + 2 * (w1 + w2) + w3), w0 + b * (wa + 2 * (wb + wc) + wd),
        f0 + b * (y0 + 2 * (y1 + y2) + y3), y0 + b * (ya + 2 * (yb + yc) + yd),
    )  # fmt: skip


@njit
def _advance(w: Any, count: Any, steps: Any) -> None:
    """One step of span/steps [s] for the first `count` lanes of the block `w`: each wheel's dry friction against its
    motion, and where that would turn it back within the step, what it really gives."""
    for i in range(count):
        d, half, dry = w[SPAN * ROW + i] / steps, w[CONSTANT * ROW + i], w[DRY * ROW + i]
        p0, v0, r0 = w[i], w[ROW + i], w[2 * ROW + i]
        w0, f0, y0 = w[3 * ROW + i], w[4 * ROW + i], w[5 * ROW + i]
        left = dry if w0 - v0 - half * y0 >= 0 else -dry
        right = dry if w0 - v0 + half * y0 >= 0 else -dry
        p, v, r, o, f, y = _runge_kutta(
            w, i, d, w[LEFT * ROW + i] - left, w[RIGHT * ROW + i] - right, p0, v0, r0, w0, f0, y0
        )  # fmt: skip
        w[STOPS * ROW + i] = min(left * (o - v - half * y), right * (o - v + half * y))
        w[OLD * ROW + i], w[(OLD + 1) * ROW + i], w[(OLD + 2) * ROW + i] = p0, v0, r0
        w[(OLD + 3) * ROW + i], w[(OLD + 4) * ROW + i], w[(OLD + 5) * ROW + i] = w0, f0, y0
        w[i], w[ROW + i], w[2 * ROW + i] = p, v, r
        w[3 * ROW + i], w[4 * ROW + i], w[5 * ROW + i] = o, f, y
    for i in range(count):
        if w[STOPS * ROW + i] < 0:
            _stop(w, i, w[SPAN * ROW + i] / steps)
            w[STUCK * ROW + i] = 1.0


@njit
def _answers(w: Any, i: Any, d: Any) -> Any:
    """By how much a unit of command over d [s] changes the wheels' rate relative to the body: its own and the other's.

    From the accelerations' response to equal and to opposite commands, each with the motors' damping over the step.
    """
    c = (CONSTANT * ROW) + i
    sine = math.sin(w[(OLD) * ROW + i])
    a12 = w[c + 9 * ROW] * math.sqrt(1 - sine * sine) + w[c + 20 * ROW]
    a22 = w[c + 21 * ROW]
    mean = -2 * w[c + 8 * ROW] * (1 + 2 * a12 + a22) / (a22 - a12 * a12)
    turn = -2 * w[c + 19 * ROW] * w[c] / (1 + w[c + 22 * ROW] * sine * sine)
    loss = d * w[c + 3 * ROW] / (2 * w[c + 8 * ROW])
    mean *= d / (1 + mean * loss * (0.5 + mean * loss / 12))
    turn *= d / (1 + turn * loss * (0.5 + turn * loss / 12))
    return (mean + turn) / 2, (mean - turn) / 2


@njit
def _held(first: Any, free: Any, own: Any, dry: Any) -> Any:
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
    half, dry = w[CONSTANT * ROW + i], w[DRY * ROW + i]
    mean, turn = w[(OLD + 3) * ROW + i] - w[(OLD + 1) * ROW + i], half * w[(OLD + 5) * ROW + i]
    first_left, first_right = mean - turn, mean + turn
    left, right = dry if first_left >= 0 else -dry, dry if first_right >= 0 else -dry
    own, other = _answers(w, i, d)
    for _ in range(PASSES):
        mean, turn = w[3 * ROW + i] - w[ROW + i], half * w[5 * ROW + i]
        free_left = mean - turn + own * left + other * right
        free_right = mean + turn + own * right + other * left
        before_left, before_right = left, right
        for _ in range(SWEEPS):
            was = left
            left = _held(first_left, free_left - other * right, own, dry)
            right = _held(first_right, free_right - other * left, own, dry)
            if abs(left - was) * own < SETTLED:
                break
        if (abs(left - before_left) + abs(right - before_right)) * own < SETTLED:
            break
        w[i], w[ROW + i], w[2 * ROW + i], w[3 * ROW + i], w[4 * ROW + i], w[5 * ROW + i] = _runge_kutta(
            w, i, d, w[LEFT * ROW + i] - left, w[RIGHT * ROW + i] - right,
            w[OLD * ROW + i], w[(OLD + 1) * ROW + i], w[(OLD + 2) * ROW + i],
            w[(OLD + 3) * ROW + i], w[(OLD + 4) * ROW + i], w[(OLD + 5) * ROW + i],
        )  # fmt: skip


@inlined
def _through(command: Any, zone: Any) -> Any:
    """What a dead zone leaves of a command: nothing inside, all of it outside, and between 0.9 and 1.1 of the zone a
    straight way from one to the other, so that its size can be estimated."""
    return command * min(1.0, max(0.0, 5 * abs(command) / max(zone, 1e-9) - 4.5))


@njit
def _move(w: Any, count: Any, u: Any, start: Any, stop: Any, longest: Any) -> None:
    """Each lane from its `start` to its `stop` [s], in as many steps as the farthest needs."""
    farthest = 0.0
    for i in range(count):
        w[SPAN * ROW + i] = stop[i] - start[i]
        farthest = max(farthest, abs(stop[i] - start[i]))
        start[i] = stop[i]
    if farthest >= 1e-12:
        for i in range(count):
            w[LEFT * ROW + i] = w[DRIVE * ROW + i] * _through(u[0], w[(DRIVE + 2) * ROW + i])
            w[RIGHT * ROW + i] = w[(DRIVE + 1) * ROW + i] * _through(u[1], w[(DRIVE + 2) * ROW + i])
        steps = max(1, math.ceil(farthest / longest))
        for _ in range(steps):
            _advance(w, count, steps)


@njit
def _block(c: Any) -> Any:
    """The block of lanes with constants c (constants, lanes), their states zero."""
    w = np.zeros((STUCK + 1) * ROW)
    for j in range(c.shape[0]):
        for i in range(c.shape[1]):
            w[(CONSTANT + j) * ROW + i] = c[j, i]
    for i in range(c.shape[1]):
        w[DRY * ROW + i] = max(0.0, -c[7, i] / c[8, i])
    return w


@njit
def innovations(  # noqa: PLR0912 (the inner loop, unrolled by hand over what a block holds)
    order: Any, kind: Any, when: Any, value: Any, commands: Any, reads: Any, delays: Any, c: Any, first: Any,
    gains: Any, longest: Any,
) -> Any:  # fmt: skip
    """e (events, lanes) of lanes that differ in `reads` (rows, states, lanes), `delays` (rows, lanes), `c`
    (constants, lanes) and `first` (states, lanes), all corrected by the same `gains` (events, states); NaN for a lane
    that toppled.
    """
    lanes, size = c.shape[1], first.shape[0]
    w, extra, u = _block(c), first[STATES:].copy(), commands[0].copy()
    for j in range(STATES):
        w[j * ROW : j * ROW + lanes] = first[j]
    now, then, error = np.zeros(lanes), np.zeros(lanes), np.zeros(lanes)
    found = np.full((len(kind), lanes), np.nan)
    for place in range(len(order)):
        event = order[place]
        row = kind[event]
        for i in range(lanes):
            then[i] = when[event] - (delays[row, i] if row >= 0 else 0.0)
        if place == 0:
            now[:] = then
        _move(w, lanes, u, now, then, longest)
        if row < 0:
            u[:] = commands[int(value[event])]
            continue
        for i in range(lanes):
            error[i] = value[event]
        for j in range(STATES):
            for i in range(lanes):
                error[i] -= reads[row, j, i] * w[j * ROW + i]
        for j in range(STATES, size):
            for i in range(lanes):
                error[i] -= reads[row, j, i] * extra[j - STATES, i]
        for j in range(STATES):
            for i in range(lanes):
                w[j * ROW + i] += gains[event, j] * error[i]
        for j in range(STATES, size):
            for i in range(lanes):
                extra[j - STATES, i] += gains[event, j] * error[i]
        found[event] = error
    return found


@njit
def _flow(w: Any, x: Any, u: Any, start: Any, stop: Any, longest: Any, phi: Any, times: Any) -> None:
    """Moves x from `start` to `stop` [s] and writes ∂x(stop)/∂x(start) of the six states into `phi`.

    Angles of wheel and yaw shift nothing, so four neighbours suffice: pitch, and the three rates.
    """
    for i in range(WIDE):
        times[0, i], times[1, i] = start, stop
        for j in range(STATES):
            w[j * ROW + i] = x[j]
    for i in range(4):
        w[MOVED[i] * ROW + 1 + i] += _NUDGE
    w[STUCK * ROW] = 0.0
    _move(w, times.shape[1], u, times[0], times[1], longest)
    for j in range(STATES):
        base = w[j * ROW]
        x[j] = base
        for i in range(4):
            phi[j, MOVED[i]] = (w[j * ROW + 1 + i] - base) / _NUDGE
        phi[j, 2] = 1.0 if j == 2 else 0.0
        phi[j, 4] = 1.0 if j == 4 else 0.0


@njit
def _spread(P: Any, phi: Any, Q: Any, h: Any, scratch: Any) -> None:
    """P ← Φ P Φᵀ + Q h, for Φ that is the identity beyond the six states."""
    size = P.shape[0]
    for i in range(STATES):
        for j in range(size):
            total = 0.0
            for k in range(STATES):
                total += phi[i, k] * P[k, j]
            scratch[i, j] = total
    for i in range(STATES):
        for j in range(i, size):
            total = scratch[i, j]
            if j < STATES:
                total = 0.0
                for k in range(STATES):
                    total += scratch[i, k] * phi[j, k]
            P[i, j] = total
            P[j, i] = total
    for i in range(size):
        for j in range(size):
            P[i, j] += Q[i, j] * h


@njit
def _arrives(w: Any, x: Any, u: Any, new: Any) -> Any:
    """Puts the new command into `u`, and returns by how much ψ̇, θ̇ and φ̇ lag for each second that it is late."""
    zone = w[(DRIVE + 2) * ROW]
    before = _acc(w, 0, w[DRIVE * ROW] * _through(u[0], zone), w[(DRIVE + 1) * ROW] * _through(u[1], zone),
                  x[0], x[1], x[3], x[5])  # fmt: skip
    u[:] = new
    after = _acc(w, 0, w[DRIVE * ROW] * _through(u[0], zone), w[(DRIVE + 1) * ROW] * _through(u[1], zone),
                 x[0], x[1], x[3], x[5])  # fmt: skip
    return after[0] - before[0], after[1] - before[1], after[2] - before[2]


@njit
def kalman_path(  # noqa: PLR0912 (the inner loop, unrolled by hand over what a state holds)
    order: Any, kind: Any, when: Any, value: Any, commands: Any, reads: Any, delays: Any, c: Any, first: Any, P0: Any,
    Q: Any, jitter: Any, noise: Any, longest: Any, gains: Any, states: Any,
) -> Any:  # fmt: skip
    """The extended Kalman filter along one log: innovations e (events,) and their variances s (events,).

    `c` (constants, WIDE) are the robot's, in every lane. Fills `gains` (events, states) and, where it has rows,
    `states` (events, states) after each event. `Q` (2, states, states) is the covariance of the process noise per
    second while both wheels move, and while one sticks or turns back; `jitter` the variance [s²] of the moments at
    which commands arrive; `noise` that of each sensor row.
    """
    size = len(first)
    x, P, u = first.copy(), P0.copy(), commands[0].copy()
    phi, scratch, seen = np.zeros((STATES, STATES)), np.zeros((STATES, size)), np.zeros(size)
    w, times = _block(c), np.zeros((2, WIDE))
    e, s = np.full(len(kind), np.nan), np.full(len(kind), np.nan)
    now = -np.inf
    for event in order:
        row = kind[event]
        then = when[event] - (delays[row] if row >= 0 else 0.0)
        now = max(now, then) if now == -np.inf else now
        if then - now > 1e-12:
            _flow(w, x, u, now, then, longest, phi, times)
            _spread(P, phi, Q[int(w[STUCK * ROW])], then - now, scratch)
            now = then
        if not abs(x[0]) < TOPPLED:
            return e, s
        if row < 0:
            late = _arrives(w, x, u, commands[int(value[event])])
            for i in range(len(RATES)):
                for j in range(len(RATES)):
                    P[RATES[i], RATES[j]] += jitter * late[i] * late[j]
        else:
            error, variance = value[event], noise[row]
            for i in range(size):
                seen[i] = 0.0
                for j in range(size):
                    seen[i] += P[i, j] * reads[row, j]
                error -= reads[row, i] * x[i]
            for i in range(size):
                variance += reads[row, i] * seen[i]
            for i in range(size):
                gains[event, i] = seen[i] / variance
                x[i] += gains[event, i] * error
            for i in range(size):
                for j in range(size):
                    P[i, j] -= seen[i] * seen[j] / variance
            e[event], s[event] = error, variance
        if len(states) > 0:
            states[event] = x
    return e, s
