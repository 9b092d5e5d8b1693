"""What the checks of a log measured, beside that from which on they find a fault."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.checkup import sensors, swings, time
from upright.checkup.finding import LEFT, Record
from upright.logs import outliers


@dataclass(frozen=True)
class Measured:
    """What a check measured, its `value`, and the `limit` from which on it is a fault, in one SI `unit`."""

    value: float
    limit: float
    unit: str


def measured(read: Record, sound: Record | None, period: float) -> dict[str, Measured]:
    """By check, for those with one number: of the log as it was read, and where its units and times are right, `sound`
    with its poses."""
    found: dict[str, Measured] = {}
    steps = np.diff(read.t)
    ordinary = steps[(steps > 0) & (steps < time.MISSED * period)]
    if len(ordinary):
        found["time stamps"] = Measured(float(ordinary.std()), time.JITTER * period, "s")
    if read.commands:
        at, _ = sensors.at_limit(read, read.commands)
        found["limits"] = Measured(at, outliers.PILED, "fraction")
    if sound is None:
        return found
    moved = np.abs(np.diff(sound[LEFT])) if LEFT in sound else np.zeros(0)
    if (moved > 0).any():
        found["steps"] = Measured(float(moved[moved > 0].min()), sensors.COARSE_ENCODER, "rad")
    if drifted := swings.drift(sound):
        mean, limit, _ = drifted
        found["bias"] = Measured(mean, limit, "rad/s")
    if swing := swings.amplitude(sound):
        found["motion"] = Measured(swing, swings.QUIET, "rad")
    return found
