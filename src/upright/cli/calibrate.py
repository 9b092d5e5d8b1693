"""`upright calibrate`: the robot from its own raw log."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import (
    AfterOption,
    BeforeOption,
    HeldOutOption,
    JsonOption,
    KitOption,
    KnownOption,
    MappingOption,
    ReportOption,
    RobotOption,
    part_of_log,
)
from upright.cli.output import AGAINST, check_targets, finish, progress
from upright.cli.typed import GIVEN


def calibrate(
    logs: Annotated[list[Path], typer.Argument(help="Logs of one robot: .csv, .txt, .json, .mat, .parquet, .mcap.")],
    *,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    mapping: MappingOption = None,
    start: AfterOption = None,
    until: BeforeOption = None,
    known: KnownOption = None,
    held_out: HeldOutOption = 0.25,
    between_knocks: Annotated[
        bool, typer.Option("--between-knocks", help="Leave out the times at which somebody pushed the robot.")
    ] = False,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the calibrated robot as TOML.")] = None,
    report: ReportOption = None,
    save: Annotated[
        Path | None, typer.Option(help="Write all estimates with their covariance as JSON (a posterior).")
    ] = None,
    force: Annotated[
        bool, typer.Option("--force", help="Write the robot also where the fit is refused, or the log cannot tell it.")
    ] = False,
    as_json: JsonOption = False,
) -> None:
    """Estimate a robot's parameters from its raw logs.

    Prints each estimate with its 95 % interval, and whether the logs determine it. A fit that does not describe the
    robot is refused, and a log may be unable to tell it (too quiet, or pushed by hand): no robot is then written. A
    calibration that is refused, unknown or doubtful ends with exit code 3.
    """
    from upright.atomic import write_json
    from upright.calibration.calibrate import calibrate as estimate

    check_targets(output, report, save, logs=logs)
    with progress("calibrating") as show:
        result = estimate(
            [part_of_log(path, mapping, start, until) for path in logs], robot, kit,
            known=known or (), held_out=held_out, between_knocks=between_knocks, progress=show,
        )  # fmt: skip
    decision = result.decision
    withheld = decision.withheld and not force
    if output and not withheld:
        result.known_robot().save(output)
        result = replace(result, saved=str(output))
        if not decision.next:  # what follows is for the robot that was written, which has its own kit
            GIVEN.set({**GIVEN.get(), "robot": output, "kit": None})
    if save:
        write_json(save, result.to_json())
    finish(result, as_json, page=report, written=(None if withheld else output, save))
    if output and withheld:
        typer.echo(f"{output} is not written. {decision.why} Try: {decision.hint}; or --force", err=True)
    if decision.against:
        raise typer.Exit(AGAINST)
