"""One state feedback for a whole family of sampled systems, by linear matrix inequalities.

For (Aᵢ, bᵢ) of the family, find Q ≻ 0 and Y. The gain k = −Y Q⁻¹ then guarantees the cost of one Lyapunov function
P = Q⁻¹ for all systems (Kothare, Balakrishnan and Morari 1996; Boyd et al. 1994, chapter 7):

    ⎡ Q   (Aᵢ Q + bᵢ Y)ᵀ   Q W½   Yᵀ r½ ⎤
    ⎢ ·         Q            0       0   ⎥ ⪰ 0   for every i,        J = Σ xᵀWx + r u² ≤ x₀ᵀ P x₀
    ⎢ ·         ·            I       0   ⎥
    ⎣ ·         ·            ·       1   ⎦

and minimise tr(P X₀). The systems are chosen by scenarios (Calafiore and Campi 2006). The list starts with the nominal
system and a few draws. Then the worst of many draws under the present gain is added, until the worst is in the list.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.errors import DesignFailed

Model = tuple[Array, Array]
"""A (n, n) and b (n, 1)."""

STRICT = 1e-6
_FIRST, _ADDED, _ROUNDS = 6, 4, 4


@dataclass(frozen=True, eq=False)
class Guaranteed:
    """u = −k x for every one of `models`, and the Lyapunov matrix P (n, n) that proves it."""

    k: Array
    P: Array
    W: Array
    price: float
    models: tuple[Model, ...]

    def check(self) -> float:
        """The largest eigenvalue of (A − bk)ᵀP(A − bk) − P + W + kᵀrk above zero, over P's largest [1].

        Zero proves stability and cost of every system under one Lyapunov function.
        """
        return max(0.0, *(excess(model, self.k, self.P, self.W, self.price) for model in self.models))


def excess(model: Model, k: Array, P: Array, W: Array, price: float) -> float:
    """The largest eigenvalue of that matrix for one system, relative to P's largest."""
    closed = model[0] - model[1] @ k[None]
    fall = closed.T @ P @ closed - P + W + price * np.outer(k, k)
    return float(np.linalg.eigvalsh((fall + fall.T) / 2)[-1] / np.linalg.eigvalsh(P)[-1])


def guaranteed(models: Sequence[Model], W: Array, price: float, start: Array) -> Guaranteed:
    """The gain of least guaranteed cost from deviations of the sizes `start` (n,), the first system being the nominal;
    W is diagonal.

    Raises `DesignFailed` where no one gain serves them all.
    """
    chosen = list(range(min(_FIRST, len(models))))
    for last in range(_ROUNDS, -1, -1):
        k, P = _solved([models[i] for i in chosen], W, price, start)
        over = np.array([excess(model, k, P, W, price) for model in models])
        if over[chosen].max() > STRICT:
            raise _no_gain("Clarabel's gain breaks its own inequalities", len(chosen))
        worst = [int(i) for i in np.argsort(-over)[:_ADDED] if over[i] > STRICT and i not in chosen]
        if not worst or not last:
            return Guaranteed(k, P, W, price, tuple(models[i] for i in chosen))
        chosen += worst
    raise AssertionError


def _solved(models: Sequence[Model], W: Array, price: float, start: Array) -> tuple[Array, Array]:
    """k (n,) and P (n, n), where the first system's own P is made the identity."""
    import cvxpy as cp
    from cvxpy.error import SolverError
    from scipy.linalg import solve_discrete_are

    n = len(W)
    size = 1 / math.sqrt(price)
    T = np.linalg.cholesky(solve_discrete_are(*models[0], W + 1e-9 * np.eye(n), np.array([[price]]))).T
    back = np.linalg.inv(T)
    deviation = (np.sqrt(np.diag(W))[:, None] * back)[np.diag(W) > 0]
    first = T @ np.diag(start)
    Q = cp.Variable((n, n), symmetric=True)
    Y = cp.Variable((1, n))
    Z = cp.Variable((n, n), symmetric=True)
    rules: list[Any] = [cp.bmat([[Z, first.T], [first, Q]]) >> 0]
    for A, b in models:
        after = (T @ A @ back) @ Q + (T @ b * size) @ Y
        m = len(deviation)
        none = np.zeros((n, m))
        column = np.zeros((n, 1))
        rows = [
            [Q, after.T, Q @ deviation.T, Y.T],
            [after, Q, none, column],
            [deviation @ Q, none.T, np.eye(m), np.zeros((m, 1))],
            [Y, column.T, np.zeros((1, m)), np.eye(1)],
        ]
        rules.append(cp.bmat(rows) >> 0)
    problem = cp.Problem(cp.Minimize(cp.trace(Z) / float(np.sum(first**2))), rules)
    try:
        with warnings.catch_warnings():  # what is inaccurate is measured by whoever uses it
            warnings.simplefilter("ignore", UserWarning)
            problem.solve(solver=cp.CLARABEL, tol_gap_abs=1e-7, tol_gap_rel=1e-7, tol_feas=1e-9)
    except SolverError:
        raise _no_gain("Clarabel gave up", len(models)) from None
    if problem.status not in ("optimal", "optimal_inaccurate") or Q.value is None or Y.value is None:
        raise _no_gain(f"Clarabel says: {problem.status}", len(models))
    P = np.linalg.inv((Q.value + Q.value.T) / 2)
    return -(Y.value @ P @ T)[0] * size, T.T @ P @ T


def _no_gain(why: str, count: int) -> DesignFailed:
    return DesignFailed(
        f"no one gain is found for {count} robots ({why})", expected="robots near enough to each other",
        likely="spreads too wide for quadratic stability", hint="narrow the spreads, or shorten the period",
    )  # fmt: skip
