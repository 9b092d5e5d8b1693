"""The page of a `Bench`: controllers ranked by the knock they survive, their responses, and a table for each push."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from upright.bodies.body import FALLEN
from upright.comparison import compare
from upright.comparison.bench import DRAWN, KNOCK, TOLERANCE, UNTIL, Bench
from upright.firmware.targets import computing_time
from upright.fleets.binomial import upper_bound
from upright.plotting import AXIS, COLOURS, number
from upright.reports.figure import Figure
from upright.reports.page import Cell, Details, Page, Section, Table, Verdict, cell_text
from upright.robots.drives import EFFORT_UNITS
from upright.tables import in_degrees, joined

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawing


def page_of(bench: Bench) -> Page:
    """The bench's page, not yet written."""
    ranked = bench.ranked()
    held = [name for name in ranked if all(row.holds for row in bench.rows if row.controller == name)]
    best, largest = next(iter(ranked.items()), ("", math.nan))
    knocked = not math.isnan(largest)
    firsts = [name for name, place in bench.places().items() if place == 1]
    tied = _tied(bench, held) if knocked else []
    take = min(tied, key=lambda name: _worse(bench, name, "effort") or 0.0, default="")
    held_by = f"{len(held)} of {len(ranked)} hold the robot"
    verdict = Verdict(f"take {take}; {held_by}" if take else held_by, "good" if held else "warn")
    ties = f"the best {len(firsts)}, in green, tie" if len(firsts) > 1 else f"{best}, in green, survives most"
    slow = bool(take) and not set(firsts) & set(_quick(bench))
    if slow:
        ties = f"green is to be taken, grey too slow for {_brick(bench)}"
    title = f"Largest knock that each controller survives: {ties}"
    facts = {"robot": bench.robot, "kit": bench.kit, "body": bench.body, "seed": str(bench.seed)}
    full = [*tables(bench), *_unsettled(bench)]
    sections = [Section("All controllers", [_summary(bench), Details("Numbers under each push", full)])]
    if knocked:
        sections = [Section("Responses", [responses(bench, take)]), *sections]
    who = f"{joined(firsts)} survive" if 1 < len(firsts) <= FEW else f"{best} survives"
    heading = f"{who} the largest knock on {bench.robot}" if knocked else f"Controllers of {bench.robot}"
    if slow:
        more = f"{joined(firsts)} survive{'' if len(firsts) > 1 else 's'} more"
        heading = f"Take {take} for {bench.robot}: {more}, but {'are' if len(firsts) > 1 else 'is'} too slow for "
        heading += _brick(bench)
    after = f"`upright certify {take or best} --robot {bench.robot}` tries it on robots that differ more."
    return Page(
        heading, sections, f"{_lead(bench, take, firsts, held)} Next: {after}", facts,
        bench.body == "twin", verdict=verdict,
        picture=Figure(title, _ranked(bench, take, slow), _SMALLER) if knocked else responses(bench),
        numbers=_numbers(bench, take or best) if knocked else [],
    )  # fmt: skip


def _ranked(bench: Bench, take: str, slow: bool) -> Drawing:
    """The limits; where the best is too slow, the one to `take` is green instead, and those too slow are grey."""
    drawing = bench.plot()
    if slow:
        for bar, name in zip(drawing.axes[0].patches, bench.ranked(), strict=True):
            bar.set_color(COLOURS[2] if name == take else COLOURS[0] if name in _quick(bench) else AXIS)
    return drawing


BRICKS = {"nxt": ("nxc", "an NXT"), "spike": ("pybricks", "a hub")}
"""Kit → the target of its firmware whose time for a product is known, and the name of its brick."""


def _brick(bench: Bench) -> str:
    return BRICKS[bench.kit][1] if bench.kit in BRICKS else ""


def _time(bench: Bench, name: str) -> float | None:
    """What a period of this controller's program takes on the kit's brick [s], estimated from its products; None where
    that is not known."""
    products = next((row.products for row in bench.rows if row.controller == name), None)
    return computing_time(products, BRICKS[bench.kit][0]) if products and bench.kit in BRICKS else None


def _quick(bench: Bench) -> list[str]:
    """The controllers whose program is not known to take longer than a period."""
    return [name for name in bench.ranked() if not (time := _time(bench, name)) or not time > bench.period]


