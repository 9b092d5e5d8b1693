"""Whether the gyro of a log has a resonance: the fit with one, where it is clearly likelier than the fit without."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.calibration.fitting import Fitted, Problem, objective
from upright.calibration.resonance import DAMPING, FREQUENCY, SWING, TYPICAL, parameters_about, resonates
from upright.calibration.sought import likelier, values_of, with_parameters
from upright.calibration.threads import in_threads

FREQUENCIES = (5.0, 7.0, 10.0, 14.0, 20.0, 28.0, 40.0, 56.0)
"""[Hz] of the starts, half an octave apart: a resonance with a damping of 0.1 or more is nearly as wide as that."""
DAMPINGS = (0.1, 0.7)
"""[1] of the starts: what swings, and a filter."""


def resonant(fit: Fitted, settled: Callable[[Problem, Array], Fitted]) -> Fitted | None:
    """The fit with a resonance, from one without; None where it is not likelier by `MARGIN`, or it has one. `settled`
    learns parameters and noise from a start."""
    if resonates(fit.problem.asked):
        return None
    ringing = likelier(fit, _starts(*fit[:2]), TYPICAL, settled)
    if ringing is None:
        return None
    other, nats = ringing
    return other._replace(problem=replace(other.problem, resonance=nats))


def resonating(problem: Problem, z: Array, frequency: float, damping: float) -> tuple[Problem, Array]:
    """The problem with a resonance of the gyro, and z (parameters,) with it there; its gyro is less late by the delay
    2ζ/ω of the resonance."""
    two = parameters_about(TYPICAL[FREQUENCY], TYPICAL[DAMPING])
    ringing, new = with_parameters(problem, z, dict(zip(two, (frequency, damping), strict=True)))
    for i, p in enumerate(problem.asked):
        if p.name == "delay/gyro":
            new[i] = max(p.coordinate(float(p.value(z[i])) - damping / (math.pi * frequency)), p.least)
    return replace(ringing, recordings=tuple(r.swinging() for r in problem.recordings)), new


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
    frequency, damping = values_of(other, at, TYPICAL).values()
    new, z = resonating(problem, z, frequency, damping)
    noise = {**new.noise, SWING: other.noise[SWING]}
    return replace(new, noise=noise, resonance=other.resonance), z
