"""From a start to parameters and noise of greatest likelihood, and where the innovations show that the model leaves
something out, to those whose free simulation follows the log best."""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial

import numpy as np

from upright.arrays import Array
from upright.calibration import resonant as resonating
from upright.calibration.annealing import from_likeliest_delays
from upright.calibration.dropping import dropped
from upright.calibration.effects import respread
from upright.calibration.fitting import STICKING, Fitted, Problem, normal_equations, objective
from upright.calibration.gauss_newton import CONVERGED, Minimum, gauss_newton, rezoned
from upright.calibration.informativity import effective_fraction
from upright.calibration.misaligned import misaligned
from upright.calibration.noise import GAIN, Bounds, learn_noise, sensor_bounds
from upright.calibration.parameters import ROLLING, most_friction
from upright.calibration.process_noise import NOISE_TIME, process, with_process
from upright.calibration.resonance import FIRST, LEAST, MOST, SWING, resonates, swing_noise
from upright.calibration.resonant import resonant
from upright.calibration.sought import at_prior, with_those_of
from upright.logs.recording import SENSOR
from upright.physics.dynamics import motor_gain
from upright.progress import Progress, unwatched

FREEDOM = 0.015
"""[1] Most process noise that is learnt, as a fraction of the commands and of the robot's weight."""

SEGMENT = 0.5
"""[s] Where innovations are not white, the filter forgets the state after each such time, and the fit is of what free
simulations over it leave: a model that leaves something out then still is the one that predicts best."""
SEGMENT_NOISE = 0.003  # [1] process noise within a segment, as a fraction of the commands: nearly none
MISSING = 0.3  # [1] of a reading's change over a segment: its first deviation there
LEVEL = 0.1  # [1] of what the best fit leaves: fits that leave so little more predict equally well
ALIKE = 0.5
"""[1] of an effective sample size: two estimates of one that differ by a factor of two may do so by chance, for those
of a log of 7 s have some eleven degrees of freedom in each of a few directions (97.5 % of F(33, 33) lie below 2.0)."""
SPREADS = 3  # turns in which parameters and the spreads between runs are fitted
SETTLED = 0.05  # [1] deviations of the prior by which no parameter moves any more
TURNS = 6  # of noise and parameters, at most

GYRO_DELAY_TRIALS = (-0.5, 0.5, 1.0)
"""[periods] added to the gyro's delay where the best fit is fitted again: delays have optima a period apart.
A fit from there must be likelier at the same noise, and predict half seconds better: either alone may be chance."""

CLEARER = 0.01
"""[1] of what a fit leaves of half seconds, by which another one leaves less that is better than by chance: with
numbers that are wrong it leaves up to 0.017 more."""

MISSED = 0.01  # [1] of the readings of half seconds: a model that leaves more is wrong, and intervals are wider for it

NOISE = 5e-4
"""[1] of the readings of half seconds that the sensors' noise may leave: 4e-5 to 3e-4 of robots that others simulated,
where TWIPR's model leaves 1.5e-3. Which of two such fits is right half seconds do not tell, and the likelihood does."""

LEAST_WEIGHT = 0.1  # [1] weight of the readings below which the prior may outweigh them
WORST_LOSS = 0.02  # [1] most R² of free simulation that the prior may then cost
WEIGHT_TOLERANCE = 0.02  # [1] relative change of the readings' weight that asks for no other fit
NOISE_TOLERANCE = 0.05  # [1] change of a variance's logarithm that asks for no other fit: a noise known to 2.5 %
WHITE = 0.15  # [1] autocorrelation of innovations below which the model is taken for right: 3 deviations of 400 samples

Cause = Callable[[Fitted, Callable[[Problem, Array], Fitted]], Fitted | None]
"""The likelier fit with a cause, from one without and what settles a start."""

NOISE_RANGE = 1e-6  # [1] least process noise that is learnt, over the most


def settled(problem: Problem, z: Array, limits: Mapping[str, float]) -> Fitted:
    """Parameters and noise of greatest likelihood near z, whether the innovations show that the model is right or
    not."""
    return _settled(problem, z, _bounds(problem, limits, FREEDOM))


