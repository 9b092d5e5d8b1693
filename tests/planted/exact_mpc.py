"""The exact minimum of the problem that the predictive controller stands for, by DAQP in each period."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.control import mpc
from upright.control.controller import ControllerSpec
from upright.control.linear_controller import LinearController
from upright.control.lqg import Lqg
from upright.control.mpc import SOFTNESS, UNLIMITED, PredictiveController, predicted
from upright.control.observer import memory, steady_push, steady_state
from upright.control.reach import largest_command
from upright.errors import DesignFailed
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]
SOFT, HARD = 8, 0  # DAQP's names for a constraint that may and one that may not be broken


@dataclass(frozen=True, eq=False)
class QuadraticProgram:
    """min ½ UᵀH U + fᵀU over |U| ≤ limit, |rows U + c| ≤ 1, soft: breaking a row by e costs e²/(2 softness)."""

    H: Array
    rows: Array
    limit: float
    softness: Array

    def solver(self) -> Any:
        """A DAQP workspace."""
        daqp: Any = import_module("daqp")
        model, n, k = daqp.Model(), len(self.H), len(self.rows)
        upper = np.concatenate([np.full(n, self.limit), np.ones(k)])
        sense = np.array([HARD] * n + [SOFT] * k, dtype=np.int32)
        flag, _ = model.setup(self.H, np.zeros(n), self.rows, upper, -upper, sense)
        if flag < 0:
            raise DesignFailed(f"DAQP refuses the programme (flag {flag})", expected="a positive definite H")
        weights = np.concatenate([np.ones(n), self.softness])
        model.soft_weights(rho_l=weights, rho_u=weights)
        return model

    def solve(self, solver: Any, f: Array, c: Array) -> Array:
        """U (2N,); raises `DesignFailed` where DAQP gives none."""
        limit = np.full(len(self.H), self.limit)
        solver.update(f=f, bupper=np.concatenate([limit, 1 - c]), blower=np.concatenate([-limit, -1 - c]))
        U, _, flag, _ = solver.solve()
        if flag <= 0:
            raise DesignFailed(f"DAQP gives no solution (flag {flag})", expected="limits that can be kept")
        return U


@dataclass(eq=False)
class Exact:
    """The controller of the exact minimum: outputs of `memory` are [f (2N), c]."""

    memory: LinearController
    programme: QuadraticProgram
    solver: Any = field(init=False, repr=False)

    def __post_init__(self) -> None:
        self.reset()

    @property
    def spec(self) -> ControllerSpec:
        return self.memory.spec

    def reset(self) -> None:
        self.memory.reset()
        self.solver = self.programme.solver()

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        outputs, n = self.memory.outputs(measurement, reference), len(self.programme.H)
        left, right = self.programme.solve(self.solver, outputs[:n], outputs[n:])[:2].tolist()
        self.memory.decided(left, right)
        return left, right

    def estimate(self) -> Sequence[float]:
        return self.memory.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.memory.applied(command)

    def to_json(self) -> dict[str, Any]:
        return self.memory.facts()

    def __deepcopy__(self, memo: dict[int, Any]) -> Exact:
        return Exact(copy.deepcopy(self.memory, memo), self.programme)


def exact(
    robot: Robot, kit: Kit, *, pitch: float = 0.3, travel: float = 1.0, limit: float | None = None,
    instants: Sequence[int] = range(3, 31, 3), horizon: int = 30,
) -> Exact:  # fmt: skip
    """The judge of `mpc` with the same arguments; pitch and travel are bounded after so many `instants` periods, each
    for the periods since the one before."""
    design = mpc(robot, kit).design
    assert isinstance(design, Lqg)
    model, plant = design.filter.sampled, design.filter.sampled.plant
    free, forced = predicted(plant.A, plant.B, (1,) * horizon)
    weights = np.repeat(design.Q[None], horizon, axis=0)
    weights[-1] = design.P
    H = np.einsum("kia,kij,kjb->ab", forced[1:], weights, forced[1:]) + np.kron(np.eye(horizon), design.R)
    gradient = np.einsum("kia,kij,kjb->ab", forced[1:], weights, free[1:])
    bounds = [(STATE_NAMES.index("pitch"), pitch), (STATE_NAMES.index("wheel"), travel / robot.wheel_radius)]
    when = list(instants)
    rows = np.vstack([forced[when, i] / b for i, b in bounds])
    drift = np.vstack([free[when, i] / b for i, b in bounds])
    lean = np.concatenate([np.full(len(when), (i == 0) / b) for i, b in bounds])
    G, every = np.vstack([gradient, drift]), np.tile(np.eye(2), (horizon, 1))

    def outputs(xi_s: Array, u_s: Array) -> Array:
        return np.vstack([-H @ every @ u_s, -rows @ every @ u_s + np.outer(lean, xi_s[0])]) - G @ xi_s

    (xi_r, u_r), (xi_push, u_push) = steady_state(model), steady_push(model)
    g = outputs(xi_push[:, None], u_push[:, None])[:, 0]
    most = min(largest_command(robot, kit) if limit is None else limit, UNLIMITED)
    recursion = memory(design.filter, G, g, outputs(xi_r, u_r), kind="exact mpc")
    softness = SOFTNESS / np.tile(np.diff([0, *when]), 2)
    return Exact(recursion, QuadraticProgram((H + H.T) / 2, rows, most, softness))


@dataclass(eq=False)
class Watched:
    """`judge` drives; `other` gets the same readings and what was really applied, and its commands are kept."""

    judge: Any
    other: PredictiveController
    commands: list[tuple[float, ...]] = field(default_factory=list)
    counted: list[bool] = field(default_factory=list)
    residual: float = 0.0

    @property
    def spec(self) -> ControllerSpec:
        return self.judge.spec

    def reset(self) -> None:
        self.judge.reset()
        self.other.reset()

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        command, own = self.judge.step(measurement, reference), self.other.step(measurement, reference)
        self.other.memory.decided(*command)
        self.commands.append((*command, *own))
        self.counted.append(self.other.limited)
        self.residual = max(self.residual, self.other.residual)
        return command

    def estimate(self) -> Sequence[float]:
        return self.judge.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.judge.applied(command)
        self.other.applied(command)

    def to_json(self) -> dict[str, Any]:
        return self.judge.to_json()
