"""The motion of a robot's body, with its wheels or without."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from upright.checkup.finding import LEFT, PITCH, RIGHT, Record
from upright.checkup.physics import Resampled, resampled


def bodily(record: Record) -> Resampled | None:
    """`resampled`; where a log has a tilt estimate and not both encoders, without wheels, since the body alone tells
    most poses."""
    if PITCH not in record or {LEFT, RIGHT} <= record.channels.keys():
        return resampled(record)
    m = resampled(record.changed(dict.fromkeys((LEFT, RIGHT), np.zeros(len(record.t)))))
    return replace(m, wheels=False) if m else None
