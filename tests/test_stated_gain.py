"""A file that states a gain: were its commands logged before it or after it? And a run whose commands have a factor."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.calibration.calibrate import calibrate
from upright.calibration.stated_gain import amplified
from upright.control import Estimated, kalman, lqr_state
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.logs.raw import raw_log
from upright.robots import Kit, Robot
from upright.signals import Log
from upright.validation.validate import validate

PRIOR, NXT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
TRUE = PRIOR.replace(com_height=0.0768, pitch_inertia=0.0013, torque_constant=0.33, motor_friction=0.003)
FULL = 3.0
"""[V] of a battery that is too small: one command in twenty is more, and is cut."""
EV3 = Path(__file__).parents[1] / "../shared/data/ev3way"


@cache
def driven(seed: int, seconds: float) -> Log:
    """A foreign file's channels: raw sensors, and commands in volts before they are cut at full duty."""
    small = replace(NXT, battery=replace(NXT.battery, voltage=FULL, sag=0.0))
    excited = Excited(Estimated(lqr_state(PRIOR, 0.01), kalman(PRIOR, small)), random_binary(600, 1.5, seed, hold=4))
    log = run(Electronics(NonlinearBody(TRUE), small), excited, seconds=seconds, seed=seed)
    assert not log.origin["outcome"]["fell"]
    names = [n for n in log.channels if n.startswith("sensor/") or n.startswith("command/")]
    return Log(log.t, {n: log[n] for n in names}, {n: log.unit(n) for n in names}, {"file": f"{seed}.csv"})


def stating(log: Log, gain: float, *, before: bool) -> Log:
    """The file of a program that multiplies its commands by `gain` and cuts them at full duty, logged before that or
    after it."""
    sides = ("command/left", "command/right")
    commands = {n: log[n] / gain if before else np.clip(log[n], -FULL, FULL) for n in sides}
    return Log(log.t, {**log.channels, **commands}, log.units, {**log.origin, "stated_gains": {f"gain={gain}": gain}})


def said(log: Log) -> str:
    return next(str(note) for note in calibrate(log, PRIOR).notes if "states gain" in str(note))


@pytest.mark.evidence
def test_commands_before_a_gain_are_found_and_those_after_it_are_left() -> None:
    """Cut at full duty in one row of twenty: what is cut tells the side, whatever the motor's own constants are."""
    log, gain = driven(1, 4.0), 1.3
    assert 0.01 < np.mean(np.abs(log["command/left"]) > FULL) < 0.2
    assert "are those before that gain" in said(stating(log, gain, before=True))
    assert "taken as logged" in said(stating(log, gain, before=False))


@pytest.mark.parametrize(
    ("before", "told"),
    [
        (True, "are those before that gain"),
        pytest.param(False, "taken as logged", marks=pytest.mark.evidence),  # as of the driver below
    ],
)
def test_a_known_robot_tells_the_side_of_the_gain(before: bool, told: str) -> None:
    """A motor of half the strength would be far from what its file says."""
    note = str(validate(stating(driven(2, 4.0), 2.0, before=before), TRUE).logs[0].notes[0])
    assert told in note


def test_a_concave_driver_is_not_taken_for_commands_before_a_gain() -> None:
    """A bridge with slow decay: V/U = (1 − e^(−2d)) / (1 − e^(−2)) of a duty d. Small duties act 2.3 times, as they
    would before a gain, and the program logs what it puts out, after its gain and cut."""
    log, sides = driven(2, 4.0), ("command/left", "command/right")
    applied = {n: np.clip(log[n], -FULL, FULL) / FULL for n in sides}
    duty = {n: -np.sign(v) * np.log1p(-np.abs(v) * (1 - np.exp(-2))) / 2 for n, v in applied.items()}
    channels = {**log.channels, **{n: FULL * d for n, d in duty.items()}}
    origin = {**log.origin, "stated_gains": {"gain=2.0": 2.0}}  # the nearest to what small duties seem to have
    note = str(validate(Log(log.t, channels, log.units, origin), TRUE).logs[0].notes[0])
    assert "taken as logged" in note
    assert "before that gain:" not in note


