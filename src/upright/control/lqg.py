"""LQG: the regulator with a Kalman filter; the dead time and every sensor delay are states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.control.delay import sampled
from upright.control.design import Design
from upright.control.kalman import RECOVERED, Disturbed, Filter, kalman_filter
from upright.control.linear_controller import LinearController
from upright.control.observer import output_feedback
from upright.control.riccati import LARGEST_STATE, among, command_weight, riccati, riccati_residual, state_weight
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot, find_kit, find_robot


@dataclass(frozen=True, eq=False, kw_only=True)
class Lqg(Design):
    """u = u_r − K (x̂ − r) with K from Q, R and the cost P of `riccati` for the `plant`, and x̂ from the `filter`.

    With an integral (lqi) that is the plant's last state.
    """

    filter: Filter
    plant: LinearModel
    Q: Array
    R: Array
    P: Array
    K: Array

    def check(self) -> float:
        """The larger of both Riccati residuals."""
        own = riccati_residual(self.plant.A, self.plant.B, self.Q, self.R, self.P)
        return max(self.filter.check(), own)

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


def regulated(
    estimator: Filter,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    servo: LinearModel | None = None,
    largest: Sequence[float] = LARGEST_STATE,
) -> Lqg:
    """The regulator of the robot that `estimator` sees, under weights as in `lqg`; of the `servo` instead, which has
    further states at its end, so many as Q or `largest` have more than six."""
    model = estimator.sampled
    plant = servo or model.plant
    n = len(plant.A)
    kept = [*model.shown, *range(6, n)]
    costly = [*range(6), *range(n + 6 - len(largest), n)]  # commands on their way cost nothing
    weight = np.zeros((n, n))
    weight[np.ix_(costly, costly)] = state_weight(Q, largest)
    weight = among(weight, kept)
    price = command_weight(model.robot.command_unit, R)
    cost, gain = riccati(plant, weight, price, kept)
    return Lqg(filter=estimator, plant=plant, Q=weight, R=price, P=cost, K=gain)
