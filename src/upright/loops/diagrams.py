"""The margins of a loop, drawn into its Bode diagram."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array
from upright.loops.margins import Margins
from upright.pages import Say
from upright.plotting import AXIS, COLOURS

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def mark_margins(size: Axes, phase: Axes, m: Margins, curve: tuple[Array, Array]) -> None:
    """The margins as lines with their size, each at its frequency; `curve`: frequencies [rad/s] and the phase [°]."""
    gains = [(at, k) for at, k in ((m.gain_low_at, m.gain_low), (m.gain_high_at, m.gain_high)) if at > 0]
    if gains:
        at, factors = zip(*gains, strict=True)
        size.vlines(at, np.divide(1.0, factors), 1.0, color=COLOURS[1], linewidth=3, label=str(Say("gain margins")))
        for place, factor in gains:
            text = f"{100 * (factor - 1):+.0f} %".replace("-", "−")
            _beside(size, text, place, 1 / factor, above=factor < 1, right=place > curve[0][-1] / 3)
    if m.phase_at > 0:
        turn = math.degrees(m.phase) * (1 if m.leads else -1)
        there = float(np.interp(m.phase_at, *curve))
        level = 360 * round((there + turn - 180) / 360) + 180
        phase.vlines([m.phase_at], level - turn, level, color=COLOURS[2], linewidth=3, label=str(Say("phase margin")))
        phase.margins(y=0.18)
        phase.axhline(level, linestyle="--", color=AXIS, linewidth=1.0)
        _beside(phase, f"{abs(turn):.0f}°", m.phase_at, level - turn, above=turn < 0, right=False)


def _beside(ax: Axes, text: str, x: float, y: float, *, above: bool, right: bool) -> None:
    """Letters at the end of a line that is drawn up or down to (x, y); `right`: near the right border."""
    ax.annotate(
        text, (x, y), (0, 4 if above else -4), textcoords="offset points", ha="right" if right else "center",
        va="bottom" if above else "top",
    )  # fmt: skip
