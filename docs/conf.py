"""How Sphinx builds the site, called by `python docs/build.py`: nothing that it writes asks another host."""

from __future__ import annotations

import re
import tomllib
from html import escape, unescape
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
html_js_files = ["site.js"]
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


FOLDED = "folded"
"""A section below the comment `<!-- folded -->` is the depth of a page: the site shows its title, which opens it."""


def fold(_app: Sphinx, doctree: nodes.document, _page: str) -> None:
    """Each such section inside `details`, whose summary is its title."""
    marks = [m for m in doctree.findall(nodes.raw) if m.astext().strip() == f"<!-- {FOLDED} -->"]
    for mark, section in [(mark, _after(mark)) for mark in marks]:
        mark.parent.remove(mark)
        section[:] = [_html("<details><summary>"), section[0], _html("</summary>"), *section[1:], _html("</details>")]


def _after(mark: nodes.Element) -> Any:
    """What follows a node, which is the last of the section before it, or of a part of that."""
    while mark.parent[-1] is mark:
        mark = mark.parent
    return mark.parent[mark.parent.index(mark) + 1]


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


def accessible(_app: Sphinx, _page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """What a keyboard and a screen reader need: the level of a caption, and a way into what scrolls by itself."""
    for old, new in (
        ('role="heading">', 'role="heading" aria-level="2">'),
        ('<div class="highlight"><pre>', '<div class="highlight"><pre tabindex="0">'),
        ('<div class="table-wrapper', '<div tabindex="0" class="table-wrapper'),
    ):
        for name in ("furo_navigation_tree", "body"):
            context[name] = context.get(name, "").replace(old, new)


COMMANDS = re.compile(
    r'(<div class="highlight-sh[^>]*><div class="highlight"><pre[^>]*><span></span>)(.*?)(?=</pre>)', re.S
)
PYTHON = re.compile(COMMANDS.pattern.replace("highlight-sh", "highlight-(?:python|pycon|default|toml)"), re.DOTALL)
OPTION = re.compile(
    r'(<span class="word">-[^<]*)</span>(<span class="w">[^<]*</span>)<span class="word">(?!-)(?=[^ ]{1,24}</span>)'
)
"""An option and its short value, which stay on one line."""
LONG = re.compile(r'<span class="pre">([^<]{28,})<')
"""A word of code that may be broken: it is longer than a line of a phone."""
TABLE = re.compile(r'<table class="docutils align-default">.*?</table>', re.DOTALL)
COLUMN, PHONE, MANY, BRIEF = 90, 40, 7, 14
"""Letters of a line of code, of a line of a table on a phone, columns in the usual type, letters of half a card."""


QUANTITY = re.compile(r"(?<=\d) (?=(?:s|ms|min|h|m|cm|mm|kg|g|N|V|rad|Hz|°|%|1/s|kB|MB)\b|%)")
"""Between a number and its unit, where no line breaks."""

DARK = (
    r'<img\1src="_images/lab\2.webp" class="only-light" loading="lazy"\3>'
    r'<img\1src="_static/lab-dark\2.webp" class="only-dark" loading="lazy"\3>'
)
"""The picture of the lab, as dark as the page."""


def readable(_app: Sphinx, _page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """Commands are never cut, and a table that is too wide for a phone is a card for each of its rows there."""
    body = COMMANDS.sub(lambda block: block[1] + wrapped(block[2]), context.get("body", ""))
    body = PYTHON.sub(lambda block: block[1] + rows(block[2]), body)
    body = LONG.sub(lambda word: f'<span class="pre long">{re.sub("(?=[#?]|&amp;)", "<wbr>", word[1])}<', body)
    body = TABLE.sub(lambda table: stacked(table[0]), body)
    parts = re.split(r"(<(pre|math)\b.*?</\2>)", body, flags=re.DOTALL)
    body = "".join(part if k % 3 else QUANTITY.sub("\u00a0", part) for k, part in enumerate(parts) if k % 3 < 2)
    context["body"] = re.sub(r'<img([^>]*?)src="_images/lab(\.es)?\.webp"([^>]*)>', DARK, body)


def wrapped(shell: str) -> str:
    """Each line as a block with a hanging indent, which breaks between words; what is copied stays one line."""
    lines = shell.splitlines(keepends=True)
    plain = [unescape(re.sub(r"<[^>]+>", "", line)) for line in lines]
    apart = " apart" * any(len(line) > COLUMN and " # " in line for line in plain)
    made: list[str] = []
    for line in lines:
        command, mark, comment = line.rstrip("\n").partition('<span class="c1">')
        parts = filter(None, re.split(r'(<span class="w">.*?</span>)', command))
        words = OPTION.sub(
            r"\1\2", "".join(part if 'class="w"' in part else f'<span class="word">{part}</span>' for part in parts)
        )
        words = words and f'<span class="command">{words}</span>'
        made.append(f'<span class="line{apart}">{words}{mark}{comment}\n</span>')
    return "".join(made)


def rows(python: str) -> str:
    """Each line apart, with how far it is indented: a phone breaks it below itself."""
    made: list[str] = []
    for line in python.splitlines(keepends=True):
        plain = unescape(re.sub(r"<[^>]+>", "", line))
        made.append(f'<span class="row" style="--in: {len(plain) - len(plain.lstrip(" ")) + 4}ch">{line}</span>')
    return "".join(made)


def stacked(table: str) -> str:
    """A table as it is; where it is wide, each cell with the title of its column, and with its role in the table.

    A first cell that is blank means what stands above it; a card repeats it.
    """
    rows = [re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row, re.DOTALL) for row in table.split("</tr>")[:-1]]
    texts = [[unescape(re.sub(r"<[^>]+>", "", cell)).strip() for cell in row] for row in rows]
    columns = list(zip(*texts, strict=True))
    kind = " many" if len(columns) > MANY else ""
    if sum(3 + max(len(word) for text in column for word in [*text.split(), ""]) for column in columns) <= PHONE:
        return table.replace("align-default", f"align-default{kind}", 1) if kind else table
    labels = texts[0]
    group = ""
    brief = [max(map(len, column)) <= BRIEF for column in columns]
    cells = iter([k for _ in texts[1:] for k in range(len(labels))])

    def cell(found: re.Match[str]) -> str:
        nonlocal group
        k = next(cells)
        if k == 0 and not found[2]:
            return f'<td role="cell"><span class="again">{group}</span></td>'
        group = found[2] if k == 0 else group
        classes = " brief" * brief[k] + " none" * (found[2] in ("", "–", "<p>–</p>"))
        return f'<td role="cell" class="{classes.strip()}" data-label="{escape(labels[k])}">{found[2]}</td>'

    table = re.sub(r"<td([^>]*)>(.*?)</td>", cell, table, flags=re.DOTALL)
    for tag, role in (("thead", "rowgroup"), ("tbody", "rowgroup"), ("tr", "row"), ("th", "columnheader")):
        table = re.sub(rf"<{tag}\b", f'<{tag} role="{role}"', table)
    return table.replace('<table class="', f'<table role="table" class="stacked{kind} ', 1)


SPANISH = {
    "Search": "Buscar", "On this page": "En esta página", "Contents": "Contenido", "Back to top": "Volver arriba",
    "Next": "Siguiente", "Previous": "Anterior", "Home": "Inicio",
    "Start": "Inicio (en inglés)", "Course": "Curso (en inglés)", "How to": "Recetas (en inglés)",
    "Concepts": "Conceptos (en inglés)", "Reference": "Referencia (en inglés)",
    "Studies": "Estudios (en inglés)",
    "The project": "El proyecto (en inglés)",
}  # fmt: skip
"""What stands round a page that is Spanish: words of the theme, and the parts of the site."""


def neighbours(app: Sphinx, page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """Before and after a page are the next ones in its own language."""
    relations = app.env.collect_relations()
    for k, way in ((1, "prev"), (2, "next")):
        other = page
        while other := relations.get(other, (None, None, None))[k]:
            if in_spanish(other) == in_spanish(page):
                break
        if context.get(way):
            title = app.env.titles[other].astext() if other else ""
            context[way] = {"link": app.builder.get_relative_uri(page, other), "title": title} if other else None


def in_spanish(page: str) -> bool:
    return page.endswith(".es") or page.startswith("notebooks/es/")


def _has_spanish(app: Sphinx, link: str) -> bool:
    """Whether the English page at a link is there in Spanish too, which stands in its own part of the tree."""
    name, _, language = link.rpartition("/")[2].removesuffix(".html").partition(".")
    return language != "es" and f"{name}.es" in app.env.found_docs


def spanish(app: Sphinx, page: str, _template: str, context: dict[str, Any], _tree: object) -> None:
    """The frame of a Spanish page is Spanish; the pages that it leads to keep their own language."""
    if not in_spanish(page):
        return

    def said(text: str) -> Markup:
        return Markup(SPANISH.get(text, text))

    context |= {"language": "es", "_": said, "gettext": said}
    captions = re.compile(r'(?<=<span class="caption-text">)[^<]+')
    tree = context.get("furo_navigation_tree", "")
    twice = re.compile(r'<li class="toctree-l1"><a class="reference internal" href="([^"#]+)">[^<]*</a></li>\n?')
    tree = twice.sub(lambda link: "" if _has_spanish(app, link[1]) else link[0], tree)
    head, *parts = captions.sub(lambda found: SPANISH.get(found[0], found[0]), tree).split('<p class="caption"')
    parts.sort(key=lambda part: ">En español<" not in part)  # its own part comes first
    context["furo_navigation_tree"] = '<p class="caption"'.join([head, *parts])


def setup(app: Sphinx) -> None:
    app.connect("autodoc-process-docstring", restructured)
    app.connect("doctree-resolved", fold)
    app.connect("html-page-context", accessible, priority=900)  # after furo, which makes the tree
    app.connect("html-page-context", neighbours)
    app.connect("html-page-context", readable, priority=905)
    app.connect("html-page-context", spanish, priority=910)
    app.add_html_math_renderer("mathml", (inline, None), (display, None))
