"""The lab's session: bodies side by side under pushes, without any server."""

from __future__ import annotations

import math
import time
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.calibration.annealing import lost
from upright.certification.design import design
from upright.control import CONTROLLERS, ControllerSpec, lqg
from upright.errors import InvalidLog
from upright.experiment import Hold, run
from upright.lab.codec import decode, encode
from upright.lab.desk import LASTING, InlineDesk, ProcessDesk
from upright.lab.display import KEPT
from upright.lab.messages import (
    Analysed,
    Broadcast,
    Change,
    Changed,
    Drag,
    History,
    JobResult,
    Light,
    Made,
    Notice,
    Play,
    Recall,
    Recovered,
    Save,
    Scrub,
    Setup,
    StandUp,
    Start,
    Steer,
    Step,
    Strike,
)  # fmt: skip
from upright.lab.plant import COARSE, FINE, Pulled, families, is_slow, loaded
from upright.lab.pushing import Pushing
from upright.lab.ring import Ring
from upright.lab.session import Session
from upright.lab.spoken import parts_of
from upright.lab.tasks import TASKS
from upright.lab.uploads import Uploaded
from upright.lab.views import catalogue
from upright.languages import speaking
from upright.logs.recording import check_unit
from upright.physics.dynamics import Disturbance, derivative, mass_matrix
from upright.physics.linear import unstable_pole
from upright.robots import Kit, Robot
from upright.signals import Log

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
MODEL = Setup(bodies=("nonlinear",))
LIGHT, LIT = TASKS["light"], replace(MODEL, bodies=("twin",), payload_height=0.0)
"""The task of the light, and what a session asks it of `MODEL`."""


def a_session(tmp_path: Path, setup: Setup = MODEL, **options: object) -> tuple[Session, InlineDesk]:
    """A session of coarse steps, as in a class, where a test does not ask for fine ones."""
    desk = InlineDesk()
    return Session(setup, desk, tmp_path, name="s", **({"fine": COARSE} | options)), desk  # type: ignore[arg-type]


def attended(session: Session, desk: InlineDesk) -> list[object]:
    """All that the session says once its desk has done everything."""
    while words := desk.poll():
        for (_, job), status, result in words:
            session.reported(job, status, result)
    return session.events()


def only(kind: type, events: list[object]) -> list:
    return [event for event in events if isinstance(event, kind)]


def test_a_session_is_the_loop_of_run(tmp_path):
    """Pushed by name, the lab records bit for bit what `run` records of the same body, controller, push and seed."""
    session, _ = a_session(tmp_path, replace(MODEL, seed=3), fine=FINE)
    session.handle(Strike("front", 0.1))
    for _ in range(50):
        session.advance(0.04)
    log = session.logs()["nonlinear"]
    body = Electronics(NonlinearBody(ROBOT, period=FINE), KIT)
    same = run(body, lqg(ROBOT, KIT, KIT.period), Hold(pitch=0.1, until=3.0), seconds=2.0, seed=3)
    assert len(log) == len(same) == 200  # 2 s of 10 ms
    for name in same.channels:
        assert np.array_equal(log[name], same[name]), name


def test_the_same_messages_give_the_same_robots(tmp_path):
    def played() -> list[object]:
        session, _ = a_session(tmp_path, Setup())
        seen = []
        for message in (
            Drag(1.0, 0.07),
            Drag(0.0, 0.0),
            Steer(0.2, 0.5),
            Change(Setup(controller="lqi")),
            StandUp(0.05),
        ):
            session.handle(message)
            session.advance(0.3)
            seen.append(session.snapshot())
        return seen

    assert played() == played()


@pytest.mark.parametrize("bodies", [("twin",), ("nonlinear",), ("linear",)])
@pytest.mark.parametrize("force", [1.0, -1.0])
def test_a_push_from_behind_leans_the_robot_forward_at_first(tmp_path, bodies, force):
    session, _ = a_session(tmp_path, Setup(bodies=bodies))
    session.handle(Drag(force, ROBOT.com_height))
    session.advance(0.05)
    pitch, wheel = session.snapshot().x[0][0], session.snapshot().x[0][2]
    assert math.copysign(1, pitch) == force
    assert abs(wheel) > 0


