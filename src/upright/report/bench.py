"""The page of a `Bench`: controllers ranked by the knock they survive, their responses, and a table for each push."""

from __future__ import annotations

import math

from upright.comparison.bench import DRAWN, TOLERANCE, Bench
from upright.plotting import number
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import in_degrees


def page_of(bench: Bench) -> Page:
    """The bench's page, not yet written."""
    ranked = bench.ranked()
    held = [name for name in ranked if all(row.holds for row in bench.rows if row.controller == name)]
    best, largest = next(iter(ranked.items()), ("", math.nan))
    verdict = Verdict(f"{len(held)} of {len(ranked)} hold the robot", "good" if held else "warn")
    knocked = not math.isnan(largest)
    alike = sum(size >= largest * (1 - TOLERANCE) for size in ranked.values())
    ties = f"the best {alike}, in green, tie" if alike > 1 else f"{best}, in green, is the best"
    title = f"Largest knock that each controller survives: {ties}"
    last, least = list(ranked.items())[-1] if ranked else ("", math.nan)
    numbers = [
        (f"{cell_text(size, 3)} N s", f"largest knock survived by {name}")
        for name, size in ((best, largest), (last, least))
    ]
    if knocked and best != last:
        numbers = [(size, f"{words}, the {end}") for (size, words), end in zip(numbers, ("most", "least"), strict=True)]
        numbers.append((f"{number(100 * TOLERANCE, 2)} %", "resolution of the search: closer controllers tie"))
    facts = {"robot": bench.robot, "kit": bench.kit, "body": bench.body, "seed": str(bench.seed)}
    sections = [Section("Tables", tables(bench))]
    if knocked:
        sections = [Section("Responses", [responses(bench)]), *sections]
    heading = f"{best} survives the largest knock on {bench.robot}" if knocked else f"Controllers of {bench.robot}"
    lead = f"{len(ranked)} controllers on a {bench.body} of {bench.robot} with kit {bench.kit}, under the same pushes. "
    lead += "Next: `upright certify` the best one with slightly different robots."
    return Page(
        heading, sections, lead, facts,
        bench.body == "twin", verdict=verdict,
        picture=Figure(title, bench.plot(), _SMALLER) if knocked else responses(bench),
        numbers=numbers if knocked else (),
    )  # fmt: skip


_SMALLER = "Of the knocks from the front and from the back, the smaller one. The tables have both."


def responses(bench: Bench) -> Figure:
    """Pitch under every controller and push."""
    fell = [row.controller for row in bench.rows if row.outcome.startswith("fell")]
    title = f"Pitch under each push; these fall: {', '.join(dict.fromkeys(fell))}" if fell else "Pitch under each push"
    ranked = list(bench.ranked())
    few = ranked if len(ranked) <= FEW else [*ranked[: FEW - 1], ranked[-1]]
    some = "" if few == ranked else f"The first {FEW - 1} by the knock that they survive, and the last."
    return Figure(title, bench.plot_responses(*few), some)


FEW = 4  # curves that can be told apart in one panel


def tables(bench: Bench) -> list[Table]:
    """What each controller does under each push."""
    header = [
        "controller",
        "holds",
        "peak [°]",
        "settles [s]",
        "wheels turn [°]",
        "effort",
        "saturated [%]",
        "knock [N s]",
        "falls [%]",
    ]
    place = {name: k for k, name in enumerate(bench.ranked())}
    ordered = sorted(bench.rows, key=lambda row: place.get(row.controller, len(place)))
    made: list[Table] = []
    for push in dict.fromkeys(row.push for row in bench.rows):
        cells: list[list[Cell]] = [
            [r.controller, r.outcome, _degrees(r.peak), r.settling, _degrees(r.travel), r.effort,
             _percent(r.saturated), r.impulse, _percent(r.spread)]
            for r in ordered
            if r.push == push
        ]  # fmt: skip
        caption = f"Pushed from the {in_degrees(push)} of lean, held until 3 s; falls are those of {DRAWN} drawn robots"
        made.append(Table(header, cells, caption, digits=3))
    return made


def _degrees(angle: float | None) -> float | None:
    return None if angle is None else math.degrees(angle)


def _percent(part: float | None) -> float | None:
    return None if part is None else 100 * part
