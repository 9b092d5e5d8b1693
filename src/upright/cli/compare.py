"""`upright compare`: several logs of the same experiment, as numbers and as a page."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from upright.cli.options import JsonOption
from upright.cli.output import print_json
from upright.errors import InvalidLog

if TYPE_CHECKING:
    from upright.signals import Log


def compare(
    logs: Annotated[
        list[str], typer.Argument(metavar="LOG...", help="Log files (.parquet, .csv, .mcap), or LABEL=FILE.")
    ],
    reference: Annotated[
        str | None, typer.Option(help="Label of the log the others are fitted to (default: the first).")
    ] = None,
    release: Annotated[
        float | None, typer.Option(help="When the push ended [s] (default: what each log says).")
    ] = None,
    report: Annotated[Path | None, typer.Option(help="Write one self-contained HTML page with the curves.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Compare logs of the same push.

    Prints settling, overshoot, effort and more for each, and how well each fits the reference.
    """
    from upright.comparison import compare as compare_logs
    from upright.report import comparison_page

    comparison = compare_logs(_labelled(logs), reference=reference, release=release)
    page = comparison_page(comparison, report) if report else None
    if as_json:
        print_json(comparison.to_json() | ({"report": str(page)} if page else {}))
        return
    typer.echo(str(comparison))
    if page:
        typer.echo(f"\nwrote {page}")


def _labelled(arguments: list[str]) -> dict[str, Log]:
    from upright.signals import Log

    labelled: dict[str, Log] = {}
    for argument in arguments:
        label, equals, file = argument.partition("=")
        path = Path(file if equals else argument)
        name = label if equals else path.stem
        if name in labelled:
            raise InvalidLog(f"two logs are called '{name}'", expected="one label each", hint=f"write OTHER={path}")
        labelled[name] = Log.load(path)
    return labelled
