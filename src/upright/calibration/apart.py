"""Runs of one robot that differ from the others in what no run should change: masses, lengths, inertias.

Each run is fitted alone, from the optimum of all at its noise. Where a number of the robot, or a coefficient of its
motion, then differs by more than chance, a run is not one of the same robot, or something in it is not in the
equations. What belongs to a run (`effects`) is no such number. Where one factor on a run's commands says most of what
fits apart would, that is named in place of the numbers that it bends.
"""

from __future__ import annotations

import math
import pathlib
from collections.abc import Sequence
from dataclasses import replace
from itertools import combinations
from typing import NamedTuple

import numpy as np
from scipy.special import ndtri

from upright.arrays import Array
from upright.calibration.effects import RUN, effects_of, run_spreads
from upright.calibration.electronics import BATTERY
from upright.calibration.estimate import NORMAL
from upright.calibration.fitting import Normal, Path, Problem
from upright.calibration.gauss_newton import Minimum, gauss_newton
from upright.calibration.informativity import MARGIN, posterior
from upright.calibration.summary import HALVED, combined_numbers
from upright.pages import Quantity, Say
from upright.pages.terms import term
from upright.robots.uncertainty import GUESS

COEFFICIENTS = ("a11", "a12", "a22", "weight_moment", "a22/a11", "weight_moment/a22")
"""Those of the combinations that friction, winding and supply are not in."""
CHANCE = 0.05  # probability that runs of one robot are said to differ, over all numbers and runs
ITERATIONS = 10  # of Gauss–Newton, from the optimum of all runs
MOST_OF_IT = 0.5  # [1] of what fits apart gain: the least that such a factor must gain
WINDING, OTHER_WINDING = "motor_resistance", 4.0  # [1] standard deviations between runs: a copper wire 25 K warmer
FACTORS = (-0.5, 0.0, 0.5)  # logarithms at which the search for it starts


class _Number(NamedTuple):
    """A number at a coordinate with a standard deviation, its interval, and whether the readings tell it."""

    name: str
    unit: str
    at: float
    spread: float
    value: float
    low: float
    high: float
    visible: bool

    @property
    def quantity(self) -> Quantity:
        """The number with its interval, for people."""
        return Quantity(self.value, self.unit, low=self.low, high=self.high)


class _Gap(NamedTuple):
    """By how many standard deviations a number of a run differs from that of another run, or of all others."""

    deviations: float
    run: int
    other: int
    own: _Number
    others: _Number


def apart(problem: Problem, z: Array, sources: Sequence[str]) -> tuple[Say, ...]:
    """Which run differs from the others and in what; nothing where none does. `z` (parameters,) is the fit of all runs,
    `sources` are their files.

    Each two runs are compared. The one that differs is that without which the others agree best.
    """
    sources = [pathlib.Path(source).name for source in sources]
    runs = range(len(problem.recordings))
    fits = [_fitted(problem, z, [run]) for run in runs] if len(runs) > 1 else []
    known = [posterior(*fit[:4]) for fit in fits]
    alone = [_numbers(*fit[:2], C) for fit, C in zip(fits, known, strict=True)]
    least = [fit[2].objective + _by_chance(fit[0], C) for fit, C in zip(fits, known, strict=True)]
    gaps = [gap for one, other in combinations(runs, 2) for gap in _gaps(one, other, alone[one], alone[other])]
    limit = _limit(max(len(gaps), 1))
    if not gaps or max(gaps).deviations <= limit:
        odd_windings = _other_windings(problem, z)
        if odd_windings and BATTERY not in {p.name for p in problem.asked}:  # no factor is in doubt
            return _windings(problem, z, sources)
        return _likeliest(problem, z, odd_windings, least, sources)
    furthest = max(gaps)
    left = {run: [g.deviations for g in gaps if run not in (g.run, g.other)] for run in runs}
    odd = min(runs, key=lambda run: max(left[run], default=0.0))
    limited = len(runs) > 2 and max(left[odd], default=0.0) <= limit
    if acts := _likeliest(problem, z, [odd] if limited else runs, least, sources):
        return acts
    if not limited:
        gap = _clearest([g for g in gaps if (g.run, g.other) == (furthest.run, furthest.other)], limit)
        return (
            Say(
                "The runs {one} and {other} differ in {name}: {first} and {second}.",
                one=sources[gap.run],
                other=sources[gap.other],
                name=term(gap.own.name),
                first=gap.own.quantity,
                second=gap.others.quantity,
            ),
        )
    rest = _fitted(problem, z, [run for run in runs if run != odd])
    gap = _clearest(_gaps(odd, odd, alone[odd], _numbers(*rest[:2], posterior(*rest))), limit)
    return (
        Say(
            "Log {n} ({log}) differs from the others in {name}: {own}, not {rest}. Leave it out.",
            n=odd + 1,
            log=sources[odd],
            name=term(gap.own.name),
            own=gap.own.quantity,
            rest=gap.others.quantity,
        ),
    )


