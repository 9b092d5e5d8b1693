"""The page of a push map: the limit over height and duration in colour, and its slices."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array
from upright.certification.recovery import KNOCK_DURATION, largest_knock
from upright.fleets.results import origin_of
from upright.plotting import colour_map, legend, line, number, panels, round_levels
from upright.reports.figure import Figure
from upright.reports.knocks import certificate_knocks, robot_of
from upright.reports.page import Page, Section, Verdict, cell_text
from upright.reports.spreads import provenance
from upright.robots import Kit, Robot
from upright.tables import least

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from xarray import Dataset


LEVELS = 10
"""Colours of a map: few enough to be distinguished side by side, and to be named at the bar."""


def push_map_figures(data: Dataset) -> list[Figure]:
    """For each direction the map and, through its middle heights, its slices with the band."""
    figures: list[Figure] = []
    ways = data["direction"].values.tolist()
    for k, direction in enumerate(ways):
        part = data.sel(direction=direction)
        if not k or _apart(data, direction) > ALIKE:
            figures += [_map(part, direction), _slices(part, direction)]
    return figures


ALIKE = 0.1  # of a limit: from another direction a map that differs by no more everywhere is not drawn again


def _apart(data: Dataset, direction: str) -> float:
    """By which part of its limit a direction differs most from the first one."""
    first, other = (data["impulse"].sel(direction=way).values for way in (data["direction"].values[0], direction))
    return float(np.nanmax(np.abs(other / first - 1)))


def _alike(data: Dataset) -> list[str]:
    """A sentence on the directions that are not drawn, since they are like the first."""
    first, *others = data["direction"].values.tolist()
    return [f"Pushed {way} the limits are within {100 * part:.2g} % of those {first}, so they are not drawn again."
            for way in others if (part := _apart(data, way)) <= ALIKE]  # fmt: skip


def _map(part: Any, direction: str) -> Figure:
    impulse: Array = part["impulse"].values
    low = float(np.nanmin(impulse))
    high = float(np.nanquantile(impulse, 0.98))
    row, column = np.unravel_index(int(np.nanargmin(impulse)), impulse.shape)
    height, duration = float(part["height"].values[row]), float(part["duration"].values[column])
    title = f"The largest push {direction} that it survives: short pushes high up are worst"
    if row < impulse.shape[0] - 1 or column > impulse.shape[1] / 4:
        title = f"The largest push {direction} that it survives is {low:.2g} N s at the worst place, more elsewhere"
    note = "Numbers on the lines: the largest impulse [N s] that it survives."
    note += " The lightest colour includes all larger ones." if float(np.nanmax(impulse)) > high else ""
    apart = float(part["island"].values.mean())
    if apart:
        note += f" At {100 * apart:.2g} % of the points a larger push is survived again; the first border is drawn."
    drawing = colour_map(
        part["duration"].values, part["height"].values, impulse.T, x_label="duration of the push [s]",
        y_label="height above the axle [m]", label="impulse [N s]", levels=_levels(low, high), smooth=True,
    )  # fmt: skip
    _numbered(drawing.axes[0], part, _levels(low, high))
    drawing.axes[0].plot(
        duration, height, "o", color="white", markeredgecolor="black", markersize=9, clip_on=False, zorder=5
    )
    inwards = [
        (-1 if part[name].values.mean() < at else 1) for name, at in (("duration", duration), ("height", height))
    ]
    drawing.axes[0].annotate(
        "weakest", (duration, height), (28 * inwards[0], 24 * inwards[1]), textcoords="offset points", color="white",
        ha="left" if inwards[0] > 0 else "right", arrowprops={"arrowstyle": "-", "color": "white"},
    )  # fmt: skip
    return Figure(title, drawing, note)


def _numbered(ax: Axes, part: Any, levels: list[float]) -> None:
    """The impulse on each border between colours: white on dark ones, dark on light ones."""
    inner = levels[1:-1]
    if not inner:
        return
    half = (len(levels) - 1) / 2
    colours = ["white" if k < half else "#101010" for k in range(1, len(levels) - 1)]
    lines = ax.contour(part["duration"].values, part["height"].values, part["impulse"].values, levels=inner,
                       colors=colours, linewidths=0.6)  # fmt: skip
    far = [level for level in inner if level > 1.1 * float(np.nanmin(part["impulse"].values))]  # not at the marker
    ax.clabel(lines, far, fmt={level: number(level, 2) for level in inner}, fontsize=9)


def _levels(low: float, high: float) -> list[float]:
    """Round borders between colours: equal steps, or where the values span more than a factor of three equal ratios."""
    if low <= 0 or high < 3 * low:
        return round_levels(low, high, LEVELS)
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    steps = [m * 10.0**p for p in powers for m in (1, 1.5, 2, 3, 4, 6, 8)]
    steps = steps if high < 30 * low else [10.0**p for p in powers]
    first = max(k for k, step in enumerate(steps) if step <= low)
    return steps[first : 1 + min(k for k, step in enumerate(steps) if step >= high)]


def _slices(part: Any, direction: str) -> Figure:
    rows = np.unique(np.rint(np.array([0.25, 0.5, 1.0]) * (part.sizes["height"] - 1)).astype(int)).tolist()
    labels = [f"impulse survived, {float(part['height'].values[row]):.2g} m above the axle [N s]" for row in rows]
    figure, axes = panels(labels, "duration of the push [s]")
    ends = {"low": "the weakest 2.5 % of robots are below", "high": "the strongest 2.5 % are above"}
    bands = ends if "low" in part else {}
    for ax, row in zip(axes, rows, strict=True):
        for name, text in {"impulse": "nominal robot", **bands}.items():
            line(ax, text, part["duration"].values, part[name].values[row])
        ax.set_ylim(0)
    title = f"Pushed {direction}: largest impulse over the duration of the push"
    if bands:
        low, high = (part[name].values[rows] / part["impulse"].values[rows] for name in ("low", "high"))
        title = (
            f"Pushed {direction}: the limits of 95 % of similar robots lie between "
            f"{number(100 * float(np.nanmin(low)), 2)} and {number(100 * float(np.nanmax(high)), 2)} % of this one's"
        )
    return Figure(title, legend(figure))


def push_map_page(data: Dataset) -> Page:
    origin = origin_of(data)
    search = origin["push_map"]
    name = origin["robot"]["name"]
    impulse = data["impulse"]
    row, column, way = np.unravel_index(int(np.nanargmin(values := impulse.transpose(
        "height", "duration", "direction").values)), values.shape)  # fmt: skip
    low = float(values[row, column, way])
    duration = float(data["duration"].values[column])
    height = float(data["height"].values[row])
    kind = (origin.get("controller") or {}).get("kind", "")
    at_com = _at_centre(data)
    under = f" under {kind}" if kind else ""
    top = " (the highest tried)" if height == float(data["height"].values.max()) else ""
    lead = f"Simulated{under}. A push is worst {height:.2g} m above the axle{top}, {1e3 * duration:.3g} ms long."
    here = f"--robot {name}"
    lead += f" Next: `upright certify {kind or 'lqg'} {here}` counts how many similar robots fall."
    first, *rest = push_map_figures(data)
    ways = data["direction"].values.tolist()
    smallest = {d: float(impulse.sel(direction=d).min()) for d in ways}
    numbers = [
        (
            f"{least(low, 2)} N s",
            f"is the weakest push: {low / duration:.2g} N for {1e3 * duration:.3g} ms, as of a tennis ball at "
            f"{_ball(low)} that it catches",
        )
    ]
    if at_com:
        text = f"survived at the centre of mass ({at_com[0]:.2g} m), {1e3 * KNOCK_DURATION:g} ms long"
        text += f"; {at_com[2]}" if at_com[2] else ""
        numbers.append((f"{cell_text(at_com[1], 2)} N s", text))
    numbers += [(f"{cell_text(smallest[d], 3)} N s", f"survived at the worst place, {d}") for d in ways
                if smallest[d] > 1.05 * low]  # fmt: skip
    long = float(impulse.isel(duration=-1).min())
    longest = number(float(data["duration"].values[-1]), 2)
    numbers.append((f"{cell_text(long, 2)} N s", f"survived at every height if the push lasts {longest} s"))
    tried = (
        f"Simulated{under}, pushed {' and '.join(ways)} for {_ends(data, 'duration', 1e3)} ms, "
        f"{_ends(data, 'height')} m above the axle. Each push grows until the robot falls, in steps of "
        f"{100 * search['tolerance']:g} %. It survives a push if it still stands {search['watch']:g} s later."
    )
    sections = [
        Section("The limit over the duration of the push", [*rest, *_alike(data)]),
        Section("How this was tried", [tried], folded=True),
    ]
    title = f"{name} survives every push tried up to {least(low, 2)} N s"
    verdict = Verdict("simulated: one robot, one controller", "info")
    if "low" in data:
        weak = float(data["low"].values.min())
        title += f"; 97.5 % of similar robots survive {least(weak, 2)} N s"
        verdict = Verdict("simulated: this robot and similar ones", "info")
    return Page(title, sections, lead, provenance(data), False, verdict=verdict, picture=first, numbers=numbers)


def _ball(impulse: float) -> str:
    """How fast a tennis ball is that this impulse stops."""
    return f"{number(impulse / BALL, 2)} m/s"


def _at_centre(data: Dataset) -> tuple[float, float, str] | None:
    """The height [m] of the centre of mass above the axle; the smallest impulse [N s] survived there for as long as a
    certificate knocks, between the points of the map; and what a certificate knocks with. None off the map."""
    known = robot_of(origin_of(data))
    durations = data["duration"].values
    heights = data["height"].values
    height = float(origin_of(data)["robot"].get("com_height") or math.nan)
    if not (durations[0] <= KNOCK_DURATION <= durations[-1] and heights[0] <= height <= heights[-1]):
        return None
    between = data["impulse"].min("direction").interp(height=height, duration=KNOCK_DURATION)
    return height, float(between), _beside(float(between), *known) if known else ""


def _beside(survived: float, robot: Robot, kit: Kit) -> str:
    """This impulse [N s] beside the most that any controller could save, and those of a certificate."""
    able = min(largest_knock(robot, kit, side) for side in (-1, 1))
    any_ = f"no controller saves more than {number(able, 2)} N s; " if math.isfinite(able) and able > survived else ""
    return f"{any_}a certificate pushes there with {certificate_knocks(robot, kit)}"


def _ends(data: Dataset, name: str, scale: float = 1.0) -> str:
    """From where to where an axis reaches."""
    values = scale * data[name].values
    return " to ".join(number(float(end), 2) for end in (values.min(), values.max()))


BALL = 0.058  # [kg] of a tennis ball
