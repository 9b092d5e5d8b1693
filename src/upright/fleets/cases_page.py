"""The page of a campaign: in which cases robots fall, and what makes the difference."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.experiment.described import facts_of, pushes_in_words
from upright.fleets.binomial import MOST_FALLS
from upright.fleets.fleet_page import falls_of, verdict_of
from upright.fleets.origin import pushes_of, spreads_table
from upright.fleets.tally import END, CaseSummary, Tally
from upright.languages import number
from upright.pages import (
    Block,
    Column,
    Fold,
    Items,
    KeyNumber,
    Next,
    Page,
    Picture,
    Quantity,
    Say,
    Table,
    Verdict,
)
from upright.pages.blocks import Cell
from upright.pages.terms import term

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DRAWN = 40  # cases at most in a figure
FEW = 4  # cases, which are told apart in any case
LISTED = 12  # cases at most that are shown one by one
MATTER = 8  # drawn numbers in a table

LIMIT = Quantity(MOST_FALLS, "fraction")
LABELS = {"robot": Say("robot"), "controller": Say("controller"), "scenario": Say("scenario")}


def cases_page(cases: Tally) -> Page:
    """The page of a campaign."""
    counted = cases.worst_first()
    alike = cases.alike() if len(cases) > FEW else []
    together = cases.merged(alike) if alike and counted else cases
    shown = cases if len(cases) <= LISTED else together
    blocks: list[Block] = [_table(shown, LISTED)]
    if shown is not cases or len(cases) > LISTED:
        blocks.append(Fold(Say("All cases"), [_table(cases, len(cases))]))
    if drawn := _drawn(cases):
        blocks.append(Fold(Say("What decides"), [drawn]))
    if cases.spreads and "robot" not in cases.varied():  # they are those of the first case
        blocks.append(Fold(Say("What varies"), [spreads_table(cases.spreads, cases.units)]))
    if scenarios := _scenarios(cases):
        blocks.append(Fold(Say("Scenarios"), [scenarios]))
    if not counted:
        title = Say("Cases: {n}; who fell is not kept", n=len(cases))
        return Page(title, blocks=blocks, origin=_made_of(cases))
    return Page(
        _title(shown), verdict=_verdict(cases, counted), lead=_lead(cases, alike),
        numbers=_numbers(cases, counted), picture=_picture(shown), next=_next(counted), blocks=blocks,
        origin=_made_of(cases),
    )  # fmt: skip


def _title(shown: Tally) -> Say:
    worst, *others = shown.worst_first()
    if not worst.fell:
        return Say("No robot fell in any case")
    if not others:
        return Say("{fell} of {n} robots fell", fell=worst.fell, n=worst.n)
    decisive = shown.decisive()
    if decisive:
        name, levels = decisive
        first, *_, last = levels
        most = {
            value: max(_value(case) for case in shown.worst_first() if case.labels.get(name, "") == value)
            for value in (first, last)
        }
        facts = {
            "worst": shown.labelled(name, first),
            "best": shown.labelled(name, last),
            "most": Quantity(most[first], "fraction", digits=2),
        }
        if not most[last]:
            return Say("Up to {most} of the robots fall with {worst}, none with {best}", **facts)
        least = Quantity(most[last], "fraction", digits=2)
        return Say("Up to {most} of the robots fall with {worst}, up to {least} with {best}", least=least, **facts)
    return Say("Worst: {case}, {part} of the robots fall", case=shown.name(worst), part=_part(worst))


def _verdict(cases: Tally, counted: Sequence[CaseSummary]) -> Verdict:
    """As a certificate judges the worst case."""
    above = sum((case.fell or 0) > MOST_FALLS * case.n for case in counted)
    if above:
        return Verdict(Say("over {limit} fall in {n} of {all} cases", limit=LIMIT, n=above, all=len(cases)), "bad")
    pushed = not cases.origins or any(map(pushes_of, cases.origins))
    return verdict_of(counted[0].fell or 0, counted[0].n, pushed=pushed)


def _lead(cases: Tally, alike: Sequence[str]) -> list[Say]:
    worst, *_ = cases.worst_first()
    facts: dict[str, Any] = {"n": len(cases), "robots": sum(case.n for case in cases)}
    lead = [Say("{robots} robots were simulated in {n} cases, and nobody pushed them.", **facts)]
    if pushes := pushes_of(cases.origins[cases.index(worst)]) if cases.origins else ():
        facts["pushes"] = pushes_in_words(pushes)
        lead = [Say("{robots} robots were simulated in {n} cases; the worst case has {pushes}.", **facts)]
    labels = [LABELS.get(name, term(name)) for name in alike]
    if decisive := cases.decisive():
        label = LABELS.get(decisive[0], term(decisive[0]))
        if alike:
            lead.append(Say("The {label} decides; no clear difference by {alike}.", label=label, alike=labels))
        else:
            lead.append(Say("Most depends on the {label}.", label=label))
    elif len(cases) > 1:
        lead.append(Say("No difference between the cases is clear."))
    return lead


def _value(case: CaseSummary) -> float:
    return case.chance.value if case.chance else 0.0


def _part(case: CaseSummary) -> Quantity | None:
    """The fraction that fell; of cases together it is no whole number of robots."""
    return Quantity(case.chance.value, "fraction", digits=2) if case.chance else None


def _numbers(cases: Tally, counted: Sequence[CaseSummary]) -> list[KeyNumber]:
    worst, *_ = counted
    decides: list[KeyNumber] = []
    for name, (_, least, most) in [*cases.drawn().items()][:1]:
        ends = Say("{small} and {large}", small=Quantity(least, "fraction", digits=2),
                   large=Quantity(most, "fraction", digits=2))  # fmt: skip
        part = Quantity(END, "fraction")
        meaning = Say(
            "fall of the {part} with the least and of those with the largest {name}", part=part, name=term(name)
        )
        decides.append(KeyNumber(ends, meaning))
    numbers = [KeyNumber(falls_of(worst.fell or 0, worst.n), Say("fall in the worst case (95 % confidence)"))]
    if len(counted) > 1:
        safe = sum(not case.fell for case in counted)
        numbers.append(KeyNumber(Say("{n} of {all}", n=safe, all=len(counted)), Say("cases in which no robot fell")))
    return [*numbers, *decides]


def _picture(shown: Tally) -> Picture:
    return Picture(Say("Robots that fell in each case, the worst on top"), functools.partial(draw_cases, shown))


def draw_cases(cases: Tally) -> Figure:
    """The fraction that fell in each case [%], the worst first, beside the limit of a certificate."""
    from upright.plotting import AXIS, COLOURS, INK, LETTER, legend, rows_of

    worst = cases.worst_first()[:DRAWN]
    labels = [str(cases.name(case)) for case in worst]
    figure, ax = rows_of(labels, str(Say("robots that fell [%]")), str(Say("case")))
    chances = [(chance.value, chance.low, chance.high) for case in worst if (chance := case.chance)]
    percent = 100 * np.array(chances).reshape(-1, 3)
    rows = np.arange(len(worst))
    limit = 100 * MOST_FALLS
    ax.barh(rows, percent[:, 0], height=0.6, color=[COLOURS[1 if value > limit else 0] for value in percent[:, 0]])
    bounds = str(Say("95 % confidence"))
    ax.hlines(rows, percent[:, 1], percent[:, 2], linewidth=1.2, color=INK, zorder=3, label=bounds)
    allowed = str(Say("a certificate allows {limit}", limit=LIMIT))
    ax.axvline(limit, linestyle="--", linewidth=1, color=AXIS, label=allowed)
    most = 1.3 * max(limit, percent[:, 2].max())
    letter = LETTER / figure.get_figwidth() / ax.get_position().width * most
    for row, (value, _, high) in enumerate(percent.tolist()):
        text = f"{number(value, 2)} %"
        at = limit if high < limit < high + letter * (len(text) + 1) else high  # not across the line of the limit
        ax.annotate(text, (at, row), (4, 0), textcoords="offset points", va="center")
    ax.set_xlim(0, most)
    if ax.get_xlim()[1] > 100:  # room for the numbers, but no tick above 100 %
        ax.set_xticks(np.arange(0, 101, 25))
    return legend(figure)


def _table(cases: Tally, most: int) -> Table:
    """At most so many cases with their falls, the worst first, and means of the robots that stood."""
    kinds = {
        "peak_pitch": Column(Say("pitch"), "rad"), "settling": Column(Say("settles"), "s"),
        "effort": Column(Say("effort"), "V² s"),
    }  # fmt: skip
    shown = [name for name in kinds if any(name in case.outcomes for case in cases)]
    rows: list[list[Cell]] = []
    for case in (cases.worst_first() or cases)[:most]:
        rows.append([cases.name(case), _part(case), case.n, *(case.mean(outcome) for outcome in shown)])
    caption = Say("Cases, the worst first; means of the robots that stood") if shown else None
    columns = [Column(Say("case")), Column(Say("fell")), Column(Say("robots"))]
    return Table([*columns, *(kinds[name] for name in shown)], rows, caption)


def _drawn(cases: Tally) -> Table | None:
    """The drawn numbers over which falls change most."""
    part = Quantity(END, "fraction")
    rows: list[list[Cell]] = [
        [term(name), least, most, cases.name(case)]
        for name, (case, least, most) in list(cases.drawn().items())[:MATTER]
    ]
    columns = [
        Column(Say("varied number")), Column(Say("small: fell"), "fraction"), Column(Say("large: fell"), "fraction"),
        Column(Say("case")),
    ]  # fmt: skip
    caption = Say("Falls of the {part} with the smallest and of the {part} with the largest value", part=part)
    return Table(columns, rows, caption) if rows else None


def _scenarios(cases: Tally) -> Items | None:
    """What is done to the robots in each scenario."""
    if len(cases.origins) != len(cases):
        return None
    pushes = {str(c.labels.get("scenario", "")): pushes_of(o) for c, o in zip(cases, cases.origins, strict=True)}
    items = [Say("{name}: {pushes}", name=name, pushes=pushes_in_words(push)) for name, push in pushes.items() if name]
    return Items(items) if items else None


def _next(counted: Sequence[CaseSummary]) -> list[Next]:
    """Where too many fall, the largest push that the worst case survives; else a certificate."""
    worst = counted[0]
    robot, controller = (str(worst.labels.get(name, "")) or None for name in ("robot", "controller"))
    if (worst.fell or 0) > MOST_FALLS * worst.n:
        why = Say("It finds the largest push that this robot and controller survive.")
        return [Next("push_map", robot=robot, controller=controller, why=why)]
    why = Say("It tries what a campaign leaves out.")
    return [Next("certify", controller or "lqg", robot=robot, why=why)]


def _made_of(cases: Tally) -> dict[str, str]:
    """Seed, length of the runs and versions, as of the first case."""
    origin = cases.origins[0] if cases.origins else {}
    seconds = origin.get("scenario", {}).get("seconds")
    facts = {name: text for name, text in facts_of(origin).items() if name in ("seed", "versions")}
    return facts | ({"each run": str(Quantity(float(seconds), "s"))} if seconds else {})
