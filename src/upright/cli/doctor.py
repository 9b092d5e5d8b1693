"""`upright doctor`: faults of a log, and their repair."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption
from upright.cli.output import check_folder, print_json, progress
from upright.errors import UprightError


def doctor(
    log: Annotated[Path, typer.Argument(help="A log of any program: .csv, .txt, .json, .mat, .parquet, .mcap.")],
    mapping: Annotated[
        str | None,
        typer.Option(help="A mapping by name (twipr, ev3way, …) or TOML file (default: by columns)."),
    ] = None,
    robot: Annotated[
        str | None, typer.Option("--robot", "-r", help="The robot, if known: sharpens the checks of units.")
    ] = None,
    fix: Annotated[Path | None, typer.Option(help="Write the repaired log: .parquet, .csv or .mcap.")] = None,
    write_mapping: Annotated[Path | None, typer.Option(help="Write the mapping that was used, for editing.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Examine a log: units, signs, sides, time, delays, saturation, bias, falls.

    Prints each finding with its evidence and repair. Exit code 0 whatever is found.
    """
    from upright.doctor.doctor import doctor as examine

    for target in (fix, write_mapping):
        _check_new(target, log)
    with progress("examining") as show:
        diagnosis = examine(log, robot, mapping=mapping, progress=show)
    written = diagnosis.repaired().save(fix) if fix else None
    if write_mapping:
        write_mapping.write_text(diagnosis.mapping.to_toml(), encoding="utf-8")
    if as_json:
        print_json(diagnosis.to_json() | ({"repaired": str(written)} if written else {}))
        return
    typer.echo(str(diagnosis))
    for path in (written, write_mapping):
        if path:
            typer.echo(f"\nwrote {path}")


def _check_new(target: Path | None, log: Path) -> None:
    """Refuse a target that is the log itself or stands in no folder."""
    if target is None:
        return
    check_folder(target)
    if target.exists() and log.exists() and target.samefile(log):
        raise UprightError(
            f"{target} is the log itself", expected="another file", hint="another name: a log is never overwritten"
        )
