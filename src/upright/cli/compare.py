"""`upright compare`: several logs of the same experiment, as numbers and as a page."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

import typer

from upright.cli.options import JsonOption, OutputOption, ReportOption
from upright.cli.output import check_targets, finish
from upright.errors import InvalidLog


def compare(
    logs: Annotated[list[str], typer.Argument(metavar="LOG", help="Logs (.parquet, .csv, .mcap), or LABEL=FILE.")],
    *,
    reference: Annotated[str | None, typer.Option(help="Label of the reference log (default: the first).")] = None,
    release: Annotated[float | None, typer.Option(help="End of the push [s] (default: from each log).")] = None,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Compare logs of the same push.

    Prints settling, overshoot, effort and other metrics of each log, and its fit to the reference.
    """
    from upright.comparison import compare as compare_logs
    from upright.signals import Log

    check_targets(output, report)
    comparison = compare_logs(
        {label: Log.load(path) for label, path in labelled(logs).items()}, reference=reference, release=release
    )
    facts: dict[str, Any] = {"report": str(report)} if report else {}
    finish(comparison, as_json, output=output, page=report, **facts)


def labelled(arguments: list[str]) -> dict[str, Path]:
    labelled: dict[str, Path] = {}
    for argument in arguments:
        label, equals, file = argument.partition("=")
        path = Path(file if equals else argument)
        name = label if equals else path.stem
        if name in labelled:
            raise InvalidLog(f"two logs are called '{name}'", expected="one label each", hint=f"write OTHER={path}")
        labelled[name] = path
    return labelled
