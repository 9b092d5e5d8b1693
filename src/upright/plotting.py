"""Figures by matplotlib, the same on pages and in notebooks: every axis is named by its quantity and unit.

Colours are those of Okabe and Ito (2008) that survive on paper. Each line also has its own dashes and each set of
points its own marker, so that a print in black and white can be read. Fonts and sizes are given here, and not by the
user's matplotlibrc, so that a page is the same bytes everywhere.
"""

from __future__ import annotations

import functools
import math
import textwrap
from collections.abc import Callable, Generator, Iterable, Sequence
from contextlib import contextmanager
from contextvars import ContextVar
from io import BytesIO
from typing import Any, ParamSpec, TypeVar

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure
from matplotlib.patches import Circle
from matplotlib.ticker import MaxNLocator
from numpy.typing import ArrayLike

from upright.arrays import Array, Complex
from upright.decimate import decimate
from upright.errors import InvalidLog
from upright.languages import number, translated
from upright.ticks import AxisNumbers, numbered

P = ParamSpec("P")
T = TypeVar("T")

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#b8609a", "#1d2126", "#b87e00")
DASHES: tuple[Any, ...] = (
    "-", (0, (8, 3)), (0, (2, 2.5)), (0, (9, 3, 2, 3)), (0, (4, 3)), (0, (14, 4)), (0, (9, 3, 2, 3, 2, 3)),
)  # fmt: skip
MARKERS = ("x", "o", "s", "^", "D")
SMALL = 7.5  # [pt]
MAP = "viridis"  # grows lighter evenly, also for the colour-blind
INK, AXIS, GRID, SPAN = "#5b6570", "#6b757f", "#e6e9ec", "#e69f00"

STYLE: dict[str, Any] = {
    "font.family": ["DejaVu Sans"], "font.size": 9.0, "axes.titlesize": 9.0, "axes.labelsize": 9.0,
    "text.color": INK, "axes.labelcolor": "#1d2126", "axes.titlecolor": "#1d2126", "axes.edgecolor": AXIS,
    "xtick.color": AXIS, "ytick.color": AXIS, "xtick.labelcolor": INK, "ytick.labelcolor": INK,
    "axes.grid": True, "axes.axisbelow": True, "grid.color": GRID, "grid.linewidth": 0.8, "legend.columnspacing": 1.0,
    "axes.linewidth": 0.8, "axes.spines.top": False, "axes.spines.right": False, "lines.linewidth": 1.4,
    "legend.fontsize": 9.0, "legend.framealpha": 0.8, "path.simplify": False, "figure.dpi": 100.0,
    "axes.titlelocation": "left", "axes.titlepad": 8.0, "image.cmap": MAP, "axes.unicode_minus": True,
}  # fmt: skip

WIDTH, LEFT, RIGHT = 7.2, 0.75, 0.15  # [inches], as what follows
PHONE = 4.0  # its letters of 9 pt are 11 px high on a screen of 390 px
PANEL, HEAD, FOOT = 1.85, 0.42, 0.55
TITLES = 0.4  # above a drawing without axes: two lines
LETTER = 0.075  # [inch] of width
KEY = 0.4  # [inch] of a line in a legend with its gaps
SCREEN, LEAST = 4.7, 0.7  # [inches] of all panels that a screen shows below a title, and of one panel at least
CIRCLE = "unit circle: inside it a motion fades"
BELOW: dict[str, Any] = {"linewidth": 4.0, "alpha": 0.35}
ROWS = "rows"  # id of axes with a row for each name
CLOUD = 500  # points: so many are a picture on a page, not each an element of it
MANY = 12  # rows of names: more are closer together
NARROWEST = 0.01  # of the x that is shown: the width of a shaded interval at least, 3 pixels on a phone
COLUMNS = 1000  # of a line that is thinned: two for each column of pixels at the width of a page


