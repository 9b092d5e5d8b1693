"""Linear models: the tangent of the dynamics, its exact discretisation, and `LinearModel`."""

from __future__ import annotations

import cmath
from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass, field, replace
from functools import lru_cache
from importlib import import_module
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Complex, read_only
from upright.errors import InvalidModel, InvalidRobot, UprightError, require
from upright.pages import Result
from upright.physics.dynamics import CALM, MODELS, Disturbance, derivative
from upright.robots import Robot, find_robot
from upright.robots.robot import unusual
from upright.signals import STATE_NAMES

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page

FADING = 1 - 1e-5  # |pole| beyond which a memory counts as one that never fades: it would take 1000 s
CONVERGED = 1e-10  # of the sum: a response that has faded so far adds less than `SPARE` from then on
_TOGETHER = 6  # 2⁶ responses are computed in one product

INPUTS = ("left", "right")
DISTURBANCES = ("force", "moment", "slope")
"""A push enters as its force [N] and its moment about the axle [N m]; the floor as its slope [rad]."""

_ARRAYS = ("A", "B", "C", "D", "E", "x0", "u0", "f0")
_NAMES = ("states", "inputs", "outputs", "disturbances")
_TINY = 1e-100  # complex step: no subtraction, so no cancellation, and its square vanishes


def _empty() -> Array:
    return np.zeros((0, 0))


@lru_cache(maxsize=256)
def _zeros(shape: tuple[int, ...]) -> Array:
    """Zeros that all models share, read-only."""
    return np.broadcast_to(0.0, shape)


@lru_cache(maxsize=64)
def _identity(n: int) -> Array:
    return read_only(np.eye(n))


@lru_cache(maxsize=256)
def _numbered(letter: str, count: int) -> tuple[str, ...]:
    """x[0], x[1], … as python-control names them."""
    return tuple(f"{letter}[{i}]" for i in range(count))


def poles_of(A: Array, *, continuous: bool) -> Complex:
    """Eigenvalues of A, the least stable of ẋ = A x first, or of x⁺ = A x where that is not `continuous`."""
    poles: Complex = np.linalg.eigvals(A).astype(np.complex128)
    return poles[np.lexsort((poles.imag, -_growth(poles, continuous=continuous)))]


STILL = 1e-6
"""From s = 0 or z = 1, relative to the fastest pole: nearer than any motion of a robot, and above rounding."""


def decays(A: Array, *, continuous: bool, B: Array | None = None, C: Array | None = None) -> bool:
    """Whether every pole of ẋ = A x decays, or of x⁺ = A x where that is not `continuous`.

    With B and C a pole at rest, s = 0 or z = 1, that no input reaches or no output shows does not count: there the free
    robot was left, such as at a constant speed that an integrator keeps up, and it is no part of the loop.
    """
    edge = 0.0 if continuous else 1.0
    lasting = _growth(np.linalg.eigvals(A).astype(np.complex128), continuous=continuous) >= edge
    if B is None or C is None or not lasting.any():
        return not lasting.any()
    from scipy.linalg import eig

    modes: Any = eig(A, left=True)
    values, left, right = modes
    unreached = np.abs(left.conj().T @ B).max(axis=1) < STILL * np.abs(B).max()
    unseen = np.abs(C @ right).max(axis=0) < STILL * np.abs(C).max()
    lasting = _growth(values, continuous=continuous) >= edge
    at_rest = np.abs(values - edge) < STILL * np.abs(values).max()
    return not (lasting & ~(at_rest & (unreached | unseen))).any()


def _growth(poles: Complex, *, continuous: bool) -> Array:
    return np.real(poles) if continuous else np.abs(poles)


