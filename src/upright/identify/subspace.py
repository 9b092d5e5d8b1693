"""A predictor-based subspace method, valid in closed loop (PBSID_opt; Chiuso 2007, van der Veen et al. 2013).

A regression on a long past foretells the next outputs; what it says of several outputs to come, given the past alone,
spans the states. Their singular values show how many there are. With the states known, A, B, C and the gain K of the
innovations follow from least squares, in which nothing is correlated with what feedback made of the noise.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from upright.identify.arx import Arx, arx, longer, past_window
from upright.identify.coordinates import PHYSICAL, PartModel, physical
from upright.identify.samples import Part

Array = NDArray[np.float64]

LARGEST = 4  # states beyond the physical ones that are tried: a fraction of a dead time, sensors that lag
FUTURE = 0.5  # rows foretold, as a share of the past


@dataclass(frozen=True, eq=False)
class Innovation:
    """x⁺ = A x + b u + K e + a constant, y = C x + e + a constant; e (rows, outputs) are the innovations of the fit.

    The matrices stand in the coordinates that the singular values gave; `part` turns them into physical ones.
    """

    A: Array
    b: Array
    C: Array
    K: Array
    e: Array
    offset: Array
    level: Array

    @property
    def foretells(self) -> bool:
        """Whether the predictor A − K C forgets its start."""
        return bool(np.abs(np.linalg.eigvals(self.A - self.K @ self.C)).max() < 1)

    def one_step(self, y: Array, u: Array) -> Array:
        """Innovations (n, outputs) of the predictor along a log, from a state of zero."""
        x, found, F = np.zeros(len(self.A)), np.empty_like(y), self.A - self.K @ self.C
        into = (y - self.level) @ self.K.T + np.outer(u, self.b) + self.offset
        for k in range(len(y)):
            found[k] = self.C @ x
            x = F @ x + into[k]
        return y - self.level - found


@dataclass(frozen=True, eq=False)
class States:
    """What the past foretells, before an order is chosen: `singular` values and the directions that belong to them."""

    rows: NDArray[np.int64]
    vectors: Array
    singular: Array
    y: Array
    u: Array

    def of_order(self, order: int) -> Innovation:
        """A, B, C and K of `order` states."""
        x = self.vectors[:, :order] * np.sqrt(self.singular[:order])
        y, u, one = self.y[self.rows], self.u[self.rows], np.ones((len(self.rows), 1))
        now = np.column_stack([x, one])
        D: Array = np.linalg.lstsq(now, y, rcond=None)[0].astype(np.float64)
        e = y - now @ D
        moved = np.column_stack([x, u, e, one])[:-1]
        P: Array = np.linalg.lstsq(moved, x[1:], rcond=None)[0].astype(np.float64)
        n, m = order, y.shape[1]
        return Innovation(P[:n].T, P[n], D[:n].T, P[n + 1 : n + 1 + m].T, e, P[-1], D[-1])


def predicted_states(part: Part, past: int | None = None) -> States:
    """What a past of `past` rows (default: `longer` than Akaike's choice) foretells of the outputs to come, as singular
    vectors."""
    lags = past or longer(past_window(part.y, part.u), part.y)
    found = arx(part.y, part.u, lags)
    future = max(int(lags * FUTURE), len(PHYSICAL[part.name]) + LARGEST)
    foretold = _past(part, found.rows, lags) @ _observability(found, future).T
    foretold -= foretold.mean(axis=0)
    inverse = np.linalg.inv(np.linalg.cholesky(_covariance(found.e)))
    vectors, singular, _ = np.linalg.svd(foretold @ np.kron(np.eye(future), inverse).T, full_matrices=False)
    return States(found.rows, vectors, singular, part.y, part.u)


def subspace(part: Part, order: int, past: int | None = None) -> PartModel:
    """The half's model of `order` states in physical coordinates."""
    model = predicted_states(part, past).of_order(order)
    return physical(part.name, part.outputs, model.A, model.b, model.C, part.dt)


def _covariance(e: Array) -> Array:
    S = e.T @ e / len(e)
    return S + 1e-12 * np.trace(S) * np.eye(len(S)) + 1e-30 * np.eye(len(S))


def _past(part: Part, rows: NDArray[np.int64], lags: int) -> Array:
    """[y, u] of the last `lags` rows, newest first (rows, lags · (outputs + 1))."""
    both = np.column_stack([part.y, part.u])
    return np.concatenate([both[rows - i] for i in range(1, lags + 1)], axis=1)


def _observability(found: Arx, future: int) -> Array:
    """Block i says what the past alone foretells of y[k+i]: the coefficients, shifted by i (upper triangular)."""
    lags, m, _ = found.A.shape
    Z = np.zeros((future, m, lags, m + 1))
    for i in range(min(future, lags)):
        Z[i, :, : lags - i, :m] = found.A[i:].transpose(1, 0, 2)
        Z[i, :, : lags - i, m] = found.b[i:].T
    return Z.reshape(future * m, lags * (m + 1))
