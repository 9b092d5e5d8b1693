"""What can be seen and done at the pins of a simulated Arduino Uno, and what can happen to its sensor."""

from __future__ import annotations

import struct

from upright.execution.execute_sketch import SketchExecutor

PRESENT, ABSENT, HUNG = range(3)
"""Conditions of the sensor (`shims/board.h`)."""

TIMERS = {3: (0xB0, 5, 0xB4), 5: (0x44, 5, 0x48), 6: (0x44, 7, 0x47), 9: (0x80, 7, 0x88), 10: (0x80, 5, 0x8A),
          11: (0xB0, 7, 0xB3)}  # fmt: skip
"""Pin with a timer → its control register, the bit that connects the pin, and the register of its duty."""

PORTS = ((8, 0x2B), (14, 0x25), (20, 0x28))
"""First pin of the next port, and the register with this one's levels."""

LED = 13


def run_for(executor: SketchExecutor, seconds: float) -> None:
    """Let that time [s] pass."""
    for _ in range(round(seconds * 1000)):
        executor.request("T", 16_000, answer=8)


def pwm(executor: SketchExecutor) -> list[float]:
    """What the driver gives both motors now, of 255, by the levels of its own inputs."""
    return [driven(executor, side) for side in ("LEFT", "RIGHT")]


def driven(executor: SketchExecutor, side: str) -> float:
    pins = executor.constants
    own = f"{side}_PWM"
    strength = duty(executor, pins[own if own in pins else "ENABLE"])
    back = duty(executor, pins[f"{side}_BACK"])
    forward = duty(executor, pins[f"{side}_FORWARD"]) if f"{side}_FORWARD" in pins else 255 - back
    return strength * (forward - back) / 255


def level(executor: SketchExecutor, pin: int) -> bool:
    """Whether an output is high."""
    first, register = next((end - (8 if end < 14 else 6), port) for end, port in PORTS if pin < end)
    return bool(executor.read(register, "B")[0] >> (pin - first) & 1)


def duty(executor: SketchExecutor, pin: int) -> float:
    if pin in TIMERS:
        control, bit, register = TIMERS[pin]
        if executor.read(control, "B")[0] >> bit & 1:
            return float(executor.read(register, "B")[0])
    return 255.0 * level(executor, pin)


def output(executor: SketchExecutor) -> list[str]:
    """The lines that came over the serial port."""
    (count,) = struct.unpack("<I", executor.request("S", answer=4))
    return executor.receive(count).decode("ascii", "replace").splitlines()
