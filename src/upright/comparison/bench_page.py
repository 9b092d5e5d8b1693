"""The page of a `Bench`: which controller to take, by the knock that it survives, its falls and its time on a brick."""

from __future__ import annotations

import functools
import math
from typing import Any

from upright.fleets.binomial import upper_bound
from upright.pages import Column, Fold, Items, KeyNumber, Message, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.blocks import Cell

Bench = Any  # these are those of `bench.py`, which imports this file
BenchRow = Any

PUSHES = {"front": 0.1, "back": -0.12}
"""Pitch [rad] at which each push holds the robot (Herrera et al. 2015, section 3.2)."""


def push_name(side: str) -> str:
    """What a push of `PUSHES` is called in data."""
    return f"{side}, {PUSHES[side]:+.2f} rad".replace("-", "−")


PUSH_WORDS = {
    push_name("front"): Say("front, at {lean}", lean=Quantity(PUSHES["front"], "rad", digits=2)),
    push_name("back"): Say("back, at {lean}", lean=Quantity(PUSHES["back"], "rad", digits=2)),
}

FEW = 4  # curves that can be told apart in one panel


def bench_page(bench: Bench) -> Page:
    """The page of a bench."""
    ranked: dict[str, float] = bench.ranked()
    knocked = any(not math.isnan(size) for size in ranked.values())
    take = bench.take if knocked else ""
    held = Say("hold the robot: {n} of {m}", n=len(bench.held), m=len(ranked))
    tolerance = Quantity(bench.tolerance, "fraction")
    lead = [
        Say("Each controller drove {robot} ({body}): let go from a lean, then knocked ever harder.",
            robot=bench.robot, body=bench.body),
    ]  # fmt: skip
    if take and len(bench.tied) > 1:
        lead.append(Say("Of those quick enough {n} are equal within {tolerance}; {take} needs the least effort.",
                        n=len(bench.tied), tolerance=tolerance, take=take))  # fmt: skip
    ranking = Picture(
        Say("Largest knock that each survives: green to be taken, grey too slow for the brick"), bench.plot,
        Say("The smaller limit of knocks from front and back. Equal places differ by less than {tolerance}.",
            tolerance=tolerance),
    )  # fmt: skip
    left_out = [Items([Say("Left out: {why}", why=list(map(Message, bench.left_out)))])] if bench.left_out else []
    pushes = [push_table(bench, push) for push in dict.fromkeys(row.push for row in bench.rows)]
    shown = [responses(bench)] if knocked else []
    verdict = Verdict(held, "good" if bench.held else "bad")
    if take:
        verdict = Verdict(Say("take {name}", name=take), "good")
        if bench.worse(take, "spread") is None:
            verdict = Verdict(Say("{name} leads; no falls counted", name=take), "unknown")
    best = take or next(iter(ranked), "")
    return Page(
        _title(bench, take) if knocked else held,
        verdict=verdict,
        lead=lead, numbers=_numbers(bench, take) if take else [], picture=ranking if knocked else responses(bench),
        next=[Next("certify", best, robot=bench.robot, why=Say("It pushes robots that differ, and counts falls."))],
        blocks=[_summary(bench), *shown, *left_out, Fold(Say("Numbers under each push"), pushes)],
        origin={"robot": bench.robot, "kit": bench.kit, "body": bench.body, "seed": str(bench.seed)},
    )  # fmt: skip


def _title(bench: Bench, take: str) -> Say:
    firsts = [name for name, place in bench.places().items() if place == 1]
    size = Quantity(next(iter(bench.ranked().values())), "N s", digits=2)
    if take and take not in firsts:
        names = [name for name in bench.ranked() if name not in bench.quick and name in firsts]
        return Say("Take {take}: {names} survives more, but is too slow for the brick", take=take, names=names)
    if take and len(bench.tied) > 1:
        return Say(
            "Take {take}: of {n} equally strong controllers it needs the least effort", take=take, n=len(bench.tied)
        )
    return Say("Survives the largest knock, {size}: {names}", size=size, names=firsts)


