"""The robot from its own raw logs: start, anneal, learn the noise, and say what came of it.

    calibrate(log, robot) → Calibration

The predictor's gains belong to noise that is learnt with the parameters. Its process noise may not exceed `FREEDOM`: a
filter that trusts its model little predicts the next sample well whatever the model is, and nothing beyond.
"""

from __future__ import annotations

import math
import os
import time
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.calibration import Calibration
from upright.calibrate.effects import effects_of, respread
from upright.calibrate.electronics import electronics_of
from upright.calibrate.filter_log import one_step_noise
from upright.calibrate.fitting import EQUATIONS, STICKING, Normal, Path, Problem, normal_equations, objective
from upright.calibrate.gauss_newton import gauss_newton
from upright.calibrate.informativity import INERTIAL, STRAIGHT, TURNING, drives_straight, too_quiet
from upright.calibrate.knocks import without_knocks
from upright.calibrate.learnt_kit import learnt_kit
from upright.calibrate.noise import Bounds, learn_noise
from upright.calibrate.parameters import ROLLING, most_friction, parameters_of
from upright.calibrate.process_noise import NOISE_TIME, arrival, process
from upright.doctor.doctor import contradictions
from upright.doctor.wheels import on_its_wheels
from upright.errors import DesignFailed, InvalidLog
from upright.logs.mapping import Mapping as Columns
from upright.logs.pace import pace_of
from upright.logs.raw import LogSource, raw_log
from upright.logs.recording import SENSOR, Recording, commanded, first_noise, head, record
from upright.physics.dynamics import motor_gain
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import Log

Array = NDArray[np.float64]


class Fitted(NamedTuple):
    """A problem, its parameters of greatest posterior z (parameters,), and the derivatives and filters there."""

    problem: Problem
    z: Array
    normal: Normal
    paths: Sequence[Path]


ANNEALING_NOISE = (0.3, 0.1, 0.03)
"""[1] Process noise of the first fits, as a fraction of the commands (rms). Much noise makes a filter that forgets fast
and follows any robot, so that a poor start converges; less noise then makes it predict over a longer time."""

FREEDOM = 0.015
"""[1] Most process noise that is learnt, as a fraction of the commands and of the robot's weight."""

SEGMENT = 0.5
"""[s] Where innovations are not white, the filter forgets the state after each such time, and the fit is of what free
simulations over it leave: a model that leaves something out then still is the one that predicts best."""
SEGMENT_NOISE = 0.003  # [1] process noise within a segment, as a fraction of the commands: nearly none
MISSING = 0.3  # [1] of a reading's change over a segment: its first deviation there
LEVEL = 0.1  # [1] of what the best fit leaves: fits that leave so little more predict equally well
SPREADS = 3  # turns in which parameters and the spreads between runs are fitted
SETTLED = 0.05  # [1] deviations of the prior by which no parameter moves any more

GYRO_DELAY_TRIALS = (-0.5, 0.5, 1.0)
"""[periods] added to the gyro's delay where the best fit is fitted again: delays have optima a period apart.
A fit from there must be likelier at the same noise, and predict half seconds better: either alone may be chance."""

LEAST_WEIGHT = 0.1  # [1] weight of the readings below which the prior may outweigh them
WORST_LOSS = 0.02  # [1] most R² of free simulation that the prior may then cost
WEIGHT_TOLERANCE = 0.02  # [1] relative change of the readings' weight that asks for no other fit
NOISE_TOLERANCE = 0.05  # [1] change of a variance's logarithm that asks for no other fit: a noise known to 2.5 %
WHITE = 0.15  # [1] autocorrelation of innovations below which the model is taken for right: 3 deviations of 400 samples

STARTS = ((0, 0, 0), (3, 0, 0), (6, 0, 0), (0, 2, 0), (0, 0, 1), (0, 0, -1))
"""[periods] added to the prior's delay of all sensors and of the gyro, and [deviations] to the pitch inertia."""

