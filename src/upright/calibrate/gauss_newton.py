"""Gauss–Newton down the posterior of a calibration, along the curves on which the coefficients of the motion stay.

A log fixes products and quotients of masses, lengths and inertias far better than these: in the parameters its
likelihood is a narrow valley with bends, in the coefficients a bowl. So each iteration linearises the innovations in
the coefficients, and keeps these as the functions of the parameters that they are (`curves`): products and quotients,
along whose valleys straight steps would have to be short.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.fitting import Normal, Path, Problem, normal_equations, objective

Array = NDArray[np.float64]

FIRST_DAMPING = 1e-6  # [1] of the coefficients' own information: too little to shorten a good first step
DAMPING_UP, DAMPING_DOWN = 30.0, 30.0  # factors after a step that fails and one that succeeds (Marquardt 1963 has 10)
LEAST_RAISED = 1e-3  # [1] damping after a first failure: less would repeat nearly the same step
MOST_DAMPING = 1e6  # [1] beyond which a step is too short to matter, and none is tried
SHORT = 10.0  # tolerances: a failing step is not shortened below this length
NO_LOSS = 1e-2  # in log-likelihood: a step that loses less counts as level, as rounding and noise would have it

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
    from upright.calibrate.curves import downhill

    least = np.array([p.least for p in problem.parameters])
    value, paths = objective(problem, z)
    normal = normal_equations(problem, z, paths, value)
    damping = FIRST_DAMPING
    for _ in range(iterations):
        spread = np.sqrt(np.diag(np.linalg.inv(normal.hessian)))
        lower, length, new, now, candidate = False, np.inf, z, value, paths
        while not lower and length > SHORT * tolerance and damping < MOST_DAMPING:
            new = downhill(np.array(z), problem.curves, normal.bowls, damping, (least, problem.active))
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
