"""The twin round a virtual brick or hub: held until its motors are first switched on, then moved by their duties.

A stand-in, never the robot. Its dead time is that of the program, not the kit's figure for it.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

from upright.bodies import equipped
from upright.compiled.counter import FOR_HAND, FOR_STILL, KINDS, Normals, whole
from upright.experiment.pushes import PushProgramme, combined
from upright.firmware.targets import BATTERY, COMPASS, GYRO, OFFSET, find_target
from upright.robots import Kit, Robot

HELD = (math.radians(2.0), math.radians(3.0))
"""[rad] by which a hand holds a robot off the vertical when it lets go: between these, to either side."""


class World:
    """`robot` in the electronics of `kit`, with the sensors and motors of a `target`; `pushes` are timed from its
    release. It is let go off the vertical (`HELD`), encoders at zero, so that nobody stands who does not balance. Once
    `fallen` it stays where it lies, and its motors turn freely."""

    def __init__(
        self,
        target: str,
        robot: Robot,
        kit: Kit,
        pushes: Sequence[PushProgramme] = (),
        *,
        seed: int = 1,
    ) -> None:
        parts = replace(kit, delay=0.0, jitter=0.0, motor=replace(kit.motor, quantum=0.0))
        self._plant = equipped("twin", robot, parts)
        known = find_target(target)
        self._raw = {channel: known.sensor(channel, kit) for channel in kit.sensors if channel in known.raw}
        self._raw |= {BATTERY: known.sensor(BATTERY, kit)}
        self._pushes = pushes
        self._robot = robot
        self._kit = kit
        self._noise = Normals(FOR_STILL, KINDS.index(GYRO), seed)
        self._looks = 0
        self.period = self._plant.spec.period
        self._names = [signal.name for signal in self._plant.spec.channels]
        side = 2 * whole(1, FOR_HAND, 2, seed) - 1
        low, high = HELD
        lean = side * (low + (high - low) * whole(0, FOR_HAND, 1024, seed) / 1024)  # in steps finer than any hand's
        self._now = self._plant.reset((lean, 0.0, lean, 0.0, 0.0, 0.0), seed)
        self.released = self.fallen = False

    @property
    def yaw(self) -> float:
        """The true heading [rad]."""
        return self._now.numbers[self._names.index("truth/yaw")]

    def step(self, duties: Sequence[float], driven: bool) -> None:
        """One period under both `duties` [%]; `driven` lets the robot go for good."""
        self.released = self.released or driven
        if self.released and not self.fallen:
            volts = self._kit.battery.volts([duty / 100 for duty in duties])
            self._now = self._plant.step(volts, combined(self._pushes, self._now.t, self._robot))
            self.fallen = self._now.fallen

    def raw(self) -> dict[str, float]:
        """What each sensor reads now, by channel, in the target's raw units; the gyro with its offset."""
        channels = dict(zip(self._names, self._now.numbers, strict=True))
        battery = self._kit.battery.voltage
        if not self.released:
            noise = self._kit.sensors[GYRO].noise * self._noise.at(self._looks)
            self._looks += 1
            channels = dict.fromkeys(channels, 0.0) | {GYRO: noise, BATTERY: battery}
        return {channel: self._read(channel, channels.get(channel, battery)) for channel in self._raw}

    def _read(self, channel: str, value: float) -> float:
        raw = self._raw[channel]
        reading = value / raw.scale
        if channel == COMPASS:  # counts clockwise
            return float(-round(reading) % 360)
        if channel == GYRO:
            reading += round(OFFSET / raw.scale) if raw.whole else OFFSET / raw.scale
        return float(round(reading)) if raw.whole else reading

    def close(self) -> None:
        self._plant.close()