def _tied(bench: Bench, held: Sequence[str]) -> list[str]:
    """Of those that hold the robot and are quick enough the ones whose knocks are within the tolerance of the
    largest."""
    sizes = {name: size for name, size in bench.ranked().items() if name in held and name in _quick(bench)}
    return [name for name, size in sizes.items() if size >= (1 - TOLERANCE) * max(sizes.values())]


def _lead(bench: Bench, take: str, firsts: Sequence[str], held: Sequence[str]) -> str:
    """What was tried, how sure the ranking is, and why one of them is to be taken."""
    ranked = bench.ranked()
    text = f"{len(ranked)} controllers on a {bench.body} of {bench.robot}, knocked ever harder at the centre of mass"
    text += f"{_height(bench)}."
    names = list(ranked)
    if len(firsts) == 1 and len(names) > 1 and ranked[names[1]] > 0 and firsts[0] in _quick(bench):
        lead = ranked[names[0]] / ranked[names[1]]
        step = 1 + TOLERANCE
        least, most = (number(100 * (ratio - 1), 1) for ratio in (lead / step, lead * step))
        text += f" Limits are found to {100 * TOLERANCE:g} %: {names[0]} leads {names[1]} by {least} to {most} %."
    tied = _tied(bench, held)
    if take and len(tied) > 1:
        quick = "quick ones" if len(_quick(bench)) < len(names) else "controllers"
        text += f" The best {len(tied)} {quick} are equally good, within the {100 * TOLERANCE:g} % to which limits are "
        turns = {name: _worse(bench, name, "travel") for name in tied}
        least = all(turn is not None and turn >= (turns[take] or 0.0) for turn in turns.values())
        text += f"found; of these {take} needs the least effort{' and rolls least' if least and turns[take] else ''}."
    return text


def _height(bench: Bench) -> str:
    """How high above the axle a knock hits, where the runs tell their robot."""
    origin = next((log.origin for log in bench.logs.values()), {})
    height = origin.get("robot", {}).get("com_height")
    return f" ({number(height, 2)} m above the axle)" if height else ""


def _worse(bench: Bench, name: str, what: str) -> float | None:
    """A number of a controller under the worse push."""
    return max(
        (x for row in bench.rows if row.controller == name and (x := getattr(row, what)) is not None), default=None
    )


def _numbers(bench: Bench, name: str) -> list[tuple[str, str]]:
    """The knock that this controller survives, its time on the brick and its falls over the spreads."""
    knocks = {n: size for n, size in bench.ranked().items() if not math.isnan(size)}
    (first, most), *_, (last, least) = [*knocks.items()] * 2
    others = [f"{n} {cell_text(size, 2)}" for n, size in {first: most, last: least}.items() if n != name]
    beside = f"; {', '.join(others)}" if others else ""
    numbers = [(f"{cell_text(knocks[name], 2)} N s", f"largest knock survived by {name}{beside}")]
    times = {n: time for n in knocks if (time := _time(bench, n)) is not None}
    if name in times:
        slowest = max(times, key=times.__getitem__)
        of = f"; {slowest} takes {_milliseconds(times[slowest])}" if slowest != name else ""
        text = f"{name} needs of each period of {_milliseconds(bench.period)} on {_brick(bench)} (estimate){of}"
        numbers.append((_milliseconds(times[name]), text))
    falls = _worse(bench, name, "spread")
    if falls is not None:
        fell = round(falls * DRAWN)
        bound = f"{cell_text(100 * upper_bound(fell, DRAWN), 2)} %"
        text = f"of similar robots fall under {name}, let go from a lean: {fell} of {DRAWN} did (with 95 % confidence)"
        numbers.append((f"≤ {bound}", text))
    efforts = {n: effort for n in knocks if (effort := _worse(bench, n, "effort")) is not None}
    if name in efforts and len(numbers) < MOST:
        ends = (
            f"{cell_text(efforts[n], 2)} ({n})" for n in (pick(efforts, key=efforts.__getitem__) for pick in (min, max))
        )
        unit = _effort_unit(bench)
        numbers.append((f"{cell_text(efforts[name], 2)} {unit}", f"effort of {name}; of all {' to '.join(ends)}"))
    return numbers


MOST = 3  # numbers on the first screen


def _milliseconds(seconds: float) -> str:
    return f"{cell_text(1e3 * seconds, 2)} ms"


