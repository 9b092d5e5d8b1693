"""What a calibrated robot predicts of each reading: over the whole log, closer, and how well."""

from __future__ import annotations

import math

from upright.calibration.calibration import DRAWN, GOOD, PREDICTED, Calibration
from upright.plotting import legend, line, panels
from upright.reports.figure import Figure
from upright.tables import joined, least, short

COMPASS = "A compass is disturbed by iron nearby, so nothing is decided by it."


def over_time(c: Calibration) -> Figure | None:
    """Readings and predictions of the first log, under which of them lie on each other."""
    if not c.free:
        return None
    drawn = [name for name in c.channels if name in DRAWN] or c.channels
    rest = [f"{short(name)} (R² {least(c.segments[name])})" for name in c.channels if name not in drawn]
    note = "Every half second the model starts anew; then it gets the commands alone."
    note += f" {COMPASS}" if any("compass" in name for name in drawn) and len(drawn) > 1 else ""
    note += f" Not drawn: {joined(rest)}." if rest else ""
    return Figure(_claim(c, drawn), c.plot_prediction(), note)


def _claim(c: Calibration, drawn: list[str]) -> str:
    """Which readings are predicted; of those that are not how well."""
    kept = c.unfitted
    sizes = {name: min(c.segments[name], kept.get(name, math.inf)) for name in drawn}
    judged = {name: size for name, size in sizes.items() if name in PREDICTED} or sizes
    missed = [f"the {short(n)} (R² {least(kept.get(n, size))})" for n, size in judged.items() if size < GOOD]
    if not missed:
        return f"Predictions lie on the readings{', also where nothing was fitted' if c.held_out else ''}"
    good = [f"the {short(name)}" for name, size in judged.items() if size >= GOOD]
    if not good:
        return "Predictions miss part of the readings"
    both = ["both encoders"] if good == ["the encoder left", "the encoder right"] else good
    return f"Predictions lie on {joined(both)}; they miss part of {joined(missed)}"


CLOSER = 1.5  # [s] of the worst reading, drawn larger


def closer(c: Calibration) -> Figure | None:
    """The gyro, or the reading that is predicted worst, over a short while of the end of the log."""
    judged = {name: c.segments[name] for name in c.channels if name in PREDICTED}
    if not c.free or not judged:
        return None
    name = min(judged, key=lambda one: judged[one])
    name = "sensor/gyro" if judged[name] >= GOOD and "sensor/gyro" in judged else name
    t, measured, predicted = c.free[0].series(name)
    inside = t >= t.max(initial=0.0) - CLOSER
    figure, (ax,) = panels([f"{short(name)} [{PREDICTED[name]}]"])
    line(ax, "measured", t[inside], measured[inside], style=4, below=True)
    line(ax, "predicted", t[inside], predicted[inside], style=1, solid=True)
    title = f"The {short(name)} over the last {CLOSER:g} s of the log"
    return Figure(title, legend(figure), "Gaps: every half second the model starts anew.")
