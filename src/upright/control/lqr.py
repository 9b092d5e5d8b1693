"""The discrete linear quadratic regulator."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Complex
from upright.control.feedback import StateFeedback, table_lines
from upright.errors import DesignFailed
from upright.physics.linear import LinearModel, linearise_rolling
from upright.robots import Robot, find_robot
from upright.signals import STATE_NAMES

# Bryson's rule: a deviation or a command of this size costs one.
LARGEST_STATE = (0.15, 1.5, 4.0, 15.0, 0.5, 3.0)  # [rad, rad/s, rad, rad/s, rad, rad/s]
LARGEST_COMMAND = {"V": 4.0, "N m": 0.15, "rad/s": 10.0}

_LEFT = 1e-9  # a mode that Q does not see stays on the unit circle, to rounding on either side of it


@dataclass(frozen=True, eq=False, repr=False)
class Lqr(StateFeedback):
    """The gain that minimises J = Σ xᵀQx + uᵀRu for x⁺ = Ax + Bu, with what proves it.

    `cost` is the stabilising solution P of the Riccati equation; `check()` re-computes its residual.
    """

    model: LinearModel = field(kw_only=True)
    Q: Array = field(kw_only=True)
    R: Array = field(kw_only=True)
    cost: Array = field(kw_only=True)

    def poles(self) -> Complex:
        """Eigenvalues of A − BK, largest magnitude first."""
        poles = np.linalg.eigvals(self.model.A - self.model.B @ self.gain).astype(complex)
        return poles[np.argsort(-np.abs(poles))]

    def words(self) -> list[str]:
        """K, the solution S of the Riccati equation, and the poles of the loop, without any filter."""
        cost = table_lines("S of the Riccati equation, J = xᵀS x", self.cost, STATE_NAMES)
        poles = ", ".join(f"{p:.4g}" if p.imag else f"{p.real:.4g}" for p in self.poles())
        return [*super().words(), *cost, f"Poles z of A − B K: {poles}"]

    def check(self) -> float:
        """Largest entry of AᵀPA − P − AᵀPB(R + BᵀPB)⁻¹BᵀPA + Q, relative to P's largest."""
        return riccati_residual(self.model.A, self.model.B, self.Q, self.R, self.cost)


def bryson(largest: ArrayLike) -> Array:
    """diag(1/largest²): weights from the largest accepted deviation of each (Bryson and Ho 1975)."""
    scale = np.asarray(largest, dtype=np.float64)
    with np.errstate(all="ignore"):
        weights = 1 / scale**2
    if not (scale > 0).all() or not ((weights > 0) & (weights < np.inf)).all():  # also where a square is beyond them
        raise DesignFailed(f"largest accepted deviations {scale.tolist()}", expected="positive numbers")
    return np.diag(weights)


def lqr(
    robot: Robot | str,
    dt: float,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    shown: Sequence[int] = range(len(STATE_NAMES)),
) -> Lqr:
    """The regulator of the robot linearised upright, its Coulomb friction as `rolling` has it, and held over `dt` [s].

    Q (6, 6) or its diagonal (6,), R (2, 2) or (2,); without them Bryson's rule on `LARGEST_STATE` and
    `LARGEST_COMMAND`. Only the states `shown` are regulated. Raises `DesignFailed` for weights of the wrong size or
    sign, or when no gain stabilises.
    """
    robot = find_robot(robot)
    state_weight = bryson(LARGEST_STATE) if Q is None else Q
    command_weight = bryson([LARGEST_COMMAND[robot.command_unit]] * 2) if R is None else R
    return dlqr(linearise_rolling(robot).c2d(dt), state_weight, command_weight, robot.command_unit, shown=shown)


