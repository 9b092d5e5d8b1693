"""`upright example`: logs and files to try every other command on."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import typer

from upright.cli.output import check_targets, print_json, print_page
from upright.cli.vocabulary import completed
from upright.languages import ENGLISH, speaking
from upright.pages import Column, Next, Page, Say, Table

FILES = {
    "handed-in": Say("hand-ins of a class of three, for `upright grade`"),
    "notebook": Say("a notebook to begin with, for Jupyter or VS Code"),
}
"""Examples that are no logs, each a folder or file of that name."""


def _names() -> list[str]:
    from upright.experiment.examples import EXAMPLES

    return [*EXAMPLES, *FILES]


def example(
    name: Annotated[
        str | None, typer.Argument(help="Example by name (default: list them).", autocompletion=completed(_names))
    ] = None,
    *,
    output: Annotated[
        Path | None, "Write the log: .csv, .parquet or .mcap (default: NAME.csv), or the other file."
    ] = None,
    json: bool = False,
) -> None:
    """Write an example log of the twin, or list them.

    Logs as a robot writes them: standing, excited, pushed, falling, and with planted faults for the doctor. Two are
    files of another kind: `notebook`, and a class's hand-ins.
    """
    from upright.errors import UnknownName
    from upright.experiment.examples import EXAMPLES
    from upright.experiment.examples import example as simulate
    from upright.signals.files import check_format

    every = {key: one.about for key, one in EXAMPLES.items()} | FILES
    if name is None:
        if json:
            with speaking(ENGLISH):
                print_json({key: str(about) for key, about in every.items()})
        else:
            print_page(_page(every))
        return
    if name not in every:
        raise UnknownName("example", name, every)
    if name in FILES:
        written = _file(name, output)
        kind = "file"
        about = FILES[name]
    else:
        target = output or Path(f"{name}.csv")
        check_targets(target)
        check_format(target)
        written = simulate(name).save(target)
        kind = "log"
        about = Say("a twin, {about}", about=EXAMPLES[name].about)
    if json:
        print_json({"example": name, kind: str(written)})
    else:
        typer.echo(str(Say("wrote {file}: {about}", file=str(written), about=about)))


def _page(every: Mapping[str, Say]) -> Page:
    table = Table([Column(Say("example")), Column(Say("what it shows"))], list(every.items()))
    return Page(Say("{n} examples to try commands on", n=len(every)), next=[Next("example", "pushed")], blocks=[table])


def _file(name: str, output: Path | None) -> Path:
    if name == "notebook":
        from upright.reports.notebook import starting_notebook

        target = output or Path("notebook.ipynb")
        check_targets(target)
        return starting_notebook(target)
    from upright.classwork.examples import hand_ins

    return hand_ins(output or Path(name))
