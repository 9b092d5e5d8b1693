"""Whether the driver keeps a constant voltage of each command: the fit with a drop, where it is clearly likelier.

A drop acts against the command, dry friction against the motion: where a motor brakes, they have other signs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from upright.arrays import Array
from upright.calibration.electronics import DROP
from upright.calibration.estimate import SURPRISE, VISIBLE, Estimate
from upright.calibration.fitting import Fitted, Problem
from upright.calibration.parameters import Parameter
from upright.calibration.sought import likelier, with_parameters
from upright.pages import Say

LEAST, MOST = 0.3, 4.0
"""[V] 95 % of the prior lie between: what two saturated transistors of a bridge keep, 0.3 V of small ones at little
current to the 4.9 V of an L298 at 2 A, of which motors of such robots draw a part (data sheets of L293D, SN754410,
L298)."""
STARTS = (0.4, 0.8, 1.6, 3.2)
"""[V] from which it is looked for."""


def drop_about() -> Parameter:
    """A drop of which nothing is stated."""
    typical = math.sqrt(LEAST * MOST)
    spread = math.log(MOST / LEAST) / (2 * 1.96)
    return Parameter(DROP, "V", typical, typical * spread, "logarithm", 0.0, guess=True)


def dropped(fit: Fitted, settled: Callable[[Problem, Array], Fitted]) -> Fitted | None:
    """The fit with a drop, from one without; None where it is not likelier by `MARGIN`, or contradicts what drivers
    keep, or no driver of these logs may have one that is not stated. `settled` learns parameters and noise from a
    start."""
    problem, z, *_ = fit
    if not problem.foreign or problem.robot.drive != "voltage" or any(p.name == DROP for p in problem.asked):
        return None
    starts = [with_parameters(problem, z, {drop_about(): value}) for value in STARTS]
    with_drop = likelier(fit, starts, (DROP,), settled)
    if with_drop is None:
        return None
    other, nats = with_drop
    (size,) = (abs(x) for p, x in zip(other.problem.asked, other.z, strict=False) if p.name == DROP)
    if size > SURPRISE:  # millivolts are none, however much likelier a log of fine sensors is with them
        return None
    return other._replace(problem=replace(other.problem, drop=nats))


def in_words(estimates: Sequence[Estimate], nats: float = 0.0) -> list[Say]:
    """What the driver keeps; nothing where it had not to be found, by `nats`, or the log leaves it open."""
    return [
        Say("The driver takes {drop} off each command.", drop=e.quantity)
        for e in estimates
        if nats and e.name == DROP and e.verdict == VISIBLE
    ]
