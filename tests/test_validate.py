"""A validation says how well known numbers predict a log, and which of them is wrong, whatever was planted."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import upright as up
from heads import shown_alike
from upright.cli.main import main
from upright.control import lqg, lqr_state
from upright.control.excited import Excited, random_binary
from upright.control.files import write_controller
from upright.errors import UprightError
from upright.logs.marks import known_fraction, marks_of
from upright.pages import html
from upright.physics.dynamics import derivative
from upright.robots import FittedLog, Kit, Motor, Robot
from upright.validation.drawn import half_second_figure
from upright.validation.fits import LogJudged
from upright.validation.law import LinearLaw, law_of, recorded
from upright.validation.validation import Validation

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")


@cache
def log_of(kind: str = "") -> up.Log:
    """Five seconds of an excited robot: the preset's, or one with a planted fault."""
    robot, kit = ROBOT, KIT
    if kind == "resistance":
        robot = robot.replace(motor_resistance=1.6 * robot.motor_resistance)
    if kind == "gyro":
        gyro = replace(kit.sensors["sensor/gyro"], delay=kit.sensors["sensor/gyro"].delay + 0.012)
        kit = replace(kit, sensors={**kit.sensors, "sensor/gyro": gyro})
    controller = Excited(lqg(ROBOT, KIT, KIT.period), random_binary(1000, 1.0, seed=5, hold=6))
    body = up.Electronics(up.NonlinearBody(robot, period=0.001), kit)
    log = up.run(body, controller, seconds=5.0, seed=2)
    if kind == "excited":  # and says so in the log
        added = random_binary(1000, 1.0, seed=5, hold=6)[: len(log)]
        channels = {"excitation/left": added[:, 0], "excitation/right": added[:, 1]}
        log = up.Log(log.t, {**log.channels, **channels}, log.units, log.origin)
    return log


@cache
def judged(kind: str = "") -> LogJudged:
    return up.validate(log_of(kind), ROBOT, KIT).logs[0]


def test_the_robot_that_made_the_log_predicts_it_and_needs_no_change() -> None:
    log = judged()
    assert log.worst.r2 > 0.9
    # half seconds leave what quantised readings and an uncertain first state leave: 2 % of the motion
    assert all(c.r2 > 0.97 and c.breaks is None for c in log.half_seconds if "compass" not in c.name)
    assert log.shifts == ()
    shown_alike(Validation(robot="mine", kit="", logs=(log,)))


def test_a_sensor_that_never_changes_is_named_in_the_verdict() -> None:
    """What is left out of a verdict is said in it: the plug of one encoder is out."""
    channel = "sensor/encoder_right"
    log = log_of()
    dead = up.Log(log.t, {**log.channels, channel: np.zeros(len(log))}, log.units, log.origin)
    result = up.validate(dead, ROBOT, KIT)
    assert result.verdict != "predicts"
    assert result.logs[0].dead == (channel,)
    assert "never changes: right encoder" in str(result)
    assert judged().dead == ()


def test_the_page_names_what_is_not_predicted_and_draws_it_first() -> None:
    """A gyro that half seconds miss, after perfect encoders: the headline, the first picture and the closed loop, which
    no law was known for, say so."""
    log = judged()
    fits = tuple(replace(c, r2=0.588 if c.name == "sensor/gyro" else 0.99) for c in log.half_seconds)
    log = replace(log, source="/a/b/run.csv", half_seconds=fits, law=None, loop=(), simulated=None, shifts=())
    page = Validation(robot="mine", kit="", logs=(log,)).page()
    head = page.head()
    assert head["title"] == "mine predicts run.csv, but not: gyro"
    assert head["verdict"]["level"] == "warn"
    assert head["numbers"][0][0] == "0.588"
    assert half_second_figure(log).axes[0].get_ylabel().startswith("gyro")
    assert "Not simulated: the controller is unknown" in html.document(page)


def test_a_loop_of_a_law_that_reads_estimates_is_not_taken_for_the_programs() -> None:
    """The program's Kalman filter reads coarse encoders and a noisy gyro: the true states are not what it computed."""
    foreign = replace_origin(log_of("excited"))
    log = up.validate(foreign, ROBOT, KIT).logs[0]
    assert log.estimates
    result = Validation(robot="", kit="", logs=(log,))
    assert result.lost is None
    assert "does not judge the robot" in html.document(result.page())
    given = up.validate(foreign, ROBOT, KIT, lqg(ROBOT, KIT, KIT.period)).logs[0]
    assert given.estimates == ()


