"""What was done to a robot, in words, and who it was."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from upright.pages import Quantity, Say


def pushes_in_words(pushes: Sequence[Mapping[str, Any]]) -> Say:
    """The pushes of a scenario as its origin keeps them, each a mapping of the numbers of one push."""
    if not pushes:
        return Say("no push")
    return Say("{pushes}", pushes=[_in_words(push) for push in pushes])


def _in_words(push: Mapping[str, Any]) -> Say:
    if push.get("impulse"):
        impulse = push["impulse"]
        size = Quantity(abs(impulse), "N s")
        return Say("a knock of {size} forward", size=size) if impulse > 0 else Say("a knock of {size} back", size=size)
    if push.get("force"):
        return Say("{force} for {time}", force=Quantity(push["force"], "N"), time=Quantity(push["duration"], "s"))
    if push.get("pitch"):
        time = Quantity(push["until"] - push.get("start", 0.0), "s")
        return Say("a force for {time} that leans it to {angle}", time=time, angle=Quantity(push["pitch"], "rad"))
    if push.get("angle"):
        return Say("a slope of {angle}", angle=Quantity(push["angle"], "rad"))
    return Say("a push")


def facts_of(origin: Mapping[str, Any]) -> dict[str, str]:
    """Robot, kit, controller, seed and versions of a log or a fleet, for a page's foot."""
    controller = origin.get("controller") or {}
    scenario = origin.get("scenario") or {}
    versions = origin.get("versions") or {}
    facts = {
        "robot": name_in(origin, "robot"),
        "kit": name_in(origin, "kit"),
        "controller": f"{controller.get('kind', '')} {str(controller.get('hash', ''))[:12]}".strip(),
        "seed": str(origin.get("seed", scenario.get("seed", ""))),
        "versions": ", ".join(f"{name} {number}" for name, number in sorted(versions.items())),
    }
    return {name: text for name, text in facts.items() if text}


def name_in(origin: Mapping[str, Any], part: str) -> str:
    """The name of the robot or the kit, empty where the origin has none."""
    return str((origin.get(part) or {}).get("name", ""))


def law_in(origin: Mapping[str, Any]) -> str:
    """The kind of controller, empty where the origin has none."""
    return str((origin.get("controller") or {}).get("kind", ""))


def law_in_words(origin: Mapping[str, Any]) -> str | Say:
    """The kind of controller, in a sentence."""
    return law_in(origin) or Say("a controller of one's own")
