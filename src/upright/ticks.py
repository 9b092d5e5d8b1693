"""Numbers at the ticks of axes and in drawings, in one style."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axis import Axis
from matplotlib.ticker import Formatter, FuncFormatter, LogFormatter

from upright.languages import localised, number

DIGITS = 4  # of a number at a tick


def numbered(*axes: Axis) -> None:
    """Numbers at the ticks in one style: 0.25, 1000, 2 · 10⁻⁷, and 0.1, 1, 10 on a logarithmic axis."""
    for axis in axes:
        logarithmic = axis.get_scale() == "log"
        axis.set_major_formatter(FuncFormatter(_plain) if logarithmic else AxisNumbers())
        if logarithmic:
            axis.set_minor_formatter(_Between(labelOnlyBase=False, minor_thresholds=(1.5, 0.5)))


def _plain(value: float, _: object) -> str:
    return number(value, DIGITS)


class AxisNumbers(Formatter):
    """All ticks of an axis with the same number of decimals."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        del pos
        return number(x, DIGITS)

    def format_ticks(self, values: Any) -> list[str]:
        ticks = np.asarray(values, dtype=np.float64)
        step = float(np.diff(ticks).min()) if len(ticks) > 1 else 0.0
        largest = float(np.abs(ticks).max()) if len(ticks) else 0.0
        decimals = max(0, -int(np.floor(np.log10(step) + 1e-9))) if step > 0 else 4
        if decimals > 4 or largest >= 1e5:
            return [number(0.0 if abs(tick) < 1e-9 * step else float(tick), 3) for tick in ticks]
        exact = (d for d in range(decimals, 5) if np.allclose(np.round(ticks, d), ticks, atol=1e-6 * step))
        decimals = next(exact, decimals)
        return [localised(f"{tick + 0.0:.{decimals}f}") for tick in np.round(ticks, decimals)]


class _Between(LogFormatter):
    """Ticks between powers of ten are named where few powers are in view."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        return number(x, DIGITS) if super().__call__(x, pos) else ""
