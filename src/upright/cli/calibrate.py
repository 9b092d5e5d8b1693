"""`upright calibrate`: the robot from its own raw log."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from upright.cli.destination import Destination
from upright.cli.logs import LogPart
from upright.cli.output import AGAINST, tell
from upright.cli.typed import GIVEN
from upright.progress import progress


def calibrate(
    logs: list[Path],
    *,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    part: LogPart,
    known: list[str] | None = None,
    held_out: float = 0.25,
    between_knocks: bool = False,
    output: Annotated[Path | None, "Write the calibrated robot as TOML."] = None,
    force: bool = False,
    out: Destination,
) -> None:
    """Estimate a robot's parameters from its raw logs.

    Prints each estimate with its 95 % interval, and whether the logs determine it. A fit that does not describe the
    robot is refused, and a log may be unable to tell it (too quiet, or pushed by hand): no robot is then written. A
    calibration that is refused, unknown or doubtful ends with exit code 3.
    """
    from upright.calibration.calibrate import calibrate as estimate

    out.check(output, logs=logs)
    with progress("calibrating") as show:
        result = estimate(
            part.read(logs),
            robot,
            kit,
            known=known or (),
            held_out=held_out,
            between_knocks=between_knocks,
            progress=show,
        )
    decision = result.decision
    withheld = decision.withheld and not force
    if output and not withheld:
        result.known_robot().save(output)
        result = replace(result, saved=str(output))
        if not decision.next:  # what follows is for the robot that was written, which has its own kit
            GIVEN.set({**GIVEN.get(), "robot": output, "kit": None})
    out.finish(result, None if withheld else output)
    if output and withheld:
        tell(f"{output} is not written. {decision.why} Try: {decision.hint}; or --force", err=True)
    if decision.against:
        raise typer.Exit(AGAINST)
