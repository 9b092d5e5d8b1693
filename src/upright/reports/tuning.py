"""The page of a `Tuned`: what it changes, the front it was picked from, and every figure beside the default's."""

from __future__ import annotations

import math

from upright.control.tunable import UNITS
from upright.reports.figure import Figure
from upright.reports.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence
from upright.tuning.figures import Figures
from upright.tuning.tune import RULE, Tuned, compared, gains

LEVEL = {"green": "good", "amber": "warn", "red": "bad"}


def page_of(tuned: Tuned) -> Page:
    """The tuning's page, not yet written."""
    was, now = tuned.default, tuned.chosen
    verdict = Verdict(now.light if tuned.kept else f"{was.light} → {now.light}", LEVEL.get(now.light, "info"))
    heading = f"{tuned.method} keeps its weights on {tuned.robot}" if tuned.kept else f"{tuned.method} on {tuned.robot}"
    title = heading if tuned.kept else f"{heading}: {gains(was, now)[0]}"
    facts = {
        "robot": tuned.robot, "kit": tuned.kit, "seed": str(tuned.seed), "candidates": str(tuned.evaluated),
    }  # fmt: skip
    caption = f"Figures on {now.samples} robots drawn from the spreads, which neither search nor rule has used"
    rows: list[list[Cell]] = [list(row) for row in compared(was, now)]
    weights: list[list[Cell]] = [
        [name, UNITS.get(name, "1"), tuned.defaults[name], value, value / tuned.defaults[name]]
        for name, value in tuned.weights.items()
    ]
    sections = [
        Section("Beside the default", [Table(["", "default", "chosen"], rows, caption), *_reasons(now)]),
        Section("Weights", [Table(["weight", "unit", "default", "chosen", "ratio"], weights, "", 4)]),
        Section("Front", [RULE, _front(tuned)]),
    ]
    return Page(
        title, sections, tuned.words(), facts, False, verdict=verdict, picture=_picture(tuned), numbers=_numbers(tuned)
    )


def _per_cent(f: Figures) -> str:
    return f"{cell_text(100 * f.falls, 3)} %"


def _reasons(now: Figures) -> list[str]:
    return [f"{sentence(now.light)} {' '.join(now.reasons)}"]


def _picture(tuned: Tuned) -> Figure:
    count = len(tuned.front) - 1
    title = f"The default, and {count} candidates that no other one beats in everything" if count else "The default"
    note = f"Falls of {tuned.front[0].figures.samples} robots on which the rule chooses."
    return Figure(title, tuned.plot(), note)


def _numbers(tuned: Tuned) -> list[tuple[str, str]]:
    was, now = tuned.default, tuned.chosen
    numbers = [
        (_per_cent(now), "of the robots fall", _per_cent(was)),
        (f"{cell_text(now.knock, 3)} N s", "largest knock survived", cell_text(was.knock, 3)),
    ]
    if math.isfinite(now.delay):
        least = cell_text(1e3 * was.delay, 3)
        numbers.append((f"{cell_text(1e3 * now.delay, 3)} ms", "smallest delay margin", least))
    return [(value, what if tuned.kept else f"{what} (default {before})") for value, what, before in numbers]


def _front(tuned: Tuned) -> Table:
    rows: list[list[Cell]] = []
    for i, point in enumerate(tuned.front):
        f = point.figures
        name = "default" if i == 0 else "chosen" if i == tuned.picked else ""
        margins: list[Cell] = [100 * f.gain, 1e3 * f.delay] if f.linear else [None, None]
        rows.append([name, f.light, 100 * f.falls, f.knock, *margins, f.settling, f.effort])
    header = ["", "light", "fell [%]", "knock [N s]", "gain [%]", "delay [ms]", "settling [s]", "effort"]
    samples = tuned.front[0].figures.samples
    return Table(header, rows, f"Candidates on the {samples} robots of the rule; gain and delay are margins", 3)
