"""The steady Kalman filter of a sampled robot: gyro bias, a constant push and every late sensor are states."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.control.delay import GYRO, SampledRobot
from upright.control.lqr import LARGEST_COMMAND, riccati_residual
from upright.errors import DesignFailed
from upright.physics.dynamics import motor_gain

Array = NDArray[np.float64]

NXTWAY_WEIGHT = 6.0  # [N] of the body of NXTway-GS, to which pushes are scaled


@dataclass(frozen=True, kw_only=True)
class Disturbed:
    """What moves a robot besides its commands, each period: standard deviations.

    `push` [N] on a body of 6 N; `motor` as a share of the largest usual command, besides the robot's Coulomb friction,
    which no linear filter knows the sign of; walks of the steady push by `push_walk` [N/√s] and of the gyro's bias by
    `bias_walk` [rad/s/√s], or by the kit's own figure where it is larger.
    """

    push: float = 0.05
    push_walk: float = 0.3
    motor: float = 0.02
    bias_walk: float = 1e-3


DISTURBED = Disturbed()

RECOVERED = Disturbed(motor=0.2)
"""More noise than motors make, where the command enters: it gives a regulator behind a filter its margins back (Doyle
and Stein 1979). On nxtway-gs the smallest gain that fells an LQG rises from 1.09 to 1.29 of its own; with more of it
ev3way falls when it is let go from −0.12 rad."""

OFFSET_FREE = Disturbed(push_walk=0.1)
"""For a method that leans against the push it sees, which is one more loop round the dead time: a push is believed the
more slowly the later it is seen (`offset_free`). Believed as fast as by `DISTURBED`, 0.5 ms more dead time fells
TWIPR."""

PROMPT = 0.025  # [s] from command to reading, up to which a push is believed as fast as `OFFSET_FREE` says


@dataclass(frozen=True, eq=False)
class Filter:
    """The steady Kalman filter of a `SampledRobot`: p̂ = p + L (y − C p), with P the covariance before a reading."""

    seen: SampledRobot
    W: Array
    P: Array
    L: Array

    def check(self) -> float:
        """Largest entry of A P Aᵀ − P − A P Cᵀ(C P Cᵀ + V)⁻¹C P Aᵀ + W, relative to P's largest."""
        return riccati_residual(self.seen.A.T, self.seen.C.T, self.W, self.seen.noise, self.P)


def kalman_filter(seen: SampledRobot, disturbed: Disturbed = DISTURBED) -> Filter:
    """The steady filter; raises `DesignFailed` where it has no solution."""
    W = _process_noise(seen, disturbed)
    solution = _steady(seen.A, seen.C, W, seen.noise)
    if solution is None:
        raise DesignFailed(
            f"no steady Kalman filter for '{seen.robot.name}' at {seen.dt:g} s",
            expected="every state to be seen by the sensors", likely="too few sensors, or a period too long",
            hint="read both encoders and the gyro, or shorten the period",
        )  # fmt: skip
    return Filter(seen, W, *solution)


def offset_free(seen: SampledRobot) -> Disturbed:
    """`OFFSET_FREE` for the dead time of this robot."""
    kit = seen.kit
    late = kit.delay + kit.jitter / 2 + max((kit.sensors[n].delay for n in seen.reads if n in kit.sensors), default=0.0)
    return replace(OFFSET_FREE, push_walk=OFFSET_FREE.push_walk * min(1.0, PROMPT / max(late, PROMPT)))


def _steady(A: Array, C: Array, W: Array, V: Array) -> tuple[Array, Array] | None:
    """P and L of the stabilising solution, None where there is none."""
    from scipy.linalg import LinAlgError, solve_discrete_are

    try:
        P = solve_discrete_are(A.T, C.T, W, V)
        L = np.linalg.solve(C @ P @ C.T + V, C @ P).T
    except (LinAlgError, ValueError):
        return None
    return (P, L) if np.abs(np.linalg.eigvals(A - A @ L @ C)).max() < 1 else None


def _process_noise(seen: SampledRobot, disturbed: Disturbed) -> Array:
    robot, names, n = seen.robot, seen.names, len(seen.A)
    weight = robot.body_mass * robot.gravity / NXTWAY_WEIGHT
    motor = disturbed.motor * LARGEST_COMMAND[robot.command_unit] + robot.coulomb_friction / motor_gain(robot)
    root = math.sqrt(seen.dt)
    columns = [seen.pushed * disturbed.push * weight, *((seen.now + seen.before) * motor).T]
    walks = {"push": disturbed.push_walk * weight * root}
    if "gyro_bias" in names:
        walks["gyro_bias"] = max(disturbed.bias_walk, seen.kit.sensors[GYRO].bias_walk) * root
    columns += [np.eye(n)[names.index(name)] * size for name, size in walks.items()]
    G = np.column_stack(columns)
    return G @ G.T + 1e-14 * np.eye(n)
