"""What may be added to a command: multisines by bands, random binary dithers and moves, driving or turning.

A signal is an array (rows, 2), left and right, each row held for several periods; its size means nothing yet. To a
controller that keeps its place, an added constant command is a reference position, so that a slow one drives or turns
the robot: a move needs no other channel than a dither.
"""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise
from typing import Any

import numpy as np

from upright.arrays import Array

COMMON = np.array([1.0, 1.0])
TURNING = np.array([-1.0, 1.0])
MODES = {"driving": COMMON, "turning": TURNING}

BANDS = (0.05, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Edges [Hz]: an octave each where the robot's own motion lies, less fine below."""

HELD = (0.02, 0.04, 0.08, 0.16)  # [s] for which a value of a random binary dither is held
EASE = 0.5  # [s] in which a signal grows from nothing, and a move goes over into the next
PHASES = 32
"""Draws of phases of which a multisine takes the one with the lowest peak for its power: 1.9 of 3 typically."""


def signals(rows: int, step: float, seed: int) -> dict[str, dict[str, Array]]:
    """Every signal by name, of unit mean square, for each way of exciting: `rows` values, each held for `step` [s]."""
    multisine: dict[str, Array] = {}
    dither: dict[str, Array] = {}
    moves: dict[str, Array] = {}
    rng = np.random.Generator(np.random.Philox(seed))
    for mode, sides in MODES.items():
        for low, high in pairwise(BANDS):
            wave = band(rows, step, low, high, rng)
            if wave.any():
                multisine[f"{mode} {low:g} to {high:g} Hz"] = unit(wave, step)[:, None] * sides
        for held in HELD:
            length = max(1, round(held / step))
            drawn = rng.integers(0, 2, -(-rows // length)) * 2.0 - 1.0
            wave: Array = np.repeat(drawn, length)[:rows].astype(np.float64)
            dither[f"{mode} binary, {1e3 * length * step:g} ms"] = unit(wave, step)[:, None] * sides
    for cycles in (1, 2, 4):
        moves[f"drive out and back, {cycles} times"] = unit(out_and_back(rows, step, cycles), step)[:, None] * COMMON
        moves[f"turn left and right, {cycles} times"] = unit(there_and_back(rows, cycles), step)[:, None] * TURNING
    return {"multisine": multisine, "random binary dither": dither, "drive and turn": moves}


def unit(wave: Array, step: float) -> Array:
    """`wave` (rows,), eased in, with a mean square of one."""
    eased = wave * np.minimum(1.0, np.arange(1, len(wave) + 1) * step / EASE)
    return eased / np.sqrt(np.mean(eased**2))


def band(rows: int, step: float, low: float, high: float, rng: np.random.Generator) -> Array:
    """Equal sines (rows,) of all whole numbers of periods in the run from `low` to before `high` [Hz], with the phases
    of the lowest peak among `PHASES` draws; zeros where the rows cannot carry that band."""
    top = min(high, 0.8 / (2 * step))  # a held value carries little beyond
    first, last = int(np.ceil(low * rows * step - 1e-9)), int(np.ceil(top * rows * step - 1e-9))
    lines = np.zeros((PHASES, rows // 2 + 1), dtype=np.complex128)
    count = max(0, last - max(first, 1))
    lines[:, max(first, 1) : max(first, 1) + count] = np.exp(2j * np.pi * rng.random((PHASES, count)))
    waves: Any = np.fft.irfft(lines, rows, axis=1)
    return waves[np.argmin(np.abs(waves).max(axis=1))]


def out_and_back(rows: int, step: float, cycles: int) -> Array:
    """A place (rows,) that is left and come back to, forward first, then behind, with smooth ways between."""
    phase = np.arange(rows) / rows * cycles % 1.0
    corners = np.where(phase < 0.5, 1.0, -1.0)
    width = max(1, round(min(2 * EASE, rows * step / cycles / 4) / step))
    window = np.hanning(width + 2)[1:-1]
    padded = np.concatenate([np.zeros(width), corners])
    smooth: Any = np.convolve(padded, window / window.sum())
    return smooth[width : width + rows]


def there_and_back(rows: int, cycles: int) -> Array:
    """A heading (rows,) that grows and falls at a constant rate: a triangle, so that the robot spins both ways."""
    phase = np.arange(rows) / rows * cycles % 1.0
    return 1.0 - 4.0 * np.abs((phase + 0.25) % 1.0 - 0.5)


def mixture(parts: Mapping[str, Array], division: Mapping[str, float]) -> Array:
    """Σ √fraction · part (rows, 2)."""
    total = np.zeros_like(next(iter(parts.values())))
    for name, fraction in division.items():
        total = total + np.sqrt(fraction) * parts[name]
    return total
