"""The page of a `Parity`: whether a program does what was designed."""

from __future__ import annotations

from upright.execution.parity import Parity
from upright.plotting import bars
from upright.reports.figure import Figure
from upright.reports.page import Cell, Page, Section, Table, Verdict, cell_text


def page_of(result: Parity) -> Page:
    """The page, not yet written."""
    rows: list[list[Cell]] = [[p.push, p.outcome, p.peak] for p in result.pushes]
    figure = bars(["difference", "tolerance"], [result.worst, result.tolerance], f"command [{result.unit}]", "largest")
    difference = f"{cell_text(result.worst, 3)} {result.unit}"
    within = "within" if result.worst <= result.tolerance else "beyond"
    return Page(
        f"{result.target} program of {result.robot}: {'equal to' if result.passed else 'not equal to'} its design",
        [Section("Pushes", [Table(["push", "outcome", "largest pitch [rad]"], rows)])],
        "" if result.as_generated else "The file differs from what `upright firmware` generates here.",
        {"controller": result.hash[:12], "numbers": result.numbers, "where": result.where}, True,
        verdict=Verdict("equal", "good") if result.passed else Verdict("not equal", "bad"),
        picture=Figure(f"Commands differ by {difference}, {within} the tolerance", figure),
        numbers=[
            (f"{result.steps} of {result.periods}", "periods compared"),
            (str(result.duties), "duties that do not follow from their commands"),
        ],
    )  # fmt: skip
