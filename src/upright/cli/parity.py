"""`upright parity`: whether a program does what was designed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.destination import Destination
from upright.cli.output import AGAINST
from upright.progress import progress


def parity(
    program: Path,
    controller: Annotated[str, "The controller.json of its design."],
    *,
    robot: Annotated[str | None, "Robot by name (see `upright robots`) or TOML file (default: the program's)."] = None,
    kit: Annotated[str | None, "Electronics by name or TOML file (default: the program's)."] = None,
    chip: str = "",
    body: str = "twin",
    out: Destination,
) -> None:
    """Execute a program and compare it with its design.

    The program drives the twin for 20 s through both pushes of Herrera et al. (2015). Every command is compared with
    the design's. Exit code 3 where they differ or the robot falls.
    """
    from upright.execution import parity as run_parity

    out.check()
    with progress("running") as show:
        result = run_parity(program, controller, robot=robot, kit=kit, chip=chip, body=body, progress=show)
    out.finish(result)
    if not result.passed:
        raise typer.Exit(AGAINST)
