"""A run of a robot that is known: what belongs to this run alone, from its log.

The robot's numbers stay. Friction, winding, supply, floor and dead times move about those that are known, with the
spreads between runs of `effects`. Readings count by their effective sample size: at full weight they would bend what a
run may have into what the equations leave out, such as a winding colder by a hundred kelvin.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.calibration.calibrate import prepared
from upright.calibration.calibrated_robot import Segments
from upright.calibration.effects import FRACTIONS, run_spreads
from upright.calibration.fitting import Fitted, Problem
from upright.calibration.gauss_newton import gauss_newton
from upright.calibration.informativity import effective_fraction
from upright.calibration.parameters import Parameter
from upright.calibration.refined import segmented
from upright.calibration.stated_gain import as_meant, stated_gains
from upright.calibration.validate import score, segments
from upright.pages import Say
from upright.robots import Kit, Robot
from upright.signals import Log

ITERATIONS = 15  # of Gauss–Newton, at most


@dataclass(frozen=True, kw_only=True)
class RunEffect:
    """A number as it is `known` of the robot, and as it is in this run."""

    name: str
    unit: str
    known: float
    here: float


def spread_here(p: Parameter, between: float) -> float:
    """Standard deviation of a run's own number, of which runs differ by `between` deviations of what is known: where
    somebody measured the robot's friction or winding, they know it no better than that."""
    return p.spread * (math.hypot(1.0, between) if p.name in FRACTIONS and not p.guess else between)


def of_this_run(problem: Problem, limits: Mapping[str, float]) -> tuple[Segments, tuple[RunEffect, ...]] | None:
    """Half seconds of the one recording of `problem` with the numbers of its own run, and these; None where they
    predict no better than those that are known. `limits` are the variances of the sensors by their kit."""
    free = _free(problem)
    known = np.zeros(len(problem.parameters))
    fit = _own_fit(free, limits)
    if not np.isfinite(fit.normal.objective):
        return None
    tempered = fit.problem
    z = fit.z
    recording = problem.recordings[0]
    if score(tempered, z) <= score(free, known):
        return None
    effects = tuple(
        RunEffect(name=p.name, unit=p.unit, known=p.prior, here=float(p.value(at)))
        for p, at in zip(free.parameters, z, strict=True)
        if p.name not in free.held
    )
    return segments(tempered, recording, z), effects


def _free(problem: Problem) -> Problem:
    """The problem in which only what belongs to the run moves."""
    spreads = run_spreads(problem.asked)
    own = tuple(replace(p, spread=spread_here(p, spreads.get(p.name, 1.0))) for p in problem.parameters)
    return replace(problem, parameters=own, held=frozenset(p.name for p in own if p.name not in spreads))


def _own_fit(free: Problem, limits: Mapping[str, float]) -> Fitted:
    fit = segmented(free, limits, [np.zeros(len(free.parameters))])[0]
    if not np.isfinite(fit.normal.objective):
        return fit
    tempered = replace(fit.problem, temper=effective_fraction(fit.problem, fit.normal, fit.paths))
    least = gauss_newton(tempered, fit.z, iterations=ITERATIONS)
    return Fitted(tempered, least.z, least.normal, least.paths)


def as_driven(log: Log, robot: Robot, kit: Kit) -> tuple[Log, tuple[Say, ...]]:
    """`log` with the commands that drove the motors, where its file states a gain and a robot that is known tells on
    which side of it they were logged, and that in words; the log as it is, and (), where none is stated."""

    def fitted(logs: Sequence[Log]) -> Fitted:
        problem, limits = prepared(logs, robot, kit, (), 0.0)
        return _own_fit(_free(problem), limits)

    if not stated_gains(log):
        return log, ()
    fit = fitted([log])
    if not np.isfinite(fit.normal.objective):
        return log, ()
    _, (driven,), words = as_meant(fit, [log], kit, fitted)
    return driven, tuple(words)
