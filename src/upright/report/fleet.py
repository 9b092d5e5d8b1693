"""Figures of fleets: maps over two axes in colour, their slices, and distributions."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from upright.fleet.fleet import Fleet
from upright.fleet.results import Summary, origin_of, summarise
from upright.report import svg
from upright.report.figure import Figure, Key, Panel, Trace
from upright.report.page import Cell, Page, Section, Table
from upright.report.svg import Scale

if TYPE_CHECKING:
    from xarray import Dataset

Array = NDArray[np.float64]

CIVIDIS = ("#00224e", "#123570", "#3b496c", "#575d6d", "#707173", "#8a8678", "#a59c74", "#c3b369", "#e1cc55", "#fee838")
"""Anchors from dark to light of a sequence that reads the same with and without red-green blindness, and in grey
(Nuñez, Anderton and Renslow 2018)."""

LEVELS = 10
"""Colours of a map: few enough to be told apart beside each other, and to be named at the bar."""

SIZE, LEFT, TOP, FOOT, BAR = 460, 72, 34, 60, 96
"""Sizes in the drawing's own units, as in `report.figure`."""


@dataclass(frozen=True, eq=False, kw_only=True)
class MapFigure:
    """`values` (nx, ny) in colour over `x` (nx,) and `y` (ny,), each increasing; NaN stays blank. The title states what
    it shows, `note` stands below. `levels` are the borders between colours (None: round ones round the values)."""

    title: str
    x: Array
    y: Array
    values: Array
    x_label: str
    y_label: str
    label: str
    levels: Sequence[float] | None = None
    note: str = ""

    def svg(self) -> str:
        """The drawing, with its title and a description."""
        x = Scale(*_edges(self.x), LEFT, LEFT + SIZE)
        y = Scale(*_edges(self.y), TOP + SIZE, TOP)
        borders = self.borders
        body = svg.label(self.y_label, 2, TOP - 10, class_="axis") + "".join(self._bands(x, y, borders))
        body += svg.element("rect", x=LEFT, y=TOP, width=SIZE, height=SIZE, class_="frame")
        body += _ticks(x, y) + svg.label(self.x_label, LEFT + SIZE, TOP + SIZE + FOOT - 6, "end", "axis")
        body += self._bar(borders)
        described = f"{self.label} in colour over {self.x_label} and {self.y_label}. {self.note}".strip()
        return _drawing(self.title, described, body, LEFT + SIZE + BAR, TOP + SIZE + FOOT)

    @property
    def borders(self) -> list[float]:
        """The borders between colours, from the least to the largest."""
        if self.levels is not None:
            return list(self.levels)
        low, high = svg.padded(self.values.reshape(-1), 0.0)
        return _borders(low, high)

    def key(self) -> list[Key]:
        """The colours are named at the bar."""
        return []

    def _bands(self, x: Scale, y: Scale, borders: list[float]) -> list[str]:
        """One path for each colour: cells of equal colour in a column are one rectangle."""
        across, up = x.many(_cells(self.x)), y.many(_cells(self.y))
        colour = np.clip(np.searchsorted(borders, self.values, side="right") - 1, 0, len(borders) - 2)
        colour = np.where(np.isfinite(self.values), colour, -1)
        parts: dict[int, list[str]] = {}
        for i, column in enumerate(colour):
            stops = [*np.flatnonzero(np.diff(column)).tolist(), len(column) - 1]
            start = 0
            for stop in stops:
                box = (across[i], up[stop + 1], across[i + 1] - across[i], up[start] - up[stop + 1])
                left, top, width, height = (svg.num(float(v)) for v in box)
                parts.setdefault(int(column[start]), []).append(f"M{left} {top}h{width}v{height}h-{width}z")
                start = stop + 1
        count = len(borders) - 1
        drawn = sorted(level for level in parts if level >= 0)
        return [
            svg.element("path", d="".join(parts[k]), fill=shade(k, count), stroke=shade(k, count), stroke_width=0.4)
            for k in drawn
        ]

    def _bar(self, borders: list[float]) -> str:
        """The key to the colours, at the right."""
        left, height = LEFT + SIZE + 18, SIZE / (len(borders) - 1)
        texts = svg.tick_texts(borders)
        parts = [svg.label(self.label, LEFT + SIZE + BAR, TOP - 10, "end", "axis")]
        for k in range(len(borders) - 1):
            top = TOP + SIZE - (k + 1) * height
            fill = shade(k, len(borders) - 1)
            parts.append(svg.element("rect", x=left, y=top, width=16, height=height, fill=fill))
        for k, text in enumerate(texts):
            parts.append(svg.label(text, left + 22, TOP + SIZE - k * height + 4.5))
        return "".join(parts)


