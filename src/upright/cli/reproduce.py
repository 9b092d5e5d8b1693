"""`upright reproduce`: Herrera et al. (2015) again, from its equations to its comparison."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption
from upright.cli.output import print_json, progress


def reproduce(
    folder: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for the page, the logs and the numbers.")
    ] = Path("herrera2015"),
    as_json: JsonOption = False,
) -> None:
    """Reproduce the study of Herrera and others (2015).

    Its model, fit, regulator and pushes, each beside the printed numbers, and the errata of the printed text.
    """
    from upright.paper.reproduce import reproduce as reproduce_paper

    with progress("reproducing") as share:
        reproduction = reproduce_paper(folder, share)
    if as_json:
        print_json(reproduction.to_json())
    else:
        typer.echo(str(reproduction))