def test_a_tug_is_a_force_at_one_end_of_the_axle(tmp_path):
    """At rest without a controller: ψ̈ and θ̈ of that force at the axle, and φ̈ = −F W/2 over the yaw inertia."""
    dt = 1e-5  # [s] the fastest pole is −270 1/s: rates are accelerations times dt to half of 2.7 permille
    body = Pulled(NonlinearBody(ROBOT, period=dt))
    body.pull(0.5)
    found = body.step((0.0, 0.0), Disturbance(0.5, 0.0, 0.0))
    _, pitch_acc, _, wheel_acc, _, _ = derivative((0.0,) * 6, (0.0, 0.0), ROBOT, Disturbance(0.5, 0.0, 0.0))
    yaw_acc = -0.5 * ROBOT.track / 2 / mass_matrix(1.0, 0.0, ROBOT)[3]
    assert found.values[[1, 3, 5]] / dt == pytest.approx([pitch_acc, wheel_acc, yaw_acc], rel=0.002)
    assert found.applied == (0.0, 0.0)  # nobody commanded anything


def test_the_two_wheels_are_tugged_alike(tmp_path):
    turns = []
    for what in ("pull_left", "pull_right"):
        session, _ = a_session(tmp_path, replace(MODEL, controller="off", kit="ideal"))
        session.handle(Strike(what, 0.5))
        session.handle(Step(1))
        turns.append(session.lanes[0].state()[5])
    assert turns[0] == -turns[1] < 0  # pulled on its left it turns clockwise


def test_a_payload_shifts_mass_and_inertia_by_the_parallel_axes():
    heavier = loaded(ROBOT, 0.2, 0.3)
    about_axle = ROBOT.pitch_inertia + ROBOT.body_mass * ROBOT.com_height**2 + 0.2 * 0.3**2
    mass = heavier.body_mass * heavier.com_height
    assert heavier.body_mass == pytest.approx(ROBOT.body_mass + 0.2)
    assert mass == pytest.approx(ROBOT.body_mass * ROBOT.com_height + 0.2 * 0.3)
    assert heavier.pitch_inertia + heavier.body_mass * heavier.com_height**2 == pytest.approx(about_axle)
    assert loaded(ROBOT, 0.0, 0.3) is ROBOT


def test_the_payload_is_unknown_to_controller_and_linear_model(tmp_path):
    session, _ = a_session(tmp_path, Setup(bodies=("nonlinear", "linear"), payload=0.1))
    plain, _ = a_session(tmp_path, Setup(bodies=("nonlinear", "linear")))
    kinds = [lane.controller.to_json() for lane in (*session.lanes, *plain.lanes)]
    assert all(kind == kinds[0] for kind in kinds)
    assert session.lanes[1].body.spec.robot == ROBOT
    assert session.lanes[0].body.spec.robot.body_mass == pytest.approx(ROBOT.body_mass + 0.1)


@pytest.mark.parametrize("family", ["lqi", "lqr-complementary", "mpc", "sliding", "pid"])
def test_the_controller_can_be_changed_while_it_stands(tmp_path, family):
    """Far from where it was switched on, turned and rolling, it takes the new controller without falling or jumping."""
    session, desk = a_session(tmp_path, certified=False)
    session.handle(Steer(0.2, 1.0))
    session.advance(1.0)
    session.advance(1.0)
    session.handle(Steer(0.0, 0.0))
    session.advance(1.0)
    before = session.snapshot().x[0]
    session.handle(Change(replace(MODEL, controller=family)))
    attended(session, desk)
    after = session.snapshot().x[0]
    assert before[2] > 5  # 0.4 m over a wheel of 0.04 m: ten radians, less what it is behind
    assert after[:6] == before[:6]
    for _ in range(3):
        session.advance(1.0)
        assert abs(session.lanes[0].state()[0]) < 0.3  # the paper's pushes lean it by 0.12
    assert abs(session.lanes[0].state()[2] - before[2]) < 5


def test_a_slow_design_is_made_beside_the_loop(tmp_path):
    session, desk = a_session(tmp_path, certified=False)
    session.handle(Change(replace(MODEL, controller="pid")))
    assert session.lanes[0].controller.spec.kind == "lqg"
    assert only(Changed, session.events())[-1].busy
    events = attended(session, desk)
    assert session.lanes[0].controller.spec.kind == "pid"
    assert not only(Changed, events)[-1].busy
    assert only(Analysed, events)[-1].stable


