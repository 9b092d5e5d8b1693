"""What a page says of a single run: which way it leans and rolls, when it comes to rest, and that nothing pushed it."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.comparison import Comparison
from upright.experiment import motionless, outcome_of, undisturbed
from upright.experiment.outcome import PUSHED
from upright.plotting import AXIS, line, panels
from upright.reports.figure import Figure
from upright.reports.made import again
from upright.reports.metrics import degrees, words
from upright.reports.page import cell_text, distance_text
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
    label = comparison.reference
    log = comparison.logs[comparison.reference]
    if way(log) != "backward " or len(comparison.pushed) != 1 or comparison.metrics[label].fell:
        return ""
    start, stop = comparison.pushed[0]
    leans = comparison.metrics[label].pitch_peak > 0 and stop - start >= LASTING
    return " Pushed backward it leans forward, into the push: pitch is positive." if leans else ""


def travel(comparison: Comparison, label: str) -> tuple[str, str]:
    """How far the robot rolls, where the radius of its wheels is known, and how far its wheels turn."""
    turn = comparison.metrics[label].wheel_travel
    ahead = _rolls(comparison, label)
    radius = comparison.logs[label].origin.get("robot", {}).get("wheel_radius")
    if not radius or not math.isfinite(turn):
        return degrees(turn), f"largest turn of the wheels{ahead}"
    if not turn:
        return "0 cm", "rolled: the wheels never turned"
    return distance_text(radius * turn), f"furthest that it rolls{ahead}: {degrees(turn)} of the wheels"


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
            level = side * math.degrees(limit)
            start = comparison.releases[label]
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
    if untouched(comparison) and not np.ptp(log[source]):
        return f"{sentence(words(name), '')} stays at 0°{log.unit(source).removeprefix('rad')}"
    finite = log[source][np.isfinite(log[source])]
    furthest = float(finite[np.abs(finite).argmax()]) if len(finite) else 0.0
    size = f"{'−' if furthest < 0 else ''}{degrees(furthest)}"
    per = log.unit(source).removeprefix("rad")
    return f"{sentence(words(name), '')} reaches {size}{per}"


def untouched(comparison: Comparison) -> bool:
    """Whether this is one run in which nothing disturbed the robot, and it stood."""
    logs = list(comparison.logs.values())
    return len(logs) == 1 and undisturbed(logs[0]) and not outcome_of(logs[0]).fell


def untouched_title(comparison: Comparison) -> str:
    """That nothing pushed it, and how far it swayed."""
    ((label, log),) = comparison.logs.items()
    name = log.origin.get("robot", {}).get("name", "") or "the robot"
    peak = comparison.metrics[label].pitch_peak
    did = "stood still for" if motionless(log) else f"swayed by at most {cell_text(math.degrees(abs(peak)), 2)}° in"
    return f"Nothing pushed {name}: it {did} {outcome_of(log).seconds:.4g} s"


def untouched_lead(comparison: Comparison) -> str:
    """Why the run tests nothing, and the same run with a push."""
    ((label, log),) = comparison.logs.items()
    kind = log.origin.get("controller", {}).get("kind", "")
    what = comparison.kinds[label]
    why = motionless(log) or "What its sensors misread is all that moves it."
    began = f"A run of the {what}{f' under {kind}' if kind else ''}, begun exactly upright: it tests nothing."
    command = f"{again('upright simulate', '--push')} {PUSHED}"
    return f"{began} {why} Next: `{command}` leans it with a push for a second, then lets go."


def resting_figure(log: Log) -> Figure | None:
    """The gyro's noise, and the commands that it makes but the motors do not follow; None without a gyro."""
    if "sensor/gyro" not in log or not motionless(log) or not np.ptp(log["sensor/gyro"]):
        return None
    unit = log.unit("command/left")
    figure, axes = panels(["gyro [°/s]", f"requested command, left [{unit}]", f"applied command, left [{unit}]"])
    drawn: list[tuple[str, Array]] = [
        ("gyro", np.degrees(log["sensor/gyro"])), ("requested", log["command/left"]), ("applied", log["applied/left"]),
    ]  # fmt: skip
    for ax, (name, values) in zip(axes, drawn, strict=True):
        line(ax, name, log.t, values, step=True, style=0, solid=True)
    most = 1.2 * float(np.abs(log["command/left"]).max())
    for ax in axes[1:]:
        ax.set_ylim(-most, most)
    return Figure("Noise alone reaches the controller, and no command reaches the motors", figure)
