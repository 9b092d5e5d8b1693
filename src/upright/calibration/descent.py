"""Down to the first state from which a robot, simulated freely, follows its readings best: compiled."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from upright.calibration.motion import njit
from upright.calibration.predictor import innovations

MISSED = 1e4  # squared error, over its scale, of a reading beyond a fall: as far off as what varies a hundredfold
NUDGES = np.array([1e-5, 1e-4, 1e-4, 1e-3, 1e-4, 1e-3, 1e-4, 1e-4])  # steps in the first state, of its own size
SPANS = np.array([0.05, 0.5, 0.5, 5.0, 0.5, 2.0, 0.5, 0.5])
"""[rad, rad/s] A weak hold, so that a still wheel is no singularity; the last two are of a gyro that swings."""
ITERATIONS = 12  # of Gauss–Newton, at most
FIRST_DAMPING, MOST_DAMPING = 1e-4, 1e4  # of Levenberg and Marquardt, of the normal equations' diagonal
LESS, MORE, LEAST_RAISED = 0.1, 30.0, 1e-3  # [1] factors of it after a success and a failure, and the least after this
LEVEL = 0.9999  # [1] of the cost: one that falls by less is the last
SAME = 1e-3  # [1] of the weak hold: first states so close descend to one


@njit
def costs(errors: Any) -> Any:
    """Sums of squares (lanes,) of errors (events, lanes) over their scale; what is beyond a fall counts as `MISSED`."""
    total = np.zeros(errors.shape[1])
    for k in range(len(errors)):
        for i in range(len(total)):
            total[i] += min(errors[k, i] ** 2, MISSED) if np.isfinite(errors[k, i]) else MISSED
    return total


@njit
def _normal(e: Any, hessian: Any, slope: Any) -> None:
    """The normal equations of the errors e (events, lanes) of a first state and its neighbours."""
    count = len(slope)
    J = np.zeros(count)
    for i in range(count):
        slope[i] = 0.0
        for j in range(count):
            hessian[i, j] = 1 / SPANS[i] ** 2 if i == j else 0.0
    for k in range(len(e)):
        there = e[k, 0] * e[k, 0] < MISSED
        for i in range(count):
            J[i] = (e[k, 1 + i] - e[k, 0]) / NUDGES[i]
            there = there and np.isfinite(J[i])
        if there:
            for i in range(count):
                slope[i] += J[i] * e[k, 0]
                for j in range(count):
                    hessian[i, j] += J[i] * J[j]


@njit
def damped_step(hessian: Any, damping: Any, slope: Any, L: Any, step: Any) -> None:
    """Solves (H + damping · diag H) step = slope, by Cholesky's factor L."""
    count = len(slope)
    for i in range(count):
        for j in range(i + 1):
            left = hessian[i, j] * (1 + damping if i == j else 1.0)
            for k in range(j):
                left -= L[i, k] * L[j, k]
            L[i, j] = math.sqrt(left) if i == j else left / L[j, j]
        step[i] = slope[i]
        for k in range(i):
            step[i] -= L[i, k] * step[k]
        step[i] /= L[i, i]
    for i in range(count - 1, -1, -1):
        for k in range(i + 1, count):
            step[i] -= L[k, i] * step[k]
        step[i] /= L[i, i]


@njit
def _near(state: Any, known: Any, free: Any) -> Any:
    """Whether a state is one that is `known` already."""
    near = True
    for i in range(len(free)):
        near = near and abs(state[free[i]] - known[free[i]]) < SAME * SPANS[i]
    return near


@njit
def descended(events: Any, robot: Any, readings: Any, first: Any, known: Any, free: Any, longest: Any) -> Any:
    """The first state (states,) of least error near `first`, and its cost, by damped Gauss–Newton in the states that
    are `free` (free,); as far as to one that is `known` already. `readings` are the events and the scale of each, over
    which errors count (readings,); `robot` is in a lane for the first state and one for each that is free, in steps of
    at most `longest` [s]."""
    read, scale = readings
    size = len(first)
    count = len(free)
    gains = np.zeros((len(events.order), len(first)))
    best = first.copy()
    candidate = first.copy()
    least = np.inf
    damping = FIRST_DAMPING
    hessian = np.zeros((count, count))
    L = np.zeros((count, count))
    slope = np.zeros(count)
    step = np.zeros(count)
    lanes = np.empty((size, 1 + count))
    e = np.empty((len(read), 1 + count))
    for _ in range(ITERATIONS):
        for i in range(1 + count):
            for j in range(size):
                lanes[j, i] = candidate[j]
            if i > 0:
                lanes[free[i - 1], i] += NUDGES[i - 1]
        missed = innovations(events, robot, lanes, gains, longest)
        for k in range(len(read)):
            for i in range(1 + count):
                e[k, i] = missed[read[k], i] / scale[k]
        cost = costs(e)[0]
        if cost < least:
            done = cost > LEVEL * least
            least = cost
            damping = LESS * damping
            best[:] = candidate
            _normal(e, hessian, slope)
            if done or _near(candidate, known, free):
                break
        else:
            damping = max(MORE * damping, LEAST_RAISED)
            if damping > MOST_DAMPING:
                break
        damped_step(hessian, damping, slope, L, step)
        candidate[:] = best
        for i in range(count):
            candidate[free[i]] -= step[i]
    return best, least
