"""Which parameters a log determines, and the figure of each beside what was known before."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.calibrate.calibration import NORMAL, VISIBLE, Calibration, Estimate
from upright.plotting import COLOURS, INK, SMALL, SPAN, legend, number, rows_of
from upright.report.figure import Figure
from upright.robots import PARAMETERS
from upright.tables import joined, spoken

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Drawing

CLOSE = 0.25  # of a value: the half width of an interval up to which it counts as measured
MEASURED, BOUNDED = f"{VISIBLE}: measured", f"{VISIBLE}: bounded"
NOT_VISIBLE = f"not {VISIBLE}"
FAR = 5.0  # standard deviations of the prior: the figure ends there
ROOM = 0.08  # of the width, for the number beside the longest bar


def groups(c: Calibration) -> tuple[list[Estimate], list[Estimate], list[Estimate]]:
    """What the log measures, the closest first; what it only bounds from above; and what it gives roughly."""
    visible = sorted((e for e in c.parameters if e.verdict == VISIBLE and not c.refused), key=width)
    bounded = [e for e in visible if e.low * e.high <= 0 or e.low < 0.1 * e.high]
    measured = [e for e in visible if e not in bounded and width(e) <= CLOSE]
    return measured, bounded, [e for e in visible if e not in bounded and e not in measured]


def width(e: Estimate) -> float:
    """Half of the interval over the value."""
    return (e.high - e.low) / max(abs(e.high + e.low), 1e-300)


def by_name(c: Calibration) -> Figure | None:
    if not any(0 < e.prior_spread < math.inf for e in c.parameters):
        return None
    note = (
        "Numbers: the part of the uncertainty that is left. Measured: at most half, and ± "
        f"{100 * CLOSE:g} % or better. Bounded: at most half, but wider. Not visible: more, or not reliable."
    )
    drawn = [e for e in c.parameters if 0 < e.prior_spread < math.inf]
    one_sided = [e for e in groups(c)[1] if e in drawn and e.name in PARAMETERS]
    short = [e for e in drawn if e not in one_sided and e.high - e.low < 0.1 * e.prior_spread]
    far = [spoken(e.name) for e in drawn if abs(e.value - e.prior) > NORMAL * e.prior_spread and e not in one_sided]
    if far:
        note += f" Outside what was known before: {joined(far)}. Check the robot's file there."
    if any(e.high - e.prior > FAR * e.prior_spread for e in drawn):
        note += " An arrow: the bar goes on."
    if any(e.wider for e in c.parameters):
        note += " Wider: the log knows less of it than the file, for the reason beside the estimates."
    note += " A dot without a bar: its interval is shorter than the dot." if short else ""
    note += " A bar without a dot reaches from zero to an upper bound." if one_sided else ""
    return Figure("What this log tells of each parameter, beside what was known before", _bars(c), note)


def _bars(c: Calibration) -> Drawing:
    """Intervals in standard deviations of the prior, coloured by what the log says of the parameter."""
    measured, bounded, rough = groups(c)
    sorts = {
        MEASURED: (measured, COLOURS[2]),
        BOUNDED: ([*rough, *bounded], COLOURS[0]),
        NOT_VISIBLE: ([e for e in c.parameters if e not in (*measured, *rough, *bounded)], INK),
    }
    kept = {k: ([e for e in group if 0 < e.prior_spread < math.inf], tone) for k, (group, tone) in sorts.items()}
    names = [e.name for group, _ in kept.values() for e in group]
    figure, ax = rows_of(names, "difference from the value before [its standard deviations]", "parameter")
    for label, (group, colour) in kept.items():
        if group:
            rows = [names.index(e.name) for e in group]
            value, low, high = ([(x - e.prior) / e.prior_spread for e, x in zip(group, xs, strict=True)]
                                for xs in zip(*((e.value, e.low, e.high) for e in group), strict=True))  # fmt: skip
            one_sided = [e in bounded and e.name in PARAMETERS for e in group]
            low = [_zero(e) if side else x for e, x, side in zip(group, low, one_sided, strict=True)]
            ax.hlines(
                rows, low, np.minimum(high, FAR), linewidth=2.5, color=colour, label=label.removeprefix(f"{VISIBLE}: ")
            )
            for row, x, end, side in zip(rows, value, high, one_sided, strict=True):
                mark, size = ("|", 9.0) if side else ("o", 4.5)
                ax.plot(end if side else x, row, mark, color=colour, markersize=size, markeredgewidth=size / 4.5)
            for e, row, x, end in zip(group, rows, value, high, strict=True):
                place = max(end, x)
                ax.annotate(
                    f"→ {_left(e)}" if place > FAR else _left(e),
                    (min(place, FAR), row),
                    (6, 0),
                    textcoords="offset points",
                    va="center",
                    size=SMALL,
                )
    every = [e for group, _ in kept.values() for e in group]
    least = [max(-NORMAL, _zero(e)) if e.name in PARAMETERS else -NORMAL for e in every]
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


def _left(e: Estimate) -> str:
    """How much of the uncertainty is left [%], with more digits where they decide whether it is half; in a word where
    it is more than before."""
    if e.wider:
        return "wider"
    left = min(100 * e.shrink, 100.0)
    return next((text for digits in (2, 3, 4) if (text := number(left, digits)) != "50"), "50") + " %"
