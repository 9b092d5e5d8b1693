"""Scales of 2 or ½ of gyro and encoders: what is asked of a log whose robot is known."""

from __future__ import annotations

import math

from upright.checkup.delays import CLEAR, SHARP
from upright.checkup.duty import back_emf
from upright.checkup.finding import GYRO, LEFT, Finding, Record, note, warning
from upright.checkup.physics import motion
from upright.checkup.units import STATE, expected
from upright.robots import Robot

_HALF = 0.5  # of the logarithm of q, from which a factor of 2 is likelier than none: files and logs are within 0.25
_EMF = 0.25  # the same of the back-EMF
_CLEAR = 5.0  # [s] on the wheels, of which q is known to a fifth


def against_robot(record: Record, robot: Robot | None = None) -> list[Finding]:
    """A gyro that shows twice or half of what the wheels and the robot's file say, or encoders that count so, by q of
    the pendulum equation; the back-EMF tells which. What is not told is said. p is not asked: friction bends it."""
    m = motion(record)
    if robot is None or m is None or m.gyro is None:
        return []
    fit = m.law
    values = expected(robot)
    sure = fit.r2 > CLEAR and fit.sharp > SHARP and not fit.pushed and m.good.sum() * m.period > _CLEAR
    off = math.log(fit.values[0]) - values["q"][0] if sure and min(fit.values) > 0 else 0.0
    shown = f"the wheels turn back {math.exp(off):.2g} times as fast against the body as by the file of '{robot.name}'"
    if abs(off) < _HALF:
        agree = f"{shown}: a scale of both gyro and encoders, or of the clock, is not told"
        unclear = "a scale of gyro or encoders by 2 or ½ is not told: no pendulum equation holds clearly"
        repair = "log for longer, with a dither and no pushes, beside a watch"
        return [note("motion/untold", m.gyro_name, agree if off else unclear, repair)]
    emf = back_emf(record, m, robot) if robot.drive == "voltage" else 0.0
    by = math.log(emf) - values["back_emf"][0] if emf else math.inf
    causes = {
        GYRO: (by, f"the gyro shows about {math.exp(-off):.2g} times the motion (another range of the chip)"),
        LEFT: (by + off, f"the encoders count about {math.exp(off):.2g} times the turns (×1, ×2 or ×4)"),
    }
    likely = [name for name, (left, _) in causes.items() if abs(left) < _EMF] or [*causes]
    evidence = f"{shown}: {' or '.join(causes[name][1] for name in likely)}, or the file is of another robot"
    return [warning("units/scale", likely[0], evidence, f"{STATE}, or mend the robot's file")]