def shade(level: int, count: int) -> str:
    """The colour of `level` among `count`, dark to light."""
    place = (len(CIVIDIS) - 1) * level / max(count - 1, 1)
    low = min(int(place), len(CIVIDIS) - 2)
    weight = place - low
    ends = [[int(text[i : i + 2], 16) for i in (1, 3, 5)] for text in CIVIDIS[low : low + 2]]
    return "#" + "".join(f"{round(a + weight * (b - a)):02x}" for a, b in zip(*ends, strict=True))


def push_map_figures(data: Dataset) -> list[Any]:
    """For each direction the map and, through its middle heights, its slices with the band."""
    figures: list[Any] = []
    for direction in data["direction"].values.tolist():
        part = data.sel(direction=direction)
        figures += [_map(part, direction), _slices(part, direction)]
    return figures


def _map(part: Any, direction: str) -> MapFigure:
    impulse: Array = part["impulse"].values
    lowest = _place(part, impulse, int(np.nanargmin(impulse)))
    title = f"Pushed {direction}, it survives at least {float(np.nanmin(impulse)):.3g} N s ({lowest})"
    high = float(np.nanquantile(impulse, 0.98))
    note = "The lightest colour includes all larger impulses." if float(np.nanmax(impulse)) > high else ""
    labels = {"x_label": "duration of the push [s]", "y_label": "height above the axle [m]"}
    borders = _borders(float(np.nanmin(impulse)), high)
    return MapFigure(
        title=title, x=part["duration"].values, y=part["height"].values, values=impulse.T, levels=borders, note=note,
        label="largest impulse survived [N s]", **labels,
    )  # fmt: skip


def _place(part: Any, impulse: Array, at: int) -> str:
    row, column = np.unravel_index(at, impulse.shape)
    height, duration = (float(part[name].values[k]) for name, k in (("height", row), ("duration", column)))
    return f"{height:.3g} m above the axle, within {duration:.2g} s"


def _slices(part: Any, direction: str) -> Figure:
    rows = np.unique(np.rint(np.array([0.25, 0.5, 1.0]) * (part.sizes["height"] - 1)).astype(int)).tolist()
    panels: list[Panel] = []
    for row in rows:
        traces = [Trace("nominal robot", part["duration"].values, part["impulse"].values[row])]
        if "low" in part:
            traces += [
                Trace(f"{text} of robots survive less", part["duration"].values, part[name].values[row])
                for name, text in (("low", "2.5 %"), ("high", "97.5 %"))
            ]
        panels.append(Panel(f"impulse survived at {float(part['height'].values[row]):.3g} m", "N s", traces))
    title = f"Pushed {direction}: largest impulse over the duration of the push"
    if "low" in part:
        width = float(np.nanmedian((part["high"].values - part["low"].values) / part["impulse"].values))
        title = f"Pushed {direction}: the band of 95 % is {100 * width:.2g} % of the impulse wide (median)"
    return Figure(title, panels, "duration of the push", "s")


def basin_figure(data: Dataset) -> MapFigure:
    """The fraction that recovers over two states."""
    recovered: Array = data["recovered"].values
    across, up = (str(name) for name in data["recovered"].dims)
    total = float(recovered.mean())
    names = [f"{name.replace('_', ' ')} [{data[name].attrs['unit']}]" for name in (across, up)]
    samples = len(np.unique(recovered)) > 2
    title = f"It recovers from {100 * total:.3g} % of these states" + (
        ", on average over the family" if samples else ""
    )
    levels = np.linspace(0, 1, LEVELS + 1).tolist() if samples else [0.0, 0.5, 1.0]
    label = "fraction that recovers [1]"
    return MapFigure(
        title=title, x=data[across].values, y=data[up].values, values=recovered, levels=levels,
        x_label=names[0], y_label=names[1], label=label,
    )  # fmt: skip


def histogram(data: Dataset, name: str, bins: int = 60) -> Figure:
    """How an outcome is distributed over the robots that stood."""
    stood = data["fell"].values == 0
    values: Array = data[name].values[stood]
    values = values[np.isfinite(values)]
    unit, words = str(data[name].attrs["unit"]), str(data[name].attrs["long_name"])
    counts, edges = np.histogram(values, bins) if len(values) else (np.zeros(1), np.array([0.0, 1.0]))
    fraction = np.append(counts, 0) / max(int(counts.sum()), 1)
    middle = float(np.median(values)) if len(values) else math.nan
    high = float(np.quantile(values, 0.95)) if len(values) else math.nan
    after = "" if unit == "1" else f" {unit}"
    title = f"{words[:1].upper()}{words[1:]}: half below {middle:.3g}{after}, 95 % below {high:.3g}{after}"
    return Figure(title, [Panel("fraction of robots", "1", [Trace(words, edges, fraction, step=True)])], words, unit)


def page_of(result: Fleet | Dataset) -> Page:
    """The page of a fleet, a push map or a basin, not yet written."""
    if isinstance(result, Fleet):
        return _fleet_page(result.data, result.summary)
    if "impulse" in result:
        return _push_map_page(result)
    if "recovered" in result:
        return _basin_page(result)
    return _fleet_page(result, summarise(result))


