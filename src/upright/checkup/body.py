"""The motion of a robot's body, with its wheels or without, and measures of a reading."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from upright.checkup.finding import LEFT, PITCH, RIGHT, Array, Record
from upright.checkup.physics import Resampled, resampled


def bodily(record: Record) -> Resampled | None:
    """`resampled`; where a log has a tilt estimate and not both encoders, without wheels, since the body alone tells
    most poses."""
    if PITCH not in record or {LEFT, RIGHT} <= record.channels.keys():
        return resampled(record)
    m = resampled(record.changed(dict.fromkeys((LEFT, RIGHT), np.zeros(len(record.t)))))
    return replace(m, wheels=False) if m else None


def commonest(values: Array) -> float:
    """The middle of the shortest interval that holds a third of the values."""
    ordered, count = np.sort(values), max(2, len(values) // 3)
    widths = ordered[count - 1 :] - ordered[: len(ordered) - count + 1]
    first = int(np.argmin(widths))
    return float(ordered[first] + ordered[first + count - 1]) / 2


def noise_of(rate: Array) -> float:
    """Standard deviation of white noise, from second differences, to which motion contributes little."""
    return float(np.median(np.abs(np.diff(rate, 2))) / 0.6745 / np.sqrt(6)) if len(rate) > 3 else 0.0


def bent(values: Array) -> float:
    """The range of values about their line."""
    x = np.arange(len(values)) - (len(values) - 1) / 2
    return float(np.ptp(values - x * float(x @ values) / float(x @ x)))