def test_weights_and_gains_reach_the_controller(tmp_path):
    stricter = replace(MODEL, controller="lqr", largest=(0.05, 1.5, 4.0, 15.0, 0.5, 3.0, 4.0))
    session, desk = a_session(tmp_path, stricter, certified=False)
    plain, other = a_session(tmp_path, replace(MODEL, controller="lqr"), certified=False)
    strict, usual = (only(Analysed, attended(*pair))[0].gain[0][0] for pair in ((session, desk), (plain, other)))
    assert strict < usual < 0  # less lean is accepted, so more voltage answers it
    by_hand = replace(MODEL, controller="gains", gains=(-27.0, -2.4, -0.46, -1.07, -4.7, -0.2))
    hand, desk = a_session(tmp_path, by_hand, certified=False)
    analysed = only(Analysed, attended(hand, desk))[0]
    assert analysed.gain[0] == by_hand.gains
    assert analysed.heads["en"].verdict.startswith("stable")


def test_margins_are_judged_as_the_page_of_a_design_does(tmp_path):
    """One judgement: the same title, verdict and numbers, in both languages."""
    session, desk = a_session(tmp_path, replace(MODEL, controller="lqg"), certified=False)
    heads = only(Analysed, attended(session, desk))[-1].heads
    page = design("lqg", ROBOT, kit=KIT).page()
    assert page.verdict
    for language, head in heads.items():
        with speaking(language):
            assert (head.title, head.verdict) == (str(page.title), str(page.verdict.text))
            assert head.numbers[:2] == tuple((str(one.value), str(one.meaning)) for one in page.numbers[:2])


@cache
def usual_light() -> tuple[Light, list[tuple[float, int]]]:
    """That of `LIT`, and what was told of it meanwhile."""
    told: list[tuple[float, int]] = []
    return LIGHT(lambda fraction, runs=0: told.append((fraction, runs)), LIT), told


def test_the_light_follows_and_a_spoilt_gain_is_red(tmp_path, monkeypatch):
    monkeypatch.setitem(TASKS, "light", lambda *args: usual_light()[0] if args[1] == LIT else LIGHT(*args))
    session, desk = a_session(tmp_path)
    lit = only(Light, attended(session, desk))[-1]
    assert lit.light == "green"
    assert {language: head.verdict.partition(":")[0] for language, head in lit.heads.items()} == {
        "en": "Green", "es": "Verde",
    }  # fmt: skip
    session.handle(Change(replace(MODEL, controller="gains", gains=(-3.0, 0.0, 0.0, 0.0, 0.0, 0.0))))
    events = attended(session, desk)
    assert [lit.light for lit in only(Light, events)] == ["none", "red"]  # gravity alone asks for more than 3 V/rad
    assert not only(Analysed, events)[-1].stable


def test_without_a_controller_the_lean_doubles_as_the_unstable_pole_says(tmp_path):
    """ψ of the falling mode grows as e^{λt}; the linear body in it leaves no other mode."""
    from upright.physics.linear import linearise

    session, _ = a_session(tmp_path, Setup(controller="off", kit="ideal", bodies=("linear",)))
    poles, modes = np.linalg.eig(linearise(ROBOT).A)
    mode = np.real(modes[:, np.argmax(poles.real)])
    session._build((mode / mode[0] * 1e-3).tolist())
    session.advance(math.log(2) / unstable_pole(ROBOT) - 1e-9)
    periods = math.floor(math.log(2) / unstable_pole(ROBOT) / KIT.period)
    assert session.lanes[0].state()[0] == pytest.approx(1e-3 * math.exp(unstable_pole(ROBOT) * periods * KIT.period))


def test_the_tour_asks_for_a_doubling_that_the_pole_explains(tmp_path):
    """From rest the first doubling of the second step is slow; the one from 0.1 to 0.2 rad takes ln 2 / λ, to a
    twentieth: by then e^{−λt} is below a hundredth of e^{λt}, and the sine of 0.2 rad is short by less than a
    hundredth."""
    session, _ = a_session(tmp_path, Setup(controller="off", bodies=("twin", "nonlinear", "linear")))
    session.handle(StandUp(0.02))
    rows = []
    for _ in range(50):
        rows.append([session.t, *(lane.state()[0] for lane in session.lanes)])
        session.handle(Step(1))
    t, *bodies = np.array(rows).T
    doubling = math.log(2) / unstable_pole(ROBOT)
    for pitch in bodies:
        first, low, high = np.interp(np.log([0.04, 0.1, 0.2]), np.log(np.maximum.accumulate(np.abs(pitch))), t)
        assert high - low == pytest.approx(doubling, rel=0.05)
        assert first > 1.5 * doubling


