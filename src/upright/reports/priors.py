"""Which parameters a log determines, and the figure of each beside what was known before."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.calibration.calibration import Calibration
from upright.calibration.estimate import BOUNDED, CLOSE, MEASURED, NORMAL, NOT_VISIBLE, VISIBLE, Estimate
from upright.plotting import COLOURS, INK, SMALL, SPAN, legend, number, rows_of
from upright.reports.figure import Figure
from upright.reports.page import cell_text
from upright.robots import PARAMETERS
from upright.tables import spoken

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawing

FAR = 8.0  # standard deviations of the prior: the figure ends there
OFF = COLOURS[1]  # of a number that the log puts outside what was known before
ROOM = 0.08  # of the width, for the number beside the longest bar


def groups(c: Calibration) -> tuple[list[Estimate], list[Estimate], list[Estimate]]:
    """What the log measures, the closest first; what it only bounds from above; and what it gives roughly."""
    visible = sorted((e for e in c.parameters if e.verdict == VISIBLE and not c.refused), key=lambda e: e.width)
    close, bounded = [e for e in visible if e.measured], [e for e in visible if e.one_sided]
    return close, bounded, [e for e in visible if e not in bounded and e not in close]


def by_name(c: Calibration) -> Figure | None:
    drawn = [e for e in c.parameters if 0 < e.prior_spread < math.inf]
    if not drawn:
        return None
    close, bounded, rough = groups(c)
    note = f"Measured: at least twice as certain as before, and to ± {100 * CLOSE:g} % or better. " if close else ""
    if bounded or rough:
        note += "Bounded: twice as certain, but known roughly, or only how large it is at most (≤). "
    note += f"Not visible: the log adds little. σ: standard deviation{_factor(drawn)}."
    note += f" The 95 % before ends at ± {NORMAL:.0f} σ, or at zero."
    if any(e.asked.coordinate(e.high) > FAR for e in drawn):
        note += " An arrow: the bar goes on."
    if any(e.wider for e in c.parameters):
        note += " Wider: less certain than in the file, for the reason that the notes give."
    halved = len(close) + len(bounded) + len(rough)
    far = sum(e.off and e.verdict != VISIBLE for e in drawn)
    title = "The 95 % interval of each parameter after this log, and before: "
    title += f"{halved or 'none'} of {len(c.parameters)} at least halved{f', {far} moved far off' if far else ''}"
    return Figure(title, _bars(c), note)


def _factor(drawn: list[Estimate]) -> str:
    """That of the logarithm a deviation is a factor, with the parameter that has the largest."""
    positive = [e for e in drawn if e.scale == "logarithm"]
    if not positive:
        return ""
    e = max(positive, key=lambda e: e.asked.rate)
    factor = f"× or ÷ {number(math.exp(e.asked.rate), 2)} for the {spoken(e.name)}"
    return f"; of numbers that must be positive a factor, {factor}"


def _bars(c: Calibration) -> Drawing:
    """Intervals in standard deviations of the prior, coloured by what the log says of the parameter."""
    close, bounded, rough = groups(c)
    sorts = {
        MEASURED: (close, COLOURS[2]),
        BOUNDED: ([*rough, *bounded], COLOURS[0]),
        NOT_VISIBLE: ([e for e in c.parameters if e not in (*close, *rough, *bounded)], INK),
    }
    kept = {k: ([e for e in group if 0 < e.prior_spread < math.inf], tone) for k, (group, tone) in sorts.items()}
    names = [e.name for group, _ in kept.values() for e in group]
    figure, ax = rows_of(names, "difference from the robot's file [σ of the file]", "parameter")
    for label, (group, colour) in kept.items():
        if group:
            rows = [names.index(e.name) for e in group]
            value, low, high = ([e.asked.coordinate(x) for e, x in zip(group, xs, strict=True)]
                                for xs in zip(*((e.value, e.low, e.high) for e in group), strict=True))  # fmt: skip
            no_dot = [e in bounded and e.name in PARAMETERS for e in group]
            low = [_zero(e) if side else x for e, x, side in zip(group, low, no_dot, strict=True)]
            ax.hlines(rows, low, np.minimum(high, FAR), linewidth=2.5, color=colour, label=label)
            for e, row, x, end, side in zip(group, rows, value, high, no_dot, strict=True):
                mark, size = ("|", 9.0) if side else ("o", 4.5)
                tone = OFF if e.outside else colour
                ax.plot(end if side else x, row, mark, color=tone, markersize=size, markeredgewidth=size / 4.5)
            if off := [(row, a, b) for e, row, a, b in zip(group, rows, low, high, strict=True) if e.outside]:
                at, ends, tops = zip(*off, strict=True)
                ax.hlines(at, ends, np.minimum(tops, FAR), linewidth=2.5, color=OFF, label="outside that before")
            for e, row, x, end in zip(group, rows, value, high, strict=True):
                place = max(end, x)
                text = f"→ {_beside(e)}".strip() if place > FAR else _beside(e)
                where: dict[str, Any] = {"textcoords": "offset points", "va": "center", "size": SMALL}
                if e.outside and x > 0:  # the end may be the figure's
                    ax.annotate(text, (min(low[rows.index(row)], x), row), (-6, 0), ha="right", **where)
                else:
                    ax.annotate(text, (min(place, FAR), row), (6, 0), **where)
    every = [e for group, _ in kept.values() for e in group]
    least = [max(-NORMAL, _zero(e)) if e.name in PARAMETERS and e.scale == "linear" else -NORMAL for e in every]
    ax.barh(
        range(len(every)),
        [NORMAL - x for x in least],
        1.0,
        least,
        color=SPAN,
        alpha=0.22,
        zorder=0,
        label="95 % before this log",
    )
    low, high = (max(min(end, FAR), -FAR) for end in ax.get_xlim())
    low = min(low, -1.1 * NORMAL)
    ax.set_xlim(low, high + ROOM * (high - low))
    return legend(figure)


def _zero(e: Estimate) -> float:
    """Where zero lies, which no number of a robot is below, in standard deviations of the prior."""
    return -e.prior / e.prior_spread


def _beside(e: Estimate) -> str:
    """What stands beside a bar: how closely the log tells the number, where it does, or where it puts it."""
    if e.outside:
        times = f", {number(e.value / e.prior, 2)} × the file" if e.prior else ""
        return f"{times.removeprefix(', ')}, wider" if times and e.wider else f"{cell_text(e.value, 2)} {e.unit}{times}"
    if e.wider:
        return "wider"
    if e.verdict != VISIBLE:
        return ""
    return f"≤ {cell_text(e.high, 2)} {e.unit}" if e.one_sided else f"± {number(100 * e.width, 2)} %"
