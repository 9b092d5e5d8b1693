"""The page of a `Bench`: controllers ranked by the knock they survive, their responses, and a table for each push."""

from __future__ import annotations

import math
from collections.abc import Sequence

from upright.comparison import compare
from upright.comparison.bench import DRAWN, TOLERANCE, Bench
from upright.plotting import number
from upright.report.figure import Figure
from upright.report.metrics import degrees
from upright.report.page import Cell, Details, Page, Section, Table, Verdict, cell_text
from upright.tables import in_degrees, joined


def page_of(bench: Bench) -> Page:
    """The bench's page, not yet written."""
    ranked = bench.ranked()
    held = [name for name in ranked if all(row.holds for row in bench.rows if row.controller == name)]
    best, largest = next(iter(ranked.items()), ("", math.nan))
    knocked = not math.isnan(largest)
    places = bench.places()
    firsts = [name for name, place in places.items() if place == 1]
    take = min(
        (name for name in firsts if name in held), key=lambda name: _worse(bench, name, "effort") or 0.0, default=""
    )
    held_by = f"{len(held)} of {len(ranked)} hold the robot"
    verdict = Verdict(f"take {take}; {held_by}" if take and knocked else held_by, "good" if held else "warn")
    ties = f"the best {len(firsts)}, in green, tie" if len(firsts) > 1 else f"{best}, in green, is the best"
    title = f"Largest knock that each controller survives: {ties}"
    numbers = _numbers(bench, take or best) if knocked else []
    facts = {"robot": bench.robot, "kit": bench.kit, "body": bench.body, "seed": str(bench.seed)}
    full = [*tables(bench), *_unsettled(bench)]
    sections = [Section("Tables", [_summary(bench), Details("Numbers under each push", full)])]
    if knocked:
        sections = [Section("Responses", [responses(bench)]), *sections]
    who = f"{joined(firsts)} survive" if 1 < len(firsts) <= FEW else f"{best} survives"
    heading = f"{who} the largest knock on {bench.robot}" if knocked else f"Controllers of {bench.robot}"
    lead = f"{len(ranked)} controllers on a {bench.body} of {bench.robot} with kit {bench.kit}: knocked ever "
    lead += "harder; and held leaning for 3 s, then let go."
    lead += f" {take} is in the first place with the least effort." if take and len(firsts) > 1 else ""
    lead += f" Next: `upright certify` {take or 'the best one'} with slightly different robots."
    return Page(
        heading, sections, lead, facts,
        bench.body == "twin", verdict=verdict,
        picture=Figure(title, bench.plot(), _SMALLER) if knocked else responses(bench),
        numbers=numbers,
    )  # fmt: skip


def _worse(bench: Bench, name: str, what: str) -> float | None:
    """A number of a controller under the worse push."""
    return max(
        (x for row in bench.rows if row.controller == name and (x := getattr(row, what)) is not None), default=None
    )


def _numbers(bench: Bench, name: str) -> list[tuple[str, str]]:
    """The knock that this controller survives, its falls over the spreads and its effort, beside the others."""
    knocks = {n: size for n, size in bench.ranked().items() if not math.isnan(size)}
    efforts = {n: effort for n in knocks if (effort := _worse(bench, n, "effort")) is not None}
    (last, least), falls = list(knocks.items())[-1], _worse(bench, name, "spread")
    others = f"; the least: {cell_text(least, 2)} ({last})" if last != name else ""
    numbers = [(f"{cell_text(knocks[name], 2)} N s", f"largest knock survived by {name}{others}")]
    if falls is not None:
        numbers.append(
            (f"{cell_text(100 * falls, 2)} %", f"of {DRAWN} similar robots fall under {name}, held and let go")
        )
    if name in efforts:
        ends = (
            f"{cell_text(efforts[n], 2)} ({n})" for n in (pick(efforts, key=efforts.__getitem__) for pick in (min, max))
        )
        unit = _effort_unit(bench)
        numbers.append((f"{cell_text(efforts[name], 2)} {unit}", f"effort of {name}; of all {' to '.join(ends)}"))
    return numbers


_SMALLER = (
    "Of the knocks from the front and from the back, the smaller one; the tables have both. "
    f"Controllers within {number(100 * TOLERANCE, 2)} % of the best of a place share it."
)


def _summary(bench: Bench) -> Table:
    """What counts of each controller, under the worse push."""
    rows: list[list[Cell]] = []
    for name, size in bench.ranked().items():
        spreads = [row.spread for row in bench.rows if row.controller == name and row.spread is not None]
        efforts = [row.effort for row in bench.rows if row.controller == name and row.effort is not None]
        rows.append([name, size, 100 * max(spreads) if spreads else None, max(efforts, default=None)])
    caption = f"The worse of front and back; falls of {DRAWN} sampled robots and effort: held at a lean and let go"
    return Table(
        ["controller", "knock [N s]", "falls [%]", f"effort [{_effort_unit(bench)}]"],
        rows,
        caption,
        2,
        even=True,
    )


