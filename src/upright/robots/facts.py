"""Robot and kit as numbers by name, and in which of them two differ."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from upright.atomic import finite
from upright.robots.drives import SPEED_DRIVE
from upright.robots.kit import Kit
from upright.robots.robot import PARAMETERS, Robot, preset_names

Facts = Mapping[str, float | str | None]

STRENGTHS = ("motor/left", "motor/right")
"""Numbers of a kit that stand in its record only where its two motors differ from the robot's."""

MOST_VALUES = 6
"""Differences that are told with their values; of more, the names."""


def robot_facts(robot: Robot) -> Facts:
    """Every physical parameter of a robot, its drive, and the conditions that its file states; its name, sources and
    spreads decide nothing."""
    unused = () if robot.drive == "speed" else SPEED_DRIVE  # other drives' certificates may be older than these
    numbers = {name: value for name, value in robot.numbers().items() if name not in unused}
    return {"drive": robot.drive, **numbers, **robot.conditions.facts()}


def recorded(origin: Mapping[str, Any]) -> dict[str, Any]:
    """The numbers of a robot in a log's origin; old ones lack those of a speed drive, which had none then.

    Raises `KeyError` for another that is missing.
    """
    return {name: origin[name] for name in PARAMETERS if name in origin or name not in SPEED_DRIVE}


def kit_facts(kit: Kit) -> Facts:
    """Every number of a kit, as `motor/limit` or `sensor/gyro/noise`; None for what is unlimited. How it is wired
    decides nothing."""
    facts: dict[str, float | str | None] = {}
    parts: list[tuple[str, Any]] = [
        (name, value) for name, value in asdict(kit).items() if name not in ("name", "wiring")
    ]
    while parts:
        name, value = parts.pop(0)
        if isinstance(value, dict):
            known = "" if name == "sensors" else f"{name}/"
            parts[:0] = [(known + str(key), inner) for key, inner in value.items()]
        elif not (name in STRENGTHS and value == 1.0):
            facts[name] = finite(value)
    return facts


def differences(here: Facts, there: Facts) -> str:
    """In what `here` differs from `there`, each by name; empty where in nothing."""
    names = [name for name in {**there, **here} if here.get(name, "none") != there.get(name, "none")]
    names = list(dict.fromkeys(_whole(name, here, there) for name in names))
    first = [f"{n} {_text(here, n)} instead of {_text(there, n)}" for n in names[:MOST_VALUES]]
    return ", ".join([*first, *names[MOST_VALUES:]])


def _whole(name: str, here: Facts, there: Facts) -> str:
    """The sensor where only one side has it, the number itself otherwise."""
    part = name.rpartition("/")[0]
    both = all(any(key.startswith(f"{part}/") for key in facts) for facts in (here, there))
    return name if both or not part else part


def _text(facts: Facts, name: str) -> str:
    if name not in facts:
        return "present" if any(key.startswith(f"{name}/") for key in facts) else "absent"
    value = facts[name]
    return "unlimited" if value is None else f"{value:.12g}" if isinstance(value, float | int) else value or "any"


def offered(name: str) -> str:
    """How a robot whose `name` is read somewhere is named in a command to type, ROBOT where nothing tells its file."""
    if name in preset_names() or name.endswith((".toml", ".json")):
        return name
    return f"{name}.toml" if name and Path(f"{name}.toml").is_file() else "ROBOT"
