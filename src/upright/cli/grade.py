"""`upright grade`: the hand-ins of a class, run again."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.destination import Destination
from upright.cli.output import tell
from upright.errors import UprightError
from upright.progress import progress


def grade(
    folder: Annotated[Path | None, "Folder with the hand-ins (.json) that the lab saved."] = None,
    *,
    output: Annotated[Path | None, "Write the table as CSV, or the worksheet as Markdown."] = None,
    workers: int | None = None,
    worksheet: str | None = None,
    lab: str = "",
    out: Destination,
) -> None:
    """Grade the hand-ins of a class, by running them again.

    Prints what each student claimed, what comes of it on this machine, and a verdict: ok, not reached, differs, edited,
    copied, other set-up or broken.
    """
    out.check(output)
    if (folder is None) == (worksheet is None):
        raise UprightError("grade needs a folder of hand-ins, or --worksheet", hint="upright grade FOLDER")
    if worksheet is not None:
        _write_worksheet(worksheet, lab, output)
        return
    from upright.classwork.grading import grade as run_again

    assert folder is not None
    each = 0  # one for each processor
    if workers is not None:
        each = max(1, workers)
    with progress("grading") as show:
        grades = run_again(folder, workers=each, progress=show)
    out.finish(grades, output and grades.save(output))


def _write_worksheet(language: str, lab: str, output: Path | None) -> None:
    from upright.atomic import write_text
    from upright.classwork.worksheet import LAB, worksheet

    text = worksheet(language, lab or LAB)
    if output:
        tell(f"wrote {write_text(output, text)}")
    else:
        typer.echo(text, nl=False)