def refined(problem: Problem, z: Array, limits: Mapping[str, float], show: Progress = unwatched) -> Fitted:
    """Parameters and noise of greatest likelihood; where the innovations show that the model is not right, those whose
    free simulation follows the log best, and readings weighted by their effective sample size."""
    bounds = _bounds(problem, limits, FREEDOM)
    rough = _likeliest_noise(problem, z, bounds)
    best = _polished(rough, bounds)
    show(0.2)  # these shares are of the time of logs whose innovations are never white
    if not white(best) and (start := from_likeliest_delays(problem, z, limits)):
        other = _likeliest_noise(*start, bounds)
        polished = _polished(other, bounds)
        if polished.normal.objective < best.normal.objective:
            rough, best = other, polished
    show(0.3)
    for cause in (misaligned, dropped):
        if not white(best) and (other := _with_cause(cause, rough, bounds)):
            rough = other
            best = _polished(other, bounds)
            problem, z = with_those_of(problem, z, rough.problem, rough.z)
    if not white(best) and (other := _with_resonance(rough, bounds)):
        rough = other
        best = _polished(other, {**bounds, **_swings(problem)})
        problem, z = resonating.with_that_of(problem, z, rough.problem, rough.z)
    if white(best) or only_noise(best):
        return _tempered(_between_runs(best))
    show(0.6)
    prior = at_prior(problem, rough.z)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        fits = [rough, *segmented(problem, limits, [prior, z, rough.z, *_without_rolling(problem, limits, prior)])]
        show(0.85)
        best, level = _best_simulated(fits, [*pool.map(simulated, fits)], LEVEL)
        moved = pool.map(partial(_with_gyro_delay, best.problem, best.z), GYRO_DELAY_TRIALS)
        tries = [fit for fit in moved if fit.normal.objective < best.normal.objective]
        for other, value in zip(tries, pool.map(simulated, tries), strict=True):
            if 1 - value <= (1 - CLEARER) * (1 - level):
                best = _one_of(other, [*best.others, best.z], value)
                level = value
        several = [best, *fits] if len(problem.recordings) > 1 else [best]  # weighted, each may go elsewhere
        last = [*pool.map(_tempered, map(_between_runs, several))]
        if len(last) > 1:
            return _best_simulated(last, [*pool.map(simulated, last)], LEVEL)[0]
        return last[0]._replace(others=best.others)


def _with_cause(cause: Cause, fit: Fitted, bounds: Bounds) -> Fitted | None:
    """The fit with a `cause`, where that explains the log."""
    other = cause(fit, partial(_settled, bounds=bounds))
    return other if other and _explains(other, fit) else None


def _explains(other: Fitted, fit: Fitted) -> bool:
    """Whether a fit that is likelier leaves clearly less of half seconds too, or makes the innovations white: else what
    it has more stands in for another error of the model."""
    return white(other) or leaves_less(other, fit, LEVEL)


def _with_resonance(fit: Fitted, bounds: Bounds) -> Fitted | None:
    """The fit with a resonance of the gyro, where that explains the log.

    Noise that makes the gyro swing is learnt only then. It would be likelier of every gyro whose noise is not white.
    """
    other = resonant(fit, partial(_settled, bounds=bounds))
    if not other or not _explains(other, fit):
        return None
    own = _swings(other.problem)
    noise = {SWING: math.log(swing_noise(other.problem.recordings, FIRST))}
    return _settled(other.problem.with_noise(noise), other.z, {**bounds, **own})


def white(fit: Fitted) -> bool:
    """Whether the innovations of a fit are those of a right model, as far as their correlations tell."""
    from upright.calibration.validate import worst_correlation

    return bool(np.isfinite(fit.normal.objective)) and worst_correlation(*fit[:4]) < WHITE


def _likeliest_noise(problem: Problem, z: Array, bounds: Bounds) -> Fitted:
    """Parameters and noise from little process noise, and where that does not end white, from more of it too: the
    likelier of both. Little noise finds a right model's optimum from nearby, and loses the way from further off."""
    calm = with_process(problem, FREEDOM / 10)
    if not np.isfinite(objective(calm, z)[0]):
        return _settled(problem, z, bounds)
    fit = _settled(calm, z, bounds)
    return fit if white(fit) else min(fit, _settled(problem, z, bounds), key=lambda one: one.normal.objective)


def _between_runs(fit: Fitted) -> Fitted:
    """The same fit with the spreads between runs that it shows; of one run none can."""
    for _ in range(SPREADS if len(fit.problem.recordings) > 1 else 0):
        covariance = np.linalg.inv(fit.normal.hessian).astype(np.float64)
        parameters, z = respread(fit.problem.parameters, fit.z, covariance)
        fit = _fitted(replace(fit.problem, parameters=parameters), z, iterations=5)
    return fit