_SMALLER = (
    f"Knocks of {1e3 * KNOCK:g} ms from front and back: drawn is the smaller limit. "
    f"Limits are found to {number(100 * TOLERANCE, 2)} %: smaller differences mean nothing, and share a place."
)


def _summary(bench: Bench) -> Table:
    """What counts of each controller, under the worse push."""
    rows: list[list[Cell]] = []
    rests = [_rest(bench, push) for push in dict.fromkeys(row.push for row in bench.rows)]
    for name, size in bench.ranked().items():
        spreads = [row.spread for row in bench.rows if row.controller == name and row.spread is not None]
        efforts = [row.effort for row in bench.rows if row.controller == name and row.effort is not None]
        time = _time(bench, name)
        times = [rest.get(name, math.nan) for rest, _ in rests]
        settled = math.nan if any(map(math.isnan, times)) else max(times, default=math.nan)
        row = [name, size, settled, 100 * max(spreads) if spreads else None, max(efforts, default=None)]
        rows.append([*row, *([None if time is None else 1e3 * time] if _brick(bench) else [])])
    band = max((limit for _, limit in rests if math.isfinite(limit)), default=math.nan)
    settling = "settling" if math.isnan(band) else f"time until pitch stays within ±{cell_text(math.degrees(band), 3)}°"
    caption = f"The worse of front and back; let go from a lean: {settling}, falls of {DRAWN} similar robots, effort"
    caption += f"; computing time for a period on {_brick(bench)}" if _brick(bench) else ""
    header = ["controller", "knock [N s]", "settles [s]", "falls [%]", f"effort [{_effort_unit(bench)}]"]
    header += [f"on {_brick(bench)} [ms]"] if _brick(bench) else []
    return Table(header, rows, caption, 3, even=True, narrow=True)


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


def responses(bench: Bench, take: str = "") -> Figure:
    """Pitch under every controller and push; of many only some, among them the one to `take`."""
    fell = [row.controller for row in bench.rows if row.outcome.startswith("fell")]
    ranked = list(bench.ranked())
    chosen = [*([take] if take else []), *(name for name in ranked if name != take)]
    few = ranked if len(ranked) <= FEW else sorted([*chosen[: FEW - 1], ranked[-1]], key=ranked.index)
    best = len(few) - 1 - bool(take)
    these = f"{take}, the best {best} besides it" if take else f"the best {best}"
    first = f"Drawn are {len(few)} of {len(ranked)}: {these}, and the last."
    knocked = any(row.impulse is not None for row in bench.rows)
    some = "" if few == ranked else first if knocked else "The tables have the other controllers too."
    title = f"Pitch while held and after; these fall: {', '.join(dict.fromkeys(fell))}" if fell else _leans(bench, few)
    return Figure(title, bench.plot_responses(*few), some)


def _leans(bench: Bench, names: Sequence[str]) -> str:
    """Who of these leans most and who least, under the worse push."""
    peaks = {n: max(abs(row.peak or 0.0) for row in bench.rows if row.controller == n) for n in names}
    ranked = sorted(peaks, key=lambda name: -peaks[name])
    if len(ranked) < 2 or not peaks[ranked[-1]]:
        return f"Pitch, pushed for {UNTIL:g} s and let go"
    most, least = (f"{name} ({number(math.degrees(peaks[name]), 2)}°)" for name in (ranked[0], ranked[-1]))
    far = f"; at {math.degrees(FALLEN):.0f}° a robot lies"
    return f"Pitch, pushed for {UNTIL:g} s and let go: of those shown {most} leans most, {least} least{far}"


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
            near = cell_text(math.degrees(limit), 3)
            caption += f"; settled: from so long after the release on pitch stays within ±{near}°"
        known = [
            k for k, name in enumerate(header) if name != "knock [N s]" or any(row[k] is not None for row in cells)
        ]
        rows = [[row[k] for k in known] for row in cells]
        made.append(Table([header[k] for k in known], rows, caption, digits=3))
    return made


def _effort_unit(bench: Bench) -> str:
    """As the motors are commanded: in volts, or by torque."""
    units = {log.unit("command/left") for log in bench.logs.values() if "command/left" in log}
    return EFFORT_UNITS[units.pop()] if len(units) == 1 else EFFORT_UNITS["V"]


def _degrees(angle: float | None) -> float | None:
    return None if angle is None else math.degrees(angle)


def _percent(part: float | None) -> float | None:
    return None if part is None else 100 * part
