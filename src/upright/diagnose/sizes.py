"""Which sizes of faults robots meet."""

from __future__ import annotations

import math

from upright.diagnose.fault_fits import FaultFit

LARGEST_OFFSET = 1.31
"""[rad/s] 75 degrees per second: the largest zero-rate level of a common gyro (L3GD20, STMicroelectronics' data sheet,
table 4, at 2000 degrees per second; 20 of the MPU-6050). More is a filter that is lost."""

ALL = 0.97  # most of a reading that is too much where its sensor has another scale
SURVIVED, SURVIVED_FOR = 4.0, 1.5
"""A factor on the scale of a gyro, or of both encoders, with which no robot stands for longer than so many seconds:
these loops bear a factor of two or three in a reading's gain. One encoder of two is no such reading: the mean of both
goes on."""
WITHOUT_TORQUE = 3.0  # [s] that no robot stands without any torque: 14 e-folds, from a millionth of a lean
REVERSE, REVERSE_WIDTH = 2.0, 0.3  # the same of a sensor that has another sign
# over the body's mass: what it can lose, within the fit's errors, and gain
LIGHTEST = -1.1
LARGEST_PAYLOAD = 4.0
MOST_LOST = 0.9
"""Of the body's mass, that goes at most where the equations of motion show it: such a search ends at 0.95, where
something else than a load is needed."""
LEAST_RADIUS, MOST_RADIUS = 0.05, 0.8  # of its radius, that a wheel loses with its tyre
WEAK = 0.9  # of its voltage, that a weak battery has left at most: motors differ by as much
STEEPEST = 0.6  # sine of a slope that robots meet
TWICE = 0.1  # of a power of two: 7 % of a scale, as well as a fall shows one
SLIGHT = {"ramp": 0.017, "payload": 0.05, "delay": 0.1, "scale": 0.1}
"""Of two causes: the sine of a floor that is out of level by a degree, a mass over the body's, to which that is known,
a part of a period, and of a reading, also where a scale is the only cause. No robot falls by less, and errors of its
model look like it."""


def possible(fit: FaultFit, fell_at: float) -> bool:
    """Whether a robot that fell at `fell_at` [s] meets a fault of this size: larger ones are what others look like to a
    filter that is lost."""
    stood = fell_at - fit.onset > SURVIVED_FOR
    wild = not 1 - SURVIVED < fit.size < 1 - 1 / SURVIVED and fit.way not in ("encoder_left", "encoder_right")
    meets = {
        "weak": fit.size < WEAK,
        "motor": not (fell_at - fit.onset > WITHOUT_TORQUE and fit.way == "both"),
        "scale": not slight(fit) and (turned(fit) or fit.size < ALL) and not (stood and wild),
        "payload": (-MOST_LOST if fit.more else LIGHTEST) < fit.size < LARGEST_PAYLOAD,
        "friction": fit.size > 0,
        "radius": LEAST_RADIUS < fit.size < MOST_RADIUS,
        "ramp": abs(fit.size) < STEEPEST,
        "bias": abs(fit.size) * (fell_at - fit.onset if fit.way == "ramp" else 1) < LARGEST_OFFSET,
    }
    return meets.get(fit.fault, True)


def slight(fit: FaultFit) -> bool:
    """Whether a fault is too small to take part in a fall."""
    return abs(fit.size) < SLIGHT.get(fit.fault, 0.0)


def natural(fit: FaultFit) -> bool:
    """Whether a sensor shows twice or half of the motion, or four times: its range or the decoding of its counts is set
    wrongly then, which is no rare fault."""
    twice = math.log2(max(1 - fit.size, TWICE))
    return fit.fault == "scale" and min(abs(abs(twice) - k) for k in (1, 2)) < TWICE


def turned(fit: FaultFit) -> bool:
    """Whether a sensor's scale is wrong by its sign."""
    return fit.fault == "scale" and abs(fit.size - REVERSE) < REVERSE_WIDTH
