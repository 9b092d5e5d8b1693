"""Figures as inline SVG: lines over time, and points in the complex plane.

A figure draws what it is given and computes nothing but its axes. Colours are those of Okabe and Ito (2008) that
survive on paper; every trace also has its own dashes, every set of points its own marker, so that a print in black
and white can be read. The page's style sheet holds the colours for light, dark and paper.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape

import numpy as np
from numpy.typing import ArrayLike

from upright.errors import InvalidLog
from upright.report import svg
from upright.report.svg import Array, Scale

WIDTH, LEFT, RIGHT = 720, 72, 14
PANEL, HEAD, GAP, FOOT = 190, 34, 12, 60
"""Sizes in the drawing's own units; a phone shows them at about half, with larger letters (style.css)."""


@dataclass(frozen=True, eq=False)
class Trace:
    """A line through (x, y), shape (n,); `step` holds each value up to the next, as a command is held.

    `style` numbers its colour and dashes; by default the place of its name among the figure's names.
    """

    name: str
    x: Array
    y: Array
    step: bool = False
    style: int | None = None

    def __init__(self, name: str, x: ArrayLike, y: ArrayLike, *, step: bool = False, style: int | None = None) -> None:
        across, up = _column(x), _column(y)
        if across.shape != up.shape:
            raise InvalidLog(f"trace '{name}' has {across.size} x and {up.size} y", expected="as many of both")
        for key, value in {"name": name, "x": across, "y": up, "step": step, "style": style}.items():
            object.__setattr__(self, key, value)


@dataclass(frozen=True)
class Panel:
    """Traces on one pair of axes; `label` and `unit` are of y, `limits` cut what would dwarf the rest."""

    label: str
    unit: str
    traces: Sequence[Trace]
    limits: tuple[float, float] | None = None


@dataclass(frozen=True)
class Key:
    """One entry of a figure's key: its `name` and the drawing of its sample."""

    name: str
    sample: str


@dataclass(frozen=True)
class Figure:
    """Panels above each other over one x; `title` states what the figure shows.

    `spans` (start, stop) are shaded and named `span_name`, the times a push acts. `note` stands below.
    """

    title: str
    panels: Sequence[Panel]
    x_label: str = "time"
    x_unit: str = "s"
    spans: Sequence[tuple[float, float]] = ()
    span_name: str = "push acts"
    note: str = ""

    @property
    def names(self) -> list[str]:
        """The traces' names in order of appearance."""
        return list(dict.fromkeys(trace.name for panel in self.panels for trace in panel.traces))

    def svg(self) -> str:
        """The drawing, with its title and a description for those who cannot see it."""
        everything = np.concatenate([np.empty(0), *(trace.x for panel in self.panels for trace in panel.traces)])
        x = Scale(*svg.padded(everything, 0.0), LEFT, WIDTH - RIGHT)
        height = len(self.panels) * (HEAD + PANEL + GAP) - GAP + FOOT
        tops = [HEAD + row * (HEAD + PANEL + GAP) for row in range(len(self.panels))]
        body = "".join(self._panel(panel, x, top) for panel, top in zip(self.panels, tops, strict=True))
        bottom = height - FOOT
        data = {"data_from": f"{x.low:.6g}", "data_to": f"{x.high:.6g}", "data_unit": self.x_unit}
        data |= {"data_left": svg.num(x.start), "data_right": svg.num(x.stop)}
        body += _x_ticks(x, bottom) + svg.label(
            _named(self.x_label, self.x_unit), WIDTH - RIGHT, height - 6, "end", "axis"
        )
        return _drawing(self.title, self._described(), body, (WIDTH, height), data)

    def key(self) -> list[Key]:
        """What stands for what."""
        entries = [Key(name, _line_sample(self._style(name))) for name in self.names]
        return [*entries, Key(self.span_name, _span_sample())] if self.spans else entries

    def _described(self) -> str:
        axes = ", ".join(_named(panel.label, panel.unit) for panel in self.panels)
        return f"{axes} over {_named(self.x_label, self.x_unit)}: {', '.join(self.names)}. {self.note}".strip()

    def _style(self, name: str) -> int:
        asked = (trace.style for panel in self.panels for trace in panel.traces if trace.name == name)
        style = next(asked)
        return self.names.index(name) if style is None else style

    def _panel(self, panel: Panel, x: Scale, top: float) -> str:
        low, high = panel.limits or svg.padded(np.concatenate([np.empty(0), *(trace.y for trace in panel.traces)]))
        y = Scale(low, high, top + PANEL, top)
        parts = [svg.label(_named(panel.label, panel.unit), 2, top - 10, class_="axis")]
        parts += [_span(x, start, stop, top) for start, stop in self.spans]
        parts += [_grid(y), _frame(top)]
        lines = "".join(_line(trace, x, y, self._style(trace.name)) for trace in panel.traces)
        parts.append(_clipped(lines, top) if panel.limits else lines)
        if not any(np.isfinite(trace.y).any() for trace in panel.traces):
            parts.append(svg.label("no finite values", (LEFT + WIDTH) / 2, top + PANEL / 2, "middle"))
        data = {
            "data_low": f"{low:.6g}",
            "data_high": f"{high:.6g}",
            "data_unit": panel.unit,
            "data_label": panel.label,
        }
        return svg.element("g", "".join(parts), class_="panel", data_top=top, data_bottom=top + PANEL, **data)


