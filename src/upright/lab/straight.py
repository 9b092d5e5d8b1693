"""The nonlinear model stepped by straight-line code: the numbers of `NonlinearBody` bit for bit, in little more than
half the time."""

from __future__ import annotations

from collections.abc import Sequence

from upright.bodies import NonlinearBody, Sample
from upright.bodies.body import FALLEN, REST, checked, sample
from upright.compiled.straight_line import written
from upright.physics.dynamics import CALM, Disturbance
from upright.robots import Robot


class Straight:
    """`NonlinearBody(robot, model, period)`, stepped by the function that is written for it."""

    def __init__(self, robot: Robot, model: str, period: float) -> None:
        self._body = NonlinearBody(robot, model, period)
        self.spec = self._body.spec
        self.substeps = self._body.substeps
        self._next = written(robot, model, period, self._body.substeps)
        self.reset()

    def reset(self, start: Sequence[float] = REST, seed: int = 0) -> Sample:
        first = self._body.reset(start, seed)
        self._x: Sequence[float] = first.values[:6].tolist()
        self._steps = 0
        return first

    def step(self, command: Sequence[float], disturbance: Disturbance = CALM) -> Sample:
        u = checked(command, 2, "command")
        values = self._next(self._x, u, disturbance)
        self._x = values[:6]
        self._steps += 1
        return sample(self._steps * self.spec.period, values, u, abs(values[0]) > FALLEN)

    def close(self) -> None:
        """Nothing is held."""
