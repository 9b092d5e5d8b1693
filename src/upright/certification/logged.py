"""What a log shows of a robot that was not assumed: the certificate then tries the robot that the log shows."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
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
