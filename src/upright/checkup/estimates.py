"""Pitch estimate and compass: their scale, against gyro and wheels."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.delays import CLEAR
from upright.checkup.finding import COMPASS, GYRO, PITCH, Finding, Record, error, note
from upright.checkup.fixes import COARSE, levels
from upright.checkup.motion import contrary, follows_wheels
from upright.checkup.physics import Resampled, gyro_by_gravity, motion, pitch_slope, smooth, widths
from upright.checkup.units import DEGREE, STATE, divide
from upright.logs.outliers import grain_of


def estimates(record: Record) -> list[Finding]:
    """Pitch estimate and compass, against the repaired gyro and encoders."""
    m = motion(record)
    return _pitch(record, m) + _heading(record, m) if m is not None else []


_NEAR = 1.2  # within which the rate of a pitch estimate that follows the gyro clearly is that of the gyro
_FACTORS = {
    "degrees instead of radians": 1 / DEGREE,
    "radians × 10": 10.0,
    "degrees × 10": 10 / DEGREE,
    "milliradians": 1000.0,
    "converted from degrees twice": DEGREE,
    "radians / 10": 0.1,
}


def _pitch(record: Record, m: Resampled) -> list[Finding]:
    """The rate of the pitch estimate relative to the gyro, which should be 1."""
    slope, r2 = pitch_slope(record, m)
    if slope and 1 < (count := levels(record[PITCH])) <= COARSE:
        step = grain_of(record[PITCH])
        return [note("channel/coarse", PITCH, f"it has {count} values in steps of {step:.3g}: too coarse to compare")]
    near = _NEAR if r2 > CLEAR else 2.0
    if r2 < 0.7 or not slope or 1 / near < slope < near:
        return []
    evidence = f"its rate is {slope:.3g} times the gyro (R² {r2:.2f}), where it should be 1"
    if -2 < slope < -0.5:
        return contrary((PITCH,), (GYRO,), evidence, follows_wheels(m) or int(np.sign(gyro_by_gravity(record, m))))
    if slope < 0:
        return []
    why = min(_FACTORS, key=lambda name: abs(math.log(slope / _FACTORS[name])))
    if abs(math.log(slope / _FACTORS[why])) > 0.4:
        repair = "nothing in the log tells which of both has another scale, or whether the clock is wrong: " + STATE
        return [error("units/scale", PITCH, evidence, repair)]
    return [divide((PITCH,), f"{why}: {evidence}", _FACTORS[why])]


def _heading(record: Record, m: Resampled) -> list[Finding]:
    """The compass relative to the turn of the wheels: R/W, from 0.1 to 1, or 57 times that in degrees."""
    if COMPASS not in record or not np.isfinite(record[COMPASS]).all():
        return []
    even = np.interp(m.t, record.t, record[COMPASS])
    width = 4 * widths(m.period)[-1]
    a, b = (smooth(x, m.period, width, 1)[m.good] for x in (even, m.right - m.left))
    if b.std() < 0.05 or abs(float(np.corrcoef(a, b)[0, 1])) < 0.8:
        return []
    slope = abs(float(a @ b / (b @ b)))
    if slope < 4:
        return []
    evidence = (
        f"degrees instead of radians: it turns {slope:.3g} rad per rad between the wheels; robots have R/W of 0.1 to 1"
    )
    return [divide((COMPASS,), evidence, 1 / DEGREE)]