PLAUSIBLE_NOISE = 9.0  # [1] variance of all sensors over the kit's, below which the prior's delays are near enough
MOST_SENSOR = 1e6  # [1] most variance that is learnt of a sensor, over the one its kit has
NOISE_RANGE = 1e-6  # [1] least process noise that is learnt, over the most
START_SECONDS = 6.0  # [s] of each log that decide between starts


def calibrate(
    logs: LogSource | Sequence[LogSource],
    robot: Robot | str,
    kit: Kit | str | None = None,
    *,
    mapping: Columns | str | None = None,
    known: Sequence[str] = (),
    held_out: float = 0.25,
    between_knocks: bool = False,
    progress: Progress | None = None,
) -> Calibration:
    """Physical parameters, dead times and noise of `robot` from one or several logs of raw sensors and commands.

    Logs are `Log`s or files, which `mapping` reads (default: the one that fits); robot and kit may be names or files.

    `robot` gives the prior: each number with the spread of its provenance, a guess with a factor of two. `kit`
    (default: the robot's own) gives first delays and noise. `known` names parameters taken for exact. The last fraction
    `held_out` of each log is not fitted; predictions are tested on it. Knocks in a log are named, and left out with
    `between_knocks`. Raises `InvalidLog` for unusable logs, `DesignFailed` where no start follows the log.
    """
    from upright.calibrate.apart import apart
    from upright.calibrate.summary import summarised

    began, show = time.perf_counter(), progress or unwatched
    given = [raw_log(log, mapping) for log in ([logs] if isinstance(logs, Log | str | os.PathLike) else logs)]
    several, left = zip(*map(on_its_wheels, given), strict=True) if given else ((), ())
    nominal = find_robot(robot)
    parts = find_kit(kit or nominal.kit)
    several, knocked = without_knocks(several, nominal, parts, cut=between_knocks)
    stated, limits = prepared(several, nominal, parts, known, held_out)
    problem, reason = stated, too_quiet(stated)
    straight = drives_straight(stated)
    held = (*(INERTIAL if reason else ()), *(TURNING if straight else ()))
    problem = replace(problem, held=frozenset(p.name for p in problem.parameters if p.name in held))
    show(0.01)  # these shares are of the time that logs of half a minute took
    problem, z = annealed(problem, limits)
    show(0.04)
    problem, z, normal, paths = refined(problem, z, limits)
    if not np.isfinite(normal.objective):
        raise _lost()
    show(0.77)
    wrong = [text for log in several for text in contradictions(log, nominal)]
    result = summarised(Fitted(problem, z, normal, paths), several, reason, began, stated=stated, wrong=wrong)
    hidden = parts.delay + parts.jitter / 2 - _dead_time(parts, several)
    notes = [*filter(None, left), *knocked, *([STRAIGHT] if straight else [])]
    notes += [str(pace) + "." for pace in map(pace_of, several) if pace and not pace.kept]
    result = replace(result, kit=learnt_kit(result, parts, problem.delays, hidden), notes=(*result.notes, *notes))
    if problem.temper < 1 and not result.withheld():  # else the noise of the kit is that of the filter
        own = result.kit or parts
        noise = one_step_noise(max(several, key=len), result.robot, own, delay=_dead_time(own, several))
        result = replace(result, robot=result.robot.replace(noise=noise))
    return result if reason else replace(result, apart=apart(problem, z, result.sources))


def prepared(
    logs: Sequence[Log], robot: Robot, kit: Kit, known: Sequence[str], held_out: float
) -> tuple[Problem, dict[str, float]]:
    """The problem at its prior, and each sensor's variance as its kit has it."""
    delay = max([kit.delay, *(kit.delay + s.delay for s in kit.sensors.values())])
    if any(_idle(log) for log in logs):
        raise InvalidLog("the commands never change", expected="motors at work", likely="a log of a robot switched off")
    recordings = tuple(record(log, robot, kit, skip=delay + 0.02, held_out=held_out) for log in logs)
    sensors = dict.fromkeys(s for r in recordings for s in r.sensors)
    delays = {s: _dead_time(kit, logs) + _delay(kit, s) for s in sensors}
    variances = [first_noise(r) for r in recordings]
    limits = {s: max(v[s] for v in variances if s in v) for s in delays}
    noise = {s: float(np.log(v)) for s, v in limits.items()}
    noise |= arrival(kit, logs)
    foreign = not all("body" in log.origin for log in logs)
    parameters = parameters_of(robot, delays, known, electronics_of(robot, kit, logs), foreign=foreign)
    every = (*parameters, *EQUATIONS, *effects_of(parameters, len(recordings)))
    problem = Problem(
        recordings=recordings, robot=robot, parameters=every, delays=delays,
        noise=noise | process(recordings, robot, ANNEALING_NOISE[0]),
    )  # fmt: skip
    return problem, limits


