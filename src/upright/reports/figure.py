"""A figure by matplotlib as inline SVG: its colours are those of the page, its letters stay text, its key wraps.

The style sheet holds the colours for light, dark and paper. A phone gets a narrower
drawing.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from html import escape
from typing import Any

import numpy as np
from matplotlib import figure as mpl
from matplotlib.collections import LineCollection
from matplotlib.colors import to_hex
from matplotlib.container import BarContainer
from matplotlib.lines import Line2D

from upright import plotting
from upright.pages.drawing import PAPER, UNIT, VARIABLES, curves_of, strokes

NARROW = 4.0  # [inches] of a drawing for phones: its letters of 9 pt are 11 px high on a screen of 390 px
ABOVE = 0.14  # [inches] that a row is higher on a phone, for letters that stood right of it
LONG, ROW = 2.0, 0.46  # [inches] of names left of rows: longer ones stand above their rows on a phone, so high each
SCALE, SQUARE = 0.5, 3.0  # [inches]: a scale of colours is narrower, a plane or a map higher


@dataclass(frozen=True)
class Key:
    """One entry of a figure's key: its `name` and the drawing of its sample."""

    name: str
    sample: str


@dataclass(frozen=True, eq=False)
class Figure:
    """A `drawing` by `upright.plotting` under a `title` that states what it shows; a `note` stands below."""

    title: str
    drawing: mpl.Figure
    note: str = ""

    def svg(self) -> str:
        """The drawing, with its title and a description for those who cannot see it."""
        return self._svg("wide" if self.drawing.axes else "any")

    def narrow(self) -> str:
        """The same for a phone, less wide, with letters of the same size; empty where nothing is drawn."""
        if not self.drawing.axes:
            return ""
        with _narrowed(self.drawing) if self._has_axes() else _stacked(self.drawing):
            return self._svg("narrow")

    def _has_axes(self) -> bool:
        return any(ax.axison for ax in self.drawing.axes)

    def _svg(self, size: str) -> str:
        for ax in self.drawing.axes:
            legend = ax.get_legend()
            if legend:
                legend.remove()
        curves = curves_of(self.drawing)
        mark = hashlib.sha256(f"{self.title} {size}".encode()).hexdigest()[:8]
        width, height = (UNIT * inches for inches in self.drawing.get_size_inches())
        described = f"{', '.join(axis_labels(self.drawing))}: {', '.join(k.name for k in self.key())}. {self.note}"
        part = f'style="max-width: {min(100 * width / UNIT / plotting.WIDTH, 100):.0f}%"' if size != "narrow" else ""
        kind = f'class="{size} lines" data-curves="{escape(json.dumps(curves))}"' if curves else f'class="{size} plane"'
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" role="img" '
            f'viewBox="0 0 {width:g} {height:g}" aria-labelledby="t{mark} d{mark}" {part} {kind}>'
            f'<title id="t{mark}">{escape(self.title)}</title><desc id="d{mark}">{escape(described.strip())}</desc>'
            f"{strokes(self.drawing, mark)}</svg>"
        )

    def key(self) -> list[Key]:
        """What stands for what, where a drawing has more than one name; a panel's label names its only line."""
        entries: dict[str, str] = {}
        for ax in self.drawing.axes:
            handles, names = ax.get_legend_handles_labels()
            lines = [name for handle, name in zip(handles, names, strict=True) if isinstance(handle, Line2D)]
            named = lines[0] if len(lines) == 1 and ax.get_ylabel().startswith(f"{lines[0]} ") else None
            for handle, name in zip(handles, names, strict=True):
                if name != named:
                    entries.setdefault(str(name), _sample(handle))
        return [Key(name, sample) for name, sample in entries.items()] if len(entries) > 1 else []


@contextmanager
def _narrowed(drawing: mpl.Figure) -> Generator[None]:
    """The same drawing for a phone, `NARROW` inches wide: its letters keep their size, its panels lose width.

    What is as high as wide loses height too, a scale of colours only moves, letters right of a row stand below its
    name, and long names left of a row above it.
    """
    width, height = drawing.get_size_inches()
    less = max(width - NARROW, 0.0)
    boxes = {ax: ax.get_position() for ax in drawing.axes}
    labels = {ax: ax.yaxis.label.get_position() for ax in drawing.axes}
    beside: list[Any] = [text for ax in drawing.axes for text in ax.texts if text.get_gid() == plotting.BESIDE]
    square = any(
        box.height * height > SQUARE and abs(box.height * height - box.width * width) < 0.2 for box in boxes.values()
    )
    named = [] if beside else [ax for ax in boxes if ax.get_gid() == plotting.ROWS and boxes[ax].x0 * width > LONG]
    rows = {ax: len(ax.get_yticks()) for ax in named}
    lower = less if square else -ABOVE * len(beside)
    lower -= sum(max(ROW * n - boxes[ax].height * height, 0.0) for ax, n in rows.items())
    drawing.set_size_inches(width - less, height - lower)
    places = [(text.xy, text.xyann, text.get_va(), text.get_ha()) for text in beside]
    for text in beside:  # below the name of its row
        text.xy, text.xyann = (0, text.xy[1]), (-4, -6)
        text.set(va="top", ha="right")
    for ax, box in boxes.items():
        across = less if box.width * width > SCALE else 0.0
        left = box.x0 * width - (less - across)
        if ax in rows:
            across = across - (left - plotting.RIGHT)
            left = plotting.RIGHT
        if any(text.axes is ax for text in beside):
            across -= (1 - box.x1) * width - plotting.RIGHT
        inside = (box.width * width - across, box.height * height - lower)
        ax.set_position((
            left / (width - less), box.y0 * height / (height - lower), inside[0] / (width - less),
            inside[1] / (height - lower),
        ))  # fmt: skip
        x, y = labels[ax]
        x = x * box.width * width + (box.x0 * width - left if ax in rows else 0.0)
        ax.yaxis.set_label_coords(x / inside[0], 1 + (y - 1) * box.height * height / inside[1])
    above = {ax: _names_above(ax) for ax in rows}
    yield
    for ax, names in above.items():
        for name in names:
            name.remove()
        ax.tick_params(axis="y", labelleft=True)
    for text, (xy, offset, up, across) in zip(beside, places, strict=True):
        text.xy, text.xyann = xy, offset
        text.set(va=up, ha=across)
    drawing.set_size_inches(width, height)
    for ax, box in boxes.items():
        ax.set_position(box)
        ax.yaxis.set_label_coords(*labels[ax])