def styled(draw: Callable[P, T]) -> Callable[P, T]:
    """Draw in our style, whatever the user's matplotlibrc says."""

    @functools.wraps(draw)
    def inside(*args: P.args, **kwargs: P.kwargs) -> T:
        with matplotlib.rc_context():
            matplotlib.rcdefaults()
            matplotlib.rcParams.update(STYLE)  # pyright: ignore[reportArgumentType, reportCallIssue]
            return draw(*args, **kwargs)

    return inside


_across: ContextVar[float] = ContextVar("across", default=WIDTH)


@contextmanager
def drawn_for_a_phone() -> Generator[None]:
    """Figures that the block draws are as wide as a phone, with letters of the same size."""
    before = _across.set(PHONE)
    try:
        yield
    finally:
        _across.reset(before)


@styled
def panels(
    labels: Sequence[str], x_label: str = "time [s]", x_scale: str = "linear", height: float | None = None,
    weights: Sequence[float] = (),
) -> tuple[Figure, list[Axes]]:  # fmt: skip
    """Empty panels above each other over one x, "linear" or "log"; `labels` name their y, `height` [inch] × weight."""
    height = height or min(PANEL, max((SCREEN - FOOT) / len(labels) - HEAD, LEAST))
    heights = [height * weight for weight in weights or [1.0] * len(labels)]
    bottom = total = len(labels) * HEAD + sum(heights) + FOOT
    across = _across.get()
    figure, axes = _Picture(figsize=(across, total)), list[Axes]()
    for label, high in zip(labels, heights, strict=True):
        bottom -= HEAD + high
        sharex = axes[0] if axes else None
        axes.append(_axes(figure, LEFT, bottom, across - LEFT - RIGHT, high, label, sharex))
        axes[-1].set(xscale=x_scale)
        numbered(axes[-1].xaxis, axes[-1].yaxis)
    for ax in axes[:-1]:
        ax.tick_params(labelbottom=False)
    axes[-1].set_xlabel(translated(x_label), loc="right")
    return figure, axes


@styled
def line(
    ax: Axes, name: str, x: ArrayLike, y: ArrayLike, *,
    step: bool = False, style: int | None = None, solid: bool = False, below: bool = False,
) -> None:  # fmt: skip
    """A line through (x, y), shape (n,), under a `name`; a gap where they are not finite.

    `step` holds each value up to the next, as a command is held. `style` numbers its colour and dashes; by default the
    place of its name among the figure's names. `solid` draws no dashes, where one line stands alone or leads; `below`
    draws it wide and pale, for another line on top. Many samples are thinned so that the line looks the same.
    """
    across, up = (np.asarray(values, dtype=np.float64).ravel() for values in (x, y))
    if across.shape != up.shape:
        raise InvalidLog(f"line '{name}' has {across.size} x and {up.size} y", expected="as many of both")
    good = np.isfinite(across) & np.isfinite(up)
    ends = np.flatnonzero(np.diff(good, prepend=False, append=False))  # of stretches of finite values
    runs = [decimate(across[a:b], up[a:b], COLUMNS) for a, b in ends.reshape(-1, 2)]
    gap = np.array([np.nan])
    across, up = (np.concatenate([part for run in runs for part in (run[k], gap)][:-1] or [gap]) for k in (0, 1))
    names = _names(ax)
    name = translated(name)
    place = style if style is not None else names.index(name) if name in names else len(names)
    ax.plot(
        across, up, label=name, drawstyle="steps-post" if step else "default", color=COLOURS[place % len(COLOURS)],
        linestyle="-" if solid or below else DASHES[place % len(DASHES)], **(BELOW if below else {}),
    )  # fmt: skip


@styled
def span(axes: Sequence[Axes], start: float, stop: float, name: str, colour: str = SPAN) -> None:
    """Shade [start, stop] of x in all `axes`."""
    for ax in axes:
        ax.axvspan(start, stop, color=colour, alpha=0.22 if colour == SPAN else 0.12, linewidth=0, zorder=0,
                   label=translated(name))  # fmt: skip


@styled
def shade(
    axes: Sequence[Axes], name: str, intervals: Iterable[tuple[float, float]], shown: tuple[float, float]
) -> None:
    """Shade intervals of x in all `axes`, within the first and last x `shown`; a short one wide enough to be seen."""
    first, last = shown
    for start, stop in intervals:
        span(axes, start, max(min(stop, last), start + NARROWEST * (last - first)), name)


