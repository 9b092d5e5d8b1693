"""Linear models: the tangent of the dynamics, its exact discretisation, and `LinearModel`."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.errors import InvalidModel
from upright.physics.dynamics import CALM, MODELS, Disturbance, derivative
from upright.robots import Robot
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

FADING = 1 - 1e-5  # |pole| beyond which a memory counts as one that never fades: it would take 1000 s
CONVERGED = 1e-10  # of the sum: a response that has faded so far adds less than `SPARE` from then on

INPUTS = ("left", "right")
DISTURBANCES = ("force", "moment", "slope")
"""A push enters as its force [N] and its moment about the axle [N m]; the floor as its slope [rad]."""

_TINY = 1e-100  # complex step: no subtraction, so no cancellation, and its square vanishes


@dataclass(frozen=True, eq=False)
class LinearModel:
    """Deviations from (x0, u0): ẋ = f0 + A (x − x0) + B (u − u0) + E w, or x⁺ − x0 = … when `dt` is a number.

    A (n, n), B (n, m), E (n, k) for the named `disturbances`; `dt` [s] is None for continuous time.
    f0 (n,) is what drives the state at (x0, u0): zero at an equilibrium.

    Raises `InvalidModel` for wrong sizes, values that are not finite, or a `dt` that is not positive.
    """

    A: Array
    B: Array
    states: tuple[str, ...] = STATE_NAMES
    inputs: tuple[str, ...] = INPUTS
    dt: float | None = None
    E: Array = field(default_factory=lambda: np.zeros((0, 0)))
    disturbances: tuple[str, ...] = ()
    x0: Array = field(default_factory=lambda: np.zeros(0))
    u0: Array = field(default_factory=lambda: np.zeros(0))
    f0: Array = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        n, m, k = len(self.states), len(self.inputs), len(self.disturbances)
        shapes = {"A": (n, n), "B": (n, m), "E": (n, k), "x0": (n,), "u0": (m,), "f0": (n,)}
        for name, shape in shapes.items():
            given: Array = np.array(getattr(self, name), dtype=np.float64)
            value: Array = np.zeros(shape) if given.size == 0 else given
            if value.shape != shape:
                raise InvalidModel(
                    f"{name} has shape {value.shape}",
                    expected=f"{shape} for {n} states and {m} inputs",
                    likely="a transpose",
                )
            if not np.isfinite(value).all():
                raise InvalidModel(f"{name} holds {value[~np.isfinite(value)][0]}", expected="finite numbers")
            value.setflags(write=False)
            object.__setattr__(self, name, value)
        if self.dt is not None and not (np.isfinite(self.dt) and self.dt > 0):
            raise InvalidModel(f"dt is {self.dt} s", expected="a positive period, or None for continuous time")

    @property
    def continuous(self) -> bool:
        """Whether this is ẋ = …, not x⁺ = …"""
        return self.dt is None

    def poles(self) -> NDArray[np.complex128]:
        """Eigenvalues of A, largest real part first."""
        poles: NDArray[np.complex128] = np.linalg.eigvals(self.A).astype(np.complex128)
        return poles[np.lexsort((poles.imag, -poles.real))]

    def c2d(self, dt: float) -> LinearModel:
        """Exact discretisation for inputs and disturbances held over `dt` [s] (zero-order hold)."""
        if not self.continuous:
            raise InvalidModel(f"the model is discrete already (dt = {self.dt:g} s)", expected="a continuous model")
        if not (np.isfinite(dt) and dt > 0):
            raise InvalidModel(f"dt is {dt} s", expected="a positive period")
        from scipy.linalg import expm

        n, m, k = len(self.states), len(self.inputs), len(self.disturbances)
        block = np.zeros((n + m + k + 1, n + m + k + 1))
        block[:n] = np.column_stack([self.A, self.B, self.E, self.f0])
        held: Array = np.asarray(expm(block * dt), dtype=np.float64)[:n]
        a, b, e, f0 = np.split(held, [n, n + m, n + m + k], axis=1)
        return LinearModel(a, b, self.states, self.inputs, float(dt), e, self.disturbances, self.x0, self.u0, f0[:, 0])

    def next(self, x: ArrayLike, u: ArrayLike, w: ArrayLike | None = None) -> Array:
        """x⁺ (n,) of a discrete model from state (n,), input (m,) and disturbance (k,)."""
        if self.continuous:
            raise InvalidModel("a continuous model has no next state", expected="a discrete one", hint="call c2d(dt)")
        free = self.x0 + self.f0 + self.A @ (np.asarray(x) - self.x0) + self.B @ (np.asarray(u) - self.u0)
        return free if w is None else free + self.E @ np.asarray(w)

    def to_control(self) -> Any:
        """The same as `control.StateSpace`, every state an output, names kept."""
        control: Any = import_module("control")
        n, m = self.B.shape
        return control.StateSpace(
            self.A, self.B, np.eye(n), np.zeros((n, m)), 0 if self.dt is None else self.dt,
            states=list(self.states), inputs=list(self.inputs), outputs=list(self.states),
        )  # fmt: skip

    @classmethod
    def from_control(cls, system: Any) -> LinearModel:
        """From a `control.StateSpace`; its dt must be a number (0: continuous), not True or None."""
        dt = system.dt
        if dt is None or dt is True:
            raise InvalidModel(f"the system's dt is {dt}", expected="0 (continuous) or a period in seconds")
        names = tuple(system.state_labels), tuple(system.input_labels)
        return cls(np.asarray(system.A), np.asarray(system.B), *names, float(dt) if dt else None)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers, for JSON."""
        arrays = {name: getattr(self, name).tolist() for name in ("A", "B", "E", "x0", "u0", "f0")}
        names = {"states": list(self.states), "inputs": list(self.inputs), "disturbances": list(self.disturbances)}
        return {**arrays, **names, "dt": self.dt}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> LinearModel:
        """The inverse of `to_json`."""
        try:
            arrays = {name: np.array(data[name], dtype=np.float64) for name in ("A", "B", "E", "x0", "u0", "f0")}
            names = {name: tuple(data[name]) for name in ("states", "inputs", "disturbances")}
            return cls(**cast(dict[str, Any], arrays | names), dt=data["dt"])
        except (KeyError, TypeError, ValueError) as error:
            raise InvalidModel(f"not a linear model: {error}", expected="JSON written by LinearModel.to_json") from None


