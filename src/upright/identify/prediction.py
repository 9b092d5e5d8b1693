"""How far a linear model foretells the part of a log that was held out, from a filter that is the same for all."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from upright.control.lqr import LARGEST_COMMAND
from upright.errors import DesignFailed
from upright.identify.coordinates import PartModel
from upright.identify.identified import reading
from upright.identify.samples import Part, Samples, by_name

Array = NDArray[np.float64]

HORIZONS = (1, 10, 50)
MOTOR = 0.3
"""Process noise at the commands, as a share of the largest usual command: what `lqg` takes as well (Doyle and Stein
1979), so that a filter trusts no model too much."""
BIAS_WALK = 1e-3  # [rad/s/√s] of the gyro's bias
LOST = 10.0  # times the motion: errors beyond are of a model that has run away
_LEAST = 1e-12


def steady_gain(A: Array, C: Array, W: Array, V: Array) -> Array:
    """L of the steady Kalman filter, for process noise W and readings of variance V; `DesignFailed` where none is.

    A little noise on every state is added where the Riccati equation is too badly scaled without.
    """
    from scipy.linalg import LinAlgError, solve_discrete_are

    for more in (0.0, 1e-10, 1e-8):
        with contextlib.suppress(LinAlgError, ValueError):
            P = np.asarray(solve_discrete_are(A.T, C.T, W + more * np.eye(len(A)), V), dtype=np.float64)
            L: Array = np.linalg.solve(C @ P @ C.T + V, C @ P).T.astype(np.float64)
            if np.isfinite(L).all() and np.abs(np.linalg.eigvals(A - A @ L @ C)).max() < 1:
                return L
    raise DesignFailed(
        "no steady Kalman filter for this model", expected="every state to be seen by the sensors",
        likely="a model that is far from the robot",
    )  # fmt: skip


def with_bias(part: Part, model: PartModel) -> tuple[Array, Array, Array]:
    """A, b and C of a half, with the bias of a gyro as its last state."""
    n = len(model.A) + ("gyro" in part.outputs)
    A, b = np.eye(n), np.zeros(n)
    A[: len(model.A), : len(model.A)], b[: len(model.A)] = model.A, model.b
    C = np.zeros((len(part.outputs), n))
    for row, name in enumerate(part.outputs):
        C[row, : len(model.A)] = reading(name, model) if not part.states else _state(name, model)
        C[row, -1] += name == "gyro"
    return A, b, C


def _state(name: str, model: PartModel) -> Array:
    return np.eye(len(model.states))[model.states.index(name)]


def foretold(samples: Samples, models: Sequence[PartModel]) -> dict[str, dict[str, float]]:
    """Fit [%], 100 (1 − rms error / rms of the motion), h samples ahead on the held-out rows, by horizon and output.

    Rates are compared themselves, angles by how far they moved in the h samples. NaN where the model runs away or has
    no filter.
    """
    parts, found = by_name(samples.parts), {str(h): dict[str, float]() for h in HORIZONS}
    for model in models:
        part = parts[model.name]
        with contextlib.suppress(DesignFailed):
            A, b, C = with_bias(part, model)
            strength = MOTOR * LARGEST_COMMAND[samples.robot.command_unit]
            W = strength**2 * np.outer(b, b) + _LEAST * np.eye(len(A))
            if "gyro" in part.outputs:
                W[-1, -1] += BIAS_WALK**2 * part.dt
            x = _filtered(A, b, C, steady_gain(A, C, W, np.diag(part.trusted)), part)
            for h in HORIZONS:
                found[str(h)] |= _fits(A, b, C, x, part, samples.fitted, h)
    return found


def _filtered(A: Array, b: Array, C: Array, L: Array, part: Part) -> Array:
    """States (n, states) after each reading."""
    x, z = np.zeros((len(part.y), len(A))), np.zeros(len(A))
    for k in range(len(part.y)):
        x[k] = z + L @ (part.y[k] - C @ z)
        z = A @ x[k] + b * part.u[k]
    return x


def _fits(A: Array, b: Array, C: Array, x: Array, part: Part, first: int, h: int) -> dict[str, float]:
    starts = np.arange(first, len(part.y) - h)
    if len(starts) < 10:
        return {}
    ahead = x[starts]
    for i in range(h):
        ahead = ahead @ A.T + part.u[starts + i][:, None] * b
    said, was, before = ahead @ C.T, part.y[starts + h], part.y[starts]
    found: dict[str, float] = {}
    for j, name in enumerate(part.outputs):
        moved = was[:, j] - before[:, j] if name in ("wheel", "turn", "yaw") else was[:, j] - was[:, j].mean()
        scale = float(np.sqrt(np.mean(moved**2)))
        error = float(np.sqrt(np.mean((said[:, j] - was[:, j]) ** 2)))
        found[name] = 100 * (1 - error / scale) if scale > 0 and error < LOST * scale else float("nan")
    return found
