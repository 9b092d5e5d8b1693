"""What every verb returns: it prints itself, shows itself in a notebook, and is data."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from upright.atomic import write_text, writing
from upright.errors import UprightError
from upright.pages.blocks import Page


class Result:
    """A result with a `page()`: its text, its look in a notebook and its file are renderings of that page."""

    def page(self) -> Page:
        """The result for people."""
        raise NotImplementedError

    def to_json(self) -> dict[str, Any]:
        """The result as data: numbers in SI, and all that the page shows."""
        raise NotImplementedError

    def __str__(self) -> str:
        from upright.pages.terminal import text

        return text(self.page())

    def __repr__(self) -> str:
        page = self.page()
        return f"<{type(self).__name__}: {page.verdict.text if page.verdict else page.title}>"

    def _repr_html_(self) -> str:
        from upright.pages.html import fragment

        return fragment(self.page())


PICTURES = (".svg", ".pdf", ".png")
"""Formats of a page's first picture by itself."""


def check_page(path: Path) -> None:
    """Raise `UprightError` where no page can have that name: for a suffix other than .html and those of `PICTURES`."""
    if path.suffix not in (".html", *PICTURES):
        expected = f"a page, .html, or its picture, {' '.join(PICTURES)}"
        raise UprightError(f"{path.name} has no known format", expected=expected, hint=f"{path.stem}.html")


def write_page(page: Page, path: str | Path, command: str = "") -> Path:
    """The page as `.html`, or its picture as `.svg`, `.pdf` or `.png`, by the suffix; returns the path.

    Raises `UprightError` for another suffix, a page without a picture, or where the file cannot be written.
    """
    from upright.pages.html import document

    target = Path(path)
    check_page(target)
    if target.suffix == ".html":
        return write_text(target, document(page, command))
    if page.picture is None:
        raise UprightError(f"{target.name}: this result has no picture", expected="a name that ends in .html")
    figure = page.picture.draw()
    with writing(target) as stream:
        figure.savefig(stream, format=target.suffix[1:])
    return target
