"""Which stated number is wrong, where a log contradicts what the robot's file states.

A log fixes products and quotients of the numbers of a robot. Where a stated one is wrong, the fit bends those that
their spreads hold least, and these may be right. So each is freed alone, as if it were a guess, in the bowls that the
readings make about the coefficients of the fit. The marginal likelihood (Laplace) says which of them explain the log,
each for itself, and whether one is clearly likelier than the others.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from types import MappingProxyType
from typing import NamedTuple, Protocol

import numpy as np

from upright.arrays import Array
from upright.calibration.coefficients import Bowls
from upright.calibration.electronics import BATTERY
from upright.calibration.estimate import FOREIGN, SURPRISE
from upright.calibration.fitting import Fitted, Problem, objective
from upright.calibration.gauss_newton import gauss_newton
from upright.calibration.parameters import LOSSES, Parameter, as_guess
from upright.calibration.refined import CLEARER, MISSED, leaves_less, only_noise, simulated
from upright.calibration.sought import laplace
from upright.errors import DesignFailed
from upright.pages import Quantity, Say
from upright.pages.terms import term
from upright.robots import PARAMETERS, Robot

ITERATIONS = 15  # of Gauss–Newton with what is freed
TURNS = 10  # of the way down in the bowls, each of which moves a parameter by three deviations at most
GAIN = 1e-3  # [nats] gain of a turn that ends it
LIKELIER = math.log(20)  # [nats] odds of twenty to one by which a number must be likelier wrong than none
CREDIBLE = 0.99  # [1] probability of the numbers of which one is said to be wrong
FAR = math.log(10)  # [1] deviation of the logarithm of a number that may be in another unit, or before a gear
LEAST = 1e-3  # [1] of a stated number that is above zero: where one that may be zero is tried with an open size
TOGETHER = 1.0
"""Deviations to which the other numbers fit where one alone is wrong: right ones were off by 0.6 at most, and with a
second wrong one by 1.4 and 1.9. Where they do not, all are doubted."""
NATURE = ("gravity",)  # which no file gets wrong by more than its spread
HEADING = "compass"
"""The sensor without which a log tells the track by what turning costs alone, as it does the yaw inertia: the floor's
friction against a wheel that turns on the spot, which no equation here has, would then be an error of the track."""


class Freed(NamedTuple):
    """What the log makes of a number (the file: `stated`) where it alone is taken for a guess: `value` [unit]. The
    logarithm of its marginal likelihood is `nats`, up to a constant; z (parameters,) is that fit in the bowls of its
    `problem`."""

    name: str
    unit: str
    stated: float
    value: float
    nats: float
    problem: Problem
    z: Array

    @property
    def as_number(self) -> Say:
        """The number, and what it would be, for people."""
        value, stated = (Quantity(x, self.unit) for x in (self.value, self.stated))
        return Say("{name} {value} (file: {stated})", name=term(self.name), value=value, stated=stated)


class Explained(NamedTuple):
    """A fit; the stated numbers of which one is wrong, the likeliest first; what that adds to the covariance of the
    fit's parameters (parameters, parameters); and where the file is doubted, how many times as wide as stated the
    deviations of stated numbers are taken in that fit, and by how many of them each `contradicted` number was off."""

    fit: Fitted
    freed: list[Freed]
    covariance: Array | float
    doubt: float = 1.0
    contradicted: Mapping[str, float] = MappingProxyType({})

    @property
    def scales(self) -> Array:
        """Deviations of each parameter (parameters,) in those that are stated."""
        return _scales(self.fit.problem.parameters, self.doubt)

    @property
    def as_stated(self) -> Problem:
        """The problem with the deviations that are stated."""
        parameters = self.fit.problem.parameters
        several = [replace(p, spread=p.spread / by) for p, by in zip(parameters, self.scales, strict=True)]
        return replace(self.fit.problem, parameters=tuple(several))


class Searching(Protocol):
    """Fits anew, with the numbers of these names as guesses, and stated ones `doubt` times as uncertain as stated.
    Raises `DesignFailed` where no start follows the log."""

    def __call__(self, *, guesses: Sequence[str] = (), doubt: float = 1.0) -> Fitted: ...


def explained(fit: Fitted, search: Searching) -> Explained:
    """The fit in which those numbers are guesses of which one, by the log, is wrong. Which one is open, so that each of
    their fits counts alike for the covariance.

    Where no single number explains the log clearly better, or its fit leaves more of half seconds than noise does and
    no less than before, all stated numbers are `_doubted_alike`. The `fit` stays as it is where half seconds are not
    predicted, since what the model leaves out bends numbers, too; and where a stated number is contradicted by more
    than `FOREIGN`, for then the log may be of another robot: what alone would explain it is named all the same.
    """
    stated = {p.name: p for p in fit.problem.parameters}
    if _most(fit.problem, fit.z) > FOREIGN or _rubs(fit.problem, fit.z):
        return Explained(fit, _single(fit, search), 0.0)
    if simulated(fit) < 1 - MISSED or not (first := _credible(fit, stated)):
        return _doubted_alike(fit, search)
    try:
        other = search(guesses=[one.name for one in first])
    except DesignFailed:
        return _doubted_alike(fit, search)
    freed = _credible(other, stated)
    if not freed:
        return _doubted_alike(fit, search)
    names = [one.name for one in freed]
    problem, z = _freed(other.problem, stated, other.z, names)
    result = gauss_newton(problem, _down(problem, z, other.normal.bowls), iterations=ITERATIONS, zones=True)
    other = Fitted(problem, result.z, result.normal, result.paths)
    if not only_noise(other) and not leaves_less(other, fit, CLEARER):
        return _doubted_alike(fit, search)
    alone = [_freed(one.problem, stated, one.z, names)[1] for one in freed]
    away = np.array(alone) - result.z
    return Explained(other, freed, away.T @ away / len(freed))


def _doubted_alike(fit: Fitted, search: Searching) -> Explained:
    """The fit with the deviations of all stated numbers as many times as wide as the largest contradiction is large,
    where there is one and half seconds are predicted all the same: then it is no error of the model.

    Which number is wrong the log does not tell then, and any may be: errors that do not agree are as much larger than
    stated as makes them agree (Birge 1932). What was found with them as stated may be far from what is likeliest then,
    so that the search begins again.
    """
    if not SURPRISE < (doubt := _most(fit.problem, fit.z)) <= FOREIGN or simulated(fit) < 1 - MISSED:
        return Explained(fit, [], 0.0)
    problem = replace(fit.problem, parameters=doubted(fit.problem.parameters, doubt))
    wide = Explained(Fitted(problem, fit.z, fit.normal, fit.paths), [], 0.0, doubt, _off(fit, 1.0))
    result = gauss_newton(problem, fit.z / wide.scales, iterations=ITERATIONS, zones=True)
    fits = [Fitted(problem, result.z, result.normal, result.paths)]
    with suppress(DesignFailed):
        fits.append(search(doubt=doubt))
    best = min(fits, key=lambda one: objective(replace(one.problem, temper=1.0), one.z)[0])
    return wide._replace(fit=best, contradicted=_off(best, doubt) or wide.contradicted)


def doubted(parameters: Sequence[Parameter], doubt: float) -> tuple[Parameter, ...]:
    """The parameters, those that a file states so many times as uncertain."""
    return tuple(replace(p, spread=doubt * p.spread) if _of_file(p) else p for p in parameters)


def _off(fit: Fitted, doubt: float) -> dict[str, float]:
    """By how many of its deviations each number is contradicted, where the fit takes those of the file for `doubt`
    times as large."""
    away = zip(fit.problem.asked, fit.z * _scales(fit.problem.parameters, doubt), strict=False)
    return {p.name: float(x) for p, x in away if not p.guess and abs(x) > SURPRISE}


def _scales(parameters: Sequence[Parameter], doubt: float) -> Array:
    """How many times as large as stated the deviation of each parameter (parameters,) is taken."""
    return np.array([doubt if _of_file(p) else 1.0 for p in parameters])


def _of_file(p: Parameter) -> bool:
    """Whether a number is one that a file states."""
    return not p.guess and (p.name in PARAMETERS or p.name == BATTERY) and p.name not in NATURE


def _single(fit: Fitted, search: Searching) -> list[Freed]:
    """The numbers each of which alone explains a log that contradicts the file by more than `FOREIGN`, if it may be off
    by any factor, the likeliest first; none where the fit does not describe the log.

    A fit that bends numbers so far may have bent the coefficients too. So where none explains it, the likeliest one is
    tried in a fit of its own.
    """
    problem, z, normal, *_ = fit
    if simulated(fit) < 1 - MISSED:
        return []
    stated = {p.name: p for p in problem.parameters}
    tries: list[Freed] = []
    for p in problem.asked:
        if p.name in PARAMETERS and p.prior > 0 and p.name not in {*_unjudged(problem), *NATURE, *LOSSES}:
            far = replace(p, spread=FAR * p.prior, scale="logarithm", guess=True)
            tries.append(_alone(problem, {**stated, p.name: far}, z, normal.bowls, p.name))
    tries.sort(key=lambda one: -one.nats)
    if agree := [one for one in tries if _agrees(one.problem, one.z) and one.nats > tries[0].nats - LIKELIER]:
        return agree
    first = tries[0]
    if first.nats < _nats(problem, z, normal.bowls) + LIKELIER:
        return []
    try:
        other = search(guesses=[first.name])
    except DesignFailed:
        return []
    if not _agrees(other.problem, other.z) or simulated(other) < 1 - MISSED:
        return []
    value = next(p.value(x) for p, x in zip(other.problem.asked, other.z, strict=False) if p.name == first.name)
    return [first._replace(value=float(value))]


def which(freed: Sequence[Freed]) -> list[Say]:
    """The numbers of which one is wrong; nothing without any."""
    numbers = [one.as_number for one in freed]
    if len(freed) > 1:
        return [Say("Log and file would agree with one of these: {numbers}. Measure them again.", numbers=numbers)]
    return [Say("Log and file would agree with {number}. Measure it again.", number=one) for one in numbers]


def _credible(fit: Fitted, stated: Mapping[str, Parameter]) -> list[Freed]:
    """The fewest numbers of which one is wrong with the probability `CREDIBLE`, the likeliest first; none where the
    `stated` priors of all may be right."""
    bowls = fit.normal.bowls
    problem, z = _freed(fit.problem, stated, fit.z, ())
    z = _down(problem, z, bowls)
    least = _nats(problem, z, bowls) + LIKELIER
    names = [p.name for p in problem.asked if _of_file(p) and p.name not in _unjudged(problem)]
    guesses = {n: as_guess(problem.robot, stated[n]) for n in names}
    tries = [_alone(problem, {**stated, n: guess}, z, bowls, n) for n, guess in guesses.items()]
    agree = [one for one in tries if one.nats > least and _agrees(one.problem, one.z)]
    ordered = sorted(agree, key=lambda one: -one.nats)
    weights = np.exp([one.nats - ordered[0].nats for one in ordered])
    before = np.cumsum(weights) - weights
    return [one for one, likelier in zip(ordered, before, strict=True) if likelier < CREDIBLE * weights.sum()]


def _unjudged(problem: Problem) -> frozenset[str]:
    """The numbers of which a log cannot say that they alone are wrong."""
    return problem.held if HEADING in problem.delays else problem.held | {"track"}


def _most(problem: Problem, z: Array) -> float:
    """The most prior deviations by which a stated number is contradicted at z (parameters,)."""
    return max((abs(x) for p, x in zip(problem.asked, z, strict=False) if not p.guess), default=0.0)


def _agrees(problem: Problem, z: Array) -> bool:
    """Whether all stated numbers fit together at z (parameters,), and no friction stands in for one."""
    return _most(problem, z) <= TOGETHER and not _rubs(problem, z)


def _rubs(problem: Problem, z: Array) -> bool:
    """Whether a friction that is a guess is `FOREIGN` at z (parameters,)."""
    return any(x > FOREIGN for p, x in zip(problem.asked, z, strict=False) if p.guess and p.name in LOSSES)


def _alone(problem: Problem, parameters: Mapping[str, Parameter], z: Array, bowls: Bowls, name: str) -> Freed:
    """The fit in the bowls with these parameters, of which the one with this name is a guess."""
    problem, z = _freed(problem, parameters, z, ())
    z = _down(problem, z, bowls)
    p, at = next((p, x) for p, x in zip(problem.asked, z, strict=False) if p.name == name)
    return Freed(name, p.unit, p.prior, float(p.value(at)), _nats(problem, z, bowls), problem, z)


def _nats(problem: Problem, z: Array, bowls: Bowls) -> float:
    """The logarithm of the marginal likelihood in the bowls, up to a constant, about z (parameters,)."""
    from upright.calibration.curves import bowl_derivatives, bowl_value

    hessian = bowl_derivatives(z, problem.curves, bowls)[1]
    return laplace(float(bowl_value(z, problem.curves, bowls)), hessian)


def _down(problem: Problem, z: Array, bowls: Bowls) -> Array:
    """The least of the bowls from z (parameters,)."""
    from upright.calibration.curves import bowl_value, downhill

    limits = np.array([p.least for p in problem.parameters]), problem.active
    value = bowl_value(z, problem.curves, bowls)
    for _ in range(TURNS):
        z = downhill(np.array(z), problem.curves, bowls, 0.0, limits)
        before = value
        value = bowl_value(z, problem.curves, bowls)
        if before - value < GAIN:
            break
    return z


def guessed(robot: Robot, parameters: Sequence[Parameter], names: Sequence[str]) -> tuple[Parameter, ...]:
    """The parameters, those with these names as guesses."""
    return tuple(as_guess(robot, p) if p.name in names else p for p in parameters)


def _freed(problem: Problem, stated: Mapping[str, Parameter], z: Array, names: Sequence[str]) -> tuple[Problem, Array]:
    """The problem with the `stated` parameters, those with these names as guesses, and z (parameters,) there."""
    parameters = guessed(problem.robot, [stated.get(p.name, p) for p in problem.parameters], names)
    new = [
        x if p == q else max(q.coordinate(max(float(p.value(x)), LEAST * q.prior)), q.least)
        for p, q, x in zip(problem.parameters, parameters, z, strict=True)
    ]  # of what is freed none may be below zero
    return replace(problem, parameters=parameters), np.array(new)
