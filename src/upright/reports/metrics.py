"""Numbers of the runs on a comparison's page: metrics, fits, when a run has settled, and what part of it to draw."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from upright.comparison import Comparison
from upright.comparison.comparison import DIVERGED, METRICS, NEGLIGIBLE
from upright.comparison.resting import STEADY, near
from upright.experiment.outcome import last_part
from upright.fleets.ensemble import SETTLED
from upright.reports.page import Cell, Table, cell_text

BESIDE = 1.0  # [s] shown before a push and after it has settled
SMALL = 0.6  # [1] of a run: less is shown alone
QUIET = 0.1  # [1] of a state's range over a run: who moves less is near rest
SPOKEN_NAMES = {"saturated": "motors at their limit", "wheel_travel": "largest turn of the wheels",
                "overshoot": "overshoot, the swing back past upright"}  # fmt: skip
"""Metrics that a page calls otherwise than a terminal does."""
BANDS = {"settling 2 %": 0.02, "settling 5 %": 0.05}
"""Settling times that noise may decide → their band, relative to the largest deviation."""
PERCENT = {"1": (100.0, "%"), "rad": (180 / math.pi, "°")}
"""Unit of a metric → its factor and unit on a page."""


def metrics_table(comparison: Comparison) -> Table:
    """The metrics, one column a run; angles in degrees."""
    rows: list[list[Cell]] = []
    for name, (_, text) in METRICS.items():
        factor, unit = PERCENT.get(comparison.unit(name), (0.0, comparison.unit(name)))
        values = [getattr(numbers, name) for numbers in comparison.metrics.values()]
        rows.append([SPOKEN_NAMES.get(name, text), unit, *(factor * value if factor else value for value in values)])
    if comparison.pushed:
        calm = [comparison.at_rest(label) for label in comparison.logs]
        within = f"settling after the release, to ±{degrees(max(limit for _, limit in calm))}"
        rows.insert(0, [within, "s", *(seconds for seconds, _ in calm)])
    several = "Metrics of each run" if len(comparison.logs) > 1 else "Metrics of the run"
    heads = list(comparison.logs) if len(comparison.logs) > 1 else ["value"]
    return Table(["", "unit", *heads], rows, several, digits=3)


def listed_metrics(comparison: Comparison) -> Table:
    """The metrics without settling times that noise decides, and without an overshoot where no run has one."""
    table = metrics_table(comparison)
    rows: list[Sequence[Cell]] = []
    for row in table.rows:
        band = BANDS.get(str(row[0]))
        lost = [band is not None and _noisy(comparison, label, band) for label in comparison.logs]
        cells = ["noise" if gone else cell for gone, cell in zip(lost, row[2:], strict=True)]
        if not all(lost) and not (
            row[0] in (SPOKEN_NAMES["overshoot"], METRICS["doubling"][1])
            and all(isinstance(cell, float) and math.isnan(cell) for cell in cells)
        ):
            rows.append([*row[:2], *cells])
    return replace(table, rows=rows)


def _noisy(comparison: Comparison, label: str, band: float) -> bool:
    """Whether pitch at rest swings beyond this part of its largest deviation after the release."""
    run = comparison.released(label)
    if math.isnan(near(run)):
        return False
    return float(run.size[last_part(len(run.size)) :].max()) > band * float(run.size.max())


def fit_tables(comparison: Comparison, fits: Mapping[str, Mapping[str, float]] | None = None) -> list[Table]:
    """The fit of each run to the reference, one row a run; none where there is one run. `fits`: others than the
    comparison's own, those while a push is answered."""
    if not comparison.fits:
        return []
    shown = fits or comparison.fits
    fitted = [name for name in comparison.signals if any(math.isfinite(f[name]) for f in shown.values())]
    rows: list[list[Cell]] = [
        [label, *("diverges" if of[name] < DIVERGED else of[name] for name in fitted)] for label, of in shown.items()
    ]
    when = "from the push until both are calm" if fits else "sample by sample"
    caption = f"Fit to {comparison.reference} [%], {when}: 100 is perfect; 0 is that of a constant, its mean"
    return [Table(["", *map(words, fitted)], rows, caption, digits=3)]


