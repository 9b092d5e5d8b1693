"""The page of a campaign's `Cases`: what makes a difference to the fraction that falls, and all outcomes."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from upright.certification.verdict import MOST_FALLS
from upright.fleets.binomial import Interval, upper_bound
from upright.fleets.ensemble import SETTLED
from upright.fleets.tally import END, Cases, CaseSummary, together
from upright.plotting import AXIS, MANY, legend, number
from upright.reports.figure import Figure
from upright.reports.knocks import harder, pushed, where
from upright.reports.page import Cell, Page, Section, Table, Verdict
from upright.reports.spreads import directions, matter_table, product, spread_table
from upright.tables import joined, sentence, spoken

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawing


def page_of(cases: Cases) -> Page:
    """The campaign's page, not yet written."""
    shown = _shown(cases)
    drawn, listed = cases.drawn(), [_table(cases), *_leaning(cases)]
    sections = (
        [Section("Varied parameters that matter", [*directions(drawn), matter_table(cases, drawn)])] if drawn else []
    )
    if shown is cases:
        sections.insert(0, Section("Cases", listed))
    else:
        sections.append(Section(f"All {len(cases)} cases in numbers", listed, folded=True))
    if _one_robot(cases) and cases.spreads:
        sections.append(Section("What varies", [spread_table(cases.spreads, cases.units)], folded=True))
    counted = cases.worst_first()
    if not counted:
        return Page(f"{len(cases)} cases", sections, "This campaign does not keep who fell.", twin_note=False)
    worst = max(counted, key=lambda case: (case.fell or 0) / case.n)
    knocks = harder(cases.origins)
    return Page(
        _title(cases, worst), sections, _lead(cases, knocks), _made(cases), twin_note=False,
        verdict=_verdict(counted, knocks), picture=Figure(_claim(cases), _limited(shown), _note(cases)),
        numbers=_numbers(cases, shown, worst),
    )  # fmt: skip


def _shown(cases: Cases) -> Cases:
    """The cases as they are drawn: many of them without the labels that make no difference."""
    merged = cases.merged(_alike(cases))
    return merged if len(cases) > MANY and 2 <= len(merged) < len(cases) and cases.worst_first() else cases


def _alike(cases: Cases) -> list[str]:
    """The labels that change the falls in no case."""
    known = {*cases.matters(), *(name for name, *_ in _apart(cases))}
    return [name for name in cases.varied() if name not in known]


def _note(cases: Cases) -> str:
    note = f"{_scenarios(cases)} Thin lines: between two bounds, each with 95 % confidence."
    if _shown(cases) is not cases:
        known = cases.varied()
        named = [joined([cases.labelled(name, level) for level in known[name]]) for name in _alike(cases)]
        note += f" A row counts the runs with {', '.join(named)} together: that makes no clear difference."
    return f"{note}{_sometimes(cases)}".strip()


def _made(cases: Cases) -> dict[str, str]:
    """Seed, length of the runs and versions, as of the first case."""
    origin = cases.origins[0] if cases.origins else {}
    seconds, versions = origin.get("scenario", {}).get("seconds"), origin.get("versions", {})
    facts = {
        "seed": str(origin.get("seed", "")),
        "each run": f"{seconds:g} s" if seconds else "",
        "versions": ", ".join(f"{name} {version}" for name, version in sorted(versions.items())),
    }
    return {name: text for name, text in facts.items() if text}


def _verdict(counted: Sequence[CaseSummary], knocks: str) -> Verdict:
    """In how many cases more fall than a certificate allows; of a single case as of a fleet."""
    above = [case for case in counted if (case.fell or 0) > MOST_FALLS * case.n]
    if knocks or not above or len(counted) == 1:
        worst = max(counted, key=lambda case: (case.fell or 0) / case.n)
        return falls_verdict(worst.fell or 0, worst.n, knocks)
    of = f"{len(above)} of {len(counted)}" if len(above) < len(counted) else f"all {len(counted)}"
    return Verdict(f"in {of} cases more fall than the {100 * MOST_FALLS:g} % that a certificate allows", "bad")


