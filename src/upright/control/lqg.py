"""LQG: the regulator with a Kalman filter; the dead time and every sensor delay are states."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.control.delay import SampledRobot, sampled
from upright.control.design import Design
from upright.control.kalman import RECOVERED, Disturbed, Filter, kalman_filter
from upright.control.linear_controller import LinearController
from upright.control.observer import output_feedback
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
from upright.robots import Kit, Robot, find_kit, find_robot


@dataclass(frozen=True, eq=False)
class Lqg(Design):
    """u = u_r − K (x̂ − r) with K from Q, R and the cost P of `riccati`, and x̂ from the `filter`."""

    filter: Filter
    Q: Array
    R: Array
    P: Array
    K: Array

    def check(self) -> float:
        """The larger of both Riccati residuals."""
        plant = self.filter.sampled.plant
        return max(self.filter.check(), riccati_residual(plant.A, plant.B, self.Q, self.R, self.P))

    @property
    def gain(self) -> Array:
        """K, the six states first."""
        return self.K


def lqg(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed = RECOVERED,
) -> LinearController:
    """The linear quadratic Gaussian regulator (Anderson and Moore 1979, ch. 8) for `robot` on the sensors of `kit`.

    Q (6, 6) or its diagonal (6,) weighs the state, R (2, 2) or (2,) the command; without them Bryson's rule. Raises
    `DesignFailed` for weights of the wrong size or sign, or where no regulator or no filter exists.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    design = regulated(kalman_filter(sampled(robot, kit, dt, reads), disturbed), Q, R)
    return output_feedback(design.filter, design.K, "lqg", design)


def regulated(estimator: Filter, Q: ArrayLike | None = None, R: ArrayLike | None = None) -> Lqg:
    """The regulator of the robot that `estimator` sees, under weights as in `lqg`."""
    model = estimator.sampled
    weight = state_weight(model, Q)
    price = command_weight(model.robot, R)
    return Lqg(estimator, weight, price, *riccati(model.plant, weight, price, regulated_states(model)))


def regulated_states(model: SampledRobot) -> list[int]:
    """Of the plant: those of the robot that readings show, and the commands on their way."""
    return [*model.shown, *range(6, len(model.plant.states))]


def state_weight(model: SampledRobot, Q: ArrayLike | None, largest: ArrayLike = LARGEST_STATE) -> Array:
    """Q (6, 6), or its diagonal, or Bryson's rule, padded with zeros for the commands on their way; zero for what no
    reading shows."""
    weight = among(weight_matrix(bryson(largest) if Q is None else Q, 6, "Q"), model.shown)
    return np.pad(weight, (0, len(model.plant.states) - 6))


def command_weight(robot: Robot, R: ArrayLike | None) -> Array:
    """R (2, 2), or its diagonal, or Bryson's rule, positive definite."""
    price = weight_matrix(bryson([LARGEST_COMMAND[robot.command_unit]] * 2) if R is None else R, 2, "R")
    if np.linalg.eigvalsh(price)[0] <= 0:
        raise DesignFailed("R is not positive definite", expected="a price on every command", hint="raise its diagonal")
    return price
