"""`upright film`: a run as a film, for lectures and papers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli import options
from upright.cli.compare import labelled
from upright.cli.output import check_targets, print_json, progress


def film(
    logs: Annotated[
        list[str], typer.Argument(metavar="LOG", help="Logs, or LABEL=FILE: the robot first, then its ghosts.")
    ],
    *,
    output: Annotated[Path, typer.Option("--output", "-o", help="Write the film: .gif, .webp or .mp4.")] = Path(
        "film.gif"
    ),
    robot: options.LogRobotOption = None,
    mapping: options.MappingOption = None,
    start: Annotated[
        float | None, typer.Option("--from", metavar="S", help="Begin at this time of the log [s].")
    ] = None,
    until: Annotated[
        float | None, typer.Option("--until", metavar="S", help="End at this time of the log [s].")
    ] = None,
    speed: Annotated[float, typer.Option(help="Speed of the film; 0.5 is half of the true one.")] = 1.0,
    frames: Annotated[float, typer.Option(help="Pictures a second.")] = 25.0,
    width: Annotated[int, typer.Option(help="Width [pixels]; the height is 9/16 of it.", min=160, max=3840)] = 960,
    as_json: options.JsonOption = False,
) -> None:
    """Make a film of one run, or of several side by side.

    Shows the robots from their side, and the traces of lean and position below them.
    """
    from upright.logs.raw import raw_log
    from upright.reports.film import film as write_film
    from upright.robots import find_robot

    check_targets(output)
    runs = {label: raw_log(path, mapping) for label, path in labelled(logs).items()}
    with progress("film") as show:
        written = write_film(
            runs, output, find_robot(robot) if robot else None,
            start=start, stop=until, speed=speed, frames=frames, width=width, progress=show,
        )  # fmt: skip
    if as_json:
        print_json({"film": str(written)})
    else:
        typer.echo(f"wrote {written}")
