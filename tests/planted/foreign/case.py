"""What both foreign simulators give."""

from __future__ import annotations

import math
from dataclasses import dataclass

from upright.logs.readers import RawTable
from upright.robots import Robot
from upright.signals import Log


@dataclass(frozen=True, eq=False)
class Case:
    """A log of a robot that is not ours, the file that its owner would write, and the truth: its numbers by the names
    of a calibration; the cause of a fall, how bad it was, its onset and when the robot leaned by 0.7 rad [s]."""

    log: RawTable | Log
    file: Robot
    truth: dict[str, float]
    cause: str = ""
    size: float = 0.0
    onset: float = 0.0
    fell_at: float = math.inf
    side: int = 2
