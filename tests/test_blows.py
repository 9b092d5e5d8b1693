"""Blows far beyond what a controller survives, and the command that a post-mortem prints."""

from __future__ import annotations

import shlex
from pathlib import Path

import pytest

from test_postmortem import KIT, NXT, logged, standing, weakened
from upright.bodies import Electronics, make_body
from upright.control import make_controller
from upright.diagnose import post_mortem
from upright.diagnose.thrown import thrown
from upright.experiment import Impulse, run
from upright.robots import Kit, Robot
from upright.signals import Log

HIT = 2.0  # [s] long after the start, in ordinary balance
BLOWS = (
    ("ev3way", "lqg", "nonlinear", 0.8),
    ("ev3way-large-wheels", "pid", "twin", -3.0),
    ("twipr", "lqg", "nonlinear", 4.0),
)
"""Robot, controller, body and impulse [N s] of blows of several times what the controller survives: gyros stand at the
ends of their ranges, wheels slide, and the log ends on the floor within 30 to 230 ms."""


def struck(robot: str, design: str, body: str, impulse: float) -> Log:
    """What a real robot would have logged of a blow at the height of its centre of mass."""
    nominal = Robot.preset(robot)
    kit = Kit.preset(nominal.kit)
    law = make_controller(design, nominal, kit, kit.period)
    log = run(Electronics(make_body(body, nominal), kit), law, Impulse(impulse=impulse, start=HIT), seconds=6.0, seed=3)
    assert log.origin["outcome"]["fell"]
    return Log(log.t, {n: log[n] for n in log.channels if n.startswith(("sensor/", "command/"))})


@pytest.mark.parametrize(
    ("robot", "design", "body", "impulse"),
    [pytest.param(*blow, marks=() if blow in BLOWS[:1] else pytest.mark.evidence) for blow in BLOWS],
)
def test_a_blow_that_throws_a_robot_over_is_a_push(robot: str, design: str, body: str, impulse: float) -> None:
    """The planted push is named, from when it hit; never surer than a cause whose log may hide another one."""
    log = struck(robot, design, body, impulse)
    found = post_mortem(log, robot)
    assert found.verdict == "push too large", str(found)
    assert found.causes[0].likelihood <= 0.9
    assert found.onset == pytest.approx(HIT, abs=0.05)  # two rows, and the 22 ms by which a gyro is behind
    assert found.fell_at <= log.t[-1]
    assert found.check() == []


def test_a_log_that_ends_just_after_a_blow_says_so_and_is_less_sure() -> None:
    """Of 20 ms a log shows two readings: it fell, by its speed, but no verdict is sure."""
    log = struck("nxtway-gs", "pid", "twin", -8.0)
    cut = log.between(0.0, HIT + 0.025)
    found = post_mortem(cut, NXT)
    assert found.verdict == "push too large"
    assert found.causes[0].likelihood < 0.6
    assert found.causes[0].evidence.facts["left"].value == pytest.approx(0.025, abs=0.011)


def test_a_gyro_that_jumps_is_no_blow() -> None:
    """An offset of 2 rad/s moves no wheel at once, and a single spike is over in one row."""
    log = logged("gyro bias", "step", 2.0)
    assert thrown(log, NXT, KIT, float(log.t[-1])) is None
    gyro = standing()["sensor/gyro"].copy()
    gyro[-10] = 6.0  # near the end of its range
    spiked = Log(standing().t, {**standing().channels, "sensor/gyro": gyro})
    assert thrown(spiked, NXT, KIT, float(spiked.t[-1])) is None


def test_what_to_run_next_names_the_log(tmp_path: Path) -> None:
    """What is printed can be typed as it is: the library knows the file, the command line adds the robot's."""
    path, toml = tmp_path / "my fall.csv", tmp_path / "robot.toml"
    weakened().save(path)
    NXT.save(toml)
    (step,) = post_mortem(str(path), str(toml), KIT, seconds=0.0).page().next
    words = shlex.split(step.command)
    assert words[0] == "upright"
    assert str(path) in words or step.verb == "design"
