"""From any state-space model of one half to its physical states: a change of coordinates, which moves no pole.

A mode e^(st) of an output is differentiated by the factor s and integrated by 1/s. So pitch follows from each mode of
the gyro, and the wheels' rate from their angle, exactly for a command held over each period.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from upright.arrays import Array, Complex
from upright.errors import InvalidModel
from upright.physics.linear import LinearModel

PHYSICAL = {"pitch": ("pitch", "pitch_rate", "wheel", "wheel_rate"), "yaw": ("yaw", "yaw_rate")}
"""States of each half of the robot, in the order of `LinearModel`."""
COMMANDS = {"pitch": (0.5, 0.5), "yaw": (-0.5, 0.5)}
"""How left and right make up the command of a half: their mean, and half their difference."""
ANGLES = {"pitch": "wheel", "yaw": "yaw"}
"""The angle of each half that drives nothing on a level floor."""
FASTEST = 0.02
"""Least |eigenvalue| of which the logarithm is taken: a mode that dies faster than 4 a period is noise in its rate."""
_INDEPENDENT = 1e-6


def half_model(half: str, A: Array, b: Array, dt: float) -> LinearModel:
    """x⁺ = A x + b u of one half every `dt` [s]: its physical states, then as many more as A has."""
    physical = PHYSICAL[half]
    extra = (f"{half}_x{i + 1}" for i in range(len(physical), len(A)))
    return LinearModel(A, b[:, None], dt=dt, states=(*physical, *extra), inputs=(half,))


def growth_rate(model: LinearModel) -> float:
    """ln of the largest |eigenvalue| over dt [1/s], but for the angle that drives nothing: how fast a half falls."""
    angle = next(model.states.index(name) for name in ANGLES.values() if name in model.states)
    A = np.delete(np.delete(model.A, angle, 0), angle, 1)
    return float(np.log(max(float(np.abs(np.linalg.eigvals(A)).max()), 1e-300)) / model.dt)


def with_sent(half: str, model: LinearModel, waiting: Array) -> LinearModel:
    """`model` with the command of one period ago as a state, which still enters by `waiting` (states,): a fraction of a
    period of dead time."""
    n = len(model.A)
    A = np.zeros((n + 1, n + 1))
    A[:n, :n], A[:n, n] = model.A, waiting
    B = np.vstack([model.B, [[1.0]]])
    C = np.column_stack([model.C, np.zeros(len(model.C))])
    states = (*model.states, f"{half}_sent")
    return LinearModel(A, B, C, dt=model.dt, states=states, inputs=model.inputs, outputs=model.outputs)


def physical(half: str, model: LinearModel, waiting: Array | None = None) -> LinearModel:
    """A model of one half (with its command of a period ago, where it is still `waiting`) in its physical states, and
    x5, x6, … where it has more. Raises `InvalidModel` where the outputs do not tell them apart.
    """
    A = model.A
    b = model.B[:, 0]
    names = PHYSICAL[half]
    if len(A) < len(names):
        raise InvalidModel(f"a model of order {len(A)} for {half}", expected=f"at least {len(names)}")
    T = _completed(_rows(half, model), A, b)
    if np.linalg.cond(T / np.linalg.norm(T, axis=1)[:, None]) > 1e9:
        raise InvalidModel(f"the outputs do not fix the {half}'s states", likely="a log with too little excitation")
    moved = T @ A @ np.linalg.inv(T)
    angle = names.index(ANGLES[half])
    moved[:, angle] = np.eye(len(A))[angle]
    result = half_model(half, moved, T @ b, model.dt)
    return result if waiting is None else with_sent(half, result, T @ waiting)


def _rows(half: str, model: LinearModel) -> Array:
    """The physical states as rows over x."""
    values, V = (part.astype(np.complex128) for part in np.linalg.eig(model.A))
    rate = _rates(values, model.dt)
    rate[np.argmin(np.abs(values - 1))] = 0.0
    inverse = np.zeros_like(rate)
    inverse[rate != 0] = 1 / rate[rate != 0]
    modes = dict(zip(model.outputs, model.C.astype(np.complex128) @ V, strict=True))
    modal = _turn(modes, rate) if half == "yaw" else _lean(modes, rate, inverse)
    return np.real(modal @ np.linalg.inv(V)).astype(np.float64)


def _turn(modes: dict[str, Complex], rate: Complex) -> Complex:
    yaw = modes["yaw"] if "yaw" in modes else modes["turn"]
    return np.array([yaw, modes.get("yaw_rate", yaw * rate)])


def _lean(modes: dict[str, Complex], rate: Complex, inverse: Complex) -> Complex:
    if "wheel_rate" in modes:
        return np.array([modes[name] for name in PHYSICAL["pitch"]])
    pitch = modes["gyro"] * inverse if "gyro" in modes else modes["pitch"]
    pitch_rate = modes.get("gyro", pitch * rate)
    relative = modes["wheel"]
    return np.array([pitch, pitch_rate, relative + pitch, relative * rate + pitch_rate])


def _rates(values: Complex, dt: float) -> Complex:
    """ln λ/dt; a real λ that is not clearly positive has no rate, and is given that of `FASTEST`."""
    unclear = (np.abs(values) < FASTEST) | ((np.abs(values.imag) < 1e-12) & (values.real < FASTEST))
    shown = np.where(unclear, np.maximum(np.abs(values), FASTEST), values)
    return (np.log(shown.astype(np.complex128)) / dt).astype(np.complex128)


def _completed(rows: Array, A: Array, b: Array) -> Array:
    """`rows` and as many left eigenvectors of the fastest modes as make a basis, scaled so that the command enters them
    with one."""
    values, V = np.linalg.eig(A)
    left = np.linalg.inv(V)
    order = np.argsort(np.abs(values))
    basis = list(rows)
    for row in np.concatenate([[left[i].real, left[i].imag] for i in order]):
        if len(basis) == len(A):
            break
        size = float(np.linalg.norm(row))
        if size > _INDEPENDENT and _apart(row / size, basis):
            enters = float(row @ b)
            basis.append(row / (enters if abs(enters) > _INDEPENDENT * size * np.linalg.norm(b) else size))
    return np.array(basis)


def _apart(row: Array, basis: Sequence[Array]) -> bool:
    unit = np.array([b / np.linalg.norm(b) for b in basis])
    rest = row - unit.T @ np.linalg.lstsq(unit.T, row, rcond=None)[0]
    return float(np.linalg.norm(rest)) > _INDEPENDENT