def _limited(cases: Cases) -> Drawing:
    """The falls of each case beside the limit of a certificate."""
    from matplotlib.text import Annotation

    drawing = cases.plot()
    (ax,) = drawing.axes
    limit = 100 * MOST_FALLS
    ax.axvline(limit, linestyle="--", linewidth=1, color=AXIS, label=f"limit of a certificate, {limit:g} %")
    ax.set_xlim(0, max(1.4 * limit, ax.get_xlim()[1]))
    for text in ax.texts:
        if isinstance(text, Annotation):  # not across the line of the limit
            text.xy = (max(text.xy[0], limit), text.xy[1])
    return legend(drawing)


def falls_verdict(fallen: int, all_of_them: int, harder: str = "") -> Verdict:
    """By a certificate's rule, which counts the upper bound of falls: green where it is within the limit, red where
    what was counted is above it too; amber also where they were pushed `harder` than a certificate pushes."""
    limit = f"{100 * MOST_FALLS:g} % that a certificate allows"
    bound = upper_bound(fallen, all_of_them)
    few = bound <= MOST_FALLS
    if harder and not few:
        return Verdict("knock beyond the certificate's range", "warn")
    level = "bad" if fallen > MOST_FALLS * all_of_them else "good" if few else "warn"
    return Verdict(f"up to {_percent(bound)} may fall: {'below' if few else 'above'} the {limit}", level)


def _title(cases: Cases, worst: CaseSummary) -> str:
    """The label that makes a difference, with bounds, or that none does."""
    if not worst.fell:
        return f"No robot fell in {len(cases)} cases"
    group = _group(cases)
    apart = _apart(cases)
    if group:
        others = [case for case in cases.worst_first() if case not in group]
        return f"{sentence(_fallen(cases, group)).rstrip('.')}; {_most(others)}"
    if not apart:
        in_case = f", in all {len(cases)} cases about alike" if len(cases) > 1 else ""
        return f"{_chance(worst)} of the robots fall{in_case}"
    name, (best, least), (hardest, most) = apart[0]
    good, bad = cases.labelled(name, best), cases.labelled(name, hardest)
    return f"With {bad} {_within(most)} of the robots fall, with {good} {_within(least)}"


def _group(cases: Cases) -> list[CaseSummary]:
    """The worst cases, where no single label tells who falls: the label with the largest effect has at one of its
    values cases that differ among themselves, so that their mean describes none of them. Empty else."""
    apart = _apart(cases)
    if not apart:
        return []
    name, (best, _), (hardest, _) = apart[0]
    counted = cases.worst_first()
    levels = [[c.chance for c in counted if c.labels.get(name) == level and c.chance] for level in (best, hardest)]
    if all(max(chance.low for chance in level) <= min(chance.high for chance in level) for level in levels):
        return []
    first = counted[0].chance
    assert first
    worst = [case for case in counted if case.chance and case.chance.high >= first.low]
    return worst if len(worst) < len(counted) else []


def _labels(cases: Cases, group: Sequence[CaseSummary]) -> dict[str, str | float]:
    """What the cases of a group have in common and no other case has; empty without."""
    labels = {name: values[0] for name in cases.varied()
              if len(values := list(dict.fromkeys(case.labels.get(name, "") for case in group))) == 1}  # fmt: skip
    alike = [case for case in cases if all(case.labels.get(name, "") == value for name, value in labels.items())]
    return labels if len(alike) == len(group) else {}


def _shared(cases: Cases, group: Sequence[CaseSummary]) -> str:
    """The labels of a group, else how many cases it has."""
    labels = [cases.labelled(name, value) for name, value in _labels(cases, group).items()]
    return ", ".join(labels) or f"{len(group)} of {len(cases)} cases"


