"""The contract of everything that answers a command: models, the twin, real bricks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, Protocol, runtime_checkable

import numpy as np

from upright.arrays import Array, read_only
from upright.errors import InvalidScenario, SpecMismatch
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Robot
from upright.signals import Signal

REST = (0.0,) * 6
FALLEN = 1.4
"""Pitch [rad] beyond which a robot has fallen: close to lying (π/2), beyond what any measured run recovers from."""


@dataclass(frozen=True, kw_only=True)
class BodySpec:
    """What a body is, known before anything is connected.

    `kind` says in words what it is ("nonlinear model", "twin", …); only a body of hardware has `real=True`.
    `channels` are the signals each sample holds, in order; `period` [s] is the time one `step` takes;
    `command_unit` is V, N m or rad/s; `limit` the largest command it takes (inf: no limit). A body that cannot
    be put into a state (`settable=False`) is reset where it stands; one that cannot be pushed by a number
    (`pushable=False`) is pushed by hand.
    """

    kind: str
    robot: Robot
    channels: tuple[Signal, ...]
    period: float
    command_unit: str = "V"
    limit: float = np.inf
    real: bool = False
    settable: bool = True
    pushable: bool = True


class Sample(NamedTuple):
    """What one step gives: time `t` [s], `numbers` in the order of the spec's channels, the command (left, right) that
    was really `applied` on the way here, whether the robot has `fallen`, and whether a motor of a speed drive has ever
    `slipped`: then a count of its steps is no angle of its wheel any more."""

    t: float
    numbers: tuple[float, ...]
    applied: tuple[float, float]
    fallen: bool = False
    slipped: bool = False

    @property
    def values(self) -> Array:
        """The numbers as a read-only array; most steps of a run need none."""
        return read_only(self.numbers)


@runtime_checkable
class Body(Protocol):
    """`reset(start, seed)` puts the robot at state `start` (six numbers) at t = 0 and returns the first sample;
    `step(command, disturbance)` holds the command [left, right] for one period and returns what came of it.
    A NaN in the command is refused with `SpecMismatch`. `close` frees what the body holds; it may be called twice.
    """

    @property
    def spec(self) -> BodySpec: ...

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample: ...

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample: ...

    def close(self) -> None: ...


def sample(t: float, values: Sequence[float], applied: Sequence[float], fallen: bool, slipped: bool = False) -> Sample:
    """A `Sample` of plain numbers."""
    return Sample(t, tuple(map(float, values)), (float(applied[0]), float(applied[1])), bool(fallen), slipped)


LARGEST_SUM = 1e12
"""Of the sizes in a command, and in a state that a run begins with: far beyond any robot, and far from overflow."""


def checked(values: Sequence[float], size: int, name: str) -> tuple[float, ...]:
    """`values` as floats, refused with `SpecMismatch` unless there are `size` of them and all are finite."""
    numbers = tuple(map(float, values))
    if len(numbers) != size or not sum(map(abs, numbers)) <= LARGEST_SUM:  # which no NaN is
        likely = "a controller that diverged" if name == "command" else ""
        expected = f"{size} finite numbers that come to {LARGEST_SUM:g} at most"
        raise SpecMismatch(f"{name} is {list(numbers)}", expected=expected, likely=likely)
    return numbers


def checked_period(period: float) -> float:
    """A body's period [s], refused with `InvalidScenario` unless it lies between 0 and 1 s."""
    if not (math.isfinite(period) and 0 < period <= 1):
        raise InvalidScenario(f"a body's period is {period} s", expected="between 0 and 1 s", likely="milliseconds")
    return float(period)
