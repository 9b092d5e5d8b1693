"""Forward sensitivities: how a trajectory changes with the robot's parameters and its start, from the traced equations.

Compiled functions for other compiled code (Numba); vectors are one-dimensional arrays of float64:

- `constants(p, complete)` → c (CONSTANTS,) from parameters p (21,) in the order of `robots.robot.PARAMETERS`;
- `constants_jacobian(p, complete)` → ∂c/∂p (CONSTANTS, 21);
- `derivative(x, u, w, c)` → ẋ (6,) at state x (6,), command u (2,) and world w (4,): force [N], moment about the axle
  [N m], sine and cosine of the slope;
- `jacobians(x, u, w, c)` → ẋ, ∂ẋ/∂x (6, 6), ∂ẋ/∂u (6, 2), ∂ẋ/∂(force, moment) (6, 2), ∂ẋ/∂c (6, CONSTANTS);
- `rk4_tangent_step(x, X, u, w, c, C, h)` → x and X one Runge–Kutta step on, with X (6, d) = ∂x/∂direction and C
  (CONSTANTS, d) = ∂c/∂direction: the exact derivative of the step, which costs one pass for all directions.

All with Coulomb friction and slope; a robot without them pays little.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.compiled import generated, generated_tangent
from upright.compiled.generated import CONSTANTS
from upright.errors import InvalidScenario, UnknownName
from upright.kernel.simulate import substeps_for
from upright.robots import Robot
from upright.robots.robot import PARAMETERS
from upright.signals import STATE_NAMES

numba: Any = import_module("numba")  # untyped: `Any` says so to the type checker

Array = NDArray[np.float64]

DIRECTIONS = 16
"""So many directions at once are what the kernel is meant for; more only take longer."""

_NUMBERS = len(PARAMETERS)
_njit: Any = partial(numba.njit, cache=True, nogil=True, error_model="numpy")
_constants: Any = numba.njit(error_model="numpy")(generated.constants)
_constants_jacobian: Any = numba.njit(error_model="numpy")(generated_tangent.constants_jacobian)
generated_tangent.fma = numba.njit(generated_tangent.fma, error_model="numpy")
_tangent: Any = numba.njit(error_model="numpy")(generated_tangent.tangent)


@_njit
def constants(p: Any, complete: float) -> Any:
    """c (CONSTANTS,) of parameters p (21,)."""
    return np.array(_constants(p, complete))


@_njit
def constants_jacobian(p: Any, complete: float) -> Any:
    """∂c/∂p (CONSTANTS, 21)."""
    out = np.zeros((CONSTANTS, _NUMBERS))
    _constants_jacobian(p, complete, out)
    return out


@_njit
def _linearised(x: Any, u: Any, w: Any, c: Any, fx: Any, fu: Any, fw: Any, fc: Any) -> Any:
    """ẋ (6,) as a tuple; rows 1, 3 and 5 of the Jacobians are written."""
    pitch, wheel, yaw = _tangent(x[0], x[1], x[3], x[4], x[5], u[0], u[1], w[0], w[1], w[2], w[3], c, fx, fu, fw, fc)
    return x[1], pitch, x[3], wheel, x[5], yaw


@_njit
def _room() -> Any:
    """Jacobians, with the ones that say ψ̇, θ̇ and φ̇ are states."""
    fx = np.zeros((6, 6))
    fx[0, 1] = fx[2, 3] = fx[4, 5] = 1.0
    return fx, np.zeros((6, 2)), np.zeros((6, 2)), np.zeros((6, CONSTANTS))


@_njit
def jacobians(x: Any, u: Any, w: Any, c: Any) -> Any:
    """ẋ (6,), ∂ẋ/∂x, ∂ẋ/∂u, ∂ẋ/∂(force, moment), ∂ẋ/∂c."""
    fx, fu, fw, fc = _room()
    slopes = _linearised(x, u, w, c, fx, fu, fw, fc)
    return np.array(slopes), fx, fu, fw, fc


@_njit
def derivative(x: Any, u: Any, w: Any, c: Any) -> Any:
    """ẋ (6,)."""
    return jacobians(x, u, w, c)[0]


@_njit
def _tangent_of(fx: Any, fc: Any, X: Any, C: Any, out: Any) -> None:
    """out = fx X + fc C, side by side over the directions."""
    for row in range(6):
        for d in range(X.shape[1]):
            out[row, d] = 0.0
        for k in range(6):
            for d in range(X.shape[1]):
                out[row, d] += fx[row, k] * X[k, d]
        if row % 2 == 1:
            for k in range(CONSTANTS):
                for d in range(X.shape[1]):
                    out[row, d] += fc[row, k] * C[k, d]


@_njit
def rk4_tangent_step(x: Any, X: Any, u: Any, w: Any, c: Any, C: Any, h: float) -> Any:
    """x (6,) and X (6, d) one step of `h` [s] on."""
    fx, fu, fw, fc = _room()
    at, moved, slope, tangent = x.copy(), X.copy(), np.zeros(6), np.zeros_like(X)
    sum_x, sum_X = np.zeros(6), np.zeros_like(X)
    for stage in range(4):
        slopes = _linearised(at, u, w, c, fx, fu, fw, fc)
        _tangent_of(fx, fc, moved, C, tangent)
        weight = 1.0 if stage in (0, 3) else 2.0
        step = h if stage == 2 else h / 2
        for row in range(6):
            slope[row] = slopes[row]
            sum_x[row] += weight * slope[row]
            at[row] = x[row] + step * slope[row]
            for d in range(X.shape[1]):
                sum_X[row, d] += weight * tangent[row, d]
                moved[row, d] = X[row, d] + step * tangent[row, d]
    return x + h / 6 * sum_x, X + h / 6 * sum_X


@_njit
def _run(x: Any, first: Any, c: Any, C: Any, commands: Any, world: Any, h: float, steps: int) -> Any:
    states, tangents = np.zeros((len(commands) + 1, 6)), np.zeros((len(commands) + 1, *first.shape))
    states[0], tangents[0], tangent = x, first, first
    for k in range(len(commands)):
        for _ in range(steps):
            x, tangent = rk4_tangent_step(x, tangent, commands[k], world[k], c, C, h)
        states[k + 1], tangents[k + 1] = x, tangent
    return states, tangents


@dataclass(frozen=True, eq=False)
class Sensitivities:
    """`states` (k + 1, 6) at times `t` (k + 1,) [s], and `tangents` (k + 1, 6, d): ∂state/∂direction for the named
    `directions`, parameters by their name and initial states as "start/pitch", …; read-only."""

    t: Array
    states: Array
    tangents: Array
    directions: tuple[str, ...]

    def __post_init__(self) -> None:
        for array in (self.t, self.states, self.tangents):
            array.setflags(write=False)


def simulate_with_sensitivities(
    robot: Robot,
    commands: ArrayLike,
    period: float,
    directions: Sequence[str],
    *,
    start: Sequence[float] = (0.0,) * 6,
    pushes: ArrayLike | None = None,
    model: str = "complete",
    substeps: int | None = None,
) -> Sensitivities:
    """The robot's open-loop trajectory under `commands` (k, 2), each held for `period` [s], and its tangents.

    `directions` are names of parameters and "start/<state>"; `pushes` (k, 2) are force [N] and moment about the axle
    [N m] in each period. Raises `UnknownName` for a direction that is neither, `InvalidScenario` for commands of
    the wrong shape.
    """
    held = np.array(commands, dtype=np.float64)
    if held.ndim != 2 or held.shape[1] != 2:
        raise InvalidScenario(f"commands have shape {held.shape}", expected="(k, 2): left and right in each period")
    p = np.array(list(robot.numbers().values()))
    X, by_parameter = _seeds(directions)
    complete = float(model == "complete")
    C = constants_jacobian(p, complete) @ by_parameter
    steps = substeps or 5 * substeps_for(p[None], model, period)
    world = np.zeros((len(held), 4))
    world[:, 3] = 1.0
    world[:, :2] = 0.0 if pushes is None else pushes
    states, tangents = _run(
        np.array(start, dtype=np.float64), X, constants(p, complete), C, held, world, period / steps, steps
    )  # fmt: skip
    return Sensitivities(np.arange(len(held) + 1, dtype=np.float64) * period, states, tangents, tuple(directions))


def _seeds(directions: Sequence[str]) -> tuple[Array, Array]:
    """∂start/∂direction (6, d) and ∂parameters/∂direction (21, d)."""
    starts, names = [f"start/{name}" for name in STATE_NAMES], list(PARAMETERS)
    X, by_parameter = np.zeros((6, len(directions))), np.zeros((len(names), len(directions)))
    for column, direction in enumerate(directions):
        if direction in names:
            by_parameter[names.index(direction), column] = 1.0
        elif direction in starts:
            X[starts.index(direction), column] = 1.0
        else:
            raise UnknownName("direction", direction, [*names, *starts])
    return X, by_parameter