def _idle(log: Log) -> bool:
    """Whether the commands never change."""
    prefix = commanded(log)
    return bool(prefix) and not any(np.ptp(log[f"{prefix}/{side}"]) for side in ("left", "right"))


def _dead_time(kit: Kit, logs: Sequence[Log]) -> float:
    """From a logged command to the motor [s]: of what was really applied, only what is less than a period."""
    whole = any(commanded(log) == "command" for log in logs)
    periods = 0 if whole else math.floor(kit.delay / kit.period + 1e-9)
    return kit.delay - periods * kit.period + kit.jitter / 2


def _delay(kit: Kit, sensor: str) -> float:
    return max((s.delay for name, s in kit.sensors.items() if SENSOR.get(name) == sensor), default=0.0)


def _with_process(problem: Problem, fraction: float) -> Problem:
    return replace(problem, noise={**problem.noise, **process(problem.recordings, problem.robot, fraction)})


def _sensor_bounds(limits: Mapping[str, float]) -> dict[str, tuple[float, float]]:
    """Between which variances a sensor's noise is learnt, of those that its kit has."""
    return {name: (variance / 4, variance * MOST_SENSOR) for name, variance in limits.items()}


def annealed(problem: Problem, limits: Mapping[str, float]) -> tuple[Problem, Array]:
    """From the best of several starts, with less and less process noise, as long as the filter keeps the robot: on the
    beginning of the logs, since only the way down is sought, and on the whole where that does not follow the rest."""
    z = _best_start(problem, limits)
    early, result = _less_noise(replace(problem, recordings=_beginnings(problem)), z, limits)
    fitted = replace(early, recordings=problem.recordings)
    return (fitted, result) if np.isfinite(objective(fitted, result)[0]) else _less_noise(problem, z, limits)


def _beginnings(problem: Problem) -> tuple[Recording, ...]:
    return tuple(head(r, START_SECONDS) for r in problem.recordings)


def _less_noise(problem: Problem, z: Array, limits: Mapping[str, float]) -> tuple[Problem, Array]:
    bounds = _sensor_bounds(limits)
    for fraction in ANNEALING_NOISE:
        less = _with_process(problem, fraction)
        if not np.isfinite(objective(less, z)[0]):
            break
        less = learn_noise(less, z, bounds, iterations=2)
        new, normal, *_ = gauss_newton(less, z, iterations=6, tolerance=0.1)
        if not np.isfinite(normal.objective):
            break
        problem, z = less, new
    return problem, z


def _best_start(problem: Problem, limits: Mapping[str, float]) -> Array:
    """The prior with its delays, or with longer ones, whichever explains the beginning of the logs best."""
    early = replace(problem, recordings=_beginnings(problem))
    tries: list[tuple[float, Array]] = []
    for all_extra, gyro_extra, heavier in STARTS:
        z = np.zeros(len(problem.parameters))
        for i, p in enumerate(problem.parameters):
            if p.name.startswith("delay/"):
                extra = all_extra + (gyro_extra if p.name == "delay/gyro" else 0)
                z[i] = p.coordinate(p.prior + extra * problem.recordings[0].period)
            elif p.name == "pitch_inertia" and p.name not in problem.held:
                z[i] = heavier
        if np.isfinite(objective(early, z)[0]):
            start = learn_noise(early, z, _sensor_bounds(limits), iterations=1)
            z, normal, *_ = gauss_newton(start, z, iterations=3, tolerance=0.3)
            tries.append((normal.objective, z))
            if len(tries) == 1 and all(start.noise[n] < np.log(PLAUSIBLE_NOISE * v) for n, v in limits.items()):
                break
    if not tries:
        raise _lost()
    return min(tries, key=lambda t: t[0])[1]


