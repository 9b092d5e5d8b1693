"""The last seconds before a fall, as they are drawn."""

from __future__ import annotations

import math
from dataclasses import dataclass, fields
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.diagnose.fall import authority, falling_lean
from upright.diagnose.innovations import FilterRun
from upright.diagnose.usual import SECONDS

PLOTTED_NIS = 0.1  # [s] over which the NIS of the figure is averaged


@dataclass(frozen=True, eq=False, kw_only=True)
class Series:
    """The last seconds by sample: time [s], pitch [rad], pitch rate [rad/s], command over the largest, how much of the
    motors' reach is used up, and the mean of e²/s over the readings of a tenth of a second, which lies between `low`
    and `high` in 95 of 100 cases where the robot follows its model."""

    t: Array
    pitch: Array
    pitch_rate: Array
    command: Array
    reserve: Array
    nis: Array
    low: float = math.nan
    high: float = math.nan

    @classmethod
    def none(cls) -> Series:
        """Nothing to draw."""
        empty = np.zeros(0)
        return cls(t=empty, pitch=empty, pitch_rate=empty, command=empty, reserve=empty, nis=empty)

    def to_json(self) -> dict[str, Any]:
        """As lists, to six digits."""
        data = {f.name: getattr(self, f.name) for f in fields(self)}
        return {k: _rounded(v) if isinstance(v, np.ndarray) else finite(v) for k, v in data.items()}


def _rounded(values: Array) -> list[float | None]:
    return [float(f"{v:.6g}") if math.isfinite(v) else None for v in values.tolist()]


def series_of(run: FilterRun, end: float) -> Series:
    """The last seconds before `end` [s]."""
    motors = authority(run)
    keep = (motors.t > end - SECONDS) & (motors.t <= end + 0.2)
    t = run.t[run.readings]
    sums = np.concatenate([[0.0], np.cumsum(run.whitened**2)])
    edges = np.searchsorted(t, motors.t[keep])
    count = edges - np.searchsorted(t, motors.t[keep] - PLOTTED_NIS)
    nis = (sums[edges] - sums[edges - count]) / np.maximum(count, 1)
    low, high = _band(float(np.median(count)) if keep.any() else 1.0)
    states = motors.states[keep].copy()
    fallen = falling_lean(run)
    if fallen is not None:  # the same lean as the time of the fall
        falling_rows = motors.t[keep] >= fallen[0][0]
        states[falling_rows, 0] = np.interp(motors.t[keep][falling_rows], *fallen)
    return Series(
        t=motors.t[keep], pitch=states[:, 0], pitch_rate=states[:, 1], command=motors.command[keep],
        reserve=motors.reserve[keep], nis=nis, low=low, high=high,
    )  # fmt: skip


def _band(count: float) -> tuple[float, float]:
    """Between which the mean of so many squares of standard normal numbers lies in 95 of 100 cases."""
    from scipy.special import chdtri

    n = max(count, 1.0)
    return float(chdtri(n, 0.975)) / n, float(chdtri(n, 0.025)) / n