def test_the_free_loop_reads_nothing_of_the_log_where_one_encoder_stands_for_both() -> None:
    """Both wheels turn alike, so one encoder is simulated: the law must not read the log's other one. The scenario
    pushes at 3.0 s for 10 ms; in the simulation, which gets no push, the gyro stays what it was."""
    controller = lqg(ROBOT, KIT, KIT.period)
    body = up.Electronics(up.NonlinearBody(ROBOT, period=0.001), KIT)
    log = up.run(body, controller, up.Impulse(impulse=0.06, start=3.0), seconds=5.0, seed=2)
    both = log["sensor/encoder_left"]
    log = up.Log(log.t, {**log.channels, "sensor/encoder_right": both}, log.units, log.origin)
    result = up.validate(log, ROBOT, KIT, controller)
    loop = result.logs[0].simulated
    assert loop is not None
    assert loop.fell_at is None  # without noise and push a designed loop stands
    assert [start for start, _ in loop.pushes] == [3.0]
    gyro = loop.simulated[:, loop.names.index("sensor/gyro")]
    before, after = (np.nanmax(np.abs(gyro[rows])) for rows in (loop.t < 2.9, loop.t > 3.0))
    assert after < 2 * before + 0.02  # the knock is worth 0.5 rad/s and more; the gyro's step is 0.017
    assert result.lost is not None
    assert 3.0 <= (result.lost.breaks or 0.0) < 3.5  # a push shows in some reading within half a second


def test_the_free_loop_gets_no_odd_reading_of_the_log() -> None:
    """A bad cable gives 8 rad/s for a row, ten times what the gyro reads here: no fit reads it, and the law neither."""
    log = log_of("excited")
    gyro = log["sensor/gyro"].copy()
    gyro[[150, 330]] = 8.0
    odd = up.Log(log.t, {**log.channels, "sensor/gyro": gyro}, log.units, log.origin)
    controller = lqg(ROBOT, KIT, KIT.period)
    whole, broken = (up.validate(one, ROBOT, KIT, controller).logs[0] for one in (log, odd))
    assert whole.simulated is not None
    assert broken.simulated is not None
    assert any("sensor/gyro: 2" in str(note) for note in broken.notes)
    pitch = whole.simulated.names.index("estimate/pitch")
    apart = np.abs(whole.simulated.simulated[:, pitch] - broken.simulated.simulated[:, pitch])
    assert np.nanmax(apart) < 0.01  # the first state is fitted anew; 8 rad/s for 10 ms are 0.08 rad
    assert np.nanmax(np.abs(whole.simulated.simulated[:, pitch])) > 0.02


def test_half_seconds_that_hold_a_push_are_left_out_and_counted() -> None:
    """A slope of 0 and a force of a hundredth of a second: of ten half seconds the one that holds 2.2 s."""
    log = log_of()
    force = np.where((log.t >= 2.2) & (log.t < 2.21), 5.0, 0.0)
    pushed = up.Log(log.t, {**log.channels, "push/force": force}, log.units, log.origin)
    result = up.validate(pushed, ROBOT, KIT).logs[0]
    parts = result.segments
    ends = [parts.when[parts.segment == n][[0, -1]] for n in np.unique(parts.segment)]
    assert not any(start <= 2.2 <= stop for start, stop in ends)
    whole = judged().segments
    assert len(ends) == len(np.unique(whole.segment)) - 1
    assert (result.pushed, result.halves) == (1, len(ends) + 1)


@cache
def fitted_to(part: str) -> Validation:
    """The robot, whose file says that it was fitted to the first three quarters of a log, or to another log."""
    log = log_of("gyro" if part == "another" else "")
    rows = log.between(0.0, 3.75)
    robot = replace(ROBOT, fitted=(FittedLog("run.csv", 0.0, 3.75, marks_of(rows)),))
    return up.validate(log_of(), robot, KIT)


