"""Poses of a log: made by hand round one run of a twin, and of measured logs whose course is known."""

from __future__ import annotations

import math
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from upright import calibrate
from upright.bodies import Electronics, NonlinearBody
from upright.checkup.doctor import Diagnosis, doctor
from upright.checkup.poses import _ends_falling
from upright.checkup.wheels import on_its_wheels
from upright.control import lqg
from upright.diagnose import post_mortem
from upright.errors import InvalidLog
from upright.experiment import Drive, Impulse, outcome_of, run
from upright.experiment.examples import example
from upright.logs.readers import RawTable, read_table, table_of
from upright.robots import Kit, Robot
from upright.signals import Log

LEFT, RIGHT, GYRO, PITCH = "sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "estimate/pitch"
T = 0.01  # [s]


@cache
def balanced() -> Log:
    """Four seconds of an NXT robot that balances through two knocks and a drive, without truth and without estimate."""
    robot, kit = Robot.preset("nxtway-gs"), Kit.preset("nxt")
    body = Electronics(NonlinearBody(robot), kit)
    knocks = [Impulse(impulse=0.03, start=1.0, duration=0.02), Impulse(impulse=-0.03, start=2.5, duration=0.02)]
    log = run(body, lqg(robot, kit, T), knocks, reference=[Drive(speed=0.1, start=0.5, until=2.0)], seconds=4.0, seed=1)
    names = (LEFT, RIGHT, GYRO, "applied/left", "applied/right", "sensor/battery")
    return Log(log.t, {name: log[name] for name in names}, {name: log.unit(name) for name in names})


def turned(angle: float, seconds: float, shape: float = 1.0) -> np.ndarray:
    """Rates [rad/s] that turn the body by `angle` within `seconds`; the larger `shape`, the more of it at the end."""
    s = np.linspace(0, 1, round(seconds / T) + 1) ** shape
    return np.diff(angle * s) / T


def resting(seconds: float) -> np.ndarray:
    """What a gyro reads of a robot at rest."""
    return np.radians(np.random.Generator(np.random.Philox(3)).normal(0, 0.3, round(seconds / T)))


def joined(before: list[np.ndarray], after: list[np.ndarray], *, chasing: float = 0.0) -> Log:
    """The balanced run with gyro readings (whole degrees a second) before it, in which the wheels stand still and the
    motors are off, and after it, in which the wheels turn at the rate `chasing` [rad/s]."""
    log = balanced()
    head, tail = (np.concatenate([np.zeros(0), *parts]) for parts in (before, after))
    channels = {GYRO: np.radians(np.round(np.degrees(np.concatenate([head, log[GYRO], tail]))))}
    for name in (LEFT, RIGHT):
        rolled = log[name][-1] + np.radians(np.round(np.degrees(chasing * T * np.arange(1, len(tail) + 1))))
        channels[name] = np.concatenate([np.full(len(head), log[name][0]), log[name], rolled])
    for name in ("applied/left", "applied/right"):
        channels[name] = np.concatenate([np.zeros(len(head)), log[name], np.full(len(tail), 6.0)])
    n = len(channels[GYRO])
    return Log(T * np.arange(n), channels, {"applied/left": "V", "applied/right": "V"})


def kinds(diagnosis: Diagnosis) -> list[str]:
    """The poses in order; standing still is a part of balancing."""
    several = ["balancing" if s.kind == "standing still" else s.kind for s in diagnosis.segments]
    return [kind for i, kind in enumerate(several) if i == 0 or kind != several[i - 1]]


def wrong(diagnosis: Diagnosis) -> list[str]:
    """Errors and warnings besides falls and the NXT gyro's own delay."""
    ordinary = {"segment/fall", "delay/sensor", "saturation"}
    return [f"{f.code}: {f.evidence}" for f in diagnosis.findings if f.severity != "note" and f.code not in ordinary]


