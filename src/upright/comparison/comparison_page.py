"""The page of several runs: whether they agree, and by how much they do not."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping

import numpy as np

from upright.comparison.drawing import draw_apart, state_words, unit_of
from upright.comparison.parts import (
    body_in_words,
    certify_next,
    cut_note,
    folds,
    measured,
    pushes_of,
)
from upright.comparison.runs import CLOSE, DIVERGED, FAIR, Compared
from upright.experiment import outcome_of
from upright.experiment.described import facts_of, law_in, name_in
from upright.pages import Cell, Column, Fold, KeyNumber, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.blocks import MOST_NUMBERS
from upright.pages.terms import channel

NAMED = 4  # runs that a title names
DIFFERS = 0.2  # of the largest push


def comparison_page(comparison: Compared) -> Page:
    """The page of a comparison of at least two logs."""
    reference = comparison.logs[comparison.reference]
    first = "pitch" if "pitch" in comparison.signals else comparison.signals[0]
    fits = _fits(comparison, first)
    lead = [_who(comparison, pushes_of(reference))]
    if _pushed_differently(comparison):
        lead.append(Say("The runs are not pushed alike."))
    elif any(kind.startswith("twin") for kind in comparison.kinds.values()):
        lead.append(Say("The twin is a simulation, no real robot."))
    return Page(
        _title(comparison, first, fits), verdict=_verdict(comparison, first, fits), lead=lead,
        numbers=_numbers(comparison, first, fits), picture=_picture(comparison, first),
        next=[certify_next(reference)],
        blocks=[_fit_table(comparison), _metrics_table(comparison), *folds(comparison), _origins(comparison)],
        origin=facts_of(reference.origin),
    )  # fmt: skip


def _who(comparison: Compared, pushes: Say) -> Say:
    """What the runs have in common."""
    robots = list(dict.fromkeys(name_in(log.origin, "robot") for log in comparison.logs.values()))
    laws = list(dict.fromkeys(law_in(log.origin) for log in comparison.logs.values()))
    if not all(robots):
        return Say("Not every log names its robot; they show {pushes}.", pushes=pushes)
    if all(laws):
        return Say("All runs are of {robots} under {laws}, with {pushes}.", robots=robots, laws=laws, pushes=pushes)
    return Say("All runs are of {robots}, with {pushes}.", robots=robots, pushes=pushes)


def _fits(comparison: Compared, name: str) -> dict[str, float]:
    """The fits [%] of a state of those that stood, the worst first, while the pushes are answered where these count."""
    shown = comparison.answered or comparison.fits
    fits = {
        label: fit[name]
        for label, fit in shown.items()
        if math.isfinite(fit[name]) and not comparison.metrics[label].fell
    }
    return dict(sorted(fits.items(), key=lambda item: item[1]))


def _title(comparison: Compared, first: str, fits: Mapping[str, float]) -> Say:
    fell = [label for label, m in comparison.metrics.items() if m.fell]
    n = len(comparison.logs)
    if fell and len(fell) <= NAMED:
        return Say("{fell} of {n} runs fell: {names}", fell=len(fell), n=n, names=fell)
    if fell:
        return Say("{fell} of {n} runs fell", fell=len(fell), n=n)
    if not fits:
        return Say("Runs compared: {names}", names=list(comparison.logs))
    return _agreement(comparison, first, fits)


def _agreement(comparison: Compared, first: str, fits: Mapping[str, float]) -> Say:
    """Which run follows which."""
    one = comparison.reference
    worst = next(iter(fits))
    state = state_words(first)
    if comparison.answered and len(fits) == 1:
        return Say("From “{one}”, “{other}” differs by sway at rest only", one=one, other=worst)
    if comparison.answered:
        return Say("From “{one}” the runs differ by sway at rest only", one=one)
    if fits[worst] < FAIR:
        return Say("In {state}, “{other}” does not follow “{one}”", state=state, other=worst, one=one)
    if len(fits) == 1:
        return Say("In {state}, “{other}” follows “{one}”", state=state, other=worst, one=one)
    return Say("In {state}, all runs follow “{one}”", state=state, one=one)


def _verdict(comparison: Compared, first: str, fits: Mapping[str, float]) -> Verdict:
    fell = sum(m.fell is True for m in comparison.metrics.values())
    if fell:
        return Verdict(Say("{fell} of {n} fell", fell=fell, n=len(comparison.logs)), "bad")
    if not fits:
        return Verdict(Say("no motion to compare"), "unknown")
    if comparison.answered:
        return Verdict(Say("same answer to the push"), "good")
    return fit_verdict(state_words(first), min(fits.values()))


def fit_verdict(state: Say, worst: float) -> Verdict:
    """How well runs agree in a state, by the worst fit [%]."""
    if worst >= CLOSE:
        return Verdict(Say("{state}: good fit", state=state), "good")
    if worst >= FAIR:
        return Verdict(Say("{state}: fair fit", state=state), "warn")
    return Verdict(Say("{state}: poor fit", state=state), "bad")


def _numbers(comparison: Compared, first: str, fits: Mapping[str, float]) -> list[KeyNumber]:
    """When runs fell, else the worst fits, the largest difference and, of two runs, when both have settled."""
    state = state_words(first)
    fell = {label: outcome_of(log) for label, log in comparison.logs.items() if comparison.metrics[label].fell}
    numbers = [KeyNumber(Quantity(end.seconds, "s"), Say("until “{run}” fell", run=run)) for run, end in fell.items()]
    for label, fit in list(fits.items())[:2]:
        meaning = Say("how well “{run}” follows “{one}” in {state}; good: at least {close}", run=label, state=state,
                      one=comparison.reference, close=_percent(CLOSE))  # fmt: skip
        if comparison.answered:
            meaning = Say("fit of {state}, “{run}”, until both are calm", state=state, run=label)
        numbers.append(KeyNumber(_percent(fit) if fit > DIVERGED else Say("diverges"), meaning))
    if len(fits) == 1 and not fell:
        label, size = _furthest(comparison, first)
        meaning = Say("largest difference of “{run}” from “{one}” in {state}", run=label, one=comparison.reference,
                      state=state)  # fmt: skip
        numbers.append(KeyNumber(Quantity(size, unit_of(comparison, first), digits=2), meaning))
    settled = [comparison.at_rest(label)[0] for label in comparison.logs]
    if len(settled) == 2 and comparison.pushed and all(map(math.isfinite, settled)):
        value = Say("{one} and {other}", one=Quantity(settled[0], "s"), other=Quantity(settled[1], "s"))
        band = Quantity(comparison.at_rest(comparison.reference)[1], "rad")
        one, other = comparison.logs
        meaning = Say("until “{one}” and “{other}” settled within ±{band} after the last push", one=one, other=other,
                      band=band)  # fmt: skip
        numbers.append(KeyNumber(value, meaning))
    return numbers[:MOST_NUMBERS]


def _percent(fit: float) -> Quantity:
    return Quantity(fit / 100, "fraction")


def _furthest(comparison: Compared, name: str) -> tuple[str, float]:
    """The run that differs most from the reference in a state, and by how much."""
    apart = {label: comparison.apart(label, name) for label in comparison.fits}
    label = max(apart, key=lambda label: apart[label])
    return label, apart[label]


def _picture(comparison: Compared, first: str) -> Picture:
    claim = Say("The {state} of the runs, and how far each is from “{one}”", state=state_words(first),
                one=comparison.reference)  # fmt: skip
    return Picture(claim, functools.partial(draw_apart, comparison, first), cut_note(comparison, first))


def _fit_table(comparison: Compared) -> Table:
    shown = comparison.answered or comparison.fits
    names = [name for name in comparison.signals if any(math.isfinite(fit[name]) for fit in shown.values())]
    columns = [Column(Say("run")), *(Column(state_words(name), "%") for name in names)]
    rows: list[list[Cell]] = []
    for label, fit in shown.items():
        rows.append([label, *(Say("diverges") if fit[name] < DIVERGED else fit[name] for name in names)])
    caption = Say("Fit to “{one}”: noise differs in each run, and lowers the fit of rates", one=comparison.reference)
    if comparison.answered:
        caption = Say("Fit to “{one}”, from the push until both are calm", one=comparison.reference)
    return Table(columns, rows, caption)


def _metrics_table(comparison: Compared) -> Table:
    parts = measured(comparison)
    columns = [Column(Say("run")), *(column for column, _ in parts)]
    rows = [[label, *(values[label] for _, values in parts)] for label in comparison.logs]
    return Table(columns, rows, Say("Numbers of each run"))


def _pushed_differently(comparison: Compared) -> bool:
    """Whether the largest pushes of the runs differ."""
    logs = [log for log in comparison.logs.values() if "push/force" in log]
    sizes = [float(np.nanmax(np.abs(log["push/force"]), initial=0.0)) for log in logs]
    return bool(sizes) and max(sizes) - min(sizes) > DIFFERS * max(sizes)


def _origins(comparison: Compared) -> Fold:
    columns = [
        Column(Say("run")), Column(Say("body")), Column(Say("states from")), Column(Say("rows")),
        Column(Say("length"), "s"), Column(Say("controller")),
    ]  # fmt: skip
    rows: list[list[Cell]] = [
        [label, body_in_words(comparison.kinds[label]), channel(comparison.sources[label]), len(log),
         float(log.t[-1] - log.t[0]), facts_of(log.origin).get("controller")]
        for label, log in comparison.logs.items()
    ]  # fmt: skip
    return Fold(Say("Where the logs come from"), [Table(columns, rows)])
