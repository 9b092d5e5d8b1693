"""Pages of push maps and basins: maps over two axes in colour, and their slices."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from upright.fleet.results import origin_of
from upright.plotting import COLOURS, GRID, INK, RIGHT, colour_map, legend, line, number, panels, round_levels
from upright.report.campaign import provenance, robot_of
from upright.report.figure import Figure
from upright.report.page import Page, Section, Verdict, cell_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as MplFigure
    from xarray import Dataset

Array = NDArray[np.float64]


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
    low, high = float(np.nanmin(impulse)), float(np.nanquantile(impulse, 0.98))
    row, column = np.unravel_index(int(np.nanargmin(impulse)), impulse.shape)
    height, duration = float(part["height"].values[row]), float(part["duration"].values[column])
    title = f"Pushed {direction}: the largest push that it survives, {low:.2g} N s or more"
    note = (
        f"Weakest: a push of {1e3 * duration:.2g} ms, {height:.2g} m above the axle, with {low / duration:.3g} N all "
        "that time."
    )
    note += " The lightest colour includes all larger impulses." if float(np.nanmax(impulse)) > high else ""
    apart = float(part["island"].values.mean())
    if apart:
        note += f" At {100 * apart:.2g} % of the points a larger push is survived again; the first border is drawn."
    drawing = colour_map(
        part["duration"].values, part["height"].values, impulse.T, x_label="duration of the push [s]",
        y_label="height above the axle [m]", label="impulse [N s]", levels=_levels(low, high), smooth=True,
    )  # fmt: skip
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
    bands = {"low": "2.5 % of robots survive less", "high": "97.5 % of robots survive less"} if "low" in part else {}
    for ax, row in zip(axes, rows, strict=True):
        for name, text in {"impulse": "nominal robot", **bands}.items():
            line(ax, text, part["duration"].values, part[name].values[row])
    title = f"Pushed {direction}: largest impulse over the duration of the push"
    if bands:
        low, high = (part[name].values[rows] / part["impulse"].values[rows] for name in ("low", "high"))
        title = (
            f"Pushed {direction}: 95 % of similar robots survive {number(100 * float(np.nanmin(low)), 2)} to "
            f"{number(100 * float(np.nanmax(high)), 2)} % of what this one does, over all that is drawn"
        )
    return Figure(title, legend(figure))


def basin_figure(data: Dataset) -> Figure:
    """The fraction that recovers over two states."""
    recovered: Array = data["recovered"].values
    across, up = (str(name) for name in data["recovered"].dims)
    names = [f"{name.replace('_', ' ')} [{data[name].attrs['unit']}]" for name in (across, up)]
    family = _several(data) > 1
    low, high = rest_range(data)
    title = "Part of the robots that recovers" if family else "States from which the robot recovers"
    if math.isfinite(low):
        area = f"{title}; black" if family else "The robot recovers from the green area; white"
        title = f"{area} line: let go with {up.replace('_', ' ')} zero"
    scale = {n: 180 / math.pi if data[n].attrs["unit"] in ("rad", "rad/s") else 1.0 for n in (across, up)}
    names = [text.replace("[rad", "[°") for text in names]
    x, y = (scale[n] * data[n].values for n in (across, up))
    drawing = colour_map(
        x, y, recovered if family else _between(recovered), x_label=names[0], y_label=names[1],
        label="recovers [1]" if family else "", names=() if family else ("falls", "recovers"),
        levels=np.linspace(0, 1, LEVELS + 1).tolist() if family else [0.0, 0.5, 1.0], smooth=True,
    )  # fmt: skip
    light, dark = ("white", "black") if family else (INK, "white")
    _zoom(drawing.axes[0], x, y, recovered)
    best = _savable(data)
    if best < math.pi / 2:
        _mark(drawing.axes[0], scale[across] * best, light)
    if math.isfinite(low):
        ends = [scale[across] * low, scale[across] * high]
        drawing.axes[0].plot(ends, [0, 0], color=dark, linewidth=2.5, solid_capstyle="butt")
        for end, side in zip(ends, ("right", "left"), strict=True):
            text = f"{number(round(end, 1), 2)}{'°' if scale[across] > 1 else ''}"
            drawing.axes[0].annotate(
                text, (end, 0), (-6 if side == "right" else 6, 4), textcoords="offset points", ha=side, color=light
            )
    _ticks(drawing.axes[0], scale[across] > 1)
    if not family:
        _named_areas(drawing)
    steps = " and ".join(_step(data, name) for name in (across, up))
    whole = " and ".join(f"{n.replace('_', ' ')} {_reach_of(data, n)}" for n in (across, up))
    note = f"Tried: {whole}, every {steps}"
    note += f", with {_several(data)} robots at each state." if family else "."
    note += " Drawn is the part around what recovers."
    note += "" if family else " The border is smoothed between the states tried."
    apart = float(data["island"].values.mean())
    islands = f" {100 * apart:.2g} % of these states are islands: from states between them and rest the robot falls."
    return Figure(title, drawing, note + (islands if apart else ""))


def _reach_of(data: Dataset, name: str) -> str:
    """From where to where a state was tried."""
    values = data[name].values
    return f"{_in_degrees(float(values.min()), data, name)} to {_in_degrees(float(values.max()), data, name)}"


def _several(data: Dataset) -> int:
    """How many robots were let go at each state."""
    return int((origin_of(data).get("basin") or {}).get("samples", 1))


def _between(recovered: Array) -> Array:
    """A smooth field that is above one half where the robot recovers, and below where it falls."""
    from scipy.ndimage import gaussian_filter

    field = gaussian_filter(recovered, SMOOTHED, mode="nearest")
    return np.where(recovered > 0.5, np.maximum(field, 0.5 + SIDE), np.minimum(field, 0.5 - SIDE))


SMOOTHED, SIDE = 2.0, 0.02
"""Standard deviation [steps of the grid] of the filter that smooths a border, and how far [1] from one half a state
stays on its side."""


def _step(data: Dataset, name: str) -> str:
    """The step of the grid along a state."""
    values = data[name].values
    return _in_degrees(float(np.diff(values).mean()) if values.size > 1 else 0.0, data, name)


def _mark(ax: Axes, best: float, colour: str) -> None:
    """The leans beyond which no controller saves the robot, let go at rest: so only where the other state is zero."""
    for side in (-best, best):
        ax.plot(
            side,
            0.0,
            "|",
            markersize=22,
            markeredgewidth=2,
            color=colour,
            label="limit of any controller, let go at rest" if side > 0 else "_",
        )
        text = f"{'−' if side < 0 else ''}{number(best, 2)}°"
        ax.annotate(text, (side, 0.0), (0, 14), textcoords="offset points", ha="center", color=colour)
    ax.set_xlim(min(ax.get_xlim()[0], -1.2 * best), max(ax.get_xlim()[1], 1.2 * best))


def _ticks(ax: Axes, degrees: bool) -> None:
    """Every 10° or 20° where a phone has room for that, else five."""
    low, high = ax.get_xlim()
    step = 10 if high - low <= 50 else 20
    if degrees and 30 <= high - low <= 120:
        ax.set_xticks(np.arange(step * math.ceil(low / step), high, step).tolist())
    else:
        ax.locator_params(axis="x", nbins=5)


def _named_areas(drawing: MplFigure) -> None:
    """Two areas need a key and no scale of colours."""
    ax, beside = drawing.axes
    drawing.delaxes(beside)
    box, right = ax.get_position(), 1 - RIGHT / drawing.get_size_inches()[0]
    ax.set_position((box.x0, box.y0, right - box.x0, box.height))
    x, y = ax.yaxis.label.get_position()
    ax.yaxis.set_label_coords(x * box.width / (right - box.x0), y)
    for name, colour in (("recovers", COLOURS[2]), ("falls", GRID)):
        ax.plot([], [], "s", color=colour, label=name)
    legend(drawing)


def _zoom(ax: Axes, x: Array, y: Array, recovered: Array) -> None:
    """Show what recovers and as much again around it."""
    for values, some, limit in ((x, recovered.max(axis=1), ax.set_xlim), (y, recovered.max(axis=0), ax.set_ylim)):
        inside = values[some > 0]
        if len(inside) > 1:
            room = 0.5 * float(np.ptp(inside))
            low, high = float(values[0]), float(values[-1])
            limit(max(low, float(inside.min()) - room), min(high, float(inside.max()) + room))


def push_map_page(data: Dataset) -> Page:
    origin = origin_of(data)
    search, name = origin["push_map"], origin["robot"]["name"]
    impulse = data["impulse"]
    row, column, way = np.unravel_index(int(np.nanargmin(values := impulse.transpose(
        "height", "duration", "direction").values)), values.shape)  # fmt: skip
    low, duration = float(values[row, column, way]), float(data["duration"].values[column])
    height = float(data["height"].values[row])
    kind = (origin.get("controller") or {}).get("kind", "")
    under = f"Simulated under {kind}, pushed" if kind else "Simulated, pushed"
    lead = (
        f"{under} {' and '.join(data['direction'].values.tolist())} for {_ends(data, 'duration', 1e3)} ms, "
        f"{_ends(data, 'height')} m above the axle. Each push grows until the robot falls: limits are within "
        f"{100 * search['tolerance']:g} %. It "
        f"survives a push if it still stands {search['watch']:g} s later. {low:.2g} N s stops a tennis ball of "
        f"{low / BALL:.2g} m/s. "
        "Next: `upright certify`, which counts how many similar robots fall."
    )
    first, *rest = push_map_figures(data)
    ways = data["direction"].values.tolist()
    least = {d: float(impulse.sel(direction=d).min()) for d in ways}
    numbers = [(f"{low:.2g} N s", f"survived where a push is worst, {height:.2g} m above the axle")]
    numbers += [(f"{low / duration:.3g} N", f"is the force of that push, for {1e3 * duration:.2g} ms")]
    numbers += [(f"{cell_text(least[d], 3)} N s", f"survived at the worst place, {d}") for d in ways
                if least[d] > 1.05 * low]  # fmt: skip
    long = float(impulse.isel(duration=-1).min())
    numbers += [
        (
            f"{cell_text(long, 2)} N s",
            f"survived everywhere if the push lasts {number(float(data['duration'].values[-1]), 2)} s",
        )
    ]
    sections = [Section("The limit over the duration of the push", [*rest, *_alike(data)])]
    title = f"{name} survives every push up to {cell_text(low, 2)} N s"
    if "low" in data:
        weak = float(data["low"].values.min())
        title += f"; 97.5 % of robots like it {cell_text(weak, 2)} N s"
        numbers.append(
            (
                f"{cell_text(weak, 2)} N s",
                "survived at the worst place by 97.5 % of the robots within the uncertainty of the file",
            )
        )
    verdict = Verdict("simulated: one robot, one controller", "info")
    return Page(title, sections, lead, provenance(data), False, verdict=verdict, picture=first, numbers=numbers)


def _ends(data: Dataset, name: str, scale: float = 1.0) -> str:
    """From where to where an axis reaches."""
    values = scale * data[name].values
    return " to ".join(number(float(end), 2) for end in (values.min(), values.max()))


BALL = 0.058  # [kg] of a tennis ball


def basin_page(data: Dataset) -> Page:
    origin = origin_of(data)
    low, high = rest_range(data)
    across, up = (str(name) for name in data["recovered"].dims)
    words = across.replace("_", " ")
    held = f"{_in_degrees(low, data, across)} to {_in_degrees(high, data, across)}"
    name, percent = origin["robot"]["name"], f"{100 * float(data['recovered'].values.mean()):.3g} %"
    known = math.isfinite(low)
    several = _several(data)
    who = f"{name}, let go at rest, recovers" if several == 1 else f"Most robots like {name} recover, let go at rest,"
    title = f"{who} from a {words} of {held}" if known else f"{name} recovers from {percent} of these states"
    kind = (origin.get("controller") or {}).get("kind", "")
    lead = (
        f"{'It' if _several(data) == 1 else 'A robot'} recovers if it still stands {origin['scenario']['seconds']:g} s "
        f"later{f', under {kind}' if kind else ''}. "
        "All other states are zero at the start. "
        "Next: `upright push-map`, which asks for pushes instead."
    )
    numbers = [(percent, "of the states tried recover")]
    if known:
        reach = data[up].values[(data["recovered"].values[int(np.abs(data[across].values).argmin())] > 0.5)]
        least, most = float(reach.min()), float(reach.max())
        alike = math.isclose(-least, most, rel_tol=1e-6)
        ends = f"±{_in_degrees(most, data, up)}" if alike else (
            f"{_in_degrees(least, data, up)} to {_in_degrees(most, data, up)}"
        )  # fmt: skip
        even = math.isclose(-low, high, rel_tol=1e-6)
        span = f"±{_in_degrees(high, data, across)}" if even else held
        it = "it recovers" if several == 1 else "most recover"
        numbers = [(span, f"{words} from which {it}, let go at rest; tried every {_step(data, across)}")]
        best = _savable(data)
        if best < math.pi / 2:
            text = "largest lean from which any controller could save it, by the linear model"
            numbers.append((f"±{_in_degrees(best, data, across)}", text))
        text = f"{up.replace('_', ' ')} from which {it}, where {words} is zero; tried every {_step(data, up)}"
        numbers.append((ends, text))
    verdict = Verdict(f"simulated: {_robots(several)}, one controller", "info")
    return Page(title, [], lead, provenance(data), False, verdict=verdict, picture=basin_figure(data), numbers=numbers)


def _robots(several: int) -> str:
    return "one robot" if several == 1 else f"{several} robots at each state"


def _savable(data: Dataset) -> float:
    """The largest pitch [rad] at rest from which any controller could save the linear robot, by `control.reach`;
    infinite where the basin is not over pitch, or no kit is known."""
    from upright.control.reach import largest_pitch

    known = robot_of(origin_of(data))
    return largest_pitch(*known) if known and str(data["recovered"].dims[0]) == "pitch" else math.inf


def _in_degrees(value: float, data: Dataset, name: str) -> str:
    """A value of an axis, angles in degrees."""
    unit = str(data[name].attrs["unit"])
    if unit not in ("rad", "rad/s"):
        return f"{cell_text(value, 2)} {unit}"
    size = math.degrees(value)
    whole = round(size, -1) if abs(size) >= 100 and unit == "rad/s" else round(size)
    return (
        f"{whole:.0f}{unit.replace('rad', '°')}".replace("-", "−")
        if abs(size) >= 10
        else f"{cell_text(size, 2)}{unit.replace('rad', '°')}".replace("-", "−")
    )


def rest_range(data: Dataset) -> tuple[float, float]:
    """From where to where, round zero, the first state recovers while the second is zero; NaN where it does not."""
    across, up = (data[str(name)].values for name in data["recovered"].dims)
    row: NDArray[np.bool_] = data["recovered"].values[:, int(np.abs(up).argmin())] > 0.5
    middle = int(np.abs(across).argmin())
    if not row[middle] or not across[0] <= 0 <= across[-1] or not up[0] <= 0 <= up[-1]:
        return math.nan, math.nan
    lost = np.flatnonzero(~row)
    low, high = lost[lost < middle].max(initial=-1) + 1, lost[lost > middle].min(initial=len(row)) - 1
    return float(across[low]), float(across[high])
