"""What the parts of the balancing program share: its limits, its status, and what it is made for."""

from __future__ import annotations

import math
from dataclasses import dataclass

from upright.control.linear_controller import LinearController
from upright.firmware.incremental import Incremental
from upright.firmware.targets import COMPASS, ENCODERS, Driver, Raw, Target
from upright.robots import Kit

BALANCING, FALLEN, STUCK, TOO_FAR, FLAT_BATTERY, TIME_IS_OVER, SENSOR_FAILED = range(7)
STATUS = (
    "balancing", "fallen", "motors at their limit", "too far away", "battery too low", "time is over",
    "a sensor failed",
)  # fmt: skip
"""Meanings of the program's `status`; all but the first stop the motors. The loop sets `TIME_IS_OVER`."""

STUCK_TIME = 1.0  # [s] both motors at full duty, as when the robot lies or a wheel is held
CALIBRATION_TIME = 1.0  # [s] over which the gyro's offset is averaged
UNPROVEN = 1e6  # limit of a memory that grows without its robot, far beyond any in balance
FASTEST = 100.0  # [rad/s] of a wheel or a heading, several times what any motor here reaches
TRAVEL = 1000.0  # [rad] of a wheel, the largest that the program follows
GYRO_MARGIN = 1.5  # largest raw reading over the gyro's range: room for the offset
TILT_TIME = 5.0  # [s] in which a pitch from the gyro alone forgets its drift
SPOKEN = 2.0  # limit of a command before the driver, over the motors' own
LEAST_SCATTER = 0.002  # [rad/s] of a gyro without stated noise
HEADING = 1000.0  # [rad] of turning that a compass is followed for
UPSIDE_DOWN = 3.2  # [rad] limit of an estimated pitch

POSITIONS = (*ENCODERS, COMPASS)
STATE_UNITS = ("rad", "rad/s", "rad", "rad/s", "rad", "rad/s")
REFERENCE_RANGE = (0.5, 5.0, 1000.0, 40.0, 1000.0, 20.0)  # in those units


@dataclass(frozen=True)
class ProgramSetup:
    """The common data of the trace's steps."""

    incremental: Incremental
    kit: Kit
    driver: Driver
    target: Target
    travel: float
    reference: bool

    @property
    def linear(self) -> LinearController:
        """The controller's matrices."""
        return self.incremental.linear

    @property
    def strongest(self) -> float:
        """The largest command that can be applied."""
        return min(self.driver.limit, self.driver.highest if self.driver.full else math.inf)

    @property
    def typed(self) -> float:
        """Limit of the command before the driver's."""
        return SPOKEN * self.strongest

    def raw(self, channel: str) -> Raw:
        """How the target gives that channel."""
        return self.target.sensor(channel, self.kit)

    @property
    def lag(self) -> int:
        """After how many whole periods a command reaches the motors."""
        return math.floor((self.kit.delay + self.kit.jitter / 2) / self.linear.period + 1e-9)

    def periods(self, time: float) -> int:
        """How many periods that time [s] takes."""
        return max(1, round(time / self.linear.period))
