"""Regulator, feedback and estimators against python-control, SLICOT and planted truths."""

from dataclasses import replace
from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.control import (
    CONTROLLERS,
    Complementary,
    Estimated,
    StateFeedback,
    complementary,
    controller_hash,
    dlqr,
    kalman,
    lqr_state,
    make_controller,
)
from upright.control.controller import Controller
from upright.control.delay import RAW
from upright.control.riccati import bryson, riccati, riccati_residual
from upright.control.robust import robust
from upright.errors import DesignFailed, InvalidController, SpecMismatch, UnknownName
from upright.experiment import Hold, run
from upright.physics.dynamics import turn_ratio
from upright.physics.linear import linearise
from upright.physics.sensing import sensor_matrix
from upright.robots import Kit, Robot, Sensor, preset_names

NXT = Robot.preset("nxtway-gs")


@pytest.mark.parametrize("name", preset_names())
@pytest.mark.needs("module:control")
def test_lqr_equals_python_control(name):
    control = pytest.importorskip("control")
    design = lqr_state(Robot.preset(name), 0.01)
    gain, cost, _ = control.dlqr(design.model.A, design.model.B, design.Q, design.R, method="scipy")
    assert np.allclose(design.gain, gain, rtol=1e-8)
    assert np.allclose(design.cost, cost, rtol=1e-8, atol=1e-8 * np.abs(cost).max())


def test_riccati_equation_of_the_textbook_has_its_published_solution():
    # Benner, Laub and Mehrmann (1995), DAREX, example 1.1: P = (1 + √5)/2 Q, poles (3 − √5)/2 and −1/2; Q has rank one
    A, B = np.array([[4.0, 3.0], [-4.5, -3.5]]), np.array([[1.0], [-1.0]])
    Q = np.array([[9.0, 6.0], [6.0, 4.0]])
    cost, gain = riccati(SimpleNamespace(A=A, B=B), Q, np.eye(1))
    assert cost == pytest.approx((1 + np.sqrt(5)) / 2 * Q, rel=1e-9)
    assert np.sort(np.linalg.eigvals(A - B @ gain)) == pytest.approx([-0.5, (3 - np.sqrt(5)) / 2], rel=1e-9)
    assert riccati_residual(A, B, Q, np.eye(1), cost) < 1e-12
    assert riccati_residual(A, B, Q, np.eye(1), cost * 1.01) > 1e-3


def test_lqr_equals_slicot():
    control = pytest.importorskip("control")
    pytest.importorskip("slycot")
    design = lqr_state(NXT, 0.01)
    gain = control.dlqr(design.model.A, design.model.B, design.Q, design.R, method="slycot")[0]
    assert np.allclose(
        design.gain, gain, rtol=1e-7
    )  # two solvers of one Riccati equation: its condition number times ε


@pytest.mark.parametrize("name", preset_names())
def test_lqr_checks_itself_and_stabilises(name):
    design = lqr_state(Robot.preset(name), 0.01)
    assert design.check() < 1e-9
    assert np.abs(design.poles()).max() < 1


def test_unweighted_integrator_is_refused():
    with pytest.raises(DesignFailed, match="zero on the diagonal of Q"):
        lqr_state(NXT, 0.01, Q=[1, 1, 0, 1, 1, 1], R=[1, 1])


@pytest.mark.parametrize(
    ("Q", "R", "word"),
    [
        ([1] * 5, [1, 1], "Q has shape"),
        ([1] * 6, [1, 0], "R is not positive"),
        ([-1, 1, 1, 1, 1, 1], [1, 1], "non-negative"),
        ([1] * 6, [1], "R has shape"),
    ],
)
def test_bad_weights_are_named(Q, R, word):
    with pytest.raises(DesignFailed, match=word):
        lqr_state(NXT, 0.01, Q=Q, R=R)


def test_continuous_model_is_refused():
    with pytest.raises(DesignFailed, match="c2d"):
        dlqr(linearise(NXT), np.eye(6), np.eye(2))


def test_feedback_is_minus_k_times_the_deviation():
    controller = StateFeedback.symmetric([-1, -2, -3, -4, -5, -6], 0.01)
    command = controller.step(np.array([0.1, 0.2, 0.3, 0.4, 0.5, 0.6]), np.zeros(6))
    # −Σ k x: pitch part 0.1 + 0.4 + 0.9 + 1.6 = 3.0, yaw part 2.5 + 3.6 = 6.1, of opposite sign on the right
    assert command == (pytest.approx(9.1), pytest.approx(-3.1))


@pytest.mark.parametrize("gain", [np.zeros(6), np.zeros((6, 2)), np.full((2, 6), np.nan)])
def test_wrong_gain_is_refused(gain):
    with pytest.raises(InvalidController):
        StateFeedback(gain, 0.01)