@pytest.mark.evidence
def test_a_run_whose_commands_have_a_factor_is_named_by_it() -> None:
    """No file states a gain. In the second log the program's commands are those before one of 1.6."""
    logs = [driven(seed, 4.0) for seed in (3, 4, 5)]
    sides = ("command/left", "command/right")
    weaker = Log(logs[1].t, {**logs[1].channels, **{n: logs[1][n] / 1.6 for n in sides}}, logs[1].units, logs[1].origin)
    (words,) = calibrate([logs[0], weaker, logs[2]], PRIOR).apart
    assert words.facts["n"] == 2
    assert words.facts["times"].low < 1.6 < words.facts["times"].high


@pytest.mark.evidence
def test_a_winding_that_no_temperature_makes_is_named() -> None:
    """A log of a body of ours has what was applied, no supply is in doubt: a factor of 1.6 is then a winding."""
    robot = Estimated(lqr_state(PRIOR, 0.01), kalman(PRIOR, NXT))
    logs = [
        run(
            Electronics(NonlinearBody(TRUE), NXT),
            Excited(robot, random_binary(400, 1.5, seed, hold=4)),
            seconds=4.0,
            seed=seed,
        )
        for seed in (6, 7, 8)
    ]
    sides = ("applied/left", "applied/right")
    weaker = Log(logs[1].t, {**logs[1].channels, **{n: logs[1][n] / 1.6 for n in sides}}, logs[1].units, logs[1].origin)
    (words,) = calibrate([logs[0], weaker, logs[2]], PRIOR).apart
    assert words.facts["n"] == 2
    assert "motor resistance" in str(words)


def test_commands_times_a_gain_end_at_full_duty_and_at_no_less_than_what_was_logged() -> None:
    t = np.arange(4.0)
    commands = np.array([1.0, -5.0, 9.0, -3.0])
    channels = {"applied/left": commands, "applied/right": commands, "sensor/battery": np.full(4, 8.0)}
    log = Log(t, channels, dict.fromkeys(channels, "V"), {"stated_gains": {"gain=2": 2.0}})
    new = amplified(log, 2.0, NXT)
    assert new["applied/left"].tolist() == [2.0, -8.0, 9.0, -6.0]
    assert "stated_gains" not in new.origin


@pytest.mark.parametrize(
    ("head", "gains"),
    [
        ("# controller v3 (gain=1.50)\n", {"gain=1.50": 1.5}),
        ("# Gain: 0.8, wait 5 ms\n", {"Gain: 0.8": 0.8}),
        ("# duty times a gain of 2\n", {"gain of 2": 2.0}),
        ("# k=1.25\n", {"k=1.25": 1.25}),
        ("# gain=1.0\n", None),
        ("# gain=1.5e3, again 3, k1=7\n", None),
        ("# k=1.1 k=2 k=3 k=4\n", None),  # those of a state feedback
        ("", None),
    ],
)
def test_a_files_gains_are_read_from_the_lines_before_its_header(
    head: str, gains: dict[str, float] | None, tmp_path: Path
) -> None:
    path = tmp_path / "run.csv"
    rows = "\n".join(f"{10 * i},{i % 3},{i},{i},{i % 5}" for i in range(30))
    path.write_text(f"{head}t_ms,gyro,enc_l,enc_r,pwm\n{rows}\n")
    assert raw_log(path).origin.get("stated_gains") == gains


@pytest.mark.needs("shared/data/ev3way")
def test_a_real_run_does_not_show_its_gain_against_a_drivers_curve() -> None:
    """Gyro and wheels of nn_v7_000 turn 1.5 times as far for a volt as those of the others (docs/calibrate.md). Its
    commands before that gain would do it, and a driver whose small duties act more than in proportion."""
    log = validate(raw_log(EV3 / "nn_v7_000.csv"), Robot.preset("ev3way-large-wheels")).logs[0]
    note = " ".join(map(str, log.notes))
    assert "taken as logged" in note
    assert "curved driver" in note
    assert "file nn_v7_000.csv" in note
