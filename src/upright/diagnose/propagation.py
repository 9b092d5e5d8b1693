"""The equations of motion from event to event, and small errors through the filter of a log, in compiled code."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from upright.calibration.kept import njit
from upright.calibration.motion import DRIVES, block_of, inlined
from upright.compiled.generated_motion import constants_rolling, rk4_rolling

BLOCK = 32  # faults that are gone through together
SOME = 1e-3  # of the dry friction, to which the motion within a step answers in proportion
SWEEPS = 20  # of Gauss and Seidel over both wheels, which hardly act on each other: as in `calibrate.motion`


@njit
def _moved(state: Any, h: Any, left: Any, right: Any, acting: Any, known: Any) -> Any:
    """The state h [s] later under both commands, and a force and a moment that are `acting`."""
    return rk4_rolling(*state, h, left, right, *acting, *known)


@njit
def held(state: Any, h: Any, drive: Any, acting: Any, dry: Any, known: Any) -> Any:
    """The same of motors with so much more `dry` friction each [command unit]: it stops a wheel against the body by the
    end of the step, or is all there is against its turning (implicit, as of Moreau 1988)."""
    unit = SOME * max(dry[0], dry[1])
    half = known[0]
    rates = np.zeros((3, 2))  # of both wheels at the end, without this friction, and with some of it in either
    for k in range(3):
        end = _moved(state, h, drive[0] - unit * (k == 1), drive[1] - unit * (k == 2), acting, known)
        rates[k, 0], rates[k, 1] = end[3] - end[1] - half * end[5], end[3] - end[1] + half * end[5]
    by_left, by_right = (rates[0] - rates[1]) / unit, (rates[0] - rates[2]) / unit
    left, right = 0.0, 0.0
    for _ in range(SWEEPS):
        left = max(-dry[0], min(dry[0], (rates[0, 0] - by_right[0] * right) / by_left[0]))
        right = max(-dry[1], min(dry[1], (rates[0, 1] - by_left[1] * left) / by_right[1]))
    return _moved(state, h, drive[0] - left, drive[1] - right, acting, known)


@inlined
def _next(state: Any, h: Any, drive: Any, acting: Any, dry: Any, known: Any) -> Any:
    """The same of motors with so much more dry friction, or with none more."""
    if max(dry[0], dry[1]) > 0:
        return held(state, h, drive, acting, dry, known)
    return _moved(state, h, drive[0], drive[1], acting, known)


@njit
def fly(constants: Any, x: Any, u: Any, w: Any, spans: Any, steps: int, dry: Any) -> Any:
    """States (lanes, n, 6) of robots with these `constants` (constants, lanes), from the states x (lanes, n, 6), after
    the `spans` (n,) [s], each in so many `steps`, under the commands u (lanes, n, 2), forces [N] and moments [N m] w
    (lanes, n, 2), and `dry` friction (n, 2) [command unit] beyond the robot's."""
    whole = np.zeros((len(constants) + DRIVES, x.shape[0]))
    whole[: len(constants)] = constants
    block = block_of(whole)
    end = x.copy()
    for lane in range(x.shape[0]):
        known = constants_rolling(block, lane)
        for i in range(x.shape[1]):
            h = spans[i] / steps
            if h <= 0:  # readings of one sample follow each other at once
                continue
            a, b, c, d, e, f = x[lane, i]
            left, right, force, moment = u[lane, i, 0], u[lane, i, 1], w[lane, i, 0], w[lane, i, 1]
            for _ in range(steps):
                a, b, c, d, e, f = _next(
                    (a, b, c, d, e, f), h, (left, right), (force, moment), (dry[i, 0], dry[i, 1]), known
                )
            end[lane, i] = np.array([a, b, c, d, e, f])
    return end


@njit
def propagate(phi: Any, pushed: Any, shifted: Any, reads: Any, gains: Any, deviation: Any) -> Any:
    """What faults add to the whitened innovations (events, faults) of a filter that corrects what they do to its state.

    Each event's flow is `phi` (events, 6, 6), its gain `gains` (events, states), its reading `reads` (events, states),
    whose innovation has this standard `deviation` (events,), NaN where none is used. Faults enter the state,
    `pushed` (events, 6, faults), and readings, `shifted` (events, faults); either may have one row for all.
    """
    faults = pushed.shape[2]
    response = np.zeros((len(phi), faults))
    for start in range(0, faults, BLOCK):  # neighbours begin at about the same time
        stop = min(start + BLOCK, faults)
        _propagate(
            phi, pushed[:, :, start:stop], shifted[:, start:stop], reads, gains, deviation, response[:, start:stop]
        )
    return response


@njit
def _propagate(phi: Any, pushed: Any, shifted: Any, reads: Any, gains: Any, deviation: Any, response: Any) -> None:
    """The same of some faults into their part of the response."""
    n = len(phi)
    size = gains.shape[1]
    faults = pushed.shape[2]
    error = np.zeros((size, faults))
    before = np.zeros((6, faults))
    innovation = np.zeros(faults)
    for i in range(_first(pushed, shifted, n), n):
        before[:] = error[:6]
        for row in range(6):
            into = error[row]
            into[:] = pushed[i % len(pushed), row]
            for column in range(6):
                slope = phi[i, row, column]
                if slope != 0:
                    of = before[column]
                    for fault in range(faults):
                        into[fault] += slope * of[fault]
        if math.isnan(deviation[i]):
            continue
        innovation[:] = -shifted[i % len(shifted)]
        for state in range(size):
            if reads[i, state] != 0:
                for fault in range(faults):
                    innovation[fault] -= reads[i, state] * error[state, fault]
        for state in range(size):
            for fault in range(faults):
                error[state, fault] += gains[i, state] * innovation[fault]
        for fault in range(faults):
            response[i, fault] = innovation[fault] / deviation[i]


