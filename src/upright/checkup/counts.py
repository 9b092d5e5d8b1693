"""Counts: whole numbers of which nobody knows how many are a turn of a wheel, or a radian per second."""

from __future__ import annotations

import math

import numpy as np

from upright.checkup.duty import counted
from upright.checkup.finding import GYRO, LEFT, RIGHT, Finding, Fix, Record, error
from upright.logs.units import UNITS
from upright.robots import Robot

DEGREE = math.pi / 180
LENGTHS = [unit for unit, (_, si) in UNITS.items() if si in ("m", "m/s")]


def whole_numbers(record: Record, why: str) -> list[Finding]:
    """Encoders in whole numbers that go over more than two turns of radians."""
    whole = [name for name in (LEFT, RIGHT) if name in record and counted(record[name])]
    names = [name for name in whole if np.nanmax(record[name]) - np.nanmin(record[name]) > 2 * math.tau]
    evidence = f"whole numbers, so degrees or counts: {why}"
    repair = "state unit and scale in a mapping"
    return [error("units/counts", name, evidence, repair) for name in names]


def distances(record: Record, robot: Robot | None = None) -> list[Finding]:
    """Encoders that were read in metres, as odometry has them, and not over the radius of a wheel: the robot has it."""
    sides = tuple(n for n in (LEFT, RIGHT) if n in record and record.read.get(n) in LENGTHS)
    if not sides:
        return []
    evidence = f"a distance, by its unit of {record.read[sides[0]]}, and no angle of a wheel"
    if robot is None:
        repair = "state in a mapping: scale 1 over the wheel's radius in metres; or name the robot with --robot"
        return [error("units/counts", name, evidence, repair) for name in sides]
    by = Fix("scale", sides, (1 / robot.wheel_radius,))
    return [error("units/scale", sides[0], evidence, f"divide by the robot's radius, {robot.wheel_radius:.4g} m", by)]


def raw_counts(record: Record, q: float, usual: tuple[float, float]) -> list[Finding]:
    """A gyro of which nobody knows what a count means: robots differ by more than chips do."""
    encoders = [name for name in (LEFT, RIGHT) if counted(record[name])]
    factor = 1 / DEGREE if encoders else 1.0
    least, most = (factor * math.exp(usual[0] + side * usual[1]) / q for side in (-1, 1))
    alike = " if the encoders count degrees" if encoders else ""
    evidence = f"raw counts: by the pendulum equation, of usual robots {least:.2g} to {most:.2g} make 1 rad/s{alike}"
    repair = "state unit and scale in a mapping: deg/s, 1/131, 1/65.5, 1/32.8, 1/16.4, or as the chip's data sheet says"
    turns = "state in a mapping how many counts are a turn"
    return [
        error("units/counts", GYRO, evidence, repair),
        *(error("units/counts", name, "raw counts, of an unknown number to a turn", turns) for name in encoders),
    ]


def encoder_counts(q: float, usual: tuple[float, float]) -> list[Finding]:
    """Encoders of which nobody knows how many counts are a turn, beside a gyro in a known unit, with q in counts."""
    least, most = (math.tau * q / math.exp(usual[0] + side * usual[1]) for side in (1, -1))
    evidence = f"raw counts: by the pendulum equation, of usual robots {least:.2g} to {most:.2g} are a turn"
    repair = "state in a mapping how many counts are a turn: unit turn, scale 1 over that number"
    return [error("units/counts", name, evidence, repair) for name in (LEFT, RIGHT)]
