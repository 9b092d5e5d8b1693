"""The nonlinear and the linear model as bodies."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from upright.bodies.body import FALLEN, REST, BodySpec, Sample, checked, checked_period, sample
from upright.compiled.straight_line import Step, written
from upright.errors import InvalidModel, InvalidScenario
from upright.physics.dynamics import CALM, MODELS, Disturbance, drives_speed, slips
from upright.physics.linear import DISTURBANCES, LinearModel, linearise_rolling
from upright.physics.sensing import readings, readings_under
from upright.physics.steps import steps_of
from upright.robots import Robot
from upright.signals.signal import SENSORS, STATE_NAMES, TRUTH

CHANNELS = (*TRUTH, *SENSORS[:-1])  # all but the battery, which is the electronics'


class NonlinearBody:
    """The equations of `physics.dynamics`, integrated by RK4; `period` [s] is what one step takes.

    `model` is "complete" or "published". Steps are cut so that the fastest pole is followed, and are computed by a
    function that is written for the robot, to the last bit as the dynamics compute them.
    """

    def __init__(self, robot: Robot, model: str = "complete", period: float = 0.001) -> None:
        if model not in MODELS:
            raise InvalidModel(f"no model is called '{model}'", expected=" or ".join(MODELS))
        self.spec = _spec(f"{model} nonlinear model", robot, checked_period(period))
        self._model = model
        self._may_slip = drives_speed(robot)
        self.substeps = steps_of(robot, period, model=model)
        self.reset()

    @classmethod
    def dividing(cls, robot: Robot, period: float) -> NonlinearBody:
        """The complete model in equal steps of about a millisecond that make up a controller's `period` [s]."""
        return cls(robot, period=period / max(1, round(period / 0.001)))

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:  # noqa: ARG002 (nothing here is random)
        self._x: Sequence[float] = checked(start, 6, "start")
        self._steps = 0
        self._slipped = False
        still = (0.0, 0.0)
        return self._sample((*self._x, *readings_under(still, self._x, self.spec.robot, model=self._model)), still)

    @cached_property
    def _next(self) -> Step:
        return written(self.spec.robot, self._model, self.spec.period, self.substeps)

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        u = checked(command, 2, "command")
        try:
            values = self._next(self._x, u, disturbance)
        except (ArithmeticError, ValueError):  # the sine of infinity is a ValueError
            raise InvalidScenario(
                f"the motion is beyond every number after {self._steps * self.spec.period:g} s",
                expected="pushes and commands that a robot can meet",
            ) from None
        self._x = values[:6]
        self._steps += 1
        if self._may_slip and not self._slipped:
            self._slipped = slips(self._x, u, self.spec.robot, disturbance, self._model)
        return self._sample(values, u)

    def close(self) -> None:
        """Nothing is held."""

    def _sample(self, values: tuple[float, ...], u: tuple[float, ...]) -> Sample:
        return Sample(self._steps * self.spec.period, values, (u[0], u[1]), abs(values[0]) > FALLEN, self._slipped)


class LinearBody:
    """A linear model as a body: exact between commands. A continuous model is discretised at `period` [s];
    a discrete one steps at its own.

    What a push does is taken from the model's disturbance columns; a model without them (one identified from
    commands alone) gets those of `robot`, linearised upright.
    """

    def __init__(self, model: LinearModel, robot: Robot, period: float = 0.001) -> None:
        if model.states != STATE_NAMES or len(model.inputs) != 2:
            raise InvalidModel(
                f"the model has states {', '.join(model.states)} and {len(model.inputs)} inputs",
                expected=f"{', '.join(STATE_NAMES)} and two commands",
            )
        discrete = model.c2d(checked_period(period)) if model.continuous else model
        self._push = discrete.E if discrete.disturbances else _push_columns(robot, discrete)
        self._linear = discrete
        self.spec = _spec("linear model", robot, discrete.dt)
        self.reset()

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:  # noqa: ARG002 (nothing here is random)
        self._x = np.array(checked(start, 6, "start"))
        self._steps, self._wheel_acc = 0, 0.0
        return self._sample((0.0, 0.0), CALM)

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        u = checked(command, 2, "command")
        force, height, slope = disturbance
        before = self._x[3]
        self._x = self._linear.next(self._x, u) + self._push @ np.array([force, force * height, slope])
        self._wheel_acc = float(self._x[3] - before) / self.spec.period
        self._steps += 1
        return self._sample(u, disturbance)

    def close(self) -> None:
        """Nothing is held."""

    def _sample(self, u: Sequence[float], w: Disturbance) -> Sample:
        x = self._x.tolist()
        values = (*x, *readings(x, self._wheel_acc, self.spec.robot, w.slope))
        return sample(self._steps * self.spec.period, values, u, abs(x[0]) > FALLEN)


def _spec(kind: str, robot: Robot, period: float) -> BodySpec:
    return BodySpec(kind=kind, robot=robot, channels=CHANNELS, period=period, command_unit=robot.command_unit)


def _push_columns(robot: Robot, model: LinearModel) -> np.ndarray:
    physical = linearise_rolling(robot).c2d(model.dt)
    assert physical.disturbances == DISTURBANCES
    return physical.E
