"""The page of a `PostMortem`: the causes with their evidence, and the last seconds with the onset marked."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

import numpy as np

from upright.diagnose import PostMortem
from upright.diagnose.causes import NO_FALL, PUSH
from upright.diagnose.fall import LEANING
from upright.plotting import INK, line, number, numbered, panels, span
from upright.report.figure import Figure
from upright.report.page import Cell, Item, Page, Section, Table, Verdict
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from numpy.typing import NDArray

    Array = NDArray[np.float64]

LARGEST = 120.0  # [°] up to which ticks are 40° apart, so that the fall has one
CUT = 1.2  # of the largest command: a law may ask for much more
SHOWN = 0.02
"""Less likely causes are only in the JSON."""


def page_of(result: PostMortem) -> Page:
    """The post-mortem's page, not yet written."""
    level = "good" if result.verdict == NO_FALL else "bad" if result.fell else "info"
    evidence = [*_words(result), *([_causes(result)] if result.causes else [])]
    sections = [Section("Cause", evidence)] if evidence else []
    drawn = len(result.series.t) > 1
    if drawn:
        sections.append(Section("Reading the figure", [_READ.format(cut=CUT)], folded=True))
    facts = {"robot": result.robot, "kit": result.kit, "samples": str(result.rows)}
    facts |= {"controller": f"{result.controller}, {result.hash[:12]}"} if result.controller else {}
    title = f"Why {result.robot} fell: {result.verdict}" if result.fell else f"{result.robot}: {result.verdict}"
    return Page(
        title, sections, _lead(result), facts, False, verdict=Verdict(_sure(result), level),
        picture=_figure(result) if drawn else None,
        numbers=_numbers(result),
    )  # fmt: skip


_READ = (
    "Shaded: from the first sign to the fall. Dashed in the first panel: 40°, which counts as the fall of a log. A "
    "simulated robot counts as fallen at 80°, where it lies; many logs end before that. The second "
    "panel divides the lean by the largest one that the motors can recover from. Lean and speeds of body and wheels "
    "count together, as the unstable motion that they make. Dashed there: the point of no return. The third panel is "
    "what the controller requests, drawn up to {cut:g} times what the motors give. The last panel, logarithmic, "
    "compares the readings with what the model expects, over a tenth of a second. Without faults it stays below the "
    "dashed line in 39 of 40 cases or more."
)


def _sure(result: PostMortem) -> str:
    """How sure the first cause is."""
    if not result.fell or not result.causes:
        return result.verdict
    likely = result.causes[0].likelihood
    return f"it fell; cause {100 * likely:.0f} % likely" if likely >= SURE else "it fell; the cause is not clear"


def _numbers(result: PostMortem) -> list[tuple[str, str]]:
    """How long the fall took, and the causes after the first."""
    known = result.fell and math.isfinite(result.onset)
    numbers = [(f"{result.fell_at - result.onset:.2g} s", "from the first sign to the fall")] if known else []
    lost = _lost(result)
    if pushed := _push(result):
        numbers.append(pushed)
    elif known and lost is not None:
        numbers.append((f"{lost - result.onset:.2g} s", "from the first sign until the motors could no longer save it"))
    likely = [c for k, c in enumerate(result.causes[:3]) if c.likelihood >= (WORTH if k else SHOWN)]
    if not likely:
        return numbers
    others = "".join(f"; {c.name} {100 * c.likelihood:.0f} %" for c in likely[1:])
    return [*numbers, (f"{100 * likely[0].likelihood:.0f} %", f"probability of this cause{others}")]


def _push(result: PostMortem) -> tuple[str, str] | None:
    """The largest push that the motors bring back, beside the one that came; None where another cause is first."""
    match = _PUSH.search(result.causes[0].evidence) if result.causes and result.causes[0].name == PUSH else None
    if match is None:
        return None
    close = abs(float(match["came"]) / float(match["most"]) - 1) < CLOSE
    came = f"this one had about {match['came']} N s{', too close to tell' if close else ''}"
    return f"{match['most']} N s", f"the largest such push that any controller could save; {came}"


CLOSE = 0.1  # of an impulse: planted ones come out 3 to 7 % small (`benchmarks/push_size.py`, 25 November 2026)
_PUSH = re.compile(
    r"(?P<push>a push \w+ of about (?P<came>[\d.]+) N s at t = [\d.]+ s),.*"
    r"(?P<worth>counts as [\d.]+° of lean; the motors bring back [\d.]+° at most).* a push of "
    r"(?P<most>[\d.]+) N s there"
)


def _lost(result: PostMortem) -> float | None:
    """From when on the drawn lean stays beyond the largest one to recover from, up to the fall [s]."""
    s = result.series
    examined = np.flatnonzero((s.t >= result.onset) & (s.t <= result.fell_at) & np.isfinite(s.reserve))
    inside = np.flatnonzero(s.reserve[examined] < 1)
    after = examined[inside[-1] + 1 :] if len(inside) else examined
    if not len(after):
        return None
    row = int(after[0])
    low, high = s.reserve[max(row - 1, 0) : row + 1][[0, -1]].tolist()
    if not low < 1 <= high:  # it was beyond before, or is not known there
        return float(s.t[row])
    crossing = float(s.t[row - 1] + (1 - low) / (high - low) * (s.t[row] - s.t[row - 1]))
    return max(crossing, result.onset)


SURE = 0.5  # probability from which a cause is named
WORTH = 0.05  # from which one beside the first is among the three numbers


