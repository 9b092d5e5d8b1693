"""The page of a fleet: how many robots fell, how far the others leaned, and what decides."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.experiment.described import law_in, law_in_words, name_in, pushes_in_words
from upright.fleets.binomial import MOST_FALLS, RARE, clopper_pearson, upper_bound
from upright.fleets.ensemble import OUTCOMES
from upright.fleets.origin import made_of, names_varied, pushes_of, spreads_of, spreads_table
from upright.fleets.results import origin_of
from upright.pages import Block, Column, Fold, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.terms import term
from upright.pages.words import shown_in

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from upright.fleets.influence import Influence
    from upright.fleets.results import Summary

GROUPS = 12  # of as many robots each, of which the fraction that fell is drawn
NAMED = 3  # varied numbers that a sentence names: more are counted, and stand in a fold
ALIKE = 3  # varied numbers: with so few the robots are all but one robot, and a certificate varies every number
DOTS = 500  # robots that a cloud shows at most


def fleet_page(data: Dataset, summary: Summary) -> Page:
    """The page of a fleet's outcomes."""
    origin = origin_of(data)
    pushes = pushes_of(origin)
    influence = summary.influence
    names = names_varied(data)
    varied = len(names)
    robot = name_in(origin, "robot")
    made = {"robot": robot, "law": law_in_words(origin)}
    lead = [Say("Each run simulates {robot} under {law}; only the noise differs.", **made)]
    if 0 < varied <= NAMED:
        lead = [
            Say("Each run simulates {robot} under {law}; what varies: {names}.", **made, names=list(map(term, names)))
        ]
    elif varied:
        lead = [Say("Each run simulates {robot} under {law}, with {n} numbers varied.", **made, n=varied)]
    if influence.strongest:
        lead.append(Say("What happens depends most on: {name}.", name=term(influence.strongest)))
    elif varied and summary.fell < summary.n:
        lead.append(Say("No varied number decides by more than chance."))
    picture = _over(data, influence) if influence.strongest else None
    if not picture and summary.fell < summary.n:
        picture = _distributed(data, summary, "peak_pitch")
    folds: list[Block] = []
    if influence.correlations:
        folds.append(Fold(Say("What decides"), [_correlations(influence)]))
    if varied:
        units = {str(name): str(column.attrs.get("unit") or "") for name, column in data.data_vars.items()}
        folds.append(Fold(Say("What varies"), [spreads_table(spreads_of(data), units)]))
    title = Say("The robot fell in {fell} of {n} runs without a push", fell=summary.fell, n=summary.n)
    following = Next(
        "certify", law_in(origin) or "lqr", robot=robot, why=Say("It varies every number, pushes and counts falls.")
    )
    if pushes:
        title = Say("The robot fell in {fell} of {n} runs with {pushes}", fell=summary.fell, n=summary.n,
                    pushes=pushes_in_words(pushes))  # fmt: skip
    else:
        following = Next("fleet", robot=robot, push="impulse:0.1", why=Say("A push shows more than noise does."))
    verdict = verdict_of(summary.fell, summary.n, pushed=bool(pushes))
    if varied <= ALIKE and verdict.level in ("good", "warn"):
        verdict = Verdict(Say("too little varied: no certificate"))
    if verdict.level == "bad":
        following = Next("push_map", robot=robot, why=Say("It finds the largest push that the robot survives."))
    return Page(
        title, verdict=verdict, lead=lead, numbers=_numbers(summary), picture=picture, next=[following],
        blocks=[*([_quantiles(summary)] if summary.fell < summary.n else []), *folds], origin=made_of(data),
    )  # fmt: skip


def verdict_of(fell: int, n: int, *, pushed: bool) -> Verdict:
    """As a certificate judges, by the upper bound of the falls; it also pushes: without that few falls are no green
    light."""
    bound = upper_bound(fell, n)
    most = Quantity(None, "fraction", high=bound, digits=2)
    if fell > MOST_FALLS * n:
        return Verdict(Say("too many fall: {part}", part=falls_of(fell, n)), "bad")
    if not pushed:
        return Verdict(Say("nobody pushed them"))
    if bound <= MOST_FALLS:
        return Verdict(Say("few fall: {most}", most=most), "good")
    return Verdict(Say("too few robots to tell: {most} fall", most=most), "warn")


def falls_of(fell: int, n: int) -> Quantity:
    """How many fall: few at most, else between two bounds, each with 95 % confidence."""
    chance = clopper_pearson(fell, n)
    return Quantity(None, "fraction", low=None if chance.value <= RARE else chance.low, high=chance.high, digits=2)


def _numbers(summary: Summary) -> list[KeyNumber]:
    allowed = Say("of such runs end in a fall, with 95 % confidence; a certificate allows {limit}",
                  limit=Quantity(MOST_FALLS, "fraction"))  # fmt: skip
    numbers = [KeyNumber(falls_of(summary.fell, summary.n), allowed)]
    meanings = {
        "peak_pitch": Say("95 % of those that stood leaned less than this"),
        "settling": Say("after the last push: by then 95 % were calm"),
        "travel": Say("95 % of those that stood stayed this near to the start"),
    }
    for name, meaning in meanings.items():
        row = summary.quantiles.get(name)
        if row and math.isfinite(row[2]) and len(numbers) < 3:
            numbers.append(KeyNumber(_shown(summary, name, row[2]), meaning))
    return numbers


