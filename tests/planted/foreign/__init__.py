"""Robots of other people: two simulators that share nothing with upright."""

from planted.foreign.plane import (
    DEGREE,
    SMALL,
    Bot,
    Change,
    Course,
    arduino,
    known,
    logged,
    metric,
    missed,
    replace,
    truth_of,
)

__all__ = [
    "DEGREE", "SMALL", "Bot", "Change", "Course", "arduino", "known", "logged", "metric", "missed", "replace",
    "truth_of",
]  # fmt: skip
