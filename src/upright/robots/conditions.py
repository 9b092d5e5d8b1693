"""Which batteries and floors a robot is to meet: what a certificate tries, and a log is compared with."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from upright.errors import InvalidRobot
from upright.robots import toml

Range = tuple[float, float]

UNITS = {"battery": "V", "slope": "rad"}
STEEPEST = 0.5  # [rad] of a floor: on a steeper one wheels slip, which no model here has
_BOUNDS = {"battery": (0.1, 1000.0), "slope": (-STEEPEST, STEEPEST)}
_KEYS = ("low", "high", "unit")


@dataclass(frozen=True, kw_only=True)
class Conditions:
    """The range (low, high) of the battery's open-circuit voltage [V] and of the floor's slope [rad]; None where the
    robot's file says nothing: then the kit's battery and a level floor count.

    Raises `InvalidRobot` for a range whose ends are exchanged, or of numbers that cannot be.
    """

    battery: Range | None = None
    slope: Range | None = None

    def __post_init__(self) -> None:
        for name, (least, most) in _BOUNDS.items():
            ends = getattr(self, name)
            if ends is None:
                continue
            low, high = ends
            if not (math.isfinite(low) and math.isfinite(high) and least <= low <= high <= most):
                raise InvalidRobot(
                    f"conditions.{name} from {low:g} to {high:g} {UNITS[name]}",
                    expected=f"low not above high, {least:g} to {most:g} {UNITS[name]}",
                    likely="degrees for radians" if name == "slope" else "millivolts",
                )
            object.__setattr__(self, name, (float(low), float(high)))

    @property
    def slopes(self) -> tuple[float, ...]:
        """The slopes [rad] to try: both ends, or level ground where nothing is stated."""
        return tuple(dict.fromkeys(self.slope)) if self.slope else (0.0,)

    def facts(self) -> dict[str, float]:
        """The ends of each stated range, by name."""
        ranges = {name: getattr(self, name) for name in UNITS if getattr(self, name)}
        return {f"conditions/{n}/{end}": v for n, ends in ranges.items() for end, v in zip(_KEYS, ends, strict=False)}

    def to_toml(self) -> str:
        """The tables that `conditions_of` reads back."""
        text = ""
        for name, unit in UNITS.items():
            if ends := getattr(self, name):
                text += f'\n[conditions.{name}]\nlow = {ends[0]!r}\nhigh = {ends[1]!r}\nunit = "{unit}"\n'
        return text


def conditions_of(table: Mapping[str, Any], where: str) -> Conditions:
    """From `[conditions.battery]` and `[conditions.slope]`, each with low, high and unit; raises `InvalidRobot`."""
    inner = toml.subtable(table, "conditions", where)
    toml.check_keys(inner, UNITS, where, "conditions.")
    ranges: dict[str, Range] = {}
    for name in inner:
        ends = toml.subtable(inner, name, where)
        called = f"conditions.{name}"
        toml.check_keys(ends, _KEYS, where, f"{called}.")
        if missing := [key for key in _KEYS if key not in ends]:
            hint = f'[{called}] low = …, high = …, unit = "{UNITS[name]}"'
            raise InvalidRobot(
                f"{where}: {called} lacks {', '.join(missing)}", expected="low, high and unit", hint=hint
            )
        low, high = (
            toml.number({"value": ends[key], "unit": ends["unit"]}, f"{called}.{key}", (UNITS[name],), where)
            for key in ("low", "high")
        )
        ranges[name] = (low, high)
    return Conditions(**ranges)
