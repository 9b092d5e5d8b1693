"""Refined instrumental variables in closed loop (Gilson and Van den Hof 2005; Gilson et al. 2011).

Regressors are correlated with the noise in the equation, since readings are noisy and feedback makes commands of them.
Instruments are not: the same regressors as the excitation alone would have made them, simulated with the law that the
log shows. Both are filtered until the equation's error is white, which makes the estimate precise; model, instruments
and filter are result in turn.
"""

from __future__ import annotations

import numpy as np

from upright.arrays import Array
from upright.errors import InvalidModel
from upright.identification.arx import Regression, regression, split
from upright.identification.coordinates import physical, with_sent
from upright.identification.joint import law, simulated
from upright.identification.samples import Part
from upright.identification.subspace import InnovationModel
from upright.physics.linear import LinearModel

ITERATIONS = 2  # of model, instruments and filter: the first's instruments are valid, the second's nearly optimal
WHITENING = 20  # lags of the filter that whitens an equation's error


def instrumental(part: Part, start: InnovationModel) -> LinearModel:
    """The half's model, whose first instruments are simulated with `start`; later ones with their result.

    Each output is regressed on as many lags as its observability index asks for, and on one command more, which holds
    the fraction of a period of dead time. Raises `InvalidModel` where the instruments are too weak.
    """
    lags = 1 if part.states else 2
    rule = law(part)
    plant = start.plant
    data = regression(part.y, part.u, lags, lags + 1)
    model = None
    waiting = np.zeros(0)
    for _ in range(ITERATIONS):
        quiet = simulated(part, plant, rule)
        if quiet is None and model:  # the first iteration's instruments are valid, if not the best
            break
        Z = _delayed(data, lags) if quiet is None else regression(quiet[0][0], quiet[1][0], lags, lags + 1).X
        model, waiting = realised(part, _estimated(data, Z), lags)
        plant = with_sent(part.name, model, waiting)
    assert model is not None
    return physical(part.name, model, waiting)


def _estimated(data: Regression, Z: Array) -> Array:
    """Coefficients by the instruments Z, each equation whitened by what is left of it without that."""
    plain = _solved(Z, data.X, data.Y)
    e = data.Y - data.X @ plain
    return np.column_stack([_filtered(Z, data, e[:, j], j) for j in range(data.Y.shape[1])])


def _delayed(data: Regression, lags: int) -> Array:
    """Older regressors, which share no reading's noise: for where model and law make no stable loop to simulate. They
    are valid in closed loop as well, but weaker."""
    apart = lags + 2
    Z = np.zeros_like(data.X)
    Z[apart:], Z[:, -1] = data.X[:-apart], 1.0
    return Z


def _filtered(Z: Array, data: Regression, e: Array, j: int) -> Array:
    """One equation's coefficients with everything filtered by what whitens its error."""
    from scipy.signal import lfilter

    if float(e @ e) < 1e-20 * float(data.Y[:, j] @ data.Y[:, j]):
        return _solved(Z, data.X, data.Y[:, j])
    past = np.column_stack([e[WHITENING - i : len(e) - i] for i in range(1, WHITENING + 1)])
    filter_ = np.append(1.0, -np.linalg.lstsq(past, e[WHITENING:], rcond=None)[0])
    Zf, Xf = (np.asarray(lfilter(filter_, 1.0, M, axis=0))[WHITENING:] for M in (Z, data.X))
    return _solved(Zf, Xf, np.asarray(lfilter(filter_, 1.0, data.Y[:, j]))[WHITENING:])


def _solved(Z: Array, X: Array, Y: Array) -> Array:
    """(ZᵀX)⁻¹ZᵀY, columns scaled first."""
    scale = np.maximum(np.linalg.norm(X, axis=0), 1e-300)
    size = np.maximum(np.linalg.norm(Z, axis=0), 1e-300)
    moment = (Z / size).T @ (X / scale)
    if not np.isfinite(moment).all() or np.linalg.cond(moment) > 1e12:
        raise InvalidModel("the instruments do not tell the regressors apart", likely="too little excitation")
    solution = np.linalg.solve(moment, (Z / size).T @ Y)
    return solution / (scale[:, None] if Y.ndim == 2 else scale)


def realised(part: Part, P: Array, lags: int) -> tuple[LinearModel, Array]:
    """The observer form of the coefficients P, and how the command of one period ago still enters it (states,)."""
    m = len(part.outputs)
    A_i, b_i = split(P, m, lags, lags + 1)
    n = m * lags
    A = np.zeros((n, n))
    waiting = np.zeros(n)
    A[:, :m], A[: n - m, m:] = A_i.reshape(n, m), np.eye(n - m)
    waiting[n - m :] = b_i[lags]
    B = b_i[:lags].reshape(n, 1)
    C = np.eye(m, n)
    return LinearModel(A, B, C, dt=part.dt, outputs=part.outputs), waiting
