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
    from upright.plotting import panels

    _, axes = panels([_named(comparison, name) for name in names])
    for ax, name in zip(axes, names, strict=True):
        _draw_state(comparison, ax, name)
    return _finished(comparison, axes)


def _draw_state(comparison: Compared, ax: Axes, name: str) -> None:
    from upright.plotting import AXIS, line

    factor = _factor(comparison, name)
    several = len(comparison.logs) > 1
    for style, (label, log) in enumerate(comparison.logs.items()):
        below = several and label == comparison.reference
        line(ax, label, log.t, factor * comparison.state(label, name), style=style, below=below)
    if name == "pitch" and comparison.pushed:
        seconds, within = comparison.at_rest(comparison.reference)
        for side in (-1, 1) if np.isfinite(seconds) else ():
            ax.axhline(side * factor * within, linestyle=":", color=AXIS, label=str(Say("settled")))
        if np.isfinite(seconds) and not several:
            _mark_rest(comparison, ax, comparison.releases[comparison.reference] + seconds)
    if dwarfing(comparison, name):
        low, high = _range(comparison, name)
        ax.set_ylim(factor * (2 * low - high), factor * (2 * high - low))


def _mark_rest(comparison: Compared, ax: Axes, when: float) -> None:
    """A dot where the pitch of a single run has come to rest."""
    from upright.plotting import INK

    t = comparison.logs[comparison.reference].t
    pitch = np.interp(when, t, _factor(comparison, "pitch") * comparison.state(comparison.reference, "pitch"))
    ax.plot([when], [pitch], "o", color=INK, markersize=5, label="_rest")
    ax.annotate(str(Say("at rest")), (when, float(pitch)), (6, 4), textcoords="offset points")


def _finished(comparison: Compared, axes: Sequence[Axes]) -> Figure:
    """The figure of these panels, with the pushes shaded."""
    from upright.plotting import legend, shade

    logs = comparison.logs.values()
    shown = min(float(log.t[0]) for log in logs), max(float(log.t[-1]) for log in logs)
    shade(axes, str(Say("push acts")), comparison.pushed, shown)
    figure = axes[0].get_figure(root=True)
    assert figure
    return legend(figure)


def unit_of(comparison: Compared, name: str) -> str:
    """The unit of a state."""
    source = comparison.sources[comparison.reference]
    return comparison.logs[comparison.reference].unit(f"{source}/{name}")


def _factor(comparison: Compared, name: str) -> float:
    """What a state is multiplied by to be read: degrees for radians."""
    return float(np.degrees(1.0)) if unit_of(comparison, name).startswith("rad") else 1.0


def _named(comparison: Compared, name: str) -> str:
    return f"{state_words(name)} [{unit_of(comparison, name).replace('rad', '°')}]"


def draw_apart(comparison: Compared, name: str) -> Figure:
    """A state of all runs, and below it how far each is from the reference, angles in degrees."""
    from upright.plotting import line, panels

    unit = unit_of(comparison, name).replace("rad", "°")
    apart = str(Say("difference from {one} [{unit}]", one=comparison.reference, unit=unit))
    _, axes = panels([_named(comparison, name), apart])
    _draw_state(comparison, axes[0], name)
    for style, label in enumerate(comparison.logs):
        if label != comparison.reference:
            t, one, other = comparison.both(label, name)
            alone = len(comparison.logs) == 2
            line(axes[1], label, t, _factor(comparison, name) * (other - one), style=style, solid=alone)
    return _finished(comparison, axes)


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
    from upright.plotting import line, panels

    unit = comparison.command_unit
    _, axes = panels([f"{Say('left command')} [{unit}]", f"{Say('right command')} [{unit}]"])
    for style, (label, log) in enumerate(comparison.logs.items()):
        prefix = commanded(log)
        for ax, side in zip(axes, ("left", "right"), strict=True):
            if prefix:
                line(ax, label, log.t, log[f"{prefix}/{side}"], step=True, style=style)
    return _finished(comparison, axes)


def draw_asked(comparison: Compared) -> Figure:
    """What the controller asked of the left motor of the first log, and what the motor got."""
    from upright.plotting import line, panels

    log = comparison.logs[comparison.reference]
    _, axes = panels([f"{Say('left command')} [{comparison.command_unit}]"])
    line(axes[0], str(Say("asked")), log.t, log["command/left"], step=True)
    line(axes[0], str(Say("applied")), log.t, log["applied/left"], step=True, solid=True)
    return _finished(comparison, axes)
