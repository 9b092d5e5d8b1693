"""The discrete linear quadratic regulator."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array, Complex
from upright.control.feedback import StateFeedback, table_lines
from upright.control.riccati import (
    LARGEST_COMMAND,
    LARGEST_STATE,
    among,
    bryson,
    riccati,
    riccati_residual,
    weight_matrix,
)
from upright.errors import DesignFailed
from upright.physics.linear import LinearModel, linearise_rolling
from upright.robots import Robot, find_robot
from upright.signals import STATE_NAMES


@dataclass(frozen=True, eq=False, repr=False)
class Lqr(StateFeedback):
    """The gain that minimises J = Σ xᵀQx + uᵀRu for x⁺ = Ax + Bu, with what proves it.

    `cost` is the stabilising solution P of the Riccati equation; `check()` re-computes its residual.
    """

    model: LinearModel = field(kw_only=True)
    Q: Array = field(kw_only=True)
    R: Array = field(kw_only=True)
    cost: Array = field(kw_only=True)

    def poles(self) -> Complex:
        """Eigenvalues of A − BK, largest magnitude first."""
        poles = np.linalg.eigvals(self.model.A - self.model.B @ self.gain).astype(complex)
        return poles[np.argsort(-np.abs(poles))]

    def words(self) -> list[str]:
        """K, the solution S of the Riccati equation, and the poles of the loop, without any filter."""
        cost = table_lines("S of the Riccati equation, J = xᵀS x", self.cost, STATE_NAMES)
        poles = ", ".join(f"{p:.4g}" if p.imag else f"{p.real:.4g}" for p in self.poles())
        return [*super().words(), *cost, f"Poles z of A − B K: {poles}"]

    def check(self) -> float:
        """Largest entry of AᵀPA − P − AᵀPB(R + BᵀPB)⁻¹BᵀPA + Q, relative to P's largest."""
        return riccati_residual(self.model.A, self.model.B, self.Q, self.R, self.cost)


def lqr(
    robot: Robot | str,
    dt: float,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    shown: Sequence[int] = range(len(STATE_NAMES)),
) -> Lqr:
    """The regulator of the robot linearised upright, its Coulomb friction as `rolling` has it, and held over `dt` [s].

    Q (6, 6) or its diagonal (6,), R (2, 2) or (2,); without them Bryson's rule on `LARGEST_STATE` and
    `LARGEST_COMMAND`. Only the states `shown` are regulated. Raises `DesignFailed` for weights of the wrong size or
    sign, or when no gain stabilises.
    """
    robot = find_robot(robot)
    state_weight = bryson(LARGEST_STATE) if Q is None else Q
    command_weight = bryson([LARGEST_COMMAND[robot.command_unit]] * 2) if R is None else R
    return dlqr(linearise_rolling(robot).c2d(dt), state_weight, command_weight, robot.command_unit, shown=shown)


def dlqr(
    model: LinearModel, Q: ArrayLike, R: ArrayLike, command_unit: str = "V", *, shown: Sequence[int] | None = None
) -> Lqr:
    """The regulator of a discrete linear model (Åström and Wittenmark 1997, theorem 11.2), of the states `shown` (None:
    all), which the others do not move."""
    if model.continuous:
        raise DesignFailed("the model is continuous", expected="a discrete one", hint="call model.c2d(dt)")
    weight, price = weight_matrix(Q, len(model.states), "Q"), weight_matrix(R, len(model.inputs), "R")
    weight = among(weight, range(len(weight)) if shown is None else shown)
    if np.linalg.eigvalsh(price)[0] <= 0:
        raise DesignFailed("R is not positive definite", expected="a price on every command", hint="raise its diagonal")
    cost, gain = riccati(model, weight, price, shown)
    return Lqr(gain, model.dt, command_unit, "lqr", model=model, Q=weight, R=price, cost=cost)
