"""A lane: one body under a controller of its own, stepped by the controller's period."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from upright.bodies import Body
from upright.control import Controller
from upright.errors import UprightError
from upright.experiment.run import as_log, fit
from upright.lab.plant import Tugged
from upright.lab.ring import Ring
from upright.physics.dynamics import Disturbance
from upright.signals import Log
from upright.signals.signal import ESTIMATE, PUSH, REFERENCE

Array = NDArray[np.float64]

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
        inner: Tugged,
        body: Body,
        controller: Controller,
        start: Sequence[float],
        seed: int,
        length: int,
    ) -> None:
        self.name, self.body, self.controller, self._inner = name, body, controller, inner
        self._inputs, self._stride = fit(body.spec, controller)
        self._seed, self.trouble = seed, ""
        self._start = (start[0], start[1], 0.0, start[3], 0.0, start[5])
        self.offset = (0.0, 0.0, start[2], 0.0, start[4], 0.0)
        extra = 4 + len(PUSH) + len(REFERENCE) + (len(ESTIMATE) if controller.spec.estimates else 0)
        self._ring = Ring(length, len(body.spec.channels) + extra)
        controller.reset()
        self.now = body.reset(self._start, seed)
        self.command, self.applied, self.fallen = (0.0, 0.0), (0.0, 0.0), self.now.fallen

    def step(self, target: Array, felt: Disturbance, tug: float) -> None:
        """One period towards the reference state `target` (6,) under the disturbance `felt` and a `tug` [N]."""
        if self.fallen:
            return
        try:
            self._step(target, felt, tug)
        except UprightError as error:
            self.fallen, self.trouble = True, f"{self.name}: {error}"

    def _step(self, target: Array, felt: Disturbance, tug: float) -> None:
        before, controller = self.now, self.controller
        command = controller.step(before.values[self._inputs], target)
        self._inner.tug(tug)
        now = before
        for _ in range(self._stride):
            now = self.body.step(command, felt)
        controller.applied(now.applied)
        self._ring.append(
            [*before.values.tolist(), *command, *now.applied, *felt, *target.tolist(), *controller.estimate()]
        )
        self.now, self.command, self.applied, self.fallen = now, command, now.applied, now.fallen

    def state(self) -> list[float]:
        """The true state (6,), with the wheel's and the heading's whole way."""
        x = [a + b for a, b in zip(self.now.values[:6].tolist(), self.offset, strict=True)]
        if self.fallen:
            x[0], x[1], x[3], x[5] = math.copysign(LYING, x[0]), 0.0, 0.0, 0.0
        return x

    def estimate(self) -> list[float]:
        """The controller's opinion of the state (6,), or nothing."""
        opinion = self.controller.estimate()
        return [a + b for a, b in zip(opinion, self.offset, strict=False)]

    def saturated(self) -> int:
        """1 for the left motor at its limit, plus 2 for the right one."""
        limit = self.body.spec.limit
        return sum(bit for bit, u in zip((1, 2), self.command, strict=True) if abs(u) >= limit)

    def log(self) -> Log | None:
        """What was recorded since this lane began, at most the last minute; None before the first period."""
        rows = self._ring.rows()
        if not len(rows):
            return None
        scenario = {"lab": True, "seed": self._seed, "start": list(self._start)}
        return as_log(rows, self.body.spec, self.controller, scenario, self.now)