def how(comparison: Comparison) -> list[str]:
    """How the numbers of the table are meant, a sentence or two for each."""
    times = {label: f"{time:.4g} s" if math.isfinite(time) else "never" for label, time in comparison.releases.items()}
    same = len(set(times.values())) == 1
    release = next(iter(times.values())) if same else ", ".join(f"{label} {text}" for label, text in times.items())
    names = [str(row[0]) for row in listed_metrics(comparison).rows]
    given = bool(comparison.pushed) or comparison.release is not None
    listed = any(name in BANDS for name in names)
    swung = SPOKEN_NAMES["overshoot"] in names
    texts = [
        f"Settling{' and overshoot are those' if swung else ' is that'} of pitch about zero "
        f"{'after the release of the push' if given else 'from the first sample on,'} at {release}. "
        f"{_band(comparison)}".strip(),
        "Settling within 2 % (5 %): the time until pitch stays within that part of its largest deviation; “noise” "
        "where it swings further at rest, so that chance would decide." if listed else "",
        "Overshoot: the largest deviation on the far side over the largest on the side of the start." if swung else
        "No overshoot: a knock is over before the robot leans, so there is no side to swing back from.",
        "Effort: the integral of both squared commands.",
        "Motors at their limit: the part of the samples with a command that they cannot follow, or at "
        "the program's own limit.",
        "Under a lasting force backward a robot leans forward, into it.",
    ]  # fmt: skip
    return [text for text in texts if text]


def _band(comparison: Comparison) -> str:
    """Why pitch has settled within the angle of the table, as a sentence with a space behind it."""
    limits = [comparison.at_rest(label)[1] for label in comparison.logs] if comparison.pushed else []
    if not limits:
        return ""
    named = f"Within ±{degrees(max(limits))} it counts as settled: "
    if max(limits) == SETTLED:
        return f"{named}that is {cell_text(SETTLED)} rad. Pitch is positive forward. "
    return f"{named}5 % of its largest deviation, or what it swings at rest if that is more. "


def around(comparison: Comparison) -> tuple[float, float] | None:
    """The time [s] round the pushes until every run is calm, where that is a small part of the runs."""
    calm = {label: comparison.at_rest(label)[0] for label in comparison.logs} if comparison.pushed else {}
    if not calm or "pitch" not in comparison.signals or not all(map(math.isfinite, calm.values())):
        return None
    settled = max(comparison.releases[label] + seconds for label, seconds in calm.items())
    log = comparison.logs[comparison.reference]
    start = float(log.t[0])
    end = float(log.t[-1])
    low = max(start, comparison.pushed[0][0] - BESIDE)
    high = min(end, settled + BESIDE)
    short = high - low < SMALL * (end - start)
    return (low, high) if short and all(_calm(comparison, label, low, high) for label in calm) else None


def _calm(comparison: Comparison, label: str, low: float, high: float) -> bool:
    """Whether a run moves little before `low` and after `high` [s] in all its states: each stays within `QUIET` of its
    range of where it begins or ends; a rate, which noise drives, may swing after `high` as it does at its very end."""
    log = comparison.logs[label]
    first = log.t < low
    after = log.t > high
    last = log.t > log.t[-1] - (log.t[-1] - high) / 3
    for name in comparison.signals:
        y = log[f"{comparison.sources[label]}/{name}"]
        slight = max(QUIET * float(np.ptp(y)), NEGLIGIBLE.get(name, 0.0))
        noisy = name.endswith("rate") and last.any()
        steady = max(slight, STEADY * float(np.ptp(y[last]))) if noisy else slight
        if any(part.any() and float(np.ptp(y[part])) > room for part, room in ((first, slight), (after, steady))):
            return False
    return True


def left_out(comparison: Comparison, low: float, high: float) -> str:
    """What a figure of a part of the runs leaves out."""
    log = comparison.logs[comparison.reference]
    ends = (("before", low > log.t[0]), ("after", high < log.t[-1]))
    beyond = " and ".join(word for word, left in ends if left)
    return f"Shown from {cell_text(low, 2)} to {cell_text(high, 2)} s; {beyond} the robot is near rest."


def degrees(angle: float) -> str:
    """An angle [rad] without its sign, in degrees, with as many digits as the table has."""
    return f"{cell_text(math.degrees(abs(angle)), 3)}°"


def words(name: str) -> str:
    """The name of a state, for readers."""
    return {"wheel": "wheel angle"}.get(name, name.replace("_", " "))


def percent(fit: float) -> str:
    """A fit [%] as text."""
    if math.isnan(fit):
        return "none (no motion)"
    return f"{cell_text(fit, 3)} %" if fit > 0 else "below 0 %"
