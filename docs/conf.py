"""How Sphinx builds the site, called by `python docs/build.py`: nothing that it writes asks another host."""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from sphinx.application import Sphinx

project = "upright"
copyright = "The upright maintainers, Apache-2.0"

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.autosummary"]
nitpicky = True
smartquotes = False
locale_dirs = ["_locale"]  # the theme's words that Sphinx does not have

myst_enable_extensions = ["dollarmath", "colon_fence", "attrs_inline"]
myst_heading_anchors = 4

autodoc_member_order = "bysource"
autodoc_typehints = "none"
autosummary_generate = False
add_module_names = False

html_theme = "furo"
html_title = "upright"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_copy_source = False
html_show_sourcelink = False
html_show_search_summary = False  # summaries are fetched, which a page from a folder may not do
html_math_renderer = "mathml"
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#00588a", "color-brand-content": "#00588a"},
    "dark_css_variables": {"color-brand-primary": "#6cb8e6", "color-brand-content": "#6cb8e6"},
}


def restructured(_app: object, _what: str, _name: str, _thing: object, _options: object, lines: list[str]) -> None:
    """Our docstrings are Markdown of one kind of mark only, `code`; everything else is meant as it stands."""
    text = re.sub(r"(`[^`\n]+`)|([*|\\]|_\b)", lambda m: m[1] or "\\" + m[2], "\n".join(lines))
    lines[:] = re.sub(r"(?<!`)`([^`\n]+)`(?!`)", r"``\1``", text).split("\n")


def fold(_app: Sphinx, doctree: nodes.document, _page: str) -> None:
    """A section below `<!-- folded -->` is the depth of a page: the site shows its title, which opens it."""
    for mark in [m for m in doctree.findall(nodes.raw) if m.astext().strip() == "<!-- folded -->"]:
        section: Any = mark.next_node(nodes.section, descend=False, siblings=True, ascend=True)
        mark.parent.remove(mark)
        section[:] = [_html("<details><summary>"), section[0], _html("</summary>"), *section[1:], _html("</details>")]


def _html(text: str) -> nodes.raw:
    return nodes.raw("", text, format="html")


THIN = '<mspace width="0.17em" />'
NAME = "<mi>(?:sin|cos|cosh|ln|det|arg|max|min)</mi>"
FUNCTION = re.compile(
    rf"(</m(?:i|n|sup|sub|over|frac)>)?(<msup>{NAME}<mn>\d</mn></msup>|(?<!<msup>){NAME})(?=(</|<mo[^>]*>&#x00028;)?)"
)


def mathml(tex: str, display: str) -> str:
    """A formula as MathML, which browsers draw by themselves; a function stands apart from what it does not enclose."""
    text = convert(tex.replace("{aligned}", "{align*}"), display=display)
    return FUNCTION.sub(lambda f: (f[1] + THIN if f[1] else "") + f[2] + ("" if f[3] else THIN), text)


def inline(self: Any, node: nodes.math) -> None:
    self.body.append(mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def display(self: Any, node: nodes.math_block) -> None:
    self.body.append(f'<div class="math" tabindex="0">{mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode


SHELL = re.compile(r'<div class="highlight-sh .*?</pre>', re.DOTALL)
HYPHENED = re.compile(r"(?<=[ \n>])([\w.,:=/-]*-[\w.,:=/-]+)")
"""In a command, which breaks between its words: a word that a browser would break behind its hyphen."""


def finished(app: Sphinx, page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """A way for the keyboard into what scrolls by itself, room to write on, and links to the site's own lab."""
    lab = app.builder.get_relative_uri(page, "index").replace("index.html", "") or "./"
    lab += "../try/index.html#" if app.config.language == "es" else "try/index.html#"
    for old, new in (
        ('role="heading">', 'role="heading" aria-level="2">'),
        ('<div class="highlight"><pre>', '<div class="highlight"><pre tabindex="0">'),
        ('<div class="table-wrapper', '<div tabindex="0" class="table-wrapper'),
        ("_" * 60, '<span class="blank"></span>'),
        ('href="http://127.0.0.1:8765/#', f'href="{lab}'),
    ):
        for name in ("furo_navigation_tree", "body"):
            context[name] = context.get(name, "").replace(old, new)
    context["body"] = SHELL.sub(lambda shell: HYPHENED.sub(r'<span class="whole">\1</span>', shell[0]), context["body"])


def setup(app: Sphinx) -> None:
    app.connect("autodoc-process-docstring", restructured)
    app.connect("doctree-resolved", fold)
    app.connect("html-page-context", finished, priority=900)  # after furo, which makes the tree
    app.add_html_math_renderer("mathml", (inline, None), (display, None))
