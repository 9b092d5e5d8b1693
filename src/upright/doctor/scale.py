"""Scales of 2 or ½ of gyro and encoders: what is asked of a log whose robot is known."""

from __future__ import annotations

import math

from upright.doctor.delays import CLEAR, SHARP
from upright.doctor.duty import ALIKE, back_emf
from upright.doctor.finding import GYRO, LEFT, Finding, Record, note, warning
from upright.doctor.physics import motion
from upright.doctor.units import SHORTER, STATE, expected
from upright.robots import Robot

_SPREAD = 0.2  # of the logarithm of q, of a robot's file and of an estimate from ten clear seconds together
_EMF = 0.25  # the same of the back-EMF


def against_robot(record: Record, robot: Robot | None = None) -> list[Finding]:
    """A gyro that shows twice or half of what the wheels and the robot's file say, or encoders that count so, by q of
    the pendulum equation; the back-EMF tells which. What is not told is said. p is not asked: friction bends it."""
    m = motion(record)
    if robot is None or m is None or m.gyro is None:
        return []
    fit, values = m.law, expected(robot)
    off = math.log(fit.values[0]) - values["q"][0] if min(fit.values, default=0.0) > 0 else 0.0
    spread = math.hypot(_SPREAD, SHORTER["q"] / max(float(m.good.sum()) * m.period, m.period))
    sure = fit.r2 > CLEAR and fit.sharp > SHARP and not fit.pushed and ALIKE * spread**2 < math.log(2) ** 2 / 2
    if not off or not sure:
        evidence = "not told: a scale of gyro and encoders by 2 or ½, since the pendulum equation does not hold clearly"
        return [note("units/untold", m.gyro_name, evidence, "a longer log with a dither and no pushes tells it")]
    shown = f"by the pendulum equation q is {math.exp(off):.2g} times that of the file of '{robot.name}'"
    if abs(off) < math.log(2) / 2 + ALIKE * spread**2 / math.log(2):
        evidence = f"{shown}, so that gyro and encoders agree; not told: a scale of both, or of the clock"
        return [note("units/untold", m.gyro_name, evidence, "compare the log's length with a watch")]
    emf = back_emf(record, m, robot) if robot.drive == "voltage" else 0.0
    by = math.log(emf) - values["back_emf"][0] if emf else math.inf
    causes = {
        GYRO: (by, f"the gyro shows about {math.exp(-off):.2g} times the motion (another range of the chip)"),
        LEFT: (by + off, f"the encoders count about {math.exp(off):.2g} times the turns (×1, ×2 or ×4)"),
    }
    likely = [name for name, (left, _) in causes.items() if abs(left) < _EMF]
    told = likely if len(likely) == 1 else [*causes]
    evidence = f"{shown}: {' or '.join(causes[name][1] for name in told)}, or the file is of another robot"
    return [warning("units/scale", told[0], evidence, f"{STATE}, or mend the robot's file")]
