"""The twin round a virtual brick: what the motors do moves it, and its sensors are what the ports read.

A stand-in, never the robot. Its dead time is that of the brick's own instructions, not the kit's figure for it.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace

import numpy as np

from upright.bodies import Electronics, make_body
from upright.experiment.pushes import PushProgramme, combined
from upright.firmware.brick import Hardware
from upright.firmware.execute_nxc import GYRO, LEFT, REST, RIGHT
from upright.firmware.lcp import VirtualBrick
from upright.firmware.line import Line
from upright.firmware.parity import Readings
from upright.firmware.program import Program
from upright.firmware.targets import BATTERY
from upright.robots import Kit, Robot

COST = (
    5  # [µs] an instruction: an LQG's four to five hundred then take the 2 ms that the kit allows for computing (guess)
)


class VirtualRobot:
    """The world of `hardware` (`hardware.world`): held upright until a motor is first switched on, then let go.

    `pushes` count from then on. `fallen` says whether it lies; then it stays there and its motors turn freely.
    """

    def __init__(
        self,
        hardware: Hardware,
        program: Program,
        robot: Robot,
        kit: Kit,
        pushes: Sequence[PushProgramme] = (),
        *,
        body: str = "twin",
        seed: int = 1,
    ) -> None:
        parts = replace(kit, delay=0.0, jitter=0.0, motor=replace(kit.motor, quantum=0.0))
        self._plant = Electronics(make_body(body, robot), parts)
        self._hardware, self._readings = hardware, Readings(program, kit)
        self._pushes, self._robot, self._kit = pushes, robot, kit
        self._rng = np.random.Generator(np.random.Philox(seed))
        self._period = round(self._plant.spec.period * 1e6)
        self._names = [signal.name for signal in self._plant.spec.channels]
        self._now = self._plant.reset(seed=seed)
        self._next, self.released, self.fallen = 0, False, False
        self._feel()
        hardware.world = self.reach

    @property
    def pitch(self) -> float:
        """The true pitch [rad]."""
        return float(self._now.values[self._names.index("truth/pitch")])

    def reach(self, time: int) -> None:
        """Bring the twin to `time` [µs]."""
        while self._next <= time:
            self._next += self._period
            self.released = self.released or any(motor.mode for motor in self._hardware.motors)
            if self.released and not self.fallen:
                self._now = self._plant.step(self._volts(), combined(self._pushes, self._now.t, self._robot))
                self.fallen = self._now.fallen
            self._feel()

    def _feel(self) -> None:
        channels = dict(zip(self._names, self._now.values.tolist(), strict=True))
        if not self.released:
            noise = self._kit.sensors["sensor/gyro"].noise * float(self._rng.standard_normal())
            channels = dict.fromkeys(channels, 0.0) | {"sensor/gyro": noise, BATTERY: self._kit.battery.voltage}
        raw = self._readings.raw(channels, self._readings.offset)
        hardware = self._hardware
        hardware.inputs[GYRO].raw = REST + round(raw["raw_gyro"])
        hardware.battery = round(raw["raw_battery"])
        for port, side in ((LEFT, "left"), (RIGHT, "right")):
            hardware.motors[port].count = round(raw[f"raw_encoder_{side}"])

    def _volts(self) -> tuple[float, float]:
        """Each duty times the battery's voltage under both."""
        left, right = (self._hardware.motors[port].duty / 100 for port in (LEFT, RIGHT))
        battery = self._kit.battery
        voltage = battery.voltage / (1 + battery.sag * (abs(left) + abs(right)))
        return left * voltage, right * voltage

    def close(self) -> None:
        self._plant.close()


@dataclass(frozen=True)
class VirtualFlight:
    """A virtual brick on a line: the `path` that a program opens, the brick, the robot round it, its clock [s]."""

    line: Line
    brick: VirtualBrick
    robot: VirtualRobot

    @property
    def path(self) -> str:
        return self.line.path

    def clock(self) -> float:
        return self.brick.seconds


@contextmanager
def virtual_flight(
    program: Program, robot: Robot, kit: Kit, pushes: Sequence[PushProgramme] = (), *, body: str = "twin", seed: int = 1
) -> Generator[VirtualFlight]:
    """A brick with the twin round it, for as long as the block lasts; its time runs as fast as it can."""
    brick = VirtualBrick(cost=COST)
    around = VirtualRobot(brick.hardware, program, robot, kit, pushes, body=body, seed=seed)
    with Line(brick) as line:
        yield VirtualFlight(line, brick, around)
    around.close()
