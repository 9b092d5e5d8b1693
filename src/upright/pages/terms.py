"""Names of parameters and sensors in words of the field."""

from __future__ import annotations

from upright.pages.words import Say
from upright.tables import short, spoken


def term(name: str) -> Say:
    """The name of a parameter, as of a file: "com_height" is centre of mass height."""
    return Say(spoken(name))


def channel(name: str) -> Say:
    """A sensor's channel: "sensor/encoder_left" is encoder left."""
    return Say(short(name))
