"""`upright film`: a run as a film, for lectures and papers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.cli.logs import LogPart, labelled
from upright.cli.output import check_targets, print_json, tell
from upright.progress import progress


def film(
    logs: Annotated[list[str], "Logs, or LABEL=FILE: the robot first, then its ghosts."],
    *,
    output: Annotated[Path, "Write the film: .gif, .webp or .mp4."] = Path("film.gif"),
    robot: Annotated[str | None, "Robot by name (see `upright robots`) or TOML file (default: the log's)."] = None,
    part: LogPart,
    speed: float = 1.0,
    frames: float = 25.0,
    width: int = 960,
    json: bool = False,
) -> None:
    """Make a film of one run, or of several side by side.

    Shows the robots from their side, and the traces of lean and position below them.
    """
    from upright.logs.raw import raw_log
    from upright.reports.film import film as write_film
    from upright.robots import find_robot

    check_targets(output)
    runs = {label: raw_log(path, part.mapping) for label, path in labelled(logs).items()}
    with progress("film") as show:
        written = write_film(
            runs,
            output,
            find_robot(robot) if robot else None,
            start=part.from_,
            stop=part.until,
            speed=speed,
            frames=frames,
            width=width,
            progress=show,
        )
    if json:
        print_json({"film": str(written)})
    else:
        tell(f"wrote {written}")
