"""A page as one HTML file without links to elsewhere, or as a piece of HTML for a notebook and the lab."""

from __future__ import annotations

import functools
import re
from collections.abc import Sequence
from html import escape
from importlib import resources
from typing import TYPE_CHECKING, Any

from upright.languages import chosen, translated
from upright.pages.blocks import Block, Page, Picture
from upright.pages.cells import Text, columns_of
from upright.pages.glossary import explained

if TYPE_CHECKING:
    from jinja2 import Template


def document(page: Page, command: str = "") -> str:
    """The whole page: style, script and drawings inside, nothing fetched; `command` made it, and stands at its foot."""
    style = _read("style.css")
    script = _read("hover.js")
    return _template("page.html").render(page=page, command=command, language=chosen(), style=style, script=script)


def fragment(page: Page) -> str:
    """The first screen and what is not folded, for a notebook."""
    return _template("fragment.html").render(page=page, language=chosen(), style="")


def shadow(page: Page) -> str:
    """The whole page with its style, for a shadow tree: its colours are those of the page around it."""
    return _template("fragment.html").render(page=page, language=chosen(), style=_read("style.css"))


def marked(text: object) -> str:
    """Text as HTML: a name in backticks is code, a letter with an index, such as J_ψ, has a subscript."""
    parts = _CODE.split(escape(str(text)))  # prose and code by turns
    return "".join(f"<code>{p}</code>" if i % 2 else _INDEX.sub(r"\1<sub>\2</sub>", p) for i, p in enumerate(parts))


_INDEX = re.compile(r"\b([A-Za-zα-ωΔ]\u0307?)_(\w)\b")
_CODE = re.compile(r"`([^`]+)`")


def right(cells: Sequence[Text]) -> bool:
    """Whether a column stands to the right: all of it are numbers."""
    return all(cell.is_number for cell in cells)


def kind(block: Block) -> str:
    """The name of the template of a block."""
    return type(block).__name__.lower()


def drawings(picture: Picture) -> list[str]:
    """The picture as SVG, for a page and for a phone."""
    from upright.pages.drawing import svg

    return [svg(picture, narrow=narrow) for narrow in (False, True)]


def _read(name: str) -> str:
    return resources.files("upright.pages").joinpath(name).read_text(encoding="utf-8")


@functools.cache
def _template(name: str) -> Template:
    from jinja2 import Environment, FunctionLoader, StrictUndefined

    environment = Environment(
        loader=FunctionLoader(lambda file: _read(f"templates/{file}")), autoescape=True, undefined=StrictUndefined,
        trim_blocks=True, lstrip_blocks=True,
    )  # fmt: skip
    environment.filters["marked"] = marked
    names: dict[str, Any] = {"kind": kind, "columns_of": columns_of, "drawings": drawings, "say": translated,
                             "right": right, "explained": explained}  # fmt: skip
    environment.globals.update(names)
    return environment.get_template(name)
