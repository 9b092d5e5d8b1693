"""What is assumed of a robot before its log is read, and what the log shows of it instead."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field, replace
from types import SimpleNamespace
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.kernel.batch import NAMES
from upright.physics.dynamics import motor_gain
from upright.robots import Kit, Robot
from upright.signals import Log

LOADED = ("body_mass", "pitch_inertia", "roll_inertia", "yaw_inertia")  # what goes with the mass of a body
NOISED = "sensors.gyro.noise"
BATTERIES = {"low": 0.85, "full": 1.12}
"""Over the kit's voltage: six AA cells under load give 7 to 9 V for 8, two lithium cells 6.4 to 8.4 V for 7.5. The
robot's file may state others (`Robot.conditions`)."""


def as_sent(log: Log) -> Log:
    """The log without what reached the motors, where it holds what was sent: what lies between is to be examined."""
    if not all(f"command/{side}" in log for side in ("left", "right")):
        return log
    kept = {name: values for name, values in log.channels.items() if not name.startswith("applied/")}
    return Log(log.t, kept, {name: log.units[name] for name in kept}, log.origin)


@dataclass(frozen=True, eq=False, kw_only=True)
class Logged:
    """The `kit` as the log shows it, and its numbers `changes` that are drawn for each robot (n,) by dotted name.

    `load` is the body's mass over the assumed one, as estimated, and `loads` (n,) what is drawn. `batteries` [V] and
    `slopes` [rad] lie outside those expected, and are tried besides, times the `tilts` (n,) that are drawn.
    """

    kit: Kit
    load: float
    loads: Array
    changes: Mapping[str, Array]
    batteries: tuple[float, ...] = ()
    slopes: tuple[float, ...] = ()
    tilts: Array = field(default_factory=lambda: np.ones(1))

    @classmethod
    def alone(cls, kit: Kit) -> Logged:
        """Another kit, and nothing else."""
        return cls(kit=kit, load=1.0, loads=np.ones(1), changes={})

    def drawn(self, count: int) -> dict[str, Array]:
        """The changes of `count` robots; more robots than were drawn for begin again."""
        return {name: rows(values, count) for name, values in self.changes.items()}

    def weighed(self, parameters: Array) -> Array:
        """The parameters (n, 25) of robots with the drawn loads."""
        result = parameters.copy()
        columns = [NAMES.index(name) for name in LOADED]
        result[:, columns] *= rows(self.loads, len(parameters))[:, None]
        return result

    def angles(self, slope: float, parameters: Array, nominal: Robot) -> Array:
        """The slope [rad] on which each of the robots with `parameters` (n, 25) stands. One that the log shows is of
        what the motors of the `nominal` robot bore at rest: stronger motors, smaller wheels or less mass bore it on a
        steeper one."""
        if slope not in self.slopes:
            return np.full(len(parameters), slope)
        own = steepness(SimpleNamespace(**dict(zip(NAMES, parameters.T, strict=True))))
        return np.arcsin(np.sin(slope * rows(self.tilts, len(parameters))) * own / steepness(nominal))


@dataclass(frozen=True, eq=False)
class Assumptions:
    """A robot, the `robots` that it may be as well, their kit, and a seed: what a log is compared with.

    What the log shows instead is `logged`. The filter that follows the log expects `disturbed` times the usual noise of
    forces and torques. It asks no mass where that `is_weighed`, and neither mass nor the motors' strength of a robot
    with `dry_friction`, for which it would take that. The slope of its `floor`, with its interval [rad], is of
    a calibration (None: not known)."""

    robot: Robot
    robots: Sequence[Robot]
    kit: Kit
    seed: int = 0
    _: KW_ONLY
    logged: Logged | None = None
    disturbed: float = 1.0
    dry_friction: bool = False
    is_weighed: bool = False
    floor: tuple[float, float, float] | None = None

    @property
    def actual_kit(self) -> Kit:
        """The kit as the log shows it, or as assumed."""
        return self.logged.kit if self.logged else self.kit

    @property
    def actual_robot(self) -> Robot:
        """The nominal robot as the log shows it, or as assumed."""
        return self.actual(self.robot)

    def actual(self, robot: Robot) -> Robot:
        """A robot with the load that the log shows."""
        return loaded(robot, self.logged.load) if self.logged else robot


def batteries(robot: Robot, kit: Kit) -> tuple[float, float] | None:
    """The lowest and the highest voltage [V] that are expected: those of the robot's file, else `BATTERIES` of the
    kit's; None for a torque drive, which has no battery in its equations, or a kit without one."""
    if robot.command_unit != "V" or not math.isfinite(kit.battery.voltage):
        return None
    low, full = (fraction * kit.battery.voltage for fraction in BATTERIES.values())
    return robot.conditions.battery or (low, full)


def steepness(p: Any) -> Any:
    """The sine of the slope on which a robot rests by one unit of command, but for a factor of all robots."""
    return motor_gain(p) / (p.wheel_radius * p.gravity * (p.body_mass + 2 * p.wheel_mass))


def delaying(kit: Kit, more: float) -> Kit:
    """The kit whose readings all come so much later [s]. To the loop that is further dead time that no controller knows
    of: of commands that arrive later a simulated one would be told, and a program is not."""
    sensors = {name: replace(sensor, delay=max(sensor.delay + more, 0.0)) for name, sensor in kit.sensors.items()}
    return replace(kit, sensors=sensors)


def rows(values: Array, count: int) -> Array:
    """`count` of the values (n,), from the beginning again where they end."""
    return np.resize(values, count)


def loaded(robot: Robot, factor: float) -> Robot:
    """The robot with a body `factor` times as heavy, and of the same shape."""
    return robot.replace(**{name: factor * getattr(robot, name) for name in LOADED}) if factor != 1 else robot
