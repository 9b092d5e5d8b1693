"""`upright reproduce`: Herrera et al. (2015) again, from its equations to its comparison."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption
from upright.cli.output import finish, progress


def reproduce(
    *,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for the page, the logs and the numbers.")
    ] = Path("herrera2015"),
    as_json: JsonOption = False,
) -> None:
    """Reproduce the paper of Herrera and others (2015).

    Its model, fit, regulator and pushes beside the printed numbers, and the errata of the text.
    """
    from upright.paper.reproduce import reproduce as reproduce_paper

    with progress("reproducing") as show:
        finish(reproduce_paper(output, show), as_json)
