"""The page of a fleet: how many robots fell, how far the others leaned, and what decides."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.experiment.described import pushes_in_words
from upright.fleets.binomial import MOST_FALLS, RARE, clopper_pearson
from upright.fleets.origin import made_of, names_varied, spreads_of, spreads_table
from upright.fleets.results import OUTCOME_NAMES, origin_of
from upright.pages import Block, Column, Fold, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.terms import term

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from xarray import Dataset

    from upright.fleets.influence import Influence
    from upright.fleets.results import Summary

GROUPS = 12  # of as many robots each, of which the fraction that fell is drawn
DOTS = 500  # robots that a cloud shows at most


def fleet_page(data: Dataset, summary: Summary) -> Page:
    """The page of a fleet's outcomes."""
    origin = origin_of(data)
    pushes = origin.get("scenario", {}).get("push") or ()
    influence = summary.influence
    lead = [
        Say("Simulated: {robot} under {controller}, {n} numbers varied; {pushes}.", robot=origin["robot"]["name"],
            controller=(origin.get("controller") or {}).get("kind") or Say("a controller of one's own"),
            n=len(names_varied(data)), pushes=pushes_in_words(pushes))
    ]  # fmt: skip
    if influence.strongest:
        what, name = OUTCOME_NAMES[influence.outcome], term(influence.strongest)
        if influence.outcome == "fell":
            lead.append(Say("Whether a robot falls depends most on: {name}.", name=name))
        else:
            lead.append(Say("What the {outcome} depends on most: {name}.", outcome=what, name=name))
    elif summary.fell < summary.n:
        lead.append(Say("No varied number decides by more than chance."))
    drawn = [name for name, row in summary.quantiles.items() if row[2] > row[0]]
    pictures = [
        Picture(
            Say("How the {outcome} is distributed over the robots that stood", outcome=OUTCOME_NAMES[name]),
            functools.partial(distribution, data, name),
        )
        for name in drawn
    ]
    if influence.strongest:
        pictures.insert(0, _over(data, influence))
    first, *others = pictures or [None]
    folds: list[Block] = []
    if influence.correlations:
        folds.append(Fold(Say("What decides"), [_correlations(influence)]))
    if others:
        folds.append(Fold(Say("Distributions"), [picture for picture in others if picture]))
    if names_varied(data):
        units = {str(name): str(column.attrs.get("unit") or "") for name, column in data.data_vars.items()}
        folds.append(Fold(Say("What varies"), [spreads_table(spreads_of(data), units)]))
    return Page(
        Say("{fell} of {n} robots fell", fell=summary.fell, n=summary.n),
        verdict=_verdict(summary, bool(pushes), len(names_varied(data))),
        lead=lead, numbers=_numbers(summary), picture=first, next=[_next(data, bool(pushes))],
        blocks=[_quantiles(summary), *folds], origin=made_of(data),
    )  # fmt: skip


def _verdict(summary: Summary, pushed: bool, varied: int) -> Verdict:
    """A certificate pushes and varies every number: without that, few falls are no green light."""
    most = Quantity(None, "fraction", high=summary.chance.high, digits=2)
    if summary.fell > MOST_FALLS * summary.n:
        return Verdict(Say("too many fall: {most}", most=most), "bad")
    if not pushed:
        return Verdict(Say("nobody pushed them"))
    if not varied:
        return Verdict(Say("only noise varied: no certificate"))
    if varied <= FEW:
        return Verdict(Say("only {n} numbers varied: no certificate", n=varied))
    if summary.chance.high <= MOST_FALLS:
        return Verdict(Say("few fall: {most}", most=most), "good")
    return Verdict(Say("too few robots to tell: {most} fall", most=most), "warn")


FEW = 3  # varied numbers: with so few the robots are all but one robot


def falls_of(fell: int, n: int) -> Quantity:
    """How many fall: few at most, else between two bounds, each with 95 % confidence."""
    chance = clopper_pearson(fell, n)
    return Quantity(None, "fraction", low=None if chance.value <= RARE else chance.low, high=chance.high, digits=2)


def _numbers(summary: Summary) -> list[KeyNumber]:
    numbers = [KeyNumber(falls_of(summary.fell, summary.n), Say("of such robots fall (95 % confidence)"))]
    meanings = {
        "peak_pitch": Say("95 % of those that stood leaned less"),
        "settling": Say("after the last push 95 % had settled"),
        "travel": Say("95 % of those that stood rolled less far"),
    }
    for name, meaning in meanings.items():
        row = summary.quantiles.get(name)
        if row and math.isfinite(row[2]) and len(numbers) < 3:
            numbers.append(KeyNumber(Quantity(row[2], summary.units[name], digits=2), meaning))
    return numbers


