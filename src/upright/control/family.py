"""Many robots under one output feedback: the linear loops' costs, all at once.

Only the pitch plane is used, with equal commands to both motors. Yaw is stable for every robot and needs no robust
design. The observer of the nominal robot is z⁺ = A z + B y + b_u u + b_a a, and u = −k (X z + X_y y). So the loop of
each robot,

    χ⁺ = (M − b k F) χ + G w        χ = [the robot, commands on their way, z],    F = [X_y C, X]

is driven by white noise w: a push, an error of the motors, the sensors' noise. The cost is E[xᵀWx + uᵀRu] in a period,
from the covariance Σ = A Σ Aᵀ + G Gᵀ, found by doubling for all robots together.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array
from upright.control.delay import SampledRobot, sent
from upright.control.kalman import DISTURBED, Disturbed, Filter
from upright.control.observer import observer
from upright.control.state_space import kept, plant_of
from upright.physics.linear import LinearModel
from upright.signals import STATE_NAMES

_DOUBLINGS = 18  # 2¹⁸ periods: an hour, after which a loop that still remembers its start counts as unstable


def halves(names: Sequence[str], sign: float = 1.0) -> tuple[Array, Array]:
    """`spread` (n, m) and `gather` (m, n) of the states that equal commands move, or opposed ones (`sign` −1).

    Left and right of a pair are one state; those of the other half are gone.
    """
    columns: list[Array] = []
    for i, name in enumerate(names):
        paired = "right" in name
        turns = name in STATE_NAMES[4:]
        column = np.zeros(len(names))
        column[i] = 1.0
        if paired:
            column[names.index(name.replace("right", "left"))] = sign
        if paired or ("left" not in name and turns == (sign < 0)):
            columns.append(column)
    spread = np.column_stack(columns)
    return spread, np.asarray(np.linalg.pinv(spread), dtype=np.float64)


def half(plant: LinearModel, sign: float = 1.0) -> LinearModel:
    """The plant under equal commands of both motors, or opposed ones with the right motor positive (`sign` −1): its one
    input is that command, and the states that only the other half moves are gone."""
    spread, gather = halves(plant.states, sign)
    B = gather @ plant.B @ np.array([[sign], [1.0]])
    return LinearModel(gather @ plant.A @ spread, B, plant.C @ spread, dt=plant.dt)


@dataclass(frozen=True, eq=False)
class Plane:
    """One robot's pitch plane: A (n, n), b (n,), C (2, n) to the encoders' mean and the gyro, G (n, 2).

    G is for push and motor noise. The first four states are pitch, pitch rate, wheel and wheel rate.
    """

    A: Array
    b: Array
    C: Array
    G: Array


def plane(model: SampledRobot, disturbed: Disturbed = DISTURBED) -> Plane:
    """The pitch plane of `model`, which reads both encoders and the gyro."""
    whole = plant_of(model)
    keep = kept(model)
    motor = disturbed.motor_size(model.robot) / np.sqrt(2)
    entering = np.zeros((len(whole.A), 2))
    entering[: len(keep), 0] = model.linear.E[keep, 0] * disturbed.push_size(model.robot)
    entering[: len(keep), 1] = (model.now + model.before)[keep].sum(axis=1) * motor
    both = half(whole)
    C = np.vstack([both.C[:2].sum(axis=0) / 2, both.C[2]])
    return Plane(both.A, both.B[:, 0], C, halves(whole.states)[1] @ entering)


@dataclass(frozen=True, eq=False)
class LoopFamily:
    """The loops of several planes (first axis) with one observer, affine in the gain k (m,) on ξ: see above.

    `N` (n, 2) is how the readings' noise enters besides through u, `Fy` (m, 2) how through ξ.
    """

    M: Array
    b: Array
    F: Array
    G: Array
    N: Array
    Fy: Array
    noise: Array

    def costs(self, k: Array, W: Array, price: float) -> Array:
        """E[xᵀWx + price u²] (robots,) with W (4, 4) on the first four states; infinite where unstable."""
        row = k @ self.F
        closed = self.M - self.b[:, :, None] * row
        entering = np.concatenate([self.G, self._noise(k)], axis=2)
        covariance = entering @ entering.swapaxes(1, 2)
        with np.errstate(over="ignore", invalid="ignore"):
            power = closed
            for _ in range(_DOUBLINGS):
                covariance = covariance + power @ covariance @ power.swapaxes(1, 2)
                power = power @ power
            size = np.abs(power).max(axis=(1, 2))
            command = np.einsum("i,kij,j->k", row, covariance, row) + float(((k @ self.Fy) ** 2) @ self.noise)
            cost = np.einsum("ij,kji->k", W, covariance[:, :4, :4]) + price * command
        return np.where((size < 0.5) & np.isfinite(cost), cost, np.inf)

    def direct(self, k: Array, W: Array, price: float) -> float:
        """The cost of the first loop by SciPy's solution of its Lyapunov equation."""
        from scipy.linalg import solve_discrete_lyapunov

        row = k @ self.F
        closed = self.M[0] - np.outer(self.b[0], row)
        entering = np.hstack([self.G[0], self._noise(k)[0]])
        covariance = np.asarray(solve_discrete_lyapunov(closed, entering @ entering.T), dtype=np.float64)
        command = row @ covariance @ row + float(((k @ self.Fy) ** 2) @ self.noise)
        return float(np.sum(W * covariance[:4, :4]) + price * command)

    def radii(self, k: Array) -> Array:
        """The largest |pole| of each loop."""
        return np.abs(np.linalg.eigvals(self.M - self.b[:, :, None] * (k @ self.F))).max(axis=1)

    def _noise(self, k: Array) -> Array:
        """The readings' noise through observer and command, as columns."""
        through = self.N[None] - self.b[:, :, None] * (k @ self.Fy)
        return through * np.sqrt(self.noise)

    def some(self, rows: Sequence[int]) -> LoopFamily:
        """Only these robots."""
        picked = list(rows)
        return LoopFamily(self.M[picked], self.b[picked], self.F, self.G[picked], self.N, self.Fy, self.noise)


