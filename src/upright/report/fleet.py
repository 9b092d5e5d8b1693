"""Pages of fleets, push maps and basins: maps over two axes in colour, their slices, and distributions."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies.body import FALLEN
from upright.certify.verdict import MOST_FALLS
from upright.fleet.binomial import upper_bound
from upright.fleet.fleet import Fleet, distribution, stood
from upright.fleet.results import OUTCOMES, Summary, origin_of, summarise
from upright.plotting import AXIS, bars, colour_map, edges, legend, line, number, panels, round_levels
from upright.report.campaign import falls_verdict, pushed
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence, spoken

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from xarray import Dataset

Array = NDArray[np.float64]

LEVELS = 10
"""Colours of a map: few enough to be distinguished side by side, and to be named at the bar."""


FRACTION: dict[str, Any] = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points"}
PARTS, DOTS = 12, 500
"""Groups of as many robots each, of which the fraction that fell is drawn; and robots drawn as dots at most."""


def push_map_figures(data: Dataset) -> list[Figure]:
    """For each direction the map and, through its middle heights, its slices with the band."""
    figures: list[Figure] = []
    for direction in data["direction"].values.tolist():
        part = data.sel(direction=direction)
        figures += [_map(part, direction), _slices(part, direction)]
    return figures


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
    labels = [f"impulse survived at {float(part['height'].values[row]):.3g} m [N s]" for row in rows]
    figure, axes = panels(labels, "duration of the push [s]")
    bands = {"low": "2.5 % of robots survive less", "high": "97.5 % of robots survive less"} if "low" in part else {}
    for ax, row in zip(axes, rows, strict=True):
        for name, text in {"impulse": "nominal robot", **bands}.items():
            line(ax, text, part["duration"].values, part[name].values[row])
    title = f"Pushed {direction}: largest impulse over the duration of the push"
    if bands:
        width = float(np.nanmedian((part["high"].values - part["low"].values) / part["impulse"].values))
        title = f"Pushed {direction}: 95 % of similar robots lie in a band of {100 * width:.2g} % of the limit"
    return Figure(title, legend(figure))


def basin_figure(data: Dataset) -> Figure:
    """The fraction that recovers over two states."""
    recovered: Array = data["recovered"].values
    across, up = (str(name) for name in data["recovered"].dims)
    names = [f"{name.replace('_', ' ')} [{data[name].attrs['unit']}]" for name in (across, up)]
    family = len(np.unique(recovered)) > 2
    low, high = rest_range(data)
    title = "States from which the robot recovers"
    if math.isfinite(low):
        title = f"The robot recovers from the green area. Bar: let go with {up.replace('_', ' ')} zero"
    scale = {n: 180 / math.pi if data[n].attrs["unit"] in ("rad", "rad/s") else 1.0 for n in (across, up)}
    names = [text.replace("[rad", "[°") for text in names]
    x, y = (scale[n] * data[n].values for n in (across, up))
    drawing = colour_map(
        x, y, recovered, x_label=names[0], y_label=names[1],
        label="recovers [1]" if family else "", names=() if family else ("falls", "recovers"),
        levels=np.linspace(0, 1, LEVELS + 1).tolist() if family else [0.0, 0.5, 1.0], smooth=not family,
    )  # fmt: skip
    _zoom(drawing.axes[0], x, y, recovered)
    if math.isfinite(low):
        ends = [scale[across] * low, scale[across] * high]
        drawing.axes[0].plot(ends, [0, 0], "k|-", linewidth=2, markersize=12)
        for end, side in zip(ends, ("right", "left"), strict=True):
            text = f"{number(round(end, 1), 2)}{'°' if scale[across] > 1 else ''}"
            drawing.axes[0].annotate(
                text, (end, 0), (-6 if side == "right" else 6, 4), textcoords="offset points", ha=side, color="black"
            )
    drawing.axes[0].locator_params(axis="x", nbins=5)
    apart = float(data["island"].values.mean())
    note = f"{100 * apart:.2g} % of these states are islands: from states between them and rest the robot falls."
    return Figure(title + (", mean over the robots drawn" if family else ""), drawing, note if apart else "")


def _zoom(ax: Axes, x: Array, y: Array, recovered: Array) -> None:
    """Show what recovers and as much again around it."""
    for values, some, limit in ((x, recovered.max(axis=1), ax.set_xlim), (y, recovered.max(axis=0), ax.set_ylim)):
        inside = values[some > 0]
        if len(inside) > 1:
            room = 0.5 * float(np.ptp(inside))
            low, high = edges(values)
            limit(max(low, float(inside.min()) - room), min(high, float(inside.max()) + room))


def histogram(data: Dataset, name: str) -> Figure:
    """How an outcome is distributed over the robots that stood."""
    values, words = stood(data, name), str(data[name].attrs["long_name"])
    scale, unit = _scale(str(data[name].attrs["unit"]))
    middle, high = (scale * np.quantile(values, (0.5, 0.95))).tolist() if len(values) else (math.nan, math.nan)
    after = "" if unit == "1" else f" {unit}"
    title = f"{sentence(words, ':')} half below {middle:.3g}{after}, 95 % below {high:.3g}{after}"
    return Figure(title, distribution(data, name))


def _scale(unit: str) -> tuple[float, str]:
    """Angles are shown in degrees."""
    return (180 / math.pi, unit.replace("rad", "°")) if unit in ("rad", "rad/s") else (1.0, unit)


def influence(data: Dataset, outcome: str) -> Figure | None:
    """The rank correlation of an outcome with each of several varied numbers, the strongest first."""
    sizes = _correlations(data, outcome)
    if len(sizes) < 2:
        return None
    ranked = list(sizes)[:12]
    drawing = bars(ranked, [abs(sizes[n]) for n in ranked], "size of the rank correlation [1]", "varied number")
    return Figure(f"{_words(data, outcome)} follows {ranked[0].replace('_', ' ')} most", drawing)


def over_strongest(data: Dataset, outcome: str) -> Figure | None:
    """An outcome over the varied number that it follows most: each robot a dot, or the fraction that fell."""
    sizes = _correlations(data, outcome)
    if not sizes:
        return None
    name, size = next(iter(sizes.items()))
    x, y = data[name].values.astype(np.float64), data[outcome].values.astype(np.float64)
    use = np.isfinite(y)
    x, y, across = x[use], y[use], f"{spoken(name)} [{data[name].attrs.get('unit', '1')}]"
    if outcome == "fell":
        parts = np.array_split(np.argsort(x), min(PARTS, max(len(x) // 20, 2)))
        figure, (ax,) = panels(["robots that fell [%]"], across)
        line(ax, "fell", [x[k].mean() for k in parts], [100 * y[k].mean() for k in parts], solid=True)
        ax.set_ylim(-2, 102)
        ends = [f"{number(100 * float(y[k].mean()), 2)} %" for k in (parts[0], parts[-1])]
        return Figure(f"Falls over {spoken(name)}: {ends[0]} of the smallest, {ends[1]} of the largest", figure)
    unit = str(data[outcome].attrs["unit"])
    y = np.degrees(y) if unit == "rad" else y
    figure, (ax,) = panels([f"{data[outcome].attrs['long_name']} [{unit.replace('rad', '°')}]"], across)
    few = np.linspace(0, len(x) - 1, min(len(x), DOTS)).astype(int)
    ax.plot(x[few], y[few], ".", markersize=3)
    dots = "each dot is a robot" if len(few) == len(x) else f"a dot is a robot, {len(few)} of {len(x)} are drawn"
    if outcome == "peak_pitch":
        limit = math.degrees(FALLEN)
        ax.axhline(limit, linestyle="--", linewidth=1, color=AXIS)
        ax.annotate(
            "a fall", (1, limit), (-4, -11), xycoords=("axes fraction", "data"), textcoords="offset points", ha="right"
        )
        ax.set_ylim(0, 1.08 * limit)
        if "fell" not in data or not data["fell"].values.any():
            reached = f"{number(float(y.min()), 2)} to {number(float(y.max()), 2)}°"
            return Figure(f"No robot fell: the largest pitch was {reached}", figure, sentence(dots))
    how = "grows" if size > 0 else "shrinks"
    return Figure(f"{_words(data, outcome)} {how} with {spoken(name)}: {dots}", figure)


def _words(data: Dataset, outcome: str) -> str:
    return sentence(str(data[outcome].attrs["long_name"]), "")


def _correlations(data: Dataset, outcome: str) -> dict[str, float]:
    """The rank correlation of an outcome with each varied number, the strongest first; none where nothing differs."""
    varied = [str(n) for n, v in data.data_vars.items() if str(n) not in OUTCOMES and np.ptp(v.values) > 0]
    y = data[outcome].values.astype(np.float64)
    use = np.isfinite(y)
    if use.sum() < 3 or np.ptp(y[use]) == 0:
        return {}
    sizes = {name: _rank_correlation(data[name].values[use], y[use]) for name in varied}
    return dict(sorted(sizes.items(), key=lambda pair: -abs(pair[1])))


def _rank_correlation(x: Array, y: Array) -> float:
    from scipy.stats import rankdata

    return float(np.corrcoef(rankdata(x), rankdata(y))[0, 1])


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
    impulse = data["impulse"]
    row, column, way = np.unravel_index(int(np.nanargmin(values := impulse.transpose(
        "height", "duration", "direction").values)), values.shape)  # fmt: skip
    low, duration = float(values[row, column, way]), float(data["duration"].values[column])
    height = float(data["height"].values[row])
    lead = (
        f"Found by pushing one robot {' and '.join(data['direction'].values.tolist())}, harder and harder, within "
        f"{100 * search['tolerance']:g} %. It survives a push if "
        f"it still stands {search['watch']:g} s later. {low:.2g} N s stops a tennis ball of {low / BALL:.2g} m/s. "
        "Next: `upright certify`, for slightly different robots."
    )
    first, *rest = push_map_figures(data)
    ways = data["direction"].values.tolist()
    least = {d: float(impulse.sel(direction=d).min()) for d in ways}
    numbers = [(f"{low:.2g} N s", f"survived where a push is worst, {height:.2g} m above the axle")]
    numbers += [(f"{low / duration:.3g} N", f"is the force of that push, for {1e3 * duration:.2g} ms")]
    numbers += [(f"{cell_text(least[d], 3)} N s", f"survived at the worst place, {d}") for d in ways
                if least[d] > 1.05 * low]  # fmt: skip
    sections = [Section("Maps and slices", rest)]
    title = f"{name} survives every push up to {cell_text(low, 2)} N s"
    verdict = Verdict("limits of one robot", "info")
    return Page(title, sections, lead, provenance(data), False, verdict=verdict, picture=first, numbers=numbers)


BALL = 0.058  # [kg] of a tennis ball


def _basin_page(data: Dataset) -> Page:
    origin = origin_of(data)
    low, high = rest_range(data)
    across, up = (str(name) for name in data["recovered"].dims)
    words = across.replace("_", " ")
    held = f"{_in_degrees(low, data, across)} to {_in_degrees(high, data, across)}"
    name, percent = origin["robot"]["name"], f"{100 * float(data['recovered'].values.mean()):.3g} %"
    known = math.isfinite(low)
    title = f"{name}, let go at rest, recovers from a {words} of {held}" if known else (
        f"{name} recovers from {percent} of these states"
    )  # fmt: skip
    kind = (origin.get("controller") or {}).get("kind", "")
    lead = (
        f"Recovers: still standing {origin['scenario']['seconds']:g} s later{f', under {kind}' if kind else ''}. "
        "Next: `upright push-map`, which asks for pushes instead."
    )
    step = float(np.diff(data[across].values).mean()) if data[across].size > 1 else 0.0
    numbers = [(percent, "of the states tried recover")]
    if known:
        reach = data[up].values[(data["recovered"].values[int(np.abs(data[across].values).argmin())] > 0.5)]
        least, most = float(reach.min()), float(reach.max())
        alike = math.isclose(-least, most, rel_tol=1e-6)
        ends = f"±{_in_degrees(most, data, up)}" if alike else (
            f"{_in_degrees(least, data, up)} to {_in_degrees(most, data, up)}"
        )  # fmt: skip
        numbers = [(ends, f"{up.replace('_', ' ')} from which it recovers, where {words} is zero")]
        numbers += [(_in_degrees(step, data, across), "step of the grid, so these angles are exact to this")]
    return Page(
        title, [], lead, provenance(data), False, verdict=Verdict("limits of one robot", "info"),
        picture=basin_figure(data), numbers=numbers,
    )  # fmt: skip


def _in_degrees(value: float, data: Dataset, name: str) -> str:
    """A value of an axis, angles in degrees."""
    unit = str(data[name].attrs["unit"])
    if unit not in ("rad", "rad/s"):
        return f"{cell_text(value, 2)} {unit}"
    size = math.degrees(value)
    return f"{round(size) if abs(size) >= 10 else cell_text(size, 2)}{unit.replace('rad', '°')}".replace("-", "−")


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


def _fleet_page(data: Dataset, summary: Summary) -> Page:
    """Falls and quantiles of the robots, with the distribution of each outcome."""
    names = [name for name, row in summary.quantiles.items() if np.isfinite(row[1]) and np.ptp(row) > 0]
    some = 0 < summary.fell < summary.n
    rows: list[list[Cell]] = []
    for name, quantiles in summary.quantiles.items():
        scale, unit = _scale(summary.units[name])
        rows.append([str(data[name].attrs["long_name"]), unit, *(scale * value for value in quantiles)])
    table = Table(["robots that stood", "unit", "5 %", "median", "95 %"], rows, "Quantiles over the robots")
    chance = summary.chance
    pushes = origin_of(data).get("scenario", {}).get("push")
    robot = origin_of(data)["robot"]["name"]
    lead = f"{_differ(data, robot)}.{_where(pushes)} Next: `upright push-map`, which finds the largest push."
    bounds = f"{number(100 * chance.low, 2)} to {number(100 * chance.high, 2)} %" if summary.fell else ""
    numbers = [
        (
            bounds or f"≤ {number(100 * upper_bound(0, summary.n), 2)} %",
            f"of all such robots fall, with 95 % confidence; wanted at most {100 * MOST_FALLS:g} %",
        )
    ]
    if "peak_pitch" in summary.quantiles and np.isfinite(summary.quantiles["peak_pitch"][2]):
        peak, fall = math.degrees(summary.quantiles["peak_pitch"][2]), math.degrees(FALLEN)
        numbers.append((f"{peak:.2g}°", f"largest pitch of 95 % of those that stood; {fall:.0f}° counts as a fall"))
    outcomes = [*(["fell"] if some else []), *names[:1]]
    causes = [figure for name in outcomes for figure in (over_strongest(data, name), influence(data, name)) if figure]
    picture, *others = [*causes, *(histogram(data, name) for name in names), None]
    sections = [Section("Numbers", [table]), Section("Distributions", [figure for figure in others if figure])]
    return Page(
        f"{summary.fell} of {summary.n} robots fell, {pushed(pushes)}", sections, lead, provenance(data), False,
        picture=picture, numbers=numbers, verdict=falls_verdict(summary.fell, summary.n),
    )  # fmt: skip


def _differ(data: Dataset, robot: str) -> str:
    """Whose relatives, in what they differ, and what holds them."""
    names = [s["name"] for s in (origin_of(data).get("vary") or {}).get("spreads", [])]
    varied = [f"{spoken(n)}{_range(data, n)}" for n in names]
    what = f" in {', '.join(varied[:4])}{', …' if len(varied) > 4 else ''}" if varied else ""
    kind = (origin_of(data).get("controller") or {}).get("kind", "")
    return f"Robots that differ from {robot}{what}{f', under {kind}' if kind else ''}"


def _range(data: Dataset, name: str) -> str:
    if name not in data:
        return ""
    values, unit = data[name].values, data[name].attrs.get("unit", "")
    return f" ({cell_text(float(values.min()), 3)} to {cell_text(float(values.max()), 3)}{f' {unit}' if unit else ''})"


def _where(pushes: Sequence[Mapping[str, Any]] | None) -> str:
    """How long the first impulse takes and at which height, as a sentence with a space before it."""
    for push in pushes or ():
        if push.get("impulse"):
            height = push.get("height")
            at = "at the centre of mass" if height is None else f"{height:g} m above the axle"
            return f" The push takes {1e3 * push.get('duration', 0.01):g} ms, {at}."
    return ""


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
