"""The feedback loop as two linear systems: the robot as its controller meets it, and the controller."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from upright.arrays import Array
from upright.control.controller import Controller
from upright.control.delay import MOST_PERIODS, SampledRobot, sampled
from upright.control.near_rest import near_rest
from upright.control.state_space import controller_of, plant_of
from upright.errors import InvalidModel, SpecMismatch
from upright.physics.linear import LinearModel, decays, one_period
from upright.robots import Kit, Robot


@dataclass(frozen=True, eq=False)
class Loop:
    """u = K y round y = P u: `plant` P and `controller` K, whose sign closes the loop. Loop gains carry 1 + L = 0.

    Raises `InvalidModel` where both pass a signal on without any delay.
    """

    plant: LinearModel
    controller: LinearModel

    def __post_init__(self) -> None:
        one_period(self.plant, self.controller)
        if self.plant.D.any() and self.controller.D.any():
            raise InvalidModel("plant and controller both pass signals on at once", expected="a plant with D = 0")

    @cached_property
    def at_input(self) -> LinearModel:
        """L = −K P, broken at the commands."""
        return -(self.controller * self.plant)

    @cached_property
    def at_output(self) -> LinearModel:
        """L = −P K, broken at the readings."""
        return -(self.plant * self.controller)

    @cached_property
    def closed(self) -> LinearModel:
        """From a disturbance at the commands to the readings."""
        P, K = self.plant, self.controller
        B = np.vstack([P.B, K.B @ P.D])
        return LinearModel(self._moves, B, np.hstack([P.C, P.D @ K.C]), P.D, P.dt)

    @cached_property
    def _moves(self) -> Array:
        """The closed loop's A."""
        P, K = self.plant, self.controller
        n = len(P.A)
        A = np.empty((n + len(K.A), n + len(K.A)))
        A[:n, :n], A[:n, n:] = P.A + P.B @ K.D @ P.C, P.B @ K.C
        A[n:, :n], A[n:, n:] = K.B @ P.C, K.A + K.B @ P.D @ K.C
        return A

    @property
    def stable(self) -> bool:
        """Whether the closed loop is."""
        return decays(self._moves, continuous=self.plant.continuous)


def robot_loop(robot: Robot, controller: Controller, kit: Kit) -> Loop:
    """The loop of `controller` on `robot` with the dead time and the sensor delays of `kit`.

    The controller's feedback of the applied command is part of the controller. So a broken loop is broken at the
    motors' effect on the robot. A controller that is linear only near rest is analysed there. Raises
    `InvalidController` for one without a linear form.
    """
    linear = near_rest(controller)
    if linear.command_unit != robot.command_unit:
        raise SpecMismatch(
            f"the controller commands {linear.command_unit}", expected=f"{robot.command_unit}, as '{robot.name}'"
        )
    model = sampled(robot, kit, linear.period, linear.reads, longest=MOST_PERIODS)
    return Loop(commanded_plant(model), controller_of(linear, model.delay))


def commanded_plant(model: SampledRobot) -> LinearModel:
    """From the commands alone to the readings."""
    return plant_of(model, pushed=False)
