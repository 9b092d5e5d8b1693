"""Runs beside each other on the page of the reproduction: a figure of one state, their metrics and their fits."""

from __future__ import annotations

import math

from upright.comparison import Comparison
from upright.comparison.drawing import dwarfing, state_words
from upright.comparison.runs import DIVERGED, METRICS
from upright.reports.figure import Figure
from upright.reports.page import Cell, Table, cell_text

SHOWN = {"1": (100.0, "%"), "rad": (180 / math.pi, "°")}
"""Unit of a metric → its factor and unit on a page."""


def state_figure(comparison: Comparison, name: str) -> Figure:
    """One state of all runs over time, and how far each is from the reference."""
    source = comparison.sources[comparison.reference]
    per = comparison.logs[comparison.reference].unit(f"{source}/{name}").removeprefix("rad")
    apart = [f"{n} {cell_text(math.degrees(comparison.apart(n, name)), 2)}°{per}" for n in comparison.fits]
    title = f"Largest difference in {state_words(name)} from {comparison.reference}: {', '.join(apart)}"
    cut = dwarfing(comparison, name)
    return Figure(title, comparison.plot(name), f"Cut at the frame: {', '.join(cut)}." if cut else "")


def metrics_table(comparison: Comparison) -> Table:
    """The metrics, one column a run; angles in degrees."""
    rows: list[list[Cell]] = []
    for name, (_, text) in METRICS.items():
        factor, unit = SHOWN.get(comparison.unit(name), (1.0, comparison.unit(name)))
        values = [getattr(numbers, name) for numbers in comparison.metrics.values()]
        rows.append([str(text), unit, *(factor * value if isinstance(value, float) else value for value in values)])
    return Table(["", "unit", *comparison.logs], rows, "Metrics of each run", digits=3)


def fit_table(comparison: Comparison) -> Table:
    """The fit of each run to the reference, one row a run."""
    fitted = [name for name in comparison.signals if any(math.isfinite(f[name]) for f in comparison.fits.values())]
    rows: list[list[Cell]] = [
        [label, *("diverges" if fit[name] < DIVERGED else fit[name] for name in fitted)]
        for label, fit in comparison.fits.items()
    ]
    caption = f"Fit to {comparison.reference} [%]: 100 is perfect; 0 is that of a constant, its mean"
    return Table(["", *(str(state_words(name)) for name in fitted)], rows, caption, digits=3)