@styled
def plane(*, circle: bool = False) -> tuple[Figure, Axes]:
    """The empty complex plane; `circle` draws the unit circle of a sampled system."""
    side = min(4.6, _across.get() - LEFT - RIGHT)
    figure = _Picture(figsize=(LEFT + side + RIGHT, HEAD + side + FOOT))
    ax = _axes(figure, LEFT, FOOT, side, side, translated("imaginary part [1]"))
    ax.set_xlabel(translated("real part [1]"), loc="right")
    ax.set_aspect("equal", adjustable="datalim")
    numbered(ax.xaxis, ax.yaxis)
    if circle:
        ax.add_patch(Circle((0, 0), 1, fill=False, edgecolor=AXIS, linestyle=(0, (2, 3)), label=translated(CIRCLE)))
    return figure, ax


@styled
def points(ax: Axes, name: str, values: Sequence[complex], style: int | None = None, size: float = 7.0) -> None:
    """Complex numbers under one name, such as the poles of a closed loop; what is not finite is left out."""
    place = len(_names(ax)) if style is None else style
    z: Complex = np.asarray(values, dtype=np.complex128).ravel()
    z = z[np.isfinite(z)]
    ax.plot(
        z.real, z.imag, label=translated(name), linestyle="", marker=MARKERS[place % len(MARKERS)], fillstyle="none",
        markersize=size, color=COLOURS[place % len(COLOURS)], rasterized=z.size > CLOUD,
    )  # fmt: skip


@styled
def nyquist(response: ArrayLike, distance: float) -> Figure:
    """L(jω) and its mirror image, an arrow towards rising ω, and the circle of radius `distance` that touches them."""
    L: Complex = np.asarray(response, dtype=np.complex128)
    reach = max(1.0, 1.35 * distance)
    real, imaginary = np.where(np.abs(L + 1) < 4 * reach, [L.real, L.imag], np.nan)
    figure, ax = plane()
    ax.plot(real, imaginary, color=COLOURS[0], linestyle="-", label=translated("loop gain L(jω)"))
    ax.plot(real, -imaginary, color=COLOURS[0], linestyle=DASHES[2], label=translated("negative frequencies"))
    ax.add_patch(
        Circle((-1, 0), distance, facecolor=COLOURS[1], alpha=0.3, linewidth=0, label=translated("distance 1 / Ms"))
    )
    ax.plot([-1], [0], linestyle="", marker="x", markersize=8, color=COLOURS[1], label="−1")
    touch = L[np.argmin(np.abs(L + 1))]
    ax.plot(touch.real, touch.imag, "o", markersize=5, color=COLOURS[4], label=translated("nearest to −1"))
    inside = np.flatnonzero((np.abs(L + 1) < reach)[:-1])
    if len(inside):
        at = inside[np.argmax(np.abs(L[inside] - touch))]
        start, end = ((float(z.real), float(z.imag)) for z in L[at : at + 2])
        ax.annotate("", end, start, arrowprops={"arrowstyle": "-|>", "color": COLOURS[0], "mutation_scale": 16})
    ax.set(xlim=(-1 - 1.15 * reach, -1 + 1.35 * reach), ylim=(-1.25 * reach, 1.25 * reach))
    return legend(figure)


@styled
def bars(
    names: Sequence[str], values: ArrayLike, x_label: str, y_label: str, *, limit: float = np.nan, digits: int = 3
) -> Figure:
    """One bar for each name, with its number beside it; NaN has a dash and no bar. A `limit` is a dashed line."""
    lengths = np.asarray(values, dtype=np.float64)
    figure, ax = rows_of(names, x_label, y_label)
    ax.barh(np.arange(len(names)), np.nan_to_num(lengths), height=0.6, color=COLOURS[0])
    for row, value in enumerate(lengths.tolist()):
        text = number(value, digits) if np.isfinite(value) else "–"
        ax.annotate(text, (value if np.isfinite(value) else 0.0, row), (4, 0), textcoords="offset points", va="center")
    ax.set_xlim(0, 1.12 * (float(np.nanmax([*lengths, limit, 0.0])) or 1.0))
    ax.axvline(limit, linestyle="--", linewidth=1, color=AXIS)
    if np.isfinite(limit):
        ax.annotate(translated("limit"), (limit, -0.6), (0, 3), textcoords="offset points", ha="center")
    return figure


