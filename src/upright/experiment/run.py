"""The loop: a body under a controller, pushed, and what came of it as a log."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict
from importlib.metadata import version
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from upright.atomic import finite
from upright.bodies.body import REST, Body, BodySpec, Sample
from upright.control.controller import Controller, controller_hash
from upright.control.permit import Permit, permitted
from upright.errors import InvalidScenario, SpecMismatch
from upright.experiment.outcome import RunOutcome
from upright.experiment.pushes import PushProgramme, combined
from upright.experiment.references import Reference, wanted
from upright.signals import Log
from upright.signals.signal import ESTIMATE, PUSH, REFERENCE, command_signals

MAX_SECONDS = 24 * 3600.0


def run(
    body: Body,
    controller: Controller,
    push: PushProgramme | Sequence[PushProgramme] = (),
    *,
    reference: Reference | Sequence[Reference] = (),
    seconds: float = 10.0,
    seed: int = 0,
    start: Sequence[float] = REST,
    progress: Callable[[float], None] | None = None,
    certificate: Permit | None = None,
    anyway: bool = False,
) -> Log:
    """Run `body` under `controller` for `seconds`, or until it falls, and return the log. A robot that lies at the
    `start` cannot fall before it has stood up.

    One row for each of the controller's periods: what the body read at that time, the command decided on it, and the
    command that was really applied from then on. `push` and `reference` are one programme or several that add up;
    `start` is the state (6,); `progress` is called with the share done. The same arguments give the same log.
    Hardware is not driven by a controller that its `certificate` refuses, unless `anyway`.

    Raises `SpecMismatch` when body and controller do not fit, `InvalidScenario` for times that make no sense,
    `NotPermitted` for a refused controller.
    """
    pushes, references = _several(push, "at"), _several(reference, "at")
    inputs, stride = fit(body.spec, controller)
    _check_pushable(body.spec, pushes)
    _check_time(seconds, controller.spec.period)
    permit = {"certificate": permitted(controller, certificate, anyway)} if body.spec.real else {}
    controller.reset()
    now = body.reset(start, seed)
    stood = not now.fallen
    rows: list[list[float]] = []
    count = round(seconds / controller.spec.period)
    for k in range(count):
        target = wanted(references, now.t, body.spec.robot)
        command = controller.step(now.values[inputs], target)
        row = [*now.values.tolist(), *command]
        felt = combined(pushes, now.t, body.spec.robot)
        now = _hold(body, command, pushes, stride, now)
        controller.applied(now.applied)
        rows.append([*row, *now.applied, *felt, *target.tolist(), *controller.estimate()])
        stood = stood or not now.fallen
        if now.fallen and stood:
            break
        if progress and k % 50 == 0:
            progress(k / count)
    scenario = {"push": [_said(p) for p in pushes], "reference": [_said(r) for r in references]}
    scenario |= {"seconds": seconds, "seed": seed, "start": list(start), **permit}
    return as_log(rows, body.spec, controller, scenario, now)


def _hold(body: Body, command: Sequence[float], pushes: Sequence[PushProgramme], stride: int, now: Sample) -> Sample:
    robot = body.spec.robot
    for _ in range(stride):
        now = body.step(command, combined(pushes, now.t, robot))
    return now


def fit(spec: BodySpec, controller: Controller) -> tuple[list[int], int]:
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


def _check_time(seconds: float, period: float) -> None:
    if not period / 2 < seconds <= MAX_SECONDS:
        raise InvalidScenario(
            f"a run of {seconds:g} s",
            expected=f"more than zero and at least a period ({period:g} s), at most {MAX_SECONDS:g} s",
        )


def _check_pushable(spec: BodySpec, pushes: Sequence[PushProgramme]) -> None:
    if pushes and not spec.pushable:
        raise InvalidScenario(f"a {spec.kind} cannot be pushed by a number", expected="no push", hint="push it by hand")


def _several(given: Any, method: str) -> list[Any]:
    return [given] if hasattr(given, method) else list(given)


def _said(part: Any) -> dict[str, Any]:
    finite = {k: v for k, v in asdict(part).items() if v is not None and math.isfinite(v)}
    return {"kind": type(part).__name__, **finite}


def as_log(rows: ArrayLike, spec: BodySpec, controller: Controller, scenario: dict[str, Any], end: Sample) -> Log:
    """The log of `rows`, one for each of the controller's periods as `run` writes them, that ended with `end`."""
    signals = [*spec.channels, *command_signals(spec.command_unit), *PUSH, *REFERENCE]
    signals += ESTIMATE if controller.spec.estimates else ()
    table = np.array(rows)
    origin = {
        "robot": {"name": spec.robot.name, "drive": spec.robot.drive, **spec.robot.numbers()},
        "body": {"kind": spec.kind, "real": spec.real, "period": spec.period, "limit": finite(spec.limit)},
        "controller": {**controller.to_json(), "hash": controller_hash(controller)},
        "scenario": scenario,
        "outcome": RunOutcome(end.fallen, end.t).to_json(),
        "versions": {name: version(name) for name in ("upright", "numpy", "mujoco")},
    }
    channels = {signal.name: table[:, i] for i, signal in enumerate(signals)}
    units = {signal.name: signal.unit for signal in signals}
    return Log(np.arange(len(table)) * controller.spec.period, channels, units, origin)
