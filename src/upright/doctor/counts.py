"""Counts: whole numbers of which nobody knows how many are a turn of a wheel, or a radian per second."""

from __future__ import annotations

import math

import numpy as np

from upright.doctor.duty import counted
from upright.doctor.finding import GYRO, LEFT, RIGHT, Finding, Record, error

DEGREE = math.pi / 180


def whole_numbers(record: Record, why: str) -> list[Finding]:
    """Encoders in whole numbers that go over more than two turns of radians."""
    whole = [name for name in (LEFT, RIGHT) if name in record and counted(record[name])]
    names = [name for name in whole if np.nanmax(record[name]) - np.nanmin(record[name]) > 2 * math.tau]
    evidence, repair = f"whole numbers, so degrees or counts: {why}", "state unit and scale in a mapping"
    return [error("units/counts", name, evidence, repair) for name in names]


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
