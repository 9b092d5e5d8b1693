"""A number as an owner writes it: "65 mm", "6,5 cm", "1:48", "±250 °/s"."""

from __future__ import annotations

import math
import re

from upright.errors import InvalidRobot
from upright.signals.units import ALIASES, UNITS

G = 9.81  # [m/s²], with which scales and motors' data sheets make kilograms of newtons
RATIO = ":1"
"""The unit of a gear or a divider, which may be written from either end: 48:1 is 1:48."""

_OWNERS: dict[str, tuple[float, str]] = {
    "g": (1e-3, "kg"),
    "kg": (1.0, "kg"),
    "oz": (0.02835, "kg"),
    "lb": (0.4536, "kg"),
    "in": (0.0254, "m"),
    "A": (1.0, "A"),
    "mA": (1e-3, "A"),
    "kg cm": (G / 100, "N m"),
    "N cm": (1e-2, "N m"),
    "oz in": (7.062e-3, "N m"),
    "rad/s²": (1.0, "rad/s²"),
}
"""Unit of scales, rulers and data sheets that no log has → (factor, SI unit). "g" is also an acceleration's."""
_SPELLINGS = ALIASES | {
    '"': "in",
    "inch": "in",
    "inches": "in",
    "gram": "g",
    "grams": "g",
    "amp": "A",
    "kgf cm": "kg cm",
    "rad/s^2": "rad/s²",
    "rad/s2": "rad/s²",
}
_NUMBER = re.compile(r"([+-]?(?:\d+[.,]?\d*|[.,]\d+)(?:e[+-]?\d+)?)\s*(.*)", re.IGNORECASE)
_THOUSANDS = re.compile(r"[+-]?[1-9]\d{0,2},\d{3}")


def units_like(unit: str, quantity: str) -> dict[str, float]:
    """Every unit of the physical `quantity`, named by its SI unit, as a multiple of `unit`; that one first."""
    alike = {name: factor for name, (factor, si) in (*UNITS.items(), *_OWNERS.items()) if si == quantity}
    own = alike.get(unit, 1.0)
    return {unit: 1.0} | {name: factor / own for name, factor in alike.items()}


def number_of(text: str, unit: str, quantity: str) -> tuple[float, str]:
    """The number in a `text`, as it stands there, and the unit behind it; `unit` where there is none.

    A decimal may be a comma. Raises `InvalidRobot` for what is no number, and for a unit of something else.
    """
    plain = text.strip().lstrip("±").replace("−", "-")
    if unit == RATIO:
        plain = _from_one(plain)
    alike = units_like(unit, quantity)
    spelled = {_folded(name): name for name in alike}
    spelled |= {_folded(other): name for other, name in _SPELLINGS.items() if name in alike}
    match = _NUMBER.fullmatch(plain)
    written, behind = match.groups() if match else ("", "")
    words = f"'{text.strip()[:40]}'"
    if _THOUSANDS.fullmatch(written):
        joined = written.replace(",", "")
        raise InvalidRobot(words, expected=f"{joined}, or {written.replace(',', '.')}", likely="thousands by a comma")
    if not written or (behind and _folded(behind) not in spelled):
        inside = ", such as 48 or 48:1" if unit == RATIO else f" in {', '.join(alike)}" if quantity else ""
        raise InvalidRobot(words, expected=f"a number{inside}")
    return float(written.replace(",", ".")), spelled[_folded(behind)] if behind else unit


def meant_unit(number: float, unit: str, quantity: str, least: float, most: float) -> str:
    """The `number` with the unit in which it lies from `least` to `most` of `unit`, where there is one.

    Of several it is the one nearest to the middle of the range, in decades.
    """
    middle = math.sqrt(max(least, most * 1e-4) * most)
    fitting = {
        name: abs(math.log(number * factor / middle))
        for name, factor in units_like(unit, quantity).items()
        if number > 0 and least <= number * factor <= most
    }
    return f"{number:g} {min(fitting, key=lambda name: fitting[name])}" if fitting else ""


def _from_one(text: str) -> str:
    """The other number of a ratio in which one of both is 1; the text itself where it is none."""
    ends = [end.strip() for end in re.split("[:/]", text)]
    if len(ends) == 2 and "1" in ends:
        ends.remove("1")
        return ends[0]
    return text


def _folded(unit: str) -> str:
    """A unit without what people write differently: case, spaces and signs of multiplication."""
    return re.sub(r"[\s·*.-]", "", unit.lower())