def _shown(summary: Summary, name: str, value: float) -> Quantity:
    return Quantity(value, "fraction" if summary.units[name] == "1" else summary.units[name])


def _name(outcome: str) -> Say:
    return OUTCOMES[outcome][1]


def _quantiles(summary: Summary) -> Table:
    rows = [[_name(name), *(_shown(summary, name, q) for q in row)] for name, row in summary.quantiles.items()]
    names = Say("robots that stood"), Say("5 % below"), Say("half below"), Say("95 % below")
    return Table([Column(name) for name in names], rows)


def _correlations(influence: Influence) -> Table:
    rows = [[term(name), size] for name, size in influence.correlations.items()]
    caption = Say(
        "Rank correlation with {outcome}; up to {chance} may be chance",
        outcome=_name(influence.outcome),
        chance=Quantity(influence.chance, "1", digits=2),
    )
    return Table([Column(Say("varied number")), Column(Say("rank correlation"), "1", digits=2)], rows, caption)


def _over(data: Dataset, influence: Influence) -> Picture:
    """The outcome over the number that it follows most: each robot a dot, or the fraction that fell."""
    name = influence.strongest
    assert name
    of = {"name": term(name)}
    rising = influence.correlations[name] > 0
    draw = functools.partial(_draw_over, data, name, influence.outcome)
    if influence.outcome == "fell":
        claim = Say("Large {name}: more robots fall", **of) if rising else Say("Small {name}: more robots fall", **of)
        return Picture(claim, draw)
    claim = Say("Large {name}: it leans further", **of) if rising else Say("Small {name}: it leans further", **of)
    return Picture(claim, draw, Say("Each dot is a robot that stood."))


def _draw_over(data: Dataset, name: str, outcome: str) -> Figure:
    from upright.plotting import line, panels

    x = data[name].values.astype(np.float64)
    y = data[outcome].values.astype(np.float64)
    across = f"{term(name)} [{data[name].attrs.get('unit') or '1'}]"
    if outcome == "fell":
        figure, (ax,) = panels([str(Say("robots that fell [%]"))], across)
        groups = np.array_split(np.argsort(x), min(GROUPS, max(len(x) // 20, 2)))
        line(ax, str(Say("fell")), [x[g].mean() for g in groups], [100 * y[g].mean() for g in groups], solid=True)
        ax.set_ylim(0)
        return figure
    use = np.flatnonzero(np.isfinite(y) & (data["fell"].values == 0))
    use = use[:: max(1, math.ceil(len(use) / DOTS))]
    factor, unit = shown_in(str(data[outcome].attrs["unit"]), float(y[use].max(initial=0.0)))
    figure, (ax,) = panels([f"{_name(outcome)} [{unit}]"], across)
    ax.plot(x[use], factor * y[use], ".", markersize=3)
    return figure


def _distributed(data: Dataset, summary: Summary, name: str) -> Picture:
    _, half, most = (_shown(summary, name, q) for q in summary.quantiles[name])
    claim = Say("Of those that stood, half have a {outcome} below {half}, and 95 % below {most}",
                outcome=_name(name), half=half, most=most)  # fmt: skip
    return Picture(claim, functools.partial(distribution, data, name))


def distribution(data: Dataset, outcome: str, bins: int = 60) -> Figure:
    """The fraction of the robots that stood over an outcome of theirs, as a histogram."""
    from upright.plotting import AXIS, legend, panels

    values = data[outcome].values[data["fell"].values == 0]
    values = values[np.isfinite(values)]
    unit = str(data[outcome].attrs["unit"])
    factor, unit = shown_in("fraction" if unit == "1" else unit, float(values.max(initial=0.0)))
    values = factor * values
    figure, (ax,) = panels([str(Say("runs [%]"))], f"{_name(outcome)} [{unit}]", height=1.4)
    if len(values):
        ax.hist(values, _edges(values, bins), weights=np.full(len(values), 100 / len(values)), histtype="stepfilled",
                alpha=0.8)  # fmt: skip
        ax.axvline(np.median(values), color=AXIS, label=str(Say("half below")))
        ax.axvline(np.quantile(values, 0.95), linestyle="--", color=AXIS, label=str(Say("95 % below")))
    return legend(figure)


def _edges(values: Array, bins: int) -> int | list[float]:
    """So many bins at most; of fewer values than that, as of counted periods, the borders halfway between them."""
    unique = np.unique(np.round(values, 9))
    repeated = 2 * len(unique) <= len(values)  # else a bin for each would hold one robot, and show nothing
    if not (repeated and 1 < len(unique) < bins):
        return min(bins, len(unique))
    middle = (unique[1:] + unique[:-1]) / 2
    first = float(2 * unique[0] - middle[0])
    last = float(2 * unique[-1] - middle[-1])
    return [first, *middle.tolist(), last]
