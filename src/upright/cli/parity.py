"""`upright parity`: whether a program does what was designed."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import (
    BodyOption,
    DesignArgument,
    JsonOption,
    OutputOption,
    ProgramKitOption,
    ProgramRobotOption,
    ReportOption,
)
from upright.cli.output import AGAINST, check_targets, finish, progress


def parity(
    program: Annotated[Path, typer.Argument(help="A program by upright firmware: .py, .c, .ino or .nxc.")],
    controller: DesignArgument,
    *,
    robot: ProgramRobotOption = None,
    kit: ProgramKitOption = None,
    chip: Annotated[
        str, typer.Option(help="For c: host, arm7 or avr; for pybricks: micropython or mpy (default: the first).")
    ] = "",
    body: BodyOption = "twin",
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Execute a program and compare it with its design.

    The program drives the twin for 20 s through both pushes of Herrera et al. (2015). Every command is compared with
    the design's. Exit code 3 where they differ or the robot falls.
    """
    from upright.execution import parity as run_parity

    check_targets(output, report)
    with progress("running") as show:
        result = run_parity(program, controller, robot=robot, kit=kit, chip=chip, body=body, progress=show)
    finish(result, as_json, output=output, page=report)
    if not result.passed:
        raise typer.Exit(AGAINST)