def _fallen(cases: Cases, group: Sequence[CaseSummary]) -> str:
    """How many fell in these cases together: "all 1000 ev3way robots fall when knocked"; of several cases, which have
    the same robots, in per cent."""
    fell, n = sum(case.fell or 0 for case in group), sum(case.n for case in group)
    part = f"{fell} of {n}" if len(group) == 1 else f"{_percent(fell / n)} of the"
    every = "all" if len(group) > 1 else f"all {n}"
    return f"{every if fell == n else part} {_robots_of(cases, group)}"


def _robots_of(cases: Cases, group: Sequence[CaseSummary]) -> str:
    """ "ev3way robots fall when knocked"."""
    labels = _labels(cases, group)
    if not labels:
        return f"robots fall in {len(group)} of {len(cases)} cases"
    robot, scene = (str(labels.pop(name, "")) for name in ("robot", "scenario"))
    when = f" {SCENES.get(scene, f'in scenario {scene}')}" if scene else ""
    others = "".join(f" with {cases.labelled(name, value)}" for name, value in labels.items())
    return f"{robot} robots fall{when}{others}".strip()


SCENES = {"knock": "when knocked", "slope": "on a slope"}
"""Usual names of scenarios, and when that is."""


def _most(others: Sequence[CaseSummary]) -> str:
    """How many fell in the worst of the other cases."""
    worst = max(others, key=lambda case: (case.fell or 0) / case.n)
    most = f"at most {worst.fell} of {worst.n} do" if worst.fell else "none does"
    return f"in the other cases {most}"


def _chance(case: CaseSummary) -> str:
    return _within(case.chance) if case.chance else "–"


def _within(chance: Interval) -> str:
    """Both bounds of a probability, or the upper one where none fell."""
    low, high = number(100 * chance.low, 2), number(100 * chance.high, 2)
    return f"{low} to {high} %" if chance.value else f"at most {high} %"


Level = tuple[str | float, Interval]


def _apart(cases: Cases) -> list[tuple[str, Level, Level]]:
    """The labels whose best and worst value have intervals apart, each with both values and fractions."""
    apart: list[tuple[str, Level, Level]] = []
    for name, levels in cases.effects().items():
        best, worst = (pick(levels, key=lambda value: levels[value].value) for pick in (min, max))
        if levels[best].high < levels[worst].low:
            apart.append((name, (best, levels[best]), (worst, levels[worst])))
    return apart


def _lead(cases: Cases, knocks: str) -> str:
    """How hard its `knocks` are, what makes no difference, and what was run."""
    sizes = sorted({case.n for case in cases})
    robots = " or ".join(dict.fromkeys(str(case.labels.get("robot", "")) for case in cases))
    robots = "its robot" if not _one_robot(cases) and "=" in product(cases) else robots
    same = "the same " if len(sizes) == 1 and _one_robot(cases) and len(cases) > 1 else ""
    many = (
        f"{same}{sizes[0]} simulated variations of {robots or 'the robot'}"
        if len(sizes) == 1
        else f"simulated variations of {robots}"
    )
    scenes = list(dict.fromkeys(str(case.labels.get("scenario", "")) for case in cases))
    known = len(scenes) == 1 and cases.pushes
    scene = (
        f", {pushed(cases.pushes)}" if known else f" in scenario {scenes[0]}" if len(scenes) == 1 and scenes[0] else ""
    )
    acts = f" {where(cases.pushes)}" if known and where(cases.pushes) else ""
    first = f"{product(cases)}, each with {many}{scene}{acts}."
    alike = [spoken(name) for name in _alike(cases)] if _shown(cases) is cases else []
    second = f" The {joined(alike)} {'makes' if len(alike) == 1 else 'make'} no clear difference." if alike else ""
    return f"{f'{knocks}{_decides(cases)}{second} {first}'.strip()}{_next(cases)}"