@pytest.mark.parametrize("waits", [50, 203])
def test_the_tour_says_truly_that_the_payload_makes_the_ghost_fall(tmp_path, waits):
    """At 0.3 N s from rest the linear ghost alone falls, which bears it without the payload: the knock hits it at the
    height of the laden robot's centre of mass and turns it at least twice as fast."""
    usual = Setup(controller="lqr", bodies=("nonlinear", "linear"))
    rates = []
    for setup, falls in ((usual, set()), (replace(usual, payload=0.2, payload_height=0.3), {"linear"})):
        session, _ = a_session(tmp_path, setup)
        session.handle(StandUp(0.0))
        session.handle(Step(waits))
        session.handle(Strike("impulse", 0.3))
        session.handle(Step(2))  # as long as a knock takes
        rates.append(abs(session.lanes[1].state()[1]))
        session.handle(Step(800))
        assert {lane.name for lane in session.lanes if lane.fallen} == falls
    assert rates[1] > 2 * rates[0]


def test_the_light_counts_its_runs():
    """300 robots under each of three pushes on each of two batteries (docs/certificate.md), the file's robot alone four
    times, and all 300 alone; all are done at the end."""
    _, told = usual_light()
    parts = np.cumsum([0, *[300] * 6, 4, 300])
    assert {runs for _, runs in told} == {parts[-1]}
    assert [fraction for fraction, _ in told] == pytest.approx(parts / parts[-1])


def test_a_fallen_robot_lies_still_until_it_is_stood_up(tmp_path):
    session, _ = a_session(tmp_path, replace(MODEL, controller="off"))
    session.handle(StandUp(0.3))
    for _ in range(4):
        session.advance(1.0)
    lying = session.snapshot()
    assert lying.x[0][8] == 1
    assert lying.x[0][0] == pytest.approx(1.5)
    session.advance(1.0)
    assert session.snapshot().x == lying.x
    session.handle(StandUp(0.0))
    assert session.snapshot().x[0][8] == 0


def test_pause_step_slow_motion_and_scrub(tmp_path):
    session, _ = a_session(tmp_path)
    session.handle(Strike("impulse", 0.05))
    session.advance(1.0)
    session.advance(0.5)
    session.handle(Play(True))
    session.advance(1.0)
    assert session.t == pytest.approx(1.5)
    session.handle(Step(3))
    assert session.t == pytest.approx(1.53)
    session.handle(Scrub(1.2))
    seen = session.snapshot()
    assert seen.t == pytest.approx(0.33)
    assert seen.back == pytest.approx(1.2)
    assert seen.x[0][0] == pytest.approx(session.logs()["nonlinear"]["truth/pitch"][33], abs=1e-4)  # four decimals
    session.handle(Play(False, 0.25))
    assert session.speed == 0.25
    assert session.snapshot().t == pytest.approx(1.53)


def test_the_last_minute_is_kept_and_no_more():
    ring = Ring(100, 2)
    with pytest.raises(IndexError):
        ring.back(0)
    for i in range(250):
        ring.append([i, -i])
    assert len(ring) == 100
    assert ring.rows()[:, 0].tolist() == list(range(150, 250))
    assert ring.rows(7)[-1, 0] == 249
    assert [ring.back(k)[0] for k in (0, 5, 99, 1000)] == [249, 244, 150, 150]
    assert KEPT == 60  # [s] as promised


def test_driving_goes_where_it_is_sent(tmp_path):
    session, _ = a_session(tmp_path)
    session.handle(Steer(0.2, 0.5))
    for _ in range(4):
        session.advance(1.0)
    session.handle(Steer(0.0, 0.0))
    for _ in range(4):
        session.advance(1.0)
    x = session.lanes[0].state()
    assert x[2] * ROBOT.wheel_radius == pytest.approx(0.8, abs=0.08)  # 4 s of 0.2 m/s; lqg keeps no integral
    assert x[4] == pytest.approx(2.0, abs=0.2)  # 4 s of 0.5 rad/s, anticlockwise


def test_a_recovered_knock_is_scored_by_its_impulse(tmp_path):
    session, _ = a_session(tmp_path)
    session.handle(Strike("impulse", 0.06))
    for _ in range(6):
        session.advance(1.0)
    (found,) = only(Recovered, session.events())
    assert found.impulse == pytest.approx(0.06)  # as it was struck: nothing else pushed
    assert not found.fell
    assert found.best == found.impulse
    session.handle(Strike("impulse", 3.0))  # far more than it stands
    for _ in range(4):
        session.advance(1.0)
    (lost,) = only(Recovered, session.events())
    assert lost.fell
    assert lost.best == found.best


