"""What was done to a robot, in words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from upright.pages import Quantity, Say


def pushes_in_words(pushes: Sequence[Mapping[str, Any]]) -> Say:
    """The pushes of a scenario as its origin keeps them, each a mapping of the numbers of one push."""
    if not pushes:
        return Say("nobody pushes")
    return Say("{pushes}", pushes=[_in_words(push) for push in pushes])


def _in_words(push: Mapping[str, Any]) -> Say:
    for name, value in push.items():
        if value and name in _WORDS:
            return _WORDS[name](push)
    return Say("a push")


_WORDS = {
    "impulse": lambda p: Say("a knock of {size}", size=Quantity(p["impulse"], "N s")),
    "force": lambda p: Say("{force} for {time}", force=Quantity(p["force"], "N"), time=Quantity(p["duration"], "s")),
    "pitch": lambda p: Say("held at {angle} and let go", angle=Quantity(p["pitch"], "rad")),
    "angle": lambda p: Say("a slope of {angle}", angle=Quantity(p["angle"], "rad")),
}
