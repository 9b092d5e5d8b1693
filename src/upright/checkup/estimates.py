"""Pitch estimate and compass: their scale, against gyro and wheels."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.delays import CLEAR
from upright.checkup.finding import COMPASS, GYRO, PITCH, Finding, Record, error, note, plain
from upright.checkup.fixes import COARSE, levels
from upright.checkup.motion import contrary, follows_wheels
from upright.checkup.physics import Resampled, gyro_by_gravity, motion, pitch_slope, smooth, widths
from upright.checkup.units import DEGREE, divide
from upright.logs.outliers import grain_of
from upright.pages import Say


def estimates(record: Record) -> list[Finding]:
    """Pitch estimate and compass, against the repaired gyro and encoders."""
    m = motion(record)
    return _pitch(record, m) + _heading(record, m) if m is not None else []


_NEAR = 1.2  # within which the rate of a pitch estimate that follows the gyro clearly is that of the gyro
_FACTORS = {
    Say("degrees"): 1 / DEGREE,
    Say("tenths of a radian"): 10.0,
    Say("tenths of a degree"): 10 / DEGREE,
    Say("milliradians"): 1000.0,
    Say("degrees converted twice"): DEGREE,
    Say("tens of radians"): 0.1,
}


def _pitch(record: Record, m: Resampled) -> list[Finding]:
    """The rate of the pitch estimate relative to the gyro, which should be 1."""
    slope, r2 = pitch_slope(record, m)
    if slope and 1 < (count := levels(record[PITCH])) <= COARSE:
        step = grain_of(record[PITCH])
        coarse = Say("It has {n} values in steps of {step}: too coarse to compare.", n=count, step=plain(step))
        return [note("channel/coarse", PITCH, coarse, None)]
    near = _NEAR if r2 > CLEAR else 2.0
    if r2 < 0.7 or not slope or 1 / near < slope < near:
        return []
    evidence = Say("Its rate is {slope} times that of the gyro, and should be 1.", slope=plain(slope), r2=plain(r2))
    if -2 < slope < -0.5:
        return contrary((PITCH,), (GYRO,), evidence, follows_wheels(m) or int(np.sign(gyro_by_gravity(record, m))))
    if slope < 0:
        return []
    why = min(_FACTORS, key=lambda name: abs(math.log(slope / _FACTORS[name])))
    if abs(math.log(slope / _FACTORS[why])) > 0.4:
        repair = Say("State the true scale of either in a mapping, or check the clock.")
        return [error("units/scale", PITCH, evidence, repair)]
    return [divide((PITCH,), Say("Perhaps {unit}. {evidence}", unit=why, evidence=evidence), _FACTORS[why])]


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
    evidence = Say("It turns {slope} rad for each rad between the wheels; usual is 0.1 to 1.", slope=plain(slope))
    return [divide((COMPASS,), evidence, 1 / DEGREE)]
