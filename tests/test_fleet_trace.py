"""The trace: generated text is current, and says what the one definition of the dynamics says."""

import cmath
import math
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

from upright.compiled import generated
from upright.compiled.trace import sources
from upright.kernel import sensitivity
from upright.physics.dynamics import Disturbance, derivative
from upright.robots import Robot
from upright.robots.robot import PARAMETERS

ROUGH = Robot.preset("nxtway-gs").replace(coulomb_friction=0.004, wheel_friction=0.001)  # no parameter without effect
NUMBERS = np.array(list(ROUGH.numbers().values()))
X, U = np.array([0.3, 1.2, 0.5, 4.0, 0.7, 2.0]), np.array([1.0, -2.0])  # leaning, driving and turning
FORCE, MOMENT, SLOPE = 0.5, 0.03, 0.1
WORLD = np.array([FORCE, MOMENT, math.sin(SLOPE), math.cos(SLOPE)])
TINY = 1e-100  # complex step: exact to rounding
ROUNDING = 1e-13  # a few hundred operations on doubles


def test_the_generated_files_are_current():
    for name, text in sources().items():
        assert Path(generated.__file__).with_name(name).read_text("utf-8") == text, (
            f"run python -m upright.compiled.trace: {name}"
        )


def slopes(x=X, u=U, p=NUMBERS, force=FORCE, moment=MOMENT, model="complete"):
    parameters = SimpleNamespace(**dict(zip(PARAMETERS, p, strict=True)))
    return np.array(derivative(x, u, parameters, Disturbance(force, moment / force, SLOPE), cmath, model))


def by_complex_step(at, name):
    """∂ẋ/∂`name` from the definition itself."""
    steps = np.eye(len(at)) * 1j * TINY
    return np.column_stack([slopes(**{name: at + step}).imag / TINY for step in steps])


def close(found, true):
    return np.abs(found - true).max() <= ROUNDING * np.abs(true).max()


@pytest.mark.parametrize("model", ["complete", "published"])
def test_the_traced_derivative_equals_the_definition(model):
    c = sensitivity.constants(NUMBERS, float(model == "complete"))
    assert close(sensitivity.derivative(X, U, WORLD, c), slopes(model=model).real)


def test_the_jacobians_equal_complex_steps_of_the_definition():
    c = sensitivity.constants(NUMBERS, 1.0)
    _, fx, fu, fw, fc = sensitivity.jacobians(X, U, WORLD, c)
    assert close(fx, by_complex_step(X, "x"))
    assert close(fu, by_complex_step(U, "u"))
    assert close(fc @ sensitivity.constants_jacobian(NUMBERS, 1.0), by_complex_step(NUMBERS, "p"))
    force = (slopes(force=FORCE + 1j * TINY).imag / TINY, slopes(moment=MOMENT + 1j * TINY).imag / TINY)
    assert close(fw, np.column_stack(force))


def test_tangents_of_a_trajectory_equal_differences_of_trajectories():
    commands = np.random.default_rng(0).normal(size=(50, 2))
    start = np.array([0.05, 0.0, 0.0, 0.0, 0.0, 0.0])
    found = sensitivity.simulate_with_sensitivities(ROUGH, commands, 0.01, ["com_height", "start/pitch"], start=start)

    def states(robot, x):
        return sensitivity.simulate_with_sensitivities(robot, commands, 0.01, [], start=x).states

    step = 1e-6  # relative for the height: truncation 1e-12 and cancellation 1e-10, both times the growth over 0.5 s
    height = ROUGH.com_height * step
    robots = [ROUGH.replace(com_height=ROUGH.com_height + sign * height) for sign in (1, -1)]
    by_height = (states(robots[0], start) - states(robots[1], start)) / (2 * height)
    nudge = np.array([step, 0, 0, 0, 0, 0])
    by_pitch = (states(ROUGH, start + nudge) - states(ROUGH, start - nudge)) / (2 * step)
    for column, true in enumerate((by_height, by_pitch)):
        assert np.abs(found.tangents[:, :, column] - true).max() < 1e-6 * np.abs(true).max()


def test_sixteen_directions_at_once_are_each_the_one_alone():
    names = [name for name in PARAMETERS if name not in ("stiction_rate", "body_depth", "body_height")]
    directions = [*names[:13], "start/pitch", "start/wheel_rate", "start/yaw"]
    assert len(directions) == sensitivity.DIRECTIONS == 16
    commands = np.random.default_rng(1).normal(size=(20, 2))
    together = sensitivity.simulate_with_sensitivities(ROUGH, commands, 0.01, directions).tangents
    for column, direction in enumerate(directions):
        alone = sensitivity.simulate_with_sensitivities(ROUGH, commands, 0.01, [direction]).tangents[:, :, 0]
        # the same sums, but perhaps in other vector instructions: rounding, in numbers of very different size
        assert np.abs(together[:, :, column] - alone).max() <= 1e-12 * np.abs(alone).max()
        assert np.abs(alone).max() > 0
