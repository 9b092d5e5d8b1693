"""Falls that the gyro does not show in time, since it is wrong itself: they show in the log without its fault."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.diagnose.fall import fall_time, falling, pace
from upright.diagnose.fault_fits import FaultFit
from upright.diagnose.innovations import FilterRun
from upright.diagnose.remedy import Window, moved, remedied
from upright.diagnose.usual import calm_of

TIPPING = 0.35  # [rad] lean at the log's end that is a fall where the filter has lost the robot as well
AFTER = 0.4  # [s] of a quick robot after its onset, by which the size of a gyro's offset is found
EARLIER = 0.03  # [s] by which a fall is earlier than the gyro shows, to be looked at again
FALLS = 1.5  # times in which it falls e-fold, that a robot stands by a wrong gyro at least
EXPLAINS, ONLY_NOISE = 0.1, 2.0
"""Most NIS up to the earlier fall that the gyro without its offset may leave, over that with it, and over the calm
one."""


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
    """When the robot fell [s] by a gyro whose offset explains all until then, and which shows the fall too late: what
    is after the fall, the floor for instance, is explained by nothing."""
    calm, least = calm_of(run, window), FALLS / falling(run.robot).pole
    offsets = [one for one in several if (one.fault, one.way) == ("bias", "step")]
    for fit in (one for one in offsets if one.onset + least < window.end - EARLIER):
        end = min(window.end, fit.onset + AFTER * pace(run.robot))
        part = replace(window, end=end, seconds=window.seconds - (window.end - end), banks={})
        freed = remedied(run, moved(run, [[fit]], part)[0])
        true = fall_time(freed) if freed is not None else None
        if freed is None or true is None or not fit.onset + least < true < window.end - EARLIER:
            continue
        left, before = (float(np.mean(one.between(fit.onset, true).whitened ** 2)) for one in (freed, run))
        if left < min(EXPLAINS * before, ONLY_NOISE * calm):
            return true
    return None
