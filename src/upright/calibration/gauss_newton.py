"""Gauss–Newton down the posterior of a calibration, along the curves on which the coefficients of the motion stay.

A log fixes products and quotients of masses, lengths and inertias far better than these: in the parameters its
likelihood is a narrow valley with bends, in the coefficients a bowl. So each iteration linearises the innovations in
the coefficients, and keeps these as the functions of the parameters that they are (`curves`): products and quotients,
along whose valleys straight steps would have to be short.

A dead zone is no such bowl. Commands have levels, and its likelihood has an optimum between any two of them, so that a
descent ends at the next one. From there the likeliest of several is taken, as long as that gains.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from upright.arrays import Array
from upright.calibration.electronics import DEAD_ZONE
from upright.calibration.fitting import Normal, Path, Problem, normal_equations, objective
from upright.calibration.threads import in_threads

FIRST_DAMPING = 1e-6  # [1] of the coefficients' own information: too little to shorten a good first step
DAMPING_UP, DAMPING_DOWN = 30.0, 30.0  # factors after a step that fails and one that succeeds (Marquardt 1963 has 10)
LEAST_RAISED = 0.03  # [1] damping after a first failure: less would repeat nearly the same step
MOST_DAMPING = 1e6  # [1] beyond which a step is too short to matter, and none is tried
SHORT = 10.0  # tolerances: a failing step is not shortened below this length
NO_LOSS = 1e-2  # in log-likelihood: a step that loses less counts as level, as rounding and noise would have it

ZONES = (0.0, 0.15, 0.3, 0.5, 0.75, 1.0, 1.5, 2.2, 3.2, 4.5, 6.5, 9.0)
"""[1] of the prior's dead zone: those that are tried. Up to the prior's they are a third of a deviation to one of them
apart, and above it each is about 1.4 times the one before."""
NEAR = ((0.85, 0.9, 0.95, 1.05, 1.1, 1.15), (0.98, 0.99, 0.995, 1.005, 1.01, 1.02))
"""[1] of the likeliest dead zone, where that is likelier than none: its neighbours, and those of the likeliest of them,
since commands may have levels as close."""
CHANGES = 3  # of a dead zone, at most
GAIN = 1.0  # in log-likelihood, from which a dead zone is another

CONVERGED, NO_DESCENT, OUT_OF_ITERATIONS = "converged", "no step lowers the objective", "iterations used up"


class Minimum(NamedTuple):
    """Where the search ended: z, derivatives and filters there, and why it `stopped`."""

    z: Array
    normal: Normal
    paths: list[Path]
    stopped: str


def gauss_newton(
    problem: Problem, z: Array, *, iterations: int, tolerance: float = 0.02, zones: bool = False
) -> Minimum:
    """z of least objective: what descent finds, and with `zones` from there with likelier dead zones; each in so many
    `iterations` at most."""
    least = _descended(problem, z, iterations, tolerance)
    return rezoned(problem, least, iterations, tolerance) if zones else least


def rezoned(problem: Problem, least: Minimum, iterations: int, tolerance: float = 0.02) -> Minimum:
    """From where a search ended down from a likelier dead zone, which stays there, as long as there is one."""
    for _ in range(CHANGES if np.isfinite(least.normal.objective) else 0):
        other = with_other_zone(problem, least.z, least.normal.objective)
        if other is None:
            break
        still = replace(problem, held=problem.held | {DEAD_ZONE})
        least = _descended(still, other, iterations, tolerance)
    return least


def with_other_zone(problem: Problem, z: Array, value: float) -> Array | None:
    """z (parameters,) with the likeliest of several dead zones; None where none is likelier than at the `value` of the
    objective, or none is asked."""
    for i, p in enumerate(problem.parameters):
        if p.name == DEAD_ZONE and problem.active[i]:
            tries, values = _of_zones(problem, z, i, [p.prior * part for part in ZONES])
            now = float(p.value(z[i]))
            for near in NEAR if now and min(value, *values) < values[0] - GAIN else ():
                likeliest = now if value <= min(values) else float(p.value(tries[int(np.argmin(values)), i]))
                more, of_more = _of_zones(problem, z, i, [likeliest * part for part in near])
                tries = np.vstack([tries, more])
                values = [*values, *of_more]
            best = int(np.argmin(values))
            return tries[best] if values[best] < value - GAIN else None
    return None


def _of_zones(problem: Problem, z: Array, place: int, zones: list[float]) -> tuple[Array, list[float]]:
    """z (zones, parameters) with each of these dead zones at its `place`, and the objective there."""
    p = problem.parameters[place]
    tries = np.repeat(z[None], len(zones), axis=0)
    tries[:, place] = [max(p.coordinate(zone), p.least) for zone in zones]
    return tries, in_threads(lambda one: objective(problem, one)[0], tries)


def _descended(problem: Problem, z: Array, iterations: int, tolerance: float) -> Minimum:
    """z of least objective, with damping after Marquardt (1963) and bounds by projection; converged when a step is less
    than `tolerance` of every parameter's posterior deviation. A step that fails is tried with the dead zone still."""
    from upright.calibration.curves import downhill

    least = np.array([p.least for p in problem.parameters])
    still = problem.active & np.array([p.name != DEAD_ZONE for p in problem.parameters])
    moving = (problem.active,) if (still == problem.active).all() else (problem.active, still)
    value, paths = objective(problem, z)
    normal = normal_equations(problem, z, paths, value)
    damping = FIRST_DAMPING
    for _ in range(iterations):
        spread = np.sqrt(np.diag(np.linalg.inv(normal.hessian)))
        lower = False
        length = np.inf
        new = z
        now = value
        candidate = paths
        while not lower and length > SHORT * tolerance and damping < MOST_DAMPING:
            for free in moving:
                new = downhill(np.array(z), problem.curves, normal.bowls, damping, (least, free))
                length = np.abs((new - z) / spread).max()
                now, candidate = objective(problem, new)
                lower = now < value + NO_LOSS or (not np.isfinite(value) and np.isfinite(now))
                if lower:
                    break
            damping = damping / DAMPING_DOWN if lower else max(DAMPING_UP * damping, LEAST_RAISED)
        if not lower:
            return Minimum(z, normal, paths, NO_DESCENT)
        z, value, paths = new, now, candidate
        normal = normal_equations(problem, z, paths, value)
        if length < tolerance:
            return Minimum(z, normal, paths, CONVERGED)
    return Minimum(z, normal, paths, OUT_OF_ITERATIONS)
