"""How Sphinx builds the site, called by `python docs/build.py`: nothing that it writes asks another host."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from markupsafe import Markup
from sphinx.application import Sphinx

project = "upright"
author = "The upright maintainers"
copyright = "The upright maintainers, Apache-2.0"
version = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text("utf-8"))["project"]["version"]
release = version

extensions = ["myst_parser", "sphinx.ext.autodoc"]
root_doc = "index"
exclude_patterns = ["src", "README.md"]
nitpicky = True
default_role = "code"

myst_enable_extensions = ["dollarmath", "colon_fence", "attrs_inline"]
myst_heading_anchors = 4

autodoc_member_order = "bysource"
autodoc_typehints = "none"
add_module_names = False

html_theme = "furo"
html_title = "upright"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_search_summary = False  # summaries are fetched, which a page from a folder may not do
html_math_renderer = "mathml"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#00588a", "color-brand-content": "#00588a"},
    "dark_css_variables": {"color-brand-primary": "#6cb8e6", "color-brand-content": "#6cb8e6"},
}
templates_path: list[str] = []
smartquotes = False


def restructured(_app: object, _what: str, _name: str, _thing: object, _options: object, lines: list[str]) -> None:
    """Our docstrings are Markdown of one kind of mark only, `code`; everything else is meant as it stands."""
    text = re.sub(r"(`[^`\n]+`)|([*|\\]|_\b)", lambda m: m[1] or "\\" + m[2], "\n".join(lines))
    lines[:] = re.sub(r"(?<!`)`([^`\n]+)`(?!`)", r"``\1``", text).split("\n")


def mathml(tex: str, display: str) -> str:
    """A formula as MathML, which browsers draw by themselves; the names of functions stand apart from what follows."""
    text = convert(tex.replace("{aligned}", "{align*}"), display=display)
    return re.sub(r"(<mi>(?:sin|cos|cosh|ln|det|arg|max|min)</mi>)(?!</)", r'\1<mspace width="0.17em" />', text)


def inline(self: Any, node: nodes.math) -> None:
    self.body.append(mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def display(self: Any, node: nodes.math_block) -> None:
    self.body.append(f'<div class="math" tabindex="0">{mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode


def accessible(_app: Sphinx, _page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """What a keyboard and a screen reader need: the level of a caption, and a way into what scrolls by itself."""
    for old, new in (
        ('role="heading">', 'role="heading" aria-level="2">'),
        ('<div class="highlight"><pre>', '<div class="highlight"><pre tabindex="0">'),
        ('<div class="table-wrapper', '<div tabindex="0" class="table-wrapper'),
    ):
        for name in ("furo_navigation_tree", "body"):
            context[name] = context.get(name, "").replace(old, new)


SPANISH = {
    "Search": "Buscar", "On this page": "En esta página", "Contents": "Contenido", "Back to top": "Volver arriba",
    "Next": "Siguiente", "Previous": "Anterior", "Home": "Inicio", "Start": "Inicio", "Course": "Curso",
    "How to": "Recetas (en inglés)", "Concepts": "Conceptos (en inglés)", "Reference": "Referencia (en inglés)",
    "The project": "El proyecto (en inglés)",
}  # fmt: skip
"""What stands round a page that is Spanish: words of the theme, and the parts of the site."""


def spanish(_app: Sphinx, page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """The frame of a Spanish page is Spanish; the pages that it leads to keep their own language."""
    if not (page.endswith(".es") or page.startswith("notebooks/es/")):
        return

    def said(text: str) -> Markup:
        return Markup(SPANISH.get(text, text))

    context |= {"language": "es", "_": said, "gettext": said}
    captions = re.compile(r'(?<=<span class="caption-text">)[^<]+')
    tree = context.get("furo_navigation_tree", "")
    context["furo_navigation_tree"] = captions.sub(lambda found: SPANISH.get(found[0], found[0]), tree)


def setup(app: Sphinx) -> None:
    app.connect("autodoc-process-docstring", restructured)
    app.connect("html-page-context", accessible, priority=900)  # after furo, which makes the tree
    app.connect("html-page-context", spanish, priority=910)
    app.add_html_math_renderer("mathml", (inline, None), (display, None))
