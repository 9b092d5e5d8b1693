"""The noise that a log shows: process and sensor variances of greatest likelihood, by Fisher's scoring."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from upright.arrays import Array
from upright.calibration.fitting import OUTLIER, Problem, huber_weight
from upright.calibration.parameters import rows_of
from upright.calibration.threads import in_threads
from upright.logs.recording import SENSOR

ENOUGH = 1000
"""Samples from which the noise is learnt: its variances then are known to 5 %, which no parameter notices."""
GAIN = 0.1  # in log-likelihood, below which a step is the last: a noise that does not matter has no end of its own

MOST_SENSOR = 1e6  # [1] most variance that is learnt of a sensor, over the one its kit has
TINY = 1e-12  # [1] of a variance: least scale of a noise, of innovations that are all zero

Bounds = Mapping[str, tuple[float, float]]
Parts = tuple[Array, Array, NDArray[np.str_]]
"""Innovations, their variances, and the sensor of each."""


def sensor_bounds(limits: Mapping[str, float]) -> dict[str, tuple[float, float]]:
    """Between which variances a sensor's noise is learnt, of those that its kit has."""
    return {name: (variance / 4, variance * MOST_SENSOR) for name, variance in limits.items()}


def learn_noise(problem: Problem, z: Array, bounds: Bounds, *, iterations: int = 3) -> Problem:
    """The same problem with the noise that makes the innovations most likely, by Fisher's scoring on the logarithms of
    the variances that have `bounds`."""
    names = list(bounds)
    low, high = np.log([bounds[n][0] for n in names]), np.log([bounds[n][1] for n in names])
    eta = np.clip([problem.noise[n] for n in names], low, high)
    damping = 0.05
    parts = _likelihood_parts(_with_noise(problem, names, eta), z)
    value, gradient, hessian = _noise_score(problem, z, names, eta, parts)
    for _ in range(iterations):
        for _ in range(4):
            free = ~(((eta <= low) & (gradient > 0)) | ((eta >= high) & (gradient < 0)))
            H = (hessian + damping * np.diag(np.diag(hessian)) + 1e-6 * np.eye(len(eta)))[
                np.ix_(rows_of(free), rows_of(free))
            ]
            step = np.zeros_like(eta)
            step[free] = -np.linalg.solve(H, gradient[free])
            new = np.clip(eta + np.clip(step, -2.0, 2.0), low, high)
            there = _likelihood_parts(_with_noise(problem, names, new), z)
            now = _noise_objective(there)
            if now < value:
                break
            damping = 10 * damping
        else:
            new, now, there = _scaled(problem, z, names, eta, (low, high), parts)
            if not now < value:
                break
        small = np.abs(new - eta).max() < 0.05 or value - now < GAIN
        eta = new
        damping = damping / 5
        parts = there
        if small:
            break
        value, gradient, hessian = _noise_score(problem, z, names, eta, parts)
    return _with_noise(problem, names, eta)


def scaled_noise(problem: Problem, z: Array, bounds: Bounds) -> tuple[float, Problem]:
    """The objective at z of the beginning of the logs, and the problem whose noise it belongs to: the given one, or the
    likelier one whose innovations are as large as its filter expects."""
    names = list(bounds)
    low, high = np.log([bounds[n][0] for n in names]), np.log([bounds[n][1] for n in names])
    eta = np.array([problem.noise[n] for n in names])
    parts = _likelihood_parts(_with_noise(problem, names, eta), z)
    value = _noise_objective(parts)
    if not np.isfinite(value):
        return value, problem
    new, now, _ = _scaled(problem, z, names, eta, (low, high), parts)
    return (now, _with_noise(problem, names, new)) if now < value else (value, problem)


def _scaled(
    problem: Problem, z: Array, names: Sequence[str], eta: Array, bounds: tuple[Array, Array], parts: Parts
) -> tuple[Array, float, Parts]:
    """Log-variances with which innovations would be as large as their filter expects, and the objective and likelihood
    there; `parts` is that at `eta`.

    Where all are scaled alike, gains and innovations stay as they are. So this goes on where a filter that is far from
    the log depends on its noise too roughly for a slope.
    """
    e, s, sensor = parts
    loss = _robust(e, s)[1] * e**2 / s
    if not np.isfinite(loss).all():
        return eta, np.inf, parts
    own = {name: float(loss[sensor == name].mean()) for name in names if (sensor == name).any()}
    tries = [
        np.clip(eta + np.log([max(own.get(n, process), TINY) for n in names]), *bounds)
        for process in (float(loss.mean()), 1.0)
    ]
    there = [_likelihood_parts(_with_noise(problem, names, new), z) for new in tries]
    values = [_noise_objective(one) for one in there]
    best = int(np.argmin(values))
    return tries[best], values[best], there[best]


def _with_noise(problem: Problem, names: Sequence[str], eta: Array) -> Problem:
    return problem.with_noise(dict(zip(names, eta.tolist(), strict=True)))


def _likelihood_parts(problem: Problem, z: Array) -> Parts:
    """Those of the samples that are enough."""
    parts: list[Parts] = []
    for recording in problem.recordings:
        until = recording.when[0] + ENOUGH * recording.period / len(problem.recordings)
        path = problem.filtered(recording, z, until=until, fitted=True)
        use = recording.judged & (recording.when <= until)
        sensor = np.array([SENSOR[row] for row in recording.rows])
        parts.append((path.e[use], path.s[use], sensor[recording.kind[use]]))
    e, s, sensor = (np.concatenate(each) for each in zip(*parts, strict=True))
    return e, s, sensor


def _noise_objective(parts: Parts) -> float:
    e, s, _ = parts
    if not (np.isfinite(e).all() and (s > 0).all()):
        return np.inf
    return 0.5 * float((_robust(e, s)[0] + np.log(s)).sum())


def _robust(e: Array, s: Array) -> tuple[Array, Array]:
    """Huber's loss, twice, and the weight that belongs to it."""
    r2 = e**2 / s
    return np.where(r2 > OUTLIER**2, 2 * OUTLIER * np.sqrt(r2) - OUTLIER**2, r2), huber_weight(np.sqrt(r2))


def _noise_score(
    problem: Problem, z: Array, names: Sequence[str], eta: Array, parts: Parts
) -> tuple[float, Array, Array]:
    """Objective, its gradient and Fisher's information for the log-variances; `parts` is the likelihood at `eta`."""
    step = 0.05
    moved = in_threads(lambda at: _likelihood_parts(_with_noise(problem, names, at), z), eta + step * np.eye(len(eta)))
    e, s, _ = parts
    loss, weight = _robust(e, s)
    with np.errstate(invalid="ignore"):  # a filter that lost the robot has no variance, and its step is not taken
        dlog = np.column_stack([(np.log(s1) - np.log(s)) / step for _, s1, _ in moved])
    de = np.column_stack([(e1 - e) / step for e1, _, _ in moved])
    gradient = (0.5 * (1 - weight * e**2 / s)) @ dlog + (weight * e / s) @ de
    hessian = 0.5 * dlog.T @ dlog + de.T @ (de / s[:, None])
    return 0.5 * float((loss + np.log(s)).sum()), gradient, hessian