def _names_above(ax: Any) -> list[Any]:
    """The names of the rows, each between its own row and the one before instead of left of it."""
    ax.tick_params(axis="y", labelleft=False)
    across = ax.get_yaxis_transform()
    names = ax.yaxis.get_major_formatter().format_ticks(ax.get_yticks())
    return [
        ax.annotate(
            name,
            (0, row - 0.49),
            (3, 0),
            xycoords=across,
            textcoords="offset points",
            va="center",
            bbox={"facecolor": PAPER, "edgecolor": "none", "pad": 0.5},
        )
        for row, name in zip(ax.get_yticks(), names, strict=True)
    ]


@contextmanager
def _stacked(drawing: mpl.Figure) -> Generator[None]:
    """Drawings without axes that stand in a row, below each other for a phone: two in a row, or one where they are
    two."""
    width, height = drawing.get_size_inches()
    boxes = [ax.get_position() for ax in drawing.axes]
    columns = 2 if len(boxes) > 2 else 1
    rows = -(-len(boxes) // columns)
    drawing.set_size_inches(NARROW, rows * height)
    for k, (ax, box) in enumerate(zip(drawing.axes, boxes, strict=True)):
        row, column = divmod(k, columns)
        ax.set_position((column / columns, (rows - 1 - row + box.y0) / rows, 1 / columns, box.height / rows))
    yield
    drawing.set_size_inches(width, height)
    for ax, box in zip(drawing.axes, boxes, strict=True):
        ax.set_position(box)


def axis_labels(drawing: mpl.Figure) -> list[str]:
    """What the axes say."""
    return [text for ax in drawing.axes for text in (ax.get_ylabel(), ax.get_xlabel()) if text]


def _sample(handle: Any) -> str:
    """A sample of a line, a set of points or a shaded span."""
    if isinstance(handle, Line2D):
        dashes = getattr(handle, "_unscaled_dash_pattern", (0, None))[1]
        array = f' stroke-dasharray="{" ".join(f"{d:g}" for d in dashes)}"' if dashes else ""
        colour = VARIABLES.get(str(handle.get_color()), str(handle.get_color()))
        wide = handle.get_linewidth() > THICK
        style = (
            f' style="stroke-width: {2 * handle.get_linewidth():g}; opacity: {handle.get_alpha() or 1:g}"'
            if wide
            else ""
        )
        inside = f'<path d="M0 7H34"{array}{style}/>' if handle.get_linestyle() not in ("None", "") else ""
        filled = handle.get_fillstyle() != "none" and handle.get_marker() in FILLED
        mark = _MARKS.get(str(handle.get_marker()), "")
        inside += f'<g style="fill: {colour}">{mark}</g>' if filled and mark else mark
        content = f'<g style="stroke: {colour}; color: {colour}">{inside}</g>'
    elif isinstance(handle, LineCollection):
        colour = to_hex(np.atleast_2d(handle.get_edgecolor())[0])
        content = f'<path d="M0 7H34" style="stroke: {VARIABLES.get(colour, colour)}; stroke-width: 3"/>'
    elif getattr(handle, "fill", True) is False:
        colour = to_hex(handle.get_edgecolor())
        content = f'<path d="M0 7H34" stroke-dasharray="2 3" style="stroke: {VARIABLES.get(colour, colour)}"/>'
    else:
        patch = handle.patches[0] if isinstance(handle, BarContainer) else handle
        colour = to_hex(np.atleast_2d(patch.get_facecolor())[0])
        alpha = patch.get_alpha() or 1
        shade = VARIABLES.get(colour, colour)
        content = f'<path d="M4 1H30V13H4Z" style="fill: {shade}; fill-opacity: {alpha:g}; stroke: none"/>'
    return f'<svg viewBox="0 0 34 14" aria-hidden="true" class="sample">{content}</svg>'


THICK = 3.0  # [points] of a line that is drawn as a band
FILLED = ("o", "s", "^", "D")

_MARKS = {
    "x": '<path d="M13 3L21 11M13 11L21 3"/>', "o": '<circle cx="17" cy="7" r="4"/>',
    "s": '<path d="M13 3H21V11H13Z"/>', "^": '<path d="M17 2L22 11H12Z"/>', "D": '<path d="M17 2L22 7L17 12L12 7Z"/>',
    "|": '<path d="M17 2V12"/>',
}  # fmt: skip
