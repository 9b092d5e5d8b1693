"""A tilted gyro, which reads a part of the yaw rate: stated in a kit, and looked for in a log. That a level one gets no
tilt is claimed in `test_drop`."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from upright.bodies import Electronics
from upright.bodies.models import NonlinearBody
from upright.calibration.calibrate import calibrate, prepared
from upright.calibration.electronics import MISALIGNED
from upright.calibration.estimate import PRIOR, VISIBLE, Estimate
from upright.calibration.filter_log import known
from upright.calibration.misaligned import in_words
from upright.calibration.own_run import of_this_run
from upright.calibration.summary import COMBINATIONS
from upright.control import make_controller
from upright.control.excited import Excited, random_binary
from upright.errors import InvalidRobot
from upright.experiment import run
from upright.robots import Kit, Robot, find_kit
from upright.robots.kit import Sensor
from upright.signals import Log

ROBOT = Robot.preset("nxtway-gs")
KIT = find_kit(ROBOT.kit)
TILT = -0.2  # [1] the sine of 11.5°


def tilted(part: float) -> Kit:
    gyro = replace(KIT.sensors["sensor/gyro"], misalignment=part)
    return replace(KIT, sensors={**KIT.sensors, "sensor/gyro": gyro})


@cache
def logged(part: float, seed: int = 3, seconds: float = 12.0) -> Log:
    """What another program logs of the preset, whose gyro shows a part of the yaw rate besides."""
    body = Electronics(NonlinearBody(ROBOT), KIT)
    dither = random_binary(round(seconds / KIT.period), 1.5, seed, 4)
    log = run(body, Excited(make_controller("lqg", ROBOT, KIT, KIT.period), dither), seconds=seconds, seed=seed)
    assert not log.origin["outcome"]["fell"]
    gyro = KIT.sensors["sensor/gyro"]
    turned = np.interp(log.t - gyro.delay, log.t, log["truth/yaw_rate"])
    channels = {n: v for n, v in log.channels.items() if n.startswith(("sensor/", "command/"))}
    both = channels["sensor/gyro"] + part * turned
    channels["sensor/gyro"] = gyro.quantum * np.round(both / gyro.quantum)
    return Log(log.t, channels, {n: log.unit(n) for n in channels}, {})


@pytest.mark.evidence
def test_a_tilt_that_no_file_states_is_found_with_the_robot() -> None:
    found = calibrate(logged(TILT), ROBOT.replace(com_height=1.1 * ROBOT.com_height))
    assert found[MISALIGNED].low <= TILT <= found[MISALIGNED].high
    assert found[MISALIGNED].verdict == VISIBLE
    assert found["com_height"].low <= ROBOT.com_height <= found["com_height"].high
    assert found["a22"].low <= COMBINATIONS["a22"][1](ROBOT) <= found["a22"].high
    assert [note for note in map(str, found.notes) if "of the yaw rate" in note and "tilted by 1" in note]
    kit = found.known_robot().kit
    assert isinstance(kit, Kit)
    assert kit.sensors["sensor/gyro"].misalignment == found[MISALIGNED].value


def test_the_tilt_of_a_kit_judges_another_log() -> None:
    """A robot that turns by ±2 rad/s: the gyro's part of that is most of what a level one leaves."""
    left: list[float] = []
    for kit in (tilted(TILT), KIT):
        names = (MISALIGNED,) if kit is not KIT else ()
        problem, limits = prepared([logged(TILT, seed=5, seconds=4.0)], ROBOT, kit, names, 0.0)
        assert MISALIGNED not in [p.name for p in problem.asked]
        fitted = of_this_run(problem, limits)
        assert fitted
        left.append(1 - fitted[0].r_squared("sensor/gyro"))
    assert left[0] < left[1] / 4


def test_the_filter_of_a_known_robot_reads_the_tilt() -> None:
    """Of logs of another program, and of a body of ours, which reads what its kit says."""
    for origin in ({}, {"body": {"kind": "twin"}}):
        log = replace(logged(TILT, seconds=4.0), origin=origin)
        problem = known(log, ROBOT, tilted(TILT), 0.0)
        recording = problem.recordings[0]
        C = problem.lanes(recording, np.zeros((len(problem.parameters), 1))).reads[:, :, 0]
        assert C[recording.rows.index("sensor/gyro")].tolist()[:7] == [0, 1, 0, 0, 0, TILT, 1]


def test_a_tilt_that_is_open_or_stated_is_no_news() -> None:
    open_ = Estimate(name=MISALIGNED, unit="1", value=0.2, low=-0.1, high=0.5, prior=0.0, prior_spread=0.15,
                     verdict=PRIOR, shift=1.3, shrink=1.0)  # fmt: skip
    assert in_words([open_], 24.0) == []
    assert in_words([replace(open_, verdict=VISIBLE)]) == []
    assert "reads 0.2 (−0.1 to 0.5) of the yaw rate" in str(in_words([replace(open_, verdict=VISIBLE)], 24.0)[0])


def test_a_kit_with_a_tilted_gyro_is_written_and_read(tmp_path: Path) -> None:
    (tmp_path / "kit.toml").write_text(tilted(TILT).to_toml())
    assert Kit.load(tmp_path / "kit.toml") == tilted(TILT)
    with pytest.raises(InvalidRobot, match="sensor misalignment is 11; expected -1 to 1"):
        Sensor(misalignment=11.0)