@pytest.mark.parametrize(
    "first",
    [Strike("impulse", 0.05), Drag(1.0, 0.1), Strike("front", 0.1), Strike("pull_left", 1.0), StandUp(0.1)],
    ids=lambda message: type(message).__name__,
)
def test_a_push_before_it_has_recovered_sets_no_record(tmp_path, first):
    """It is less than a second, the shortest recovery, after something else; the same knock alone is a record."""
    session, _ = a_session(tmp_path)
    session.handle(first)
    session.advance(0.3)
    session.handle(Drag(0.0, 0.1))
    session.handle(Strike("impulse", 0.05))
    for _ in range(8):
        session.advance(1.0)
    assert not session.lanes[0].fallen
    assert not any(found.single for found in only(Recovered, session.events()))
    assert (session.score.best, session.result().best) == (0.0, 0.0)
    session.handle(Strike("impulse", 0.05))
    for _ in range(6):
        session.advance(1.0)
    (found,) = only(Recovered, session.events())
    assert (found.single, found.impulse, found.best) == (True, pytest.approx(0.05), pytest.approx(0.05))


def test_what_another_controller_recovers_from_is_nobody_s_record(tmp_path):
    session, _ = a_session(tmp_path)
    session.handle(Strike("impulse", 0.05))
    session.advance(0.2)
    session.handle(Change(replace(MODEL, controller="lqi")))
    for _ in range(6):
        session.advance(1.0)
    assert not session.lanes[0].fallen
    assert not only(Recovered, session.events())
    assert session.score.best == 0


@pytest.mark.parametrize("period", [0.002, 0.008, 0.01, 0.015, 0.03])
def test_a_knock_has_the_size_that_was_asked_for_at_every_period(period):
    """Forces are asked for once in a period, and a knock of 20 ms need not be whole periods."""
    pushing = Pushing()
    pushing.strike(Strike("impulse", 0.4), 3 * period, period)
    forces = [pushing.at(k * period, 0.0, ROBOT)[0].force for k in range(40)]
    assert sum(forces) * period == pytest.approx(0.4)


def test_a_pull_at_a_wheel_is_no_knock(tmp_path):
    """It turns the robot, and says nothing of how hard a knock it bears."""
    session, _ = a_session(tmp_path)
    session.handle(Strike("pull_left", 1.5))
    for _ in range(5):
        session.advance(1.0)
    assert not session.lanes[0].fallen
    assert not only(Recovered, session.events())
    assert session.score.best == 0


def test_the_tour_says_truly_why_the_robot_stands_still_and_then_sways(tmp_path):
    """Of the usual robot before any push, and from 5 s after a knock on for 5 s. Its dead zone lets it stand still for
    a while; then both dead zone and noise make it sway: without one of them it sways less, by more than a quarter,
    and does not come to rest, either: 0.5 mrad is far more than what is left of a knock after 5 s."""

    def sway(**without: float) -> float:
        session, _ = a_session(tmp_path, replace(MODEL, seed=7, **without))  # type: ignore[arg-type]
        session.handle(Strike("impulse", 0.05))
        pitch: list[float] = []
        for k in range(40):
            session.advance(0.25)
            pitch += [session.lanes[0].state()[0]] if k >= 20 else []
        return float(np.sqrt(np.mean(np.square(pitch))))

    still, _ = a_session(tmp_path)
    for _ in range(6):
        still.advance(0.25)
    assert still.lanes[0].state()[:1] == [pytest.approx(0.0, abs=1e-3)]  # 1.5 s: its first lean, if any, is later
    assert set(still.lanes[0].applied) == {0.0}
    both, noiseless, answering = sway(), sway(noise=0.0), sway(dead_zone=0.0)
    assert both > 1.33 * max(noiseless, answering)
    assert min(noiseless, answering) > 5e-4


def test_a_hold_is_no_knock(tmp_path):
    session, _ = a_session(tmp_path)
    session.handle(Strike("front", 0.1))
    for _ in range(9):
        session.advance(1.0)
    assert not only(Recovered, session.events())
    assert session.score.best == 0


