"""Figures by matplotlib for notebooks: every axis is named by its quantity and unit."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure


def panels(labels: Sequence[str], x_label: str = "time [s]", x_scale: str = "linear") -> tuple[Figure, list[Axes]]:
    """An empty figure of panels above each other over one x; `labels` name their y, `x_scale` is "linear" or "log"."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 1 + 2 * len(labels)), layout="constrained")
    axes: list[Axes] = list(figure.subplots(len(labels), sharex=True, squeeze=False)[:, 0])
    for ax, label in zip(axes, labels, strict=True):
        ax.set(ylabel=label, xscale=x_scale)
        ax.grid(visible=True, which="both", alpha=0.3)
    axes[-1].set_xlabel(x_label)
    return figure, axes


def intervals(names: Sequence[str], values: ArrayLike, ends: ArrayLike, x_label: str, y_label: str) -> Figure:
    """`values` (n,) with their intervals `ends` (n, 2), one row for each name; an end that is NaN is not drawn."""
    from matplotlib.figure import Figure

    low, high = np.asarray(ends, dtype=np.float64).reshape(-1, 2).T
    rows = range(len(names))
    figure = Figure(figsize=(8, 1 + 0.3 * len(names)), layout="constrained")
    ax = figure.subplots()
    ax.hlines(rows, low, high, linewidth=2, label="95 % interval")
    ax.plot(np.asarray(values), rows, "o", label="estimate")
    ax.set(yticks=rows, yticklabels=names, xlabel=x_label, ylabel=y_label)
    ax.invert_yaxis()
    ax.grid(visible=True, axis="x", alpha=0.3)
    return figure
