"""The largest push like the one that felled a robot that its own controller saves."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from upright.errors import UprightError
from upright.validation.law import recorded

if TYPE_CHECKING:
    from collections.abc import Sequence

    from upright.control import Controller
    from upright.diagnose.causes import Cause
    from upright.robots import Kit, Robot
    from upright.signals import Log


def with_saved(
    causes: Sequence[Cause], log: Log, robot: Robot, kit: Kit, controller: Controller | None
) -> tuple[Cause, ...]:
    """The causes; where the first is a push, with what the `controller`, or else the one that the log names, saves of
    pushes at its height, of its length and direction, from standing still."""
    from upright.fleets.fleet import ensemble_of
    from upright.fleets.push_map import PushGrid, push_map

    first, *others = causes
    if (push := first.push) is None:
        return tuple(causes)
    law = controller or ((named := recorded(log)) and named.controller)
    if law is None:
        return tuple(causes)
    grid = PushGrid(
        directions=[1 if push.impulse > 0 else -1],
        heights=np.array([push.height]),
        durations=np.array([max(push.duration, SHORTEST)]),
    )
    try:
        survived = push_map(ensemble_of(robot, law, kit), grid, samples=0)
    except UprightError:  # a controller that no law describes
        return tuple(causes)
    known = replace(push, by=law.spec.kind, saves=float(survived.data["impulse"].values.squeeze()))
    return (replace(first, push=known), *others)


SHORTEST = 1e-3
"""[s] of a push in the simulation: a shorter one moves the robot as much."""
