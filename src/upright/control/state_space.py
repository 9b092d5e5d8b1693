"""The robot under its commands and a linear controller as linear models, and the bilinear map between both times."""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from upright.control.delay import SampledRobot, behind_dead_time, sent
from upright.control.linear_controller import LinearController
from upright.errors import InvalidModel
from upright.physics.interconnect import lft
from upright.physics.linear import LinearModel, delay_line
from upright.signals import STATE_NAMES


def continuous(system: LinearModel) -> LinearModel:
    """The system itself, or a discrete one under z = (1 + s)/(1 − s): the unit circle becomes the imaginary axis.

    Norms, margins and stability are kept. Raises `InvalidModel` for a pole at z = −1.
    """
    if system.continuous:
        return system
    A = system.A
    identity = np.eye(len(system.A))
    if len(A) and np.linalg.cond(A + identity) > 1e12:
        raise InvalidModel("a pole at z = −1", expected="none there", hint="change the period a little")
    inverse = np.linalg.inv(A + identity)
    root = math.sqrt(2)
    D = system.D - system.C @ inverse @ system.B
    return LinearModel(inverse @ (A - identity), root * inverse @ system.B, root * system.C @ inverse, D)


def discrete(system: LinearModel, dt: float) -> LinearModel:
    """The inverse of `continuous`: s = (z − 1)/(z + 1)."""
    A = system.A
    identity = np.eye(len(system.A))
    if len(A) and np.linalg.cond(identity - A) > 1e12:
        raise InvalidModel("a pole at s = 1", expected="none there", hint="change the period a little")
    inverse = np.linalg.inv(identity - A)
    root = math.sqrt(2)
    D = system.D + system.C @ inverse @ system.B
    return LinearModel(inverse @ (identity + A), root * inverse @ system.B, root * system.C @ inverse, D, dt)


def plant_of(model: SampledRobot) -> LinearModel:
    """From both commands to the readings.

    The states are the robot's six and the readings on their way, then the commands on theirs, newest first. Gyro bias
    and push, which no command moves, are left out.
    """
    keep = kept(model)
    linear = model.linear
    line = model.delay + bool(model.before.any())
    A, B = behind_dead_time(linear.A[keep][:, keep], model.now[keep], model.before[keep], model.delay, line)
    C = np.hstack([linear.C[:, keep], np.zeros((len(linear.C), 2 * line))])
    return LinearModel(A, B, C, dt=model.dt, states=(*(linear.states[i] for i in keep), *sent(line)))


def kept(model: SampledRobot) -> list[int]:
    """Which of the names of `model` are states that the commands move."""
    return [i for i, name in enumerate(model.linear.states) if name in STATE_NAMES or "@" in name]


def controller_of(linear: LinearController, delay: int) -> LinearModel:
    """From the readings to the commands, when the command applied is the one of `delay` periods ago."""
    B = np.hstack([linear.By, linear.Ba])  # of the readings, and of the command that comes back from the motors
    D = np.hstack([linear.Dy, np.zeros((2, 2))])
    return hearing(LinearModel(linear.A, B, linear.C, D, linear.period), delay)


def hearing(system: LinearModel, delay: int) -> LinearModel:
    """A system whose last inputs are its own outputs of `delay` periods ago."""
    twice = replace(system, C=np.tile(system.C, (2, 1)), D=np.tile(system.D, (2, 1)), outputs=())
    return lft(twice, delay_line(len(system.C), delay, system.dt))