def _unsettled(bench: Bench) -> list[str]:
    """Why some have no settling time though they hold."""
    rest = {row.push: _rest(bench, row.push)[0] for row in bench.rows}
    lost = {r.controller: None for r in bench.rows if r.holds and math.isnan(rest[r.push].get(r.controller, math.nan))}
    return [f"No settling time of {joined(list(lost))}: pitch does not come to rest within the run."] if lost else []


def _rest(bench: Bench, push: str) -> tuple[dict[str, float], float]:
    """How long after the release each controller's pitch comes to rest [s], as on a comparison's page; and within which
    angle [rad]."""
    logs = {name: log for (name, under), log in bench.logs.items() if under == push}
    if not logs:
        return {}, math.nan
    comparison = compare(logs)
    rest = {name: comparison.at_rest(label) for name, label in zip(logs, comparison.logs, strict=True)}
    known = [limit for seconds, limit in rest.values() if math.isfinite(seconds)]
    return {name: seconds for name, (seconds, _) in rest.items()}, max(known, default=math.nan)


def responses(bench: Bench) -> Figure:
    """Pitch under every controller and push."""
    fell = [row.controller for row in bench.rows if row.outcome.startswith("fell")]
    ranked = list(bench.ranked())
    few = ranked if len(ranked) <= FEW else [*ranked[: FEW - 1], ranked[-1]]
    first = f"The first {FEW - 1} by the knock that they survive, and the last."
    knocked = any(row.impulse is not None for row in bench.rows)
    some = "" if few == ranked else first if knocked else "The tables have the other controllers too."
    title = f"Pitch while held and after; these fall: {', '.join(dict.fromkeys(fell))}" if fell else _leans(bench, few)
    return Figure(title, bench.plot_responses(*few), some)


def _leans(bench: Bench, names: Sequence[str]) -> str:
    """Who of these leans most and who least, under the worse push."""
    peaks = {n: max(abs(row.peak or 0.0) for row in bench.rows if row.controller == n) for n in names}
    ranked = sorted(peaks, key=lambda name: -peaks[name])
    if len(ranked) < 2 or not peaks[ranked[-1]]:
        return "Pitch, held at a lean and let go"
    most, least = (f"{name} ({number(math.degrees(peaks[name]), 2)}°)" for name in (ranked[0], ranked[-1]))
    return f"Pitch, held at a lean and let go: of those shown {most} leans most, {least} least"


FEW = 4  # curves that can be told apart in one panel


def tables(bench: Bench) -> list[Table]:
    """What each controller does under each push."""
    header = [
        "controller",
        "holds",
        "peak [°]",
        "settles [s]",
        "wheels turn [°]",
        f"effort [{_effort_unit(bench)}]",
        "saturated [%]",
        "knock [N s]",
        "falls [%]",
    ]
    place = {name: k for k, name in enumerate(bench.ranked())}
    ordered = sorted(bench.rows, key=lambda row: place.get(row.controller, len(place)))
    made: list[Table] = []
    for push in dict.fromkeys(row.push for row in bench.rows):
        rest, limit = _rest(bench, push)
        cells: list[list[Cell]] = [
            [r.controller, r.outcome, _degrees(r.peak), rest.get(r.controller), _degrees(r.travel), r.effort,
             _percent(r.saturated), r.impulse, _percent(r.spread)]
            for r in ordered
            if r.push == push
        ]  # fmt: skip
        caption = f"Pushed from the {in_degrees(push)} of lean, held until 3 s; falls are those of {DRAWN} drawn robots"
        if not math.isnan(limit):
            caption += f"; settled: from so long after the release on pitch stays within ±{degrees(limit)}"
        known = [
            k for k, name in enumerate(header) if name != "knock [N s]" or any(row[k] is not None for row in cells)
        ]
        rows = [[row[k] for k in known] for row in cells]
        made.append(Table([header[k] for k in known], rows, caption, digits=3))
    return made


def _effort_unit(bench: Bench) -> str:
    """As the motors are commanded: in volts, or by torque."""
    units = {log.unit("command/left") for log in bench.logs.values() if "command/left" in log}
    return "N² m² s" if units == {"N m"} else "V² s"


def _degrees(angle: float | None) -> float | None:
    return None if angle is None else math.degrees(angle)


def _percent(part: float | None) -> float | None:
    return None if part is None else 100 * part
