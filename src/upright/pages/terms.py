"""Names of parameters and sensors in words of the field."""

from __future__ import annotations

import re

from upright.pages.words import Say

SPOKEN = {
    "com_height": "centre of mass height", "asymmetry": "motor asymmetry", "constant_command": "command offset",
    "coulomb_friction": "Coulomb friction", "weight_moment/a22": "weight moment/a22",
}  # fmt: skip
"""Names of numbers that need other words, for readers."""


def term(name: str) -> Say:
    """The name of a parameter, as of a file: "com_height" is centre of mass height."""
    return Say(_spoken(name))


def channel(name: str) -> Say:
    """A sensor's channel: "sensor/encoder_left" is encoder left."""
    return Say(short(name))


def short(channel: str) -> str:
    """`sensor/encoder_left` as `encoder left`."""
    return channel.removeprefix("sensor/").removeprefix("estimate/").replace("_", " ")


def _spoken(name: str) -> str:
    """The name of a parameter in words: "com_height" as centre of mass height, "delay/gyro" as gyro delay."""
    if name in SPOKEN:
        return SPOKEN[name]
    match = re.fullmatch(r"(?:[a-z_]+\.)*([a-z_]+)(?:/(.+))?", name)
    if not match:
        return name.replace("_", " ")
    kind = match[1]
    of = (match[2] or "").replace("_", " ")
    return f"{of} {kind}" if of else SPOKEN.get(kind, kind.replace("_", " "))
