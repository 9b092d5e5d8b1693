"""The page of a `Comparison`: its tables and one figure for each signal."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.comparison import Comparison
from upright.comparison.comparison import METRICS, NEGLIGIBLE
from upright.plotting import AXIS
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence

if TYPE_CHECKING:
    from matplotlib.axes import Axes

BESIDE = 1.0  # [s] shown before a push and after it has settled
SMALL = 0.6  # [1] of a run: less is shown alone
DWARFED = 5.0
"""A trace that leaves the reference's range by more than this many times its width is cut at the frame."""


def page_of(comparison: Comparison) -> Page:
    """The comparison's page, not yet written."""
    first = "pitch" if "pitch" in comparison.signals else comparison.signals[0]
    still = [name for name in comparison.signals if _is_still(comparison, name)]
    figures = [state_figure(comparison, name) for name in comparison.signals if name not in (first, *still)]
    quiet = [sentence(f"no motion of {' or '.join(name.replace('_', ' ') for name in still)}")] if still else []
    sections = [
        Section("Numbers", [metrics_table(comparison), *fit_tables(comparison), _how(comparison)]),
        Section("Other states", [*figures, *quiet]),
    ]
    commands = comparison.plot_commands()
    sections += [Section("Commands", [Figure(_efforts(comparison), commands)])] if commands else []
    sections.append(Section("Origin of the runs", [_origin_table(comparison)], folded=True))
    return Page(
        _title(comparison, first), sections, _lead(comparison), _provenance(comparison),
        verdict=_verdict(comparison), picture=state_figure(comparison, first), numbers=_numbers(comparison),
    )  # fmt: skip


def _title(comparison: Comparison, first: str) -> str:
    """Who fell, or how well the runs agree; of one run what it did."""
    labels = list(comparison.logs)
    fell = [label for label, m in comparison.metrics.items() if m.fell]
    if len(labels) == 1:
        (m,) = comparison.metrics.values()
        done = "The robot fell" if m.fell else "The robot stands"
        return f"{done}; pitch reaches {abs(m.pitch_peak):.2g} rad ({math.degrees(abs(m.pitch_peak)):.2g}°)"
    if fell and len(fell) < len(labels):
        return f"{', '.join(fell)} fell; {', '.join(label for label in labels if label not in fell)} did not"
    fits = {label: f[first] for label, f in comparison.fits.items() if math.isfinite(f.get(first, math.nan))}
    if not fits:
        return f"{', '.join(labels)} compared"
    worst = min(fits, key=lambda label: fits[label])
    if len(fits) == 1:
        return f"{sentence(worst, '')} follows {comparison.reference}: fit {_percent(fits[worst])}"
    return f"{len(fits)} runs follow {comparison.reference}; the worst, {worst}, fits {_percent(fits[worst])}"


def _lead(comparison: Comparison) -> str:
    """What was run: robot, controller, push."""
    log = comparison.logs[comparison.reference]
    robot, kind = log.origin.get("robot", {}).get("name", ""), log.origin.get("controller", {}).get("kind", "")
    who = f"{robot} under {kind}" if robot and kind else robot or "One experiment"
    pushes = [f"from {start:.3g} to {stop:.3g} s" for start, stop in comparison.pushed]
    pushed = f", pushed {' and '.join(pushes[:2])}" if pushes else ", without a push"
    several = f", in {', '.join(comparison.logs)}" if comparison.fits else ""
    return f"{who}{pushed}{several}."


def _verdict(comparison: Comparison) -> Verdict | None:
    """How many robots stood, where every log says so."""
    fell = [m.fell for m in comparison.metrics.values()]
    if any(f is None for f in fell):
        return None
    stood = fell.count(False)
    text = ("stood" if stood else "fell") if len(fell) == 1 else f"{stood} of {len(fell)} stood"
    return Verdict(text, "good" if stood == len(fell) else "warn")