def _quantiles(summary: Summary) -> Table:
    rows = [
        [
            OUTCOME_NAMES[name],
            *(Quantity(q, "fraction" if summary.units[name] == "1" else summary.units[name]) for q in row),
        ]
        for name, row in summary.quantiles.items()
    ]
    columns = [
        Column(Say("robots that stood")),
        Column(Say("5 % below")),
        Column(Say("half below")),
        Column(Say("95 % below")),
    ]
    return Table(columns, rows)


def _correlations(influence: Influence) -> Table:
    rows = [[term(name), size] for name, size in influence.correlations.items()]
    caption = Say(
        "Rank correlation with {outcome}; up to {chance} may be chance",
        outcome=OUTCOME_NAMES[influence.outcome],
        chance=Quantity(influence.chance, "1", digits=2),
    )
    return Table([Column(Say("varied number")), Column(Say("rank correlation"), "1", digits=2)], rows, caption)


def _over(data: Dataset, influence: Influence) -> Picture:
    """The outcome over the number that it follows most: each robot a dot, or the fraction that fell."""
    name = influence.strongest
    assert name
    claim = Say(
        "The {outcome}, robot by robot, over the {name}", outcome=OUTCOME_NAMES[influence.outcome], name=term(name)
    )
    return Picture(claim, functools.partial(_draw_over, data, name, influence.outcome))


def _draw_over(data: Dataset, name: str, outcome: str) -> Figure:
    from upright.plotting import line, panels

    x = data[name].values.astype(np.float64)
    y = data[outcome].values.astype(np.float64)
    across = f"{term(name)} [{data[name].attrs.get('unit') or '1'}]"
    if outcome == "fell":
        figure, (ax,) = panels([str(Say("robots that fell [%]"))], across)
        groups = np.array_split(np.argsort(x), min(GROUPS, max(len(x) // 20, 2)))
        line(ax, str(Say("fell")), [x[g].mean() for g in groups], [100 * y[g].mean() for g in groups], solid=True)
        ax.set_ylim(-2, 102)
        return figure
    use = np.flatnonzero(np.isfinite(y) & (data["fell"].values == 0))
    use = use[:: max(1, math.ceil(len(use) / DOTS))]
    unit = str(data[outcome].attrs["unit"])
    factor = 180 / math.pi if unit == "rad" else 1.0
    figure, (ax,) = panels([f"{OUTCOME_NAMES[outcome]} [{unit.replace('rad', '°')}]"], across)
    ax.plot(x[use], factor * y[use], ".", markersize=3)
    return figure


def _next(data: Dataset, pushed: bool) -> Next:
    robot = str(origin_of(data)["robot"]["name"])
    if pushed:
        return Next("push_map", robot=robot)
    return Next("fleet", robot=robot, push="impulse:0.1", why=Say("A push shows more than noise does."))


def distribution(data: Dataset, outcome: str, bins: int = 60) -> Figure:
    """The fraction of the robots that stood over an outcome of theirs, as a histogram."""
    from upright.plotting import panels

    values = stood(data, outcome)
    unit = str(data[outcome].attrs["unit"])
    if unit in ("rad", "rad/s"):
        values = np.degrees(values)
        unit = unit.replace("rad", "°")
    words = str(data[outcome].attrs["long_name"])
    if unit == "1":
        values = 100 * values
        unit = "%"
    figure, (ax,) = panels(["robots [%]"], f"{words} [{unit}]", height=1.4)
    if len(values):
        ax.hist(values, _borders(values, bins), weights=np.full(len(values), 100 / len(values)), histtype="stepfilled",
                alpha=0.8)  # fmt: skip
    return figure


def _borders(values: Array, bins: int) -> int | list[float]:
    """Borders between the values where these are few, as of counted periods; other bins would look like a comb."""
    few = np.unique(np.round(values, 9))
    step = float(np.diff(few).min()) if len(few) > 1 else 0.0
    if not step or np.ptp(few) > bins * step:
        return bins
    return [float(few[0]) + step * (k - 0.5) for k in range(round(float(np.ptp(few)) / step) + 2)]


def stood(data: Dataset, outcome: str) -> Array:
    """An outcome of the robots that stood, as far as they have one."""
    values = data[outcome].values[data["fell"].values == 0]
    return values[np.isfinite(values)]