@pytest.mark.parametrize(
    "setup",
    [
        replace(MODEL, robot="nobody"), replace(MODEL, kit="nokit"), replace(MODEL, numbers={"body_mass": -1.0}),
        replace(MODEL, numbers={"mass": 1.0}), replace(MODEL, robot="twipr"), replace(MODEL, bodies=()),
        replace(MODEL, largest=(1.0,)), replace(MODEL, controller="gains", gains=(1.0,)),
        replace(MODEL, controller="lqr", largest=(0.0,) * 7), replace(MODEL, bodies=("calibrated",)),
    ],
)  # fmt: skip
def test_what_cannot_be_is_reported_and_changes_nothing(tmp_path, setup):
    """twipr is driven by torque, which the kit nxt does not give."""
    session, _ = a_session(tmp_path)
    session.events()
    before = session.lanes
    session.handle(Change(setup))
    (said,) = only(Notice, session.events())
    assert said.level == "error"
    assert "\n" not in said.parts["en"].came
    assert session.setup == MODEL
    assert session.lanes is before
    session.advance(0.1)


def test_files_of_the_run_can_be_read_again(tmp_path):
    session, desk = a_session(tmp_path, Setup(bodies=("nonlinear", "linear")), certified=False)
    with pytest.raises(AssertionError):
        assert session.logs()
    session.handle(Strike("impulse", 0.05))
    session.advance(1.0)
    for what in ("csv", "parquet", "controller", "robot"):  # pages take longer: see the next test
        session.handle(Save(what))
    names = {made.name for made in only(Made, attended(session, desk))}
    assert names == {"run.csv", "run.parquet", "controller.json", "robot.toml"}
    assert Log.load(tmp_path / "run.parquet") == session.logs()["nonlinear"]
    assert len(Log.load(tmp_path / "run.csv")) == 100
    assert Robot.load(tmp_path / "robot.toml") == ROBOT


def test_the_doctor_examines_the_run_and_an_uploaded_file(tmp_path):
    session, desk = a_session(tmp_path, certified=False)
    session.handle(Steer(0.2, 0.3))
    for _ in range(5):
        session.advance(1.0)
    session.handle(Start("doctor"))
    (found,) = only(JobResult, attended(session, desk))
    assert found.job == "doctor"
    session.handle(Save("csv"))
    attended(session, desk)
    (tmp_path / "run.csv").rename(tmp_path / "in-mine.csv")
    session.handle(Uploaded("log", str(tmp_path / "in-mine.csv")))
    (again,) = only(JobResult, attended(session, desk))
    assert again.heads["en"].verdict == found.heads["en"].verdict
    assert str(tmp_path) not in again.html["en"]  # where a server keeps its files is nobody's business
    assert "mine.csv" in again.heads["es"].title
    for path in ("../../etc/passwd", "/etc/passwd", "nothing.csv"):
        session.handle(Start("doctor", path))
        assert only(Notice, attended(session, desk))[0].level == "error"


def test_an_uploaded_robot_stands_there_with_its_numbers(tmp_path):
    session, desk = a_session(tmp_path, certified=False)
    mine = ROBOT.replace(name="mine", body_mass=0.7)
    mine.save(tmp_path / "in-mine.toml")
    session.handle(Uploaded("robot", str(tmp_path / "in-mine.toml")))
    attended(session, desk)
    assert session.plant.nominal == mine
    again, _ = a_session(tmp_path, session.setup)  # as a link would bring it back
    assert again.plant.nominal == mine


def test_a_calibrated_model_joins_as_a_further_trace(tmp_path):
    session, _ = a_session(tmp_path)
    learnt = ROBOT.replace(com_height=0.08)
    session.reported("calibrate", "done", (learnt, JobResult("calibrate", {}, {})))
    assert [lane.name for lane in session.lanes] == ["nonlinear", "calibrated"]
    assert session.lanes[1].body.spec.robot == learnt


def test_a_job_that_failed_says_why_part_by_part_in_each_language(tmp_path):
    """A log in volts opened for TWIPR, whose motors take torques."""
    session, _ = a_session(tmp_path)
    session.advance(1.0)
    with pytest.raises(InvalidLog) as wrong:
        check_unit(session.logs()["nonlinear"], "applied", Robot.preset("twipr"))
    session.reported("calibrate", "failed", parts_of(wrong.value))
    notice = only(Notice, session.events())[-1]
    assert (notice.job, notice.level) == ("calibrate", "error")
    english, spanish = notice.parts["en"], notice.parts["es"]
    assert english.expected == "N m, as those of 'twipr'"
    assert all(part in str(wrong.value) for part in (english.came, english.expected, english.likely, english.hint))
    assert "twipr" in spanish.expected
    assert not {spanish.came, spanish.likely, spanish.hint} & {english.came, english.likely, english.hint}


