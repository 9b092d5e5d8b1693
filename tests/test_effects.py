"""Effects of a run beside the robot's numbers: what a slope does, how runs share a robot, and how far they spread."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.calibration.apart import apart
from upright.calibration.calibrate import prepared
from upright.calibration.effects import FRACTIONS, RUN, effects_of, maps_of, of_robot, respread, run_spreads, spread_of
from upright.calibration.gauss_newton import gauss_newton
from upright.calibration.own_run import spread_here
from upright.calibration.parameters import Parameter, parameters_of
from upright.calibration.process_noise import process
from upright.calibration.refined import FREEDOM
from upright.control import Estimated, kalman, lqr_state
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.experiment.pushes import Slope
from upright.pages import Say
from upright.robots import Kit, Robot
from upright.signals import Log

PRIOR, NXT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
TRUE = PRIOR.replace(com_height=0.0768, pitch_inertia=0.0013, torque_constant=0.33, motor_friction=0.003)
RUNS = ((0.7, 0.010), (1.0, -0.005), (1.3, 0.0))
"""Of three runs: the viscous friction over the robot's, and the floor's slope [rad]."""
SLOPE_TORQUE = (PRIOR.body_mass + 2 * PRIOR.wheel_mass) * PRIOR.gravity * PRIOR.wheel_radius / 2
"""[N m/rad] of each wheel that holds a robot on a slope."""


def logged(friction: float, slope: float, seed: int, seconds: float = 5.0, robot: Robot = TRUE) -> Log:
    body = Electronics(NonlinearBody(robot.replace(motor_friction=friction * TRUE.motor_friction)), NXT)
    controller = Estimated(lqr_state(PRIOR, 0.01), kalman(PRIOR, NXT))
    excited = Excited(controller, random_binary(round(seconds / 0.01), 1.5, seed, hold=4))
    return run(body, excited, seconds=seconds, seed=seed, push=Slope(angle=slope))


def test_runs_share_a_robot_and_differ_in_what_is_theirs() -> None:
    """Three runs, their viscous friction from 0.7 to 1.3 of the robot's and on three slopes, at the kit's noise: each
    run's friction, slope and the robot's own numbers are within three deviations of the truth."""
    logs = [logged(*effects, seed, 2.0) for seed, effects in enumerate(RUNS)]
    problem, _ = prepared(logs, PRIOR, NXT, (), 0.0)
    problem = replace(problem, noise=problem.noise | process(problem.recordings, PRIOR, FREEDOM / 10))
    z, normal, *_ = gauss_newton(problem, np.zeros(len(problem.parameters)), iterations=6, tolerance=0.2)
    C, names = np.linalg.inv(normal.hessian), [p.name for p in problem.asked]
    gain = TRUE.torque_constant / TRUE.motor_resistance
    for run_, (share, slope) in enumerate(RUNS):
        own, map_ = problem.of_run(z[:, None], run_)[:, 0], problem.curves.maps[run_]
        truth = {
            "motor_friction": share * TRUE.motor_friction, "constant_command": -SLOPE_TORQUE * slope / gain,
            "torque_constant": TRUE.torque_constant, "pitch_inertia": TRUE.pitch_inertia,
        }  # fmt: skip
        for name, value in truth.items():
            i = names.index(name)
            spread = np.sqrt(map_[i] @ C @ map_[i])
            assert abs(own[i] - problem.asked[i].coordinate(value)) < 3 * spread + 0.05, (run_, name)


def test_a_run_of_another_robot_is_named_and_what_belongs_to_a_run_is_not() -> None:
    """Friction and slopes of three runs differ: none is another robot's. With a body of 1.3 times its mass in one run
    that one differs by 5 deviations and more, beyond the 3.6 that one chance in 20 allows of 24 numbers and runs."""
    heavier = TRUE.replace(body_mass=1.3 * TRUE.body_mass)
    logs = [logged(*effects, seed, 2.0) for seed, effects in enumerate(RUNS)]
    assert apart_of(logs) == ()
    (words,) = apart_of([logs[0], logged(*RUNS[1], 1, 2.0, heavier), logs[2]])
    assert (words.facts["n"], words.facts["log"]) == (2, "b")
    assert "friction" not in str(words)


def apart_of(logs: list[Log]) -> tuple[Say, ...]:
    problem, _ = prepared(logs, PRIOR, NXT, (), 0.0)
    problem = replace(problem, noise=problem.noise | process(problem.recordings, PRIOR, FREEDOM / 10))
    z = gauss_newton(problem, np.zeros(len(problem.parameters)), iterations=6, tolerance=0.2).z
    return apart(problem, z, "abc")


def test_a_robot_is_the_mean_of_its_runs_and_as_unknown_as_they_differ() -> None:
    """One run alone knows its own friction, not the robot's: the stated spread is added. Of more runs, the mean's."""
    parameters = [p for p in parameters_of(PRIOR, {}) if p.name in ("motor_friction", "com_height")]
    size = FRACTIONS["motor_friction"] * parameters[1].prior / parameters[1].spread
    for runs, own in ((1, []), (2, [1.0, 0.5])):
        every = (*parameters, *effects_of(parameters, runs))
        z, C = np.array([0.3, 0.0, *own]), np.zeros((len(every),) * 2)
        told, total = of_robot(every, z, C, runs)
        assert told[:2] == pytest.approx([0.3, size * 0.75 if own else 0.0])
        assert np.sqrt(np.diag(total))[:2] == pytest.approx([0.0, size / np.sqrt(runs)])


def test_a_runs_numbers_are_the_robots_and_its_own_deviation() -> None:
    parameters = parameters_of(PRIOR, {"gyro": 0.002})
    every = (*parameters, *effects_of(parameters, 2))
    maps, z = maps_of(every, 2), np.zeros(len(every))
    own = [p.name for p in every].index(f"{RUN}1/motor_friction")
    z[own] = 1.0
    row = [p.name for p in parameters].index("motor_friction")
    moved = maps @ z
    assert moved[0] == pytest.approx(0.0)
    assert np.flatnonzero(moved[1]).tolist() == [row]
    p = parameters[row]
    assert float(p.value(moved[1, row])) - p.prior == pytest.approx(FRACTIONS["motor_friction"] * p.prior)
    assert not effects_of(parameters, 1)  # of one run nobody can tell its number from the robot's


def test_the_spread_between_runs_is_that_of_the_runs() -> None:
    """Many runs, their deviations known: the spread becomes theirs, whatever was stated; of few it stays nearer."""
    rng, share = np.random.default_rng(0), FRACTIONS["motor_friction"]
    friction = Parameter("motor_friction", "N m s/rad", 0.01, 0.005, "linear", 0.0)
    for runs, near in ((400, 0.1), (3, 0.8)):
        parameters = (friction, *effects_of([friction], runs))
        z = np.append(0.0, 3.0 * rng.standard_normal(runs))
        truth = parameters[1].spread * z
        for _ in range(30):
            parameters, z = respread(parameters, z, np.zeros((runs + 1, runs + 1)))
        assert parameters[1].spread * z == pytest.approx(truth)  # the deviations themselves stay
        found = parameters[1].spread * friction.spread / (share * friction.prior)
        assert abs(np.log(found / 3.0)) < near


def test_known_numbers_do_not_differ_between_runs() -> None:
    logs = [logged(1.0, 0.0, seed, 1.5) for seed in (0, 1)]
    problem, _ = prepared(logs, PRIOR, replace(NXT, jitter=0.0), ("motor_friction",), 0.0)
    assert not any("motor_friction" in p.name for p in problem.parameters)


def test_a_runs_own_friction_may_be_off_by_what_runs_differ_and_what_is_not_known() -> None:
    """Friction of 0.01 differs by 30 % between runs, 0.003; known to 0.004, a run's own may be off by 0.005."""
    measured = Parameter("motor_friction", "N m s/rad", 0.01, 0.004, "logarithm")
    assert spread_here(measured, spread_of(measured, 0.01)) == pytest.approx(0.005)
    guess = replace(measured, guess=True)  # nobody knows it: what runs differ is all that is allowed
    assert spread_here(guess, spread_of(guess, 0.01)) == pytest.approx(0.003)
    late = Parameter("delay/gyro", "s", 0.01, 0.02, "linear")
    assert spread_here(late, run_spreads([late])["delay/gyro"]) == pytest.approx(0.005)


def test_the_mean_of_runs_without_friction_is_none() -> None:
    """Zero friction is at z = −0.2. Runs at z = 0.1 ± 0.6 have 0.7 and −0.2, since none has less: 0.25 on average."""
    friction = Parameter("motor_friction", "N m s/rad", 0.001, 0.005, "linear", 0.0)
    parameters = (friction, *(replace(p, spread=1.0) for p in effects_of([friction], 2)))
    z, _ = of_robot(parameters, np.array([0.1, 0.6, -0.6]), np.zeros((3, 3)), 2)
    assert z[0] == pytest.approx((0.7 - 0.2) / 2)
    z, _ = of_robot(parameters, np.array([-0.2, -0.6, -0.6]), np.zeros((3, 3)), 2)
    assert z[0] == pytest.approx(-0.2)
