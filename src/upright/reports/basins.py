"""The page of a basin of attraction: the states from which the robot recovers, over two of them."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array, Mask
from upright.fleets.results import origin_of
from upright.plotting import COLOURS, GRID, INK, RIGHT, colour_map, legend, number
from upright.reports.figure import Figure
from upright.reports.knocks import robot_of
from upright.reports.page import Page, Verdict, cell_text
from upright.reports.spreads import provenance

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as MplFigure
    from xarray import Dataset


LEVELS = 10
"""Colours of a map of parts: few enough to be distinguished side by side."""


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
    note += "" if family else " The border is smoothed between them. Similar robots: add `--vary spread` and `-n 20`."
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
    step = 10 if high - low <= 100 else 20
    if degrees and 30 <= high - low <= 120:
        ax.set_xticks(np.arange(step * math.ceil(low / step), high, step).tolist())
    else:
        ax.locator_params(axis="x", nbins=5)


def _named_areas(drawing: MplFigure) -> None:
    """Two areas need a key and no scale of colours."""
    ax, beside = drawing.axes
    drawing.delaxes(beside)
    box = ax.get_position()
    right = 1 - RIGHT / drawing.get_size_inches()[0]
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
            low = float(values[0])
            high = float(values[-1])
            limit(max(low, float(inside.min()) - room), min(high, float(inside.max()) + room))


def basin_page(data: Dataset) -> Page:
    origin = origin_of(data)
    low, high = rest_range(data)
    across, up = (str(name) for name in data["recovered"].dims)
    words = across.replace("_", " ")
    known = math.isfinite(low)
    held = f"{_in_degrees(low, data, across)} to {_in_degrees(high, data, across)}" if known else ""
    name = origin["robot"]["name"]
    percent = f"{100 * float(data['recovered'].values.mean()):.3g} %"
    several = _several(data)
    who = f"{name}, let go at rest, recovers" if several == 1 else f"Most robots like {name} recover, let go at rest,"
    title = f"{who} from a {words} of {held}" if known else f"{name} recovers from {percent} of these states"
    kind = (origin.get("controller") or {}).get("kind", "")
    lead = (
        f"{'It' if _several(data) == 1 else 'A robot'} recovers if it still stands {origin['scenario']['seconds']:g} s "
        f"later{f', under {kind}' if kind else ''}.{_why(data)} "
        f"Next: `upright push-map --robot {name}{f' --controller {kind}' if kind else ''}` does the same for pushes."
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
        numbers: list[tuple[str, str]] = []
        best = _savable(data)
        if best < math.pi / 2:
            text = f"largest {words} from which any controller could save it: linear model{_volts(data)}, lean known"
            numbers.append((f"±{_in_degrees(best, data, across)}", text))
        text = f"{up.replace('_', ' ')} from which {it}, where {words} is zero; tried every {_step(data, up)}"
        numbers.append((ends, text))
        numbers.append((span, f"hold it upright to within this when it starts; tried every {_step(data, across)}"))
    verdict = Verdict(f"simulated: {_robots(several)}, one controller", "info")
    return Page(title, [], lead, provenance(data), False, verdict=verdict, picture=basin_figure(data), numbers=numbers)


def _why(data: Dataset) -> str:
    """Why this controller saves less than any could, as a sentence with a space before it."""
    low, high = rest_range(data)
    reads = (origin_of(data).get("controller") or {}).get("reads") or ()
    blind = bool(reads) and not any(name == "truth/pitch" or "accel" in name for name in reads)
    less = blind and min(-low, high) < WELL * _savable(data) < math.inf
    why = " It saves less than the motors could: no sensor shows a lean at rest, so it notices the fall late."
    return why if less else ""


WELL = 0.9
"""Of what any controller could save: below, the page says why. On nxtway-gs lqr of the true state reaches 33° of 36°,
and of gyro and encoders 16°."""


def _robots(several: int) -> str:
    return "one robot" if several == 1 else f"{several} robots at each state"


def _volts(data: Dataset) -> str:
    """The battery of the kit; empty for a torque drive."""
    known = robot_of(origin_of(data))
    volts = known[1].battery.voltage if known and known[0].command_unit == "V" else math.inf
    return f" with {volts:g} V" if math.isfinite(volts) else ""


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
    row: Mask = data["recovered"].values[:, int(np.abs(up).argmin())] > 0.5
    middle = int(np.abs(across).argmin())
    if not row[middle] or not across[0] <= 0 <= across[-1] or not up[0] <= 0 <= up[-1]:
        return math.nan, math.nan
    lost = np.flatnonzero(~row)
    low = lost[lost < middle].max(initial=-1) + 1
    high = lost[lost > middle].min(initial=len(row)) - 1
    return float(across[low]), float(across[high])