@dataclass(frozen=True, eq=False, repr=False)
class LinearModel(Result):
    """Deviations from (x0, u0): ẋ = f0 + A (x − x0) + B (u − u0) + E w, or x⁺ − x0 = … where `dt` is a period [s].

    A (n, n), B (n, m), E (n, k) for the named `disturbances`; y = C x + D u with C (p, n) and D (p, m), by default
    every state and zero. As in python-control, `dt` is 0 for continuous time. f0 (n,) is what drives the state at
    (x0, u0): zero at an equilibrium. Six states without names and without C are those of the robot. `subject` is the
    name of what it describes, `input_unit` the unit of its inputs, where they are known.

    Raises `InvalidModel` for wrong sizes, values that are not finite, or a negative `dt`.
    """

    A: Array
    B: Array
    C: Array = field(default_factory=_empty)
    D: Array = field(default_factory=_empty)
    dt: float = 0.0
    _: KW_ONLY
    states: tuple[str, ...] = ()
    inputs: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    E: Array = field(default_factory=_empty)
    disturbances: tuple[str, ...] = ()
    x0: Array = field(default_factory=lambda: np.zeros(0))
    u0: Array = field(default_factory=lambda: np.zeros(0))
    f0: Array = field(default_factory=lambda: np.zeros(0))
    subject: str = ""
    input_unit: str = ""

    def __post_init__(self) -> None:
        n = len(self.states) or len(self.A)
        m = len(self.inputs) or np.shape(self.B)[-1]
        k = len(self.disturbances)
        every = n > 0 and np.size(self.C) == 0
        p = len(self.outputs) or (n if every else len(self.C if n else self.D))
        shapes = {"A": (n, n), "B": (n, m), "C": (p, n), "D": (p, m), "E": (n, k), "x0": (n,), "u0": (m,), "f0": (n,)}
        for name, shape in shapes.items():
            given = getattr(self, name)
            if np.size(given) == 0:
                object.__setattr__(self, name, _identity(n) if name == "C" and every else _zeros(shape))
                continue
            value: Array = np.array(given, dtype=np.float64)
            if value.shape != shape:
                raise InvalidModel(
                    f"{name} has shape {value.shape}",
                    expected=f"{shape} for {n} states, {m} inputs and {p} outputs",
                    likely="a transpose",
                )
            if not np.isfinite(value).all():
                raise InvalidModel(f"{name} holds {value[~np.isfinite(value)][0]}", expected="finite numbers")
            value.setflags(write=False)
            object.__setattr__(self, name, value)
        if not (np.isfinite(self.dt) and self.dt >= 0):
            raise InvalidModel(f"dt is {self.dt} s", expected="a positive period, or 0 for continuous time")
        robot = every and n == len(STATE_NAMES)
        states = self.states or (STATE_NAMES if robot else _numbered("x", n))
        inputs = self.inputs or (INPUTS if robot and m == len(INPUTS) else _numbered("u", m))
        outputs = self.outputs or (states if every else _numbered("y", p))
        for name, labels in {"states": states, "inputs": inputs, "outputs": outputs}.items():
            object.__setattr__(self, name, tuple(labels))

    def __repr__(self) -> str:
        kind = "continuous" if self.continuous else f"every {self.dt:g} s"
        return f"LinearModel({len(self.A)} states, {len(self.inputs)} inputs, {len(self.outputs)} outputs, {kind})"

    def page(self) -> Page:
        """The model for people."""
        from upright.physics.linear_page import linear_page

        return linear_page(self)

    def plot(self) -> Figure:
        """The poles in the plane."""
        from upright.physics.linear_page import poles_picture

        return poles_picture(self).draw()

    @classmethod
    def gain(cls, D: ArrayLike, dt: float = 0.0) -> LinearModel:
        """A gain D (p, m) without states."""
        matrix = np.asarray(D, dtype=np.float64)
        p, m = matrix.shape
        return cls(np.zeros((0, 0)), np.zeros((0, m)), np.zeros((p, 0)), matrix, dt)

    @property
    def continuous(self) -> bool:
        """Whether this is ẋ = …, not x⁺ = …"""
        return self.dt == 0

    @property
    def stable(self) -> bool:
        """Whether every pole decays."""
        return decays(self.A, continuous=self.continuous)

    def poles(self) -> Complex:
        """Eigenvalues of A, the least stable first."""
        return poles_of(self.A, continuous=self.continuous)

    def points(self, omega: Array) -> Complex:
        """λ (len(omega),), jω or e^{jω dt}, at ω in [rad/s]."""
        jw: Complex = (1j * omega).astype(np.complex128)
        return jw if self.continuous else np.exp(jw * self.dt)

    def response(self, omega: ArrayLike) -> Complex:
        """The gain (p, m, len(omega)) at each frequency ω [rad/s]: outputs, inputs, frequencies, as
        `control.frequency_response` has them."""
        return np.moveaxis(self.matrices(omega), 0, -1)

    def matrices(self, omega: ArrayLike) -> Complex:
        """C (λI − A)⁻¹ B + D at λ = jω or e^{jω dt}, the same as a stack (len(omega), p, m), which NumPy multiplies."""
        w = np.atleast_1d(np.asarray(omega, dtype=np.float64))
        points = self.points(w)
        shifted = points[:, None, None] * np.eye(len(self.A)) - self.A
        return self.C @ np.linalg.solve(shifted, np.broadcast_to(self.B, (len(w), *self.B.shape))) + self.D

    def __mul__(self, first: LinearModel) -> LinearModel:
        """This system behind `first`, as python-control's `*`."""
        one_period(self, first)
        n, m = len(self.A), len(first.A)
        A = np.block([[self.A, self.B @ first.C], [np.zeros((m, n)), first.A]])
        B = np.vstack([self.B @ first.D, first.B])
        C = np.hstack([self.C, self.D @ first.C])
        return LinearModel(A, B, C, self.D @ first.D, self.dt, inputs=first.inputs, outputs=self.outputs)

    def __neg__(self) -> LinearModel:
        return replace(self, C=-self.C, D=-self.D)

    def scaled(self, inputs: ArrayLike, outputs: ArrayLike) -> LinearModel:
        """With each input counted in units of `inputs` (m,) and each output in units of `outputs` (p,)."""
        u = np.asarray(inputs, dtype=np.float64)
        y = 1 / np.asarray(outputs, dtype=np.float64)
        return LinearModel(
            self.A, self.B * u, y[:, None] * self.C, y[:, None] * self.D * u, self.dt,
            states=self.states, inputs=self.inputs, outputs=self.outputs,
        )  # fmt: skip

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
        return replace(self, A=a, B=b, E=e, f0=f0[:, 0], dt=float(dt))

    def next(self, x: ArrayLike, u: ArrayLike, w: ArrayLike | None = None) -> Array:
        """x⁺ (n,) of a discrete model from state (n,), input (m,) and disturbance (k,)."""
        if self.continuous:
            raise InvalidModel("a continuous model has no next state", expected="a discrete one", hint="call c2d(dt)")
        free = self.x0 + self.f0 + self.A @ (np.asarray(x) - self.x0) + self.B @ (np.asarray(u) - self.u0)
        return free if w is None else free + self.E @ np.asarray(w)

    def to_control(self) -> Any:
        """The same as `control.StateSpace`, names kept."""
        require("to_control", "control")
        control: Any = import_module("control")
        names = {name: list(getattr(self, name)) for name in ("states", "inputs", "outputs")}
        return control.StateSpace(self.A, self.B, self.C, self.D, self.dt, **names)

    @classmethod
    def from_control(cls, system: Any) -> LinearModel:
        """From a `control.StateSpace` or `control.TransferFunction`; its dt must be a number, not True or None."""
        require("from_control", "control")
        control: Any = import_module("control")
        system = control.ss(system)
        if system.dt is None or system.dt is True:
            raise InvalidModel(f"the system's dt is {system.dt}", expected="0 (continuous) or a period in seconds")
        names = [tuple(labels) for labels in (system.state_labels, system.input_labels, system.output_labels)]
        matrices = system.A, system.B, system.C, system.D
        return cls(*matrices, float(system.dt), states=names[0], inputs=names[1], outputs=names[2])

    def to_json(self) -> dict[str, Any]:
        """Plain numbers, for JSON, the poles with real and imaginary part."""
        return {
            "schema": "upright/linearise/1",
            **{name: getattr(self, name).tolist() for name in _ARRAYS},
            **{name: list(getattr(self, name)) for name in _NAMES},
            "dt": self.dt,
            "subject": self.subject,
            "input_unit": self.input_unit,
            "poles": [[float(p.real), float(p.imag)] for p in self.poles()],
        }

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> LinearModel:
        """The inverse of `to_json`; older files lack C, D and the outputs, and say null for continuous time."""
        given: dict[str, Any] = {"C": [], "D": [], "outputs": []} | data
        try:
            arrays = {name: np.array(given[name], dtype=np.float64) for name in _ARRAYS}
            names = {name: tuple(given[name]) for name in _NAMES}
            labels = {name: str(given.get(name, "")) for name in ("subject", "input_unit")}
            return cls(**cast(dict[str, Any], arrays | names | labels), dt=given["dt"] or 0.0)
        except (KeyError, TypeError, ValueError) as error:
            raise InvalidModel(f"not a linear model: {error}", expected="JSON written by LinearModel.to_json") from None


