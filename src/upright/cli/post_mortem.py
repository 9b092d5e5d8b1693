"""`upright post-mortem`: why did it fall?"""

from __future__ import annotations

from typing import Annotated

import typer

from upright.cli.options import (
    KIT_HELP,
    JsonOption,
    LawOption,
    LogArgument,
    LogRobotOption,
    MappingOption,
    OutputOption,
    ReportOption,
    complete_kit,
)
from upright.cli.output import check_targets, finish, progress


def post_mortem(
    log: LogArgument,
    *,
    robot: LogRobotOption = None,
    kit: Annotated[
        str | None,
        typer.Option(help=f"{KIT_HELP} (default: the log's, else the robot's).", autocompletion=complete_kit),
    ] = None,
    controller: LawOption = None,
    mapping: MappingOption = None,
    seconds: Annotated[
        float, typer.Option(min=0.0, help="Longest search [s of processor time]; then what is known is said.")
    ] = 60.0,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Diagnose a fall from the last seconds of a log.

    Ranks faults of sensors, motors, battery, loop, gain and floor, pushes, loads and walls, two at once too, each with
    evidence and repair; or says that it is none of these. Exit code 0, also for a robot that did not fall.
    """
    from upright.diagnose import post_mortem as examine

    check_targets(output, report, logs=[log])
    with progress("examining the last seconds") as show:
        result = examine(log, robot, kit, controller, mapping=mapping, seconds=seconds, progress=show)
    finish(result, as_json, output=output, page=report)