def _numbers(bench: Bench, take: str) -> list[KeyNumber]:
    """The knock that the controller to take survives, its falls, and its time on the brick or its effort."""
    best, size = next(iter(bench.ranked().items()))
    meaning = Say("largest knock that {take} survives", take=take)
    if best != take:
        meaning = Say("largest knock that {take} survives; {best} {size}", take=take, best=best,
                      size=Quantity(size, "N s", digits=2))  # fmt: skip
    numbers = [KeyNumber(Quantity(bench.ranked()[take], "N s", digits=2), meaning)]
    falls = bench.worse(take, "spread")
    time = bench.computing_time(take)
    effort = bench.worse(take, "effort")
    if falls is not None:
        most = Quantity(None, "fraction", high=upper_bound(round(falls * bench.drawn), bench.drawn), digits=2)
        numbers.append(KeyNumber(most, Say("of similar robots fall (95 % confidence)")))
    if time is not None:
        period = Quantity(bench.period, "s")
        meaning = Say("of computing in each period of {period}", period=period)
        if best != take and (slow := bench.computing_time(best)):
            meaning = Say("of computing in each period of {period}; {best} {slow}", period=period, best=best,
                          slow=Quantity(slow, "s", digits=2))  # fmt: skip
        numbers.append(KeyNumber(Quantity(time, "s", digits=2), meaning))
    elif effort is not None:
        numbers.append(KeyNumber(Quantity(effort, bench.effort_unit, digits=2), Say("effort")))
    return numbers


def _summary(bench: Bench) -> Table:
    """What counts of each controller, under the worse push, the best first."""
    rests = [bench.rest(push) for push in dict.fromkeys(row.push for row in bench.rows)]
    rows: list[list[Cell]] = []
    for name, size in bench.ranked().items():
        settled = max((rest.get(name, math.nan) for rest in rests), default=math.nan)
        slow = bool(rests) and any(math.isnan(rest.get(name, math.nan)) for rest in rests)
        falls, effort = (bench.worse(name, figure) for figure in ("spread", "effort"))
        rows.append([name, size, falls, bench.computing_time(name), effort, None if slow else settled])
    columns = [
        Column(Say("controller")), Column(Say("knock"), "N s"), Column(Say("falls"), "fraction"),
        Column(Say("computing"), "s"), Column(Say("effort"), bench.effort_unit), Column(Say("settling"), "s"),
    ]  # fmt: skip
    return Table(columns, rows, Say("The best first; each number from the push under which it is worse"))


def push_table(bench: Bench, push: str) -> Table:
    """What each controller does under one push."""
    rest = bench.rest(push)
    place = {name: k for k, name in enumerate(bench.ranked())}
    rows: list[list[Cell]] = [
        [row.controller, _holds(row), row.peak, rest.get(row.controller), row.travel, row.effort, row.saturated,
         row.impulse, row.spread]
        for row in sorted(bench.rows, key=lambda row: place.get(row.controller, len(place)))
        if row.push == push
    ]  # fmt: skip
    columns = [
        Column(Say("controller")), Column(Say("holds")), Column(Say("largest pitch"), "rad"),
        Column(Say("settling"), "s"), Column(Say("wheels turn"), "rad"), Column(Say("effort"), bench.effort_unit),
        Column(Say("at the motors' limit"), "fraction"), Column(Say("knock"), "N s"),
        Column(Say("falls"), "fraction"),
    ]  # fmt: skip
    return Table(columns, rows, Say("Held in a lean and let go: from the {push}", push=PUSH_WORDS.get(push, push)))


def _holds(row: BenchRow) -> Verdict | Say:
    if row.holds:
        return Verdict(Say("yes"), "good")
    if row.fell_at is not None:
        return Verdict(Say("fell after {time}", time=Quantity(row.fell_at, "s", digits=2)), "bad")
    return Message(row.outcome)


def responses(bench: Bench) -> Picture:
    """Pitch under every controller and push; of many only the one to take, the best, and the last."""
    ranked = [*bench.ranked()]
    first = [bench.take] if bench.take else []
    order = [*first, *(name for name in ranked if name not in first)]
    few = order if len(order) <= FEW else [*order[: FEW - 1], order[-1]]
    claim = Say("Pitch while pushed and let go: {names}", names=few)
    return Picture(claim, functools.partial(bench.plot_responses, *few))
