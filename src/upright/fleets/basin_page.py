"""The page of a basin of attraction: from where a robot recovers when it is let go, over two of its states."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.experiment.described import law_in, law_in_words, name_in
from upright.fleets.limits import ranges, samples, saved_by_any, sees_lean, states
from upright.fleets.origin import made_of
from upright.fleets.results import origin_of
from upright.pages import MOST_NUMBERS, Column, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.blocks import Cell

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from xarray import Dataset

LEVELS = 10  # colours of a map of parts: few enough to be told apart side by side

SMOOTHED = 2.0  # [steps of the grid] of the filter that smooths a border
SIDE = 0.02  # [1] how far from one half a state stays on its side

STATES = {
    "pitch": Say("pitch"), "pitch_rate": Say("pitch rate"), "wheel": Say("wheel angle"),
    "wheel_rate": Say("wheel rate"), "yaw": Say("heading"), "yaw_rate": Say("yaw rate"),
}  # fmt: skip


def basin_page(data: Dataset) -> Page:
    """The page of a basin."""
    origin = origin_of(data)
    robot = name_in(origin, "robot")
    across, up = states(data)
    part = Quantity(float(data["recovered"].values.mean()), "fraction")
    known = ranges(data)[across]
    span = _range(data, across)
    verdict = Verdict(Say("recovers from {range}", range=span))
    if not known:
        title = Say("Of the states tried, {robot} recovers from {part}", robot=robot, part=part)
        verdict = Verdict(Say("falls when let go at rest"), "bad")
        if not all(data[name].values[0] <= 0 <= data[name].values[-1] for name in (across, up)):
            verdict = Verdict(Say("rest was not tried"), "unknown")
    elif samples(data) > 1:
        title = Say("With no {up}, most robots like {robot} recover from a {across} of {range}", up=STATES[up],
                    robot=robot, across=STATES[across], range=span)  # fmt: skip
        verdict = Verdict(Say("most recover from {range}", range=span))
    else:
        title = Say("Let go at rest but for its {across}, {robot} recovers from {range}", robot=robot,
                    across=STATES[across], range=span)  # fmt: skip
        if across == "pitch":
            title = Say("Hold {robot} within {range} when it starts: from there it recovers", robot=robot, range=span)
    made = {"controller": law_in_words(origin), "time": Quantity(float(origin["scenario"]["seconds"]), "s")}
    lead = [Say("Simulated under {controller}: who still stands after {time} has recovered.", **made)]
    if samples(data) > 1:
        lead = [Say("Of {n} robots at each state under {controller}, those have recovered that stand after {time}.",
                    n=samples(data), **made)]  # fmt: skip
    best = saved_by_any(data)
    if known and best and max(known) < best:
        lead.insert(0, Say("Its motors could bring it back from a larger lean."))
        if not sees_lean(data):
            lead[0] = Say("No sensor shows a lean at rest: it acts late, and recovers from less.")
    why = Say("It does the same for pushes.")
    return Page(
        title, verdict=verdict, lead=lead, numbers=_numbers(data), picture=_picture(data),
        next=[Next("push_map", robot=robot, controller=law_in(origin) or None, why=why)],
        blocks=[_table(data)], origin=made_of(data),
    )  # fmt: skip


def _range(data: Dataset, name: str) -> Say:
    """The range round zero of a state."""
    return _between(ranges(data)[name] or (math.nan, math.nan), str(data[name].attrs["unit"]))


def _between(ends: Sequence[float], unit: str) -> Say:
    low, high = ends
    return Say("{low} to {high}", low=Quantity(low, unit), high=Quantity(high, unit))


def _numbers(data: Dataset) -> list[KeyNumber]:
    across, up = states(data)
    names = {"up": STATES[up], "across": STATES[across]}
    numbers: list[KeyNumber] = []
    recovers = ranges(data)[up]
    if recovers:
        meaning = Say("{up} from which it recovers at zero {across}", **names)
        if recovers == (data[up].values[0], data[up].values[-1]):
            meaning = Say("{up}: it recovers from all that was tried", **names)
        numbers.append(KeyNumber(_range(data, up), meaning))
    best = saved_by_any(data)
    if best:
        meaning = Say("largest pitch at rest that any controller saves")
        numbers.append(KeyNumber(Quantity(best, "rad", digits=2), meaning))
    part = Quantity(float(data["recovered"].values.mean()), "fraction")
    numbers += [
        KeyNumber(_step(data, across), Say("step of {across} from one try to the next", **names)),
        KeyNumber(part, Say("of the states tried are survived")),
    ]
    return numbers[:MOST_NUMBERS]


def _step(data: Dataset, name: str) -> Quantity:
    return Quantity(float(np.diff(data[name].values).mean()), str(data[name].attrs["unit"]))


def _table(data: Dataset) -> Table:
    columns = [Column(Say("state")), Column(Say("recovers from")), Column(Say("tried")), Column(Say("step"))]
    rows = [_row(data, name) for name in states(data)]
    return Table(columns, rows, Say("Each state while the other is zero"))


def _row(data: Dataset, name: str) -> list[Cell]:
    values = data[name].values
    unit = str(data[name].attrs["unit"])
    tried = _between((float(values.min()), float(values.max())), unit)
    recovers = _range(data, name) if ranges(data)[name] else None
    return [STATES[name], recovers, tried, _step(data, name)]


def _picture(data: Dataset) -> Picture:
    up = STATES[states(data)[1]]
    claim = Say("It recovers from the green states; on the white line its {up} is zero", up=up)
    if samples(data) > 1:
        claim = Say("The lighter, the more robots recover; on the black line their {up} is zero", up=up)
    note = Say("The border is smoothed, and what is far from it left out.")
    if saved_by_any(data):
        note = Say("The border is smoothed. Marks: the largest pitch at rest that any controller saves.")
    return Picture(claim, functools.partial(draw_basin, data), note)


def draw_basin(data: Dataset) -> Figure:
    """The part that recovers, in colour over both states, and the range at rest."""
    from upright.plotting import INK, colour_map

    across, _ = states(data)
    recovered: Array = data["recovered"].values
    family = samples(data) > 1
    units = {name: str(data[name].attrs["unit"]) for name in states(data)}
    x, y = (DEGREES * data[name].values for name in states(data))
    names = [f"{STATES[name]} [{unit.replace('rad', '°')}]" for name, unit in units.items()]
    drawing = colour_map(
        x, y, recovered if family else smooth(recovered), x_label=names[0], y_label=names[1],
        label=str(Say("recovers [1]")) if family else "",
        levels=np.linspace(0, 1, LEVELS + 1).tolist() if family else [0.0, 0.5, 1.0],
    )  # fmt: skip
    ax = drawing.axes[0]
    light, dark = ("white", "black") if family else (INK, "white")
    _zoom(ax, x, y, recovered)
    if not family:
        _name_areas(ax, y, recovered[len(x) // 2])
    if best := saved_by_any(data):
        _mark_limit(ax, DEGREES * best, light)
    if ends := ranges(data)[across]:
        ax.plot([DEGREES * end for end in ends], [0, 0], color=dark, linewidth=2.5, solid_capstyle="butt")
    ax.locator_params(axis="x", nbins=5)
    return drawing


DEGREES = 180 / math.pi  # [°/rad]: all states are angles or their rates


def smooth(recovered: Array) -> Array:
    """A smooth field that is above one half where the robot recovers, and below where it falls."""
    from scipy.ndimage import gaussian_filter

    field = gaussian_filter(recovered, SMOOTHED, mode="nearest")
    return np.where(recovered > 0.5, np.maximum(field, 0.5 + SIDE), np.minimum(field, 0.5 - SIDE))


def _name_areas(ax: Axes, y: Array, upright: Array) -> None:
    """What the colours mean: `upright` (ny,) tells which y are recovered from where x is zero."""
    ax.annotate(str(Say("it falls")), (0.03, 0.06), xycoords="axes fraction", color="black")
    if upright.any():
        ax.annotate(str(Say("it recovers")), (0.0, y[upright > 0].max() / 4), ha="center", va="center", color="white")


def _mark_limit(ax: Axes, best: float, colour: str) -> None:
    """The pitch [°] beyond which no controller saves the robot, let go at rest: so only where the rate is zero."""
    ax.plot([-best, best], [0, 0], "|", markersize=22, markeredgewidth=2, color=colour)
    for side in (-best, best):
        ax.annotate(str(Quantity(side / DEGREES, "rad", digits=2)), (side, 0.0), (0, 14), textcoords="offset points",
                    ha="center", color=colour)  # fmt: skip
    ax.set_xlim(min(ax.get_xlim()[0], -1.4 * best), max(ax.get_xlim()[1], 1.4 * best))


def _zoom(ax: Axes, x: Array, y: Array, recovered: Array) -> None:
    """Show what recovers and as much again around it."""
    for values, some, limit in ((x, recovered.max(axis=1), ax.set_xlim), (y, recovered.max(axis=0), ax.set_ylim)):
        inside = values[some > 0]
        if len(inside) > 1:
            room = 0.5 * float(np.ptp(inside))
            low = float(values[0])
            high = float(values[-1])
            limit(max(low, float(inside.min()) - room), min(high, float(inside.max()) + room))
