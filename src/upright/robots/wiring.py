"""How encoders, motor driver and battery are connected to a microcontroller, as far as a kit says it."""

from __future__ import annotations

import math
from dataclasses import dataclass

from upright.errors import InvalidRobot
from upright.robots.toml import quantity

DRIVERS = ("one-pin", "two-pin", "pwm-enable")
"""PWM and one direction pin a motor; PWM and two of them (TB6612, L298N); two PWM and an enable pin (BTS7960)."""
DECODINGS = (1, 2, 4)
"""Edges that count, of the four that two channels have in one pulse."""
ROUNDED = 0.005
"""Largest relative difference of a step from its counts a turn: it was written with three digits."""


@dataclass(frozen=True, kw_only=True)
class BoardWiring:
    """What a sketch must know of its parts; "" and 0 where the kit does not say.

    `pulses_per_turn` are those of one encoder channel in a turn of the wheel, of whose four edges `decoding` count.
    `battery_divider` is the battery's voltage over that at the pin.
    """

    driver: str = ""
    pulses_per_turn: float = quantity("1", 0.0, "pulses of one encoder channel in a turn of the wheel")
    decoding: float = quantity("1", 0.0, "edges that count, of the four of a pulse")
    battery_divider: float = quantity("1", 0.0, "the battery's voltage over that at the pin")

    def __post_init__(self) -> None:
        if self.driver not in ("", *DRIVERS):
            raise InvalidRobot(f"wiring.driver is '{self.driver}'", expected=" or ".join(DRIVERS))
        if self.decoding not in (0, *DECODINGS):
            raise InvalidRobot(f"wiring.decoding is {self.decoding:g}", expected="1, 2 or 4 edges of a pulse")
        if self.battery_divider and not 1 <= self.battery_divider < math.inf:
            raise InvalidRobot(f"wiring.battery_divider is {self.battery_divider:g}", expected="1 or more",
                               likely="its inverse: it is the battery's voltage over the pin's")  # fmt: skip

    def edges(self, quantum: float, name: str) -> int:
        """Edges of a pulse that count where one count is `quantum` [rad]; 0 where the wiring does not say.

        Raises `InvalidRobot`, with the `name` of the encoder, where pulses and decoding do not agree with it.
        """
        if not self.pulses_per_turn:
            return int(self.decoding)
        choices = (int(self.decoding),) if self.decoding else DECODINGS
        for edges in choices:
            if abs(edges * self.pulses_per_turn * quantum / math.tau - 1) <= ROUNDED:
                return edges
        right = " or ".join(f"{math.tau / (edges * self.pulses_per_turn):.6g} (x{edges})" for edges in choices)
        raise InvalidRobot(f"{name}.quantum is {quantum:g} rad", expected=f"{right} of {self.pulses_per_turn:g} pulses",
                           hint="mend the quantum or [wiring]")  # fmt: skip
