"""Counts: whole numbers of which nobody knows how many are a turn of a wheel, or a radian per second."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.duty import counted
from upright.checkup.finding import GYRO, LEFT, RIGHT, Finding, Fix, Record, error
from upright.pages import Quantity, Say
from upright.robots import Robot
from upright.signals.units import UNITS

DEGREE = math.pi / 180
LENGTHS = [unit for unit, (_, si) in UNITS.items() if si in ("m", "m/s")]


STATE_SCALE = Say("State unit and scale in a mapping.")
STATE_COUNTS = Say("State in a mapping how many counts are a turn.")


def whole_numbers(record: Record) -> list[Finding]:
    """Encoders in whole numbers that go over more than two turns of radians."""
    whole = [name for name in (LEFT, RIGHT) if name in record and counted(record[name])]
    names = [name for name in whole if np.nanmax(record[name]) - np.nanmin(record[name]) > 2 * math.tau]
    evidence = Say("Whole numbers are degrees or counts; this log does not tell which.")
    return [error("units/counts", name, evidence, STATE_SCALE) for name in names]


def distances(record: Record, robot: Robot | None = None) -> list[Finding]:
    """Encoders that were read in metres, as odometry has them, and not over the radius of a wheel: the robot has it."""
    sides = tuple(n for n in (LEFT, RIGHT) if n in record and record.read.get(n) in LENGTHS)
    if not sides:
        return []
    evidence = Say("Its unit, {unit}, is that of a distance, and no angle of a wheel.", unit=record.read[sides[0]])
    if robot is None:
        repair = Say("Name the robot with `--robot`, or state scale 1 over the wheel's radius in a mapping.")
        return [error("units/counts", name, evidence, repair) for name in sides]
    by = Fix("scale", sides, (1 / robot.wheel_radius,))
    repair = Say("Divide by the robot's wheel radius, {radius}.", radius=Quantity(robot.wheel_radius, "m"))
    return [error("units/scale", sides[0], evidence, repair, by)]


def raw_counts(record: Record, q: float, usual: tuple[float, float]) -> list[Finding]:
    """A gyro of which nobody knows what a count means: robots differ by more than chips do."""
    encoders = [name for name in (LEFT, RIGHT) if counted(record[name])]
    factor = 1 / DEGREE if encoders else 1.0
    least, most = (factor * math.exp(usual[0] + side * usual[1]) / q for side in (-1, 1))
    counts = Quantity(None, "1", low=least, high=most)
    evidence = Say("Raw counts: of usual robots {counts} of them make 1 rad/s.", counts=counts)
    if encoders:
        evidence = Say("Raw counts: {counts} of them make 1 rad/s, if the encoders count degrees.", counts=counts)
    repair = Say("State unit deg/s and the chip's scale in a mapping: 1/131, 1/65.5, 1/32.8 or 1/16.4.")
    unknown = Say("Raw counts, of an unknown number to a turn.")
    return [
        error("units/counts", GYRO, evidence, repair),
        *(error("units/counts", name, unknown, STATE_COUNTS) for name in encoders),
    ]


def encoder_counts(q: float, usual: tuple[float, float]) -> list[Finding]:
    """Encoders of which nobody knows how many counts are a turn, beside a gyro in a known unit, with q in counts."""
    least, most = (math.tau * q / math.exp(usual[0] + side * usual[1]) for side in (1, -1))
    counts = Quantity(None, "1", low=least, high=most)
    evidence = Say("Raw counts: of usual robots {counts} are a turn.", counts=counts)
    return [error("units/counts", name, evidence, STATE_COUNTS) for name in (LEFT, RIGHT)]