def test_a_command_that_an_error_names_is_known_by_its_verb():
    """So the page can put its own button beside it."""
    parts = parts_of(lost())["es"]
    assert (parts.verb, parts.hint) == ("doctor", "`upright doctor LOG`")


def test_a_calibration_sees_no_truth(tmp_path):
    from upright.lab.tasks import _raw

    session, _ = a_session(tmp_path)
    session.advance(1.0)
    seen = _raw(session.logs()["nonlinear"])
    assert not [name for name in seen.channels if name.startswith(("truth/", "estimate/", "push/"))]
    assert "sensor/gyro" in seen


def test_a_broadcast_stands_everybody_up(tmp_path):
    session, _ = a_session(tmp_path, replace(MODEL, controller="off"))
    session.handle(StandUp(0.5))
    session.advance(1.0)
    session.handle(Broadcast(MODEL))
    assert session.lanes[0].state() == [0.0] * 6
    assert session.setup == MODEL


def test_every_preset_and_family_of_the_catalogue_can_be_chosen(tmp_path):
    listed = catalogue()
    session, _ = a_session(tmp_path)
    for robot in listed.robots:
        setup = replace(MODEL, robot=robot.name, kit=robot.kit)
        session.handle(Change(setup))
        session.advance(0.05)
        assert session.setup == setup, robot.name
    quick = [f.name for f in listed.families if not is_slow(f.name)]
    assert {f.name for f in listed.families} == {n for n in CONTROLLERS if not CONTROLLERS[n].own} | {"gains", "off"}
    for family in quick:
        session.handle(Change(replace(MODEL, controller=family)))
        session.advance(0.05)
        assert session.setup.controller == family
    assert not only(Notice, session.events())


class Rod:
    """A controller of somebody else: the same small voltage for ever."""

    def __init__(self, robot: Robot, kit: Kit, dt: float) -> None:
        self.spec = ControllerSpec("rod", (), dt, robot.command_unit)

    def reset(self) -> None: ...

    def step(self, measurement: object, reference: object) -> tuple[float, float]:
        return 0.5, 0.5

    def estimate(self) -> tuple[float, ...]:
        return ()

    def applied(self, command: object) -> None: ...

    def to_json(self) -> dict[str, object]:
        return {"kind": "rod"}


def test_a_registered_plug_in_is_a_family_like_ours(tmp_path, monkeypatch):
    monkeypatch.setattr(CONTROLLERS, "_own", {**CONTROLLERS._own})
    CONTROLLERS.register("rod", Rod)
    CONTROLLERS.register("bent", lambda robot, kit, dt: 1 / 0)
    assert {"rod", "bent"} <= {family.name for family in families()}
    session, desk = a_session(tmp_path, certified=False)
    session.handle(decode(encode(Change(replace(MODEL, controller="rod", largest=(1.0,) * 7)))))
    session.advance(0.1)
    assert session.lanes[0].controller.spec.kind == "rod"
    assert session.logs()["nonlinear"]["command/left"][-1] == 0.5
    assert only(Analysed, attended(session, desk))[-1].gain == ()  # it has no known linear form, and says so
    session.handle(Change(replace(MODEL, controller="bent")))
    assert "ZeroDivisionError" in only(Notice, session.events())[-1].parts["en"].came
    assert session.setup.controller == "rod"


def test_a_page_cannot_have_a_file_s_code_run(tmp_path):
    (tmp_path / "evil.py").write_text("from pathlib import Path\nPath(__file__).with_suffix('.ran').touch()\nX = print")
    session, _ = a_session(tmp_path)
    session.handle(Change(replace(MODEL, controller=f"{tmp_path}/evil.py:X")))
    assert only(Notice, session.events())[-1].parts["en"].expected.startswith("one of")
    assert not (tmp_path / "evil.ran").exists()


