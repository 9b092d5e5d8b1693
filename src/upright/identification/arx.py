"""Regression of outputs on their own past and that of the command, on a level floor.

y[k] = Σ A_i y[k−i] + Σ b_i u[k−i] + c + e[k]. The last output is an angle that drives nothing, so that only its steps
are regressors and its next step is the target: a model that follows is the same wherever the robot stands, and its
integrator is exact. With a long past this is consistent in closed loop, since e[k] is new to everything before it.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array, Whole

PASTS = (10, 15, 20, 30, 40, 50, 60)
"""Lengths of the past among which `past_window` chooses."""
LONGER = 2.5
"""Past of a subspace method over that of Akaike's criterion. On twins with coarse readings (1° encoders, 1 V of
excitation) the criterion's past gives an unstable pole a fifth too small; beyond about twice that it stays."""


@dataclass(frozen=True, eq=False)
class Regression:
    """Rows k of the log, regressors X (rows, columns) and targets Y (rows, outputs)."""

    rows: Whole
    X: Array
    Y: Array


@dataclass(frozen=True, eq=False)
class Arx:
    """A_i (lags, outputs, outputs), b_i (lags, outputs) and the residuals e (rows, outputs) of the `rows`."""

    A: Array
    b: Array
    rows: Whole
    e: Array


@dataclass(frozen=True)
class FirstResponse:
    """The first row after an unpredicted command in which an output responds, and the largest t-value of its rows."""

    row: int
    strength: float


def regression(y: Array, u: Array, lags: int, inputs: int, start: int = 0) -> Regression:
    """Regressors of `lags` outputs and `inputs` commands, for the rows from `start` (or the first possible one)."""
    steps = np.diff(y[:, -1], prepend=y[0, -1])
    rows = np.arange(max(lags + 1, inputs, start), len(y))
    columns = [y[rows - i, j] for i in range(1, lags + 1) for j in range(y.shape[1] - 1)]
    columns += [steps[rows - i] for i in range(1, lags)]
    columns += [u[rows - i] for i in range(1, inputs + 1)] + [np.ones(len(rows))]
    return Regression(rows, np.column_stack(columns), np.column_stack([y[rows, :-1], steps[rows]]))


def split(P: Array, outputs: int, lags: int, inputs: int) -> tuple[Array, Array]:
    """A_i and b_i from the coefficients P (columns, outputs) of a `regression`."""
    A = np.zeros((lags, outputs, outputs))
    rest = outputs - 1
    for i in range(lags):
        A[i, :, :-1] = P[i * rest : (i + 1) * rest].T
    for i in range(lags - 1):
        step = P[lags * rest + i]
        A[i, :, -1] += step
        A[i + 1, :, -1] -= step
    A[0, -1, -1] += 1.0
    first = lags * rest + lags - 1
    return A, P[first : first + inputs]


def arx(y: Array, u: Array, lags: int, start: int = 0) -> Arx:
    """Least squares with `lags` of outputs and command."""
    result = regression(y, u, lags, lags, start)
    P: Array = np.linalg.lstsq(result.X, result.Y, rcond=None)[0].astype(np.float64)
    A, b = split(P, y.shape[1], lags, lags)
    return Arx(A, b, result.rows, result.Y - result.X @ P)


def past_window(y: Array, u: Array, pasts: Sequence[int] = PASTS) -> int:
    """The length of the past that Akaike's criterion chooses, on the same rows for all."""
    allowed = [p for p in pasts if p <= most_past(y)] or [min(pasts)]
    scores: list[float] = []
    for lags in allowed:
        e = arx(y, u, lags, max(allowed) + 1).e
        count = y.shape[1] * lags + lags + y.shape[1]
        scores.append(len(e) * _log_det(e.T @ e / len(e)) + 2 * y.shape[1] * count)
    return allowed[int(np.argmin(scores))]


def longer(past: int, y: Array) -> int:
    """A past `LONGER` than the `past` of Akaike's criterion, as far as the log has rows for it.

    The criterion asks for one good step. The lags that it cuts off bias the states, which a subspace method estimates
    from many steps.
    """
    return max(past, min(round(LONGER * past), most_past(y)))


def most_past(y: Array) -> int:
    """The longest past that leaves eight rows for each of its numbers."""
    return int(len(y) / 8 / (y.shape[1] + 1))


def first_response(y: Array, u: Array, reach: int, lags: int = 20) -> list[FirstResponse]:
    """For each output the first row that responds to the part of the command that nothing before it predicts.

    A row responds if its t-value exceeds 4 and a tenth of the largest: the rest of a fractional delay is less.
    """
    result = regression(y, u, lags, reach)
    R = np.linalg.qr(result.X, mode="r")
    P = np.linalg.lstsq(result.X, result.Y, rcond=None)[0]
    e = result.Y - result.X @ P
    spread = np.sqrt((np.linalg.pinv(R) ** 2).sum(axis=1))
    t = np.abs(P / np.maximum(np.outer(spread, e.std(axis=0)), 1e-300))[-1 - reach : -1]
    return [
        FirstResponse(int(np.argmax(column > max(4.0, 0.1 * column.max()))) + 1, float(column.max())) for column in t.T
    ]  # fmt: skip


def _log_det(S: Array) -> float:
    return float(np.linalg.slogdet(S)[1])
