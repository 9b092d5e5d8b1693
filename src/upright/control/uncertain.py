"""What is not known of a robot, and robots drawn from it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from upright.errors import DesignFailed, InvalidRobot, UnknownName
from upright.robots import PARAMETERS, Robot

Array = NDArray[np.float64]

GUESSED = 0.2
"""Relative standard deviation of a parameter that its preset calls a guess, or gives no source for."""

COUNTED = ("gear_ratio",)
DRAWN = ("body_depth", "body_height", "stiction_rate")  # for pictures, or a choice: they move nothing

MAY_BE_ZERO = ("rotor_inertia", "back_emf", "motor_friction", "wheel_friction", "coulomb_friction")

FARTHEST = 2.0  # standard deviations: draws beyond are drawn again, as the ends of a robot's parameters are known


def spreads(robot: Robot, guessed: float = GUESSED) -> dict[str, float]:
    """One standard deviation of each uncertain parameter, in its own unit: the preset's, or `guessed` of its value.

    A parameter that is zero by a guess stays zero, since a share of it says nothing; a gear ratio that is a guess stays
    too, since its teeth can be counted.
    """
    found = {
        name: known.spread if known.spread is not None else guessed * abs(value) * (name not in COUNTED)
        for name, value in robot.numbers().items()
        if (known := robot.provenance.get(name)) and name not in DRAWN
    }
    return {name: size for name, size in found.items() if size > 0}


def draw(
    robot: Robot, count: int, seed: int = 0, sizes: Mapping[str, float] | None = None, covariance: Array | None = None
) -> list[Robot]:
    """`count` robots round `robot`: normal in the parameters named by `sizes` (None: the preset's `spreads`), cut at
    `FARTHEST` deviations, and correlated as `robot.correlation` says. `covariance` (n, n) in the order of `sizes`
    replaces their squares.

    What no robot can be (`InvalidRobot`) is drawn again. Raises `DesignFailed` where nearly nothing can be.
    """
    chosen = dict(spreads(robot) if sizes is None else sizes)
    for name in chosen:
        if name not in PARAMETERS:
            raise UnknownName("parameter", name, PARAMETERS)
    rng = np.random.Generator(np.random.Philox(seed))
    joint = _joint(robot, chosen) if sizes is None and robot.correlation else covariance
    root = np.diag(list(chosen.values())) if joint is None else _root(joint, len(chosen))
    centre = np.array([getattr(robot, name) for name in chosen])
    found: list[Robot] = []
    for _ in range(50 * count + 50):
        if len(found) == count:
            return found
        normal = rng.standard_normal(len(chosen))
        if np.abs(normal).max(initial=0.0) > FARTHEST:
            continue
        drawn = _made(robot, dict(zip(chosen, (centre + root @ normal).tolist(), strict=True)))
        found += [drawn] if drawn else []
    raise DesignFailed(
        f"of {50 * count} draws only {len(found)} are robots", expected="spreads well below the values",
        hint="name smaller spreads",
    )  # fmt: skip


def _joint(robot: Robot, sizes: Mapping[str, float]) -> Array:
    """The covariance of the parameters of `sizes` by the robot's own correlations."""
    place = {name: i for i, name in enumerate(sizes)}
    whole = np.eye(len(sizes))
    for (first, second), value in robot.correlation.items():
        if first in place and second in place:
            whole[place[first], place[second]] = whole[place[second], place[first]] = value
    deviations = np.array(list(sizes.values()))
    return whole * np.outer(deviations, deviations)


def _root(covariance: Array, size: int) -> Array:
    values, vectors = np.linalg.eigh(np.asarray(covariance, dtype=np.float64))
    if len(values) != size or values[0] < -1e-9 * max(values[-1], 0.0):
        raise DesignFailed("the covariance is not one", expected=f"a symmetric, non-negative ({size}, {size}) matrix")
    return vectors * np.sqrt(np.maximum(values, 0.0))


def _made(robot: Robot, changes: dict[str, float]) -> Robot | None:
    """The robot with these numbers, or None where it cannot be. A friction drawn below zero is none; a roll inertia
    that is not drawn follows the others as far as the triangle inequality asks."""
    numbers = {name: max(value, 0.0) if name in MAY_BE_ZERO else value for name, value in changes.items()}
    both = {"pitch_inertia": robot.pitch_inertia, "yaw_inertia": robot.yaw_inertia} | numbers
    pitch, yaw = both["pitch_inertia"], both["yaw_inertia"]
    if "roll_inertia" not in numbers:
        numbers["roll_inertia"] = min(max(robot.roll_inertia, abs(pitch - yaw)), pitch + yaw)
    try:
        return robot.replace(**numbers)
    except InvalidRobot:
        return None
