"""`upright monitor`: the output of a running program, line by line, and its log when it stops."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

from upright.cli.output import tell
from upright.errors import InvalidLog

FASTEST = 20.0  # [Hz] of telemetry on the screen: faster is not readable


def monitor(
    source: str = "-",
    *,
    program: Annotated[Path | None, "Program by `upright firmware` (.py) that the virtual hub runs."] = None,
    seconds: Annotated[float | None, "Length of the run [s] that is followed (default: to its end)."] = None,
    output: Annotated[Path | None, "Write the log: .parquet, .csv or .mcap."] = None,
) -> None:
    """Show the telemetry of a running program, then its log.

    On a hub the program is started by the hub's button and not stopped from here. The CRC of every line is checked.
    """
    from upright.flight.follow import follow, is_live
    from upright.flight.keep import check_log_target, save_log
    from upright.flight.program_logs import read_lines
    from upright.flight.screen import Screen

    if output:
        check_log_target(output)
    shown = Screen(FASTEST if is_live(source) else math.inf)
    try:
        follow(source, shown.receive, program=program, seconds=math.inf if seconds is None else seconds)
    finally:
        if shown.damaged:
            tell(f"{shown.damaged} damaged lines were left out", err=True)
        if output and shown.kept:
            result = read_lines(shown.kept)
            path, wrong = save_log(result.log, output)
            tell("\n".join([*result.flaws, wrong, f"wrote {path}: {len(result.log)} rows"]).replace("\n\n", "\n"))
    if output and not shown.kept:
        raise InvalidLog(f"{source} held no log", expected="the program's lines from H to E", likely="it still runs")