def _is_still(comparison: Comparison, name: str) -> bool:
    """Whether no run moves in this state by more than what counts as noise."""
    states = [log[f"{comparison.sources[label]}/{name}"] for label, log in comparison.logs.items()]
    return name in NEGLIGIBLE and all(np.nanmax(y) - np.nanmin(y) <= NEGLIGIBLE[name] for y in states)


def _numbers(comparison: Comparison) -> list[tuple[str, str]]:
    """Of one run pitch and travel, of the first three runs the largest pitch; a fall says so."""
    if len(comparison.logs) == 1:
        (m,) = comparison.metrics.values()
        return [
            (f"{abs(m.pitch_peak):.3g} rad", f"largest pitch: {math.degrees(abs(m.pitch_peak)):.2g}°"),
            (_settles(m.settling_5), "after the release, until pitch stays within 5 % of its largest value"),
            (f"{m.wheel_travel:.3g} rad", "largest turn of the wheels"),
        ]
    fits = [
        (_percent(fit["pitch"]), f"fit of {label} to {comparison.reference}: pitch")
        for label, fit in list(comparison.fits.items())[:1]
        if math.isfinite(fit.get("pitch", math.nan))
    ]
    return fits + [
        (f"{math.degrees(abs(m.pitch_peak)):.3g}°", f"{label}: largest pitch") if not m.fell else ("fell", label)
        for label, m in list(comparison.metrics.items())[: 3 - len(fits)]
    ]  # fmt: skip


def _settles(seconds: float) -> str:
    return "never" if math.isnan(seconds) else f"{seconds:.3g} s"


def _how(comparison: Comparison) -> str:
    times = {label: f"{time:.4g} s" if math.isfinite(time) else "never" for label, time in comparison.releases.items()}
    same = len(set(times.values())) == 1
    release = next(iter(times.values())) if same else ", ".join(f"{label} {text}" for label, text in times.items())
    return (
        f"Settling and overshoot are those of pitch about zero after the release of the push at {release}. "
        "Settling: the time until pitch stays within 2 % (5 %) of its largest deviation. Overshoot: the largest "
        "deviation on the far side over the largest on the side of the start. Effort: the integral of both squared "
        "commands. Saturated: the fraction of samples with a command above the largest applied one. Fell: the recorded "
        "outcome of the run."
    )


def metrics_table(comparison: Comparison) -> Table:
    """The metrics, one column a run."""
    rows: list[list[Cell]] = [
        [text, comparison.unit(name), *(getattr(numbers, name) for numbers in comparison.metrics.values())]
        for name, (_, text) in METRICS.items()
    ]
    return Table(["", "unit", *comparison.logs], rows, "Metrics of each run")


def fit_tables(comparison: Comparison) -> list[Table]:
    """The fit of each run to the reference, one row a run; none where there is one run."""
    if not comparison.fits:
        return []
    rows: list[list[Cell]] = [[label, *fits.values()] for label, fits in comparison.fits.items()]
    caption = f"NRMSE fit to {comparison.reference} [%]: 100 is perfect; 0 is that of a constant, its mean"
    return [Table(["", *(name.replace("_", " ") for name in comparison.signals)], rows, caption, digits=3)]


def state_figure(comparison: Comparison, name: str) -> Figure:
    """One state of all runs over time, under a title that says how they differ."""
    figure = comparison.plot(name)
    if name == "pitch" and comparison.pushed and len(comparison.logs) == 1:
        _band(comparison, figure.axes[0])
    limits, note = _limits(comparison, name)
    if limits:
        figure.axes[0].set_ylim(*limits)
    around = _around(comparison)
    if around:
        figure.axes[0].set_xlim(*around)
        note = f"{note} Shown round the push; before and after the robot is near rest.".strip()
    return Figure(_claim(comparison, name), figure, note)


def _band(comparison: Comparison, ax: Axes) -> None:
    """The 5 % about zero in which pitch has to stay after the release."""
    ((label, log),) = comparison.logs.items()
    released = log.between(comparison.releases[label], math.inf)
    limit = 0.05 * float(np.abs(released[f"{comparison.sources[label]}/pitch"]).max())
    for side in (-limit, limit):
        ax.hlines(side, released.t[0], released.t[-1], linestyle=":", linewidth=1, color=AXIS)


