"""A lane: one body under a controller of its own, stepped by the controller's period."""

from __future__ import annotations

import math
from collections.abc import Sequence

from upright.arrays import Array
from upright.bodies import Body
from upright.control import Controller
from upright.errors import UprightError
from upright.experiment.loop import Stepper
from upright.lab.plant import Pulled
from upright.lab.ring import Ring
from upright.physics.dynamics import Disturbance
from upright.signals import Log

LYING = 1.5
"""Pitch [rad] at which a fallen robot is shown: on its back or on its face."""


class Lane:
    """`body` under `controller`, from the state `start` (6,), recorded for `length` periods.

    The wheel's angle starts from zero whatever it was, so that an estimator meets a robot that seems to stand where it
    was switched on; `offset` is added to what is shown. `trouble` says why a lane stopped that did not fall.
    """

    def __init__(
        self,
        name: str,
        inner: Pulled,
        body: Body,
        controller: Controller,
        *,
        start: Sequence[float],
        seed: int,
        length: int,
    ) -> None:
        self.name, self.body, self.controller, self._inner = name, body, controller, inner
        self._seed = seed
        self.trouble: UprightError | None = None
        self._start = (start[0], start[1], 0.0, start[3], 0.0, start[5])
        self.offset = (0.0, 0.0, start[2], 0.0, start[4], 0.0)
        self._loop = Stepper(body, controller, self._start, seed)
        self._ring = Ring(length, len(self._loop.signals))
        self.fallen = self._loop.now.fallen

    @property
    def applied(self) -> tuple[float, float]:
        """The command (left, right) that was really applied last."""
        return self._loop.now.applied

    def step(self, reference: Array, disturbance: Disturbance, pull: float) -> None:
        """One period towards the state `reference` (6,) under `disturbance` and a `pull` [N]."""
        if self.fallen:
            return
        self._inner.pull(pull)
        try:
            self._ring.append(self._loop.step(reference, lambda _: disturbance))
            self.fallen = self._loop.now.fallen
        except UprightError as error:
            self.fallen = True
            self.trouble = error

    def state(self) -> list[float]:
        """The true state (6,), with the wheel's and the heading's whole way."""
        x = [a + b for a, b in zip(self._loop.now.numbers[:6], self.offset, strict=True)]
        if self.fallen:
            x[0], x[1], x[3], x[5] = math.copysign(LYING, x[0]), 0.0, 0.0, 0.0
        return x

    def estimate(self) -> list[float]:
        """The controller's estimate of the state (6,), or nothing."""
        estimate = self.controller.estimate()
        return [a + b for a, b in zip(estimate, self.offset, strict=False)]

    def saturated(self) -> int:
        """1 for the left motor at its limit, plus 2 for the right one."""
        limit = self.body.spec.limit
        return sum(bit for bit, u in zip((1, 2), self._loop.command, strict=True) if abs(u) >= limit)

    def log(self) -> Log | None:
        """What was recorded since this lane began, at most the last minute; None before the first period."""
        rows = self._ring.rows()
        if not len(rows):
            return None
        scenario = {"lab": True, "seed": self._seed, "start": list(self._start)}
        return self._loop.log(rows, scenario)