def _lost() -> DesignFailed:
    return DesignFailed(
        "the filter loses the robot from every start", expected="a log of the named robot, balancing",
        likely="another robot, a flipped sign or a wrong unit", hint="run `upright doctor` on the log",
    )  # fmt: skip


def refined(problem: Problem, z: Array, limits: Mapping[str, float]) -> Fitted:
    """Parameters and noise of greatest likelihood; where the innovations show that the model is not right, those whose
    free simulation follows the log best, and readings weighted by their effective sample size."""
    from upright.calibrate.validate import worst_correlation

    calm = _with_process(problem, FREEDOM / 10)
    start = calm if np.isfinite(objective(calm, z)[0]) else problem
    rough = _settled(start, z, _bounds(problem, limits, FREEDOM))
    best = _polished(rough, _bounds(problem, limits, FREEDOM))
    if worst_correlation(*best) < WHITE:
        return _tempered(*_between_runs(best))
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        others = pool.submit(_without_first, problem, limits)
        fits = [rough, *pool.map(partial(segmented, problem, limits), (np.zeros_like(z), z, rough.z)), *others.result()]
        best, level = _best_simulated(fits, [*pool.map(_simulated, fits)], LEVEL)
        moved = pool.map(partial(_with_gyro_delay, best.problem, best.z), GYRO_DELAY_TRIALS)
        tries = [fit for fit in moved if fit.normal.objective < best.normal.objective]
        best, _ = _best_simulated([best, *tries], [level, *pool.map(_simulated, tries)])
        several = [best, *fits] if len(problem.recordings) > 1 else [best]  # weighted, each may go elsewhere
        last = [_tempered(*fit) for fit in pool.map(_between_runs, several)]
        return _best_simulated(last, [*pool.map(_simulated, last)], LEVEL)[0]


def _between_runs(fit: Fitted) -> Fitted:
    """The same fit with the spreads between runs that it shows; of one run none can."""
    for _ in range(SPREADS if len(fit.problem.recordings) > 1 else 0):
        covariance = np.linalg.inv(fit.normal.hessian).astype(np.float64)
        parameters, z = respread(fit.problem.parameters, fit.z, covariance)
        fit = _fitted(replace(fit.problem, parameters=parameters), z, iterations=5)
    return fit


def segmented(problem: Problem, limits: Mapping[str, float], z: Array) -> Fitted:
    """From z, the fit of what free simulations of half a second leave."""
    problem = _with_process(replace(problem, restart=SEGMENT), SEGMENT_NOISE)
    bounds = _sensor_bounds(limits)
    first = {name: math.log(min(max(_changes(problem, name), low), high)) for name, (low, high) in bounds.items()}
    problem = replace(problem, noise={**problem.noise, **first})
    for _ in range(6):
        problem = learn_noise(problem, z, bounds, iterations=5)
        fit, before = _fitted(problem, z, iterations=5), z
        z = fit.z
        if np.abs(z - before).max() < SETTLED:
            return fit
    return _fitted(problem, z, iterations=10)


def _without_first(problem: Problem, limits: Mapping[str, float]) -> list[Fitted]:
    """From a fit without rolling friction, where that is asked: with it a bad optimum may be nearer to the prior."""
    without, zero = replace(problem, held=problem.held | {ROLLING}), np.zeros(len(problem.parameters))
    asked = ROLLING in {p.name for p in problem.parameters} - problem.held
    return [segmented(problem, limits, segmented(without, limits, zero).z)] if asked else []


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


def _fitted(problem: Problem, z: Array, *, iterations: int) -> Fitted:
    """Gauss–Newton from z."""
    result = gauss_newton(problem, z, iterations=iterations)
    return Fitted(problem, result.z, result.normal, result.paths)