@dataclass(frozen=True)
class PointSet:
    """Complex numbers under one name, such as the poles of a closed loop."""

    name: str
    values: Sequence[complex]
    style: int | None = None


@dataclass(frozen=True)
class PointFigure:
    """Points in the complex plane, both axes to one scale; `circle` draws the unit circle of a sampled system."""

    title: str
    sets: Sequence[PointSet]
    x_label: str = "real part"
    y_label: str = "imaginary part"
    unit: str = "1"
    circle: bool = True
    note: str = ""

    def svg(self) -> str:
        """The drawing, with its title and a description."""
        size = 460.0
        real, imaginary = self._ranges()
        x, y = Scale(*real, LEFT, LEFT + size), Scale(*imaginary, HEAD + size, HEAD)
        body = svg.label(_named(self.y_label, self.unit), 2, HEAD - 10, class_="axis")
        body += _grid(y, LEFT + size) + _x_ticks(x, HEAD + size, HEAD)
        body += svg.element("rect", x=LEFT, y=HEAD, width=size, height=size, class_="frame")
        if self.circle:
            body += svg.element("circle", cx=x(0), cy=y(0), r=x(1) - x(0), class_="unit")
        for index, points in enumerate(self.sets):
            body += _markers(points, x, y, index)
        body += svg.label(_named(self.x_label, self.unit), LEFT + size, HEAD + size + FOOT - 6, "end", "axis")
        described = f"{self.y_label} over {self.x_label}: {', '.join(p.name for p in self.sets)}. {self.note}".strip()
        return _drawing(self.title, described, body, (LEFT + size + RIGHT, HEAD + size + FOOT))

    def key(self) -> list[Key]:
        """What stands for what."""
        return [Key(points.name, _point_sample(points, index)) for index, points in enumerate(self.sets)]

    def _ranges(self) -> tuple[tuple[float, float], tuple[float, float]]:
        values = [complex(v) for points in self.sets for v in points.values] + ([1, -1, 1j, -1j] if self.circle else [])
        real = svg.padded(np.array([v.real for v in values]))
        imaginary = svg.padded(np.array([v.imag for v in values]))
        half = max(real[1] - real[0], imaginary[1] - imaginary[0]) / 2
        middle = (sum(real) / 2, sum(imaginary) / 2)
        return (middle[0] - half, middle[0] + half), (middle[1] - half, middle[1] + half)


def _column(values: ArrayLike) -> Array:
    column = np.array(values, dtype=np.float64).reshape(-1)
    column.setflags(write=False)
    return column


def _named(text: str, unit: str) -> str:
    return f"{text} [{unit}]" if unit else text


