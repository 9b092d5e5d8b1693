"""Quadratic costs: weights by Bryson's rule, and the discrete Riccati equation."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.errors import DesignFailed
from upright.physics.linear import LinearModel

# Bryson's rule: a deviation or a command of this size costs one.
LARGEST_STATE = (0.15, 1.5, 4.0, 15.0, 0.5, 3.0)  # [rad, rad/s, rad, rad/s, rad, rad/s]
LARGEST_COMMAND = {"V": 4.0, "N m": 0.15, "rad/s": 10.0}

_LEFT = 1e-9  # a mode that Q does not see stays on the unit circle, to rounding on either side of it


def bryson(largest: ArrayLike) -> Array:
    """diag(1/largest²): weights from the largest accepted deviation of each (Bryson and Ho 1975)."""
    scale = np.asarray(largest, dtype=np.float64)
    with np.errstate(all="ignore"):
        weights = 1 / scale**2
    if not (scale > 0).all() or not ((weights > 0) & (weights < np.inf)).all():  # also where a square is beyond them
        raise DesignFailed(f"largest accepted deviations {scale.tolist()}", expected="positive numbers")
    return np.diag(weights)


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


def state_weight(Q: ArrayLike | None, largest: Sequence[float] = LARGEST_STATE) -> Array:
    """Q, or its diagonal, or Bryson's rule on the `largest` deviations."""
    return weight_matrix(bryson(largest) if Q is None else Q, len(largest), "Q")


def command_weight(unit: str, R: ArrayLike | None) -> Array:
    """R (2, 2), or its diagonal, or Bryson's rule on the usual command in that `unit`, positive definite."""
    return price_matrix(bryson([LARGEST_COMMAND[unit]] * 2) if R is None else R, 2)


def price_matrix(R: ArrayLike, size: int) -> Array:
    """A positive definite (size, size) from a matrix or its diagonal."""
    price = weight_matrix(R, size, "R")
    if np.linalg.eigvalsh(price)[0] <= 0:
        raise DesignFailed("R is not positive definite", expected="a price on every command", hint="raise its diagonal")
    return price
