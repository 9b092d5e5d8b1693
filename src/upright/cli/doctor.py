"""`upright doctor`: faults of a log and their repair."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from upright.cli.options import (
    ROBOT_HELP,
    JsonOption,
    LogArgument,
    MappingOption,
    OutputOption,
    ReportOption,
    complete_robot,
)
from upright.cli.output import check_targets, finish, print_json, progress


def doctor(
    log: LogArgument,
    *,
    mapping: MappingOption = None,
    robot: Annotated[
        str | None,
        typer.Option(
            "--robot", "-r", help=f"{ROBOT_HELP}; improves the checks of units.", autocompletion=complete_robot
        ),
    ] = None,
    fix: Annotated[Path | None, typer.Option(help="Write the repaired log: .parquet, .csv or .mcap.")] = None,
    write_mapping: Annotated[
        Path | None, typer.Option(help="Write the mapping as TOML, or a draft of one, for editing.")
    ] = None,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Find faults of a log: units, signs, delays, bias, …

    Prints each finding with its evidence and repair. Exit code 0, whatever the findings.
    """
    from dataclasses import replace

    from upright.atomic import write_text
    from upright.checkup.columns import drafted
    from upright.checkup.doctor import doctor as examine
    from upright.errors import InvalidLog
    from upright.logs.readers import read_table

    check_targets(fix, write_mapping, output, report, logs=[log])
    table = read_table(log)
    try:
        with progress("examining") as show:
            diagnosis = examine(table, robot, mapping=mapping, progress=show)
    except InvalidLog as error:
        if not write_mapping or mapping:
            raise
        write_text(write_mapping, drafted(table))
        if as_json:
            print_json({"draft": str(write_mapping)})
        else:
            typer.echo(f"{error}\na draft is in {write_mapping}")
        return
    diagnosis = replace(diagnosis, source=str(log))  # as it was typed, for what to run next
    repaired = diagnosis.repaired().save(fix) if fix else None
    if write_mapping:
        write_text(write_mapping, diagnosis.mapping.to_toml())
    facts: dict[str, Any] = {"repaired": str(repaired)} if repaired else {}
    finish(diagnosis, as_json, output=output, page=report, written=(repaired, write_mapping), **facts)
