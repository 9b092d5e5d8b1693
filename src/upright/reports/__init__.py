"""The page of any result as a file, films of runs, and drawings of a robot."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from upright.errors import UprightError
from upright.pages import Result, Say
from upright.pages.result import write_page


def report(result: Any, path: str | Path, *, title: str = "", command: str = "") -> Path:
    """Write the page of a `result`, which is what a verb returns, and return its path.

    As `.html` it is one self-contained file, as `.svg`, `.pdf` or `.png` the picture of its first screen. `title`
    replaces the page's own; `command`, which made the result, stands at its foot. Raises `UprightError` for a result
    without a page, or where the file cannot be written.
    """
    if not isinstance(result, Result):
        raise UprightError(f"{type(result).__name__} has no page", expected="what a verb of upright returns")
    page = result.page()
    if title:
        page = replace(page, title=Say("{name}", name=title))
    return write_page(page, path, command)
