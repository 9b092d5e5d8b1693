"""The equations of motion from event to event, and small errors through the filter of a log, in compiled code."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from upright.calibrate.kept import njit
from upright.calibrate.motion import block_of
from upright.compiled.generated_motion import constants_rolling, rk4_rolling


@njit
def fly(constants: Any, x: Any, u: Any, w: Any, spans: Any, steps: int) -> Any:
    """States (lanes, n, 6) of robots with these `constants` (constants, lanes), from the states x (lanes, n, 6), after
    the `spans` (n,) [s], each in so many `steps`, under the commands u (lanes, n, 2), forces [N] and moments [N m] w
    (lanes, n, 2)."""
    whole = np.zeros((len(constants) + 4, x.shape[0]))
    whole[: len(constants)] = constants
    block, end = block_of(whole), x.copy()
    for lane in range(x.shape[0]):
        known = constants_rolling(block, lane)
        for i in range(x.shape[1]):
            h = spans[i] / steps
            if h <= 0:  # readings of one sample follow each other at once
                continue
            a, b, c, d, e, f = x[lane, i]
            left, right, force, moment = u[lane, i, 0], u[lane, i, 1], w[lane, i, 0], w[lane, i, 1]
            for _ in range(steps):
                a, b, c, d, e, f = rk4_rolling(a, b, c, d, e, f, h, left, right, force, moment, *known)
            end[lane, i] = np.array([a, b, c, d, e, f])
    return end


@njit
def propagate(phi: Any, pushed: Any, shifted: Any, reads: Any, gains: Any, deviation: Any) -> Any:
    """What faults add to the whitened innovations (events, faults) of a filter that corrects what they do to its state.

    Each event's flow is `phi` (events, 6, 6), its gain `gains` (events, states), its reading `reads` (events, states),
    whose innovation has this standard `deviation` (events,), NaN where none is used. Faults enter the state,
    `pushed` (events, 6, faults), and readings, `shifted` (events, faults); either may have one row for all.
    """
    n, size, faults = len(phi), gains.shape[1], pushed.shape[2]
    error, before = np.zeros((size, faults)), np.zeros((6, faults))
    innovation, response = np.zeros(faults), np.zeros((n, faults))
    for i in range(n):
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
    return response


@njit
def observe(
    constants: Any, steps: int, first: Any, u: Any, spans: Any, reads: Any, gains: Any, readings: Any, deviation: Any,
    forces: Any,
) -> Any:  # fmt: skip
    """Whitened innovations (lanes, events) of a robot with these `constants` from the state `first` on, under the
    commands u (events, 2), and `forces` [N] and moments [N m] (lanes, events, 2).

    A filter that has the `gains` (events, states) corrects the state by what the `readings` (events,) show beyond it.
    """
    n, size = len(spans), gains.shape[1]
    seen = np.zeros((len(forces), n))
    whole = np.zeros((len(constants) + 4, 1))
    whole[: len(constants), 0] = constants
    known = constants_rolling(block_of(whole), 0)
    for lane in range(len(forces)):
        x = first.copy()
        for i in range(n):
            h = spans[i] / steps
            if h > 0:
                a, b, c, d, e, f = x[0], x[1], x[2], x[3], x[4], x[5]
                left, right, force, moment = u[i, 0], u[i, 1], forces[lane, i, 0], forces[lane, i, 1]
                for _ in range(steps):
                    a, b, c, d, e, f = rk4_rolling(a, b, c, d, e, f, h, left, right, force, moment, *known)
                x[0], x[1], x[2], x[3], x[4], x[5] = a, b, c, d, e, f
            if math.isnan(deviation[i]):
                continue
            innovation = readings[i]
            for state in range(size):
                innovation -= reads[i, state] * x[state]
            for state in range(size):
                x[state] += gains[i, state] * innovation
            seen[lane, i] = innovation / deviation[i]
    return seen
