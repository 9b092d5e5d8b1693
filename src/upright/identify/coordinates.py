"""From any state-space model of one half to its physical states: a change of coordinates, which moves no pole.

Every mode e^(st) of the outputs gives its share of a rate by the factor s, of an integral by 1/s. So pitch follows from
what the gyro says of each mode and the wheels' rate from their angle, exact for a command held over each period.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from upright.errors import InvalidModel

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

PHYSICAL = {"pitch": ("pitch", "pitch_rate", "wheel", "wheel_rate"), "yaw": ("yaw", "yaw_rate")}
FASTEST = 0.02
"""Least |eigenvalue| of which the logarithm is taken: a mode that dies faster than 4 a period is noise in its rate."""
_INDEPENDENT = 1e-6


@dataclass(frozen=True, eq=False)
class PartModel:
    """x⁺ = A x + b u of one half `name` every `dt` [s], with its `states` by name, the physical ones first.

    `order` is that of the dynamics; a fraction of a period of dead time adds the state "sent".
    """

    name: str
    A: Array
    b: Array
    states: tuple[str, ...]
    dt: float

    @property
    def pole(self) -> float:
        """ln of the largest |eigenvalue| over dt [1/s]: how fast the half runs away. The angle that drives nothing does
        not count."""
        angle = self.states.index("wheel" if self.name == "pitch" else "yaw")
        return fastest(np.delete(np.delete(self.A, angle, 0), angle, 1), self.dt)


def fastest(A: Array, dt: float) -> float:
    """ln of the largest |eigenvalue| of A over dt [1/s]."""
    return float(np.log(max(float(np.abs(np.linalg.eigvals(A)).max()), 1e-300)) / dt)


def physical(
    name: str, outputs: Sequence[str], A: Array, b: Array, C: Array, dt: float, waiting: Array | None = None
) -> PartModel:
    """x⁺ = A x + b u (+ `waiting` u⁻, what the command of a period ago still does), y = C x of the half `name` in its
    physical states, and x5, x6, … where it has more. Raises `InvalidModel` where the outputs do not tell them apart.
    """
    wanted = PHYSICAL[name]
    if len(A) < len(wanted):
        raise InvalidModel(f"a model of order {len(A)} for {name}", expected=f"at least {len(wanted)}")
    T = _completed(_rows(name, outputs, A, C, dt), A, b)
    if np.linalg.cond(T / np.linalg.norm(T, axis=1)[:, None]) > 1e9:
        raise InvalidModel(f"the outputs do not fix the {name}'s states", likely="a log that is hardly excited")
    inverse = np.linalg.inv(T)
    moved, entered = T @ A @ inverse, T @ b
    angle = wanted.index("wheel" if name == "pitch" else "yaw")
    moved[:, angle] = np.eye(len(A))[angle]
    names = (*wanted, *(f"{name}_x{i + 1}" for i in range(len(wanted), len(A))))
    if waiting is None:
        return PartModel(name, moved, entered, names, dt)
    n = len(A)
    full, enters = np.zeros((n + 1, n + 1)), np.append(entered, 1.0)
    full[:n, :n], full[:n, n] = moved, T @ waiting
    return PartModel(name, full, enters, (*names, f"{name}_sent"), dt)


def _rows(name: str, outputs: Sequence[str], A: Array, C: Array, dt: float) -> Array:
    """The physical states as rows over x."""
    found = np.linalg.eig(A)
    values, V = found[0].astype(np.complex128), found[1].astype(np.complex128)
    integrator = int(np.argmin(np.abs(values - 1)))
    rate = _rates(values, dt)
    rate[integrator] = 0.0
    inverse = np.zeros_like(rate)
    inverse[rate != 0] = 1 / rate[rate != 0]
    said = dict(zip(outputs, C.astype(np.complex128) @ V, strict=True))
    modal = _turn(said, rate) if name == "yaw" else _lean(said, rate, inverse)
    return np.real(modal @ np.linalg.inv(V)).astype(np.float64)


def _turn(said: dict[str, Complex], rate: Complex) -> Complex:
    yaw = said["yaw"] if "yaw" in said else said["turn"]
    return np.array([yaw, said.get("yaw_rate", yaw * rate)])


def _lean(said: dict[str, Complex], rate: Complex, inverse: Complex) -> Complex:
    if "wheel_rate" in said:
        return np.array([said["pitch"], said["pitch_rate"], said["wheel"], said["wheel_rate"]])
    pitch = said["gyro"] * inverse if "gyro" in said else said["pitch"]
    pitch_rate = said.get("gyro", pitch * rate)
    relative = said["wheel"]
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
