"""Robot and controller together, as a log shows them: the law that feedback follows, and logs that might have been.

The law is the regression of the command on everything before it; what is left is the excitation, which no noise has
moved. With a model of the robot in innovation form the loop can be run again, without noise (for instruments) or with
its innovations drawn anew (a bootstrap of the whole loop, so that feedback correlates noise and commands as it did).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.identify.samples import Part
from upright.identify.subspace import Innovation

Array = NDArray[np.float64]

MEMORY = 40
"""Rows of readings and of commands that the law may remember."""
WILD = 100.0
"""A simulated loop whose readings exceed those of the log so many times has run away."""


@dataclass(frozen=True, eq=False)
class Law:
    """u[k] = Σ F_i y[k−i] + Σ g_i u[k−i] + r[k], with readings as the controller has them: `late` periods after y.

    F (outputs, memory + 1) and g (memory,) newest first; `excitation` r (n,) is what the law does not foretell.
    """

    F: Array
    g: Array
    excitation: Array
    late: tuple[int, ...]


def law(part: Part, memory: int = MEMORY) -> Law:
    """The law behind the commands of `part`, by least squares."""
    first = memory + max(part.late)
    rows = np.arange(first, len(part.u))
    columns = [part.y[rows - s - i, j] for j, s in enumerate(part.late) for i in range(memory + 1)]
    columns += [part.u[rows - i] for i in range(1, memory + 1)] + [np.ones(len(rows))]
    X = np.column_stack(columns)
    P: Array = np.linalg.lstsq(X, part.u[rows], rcond=None)[0].astype(np.float64)
    excitation = np.zeros(len(part.u))
    excitation[rows] = part.u[rows] - X @ P
    m = len(part.late)
    return Law(P[: m * (memory + 1)].reshape(m, memory + 1), P[-1 - memory : -1], excitation, part.late)


@dataclass(frozen=True, eq=False)
class Loop:
    """A model x⁺ = A x + b u + K e, y = C x + e under a `law`, to be run from rest."""

    A: Array
    b: Array
    C: Array
    K: Array
    law: Law

    def run(self, e: Array) -> tuple[Array, Array] | None:
        """y (runs, n, outputs) and u (runs, n) for innovations e (runs, n, outputs); None where the loop runs away."""
        runs, n, m = e.shape
        memory, worst = len(self.law.g), max(self.law.late)
        pad = memory + worst + 1
        y, u = np.zeros((runs, n + pad, m)), np.zeros((runs, n + pad))
        x = np.zeros((runs, len(self.A)))
        At, Ct, Kt = self.A.T, self.C.T, self.K.T
        back, forward = self.law.g[::-1].copy(), self.law.F[:, ::-1].T.copy()
        for k in range(n):
            at = k + pad
            y[:, at] = x @ Ct + e[:, k]
            now = u[:, at - memory : at] @ back + self.law.excitation[k]
            for j, s in enumerate(self.law.late):
                now += y[:, at - s - memory : at - s + 1, j] @ forward[:, j]
            u[:, at] = now
            x = x @ At + now[:, None] * self.b + e[:, k] @ Kt
            if k % 100 == 0 and not (np.abs(x) < 1e9).all():
                return None
        return y[:, pad:], u[:, pad:]


def noise_free(part: Part, A: Array, b: Array, C: Array, rule: Law) -> tuple[Array, Array] | None:
    """y (n, outputs) and u (n,) that the excitation alone would have made; None where this loop runs away."""
    M, N = _closed(A, b, C, rule)
    z, into = np.zeros((len(part.u) + 1, len(M))), np.outer(rule.excitation, N)
    for k in range(len(part.u)):
        z[k + 1] = M @ z[k] + into[k]
        if k % 100 == 0 and not np.abs(z[k]).max() < 1e9:
            return None
    u = z[1:, len(A)]
    if np.abs(u).max() > WILD * np.abs(part.u).max():
        return None
    return z[:-1, : len(A)] @ C.T, u


def _closed(A: Array, b: Array, C: Array, rule: Law) -> tuple[Array, Array]:
    """z⁺ = M z + N r for z = [x, the commands sent last, the outputs read last], newest first."""
    n, m, memory = len(A), len(C), len(rule.g)
    reach = memory + max(rule.late)
    size = n + memory + m * reach
    decide = np.zeros(size)  # u = decide z + r
    decide[n : n + memory] = rule.g
    for j, s in enumerate(rule.late):
        for i in range(memory + 1):
            if s + i == 0:
                decide[:n] += rule.F[j, 0] * C[j]
            else:
                decide[n + memory + m * (s + i - 1) + j] += rule.F[j, i]
    M, N = np.zeros((size, size)), np.zeros(size)
    M[:n, :n] = A
    M[:n] += np.outer(b, decide)
    M[n] = decide
    N[:n], N[n] = b, 1.0
    M[n + 1 : n + memory, n : n + memory - 1] = np.eye(memory - 1)
    M[n + memory : n + memory + m, :n] = C
    M[n + memory + m :, n + memory : size - m] = np.eye(m * (reach - 1))
    return M, N


def might_have_been(part: Part, base: Innovation, runs: int, seed: int) -> list[Part] | None:
    """`runs` logs of the loop of `base` and the law, with its innovations drawn anew and the excitation as it was;
    None where base and law do not make a stable loop."""
    rng = np.random.default_rng(seed)
    e = base.e - base.e.mean(axis=0)
    drawn = e[rng.integers(0, len(e), size=(runs, len(part.y)))]
    made = Loop(base.A, base.b, base.C, base.K, law(part)).run(drawn)
    if made is None:
        return None
    y, u = made
    if not np.isfinite(u).all() or np.abs(u).max() > WILD * np.abs(part.u).max():
        return None
    return [replace(part, y=y[i], u=u[i]) for i in range(runs)]
