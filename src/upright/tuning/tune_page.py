"""The page of a `Tuned`: what was won and what it costs beside the default, and the candidates by name."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from upright.pages import Column, Fold, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.blocks import Cell
from upright.tuning.figures import MEASURES, Figures, Measure, fell_once

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Tuned = Any  # that of `tune.py`, which imports this file

LIGHTS = {
    "green": Verdict(Say("green"), "good"), "amber": Verdict(Say("amber"), "warn"), "red": Verdict(Say("red"), "bad"),
    "unknown": Verdict(Say("unknown"), "unknown"),
}  # fmt: skip
NAMES = {
    "falls": Say("robots that fall"), "knock": Say("largest knock survived"), "delay": Say("delay margin"),
    "stronger": Say("gain margin upward"), "weaker": Say("gain margin downward"),
    "settling": Say("settling time"), "effort": Say("effort"), "saturated": Say("time at the motors' limit"),
    "travel": Say("distance rolled"), "sway": Say("sway at rest"),
}  # fmt: skip
WORSE = {
    "falls": Say("falls"), "light": Say("light"), "knock": Say("knock"), "stability": Say("stability"),
    "gain margin": Say("gain margin"), "delay margin": Say("delay margin"),
}  # fmt: skip
CHANGES = {"won": Verdict(Say("better"), "good"), "paid": Verdict(Say("worse"), "warn"), "": Say("alike")}


def tune_page(tuned: Tuned) -> Page:
    """The page of a tuning."""
    lead = [Say("Candidates tried for {robot}: {n}.", robot=tuned.robot, n=tuned.evaluated)]
    if _compared(tuned):
        lead = [
            Say("The best candidate for {robot}, of {n}, was judged on {new} robots that the search never saw.",
                robot=tuned.robot, n=tuned.evaluated, new=tuned.default.samples),
            *_falls(tuned),
        ]  # fmt: skip
    others = len(tuned.front) - 1
    compared = _compared(tuned)
    changes = Say("The candidate beside the default: green is better, orange worse, grey may be chance")
    folds = [Fold(Say("Candidates"), [_candidates(tuned)])] if others else []
    return Page(
        _title(tuned), verdict=_verdict(tuned), lead=lead, numbers=_numbers(tuned),
        picture=Picture(changes, tuned.plot) if compared else None, next=[_next(tuned)],
        blocks=[_beside(tuned), Fold(Say("Weights"), [_weights(tuned)]), *folds],
        origin={"kit": tuned.kit, "seed": str(tuned.seed)},
    )  # fmt: skip


def _compared(tuned: Tuned) -> bool:
    """Whether a candidate was judged beside the default."""
    return bool(tuned.refused) or not tuned.kept


def _falls(tuned: Tuned) -> list[Say]:
    """Whether the falls of the same robots differ beyond what chance explains."""
    was, now = tuned.default, tuned.tried
    here, there = fell_once(now, was)
    if not here + there:
        return []
    counts = {"here": here, "there": there}
    if now.falls_more(was) or was.falls_more(now):
        return [
            Say("Fell with the candidate only: {here}; by default only: {there}. That is more than chance.", **counts)
        ]
    return [Say("Fell with the candidate only: {here}; by default only: {there}. That may be chance.", **counts)]


def _verdict(tuned: Tuned) -> Verdict:
    if tuned.kept:
        return Verdict(Say("keep the default weights"))
    light = LIGHTS[tuned.chosen.light]
    if light.level == "bad":
        return Verdict(Say("tuned, but still {light}", light=light.text), light.level)
    return Verdict(Say("better weights: {light}", light=light.text), light.level)


def _title(tuned: Tuned) -> Say:
    was, now = tuned.default, tuned.chosen
    if tuned.refused:
        worse = [WORSE[name] for name in tuned.refused.worse(was)]
        return Say(
            "The default weights of {method} stay: the best candidate is worse in {worse}",
            method=tuned.method,
            worse=worse,
        )
    if tuned.kept:
        return Say("No candidate beats the default weights of {method}", method=tuned.method)
    if was.falls_more(now):
        return Say("Fewer falls: {now} of {n} robots, by default {was}", now=now.fell, n=now.samples, was=was.fell)
    knock = next(m for m in MEASURES if m.name == "knock")
    if knock.change(was, now) == "won":
        return Say("Largest knock: {now}, by default {was}", now=_value(knock, now), was=_value(knock, was))
    if now.light_beside(was) == "won":
        return Say("A better light: {now} instead of {was}", now=LIGHTS[now.light].text, was=LIGHTS[was.light].text)
    effort = next(m for m in MEASURES if m.name == "effort")
    return Say(
        "Effort {now} instead of {was}, and no more falls than by chance",
        now=_value(effort, now),
        was=_value(effort, was),
    )


def _value(measure: Measure, figures: Figures) -> Quantity | Say:
    if measure.name == "falls":
        return Say("{fell} of {n}", fell=figures.fell, n=figures.samples)
    return Quantity(measure.of(figures), measure.unit)


def _numbers(tuned: Tuned) -> list[KeyNumber]:
    """The three figures by which the rule picks."""
    was, now = tuned.default, tuned.tried
    picks = [m for m in MEASURES if m.name in ("falls", "knock", "effort")]
    if not _compared(tuned):
        return [KeyNumber(_value(measure, was), NAMES[measure.name]) for measure in picks]
    falls = Say("of {n} robots fall, default → candidate", n=now.samples)
    numbers = [KeyNumber(Say("{was} → {now}", was=was.fell, now=now.fell), falls)]
    for measure in picks[1:]:
        before = Quantity(measure.of(was), "1", digits=2)
        after = Quantity(measure.of(now), measure.unit, digits=2)
        numbers.append(KeyNumber(Say("{was} → {now}", was=before, now=after), NAMES[measure.name]))
    return numbers


def _next(tuned: Tuned) -> Next:
    if tuned.kept:
        return Next("certify", tuned.method, robot=tuned.robot, why=Say("It pushes similar robots, and counts falls."))
    if LIGHTS[tuned.chosen.light].level == "bad":
        return Next("bench_controllers", robot=tuned.robot, why=Say("It compares the methods on this robot."))
    file = f"{tuned.method}-tuned.json"
    why = Say("First save it: add `-o {file}` to this command.", file=file)
    return Next("certify", file, robot=tuned.robot, why=why)


def _beside(tuned: Tuned) -> Table:
    """Every figure of the default, and beside it that of the chosen or the refused one, with what is won and paid."""
    was = tuned.default
    columns = [Column(Say("number")), Column(Say("default"))]
    rows: list[list[Cell]] = [
        [Say("light"), LIGHTS[was.light]],
        *([NAMES[m.name], _value(m, was)] for m in MEASURES),
    ]  # fmt: skip
    if not _compared(tuned):
        return Table(columns, rows)
    now = tuned.tried
    columns += [Column(Say("candidate")), Column(Say("change"))]
    beside: list[list[Cell]] = [
        [LIGHTS[now.light], CHANGES[now.light_beside(was)]],
        *([_value(m, now), _changed(m, was, now)] for m in MEASURES),
    ]  # fmt: skip
    return Table(columns, [[*row, *other] for row, other in zip(rows, beside, strict=True)])


def _changed(measure: Measure, was: Figures, now: Figures) -> Verdict | Say:
    change = measure.change(was, now)
    if measure.name == "falls" and not change and was.fallen != now.fallen:
        return Say("may be chance")
    return CHANGES[change]


def _weights(tuned: Tuned) -> Table:
    units = tuned.to_json()["units"]
    columns = [Column(Say("weight")), Column(Say("default"))]
    rows: list[list[Cell]] = [[name, Quantity(value, units[name])] for name, value in tuned.defaults.items()]
    if not tuned.kept:
        columns += [Column(Say("candidate")), Column(Say("ratio"), "1")]
        for row, (name, value) in zip(rows, tuned.weights.items(), strict=True):
            row += [Quantity(value, units[name]), value / tuned.defaults[name]]
    return Table(columns, rows)


def draw_changes(was: Figures, now: Figures) -> Figure:
    """Each figure's difference from the default's [%], in the colour of what it means."""
    from upright.plotting import AXIS, COLOURS, rows_of

    measures = [m for m in MEASURES if 0 < m.of(was) < math.inf]
    names = [str(NAMES[m.name]) for m in measures]
    changes = [100 * (m.of(now) / m.of(was) - 1) for m in measures]
    colours = {"won": COLOURS[2], "paid": COLOURS[1], "": AXIS}
    figure, ax = rows_of(names, str(Say("difference from the default [%]")), str(Say("number")))
    ax.barh(range(len(names)), changes, height=0.6, color=[colours[m.change(was, now)] for m in measures])
    ax.axvline(0, color=AXIS, linewidth=1)
    return figure


def _candidates(tuned: Tuned) -> Table:
    """The front, each by its name, with what the rule refuses it for."""
    first = tuned.front[0].figures
    rows: list[list[Cell]] = []
    for i, point in enumerate(tuned.front):
        f = point.figures
        worse = [WORSE[name] for name in f.worse(first)]
        name = Say("default") if i == 0 else tuned.called(i)
        state = Say("chosen") if i and i == tuned.picked else Say("allowed")
        if worse:
            state = Say("worse: {worse}", worse=worse)
        margins: list[Cell] = [f.gain, f.delay] if f.linear else [None, None]
        rows.append([name, state, _value(MEASURES[0], f), f.knock, *margins, LIGHTS[f.light], f.effort, f.settling])
    columns = [
        Column(Say("candidate")), Column(Say("rule")), Column(Say("fell")), Column(Say("knock"), "N s"),
        Column(Say("gain margin"), "fraction"), Column(Say("delay margin"), "s"), Column(Say("light")),
        Column(Say("effort"), "1"), Column(Say("settling"), "s"),
    ]  # fmt: skip
    caption = Say("On {n} other robots. Allowed: no worse light, no smaller knock or margin, no clearly more falls.",
                  n=first.samples)  # fmt: skip
    return Table(columns, rows, caption)
