"""A picture as inline SVG: its colours are those of the page, its letters stay text, and a pointer reads
its lines."""

from __future__ import annotations

import hashlib
import io
import json
import re
from collections.abc import Collection
from html import escape
from typing import Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure

from upright import plotting
from upright.pages.blocks import Picture

UNIT = 72  # a drawing has 72 units for an inch of matplotlib's
SHARP = 216  # dots for an inch of a map, so that its borders are no stairs
PAPER = "#fdfdfb"  # ground of letters that stand across lines

VARIABLES = {colour: f"var(--c{k})" for k, colour in enumerate(plotting.COLOURS)} | {
    plotting.INK: "var(--soft)", plotting.AXIS: "var(--axis)", plotting.GRID: "var(--grid)",
    plotting.SPAN: "var(--span)", PAPER: "var(--paper)",
}  # fmt: skip
"""Colours of a drawing → variables of the style sheet."""


def svg(picture: Picture, *, narrow: bool = False) -> str:
    """The drawing, for a page or as wide as a phone, with its claim for those who cannot see it."""
    if narrow:
        with plotting.drawn_for_a_phone():
            drawing = picture.draw()
    else:
        drawing = picture.draw()
    curves = curves_of(drawing)
    claim = str(picture.claim)
    mark = hashlib.sha256(f"{claim} {narrow}".encode()).hexdigest()[:8]
    width, height = (UNIT * inches for inches in drawing.get_size_inches())
    size = "narrow" if narrow else "wide"
    data = ""
    below = ""
    if curves:
        data = f' data-curves="{escape(json.dumps(curves))}"'
        below = "<output></output>"  # where hover.js says what it reads
    most = "" if narrow else f' style="max-width: {min(100 * width / UNIT / plotting.WIDTH, 100):.0f}%"'
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" role="img" viewBox="0 0 {width:g} {height:g}" '
        f'aria-labelledby="t{mark}" class="{size}{" lines" if curves else ""}"{most}{data}>'
        f'<title id="t{mark}">{escape(claim)}</title>{strokes(drawing, mark)}</svg>{below}'
    )


def strokes(drawing: Figure, mark: str) -> str:
    """What stands inside the <svg> of a drawing; its ids end with `mark`, so that they differ on one page."""
    stream = io.StringIO()
    with matplotlib.rc_context({"svg.fonttype": "none", "svg.hashsalt": mark}):
        Figure.savefig(drawing, stream, format="svg", transparent=True, dpi=SHARP, metadata={"Date": None})
    body = re.search(r"</metadata>(.*)</svg>", stream.getvalue(), re.DOTALL)
    assert body
    return _themed(body[1], mark)


def curves_of(drawing: Figure) -> list[dict[str, Any]]:
    """For each panel of lines where it stands, what its axes show, and the ids of its lines."""
    width, height = (UNIT * inches for inches in drawing.get_size_inches())
    panels: list[dict[str, Any]] = []
    for row, ax in enumerate(drawing.axes):
        lines = [line for line in ax.lines if line.get_linestyle() not in ("None", "") and _is_curve(line)]
        if not lines or ax.get_aspect() != "auto":
            continue
        for k, line in enumerate(lines):
            line.set_gid(f"line-{row}-{k}")
        box = ax.get_position()
        panels.append({
            "row": row, "lines": [str(line.get_label()) for line in lines],
            "left": round(width * box.x0, 2), "right": round(width * box.x1, 2),
            "top": round(height * (1 - box.y1), 2), "bottom": round(height * (1 - box.y0), 2),
            "x": [*ax.get_xlim()], "y": [*ax.get_ylim()], "logx": ax.get_xscale() == "log",
            "logy": ax.get_yscale() == "log", "label": ax.get_ylabel(), "unit": drawing.axes[-1].get_xlabel(),
        })  # fmt: skip
    return panels


def _is_curve(line: Any) -> bool:
    """Whether a line is a curve over x with a name, and no rule across the panel."""
    curve = line.get_transform() == line.axes.transData and len(np.atleast_1d(line.get_xdata())) > 1
    return curve and not str(line.get_label()).startswith("_")


def _themed(body: str, mark: str) -> str:
    """Colours as variables, coordinates to hundredths, ids that differ between the drawings of a page."""
    body = re.sub(r"<defs>\s*<style.*?</style>\s*</defs>", "", body, count=1, flags=re.DOTALL)
    for colour, variable in VARIABLES.items():
        body = body.replace(colour, variable)
    body = re.sub(r"<[^>]*>", lambda tag: re.sub(r"(\d+\.\d{2})\d+", r"\1", tag[0]), body)  # but not its letters
    body = re.sub(r"font: ([\d.]+)px [^;\"]*", r"font-size: \1px", body)
    body = body.replace("xlink:href", "href")
    used = set(re.findall(r"[\"(]#([^\")]+)", body))
    body = re.sub(r' id="([^"]*)"', lambda m: _id(m[1], mark, used), body)
    body = re.sub(r'([("])#([^")]+)', rf"\1#\2-{mark}", body)
    return re.sub(r"\s*\n\s*", " ", body)


def _id(name: str, mark: str, used: Collection[str]) -> str:
    """Only what a drawing refers to, and the lines that a pointer reads, keep an id."""
    return f' id="{name}-{mark}"' if name in used or name.startswith("line-") else ""
