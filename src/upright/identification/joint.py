"""Robot and controller together, as a log shows them: the feedback law, and repeated logs.

The law is the regression of the command on everything before it; its residual is the excitation, which no noise has
moved. With a model of the robot in innovation form the loop can be run again, without noise (for instruments) or with
its innovations drawn anew (a bootstrap of the whole loop, so that feedback correlates noise and commands as it did).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.identification.samples import Part
from upright.identification.subspace import InnovationModel
from upright.physics.linear import LinearModel

MEMORY = 40  # rows of readings and of commands that the law may remember
WILD = 100.0  # times the log's largest command: a simulated loop beyond has run away


@dataclass(frozen=True, eq=False)
class FeedbackLaw:
    """u[k] = Σ F_i y[k−i] + Σ g_i u[k−i] + r[k], with readings as the controller has them: `delays` periods after y.

    F (outputs, memory + 1) and g (memory,) newest first; `excitation` r (n,) is what the law does not predict.
    """

    F: Array
    g: Array
    excitation: Array
    delays: tuple[int, ...]

    @property
    def weights(self) -> Array:
        """By which the law weighs the rows [y, u] up to the present one (rows, outputs + 1), oldest first."""
        memory, m = len(self.g), len(self.delays)
        newest_first = np.zeros((memory + max(self.delays) + 1, m + 1))
        newest_first[1 : memory + 1, m] = self.g
        for j, delay in enumerate(self.delays):
            newest_first[delay : delay + memory + 1, j] = self.F[j]
        return newest_first[::-1]


def law(part: Part, memory: int = MEMORY) -> FeedbackLaw:
    """The law behind the commands of `part`, by least squares."""
    m = len(part.delays)
    rows = np.arange(memory + max(part.delays), len(part.u))
    columns = [part.y[rows - delay - i, j] for j, delay in enumerate(part.delays) for i in range(memory + 1)]
    columns += [part.u[rows - i] for i in range(1, memory + 1)] + [np.ones(len(rows))]
    X = np.column_stack(columns)
    P: Array = np.linalg.lstsq(X, part.u[rows], rcond=None)[0].astype(np.float64)
    excitation = np.zeros(len(part.u))
    excitation[rows] = part.u[rows] - X @ P
    return FeedbackLaw(P[: m * (memory + 1)].reshape(m, memory + 1), P[-1 - memory : -1], excitation, part.delays)


def simulated(
    part: Part, plant: LinearModel, rule: FeedbackLaw, e: Array | None = None, K: Array | None = None
) -> tuple[Array, Array] | None:
    """y (runs, n, outputs) and u (runs, n) of x⁺ = A x + b u + K e, y = C x + e under the law, from rest.

    Without innovations `e` (runs, n, outputs) it is one run of the excitation alone. None where the loop runs away.
    """
    weights = rule.weights
    n = len(part.u)
    m = len(plant.C)
    pad = len(weights) - 1
    noise = np.zeros((1, n, m)) if e is None else e
    enters = noise @ (np.zeros((len(plant.A), m)) if K is None else K).T
    history = np.zeros((len(noise), pad + n, m + 1))
    x = np.zeros((len(noise), len(plant.A)))
    flat = np.ascontiguousarray(weights).ravel()
    At = plant.A.T.copy()
    Ct = plant.C.T.copy()
    b = plant.B[:, 0]
    for k in range(n):
        history[:, pad + k, :m] = x @ Ct + noise[:, k]
        u = history[:, k : k + pad + 1].reshape(len(x), -1) @ flat + rule.excitation[k]
        history[:, pad + k, m] = u
        x = x @ At + u[:, None] * b + enters[:, k]
        if k % 100 == 0 and not (np.abs(x) < 1e9).all():
            return None
    y = history[:, pad:, :m]
    u = history[:, pad:, m]
    return (y, u) if np.isfinite(u).all() and np.abs(u).max() <= WILD * np.abs(part.u).max() else None


def repeated(part: Part, base: InnovationModel, runs: int, seed: int) -> list[Part] | None:
    """`runs` logs of the loop of `base` and the law, with its innovations drawn anew and the excitation as it was;
    None where base and law do not make a stable loop."""
    rng = np.random.default_rng(seed)
    e = base.e - base.e.mean(axis=0)
    drawn = e[rng.integers(0, len(e), size=(runs, len(part.y)))]
    made = simulated(part, base.plant, law(part), drawn, base.K)
    return [replace(part, y=y, u=u) for y, u in zip(*made, strict=True)] if made else None
