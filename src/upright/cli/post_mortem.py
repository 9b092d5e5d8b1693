"""`upright post-mortem`: why did it fall?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption
from upright.cli.output import check_folder, print_json, progress


def post_mortem(
    log: Annotated[Path, typer.Argument(help="A log with commands, encoders and gyro: .csv, .parquet, .mcap, …")],
    robot: Annotated[
        str | None, typer.Option("--robot", "-r", help="The robot by name or TOML file (default: that of the log).")
    ] = None,
    kit: Annotated[
        str | None, typer.Option(help="Electronics by name or TOML file (default: the log's, else the robot's own).")
    ] = None,
    controller: Annotated[
        Path | None, typer.Option("--controller", "-c", help="What should have driven it: controller.json.")
    ] = None,
    mapping: Annotated[
        str | None, typer.Option(help="A mapping by name (twipr, ev3way, …) or TOML file (default: what seems to fit).")
    ] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the result as JSON.")] = None,
    report: Annotated[Path | None, typer.Option(help="Write a page with the last seconds: .html.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Say why a robot fell, from the last seconds of its log.

    Ranks saturation, gyro bias, dropped samples, wheel slip, weak battery, a push too large, delay grown, gain too low
    and too high, each with its evidence and repair. Exit code 0 whatever is found, also where it did not fall.
    """
    from upright.atomic import write_json
    from upright.control import read_controller
    from upright.diagnose import post_mortem as examine
    from upright.logs.mapping import find_mapping
    from upright.robots import find_kit, find_robot

    for target in (output, report):
        if target:
            check_folder(target)
    with progress("looking at the last seconds") as show:
        found = examine(
            log,
            find_robot(robot) if robot else None,
            find_kit(kit) if kit else None,
            read_controller(controller) if controller else None,
            mapping=find_mapping(mapping) if mapping else None,
            progress=show,
        )
    if output:
        write_json(output, found.to_json())
    if report:
        from upright.report.postmortem import postmortem_page

        postmortem_page(found, report)
    if as_json:
        print_json(found.to_json())
        return
    typer.echo("\n".join([str(found), *(f"wrote {path}" for path in (output, report) if path)]))