def test_a_log_of_the_robots_own_fit_is_said_to_be_no_test() -> None:
    own, other = fitted_to("first"), fitted_to("another")
    assert own.logs[0].fitted == pytest.approx(0.75, abs=0.2)  # 32 marks: two deviations are 0.15, and windows overlap
    assert other.logs[0].fitted == 0
    assert judged().fitted is None  # a preset does not say
    pages = [result.page() for result in (own, other)]
    assert [page.verdict.level for page in pages if page.verdict] == ["warn", "good"]
    assert ["served to fit" in str(page.lead[-1]) for page in pages] == [True, True]
    assert [str(page.lead[-1]).startswith("A test") for page in pages] == [False, True]
    assert [page.next[0].verb for page in pages] == ["validate", "design"]


def test_marks_know_rows_again_in_another_file_and_in_a_part(tmp_path: Path) -> None:
    """What is kept of 375 rows says which fraction of another log they are: all of a part, none of another run."""
    log = log_of()
    marks = marks_of(log.between(0.0, 3.0))
    for name in ("run.csv", "run.parquet"):
        copy = up.Log.load(log.between(0.0, 3.0).save(tmp_path / name))
        assert known_fraction(copy, [marks]) == 1.0
    assert known_fraction(log.between(1.0, 2.0), [marks]) == 1.0
    assert known_fraction(log.between(3.0, 5.0), [marks]) == 0.0
    assert known_fraction(log_of("resistance"), [marks]) == 0.0
    quiet = up.Log(log.t, {"sensor/gyro": np.zeros(len(log)), "sensor/encoder_left": np.round(log.t)}, {})
    assert marks_of(quiet) == ()  # what hardly moves looks alike in many logs


def test_a_log_of_ours_names_its_controller() -> None:
    """The program of the log, filter and all, gives its commands again; where the log lies about it, it does not."""
    log = log_of("excited")
    law = recorded(log)
    assert law is not None
    assert "names (lqg" in str(law.name)
    wrong = {name: -values if name.startswith("command/") else values for name, values in log.channels.items()}
    assert recorded(up.Log(log.t, wrong, log.units, log.origin)) is None
    assert recorded(replace_origin(log)) is None


def replace_origin(log: up.Log) -> up.Log:
    """The log as if another program had written it."""
    return up.Log(log.t, dict(log.channels), log.units)


def test_planted_faults_are_what_would_have_to_move() -> None:
    # a winding of 1.6 times the resistance is one whose gain and damping are smaller: several numbers say so
    moved = {shift.name: shift for shift in judged("resistance").shifts}
    assert moved["torque_constant"].proposed < moved["torque_constant"].value
    gyro = judged("gyro").shifts[0]
    assert gyro.name == "delay/gyro"
    # one Gauss–Newton step goes most of the planted 12 ms, not all
    assert 0.004 < gyro.proposed - gyro.value < 0.02


def test_what_belongs_to_a_run_is_distinguished_from_the_robot() -> None:
    """A program that reads its gyro 12 ms late is of this run: fitted to it, the half seconds are those of a robot that
    is known, and every effect but this one stays within the spread that runs usually have."""
    log = judged("gyro")
    assert min(c.r2 for c in log.own_run if "compass" not in c.name) > 0.97 > log.worst.r2
    moved = {e.name: e.here - e.known for e in log.effects}
    assert moved["delay/gyro"] == pytest.approx(0.012, abs=0.001)
    assert abs(moved["motor_resistance"]) < 0.05 * ROBOT.motor_resistance
    assert "fitted to this run" in str(Validation(robot="", kit="", logs=(log,)))
    assert judged().own_run == ()  # a log that is predicted asks for nothing


