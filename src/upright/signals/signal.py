"""What a number is called, what it is measured in, and which letter the textbook gives it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Signal:
    """A named scalar in time: path-like `name`, SI `unit`, textbook `symbol`."""

    name: str
    unit: str
    symbol: str = ""


STATE = (
    Signal("pitch", "rad", "ψ"),
    Signal("pitch_rate", "rad/s", "ψ̇"),
    Signal("wheel", "rad", "θ"),
    Signal("wheel_rate", "rad/s", "θ̇"),
    Signal("yaw", "rad", "φ"),
    Signal("yaw_rate", "rad/s", "φ̇"),
)
"""The state of every model here, in the order of Herrera et al. (2015), eq. (17)."""

STATE_NAMES = tuple(signal.name for signal in STATE)
TRUE_STATE = tuple(f"truth/{name}" for name in STATE_NAMES)
"""The true state, which no real robot offers."""

SENSORS = (
    Signal("sensor/encoder_left", "rad", "θ_l − ψ"),
    Signal("sensor/encoder_right", "rad", "θ_r − ψ"),
    Signal("sensor/gyro", "rad/s", "ψ̇"),
    Signal("sensor/compass", "rad", "φ"),
    Signal("sensor/accel_forward", "m/s²", "f_x"),
    Signal("sensor/accel_up", "m/s²", "f_z"),
    Signal("sensor/battery", "V", "V_b"),
)
"""What a kit can measure, in our signs: positive forward, heading anticlockwise from above."""

FUSED = (Signal("sensor/pitch", "rad", "ψ"),)
"""What a chip, or a filter beside the controller, makes of gyro and accelerometer. No body offers it: a kit does."""


def _prefixed(prefix: str) -> tuple[Signal, ...]:
    return tuple(Signal(f"{prefix}/{s.name}", s.unit, s.symbol) for s in STATE)


TRUTH = _prefixed("truth")
ESTIMATE = _prefixed("estimate")
REFERENCE = _prefixed("reference")


SIDES = ("left", "right")


def command_signals(unit: str) -> tuple[Signal, ...]:
    """The two commands asked for and the two really applied, in the drive's `unit` (V or N m)."""
    return tuple(
        Signal(f"{prefix}/{side}", unit, f"u_{side[0]}") for prefix in ("command", "applied") for side in SIDES
    )


PUSH = (
    Signal("push/force", "N", "F"),
    Signal("push/height", "m", "h"),
    Signal("push/slope", "rad", "γ"),
)

RATES = (
    Signal("sensor/encoder_rate_left", "rad/s", "θ̇_l − ψ̇"),
    Signal("sensor/encoder_rate_right", "rad/s", "θ̇_r − ψ̇"),
)
"""What robots log that know only their wheels' speeds."""

KNOWN = {s.name: s for s in (*RATES, *TRUTH, *ESTIMATE, *REFERENCE, *SENSORS, *FUSED, *command_signals("V"), *PUSH)}
"""Every channel name this package writes, with its usual unit."""
