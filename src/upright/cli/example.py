"""`upright example`: logs to try every other command on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import JsonOption, completed
from upright.cli.output import check_targets, print_json, print_table


def _names() -> list[str]:
    from upright.experiment.examples import EXAMPLES

    return list(EXAMPLES)


def example(
    name: Annotated[
        str | None, typer.Argument(help="Example by name (default: list them).", autocompletion=completed(_names))
    ] = None,
    *,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the log: .csv, .parquet or .mcap (default: NAME.csv).")
    ] = None,
    as_json: JsonOption = False,
) -> None:
    """Write an example log of the twin, or list them.

    Logs as a robot writes them: standing, excited, pushed, falling, and with planted faults for the doctor.
    """
    from upright.experiment.examples import EXAMPLES
    from upright.experiment.examples import example as simulate

    if name is None:
        if as_json:
            print_json({key: one.about for key, one in EXAMPLES.items()})
        else:
            print_table(("example", "what it shows"), [(key, one.about) for key, one in EXAMPLES.items()])
        return
    target = output or Path(f"{name}.csv")
    check_targets(target)
    written = simulate(name).save(target)
    if as_json:
        print_json({"example": name, "log": str(written)})
    else:
        typer.echo(f"wrote {written}: a twin, {EXAMPLES[name].about}")