@njit
def _first(pushed: Any, shifted: Any, n: int) -> int:
    """The event, of n, at which some fault first enters."""
    i = 0
    while i < n and not (pushed[i % len(pushed)].any() or shifted[i % len(shifted)].any()):
        i += 1
    return i


@njit
def slide(floor: Any, moving: Any, u: Any, acting: Any, grip: Any, slipped: Any, h: Any) -> Any:
    """The acceleration of slipping [m/s²] within h [s] on a floor that holds `grip` of the weight, of wheels that slip
    at `slipped` [m/s] before, and how fast they slip then; the equations are those of `slip.slipping`. The robot is
    `moving` with a pitch [rad], pitch rate and wheel rate [rad/s] under the sum u of both commands, and a force [N] and
    a moment [N m] are `acting`."""
    total, lever, inertia, wheel, rotors, radius, gain, damping, friction, dry, rolling, slow, gravity = floor
    pitch, pitch_rate, wheel_rate = moving
    force, moment = acting
    cos = math.cos(pitch)
    sin = math.sin(pitch)
    rate = wheel_rate - pitch_rate
    torque = gain * u - damping * rate - dry * rate / math.sqrt(rate * rate + slow * slow)
    across = lever * cos
    ratio = rotors / wheel
    inner = inertia - rotors * ratio
    whole = total * inner - across * across
    # ẍ, ψ̈ and θ̈ without the floor's force, by a newton of it, and by a newton metre of the motors
    turning = torque - friction * wheel_rate - rolling * wheel_rate / math.sqrt(wheel_rate * wheel_rate + slow * slow)
    x = lever * pitch_rate * pitch_rate * sin + force
    y = lever * gravity * sin - torque + moment + ratio * turning
    move, falling = (inner * x - across * y) / whole, (total * y - across * x) / whole
    free = radius * (turning + rotors * falling) / wheel - move
    x = 1.0
    y = -ratio * radius
    move, tipped = (inner * x - across * y) / whole, (total * y - across * x) / whole
    held = radius * (-radius + rotors * tipped) / wheel - move
    x = 0.0
    y = ratio - 1.0
    move, lean = (inner * x - across * y) / whole, (total * y - across * x) / whole
    driven = radius * (1.0 + rotors * lean) / wheel - move
    # a body that falls weighs less
    needed = -free / held
    drop = lever * sin
    weight = total * gravity - lever * pitch_rate * pitch_rate * cos - drop * falling
    if slipped == 0.0 and abs(needed) <= grip * (weight - drop * tipped * needed):
        return 0.0, 0.0
    way = math.copysign(1.0, slipped if slipped != 0.0 else needed)
    sliding = free + held * way * max(0.0, grip * weight / (1.0 + way * grip * drop * tipped))
    lost = driven * damping / radius * h
    if lost > 1e-6:
        sliding *= -math.expm1(-lost) / lost
    after = slipped + sliding * h
    if slipped != 0.0 and way * after <= 0.0:
        return -slipped / h, 0.0
    return sliding, after


@njit
def observe(steps: int, followed: Any, floor: Any, robots: Any, onsets: Any, forces: Any, floors: Any) -> Any:
    """Whitened innovations (lanes, events) of robots under `forces` [N] and moments [N m] (lanes, events, 2), on
    `floors` (lanes, 2) that from a time [s] on hold no more than a fraction of the weight (0: any).

    The filter `followed` a log: its first state, times [s], commands u (events, 2), spans [s], reads and gains (events,
    states), readings and deviations (events,), and dry friction (events, 2) as in `fly`. It corrects the state by what
    the readings show beyond it. The constants of the `robots` (lanes + 1, constants) are those of a lane from its onset
    (lanes,) [s] on, and the last ones before. `floor` are the numbers of the sums of forces on wheels that slip
    (`slide`).
    """
    first, t, u, spans, reads, gains, readings, deviation, dry = followed
    n = len(spans)
    size = gains.shape[1]
    lanes = len(forces)
    result = np.zeros((lanes, n))
    whole = np.zeros((robots.shape[1] + DRIVES, 1))
    whole[:-DRIVES, 0] = robots[lanes]
    usual = constants_rolling(block_of(whole), 0)
    for lane in range(lanes):
        whole[:-DRIVES, 0] = robots[lane]
        changed = constants_rolling(block_of(whole), 0)
        x = first.copy()
        slipped = 0.0
        for i in range(n):
            h = spans[i] / steps
            if h > 0:
                a, b, c, d, e, f = x[0], x[1], x[2], x[3], x[4], x[5]
                left = u[i, 0]
                right = u[i, 1]
                force = forces[lane, i, 0]
                moment = forces[lane, i, 1]
                known = changed if t[i] >= onsets[lane] else usual
                for _ in range(steps):
                    axle, body = force, moment
                    if floors[lane, 1] > 0 and t[i] >= floors[lane, 0]:
                        sliding, slipped = slide(
                            floor, (a, b, d), left + right, (axle, body), floors[lane, 1], slipped, h
                        )
                        axle += floor[0] * sliding
                        body += floor[1] * math.cos(a) * sliding
                    a, b, c, d, e, f = _next(
                        (a, b, c, d, e, f), h, (left, right), (axle, body), (dry[i, 0], dry[i, 1]), known
                    )
                x[0], x[1], x[2], x[3], x[4], x[5] = a, b, c, d, e, f
            if math.isnan(deviation[i]):
                continue
            innovation = readings[i]
            for state in range(size):
                innovation -= reads[i, state] * x[state]
            for state in range(size):
                x[state] += gains[i, state] * innovation
            result[lane, i] = innovation / deviation[i]
    return result
