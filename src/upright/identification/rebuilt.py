"""Models of one step from rebuilt states: the paper's least squares, and total least squares.

States are rebuilt as Herrera et al. (2015) have them: pitch is the integrated gyro less its mean, the wheel is the
encoder plus pitch, rates are differences. Their errors are in the regressors, and through feedback in the
commands. So both methods are biased on real sensors; `study.Study` estimates the bias from repeated logs.
"""

from __future__ import annotations

import numpy as np

from upright.arrays import Array
from upright.errors import InvalidModel
from upright.identification.coordinates import PHYSICAL, half_model
from upright.identification.samples import Part
from upright.physics.linear import LinearModel


def rebuilt(part: Part) -> Array:
    """The physical states (n, states) of one half, in the order of `PHYSICAL`."""
    named = dict(zip(part.outputs, part.y.T, strict=True))
    if part.states:
        return np.column_stack([named[name] for name in PHYSICAL[part.name]])
    if part.name == "yaw":
        return np.column_stack([named["turn"], _difference(named["turn"], part.dt)])
    if "gyro" in named:
        rate = named["gyro"] - named["gyro"].mean()
        pitch = np.concatenate([[0.0], np.cumsum(rate[:-1])]) * part.dt
        pitch -= pitch.mean()
    else:
        pitch = named["pitch"]
        rate = _difference(named["pitch"], part.dt)
    wheel = named["wheel"] + pitch
    return np.column_stack([pitch, rate, wheel, _difference(wheel, part.dt)])


def least_squares_part(part: Part) -> LinearModel:
    """x⁺ = A x + b u + a constant by ordinary least squares (Herrera et al. 2015, eq. 33)."""
    x = rebuilt(part)
    X = np.column_stack([x[:-1], part.u[:-1], np.ones(len(x) - 1)])
    scaled, _, rank, _ = np.linalg.lstsq(X / _size(X), x[1:], rcond=1e-12)
    if rank < X.shape[1]:
        raise InvalidModel(
            f"the regressors of {part.name} have rank {rank} of {X.shape[1]}", expected="full rank, as eq. (33) asks",
            likely="a log without excitation, whose commands follow from its states",
        )  # fmt: skip
    P = scaled / _size(X)[:, None]
    n = x.shape[1]
    return half_model(part.name, P[:n].T, P[n], part.dt)


def total_least_squares(part: Part) -> LinearModel:
    """The same model by total least squares (Van Huffel and Vandewalle 1991, chapter 10).

    All states have errors, with the covariance of the kit's sensors; command and constant are exact.

    Rates follow by the regression; angles follow from rates, as the states were rebuilt.
    """
    if part.states:
        return least_squares_part(part)
    x = rebuilt(part)
    names = PHYSICAL[part.name]
    moved = [i for i, name in enumerate(names) if name.endswith("_rate")]
    used = [i for i, name in enumerate(names) if name.endswith("_rate") or name == "pitch"]
    S = _errors(part, len(x))
    noisy, exact = (
        np.column_stack([x[:-1][:, used], x[1:][:, moved]]),
        np.column_stack([part.u[:-1], np.ones(len(x) - 1)]),
    )
    rest = noisy - exact @ np.linalg.lstsq(exact, noisy, rcond=None)[0]
    from scipy.linalg import eigh

    n, m = len(used), len(moved)
    vectors = np.asarray(eigh(rest.T @ rest, S)[1])[:, :m]
    P = -np.linalg.solve(vectors[n:].T, vectors[:n].T).T
    Q = np.linalg.lstsq(exact, noisy[:, n:] - noisy[:, :n] @ P, rcond=None)[0]
    A, b = _kinematics(names, used, moved, P, Q[0], part.dt)
    return half_model(part.name, A, b, part.dt)


def _kinematics(
    names: tuple[str, ...], used: list[int], moved: list[int], P: Array, b: Array, dt: float
) -> tuple[Array, Array]:
    """A and b: the rates' rows as result, pitch⁺ = pitch + dt · rate, other angles⁺ = angle + dt · rate⁺."""
    A, enters = np.eye(len(names)), np.zeros(len(names))
    for column, i in enumerate(moved):
        A[i] = 0.0
        A[i, used], enters[i] = P[:, column], b[column]
    for i, name in enumerate(names):
        if name == "pitch":
            A[i, i + 1] = dt
        elif not name.endswith("_rate"):
            A[i] += dt * A[i + 1]
            enters[i] = dt * enters[i + 1]
    return A, enters


def _errors(part: Part, rows: int) -> Array:
    """Covariance of the errors in [pitch, rates; next rates], from independent errors of the readings: encoder and
    gyro at three successive rows, and what integrating the gyro has left in pitch."""
    dt = part.dt
    if part.name == "yaw":
        L = np.array([[-1.0, 1, 0], [0, -1, 1]]) / dt
        return part.noise[0] * L @ L.T
    body = part.noise[0]
    wheel = part.noise[-1]
    g = np.eye(3)
    e = np.eye(3)
    v = 1 / dt
    if part.outputs[0] == "gyro":
        drift = rows * body * dt**2 / 6  # mean variance of a random walk about its mean
        columns = np.block([
            [np.array([[1.0, 0, 0, 0]]), np.zeros((1, 3))], [np.zeros((1, 1)), g[1:2], 0 * e[:1]],
            [np.zeros((1, 1)), g[:1], v * (e[1:2] - e[:1])], [np.zeros((1, 1)), g[2:], 0 * e[:1]],
            [np.zeros((1, 1)), g[1:2], v * (e[2:] - e[1:2])],
        ])  # fmt: skip
        variances = np.array([drift, body, body, body, wheel, wheel, wheel])
    else:
        back = v * (g[1:2] - g[:1])
        ahead = v * (g[2:] - g[1:2])
        columns = np.block([
            [g[1:2], 0 * e[:1]], [back, 0 * e[:1]], [back, v * (e[1:2] - e[:1])], [ahead, 0 * e[:1]],
            [ahead, v * (e[2:] - e[1:2])],
        ])  # fmt: skip
        variances = np.array([body] * 3 + [wheel] * 3)
    S: Array = (columns * variances) @ columns.T
    return S + 1e-9 * np.diag(np.diag(S))


def _size(X: Array) -> Array:
    return np.maximum(np.linalg.norm(X, axis=0), 1e-300)


def _difference(values: Array, dt: float) -> Array:
    slope = np.diff(values) / dt
    return np.concatenate([slope[:1], slope])
