"""`upright design`: one controller into a file, with its margins."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.cli.destination import Destination
from upright.cli.output import warn_of


def design(
    method: str,
    *,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    period: float | None = None,
    gains: str | None = None,
    posterior: Path | None = None,
    output: Annotated[Path | None, "Write the controller as JSON."] = None,
    out: Destination,
) -> None:
    """Design a controller for a robot.

    Prints its inputs, the residual of its equations, and the margins of its loop.
    """
    from upright.certification.design import design as design_controller
    from upright.experiment.notation import named_values
    from upright.robots import find_robot

    out.check(output)
    warn_of(find_robot(robot))
    own = named_values(gains, "--gains") if gains else None
    result = design_controller(method, robot, kit, period=period, own=own, posterior=posterior)
    out.finish(result, output and result.save(output))
