"""Rules of the post-mortem by numbers that follow from the equations, without a filter along a log."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from upright.arrays import Array
from upright.diagnose import blows, chances, facts, verdict
from upright.diagnose.causes import DROPPED, HIGH, LOW, OFF
from upright.diagnose.evidence import EXCURSION, KNOWN_TO, Evidence
from upright.diagnose.fall import Authority, falling, half_swing, held_command, pace, wheel_rates
from upright.diagnose.fault_fits import FaultFit, PushEstimate
from upright.diagnose.joint import _Joint
from upright.diagnose.measured import Demand, Toppling
from upright.diagnose.slip import slid_at
from upright.diagnose.thrown import Throw
from upright.physics.dynamics import motor_gain
from upright.robots import Robot, preset_names
from upright.signals import Log

NXT = Robot.preset("nxtway-gs")
E_FOLD = 1 / falling(NXT).pole  # 0.134 s
PERIOD = 0.02  # [s] of a slow loop, whose commands repeat where the robot rests


def held(needed: Array, asked: Array, battery: Array | None = None) -> tuple[float, float] | None:
    """What counts as held among commands (rows,) of both motors, of which so much is `needed` (rows,)."""
    t: Array = PERIOD * np.arange(len(asked), dtype=np.float64)
    log = Log(t, {"sensor/battery": battery} if battery is not None else {"sensor/gyro": 0.0 * t})
    run: Any = SimpleNamespace(log=log, asked=np.column_stack([asked, asked]), robot=NXT)
    motors = Authority(t, asked, needed, np.zeros(len(t)), np.zeros((len(t), 6)))
    return held_command(run, motors, float(t[-1]), EXCURSION)


def stopped(rows: int) -> tuple[Array, Array]:
    """What is needed, and commands that answer it in every row, but for the last `rows`, over which the need grows as a
    lean does."""
    needed = 0.02 * np.sin(np.arange(200.0))
    needed[-rows:] = 0.1 * np.exp(PERIOD / E_FOLD * np.arange(rows))
    asked = np.where(np.arange(200) < 200 - rows, needed, needed[-rows])
    return needed, asked


def test_a_robot_at_rest_whose_commands_repeat_is_no_stopped_program() -> None:
    needed, asked = stopped(15)  # 0.3 s, or 2.2 times in which it falls e-fold
    found = held(needed, asked)
    assert found is not None
    assert found[0] == pytest.approx(PERIOD * 185)
    needed[-15:] = 0.005  # the same repeated command where nothing has to be answered
    assert held(needed, asked) is None


def test_duties_that_stand_still_are_commands_that_do_though_the_battery_s_reading_scatters() -> None:
    needed, duties = stopped(15)
    volts = 8.0 + 0.02 * np.random.default_rng(1).standard_normal(len(duties))
    assert held(needed, duties * volts, volts) is not None
    assert held(needed, duties * volts) is None  # without the battery's channel these are volts that change


def test_only_robots_that_fall_slowly_get_more_time() -> None:
    assert {name: pace(Robot.preset(name)) for name in preset_names()} == dict.fromkeys(preset_names(), 1.0)
    # a body of 50 times the inertia about its axle under the same weight: its e-fold is √50 times longer on wheels that
    # stand, and nearly so on wheels that roll
    whole = 50 * (NXT.pitch_inertia + NXT.body_mass * NXT.com_height**2)
    slow = NXT.replace(pitch_inertia=whole, roll_inertia=whole, yaw_inertia=whole)
    assert pace(slow) == pytest.approx(4.75 / falling(slow).pole)
    assert pace(slow) > 2.0


def test_wheels_slide_by_commands_that_ask_more_of_the_floor_than_it_holds() -> None:
    mass = NXT.body_mass + 2 * NXT.wheel_mass
    # at rest the whole torque of two motors pushes on the floor at the radius, but for what turns the body and wheels
    whole = mass * NXT.gravity * NXT.wheel_radius / (2 * motor_gain(NXT))
    for part, slides in ((0.1, False), (20.0, True)):
        u = np.where(np.arange(100)[:, None] < 50, 0.0, part * whole) * np.ones((100, 2))
        t = 0.01 * np.arange(100)
        run: Any = SimpleNamespace(robot=NXT, before=np.zeros((100, 6)), command=u, t=t, spans=np.full(100, 0.01))
        at = slid_at(run, 0.0, 1.0)
        assert (at == pytest.approx(0.5)) if slides else (at is None)


@pytest.fixture
def _last_questions(monkeypatch: pytest.MonkeyPatch) -> None:
    """Only what is asked of a robot whose innovations are noise: references, speed, battery and gain."""
    monkeypatch.setattr(verdict, "QUESTIONS", verdict.QUESTIONS[-4:])


def left_over(**motors: Any) -> dict[str, float]:
    """The likelihoods of a sound robot whose motors were used so."""
    use = {"saturated": 0.0, "pegged": 0.0, "stuck": False, "held": None, "swings": 0.8, "help": math.nan, "speed": 0.3}
    use["half_swing"] = math.nan
    demand = motors.pop("demand", None)
    none: Any = SimpleNamespace(fault="none", pushes=(), score=0.0, nis=0.7, rest=np.zeros(0), explained=0.0)
    log = Log(np.arange(0.0, 6.0, 0.01), {"sensor/gyro": np.zeros(600)})
    evidence: Any = SimpleNamespace(
        run=SimpleNamespace(log=log, robot=NXT), fell_at=5.0, excursion=EXCURSION, ordinary=1.0, calm=1.0, nis=1.0,
        fits=(none,), pairs=(), pushes_only=none, left=None, stuck=None, jam=None, match=None, stable=None,
        slid=math.nan, lost=(0.0, 0.0, 4.0), demand=demand, battery=(math.nan, math.nan), throw=None, then=log.t,
        notes=(), motors=SimpleNamespace(**use | motors), toppling=Toppling(1.0, 0.0, 0.5, 1 / E_FOLD),
    )  # fmt: skip
    return {cause.name: cause.likelihood for cause in verdict.ranked(evidence)}


@pytest.mark.usefixtures("_last_questions")
def test_commands_that_stay_small_are_no_gain_that_is_too_high() -> None:
    # commands near nothing, a little the wrong way, while the robot leans on: a high gain gives large ones
    assert left_over(help=-0.06)[LOW] > 0.5 > left_over(help=-0.06)[HIGH]
    assert left_over(saturated=0.8)[HIGH] > 0.5
    assert left_over(swings=12.0, help=0.5)[HIGH] > 0.5
    # full commands that swing: a gain that is too high swings faster than at twice the pole, or 1.57 e-folds each way
    assert left_over(saturated=0.8, half_swing=0.4)[HIGH] > 0.5
    assert left_over(saturated=0.8, half_swing=2.8)[LOW] > 0.5


@pytest.mark.usefixtures("_last_questions")
def test_references_that_ask_for_little_speed_exclude_motors_that_were_asked_for_more() -> None:
    fast = {"speed": 0.98, "help": 0.8, "saturated": 0.8}
    top = 0.3  # [m/s]
    unknown = left_over(**fast)  # nothing is known of what was asked: a robot of low gain runs after its fall as well
    assert unknown["saturation"] == pytest.approx(0.5, abs=0.01)
    assert unknown["saturation"] > unknown[LOW] > 0.3
    slow = left_over(**fast, demand=Demand(jump=0.0, at=3.0, top_speed=top, fastest=top / 10))
    assert slow[LOW] > 0.5
    assert left_over(**fast, demand=Demand(jump=0.0, at=3.0, top_speed=top, fastest=top))["saturation"] > 0.5


@pytest.mark.parametrize(("pushes_leave", "held"), [(0.77, False), (1.4, True)])
def test_no_fault_is_needed_where_pushes_leave_only_noise(pushes_leave: float, held: bool) -> None:
    """A low gain of a stranger's robot, whose knock has no exact shape: a delay explained a tenth of the noise."""
    none: Any = SimpleNamespace(fault="none", nis=pushes_leave, score=100.0)
    delay: Any = SimpleNamespace(fault="delay", nis=0.9 * pushes_leave if not held else 0.9, score=124.0)
    evidence: Any = SimpleNamespace(pushes_only=none, calm=1.0, noise=delay.nis)
    evidence.misfit, evidence.nats = lambda fit: fit.nis, lambda fit: fit.score
    assert (chances.holds(evidence, delay) > 0.5) == held


