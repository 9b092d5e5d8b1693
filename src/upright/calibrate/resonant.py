"""Whether the gyro of a log has a resonance: the fit with one, where it is clearly likelier than the fit without."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial

import numpy as np

from upright.arrays import Array
from upright.calibrate.fitting import Fitted, Problem, objective
from upright.calibrate.gauss_newton import gauss_newton
from upright.calibrate.informativity import MARGIN, score_covariance
from upright.calibrate.resonance import DAMPING, FREQUENCY, SWING, TYPICAL, parameters_about
from upright.calibrate.threads import CORES, in_threads

FREQUENCIES = (5.0, 7.0, 10.0, 14.0, 20.0, 28.0, 40.0, 56.0)
"""[Hz] of the starts, half an octave apart: a resonance with a damping of 0.1 or more is nearly as wide as that."""
DAMPINGS = (0.1, 0.7)
"""[1] of the starts: what swings, and a filter."""
ITERATIONS = 5  # of Gauss–Newton from each start, before the noise is learnt again at the best


def resonant(fit: Fitted, settled: Callable[[Problem, Array], Fitted]) -> Fitted | None:
    """The fit with a resonance, from one without; None where it is not likelier by `MARGIN`. `settled` learns
    parameters and noise from a start."""
    with ThreadPoolExecutor(CORES) as pool:
        tries = [*pool.map(_nearby, _starts(*fit[:2]))]
        value, problem, z = min(tries, key=lambda one: one[0], default=(math.inf, *fit[:2]))
        if not math.isfinite(value):
            return None
        other = settled(problem, z)
        likelier, less = pool.map(partial(evidence, weight=weight_of(other)), (other, fit))
    nats = likelier - less
    return other._replace(problem=replace(other.problem, resonance=nats)) if nats >= MARGIN else None


def _nearby(start: tuple[Problem, Array]) -> tuple[float, Problem, Array]:
    """The objective near a start, and its problem and z (parameters,) there."""
    least = gauss_newton(*start, iterations=ITERATIONS)
    return least.normal.objective, start[0], least.z


def weight_of(fit: Fitted) -> float:
    """What readings count for the two numbers of a resonance, whose innovations are not white: the covariance that
    takes them for white over the one that does not (Chandler and Bate 2007), at most 1."""
    problem, _, normal, paths = fit
    two = [i for i, p in enumerate(problem.parameters) if p.name in TYPICAL]
    white = np.linalg.inv(normal.hessian)
    true = white @ (problem.temper**2 * score_covariance(problem, normal, paths) + np.eye(len(white))) @ white
    ratio = np.trace(np.linalg.solve(white[np.ix_(two, two)], true[np.ix_(two, two)])) / 2
    return float(min(1.0, 1 / ratio))


def evidence(fit: Fitted, weight: float) -> float:
    """The logarithm of the marginal likelihood, up to a constant, where readings have this `weight`: the posterior at
    its peak, times the volume of the peak over that of the prior (Laplace's approximation)."""
    least = gauss_newton(replace(fit.problem, temper=weight), fit.z, iterations=ITERATIONS).normal
    return -least.objective - 0.5 * float(np.linalg.slogdet(least.hessian)[1])


def resonating(problem: Problem, z: Array, frequency: float, damping: float) -> tuple[Problem, Array]:
    """The problem with a resonance of the gyro, and z (parameters,) with it there; its gyro is less late by the delay
    2ζ/ω of the resonance."""
    place, two = len(problem.asked), parameters_about(TYPICAL[FREQUENCY], TYPICAL[DAMPING])
    parameters = (*problem.parameters[:place], *two, *problem.parameters[place:])
    at = [p.coordinate(value) for p, value in zip(two, (frequency, damping), strict=True)]
    new = np.concatenate([z[:place], at, z[place:]])
    for i, p in enumerate(problem.asked):
        if p.name == "delay/gyro":
            new[i] = max(p.coordinate(float(p.value(z[i])) - damping / (math.pi * frequency)), p.least)
    recordings = tuple(r.swinging() for r in problem.recordings)
    return replace(problem, parameters=parameters, recordings=recordings), new


def _starts(problem: Problem, z: Array) -> Iterator[tuple[Problem, Array]]:
    """For each damping the frequencies that are likelier than their neighbours, all else as in the fit at z."""
    for damping in DAMPINGS:
        each = [resonating(problem, z, frequency, damping) for frequency in FREQUENCIES]
        values = np.array([math.inf, *in_threads(lambda one: objective(*one)[0], each), math.inf])
        for i, one in enumerate(each):
            if values[i + 1] <= min(values[i], values[i + 2]) and math.isfinite(values[i + 1]):
                yield one


def with_that_of(problem: Problem, z: Array, other: Problem, at: Array) -> tuple[Problem, Array]:
    """The problem without a resonance, and its z (parameters,), with the resonance that the `other` has `at`."""
    frequency, damping = (float(p.value(x)) for p, x in zip(other.asked, at, strict=False) if p.name in TYPICAL)
    new, z = resonating(problem, z, frequency, damping)
    noise = {**new.noise, SWING: other.noise[SWING]}
    return replace(new, noise=noise, resonance=other.resonance), z


def at_prior(problem: Problem, z: Array) -> Array:
    """The prior's coordinates (parameters,), with the resonance that z has."""
    own = [p.name in TYPICAL for p in problem.parameters]
    return np.where(own, z, 0.0)
