"""Robots of other people: two simulators that share nothing with upright, behind one interface.

`plane` has three robots that stay in one plane, `turning` three that turn as well and sixteen faults. `stand` and
`fall` give a `Case` of any of the six.
"""

from __future__ import annotations

from typing import Any

from planted.foreign import plane, turning
from planted.foreign.case import Case
from planted.foreign.plane import DEGREE, SMALL, Bot, Course, arduino, known, logged, metric, missed, replace, truth_of

ROBOTS = (*plane.ROBOTS, *turning.MACHINES)
RIGHT = turning.RIGHT  # the verdict that names each fault


def _of(name: str) -> Any:
    return plane if name in plane.ROBOTS else turning


def faults(name: str) -> tuple[str, ...]:
    """The faults that can be planted in a robot."""
    return tuple(_of(name).FAULTS)


def stand(name: str, seed: int, **options: float) -> Case:
    """A robot that balances and whose log tells something of it."""
    return _of(name).stand(name, seed, **options)


def fall(name: str, cause: str, seed: int) -> Case | None:
    """A robot that falls by this cause, and stands without it; None where no size does that."""
    return _of(name).fall(name, cause, seed)


__all__ = [
    "DEGREE", "RIGHT", "ROBOTS", "SMALL", "Bot", "Case", "Course", "arduino", "fall", "faults", "known", "logged",
    "metric", "missed", "replace", "stand", "truth_of",
]  # fmt: skip