def _limit(tests: int) -> float:
    """The standard deviations that one of so many tests exceeds by chance, to either side, with `CHANCE` in all."""
    return -float(ndtri(CHANCE / 2 / tests))


def _other_windings(problem: Problem, z: Array) -> list[int]:
    """Runs whose winding is off by more than any temperature makes it: a factor on their commands would look so."""
    stated = {p.name: p.spread for p in effects_of(problem.asked, len(problem.recordings))}
    return [
        run
        for run in range(len(problem.recordings))
        for p, at in zip(problem.parameters, z, strict=True)
        if p.name == f"{RUN}{run}/{WINDING}" and abs(at) * p.spread > OTHER_WINDING * stated[p.name]
    ]


def _windings(problem: Problem, z: Array, sources: Sequence[str]) -> tuple[Say, ...]:
    """The run whose winding is furthest from the others', and what they need."""
    i = [p.name for p in problem.asked].index(WINDING)
    p = problem.asked[i]
    runs = range(len(sources))
    needs = [float(p.value(problem.of_run(z[:, None], run)[i, 0])) for run in runs]
    odd = max(runs, key=lambda run: abs(math.log(needs[run] / np.median(needs))))
    others = [Quantity(value, p.unit) for run, value in enumerate(needs) if run != odd]
    return (
        Say(
            "Log {n} ({log}) needs a motor resistance of {own}, not {others}: look for another gain or supply.",
            n=odd + 1,
            log=sources[odd],
            own=Quantity(needs[odd], p.unit),
            others=others,
        ),
    )


class _Factor(NamedTuple):
    """By how many nats a factor on the commands of a run is likelier than none, and the factor against the others'."""

    gained: float
    run: int
    value: float
    low: float
    high: float


def _likeliest(
    problem: Problem, z: Array, runs: Sequence[int], least: Sequence[float], sources: Sequence[str]
) -> tuple[Say, ...]:
    """The likeliest factor on the commands of one of `runs`; nothing where none says enough. `least` are the
    objectives of all runs, each fitted by itself, less what that gains by chance."""
    if not runs:
        return ()
    none = gauss_newton(problem, z, iterations=ITERATIONS, zones=True)
    acts = [factor for run in runs if (factor := _acts(problem, z, run, none, least[run]))]
    return (_named(max(acts), sources),) if acts else ()


def _acts(problem: Problem, z: Array, run: int, none: Minimum, own: float) -> _Factor | None:
    """The factor on the commands of `run`; None where it does not say most of what a fit of this run apart would.
    `none` is the fit without a factor, `own` the objective of the run fitted by itself, less its gain by chance."""
    names = [p.name for p in problem.parameters]
    supply = f"{RUN}{run}/{BATTERY}"
    if supply not in names:
        return None
    i = names.index(supply)
    battery = problem.parameters[names.index(BATTERY)]
    # what a deviation of one is, in the factor's logarithm
    p = problem.parameters[i]
    unit = battery.rate
    free = replace(
        problem, parameters=tuple(replace(q, spread=GUESS / unit) if q is p else q for q in problem.parameters)
    )
    starts = [np.where(np.arange(len(z)) == i, size / GUESS, none.z) for size in FACTORS]
    best = min(
        (gauss_newton(free, at, iterations=ITERATIONS, zones=True) for at in starts), key=lambda m: m.normal.objective
    )
    joint = none.normal.objective
    gained = joint - best.normal.objective - math.log(GUESS / unit / p.spread)
    others = [other for other in range(len(problem.recordings)) if other != run]
    separate = joint - own - _fitted(problem, z, others)[2].objective
    if gained < max(MARGIN, MOST_OF_IT * separate):
        return None
    slope = np.zeros(len(z))
    for other in range(len(problem.recordings)):
        q = free.parameters[j := names.index(f"{RUN}{other}/{BATTERY}")]
        slope[j] = q.spread * unit * (1.0 if other == run else -1.0 / len(others))
    spread = math.sqrt(slope @ posterior(free, best.z, best.normal, best.paths) @ slope)
    if abs(slope @ best.z) <= _limit(len(problem.recordings)) * spread:
        return None
    value, low, high = (math.exp(slope @ best.z + side * spread) for side in (0.0, -NORMAL, NORMAL))
    return _Factor(gained, run, value, low, high)