@pytest.mark.parametrize("side", [1.4, -0.9])
def test_a_robot_that_lies_and_stands_up_is_judged_only_while_it_balances(side: float) -> None:
    log = joined([resting(3.0), turned(-side, 0.3)], [])
    diagnosis = doctor(log)
    assert kinds(diagnosis) == ["lying", "standing up", "balancing"]
    assert diagnosis.segments[0].lean == pytest.approx(side, abs=0.15)  # the balance is not upright all the time
    assert diagnosis.segments[0].stop == pytest.approx(3.0, abs=0.15)
    assert wrong(diagnosis) == []
    repaired = diagnosis.repaired()
    assert repaired.t[0] == pytest.approx(3.3, abs=0.2)
    assert repaired["applied/left"] == pytest.approx(np.interp(repaired.t, log.t, log["applied/left"]))


# Slow, at a steady rate, with a run after it, and as a plain topple.
@pytest.mark.parametrize(("angle", "seconds", "shape"), [(0.9, 0.9, 1.0), (-0.85, 1.2, 1.5), (1.3, 0.5, 3.0)])
def test_a_fall_is_one_whatever_its_shape(angle: float, seconds: float, shape: float) -> None:
    diagnosis = doctor(joined([], [turned(angle, seconds, shape)], chasing=12.0 * np.sign(angle)))
    (fall,) = [f for f in diagnosis.findings if f.code == "segment/fall"]
    assert fall.span is not None
    assert 3.2 < fall.span[0] < 4.0 + 0.5 * seconds
    assert wrong(diagnosis) == []
    assert diagnosis.repaired().t[-1] < 4.0 + 0.5 * seconds


def test_a_fallen_robot_lies_also_where_its_wheels_still_turn() -> None:
    diagnosis = doctor(joined([], [turned(1.3, 0.5, 3.0), resting(2.0)], chasing=15.0))
    assert kinds(diagnosis) == ["balancing", "falling", "fallen"]
    assert wrong(diagnosis) == []


def test_a_robot_that_balances_is_in_no_other_pose() -> None:
    assert kinds(doctor(balanced())) == ["balancing"]


@pytest.mark.parametrize("factor", [180 / np.pi, 1.0, -1.0])
def test_the_pose_does_not_hang_on_the_gyros_unit_or_sign(factor: float) -> None:
    log = joined([resting(3.0), turned(-1.4, 0.3)], [turned(1.3, 0.5, 3.0)], chasing=12.0)
    diagnosis = doctor(Log(log.t, {**log.channels, GYRO: factor * log[GYRO]}, log.units))
    assert kinds(diagnosis) == ["lying", "standing up", "balancing", "falling"]


def test_a_robot_on_its_back_drives_no_motor_backwards() -> None:
    """Upside down the wheels turn the other way: driven in open loop, they roll as their commands say, reversed."""
    t = 0.015 * np.arange(300)
    volts = np.where(t % 2 < 1, 2.0, -2.0)
    speed = np.zeros(len(t))
    for k in range(1, len(t)):
        speed[k] = speed[k - 1] + 0.1 * (-4.0 * volts[k - 1] - speed[k - 1])
    wheel = np.cumsum(speed) * 0.015
    rng = np.random.Generator(np.random.Philox(3))
    pitch = 3.05 + 1e-4 * rng.normal(size=len(t))
    log = Log(t, {LEFT: wheel, RIGHT: wheel, PITCH: pitch, "applied/left": volts, "applied/right": volts})
    diagnosis = doctor(log)
    assert kinds(diagnosis) == ["upside down"]
    assert [f.code for f in diagnosis.findings if f.severity == "error"] == []


COURSES = {
    "ev3way/tilt_000.csv": ["balancing", "falling"],
    "ev3way/nn_v17_005.csv": ["balancing", "falling"],
    "ev3way/nn_v7_000.csv": ["balancing", "falling"],
    "regbot/position_step_2m.txt": ["balancing"],
    "regbot/wheel_speed_upside_down.txt": ["upside down"],
    "twipr/direct_1_all.csv": ["lying", "moved", "lying", "moved", "lying"],
    "twipr/run1.csv": ["balancing"],
    "twipr/run2_all.csv": ["lying", "standing up", "balancing"],
    "ev3-balanc3r/datalog.json.txt": ["balancing"],
}
ALLOWED = {"samples/repeated", "saturation", "delay/sensor", "delay/command", "segment/fall", "segment/none",
           "estimate/accelerometer", "samples/controller"}  # fmt: skip
