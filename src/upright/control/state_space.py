"""State-space systems, discrete or continuous, and the robot under its commands as one of them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.control.delay import SampledRobot
from upright.control.linear_controller import LinearController
from upright.errors import InvalidModel
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class StateSpace:
    """x⁺ = A x + B u, y = C x + D u every `dt` [s], or ẋ = … where `dt` is None.

    Raises `InvalidModel` for matrices that do not fit each other or are not finite.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    dt: float | None = None

    def __post_init__(self) -> None:
        n, (p, m) = len(self.A), np.shape(self.D)
        for name, shape in {"A": (n, n), "B": (n, m), "C": (p, n), "D": (p, m)}.items():
            value = np.array(getattr(self, name), dtype=np.float64)
            value = value.reshape(shape) if value.size == 0 and 0 in shape else value
            if value.shape != shape or not np.isfinite(value).all():
                raise InvalidModel(f"{name} has shape {value.shape}", expected=f"{shape}, finite", likely="a transpose")
            value.setflags(write=False)
            object.__setattr__(self, name, value)

    @classmethod
    def gain(cls, D: ArrayLike, dt: float | None = None) -> StateSpace:
        """A gain D (p, m) without memory."""
        matrix = np.asarray(D, dtype=np.float64)
        p, m = matrix.shape
        return cls(np.zeros((0, 0)), np.zeros((0, m)), np.zeros((p, 0)), matrix, dt)

    @classmethod
    def from_control(cls, system: Any) -> StateSpace:
        """From a `control.StateSpace` or `control.TransferFunction`."""
        import control

        found: Any = control.ss(system)  # type: ignore[attr-defined]
        return cls(found.A, found.B, found.C, found.D, float(found.dt) if found.dt else None)

    @cached_property
    def poles(self) -> Complex:
        """Eigenvalues of A, the least stable first."""
        poles = np.linalg.eigvals(self.A).astype(complex)
        return poles[np.argsort(-(np.real(poles) if self.dt is None else np.abs(poles)))]

    @property
    def stable(self) -> bool:
        """Whether every pole decays."""
        worst = self.poles[:1]
        return bool((np.real(worst) < 0 if self.dt is None else np.abs(worst) < 1).all())

    def response(self, omega: ArrayLike) -> Complex:
        """C (λI − A)⁻¹ B + D (len(omega), p, m) at λ = jω or e^{jω dt}, ω in [rad/s]."""
        w = np.atleast_1d(np.asarray(omega, dtype=np.float64))
        points = 1j * w if self.dt is None else np.exp(1j * w * self.dt)
        n = len(self.A)
        shifted = points[:, None, None] * np.eye(n) - self.A
        return self.C @ np.linalg.solve(shifted, np.broadcast_to(self.B, (len(w), *self.B.shape))) + self.D

    def __matmul__(self, first: StateSpace) -> StateSpace:
        """This system behind `first`."""
        one_period(self, first)
        n, m = len(self.A), len(first.A)
        A = np.block([[self.A, self.B @ first.C], [np.zeros((m, n)), first.A]])
        B = np.vstack([self.B @ first.D, first.B])
        return StateSpace(A, B, np.hstack([self.C, self.D @ first.C]), self.D @ first.D, self.dt)

    def __neg__(self) -> StateSpace:
        return StateSpace(self.A, self.B, -self.C, -self.D, self.dt)

    def scaled(self, inputs: ArrayLike, outputs: ArrayLike) -> StateSpace:
        """With each input counted in units of `inputs` and each output in units of `outputs`."""
        u, y = np.asarray(inputs, dtype=np.float64), 1 / np.asarray(outputs, dtype=np.float64)
        return StateSpace(self.A, self.B * u, y[:, None] * self.C, y[:, None] * self.D * u, self.dt)


def one_period(one: StateSpace, other: StateSpace) -> None:
    """Refuse two systems of different periods."""
    if one.dt != other.dt:
        raise InvalidModel(f"periods of {one.dt} and {other.dt} s in one loop", expected="equal ones")


def continuous(system: StateSpace) -> StateSpace:
    """The system itself, or a discrete one under z = (1 + s)/(1 − s): the unit circle becomes the imaginary axis.

    Norms, margins and stability are kept. Raises `InvalidModel` for a pole at z = −1.
    """
    if system.dt is None:
        return system
    A, identity = system.A, np.eye(len(system.A))
    if len(A) and np.linalg.cond(A + identity) > 1e12:
        raise InvalidModel("a pole at z = −1", expected="none there", hint="change the period a little")
    inverse, root = np.linalg.inv(A + identity), math.sqrt(2)
    D = system.D - system.C @ inverse @ system.B
    return StateSpace(inverse @ (A - identity), root * inverse @ system.B, root * system.C @ inverse, D)


def discrete(system: StateSpace, dt: float) -> StateSpace:
    """The inverse of `continuous`: s = (z − 1)/(z + 1)."""
    A, identity = system.A, np.eye(len(system.A))
    if len(A) and np.linalg.cond(identity - A) > 1e12:
        raise InvalidModel("a pole at s = 1", expected="none there", hint="change the period a little")
    inverse, root = np.linalg.inv(identity - A), math.sqrt(2)
    D = system.D + system.C @ inverse @ system.B
    return StateSpace(inverse @ (identity + A), root * inverse @ system.B, root * system.C @ inverse, D, dt)


def plant_of(seen: SampledRobot) -> StateSpace:
    """From commands (2) and a push at the centre of mass [N] to the readings.

    The states are the robot's six and the readings on their way, then the commands on theirs, newest first; gyro bias
    and push, which no command moves, are left out.
    """
    keep = kept(seen)
    n, fraction = len(keep), bool(seen.before.any())
    line = 2 * (seen.delay + fraction)
    A, B = np.zeros((n + line, n + line)), np.zeros((n + line, 3))
    A[:n, :n], B[:n, 2] = seen.A[np.ix_(keep, keep)], seen.pushed[keep]
    A[n + 2 :, n : n + line - 2] = np.eye(max(line - 2, 0))
    B[n : n + 2, :2] = np.eye(2)[: min(line, 2)]
    places = [B[:, :2], *(A[:, n + 2 * i : n + 2 * i + 2] for i in range(line // 2))]
    places[seen.delay][:n] = seen.now[keep]
    if fraction:
        places[seen.delay + 1][:n] = seen.before[keep]
    C = np.pad(seen.C[:, keep], ((0, 0), (0, line)))
    return StateSpace(A, B, C, np.zeros((len(C), 3)), seen.dt)


def kept(seen: SampledRobot) -> list[int]:
    """Which of the names of `seen` are states that the commands move."""
    return [i for i, name in enumerate(seen.names) if name in STATE_NAMES or "@" in name]


def controller_of(linear: LinearController, delay: int) -> StateSpace:
    """From the readings to the commands, when the command applied is the one of `delay` periods ago."""
    A, C, D = linear.A, linear.C, linear.Dy
    n, line = len(A), 2 * delay
    if not line:
        return StateSpace(A + linear.Ba @ C, linear.By + linear.Ba @ D, C, D, linear.period)
    whole = np.zeros((n + line, n + line))
    whole[:n, :n], whole[:n, -2:], whole[n : n + 2, :n] = A, linear.Ba, C
    whole[n + 2 :, n:-2] = np.eye(line - 2)
    B = np.vstack([linear.By, D, np.zeros((line - 2, len(linear.reads)))])
    return StateSpace(whole, B, np.pad(C, ((0, 0), (0, line))), D, linear.period)
