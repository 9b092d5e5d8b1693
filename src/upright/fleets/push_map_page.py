"""The page of a push map: the weakest push, the limit over height and duration in colour, and its slices."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array
from upright.experiment.described import law_in, law_in_words, name_in
from upright.fleets.limits import KNOCK, at_centre, longest, weakest
from upright.fleets.origin import made_of
from upright.fleets.results import origin_of
from upright.languages import number
from upright.pages import MOST_NUMBERS, Column, Fold, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.words import shown_in

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from xarray import Dataset

LEVELS = 10  # colours of a map: few enough to be told apart side by side

WAYS = {"forward": Say("forward"), "backward": Say("backward")}


def push_map_page(data: Dataset) -> Page:
    """The page of a push map."""
    origin = origin_of(data)
    robot = name_in(origin, "robot")
    weak, *_ = weakest(data).values()
    size = _survived(weak["impulse"])
    title = Say("{robot} survives {size} at every height and duration tried", robot=robot, size=size)
    verdict = Verdict(Say("survives {size}", size=size))
    lead = Say("Simulated under {controller}: it is weakest {height} above the axle, against {force} for {time}.",
               controller=law_in_words(origin), height=Quantity(weak["height"], "m"),
               force=Quantity(weak["force"], "N"), time=Quantity(weak["duration"], "s"))  # fmt: skip
    if not weak["impulse"]:
        title = Say("The smallest push tried fells {robot}", robot=robot)
        verdict = Verdict(Say("no push is survived"), "bad")
        lead = Say("Simulated under {controller}, at every height and duration.", controller=law_in_words(origin))
    first, *others = [_map(data, way) for way in weakest(data)]
    slices = [_slices(data.sel(direction=way), way) for way in weakest(data)]
    why = Say("It counts how many similar robots fall.")
    return Page(
        title, verdict=verdict, lead=[lead], numbers=_numbers(data), picture=first,
        next=[Next("certify", law_in(origin) or "lqg", robot=robot, why=why)],
        blocks=[_table(data), Fold(Say("Heights and directions"), [*slices, *others])], origin=made_of(data),
    )  # fmt: skip


def _numbers(data: Dataset) -> list[KeyNumber]:
    numbers: list[KeyNumber] = []
    knock = at_centre(data)
    if knock:
        meaning = Say("survived at the centre of mass, if the push lasts {time}", time=Quantity(KNOCK, "s"))
        numbers.append(KeyNumber(_survived(knock), meaning))
    time = Quantity(float(data["duration"].values[-1]), "s", digits=2)
    meaning = Say("survived at every height, if the push lasts {time}", time=time)
    numbers.append(KeyNumber(_survived(longest(data)), meaning))
    weak, *_ = places = list(weakest(data).values())
    if "low" in weak:
        low = min(place["low"] for place in places)
        numbers.append(KeyNumber(_survived(low), Say("survived everywhere by 97.5 % of similar robots")))
    ball = Quantity(weak["ball"], "m/s", digits=2)
    numbers.append(KeyNumber(ball, Say("a tennis ball at this speed, stopped by the robot, pushes as hard as that")))
    return numbers[:MOST_NUMBERS]


def _survived(impulse: float) -> Quantity:
    """A limit, which is never rounded up."""
    return Quantity(None, "N s", low=impulse)


def _table(data: Dataset) -> Table:
    columns = [
        Column(Say("direction")), Column(Say("it survives")), Column(Say("height"), "m"), Column(Say("lasts"), "s"),
        Column(Say("97.5 % survive")),
    ]  # fmt: skip
    rows = [
        [
            WAYS[way],
            _survived(place["impulse"]),
            place["height"],
            place["duration"],
            _survived(place["low"]) if "low" in place else None,
        ]
        for way, place in weakest(data).items()
    ]
    return Table(columns, rows, Say("Where each direction is weakest, by its height above the axle"))


def _map(data: Dataset, way: str) -> Picture:
    claim = Say("The largest push {way} that it survives, by height and duration", way=WAYS[way])
    watched = Quantity(float(origin_of(data)["push_map"]["watch"]), "s")
    note = Say(
        "Lines: the largest push [N s] after which it stands for {time}. The lightest colour has more.", time=watched
    )
    return Picture(claim, functools.partial(draw_map, data.sel(direction=way)), note)


def draw_map(part: Dataset) -> Figure:
    """The largest impulse of one direction over height and duration, and a mark where it is least."""
    from upright.plotting import colour_map

    impulse: Array = part["impulse"].values
    low = float(np.nanmin(impulse))
    high = float(np.nanquantile(impulse, 0.98))
    row, column = np.unravel_index(int(np.nanargmin(impulse)), impulse.shape)
    factor, unit = shown_in("m", float(part["height"].values.max()))
    heights = factor * part["height"].values
    height, duration = float(heights[row]), float(part["duration"].values[column])
    levels = _levels(low, high)
    drawing = colour_map(
        part["duration"].values, heights, impulse.T, x_label=str(Say("duration of the push [s]")),
        y_label=f"{Say('height above the axle')} [{unit}]", label=str(Say("push [N s]")), levels=levels,
    )  # fmt: skip
    ax = drawing.axes[0]
    _numbered(ax, part, heights, levels)
    ax.plot(duration, height, "o", color="white", markeredgecolor="black", markersize=9, clip_on=False, zorder=5)
    right = part["duration"].values.mean() >= duration
    above = heights.mean() >= height
    ax.annotate(
        str(Say("weakest")), (duration, height), (28 if right else -28, 24 if above else -24), color="white",
        textcoords="offset points", ha="left" if right else "right", arrowprops={"arrowstyle": "-", "color": "white"},
    )  # fmt: skip
    return drawing


def _numbered(ax: Axes, part: Any, heights: Array, levels: list[float]) -> None:
    """The impulse on each border between colours: white on dark ones, dark on light ones."""
    inner = levels[1:-1]
    if not inner:
        return
    half = (len(levels) - 1) / 2
    colours = ["white" if k < half else "#101010" for k in range(1, len(levels) - 1)]
    lines = ax.contour(part["duration"].values, heights, part["impulse"].values, levels=inner,
                       colors=colours, linewidths=0.6)  # fmt: skip
    far = [level for level in inner if level > 1.6 * float(np.nanmin(part["impulse"].values))]  # not at the marker
    ax.clabel(lines, far, fmt={level: number(level, 2) for level in inner}, fontsize=9)


def _levels(low: float, high: float) -> list[float]:
    """Round borders between colours: equal steps, or where the values span more than a factor of three equal ratios."""
    from upright.plotting import round_levels

    if low <= 0 or high < 3 * low:
        return round_levels(low, high, LEVELS)
    powers = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    steps = [m * 10.0**p for p in powers for m in (1, 1.5, 2, 3, 4, 6, 8)]
    steps = steps if high < 30 * low else [10.0**p for p in powers]
    first = max(k for k, step in enumerate(steps) if step <= low)
    return steps[first : 1 + min(k for k, step in enumerate(steps) if step >= high)]


def _slices(part: Dataset, way: str) -> Picture:
    return Picture(
        Say("Pushed {way}: a longer push may be larger", way=WAYS[way]), functools.partial(_draw_slices, part)
    )


def _draw_slices(part: Dataset) -> Figure:
    """The limit over the duration at three heights, with the band of similar robots."""
    from upright.plotting import legend, line, panels

    rows = np.unique(np.rint(np.array([0.25, 0.5, 1.0]) * (part.sizes["height"] - 1)).astype(int)).tolist()
    heights = [Quantity(float(part["height"].values[row]), "m", digits=2) for row in rows]
    labels = [str(Say("survived, {height} above the axle [N s]", height=height)) for height in heights]
    figure, axes = panels(labels, str(Say("duration of the push [s]")))
    names = {"impulse": Say("this robot"), "low": Say("2.5 % of similar robots below"), "high": Say("2.5 % above")}
    for ax, row in zip(axes, rows, strict=True):
        for name, words in names.items():
            if name in part:
                line(ax, str(words), part["duration"].values, part[name].values[row])
        ax.set_ylim(0)
    return legend(figure)