def test_every_controller_says_what_it_is():
    plain = Kit.preset("nxt")
    kit = replace(plain, sensors=plain.sensors | {"sensor/pitch": Sensor()})  # a fused angle beside all others
    for name in CONTROLLERS:
        # over two robots instead of 200: nothing here depends on how many it was tried on
        searches = name == "robust"
        make = partial(robust, tried=2) if searches else partial(make_controller, name)
        controller = make(NXT, kit, 0.01)
        assert isinstance(controller, Controller)
        controller.reset()
        command = controller.step(np.zeros(len(controller.spec.reads)), np.zeros(6))
        assert command == (0.0, 0.0)  # at rest, upright, by symmetry
        assert controller_hash(controller) == controller_hash(controller if searches else make(NXT, kit, 0.01))
    with pytest.raises(UnknownName):
        make_controller("lqx", NXT, kit, 0.01)


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("size", [0.0, -1.0, np.nan, np.inf, 1e-200, 1e200])
def test_deviations_without_a_square_are_refused_in_silence(size):
    with pytest.raises(DesignFailed, match="positive numbers"):
        bryson([1.0, size])


def test_hash_changes_with_a_gain():
    design = lqr_state(NXT, 0.01)
    other = StateFeedback(design.gain * (1 + 1e-12), 0.01, kind="lqr")
    assert controller_hash(StateFeedback(design.gain, 0.01, kind="lqr")) != controller_hash(other)


@pytest.mark.needs("module:control")
def test_kalman_gain_equals_python_control():
    control = pytest.importorskip("control")
    kit = Kit.preset("nxt")
    built = kalman(NXT, kit, 0.01)
    # the dual of dlqr: the same Riccati equation by another route, from the same noises rebuilt by hand
    sensors = [kit.sensors[name] for name in built.reads]
    noise = np.diag([s.noise**2 + s.quantum**2 / 12 for s in sensors])
    model = linearise(NXT).c2d(0.01)
    share = NXT.body_mass * NXT.gravity / 6.0  # of the weight that the documented noises are for
    push = np.append(model.E @ [1, NXT.com_height, 0], [0, 0]) * 0.05 * share
    walks = np.array([max(1e-3, sensors[2].bias_walk), 0.3 * share]) * 0.1  # √(0.01 s)
    G = np.column_stack([push, built.B * 0.02 * 4.0, np.eye(8)[:, 6:] * walks])
    P = control.dare(built.A.T, built.C.T, G @ G.T + 1e-14 * np.eye(8), noise)[0]
    assert np.allclose(built.L, P @ built.C.T @ np.linalg.inv(built.C @ P @ built.C.T + noise), rtol=1e-5, atol=1e-9)


def test_kalman_finds_a_planted_gyro_bias():
    # the sensors are otherwise ideal, so after the filter has settled (seconds) the bias is what was planted
    kit = Kit.preset("nxt")
    design, estimator = lqr_state(NXT, 0.01), kalman(NXT, kit, 0.01)
    body = NonlinearBody(NXT, period=0.01)
    loop, state = Estimated(design, estimator), body.reset((0.02, 0, 0, 0, 0, 0)).values[:6]
    for _ in range(3000):
        y = sensor_matrix(RAW, turn_ratio(NXT)) @ state + [0.0, 0.0, 0.05]
        command = loop.step(y, np.zeros(6))
        state = body.step(command).values[:6]
        loop.applied(command)
    assert abs(estimator._x[6] - 0.05) < 1e-3
    assert abs(state[0]) < 1e-3


def test_complementary_filter_has_a_stationary_gain_of_one_for_gravity():
    # gyro silent, gravity says 0.1 rad: after 10 time constants e⁻¹⁰ = 5e-5 of the error is left
    robot = NXT
    filter_ = Complementary(robot.track / (2 * robot.wheel_radius), 0.01, time=0.2, accelerometer=True)
    filter_.update(np.array([0, 0, 0, 0, 9.81]))
    for _ in range(200):
        state = filter_.update(np.array([0, 0, 0, -9.81 * np.sin(0.1), 9.81 * np.cos(0.1)]))
    assert state[0] == pytest.approx(0.1, rel=1e-4)


def test_estimators_need_encoders_and_gyro():
    with pytest.raises(SpecMismatch, match="has no sensor/encoder_left"):
        kalman(NXT, Kit(name="blind"))
    with pytest.raises(SpecMismatch, match="has no"):
        complementary(NXT, Kit(name="blind"))


@pytest.mark.parametrize("name", ["lqr", "lqr-complementary"])
def test_raw_sensors_alone_hold_the_robot_through_a_push(name):
    kit = Kit.preset("nxt")
    controller = make_controller(name, NXT, kit, 0.01)
    assert not controller.spec.reads_truth
    log = run(Electronics(NonlinearBody(NXT), kit), controller, Hold(pitch=0.05, until=2.0), seconds=6, seed=3)
    assert not log.origin["outcome"]["fell"]
    # the estimator knows the pitch to about a degree, which is the gyro's resolution
    error = log["estimate/pitch"] - log["truth/pitch"]
    assert np.sqrt(np.mean(error[300:] ** 2)) < np.deg2rad(1.5)
