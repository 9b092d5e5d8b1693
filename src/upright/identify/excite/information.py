"""What a run would tell: Fisher's information of the predictor that `calibrate` uses, and the signals that give most.

Information adds over signals at different frequencies, so that of a mixture is nearly the sum of its parts' by their
shares. What is to be small is the mean logarithm of the interval widths: as with D-optimality no unit and no scale
enters, but what counts is each parameter's own interval, not directions that nobody reads; its gradient is that of
A-optimality with weights that follow the widths.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from upright.identify.calibrate import FREEDOM, prepared, process
from upright.identify.fitting import Problem, normal_equations, objective
from upright.identify.informativity import too_quiet
from upright.identify.noise import Bounds, learn_noise
from upright.robots import Kit, Robot
from upright.signals import Log

Array = NDArray[np.float64]

HELD_OUT = 0.25
"""Last share of a log that `calibrate` keeps back by default, and that tells nothing."""

SHARES = (FREEDOM / 10, FREEDOM, 0.1, 0.3)
"""Process noise, as a share of the commands, tried in turn until the filter follows the log: more than `FREEDOM` only
where kernel and predictor differ, as in their dry friction."""

FOLLOWED = 1.5  # rms of the whitened innovations up to which a log is followed


def problem_of(
    log: Log, robot: Robot, kit: Kit, known: Sequence[str] = (), noise: Mapping[str, float] | None = None
) -> Problem:
    """The calibration of `robot` from `log`, at its prior, with its `noise` (log-variances), which is else learnt."""
    found, limits = prepared([log], robot, kit, known, HELD_OUT)
    problem = replace(found, fine=True)
    if noise is not None:
        given = replace(problem, noise=dict(noise))
        if np.isfinite(_misfit(given)):
            return given
    found = problem
    for share in SHARES:
        found = _learnt(problem, limits, share)
        if _misfit(found) < FOLLOWED:
            return found
    return found


def quiet(log: Log, robot: Robot, kit: Kit, known: Sequence[str] = ()) -> str:
    """Why `calibrate` would give no inertia from that log, in words; '' where it would."""
    return too_quiet(prepared([log], robot, kit, known, HELD_OUT)[0])


def _learnt(problem: Problem, limits: Mapping[str, float], share: float) -> Problem:
    """With the noise of the log, that of the process up to `share`, from a tenth of that where the filter bears it."""
    low, high = (process(problem.recordings, problem.robot, part) for part in (share / 10, share))
    bounds: Bounds = {name: (variance / 4, variance * 1e6) for name, variance in limits.items()}
    free = {name: (float(np.exp(low[name])), float(np.exp(high[name]))) for name in ("motor", "push")}
    start = replace(problem, noise={**problem.noise, **high})
    if not np.isfinite(_misfit(start)):
        return start
    return learn_noise(start, np.zeros(len(problem.parameters)), {**bounds, **free}, iterations=5)


def _misfit(problem: Problem) -> float:
    """Root mean square of the whitened innovations at the prior; inf where the filter loses the robot."""
    value, paths = objective(problem, np.zeros(len(problem.parameters)))
    if not np.isfinite(value):
        return np.inf
    parts = [path.e / np.sqrt(path.s) for path in paths]
    return float(np.sqrt(np.nanmean(np.concatenate(parts) ** 2)))


def fisher(problem: Problem) -> Array:
    """Information (n, n) about the parameters of `problem`, in deviations of their prior: JᵀJ of the whitened
    innovations. Zero where the filter loses the robot."""
    z = np.zeros(len(problem.parameters))
    value, paths = objective(problem, z)
    if not np.isfinite(value):
        return np.zeros((len(z), len(z)))
    J = normal_equations(problem, z, paths, value).slopes
    return J.T @ J


def shrunk(M: Array) -> Array:
    """What is left (n,) of each parameter's interval when `M` (n, n) joins the prior; 1 is nothing gained."""
    return np.sqrt(np.diag(np.linalg.inv(np.eye(len(M)) + M)))


def score(M: Array, weights: Array) -> float:
    """The weighted mean logarithm of `shrunk`: less is better."""
    return float(weights @ np.log(shrunk(M)) / weights.sum())


def best_shares(base: Array, parts: Array, weights: Array, iterations: int = 1000) -> Array:
    """Shares (m,) of one energy among `parts` (m, n, n), what all of it would tell by each, beside `base` (n, n), that
    make `score` least: by multiplicative steps (Silvey, Titterington and Torsney 1978)."""
    shares = np.full(len(parts), 1 / len(parts))
    for _ in range(iterations):
        C = np.linalg.inv(np.eye(len(base)) + base + np.tensordot(shares, parts, 1))
        scaled = (C * (weights / np.diag(C))) @ C
        gain = np.maximum(np.einsum("ij,kji->k", scaled, parts), 0.0)
        if not gain.any():
            break
        shares = shares * np.sqrt(gain)
        shares = shares / shares.sum()
    return np.where(shares > LEAST_SHARE, shares, 0.0) / shares[shares > LEAST_SHARE].sum()


LEAST_SHARE = 0.01
"""Of the energy: less is not worth a line of the plan."""


def added(M: Array, base: Array) -> Array:
    """What M (n, n) tells beyond `base`, without directions in which noise made it less."""
    values, directions = np.linalg.eigh(M - base)
    return (directions * np.maximum(values, 0.0)) @ directions.T
