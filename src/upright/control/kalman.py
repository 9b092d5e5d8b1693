"""The one Kalman filter: its noise, its steady gain, its step; and that of a sampled robot.

Of a robot, the gyro's bias, a constant push and the readings of every delayed sensor are states.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.control.delay import SampledRobot
from upright.control.riccati import LARGEST_COMMAND, riccati_residual
from upright.errors import DesignFailed
from upright.physics.dynamics import motor_gain
from upright.physics.sensing import GYRO
from upright.robots import Robot

NXTWAY_WEIGHT = 6.0  # [N] of the body of NXTway-GS, to which pushes are scaled


@dataclass(frozen=True, kw_only=True)
class Disturbed:
    """Standard deviations of the disturbances of a robot, each period.

    `push` [N] is for a body of 6 N. `motor` is a fraction of the largest usual command [1]; dry friction, whose
    sign no linear filter knows, is added to it. The steady push is a random walk of `push_walk` [N/√s]. The gyro's bias
    is one of `bias_walk` [rad/s/√s], or of the kit's figure where that is larger.
    """

    push: float = 0.05
    push_walk: float = 0.3
    motor: float = 0.02
    bias_walk: float = 1e-3

    def push_size(self, robot: Robot) -> float:
        """The standard deviation of the push [N], by the robot's weight."""
        return self.push * robot.body_mass * robot.gravity / NXTWAY_WEIGHT

    def motor_size(self, robot: Robot) -> float:
        """That of each command, in its unit."""
        usual = LARGEST_COMMAND[robot.command_unit]
        return self.motor * usual + (robot.coulomb_friction + robot.rolling_friction) / motor_gain(robot)

    def noise(self, model: SampledRobot) -> Array:
        """W (n, n), the covariance of what enters the states of `model` in a period."""
        robot = model.robot
        names = model.linear.states
        n = len(model.linear.A)
        root = math.sqrt(model.dt)
        walks = dict[str, float]()
        if "push" in names:
            walks["push"] = self.push_walk * robot.body_mass * robot.gravity / NXTWAY_WEIGHT * root
        if "gyro_bias" in names:
            walks["gyro_bias"] = max(self.bias_walk, model.kit.sensors[GYRO].bias_walk) * root
        columns = [
            model.linear.E[:, 0] * self.push_size(robot),
            *((model.now + model.before) * self.motor_size(robot)).T,
        ]
        columns += [np.eye(n)[names.index(name)] * size for name, size in walks.items()]
        return process_noise(np.column_stack(columns))


DISTURBED = Disturbed()

RECOVERED = Disturbed(motor=0.2)
"""More noise than motors make, where the command enters: it gives a regulator behind a filter its margins back (Doyle
and Stein 1979). On nxtway-gs the smallest gain that fells an LQG rises from 1.09 to 1.29 of its own; with more of it
ev3way falls when it is let go from −0.12 rad."""

OFFSET_FREE = Disturbed(push_walk=0.1)
"""For a method that leans against the push it sees, which is one more loop round the dead time: a push is believed the
more slowly the later it is seen (`offset_free`). Believed as fast as by `DISTURBED`, 0.5 ms more dead time fells
TWIPR."""

BADLY_SCALED = (0.0, 1e-14, 1e-12)
"""Variances added to every state: without any, one in a thousand robots with long dead times has no solution."""

PROMPT = 0.025  # [s] from command to reading, up to which a push is believed as fast as `OFFSET_FREE` says


@dataclass(frozen=True, eq=False)
class Filter:
    """The steady Kalman filter of a `SampledRobot`: p̂ = p + L (y − C p), with P the covariance before a reading."""

    sampled: SampledRobot
    W: Array
    P: Array
    L: Array

    @property
    def innovation_covariance(self) -> Array:
        """Covariance of what a reading is beside its prediction, C P Cᵀ + V."""
        C = self.sampled.linear.C
        return C @ self.P @ C.T + self.sampled.noise

    def check(self) -> float:
        """Largest entry of A P Aᵀ − P − A P Cᵀ(C P Cᵀ + V)⁻¹C P Aᵀ + W, relative to P's largest."""
        return riccati_residual(self.sampled.linear.A.T, self.sampled.linear.C.T, self.W, self.sampled.noise, self.P)