def dlqr(
    model: LinearModel, Q: ArrayLike, R: ArrayLike, command_unit: str = "V", *, shown: Sequence[int] | None = None
) -> Lqr:
    """The regulator of a discrete linear model (Åström and Wittenmark 1997, theorem 11.2), of the states `shown` (None:
    all), which the others do not move."""
    if model.continuous:
        raise DesignFailed("the model is continuous", expected="a discrete one", hint="call model.c2d(dt)")
    weight, price = weight_matrix(Q, len(model.states), "Q"), weight_matrix(R, len(model.inputs), "R")
    weight = among(weight, range(len(weight)) if shown is None else shown)
    if np.linalg.eigvalsh(price)[0] <= 0:
        raise DesignFailed("R is not positive definite", expected="a price on every command", hint="raise its diagonal")
    cost, gain = riccati(model, weight, price, shown)
    return Lqr(gain, model.dt, command_unit, "lqr", model=model, Q=weight, R=price, cost=cost)


def among(matrix: Array, kept: Sequence[int]) -> Array:
    """The matrix, zero in all rows and columns but those `kept`."""
    result = np.zeros_like(matrix)
    chosen = np.ix_(kept, kept)
    result[chosen] = matrix[chosen]
    return result


def riccati(model: LinearModel, Q: Array, R: Array, kept: Sequence[int] | None = None) -> tuple[Array, Array]:
    """The stabilising solution P of the discrete Riccati equation and its gain K; `DesignFailed` where none is.

    Both are zero but for the states `kept` (None: all), which the others neither move nor burden by Q.
    """
    from scipy.linalg import LinAlgError, solve_discrete_are

    if kept is not None and len(kept) < len(model.A):
        part = LinearModel(model.A[np.ix_(kept, kept)], model.B[kept], dt=model.dt)
        cost = np.zeros_like(model.A)
        gain = np.zeros_like(model.B.T)
        cost[np.ix_(kept, kept)], gain[:, kept] = riccati(part, Q[np.ix_(kept, kept)], R)
        return cost, gain
    A, B = model.A, model.B
    cost: Array = np.full_like(A, np.nan)
    with contextlib.suppress(LinAlgError, ValueError):
        cost = np.asarray(solve_discrete_are(A, B, Q, R), dtype=np.float64)
    gain = np.asarray(np.linalg.solve(R + B.T @ cost @ B, B.T @ cost @ A), dtype=np.float64)
    if not np.isfinite(cost).all() or np.abs(np.linalg.eigvals(A - B @ gain)).max() > 1 - _LEFT:
        raise DesignFailed(
            "no gain stabilises this model under these weights",
            expected="every unstable or weightless mode to be reached by the commands and seen by Q",
            likely="a zero on the diagonal of Q for wheel or yaw, or a period too long for the robot",
            hint="give every state a weight, or shorten the period",
        )
    return cost, gain


def weight_matrix(weight: ArrayLike, size: int, name: str) -> Array:
    """A symmetric, non-negative (size, size) from a matrix or its diagonal; `DesignFailed` says what is wrong."""
    matrix = np.array(weight, dtype=np.float64)
    matrix = np.diag(matrix) if matrix.ndim == 1 else matrix
    if matrix.shape != (size, size):
        raise DesignFailed(
            f"{name} has shape {np.shape(weight)}", expected=f"({size}, {size}) or its diagonal ({size},)"
        )
    if not np.isfinite(matrix).all() or not np.allclose(matrix, matrix.T) or np.linalg.eigvalsh(matrix)[0] < -1e-12:
        raise DesignFailed(f"{name} is not a symmetric, non-negative matrix", expected="weights of zero or more")
    return matrix


def riccati_residual(A: Array, B: Array, Q: Array, R: Array, P: Array) -> float:
    """Largest entry of AᵀPA − P − AᵀPB(R + BᵀPB)⁻¹BᵀPA + Q, relative to P's largest."""
    coupling = A.T @ P @ B
    residual = A.T @ P @ A - P - coupling @ np.linalg.solve(R + B.T @ P @ B, coupling.T) + Q
    return float(np.abs(residual).max() / np.abs(P).max())