@lru_cache(maxsize=256)
def delay_line(width: int, periods: int, dt: float) -> LinearModel:
    """`width` signals, `periods` periods of `dt` [s] late: what waits is its state, newest first."""
    n = width * periods
    A = np.eye(n, k=-width)
    B = np.eye(n, width)
    C = np.eye(width, n, k=n - width)
    return LinearModel(A, B, C, np.zeros((width, width)) if periods else np.eye(width), dt)


def one_period(one: LinearModel, other: LinearModel) -> None:
    """Refuse two systems of different periods."""
    if one.dt != other.dt:
        raise InvalidModel(f"periods of {one.dt} and {other.dt} s in one loop", expected="equal periods")


def linearise(
    robot: Robot | str, x: Sequence[float] = (0.0,) * 6, u: Sequence[float] = (0.0, 0.0), model: str = "complete"
) -> LinearModel:
    """The tangent of the dynamics at state `x` (6,) and command `u` (2,), exact to rounding by complex steps
    (Squire and Trapp 1998). It is an equilibrium only where `f0` is zero: driving against losses is not.

    >>> [round(float(pole.real), 2) for pole in linearise("nxtway-gs").poles()[:2]]
    [7.44, 0.0]
    """
    if len(x) != 6 or len(u) != 2 or not np.isfinite([*x, *u]).all():
        raise InvalidModel(
            f"operating point x = {list(x)}, u = {list(u)}", expected="six finite states and two commands"
        )

    if model not in MODELS:
        raise InvalidModel(f"no model is called '{model}'", expected=" or ".join(MODELS))
    known = find_robot(robot)
    at = tangent(known, tuple(map(float, x)), tuple(map(float, u)), model)
    return replace(at, subject=known.name, input_unit=known.command_unit)


