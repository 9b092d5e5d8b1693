"""The page of a `PostMortem`: the causes with their evidence, and the last seconds with the onset marked."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.diagnose import PostMortem
from upright.diagnose.blows import HELPED, PUSHED
from upright.diagnose.causes import (
    DROPPED,
    HIGH,
    KNOWN,
    LOW,
    NO_FALL,
    OFF,
    PUSH,
    REVERSED,
    SATURATION,
    STUCK,
    WALL,
    Blow,
    Cause,
)
from upright.diagnose.fall import LEANING
from upright.diagnose.series import Series
from upright.plotting import INK, line, number, numbered, panels, span
from upright.reports.figure import Figure
from upright.reports.page import Cell, Item, Page, Section, Table, Verdict
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LARGEST = 120.0  # [°] up to which ticks are 40° apart, so that the fall has one
CUT = 1.2  # of the largest command: a law may ask for much more
FAR = 1.5  # of the largest lean to recover from
SHOWN = 0.02
"""Less likely causes are only in the JSON."""


def page_of(result: PostMortem) -> Page:
    """The post-mortem's page, not yet written."""
    level = "good" if result.verdict == NO_FALL else "bad" if result.fell else "info"
    evidence = [*_words(result), *([_causes(result)] if result.causes else []), *_most(result)]
    sections = [Section("Cause", evidence)] if evidence else []
    drawn = len(result.series.t) > 1
    if drawn:
        read = _READ.format(cut=CUT) + ("" if result.fell and _blow(result) else _SURPRISE)
        sections.append(Section("Reading the figure", [read], folded=True))
    facts = {"robot": result.robot, "kit": result.kit, "samples": str(result.rows)}
    facts |= {"controller": f"{result.controller}, {result.hash[:12]}"} if result.controller else {}
    title = f"Why {result.robot} fell: {result.verdict}" if result.fell else f"{result.robot}: {result.verdict}"
    return Page(
        title, sections, _lead(result), facts, False, verdict=Verdict(_sure(result), level),
        picture=_figure(result) if drawn else None,
        numbers=_numbers(result),
    )  # fmt: skip


_READ = (
    "Dashed in the first panel: 40°, at which a log counts as fallen (known to a sample or two). A simulated robot "
    "counts as fallen at 80°, where it lies; many logs end before that. The second panel adds the lean and the speeds "
    "of body and wheels, as the unstable motion that they make together. It divides the sum by the most that the "
    "motors can recover from: beyond 1 there is no return. The third panel is what the controller requests, drawn up "
    "to {cut:g} times what the motors give."
)
_SURPRISE = (
    " The last panel, logarithmic, compares the readings with what the model expects, over a tenth of a second. "
    "Without faults it stays below the dashed line in 39 of 40 cases or more."
)


def _most(result: PostMortem) -> list[Item]:
    """Why no push is surer."""
    return [_MOST.format(100 * SUREST)] if _blow(result) else []


SUREST = PUSHED * (1 - HELPED)  # a push's largest probability
_MOST = (
    "A push never gets more than {:.0f} %. The rest is kept for what the log does not show, and for a fault that looks "
    "like a push."
)


def _blow(result: PostMortem) -> Blow | None:
    """The push that is the first cause; None where another is."""
    return result.causes[0].push if result.causes else None


def _sure(result: PostMortem) -> str:
    """How sure the first cause is."""
    if not result.fell or not result.causes:
        return result.verdict
    likely = result.causes[0].likelihood
    return f"it fell; cause {100 * likely:.0f} % likely" if likely >= SURE else "it fell; the cause is not clear"


def _numbers(result: PostMortem) -> list[tuple[str, str]]:
    """The push beside the largest to save, or how long the fall took; and the causes after the first."""
    known = result.fell and math.isfinite(result.onset)
    push, lost = _blow(result), _lost(result)
    numbers = []
    if push:
        where = f"the push at {push.start:.2f} s, {push.lasted}, taken to hit {push.height:.2g} m above the axle"
        most, by = (push.most, "the best possible") if push.saves is None else (push.saves, "its")
        best = f"the largest such push that {by} controller survives{push.powered}"
        numbers = [(push.size, where), (f"{most:.2g} N s", best)]
    elif known:
        since = _SINCE.get(result.verdict, "from the first sign, where the sensors differ from the model,")
        numbers = [(f"{result.fell_at - result.onset:.2g} s", f"{since} to the fall")]
        if lost is not None and result.verdict != OFF:  # motors that are off save nothing
            numbers.append((f"{lost - result.onset:.2g} s", "from then until the motors could no longer save it"))
    likely = [c for k, c in enumerate(result.causes[:3]) if c.likelihood >= (WORTH if k else SHOWN)]
    if not likely:
        return numbers
    first = likely[0].likelihood
    others = [f"{c.name} {100 * c.likelihood:.0f} %" for c in likely[1:]]
    next_to_it = f"; second: {', '.join(others)}" if others else ""
    this = "that the push felled it" if push else "of this cause"
    return [*numbers, (f"{100 * first:.0f} %", f"probability {this}{next_to_it}")]


