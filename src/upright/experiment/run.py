"""The loop: a body under a controller, pushed, and what came of it as a log."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict
from typing import Any

from upright.bodies.body import REST, Body
from upright.control.controller import Controller
from upright.errors import InvalidScenario, check_within
from upright.experiment.loop import Stepper
from upright.experiment.permit import Permit, permitted
from upright.experiment.pushes import PushProgramme, combined
from upright.experiment.references import Reference, total
from upright.physics.dynamics import Disturbance
from upright.progress import Progress
from upright.signals import Log

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
    progress: Progress | None = None,
    certificate: Permit | None = None,
    anyway: bool = False,
) -> Log:
    """Run `body` under `controller` for `seconds`, or until it lies after a fall, and return the log. It falls at
    a lean of `robots.kit.STOP`, where every program stops the motors; where it lies at the `start`, the run goes on.

    One row for each of the controller's periods: what the body read at that time, the command decided on it, and the
    command that was really applied from then on. `push` and `reference` are one programme or several that add up;
    `start` is the state (6,); `progress` is called with the fraction done. The same arguments give the same log.
    Hardware is not driven by a controller that its `certificate` refuses, unless `anyway`.

    Raises `SpecMismatch` when body and controller do not fit, `InvalidScenario` for times that make no sense,
    `NotPermitted` for a refused controller.
    """
    pushes, references = _several(push), _several(reference)
    spec = body.spec
    robot = spec.robot
    period = controller.spec.period
    if pushes and not spec.pushable:
        raise InvalidScenario(f"a {spec.kind} cannot be pushed by a number", expected="no push", hint="push it by hand")
    if not period / 2 < seconds <= MAX_SECONDS:
        raise InvalidScenario(
            f"a run of {seconds:g} s",
            expected=f"more than zero and at least a period ({period:g} s), at most {MAX_SECONDS:g} s",
        )
    check_within("as a seed", seed, 0, 2**64 - 1)
    permit = {"certificate": permitted(controller, certificate, robot, anyway=anyway)} if spec.real else {}
    count = round(seconds / period)
    loop = Stepper(body, controller, start, seed)
    stood = not loop.now.fallen
    rows = list[list[float]]()

    def disturbance(t: float) -> Disturbance:
        return combined(pushes, t, robot)

    for k in range(count):
        rows.append(loop.step(total(references, loop.now.t, robot), disturbance))
        stood = stood or not loop.now.fallen
        if loop.now.fallen and stood:
            break
        if progress and k % 50 == 0:
            progress(k / count)
    scenario = {"push": [_facts(p) for p in pushes], "reference": [_facts(r) for r in references]}
    scenario |= {"seconds": seconds, "seed": seed, "start": list(start), **permit}
    return loop.log(rows, scenario)


def _several(given: Any) -> list[Any]:
    return [given] if hasattr(given, "at") else list(given)


def _facts(part: Any) -> dict[str, Any]:
    numbers = {k: v for k, v in asdict(part).items() if v is not None and math.isfinite(v)}
    return {"kind": type(part).__name__, **numbers}
