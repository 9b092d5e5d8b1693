"""The help of `upright` itself, as `main` prints it, kept in a file: typer alone loads as long as six interpreters."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from pathlib import Path

TEXT = Path(__file__).with_name("overview.txt")
"""What `upright --help` prints on 80 columns and more; a test compares it with what `main` makes."""
COLUMNS = 80
ASKS = ([], ["-h"], ["--help"])


def overview(arguments: Sequence[str]) -> str | None:
    """The help, if these arguments ask for no more; None where it has to be made: on a narrow terminal, or where a
    shell asks for completions."""
    if list(arguments) not in ASKS or "_UPRIGHT_COMPLETE" in os.environ or _columns() < COLUMNS:
        return None
    return TEXT.read_text("utf-8")


def _columns() -> int:
    """The width of the terminal, as `shutil.get_terminal_size` has it, without what that loads."""
    try:
        if (given := int(os.environ.get("COLUMNS", "0"))) > 0:
            return given
    except ValueError:
        pass
    try:
        return os.get_terminal_size(sys.stdout.fileno()).columns or COLUMNS
    except (AttributeError, ValueError, OSError):
        return COLUMNS
