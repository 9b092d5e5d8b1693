"""The page of one run: whether the robot stood, how far it leaned and rolled, and when it was calm again."""

from __future__ import annotations

import functools
import math

from upright.certification.verdict import MOST_TRAVEL
from upright.comparison.drawing import draw_asked
from upright.comparison.parts import (
    certify_next,
    folds,
    measured,
    pushes_of,
    states_picture,
    who,
)
from upright.comparison.runs import Compared, Metrics
from upright.experiment import motionless, outcome_of, undisturbed
from upright.experiment.described import facts_of, name_in
from upright.pages import Column, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.robots import offered
from upright.signals import Log


def run_page(comparison: Compared) -> Page:
    """The page of a comparison of one log."""
    ((label, log),) = comparison.logs.items()
    numbers = comparison.metrics[label]
    calm = undisturbed(log) and not numbers.fell
    still = motionless(log) if calm else None
    lead = [who(log, comparison.kinds[label], pushes_of(log)), *([still] if still else [])]
    columns = [Column(Say("number")), Column(Say("value"))]
    rows = [
        [column.name, Quantity(value, column.unit)]
        for column, values in measured(comparison)
        for value in values.values()
        if isinstance(value, float)  # that it fell is said above
    ]
    return Page(
        _title(log, numbers, calm, bool(still)), verdict=_verdict(log, numbers, calm), lead=lead,
        numbers=_numbers(comparison, label), picture=_picture(comparison, label, still), next=[_next(log, calm)],
        blocks=[Table(columns, rows), *folds(comparison)], origin=facts_of(log.origin),
    )  # fmt: skip


def _title(log: Log, numbers: Metrics, calm: bool, still: bool) -> Say:
    outcome = outcome_of(log)
    time = Quantity(outcome.seconds, "s", digits=4)
    if outcome.fell or outcome.fell is None or math.isfinite(outcome.slipped):
        return outcome.in_words
    if math.isfinite(numbers.doubling):
        doubling = Quantity(numbers.doubling, "s", digits=2)
        return Say("It stood for {time}, but its swing doubles every {doubling}", time=time, doubling=doubling)
    if _rolls_away(log, numbers):
        return Say("It stood for {time} and rolled {way}", time=time, way=Quantity(numbers.rolled, "m", digits=2))
    if still:
        return Say("It stood still for {time}", time=time)
    if calm:
        most = Quantity(abs(numbers.pitch_peak), "rad")
        return Say("It swayed by {most} at most in {time}", most=most, time=time)
    robot = name_in(log.origin, "robot")
    pushed = robot and pushes_of(log).facts
    return Say("Pushed, {robot} stood for {time}", robot=robot, time=time) if pushed else outcome.in_words


def _verdict(log: Log, numbers: Metrics, calm: bool) -> Verdict:
    outcome = outcome_of(log)
    if outcome.fell:
        return Verdict(Say("it fell"), "bad")
    if outcome.fell is None:
        return Verdict(Say("not known whether it fell"), "unknown")
    warning = _warning(log, numbers)
    if warning:
        return Verdict(warning, "warn")
    return Verdict(Say("nothing disturbed it")) if calm else Verdict(Say("it stands"), "good")


def _warning(log: Log, numbers: Metrics) -> Say | None:
    """What is wrong with a run that stood."""
    if math.isfinite(outcome_of(log).slipped):
        return Say("its motors slipped")
    if math.isfinite(numbers.doubling):
        return Say("its swing grows")
    if _rolls_away(log, numbers):
        return Say("it rolled far")
    return None


def _rolls_away(log: Log, numbers: Metrics) -> bool:
    """Whether it rolled off a table though no reference asked for it."""
    return numbers.rolled > MOST_TRAVEL and not (log.origin.get("scenario") or {}).get("reference")


def _numbers(comparison: Compared, label: str) -> list[KeyNumber]:
    m = comparison.metrics[label]
    numbers = [KeyNumber(Quantity(abs(m.pitch_peak), "rad"), Say("largest pitch"))]
    if m.saturated > 0 and m.fell:
        limit = Say("of the time the motors were at their limit")
        numbers.append(KeyNumber(Quantity(m.saturated, "fraction", digits=2), limit))
    elif comparison.pushed and not m.fell:
        seconds, within = comparison.at_rest(label)
        settled = Say("never") if math.isnan(seconds) else Quantity(seconds, "s")
        band = Quantity(within, "rad")
        numbers.append(KeyNumber(settled, Say("after the last push until pitch stays within ±{band}", band=band)))
    if math.isfinite(m.rolled):
        numbers.append(KeyNumber(Quantity(m.rolled, "m"), Say("furthest from the start")))
    return numbers


def _picture(comparison: Compared, label: str, still: Say | None) -> Picture:
    if still:
        claim = Say("What the controller asked of the left motor, and what the motor got")
        return Picture(claim, functools.partial(draw_asked, comparison))
    seconds, _ = comparison.at_rest(label)
    if comparison.metrics[label].fell:
        claim = Say("Pitch and wheel angle until the fall")
    elif not comparison.pushed:
        claim = Say("Pitch and wheel angle, while nobody pushes")
    elif math.isnan(seconds):
        claim = Say("After the last push pitch does not come to rest")
    else:
        claim = Say("Pitch is at rest {time} after the last push", time=Quantity(seconds, "s"))
    names = [name for name in ("pitch", "wheel") if name in comparison.signals]
    return states_picture(comparison, claim, *(names or comparison.signals[:1]))


def _next(log: Log, calm: bool) -> Next:
    robot = offered(name_in(log.origin, "robot"))
    if calm:
        why = Say("A push shows more than noise does.")
        return Next("simulate", robot=robot, push="hold:0.1,until=1", why=why)
    if outcome_of(log).fell:
        return Next("push_map", robot=robot, why=Say("It shows which pushes the robot survives."))
    return certify_next(log)
