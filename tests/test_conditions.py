"""The batteries and floors that a robot's file expects: read, tried, and compared with a log."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.certification.checks import TrialSetup, kernel_controller, trials
from upright.certification.pushes import RELEASE, standard_pushes
from upright.control import lqg
from upright.errors import InvalidRobot
from upright.experiment import Drive, Impulse, Slope, run
from upright.fleets.ensemble import Ensemble
from upright.fleets.vary import varied
from upright.likelihood.assumptions import Assumptions, batteries
from upright.likelihood.support import supported
from upright.robots import Kit, Robot
from upright.robots.facts import differences, robot_facts
from upright.robots.sections import Conditions
from upright.robots.uncertainty import Family, Uncertainty, draw
from upright.signals import Log

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
HILLS = Conditions(battery=(4.0, 9.0), slope=(0.0, math.radians(5)))
BATTERY = '[conditions.battery]\nlow = 6.8\nhigh = 9\nunit = "V"\n'


def expecting(conditions: Conditions) -> Robot:
    return ROBOT.replace(conditions=conditions)


def test_a_file_keeps_its_conditions(tmp_path: Path) -> None:
    robot = expecting(HILLS)
    assert Robot.load(robot.save(tmp_path / "robot.toml")) == robot
    (tmp_path / "one.toml").write_text(ROBOT.to_toml() + "\n" + BATTERY, "utf-8")
    assert Robot.load(tmp_path / "one.toml").conditions == Conditions(battery=(6.8, 9.0))
    assert robot.replace(body_mass=0.7).conditions == HILLS


@pytest.mark.parametrize(
    ("text", "part"),
    [
        (BATTERY.replace('"V"', '"mV"'), "millivolts"),
        (BATTERY.replace("6.8", "10"), "low not above high"),
        (BATTERY.replace("low = 6.8\n", ""), "lacks low"),
        (BATTERY.replace("battery", "batery"), "battery"),
        (BATTERY.replace("6.8", '"low"'), "conditions.battery.low"),
        ('[conditions.slope]\nlow = -5\nhigh = 5\nunit = "rad"\n', "degrees"),
        ("[conditions]\nbattery = [6.8, 9]\n", "table"),
        ('[conditions.battery]\nlow = nan\nhigh = 9\nunit = "V"\n', "conditions.battery.low"),
    ],
)
def test_wrong_conditions_are_named(text: str, part: str, tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text(ROBOT.to_toml() + "\n" + text, "utf-8")
    with pytest.raises(InvalidRobot, match=part):
        Robot.load(tmp_path / "robot.toml")


def test_batteries_are_the_files_or_the_kits() -> None:
    assert batteries(ROBOT, KIT) == pytest.approx((0.85 * 8, 1.12 * 8))  # of six AA cells: 7 to 9 V under load
    assert batteries(expecting(HILLS), KIT) == (4.0, 9.0)
    assert batteries(Robot.preset("twipr"), Kit.preset("twipr")) is None


def test_trials_on_a_slope_are_the_loop_of_run() -> None:
    """As on level ground, peaks differ by noise alone, below some hundredths of a radian."""
    robot, angle = expecting(Conditions(slope=(0.0, math.radians(3)))), math.radians(3)
    trial_setup = TrialSetup(robot, [robot] * 10, KIT, controller=kernel_controller(lqg(robot, KIT), robot, KIT))
    runs = trials(trial_setup).trials
    assert len(runs) == trial_setup.runs_of_trials // 10 == 12
    full = 1.12 * KIT.battery.voltage
    sloped = [t for t in runs if t.push.endswith(", slope +3.0°") and t.battery == "full"]
    assert len(sloped) == 3
    for trial in sloped:
        push = standard_pushes(robot, KIT, full, angle)[trial.push.partition(", slope")[0]].push
        body = Electronics(NonlinearBody(robot), KIT)
        log = run(body, lqg(robot, KIT), [push, Slope(angle=angle)], seconds=RELEASE + 1, seed=3)
        assert abs(np.abs(log["truth/pitch"]).max() - trial.peak) < 0.03


def test_a_log_is_compared_with_what_the_file_expects() -> None:
    weak = dataclasses.replace(KIT, battery=dataclasses.replace(KIT.battery, voltage=4.2))
    pushes: list[Any] = [Impulse(impulse=0.03, start=2.0), Slope(angle=math.radians(4))]
    drive = [Drive(speed=0.05, start=3.0)]
    log = run(Electronics(NonlinearBody(ROBOT), weak), lqg(ROBOT, KIT), pushes, reference=drive, seconds=9.0, seed=5)
    raw = Log(log.t, {n: log[n] for n in log.channels if n.startswith(("sensor/", "command/"))})

    def outside(robot: Robot) -> set[str]:
        drawn = draw(robot, 100, 3, Uncertainty.of(robot).scaled(0.2))
        floor = (math.radians(4), math.radians(3.9), math.radians(4.1))  # as a calibration of the log has it
        assumed = Assumptions(robot, drawn, KIT, floor=floor)
        return {s.name for s in supported(raw, assumed) if s.outside}

    assert {"battery", "slope"} <= outside(ROBOT)
    assert not {"battery", "slope"} & outside(expecting(HILLS))


def test_a_certificate_of_other_conditions_is_another() -> None:
    words = differences(robot_facts(expecting(HILLS)), robot_facts(ROBOT))
    assert "conditions/battery" in words
    assert "conditions/slope" in words
    assert "conditions/battery" not in robot_facts(ROBOT)  # certificates of before stay valid


def test_a_fleet_draws_the_batteries() -> None:
    robot = expecting(HILLS)
    ensemble = Ensemble(family=Family(robot, KIT, varied("conditions", robot, KIT)), controller=lqg(robot, KIT))
    volts = ensemble.family.draw(0, range(4000))["battery.voltage"]
    # of 4000 between 4 and 9 V the outermost lie 1 mV from the ends on average
    assert (volts.min(), volts.max()) == pytest.approx((4.0, 9.0), abs=0.02)