def _around(comparison: Comparison) -> tuple[float, float] | None:
    """The time [s] round the pushes until every run has settled, where that is a small part of the runs."""
    if not comparison.pushed or any(m.fell or math.isnan(m.settling_5) for m in comparison.metrics.values()):
        return None
    settled = max(comparison.releases[label] + m.settling_5 for label, m in comparison.metrics.items())
    log = comparison.logs[comparison.reference]
    start, end = float(log.t[0]), float(log.t[-1])
    low, high = max(start, comparison.pushed[0][0] - BESIDE), min(end, settled + BESIDE)
    return (low, high) if high - low < SMALL * (end - start) else None


def _claim(comparison: Comparison, name: str) -> str:
    if name == "pitch":
        if not comparison.pushed:
            peaks = (f"{label} {abs(m.pitch_peak):.3g} rad" for label, m in comparison.metrics.items())
            return "Largest pitch: " + ", ".join(peaks)
        times = {label: numbers.settling_5 for label, numbers in comparison.metrics.items()}
        if len(times) == 1:
            (seconds,) = times.values()
            when = f"{_settles(seconds)} after the release" if math.isfinite(seconds) else "not within the run"
            return f"Pitch settles to 5 % of its largest value (dotted) {when}"
        settled = (f"{label} {_settles(s)}" for label, s in times.items())
        return "Pitch settles to 5 % of its largest value in: " + ", ".join(settled)
    words = name.replace("_", " ").capitalize()
    fits = (f"{label} {_percent(fits[name])}" for label, fits in comparison.fits.items())
    return f"{words}, fit to {comparison.reference}: " + ", ".join(fits) if comparison.fits else f"{words} of the run"


def _percent(fit: float) -> str:
    if math.isnan(fit):
        return "none (no motion)"
    return f"{cell_text(fit, 3)} %" if fit > 0 else "below 0 %"


def _limits(comparison: Comparison, name: str) -> tuple[tuple[float, float] | None, str]:
    """The range to draw where a run dwarfs the reference, and which runs are cut."""
    states = {label: log[f"{comparison.sources[label]}/{name}"] for label, log in comparison.logs.items()}
    reference = states[comparison.reference]
    finite = reference[np.isfinite(reference)]
    low, high = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)
    room = DWARFED * (high - low)
    with np.errstate(invalid="ignore"):
        cut = [label for label, y in states.items() if ((y > high + room) | (y < low - room)).any()]
    if not cut or high == low:
        return None, ""
    return (low - (high - low), high + (high - low)), f"Cut at the frame: {', '.join(cut)}."


def _efforts(comparison: Comparison) -> str:
    unit = comparison.unit("effort")
    return "Effort: " + ", ".join(f"{label} {cell_text(m.effort, 3)} {unit}" for label, m in comparison.metrics.items())


def _origin_table(comparison: Comparison) -> Table:
    rows: list[list[Cell]] = [
        [label, comparison.kinds[label] or "–", comparison.sources[label], len(log), float(log.t[-1] - log.t[0])]
        for label, log in comparison.logs.items()
    ]
    return Table(["run", "body", "states from", "samples", "length [s]"], rows, "Runs")


def _provenance(comparison: Comparison) -> dict[str, str]:
    facts: dict[str, str] = {}
    for label, log in comparison.logs.items():
        seed = log.origin.get("scenario", {}).get("seed")
        mark = log.origin.get("controller", {}).get("hash")
        versions = log.origin.get("versions", {})
        known = {
            "seed": "" if seed is None else str(seed),
            "controller": str(mark)[:12] if mark else "",
            "versions": ", ".join(f"{name} {number}" for name, number in sorted(versions.items())),
        }
        facts |= {f"{label}: {key}": text for key, text in known.items() if text}
    return facts