"""Warnings that docs/logs.md justifies on these logs."""


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.needs(f"shared/data/{name}")) for name in COURSES]
)
def test_the_course_of_a_measured_log(shared: Path, name: str) -> None:
    diagnosis = doctor(shared / "data" / name)
    assert kinds(diagnosis) == COURSES[name]
    assert [f.code for f in diagnosis.findings if f.severity == "error"] == []
    assert {f.code for f in diagnosis.findings if f.severity == "warning"} <= ALLOWED


@pytest.mark.needs("shared/data/ev3way/nn_v17_005.csv")
def test_the_post_mortem_sees_a_slow_fall(shared: Path) -> None:
    found = post_mortem(shared / "data" / "ev3way" / "nn_v17_005.csv", "ev3way")
    assert found.fell
    assert 6.0 < found.fell_at < 6.9
    assert "fell at 6." in str(found)


def short(*, motors: int, gyro: int, rows: int = 29) -> Log:
    """A third of a second of a robot whose motors or gyro are reversed: it topples faster than by itself, since the
    wheels drive away from the fall. Nothing balances, so that a rising exponential is all of the motion."""
    t = T * np.arange(rows)
    lean = 0.02 * np.exp(13 * t)
    command = np.clip(40 * gyro * lean, -8, 8)
    wheel = np.cumsum(np.cumsum(3.0 * motors * command)) * T - lean
    names = {LEFT: wheel, RIGHT: wheel, GYRO: gyro * 13 * lean, "command/left": command, "command/right": command}
    return Log(t, names, {"command/left": "V", "command/right": "V"})


@pytest.mark.parametrize(
    ("motors", "gyro", "blamed"), [(-1, 1, "wheels turn against"), pytest.param(1, 1, "", marks=pytest.mark.evidence)]
)
def test_a_log_of_29_rows_shows_its_fall(motors: int, gyro: int, blamed: str) -> None:
    log = short(motors=motors, gyro=gyro)
    assert "segment/fall" in doctor(log).codes()
    found = post_mortem(log, "nxtway-gs")
    assert found.fell
    assert found.check() == []
    assert any(blamed in str(said) for said in (*found.notes, *(cause.evidence for cause in found.causes)))
    assert ("against" in str(found)) == bool(blamed)


@pytest.mark.parametrize("rows", [20, 29, 60, 120, 178, 199])
def test_a_log_of_any_length_is_examined(rows: int) -> None:
    """Of a robot that balances from its first row to its last: no kernel is longer than what it smooths, no error."""
    log = balanced()
    part = Log(log.t[100 : 100 + rows], {name: x[100 : 100 + rows] for name, x in log.channels.items()}, log.units)
    assert not [f for f in doctor(part, robot="nxtway-gs").findings if f.severity == "error"]


def test_a_rounded_estimate_is_called_coarse_and_has_no_wrong_scale() -> None:
    """Steps as large as the robot's swings: regressions on them find any factor."""
    log = balanced()
    lean = np.cumsum(log[GYRO]) * T
    rounded = Log(log.t, {**log.channels, PITCH: 0.03 * np.rint(lean / 0.03)}, log.units)
    found = {f.code: f for f in doctor(rounded).findings if f.channel == PITCH}
    assert set(found) == {"channel/coarse"}
    assert found["channel/coarse"].severity == "note"


def test_rows_that_the_file_says_were_left_out_are_named(tmp_path: Path) -> None:
    log = balanced()
    (tmp_path / "x.csv").write_text(
        "# wait_ms=5,decim=2\n" + log.save(tmp_path / "y.csv").read_text().split("\n", 1)[1]
    )
    assert "samples/controller" in doctor(tmp_path / "x.csv").codes()
    (tmp_path / "x.csv").write_text("# decim=1\n" + (tmp_path / "y.csv").read_text().split("\n", 1)[1])
    assert "samples/controller" not in doctor(tmp_path / "x.csv").codes()


