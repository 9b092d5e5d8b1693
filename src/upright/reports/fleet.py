"""Pages of fleets: an outcome over what was varied, and distributions; `maps` has those of push maps and basins."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array, Mask
from upright.certification.verdict import MOST_FALLS
from upright.fleets.binomial import RARE
from upright.fleets.ensemble import SETTLED
from upright.fleets.fleet import Fleet, distribution, stood
from upright.fleets.results import OUTCOMES, Summary, origin_of, summarise
from upright.plotting import AXIS, INK, bars, legend, line, number, panels
from upright.reports.basins import basin_page
from upright.reports.campaign import falls_verdict
from upright.reports.figure import Figure
from upright.reports.knocks import harder, pushed, where
from upright.reports.maps import push_map_page
from upright.reports.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.reports.spreads import provenance, size_of, spread_table, width
from upright.robots.kit import STOP
from upright.tables import joined, sentence, spoken

if TYPE_CHECKING:
    from xarray import Dataset


FRACTION: dict[str, Any] = {"xycoords": ("axes fraction", "data"), "textcoords": "offset points"}

PARTS, DOTS, SHOWN = 12, 500, 0.995
"""Groups of as many robots each, of which the fraction that fell is drawn; robots drawn as dots at most; and the part
of the robots that a distribution with a long tail shows."""


def histogram(data: Dataset, name: str) -> Figure:
    """How an outcome is distributed over the robots that stood."""
    values, words = stood(data, name), _called(data, name)
    scale, unit = _scale(data, name)
    middle, high = (scale * np.quantile(values, (0.5, 0.95))).tolist() if len(values) else (math.nan, math.nan)
    after = unit if unit == "°" else f" {unit}"
    at_zero = float((values == 0).mean()) if len(values) else 0.0
    half = f"{100 * at_zero:.0f} % at 0" if at_zero >= 0.5 else f"half below {_two(middle)}"
    title = f"{sentence(words, '')} of those that stood: {half}{after}, 95 % below {_two(high)}{after}"
    drawing, note = distribution(data, name), _GROUPS if name == "settling" else ""
    (ax,) = drawing.axes
    ax.xaxis.label.set_text(ax.get_xlabel().replace(str(data[name].attrs["long_name"]), words))
    if len(values) and np.ptp(values) > 0:
        for place, text, style in ((middle, "half", "-"), (high, "95 %", "--")):
            ax.axvline(place, linestyle=style, linewidth=1.2, color=INK, label=f"{text} are below")
        low, end, most = (scale * np.quantile(values, (0.0, SHOWN, 1.0))).tolist()
        if most - end > 0.1 * (most - low):
            ax.set_xlim(low - 0.03 * (end - low), end + 0.03 * (end - low))
            note = f"{note} Not drawn: the {100 * (1 - SHOWN):.2g} % with the most, up to {_two(most)}{after}.".strip()
        note = f"{_still(data)}{note}" if name == "peak_pitch" else note
        legend(drawing)
    return Figure(title, drawing, note)


def _still(data: Dataset) -> str:
    """Who the dots at 0 are, as a sentence with a space behind it; nothing where there are no two groups."""
    swings = _swinging(data)
    return "" if swings is None else f"At 0: the {int((~swings).sum())} robots that never moved. "


def _untested(data: Dataset) -> str:
    """That some robots never left the place where they stood balanced, as a sentence with a space before it; nothing
    where they were pushed, or all or none did."""
    swings = _swinging(data)
    if swings is None:
        return ""
    return (
        f" {int((~swings).sum())} never moved: they start upright, nothing disturbs them, and the small commands that "
        "noise makes stay within the motors' dead zone. They test nothing."
    )


def _swinging(data: Dataset) -> Mask | None:
    """Of the robots that stood those that swing; None where there are no two groups, or a push moved them."""
    origin, rolled = origin_of(data), stood(data, "travel") if "travel" in data else np.empty(0)
    motor = (origin.get("kit") or {}).get("motor") or {}
    zone, still = motor.get("dead_zone", 0.0) + motor.get("drop", 0.0), int((rolled < STILL).sum())
    if origin.get("scenario", {}).get("push") or not zone or not MANY * len(rolled) < still < (1 - MANY) * len(rolled):
        return None
    return rolled >= STILL


def _moving(data: Dataset, summary: Summary) -> tuple[Mapping[str, Sequence[float]], int | None]:
    """The 5, 50 and 95 % quantiles of each outcome; of two groups those of the robots that moved, since the others have
    zeros, and how many moved; None where all count."""
    swings = _swinging(data)
    if swings is None:
        return summary.quantiles, None
    part = {name: np.quantile(stood(data, name)[swings], (0.05, 0.5, 0.95)).tolist() for name in summary.quantiles}
    return part, int(swings.sum())


def _quantiles(data: Dataset, quantiles: Mapping[str, Sequence[float]], moved: int | None) -> Table:
    rows: list[Sequence[Cell]] = []
    for name, row in quantiles.items():
        scale, unit = _scale(data, name)
        rows.append([f"{_called(data, name)} [{unit}]", *(scale * value for value in row)])
    who = "robots that stood" if moved is None else f"the {moved} that moved"
    over = "the robots" if moved is None else "the robots that moved"
    return Table([who, "5 %", "median", "95 %"], rows, f"Quantiles over {over}", 3)


def _matters(data: Dataset, outcome: str) -> str:
    """Whether an outcome follows what was varied, where few numbers were, as a sentence with a space before it."""
    sizes = _correlations(data, outcome)
    if not 0 < len(sizes) <= FEW:
        return ""
    name, size = next(iter(sizes.items()))
    limit, what = _chance(data, len(sizes)), _words(data, outcome).lower()
    if abs(size) <= limit:
        which = f"{spoken(name)} makes" if len(sizes) == 1 else "what was varied makes"
        return f" {sentence(which, '')} no visible difference to the {what}: no more than chance does."
    how = "clearly" if abs(size) > CLEAR else "a little"
    return f" The {what} follows {spoken(name)} {how} (rank correlation {number(size, 2)})."


STILL, MANY = 1e-3, 0.05  # [m] that a robot rolls at least; part of the robots that makes a group


def _two(value: float) -> str:
    """Two digits; a dash where no robot stood."""
    return number(value, 2) if math.isfinite(value) else "–"


def _called(data: Dataset, name: str) -> str:
    """An outcome in words; where there was one push, it is not the last one."""
    words, pushes = str(data[name].attrs["long_name"]), origin_of(data).get("scenario", {}).get("push") or ()
    return words.replace("the last push", "the push") if len(pushes) == 1 else words


_BAND = f"±{math.degrees(SETTLED):.3g}°"
_GROUPS = (
    f"Settled: from here on pitch stays within {_BAND} ({SETTLED:g} rad). A robot whose next "
    "swing leaves this band too settles a swing later; so there may be groups with a gap between them."
)


def _scale(data: Dataset, name: str) -> tuple[float, str]:
    """Angles are shown in degrees, fractions in per cent."""
    unit = str(data[name].attrs["unit"])
    if unit in ("rad", "rad/s"):
        return 180 / math.pi, unit.replace("rad", "°")
    return (100.0, "%") if unit == "1" else (1.0, unit)


def influence(data: Dataset, outcome: str) -> Figure | None:
    """The rank correlation of an outcome with each of several varied numbers, the strongest first."""
    sizes = _correlations(data, outcome)
    if len(sizes) < 2:
        return None
    ranked = list(sizes)[:12]
    drawing = bars(ranked, [abs(sizes[n]) for n in ranked], "size of the rank correlation [1]", "varied number")
    limit, (ax,) = _chance(data, len(sizes)), drawing.axes
    ax.axvline(limit, linestyle="--", linewidth=1, color=AXIS)
    ax.set_xlim(0, max(1.2 * limit, ax.get_xlim()[1]))
    note = f"Left of the dashed line, {number(limit, 2)}, it may be chance."
    follows = "falls follow" if outcome == "fell" else f"{_words(data, outcome).lower()} follows"
    if abs(sizes[ranked[0]]) <= limit:
        return Figure(f"Chance alone may make these: {follows} no varied number clearly", drawing, note)
    return Figure(f"{sentence(follows, '')} {spoken(ranked[0])} most", drawing, note)


def _chance(data: Dataset, tried: int) -> float:
    """The largest of several rank correlations that chance alone makes in 95 of 100 fleets (Bonferroni)."""
    from scipy.stats import norm

    return float(norm.ppf(1 - 0.025 / max(tried, 1))) / math.sqrt(max(len(data["fell"]), 1))


def _clear(data: Dataset, outcome: str) -> bool:
    """Whether dots of an outcome over the number that it follows most show a trend."""
    return max((abs(size) for size in _correlations(data, outcome).values()), default=0.0) > CLEAR


def _explained(data: Dataset, fallen: int) -> bool:
    """Whether a varied number tells who fell, by more falls than chance makes."""
    sizes = _correlations(data, "fell")
    return fallen >= ENOUGH and bool(sizes) and abs(next(iter(sizes.values()))) > _chance(data, len(sizes))


ENOUGH = 10  # falls: from fewer no cause is named


def over_strongest(data: Dataset, outcome: str) -> Figure | None:
    """An outcome over the varied number that it follows most: each robot a dot, or the fraction that fell."""
    sizes = _correlations(data, outcome)
    if not sizes:
        return None
    name, size = next(iter(sizes.items()))
    x, y = data[name].values.astype(np.float64), data[outcome].values.astype(np.float64)
    use = np.isfinite(y) & ((outcome == "fell") | (data["fell"].values == 0))
    x, y, unit = x[use], y[use], str(data[name].attrs.get("unit", "1"))
    if unit == "m" and len(x) and float(x.max()) < 1:
        x, unit = 1000 * x, "mm"
    across = f"{spoken(name)} [{unit}]"
    if outcome == "fell":
        parts = np.array_split(np.argsort(x), min(PARTS, max(len(x) // 20, 2)))
        figure, (ax,) = panels(["robots that fell [%]"], across)
        line(ax, "fell", [x[k].mean() for k in parts], [100 * y[k].mean() for k in parts], solid=True)
        ax.lines[0].set(marker="o", markersize=4)
        ax.set_ylim(-2, 102)
        ends = [f"{number(100 * float(y[k].mean()), 2)} %" for k in (parts[0], parts[-1])]
        title = f"Of the robots with the least {spoken(name)} {ends[0]} fall, of those with the most {ends[1]}"
        return Figure(title, figure, f"Each dot: one of {len(parts)} groups of as many robots.")
    unit = str(data[outcome].attrs["unit"])
    y = np.degrees(y) if unit == "rad" else y
    figure, (ax,) = panels([f"{data[outcome].attrs['long_name']} [{unit.replace('rad', '°')}]"], across)
    ends = [int(y.argmin()), int(y.argmax())]  # these are drawn too
    every = math.ceil(len(x) / DOTS)
    few = np.union1d(np.arange(0, len(x), max(every, 1)), ends)
    ax.plot(x[few], y[few], ".", markersize=3)
    drawn = "every second robot" if every == 2 else f"one of every {every} robots"
    dots = "each dot is a robot" if every <= 1 else f"each dot is a robot; {drawn} is drawn, and the least and the most"
    how = "grows" if size > 0 else "shrinks"
    if outcome == "peak_pitch":
        limit = math.degrees(STOP)
        far = f"; where a fall ends, {limit:.0f}°, is far above" if float(y.max()) < limit / 2 else ""
        if not far:
            ax.axhline(limit, linestyle="--", linewidth=1, color=AXIS)
            ax.annotate("a fall", (1, limit), (-4, -11), ha="right", **FRACTION)
            ax.set_ylim(0, 1.08 * limit)
        if len(y):
            reached = f"{number(float(y.min()), 3)} to {number(float(y.max()), 3)}°"
            clear = f" and {how} with {spoken(name)}" if abs(size) > CLEAR else ""
            alike = 0 < len(_correlations(data, outcome)) <= FEW and abs(size) <= _chance(data, 1)
            clear = f", whatever the {spoken(name)}" if alike else clear
            dots = f"{_still(data)}{sentence(dots, '')}"
            who = "Those that stood" if data["fell"].values.any() else "No robot fell"
            return Figure(f"{who}: the largest pitch is {reached}{clear}", figure, sentence(f"{dots}{far}"))
    return Figure(f"{_words(data, outcome)} {how} with {spoken(name)}: {dots}", figure)


CLEAR = 0.5  # [1] of a rank correlation: below, dots show no clear trend


def _words(data: Dataset, outcome: str) -> str:
    return sentence(str(data[outcome].attrs["long_name"]), "")


def _correlations(data: Dataset, outcome: str) -> dict[str, float]:
    """The rank correlation of an outcome with each varied number, the strongest first; none where nothing differs."""
    varied = [str(n) for n, v in data.data_vars.items() if str(n) not in OUTCOMES and np.ptp(v.values) > 0]
    y = data[outcome].values.astype(np.float64)
    use = np.isfinite(y) & ((outcome == "fell") | (data["fell"].values == 0))
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
        return push_map_page(result)
    if "recovered" in result:
        return basin_page(result)
    return _fleet_page(result, summarise(result))


def _fleet_page(data: Dataset, summary: Summary) -> Page:
    """Falls and quantiles of the robots, with the distribution of each outcome."""
    pushes = origin_of(data).get("scenario", {}).get("push")
    kept = summary.quantiles
    names = [name for name, row in kept.items() if np.isfinite(row[1]) and np.ptp(row) > 0]
    explained = _explained(data, summary.fell)
    quantiles, moved = _moving(data, summary)
    table = _quantiles(data, quantiles, moved)
    chance = summary.chance
    robot = origin_of(data)["robot"]["name"]
    after = f"`upright push-map --robot {robot}`, which finds the largest push"
    if not pushes:
        after = f"`upright fleet --robot {robot} --samples {summary.n} --push impulse:0.1` pushes them with 0.1 N s"
    few = 0 < len(_varied(data)) <= FEW
    all_vary = "; with `--vary spread` all numbers of the robot vary" if few else ""
    matters = _matters(data, "peak_pitch") if "peak_pitch" in names and not summary.fell else ""
    knocks = harder([origin_of(data)])
    acts = f" The push acts {where(pushes)}." if where(pushes) else ""
    seconds = origin_of(data).get("scenario", {}).get("seconds")
    lasts = f" Each run lasts {seconds:g} s." if seconds else ""
    says = f"{_untested(data) or matters}{_untold(summary, explained)}"
    lead = f"{_differ(data, robot)}{lasts}{acts}{knocks}{says} Next: {after}{all_vary}."
    rare = chance.value <= RARE
    above = f"{number(100 * chance.high, 2)} %"
    part = f"≤ {above}" if rare else f"{number(100 * chance.low, 2)} to {above}"
    sure = f"{'' if rare else 'each bound '}with 95 % confidence"
    limit = f"; a certificate allows {100 * MOST_FALLS:g} %" if pushes else ""
    numbers = [(part, f"of such robots fall{'' if pushes else ' while nothing disturbs them'}, {sure}{limit}")]
    most = {name: row[2] for name, row in quantiles.items()}
    standing = "those that stood" if summary.fell else f"all {summary.n}"
    who = f"95 % of {standing if moved is None else f'the {moved} that moved'}"
    if math.isfinite(most.get("peak_pitch", math.nan)):
        numbers.append((f"{number(math.degrees(most['peak_pitch']), 2)}°", f"is the most that {who} leaned"))
    if "settling" in kept and np.isfinite(kept["settling"]).all():
        _, half, longest = kept["settling"]
        after = _called(data, "settling").removeprefix("settling time ")
        numbers.append((f"{half:.3g} s", f"{after} half of them stay within {_BAND}; 95 % after {longest:.3g} s"))
    elif math.isfinite(most.get("travel", math.nan)):
        numbers.append((f"{1e3 * most['travel']:.3g} mm", f"is the furthest that {who} rolled"))
    outcomes = ["fell"] if explained else names[:1]
    trends = [name for name in outcomes if explained or matters or _clear(data, name)]
    causes = [figure for name in trends for figure in (over_strongest(data, name), influence(data, name)) if figure]
    histograms = [histogram(data, name) for name in names]
    picture = (causes or histograms or [None]).pop(0)
    spreads = (origin_of(data).get("vary") or {}).get("spreads", [])
    facts = {**provenance(data), **({"each run": f"{seconds:g} s"} if seconds else {})}
    sections = [
        Section("Numbers", [table]),
        *([Section("What matters", causes)] if causes else []),
        *([Section("Distributions", histograms, folded=True)] if histograms else []),
        *([Section("What varies", [spread_table(spreads, units_of(data))], folded=True)] if spreads else []),
    ]
    return Page(
        f"{summary.fell} of {summary.n} robots fell, {pushed(pushes)}", sections, lead, facts, False,
        picture=picture, numbers=numbers, verdict=_verdict(data, summary, knocks),
    )  # fmt: skip


def _untold(summary: Summary, explained: bool) -> str:
    """That the falls have no clear cause, as a sentence with a space before it; nothing where they have, or none is."""
    if not summary.fell or summary.fell == summary.n or explained:
        return ""
    few = f"{summary.fell} fall{' is' if summary.fell == 1 else 's are'} too few to tell why."
    return f" {few if summary.fell < ENOUGH else 'No varied number clearly tells which fall.'}"


def _varied(data: Dataset) -> list[str]:
    """The numbers in which the robots differ."""
    return [spread["name"] for spread in (origin_of(data).get("vary") or {}).get("spreads", [])]


def _verdict(data: Dataset, summary: Summary, knocks: str) -> Verdict:
    """A certificate pushes, and varies every number: without that, few falls are no green light."""
    verdict = falls_verdict(summary.fell, summary.n, knocks)
    names = _varied(data)
    if verdict.level == "bad":
        return verdict
    if not origin_of(data).get("scenario", {}).get("push"):
        return Verdict("not pushed", "info")
    if len(names) > FEW:
        return verdict
    varied = f"only {joined([spoken(name) for name in names])} varied" if names else "nothing but noise varied"
    return Verdict(f"{varied}: no certificate", "info")


def _differ(data: Dataset, robot: str) -> str:
    """Whose relatives, in what they differ, and what holds them."""
    names = _varied(data)
    kind = (origin_of(data).get("controller") or {}).get("kind", "")
    under = f", under the controller {kind}" if kind else ""
    if 0 < len(names) <= FEW:
        varied = joined([f"{spoken(name)}{_range(data, name)}" for name in names])
        return f"Simulated robots that differ from {robot} only in {varied}{under}; each has its own sensor noise."
    if not names:
        return f"Simulated robots with the numbers of {robot}{under}; only noise differs."
    spreads = sorted((origin_of(data).get("vary") or {})["spreads"], key=width)
    ends = [
        f"{size_of(spread, units_of(data).get(spread['name'], '')).removeprefix('by ')} ({spoken(spread['name'])})"
        for spread in (spreads[0], spreads[-1])
    ]
    return (
        f"Simulated robots that differ from {robot} in {len(names)} numbers, typically by {' to '.join(ends)}{under}."
    )


FEW = 3  # varied numbers that a sentence names


def units_of(data: Dataset) -> dict[str, str]:
    """The unit of each number of a fleet."""
    return {str(name): str(values.attrs.get("unit", "")) for name, values in data.data_vars.items()}


def _range(data: Dataset, name: str) -> str:
    if name not in data:
        return ""
    values, unit = data[name].values, data[name].attrs.get("unit", "")
    if unit == "m" and float(values.max()) < 1:
        values, unit = 1000 * values, "mm"
    return f" ({cell_text(float(values.min()), 3)} to {cell_text(float(values.max()), 3)}{f' {unit}' if unit else ''})"
