"""What the parts of the balancing program share: its limits, its status, and what it is made for."""

from __future__ import annotations

import math
from dataclasses import dataclass

from upright.control.linear_controller import LinearController
from upright.firmware.incremental import Incremental
from upright.firmware.targets import COMPASS, ENCODERS, Driver, Raw, Target
from upright.robots import Kit

BALANCING, FALLEN, STUCK, TOO_FAR, FLAT_BATTERY, TIME_IS_OVER = range(6)
STATUS = ("balancing", "fallen", "motors at their limit", "too far away", "battery too low", "time is over")
"""What the program's `status` says; anything but zero stops the motors. The last is the loop's own."""

FALL_PITCH = 0.8  # [rad] from which no robot here has the torque to come back
STUCK_TIME = 1.0  # [s] both motors at full duty, as when the robot lies or a wheel is held
CALIBRATION_TIME = 1.0  # [s] over which the gyro's offset is averaged
UNPROVEN = 1e6  # that a memory is kept within which grows without its robot: nothing that balances comes near
FASTEST = 100.0  # [rad/s] of a wheel or a heading, several times what any motor here reaches
TRAVEL = 1000.0  # [rad] of a wheel, the largest that the program follows
GYRO_MARGIN = 1.5  # raw readings may exceed the range by the offset that is taken off them
TILT_TIME = 5.0  # [s] in which a pitch from the gyro alone forgets its drift
SPOKEN = 2.0  # commands beyond twice what the motors take say no more than that
LEAST_SCATTER = 0.002  # [rad/s] of a gyro without stated noise
HEADING = 1000.0  # [rad] of turning that a compass is followed for
UPSIDE_DOWN = 3.2  # [rad] no opinion of a pitch is worth more

POSITIONS = (*ENCODERS, COMPASS)
SIDES = ("left", "right")
STATE_UNITS = ("rad", "rad/s", "rad", "rad/s", "rad", "rad/s")
REFERENCE_RANGE = (0.5, 5.0, 1000.0, 40.0, 1000.0, 20.0)  # in those units


@dataclass(frozen=True)
class Setup:
    """What the steps of the trace share."""

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
        """What the command is kept within before the driver limits it."""
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
