"""Whether the gyro is tilted, and so reads a part of the yaw rate beside the pitch rate: the fit with that part, where
it is clearly likelier than the fit without."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from upright.arrays import Array
from upright.calibration.electronics import MISALIGNED, TILTED
from upright.calibration.estimate import VISIBLE, Estimate
from upright.calibration.fitting import Fitted, Problem
from upright.calibration.informativity import TURNING
from upright.calibration.parameters import Parameter
from upright.calibration.sought import likelier, with_parameters
from upright.logs.recording import SENSOR
from upright.pages import Quantity, Say


def part_about() -> Parameter:
    """A part of the yaw rate [1], of which nothing is stated."""
    return Parameter(MISALIGNED, "1", 0.0, TILTED, "linear", guess=True)


def misaligned(fit: Fitted, settled: Callable[[Problem, Array], Fitted]) -> Fitted | None:
    """The fit with a tilted gyro, from one without; None where it is not likelier by `MARGIN`, or these logs do not
    show how the robot turns. `settled` learns parameters and noise from a start."""
    problem, z, *_ = fit
    if not problem.foreign or any(p.name == MISALIGNED for p in problem.asked) or not _turns(problem):
        return None
    tilted = likelier(fit, [with_parameters(problem, z, {part_about(): 0.0})], (MISALIGNED,), settled)
    if tilted is None:
        return None
    other, nats = tilted
    return other._replace(problem=replace(other.problem, misalignment=nats))


def _turns(problem: Problem) -> bool:
    """Whether a log has a gyro beside two encoders, and the robot turns in it."""
    kinds = [[SENSOR[row] for row in r.rows] for r in problem.recordings]
    return not problem.held & {*TURNING} and any("gyro" in k and k.count("encoder") == 2 for k in kinds)


def in_words(estimates: Sequence[Estimate], nats: float = 0.0) -> list[Say]:
    """How far the gyro is tilted; nothing where that had not to be found, by `nats`, or the log leaves it open."""
    return [
        Say("The gyro is tilted by {angle}: it also reads {part} of the yaw rate.",
            angle=Quantity(abs(math.asin(max(-1.0, min(1.0, e.value)))), "rad", digits=2),
            part=Quantity(e.value, "1", low=e.low, high=e.high, digits=2))
        for e in estimates
        if nats and e.name == MISALIGNED and e.verdict == VISIBLE
    ]  # fmt: skip