def _named(acts: _Factor, sources: Sequence[str]) -> Say:
    return Say(
        "Commands of log {n} ({log}) act {times} times as strongly as others': look for another gain or supply.",
        n=acts.run + 1,
        log=sources[acts.run],
        times=Quantity(acts.value, "1", low=acts.low, high=acts.high),
    )


def _gaps(run: int, other: int, own: Sequence[_Number], others: Sequence[_Number]) -> list[_Gap]:
    """Each number of a run against that of another, or of all others, of those that either tells."""
    return [
        _Gap(abs(one.at - two.at) / math.hypot(one.spread, two.spread), run, other, one, two)
        for one, two in zip(own, others, strict=True)
        if one.visible or two.visible
    ]


def _clearest(gaps: Sequence[_Gap], limit: float) -> _Gap:
    """The largest of those beyond the limit, or of all: a coefficient first."""
    beyond = [gap for gap in gaps if gap.deviations > limit] or gaps
    return max(beyond, key=lambda gap: (gap.own.name in COEFFICIENTS, gap.deviations))


def _fitted(problem: Problem, z: Array, runs: Sequence[int]) -> tuple[Problem, Array, Normal, Sequence[Path]]:
    """Some of the runs fitted by themselves."""
    shared = [i for i, p in enumerate(problem.parameters) if not p.name.startswith(RUN)]
    parameters = [problem.parameters[i] for i in shared]
    first = problem.of_run(z[:, None], runs[0])[:, 0]
    if len(runs) > 1:
        first = z[shared]
        for new, run in enumerate(runs):
            for p, at in zip(problem.parameters, z, strict=True):
                if p.name.startswith(f"{RUN}{run}/"):
                    parameters.append(replace(p, name=f"{RUN}{new}/{p.name.partition('/')[2]}"))
                    first = np.append(first, at)
    part = replace(problem, recordings=tuple(problem.recordings[run] for run in runs), parameters=tuple(parameters))
    least = gauss_newton(part, first, iterations=ITERATIONS)
    return part, least.z, least.normal, least.paths


def _by_chance(problem: Problem, C: Array) -> float:
    """[nats] that a fit of one run by itself gains though it does not differ: half of one for each of the robot's
    numbers that it shows (Wilks 1938), and less for those that are mostly the prior's. C is its covariance."""
    return 0.5 * sum(1.0 - float(C[i, i]) for i, p in enumerate(problem.parameters) if not p.name.startswith(RUN))


def _numbers(problem: Problem, z: Array, C: Array) -> list[_Number]:
    """The robot's numbers that no run should change, and the coefficients of its motion, with the covariance C."""
    differ = run_spreads(problem.asked)
    numbers: list[_Number] = []
    for i, p in enumerate(problem.asked):
        spread = float(np.sqrt(C[i, i]))
        if p.name not in differ and p.name not in problem.held:
            at = float(z[i])
            value, low, high = (float(p.value(at + side * spread)) for side in (0.0, -NORMAL, NORMAL))
            numbers.append(_Number(p.name, p.unit, at, spread, value, low, high, spread < HALVED))
    for c in combined_numbers(problem, z):
        spread = float(np.sqrt(c.slopes @ C @ c.slopes))
        before = float(np.linalg.norm(c.slopes))
        if c.name in COEFFICIENTS and before > 0:
            low, high = (c.value + side * spread for side in (-NORMAL, NORMAL))
            numbers.append(_Number(c.name, c.unit, c.value, spread, c.value, low, high, spread < HALVED * before))
    return numbers
