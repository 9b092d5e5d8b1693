"""Gauss–Newton down the posterior of a calibration, along the curves on which the coefficients of the motion stay.

A log fixes products and quotients of masses, lengths and inertias far better than these: in the parameters its
likelihood is a narrow valley with bends, in the coefficients a bowl. So each iteration linearises the innovations in
the coefficients, and keeps these as the functions of the parameters that they are.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.fitting import Normal, Path, Problem, normal_equations, objective
from upright.calibrate.parameters import rows_of

Array = NDArray[np.float64]

FIRST_DAMPING = 1e-6  # of the coefficients' own information
SHORT = 10.0  # tolerances: a step that gains nothing is not shortened below
HEAVY = 1e6  # damping beyond which no step is tried
FAR = 3.0  # deviations of the prior that a parameter moves at most in one iteration
INNER, ENOUGH = 25, 1e-5  # iterations along the coefficients' curves, and the gain in log-likelihood that ends them


def gauss_newton(
    problem: Problem, z: Array, *, iterations: int, tolerance: float = 0.02
) -> tuple[Array, Normal, list[Path]]:
    """z that makes the objective least, with damping after Marquardt (1963) and bounds by projection; stops when a
    step is less than `tolerance` of every parameter's posterior deviation."""
    value, paths = objective(problem, z)
    normal = normal_equations(problem, z, paths, value)
    damping = FIRST_DAMPING
    for _ in range(iterations):
        spread = np.sqrt(np.diag(np.linalg.inv(normal.hessian)))
        lower, length, new, now, candidate = False, np.inf, z, value, paths
        while not lower and length > SHORT * tolerance and damping < HEAVY:
            new = _foreseen(problem, z, normal, damping)
            length = np.abs((new - z) / spread).max()
            now, candidate = objective(problem, new)
            lower = now < value + 1e-2 or (not np.isfinite(value) and np.isfinite(now))
            damping = damping / 30 if lower else max(30 * damping, 1e-3)
        if lower:
            z, value, paths = new, now, candidate
            normal = normal_equations(problem, z, paths, value)
        if length < tolerance or not lower:
            break
    return z, normal, paths


def _foreseen(problem: Problem, z: Array, normal: Normal, damping: float) -> Array:
    """Where the objective would be least if innovations were linear in the coefficients, at most `FAR` away.

    The coefficients themselves are taken as they are: products and quotients of parameters, along whose curved valleys
    straight steps would have to be short.
    """
    rows, unit = normal.rows, normal.unit[normal.rows]
    least = np.maximum([p.least for p in problem.parameters], z - FAR)
    weighed = normal.weight[:, None] * normal.by_coefficient
    information, g = problem.temper * normal.by_coefficient.T @ weighed, problem.temper * weighed.T @ normal.whitened
    A = information + damping * np.diag(np.diag(information))
    q0 = problem.coefficients(z[:, None])[rows, 0] / unit

    def model(y: Array) -> tuple[float, Array, Array]:
        q, C = problem.by_parameter(y)
        d, slopes = q[rows] / unit - q0, C[rows] / unit[:, None]
        return float(g @ d + 0.5 * d @ A @ d + 0.5 * y @ y), d, slopes

    y, (value, d, slopes), brake = z, model(z), 1e-9
    for _ in range(INNER):
        gradient = slopes.T @ (g + A @ d) + y
        H = slopes.T @ A @ slopes + np.eye(len(z))
        free = rows_of(problem.active & ~((y <= least + 1e-9) & (gradient > 0)))
        while brake < 1e9:
            step = np.zeros_like(y)
            step[free] = -np.linalg.solve((H + brake * np.diag(np.diag(H)))[np.ix_(free, free)], gradient[free])
            new = np.clip(y + step, least, z + FAR)
            lower, *there = model(new)
            if lower < value:
                break
            brake = max(10 * brake, 1e-6)
        else:
            break
        gained, y, value, brake, (d, slopes) = value - lower, new, lower, brake / 10, there
        if gained < ENOUGH:
            break
    return y