def _decides(cases: Cases) -> str:
    """The varied parameter that matters most, as a sentence with a space before it; nothing where chance explains the
    falls."""
    drawn = cases.drawn()
    if not drawn or not _group(cases):
        return ""
    name, (case, least, most) = next(iter(drawn.items()))
    (few, fewer), (many, more) = sorted([(least, "smallest"), (most, "largest")])
    part = f"among the {100 * END:g} %"
    return (
        f" The {spoken(name)} decides most: {part} of robots with the {more} {spoken(name)} {_percent(many)} fall, "
        f"{part} with the {fewer} {_percent(few)} ({_named(cases, case)})."
    )


def _named(cases: Cases, case: CaseSummary, without: Sequence[str] = ()) -> str:
    """The labels of a case that make a difference."""
    names = [name for name in cases.varied() if name not in (*_alike(cases), *without)]
    return ", ".join(cases.labelled(name, case.labels.get(name, "")) for name in names)


def _sometimes(cases: Cases) -> str:
    """The labels that make a difference in some cases and not over all, each with where it is largest, as sentences
    with a space before them."""
    apart = {name for name, *_ in _apart(cases)}
    words = ""
    for name, (worse, better) in cases.matters().items():
        if name not in apart and worse.chance and better.chance:
            hard, easy = (cases.labelled(name, c.labels.get(name, "")) for c in (worse, better))
            few = _percent(better.chance.value) if better.fell else "none"
            words += f" On {_named(cases, worse, [name])}, the {spoken(name)} matters: {_percent(worse.chance.value)} "
            words += f"fall with {hard}, {few} with {easy}."
    return words


def _scenarios(cases: Cases) -> str:
    """What is done to the robots in each scenario, as a sentence with a space before it; nothing for a single one."""
    if len(cases.origins) != len(cases):
        return ""
    pushes = {str(case.labels.get("scenario", "")): origin.get("scenario", {}).get("push")
              for case, origin in zip(cases, cases.origins, strict=True)}  # fmt: skip
    if len(pushes) < 2:
        return ""
    return "".join(f" {sentence(f'{name}: {pushed(push)} {where(push)}'.strip())}" for name, push in pushes.items())


def _next(cases: Cases) -> str:
    """What to run next: where even the best case falls too often, its push is too large."""
    chances = [case.chance.value for case in cases if case.chance]
    if cases.pushes and chances and (min(chances) > MOST_FALLS or max(chances) > HOPELESS):
        worst = str(cases.worst_first()[0].labels.get("robot", ""))
        of = f" --robot {worst}" if worst else ""
        kind = str(cases.worst_first()[0].labels.get("controller", ""))
        of += f" --controller {kind}" if worst and kind else ""
        case = f"{worst} survives{f' under {kind}' if kind else ''}, the worst case" if worst else "it survives"
        return f" Next: `upright push-map{of}` finds the largest push that {case}."
    best = "the best" if any(name == "controller" for name, *_ in _apart(cases)) else "a"
    return f" Next: `upright tune` {best} controller." if any(case.fell for case in cases) else ""


HOPELESS = 0.5  # of the robots: where more fall, other weights save few


def _one_robot(cases: Cases) -> bool:
    return len({case.labels.get("robot", "") for case in cases}) == 1


def _strongest(cases: Cases) -> list[tuple[str, str]]:
    """How many fall at both ends of the varied parameter that matters most; none where chance explains them all."""
    drawn = cases.drawn()
    if not drawn:
        return []
    name, (case, least, most) = next(iter(drawn.items()))
    of_case = f", {cases.names()[cases.index(case)]}" if len(cases) > 1 else ""
    most_of_it = f"fall with the smallest and the largest {spoken(name)} ({100 * END:g} % of the robots each{of_case})"
    return [(f"{number(100 * least, 2)} and {_percent(most)}", most_of_it)]