_LAST = "examined for the controller, up"
_SINCE = {
    OFF: "from when the motors went off", DROPPED: "from when the program stood still or readings were lost",
    STUCK: "from when the sensor stood still", PUSH: "from the blow", WALL: "from when the wheels were held",
    REVERSED: "from the beginning of the fall", LOW: _LAST, HIGH: _LAST, SATURATION: _LAST,
}  # fmt: skip
"""Since when a cause shows that no reading shows which differs from the model."""


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
    text = f"It fell at t = {result.fell_at:.2f} s of the log, when the lean passed 40°."
    best = result.causes[0] if result.causes else None
    if not best:
        return text
    text += f" {sentence(_plain(best))}" if best.evidence else ""
    repair = (best.push.remedy if best.push else best.repair).rstrip(".")
    return f"{text} Next: {sentence(repair)}" if repair else text


def _plain(cause: Cause) -> str:
    """The first clause of the evidence, without the filter's words; of a push how it compares with what is saved."""
    if push := cause.push:
        return f"{push} most likely threw it over. {sentence(push.limits, '')}"
    return (
        cause.evidence.split("; ", maxsplit=1)[0]
        .split(". ", maxsplit=1)[0]
        .replace("of the innovations", "of the deviation from the model")
    )


def _words(result: PostMortem) -> list[Item]:
    missing = [f"Missing channels: {', '.join(result.missing)}."] if result.missing else []
    return [*missing, *map(sentence, result.notes)]


def _evidence(cause: Cause) -> str:
    """The evidence; of a push only what the lead does not say."""
    if not (push := cause.push):
        return f"{cause.evidence}."
    counts = f"{push.lean}°"
    largest = f"{math.degrees(push.largest):.3g}°"
    return (
        f"that push alone explains {100 * min(push.explained, 0.999):.3g} % of the squared innovations. The speed that "
        f"it gives is as hard to stop as a lean at rest of {counts}; the motors bring back {largest} at most (a push "
        f"of {push.most:.2g} N s)."
    )


def _causes(result: PostMortem) -> Table:
    rows: list[list[Cell]] = [
        [
            c.name,
            f"{100 * c.likelihood:.0f} %",
            _evidence(c) if k == 0 else f"{c.evidence}.",
            c.push.remedy if c.push else c.repair,
        ]
        for k, c in enumerate(result.causes)
        if c.likelihood >= SHOWN
    ]
    if rest := 100 - sum(round(100 * c.likelihood) for c in result.causes if c.likelihood >= SHOWN):
        rows.append(["all others", f"{rest} %", "", ""])
    return Table(["cause", "probability", "evidence", "repair"], rows)


def _figure(result: PostMortem) -> Figure:
    s = result.series
    push = _blow(result) if result.fell else None
    labels = ["pitch [°]", "lean and speed together / the most that can be saved",
              "requested command / the most that the motors give"]  # fmt: skip
    surprise = [] if push else ["surprise of the sensors: error² / expected"]  # its model knows no push
    figure, axes = panels([*labels, *surprise], weights=(1.0, 1.5, 0.8, 1.0)[: 4 if surprise else 3])
    pitch, reach, command = axes[:3]
    degrees = np.degrees(s.pitch)
    line(pitch, "pitch", s.t, degrees, style=0, solid=True)
    for level in (-math.degrees(LEANING), math.degrees(LEANING)):
        if np.nanmin(degrees) < level < np.nanmax(degrees):
            _level(pitch, s.t, level, f"{level:.0f}°: fallen".replace("-", "−"))
    apart = 20 if np.nanmax(np.abs(degrees)) < LARGEST / 1.5 else 40
    if np.nanmax(np.abs(degrees)) < LARGEST:
        pitch.set_yticks(
            [tick for tick in range(-80, 81, apart) if np.nanmin(degrees) - 5 <= tick <= np.nanmax(degrees) + 5]
        )
    line(reach, "lean", s.t, s.reserve, style=2, solid=True)
    _commands(command, s.t, s.command, result.fell_at)
    if surprise:
        _surprise(axes[3], result)
    _limits(reach, s.t, push)
    reach.set_ylim(0, FAR)
    known = result.fell and math.isfinite(result.onset)
    if not known:
        return Figure("The last seconds", figure)
    if (lost := _lost(result)) is not None and not push:
        reach.plot(lost, 1.0, "o", color=INK, markersize=6)
        last_half = lost > (result.onset + result.fell_at) / 2
        beside = (-8, -12) if last_half else (8, -12)
        words = f"after {lost - result.onset:.2g} s"
        side = "right" if last_half else "left"
        reach.annotate(words, (lost, 1.0), beside, textcoords="offset points", ha=side)
    if push:
        _dot(reach, push)
    span(axes, max(result.onset, float(s.t[0])), result.fell_at, "_trouble")
    start = max(float(s.t[0]), result.onset - max(BEFORE, result.fell_at - result.onset))
    axes[0].set_xlim(start, min(float(s.t[-1]), result.fell_at + AFTER))
    lasted = result.fell_at - result.onset
    sign = "push" if push else "first sign"
    note = f"Shaded: from the {sign} to the fall."
    if push:
        note += _SLOWED if _slows(s, push.start) else ""
        note += _DOT
    if lost is not None and (s.reserve[(s.t >= start) & (s.t < lost)] > 1).any():
        note += " The lean passed “no return” before and came back: this limit, the model's, is rough here."
    return Figure(f"{lasted:.2g} s from the {sign} at {result.onset:.2f} s to the fall", figure, note)