@styled
def intervals(names: Sequence[str], values: ArrayLike, ends: ArrayLike, x_label: str, y_label: str) -> Figure:
    """`values` (n,) with their intervals `ends` (n, 2), one row for each name; an end that is NaN is not drawn."""
    low, high = np.asarray(ends, dtype=np.float64).reshape(-1, 2).T
    rows = np.arange(len(names))
    figure, ax = rows_of(names, x_label, y_label)
    ax.hlines(rows, low, high, linewidth=2.5, color=COLOURS[0], label=translated("95 % interval"))
    ax.plot(
        np.asarray(values, dtype=np.float64), rows, "o", markersize=4.5, color=COLOURS[0], label=translated("estimate")
    )
    return figure


@styled
def rows_of(names: Sequence[str], x_label: str, y_label: str) -> tuple[Figure, Axes]:
    """An empty figure with one row for each name, the first on top."""
    across = _across.get()
    texts = list(names)
    left = min(0.4 * across, 0.4 + LETTER * max(map(len, texts), default=0))
    if across < WIDTH:  # a phone breaks long names
        texts = [textwrap.fill(text, round((left - 0.1) / LETTER)) for text in texts]
    lines = max((text.count("\n") for text in texts), default=0)  # more than one for each name
    height = max(len(names), 2) * ((0.24 if len(names) <= MANY else 0.2) + 0.14 * lines)
    figure = _Picture(figsize=(across, HEAD + height + FOOT))
    ax = _axes(figure, left, FOOT, across - left - RIGHT, height, y_label)
    ax.set(yticks=range(len(names)), yticklabels=texts, ylim=(len(names) - 0.4, -0.6), gid=ROWS)
    ax.set_xlabel(x_label, loc="right")
    ax.grid(visible=False, axis="y")
    ax.tick_params(axis="y", length=0)
    numbered(ax.xaxis)
    return figure, ax


@styled
def colour_map(
    x: Array, y: Array, values: Array, *, x_label: str, y_label: str, levels: Sequence[float], label: str = "",
) -> Figure:  # fmt: skip
    """`values` (nx, ny) in colour over `x` (nx,) and `y` (ny,), each increasing; `levels` are the borders between
    colours, and NaN stays blank. Their scale stands beside under a `label`; without one there are two colours."""
    height = 2.7
    bar = 1.1 if label else RIGHT
    side = min(5.7, _across.get() - LEFT) - bar
    figure = _Picture(figsize=(LEFT + side + bar, HEAD + height + FOOT))
    ax = _axes(figure, LEFT, FOOT, side, height, y_label)
    colours = matplotlib.colormaps[MAP] if label else ListedColormap([GRID, COLOURS[2]])
    shown = np.ma.masked_invalid(np.clip(values.T, levels[0], np.nextafter(levels[-1], -np.inf)))
    picture = ax.contourf(x, y, shown, levels=levels, cmap=colours, norm=BoundaryNorm(levels, colours.N))
    ax.set(xlim=(x[0], x[-1]), ylim=(y[0], y[-1]))
    ax.set_xlabel(x_label, loc="right")
    ax.grid(visible=False)
    ax.spines[:].set_visible(True)
    numbered(ax.xaxis, ax.yaxis)
    if label:
        beside = _axes(figure, LEFT + side + 0.2, FOOT, 0.18, height)
        key = figure.colorbar(picture, cax=beside, ticks=levels)
        key.outline.set_visible(False)
        beside.set_title(label, loc="right", x=1.0 + 0.7 / 0.18)
        beside.yaxis.set_major_formatter(AxisNumbers())
    return figure


