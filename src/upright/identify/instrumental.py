"""Refined instrumental variables in closed loop (Gilson and Van den Hof 2005; Gilson et al. 2011).

Regressors are correlated with the noise in the equation, since readings are noisy and feedback makes commands of them.
Instruments are not: the same regressors as the excitation alone would have made them, simulated with the law that the
log shows. Both are filtered until the equation's error is white, which makes the estimate precise; model, instruments
and filter are found in turn.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from upright.errors import InvalidModel
from upright.identify.arx import Regression, regression, split
from upright.identify.coordinates import PartModel, physical
from upright.identify.joint import law, noise_free
from upright.identify.samples import Part
from upright.identify.subspace import Innovation

Array = NDArray[np.float64]

TURNS = 2
WHITENING = 20
"""Lags of the filter that whitens an equation's error."""


def instrumental(part: Part, start: Innovation) -> PartModel:
    """The half's model, whose first instruments are simulated with `start`; later ones with what they gave.

    Each output is regressed on as many lags as its observability index asks for, and on one command more, which holds
    the fraction of a period of dead time. Raises `InvalidModel` where the instruments are too weak.
    """
    lags = 1 if part.states else 2
    rule = law(part)
    found = regression(part.y, part.u, lags, lags + 1)
    calm = noise_free(part, start.A, start.b, start.C, rule)
    turn = _turn(found, _delayed(found, lags) if calm is None else regression(*calm, lags, lags + 1).X)
    for _ in range(TURNS - 1):
        calm = noise_free(part, *_whole(*realised(turn, part.y.shape[1], lags)), rule)
        if calm is None:  # the first turn's instruments are valid, if not the best
            break
        turn = _turn(found, regression(*calm, lags, lags + 1).X)
    return _as_part(part, turn, lags)


def _turn(found: Regression, Z: Array) -> Array:
    """Coefficients by the instruments Z, each equation whitened by what is left of it without that."""
    plain = _solved(Z, found.X, found.Y)
    e = found.Y - found.X @ plain
    return np.column_stack([_filtered(Z, found, e[:, j], j) for j in range(found.Y.shape[1])])


def _delayed(found: Regression, lags: int) -> Array:
    """The regressors of so long ago that no reading's noise is in both: for where model and law make no stable loop, so
    that nothing can be simulated. They are valid in closed loop as well, but weaker."""
    apart = lags + 2
    Z = np.zeros_like(found.X)
    Z[apart:], Z[:, -1] = found.X[:-apart], 1.0
    return Z


def _filtered(Z: Array, found: Regression, e: Array, j: int) -> Array:
    """One equation's coefficients with everything filtered by what whitens its error."""
    from scipy.signal import lfilter

    if float(e @ e) < 1e-20 * float(found.Y[:, j] @ found.Y[:, j]):
        return _solved(Z, found.X, found.Y[:, j])
    past = np.column_stack([e[WHITENING - i : len(e) - i] for i in range(1, WHITENING + 1)])
    filter_ = np.append(1.0, -np.linalg.lstsq(past, e[WHITENING:], rcond=None)[0])
    Zf, Xf = (np.asarray(lfilter(filter_, 1.0, M, axis=0))[WHITENING:] for M in (Z, found.X))
    return _solved(Zf, Xf, np.asarray(lfilter(filter_, 1.0, found.Y[:, j]))[WHITENING:])


def _solved(Z: Array, X: Array, Y: Array) -> Array:
    """(ZᵀX)⁻¹ZᵀY, columns scaled first."""
    scale = np.maximum(np.linalg.norm(X, axis=0), 1e-300)
    size = np.maximum(np.linalg.norm(Z, axis=0), 1e-300)
    moment = (Z / size).T @ (X / scale)
    if not np.isfinite(moment).all() or np.linalg.cond(moment) > 1e12:
        raise InvalidModel("the instruments do not tell the regressors apart", likely="too little excitation")
    solution = np.linalg.solve(moment, (Z / size).T @ Y)
    return solution / (scale[:, None] if Y.ndim == 2 else scale)


def realised(P: Array, outputs: int, lags: int) -> tuple[Array, Array, Array, Array]:
    """A, b, C, and what the command of one period ago still does, of the coefficients P in observer form."""
    A_i, b_i = split(P, outputs, lags, lags + 1)
    n = outputs * lags
    A = np.zeros((n, n))
    A[:, :outputs] = A_i.reshape(n, outputs)
    A[: n - outputs, outputs:] = np.eye(n - outputs)
    waiting = np.zeros(n)
    waiting[n - outputs :] = b_i[lags]
    return A, b_i[:lags].reshape(n), np.eye(outputs, n), waiting


def _whole(A: Array, b: Array, C: Array, waiting: Array) -> tuple[Array, Array, Array]:
    """The same with the command of one period ago as a state."""
    n = len(A)
    full = np.zeros((n + 1, n + 1))
    full[:n, :n], full[:n, n] = A, waiting
    return full, np.append(b, 1.0), np.column_stack([C, np.zeros(len(C))])


def _as_part(part: Part, P: Array, lags: int) -> PartModel:
    A, b, C, waiting = realised(P, part.y.shape[1], lags)
    return physical(part.name, part.outputs, A, b, C, part.dt, waiting)