def segmented(problem: Problem, limits: Mapping[str, float], starts: Sequence[Array]) -> list[Fitted]:
    """From the `starts` the fits of what free simulations of half a second leave: noise and parameters in turn, until a
    turn neither moves nor gains. A start that comes to where a likelier one is goes no further."""
    problem = with_process(replace(problem, restart=SEGMENT), SEGMENT_NOISE)
    bounds = sensor_bounds(limits)
    first = {name: math.log(min(max(_changes(problem, name), low), high)) for name, (low, high) in bounds.items()}
    problem = problem.with_noise(first)

    def turned(fit: Fitted) -> tuple[Fitted, bool]:
        new = _fitted(learn_noise(fit.problem, fit.z, bounds, iterations=5), fit.z, iterations=5)
        if moves(fit, new):
            return new, False
        least = Minimum(new.z, new.normal, list(new.paths), CONVERGED)
        zoned = Fitted(new.problem, *rezoned(new.problem, least, iterations=5)[:3])
        return zoned, not moves(new, zoned)

    def moves(fit: Fitted, new: Fitted) -> bool:
        gained = fit.normal.objective - new.normal.objective
        return bool(np.abs(new.z - fit.z).max() >= SETTLED and abs(gained) >= GAIN)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        fits = [(fit, False) for fit in pool.map(partial(_fitted, problem, iterations=0), starts)]
        for _ in range(TURNS):
            going = pool.map(turned, [fit for fit, ended in fits if not ended])
            fits = _likeliest([*going, *(one for one in fits if one[1])])
        last = [_fitted(fit.problem, fit.z, iterations=10, zones=True) for fit, ended in fits if not ended]
        return [*last, *(fit for fit, ended in fits if ended)]


def _likeliest(fits: Sequence[tuple[Fitted, bool]]) -> list[tuple[Fitted, bool]]:
    """Of fits that are at one place the likeliest."""
    kept: list[tuple[Fitted, bool]] = []
    for fit, ended in sorted(fits, key=lambda one: one[0].normal.objective):
        if all(np.abs(fit.z - other.z).max() >= SETTLED for other, _ in kept):
            kept.append((fit, ended))
    return kept


def _without_rolling(problem: Problem, limits: Mapping[str, float], prior: Array) -> list[Array]:
    """A start from a fit without rolling friction, where that is asked: with it a bad optimum may be nearer to the
    prior."""
    without = replace(problem, held=problem.held | {ROLLING})
    asked = ROLLING in {p.name for p in problem.parameters} - problem.held
    return [segmented(without, limits, [prior])[0].z] if asked else []


def _changes(problem: Problem, sensor: str) -> float:
    """Variance of a sensor's readings that a model which follows them roughly leaves over a segment."""
    changes: list[float] = []
    for r in problem.recordings:
        lag = max(1, round(SEGMENT / r.period))
        for row, name in enumerate(r.rows):
            y = r.value[r.kind == row]
            if SENSOR[name] == sensor and len(y) > lag:
                changes.append(float(np.mean((y[lag:] - y[:-lag]) ** 2)) / 2)
    return MISSING**2 * max(changes, default=0.0)


def _fitted(problem: Problem, z: Array, *, iterations: int, zones: bool = False) -> Fitted:
    """Gauss–Newton from z, to other dead zones too with `zones`."""
    result = gauss_newton(problem, z, iterations=iterations, zones=zones)
    return Fitted(problem, result.z, result.normal, result.paths)


def simulated(fit: Fitted) -> float:
    """How well the robot of a fit follows the log when it is simulated freely."""
    from upright.calibration.validate import score

    return score(fit.problem, fit.z) if np.isfinite(fit.normal.objective) else -np.inf


def only_noise(fit: Fitted) -> bool:
    """Whether free simulations leave no more of half seconds than noise does."""
    return simulated(fit) > 1 - NOISE


def leaves_less(other: Fitted, fit: Fitted, part: float) -> bool:
    """Whether free simulations of the `other` leave less of the log than those of a fit, by this `part` [1] of it."""
    return 1 - simulated(other) <= (1 - part) * (1 - simulated(fit))


def _best_simulated(fits: Sequence[Fitted], scores: Sequence[float], level: float = 0.0) -> tuple[Fitted, float]:
    """The fit with the best of these `scores`, and its score; of fits that leave more than it by a fraction of at most
    `level`, and whose effective sample size is not less than that of any by more than chance, the one whose numbers the
    prior takes for likeliest.

    What the readings say beside the prior is in proportion to that size. A fit may be near the prior since its
    innovations are strongly correlated: then it hardly knows anything of what it predicts as well.
    """
    least = max(scores) - level * (1 - max(scores)) if np.isfinite(max(scores)) else -np.inf
    good = [(fit, value) for fit, value in zip(fits, scores, strict=True) if value >= least]
    if level and np.isfinite(least) and len(good) > 1:
        sizes = [effective_fraction(fit.problem, fit.normal, fit.paths) for fit, _ in good]
        good = [one for one, size in zip(good, sizes, strict=True) if size >= ALIKE * max(sizes)]
    fit, value = min(good, key=lambda one: float(one[0].z @ one[0].z))
    return _one_of(fit, [other.z for other, _ in good if other is not fit], value), value


