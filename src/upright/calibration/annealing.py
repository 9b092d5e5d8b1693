"""The way down: from the prior, with less and less process noise, and from the dead times that a filter finds likeliest
which hardly asks for the right robot."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from itertools import product

import numpy as np

from upright.arrays import Array
from upright.calibration.fitting import Problem, objective
from upright.calibration.gauss_newton import gauss_newton, with_other_zone
from upright.calibration.noise import learn_noise, scaled_noise, sensor_bounds
from upright.calibration.process_noise import with_process
from upright.calibration.threads import in_threads
from upright.errors import DesignFailed
from upright.logs.recording import Recording, head
from upright.pages import Next, Say

ANNEALING_NOISE = (0.3, 0.1, 0.03)
"""[1] Process noise of the first fits, as a fraction of the commands (rms). Much noise makes a filter that forgets fast
and follows any robot, so that a poor start converges; less noise then makes it predict over a longer time."""

START_SECONDS = 6.0  # [s] of each log on which the way down is sought
PERIODS = range(-4, 5)
"""Added to the prior's delays: at 10 ms, two of its deviations either side. An optimum is about a period wide."""
TURNS = 3  # times that the search goes on from an edge of these
NEAR = 0.75  # [periods] by which delays differ that lead to the same optimum
HEAVY = 2.0  # [deviations] added to the pitch inertia in a last start


def annealed(problem: Problem, limits: Mapping[str, float]) -> tuple[Problem, Array]:
    """From the prior, with less and less process noise; where its delays lose the robot, from the likeliest ones, and
    from a heavier body. Raises `DesignFailed` where the filter loses the robot from each."""
    start = np.zeros(len(problem.parameters))
    if not _follows(problem, start):
        start = _likeliest_delays(problem, limits)
    if not _follows(problem, start):
        start = _with_delays(problem, (0, 0), heavier=HEAVY)
    if not _follows(problem, start):
        raise lost()
    return _less_noise(problem, start, limits)


def from_likeliest_delays(problem: Problem, z: Array, limits: Mapping[str, float]) -> tuple[Problem, Array] | None:
    """The same from the likeliest delays; None where those at z (parameters,) are near them."""
    start = _likeliest_delays(problem, limits)
    period = problem.recordings[0].period
    off = [
        abs(float(p.value(a) - p.value(b)))
        for p, a, b in zip(problem.parameters, z, start, strict=False)
        if p.name in ("delay/encoder", "delay/gyro")
    ]
    if max(off, default=0.0) < NEAR * period or not _follows(problem, start):
        return None
    return _less_noise(problem, start, limits)


def lost() -> DesignFailed:
    return DesignFailed(
        Say("the filter loses the robot from every start"), expected=Say("a log of the named robot, balancing"),
        likely=Say("another robot, a flipped sign or a wrong unit"), hint=Next("doctor", "LOG"),
    )  # fmt: skip


def _less_noise(problem: Problem, z: Array, limits: Mapping[str, float]) -> tuple[Problem, Array]:
    """From z, as long as the filter keeps the robot: on the beginning of the logs, since only the way down is sought,
    and on the whole where that does not follow the rest."""
    early, result = _fits(replace(problem, recordings=_beginnings(problem)), z, limits)
    fitted = replace(early, recordings=problem.recordings)
    return (fitted, result) if np.isfinite(objective(fitted, result)[0]) else _fits(problem, z, limits)


def _fits(problem: Problem, z: Array, limits: Mapping[str, float]) -> tuple[Problem, Array]:
    """From z, and from there with a dead zone that is likelier at the first noise: the likelier of both ends."""
    first = _at(problem, z, limits, ANNEALING_NOISE[0])
    end = _descended(problem, z, limits, first)
    other = with_other_zone(first, z, objective(first, z)[0])
    if other is None:
        return end
    there = _descended(problem, other, limits, _at(problem, other, limits, ANNEALING_NOISE[0]))
    return min(end, there, key=lambda one: objective(*one)[0])


def _at(problem: Problem, z: Array, limits: Mapping[str, float], fraction: float) -> Problem:
    """The problem with so much process noise, and where the filter keeps the robot with the sensors' noise of that."""
    less = with_process(problem, fraction)
    kept = np.isfinite(objective(less, z)[0])
    return learn_noise(less, z, sensor_bounds(limits), iterations=2) if kept else less


def _descended(problem: Problem, z: Array, limits: Mapping[str, float], less: Problem) -> tuple[Problem, Array]:
    """From z down, at the noise of the problem `less` first, as long as the filter keeps the robot."""
    for fraction in ANNEALING_NOISE:
        if fraction != ANNEALING_NOISE[0]:
            less = _at(problem, z, limits, fraction)
        new, normal, *_ = gauss_newton(less, z, iterations=6, tolerance=0.1, zones=True)
        if not np.isfinite(normal.objective):
            break
        problem, z = less, new
    return problem, z


def _beginnings(problem: Problem) -> tuple[Recording, ...]:
    return tuple(head(r, START_SECONDS) for r in problem.recordings)


def _follows(problem: Problem, z: Array) -> bool:
    noisy = with_process(replace(problem, recordings=_beginnings(problem)), ANNEALING_NOISE[0])
    return bool(np.isfinite(objective(noisy, z)[0]))


def _with_delays(problem: Problem, periods: tuple[int, int], heavier: float = 0.0) -> Array:
    """The prior with so many `periods` added to the delays of the gyro and of the other sensors."""
    z = np.zeros(len(problem.parameters))
    for i, p in enumerate(problem.parameters):
        if p.name.startswith("delay/"):
            extra = periods[0] if p.name == "delay/gyro" else periods[1]
            z[i] = p.coordinate(p.prior + extra * problem.recordings[0].period)
        elif p.name == "pitch_inertia" and p.name not in problem.held:
            z[i] = heavier
    return z


def _likeliest_delays(problem: Problem, limits: Mapping[str, float]) -> Array:
    """The prior with the delays of greatest posterior, to a period, under the noise of the first fits.

    That filter forgets in a few periods what it predicted. So it asks for readings that fit each other and the commands
    in time, and hardly for the right robot: its likelihood has one deep optimum where that of a stiff filter has many.
    """
    problem = with_process(replace(problem, recordings=_beginnings(problem)), ANNEALING_NOISE[0])
    bounds = sensor_bounds(limits)
    least = np.array([p.least for p in problem.parameters])

    def value(periods: tuple[int, int]) -> float:
        z = _with_delays(problem, periods)
        return scaled_noise(problem, z, bounds)[0] + 0.5 * float(z @ z) if (z >= least).all() else np.inf

    known: dict[tuple[int, int], float] = {}
    best = (0, 0)
    for _ in range(TURNS):
        around = [(best[0] + i, best[1] + j) for i, j in product(PERIODS, PERIODS)]
        new = [at for at in around if at not in known]
        known |= zip(new, in_threads(value, new), strict=True)
        before = best
        best = min(known, key=lambda at: known[at])
        if max(abs(best[0] - before[0]), abs(best[1] - before[1])) < max(PERIODS):
            break
    return _with_delays(problem, best)
