"""How commands print: tables, JSON, progress."""

from __future__ import annotations

import sys
from collections.abc import Callable, Generator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import typer

from upright.atomic import json_text
from upright.errors import UprightError

PIPED_WIDTH = 200
"""Columns of a table that goes into a pipe or a file, where no line should be broken."""


def print_table(header: Sequence[str], rows: Sequence[Sequence[str]], numbers: Sequence[str] = ()) -> None:
    """Print aligned columns; those named in `numbers` are set to the right, and only the last one may wrap."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, header_style="bold")
    for name in header:
        last = name == header[-1]
        table.add_column(Text(name), justify="right" if name in numbers else "left", no_wrap=not last)
    for row in rows:
        table.add_row(*(Text(cell) for cell in row))
    Console(width=None if sys.stdout.isatty() else PIPED_WIDTH, highlight=False).print(table)


def print_json(data: Any) -> None:
    """Print JSON on stdout."""
    typer.echo(json_text(data))


def check_folder(path: Path) -> None:
    """Refuse a file whose folder is not there, before the work that would fill it."""
    if not path.parent.is_dir():
        raise UprightError(f"there is no folder {path.parent} for {path.name}", hint=f"mkdir -p {path.parent}")


@contextmanager
def progress(label: str) -> Generator[Callable[[float], None]]:
    """A bar on stderr where a person watches it: yields what takes the share done."""
    if not sys.stderr.isatty():
        yield _nobody_watches
        return
    from rich.console import Console
    from rich.progress import Progress

    with Progress(console=Console(stderr=True), transient=True) as bar:
        task = bar.add_task(label, total=1.0)

        def show(share: float) -> None:
            bar.update(task, completed=share)

        yield show


def _nobody_watches(share: float) -> None:
    """Show nothing of the `share` done."""