def test_a_log_cut_in_the_midst_of_a_swing_has_no_gyro_offset() -> None:
    """A robot that swings by 1.2 rad: the log's ends lie 1.1 rad apart, which its pitch estimate shows. A sine solves
    the pendulum equation, where the wheels run against it."""
    t = T * np.arange(290)
    angle = 1.2 * np.sin(2.5 * t - 0.2)
    wheel = -3 * angle + np.random.default_rng(7).normal(0, 0.01, len(t))  # a reading of its own, and no copy
    log = Log(t, {GYRO: 3.0 * np.cos(2.5 * t - 0.2), PITCH: angle, LEFT: wheel, RIGHT: wheel})
    assert abs(angle[-1] - angle[0]) > 1.0
    assert "gyro/bias" not in doctor(log).codes()
    found = doctor(Log(t, {**log.channels, GYRO: log[GYRO] + 0.3}))
    (bias,) = [f for f in found.findings if f.code == "gyro/bias"]
    assert bias.facts["mean"] == pytest.approx(0.3, abs=0.02)


def test_only_the_time_on_the_wheels_is_fitted() -> None:
    """It lies for 3 s, stands up within 0.3 s, balances for 4 s, falls within 0.5 s, and lies."""
    log = joined([resting(3.0), turned(-1.4, 0.3)], [turned(1.3, 0.5, 3.0), resting(2.0)], chasing=12.0)
    part, left = on_its_wheels(log)
    assert part.t[0] == pytest.approx(3.3, abs=0.15)
    assert part.t[-1] == pytest.approx(7.8, abs=0.15)
    assert left is not None
    assert "lying" in str(left)
    assert "fallen" in str(left)
    assert on_its_wheels(log, falling=False)[0].t[-1] < 7.6
    assert on_its_wheels(balanced()) == (balanced(), None)


def test_a_robot_on_its_back_is_not_calibrated() -> None:
    """Its gyro is made of a pitch estimate, which alone knows that it is upside down."""
    t = T * np.arange(300)
    pitch = 3.05 + 0.01 * np.sin(9 * t)
    channels = {PITCH: pitch, GYRO: np.gradient(pitch, T), LEFT: np.sin(3 * t), RIGHT: np.sin(3 * t)}
    channels |= dict.fromkeys(("applied/left", "applied/right"), np.cos(3 * t))
    with pytest.raises(InvalidLog, match="upside down"):
        calibrate(Log(t, channels, origin={"derived": {GYRO: PITCH}}), "nxtway-gs")


def test_microseconds_read_as_seconds_are_named() -> None:
    log = balanced()
    with pytest.raises(InvalidLog, match="in µs they are 10 ms"):
        on_its_wheels(Log(1e6 * log.t, log.channels, log.units))


def test_times_since_1970_are_reported_to_the_hundredth() -> None:
    log = joined([], [turned(1.3, 0.5, 3.0)], chasing=12.0)
    (fall,) = [f for f in doctor(Log(log.t + 1.7e9, log.channels, log.units)).findings if f.code == "segment/fall"]
    assert "before 170000000" in str(fall.repair)
    assert "10⁹" not in f"{fall.evidence}{fall.repair}"


# Rows of a measured log, cut where nobody would: what its authors and its own tilt say is in the README beside it.
CUTS = {
    "twipr/run1.csv": (0, 220, ["balancing"]),  # stuck by friction up to row 204
    "twipr/run2_all.csv": (1100, 1500, ["lying", "standing up", "balancing"]),
}


@pytest.mark.parametrize("name", [pytest.param(n, marks=pytest.mark.needs(f"shared/data/{n}")) for n in CUTS])
def test_a_measured_log_cut_anywhere_gets_no_false_alarm(shared: Path, name: str) -> None:
    first, last, poses = CUTS[name]
    table = read_table(shared / "data" / name)
    part = replace(table, columns={n: x[first:last] for n, x in table.columns.items()})
    found = doctor(part)
    assert kinds(found) == poses
    assert not {"units/scale", "motion/differentiated", "gyro/bias"} & set(found.codes())


@pytest.mark.needs("shared/data/twipr/run1.csv")
def test_a_measured_log_in_other_units_gets_no_false_alarm(shared: Path) -> None:
    """Torques that nobody named are not read as volts, whose back-EMF would be a thousandth of a motor's."""
    raw = read_table(shared / "data/twipr/run1.csv").columns
    names = {"t": "t_s", "gyro": "theta_dot_radps", "wl": "speed_left_radps", "wr": "speed_right_radps",
             "u_l": "u_left_Nm", "u_r": "u_right_Nm"}  # fmt: skip
    found = doctor(RawTable({mine: raw[theirs] for mine, theirs in names.items()}))
    assert [f.code for f in found.findings if f.severity == "error"] == []


