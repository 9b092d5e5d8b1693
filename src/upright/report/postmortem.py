"""The page of a `PostMortem`: the causes with their evidence, and the last seconds with the onset marked."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.diagnose import PostMortem
from upright.diagnose.causes import NO_FALL, Cause
from upright.diagnose.fall import LEANING
from upright.diagnose.verdict import HELPED, PUSHED
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
        sections.append(Section("Reading the figure", [_READ.format(cut=CUT)], folded=True))
    facts = {"robot": result.robot, "kit": result.kit, "samples": str(result.rows)}
    facts |= {"controller": f"{result.controller}, {result.hash[:12]}"} if result.controller else {}
    push = result.causes[0].push if result.causes else None
    why = "a push at the limit" if push and push.close else result.verdict
    title = f"Why {result.robot} fell: {why}" if result.fell else f"{result.robot}: {result.verdict}"
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
    "dashed line in 39 of 40 cases or more. `upright doctor` smooths the gyro, so its fall begins some hundredths of a "
    "second before the first sign."
)


def _most(result: PostMortem) -> list[Item]:
    """Why no push is surer."""
    if not result.causes or result.causes[0].push is None:
        return []
    return [_MOST.format(100 * PUSHED * (1 - HELPED))]


_MOST = (
    "No push is given more than {:.0f} %: in about one fall of ten something that the log does not show adds to it, "
    "and a fault may look like a push."
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
    pushed = _push(result)
    sign = "push" if pushed else "first sign, where the sensors differ from the model,"
    numbers = [(f"{result.fell_at - result.onset:.2g} s", f"from the {sign} to the fall")] if known else []
    lost = _lost(result)
    if pushed:
        numbers.append(pushed)
    elif known and lost is not None:
        numbers.append((f"{lost - result.onset:.2g} s", "from the first sign until the motors could no longer save it"))
    likely = [c for k, c in enumerate(result.causes[:3]) if c.likelihood >= (WORTH if k else SHOWN)]
    if not likely:
        return numbers
    others = "".join(f"; {c.name} {100 * c.likelihood:.0f} %" for c in likely[1:])
    this = "that the push felled it, not something else" if pushed else "of this cause"
    return [*numbers, (f"{100 * likely[0].likelihood:.0f} %", f"probability {this}{others}")]


def _push(result: PostMortem) -> tuple[str, str] | None:
    """The largest push that the motors bring back, beside the one that came; None where another cause is first."""
    push = result.causes[0].push if result.causes else None
    if push is None:
        return None
    came = f"this one had {push.size()}{', about as much' if push.close else ''}"
    return f"{push.most:.2g} N s", f"the largest such push that the best controller could save; {came}"


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
    text += f" {sentence(_plain(best))}" if best.evidence else ""
    repair = best.repair.rstrip(".").replace("`upright push-map`", f"`upright push-map --robot {result.robot}`")
    repair = repair.replace("`upright design`", f"`upright design lqg --robot {result.robot}`")
    return f"{text} Next: {sentence(repair)}" if repair else text


def _plain(cause: Cause) -> str:
    """The first clause of the evidence, without the filter's words; of a push what it did."""
    if push := cause.push:
        counts, largest = (f"{math.degrees(angle):.2g}°" for angle in (push.counts, push.largest))
        text = f"{push} gave it a speed that is as hard to stop as a lean at rest of {counts}"
        if push.close:
            return f"{text}, about the most that the best controller brings back ({largest}); yours saves no more"
        return f"{text}; the motors bring back {largest} at most"
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
    return (
        f"that push alone explains {100 * min(push.explained, 0.999):.3g} % of the innovations, assumed to hit "
        f"{push.height:.2g} m above the axle."
    )


