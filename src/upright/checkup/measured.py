"""What the checks of a log measured, beside that from which on they find a fault."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.checkup import sensors, swings, time
from upright.checkup.finding import LEFT, Record
from upright.logs import outliers


@dataclass(frozen=True)
class CheckNumber:
    """What a check measured, its `value`, and the `limit` from which on it is a fault, in one SI `unit`."""

    value: float
    limit: float
    unit: str


def measured(read: Record, sound: Record | None, period: float) -> dict[str, CheckNumber]:
    """By check, for those with one number: of the log as it was read, and where its units and times are right, `sound`
    with its poses."""
    numbers: dict[str, CheckNumber] = {}
    steps = np.diff(read.t)
    ordinary = steps[(steps > 0) & (steps < time.MISSED * period)]
    if len(ordinary):
        numbers["time stamps"] = CheckNumber(float(ordinary.std()), time.JITTER * period, "s")
    if read.commands:
        at, _ = sensors.at_limit(read, read.commands)
        numbers["limits"] = CheckNumber(at, outliers.PILED, "fraction")
    if sound is None:
        return numbers
    moved = np.abs(np.diff(sound[LEFT])) if LEFT in sound else np.zeros(0)
    if (moved > 0).any():
        numbers["steps"] = CheckNumber(float(moved[moved > 0].min()), sensors.COARSE_ENCODER, "rad")
    if drifted := swings.drift(sound):
        mean, limit, _ = drifted
        numbers["bias"] = CheckNumber(mean, limit, "rad/s")
    if swing := swings.amplitude(sound):
        numbers["motion"] = CheckNumber(swing, swings.QUIET, "rad")
    return numbers
