"""The page of a campaign's `Cases`: the fraction that fell in each, the worst first, and the table of all outcomes."""

from __future__ import annotations

from upright.fleet.ensemble import OUTCOMES
from upright.fleet.tally import Cases
from upright.plotting import number
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict


def page_of(cases: Cases) -> Page:
    """The campaign's page, not yet written."""
    names, counted = cases.names(), cases.worst_first()
    rows: list[list[Cell]] = [
        [name, case.n, case.fell, *(case.mean(o) for o in cases.shown())]
        for name, case in zip(names, cases, strict=True)
    ]
    header = [
        "case",
        "robots",
        "fell",
        *(f"{name} [{unit}]" for unit, name in map(OUTCOMES.__getitem__, cases.shown())),
    ]
    sections = [Section("Cases", [Table(header, rows, "Means of the robots that stood")])]
    if not counted:
        return Page(f"{len(cases)} cases", sections, "This campaign does not keep who fell.", twin_note=False)
    worst = counted[0]
    chance = worst.chance
    fallen = sum(case.fell or 0 for case in cases)
    numbers = [(f"{fallen} of {sum(case.n for case in cases)}", "robots that fell in all cases")]
    if chance:
        low, high = (number(100 * end, 2) for end in (chance.low, chance.high))
        numbers.append((f"{low} to {high} %", "95 % interval of the worst case"))
    percent = number(100 * (worst.fell or 0) / worst.n, 3)
    name = cases.names()[cases.index(worst)]
    title = f"{name} falls most: {percent} % of the robots" if fallen else f"No robot fell in {len(cases)} cases"
    return Page(
        title, sections, f"{len(cases)} cases of {worst.n} robots each.",
        twin_note=False, verdict=Verdict("some fell", "warn") if fallen else Verdict("none fell", "good"),
        picture=Figure("Robots that fell in each case, with the 95 % interval", cases.plot()), numbers=numbers,
    )  # fmt: skip
