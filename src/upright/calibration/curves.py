"""The curves on which the coefficients stay while the parameters move, and the way down along them: compiled."""

from __future__ import annotations

import math
from importlib import import_module
from typing import Any

import numpy as np

from upright.calibration import parameters
from upright.calibration.coefficients import (
    AT,
    DELAYS,
    DRIVEN,
    EXACT,
    LEVEL,
    LOST,
    SMOOTH,
    TURN_READ,
    TURNED,
    Bowls,
    around,
    slopes_of,
)
from upright.calibration.descent import damped_step
from upright.calibration.kept import njit
from upright.compiled import generated
from upright.compiled.jit import numba
from upright.robots import PARAMETERS
from upright.robots.uncertainty import roll_bounds

PLAIN = len(PARAMETERS)
"""Where among the numbers of `Priors` begin those of the electronics, and after these the dead times."""
DEAD_TIMES = PLAIN + DELAYS - DRIVEN
ROLL, PITCH, YAW = ([*PARAMETERS].index(f"{axis}_inertia") for axis in ("roll", "pitch", "yaw"))

REACH = 3.0  # deviations of the prior that a parameter moves at most in one iteration
INNER = 25  # iterations along the coefficients' curves, at most
INNER_GAIN = 1e-5  # in log-likelihood: gain that ends them, a thousandth of Gauss–Newton's own `NO_LOSS`
FIRST_BRAKE, LEAST_BRAKE, MOST_BRAKE = 1e-9, 1e-6, 1e9  # damping of the inner steps: first, after a failure, most
MORE_BRAKE = 2.0  # [1] factor after a first failure, doubled after each further one; after a success Nielsen's (1999)

_fixed_tuple: Any = import_module("numba.np.unsafe.ndarray").to_fixed_tuple
_compiled: Any = numba.njit(error_model="numpy")
_value_at, _between, _roll_bounds, _constants, _around, _slopes_of = map(
    _compiled, (parameters.value_at, parameters.between, roll_bounds, generated.constants, around, slopes_of)
)


@njit
def numbers_at(z: Any, priors: Any) -> Any:
    """The numbers that the coefficients follow from (n, lanes) at the coordinates z (asked and more, lanes)."""
    numbers = np.empty((len(priors.given), z.shape[1]))
    for i in range(len(numbers)):
        numbers[i] = priors.given[i]
    for k in range(len(priors.place)):
        for lane in range(z.shape[1]):
            numbers[priors.place[k], lane] = _value_at(
                z[k, lane], priors.prior[k], priors.spread[k], priors.rate[k], priors.lower[k]
            )
    return numbers


@njit
def coefficients(z: Any, priors: Any) -> Any:
    """The coefficients (coefficients, lanes) at z (asked and more, lanes): the constants of the equations of motion,
    each with the error that z has for it after what is asked; factor of the left and of the right motor, dead zone,
    constant command, and the drop in volts of the logged command; what the gyro reads of the yaw rate; the dead time of
    each sensor; ω [rad/s] and ζ of a resonance."""
    numbers = numbers_at(z, priors)
    asked = len(priors.place)
    tail = len(numbers) - DEAD_TIMES
    q = np.empty((DELAYS + tail, z.shape[1]))
    for lane in range(z.shape[1]):
        bounds = _roll_bounds(numbers[PITCH, lane], numbers[YAW, lane])
        numbers[ROLL, lane] = _between(bounds, numbers[ROLL, lane])
        for row, value in enumerate(_constants(_fixed_tuple(numbers[:PLAIN, lane], PLAIN), 1.0)):
            q[row, lane] = value
        coupling = TURNED / EXACT * math.sqrt(q[AT.pitch_inertia, lane]) if priors.rubs else q[AT.rotor_coupling, lane]
        for k in range(len(z) - asked):
            size = coupling if LEVEL[k] == AT.rotor_coupling else q[LEVEL[k], lane]
            if LEVEL[k] == AT.stiction_rate_squared:
                q[LEVEL[k], lane] *= math.exp(-SMOOTH * z[asked + k, lane])
            else:
                q[LEVEL[k], lane] += EXACT * size * z[asked + k, lane]
        half = numbers[PLAIN, lane] / 2
        supply = numbers[PLAIN + 1, lane]
        q[DRIVEN, lane], q[DRIVEN + 1, lane] = supply * (1 - half), supply * (1 + half)
        q[DRIVEN + 2, lane], q[DRIVEN + 3, lane] = numbers[PLAIN + 2, lane], numbers[PLAIN + 3, lane]
        q[LOST, lane], q[TURN_READ, lane] = numbers[PLAIN + 4, lane] / supply, numbers[PLAIN + 5, lane]
        for k in range(tail):
            q[DELAYS + k, lane] = numbers[DEAD_TIMES + k, lane]
        if priors.swings:
            q[-2, lane] *= 2 * math.pi
    return q


