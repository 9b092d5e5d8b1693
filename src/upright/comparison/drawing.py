"""Runs over time: their states in degrees, and their commands."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from upright.logs.recording import commanded
from upright.pages import Say

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from upright.comparison.runs import Compared

DWARFED = 5.0
"""A run that leaves the reference's range by more than this many times its width is cut at the frame."""

STATES = {
    "pitch": Say("pitch"), "wheel": Say("wheel angle"), "yaw": Say("yaw"), "pitch_rate": Say("pitch rate"),
    "wheel_rate": Say("wheel rate"), "yaw_rate": Say("yaw rate"),
}  # fmt: skip


def state_words(name: str) -> Say:
    """A state in words; one that is no robot's as it is."""
    return STATES.get(name, Say("{name}", name=name))


def draw_states(comparison: Compared, names: Sequence[str]) -> Figure:
    """One panel for each state, angles in degrees; the reference lies wide and pale below the others. Dotted lines hold
    the pitch of a run that has settled."""
    from upright.plotting import AXIS, legend, line, panels

    source = comparison.sources[comparison.reference]
    units = [comparison.logs[comparison.reference].unit(f"{source}/{name}") for name in names]
    labels = [f"{state_words(name)} [{unit.replace('rad', '°')}]" for name, unit in zip(names, units, strict=True)]
    figure, axes = panels(labels)
    several = len(comparison.logs) > 1
    for ax, name, unit in zip(axes, names, units, strict=True):
        factor = float(np.degrees(1.0)) if unit.startswith("rad") else 1.0
        for style, (label, log) in enumerate(comparison.logs.items()):
            below = several and label == comparison.reference
            line(ax, label, log.t, factor * comparison.state(label, name), style=style, below=below)
        if name == "pitch" and comparison.pushed:
            seconds, within = comparison.at_rest(comparison.reference)
            for side in (-1, 1) if np.isfinite(seconds) else ():
                ax.axhline(side * factor * within, linestyle=":", color=AXIS, label=str(Say("settled")))
        if dwarfing(comparison, name):
            low, high = _range(comparison, name)
            ax.set_ylim(factor * (2 * low - high), factor * (2 * high - low))
    _shade(comparison, axes)
    return legend(figure)


def dwarfing(comparison: Compared, name: str) -> list[str]:
    """The runs that would make a line of the reference's motion, and are cut."""
    low, high = _range(comparison, name)
    room = DWARFED * (high - low)
    states = {label: comparison.state(label, name) for label in comparison.logs}
    with np.errstate(invalid="ignore"):
        return [label for label, y in states.items() if room and ((y > high + room) | (y < low - room)).any()]


def _range(comparison: Compared, name: str) -> tuple[float, float]:
    y = comparison.state(comparison.reference, name)
    finite = y[np.isfinite(y)]
    return (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)


def draw_commands(comparison: Compared) -> Figure:
    """Both commands of the logs that have them, as they were applied where a log says so."""
    from upright.plotting import legend, line, panels

    unit = comparison.command_unit
    figure, axes = panels([f"{Say('left command')} [{unit}]", f"{Say('right command')} [{unit}]"])
    for style, (label, log) in enumerate(comparison.logs.items()):
        prefix = commanded(log)
        for ax, side in zip(axes, ("left", "right"), strict=True):
            if prefix:
                line(ax, label, log.t, log[f"{prefix}/{side}"], step=True, style=style)
    _shade(comparison, axes)
    return legend(figure)


def draw_asked(comparison: Compared) -> Figure:
    """What the controller asked of the left motor of the first log, and what the motor got."""
    from upright.plotting import legend, line, panels

    log = comparison.logs[comparison.reference]
    figure, axes = panels([f"{Say('left command')} [{comparison.command_unit}]"])
    line(axes[0], str(Say("asked")), log.t, log["command/left"], step=True)
    line(axes[0], str(Say("applied")), log.t, log["applied/left"], step=True, solid=True)
    _shade(comparison, axes)
    return legend(figure)


def _shade(comparison: Compared, axes: Sequence[Axes]) -> None:
    from upright.plotting import SPAN, span

    end = max(float(log.t[-1]) for log in comparison.logs.values())
    for start, stop in comparison.pushed:
        span(axes, start, min(stop, end), str(Say("push acts")))
        for ax in axes:
            ax.axvline(start, color=SPAN, zorder=0)  # a knock is too short for a span
