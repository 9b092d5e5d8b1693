"""Effects of a run beside the robot's numbers: what a slope does, how runs share a robot, and how far they spread."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from upright.bodies import Electronics, NonlinearBody
from upright.calibrate.calibrate import calibrate, prepared
from upright.calibrate.calibration import Calibration
from upright.calibrate.effects import RUN, SHARES, between_runs, effects_of, respread, shares
from upright.calibrate.parameters import Parameter, parameters_of
from upright.control import Estimated, kalman, lqr
from upright.control.excited import Excited, random_binary
from upright.experiment import run
from upright.experiment.pushes import Slope
from upright.physics.linear import unstable_pole
from upright.robots import Kit, Robot
from upright.signals import Log

PRIOR, NXT = Robot.preset("nxtway-gs"), Kit.preset("nxt")
TRUE = PRIOR.replace(com_height=0.0768, pitch_inertia=0.0013, torque_constant=0.33, motor_friction=0.003)
RUNS = ((0.6, 0.010), (1.0, -0.005), (1.5, 0.0))
"""Of three runs: the viscous friction over the robot's, and the floor's slope [rad]."""
SLOPE_TORQUE = (PRIOR.body_mass + 2 * PRIOR.wheel_mass) * PRIOR.gravity * PRIOR.wheel_radius / 2
"""[N m/rad] of each wheel that holds a robot on a slope."""


def logged(friction: float, slope: float, seed: int, seconds: float = 5.0) -> Log:
    body = Electronics(NonlinearBody(TRUE.replace(motor_friction=friction * TRUE.motor_friction)), NXT)
    controller = Estimated(lqr(PRIOR, 0.01), kalman(PRIOR, NXT))
    excited = Excited(controller, random_binary(round(seconds / 0.01), 1.5, seed, hold=4))
    return run(body, excited, seconds=seconds, seed=seed, push=Slope(angle=slope))


@cache
def together() -> Calibration:
    return calibrate([logged(*effects, seed) for seed, effects in enumerate(RUNS)], PRIOR)


def test_runs_share_a_robot_and_differ_in_what_is_theirs() -> None:
    """Three runs, their viscous friction from 0.6 to 1.5 of the robot's and on three slopes: the robot's friction is
    inside its interval, and its pole as sure as if no run differed."""
    found = together()
    friction = found["motor_friction"]
    assert friction.low <= np.mean([share * TRUE.motor_friction for share, _ in RUNS]) <= friction.high
    assert unstable_pole(found.robot) == pytest.approx(unstable_pole(TRUE), rel=0.02)
    assert found["torque_constant"].low <= TRUE.torque_constant <= found["torque_constant"].high


def test_a_slope_is_a_constant_command() -> None:
    """One run on a slope of 0.6°: M g R sin γ / 2 of each wheel against the motion, over the motor's gain."""
    found = calibrate(logged(1.0, 0.010, 7), PRIOR)
    constant = found["constant_command"]
    gain = TRUE.torque_constant / TRUE.motor_resistance
    assert constant.low <= -SLOPE_TORQUE * 0.010 / gain <= constant.high
    assert constant.shrink < 0.2


def test_one_run_alone_knows_its_own_friction_and_not_the_robots() -> None:
    parameters = [p for p in parameters_of(PRIOR, {"gyro": 0.002}) if p.name in ("motor_friction", "com_height")]
    variance = dict(zip([p.name for p in parameters], np.diag(between_runs(parameters, np.zeros(2))), strict=True))
    p = next(p for p in parameters if p.name == "motor_friction")
    assert variance["com_height"] == 0.0
    assert np.sqrt(variance["motor_friction"]) * p.spread == pytest.approx(SHARES["motor_friction"] * p.prior)


def test_a_runs_numbers_are_the_robots_and_its_own_deviation() -> None:
    parameters = parameters_of(PRIOR, {"gyro": 0.002})
    every = (*parameters, *effects_of(parameters, 2))
    maps, z = shares(every, 2), np.zeros(len(every))
    own = [p.name for p in every].index(f"{RUN}1/motor_friction")
    z[own] = 1.0
    row = [p.name for p in parameters].index("motor_friction")
    moved = maps @ z
    assert moved[0] == pytest.approx(0.0)
    assert np.flatnonzero(moved[1]).tolist() == [row]
    p = parameters[row]
    assert float(p.value(moved[1, row])) - p.prior == pytest.approx(SHARES["motor_friction"] * p.prior)
    assert not effects_of(parameters, 1)  # of one run nobody can tell its number from the robot's


def test_the_spread_between_runs_is_that_of_the_runs() -> None:
    """Many runs, their deviations known: the spread becomes theirs, whatever was stated; of few it stays nearer."""
    rng = np.random.default_rng(0)
    for runs, near in ((400, 0.15), (3, 1.0)):
        parameters = tuple(Parameter(f"{RUN}{i}/motor_friction", "1", 0.0, 0.5, "linear") for i in range(runs))
        z = 3.0 * rng.standard_normal(runs)
        truth, before = 0.5 * z, z
        for _ in range(60):
            parameters, z = respread(parameters, z, np.zeros((runs, runs)))
        assert parameters[0].spread * z == pytest.approx(truth)  # the deviations themselves stay
        assert abs(np.log(parameters[0].spread / 1.5)) < near, before


def test_known_numbers_do_not_differ_between_runs() -> None:
    logs = [logged(1.0, 0.0, seed, 1.5) for seed in (0, 1)]
    problem, _ = prepared(logs, PRIOR, replace(NXT, jitter=0.0), ("motor_friction",), 0.0)
    assert not any("motor_friction" in p.name for p in problem.parameters)