def linearise(
    robot: Robot, x: Sequence[float] = (0.0,) * 6, u: Sequence[float] = (0.0, 0.0), model: str = "complete"
) -> LinearModel:
    """The tangent of the dynamics at state `x` (6,) and command `u` (2,), exact to rounding by complex steps
    (Squire and Trapp 1998). It is an equilibrium only where `f0` is zero: driving against losses is not.

    >>> [round(float(pole.real), 2) for pole in linearise(Robot.preset("nxtway-gs")).poles()[:2]]
    [7.44, 0.0]
    """
    if len(x) != 6 or len(u) != 2 or not np.isfinite([*x, *u]).all():
        raise InvalidModel(
            f"operating point x = {list(x)}, u = {list(u)}", expected="six finite states and two commands"
        )

    if model not in MODELS:
        raise InvalidModel(f"no model is called '{model}'", expected=" or ".join(MODELS))

    def column(dx: Sequence[complex], du: Sequence[complex], w: Disturbance) -> Array:
        at_x = [a + b for a, b in zip(x, dx, strict=True)]
        at_u = [a + b for a, b in zip(u, du, strict=True)]
        slopes = derivative(at_x, at_u, robot, w, cmath, model)
        return np.array([complex(s).imag / _TINY for s in slopes])

    def unit(size: int, index: int) -> list[complex]:
        return [1j * _TINY if i == index else 0j for i in range(size)]

    still, idle = unit(6, -1), unit(2, -1)
    A = np.column_stack([column(unit(6, i), idle, CALM) for i in range(6)])
    B = np.column_stack([column(still, unit(2, i), CALM) for i in range(2)])
    force = column(still, idle, Disturbance(force=1j * _TINY))
    moment = column(still, idle, Disturbance(force=1j * _TINY, height=1.0)) - force
    slope = column(still, idle, Disturbance(slope=1j * _TINY))
    f0 = np.array(derivative(x, u, robot, CALM, model=model), dtype=np.float64)
    E = np.column_stack([force, moment, slope])
    return LinearModel(A, B, E=E, disturbances=DISTURBANCES, x0=np.array(x), u0=np.array(u), f0=f0)


def unstable_pole(robot: Robot) -> float:
    """The rate [1/s] at which the robot falls: its largest pole, standing upright."""
    return float(linearise(robot).poles()[0].real)


def impulse_norm(A: Array, B: Array) -> Array:
    """Σ_k |A^k B| (n, m), entry by entry, for an A whose every |eigenvalue| is below `FADING`."""
    total, power = np.abs(B), B
    while np.abs(power).max(initial=0.0) > CONVERGED * total.max(initial=0.0):
        power = A @ power
        total = total + np.abs(power)
    return total
