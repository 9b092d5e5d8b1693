"""Where a loop can be opened, in words."""

from __future__ import annotations

import math

from upright.pages import Quantity, Say

PLACES = {
    "both motors": Say("both motors"), "left motor": Say("the left motor"), "right motor": Say("the right motor"),
    "steering": Say("the steering"), "encoder left": Say("the left encoder"),
    "encoder right": Say("the right encoder"), "encoder_left": Say("the left encoder"),
    "encoder_right": Say("the right encoder"), "encoder rate left": Say("the left wheel's rate"),
    "encoder rate right": Say("the right wheel's rate"), "gyro": Say("the gyro"), "compass": Say("the compass"),
    "accel forward": Say("the forward accelerometer"), "accel up": Say("the upward accelerometer"),
    "pitch": Say("the angle sensor"),
}  # fmt: skip


def delay_of(seconds: float) -> Quantity:
    """A delay that a loop bears, to a tenth of a millisecond, never more than there is."""
    return Quantity(math.floor(1e4 * seconds) / 1e4 if math.isfinite(seconds) else seconds, "s")


def place_of(channel: str) -> Say:
    """A motor or a sensor by its name; older designs, which were examined at both motors only, have none."""
    return PLACES.get(channel or "both motors") or Say("{name}", name=channel)
