"""Angles that begin again: an encoder that counts one turn only, a counter of 8 or 16 bits, a pitch from 0 to 360°."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.finding import LEFT, PITCH, RIGHT, Array, Finding, Fix, Record, error, instant
from upright.logs.outliers import grain_of
from upright.pages import Quantity, Say

_HALF = 0.5  # of a channel's range: a step beyond is a jump
_CLEAR = 4.0  # times the largest ordinary step, which a jump exceeds
_TURN = 2 * math.pi  # [rad] after which most angles begin again


def wrapped(record: Record) -> list[Finding]:
    """Encoders and pitch estimates whose readings jump by one period, up to which they count.

    All jumps are alike, and no reading is further from another than they are. Of a single jump the period must be a
    usual one: a counter may also have been set to zero.
    """
    findings: list[Finding] = []
    for name in (LEFT, RIGHT, PITCH):
        jumps, period = _jumps(record[name]) if name in record else (0, 0.0)
        if jumps:
            first = int(np.argmax(np.abs(np.diff(record[name])) > _HALF * period))
            turn = Quantity(period, _unit(record, name), digits=4)
            evidence = Say(
                "It begins again after {period}, first at {time} ({n} in all).",
                period=turn,
                time=instant(float(record.t[first])),
                n=jumps,
            )
            repair = Say("Add {period} where it jumps.", period=turn)
            findings.append(error("encoder/wrapped", name, evidence, repair, Fix("unwrap", (name,), (period,))))
    return findings


def _unit(record: Record, name: str) -> str:
    unit = record.units.get(name, "")
    return "counts" if unit in ("", "1") else unit


def _jumps(x: Array) -> tuple[int, float]:
    """How often readings (n,) begin again, and after how much; (0, 0) where they do not."""
    steps = np.diff(x[np.isfinite(x)])
    reach = float(np.ptp(x[np.isfinite(x)])) if len(steps) else 0.0
    jump = np.abs(steps) > _HALF * reach
    if not 0 < jump.sum() < len(steps) / 4 or not reach > 0:
        return 0, 0.0
    grain = grain_of(x)
    ordinary = float(np.abs(steps[~jump]).max())
    sizes = np.abs(steps[jump])
    if sizes.min() < _CLEAR * max(ordinary, grain) or np.ptp(sizes) > 2 * ordinary + grain or _dropouts(x, reach):
        return 0, 0.0
    size = float(np.median(sizes))
    within = ordinary + grain
    usual = [p for p in _usual(size, grain) if abs(p - size) <= within and p > reach - within]
    if usual:
        return int(jump.sum()), min(usual, key=lambda p: abs(p - size))
    return (int(jump.sum()), reach + grain) if jump.sum() > 1 else (0, 0.0)


def _usual(size: float, grain: float) -> list[float]:
    """Periods near `size` that angles and counters have: whole turns, and a power of two of the steps `grain`."""
    bits = [grain * 2.0 ** round(math.log2(size / grain))] if grain > 0 and size > 100 * grain else []
    return [max(round(size / _TURN), 1) * _TURN, *bits]


def _dropouts(x: Array, reach: float) -> bool:
    """Whether the readings beyond the jumps are one and the same, as where a sensor answers with zero."""
    middle = float(np.nanmin(x)) + reach / 2
    return any(len(side) > 1 and np.ptp(side) == 0 for side in (x[x < middle], x[x > middle]))