_DOT = (
    " Lean and speed: the curve's estimator needs some hundredths of a second to follow a push. The dot is the push, "
    "estimated from the whole log; ± is the largest error that test pushes of known size had."
)
_SLOWED = " Pitch: it jumps with the push, then grows more slowly while the wheels catch up with the body."
JUMP = 0.05  # [s] in which a push turns the body, before the wheels follow


def _slows(s: Series, start: float) -> bool:
    """Whether the pitch turns, after a push, twice as fast at first as in the hundredths of a second after it."""
    first, then = (
        np.nanmax(np.abs(s.pitch_rate[(s.t >= low) & (s.t < low + JUMP)]), initial=0.0) for low in (start, start + JUMP)
    )
    return bool(first > 2 * then)


def _limits(ax: Axes, t: Array, push: Blow | None) -> None:
    """What the best possible controller saves, and the robot's own."""
    _level(ax, t, 1.0, "no return" if push is None else "best possible")
    if push is not None and push.saves is not None:
        own = push.saves / push.most
        _level(ax, t, own, f"its own: {own:.2f}", above=False)


def _dot(ax: Axes, push: Blow) -> None:
    """A push over the largest that the motors bring back, with its error."""
    part = push.counts / push.largest
    ends = np.minimum([(1 - KNOWN) * part, (1 + KNOWN) * part], FAR)
    ax.plot(push.start, min(part, FAR), "o", color=INK, markersize=4, clip_on=False)
    ax.plot([push.start] * 2, ends, "_-", color=INK, markersize=7, linewidth=1, clip_on=False)
    words = f"push: {part:.2f} ± {KNOWN * part:.2f}"
    ax.annotate(words, (push.start, (min(part, FAR) + FAR) / 2), (-8, 0), textcoords="offset points", ha="right")


BEFORE, AFTER = 0.3, 0.2  # [s] shown before the onset, at least, and after the fall


def _surprise(ax: Axes, result: PostMortem) -> None:
    """The squared innovations over what the model expects of them."""
    s = result.series
    ax.set_yscale("log")
    numbered(ax.yaxis)
    line(ax, "error²", s.t, np.maximum(s.nis, 1e-3), style=4, solid=True)
    low, high = ax.get_ylim()
    ax.set_yticks([power for k in range(-3, 7) if low <= (power := 10.0**k) <= high])
    if math.isfinite(s.high) and s.high > 0:
        _level(ax, s.t, s.high, f"usual, up to {number(s.high, 2)}")


def _commands(ax: Axes, t: Array, command: Array, fell_at: float) -> None:
    """What the controller requests, over the largest command, up to `CUT`."""
    line(ax, "requested command", t, np.clip(command, -CUT, CUT), step=True, style=1, solid=True)
    for level in (-1.0, 1.0):
        _level(ax, t, level, "motors' limit" if level > 0 else "")
    ax.set_ylim(-1.8, 1.8)
    if (np.abs(command) > CUT).any():
        above = bool((command > CUT).any())
        ax.set_ylim(*((-1.8, 2.8) if above else (-2.8, 1.8)))  # with room for the words
        ax.set_yticks([-1, 0, 1])
        before = np.abs(command[t <= fell_at] if math.isfinite(fell_at) else command)
        words = f"cut at {CUT:g}; {before[-1]:.2g} at the fall" if len(before) else f"cut at {CUT:g}"
        _cut(ax, CUT if above else -CUT, words, above=above)


def _cut(ax: Axes, level: float, words: str, *, above: bool) -> None:
    """Up to where a curve is drawn, in words `above` or below that level at the right end."""
    ax.annotate(
        words, (1, level), (-2, 6 if above else -11), ha="right",
        xycoords=("axes fraction", "data"), textcoords="offset points",
    )  # fmt: skip


def _level(ax: Axes, t: Array, level: float, name: str, *, above: bool = True) -> None:
    """A dashed line across, with its name `above` or below its left end."""
    line(ax, "_level", t[[0, -1]], [level] * 2, style=4)
    ax.lines[-1].set(linewidth=0.9)
    place = (0, 4 if above else -11)
    ax.annotate(name, (0.005, level), place, xycoords=("axes fraction", "data"), textcoords="offset points")
