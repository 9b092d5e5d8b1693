"""What a page says of a single run: which way it leans and rolls, and when it comes to rest."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.comparison import Comparison
from upright.plotting import AXIS
from upright.report.metrics import degrees, words
from upright.report.page import cell_text
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from upright.signals import Log

LASTING = 0.5  # [s] of a push against which a robot leans


def way(log: Log) -> str:
    """The way of the pushes with a space behind it; nothing where they differ."""
    ways = set(np.sign(log["push/force"]).tolist()) - {0.0} if "push/force" in log else set[float]()
    return "" if len(ways) != 1 else "forward " if ways == {1.0} else "backward "


def leans_into(comparison: Comparison) -> str:
    """That a robot leans against a lasting push, which looks like a wrong sign; with a space before it."""
    ((label, log),) = comparison.logs.items()
    if way(log) != "backward " or len(comparison.pushed) != 1 or comparison.metrics[label].fell:
        return ""
    start, stop = comparison.pushed[0]
    leans = comparison.metrics[label].pitch_peak > 0 and stop - start >= LASTING
    return " Pushed backward it leans forward, into the push: pitch is positive." if leans else ""


def travel(comparison: Comparison, label: str) -> tuple[str, str]:
    """How far the robot rolls, where the radius of its wheels is known, and how far its wheels turn."""
    turn, ahead = comparison.metrics[label].wheel_travel, _rolls(comparison, label)
    radius = comparison.logs[label].origin.get("robot", {}).get("wheel_radius")
    if not radius or not math.isfinite(turn):
        return degrees(turn), f"largest turn of the wheels{ahead}"
    return f"{cell_text(100 * radius * turn, 2)} cm", f"furthest that it rolls{ahead}: {degrees(turn)} of the wheels"


def _rolls(comparison: Comparison, label: str) -> str:
    """Which way the wheels turn furthest from where they begin."""
    wheel = comparison.logs[label].channels.get(f"{comparison.sources[label]}/wheel")
    if wheel is None or not np.isfinite(wheel).all():
        return ""
    return ", forward" if wheel.max() - wheel[0] >= wheel[0] - wheel.min() else ", backward"


def settles(seconds: float, digits: int = 3) -> str:
    return "never" if math.isnan(seconds) else f"{cell_text(seconds, digits)} s"


def band(comparison: Comparison, ax: Axes) -> None:
    """Dotted: what counts as settled after the release; a dot where it is."""
    ((label, log),) = comparison.logs.items()
    calm, limit = comparison.at_rest(label)
    if math.isfinite(calm):
        for side in (-1, 1):
            level, start = side * math.degrees(limit), comparison.releases[label]
            ax.hlines(level, start, log.t[-1], linestyle=":", linewidth=1.2, color=AXIS)
        at = comparison.releases[label] + calm
        if at < log.t[-1]:
            pitch = math.degrees(float(np.interp(at, log.t, log[f"{comparison.sources[label]}/pitch"])))
            ax.plot([at], [pitch], "o", markersize=6, color=AXIS, label="_settled")
            ax.annotate(
                f"settled after {settles(calm, 2)}", (at, pitch), (at, 2.5 * math.degrees(limit)), va="bottom",
                arrowprops={"arrowstyle": "-", "color": AXIS},
            )  # fmt: skip


def alone(comparison: Comparison, name: str) -> str:
    """What one run shows of a state."""
    ((label, log),) = comparison.logs.items()
    if name == "pitch" and comparison.pushed and not comparison.metrics[label].fell:
        calm, limit = comparison.at_rest(label)
        if math.isnan(calm):
            return "Pitch does not come to rest within the run"
        return f"Pitch has settled, within the dotted ±{degrees(limit)}, {settles(calm, 2)} after the release"
    source = f"{comparison.sources[label]}/{name}"
    finite = log[source][np.isfinite(log[source])]
    furthest = float(finite[np.abs(finite).argmax()]) if len(finite) else 0.0
    size, per = f"{'−' if furthest < 0 else ''}{degrees(furthest)}", log.unit(source).removeprefix("rad")
    return f"{sentence(words(name), '')} reaches {size}{per}"
