"""Linear systems in loops and beside one another, under the names of python-control."""

from __future__ import annotations

import numpy as np

from upright.arrays import Array
from upright.physics.linear import LinearModel, one_period


def lft(plant: LinearModel, controller: LinearModel) -> LinearModel:
    """`controller` from the last outputs of `plant` to its last inputs, the lower linear fractional transformation
    (Zhou and Doyle 1998, chapter 9). The plant's states come first.

    Raises `InvalidModel` for different periods.
    """
    one_period(plant, controller)
    P = plant
    K = controller
    m, p = K.D.shape
    inputs = P.B.shape[1] - m
    outputs = len(P.C) - p
    Bw, Bu = np.split(P.B, [inputs], axis=1)
    Cz, Cy = np.split(P.C, [outputs])
    (Dzw, Dzu), (Dyw, Dyu) = (np.split(rows, [inputs], axis=1) for rows in np.split(P.D, [outputs]))
    back = np.linalg.inv(np.eye(p) - Dyu @ K.D)  # y = back (Cy x + Dyw w + Dyu Ck x_k)
    y = back @ Cy
    w = back @ Dyw
    k = back @ Dyu @ K.C
    A = np.block([[P.A + Bu @ K.D @ y, Bu @ (K.C + K.D @ k)], [K.B @ y, K.A + K.B @ k]])
    B = np.vstack([Bw + Bu @ K.D @ w, K.B @ w])
    C = np.hstack([Cz + Dzu @ K.D @ y, Dzu @ (K.C + K.D @ k)])
    return LinearModel(A, B, C, Dzw + Dzu @ K.D @ w, P.dt)


def feedback(forward: LinearModel, back: LinearModel, sign: float = -1.0) -> LinearModel:
    """From r to y = forward (r + sign · back y), of a sign of 1 or −1."""
    B = np.hstack([forward.B, forward.B])
    C = np.vstack([forward.C, forward.C])
    return lft(LinearModel(forward.A, B, C, np.tile(forward.D, (2, 2)), forward.dt), back if sign > 0 else -back)


def append(one: LinearModel, other: LinearModel) -> LinearModel:
    """Both beside one another, without a signal between them."""
    one_period(one, other)
    A, B, C, D = (_diagonal(getattr(one, name), getattr(other, name)) for name in "ABCD")
    return LinearModel(A, B, C, D, one.dt)


def _diagonal(first: Array, second: Array) -> Array:
    (n, m), (p, q) = first.shape, second.shape
    return np.block([[first, np.zeros((n, q))], [np.zeros((p, m)), second]])
