"""What is done to the robot: pushes, holds and slopes, as functions of time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from upright.errors import InvalidScenario
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Robot


class PushProgramme(Protocol):
    """A disturbance in time: `at(t, robot)` is what acts on the robot from t [s] on, until asked again."""

    def at(self, t: float, robot: Robot) -> Disturbance: ...


def _check(push: object) -> None:
    for name, value in vars(push).items():
        if value is None:
            continue
        if not math.isfinite(value):
            raise InvalidScenario(f"{type(push).__name__}: {name} is {value}", expected="a finite number")
        if name == "duration" and value <= 0:
            raise InvalidScenario(f"{type(push).__name__}: {name} is {value:g}", expected="more than zero")


@dataclass(frozen=True, kw_only=True)
class Push:
    """A horizontal `force` [N], forward positive, from `start` for `duration` [s], at `height` [m] above the axle
    (None: at the centre of mass)."""

    force: float
    start: float = 1.0
    duration: float = 0.1
    height: float | None = None

    __post_init__ = _check

    def at(self, t: float, robot: Robot) -> Disturbance:
        return _acting(self, t, robot, self.force, self.duration)


@dataclass(frozen=True, kw_only=True)
class Impulse:
    """A short push of `impulse` [N s] from `start` [s] on, spread evenly over `duration` [s]."""

    impulse: float
    start: float = 1.0
    duration: float = 0.01
    height: float | None = None

    __post_init__ = _check

    def at(self, t: float, robot: Robot) -> Disturbance:
        return _acting(self, t, robot, self.impulse / self.duration, self.duration)


@dataclass(frozen=True, kw_only=True)
class Hold:
    """The constant force that keeps a robot at rest at `pitch` [rad], from `start` until `until` [s], then released.

    From statics (docs/conventions.md): the floor takes F and the motors the moment, M g L sin ψ = −F (h cos ψ + R).
    A hold of +0.1 rad is thus a force on the front, backwards.
    """

    pitch: float
    until: float
    start: float = 0.0
    height: float | None = None

    def __post_init__(self) -> None:
        _check(self)
        if self.until <= self.start:
            raise InvalidScenario(f"a hold from {self.start:g} to {self.until:g} s", expected="an end after its start")
        if abs(self.pitch) >= math.pi / 2:
            raise InvalidScenario(
                f"a hold at {self.pitch:g} rad", expected="less than π/2", likely="degrees for radians"
            )

    def force(self, robot: Robot) -> float:
        """F [N] that holds this robot at `pitch`."""
        weight = robot.body_mass * robot.gravity * robot.com_height
        lever = _height(self.height, robot) * math.cos(self.pitch) + robot.wheel_radius
        return -weight * math.sin(self.pitch) / lever

    def at(self, t: float, robot: Robot) -> Disturbance:
        return _acting(self, t, robot, self.force(robot), self.until - self.start)


@dataclass(frozen=True, kw_only=True)
class Slope:
    """A floor that climbs along the world's x axis by `angle` [rad] from `start` [s] on."""

    angle: float
    start: float = 0.0

    def __post_init__(self) -> None:
        _check(self)
        if abs(self.angle) >= math.pi / 4:
            raise InvalidScenario(
                f"a slope of {self.angle:g} rad", expected="less than π/4", likely="degrees for radians"
            )

    def at(self, t: float, robot: Robot) -> Disturbance:  # noqa: ARG002 (a floor is the same for every robot)
        return Disturbance(slope=self.angle if t >= self.start - _SAME_TIME else 0.0)


_SAME_TIME = 1e-9  # [s] time is counted in periods, so that equal times may differ by rounding


def combined(pushes: Sequence[PushProgramme], t: float, robot: Robot) -> Disturbance:
    """All pushes together: forces add, and act at the height that gives the same moment; slopes add."""
    force = moment = slope = 0.0
    for push in pushes:
        part = push.at(t, robot)
        force = force + part.force
        moment = moment + part.force * part.height
        slope = slope + part.slope
    return Disturbance(force, moment / force if force else 0.0, slope) if force or slope else CALM


def _acting(push: Push | Impulse | Hold, t: float, robot: Robot, force: float, duration: float) -> Disturbance:
    on = push.start - _SAME_TIME <= t < push.start + duration - _SAME_TIME
    return Disturbance(force if on else 0.0, _height(push.height, robot))


def _height(height: float | None, robot: Robot) -> float:
    return robot.com_height if height is None else height