def kalman_filter(model: SampledRobot, disturbed: Disturbed = DISTURBED) -> Filter:
    """The steady filter; raises `DesignFailed` where it has no solution."""
    W = disturbed.noise(model)
    linear = model.linear
    of = f"'{model.robot.name}' at {model.dt:g} s"
    return Filter(model, W, *steady_kalman(linear.A, linear.C, W, model.noise, BADLY_SCALED, of=of))


def offset_free(model: SampledRobot) -> Disturbed:
    """`OFFSET_FREE` for the dead time of this robot."""
    kit = model.kit
    delay = (
        kit.delay + kit.jitter / 2 + max((kit.sensors[n].delay for n in model.reads if n in kit.sensors), default=0.0)
    )
    return replace(OFFSET_FREE, push_walk=OFFSET_FREE.push_walk * min(1.0, PROMPT / max(delay, PROMPT)))


def process_noise(entering: Array, least: float = 1e-14) -> Array:
    """W = G Gᵀ + `least` I (n, n), for independent white disturbances.

    They enter the states by the columns of G (n, k), each times its standard deviation. A little on every state keeps
    the Riccati equation solvable.
    """
    return entering @ entering.T + least * np.eye(len(entering))


def steady_kalman(
    A: Array, C: Array, W: Array, V: Array, more: Sequence[float] = (0.0,), *, of: str = "this model"
) -> tuple[Array, Array]:
    """P (n, n) before a reading, and L (n, p), of the steady filter x = z + L (y − C z), z⁺ = A x.

    W (n, n) is the covariance of the process noise, V (p, p) that of the readings (Anderson and Moore 1979, chapter 4).
    `more` are variances added to every state, tried one after the other where the Riccati equation is too badly scaled.
    Raises `DesignFailed`, in which it is the filter `of` something, where none has a stabilising solution.
    """
    from scipy.linalg import LinAlgError, solve_discrete_are

    for added in more:
        with contextlib.suppress(LinAlgError, ValueError):
            P: Array = np.asarray(solve_discrete_are(A.T, C.T, W + added * np.eye(len(A)), V), dtype=np.float64)
            L: Array = np.linalg.solve(C @ P @ C.T + V, C @ P).T.astype(np.float64)
            if np.isfinite(L).all() and np.abs(np.linalg.eigvals(A - A @ L @ C)).max() < 1:
                return P, L
    raise DesignFailed(
        f"no steady Kalman filter for {of}", expected="every state to be shown by the sensors",
        likely="too few sensors, a period too long, or a model far from the robot",
        hint="read both encoders and the gyro, or shorten the period",
    )  # fmt: skip


def one_step(A: Array, C: Array, L: Array) -> tuple[Array, Array, Array]:
    """F, G and H of the steady filter from prediction to prediction: z⁺ = F z + G y; after y, x = H z + L y."""
    after = np.eye(len(A)) - L @ C
    return A @ after, A @ L, after


def corrected(z: Array, y: Array, C: Array, L: Array) -> Array:
    """The state x = z + L (y − C z) after a reading: z (n,), y (p,); for k filters at once (n, k), (p, k)."""
    return z + L @ (y - C @ z)


def filtered(A: Array, C: Array, L: Array, readings: Array, moved: Array, start: Array) -> tuple[Array, Array]:
    """States (steps, n) after each of `readings` (steps, p), and innovations (steps, p); k filters on a last axis.

    The state moves by A and by `moved` (steps, n), what the commands of each period add. `start` (n,) is the first
    prediction. A missing reading (NaN) corrects nothing.
    """
    states, errors = np.empty(moved.shape), np.empty(readings.shape)
    z = start
    there = ~np.isnan(readings)
    if there.all():  # each prediction is F of the one before and what is known beforehand
        F, G, _ = one_step(A, C, L)
        added = moved + (readings @ G.T if readings.ndim == 2 else G @ readings)
        for i, more in enumerate(added):
            states[i] = z
            z = F @ z + more
        errors = readings - (states @ C.T if readings.ndim == 2 else C @ states)
        return states + (errors @ L.T if readings.ndim == 2 else L @ errors), errors
    for i, y in enumerate(readings):
        errors[i] = y - C @ z
        states[i] = z + L @ np.where(there[i], errors[i], 0.0)
        z = A @ states[i] + moved[i]
    return states, errors