def test_the_law_is_read_from_the_log_or_from_its_file(tmp_path: Path) -> None:
    controller = lqg(ROBOT, KIT, KIT.period)
    log = log_of()
    whole = log_of("excited")
    read = law_of(whole, ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro"))
    assert isinstance(read, LinearLaw)
    assert read.explained > 0.9999  # u = −K x̂ + excitation, and x̂ is in the log
    assert not isinstance(law_of(log, ("sensor/gyro",)), LinearLaw)  # without the excitation, which nobody logged
    path = write_controller(controller, tmp_path / "c.json")
    given = up.validate(whole, ROBOT, KIT, path).logs[0]
    assert min(c.r2 for c in given.loop if "gyro" in c.name) > 0.8


LATE, STEP, EVERY = 0.03, 0.001, 10  # [s] of all sensors, [s] of the integration, steps in a row


def log_of_late_estimates() -> up.Log:
    """The equations by Runge and Kutta's formula under a state feedback, all of whose sensors are `LATE`; its pitch is
    what a program without a model has: as late as they are."""
    robot, gains = ROBOT, lqr_state(ROBOT, KIT.period).gain[0]
    rows, late = 400, round(LATE / STEP)
    added = random_binary(rows, 1.0, seed=3, hold=6)
    past, table = [np.array([0.03, 0.0, 0.0, 0.0, 0.0, 0.0])], list[list[float]]()

    def rate(x: np.ndarray, u: float) -> np.ndarray:
        return np.array(derivative(x.tolist(), (u, u), robot))

    for row in range(rows):
        seen = past[max(0, len(past) - 1 - late)]
        u = float(-gains[:4] @ seen[:4]) + float(added[row, 0])
        encoder = seen[2] - seen[0]
        table.append([encoder, encoder, seen[1], seen[0], u, u])
        for _ in range(EVERY):
            x = past[-1]
            a = rate(x, u)
            b = rate(x + STEP / 2 * a, u)
            c = rate(x + STEP / 2 * b, u)
            past.append(x + STEP / 6 * (a + 2 * b + 2 * c + rate(x + STEP * c, u)))
    names = ("sensor/encoder_left", "sensor/encoder_right", "sensor/gyro", "estimate/pitch", "command/left",
             "command/right")  # fmt: skip
    channels = dict(zip(names, np.array(table).T, strict=True))
    channels |= {"excitation/left": added[:, 0], "excitation/right": added[:, 0]}
    return up.Log(np.arange(rows) * EVERY * STEP, channels)


def test_a_law_reads_an_estimate_as_late_as_the_sensors_that_it_is_made_of() -> None:
    """The log is exact, so its own robot and law follow its pitch to the end. (Its wheels are held by a sum of the gyro
    in the law that is read, and drift.) With the present pitch, which is 30 ms younger, R² would be 0.7 and 0.4."""
    sensors = {n: replace(s, delay=LATE, noise=0.0, quantum=0.0, bias=0.0) for n, s in KIT.sensors.items()}
    kit = replace(KIT, sensors=sensors, delay=0.0, jitter=0.0, motor=Motor())
    log = up.validate(log_of_late_estimates(), ROBOT, kit).logs[0]
    assert "estimate/pitch" in str(log.law)
    assert log.simulated is not None
    assert log.simulated.fell_at is None
    r2 = {c.name: c.r2 for c in log.loop}
    assert min(r2["sensor/gyro"], r2["estimate/pitch"]) > 0.99  # the first state is fitted to half a second, not known


def test_a_law_that_is_not_linear_is_said_to_be_unknown() -> None:
    log = log_of()
    names = [n for n in log.channels if n.startswith(("sensor/encoder", "sensor/gyro", "applied/"))]
    rng = np.random.default_rng(1)
    signs = np.sign(rng.standard_normal((len(log), 2)))
    channels = {n: log[n] for n in names} | {"command/left": signs[:, 0], "command/right": signs[:, 1]}
    result = up.validate(up.Log(log.t, channels, log.units), ROBOT, KIT).logs[0]
    assert not result.loop
    assert result.law is None
    assert result.explained < 0.99


def test_the_command_gives_a_verdict_a_page_and_json(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = log_of("gyro").save(tmp_path / "run.parquet")
    page = tmp_path / "page.html"
    assert main(["validate", "nxtway-gs", str(path), "--json", "--report", str(page)]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["verdict"] in ("predicts", "predicts in part", "does not predict")
    assert "measured" in page.read_text()
    assert "predicted" in page.read_text()
    assert main(["validate", "nxtway-gs", str(tmp_path / "none.csv")]) == 2
    assert main(["validate", "no-such-robot", str(path)]) == 2


def test_a_controller_of_another_period_is_refused(tmp_path: Path) -> None:
    slow = write_controller(lqg(ROBOT, KIT, 0.02), tmp_path / "slow.json")
    with pytest.raises(UprightError, match="20 ms"):
        up.validate(log_of(), ROBOT, KIT, slow)


@pytest.mark.needs("shared/data/twipr")
def test_the_free_closed_loop_of_a_real_robot(shared: Path) -> None:
    """The law is in the log (k1 v + k2 pitch + k3 rate ± k4 yaw rate + excitation); the robot is the preset."""
    result = up.validate(shared / "data" / "twipr" / "run1.csv", "twipr").logs[0]
    assert "estimate/pitch" in str(result.law)
    assert result.loop
