"""What bodies of hardware share: a robot that this computer commands, tick by tick, over a slow line."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from upright.bodies.body import BodySpec, Sample, checked, sample
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


def remote_spec(kind: str, robot: Robot, period: float, most: float, real: bool) -> BodySpec:
    """The spec of a robot whose duties are sent from here: no truth, no state to be put into, no push by a number.

    `most` is the highest voltage of its battery [V]. Raises `SpecMismatch` for a robot that is not driven by voltage.
    """
    if robot.command_unit != "V":
        raise SpecMismatch(f"'{robot.name}' is commanded in {robot.command_unit}", expected=f"V, as a {kind} drives")
    return BodySpec(
        kind=kind, robot=robot, channels=CHANNELS, period=period, limit=most, real=real, settable=False, pushable=False
    )


def at_rest(start: Sequence[float], kind: str) -> None:
    """Refuse to put hardware into a state."""
    if any(checked(start, 6, "start")):
        raise SpecMismatch(f"a {kind} cannot be put into a state", expected="no start", hint="hold it so by hand")


def unpushed(disturbance: Disturbance, kind: str) -> None:
    """Refuse to push hardware by a number."""
    if tuple(disturbance) != tuple(CALM):
        raise SpecMismatch(f"a {kind} cannot be pushed by a number", expected="no push", hint="push it by hand")


def duty(volts: float, battery: float) -> int:
    """The duty [%] that is nearest to a command at the battery's voltage [V]."""
    return max(-100, min(100, round(100 * volts / battery))) if battery > 0 else 0


def as_sample(t: float, reading: Reading, offset: float, duties: Sequence[float]) -> Sample:
    """A sample in SI units of what was read at `t` [s], with the gyro's `offset` [deg/s] taken off. Nothing here knows
    whether the robot has fallen."""
    rates = (reading.left * DEGREE, reading.right * DEGREE, (reading.gyro - offset) * DEGREE, reading.battery)
    return sample(t, rates, [d / 100 * reading.battery for d in duties], False)
