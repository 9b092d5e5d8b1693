"""Two runs beside each other: a figure with their difference, and the command that certifies their controller."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from upright.comparison import Comparison
from upright.plotting import AXIS, legend, line, panels, span
from upright.report.page import cell_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

Array = NDArray[np.float64]


def with_difference(comparison: Comparison, t: Array, one: Array, other: Array) -> Figure:
    """Pitch of two runs [rad], and below it by how much the second exceeds the reference, at the times `t` [s]."""
    figure, axes = panels(["pitch [rad]", "difference [rad]"])
    for label, log in comparison.logs.items():
        line(axes[0], label, log.t, log[f"{comparison.sources[label]}/pitch"])
    line(axes[1], "difference", t, other - one, style=4, solid=True)
    for start, stop in comparison.pushed:
        span(axes, start, min(stop, float(t[-1])), "push acts")
    return legend(figure)


def mark_largest(ax: Axes) -> None:
    """A dot where the curve of an axis in degrees is furthest from zero, with its size."""
    curve = next((drawn for drawn in ax.lines if drawn.get_label() == "difference"), None)
    if curve is None:
        return
    x, y = (np.asarray(values, dtype=np.float64) for values in curve.get_data())
    if not np.isfinite(y).any():
        return
    at = int(np.nanargmax(np.abs(y)))
    ax.plot([x[at]], [y[at]], "o", markersize=6, color=AXIS, label="_largest difference")
    text = f"{cell_text(abs(float(y[at])), 3)}°"
    ax.annotate(text, (x[at], y[at]), (6, 0), textcoords="offset points", va="center")
    ax.margins(y=0.15)


def certify_command(robot: str, kind: str) -> str:
    """The command that certifies a controller of a robot, as far as both are known."""
    from upright.control.methods import OURS

    law = kind if kind in {method.name for method in OURS} else "CONTROLLER"
    return f"`upright certify {law}{f' --robot {robot}' if robot else ''}`"
