"""The feedback loop as two linear systems: the robot as its controller meets it, and the controller."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from upright.arrays import Array, Complex
from upright.control.controller import Controller
from upright.control.delay import MOST_PERIODS, ROUNDING, SampledRobot, sampled
from upright.control.law import near_rest
from upright.control.linear_controller import LinearController
from upright.control.state_space import controller_of, plant_of
from upright.errors import InvalidModel, SpecMismatch
from upright.physics.interconnect import feedback
from upright.physics.linear import LinearModel, decays, one_period, poles_of
from upright.robots import Kit, Robot
from upright.signals import STATE_NAMES

LATEST = 0.3  # [s] more delay than this no balancing robot survives
FREE = ("wheel", "yaw")  # a robot stands wherever it is, and in whatever direction
FINEST = 1e-3  # [s] steps of delay: a loop that is unstable between two of them alone is not found


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
        return feedback(self.plant, self.controller, sign=1.0)

    @cached_property
    def _moves(self) -> Array:
        """The closed loop's A."""
        P, K = self.plant, self.controller
        n = len(P.A)
        A = np.empty((n + len(K.A), n + len(K.A)))
        A[:n, :n], A[:n, n:] = P.A + P.B @ K.D @ P.C, P.B @ K.C
        A[n:, :n], A[n:, n:] = K.B @ P.C, K.A + K.B @ P.D @ K.C
        return A

    def poles(self) -> Complex:
        """Of the closed loop, the least stable first."""
        return poles_of(self._moves, continuous=self.plant.continuous)

    @property
    def stable(self) -> bool:
        """Whether the closed loop is."""
        return decays(self._moves, continuous=self.plant.continuous)

    @property
    def stands(self) -> bool:
        """Whether it is but for a mode at rest that the commands do not reach, as a speed that an integrator keeps."""
        if self.stable:
            return True
        closed = self.closed
        return decays(closed.A, continuous=closed.continuous, B=closed.B, C=closed.C)


@dataclass(frozen=True, eq=False, kw_only=True)
class RobotLoop(Loop):
    """The loop of a controller, `linear` near rest, on a robot with the dead time and the sensor delays of its kit.

    Its readings tell nothing of the states `hidden`, or the controller does not look at them: their poles are left out.
    """

    robot: Robot
    kit: Kit
    linear: LinearController
    hidden: tuple[str, ...]

    def on(self, robot: Robot | None = None, kit: Kit | None = None) -> Loop:
        """The same controller, which knows nothing of it, on another robot or with another kit."""
        model = _sampled(robot or self.robot, kit or self.kit, self.linear)
        return Loop(_without(plant_of(model), self.hidden), self.controller)

    def delay_margin(self, at: str = "", latest: float = LATEST) -> float:
        """How much more dead time [s] the loop survives when the controller does not know of it; infinite beyond
        `latest`.

        With `at`, a sensor's channel, it is that sensor's delay that grows. It is raised by `FINEST` until the loop of
        the robot sampled with it is unstable, then bisected.
        """
        high = low = 0.0
        while self._bears(high, at):
            low = high
            high = high + FINEST
            if high > latest:
                return math.inf
        for _ in range(12 if high else 0):
            middle = (low + high) / 2
            low, high = (middle, high) if self._bears(middle, at) else (low, middle)
        return low

    def _bears(self, more: float, at: str) -> bool:
        return self.on(kit=delayed_kit(self.kit, more, at)).stands


def robot_loop(controller: Controller, robot: Robot, kit: Kit) -> RobotLoop:
    """The loop of `controller` on `robot` with `kit`.

    The controller's feedback of the applied command is part of the controller. So a broken loop is broken at the
    motors' effect on the robot. A controller that is linear only near rest is analysed there. Raises
    `InvalidController` for one without a linear form.
    """
    linear = near_rest(controller)
    if linear.command_unit != robot.command_unit:
        raise SpecMismatch(
            f"the controller commands {linear.command_unit}", expected=f"{robot.command_unit}, as '{robot.name}'"
        )
    model = _sampled(robot, kit, linear)
    K = controller_of(linear, model.delay)
    plant = plant_of(model)
    hidden = (*model.hidden, *_overlooked(plant, K))
    return RobotLoop(_without(plant, hidden), K, robot=robot, kit=kit, linear=linear, hidden=hidden)


def delayed_kit(kit: Kit, more: float, at: str) -> Kit:
    """The kit with so much more dead time [s], or with as much more delay of the sensor `at`."""
    if not at:
        return replace(kit, delay=kit.delay + more)
    sensor = kit.sensors[at]
    return replace(kit, sensors=kit.sensors | {at: replace(sensor, delay=sensor.delay + more)})


def _overlooked(plant: LinearModel, controller: LinearModel) -> list[str]:
    """The free positions that a controller does not look at though it is shown them: the heading, where it reads the
    sum of both encoders, or the wheels, where their gain is zero. Each is a pole at 1 that no loop moves."""
    enters = np.vstack([controller.B, controller.D]) @ plant.C
    smallest = ROUNDING * np.abs(enters).max(initial=0.0)
    shown = [name for name in FREE if name in plant.states]
    return [name for name in shown if np.abs(enters @ _at_rest(plant, name)).max() <= smallest]


def _at_rest(plant: LinearModel, name: str) -> Array:
    """The state (n,) in which the robot stands still one radian further: the readings on their way show it as well."""
    at = plant.states.index(name)
    waiting = [i for i, state in enumerate(plant.states) if state not in STATE_NAMES]
    x = np.eye(len(plant.A))[at]
    x[waiting] = np.linalg.solve(np.eye(len(waiting)) - plant.A[np.ix_(waiting, waiting)], plant.A[waiting, at])
    return x


def _without(plant: LinearModel, hidden: Sequence[str]) -> LinearModel:
    """The plant without those of its positions that are `hidden` from the controller alone."""
    places = [plant.states.index(name) for name in hidden if name in plant.states]
    if not places:
        return plant
    still = np.column_stack([_at_rest(plant, plant.states[at]) for at in places])
    rest = np.setdiff1d(np.arange(len(plant.A)), places)
    back = np.eye(len(plant.A))[rest]  # x less what stands still: x_rest − still_rest x_places
    back[:, places] -= still[rest]
    return LinearModel(back @ plant.A[:, rest], back @ plant.B, plant.C[:, rest], dt=plant.dt)


def _sampled(robot: Robot, kit: Kit, linear: LinearController) -> SampledRobot:
    return sampled(robot, kit, linear.period, linear.reads, longest=MOST_PERIODS)
