"""How a sketch is wired, from what the kit says of its parts; what it does not say is assumed aloud."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from typing import Any

from upright.errors import SpecMismatch
from upright.robots import Kit, Robot
from upright.signals import SIDES

ASSUMED: dict[str, Any] = {"driver": "two-pin", "decoding": 4, "divider": 3.0}
"""Where the kit does not say: on its "back" pin also a driver with one direction pin works; makers count four edges."""
PIN_VOLTS, STEPS = 5.0, 1023
"""Data sheet of the ATmega328P: its converter's range at 5 V, in ten bits."""
CHARGED = 4.2 / 3.7
"""A full lithium cell over its nominal voltage."""


def sketch_wiring(kit: Kit, *, encoders: bool = True) -> dict[str, Any]:
    """What the template of a sketch must know of driver, encoders and battery, and what of it the kit does not say.

    `pulses` are those of either encoder's channel A in a turn of the wheel, none without `encoders`. Raises
    `SpecMismatch` for what would count wrongly or harm the board, `InvalidRobot` for pulses that contradict the
    encoder's step.
    """
    stated: dict[str, Any] = {"driver": kit.wiring.driver, "divider": kit.wiring.battery_divider}
    pulses = list[float]()
    if encoders:
        stated["decoding"] = _edges(kit)
        pulses = [math.tau / encoder_step(kit, f"sensor/encoder_{side}") for side in SIDES]
    used = {"decoding": 0} | {name: value or ASSUMED[name] for name, value in stated.items()}
    assumed = [name for name, value in stated.items() if not value]
    pulses = [count / used["decoding"] for count in pulses]
    return {**used, "pulses": pulses, "volts": kit.battery.voltage, "assumed": assumed}


def _edges(kit: Kit) -> int:
    """Edges that count for one pulse, the same of both encoders; 0 where the kit does not say."""
    left, right = (encoder_step(kit, f"sensor/encoder_{side}") for side in SIDES)
    edges = kit.wiring.edges(left, f"kit '{kit.name}': sensors.encoder_left")
    replace(kit.wiring, decoding=edges).edges(right, f"kit '{kit.name}': sensors.encoder_right")
    return edges


TICKS = 25_000
"""[1/s] interrupts in which steps are made: 640 cycles of an Uno's processor, of which they take a third."""
EVERY = 25  # ticks from one change of a motor's pace to the next, 1 ms


def sketch_steps(robot: Robot, kit: Kit) -> dict[str, Any]:
    """What the template of a sketch must know of two steppers; raises `SpecMismatch` for steps faster than it makes."""
    left, right = (encoder_step(kit, f"sensor/encoder_{side}") for side in SIDES)
    fastest = kit.motor.limit / min(left, right)
    if fastest > TICKS / 2:  # a pace has fifteen bits
        hint = "fewer microsteps, and so a larger quantum of the encoders, or a lower motor.limit"
        speed = f"{kit.motor.limit:g} rad/s are {fastest:.5g} steps a second"
        raise SpecMismatch(speed, expected=f"at most {TICKS // 2}", hint=hint)
    pace = [65536 / (step * TICKS) for step in (left, right)]
    more = min(robot.acceleration_limit * EVERY / TICKS * min(pace), 32767.0)
    return {"left": left, "ticks": TICKS, "every": EVERY, "pace": pace, "more": max(1, round(more))}


def wiring_table(sketch: str) -> str:
    """The pins that the text of a sketch names, what they go to and why, in lines of at most 80 columns."""
    part = sketch[sketch.index("/* Wiring") : sketch.index("\n*/\n#define")]
    return re.sub(r"#define \w+ |/\*\s| \*/", "", part).rstrip()


def encoder_step(kit: Kit, channel: str) -> float:
    """One count of that encoder [rad]; `SpecMismatch` where the kit does not say."""
    if channel in kit.sensors and kit.sensors[channel].quantum:
        return kit.sensors[channel].quantum
    name = channel.replace("sensor/", "sensors.")
    raise SpecMismatch(f"kit '{kit.name}' has no {name}.quantum", expected="radians of the wheel per count",
                       hint=f"[{name}.quantum] in the kit's file: 6.283185 / counts a turn")  # fmt: skip


def battery_divider(kit: Kit) -> float:
    """The battery's voltage over the pin's; `SpecMismatch` where a full battery is more than the pin stands."""
    divider = kit.wiring.battery_divider or ASSUMED["divider"]
    full = kit.battery.voltage * CHARGED
    if PIN_VOLTS * divider < full < math.inf:
        raise SpecMismatch(
            f"{full:.3g} V of a full battery are {full / divider:.2g} V behind a divider by {divider:g}",
            expected=f"at most {PIN_VOLTS:g} V on a pin", hint="[wiring.battery_divider] in the kit's file",
        )  # fmt: skip
    return divider
