"""Falls that the gyro does not show in time, since it is wrong itself: they show in the log without its fault."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.diagnose.changes import scaled_sensors
from upright.diagnose.fall import fall_time, falling, pace
from upright.diagnose.fault_fits import FaultFit
from upright.diagnose.innovations import OFFSET, FilterRun
from upright.diagnose.remedy import GYRO, ONSET_STEP, Window, anywhere, followed, lately, moved, remedied
from upright.diagnose.sizes import SURVIVED_FOR
from upright.diagnose.usual import calm_of
from upright.errors import InvalidLog

TIPPING = 0.35  # [rad] lean at the log's end that is a fall where the filter has lost the robot as well
AFTER = 0.4  # [s] of a quick robot after its onset, by which the size of a gyro's offset is found
EARLIER = 0.03  # [s] by which a fall is earlier than the gyro shows, to be looked at again
FALLS = 1.5  # times in which it falls e-fold, that a robot stands by a wrong gyro at least
EXPLAINS, ONLY_NOISE = 0.1, 2.0
"""Most NIS up to the earlier fall that the gyro without its fault may leave, over that with it, and over the calm one;
of a scale not the latter, since it multiplies noise and what is wrong with the robot's file."""

SHOWS = (0.5, 2.0, 0.1, 0.2, 0.35, 5.0)  # times the motion, that a gyro shows and that are tried first
ANGLES = (0.5, 2.0, 0.3, 1.4)  # times its angle, that an encoder shows and that are tried first
LOUD, LOUD_FOR = 20.0, 0.4  # NIS over the usual one, and for how long [s], of a fall that the gyro does not show


def mis_scaled(run: FilterRun, window: Window) -> list[FaultFit]:
    """A gyro of another scale that explains most of a log, of any size: a signature is of the robot that stands, and a
    gyro that shows a seventh of the motion goes far from it. It explains until the robot falls by it, and what the
    floor does then nothing explains, as it does without it. Its offset is scaled with the motion, or stays as it was.
    Nothing where the robot falls by none of them."""
    try:
        recent = lately(run, window)
    except InvalidLog:  # sensors that stand still for so long
        return []
    usual = window.of(recent)
    then = usual.clock[usual.readings]
    costs = np.log1p(usual.whitened**2)

    def cost(tried: FaultFit) -> float:
        freed = remedied(recent, tried)
        fell_at = fall_time(freed) if freed is not None else None
        if freed is None or fell_at is None or not len(freed.clock):
            return math.inf
        part = window.of(freed)
        end = min(fell_at, float(freed.clock[-1]))
        until = part.clock[part.readings] < end
        return float(np.log1p(part.whitened[until] ** 2).sum() + costs[then >= end].sum())

    gyro = FaultFit(fault="scale", way=GYRO.removeprefix("sensor/"))
    before = usual.after[usual.clock < window.end - window.seconds / 2, OFFSET]  # of more seconds than of trouble
    shown = [(), (float(np.median(before)),)] if len(before) else [()]
    sizes = [1 - 1 / shows for shows in SHOWS]
    least, best = min((anywhere(cost, replace(gyro, more=one), sizes, window) for one in shown), key=lambda one: one[0])
    return [best] if least < float(costs.sum()) and not _of_another_robot(best, window) else []


def _of_another_robot(fit: FaultFit, window: Window) -> bool:
    """Whether a sensor has its scale from the beginning of what is examined on, and the robot stands by it: so does any
    sensor under the file of another robot."""
    return fit.onset < window.end - window.seconds + ONSET_STEP / 2 and window.end - fit.onset > SURVIVED_FOR


def mis_scaled_angles(run: FilterRun, window: Window) -> list[FaultFit]:
    """An encoder, or both, of another scale that explains most of a log beside pushes of any shape: by the same loss,
    for which what a push does counts little, and a fit of squares with pushes beside it ends at another fault."""
    recent = lately(run, window)

    def cost(tried: FaultFit) -> float:
        freed = followed(recent, float(recent.t[-1]), tried)
        return math.inf if freed is None else float(np.log1p(window.of(freed).whitened ** 2).sum())

    sizes = [1 - 1 / shows for shows in ANGLES]
    angles = [way for way in scaled_sensors(run) if f"sensor/{way}" != GYRO]
    several = [anywhere(cost, FaultFit(fault="scale", way=way), sizes, window)[1] for way in angles]
    return [fit for fit in several if not _of_another_robot(fit, window)]


def unseen(run: FilterRun, window: Window) -> float | None:
    """When a robot fell [s] whose gyro shows so little of it that neither its angle nor the filter's falls; None where
    nothing is loud in the log, or where no such gyro explains it."""
    part = window.of(run)
    if not part.readings.any():
        return None
    blocks = np.floor((part.clock[part.readings] - part.clock[0]) / LOUD_FOR).astype(int)
    squares = np.bincount(blocks, part.whitened**2) / np.maximum(np.bincount(blocks), 1)
    return sooner(run, mis_scaled(run, window), window) if squares.max() > LOUD * window.usual else None


def hidden_fall(run: FilterRun, several: Sequence[FaultFit]) -> float | None:
    """The time of the fall [s] that shows where the likeliest fault is taken out of the log."""
    for fit in several:
        freed = remedied(run, fit) if fit.fault in ("bias", "delay") else None
        fell_at = fall_time(freed) if freed is not None else None
        if fell_at is not None:
            return fell_at
    # a log of delayed readings ends before they show the floor
    return float(run.t[-1]) if abs(run.after[-1, 0]) > TIPPING else None


def sooner(run: FilterRun, several: Sequence[FaultFit], window: Window) -> float | None:
    """When the robot fell [s] by a gyro whose offset, or scale, explains all until then, and which shows the fall too
    late: what is after the fall, the floor for instance, is explained by nothing."""
    calm = calm_of(run, window)
    least = FALLS / falling(run.robot).pole
    wrong = [one for one in several if (one.fault, one.way) in (("bias", "step"), ("scale", "gyro"))]
    for fit in (one for one in wrong if one.onset + least < window.end - EARLIER):
        if fit.fault == "bias":
            end = min(window.end, fit.onset + AFTER * pace(run.robot))
            part = replace(window, end=end, seconds=window.seconds - (window.end - end), banks={})
            freed = remedied(run, moved(run, [[fit]], part)[0])
        else:
            freed = remedied(lately(run, window), fit)
        true = fall_time(freed) if freed is not None else None
        if freed is None or true is None or not fit.onset + least < true < window.end - EARLIER:
            continue
        left, before = (float(np.mean(one.between(fit.onset, true).whitened ** 2)) for one in (freed, run))
        if left < min(EXPLAINS * before, ONLY_NOISE * calm if fit.fault == "bias" else math.inf):
            return true
    return None
