"""Scales of 2 or ½ of gyro and encoders: what is asked of a log whose robot is known."""

from __future__ import annotations

import math

from upright.checkup.delays import CLEAR, SHARP
from upright.checkup.duty import back_emf
from upright.checkup.finding import GYRO, LEFT, Finding, Record, note, plain, warning
from upright.checkup.physics import motion
from upright.checkup.units import expected
from upright.pages import Say
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
    facts = {"ratio": plain(math.exp(off), 2), "robot": robot.name}
    if abs(off) < _HALF:
        evidence = Say("No pendulum equation holds clearly, so a scale of 2 or ½ would not show.")
        if off:
            evidence = Say(
                "Gyro and wheels agree with the file of {robot} (ratio {ratio}); one scale of both would not show.",
                **facts,
            )
        repair = Say("Log for longer, with a dither and no pushes, beside a watch.")
        return [note("motion/untold", m.gyro_name, evidence, repair)]
    emf = back_emf(record, m, robot) if robot.drive == "voltage" else 0.0
    by = math.log(emf) - values["back_emf"][0] if emf else math.inf
    apart = {GYRO: by, LEFT: by + off}
    likely = [name for name, left in apart.items() if abs(left) < _EMF] or [*apart]
    evidence = Say(
        "The wheels turn {ratio} times as fast as by the file of {robot}: the gyro's range, or how encoders count.",
        **facts,
    )
    repair = Say("State the true unit and scale in a mapping, or mend the robot's file.")
    return [warning("units/scale", likely[0], evidence, repair)]
