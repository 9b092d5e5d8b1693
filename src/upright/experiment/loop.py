"""The loop itself: a body under a controller, one of the controller's periods at a time."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import cache, cached_property
from importlib.metadata import version
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.atomic import finite
from upright.bodies.body import REST, Body, BodySpec
from upright.bodies.electronics import advanced
from upright.control.controller import Controller, controller_hash
from upright.errors import SpecMismatch
from upright.experiment.outcome import RunOutcome
from upright.physics.dynamics import Disturbance
from upright.robots.kit import STOP
from upright.signals import Log, Signal
from upright.signals.signal import ESTIMATE, PUSH, REFERENCE, command_signals


class Stepper:
    """`body` at state `start` (6,) under `controller`; `now` is the body's newest sample.

    As a program does, it stops the motors at a lean of `STOP`, at the time `stopped` [s]: the robot has fallen, though
    its body moves on until it lies. `slipped` [s] is when a motor first lost its position (`Sample.slipped`).

    `signals` are what each row of `step` holds, in order. Raises `SpecMismatch` when body and controller do not fit.
    """

    def __init__(self, body: Body, controller: Controller, start: Sequence[float] = REST, seed: int = 0) -> None:
        self.body, self.controller = body, controller
        self._inputs, self._stride = _fit(body.spec, controller)
        names = [signal.name for signal in body.spec.channels]
        watched = "truth/pitch" in names and not controller.spec.stands_up
        self._pitch = names.index("truth/pitch") if watched else None
        self._times = list[float]()  # hardware keeps its own time; a model's steps are exact
        controller.reset()
        self.now = body.reset(start, seed)
        self.command = (0.0, 0.0)
        self.stopped = self.slipped = math.inf
        self._judge()

    @cached_property
    def signals(self) -> tuple[Signal, ...]:
        spec = self.body.spec
        estimate = ESTIMATE if self.controller.spec.estimates else ()
        return (*spec.channels, *command_signals(spec.command_unit), *PUSH, *REFERENCE, *estimate)

    def _judge(self) -> None:
        """Whether the robot has fallen by now, or lost its wheels' position."""
        if self._pitch is not None and abs(self.now.numbers[self._pitch]) > STOP:
            self.stopped = min(self.stopped, self.now.t)
        if self.now.slipped:
            self.slipped = min(self.slipped, self.now.t)

    def step(self, reference: Array, disturbance: Callable[[float], Disturbance]) -> list[float]:
        """One of the controller's periods towards the state `reference` (6,), under `disturbance(t)` for each step of
        the body. Returns the row: what the body read at the period's start, the command decided on it, the command that
        was really applied, the disturbance at the period's start, the reference, and the controller's estimate."""
        body, controller, before = self.body, self.controller, self.now
        if not body.spec.settable:
            self._times.append(before.t)
        command = controller.step(before.values[self._inputs], reference)
        if math.isfinite(self.stopped):
            command = (0.0, 0.0)
        acting = disturbance(before.t)
        now = advanced(body, before.t, command, disturbance, self._stride)
        controller.applied(now.applied)
        self.now, self.command = now, command
        self._judge()
        return [*before.numbers, *command, *now.applied, *acting, *reference.tolist(), *controller.estimate()]

    def log(self, rows: ArrayLike, scenario: dict[str, Any]) -> Log:
        """The log of `rows`, one for each of the controller's periods, that ended with the newest sample."""
        spec = self.body.spec
        controller = self.controller
        table = np.array(rows)
        fell = self.now.fallen or math.isfinite(self.stopped)
        origin = {
            "robot": {"name": spec.robot.name, "drive": spec.robot.drive, **spec.robot.numbers()},
            "body": {"kind": spec.kind, "real": spec.real, "period": spec.period, "limit": finite(spec.limit)},
            "controller": {**controller.to_json(), "hash": controller_hash(controller)},
            "scenario": scenario,
            "outcome": RunOutcome(fell, min(self.stopped, self.now.t), self.slipped).to_json(),
            "versions": dict(_versions()),
        }
        channels = {signal.name: table[:, i] for i, signal in enumerate(self.signals)}
        units = {signal.name: signal.unit for signal in self.signals}
        t = np.array(self._times[-len(table) :]) if self._times else np.arange(len(table)) * controller.spec.period
        return Log(t, channels, units, origin)


@cache
def _versions() -> dict[str, str]:
    return {name: version(name) for name in ("upright", "numpy", "mujoco")}  # each reads a file


def _fit(spec: BodySpec, controller: Controller) -> tuple[list[int], int]:
    """Where the controller's inputs stand among the body's channels, and how many body steps make a period."""
    wants = controller.spec
    names = [signal.name for signal in spec.channels]
    missing = [name for name in wants.reads if name not in names]
    if missing:
        raise SpecMismatch(
            f"the {wants.kind} reads {', '.join(missing)}, which the {spec.kind} does not offer",
            expected=f"some of {', '.join(names)}",
            likely="a controller of the true state on raw sensors"
            if wants.reads_truth
            else "a kit without that sensor",
            hint="put an estimator in front: Estimated(controller, kalman(robot, kit))" if wants.reads_truth else "",
        )
    if spec.real and wants.reads_truth:
        raise SpecMismatch(f"the {wants.kind} reads the true state", expected="sensors only on a real robot")
    if wants.command_unit != spec.command_unit:
        raise SpecMismatch(
            f"the controller commands {wants.command_unit}", expected=f"{spec.command_unit}, the body's unit"
        )
    if not spec.settable and wants.period < spec.period * (1 - 1e-9):
        raise SpecMismatch(
            f"the {wants.kind} commands {1 / wants.period:.4g} times a second, and a {spec.kind} answers "
            f"{1 / spec.period:.4g} times", expected=f"a period of {spec.period:g} s or a multiple of it",
            hint="let the robot run it by itself: upright firmware, upright fly",
        )  # fmt: skip
    stride = round(wants.period / spec.period)
    if stride < 1 or not math.isclose(stride * spec.period, wants.period, rel_tol=1e-9):
        raise SpecMismatch(
            f"the controller's period {wants.period:g} s is not a multiple of the body's {spec.period:g} s",
            expected="a period that divides it",
            hint="change one of the two periods",
        )
    return [names.index(name) for name in wants.reads], stride
