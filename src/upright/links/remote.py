"""What bodies of hardware share: a robot that this computer commands, tick by tick, over a slow line."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from upright.bodies.body import REST, BodySpec, Sample, checked, sample
from upright.errors import SpecMismatch
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Robot
from upright.signals.signal import KNOWN

CHANNELS = tuple(KNOWN[f"sensor/{name}"] for name in ("encoder_left", "encoder_right", "gyro", "battery"))
DEGREE = math.pi / 180
STILL = 20  # readings that the gyro's offset is averaged over


@dataclass(frozen=True)
class Reading:
    """What a robot reports of a tick: encoders [deg], gyro [deg/s], battery [V]."""

    left: float
    right: float
    gyro: float
    battery: float


class RemoteBody:
    """A robot whose duties are sent from here: no truth, no state to be put into, no push by a number; `most` is the
    highest voltage of its battery [V]. A kind of link says how it is begun and asked.

    Raises `SpecMismatch` for a robot that is not driven by voltage.
    """

    def __init__(self, kind: str, robot: Robot, period: float, most: float, real: bool) -> None:
        if robot.command_unit != "V":
            raise SpecMismatch(
                f"'{robot.name}' is commanded in {robot.command_unit}", expected=f"V, as a {kind} drives"
            )
        self.spec = BodySpec(
            kind=kind, robot=robot, channels=CHANNELS, period=period, limit=most, real=real, settable=False,
            pushable=False,
        )  # fmt: skip
        self.overruns = 0
        self._offset = 0.0
        self._battery = 0.0

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:  # noqa: ARG002 (hardware makes its own noise)
        kind = self.spec.kind
        if any(checked(start, 6, "start")):
            raise SpecMismatch(f"a {kind} cannot be put into a state", expected="no start", hint="hold it so by hand")
        still = self._begin()
        self.overruns = 0
        self._offset = sum(reading.gyro for reading in still) / len(still)
        return self._sample(0.0, still[-1], (0, 0))

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        duties = [duty(volts, self._battery) for volts in checked(command, 2, "command")]
        if tuple(disturbance) != tuple(CALM):
            raise SpecMismatch(
                f"a {self.spec.kind} cannot be pushed by a number", expected="no push", hint="push it by hand"
            )
        return self._sample(*self._exchange(duties))

    def _begin(self) -> Sequence[Reading]:
        """Connected, with the motors off and the clock at zero: `STILL` readings of a robot at rest."""
        raise NotImplementedError

    def _exchange(self, duties: Sequence[int]) -> tuple[float, Reading, Sequence[int]]:
        """A period under these duties [%]: the time since the start [s], a reading, and the duties it was taken
        under."""
        raise NotImplementedError

    def _sample(self, t: float, reading: Reading, duties: Sequence[int]) -> Sample:
        """In SI units, with the gyro's offset taken off. Nothing here knows whether the robot has fallen."""
        self._battery = reading.battery
        angles = (reading.left * DEGREE, reading.right * DEGREE)
        values = (*angles, (reading.gyro - self._offset) * DEGREE, reading.battery)
        return sample(t, values, [d / 100 * reading.battery for d in duties], False)


def duty(volts: float, battery: float) -> int:
    """The duty [%] that is nearest to a command at the battery's voltage [V]."""
    return max(-100, min(100, round(100 * volts / battery))) if battery > 0 else 0
