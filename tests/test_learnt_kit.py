"""What a calibration learns of a robot's electronics stays in the file that every other command takes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

import upright as up
from upright.calibration.calibration import Calibration
from upright.calibration.electronics import ASYMMETRY
from upright.calibration.learnt_kit import learnt_kit
from upright.cli.main import main
from upright.control import lqg
from upright.control.excited import Excited, random_binary
from upright.errors import UprightError
from upright.robots import Kit, Motor, Robot, find_robot, kit_names
from upright.robots.facts import kit_facts

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
BEHIND, STRONGER = 0.012, 0.08
"""[s] by which the gyro is behind the kit's, [1] by which the right motor is stronger than the left."""


def faulty() -> Kit:
    gyro = replace(KIT.sensors["sensor/gyro"], delay=KIT.sensors["sensor/gyro"].delay + BEHIND)
    motor = replace(KIT.motor, left=1 - STRONGER / 2, right=1 + STRONGER / 2)
    return replace(KIT, sensors={**KIT.sensors, "sensor/gyro": gyro}, motor=motor)


@pytest.mark.parametrize("name", kit_names())
def test_a_kit_written_is_the_kit_read(name: str, tmp_path: Path) -> None:
    path = tmp_path / "kit.toml"
    path.write_text(Kit.preset(name).to_toml(), encoding="utf-8")
    assert kit_facts(Kit.load(path)) == kit_facts(Kit.preset(name))


def test_a_robot_keeps_its_own_electronics_in_its_file(tmp_path: Path) -> None:
    robot = replace(ROBOT, kit=faulty())
    again = Robot.load(robot.save(tmp_path / "mine.toml"))
    assert again == robot
    assert again.kit == faulty()
    assert again.kit_name == "nxt"
    # a certificate of a kit that says nothing of its motors stays one of this kit
    assert kit_facts(faulty()).keys() - kit_facts(KIT).keys() == {"motor/left", "motor/right"}


def test_a_motor_that_a_refused_fit_turns_backwards_has_no_strength() -> None:
    """A right encoder of the other sign made an asymmetry of −2.4, and the page of the refused fit became "motor right
    is -0.187671; expected zero or more", of which nobody learns what is wrong."""
    result = SimpleNamespace(delays=(), electronics=(SimpleNamespace(name=ASYMMETRY, value=-2.4),))
    motor = learnt_kit(cast("Calibration", result), KIT, {"gyro": 0.0}, 0.0).motor
    assert (motor.left, motor.right) == (pytest.approx(2.2), 0.0)  # 1 ± half of it, and none below zero


def test_a_robots_file_with_a_broken_kit_is_refused_in_a_line(tmp_path: Path) -> None:
    path = replace(ROBOT, kit=faulty()).save(tmp_path / "mine.toml")
    path.write_text(path.read_text().replace("kit.sensors.gyro.delay", "kit.sensors.giro.delay"))
    with pytest.raises(UprightError, match="giro"):
        Robot.load(path)


def test_unequal_motors_turn_a_robot_and_the_log_says_what_was_applied() -> None:
    kit = Kit(name="unequal", motor=Motor(left=0.9, right=1.1))
    body = up.Electronics(up.NonlinearBody(ROBOT, period=0.001), kit)
    now = body.reset()
    for _ in range(50):
        now = body.step((1.0, 1.0))
    assert now.applied == (1.0, 1.0)
    # the right wheel is faster: anticlockwise, which is positive
    assert dict(zip([c.name for c in body.spec.channels], now.values, strict=True))["truth/yaw"] > 0.001


@pytest.mark.evidence
def test_what_a_log_shows_of_the_electronics_reaches_every_command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    controller = Excited(lqg(ROBOT, KIT, KIT.period), random_binary(1000, 1.0, seed=5, hold=6))
    body = up.Electronics(up.NonlinearBody(ROBOT, period=0.001), faulty())
    log = up.run(body, controller, seconds=8.0, seed=2).save(tmp_path / "run.parquet")
    mine, posterior = tmp_path / "mine.toml", tmp_path / "mine.json"
    assert main(["calibrate", str(log), "--robot", "nxtway-gs", "-o", str(mine), "--save", str(posterior)]) == 0
    learnt = Robot.load(mine).kit
    assert isinstance(learnt, Kit)
    true = faulty().sensors["sensor/gyro"].delay
    assert learnt.sensors["sensor/gyro"].delay == pytest.approx(true, abs=0.004)
    motors = learnt.motor
    assert (motors.right - motors.left) / (motors.right + motors.left) * 2 == pytest.approx(STRONGER, abs=0.03)
    assert find_robot(posterior).kit == learnt
    before = up.validate(log, ROBOT).logs[0].worst.r2
    assert up.validate(log, mine).logs[0].worst.r2 > before
    assert up.validate(log, posterior).logs[0].worst.r2 > before
    assert (
        main(
            [
                "simulate",
                "--robot",
                str(mine),
                "--push",
                "hold:0.05,until=1",
                "--seconds",
                "2",
                "-o",
                str(tmp_path / "s.parquet"),
            ]
        )
        == 0
    )
    simulated = up.Log.load(tmp_path / "s.parquet")
    rate, gyro = simulated["truth/pitch_rate"][20:-20], simulated["sensor/gyro"]
    lag = np.argmax([np.corrcoef(rate, np.roll(gyro, -k)[20:-20])[0, 1] for k in range(6)])
    assert lag * simulated.period == pytest.approx(true, abs=0.012)
    capsys.readouterr()
    for command in (["post-mortem", str(log)], ["validate", str(mine), str(log)]):
        robot = ["--robot", str(mine)] if command[0] == "post-mortem" else []
        assert main([*command, *robot]) == 0, command
