"""Figures and pages from numbers that other rooms computed; `report` writes the page of any result."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

from upright.errors import UprightError
from upright.pages import Result, Say
from upright.pages.result import PICTURES, write_page
from upright.reports.figure import Figure as Figure
from upright.reports.head import Verdict as Verdict
from upright.reports.page import Details as Details
from upright.reports.page import Formula as Formula
from upright.reports.page import Page as Page
from upright.reports.page import Section as Section
from upright.reports.page import Table as Table


def report(result: Any, path: str | Path, *, title: str = "", command: str = "") -> Path:
    """Write the page of a `result`, which is what a verb returns, and return its path.

    As `.html` it is one self-contained file, as `.svg`, `.pdf` or `.png` the picture of its first screen. `title`
    replaces the page's own; `command`, which made the result, stands at its foot. Raises `UprightError` for a result
    without a page, or where the file cannot be written.
    """
    if isinstance(result, Result):
        page = result.page()
        return write_page(replace(page, title=Say("{title}", title=title) if title else page.title), path, command)
    if Path(path).suffix in PICTURES:
        raise UprightError(f"{path}: this page has many pictures", expected="a name that ends in .html")
    return finished(result, title=title, command=command).write(path)


def finished(result: Any, *, title: str = "", command: str = "") -> Page:
    """The page of the paper or of a hand-in, with the command that made it."""
    page = result if isinstance(result, Page) else getattr(result, "page", lambda: None)()
    if page is None:
        raise UprightError(f"{type(result).__name__} has no page", expected="what a verb of upright returns")
    made = {"command": command} if command else {}
    return replace(page, title=title or page.title, provenance={**page.provenance, **made})