@lru_cache(maxsize=256)
def linearise_rolling(robot: Robot) -> LinearModel:
    """The tangent upright of the robot as it rolls (`Robot.rolling`): what designs and linear bodies take it for."""
    return tangent(robot.rolling())


@lru_cache(maxsize=256)  # a margin asks for that of one robot hundreds of times
def tangent(
    robot: Robot, x: tuple[float, ...] = (0.0,) * 6, u: tuple[float, ...] = (0.0, 0.0), model: str = "complete"
) -> LinearModel:
    """`linearise` of a robot at hand, at a point that is one."""

    def rates(dx: Sequence[complex], du: Sequence[complex], w: Disturbance) -> Complex:
        at_x = [a + b for a, b in zip(x, dx, strict=True)]
        at_u = [a + b for a, b in zip(u, du, strict=True)]
        try:
            return np.array(derivative(at_x, at_u, robot, w, cmath, model), dtype=np.complex128)
        except ArithmeticError:  # the mass matrix is singular to rounding, or a speed overflows
            raise _extreme(robot, x, u) from None

    def column(dx: Sequence[complex], du: Sequence[complex], w: Disturbance) -> Array:
        return rates(dx, du, w).imag / _TINY

    def unit(size: int, index: int) -> list[complex]:
        return [1j * _TINY if i == index else 0j for i in range(size)]

    still, idle = unit(6, -1), unit(2, -1)
    A = np.column_stack([column(unit(6, i), idle, CALM) for i in range(6)])
    B = np.column_stack([column(still, unit(2, i), CALM) for i in range(2)])
    force = column(still, idle, Disturbance(force=1j * _TINY))
    moment = column(still, idle, Disturbance(force=1j * _TINY, height=1.0)) - force
    slope = column(still, idle, Disturbance(slope=1j * _TINY))
    E = np.column_stack([force, moment, slope])
    f0 = rates(still, idle, CALM).real
    return LinearModel(A, B, E=E, disturbances=DISTURBANCES, x0=np.array(x), u0=np.array(u), f0=f0)


def _extreme(robot: Robot, x: Sequence[float], u: Sequence[float]) -> UprightError:
    """What divides by zero or overflows: the robot's numbers upright and at rest, else the operating point."""
    if any((*x, *u)):
        return InvalidModel(f"no tangent at x = {list(x)}, u = {list(u)}", expected="a motion that a robot can make")
    hint = f"check {unusual(robot.numbers()) or 'its inertias'}"
    return InvalidRobot(f"{robot.name}: its numbers are too far apart to compute with", hint=hint)


def unstable_pole(robot: Robot) -> float:
    """The rate [1/s] at which the robot falls: its largest pole, standing upright."""
    return float(tangent(robot).poles()[0].real)


def impulse_norm(A: Array, B: Array) -> Array:
    """Σ_k |A^k B| (n, m), entry by entry, for an A whose every |eigenvalue| is below `FADING`."""
    n, m = B.shape
    power, responses = A, B  # (n, count m): A^k B beside one another, many to a product
    for _ in range(_TOGETHER):
        responses = np.hstack([responses, power @ responses])
        power = power @ power
    total = np.zeros((n, m))
    while True:
        total = total + np.abs(responses).reshape(n, 2**_TOGETHER, m).sum(axis=1)
        if np.abs(responses[:, -m:]).max(initial=0.0) <= CONVERGED * total.max(initial=0.0):
            return total
        responses = power @ responses
