"""How well a linear model predicts the held-out part of a log, from the same Kalman filter for all models."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping

import numpy as np

from upright.arrays import Array
from upright.control.kalman import filtered, process_noise, steady_kalman
from upright.control.riccati import LARGEST_COMMAND
from upright.errors import DesignFailed
from upright.identification.identified import reading
from upright.identification.samples import Part, Samples
from upright.physics.linear import LinearModel

HORIZONS = (1, 10, 50)
MOTOR = 0.3
"""Process noise at the commands over the largest usual command: more than motors make, as for `lqg` (Doyle and Stein
1979), so that the filter trusts no model too much."""
BIAS_WALK = 1e-3  # [rad/s/√s] of the gyro's bias
LOST = 10.0  # rms error over rms motion, beyond which the model has run away
ADDED = (0.0, 1e-10, 1e-8)  # variance on every state, tried in turn where the Riccati equation is badly scaled


def with_bias(part: Part, model: LinearModel) -> tuple[Array, Array, Array]:
    """A, b and C of a half, with the bias of a gyro as its last state."""
    n, m = len(model.A), len(part.outputs)
    A, b = np.eye(n + ("gyro" in part.outputs)), np.zeros(n + ("gyro" in part.outputs))
    A[:n, :n], b[:n] = model.A, model.B[:, 0]
    C = np.zeros((m, len(A)))
    C[:, :n] = [reading(name, model.states, known=part.states) for name in part.outputs]
    C[:, -1] += [name == "gyro" for name in part.outputs]
    return A, b, C


def prediction_fits(samples: Samples, halves: Mapping[str, LinearModel]) -> dict[str, dict[str, float]]:
    """Skill [%], 100 (1 − rms error / rms of the motion), h samples ahead on the held-out rows, by horizon and output.

    Rates are compared themselves, angles by their change over the h samples. NaN where the model runs away or has no
    filter.
    """
    fits = {str(h): dict[str, float]() for h in HORIZONS}
    for part in samples.parts:
        with contextlib.suppress(DesignFailed):
            A, b, C = with_bias(part, halves[part.name])
            strength = MOTOR * LARGEST_COMMAND[samples.robot.command_unit]
            W = process_noise(strength * b[:, None], 1e-12)
            if "gyro" in part.outputs:
                W[-1, -1] += BIAS_WALK**2 * part.dt
            _, L = steady_kalman(A, C, W, np.diag(part.trusted), ADDED)
            x, _ = filtered(A, C, L, part.y, np.outer(part.u, b), np.zeros(len(A)))
            held = slice(samples.fitted, None)
            for h in HORIZONS:
                fits[str(h)] |= _fits(A, b, C, x[held], part.cut(samples.fitted, len(part.y)), h)
    return fits


def _fits(A: Array, b: Array, C: Array, x: Array, part: Part, h: int) -> dict[str, float]:
    starts = np.arange(len(part.y) - h)
    if len(starts) < 10:
        return {}
    ahead = x[starts]
    for i in range(h):
        ahead = ahead @ A.T + part.u[starts + i][:, None] * b
    predicted = ahead @ C.T
    actual = part.y[starts + h]
    before = part.y[starts]
    fits: dict[str, float] = {}
    for j, name in enumerate(part.outputs):
        moved = actual[:, j] - (before[:, j] if name in ("wheel", "turn", "yaw") else actual[:, j].mean())
        scale = float(np.sqrt(np.mean(moved**2)))
        error = float(np.sqrt(np.mean((predicted[:, j] - actual[:, j]) ** 2)))
        fits[name] = 100 * (1 - error / scale) if scale > 0 and error < LOST * scale else float("nan")
    return fits