@pytest.mark.parametrize(("sound", "leaves", "blow"), [(0.0, 1.1, False), (1.0, 1.1, True), (0.0, 8.0, True)])
def test_a_blow_is_the_cause_unless_a_fault_showed_before_it(
    sound: float, leaves: float, blow: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Twipr under readings that came late was pushed by less than it stands: its body turned like one that is thrown.
    The delay and the push left noise. What fits after a blow only, or leaves eight times the noise, explains none."""
    throw = Throw(
        start=3.5, after=-15.0, seconds=0.03, clipped=False, wheels=True, lost=True, left=0.5, rows=50, times=4.4
    )  # fmt: skip
    evidence: Any = SimpleNamespace(throw=throw, slid=math.nan, calm=1.0, pushes_only=SimpleNamespace(nis=129.0))
    delay = FaultFit(fault="delay", onset=3.1, size=1.3, nis=leaves)
    known: dict[str, Any] = {"toppled": (1.0, 1.0, None), "driven_into": [], "best_of": delay, "sound_until": sound}
    for name, answer in known.items():
        monkeypatch.setattr(blows, name, lambda *_, answer=answer: answer)
    assert bool(blows.thrown_over(evidence)) == blow


@pytest.mark.parametrize(("wrong", "stood"), [(0.0, True), (8.0, False)])
def test_a_program_that_stopped_is_the_cause_of_a_sound_robot_only(wrong: float, stood: bool) -> None:
    """A gyro of another scale made a tall robot fall, whose program then stopped: by that gyro it leaned so little that
    the motors could have saved it. Innovations are noise, and until the stop what the gyro has `wrong` beside it."""
    t = 0.01 * np.arange(400)
    noise = np.random.default_rng(5).standard_normal(400)
    rest = noise + wrong * (t > 2.0)
    none: Any = SimpleNamespace(fault="none", rest=rest)
    evidence: Any = SimpleNamespace(
        motors=SimpleNamespace(held=(3.0, 4.0), pegged=0.0, stuck=False), stuck=None, then=t, calm=1.0,
        weights=np.ones(400), pushes_only=none, fits=(none, SimpleNamespace(fault="scale", rest=noise)),
    )  # fmt: skip
    (answer,) = facts.stuck(evidence)
    assert (answer.name, answer.probability > 0.9, answer.probability < 0.1) == (DROPPED, stood, not stood)


@pytest.mark.parametrize(("lean", "topples"), [(0.45, 1.0), (0.1, 0.0), (0.3, chances.EARLIER)])
def test_a_push_since_which_a_robot_swings_may_have_felled_it_and_one_that_motors_do_not_stop_has(
    lean: float, topples: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A robot of 16 kg fell 1.4 s after a push of 0.6 of what its motors bring back: a gain too low, 0.72. Nothing
    shows whether a better gain had saved it, so that both share the probability."""

    def restless(*_: Any) -> float:
        return 2.05  # [s]: it never came to rest after the push, which began in the last block in which it rested

    monkeypatch.setattr(chances, "unsettled", restless)
    push = PushEstimate(start=2.0, stop=2.1, impulse=lean, height=0.0, score=100.0)
    evidence: Any = SimpleNamespace(
        pushes_only=SimpleNamespace(pushes=(push,)), toppling=Toppling(1.0, 0.0, 0.5, 1 / E_FOLD), fell_at=5.0,
        excursion=EXCURSION, motors=SimpleNamespace(stuck=False, pegged=0.0),
    )  # fmt: skip
    chance, _, _ = chances.toppled(evidence)
    assert chance == pytest.approx(topples, abs=0.02)  # the step is a tenth of the lean wide


def test_an_error_that_a_robot_may_have_counts_as_one_reading_however_far_it_moved() -> None:
    # whitened innovations of noise, then of a fall for half a second: a robot that is wrong by `KNOWN_TO` leaves that
    # part of each of them, which is one error in each tenth of a second
    t = 0.01 * np.arange(400)
    y = np.random.default_rng(3).standard_normal(400) * np.where(t < 3.5, 1.0, 400.0)
    run: Any = SimpleNamespace(readings=np.ones(400, dtype=bool), clock=t, whitened=y)
    run.only = lambda _: run
    found: Any = SimpleNamespace(run=run, then=t, calm=1.0, pushes_only=SimpleNamespace(rest=y))
    weights = Evidence.weights.func(found)  # type: ignore[attr-defined]
    fell = t >= 3.5
    assert (weights[fell] * (KNOWN_TO * y[fell]) ** 2).sum() == pytest.approx(5.0, rel=0.05)  # tenths of a second
    assert weights[~fell].min() > 0.9  # noise stays what it was


def test_the_rate_of_a_wheel_is_that_over_several_of_its_encoder_s_steps() -> None:
    # 1° and 10 ms: from row to row a wheel at 5 rad/s seems to turn at 3.5 or at 5.2
    t, degree = 0.01 * np.arange(100), math.pi / 180
    names = ("sensor/encoder_left", "sensor/encoder_right")
    log = Log(t, dict.fromkeys(names, degree * np.floor(5.0 * t / degree)), dict.fromkeys(names, "rad"))
    assert wheel_rates(log, t[10:]) == pytest.approx(np.full(90, 5.0), abs=degree / 0.05)


def test_friction_that_varies_leaves_more_than_a_robot_that_is_a_little_off() -> None:
    """Of a fall of 800 times the noise, friction that is 4 % off leaves 0.04² of that, 1.3, beside the noise. Errors of
    the robot's parameters are searched beside every hypothesis, so that a dead motor that leaves as much is none."""
    evidence: Any = SimpleNamespace(nis=800.0, calm=1.0)
    assert chances.fits_badly(evidence, 2.28, "friction") < 0.1
    assert chances.fits_badly(evidence, 2.28, "motor") > 0.5


def test_dry_friction_is_never_less_than_none() -> None:
    """A file that states too much of it had "a dry friction of −0.016 N m, which is more than robots meet" (0.11)."""
    fit, end = FaultFit(fault="friction", way="both", onset=1.0, size=0.1), 3.0
    recent: Any = SimpleNamespace(log=SimpleNamespace(t=np.arange(0.0, end, PERIOD)))
    window: Any = SimpleNamespace(end=end)
    known: Any = {(1.0, 0.0): None, (1.0, 0.3): None}  # no filter is asked
    joint = _Joint(recent, window, (fit,), fit, np.zeros((0, 0)), known)
    assert joint.inside(np.array([1.0, -0.5])).tolist() == [1.0, 0.0]
    assert joint.inside(np.array([1.0, 0.3])).tolist() == [1.0, 0.3]


def test_a_swing_goes_one_way_for_half_of_its_period() -> None:
    """Of ω over a pole λ, π λ/ω e-folds; to a row, since a sign changes between two. The last 12 e-folds count."""
    t: Array = np.arange(0.0, 20.0, PERIOD)
    pole = 4.0
    for ratio in (0.7, 3.0):
        motors = Authority(t, np.sin(ratio * pole * t), np.zeros(len(t)), np.zeros(len(t)), np.zeros((len(t), 6)))
        assert half_swing(motors, pole, 19.0) == pytest.approx(math.pi / ratio, abs=PERIOD * pole)
    still = Authority(t, np.sin(pole * t) * (t < 10.0), np.zeros(len(t)), np.zeros(len(t)), np.zeros((len(t), 6)))
    assert math.isnan(half_swing(still, pole, 19.0))


@pytest.mark.parametrize(("given_up", "named"), [(0.0, True), (4 * E_FOLD, False)])
def test_a_program_that_stops_is_a_cause_and_one_that_gives_up_a_fall_is_none(
    given_up: float, named: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A body that sways at 0.1 rad/s falls from 3 s on, by its pole. Commands end as it begins, or four e-folds later:
    it turns 55 times as fast then as when it began."""
    t: Array = 0.01 * np.arange(420)
    fall = 0.1 * np.exp(np.minimum(np.maximum(t - 3.0, 0.0), 6 * E_FOLD) / E_FOLD)
    log = Log(t, {"sensor/gyro": np.where(t < 3.0, 0.1 * np.sin(5 * t), fall)})
    asked = np.where(t < 3.0 + given_up, 1.0 + np.sin(5 * t), 0.0)
    run: Any = SimpleNamespace(log=log, asked=np.column_stack([asked, asked]))
    monkeypatch.setattr(facts, "sound_until", lambda *_: 1.0)
    evidence: Any = SimpleNamespace(run=run, fell_at=3.0 + 6 * E_FOLD)
    answers = facts.switched_off(evidence)
    assert [answer.name for answer in answers] == [OFF] * named
    assert all(answer.onset == pytest.approx(3.0, abs=0.011) for answer in answers)
    asked[200:290] = 0.0  # its law gave nothing for longer than a third of what is left before the fall: 1.2 s at most
    assert not facts.switched_off(SimpleNamespace(run=SimpleNamespace(log=log, asked=asked[:, None]), fell_at=4.2))  # type: ignore[arg-type]


def test_motors_that_are_off_at_first_are_not_held_as_usual() -> None:
    """A robot that is held for half a second before its motors are switched on; later no command stands so long."""
    needed, asked = stopped(20)
    before = round(0.5 / PERIOD)
    late = held(np.concatenate([np.zeros(before), needed]), np.concatenate([np.zeros(before), asked]))
    assert late is not None
    assert late == pytest.approx(tuple(0.5 + x for x in held(needed, asked) or ()))