def _one_of(fit: Fitted, others: Sequence[Array], value: float) -> Fitted:
    """The fit beside `others` that predict as well, where by its score, `value`, the model is right: else its intervals
    are wider for what that leaves."""
    return fit._replace(others=others if value > 1 - MISSED else ())


def _with_gyro_delay(problem: Problem, z: Array, periods: float) -> Fitted:
    """The fit from z with so many periods added to the gyro's delay."""
    for i, p in enumerate(problem.parameters):
        if p.name == "delay/gyro":
            z = z.copy()
            z[i] = max(p.coordinate(float(p.value(z[i])) + periods * problem.recordings[0].period), p.least)
    return _fitted(problem, z, iterations=10)


def _bounds(problem: Problem, limits: Mapping[str, float], fraction: float) -> Bounds:
    top = process(problem.recordings, problem.robot, fraction)
    dry = most_friction(problem.robot)
    top[STICKING] = max(top[STICKING], math.log((dry / motor_gain(problem.robot)) ** 2 * NOISE_TIME + 1e-30))
    free = {
        name: (math.exp(value) * NOISE_RANGE, math.exp(value)) for name, value in top.items() if name != "gyro_bias"
    }
    return {**sensor_bounds(limits), **free, **(_swings(problem) if resonates(problem.asked) else {})}


def _swings(problem: Problem) -> dict[str, tuple[float, float]]:
    """Between which variances the noise is learnt that makes a gyro swing."""
    return {SWING: (swing_noise(problem.recordings, LEAST), swing_noise(problem.recordings, MOST))}


def _settled(problem: Problem, z: Array, bounds: Bounds) -> Fitted:
    """Parameters and noise in turn, until the noise of the sensors stays. Parameters first: noise that is learnt at
    wrong ones explains what they leave, and then hides from the next fit that they are wrong."""
    inside = {n: float(np.clip(problem.noise[n], np.log(low), np.log(high))) for n, (low, high) in bounds.items()}
    within = problem.with_noise(inside)
    problem = within if np.isfinite(objective(within, z)[0]) else problem
    for turn in range(TURNS):
        _, z, normal, paths, _ = _fitted(problem, z, iterations=5, zones=True)
        before = problem
        problem = learn_noise(problem, z, bounds, iterations=3 if turn else 5)
        changed = {n: abs(problem.noise[n] - before.noise[n]) for n in bounds}
        if max(changed.values()) < NOISE_TOLERANCE:
            return Fitted(before, z, normal, paths)
    return _fitted(problem, z, iterations=8, zones=True)


def _polished(fit: Fitted, bounds: Bounds) -> Fitted:
    """The same in fine steps, where these are finer and the filter follows the log in them."""
    fine = replace(fit.problem, fine=True)
    if fine.longest == fit.problem.longest:
        return fit
    problem = learn_noise(fine, fit.z, bounds, iterations=2)
    polished = _fitted(problem, fit.z, iterations=10)
    return polished if np.isfinite(polished.normal.objective) else fit


def _tempered(fit: Fitted) -> Fitted:
    """The same fit in fine steps, with readings weighted by their effective sample size against the prior. Where the
    prior would then draw the fit away from what predicts the log, the fit stays and only its intervals widen."""
    from upright.calibration.validate import score

    problem, z, normal, paths, _ = fit
    longest = problem.longest
    problem = replace(problem, fine=True)
    first = z
    for _ in range(2):
        fraction = effective_fraction(problem, normal, paths)
        if abs(fraction / problem.temper - 1) < WEIGHT_TOLERANCE and problem.longest == longest:
            break
        problem, longest = replace(problem, temper=fraction), problem.longest
        _, z, normal, paths, _ = _fitted(problem, z, iterations=10)
    if problem.temper < LEAST_WEIGHT and score(problem, z) < score(problem, first) - WORST_LOSS:
        value, paths = objective(problem, first)
        return Fitted(problem, first, normal_equations(problem, first, paths, value), paths)
    return Fitted(problem, z, normal, paths)