@njit
def of_run(z: Any, run: Any, curves: Any) -> Any:
    """The numbers of one run (shared, lanes) at z (parameters, lanes): the robot's, and what this run adds."""
    own = np.zeros((len(curves.least), z.shape[1]))
    for i in range(len(own)):
        for k in range(len(z)):
            part = curves.maps[run, i, k]
            if part != 0:
                for lane in range(z.shape[1]):
                    own[i, lane] += part * z[k, lane]
        for lane in range(z.shape[1]):
            own[i, lane] = max(own[i, lane], curves.least[i])
    return own


@njit
def coefficients_of(z: Any, run: Any, curves: Any) -> Any:
    """The coefficients of one run (coefficients, lanes) at z (parameters, lanes)."""
    return coefficients(of_run(z, run, curves), curves.priors)


@njit
def by_parameter(z: Any, run: Any, curves: Any) -> Any:
    """The coefficients (coefficients,) of a run at z (parameters,), and their slopes (coefficients, parameters)."""
    q = coefficients(_around(of_run(z.reshape(len(z), 1), run, curves)), curves.priors)
    return q[:, -1].copy(), _product(_slopes_of(q), curves.maps[run])


@njit
def _product(A: Any, B: Any) -> Any:
    """The product of two matrices (n, m) and (m, k)."""
    C = np.zeros((len(A), B.shape[1]))
    for i in range(len(A)):
        for j in range(len(B)):
            for k in range(B.shape[1]):
                C[i, k] += A[i, j] * B[j, k]
    return C


@njit
def bowl_value(y: Any, curves: Any, bowls: Any) -> Any:
    """The objective that the `bowls` make at y (parameters,)."""
    total = 0.0
    for k in range(len(y)):
        total += 0.5 * y[k] * y[k]
    for run in range(len(bowls.at)):
        d = coefficients(of_run(y.reshape(len(y), 1), run, curves), curves.priors)[:, 0] - bowls.at[run]
        for i in range(len(d)):
            slope = bowls.gradient[run, i]
            for j in range(len(d)):
                slope += 0.5 * bowls.hessian[run, i, j] * d[j]
            total += slope * d[i]
    return total


@njit
def bowl_derivatives(y: Any, curves: Any, bowls: Any) -> Any:
    """Gradient (parameters,) and Hessian (parameters, parameters) of that objective at y (parameters,), without what
    the curves bend."""
    gradient = y.copy()
    hessian = np.eye(len(y))
    for run in range(len(bowls.at)):
        q, C = by_parameter(y, run, curves)
        weighed = _product(bowls.hessian[run], C)
        hessian += _product(C.T.copy(), weighed)
        for k in range(len(y)):
            for i in range(len(q)):
                gradient[k] += C[i, k] * bowls.gradient[run, i] + weighed[i, k] * (q[i] - bowls.at[run, i])
    return gradient, hessian


@njit
def _step(gradient: Any, hessian: Any, brake: Any, free: Any) -> Any:
    """The step (parameters,) down, of those parameters alone that are `free`, with the Hessian's diagonal raised."""
    count = len(free)
    H = np.empty((count, count))
    L = np.empty((count, count))
    slope = gradient[free]
    part = np.empty(count)
    for i in range(count):
        H[i] = hessian[free[i]][free]
    damped_step(H, brake, slope, L, part)
    step = np.zeros(len(gradient))
    step[free] = -part
    return step


@njit
def downhill(z: Any, curves: Any, bowls: Any, damping: Any, limits: Any) -> Any:
    """Where the objective that the `bowls` make is least, these steeper by the `damping` of their own diagonal: from z
    (parameters,), at most `REACH` away. The `limits` are the least of each parameter (parameters,), and which of them
    are active. By Gauss–Newton with Nielsen's damping (1999)."""
    bowls = Bowls(bowls.at, bowls.gradient, bowls.hessian.copy())
    for run in range(len(bowls.at)):
        for i in range(bowls.at.shape[1]):
            bowls.hessian[run, i, i] *= 1 + damping
    least = np.maximum(limits[0], z - REACH)
    most = z + REACH
    active = limits[1]
    y = z
    now = bowl_value(z, curves, bowls)
    brake = FIRST_BRAKE
    more = MORE_BRAKE
    for _ in range(INNER):
        gradient, hessian = bowl_derivatives(y, curves, bowls)
        free = np.flatnonzero(active & ~((y <= least + 1e-9) & (gradient > 0)))
        new = y
        gained = 0.0
        expected = 0.0
        while brake < MOST_BRAKE:
            step = _step(gradient, hessian, brake, free)
            new = np.minimum(np.maximum(y + step, least), most)
            moved = new - y
            expected = -(gradient * moved).sum() - 0.5 * (moved * (hessian * moved).sum(axis=1)).sum()
            if expected < INNER_GAIN and (new == y + step).all():
                return y
            gained = now - bowl_value(new, curves, bowls)
            if gained > 0:
                break
            brake = max(more * brake, LEAST_BRAKE)
            more = 2 * more
        if not gained > 0:
            break
        y = new
        now -= gained
        more = MORE_BRAKE
        brake *= max(0.1, 1 - (2 * gained / max(expected, gained) - 1) ** 3)
        if gained < INNER_GAIN:
            break
    return y
