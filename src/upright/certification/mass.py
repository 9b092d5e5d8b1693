"""A robot on a scale."""

from __future__ import annotations

import math

from upright.errors import InvalidRobot, InvalidScenario
from upright.likelihood.assumptions import LOADED, loaded
from upright.likelihood.support import LOAD
from upright.robots import Provenance, Robot
from upright.robots.uncertainty import deviations

SCALE = 0.01
"""One deviation of what a scale says: kitchen scales are right to a few grams, of robots of 0.3 to 3 kg."""

MOST = 10.0
"""Times what its file says, that a body weighs at most: more is another unit, or another robot."""

SHAPE = 0.5
"""One deviation of the inertia of what a body has lost or carries, over what it would be in the body's own shape."""


def on_the_scale(robot: Robot, weighed: float, *, logged: bool) -> Robot:
    """The robot whose body and wheels weigh `weighed` [kg] together. What the body weighs more or less than its file
    says is in the shape of the body, its inertias to `SHAPE` of their change.

    Raises `InvalidRobot` for less than the wheels weigh, and for a body of more than `MOST` times the file's. Without a
    log of the robot (`logged`), which shows where such a load sits, also where its mass differs by more than `LOAD`.
    """
    body = weighed - 2 * robot.wheel_mass
    if not (math.isfinite(weighed) and body > 0):
        raise InvalidRobot(f"a robot that weighs {weighed:g} kg", expected=f"more than {2 * robot.wheel_mass:g} kg, "
                           "which its wheels weigh")  # fmt: skip
    factor = body / robot.body_mass
    if factor > MOST:
        raise InvalidRobot(f"a body of {body:.3g} kg on the scale", expected=f"at most {MOST:g} times the "
                           f"{robot.body_mass:.3g} kg of its file", likely="grams")  # fmt: skip
    if abs(factor - 1) > LOAD and not logged:
        raise InvalidRobot(
            f"a body of {body:.3g} kg on the scale", expected=f"{robot.body_mass:.3g} kg ± {LOAD:.0%}, as in its file",
            hint="give a log of this robot; or write mass, centre and inertias into its file",
        )  # fmt: skip
    known = loaded(robot, factor)
    before = deviations(robot)
    sizes = {name: math.hypot(factor * before.get(name, 0.0), SHAPE * (factor - 1) * getattr(robot, name))
             for name in LOADED if name in before}  # fmt: skip
    sizes["body_mass"] = math.hypot(SCALE * weighed, 2 * before.get("wheel_mass", 0.0))
    scaled = {name: Provenance("the robot on a scale", size) for name, size in sizes.items()}
    return known.replace(provenance={**robot.provenance, **scaled})


def as_weighed(robot: Robot, weighed: float | None, *, alone: bool, logged: bool) -> Robot:
    """The robot of a file on a scale, or as it is (None). Of robots that are drawn from elsewhere, not from this file
    `alone`, a scale says nothing."""
    if weighed is None:
        return robot
    if not alone:
        raise InvalidScenario("a weight beside a posterior or a list of robots", expected="a weight and the robot's "
                              "file", hint="calibrate again from the robot's file with this mass")  # fmt: skip
    return on_the_scale(robot, weighed, logged=logged)