def _push_map_page(data: Dataset) -> Page:
    origin = origin_of(data)
    search, name = origin["push_map"], origin["robot"]["name"]
    lead = (
        f"The largest impulse after which the robot still stands {search['watch']:g} s later, within "
        f"{100 * search['tolerance']:g} %."
    )
    return _map_page(data, push_map_figures(data), f"Pushes that {name} survives", lead)


def _basin_page(data: Dataset) -> Page:
    origin = origin_of(data)
    title = f"States that {origin['robot']['name']} recovers from"
    return _map_page(data, [basin_figure(data)], title, f"Standing {origin['scenario']['seconds']:g} s later.")


def _fleet_page(data: Dataset, summary: Summary) -> Page:
    """Falls and quantiles of the robots, with the distribution of each outcome."""
    names = [name for name in summary.quantiles if np.isfinite(data[name].values).any()]
    rows: list[list[Cell]] = [
        [str(data[name].attrs["long_name"]), summary.units[name], *summary.quantiles[name]]
        for name in summary.quantiles
    ]
    table = Table(["robots that stood", "unit", "5 %", "median", "95 %"], rows, "Quantiles over the robots")
    chance = summary.chance
    lead = (
        f"{summary.fell} of {summary.n} robots fell: a probability of {chance.value:.3g}, with 95 % confidence between "
        f"{chance.low:.3g} and {chance.high:.3g} (Clopper and Pearson)."
    )
    figures = [histogram(data, name) for name in names]
    title = f"{summary.n} robots like {origin_of(data)['robot']['name']}"
    return Page(title, [Section("Numbers", [table]), Section("Distributions", figures)], lead, provenance(data), False)


def _map_page(data: Dataset, figures: Sequence[Any], title: str, lead: str) -> Page:
    return Page(title, [Section("Maps", list(figures))], lead, provenance(data), False)


def provenance(data: Dataset) -> dict[str, str]:
    """Robot, controller, seed and versions for a page's foot."""
    origin = origin_of(data)
    controller, versions = origin.get("controller", {}), origin.get("versions", {})
    facts = {
        "robot": str(origin.get("robot", {}).get("name", "")),
        "kit": str((origin.get("kit") or {}).get("name", "ideal")),
        "controller": f"{controller.get('kind', '')} {str(controller.get('hash', ''))[:12]}".strip(),
        "seed": str(origin.get("seed", "")),
        "versions": ", ".join(f"{name} {number}" for name, number in sorted(versions.items())),
    }
    return {name: text for name, text in facts.items() if text}


def _borders(low: float, high: float) -> list[float]:
    """Round numbers round [low, high], about `LEVELS` apart."""
    if not high > low:
        return [low, low + (abs(low) or 1.0)]
    inside = svg.nice_ticks(low, high, LEVELS)
    step = inside[1] - inside[0] if len(inside) > 1 else high - low
    first = [inside[0] - step] if inside[0] > low + 1e-9 * step else []
    last = [inside[-1] + step] if inside[-1] < high - 1e-9 * step else []
    return [*first, *inside, *last]


def _cells(values: Array) -> Array:
    """The borders (n + 1,) of the cells round n values: half way between neighbours."""
    if len(values) == 1:
        half = abs(values[0]) / 2 or 0.5
        return np.array([values[0] - half, values[0] + half])
    middle = (values[1:] + values[:-1]) / 2
    return np.concatenate([[2 * values[0] - middle[0]], middle, [2 * values[-1] - middle[-1]]])


def _edges(values: Array) -> tuple[float, float]:
    cells = _cells(values)
    return float(cells[0]), float(cells[-1])


def _ticks(x: Scale, y: Scale) -> str:
    parts: list[str] = []
    for scale, across in ((x, True), (y, False)):
        ticks = svg.nice_ticks(scale.low, scale.high, 6)
        for tick, text in zip(ticks, svg.tick_texts(ticks), strict=True):
            at = scale(tick)
            if across:
                parts.append(svg.element("line", x1=at, x2=at, y1=TOP + SIZE, y2=TOP + SIZE + 5, class_="frame"))
                parts.append(svg.label(text, at, TOP + SIZE + 23, "middle"))
            else:
                parts.append(svg.element("line", x1=LEFT - 5, x2=LEFT, y1=at, y2=at, class_="frame"))
                parts.append(svg.label(text, LEFT - 8, at + 4.5, "end"))
    return "".join(parts)


def _drawing(title: str, described: str, body: str, width: float, height: float) -> str:
    mark = hashlib.sha256((title + body).encode()).hexdigest()[:10]
    inside = svg.element("title", escape(title), id=f"t{mark}") + svg.element("desc", escape(described), id=f"d{mark}")
    names = {"xmlns": "http://www.w3.org/2000/svg", "role": "img", "aria_labelledby": f"t{mark} d{mark}"}
    return svg.element("svg", inside + body, viewBox=f"0 0 {svg.num(width)} {svg.num(height)}", class_="plane", **names)
