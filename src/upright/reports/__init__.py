"""Figures and pages from numbers that other rooms computed; `report` writes the page of any result."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module
from pathlib import Path
from typing import Any

from upright.errors import UprightError
from upright.pages import Result, Say
from upright.pages.result import write_page
from upright.reports.figure import Figure as Figure
from upright.reports.following import completed
from upright.reports.head import Verdict as Verdict
from upright.reports.made import made_by
from upright.reports.page import Details as Details
from upright.reports.page import Formula as Formula
from upright.reports.page import Page as Page
from upright.reports.page import Section as Section
from upright.reports.page import Table as Table

PAGES = {
}  # fmt: skip
"""Class of a result → the file of this room that has its page."""


def report(result: Any, path: str | Path, *, title: str = "", command: str = "") -> Path:
    """Write the page of a `result` as one self-contained HTML file, and return its path.

    `result` is what a verb returns: a comparison, a calibration, a validation, all identified models, an excitation
    plan, a certificate, a post-mortem, a fleet, a push map, a basin, a campaign, a
    diagnosis or a parity. `title` replaces the page's own; `command`, which made the result, stands at
    its foot. Raises `UprightError` for a result without a
    page, or where the file cannot be written.
    """
    if isinstance(result, Result):
        page = result.page()
        return write_page(replace(page, title=Say("{title}", title=title) if title else page.title), path, command)
    return finished(result, title=title, command=command).write(path)


def finished(result: Any, *, title: str = "", command: str = "") -> Page:
    """The page of a result with the command that made it, and what to run next completed by that command."""
    with made_by(command):
        page = page_of(result)
    made = {"command": command} if command else {}
    lead = completed(page.lead, command)
    return replace(page, title=title or page.title, lead=lead, provenance={**page.provenance, **made})


def page_of(result: Any) -> Page:
    """The page of a result, not yet written; a page is its own, and some results make theirs."""
    if isinstance(result, Page):
        return result
    if hasattr(result, "page"):
        return result.page()
    file = next((PAGES[c.__name__] for c in type(result).__mro__ if c.__name__ in PAGES), None)
    if file is None:
        raise UprightError(f"{type(result).__name__} has no page", expected="a result: " + ", ".join(PAGES))
    return import_module(f"upright.reports.{file}").page_of(result)
