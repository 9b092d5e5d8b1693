"""`upright grade`: the hand-ins of a class, run again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption, ReportOption, completed, registered
from upright.cli.output import check_targets, finish, progress
from upright.errors import UprightError


def grade(
    folder: Annotated[Path | None, typer.Argument(help="Folder with the hand-ins (.json) that the lab saved.")] = None,
    *,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the table as CSV, or the worksheet as Markdown.")
    ] = None,
    report: ReportOption = None,
    workers: Annotated[int, typer.Option(min=0, max=64, help="Processes; 0: one for each processor.")] = 0,
    worksheet: Annotated[
        str | None,
        typer.Option(
            metavar="LANGUAGE",
            help="Write the worksheet instead: es or en.",
            autocompletion=completed(registered("upright.classwork.worksheet", "LANGUAGES")),
        ),
    ] = None,
    lab: Annotated[
        str, typer.Option(metavar="ADDRESS", help="Address of the class's lab, for the links of the worksheet.")
    ] = "",
    as_json: JsonOption = False,
) -> None:
    """Grade the hand-ins of a class, by running them again.

    Prints what each student claimed, what comes of it on this machine, and a verdict: ok, not reached, differs, edited,
    copied, other set-up or broken.
    """
    check_targets(output, report)
    if (folder is None) == (worksheet is None):
        raise UprightError("grade needs a folder of hand-ins, or --worksheet", hint="upright grade FOLDER")
    if worksheet is not None:
        _write_worksheet(worksheet, lab, output)
        return
    from upright.classwork.grading import grade as run_again

    assert folder is not None
    with progress("grading") as show:
        grades = run_again(folder, workers=workers, progress=show)
    finish(grades, as_json, page=report, written=(output and grades.save(output),))


def _write_worksheet(language: str, lab: str, output: Path | None) -> None:
    from upright.atomic import write_text
    from upright.classwork.worksheet import LAB, worksheet

    text = worksheet(language, lab or LAB)
    typer.echo(f"wrote {write_text(output, text)}" if output else text, nl=bool(output))
