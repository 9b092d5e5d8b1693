"""How far a long computation is: what is called with the fraction done, and what shows nothing of it."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager

from upright.messages import in_language

Progress = Callable[[float], None]
"""Called with the fraction done [1], from 0 to 1."""


def unwatched(fraction: float) -> None:
    """Progress that nobody watches: nothing is shown of the `fraction`."""


QUIET = 10.0
"""[s] in which nobody asks whether a command still runs."""


def _in_lines(label: str) -> Callable[[float], None]:
    begin = time.monotonic()
    shown = 0
    named = in_language(label)

    def show(fraction: float) -> None:
        nonlocal shown
        spent = time.monotonic() - begin
        if spent > QUIET and shown < int(10 * fraction) < 10:
            shown = int(10 * fraction)
            left = spent * (1 / fraction - 1)
            print(in_language(f"{named}: {10 * shown} %, about {left:.0f} s left"), file=sys.stderr)

    return show


@contextmanager
def progress(label: str) -> Generator[Callable[[float], None]]:
    """A bar on stderr in a terminal, else a line for each tenth of what takes long: yields what takes the fraction
    done."""
    if not sys.stderr.isatty():
        yield _in_lines(label)
        return
    from rich import progress as rich
    from rich.console import Console

    bar = rich.Progress(console=Console(stderr=True), transient=True)
    task = bar.add_task(in_language(label), total=1.0)

    def show(fraction: float) -> None:
        bar.start()  # with the first fraction, since a command may ask before its work begins
        bar.update(task, completed=fraction)

    try:
        yield show
    finally:
        bar.stop()
