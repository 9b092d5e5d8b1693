"""A predictor-based subspace method, valid in closed loop (PBSID_opt; Chiuso 2007, van der Veen et al. 2013).

A regression on a long past predicts the next outputs; its predictions of several future outputs, from the past alone,
span the states. Their singular values show how many there are. With the states known, A, B, C and the gain K of the
innovations follow from least squares, in which nothing is correlated with what feedback made of the noise.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from upright.arrays import Array, Whole
from upright.identification.arx import Arx, arx, longer, past_window
from upright.identification.coordinates import PHYSICAL, physical
from upright.identification.samples import Part
from upright.physics.linear import LinearModel

LARGEST = 4  # states beyond the physical ones that are tried: a fraction of a dead time, sensors that lag
FUTURE = 0.5  # rows predicted over rows of the past


@dataclass(frozen=True, eq=False)
class InnovationModel:
    """The `plant` x⁺ = A x + b u + K e + `offset`, y = C x + e + `level`; e (rows, outputs) are the fit's innovations.

    The states have the coordinates of the singular values; `physical` gives them those of the robot.
    """

    plant: LinearModel
    K: Array
    e: Array
    offset: Array
    level: Array

    @property
    def predictor(self) -> Array:
        """A − K C, by which the predictor forgets its start."""
        return self.plant.A - self.K @ self.plant.C

    @property
    def predicts(self) -> bool:
        """Whether the predictor is stable."""
        return bool(np.abs(np.linalg.eigvals(self.predictor)).max() < 1)

    def one_step(self, y: Array, u: Array) -> Array:
        """Innovations (n, outputs) of the predictor along a log, from a state of zero."""
        x = np.zeros(len(self.plant.A))
        predicted = np.empty_like(y)
        F = self.predictor
        C = self.plant.C
        into = (y - self.level) @ self.K.T + np.outer(u, self.plant.B[:, 0]) + self.offset
        for k in range(len(y)):
            predicted[k] = C @ x
            x = F @ x + into[k]
        return y - self.level - predicted


@dataclass(frozen=True, eq=False)
class States:
    """The past's prediction of `part`, before an order is chosen: `singular` values and their directions."""

    part: Part
    rows: Whole
    vectors: Array
    singular: Array

    def of_order(self, order: int) -> InnovationModel:
        """A, B, C and K of `order` states."""
        x = self.vectors[:, :order] * np.sqrt(self.singular[:order])
        y = self.part.y[self.rows]
        u = self.part.u[self.rows]
        one = np.ones((len(self.rows), 1))
        now = np.column_stack([x, one])
        D: Array = np.linalg.lstsq(now, y, rcond=None)[0].astype(np.float64)
        e = y - now @ D
        moved = np.column_stack([x, u, e, one])[:-1]
        P: Array = np.linalg.lstsq(moved, x[1:], rcond=None)[0].astype(np.float64)
        n = order
        m = y.shape[1]
        plant = LinearModel(P[:n].T, P[n][:, None], D[:n].T, dt=self.part.dt, outputs=self.part.outputs)
        return InnovationModel(plant, P[n + 1 : n + 1 + m].T, e, P[-1], D[-1])


def predicted_states(part: Part, past: int | None = None) -> States:
    """What `past` rows (default: `longer` than Akaike's choice) predict of the future outputs, as singular vectors."""
    lags = past or longer(past_window(part.y, part.u), part.y)
    model = arx(part.y, part.u, lags)
    future = max(int(lags * FUTURE), len(PHYSICAL[part.name]) + LARGEST)
    predicted = _past(part, model.rows, lags) @ _observability(model, future).T
    predicted -= predicted.mean(axis=0)
    inverse = np.linalg.inv(np.linalg.cholesky(_covariance(model.e)))
    vectors, singular, _ = np.linalg.svd(predicted @ np.kron(np.eye(future), inverse).T, full_matrices=False)
    return States(part, model.rows, vectors, singular)


def subspace(part: Part, order: int, past: int | None = None) -> LinearModel:
    """The half's model of `order` states in physical coordinates."""
    return physical(part.name, predicted_states(part, past).of_order(order).plant)


def _covariance(e: Array) -> Array:
    S = e.T @ e / len(e)
    return S + 1e-12 * np.trace(S) * np.eye(len(S)) + 1e-30 * np.eye(len(S))


def _past(part: Part, rows: Whole, lags: int) -> Array:
    """[y, u] of the last `lags` rows, newest first (rows, lags · (outputs + 1))."""
    both = np.column_stack([part.y, part.u])
    return np.concatenate([both[rows - i] for i in range(1, lags + 1)], axis=1)


def _observability(model: Arx, future: int) -> Array:
    """Block i predicts y[k+i] from the past alone: the coefficients, shifted by i (upper triangular)."""
    lags, m, _ = model.A.shape
    Z = np.zeros((future, m, lags, m + 1))
    for i in range(min(future, lags)):
        Z[i, :, : lags - i, :m] = model.A[i:].transpose(1, 0, 2)
        Z[i, :, : lags - i, m] = model.b[i:].T
    return Z.reshape(future * m, lags * (m + 1))
