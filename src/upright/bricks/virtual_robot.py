"""Virtual robots: a brick or a hub with the twin round it."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from upright.bricks.brick import WIRED, Hardware, set_readings
from upright.bricks.hub import VirtualHub
from upright.bricks.lcp import VirtualBrick
from upright.bricks.line import Line
from upright.bricks.world import World
from upright.experiment.pushes import PushProgramme
from upright.links.brick import Wiring
from upright.robots import Kit, Robot

COST = 8
"""[µs] of an instruction: 10 000 turns of a loop in NXC took 0.806 s on a brick with firmware 1.28 (robootika.com, "NXT
kiiruse testimine", 2011), and nbc makes ten instructions of an empty one. Arithmetic on floats takes longer."""


class VirtualRobot:
    """The `world` of `hardware` (`hardware.world`), brought to the brick's time whenever the brick looks at it."""

    def __init__(self, hardware: Hardware, world: World, wiring: Wiring = WIRED) -> None:
        self.world = world
        self._hardware = hardware
        self._wiring = wiring
        self._period = round(world.period * 1e6)
        self._next = 0
        set_readings(hardware, world.raw(), wiring)
        hardware.world = self.reach

    def reach(self, time: int) -> None:
        """Bring the twin to `time` [µs]."""
        motors = self._hardware.motors
        while self._next <= time:
            self._next += self._period
            duties = (motors[self._wiring.left].duty, motors[self._wiring.right].duty)
            self.world.step(duties, any(motor.mode for motor in motors))
            set_readings(self._hardware, self.world.raw(), self._wiring)
            self._hardware.tick(self._period // 1000)

    def wait(self, seconds: float) -> None:
        """Let that time [s] pass while the brick runs no program."""
        self.reach(self._next - self._period + round(seconds * 1e6))


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
    robot: Robot,
    kit: Kit,
    pushes: Sequence[PushProgramme] = (),
    *,
    seed: int = 1,
    wiring: Wiring = WIRED,
) -> Generator[VirtualFlight]:
    """A brick with the twin round it, wired so, for as long as the block lasts; its time runs as fast as it can."""
    brick = VirtualBrick(cost=COST)
    world = World("nxc", robot, kit, pushes, seed=seed)
    around = VirtualRobot(brick.hardware, world, wiring)
    with Line(brick) as line:
        yield VirtualFlight(line, brick, around)
    world.close()


@contextmanager
def virtual_hub(
    robot: Robot,
    kit: Kit,
    pushes: Sequence[PushProgramme] = (),
    *,
    seed: int = 1,
    **line: Any,
) -> Generator[VirtualHub]:
    """A hub with the twin round it, for as long as the block lasts; its `line` is as `VirtualHub` has it."""
    hub = VirtualHub(World("pybricks", robot, kit, pushes, seed=seed), **line)
    try:
        yield hub
    finally:
        hub.close()
