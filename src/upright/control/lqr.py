"""The discrete linear quadratic regulator: of a model, of a robot's true state, and of a robot on its sensors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from numpy.typing import ArrayLike

from upright.arrays import Array, Complex
from upright.control.delay import sampled
from upright.control.feedback import StateFeedback, table_lines
from upright.control.kalman import RECOVERED, Disturbed
from upright.control.linear_controller import LinearController
from upright.control.observed import observed
from upright.control.riccati import (
    among,
    command_weight,
    price_matrix,
    riccati,
    riccati_residual,
    state_weight,
    weight_matrix,
)
from upright.errors import DesignFailed
from upright.physics.linear import LinearModel, linearise_rolling, poles_of
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import STATE_NAMES


@dataclass(frozen=True, eq=False, repr=False)
class Lqr(StateFeedback):
    """The gain that minimises J = Σ xᵀQx + uᵀRu for x⁺ = Ax + Bu, with what proves it.

    `cost` is the stabilising solution S of the Riccati equation; `check()` re-computes its residual.
    """

    model: LinearModel = field(kw_only=True)
    Q: Array = field(kw_only=True)
    R: Array = field(kw_only=True)
    cost: Array = field(kw_only=True)

    def poles(self) -> Complex:
        """Eigenvalues of A − BK, largest magnitude first."""
        return poles_of(self.model.A - self.model.B @ self.gain, continuous=False)

    def words(self) -> list[str]:
        """K, the solution S of the Riccati equation, and the poles of the loop, without any filter."""
        cost = table_lines("S of the Riccati equation, J = xᵀS x", self.cost, STATE_NAMES)
        poles = ", ".join(f"{p:.4g}" if p.imag else f"{p.real:.4g}" for p in self.poles())
        return [*super().words(), *cost, f"Poles z of A − B K: {poles}"]

    def check(self) -> float:
        """Largest entry of AᵀSA − S − AᵀSB(R + BᵀSB)⁻¹BᵀSA + Q, relative to S's largest."""
        return riccati_residual(self.model.A, self.model.B, self.Q, self.R, self.cost)


def lqr(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed = RECOVERED,
) -> LinearController:
    """`lqr_state` of what the sensors of `kit` show, behind a Kalman filter (`observed`), every `dt` [s] (None: the
    kit's period): what `upright design lqr` writes. Printed, it says K, S and the poles of A − BK.

    Q and R as in `lqr_state`. `reads` are the channels (None: what the kit has), `disturbed` the filter's noise. Raises
    `DesignFailed` for weights of the wrong size or sign, or where no regulator or no filter exists.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    model = sampled(robot, kit, dt, reads)
    feedback = lqr_state(robot, model.dt, Q, R, shown=model.shown)
    return observed(feedback, robot, kit, reads=model.reads, disturbed=disturbed)


def lqr_state(
    robot: Robot | str,
    dt: float,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    shown: Sequence[int] = range(len(STATE_NAMES)),
) -> Lqr:
    """The regulator of the true state, of the robot linearised upright (its Coulomb friction as `rolling` has it) and
    held over `dt` [s]: a simulation has this state, no real robot.

    Q (6, 6) or its diagonal (6,), R (2, 2) or (2,); without them Bryson's rule on `LARGEST_STATE` and
    `LARGEST_COMMAND`. Only the states `shown` are regulated. Raises `DesignFailed` for weights of the wrong size or
    sign, or when no gain stabilises.
    """
    robot = find_robot(robot)
    price = command_weight(robot.command_unit, R)
    return dlqr(linearise_rolling(robot).c2d(dt), state_weight(Q), price, robot.command_unit, shown=shown)


def dlqr(
    model: LinearModel, Q: ArrayLike, R: ArrayLike, command_unit: str = "V", *, shown: Sequence[int] | None = None
) -> Lqr:
    """The regulator of a discrete linear model (Åström and Wittenmark 1997, theorem 11.2), of the states `shown` (None:
    all), which the others do not move."""
    if model.continuous:
        raise DesignFailed("the model is continuous", expected="a discrete one", hint="call model.c2d(dt)")
    states = range(len(model.states))
    weight = among(weight_matrix(Q, len(states), "Q"), states if shown is None else shown)
    price = price_matrix(R, len(model.inputs))
    cost, gain = riccati(model, weight, price, shown)
    return Lqr(gain, model.dt, command_unit, "lqr", model=model, Q=weight, R=price, cost=cost)
