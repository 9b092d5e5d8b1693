"""`upright validate`: what is known, judged on another log."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import (
    AfterOption,
    BeforeOption,
    JsonOption,
    KitOption,
    LawOption,
    MappingOption,
    OutputOption,
    ReportOption,
    complete_robot,
    part_of_log,
)
from upright.cli.output import check_targets, finish, progress


def validate(
    robot: Annotated[
        str,
        typer.Argument(help="Robot by name, TOML file, or JSON by `calibrate --save`.", autocompletion=complete_robot),
    ],
    logs: Annotated[list[Path], typer.Argument(help="Other logs of it: .csv, .txt, .json, .mat, .parquet, .mcap.")],
    *,
    kit: KitOption = None,
    controller: LawOption = None,
    mapping: MappingOption = None,
    start: AfterOption = None,
    until: BeforeOption = None,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:  # fmt: skip
    """Judge a robot's numbers on logs they are not from.

    Predicts each half second from a fitted state, and simulates the closed loop freely where its law is known. Says
    where that breaks, and which number would have to move. Exit code 0 for any verdict.
    """
    from upright.validation.validate import validate as judge

    check_targets(output, report, logs=logs)
    with progress("predicting") as show:
        result = judge(
            [part_of_log(path, mapping, start, until) for path in logs], robot, kit, controller, progress=show
        )
    finish(result, as_json, output=output, page=report)
