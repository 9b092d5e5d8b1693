"""What the pages of one run and of several have in common: who ran, the metrics, the commands, and what is meant."""

from __future__ import annotations

import functools
import math
from collections.abc import Mapping
from typing import Any

from upright.comparison.drawing import draw_commands, draw_states, dwarfing
from upright.comparison.runs import METRICS, Compared
from upright.experiment.described import law_in, law_in_words, name_in, pushes_in_words
from upright.logs.recording import commanded
from upright.pages import Cell, Column, Fold, Items, Next, Picture, Quantity, Say
from upright.robots import offered
from upright.signals import Log

FRACTIONS = {"1": "fraction"}
"""Unit of a metric → that in which people read it."""


BODIES = {
    "twin": Say("MuJoCo twin"),
    "nonlinear model": Say("nonlinear model"),
    "linear model": Say("linear model"),
}
"""What is in the name of a simulated body, and what it is."""


def body_in_words(kind: str) -> Say | str | None:
    """A kind of body as the origin of a log names it."""
    return next((words for part, words in BODIES.items() if part in kind), kind or None)


def who(log: Log, kind: str, pushes: Say) -> Say:
    """Robot, controller and pushes of a run in a body of this kind."""
    robot = name_in(log.origin, "robot")
    facts = {"robot": robot, "law": law_in_words(log.origin), "pushes": pushes}
    if not robot:
        return Say("The log does not name its robot; it shows {pushes}.", pushes=pushes)
    if kind.startswith("twin"):
        return Say("The twin simulates {robot} under {law}, with {pushes}.", **facts)
    if "nonlinear model" in kind:
        return Say("The model simulates {robot} under {law}, with {pushes}.", **facts)
    if "linear model" in kind:
        return Say("The linear model simulates {robot} under {law}, with {pushes}.", **facts)
    return Say("The robot is {robot} under {law}, with {pushes}.", **facts)


def pushes_of(log: Log) -> Say:
    """What pushed the robot, by the scenario or, in a log from elsewhere, by its channel."""
    scenario: Mapping[str, Any] = log.origin.get("scenario") or {}
    if "push/force" in log and log["push/force"].any() and not scenario.get("push"):
        return Say("a push")
    return pushes_in_words(scenario.get("push") or ())


def measured(comparison: Compared) -> list[tuple[Column, dict[str, Cell]]]:
    """Each metric that some run has, with its value for each run, the most important first."""
    rows: list[tuple[Column, dict[str, Cell]]] = []
    for name, (_, text) in METRICS.items():
        unit = comparison.unit(name)
        values: dict[str, Cell] = {label: getattr(m, name) for label, m in comparison.metrics.items()}
        rows.append((Column(text, FRACTIONS.get(unit, unit)), values))
    if comparison.pushed:
        settled: dict[str, Cell] = {label: comparison.at_rest(label)[0] for label in comparison.logs}
        rows.insert(2, (Column(Say("settling"), "s"), settled))
    return [(column, values) for column, values in rows if any(map(_known, values.values()))]


def _known(value: Cell) -> bool:
    return value is not None and not (isinstance(value, float) and math.isnan(value))


def states_picture(comparison: Compared, claim: Say, *names: str) -> Picture:
    """Some states over the whole of the runs; which runs are cut stands below."""
    return Picture(claim, functools.partial(draw_states, comparison, names), cut_note(comparison, *names))


def cut_note(comparison: Compared, *names: str) -> Say | None:
    """Which runs are cut."""
    cut = sorted({label for name in names for label in dwarfing(comparison, name)})
    return Say("Cut at the frame: {runs}.", runs=cut) if cut else None


def folds(comparison: Compared) -> list[Fold]:
    """The states that move over the whole of the runs, the commands, and what the numbers mean."""
    states = Picture(Say("Every state that moves"), functools.partial(draw_states, comparison, comparison.moving))
    pages = [Fold(Say("All states"), [states])]
    if any(map(commanded, comparison.logs.values())):
        commands = Picture(Say("Commands of the motors"), functools.partial(draw_commands, comparison))
        pages.append(Fold(Say("Commands"), [commands]))
    return [*pages, Fold(Say("How the numbers are meant"), [Items(_meanings(comparison))])]


def _meanings(comparison: Compared) -> list[Say]:
    """What the numbers of the tables mean."""
    items = [
        Say("Effort: the integral of both commands squared."),
        Say("Motors at limit: the part of the time in which they cannot give what is asked."),
        Say("Overshoot: the largest swing back, as a part of the lean at the release."),
        Say("Settling 2 % or 5 %: until pitch stays within that part of its largest value after the release."),
    ]
    if comparison.pushed:
        band = Quantity(max(comparison.at_rest(label)[1] for label in comparison.logs), "rad")
        items.insert(0, Say("Settling: from the end of the last push until pitch stays within ±{band}.", band=band))
        items.append(Say("Held back for long, a robot leans forward, into the push."))
    if comparison.fits:
        items.append(Say("Fit: 100 % is the same curve, 0 % is no better than a constant."))
        items.append(Say("Noise is another one in each run, and lowers the fit of rates most."))
    return items


def certify_next(log: Log) -> Next:
    """To certify the controller of a log."""
    from upright.control.methods import OURS

    kind = law_in(log.origin)
    law = kind if kind in {method.name for method in OURS} else "CONTROLLER"
    why = Say("It pushes many similar robots, and counts falls.")
    return Next("certify", law, robot=offered(name_in(log.origin, "robot")), why=why)
