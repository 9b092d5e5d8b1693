"""`upright linearise`: the tangent of the dynamics at an operating point."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.atomic import write_json
from upright.cli.destination import Destination
from upright.cli.output import warn_of
from upright.errors import UnknownName


def linearise(
    *,
    robot: str = "nxtway-gs",
    at: str = "",
    period: Annotated[float | None, "Period of the controller [s]: a discrete model with held commands."] = None,
    model: str = "complete",
    output: Annotated[Path | None, "Write the model as JSON."] = None,
    out: Destination,
) -> None:
    """Linearise a robot: A, B and poles.

    Continuous, or discrete with --period. Warns where the operating point is not an equilibrium.
    """
    from upright.experiment.notation import vector
    from upright.physics.dynamics import MODELS
    from upright.physics.linear import INPUTS
    from upright.physics.linear import linearise as tangent
    from upright.robots import find_robot
    from upright.signals import STATE_NAMES

    out.check(output)
    if model not in MODELS:
        raise UnknownName("model", model, MODELS)
    point = vector(at, [*STATE_NAMES, *INPUTS], "--at")
    chosen = find_robot(robot)
    warn_of(chosen)
    linear = tangent(chosen, point[:6], point[6:], model)
    linear = linear if period is None else linear.c2d(period)
    out.finish(linear, output and write_json(output, linear.to_json()))
