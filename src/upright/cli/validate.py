"""`upright validate`: what is known, judged on another log."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.cli.destination import Destination
from upright.cli.logs import LogPart
from upright.progress import progress


def validate(
    robot: Annotated[str, "Robot by name, TOML file, or JSON by `calibrate --save`."],
    logs: Annotated[list[Path], "Other logs of it: .csv, .txt, .json, .mat, .parquet, .mcap."],
    *,
    kit: str | None = None,
    controller: Annotated[
        str | None, "Controller by name, controller.json or my.py:Name, of the log (default: read from it)."
    ] = None,
    part: LogPart,
    out: Destination,
) -> None:
    """Judge a robot's numbers on logs they are not from.

    Predicts each half second from a fitted state, and simulates the closed loop freely where its law is known. Says
    where that breaks, and which number would have to move. Exit code 0 for any verdict.
    """
    from upright.validation.validate import validate as judge

    out.check(logs=logs)
    with progress("predicting") as show:
        result = judge(part.read(logs), robot, kit, controller, progress=show)
    out.finish(result)