def _numbers(cases: Cases, shown: Cases, worst: CaseSummary) -> list[tuple[str, str]]:
    if not worst.fell:
        at_most = f"≤ {_percent(upper_bound(0, worst.n))}"
        text = f"of the robots of a case fall, with 95 % confidence; a certificate allows {100 * MOST_FALLS:g} %"
        return [(at_most, text)]
    if group := _group(cases):
        others = [case for case in cases.worst_first() if case not in group]
        chance, safe = together(group), sum(not case.fell for case in others)
        sure = f" (95 %: {_within(chance)})" if chance.value < 1 else ""
        runs = f": {group[0].n} robots in {len(group)} cases" if len(group) > 1 and sure else ""
        numbers = [(_percent(chance.value), f"of the {_robots_of(cases, group)}{runs}{sure}")]
        outside = (c for c in shown.worst_first() if not any(c.labels.items() <= w.labels.items() for w in group))
        after = next(outside, None)
        if after and after.fell and after.chance:
            inside = f"fall in the next worst case, {shown.names()[shown.index(after)]} (95 %: {_within(after.chance)})"
            numbers.append((f"{number(100 * after.chance.value, 3)} %", inside))
        each = f" (at most {_percent(upper_bound(0, others[-1].n))} may, with 95 % confidence)" if safe else ""
        return [*numbers, (f"{safe} of {len(cases)}", f"cases where none of {others[-1].n} fell{each}")]
    numbers: list[tuple[str, str]] = []
    name, levels = next(iter(cases.effects().items()), ("", {}))
    ranked = sorted(levels, key=lambda v: levels[v].value)
    for level in reversed(ranked if len(ranked) <= 2 else (ranked[0], ranked[-1])):
        chance = levels[level]
        numbers.append((_percent(chance.value), f"fall with {cases.labelled(name, level)} (95 %: {_within(chance)})"))
    numbers += _strongest(cases)
    times = {case.mean("settling"): label for case, label in zip(cases, cases.names(), strict=True)}
    known = sorted(time for time in times if time is not None)
    if len(numbers) < 3 and known and known[-1] > 1.05 * known[0]:
        ends = f"{number(known[0], 3)} to {number(known[-1], 3)} s"
        numbers.append((ends, f"mean time to settle, longest with {times[known[-1]]}"))
    return numbers


def _claim(cases: Cases) -> str:
    group = _group(cases)
    apart = [f"{cases.labelled(name, worst)}" for name, _, (worst, _) in _apart(cases)]
    with_these = _shared(cases, group) if group else joined(apart)
    return f"Robots that fell in each case{f': most with {with_these}' if with_these else ''}"


def _table(cases: Cases) -> Table:
    """A row a case; angles in degrees."""
    kinds = {
        "peak_pitch": ("pitch [°]", 180 / math.pi),
        "settling": ("settles [s]", 1.0),
        "effort": ("effort [V² s]", 1.0),
    }
    shown = [name for name in cases.shown() if name in kinds]
    rows: list[list[Cell]] = []
    names, first = cases.names(), cases.worst_first()
    order = [*(cases.index(case) for case in first), *(k for k, case in enumerate(cases) if case not in first)]
    for name, case in ((names[k], cases[k]) for k in order):
        means = [(case.mean(o), kinds[o][1]) for o in shown]
        fell = None if case.fell is None else 100 * case.fell / case.n
        rows.append([name, fell, *(None if mean is None else factor * mean for mean, factor in means)])
    header = ["case", "fell [%]", *(kinds[o][0] for o in shown)]
    caption = f"Means of those that stood; “settles”: stays within ±{math.degrees(SETTLED):.3g}°"
    return Table(header, rows, caption, 3, even=True, narrow=True)


def _leaning(cases: Cases) -> list[str]:
    """Why robots do not settle on a slope."""
    on_slope = [case for case, origin in zip(cases, cases.origins, strict=False)
                if any(push.get("angle") for push in origin.get("scenario", {}).get("push") or ())]  # fmt: skip
    never = [case for case in on_slope if case.mean("settling") is None]
    if not never:
        return []
    where = "On the slope no robot settles" if len(never) == len(on_slope) else "“–” on the slope: no robot settles"
    return [
        f"{where}, since to stand there it has to lean, by more than {math.degrees(SETTLED):.3g}°. "
        "It stands all the same."
    ]


def _percent(part: float) -> str:
    return f"{number(100 * part, 2)} %"
