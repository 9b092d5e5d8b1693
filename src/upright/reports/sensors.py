"""How well a calibrated robot predicts each sensor: tables and a figure for the page of a `Calibration`."""

from __future__ import annotations

import math

from upright.calibration.calibration import Calibration
from upright.plotting import legend, line, number, panels
from upright.reports.figure import Figure
from upright.reports.page import Cell, Item, Table, cell_text
from upright.tables import short

WORDS = (
    "R²: the log is simulated half a second at a time. Each simulation starts from a state fitted to that half second.",
    "Fit: the part of the log held out is predicted some samples ahead. Each prediction starts from what the filter "
    "knew of the past, which is less sure. An error of the start{grows}. So a fit can fall over many samples "
    "where R² stays near 1.",
)


def in_words(c: Calibration) -> list[Item]:
    pole = c["unstable_pole"].value
    grows = f" doubles every {number(1e3 * math.log(2) / pole, 2)} ms" if pole > 0 else " grows"
    return [text.replace("{grows}", grows) for text in WORDS]


def tables(c: Calibration) -> list[Item]:
    free: list[list[Cell]] = [[short(name), value] for name, value in c.segments.items() if name != "lost"]
    items: list[Item] = [Table(["sensor", "R² of half seconds"], free)]
    if lost := c.segments.get("lost", 0.0):
        items.append(f"In {cell_text(100 * lost, 2)} % of these readings the simulated robot had fallen.")
    if not c.fits:
        return items
    names = list(next(iter(c.fits.values())))
    rows: list[list[Cell]] = [
        [_ahead(str(h)), *("worse than the mean" if fit < 0 else fit for fit in fits.values())]
        for h, fits in c.fits.items()
    ]
    items.append(Table(["ahead", *map(short, names)], rows, "Fit [%]", digits=3))
    figure, (ax,) = panels(["fit on the part held out [%]"], "samples ahead", "log")
    for name in names:
        line(ax, short(name), [float(h) for h in c.fits], [fits[name] for fits in c.fits.values()])
    for drawn in ax.lines:
        drawn.set(marker="o", markersize=4)
    ax.set_xticks([float(h) for h in c.fits], list(map(str, c.fits)))
    ax.minorticks_off()
    ax.set_ylim(0, 100)
    items.append(Figure(f"Fit of each sensor, {_ahead(str(list(c.fits)[-1]))} ahead and less", legend(figure)))
    return items


def _ahead(samples: str) -> str:
    return f"{samples} sample{'' if samples == '1' else 's'}"
