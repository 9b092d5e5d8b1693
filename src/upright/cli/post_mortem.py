"""`upright post-mortem`: why did it fall?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.cli.destination import Destination
from upright.progress import progress


def post_mortem(
    log: Path,
    *,
    robot: Annotated[str | None, "Robot by name (see `upright robots`) or TOML file (default: the log's)."] = None,
    kit: Annotated[str | None, "Electronics by name or TOML file (default: the log's, else the robot's)."] = None,
    controller: str | None = None,
    mapping: str | None = None,
    time_limit: Annotated[float, "Stop the search after this time [s]; then what is known is said."] = 60.0,
    out: Destination,
) -> None:
    """Diagnose a fall from the last seconds of a log.

    Ranks faults of sensors, motors, battery, loop, gain and floor, pushes, loads and walls, two at once too, each with
    evidence and repair; or says that it is none of these. Exit code 0, also for a robot that did not fall.
    """
    from upright.diagnose import post_mortem as examine

    out.check(logs=[log])
    with progress("examining the last seconds") as show:
        result = examine(log, robot, kit, controller, mapping=mapping, seconds=time_limit, progress=show)
    out.finish(result)
