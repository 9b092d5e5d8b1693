"""Units of columns: their factors to SI, and how other programs spell them."""

from __future__ import annotations

import math

UNITS: dict[str, tuple[float, str]] = {
    "": (1.0, ""), "1": (1.0, "1"), "%": (0.01, "1"), "s": (1.0, "s"), "ms": (1e-3, "s"), "us": (1e-6, "s"),
    "µs": (1e-6, "s"), "ns": (1e-9, "s"), "rad": (1.0, "rad"), "deg": (math.pi / 180, "rad"),
    "mdeg": (math.pi / 180e3, "rad"), "turn": (math.tau, "rad"), "mrad": (1e-3, "rad"), "rad/s": (1.0, "rad/s"),
    "deg/s": (math.pi / 180, "rad/s"), "mdeg/s": (math.pi / 180e3, "rad/s"), "mrad/s": (1e-3, "rad/s"),
    "rpm": (math.tau / 60, "rad/s"), "V": (1.0, "V"), "mV": (1e-3, "V"), "N m": (1.0, "N m"), "mN m": (1e-3, "N m"),
    "m/s²": (1.0, "m/s²"), "g": (9.80665, "m/s²"), "m": (1.0, "m"), "mm": (1e-3, "m"), "cm": (1e-2, "m"),
    "m/s": (1.0, "m/s"), "mm/s": (1e-3, "m/s"), "cm/s": (1e-2, "m/s"),
}  # fmt: skip
"""Unit of a column → (factor, SI unit)."""

ALIASES = {
    "°": "deg", "degrees": "deg", "degree": "deg", "°/s": "deg/s", "dps": "deg/s", "deg/sec": "deg/s", "degps": "deg/s",
    "degrees/s": "deg/s", "rad/sec": "rad/s", "radps": "rad/s", "radians": "rad", "sec": "s", "seconds": "s",
    "msec": "ms", "usec": "us", "volt": "V", "volts": "V", "v": "V", "mv": "mV", "nm": "N m",
    "n·m": "N m", "n*m": "N m",    "m/s^2": "m/s²", "m/s2": "m/s²", "percent": "%",
}  # fmt: skip
"""Other spellings of a unit."""


def unit_of(text: str) -> str:
    """A unit as the mappings write it, '' for what is none."""
    plain = text.strip().strip("[](){}").strip()
    return plain if plain in UNITS else ALIASES.get(plain, ALIASES.get(plain.lower(), ""))