def _drawing(
    title: str, described: str, body: str, size: tuple[float, float], data: dict[str, str] | None = None
) -> str:
    mark = hashlib.sha256((title + body).encode()).hexdigest()[:10]  # ids must differ within a page and not by chance
    inside = svg.element("title", escape(title), id=f"t{mark}") + svg.element("desc", escape(described), id=f"d{mark}")
    return svg.element(
        "svg",
        inside + body,
        xmlns="http://www.w3.org/2000/svg",
        viewBox=f"0 0 {svg.num(size[0])} {svg.num(size[1])}",
        role="img",
        aria_labelledby=f"t{mark} d{mark}",
        class_="lines" if data else "plane",
        **(data or {}),
    )


def _grid(y: Scale, right: float = WIDTH - RIGHT) -> str:
    ticks = svg.nice_ticks(y.low, y.high, 6)
    parts: list[str] = []
    for tick, text in zip(ticks, svg.tick_texts(ticks), strict=True):
        class_ = "zero" if text == "0" else "grid"
        parts.append(svg.element("line", x1=LEFT, x2=right, y1=y(tick), y2=y(tick), class_=class_))
        parts.append(svg.label(text, LEFT - 8, y(tick) + 4.5, "end"))
    return "".join(parts)


def _x_ticks(x: Scale, bottom: float, top: float | None = None) -> str:
    ticks = svg.nice_ticks(x.low, x.high, 7)
    parts: list[str] = []
    for tick, text in zip(ticks, svg.tick_texts(ticks), strict=True):
        reach = bottom + 5 if top is None else top
        class_ = "frame" if top is None else "zero" if text == "0" else "grid"
        parts.append(svg.element("line", x1=x(tick), x2=x(tick), y1=bottom, y2=reach, class_=class_))
        parts.append(svg.label(text, x(tick), bottom + 23, "middle"))
    return "".join(parts)


def _frame(top: float) -> str:
    return svg.element("path", d=f"M{LEFT} {top}V{top + PANEL}H{WIDTH - RIGHT}", class_="frame")


def _span(x: Scale, start: float, stop: float, top: float) -> str:
    left, right = x(max(start, x.low)), x(min(stop, x.high))
    return svg.element("rect", x=left, y=top, width=max(right - left, 1.0), height=PANEL, class_="span")


def _clipped(lines: str, top: float) -> str:
    mark = f"c{hashlib.sha256((lines + svg.num(top)).encode()).hexdigest()[:10]}"
    window = svg.element("rect", x=LEFT, y=top, width=WIDTH - LEFT - RIGHT, height=PANEL)
    return svg.element("clipPath", window, id=mark) + svg.element("g", lines, clip_path=f"url(#{mark})")


def _line(trace: Trace, x: Scale, y: Scale, style: int) -> str:
    lines: list[str] = []
    for t, values in svg.finite_runs(trace.x, trace.y):
        kept_t, kept = svg.decimate(t, values, WIDTH - LEFT - RIGHT)
        corners = svg.stairs(kept_t, kept) if trace.step else (kept_t, kept)
        heights = np.clip(y.many(corners[1]), y.stop - PANEL, y.start + PANEL)  # beyond that it is out of sight
        lines.append(svg.element("polyline", points=svg.points(x.many(corners[0]), heights)))
    return svg.element("g", "".join(lines), class_=f"line {svg.style_class(style)}", data_name=trace.name)


def _markers(points: PointSet, x: Scale, y: Scale, index: int) -> str:
    style, shape = _point_style(points, index)
    finite = (complex(v) for v in points.values if np.isfinite(v))
    return "".join(svg.marker(shape, x(v.real), y(v.imag), style) for v in finite)


def _point_style(points: PointSet, index: int) -> tuple[str, str]:
    number = index if points.style is None else points.style
    return f"c{number % svg.COLOURS}", svg.MARKERS[number % len(svg.MARKERS)]


def _sample(inside: str) -> str:
    return svg.element("svg", inside, viewBox="0 0 34 14", aria_hidden="true", class_="sample")


def _line_sample(style: int) -> str:
    line = svg.element("polyline", points="0,7 34,7")
    return _sample(svg.element("g", line, class_=f"line {svg.style_class(style)}"))


def _span_sample() -> str:
    return _sample(svg.element("rect", x=4, y=1, width=26, height=12, class_="span"))


def _point_sample(points: PointSet, index: int) -> str:
    style, shape = _point_style(points, index)
    return _sample(svg.marker(shape, 17, 7, style))