@styled
def empty(count: int, height: float, least: float = 0.0) -> tuple[Figure, list[Axes]]:
    """A figure of `count` drawings without axes, to one scale across and up, each `height` [inch] high. They stand
    beside each other, as many as are `least` [inch] wide."""
    across = _across.get()
    beside = max(1, min(count, int(across / least))) if least else count
    each = height + TITLES
    rows = math.ceil(count / beside)
    figure = _Picture(figsize=(across, rows * each))
    width = across / beside
    places = [(k % beside * width, (rows - 1 - k // beside) * each) for k in range(count)]
    axes = [_axes(figure, *place, width, height) for place in places]
    for ax in axes:
        ax.set_aspect("equal", adjustable="box")
        ax.set_axis_off()
    return figure, axes


def round_levels(low: float, high: float, count: int) -> list[float]:
    """At most `count` + 1 round numbers from just below `low` to just above `high`."""
    high = high if high > low else low + (abs(low) or 1.0)
    return list(MaxNLocator(count, steps=[1, 2, 5, 10]).tick_values(low, high))


@styled
def legend(figure: Figure) -> Figure:
    """The same figure with the names of its lines, by the first panel that has each: above it or at the figure's foot,
    where they have room beside the name of y or of x, else inside. A label may name one."""
    known: set[str] = set()
    for ax in figure.axes:
        handles, labels = ax.get_legend_handles_labels()
        named = dict(zip(labels, handles, strict=True))
        alone = len(named) == 1 and ax.get_ylabel().startswith(f"{labels[0]} ")
        if named.keys() - known and len(named.keys() | known) > 1 and not alone:
            ax.legend([*named.values()], [*named], **_place_of_legend(figure, ax, [*named], first=not known))
        known |= named.keys()
    return figure


def _place_of_legend(figure: Figure, ax: Axes, names: Sequence[str], *, first: bool) -> dict[str, Any]:
    above = {"loc": "lower right", "bbox_to_anchor": (1, 1)}
    foot = {"loc": "lower left", "bbox_to_anchor": (0, 0), "bbox_transform": figure.transFigure}
    row = {"ncols": len(names), "frameon": False, "borderaxespad": 0.2, "handlelength": 1.4}
    across = figure.get_figwidth()
    needed = LETTER * len("".join(names)) + KEY * len(names)
    if needed + LETTER * len(ax.get_ylabel()) < across * ax.get_position().width:
        return above | row
    if first and needed + LETTER * len(figure.axes[-1].get_xlabel()) < across:
        return foot | row
    return above | row | {"ncols": 3} if ax.get_gid() == ROWS else {}


@styled
class _Picture(Figure):
    """A figure that a notebook shows by itself: only figures of pyplot have a backend there."""

    @styled
    def _repr_png_(self) -> tuple[bytes, dict[str, int]]:
        """The picture for screens of twice as many dots, and the size [px] to show it at."""
        picture = BytesIO()
        self.savefig(picture, format="png", dpi=2 * self.dpi)
        width, height = self.get_size_inches() * self.dpi
        return picture.getvalue(), {"width": round(width), "height": round(height)}


@styled
def _axes(
    figure: Figure, left: float, bottom: float, width: float, height: float, y_label: str = "",
    sharex: Axes | None = None,
) -> Axes:  # fmt: skip
    """Axes at a place of the figure [inch]. The name of y is above its axis: no head has to be turned to read it."""
    across, up = figure.get_size_inches()
    ax = figure.add_axes((left / across, bottom / up, width / across, height / up), sharex=sharex)
    ax.set_ylabel(y_label, rotation=0, ha="left", va="bottom")
    ax.yaxis.set_label_coords((0.02 - left) / width, 1.0 + 0.1 / height)
    return ax


def _names(panel: Axes) -> list[str]:
    """The names drawn so far in the figure of a panel, each once, but for those of shaded spans."""
    lines = (line.get_label() for ax in panel.figure.axes for line in ax.lines)
    return list(dict.fromkeys(str(name) for name in lines if not str(name).startswith("_")))