def test_a_swing_from_which_the_robot_comes_back_is_no_fall() -> None:
    """The measured TWIPR swings to 1.40 rad and goes on; another lies first, and a third stays down."""
    t = T * np.arange(300)
    swing = Log(t, {PITCH: 1.42 * np.sin(3 * t)})
    lying = Log(t, {PITCH: np.where(t < 1, -1.5, 0.0)})
    assert outcome_of(swing.between(0, 2.0)).fell is None
    assert outcome_of(lying).fell is None
    assert outcome_of(Log(t, {PITCH: np.where(t < 1, 0.0, 1.5)})).fell


@pytest.mark.parametrize("rows", [1, 37])
def test_a_lean_that_never_changes_ends_in_no_fall(rows: int) -> None:
    """A tilt that hangs, or a single row between two poses: nothing turned, and no row is after the last one."""
    assert not _ends_falling(np.full(rows, 1.0), T)


@pytest.mark.needs("shared/data/twipr/run1.csv")
@pytest.mark.parametrize("rows", [300, 325])
def test_a_body_that_motors_catch_has_not_reached_the_floor(shared: Path, rows: int) -> None:
    """The measured TWIPR leans by 0.76 rad, three times as far as before, is braked within 0.16 s and driven back."""
    table = read_table(shared / "data/twipr/run1.csv")
    assert "falling" not in kinds(doctor(replace(table, columns={n: x[:rows] for n, x in table.columns.items()})))


@pytest.mark.needs("shared/data/twipr/direct_1_all.csv")
def test_a_robot_that_is_thrown_and_carried_has_no_fall_to_explain(shared: Path) -> None:
    with pytest.raises(InvalidLog, match="never on its wheels"):
        post_mortem(str(shared / "data/twipr/direct_1_all.csv"), "twipr")


@pytest.mark.parametrize("per_radian", [1.0, 260.0])
def test_a_robot_on_a_stand_whose_wheels_spin_up_does_not_balance(per_radian: float) -> None:
    """A first-order motor (0.08 s, 18 rad/s) under a body that only shakes by half a degree a second; in radians, and
    in counts of an unknown number to a turn. On a floor such wheels would turn any body by a radian a second."""
    n, rng = 150, np.random.Generator(np.random.Philox(7))
    t = T * np.arange(n)
    rate = np.where(t > 0.3, 18 * (1 - np.exp(-(t - 0.3) / 0.08)), 0.0) * per_radian
    channels = {GYRO: rng.normal(0, np.radians(0.5), n), PITCH: np.full(n, 0.05) + rng.normal(0, 1e-3, n)}
    channels |= {LEFT: np.cumsum(rate) * T, RIGHT: -np.cumsum(rate) * T}
    on = np.where(t > 0.3, 7.0, 0.0)
    found = doctor(Log(t, channels | {"applied/left": on, "applied/right": on}, {"applied/left": "V"}))
    assert [pose.kind for pose in found.segments] == ["held"]
    assert any("its wheels are off the floor" in str(finding.evidence) for finding in found.findings)
    assert "segment/none" in found.codes()


@cache
def driven() -> Log:
    """From rest to a speed of the wheels of 12 rad/s, and on at that speed, where the body rests."""
    robot = Robot.preset("nxtway-gs")
    drive = [Drive(speed=0.3, start=1.0, until=6.0)]
    return run(NonlinearBody(robot), lqg(robot, Kit.preset("nxt"), T), reference=drive, seconds=7.0, seed=2)


def shown(**sensors: np.ndarray) -> set[str]:
    """The poses of that run with these sensors."""
    log = driven()
    channels = {name: log[name] for name in (LEFT, RIGHT, "applied/left", "applied/right")}
    channels |= {name.replace("_", "/"): values for name, values in sensors.items()}
    found = doctor(Log(log.t, channels, {"applied/left": "V", "applied/right": "V"}))
    return {pose.kind for pose in found.segments}