def _simulated(fit: Fitted) -> float:
    """How well the robot of a fit follows the log when it is simulated freely."""
    from upright.calibrate.validate import score

    return score(fit.problem, fit.z) if np.isfinite(fit.normal.objective) else -np.inf


def _best_simulated(fits: Sequence[Fitted], scores: Sequence[float], level: float = 0.0) -> tuple[Fitted, float]:
    """The fit with the best of these `scores`, and its score; of fits that leave more than it by a fraction of at most
    `level`, the one whose numbers the prior takes for likeliest."""
    least = max(scores) - level * (1 - max(scores)) if np.isfinite(max(scores)) else -np.inf
    good = [(fit, value) for fit, value in zip(fits, scores, strict=True) if value >= least]
    return min(good, key=lambda one: float(one[0].z @ one[0].z))


def _with_gyro_delay(problem: Problem, z: Array, periods: float) -> Fitted:
    """The fit from z with so many periods added to the gyro's delay."""
    for i, p in enumerate(problem.parameters):
        if p.name == "delay/gyro":
            z = z.copy()
            z[i] = max(p.coordinate(float(p.value(z[i])) + periods * problem.recordings[0].period), p.least)
    return _fitted(problem, z, iterations=10)


def _bounds(problem: Problem, limits: Mapping[str, float], fraction: float) -> Bounds:
    top, dry = process(problem.recordings, problem.robot, fraction), most_friction(problem.robot)
    top[STICKING] = max(top[STICKING], math.log((dry / motor_gain(problem.robot)) ** 2 * NOISE_TIME + 1e-30))
    free = {
        name: (math.exp(value) * NOISE_RANGE, math.exp(value)) for name, value in top.items() if name != "gyro_bias"
    }
    return {**_sensor_bounds(limits), **free}


def _settled(problem: Problem, z: Array, bounds: Bounds) -> Fitted:
    """Parameters and noise in turn, until the noise of the sensors stays. Parameters first: noise that is learnt at
    wrong ones explains what they leave, and then hides from the next fit that they are wrong."""
    inside = {n: float(np.clip(problem.noise[n], np.log(low), np.log(high))) for n, (low, high) in bounds.items()}
    within = replace(problem, noise={**problem.noise, **inside})
    problem = within if np.isfinite(objective(within, z)[0]) else problem
    for turn in range(6):
        _, z, normal, paths = _fitted(problem, z, iterations=5)
        before, problem = problem, learn_noise(problem, z, bounds, iterations=3 if turn else 5)
        changed = {n: abs(problem.noise[n] - before.noise[n]) for n in bounds}
        if max(changed.values()) < NOISE_TOLERANCE:
            return Fitted(before, z, normal, paths)
    return _fitted(problem, z, iterations=8)


def _polished(fit: Fitted, bounds: Bounds) -> Fitted:
    """The same in fine steps, where these are finer."""
    fine = replace(fit.problem, fine=True)
    if fine.longest == fit.problem.longest:
        return fit
    problem = learn_noise(fine, fit.z, bounds, iterations=2)
    return _fitted(problem, fit.z, iterations=10)


def _tempered(problem: Problem, z: Array, normal: Normal, paths: Sequence[Path]) -> Fitted:
    """The same fit in fine steps, with readings weighted by their effective sample size against the prior. Where the
    prior would then draw the fit away from what predicts the log, the fit stays and only its intervals widen."""
    from upright.calibrate.informativity import effective_fraction
    from upright.calibrate.validate import score

    longest, problem, first = problem.longest, replace(problem, fine=True), z
    for _ in range(2):
        fraction = effective_fraction(problem, normal, paths)
        if abs(fraction / problem.temper - 1) < WEIGHT_TOLERANCE and problem.longest == longest:
            break
        problem, longest = replace(problem, temper=fraction), problem.longest
        _, z, normal, paths = _fitted(problem, z, iterations=10)
    if problem.temper < LEAST_WEIGHT and score(problem, z) < score(problem, first) - WORST_LOSS:
        value, paths = objective(problem, first)
        return Fitted(problem, first, normal_equations(problem, first, paths, value), paths)
    return Fitted(problem, z, normal, paths)
