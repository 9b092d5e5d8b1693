"""The last seconds before a fall, drawn."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.diagnose.causes import KNOWN, Blow
from upright.pages import Quantity, Say
from upright.plotting import INK, line, panels, span
from upright.robots.kit import STOP

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from upright.diagnose.examined import FallExamined

LARGEST = 120.0  # [°] up to which ticks are 40° apart, so that the fall has one
FAR = 1.5  # of the largest lean to recover from
BEFORE, AFTER = 0.3, 0.2  # [s] shown before the onset, at least, and after the fall


def last_seconds(result: FallExamined, push: Blow | None = None, lost: float | None = None) -> Figure:
    """Pitch, and lean and speed over the most that the motors recover from, with the time [s] from which on the robot
    was `lost`; or as a push [N s] that is as hard to stop, beside the `push` that came."""
    s = result.series
    scale = push.most if push else 1.0
    danger = Say("lean and speed, as a push [N s]") if push else Say("lean and speed / the most that can be saved")
    labels = [Say("pitch [°]"), danger]
    figure, axes = panels([str(label) for label in labels], weights=(1.0, 1.2))
    pitch, reach = axes
    degrees = np.degrees(s.pitch)
    line(pitch, str(Say("pitch")), s.t, degrees, style=0, solid=True)
    low, high = float(np.nanmin(degrees)), float(np.nanmax(degrees))
    fallen = math.degrees(STOP)
    for level in (-fallen, fallen):
        if low < level < high:
            _level(pitch, s.t, level, Say("{lean}: fallen", lean=Quantity(math.radians(level), "rad", digits=2)))
    largest = max(abs(low), abs(high))
    if largest < LARGEST:
        apart = 20 if largest < LARGEST / 1.5 else 40
        pitch.set_yticks([tick for tick in range(-80, 81, apart) if low - 5 <= tick <= high + 5])
    line(reach, str(Say("lean and speed")), s.t, scale * s.reserve, style=2, solid=True)
    if push is None:
        _level(reach, s.t, 1.0, Say("no return"))
    else:
        _limits(reach, s.t, push)
    reach.set_ylim(0, FAR * scale)
    if lost is not None:
        reach.plot(lost, 1.0, "o", color=INK, markersize=6)
    _framed(axes, result)
    return figure


def _framed(axes: list[Axes], result: FallExamined) -> None:
    """The time from the onset to the fall shaded, and little before and after it shown."""
    if not (result.fell and math.isfinite(result.onset)):
        return
    t = result.series.t
    span(axes, max(result.onset, float(t[0])), result.fell_at, "_trouble")
    start = max(float(t[0]), result.onset - max(BEFORE, result.fell_at - result.onset))
    axes[0].set_xlim(start, min(float(t[-1]), result.fell_at + AFTER))


def _limits(ax: Axes, t: Array, push: Blow) -> None:
    """The pushes [N s] that the best possible controller survives, and the robot's own; and the one that came, with its
    error."""
    _level(ax, t, push.most, Say("best possible"))
    if push.saves is not None:
        _level(ax, t, push.saves, Say("its controller"), above=False)
    came = push.counts / push.largest * push.most
    highest = FAR * push.most
    ends = np.minimum([(1 - KNOWN) * came, (1 + KNOWN) * came], highest)
    ax.plot(push.start, min(came, highest), "o", color=INK, markersize=4, clip_on=False)
    ax.plot([push.start] * 2, ends, "_-", color=INK, markersize=7, linewidth=1, clip_on=False)
    middle = (min(came, highest) + highest) / 2
    ax.annotate(str(Say("the push")), (push.start, middle), (-8, 0), textcoords="offset points", ha="right")


def _level(ax: Axes, t: Array, level: float, name: Say | None = None, *, above: bool = True) -> None:
    """A dashed line across, with its name `above` or below its left end."""
    line(ax, "_level", t[[0, -1]], [level] * 2, style=4)
    ax.lines[-1].set(linewidth=0.9)
    if name:
        place = (0, 4 if above else -11)
        ax.annotate(str(name), (0.005, level), place, xycoords=("axes fraction", "data"), textcoords="offset points")