def test_a_robot_that_drives_off_and_rolls_on_is_not_held() -> None:
    log = driven()
    assert np.abs(np.diff(log[LEFT])).max() / T > 10
    noise = np.random.Generator(np.random.Philox(5)).normal(0, 0.02, len(log))
    assert "held" not in shown(sensor_gyro=log[GYRO] + noise)


def test_a_gyro_about_another_axis_beside_a_tilt_is_no_robot_on_a_stand() -> None:
    """The noise of an axis that does not turn is a body at rest; the tilt of the same log shows that it turns."""
    log = driven()
    rolled = np.random.Generator(np.random.Philox(9)).normal(0, 0.005, len(log))
    assert "held" in shown(sensor_gyro=rolled)
    assert "held" not in shown(sensor_gyro=rolled, estimate_pitch=log["truth/pitch"] + 0.01)


def test_a_fall_begins_with_its_push_and_is_dated_where_programs_stop() -> None:
    """Pushed at 5 s, and quiet before; it has fallen where the sum of its gyro from there on passes 0.8 rad, to a few
    rows."""
    log = example("fall")
    lean = np.cumsum(np.where(log.t >= 5.0, log["sensor/gyro"], 0.0)) * log.period
    fell = float(log.t[np.argmax(np.abs(lean) > 0.8)])
    found = doctor(log)
    (fall,) = [f for f in found.findings if f.code == "segment/fall"]
    assert fall.span is not None
    assert 5.0 <= fall.span[0] < fell
    (said,) = [line for line in map(str, found.page().lead) if "falls at" in line]
    told = float(said.replace("\u00a0", " ").split("falls at ")[1].split(" ")[0])
    assert told == pytest.approx(fell, abs=0.03)
    assert found.repaired().t[-1] == pytest.approx(4.9, abs=0.05)  # the quiet rows before the push are kept


@pytest.mark.parametrize(("scale", "missing"), [(1000.0, False), (1.0, True)])
def test_a_fall_is_dated_by_the_repaired_clock(scale: float, missing: bool) -> None:
    """A clock in milliseconds, and one that lacks a time: the fall is where that of the sound log is, to a row."""
    log = example("fall")
    table = table_of(log)
    t = scale * log.t
    t[len(t) // 2] = np.nan if missing else t[len(t) // 2]
    found = doctor(replace(table, columns={**table.columns, "t": t}))
    assert found.fell_at == pytest.approx(doctor(log).fell_at, abs=log.period)
    assert any("falls at" in str(line) for line in found.page().lead)


@pytest.mark.needs("shared/cases/motors-off")
@pytest.mark.parametrize("name", ["freefall", "wrap"])
def test_of_motors_that_are_off_a_standstill_is_no_error(name: str, shared: Path) -> None:
    """README of shared/cases: both motors are off in every row."""
    found = doctor(shared / "cases" / "motors-off" / f"{name}.csv")
    assert "segment/motors-off" in found.codes()
    assert not [f for f in found.findings if f.severity == "error"]


def test_wheels_that_turn_under_commands_of_zero_do_not_excuse_them() -> None:
    log = example("excited")
    still = {name: np.zeros(len(log.t)) for name in log.channels if name.startswith(("command/", "applied/"))}
    codes = [(f.code, f.channel) for f in doctor(Log(log.t, dict(log.channels) | still, log.units)).findings]
    assert any(code == "channel/constant" and channel.startswith(("command/", "applied/")) for code, channel in codes)


@pytest.mark.needs("shared/cases/motors-off")
def test_the_post_mortem_sees_the_fall_of_a_log_without_wheels_and_motors(shared: Path) -> None:
    """Its pitch estimate is above 57 degrees in the last half second, and passes 46 in between."""
    source = shared / "cases" / "motors-off" / "freefall.csv"
    rows = np.loadtxt(source, delimiter=",", skiprows=1)
    passed = 1e-3 * rows[np.argmax(rows[:, 2] > math.degrees(0.8)), 1]
    found = post_mortem(source, "nxtway-gs")
    assert found.fell_at == pytest.approx(passed, abs=0.1)  # its rate is made of that angle, whose zero is not known
