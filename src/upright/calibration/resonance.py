"""A gyro that reads the pitch rate through a resonance of second order: a mount that swings, or a filter on its board.

ω² / (s² + 2ζω s + ω²) is both. Little damping is something between frame and gyro that swings: it turns further than
the frame near its frequency. A damping of 0.7 is a filter of second order, whose passband ends at that frequency.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.calibration.estimate import VISIBLE, Estimate
from upright.calibration.parameters import Parameter
from upright.logs.recording import SENSOR, Recording
from upright.pages import Quantity, Say
from upright.robots import Kit

FREQUENCY, DAMPING = "gyro_resonance", "gyro_damping"
MEANING = {
    FREQUENCY: "where the gyro swings, or where its filter ends",
    DAMPING: "of that resonance: little of what swings, 0.7 of a filter",
}

TYPICAL = {FREQUENCY: 22.0, DAMPING: 0.17}
"""[Hz, 1] Medians of the priors: geometric means of what is plausible. Mounts of bricks and of printed parts swing at 5
to 40 Hz, filters on gyros' boards end at 5 to 100 Hz; a joint damps 0.02 of what is critical, a filter 0.5 to 1.4."""
RANGE = {FREQUENCY: math.log(100 / 5) / (2 * 1.96), DAMPING: math.log(1.4 / 0.02) / (2 * 1.96)}
"""Deviations of their logarithms: 95 % from end to end of that."""
SWING = "swing"
"""Noise that makes a gyro swing, a variance a second: gears and shocks do so without turning the frame."""
FIRST, LEAST, MOST = 0.1, 1e-3, 0.3
"""[1] How much of a gyro's deviation such a swing is: at first, at least, and at most. Beyond a tenth of its power it
would be no addition to the motion, and stand in for what the robot's equations leave out."""
FILTERS = 0.5
"""[1] Damping from which the resonance amplifies nothing by more than 1.15, and is called a filter."""


def resonance_of(kit: Kit) -> tuple[Parameter, ...]:
    """The two parameters of the gyro of `kit`, where it has a resonance."""
    gyro = kit.sensors.get("sensor/gyro")
    return parameters_about(gyro.resonance, gyro.damping) if gyro and gyro.resonance else ()


def parameters_about(frequency: float, damping: float) -> tuple[Parameter, ...]:
    """Frequency [Hz] and damping [1] with these medians of their priors."""
    medians = {FREQUENCY: frequency, DAMPING: damping}
    units = {FREQUENCY: "Hz", DAMPING: "1"}
    return tuple(
        Parameter(name, units[name], value, value * RANGE[name], "logarithm", 0.0, guess=True)
        for name, value in medians.items()
    )


def resonates(parameters: Sequence[Parameter]) -> bool:
    """Whether these are of a gyro that has a resonance."""
    return any(p.name == FREQUENCY for p in parameters)


def swing_noise(recordings: Sequence[Recording], part: float) -> float:
    """The variance a second [(rad/s)²/s] under which a resonance of typical numbers swings with this `part` of the
    gyro's deviation: 4ζω times the variance of the swing."""
    gyros = [r.value[r.kind == [SENSOR[row] for row in r.rows].index("gyro")] for r in recordings]
    rate = 4 * TYPICAL[DAMPING] * 2 * math.pi * TYPICAL[FREQUENCY]
    return rate * part**2 * float(np.mean([y.var() for y in gyros]))


def in_words(estimates: Sequence[Estimate]) -> list[Say]:
    """What the two numbers say of the robot; nothing where the log leaves the frequency open."""
    known = {e.name: e for e in estimates}
    if FREQUENCY not in known or known[FREQUENCY].verdict != VISIBLE:
        return []
    f, damping = known[FREQUENCY], known[DAMPING]
    facts = {"frequency": f.quantity, "damping": Quantity(damping.value, "1", digits=2)}
    if damping.value >= FILTERS:
        return [Say("The gyro has a low-pass filter at {frequency}, damping {damping}.", **facts)]
    return [Say("The gyro swings against the frame at {frequency}, damping {damping}: fix the sensor.", **facts)]
