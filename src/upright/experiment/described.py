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
    if push.get("impulse"):
        return Say("a knock of {size}", size=Quantity(push["impulse"], "N s"))
    if push.get("force"):
        return Say("{force} for {time}", force=Quantity(push["force"], "N"), time=Quantity(push["duration"], "s"))
    if push.get("pitch"):
        return Say("held at {angle} and let go", angle=Quantity(push["pitch"], "rad"))
    if push.get("angle"):
        return Say("a slope of {angle}", angle=Quantity(push["angle"], "rad"))
    return Say("a push")