def _lead(result: PostMortem) -> str:
    """When it fell, why, and what to do."""
    if not result.fell:
        return "The robot did not fall in this log."
    text = f"It fell at t = {result.fell_at:.2f} s of the log, where the lean passes 40°."
    best = result.causes[0] if result.causes else None
    if not best:
        return text
    text += f" {sentence(_plain(best.evidence))}" if best.evidence else ""
    repair = best.repair.rstrip(".").replace("`upright push-map`", f"`upright push-map --robot {result.robot}`")
    repair = repair.replace("`upright design`", f"`upright design lqg --robot {result.robot}`")
    return f"{text} Next: {sentence(repair)}" if repair else text


def _plain(evidence: str) -> str:
    """The first clause, without the filter's words; of a push also what it did."""
    if match := _PUSH.search(evidence):
        return f"{match['push']} made it so fast that this {match['worth']}"
    return (
        evidence.split("; ", maxsplit=1)[0]
        .split(". ", maxsplit=1)[0]
        .replace("of the innovations", "of the deviation from the model")
    )


def _words(result: PostMortem) -> list[Item]:
    missing = [f"Missing channels: {', '.join(result.missing)}."] if result.missing else []
    return [*missing, *map(sentence, result.notes)]


def _causes(result: PostMortem) -> Table:
    rows: list[list[Cell]] = [
        [c.name, f"{100 * c.likelihood:.0f} %", f"{c.evidence}.", c.repair]
        for c in result.causes
        if c.likelihood >= SHOWN
    ]
    if rest := 100 - sum(round(100 * c.likelihood) for c in result.causes if c.likelihood >= SHOWN):
        rows.append(["all others", f"{rest} %", "", ""])
    return Table(["cause", "probability", "evidence", "repair"], rows)


def _figure(result: PostMortem) -> Figure:
    s = result.series
    labels = ["pitch [°]", "lean and its speed / the most that can be saved [1]",
              "requested command / what the motors give [1]",
              "surprise of the sensors: error² / expected [1]"]  # fmt: skip
    figure, axes = panels(labels)
    pitch, reach, command, nis = axes
    degrees = np.degrees(s.pitch)
    line(pitch, "pitch", s.t, degrees, style=0, solid=True)
    for level in (-math.degrees(LEANING), math.degrees(LEANING)):
        if np.nanmin(degrees) < level < np.nanmax(degrees):
            _level(pitch, s.t, level, f"{level:.0f}°: counts as the fall".replace("-", "−"))
    apart = 20 if np.nanmax(np.abs(degrees)) < LARGEST / 1.5 else 40
    if np.nanmax(np.abs(degrees)) < LARGEST:
        pitch.set_yticks(
            [tick for tick in range(-80, 81, apart) if np.nanmin(degrees) - 5 <= tick <= np.nanmax(degrees) + 5]
        )
    line(reach, "lean", s.t, s.reserve, style=2, solid=True)
    _level(reach, s.t, 1.0, "no return")
    line(command, "requested command", s.t, np.clip(s.command, -CUT, CUT), step=True, style=1, solid=True)
    for level in (-1.0, 1.0):
        _level(command, s.t, level, "motors at their limit" if level > 0 else "")
    nis.set_yscale("log")
    numbered(nis.yaxis)
    line(nis, "error²", s.t, np.maximum(s.nis, 1e-3), style=4, solid=True)
    low, high = nis.get_ylim()
    nis.set_yticks([power for k in range(-3, 7) if low <= (power := 10.0**k) <= high])
    if math.isfinite(s.high) and s.high > 0:
        _level(nis, s.t, s.high, f"usual, up to {number(s.high, 2)}")
    command.set_ylim(-1.8, 1.8)
    if (np.abs(s.command) > CUT).any():
        above = bool((s.command > CUT).any())
        command.annotate(
            f"drawn up to {CUT:g}", (1, CUT if above else -CUT), (-2, 3 if above else -11), ha="right",
            xycoords=("axes fraction", "data"), textcoords="offset points",
        )  # fmt: skip
    reach.set_ylim(0, 1.5)
    known = result.fell and math.isfinite(result.onset)
    if not known:
        return Figure("The last seconds", figure)
    if (lost := _lost(result)) is not None:
        reach.plot(lost, 1.0, "o", color=INK, markersize=6)
        last_half = lost > (result.onset + result.fell_at) / 2
        words, beside = f"after {lost - result.onset:.2g} s", (-8, -12) if last_half else (8, -12)
        reach.annotate(words, (lost, 1.0), beside, textcoords="offset points", ha="right" if last_half else "left")
    span(axes, max(result.onset, float(s.t[0])), result.fell_at, "_trouble")
    start = max(float(s.t[0]), result.onset - max(BEFORE, result.fell_at - result.onset))
    axes[0].set_xlim(start, min(float(s.t[-1]), result.fell_at + AFTER))
    lasted = result.fell_at - result.onset
    note = "Shaded: from the first sign to the fall."
    if lost is not None and result.causes and result.causes[0].name == PUSH:
        note += (
            " The curves are a filter's, which follows a push some hundredths of a second late: the push itself "
            "decided, not the time after it."
        )
    if lost is not None and (s.reserve[(s.t >= start) & (s.t < lost)] > 1).any():
        note += " The lean passed “no return” before and came back: this limit, the model's, is rough here."
    return Figure(f"From the first sign at {result.onset:.2f} s to the fall it took {lasted:.2g} s", figure, note)


BEFORE, AFTER = 0.4, 0.2  # [s] shown before the onset, at least, and after the fall


def _level(ax: Axes, t: Array, level: float, name: str) -> None:
    """A dashed line across, with its name at its left end."""
    line(ax, "_level", t[[0, -1]], [level] * 2, style=4)
    ax.lines[-1].set(linewidth=0.9)
    ax.annotate(name, (0.005, level), (0, 4), xycoords=("axes fraction", "data"), textcoords="offset points")
