"""How far a linear model foretells the part of a log that was held out, from a filter that is the same for all."""

from __future__ import annotations

import contextlib
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from upright.control.kalman import filtered, process_noise, steady_kalman
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
ADDED = (0.0, 1e-10, 1e-8)  # variance on every state that the Riccati equation of a badly scaled model is tried with
_LEAST = 1e-12


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
            W = process_noise(strength * b[:, None], _LEAST)
            if "gyro" in part.outputs:
                W[-1, -1] += BIAS_WALK**2 * part.dt
            _, L = steady_kalman(A, C, W, np.diag(part.trusted), ADDED)
            x, _ = filtered(A, C, L, part.y, np.outer(part.u, b), np.zeros(len(A)))
            for h in HORIZONS:
                found[str(h)] |= _fits(A, b, C, x, part, samples.fitted, h)
    return found


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
