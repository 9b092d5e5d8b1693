"""Weights in a robot's file are the defaults of their methods, for its own kit."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

from upright.control import CONTROLLERS, controller_hash
from upright.errors import InvalidRobot, UprightError
from upright.robots import Kit, Robot

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
TABLE = '\n[weights.lqg]\npitch = 0.1\nwheel = 2.0\nsource = "upright tune lqg, seed 0"\n'


def written(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "robot.toml"
    path.write_text(ROBOT.to_toml() + text, "utf-8")
    return path


def test_weights_in_a_file_are_the_methods_defaults(tmp_path: Path) -> None:
    robot, lqg = Robot.load(written(tmp_path, TABLE)), CONTROLLERS["lqg"]
    own = lqg(robot, KIT, 0.01)
    asked = lqg.tuned(ROBOT, KIT, 0.01, {**lqg.defaults(ROBOT, KIT, 0.01), "pitch": 0.1, "wheel": 2.0})
    assert controller_hash(own) == controller_hash(asked)
    assert controller_hash(own) != controller_hash(lqg(ROBOT, KIT, 0.01))
    other = dataclasses.replace(KIT, name="another")  # they were tuned for the robot's own kit
    assert controller_hash(lqg(robot, other, 0.01)) == controller_hash(lqg(ROBOT, other, 0.01))
    lqi = CONTROLLERS["lqi"]
    assert controller_hash(lqi(robot, KIT, 0.01)) == controller_hash(lqi(ROBOT, KIT, 0.01))


def test_weights_survive_the_file_and_a_change_of_the_robot(tmp_path: Path) -> None:
    robot = Robot.load(written(tmp_path, TABLE))
    again = Robot.load(robot.replace(com_height=0.08).save(tmp_path / "again.toml"))
    assert again.weights == robot.weights
    assert again.weights["lqg"].source == "upright tune lqg, seed 0"


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ('[weights.lqg]\npitch = -1\nsource = "s"\n', "positive"),
        ('[weights.lqg]\npitch = "much"\nsource = "s"\n', "positive"),
        ("[weights.lqg]\npitch = 1\n", "source"),
        ("[weights]\nlqg = 1\n", "table"),
    ],
)
def test_wrong_weights_are_named(text: str, part: str, tmp_path: Path) -> None:
    with pytest.raises(InvalidRobot, match=part):
        Robot.load(written(tmp_path, "\n" + text))


def test_a_weight_that_the_method_does_not_have_is_named(tmp_path: Path) -> None:
    robot = Robot.load(written(tmp_path, TABLE.replace("wheel", "whel")))
    with pytest.raises(UprightError, match=r"whel"):
        CONTROLLERS["lqg"](robot, KIT, 0.01)