def _causes(result: PostMortem) -> Table:
    rows: list[list[Cell]] = [
        [
            c.name,
            f"{100 * c.likelihood:.0f} %",
            _evidence(c) if k == 0 else f"{c.evidence}.",
            "see Next, above" if k == 0 and c.repair else c.repair,
        ]
        for k, c in enumerate(result.causes)
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
            _level(pitch, s.t, level, f"{level:.0f}°: fallen".replace("-", "−"))
    apart = 20 if np.nanmax(np.abs(degrees)) < LARGEST / 1.5 else 40
    if np.nanmax(np.abs(degrees)) < LARGEST:
        pitch.set_yticks(
            [tick for tick in range(-80, 81, apart) if np.nanmin(degrees) - 5 <= tick <= np.nanmax(degrees) + 5]
        )
    line(reach, "lean", s.t, s.reserve, style=2, solid=True)
    _level(reach, s.t, 1.0, "no return")
    _commands(command, s.t, s.command)
    nis.set_yscale("log")
    numbered(nis.yaxis)
    line(nis, "error²", s.t, np.maximum(s.nis, 1e-3), style=4, solid=True)
    low, high = nis.get_ylim()
    nis.set_yticks([power for k in range(-3, 7) if low <= (power := 10.0**k) <= high])
    if math.isfinite(s.high) and s.high > 0:
        _level(nis, s.t, s.high, f"usual, up to {number(s.high, 2)}")
    reach.set_ylim(0, FAR)
    if np.nanmax(s.reserve, initial=0.0) > FAR:
        _cut(reach, FAR, above=False)
    known = result.fell and math.isfinite(result.onset)
    if not known:
        return Figure("The last seconds", figure)
    pushed = bool(result.causes) and result.causes[0].push is not None
    if (lost := _lost(result)) is not None and not pushed:
        reach.plot(lost, 1.0, "o", color=INK, markersize=6)
        last_half = lost > (result.onset + result.fell_at) / 2
        beside = (-8, -12) if last_half else (8, -12)
        words, side = f"after {lost - result.onset:.2g} s", "right" if last_half else "left"
        reach.annotate(words, (lost, 1.0), beside, textcoords="offset points", ha=side)
    if pushed and (push := result.causes[0].push):
        part = push.counts / push.largest
        reach.plot(push.start, min(part, FAR), "o", color=INK, markersize=6, clip_on=False)
        reach.annotate("the push", (push.start, 1), (-8, -12), textcoords="offset points", ha="right")
    span(axes, max(result.onset, float(s.t[0])), result.fell_at, "_trouble")
    start = max(float(s.t[0]), result.onset - max(BEFORE, 0.7 * (result.fell_at - result.onset)))
    axes[0].set_xlim(start, min(float(s.t[-1]), result.fell_at + AFTER))
    lasted = result.fell_at - result.onset
    note = f"Shaded: from the {'push' if pushed else 'first sign'} to the fall."
    if lost is not None and pushed:
        note += (
            " The curves come from an estimator, which lags a push by some hundredths of a second. The dot is the push "
            "as the whole log shows it: that alone decided."
        )
    if lost is not None and (s.reserve[(s.t >= start) & (s.t < lost)] > 1).any():
        note += " The lean passed “no return” before and came back: this limit, the model's, is rough here."
    sign = "push" if pushed else "first sign"
    return Figure(f"From the {sign} at {result.onset:.2f} s to the fall it took {lasted:.2g} s", figure, note)


BEFORE, AFTER = 0.3, 0.2  # [s] shown before the onset, at least, and after the fall


def _commands(ax: Axes, t: Array, command: Array) -> None:
    """What the controller requests, over the largest command, up to `CUT`."""
    line(ax, "requested command", t, np.clip(command, -CUT, CUT), step=True, style=1, solid=True)
    for level in (-1.0, 1.0):
        _level(ax, t, level, "motors' limit" if level > 0 else "")
    ax.set_ylim(-1.8, 1.8)
    if (np.abs(command) > CUT).any():
        above = bool((command > CUT).any())
        ax.set_ylim(*((-1.8, 2.8) if above else (-2.8, 1.8)))  # with room for the words
        ax.set_yticks([-1, 0, 1])
        _cut(ax, CUT if above else -CUT, above=above)


def _cut(ax: Axes, level: float, *, above: bool) -> None:
    """Up to where a curve is drawn, in words `above` or below that level at the right end."""
    ax.annotate(
        f"drawn up to {abs(level):g}", (1, level), (-2, 3 if above else -11), ha="right",
        xycoords=("axes fraction", "data"), textcoords="offset points",
    )  # fmt: skip


def _level(ax: Axes, t: Array, level: float, name: str) -> None:
    """A dashed line across, with its name at its left end."""
    line(ax, "_level", t[[0, -1]], [level] * 2, style=4)
    ax.lines[-1].set(linewidth=0.9)
    ax.annotate(name, (0.005, level), (0, 4), xycoords=("axes fraction", "data"), textcoords="offset points")
