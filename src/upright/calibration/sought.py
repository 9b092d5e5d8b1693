"""A cause that a log may have beside its robot: the fit with it, where it is clearly likelier than the fit without.

Both fits are compared by their marginal likelihood, so that the priors of the cause's own parameters are paid for, with
readings weighted by what their correlated innovations leave of them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Iterable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial

import numpy as np

from upright.arrays import Array
from upright.calibration.electronics import DROP, MISALIGNED
from upright.calibration.fitting import Fitted, Problem
from upright.calibration.gauss_newton import gauss_newton
from upright.calibration.informativity import MARGIN, score_covariance
from upright.calibration.parameters import Parameter
from upright.calibration.resonance import TYPICAL
from upright.calibration.threads import CORES

ITERATIONS = 5  # of Gauss–Newton from each start, before the noise is learnt again at the best
SOUGHT = frozenset({*TYPICAL, DROP, MISALIGNED})
"""The parameters of such causes."""


def likelier(
    fit: Fitted,
    starts: Iterable[tuple[Problem, Array]],
    names: Collection[str],
    settled: Callable[[Problem, Array], Fitted],
) -> tuple[Fitted, float] | None:
    """The fit with the parameters of these `names`, from the best of the `starts`, and by how many nats it is likelier
    than the `fit` without them; None where that is less than `MARGIN`. `settled` learns parameters and noise from a
    start, where the same noise already gains as much."""
    with ThreadPoolExecutor(CORES) as pool:
        tries = [*pool.map(_nearby, starts)]
        value, problem, z = min(tries, key=lambda one: one[0], default=(math.inf, *fit[:2]))
        if not fit.normal.objective - value >= MARGIN:
            return None
        other = settled(problem, z)
        more, less = pool.map(partial(evidence, weight=weight_of(other, names)), (other, fit))
    return (other, more - less) if more - less >= MARGIN else None


def _nearby(start: tuple[Problem, Array]) -> tuple[float, Problem, Array]:
    """The objective near a start, and its problem and z (parameters,) there."""
    least = gauss_newton(*start, iterations=ITERATIONS)
    return least.normal.objective, start[0], least.z


def weight_of(fit: Fitted, names: Collection[str]) -> float:
    """What readings count for the parameters of these `names`, whose innovations are not white: the covariance that
    takes them for white over the one that does not (Chandler and Bate 2007), at most 1."""
    problem, _, normal, paths, _ = fit
    own = [i for i, p in enumerate(problem.parameters) if p.name in names]
    white = np.linalg.inv(normal.hessian)
    true = white @ (problem.temper**2 * score_covariance(problem, normal, paths) + np.eye(len(white))) @ white
    ratio = np.trace(np.linalg.solve(white[np.ix_(own, own)], true[np.ix_(own, own)])) / len(own)
    return float(min(1.0, 1 / ratio))


def evidence(fit: Fitted, weight: float) -> float:
    """The logarithm of the marginal likelihood, up to a constant, where readings have this `weight`: the posterior at
    its peak, times the volume of the peak over that of the prior (Laplace's approximation)."""
    least = gauss_newton(replace(fit.problem, temper=weight), fit.z, iterations=ITERATIONS).normal
    return laplace(least.objective, least.hessian)


def laplace(least: float, hessian: Array) -> float:
    """The logarithm of the volume under a peak, up to a constant: of the `least` objective and its Hessian (n, n)
    there, by coordinates of which the prior takes each for standard normal."""
    return -least - 0.5 * float(np.linalg.slogdet(hessian)[1])


def with_parameters(problem: Problem, z: Array, added: Mapping[Parameter, float]) -> tuple[Problem, Array]:
    """The problem that asks these parameters too, and z (parameters,) with their values."""
    place = len(problem.asked)
    new = np.concatenate([z[:place], [p.coordinate(value) for p, value in added.items()], z[place:]])
    return replace(problem, parameters=(*problem.parameters[:place], *added, *problem.parameters[place:])), new


def values_of(problem: Problem, z: Array, names: Collection[str]) -> dict[Parameter, float]:
    """The parameters of these `names`, each with its value at z (parameters,)."""
    return {p: float(p.value(x)) for p, x in zip(problem.asked, z, strict=False) if p.name in names}


def with_those_of(problem: Problem, z: Array, other: Problem, at: Array) -> tuple[Problem, Array]:
    """The problem with a drop and a tilt of the gyro that the `other` has `at` its z (parameters,), and its own z."""
    names = {p.name for p in other.asked} - {p.name for p in problem.asked}
    new, z = with_parameters(problem, z, values_of(other, at, names))
    return replace(new, drop=other.drop, misalignment=other.misalignment), z


def at_prior(problem: Problem, z: Array) -> Array:
    """The prior's coordinates (parameters,), with the causes that z has."""
    return np.where([p.name in SOUGHT for p in problem.parameters], z, 0.0)
