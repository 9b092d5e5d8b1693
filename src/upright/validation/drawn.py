"""Readings of a log, measured and predicted, as drawings."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.calibration.calibrated_robot import GOOD, PREDICTED
from upright.pages import Say
from upright.pages.terms import short
from upright.validation.fits import COMPASS, LogJudged, loop_channels
from upright.validation.loop import FreeLoop

if TYPE_CHECKING:
    from matplotlib.figure import Figure

READINGS = {
    "sensor/gyro": Say("gyro"),
    "sensor/encoder_left": Say("left encoder"),
    "sensor/encoder_right": Say("right encoder"),
    "sensor/encoder_rate_left": Say("left wheel rate"),
    "sensor/encoder_rate_right": Say("right wheel rate"),
    COMPASS: Say("compass"),
    "estimate/pitch": Say("estimated pitch"),
}
BEYOND = 0.5  # of the measured range, above and below it: a simulation that goes further is cut at the frame


def reading(name: str) -> Say:
    """A channel of a log in words."""
    return READINGS.get(name) or Say("{name}", name=short(name))


def half_second_figure(log: LogJudged) -> Figure:
    """Measured and predicted readings, half a second at a time; those that do not pass first, the worst of them."""
    from upright.plotting import legend, line, panels, shade

    r2 = {c.name: min(c.r2, GOOD) for c in log.half_seconds}
    names = [name for name in log.segments.rows if name in PREDICTED] or list(log.segments.rows)
    names.sort(key=lambda name: r2.get(name, GOOD))
    lowest = log.worst.name if log.worst.name in names else names[0]
    error = str(Say("{sensor}, measured − predicted [{unit}]", sensor=reading(lowest), unit=_unit(lowest)))
    figure, axes = panels([*map(_label, names), error])
    for ax, name in zip(axes, names, strict=False):
        t, measured, predicted = _degrees(*log.segments.series(name))
        line(ax, str(Say("measured")), t, measured, style=4, below=True)
        line(ax, str(Say("predicted")), t, predicted, style=1, solid=True)
    t, measured, predicted = _degrees(*log.segments.series(lowest))
    line(axes[-1], "_error", t, measured - predicted, style=0, solid=True)
    if log.simulated is not None and len(log.segments.when):
        when = log.segments.when
        shade(axes, str(Say("push")), log.simulated.pushes, (float(when.min()), float(when.max())))
    return legend(figure)


def loop_figure(loop: FreeLoop) -> Figure:
    """Measured readings, and those of the free closed loop, with its pushes and when each reading is lost."""
    from upright.plotting import AXIS, legend, line, panels, shade

    figure, axes = panels([_label(name) for name in loop.names])
    for i, ax in enumerate(axes):
        t, measured, simulated = _degrees(loop.t, loop.measured[:, i], loop.simulated[:, i])
        line(ax, str(Say("measured")), t, measured, style=4, below=True)
        line(ax, str(Say("simulated")), t, simulated, style=1, solid=True)
        low, high = np.nanmin(measured), np.nanmax(measured)
        room = BEYOND * (high - low)
        if np.nanmax(simulated) > high + room or np.nanmin(simulated) < low - room:
            ax.set_ylim(low - room, high + room)
    shade(axes, str(Say("push, not simulated")), loop.pushes, (float(loop.t[0]), float(loop.t[-1])))
    for ax, channel in zip(axes, loop_channels(loop), strict=True):
        if channel.breaks is not None and channel.name != COMPASS:
            ax.axvline(channel.breaks, linestyle="--", linewidth=1, color=AXIS)
            ax.annotate(str(Say("lost")), (channel.breaks, 0.04), (4, 0), xycoords=("data", "axes fraction"),
                        textcoords="offset points")  # fmt: skip
    return legend(figure)


def _degrees(t: Array, *readings: Array) -> tuple[Array, ...]:
    return (t, *map(np.degrees, readings))


def _label(name: str) -> str:
    return f"{reading(name)} [{_unit(name)}]"


def _unit(name: str) -> str:
    return PREDICTED.get(name, "rad").replace("rad", "°")
