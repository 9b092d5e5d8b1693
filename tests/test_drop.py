"""A driver that keeps a constant voltage of each command: stated in a kit, and looked for in a log."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from interpreter import Interpreter
from upright.bodies import Electronics
from upright.bodies.models import NonlinearBody
from upright.calibration.calibrate import calibrate, prepared
from upright.calibration.dropping import in_words
from upright.calibration.electronics import DROP, MISALIGNED
from upright.calibration.estimate import PRIOR, VISIBLE, Estimate
from upright.calibration.informativity import MARGIN
from upright.calibration.motion import block_of, driven
from upright.calibration.own_run import of_this_run
from upright.calibration.resonance import FREQUENCY
from upright.calibration.summary import COMBINATIONS
from upright.compiled.generated import constants
from upright.compiled.jit import numba
from upright.control import make_controller
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.firmware.balance import trace
from upright.robots import Kit, Robot, find_kit
from upright.signals import Log

ROBOT = Robot.preset("nxtway-gs")
KIT = find_kit(ROBOT.kit)
KEPT = 1.2  # [V] of 8
RUBS = 0.005  # [N m] dry friction of a LEGO motor, as docs/add-a-robot.md guesses it
_driven = numba.njit(lambda w, u: driven(w, 0, u))


def prior(friction: float = 0.0) -> Robot:
    """The robot with a centre of mass a tenth too high."""
    return ROBOT.replace(com_height=1.1 * ROBOT.com_height, coulomb_friction=friction)


def behind(drop: float) -> Kit:
    """The preset's kit, whose driver has a drop, and no steps: half a step of 0.08 V would be a drop of its own, since
    steps are towards zero and the command is logged before them."""
    return replace(KIT, motor=replace(KIT.motor, drop=drop, quantum=0.0))


@cache
def logged(drop: float, friction: float = 0.0, seed: int = 3, seconds: float = 12.0) -> Log:
    """What another program logs of the preset: its sensors, and what it commands."""
    body = Electronics(NonlinearBody(ROBOT.replace(coulomb_friction=friction)), behind(drop))
    dither = random_binary(round(seconds / KIT.period), 1.5 + drop, seed, 4)
    log = run(body, Excited(make_controller("lqg", ROBOT, KIT, KIT.period), dither), seconds=seconds, seed=seed)
    assert not log.origin["outcome"]["fell"]
    kept = {n: v for n, v in log.channels.items() if n.startswith(("sensor/", "command/"))}
    return Log(log.t, kept, {n: log.unit(n) for n in kept}, {})


@pytest.mark.parametrize("command", [-4.0, -1.5, -1.0, 0.0, 0.5, 1.5, 2.25])
def test_motors_of_a_calibration_get_what_a_drop_leaves(command: float) -> None:
    """s · sign(u) max(0, |u| − 1.5 V) of a motor of strength s, and 0.125 V more of both; all exact in binary."""
    numbers = [float(v) for v in constants(tuple(ROBOT.numbers().values()), 1.0)]
    w = block_of(np.array([*numbers, 0.5, 1.0, 0.0, 0.125, 1.5])[:, None])
    left = np.sign(command) * max(0.0, abs(command) - 1.5)
    assert _driven(w, np.array([command, command])) == (0.5 * left + 0.125, left + 0.125)


@pytest.mark.parametrize("volts", [6.0, 7.3, 8.4])
def test_a_program_drives_its_motors_as_the_closed_form_says(volts: float) -> None:
    """Of a command u on a battery of U: the duty is |u| / U in whole hundredths, nothing up to 0.5 V, U at most; the
    motors get that part of U less 1.5 V. To rounding; a command within that of a whole step may fall to either side."""
    kit = replace(KIT, motor=replace(KIT.motor, dead_zone=0.5, drop=1.5))
    brick = Interpreter(trace(make_controller("lqg", ROBOT, kit, kit.period), ROBOT, kit, "nxc"))
    seen = list[float]()
    for rate in (*range(0, -40, -1), *range(-40, 40)):  # of the gyro [deg/s], as of a robot that leans ever more
        raw = {"raw_encoder_left": 0.0, "raw_encoder_right": 0.0, "raw_gyro": rate, "raw_battery": round(1e3 * volts)}
        told = brick.command(raw)
        u = told["command_left"]
        hundredths = min(100 * abs(u) / volts, 100.0) if abs(u) > 0.5 else 0.0
        if abs(hundredths - round(hundredths)) > 1e-9 or hundredths in (0.0, 100.0):
            duty = math.floor(hundredths)
            assert told["duty_left"] == math.copysign(duty, u)
            assert told["applied_left"] == pytest.approx(math.copysign(max(0.0, duty / 100 * volts - 1.5), u))
            seen.append(duty)
        brick.update()
    assert min(seen) == 0
    assert max(seen) == 100


def test_a_stated_drop_is_asked_with_half_of_itself() -> None:
    foreign = logged(0.0, seconds=4.0)
    for log, asked in ((foreign, True), (replace(foreign, origin={"body": {"kind": "twin"}}), False)):
        problem, _ = prepared([log], ROBOT, behind(0.8), (), 0.0)
        drops = [p for p in problem.asked if p.name == DROP]
        assert bool(drops) == asked  # a body of ours logs what was applied
        assert all((p.prior, p.spread, p.lower, p.unit) == (0.8, 0.4, 0.0, "V") for p in drops)


def test_a_known_drop_counts_and_is_not_asked() -> None:
    kit = behind(KEPT)
    left: list[float] = []
    for known in ((DROP,), ()):
        problem, limits = prepared([logged(KEPT, seconds=4.0)], ROBOT, kit if known else KIT, known, 0.0)
        assert DROP not in [p.name for p in problem.asked]
        fitted = of_this_run(problem, limits)
        assert fitted
        left.append(1 - fitted[0].r_squared("sensor/gyro"))
    assert left[0] < left[1] / 4  # without it, the model's motors are driven by 1.2 V too much


@pytest.mark.evidence
def test_a_drop_that_no_file_states_is_found_with_the_robot() -> None:
    found = calibrate(logged(KEPT), prior())
    assert found[DROP].low <= KEPT <= found[DROP].high
    assert found[DROP].high - found[DROP].low < 0.2  # [V] half of a dead zone of the kit, within which nothing moves
    assert found[DROP].verdict == VISIBLE
    assert found["com_height"].low <= ROBOT.com_height <= found["com_height"].high
    assert found["a11"].low <= COMBINATIONS["a11"][1](ROBOT) <= found["a11"].high
    assert [note for note in map(str, found.notes) if "off each command" in note]
    assert found.to_json()["likelier"][DROP] > MARGIN
    assert found.kit
    in_commands = (
        found[DROP].value / found["battery"].value
    )  # a kit's drop is of a command, before the motors' strength
    assert found.kit.motor.drop == pytest.approx(in_commands, rel=1e-12)
    kit = found.known_robot().kit
    assert isinstance(kit, Kit)
    assert kit.motor.drop == found.kit.motor.drop


def test_a_sound_driver_and_gyro_get_no_drop_no_tilt_and_no_resonance() -> None:
    """Dry friction acts against the motion, a drop against the command. Five seconds tell that nothing is needed."""
    found = calibrate(logged(0.0, RUBS, seconds=5.0), prior(RUBS))
    assert not {DROP, MISALIGNED, FREQUENCY} & {e.name for e in found.electronics}
    assert found.kit
    gyro = found.kit.sensors["sensor/gyro"]
    assert (found.kit.motor.drop, gyro.misalignment, gyro.resonance) == (0.0, 0.0, 0.0)
    assert not [
        note for note in map(str, found.notes) if any(w in note for w in ("off each command", "yaw rate", "Hz"))
    ]


def test_nothing_is_said_of_a_drop_that_the_log_leaves_open_or_the_file_states() -> None:
    open_ = Estimate(name=DROP, unit="V", value=1.0, low=0.4, high=3.0, prior=1.1, prior_spread=0.7, verdict=PRIOR,
                     shift=0.0, shrink=0.8)  # fmt: skip
    assert in_words([open_], 24.0) == []
    assert in_words([replace(open_, verdict=VISIBLE)]) == []
    assert "takes 1 (0.4 to 3)\u00a0V off" in str(in_words([replace(open_, verdict=VISIBLE)], 24.0)[0])
