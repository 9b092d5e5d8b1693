"""Fisher's information of a run for the predictor of `calibrate`, and the division of energy that gives most.

Information adds over signals at different frequencies, so that of a mixture is nearly the sum of its parts' by their
division. What is to be small is the mean logarithm of the interval widths: as with D-optimality no unit and no scale
enters, but what counts is each parameter's own interval, not directions that nobody reads; its gradient is that of
A-optimality with weights that follow the widths.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.calibration.calibrate import prepared
from upright.calibration.electronics import CONSTANT
from upright.calibration.fitting import STICKING, Problem, normal_equations, objective
from upright.calibration.informativity import too_quiet
from upright.calibration.process_noise import process
from upright.calibration.refined import FREEDOM
from upright.pages import Say
from upright.robots import Kit, Robot
from upright.signals import Log

HELD_OUT = 0.25
"""Last fraction of a log that `calibrate` holds out by default, and that gives no information."""

PROCESS_NOISE = (FREEDOM / 10, FREEDOM, 0.1, 0.3)
"""Process noise over the commands (rms): what twins of the equations' own robot show (contacts that yield, dry
friction that is not quite theirs), so that slow motion tells less than a perfect model would have it; and more, where
the filter would lose the robot otherwise, since kernel and predictor differ in their dry friction."""

LOOSE = 0.03
"""Noise while a wheel sticks, over the friction that holds it: what twins show."""


def problem_of(log: Log, robot: Robot, kit: Kit, known: Sequence[str] = ()) -> Problem:
    """The calibration of `robot` from `log` at its prior, with the noise of the kit's sensors and the least
    `PROCESS_NOISE` with which the filter does not lose the robot. The floor is taken for level."""
    problem = replace(prepared([log], robot, kit, (*known, CONSTANT), HELD_OUT)[0], fine=True)
    several = (replace(problem, noise={**problem.noise, **_process(problem, size)}) for size in PROCESS_NOISE)
    return next((p for p in several if np.isfinite(objective(p, np.zeros(len(p.parameters)))[0])), problem)


def _process(problem: Problem, size: float) -> dict[str, float]:
    noise = process(problem.recordings, problem.robot, size)
    return noise | {STICKING: noise[STICKING] + 2 * np.log(LOOSE)}


def quiet(log: Log, robot: Robot, kit: Kit, known: Sequence[str] = ()) -> Say | None:
    """Why `calibrate` would give no inertia from that log, in words; None where it would."""
    return too_quiet(prepared([log], robot, kit, (*known, CONSTANT), HELD_OUT)[0])


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


def best_division(base: Array, parts: Array, weights: Array, iterations: int = 1000) -> Array:
    """Fractions (m,) of one energy among `parts` (m, n, n), the information of all of it in each, beside `base` (n, n),
    that make `score` least: by multiplicative steps (Silvey, Titterington and Torsney 1978)."""
    division = np.full(len(parts), 1 / len(parts))
    for _ in range(iterations):
        C = np.linalg.inv(np.eye(len(base)) + base + np.tensordot(division, parts, 1))
        scaled = (C * (weights / np.diag(C))) @ C
        gain = np.maximum(np.einsum("ij,kji->k", scaled, parts), 0.0)
        if not gain.any():
            break
        before = division
        division = division * np.sqrt(gain)
        division = division / division.sum()
        if np.abs(division - before).max() < SETTLED:
            break
    return np.where(division > LEAST_PART, division, 0.0) / division[division > LEAST_PART].sum()


SETTLED = 1e-6
"""Of a fraction, in one step: a hundred more such steps move it by a hundredth of `LEAST_PART`."""

LEAST_PART = 0.01
"""Of the energy: less is not worth a line of the plan."""


def added(M: Array, base: Array) -> Array:
    """What M (n, n) tells beyond `base`, without directions in which noise made it less."""
    values, directions = np.linalg.eigh(M - base)
    return (directions * np.maximum(values, 0.0)) @ directions.T
