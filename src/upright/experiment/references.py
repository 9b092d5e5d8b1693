"""What the robot is asked to do: drive, turn, stand still."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Protocol

import numpy as np

from upright.arrays import Array
from upright.errors import InvalidScenario
from upright.robots import Robot


class Reference(Protocol):
    """A reference state in time: `at(t, robot)` gives six numbers, zero for standing where it started."""

    def at(self, t: float, robot: Robot) -> Array: ...


def _check(reference: Any) -> None:
    for name, value in vars(reference).items():
        if not math.isfinite(value) and name != "until":
            raise InvalidScenario(f"{type(reference).__name__}: {name} is {value}", expected="a finite number")
    if not reference.until > reference.start:
        raise InvalidScenario(
            f"{type(reference).__name__} from {reference.start:g} to {reference.until:g} s",
            expected="an end after its start",
        )


@dataclass(frozen=True, kw_only=True)
class Drive:
    """Roll at `speed` [m/s], forward positive, from `start` until `until` [s], then stop there."""

    speed: float
    start: float = 0.0
    until: float = math.inf

    __post_init__ = _check

    def at(self, t: float, robot: Robot) -> Array:
        rate = self.speed / robot.wheel_radius
        angle, now = _ramp(t, self.start, self.until, rate)
        return np.array([0.0, 0.0, angle, now, 0.0, 0.0])


@dataclass(frozen=True, kw_only=True)
class Turn:
    """Turn at `rate` [rad/s], anticlockwise positive, from `start` until `until` [s], then keep the heading."""

    rate: float
    start: float = 0.0
    until: float = math.inf

    __post_init__ = _check

    def at(self, t: float, robot: Robot) -> Array:  # noqa: ARG002 (a turn is the same for every robot)
        angle, now = _ramp(t, self.start, self.until, self.rate)
        return np.array([0.0, 0.0, 0.0, 0.0, angle, now])


def total(references: Sequence[Reference], t: float, robot: Robot) -> Array:
    """The sum of all references: driving and turning at once is an arc."""
    return sum((reference.at(t, robot) for reference in references), np.zeros(6))


def _ramp(t: float, start: float, until: float, rate: float) -> tuple[float, float]:
    inside = start <= t < until
    return rate * (min(max(t, start), until) - start), rate if inside else 0.0