def family(planes: Sequence[Plane], estimator: Filter) -> LoopFamily:
    """The loops of `planes`, all of one size, with the observer of the nominal robot's `estimator`."""
    model = estimator.sampled
    watch = observer(estimator)
    spread, gather = halves([*model.linear.states, *sent(model.history)])
    out, _ = halves([*STATE_NAMES, *sent(model.history)])
    into = np.linalg.pinv(out)
    both = np.ones(2)
    apart = np.array([[1.0, 0.0], [1.0, 0.0], [0.0, 1.0]])
    A, By = gather @ watch.A @ spread, gather @ watch.By @ apart
    Bu, Ba = gather @ watch.Bu @ both, gather @ watch.Ba @ both
    X, Xy = into @ watch.C[:-1] @ spread, into @ watch.Dy[:-1] @ apart
    n = len(planes[0].A)
    size = len(A)
    line = model.delay + bool(model.before.any())
    M = np.zeros((len(planes), n + size, n + size))
    b = np.zeros((len(planes), n + size))
    G = np.zeros((len(planes), n + size, 2))
    for i, one in enumerate(planes):
        M[i, :n, :n], M[i, n:, :n], M[i, n:, n:] = one.A, By @ one.C, A
        b[i, :n], b[i, n:], G[i, :n] = one.b, Bu, one.G
    if model.delay:
        M[:, n:, n - line + model.delay - 1] += Ba
    else:
        b[:, n:] += Ba
    F = np.hstack([Xy @ planes[0].C, X])
    N = np.vstack([np.zeros((n, 2)), By])
    variance = np.array([model.noise[0, 0] / 2, model.noise[2, 2]])
    return LoopFamily(M, b, F, G, N, Xy, variance)