def test_a_job_in_a_process_reports_and_can_be_killed(tmp_path):
    desk = ProcessDesk(modest=0)
    try:
        desk.submit(("s", "design"), "design", (replace(MODEL, controller="lqr-state", kit="ideal"), True))
        desk.submit(("s", "robust"), "design", (replace(MODEL, controller="robust"), True), alone=True)
        done = {}
        while ("s", "design") not in done:
            done |= {key: result for key, status, result in desk.poll() if status == "done"}
            time.sleep(0.02)
        controller, found = done["s", "design"]
        assert found.stable
        assert controller.spec.kind == "lqr"
        desk.cancel(("s", "robust"))
        assert not [word for word in desk.poll() if word[0] == ("s", "robust")]
        desk.submit(("s", "robot"), "robot", (str(tmp_path / "none.toml"),))
        words = []
        while not words:
            words = desk.poll()
            time.sleep(0.02)
        assert words[0][1] == "failed"
        assert "none.toml" in words[0][2]["en"].came
    finally:
        desk.close()


@pytest.mark.evidence
def test_what_was_computed_once_costs_no_process_again(tmp_path, monkeypatch):
    """Another session that asks for the same is answered at once, with nothing begun; here by a task that is quick."""
    assert "light" in LASTING
    monkeypatch.setattr("upright.lab.desk.LASTING", ("robot",))
    paths = [str(Robot.preset(name).save(tmp_path / f"{name}.toml")) for name in ("nxtway-gs", "twipr")]
    desk = ProcessDesk(modest=0)
    try:
        desk.submit(("one", "robot"), "robot", (paths[0],), alone=True)
        words = []
        while not words:
            words = desk.poll()
            time.sleep(0.02)
        assert (words[0][:2], words[0][2].name) == ((("one", "robot"), "done"), "nxtway-gs")
        desk.submit(("two", "robot"), "robot", (paths[0],), alone=True)
        assert desk.poll() == [(("two", "robot"), "done", words[0][2])]
        assert not desk._alone
        desk.submit(("two", "robot"), "robot", (paths[1],), alone=True)
        assert desk.poll() == []
        assert desk._alone
    finally:
        desk.close()


def test_a_light_of_the_controller_before_is_given_up(tmp_path):
    """Its certificate is still being computed when another controller is chosen: nothing of it may be shown."""
    session, desk = a_session(tmp_path)
    for (_, job), status, result in desk.poll():  # the design is done, and its light asked for
        session.reported(job, status, result)
    session.handle(Change(replace(MODEL, controller="lqi")))
    assert [key[1] for key, _, _ in desk.poll()] == ["design"]


def test_a_setup_that_is_refused_leaves_the_analysis_of_what_stands(tmp_path, monkeypatch):
    monkeypatch.setitem(TASKS, "light", lambda *_: Light("green", ()))
    session, desk = a_session(tmp_path)
    attended(session, desk)
    session.handle(Change(replace(MODEL, controller="nonsense")))
    events = attended(session, desk)
    assert [event.level for event in only(Notice, events)] == ["error"]
    assert only(Changed, events)[0].setup == MODEL
    assert len(only(Analysed, events)) > 0
    assert only(Light, events)[-1].light == "green"


def test_the_history_is_sent_again_from_a_moment_on(tmp_path):
    """Six states of each body, then ψ̂, both commands and the limits, as the snapshots show them."""
    session, _ = a_session(tmp_path)
    session.handle(Strike("front", 0.1))
    session.advance(1.0)
    session.events()
    session.handle(Recall(0.5))
    (history,) = only(History, session.events())
    assert history.t[0] >= 0.5 - 1e-9
    assert history.t[-1] == session.snapshot().t
    last, shown = history.rows[-1], session.snapshot()
    assert last == (*shown.x[0][:6], shown.e[0], *shown.x[0][6:8], shown.s)


@pytest.mark.parametrize("raw", [pytest.param(False, marks=pytest.mark.evidence), True])
def test_an_opened_log_is_compared_with_the_run(tmp_path, raw):
    """With its states, or with sensors alone as a brick writes them."""
    session, desk = a_session(tmp_path, certified=False)
    session.handle(Strike("front", 0.1))
    for _ in range(2):
        session.advance(1.0)
    log = session.logs()["nonlinear"]
    kept = {n: x for n, x in log.channels.items() if not raw or n.startswith(("sensor/", "command/", "applied/"))}
    Log(log.t + 1000.0, kept, {n: log.unit(n) for n in kept}, log.origin).save(tmp_path / "in-friday.csv")
    session.handle(Save("report", "in-friday.csv"))
    events = attended(session, desk)
    assert only(Notice, events) == []
    assert "friday" in (tmp_path / only(Made, events)[0].url).read_text("utf-8")
