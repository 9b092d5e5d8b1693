"""The paper's linear model: one-step least squares on sampled states (Herrera et al. 2015, eqs. 25 to 33)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.errors import InvalidLog
from upright.physics.linear import LinearModel
from upright.robots import Robot
from upright.signals import STATE_NAMES, Log


@dataclass(frozen=True, eq=False)
class LeastSquares:
    """P̂ = (XᵀX)⁻¹Xᵀy of eq. (33) for x⁺ = p₀ + A x + B u.

    `offset` p₀ (6,) is the independent term; `condition` is that of X_g with columns scaled to unit length, `rank` its
    numerical rank out of 9.
    """

    model: LinearModel
    offset: Array
    rank: int
    condition: float
    samples: int

    @property
    def full_rank(self) -> bool:
        """Whether X_g determines every parameter, as the paper demands."""
        return self.rank == 9


def least_squares(states: ArrayLike, commands: ArrayLike, dt: float) -> LeastSquares:
    """Fit x⁺ = p₀ + A x + B u to states (n, 6) and the commands (n, 2) held after each, every `dt` [s].

    Raises `InvalidLog` for too few samples, NaN, or unequal lengths.
    """
    x, u = np.asarray(states, dtype=np.float64), np.asarray(commands, dtype=np.float64)
    if x.ndim != 2 or x.shape[1] != 6 or u.shape != (len(x), 2):
        raise InvalidLog(f"states {x.shape} and commands {u.shape}", expected="(n, 6) and (n, 2)")
    if len(x) < 20:
        raise InvalidLog(f"{len(x)} samples", expected="at least 20 for nine parameters a row")
    if not (np.isfinite(x).all() and np.isfinite(u).all()):
        raise InvalidLog("NaN among states or commands", expected="finite numbers", hint="cut the log before it")
    regressors = np.column_stack([np.ones(len(x) - 1), x[:-1], u[:-1]])
    scale = np.maximum(np.linalg.norm(regressors, axis=0), np.finfo(float).tiny)
    solution, _, rank, singular = np.linalg.lstsq(regressors / scale, x[1:], rcond=1e-12)
    P = solution / scale[:, None]
    model = LinearModel(P[1:7].T, P[7:].T, dt=dt)
    return LeastSquares(model, P[0], int(rank), float(singular[0] / singular[-1]), len(x))


def rebuild_states(log: Log, robot: Robot) -> Array:
    """The six states (n, 6) as the paper's robot has them: ψ is the integrated gyro, less its mean (the bias);
    θ the encoders plus ψ; φ the compass where there is one, else the encoders; rates of θ and φ are differences.
    """
    gyro = log["sensor/gyro"] - log["sensor/gyro"].mean()
    pitch = np.concatenate([[0.0], np.cumsum(gyro[:-1] * np.diff(log.t))])
    pitch -= pitch.mean()
    left, right = log["sensor/encoder_left"], log["sensor/encoder_right"]
    wheel = (left + right) / 2 + pitch
    turn = (right - left) * robot.wheel_radius / robot.track
    yaw = log.channels.get("sensor/compass", turn)
    return np.column_stack([pitch, gyro, wheel, _difference(wheel, log.t), yaw, _difference(yaw, log.t)])


def _difference(values: Array, t: Array) -> Array:
    slope = np.diff(values) / np.diff(t)
    return np.concatenate([slope[:1], slope])


def unstable_pole(model: LinearModel) -> float:
    """The fastest growing real mode of a discrete model [1/s]: ln of its largest |eigenvalue| over dt."""
    assert model.dt is not None
    pitch = [STATE_NAMES.index(name) for name in ("pitch", "pitch_rate", "wheel_rate")]
    return float(np.log(np.abs(np.linalg.eigvals(model.A[np.ix_(pitch, pitch)])).max()) / model.dt)
