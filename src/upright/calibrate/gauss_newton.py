"""Gauss–Newton down the posterior of a calibration, along the curves on which the coefficients of the motion stay.

A log fixes products and quotients of masses, lengths and inertias far better than these: in the parameters its
likelihood is a narrow valley with bends, in the coefficients a bowl. So each iteration linearises the innovations in
the coefficients, and keeps these as the functions of the parameters that they are.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.fitting import Normal, Path, Problem, huber_weight, normal_equations, objective
from upright.calibrate.parameters import rows_of

Array = NDArray[np.float64]

FIRST_DAMPING = 1e-6  # [1] of the coefficients' own information: too little to shorten a good first step
DAMPING_UP, DAMPING_DOWN = 30.0, 30.0  # factors after a step that fails and one that succeeds (Marquardt 1963 has 10)
LEAST_RAISED = 1e-3  # [1] damping after a first failure: less would repeat nearly the same step
MOST_DAMPING = 1e6  # [1] beyond which a step is too short to matter, and none is tried
SHORT = 10.0  # tolerances: a failing step is not shortened below this length
NO_LOSS = 1e-2  # in log-likelihood: a step that loses less counts as level, as rounding and noise would have it
REACH = 3.0  # deviations of the prior that a parameter moves at most in one iteration
INNER = 25  # iterations along the coefficients' curves, at most
INNER_GAIN = 1e-5  # in log-likelihood: gain that ends them, a thousandth of `NO_LOSS`
FIRST_BRAKE, LEAST_BRAKE, MOST_BRAKE = 1e-9, 1e-6, 1e9  # damping of the inner steps: first, after a failure, most
MORE_BRAKE = 2.0  # [1] factor after a first failure, doubled after each further one; after a success Nielsen's (1999)

CONVERGED, NO_DESCENT, OUT_OF_ITERATIONS = "converged", "no step lowers the objective", "iterations used up"


class Minimum(NamedTuple):
    """Where the search ended: z, derivatives and filters there, and why it `stopped`."""

    z: Array
    normal: Normal
    paths: list[Path]
    stopped: str


def gauss_newton(problem: Problem, z: Array, *, iterations: int, tolerance: float = 0.02) -> Minimum:
    """z of least objective, with damping after Marquardt (1963) and bounds by projection; converged when a step is less
    than `tolerance` of every parameter's posterior deviation."""
    value, paths = objective(problem, z)
    normal = normal_equations(problem, z, paths, value)
    damping = FIRST_DAMPING
    for _ in range(iterations):
        spread = np.sqrt(np.diag(np.linalg.inv(normal.hessian)))
        lower, length, new, now, candidate = False, np.inf, z, value, paths
        while not lower and length > SHORT * tolerance and damping < MOST_DAMPING:
            new = _predicted_minimum(problem, z, normal, damping)
            length = np.abs((new - z) / spread).max()
            now, candidate = objective(problem, new)
            lower = now < value + NO_LOSS or (not np.isfinite(value) and np.isfinite(now))
            damping = damping / DAMPING_DOWN if lower else max(DAMPING_UP * damping, LEAST_RAISED)
        if not lower:
            return Minimum(z, normal, paths, NO_DESCENT)
        z, value, paths = new, now, candidate
        normal = normal_equations(problem, z, paths, value)
        if length < tolerance:
            return Minimum(z, normal, paths, CONVERGED)
    return Minimum(z, normal, paths, OUT_OF_ITERATIONS)


def _predicted_minimum(problem: Problem, z: Array, normal: Normal, damping: float) -> Array:
    """Where the objective would be least if innovations were linear in the coefficients, at most `REACH` away.

    The coefficients themselves are taken as they are: products and quotients of parameters, along whose curved valleys
    straight steps would have to be short.
    """
    least = np.maximum([p.least for p in problem.parameters], z - REACH)
    bowls: list[tuple[Array, Array, Array]] = []
    for part, (q, _) in zip(normal.linear, problem.by_parameter(z), strict=True):
        weighed = huber_weight(part.whitened)[:, None] * part.by_coefficient
        A = problem.temper * part.by_coefficient.T @ weighed
        bowls.append(
            (q[part.rows] / part.unit, A + damping * np.diag(np.diag(A)), problem.temper * weighed.T @ part.whitened)
        )

    def value(y: Array) -> float:
        q = (c[:, 0] for c in problem.coefficients_of_runs(y[:, None]))
        steps = [at[part.rows] / part.unit - c for part, (c, *_), at in zip(normal.linear, bowls, q, strict=True)]
        return 0.5 * float(y @ y) + sum(
            float(g @ d + 0.5 * d @ A @ d) for d, (_, A, g) in zip(steps, bowls, strict=True)
        )

    def derivatives(y: Array) -> tuple[Array, Array]:
        gradient, hessian = y, np.eye(len(y))
        for part, (at, A, g), (q, C) in zip(normal.linear, bowls, problem.by_parameter(y), strict=True):
            slopes = C[part.rows] / part.unit[:, None]
            gradient = gradient + slopes.T @ (g + A @ (q[part.rows] / part.unit - at))
            hessian += slopes.T @ A @ slopes
        return gradient, hessian

    y, now, brake, more = z, value(z), FIRST_BRAKE, MORE_BRAKE
    for _ in range(INNER):
        gradient, hessian = derivatives(y)
        free = rows_of(problem.active & ~((y <= least + 1e-9) & (gradient > 0)))
        while brake < MOST_BRAKE:
            step = np.zeros_like(y)
            braked = (hessian + brake * np.diag(np.diag(hessian)))[np.ix_(free, free)]
            step[free] = -np.linalg.solve(braked, gradient[free])
            new = np.clip(y + step, least, z + REACH)
            expected = -(gradient @ (new - y)) - 0.5 * (new - y) @ hessian @ (new - y)
            if expected < INNER_GAIN and (new == y + step).all():
                return y
            gained = now - value(new)
            if gained > 0:
                break
            brake, more = max(more * brake, LEAST_BRAKE), 2 * more
        else:
            break
        y, now, more = new, now - gained, MORE_BRAKE
        brake *= max(0.1, 1 - (2 * gained / max(expected, gained) - 1) ** 3)
        if gained < INNER_GAIN:
            break
    return y
