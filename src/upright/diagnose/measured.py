"""What was measured of a fall: what topples the robot, how its motors were used, and what was demanded of it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from upright.diagnose.fault_fits import PushEstimate

SLOWLY = math.pi / 2
"""E-folds of falling that commands go one way at a time, from which a gain is not too high. A loop that holds a robot
whose pole is λ crosses over at 2 λ or more, and one of too high a gain swings faster than that: π/(2 λ) each way."""


@dataclass(frozen=True)
class Toppling:
    """What fells the robot: the lean [rad] that each N s of a push is worth (`per_impulse`), and each N s m of its
    height (`per_height`), the `largest` lean [rad] that the motors bring back, and the `pole` [1/s] of falling."""

    per_impulse: float
    per_height: float
    largest: float
    pole: float

    def lean(self, push: PushEstimate) -> float:
        """The lean [rad] that a push gives the robot."""
        return (self.per_impulse + push.height * self.per_height) * push.impulse

    def largest_like(self, push: PushEstimate) -> float:
        """The impulse [N s] of the largest push at the same height that the motors bring back."""
        return self.largest / abs(self.per_impulse + push.height * self.per_height)

    def beyond(self, push: PushEstimate) -> float:
        """The push over the largest that the motors bring back [1]. They act while it lasts, so that a force counts
        the less the later it comes: by exp(−λt)."""
        grown = max(self.pole * (push.stop - push.start), 1e-6)
        return abs(self.lean(push)) / self.largest * -math.expm1(-grown) / grown


@dataclass(frozen=True, kw_only=True)
class MotorUse:
    """How the motors were used before the fall: fraction of the last excursion at the limit (`saturated`) and of the
    last second (`pegged`), whether no command changed (`stuck`) or from when to when one was `held` short of the limit
    [s], changes of the command's sign a second (`swings`), and the median of what they gave over what would have
    stopped the fall, where they had more (`help`). Last the largest rate of a wheel while the robot was `UPRIGHT`, over
    that at which full commands give no torque (`speed`), and how many e-folds of falling the commands went one way at a
    time in the last swings (`half_swing`, NaN without swings)."""

    saturated: float
    pegged: float
    stuck: bool
    held: tuple[float, float] | None
    swings: float
    help: float
    speed: float = 0.0
    half_swing: float = math.nan


@dataclass(frozen=True)
class Demand:
    """The largest sudden change of the reference speed, `jump` [m/s] `at` a time [s], the motors' `top_speed`, and the
    `fastest` reference in twice the last excursion."""

    jump: float
    at: float
    top_speed: float
    fastest: float
