"""The page of a `Comparison`: its tables and one figure for each signal."""

from __future__ import annotations

import math

import numpy as np

from upright.comparison import Comparison, active_intervals
from upright.comparison.comparison import METRICS
from upright.report.figure import Figure, Panel, Trace
from upright.report.page import Cell, Page, Section, Table, cell_text
from upright.signals import STATE, Log

DWARFED = 5.0
"""A trace that leaves the reference's range by more than this many times its width is cut at the frame."""


def page_of(comparison: Comparison) -> Page:
    """The comparison's page, not yet written."""
    labels = ", ".join(comparison.logs)
    sections = [
        Section("Numbers", [_how(comparison), metrics_table(comparison), *fit_tables(comparison)]),
        Section("States", [state_figure(comparison, name) for name in comparison.signals]),
    ]
    commands = _command_figure(comparison)
    sections += [Section("Commands", [commands])] if commands else []
    sections.append(Section("Origin of the runs", [_origin_table(comparison)]))
    return Page("Runs compared", sections, f"The same experiment in {labels}.", _provenance(comparison))


def _how(comparison: Comparison) -> str:
    times = {label: f"{time:.4g} s" if math.isfinite(time) else "never" for label, time in comparison.releases.items()}
    same = len(set(times.values())) == 1
    release = next(iter(times.values())) if same else ", ".join(f"{label} {text}" for label, text in times.items())
    return (
        f"Settling and overshoot are those of pitch about zero after the release of the push at {release}. "
        "Settling: the time until pitch stays within 2 % (5 %) of its largest deviation. Overshoot: the largest swing "
        "to the other side over the largest to the first. Effort: the integral of both squared commands. Saturated: "
        "the fraction of samples with a command above the largest applied one. Fell: the recorded outcome of the run."
    )


def metrics_table(comparison: Comparison) -> Table:
    """What each run shows, one column a run."""
    rows: list[list[Cell]] = [
        [text, comparison.unit(name), *(getattr(numbers, name) for numbers in comparison.metrics.values())]
        for name, (_, text) in METRICS.items()
    ]
    return Table(["", "unit", *comparison.logs], rows, "What each run shows")


def fit_tables(comparison: Comparison) -> list[Table]:
    """The fit of each run to the reference, one row a run; none where there is one run."""
    if not comparison.fits:
        return []
    rows: list[list[Cell]] = [[label, *fits.values()] for label, fits in comparison.fits.items()]
    caption = f"Fit to {comparison.reference} [%]: 100 is perfect, 0 no better than its mean (NRMSE)"
    return [Table(["", *(name.replace("_", " ") for name in comparison.signals)], rows, caption, digits=3)]


def state_figure(comparison: Comparison, name: str) -> Figure:
    """One state of all runs over time, under a title that says how they differ."""
    signal = next((signal for signal in STATE if signal.name == name), None)
    channels = {label: f"{comparison.sources[label]}/{name}" for label in comparison.logs}
    traces = [Trace(label, log.t, log[channels[label]]) for label, log in comparison.logs.items()]
    reference = comparison.logs[comparison.reference]
    text = name.replace("_", " ") + (f" {signal.symbol}" if signal else "")
    unit = reference.unit(channels[comparison.reference])
    limits, note = _limits(traces, reference[channels[comparison.reference]])
    panel = Panel(text, unit, traces, limits)
    return Figure(_claim(comparison, name), [panel], spans=_spans(comparison), note=note)


def _claim(comparison: Comparison, name: str) -> str:
    if name == "pitch":
        times = {label: numbers.settling_2 for label, numbers in comparison.metrics.items()}
        settled = (f"{label} {'never' if math.isnan(s) else f'in {s:.3g} s'}" for label, s in times.items())
        return "Pitch settles to 2 %: " + ", ".join(settled)
    words = name.replace("_", " ").capitalize()
    fits = (f"{label} {_percent(fits[name])}" for label, fits in comparison.fits.items())
    return f"{words}, fit to {comparison.reference}: " + ", ".join(fits) if comparison.fits else f"{words} of the run"


def _percent(fit: float) -> str:
    if math.isnan(fit):
        return "not defined"
    return f"{cell_text(fit, 3)} %" if fit > 0 else "worse than its mean"


def _limits(traces: list[Trace], reference: np.ndarray) -> tuple[tuple[float, float] | None, str]:
    finite = reference[np.isfinite(reference)]
    low, high = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 0.0)
    room = DWARFED * (high - low)
    with np.errstate(invalid="ignore"):
        cut = [t.name for t in traces if ((t.y > high + room) | (t.y < low - room)).any()]
    if not cut or high == low:
        return None, ""
    return (low - (high - low), high + (high - low)), f"Cut at the frame: {', '.join(cut)}."


def _spans(comparison: Comparison) -> tuple[tuple[float, float], ...]:
    pushed = (log for log in (comparison.logs[comparison.reference], *comparison.logs.values()) if "push/force" in log)
    log = next(pushed, None)
    return () if log is None else active_intervals(log.t, log["push/force"])


def _command_figure(comparison: Comparison) -> Figure | None:
    prefixes = {label: _command_prefix(log) for label, log in comparison.logs.items()}
    drawn = [(style, label, log) for style, (label, log) in enumerate(comparison.logs.items()) if prefixes[label]]
    if not drawn:
        return None
    panels = [
        Panel(
            f"{side} command",
            comparison.command_unit,
            [
                Trace(label, log.t, log[f"{prefixes[label]}/{side}"], step=True, style=style)
                for style, label, log in drawn
            ],
        )
        for side in ("left", "right")
    ]
    unit = comparison.unit("effort")
    efforts = (f"{label} {cell_text(m.effort, 3)} {unit}" for label, m in comparison.metrics.items())
    return Figure("Effort: " + ", ".join(efforts), panels, spans=_spans(comparison))


def _command_prefix(log: Log) -> str:
    return next((p for p in ("applied", "command") if f"{p}/left" in log and f"{p}/right" in log), "")


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
