"""Any controller with a stored excitation added to its command: how an unstable robot is identified."""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.control.controller import Controller
from upright.errors import InvalidController


class Excited:
    """`controller` plus `excitation` (n, 2) [command unit], one row a period, zero after its end."""

    def __init__(self, controller: Controller, excitation: ArrayLike) -> None:
        sequence = np.array(excitation, dtype=np.float64)
        if sequence.ndim != 2 or sequence.shape[1] != 2 or not np.isfinite(sequence).all():
            raise InvalidController(f"an excitation of shape {sequence.shape}", expected="finite numbers (n, 2)")
        self.controller = controller
        self.excitation = sequence
        self._row = 0
        self.spec = replace(controller.spec, kind=f"{controller.spec.kind}+excitation")

    def reset(self) -> None:
        self.controller.reset()
        self._row = 0

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        left, right = self.controller.step(measurement, reference)
        extra = self.excitation[self._row] if self._row < len(self.excitation) else (0.0, 0.0)
        self._row += 1
        return left + float(extra[0]), right + float(extra[1])

    def estimate(self) -> Sequence[float]:
        return self.controller.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.controller.applied(command)

    def to_json(self) -> dict[str, Any]:
        stored = hashlib.sha256(self.excitation.tobytes()).hexdigest()
        return {**self.controller.to_json(), "kind": self.spec.kind, "excitation": stored}


def random_binary(count: int, amplitude: float, seed: int, hold: int = 1) -> Array:
    """±`amplitude` (count, 2), drawn anew every `hold` periods, independently for both motors (PRBS)."""
    rng = np.random.Generator(np.random.Philox(seed))
    signs = rng.integers(0, 2, size=(-(-count // hold), 2)).astype(np.float64) * 2.0 - 1.0
    held: Array = np.repeat(signs, hold, axis=0)[:count]
    return held * amplitude
