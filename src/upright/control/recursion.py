"""An observer at work in front of a method that is not linear."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.control.linear_controller import finite_matrix
from upright.control.observer import Observer

Array = NDArray[np.float64]

MATRICES = ("A", "By", "Bu", "Ba", "S", "Sy", "C", "Dy", "Dr")


@dataclass(eq=False, kw_only=True)
class Recursion:
    """z⁺ = A z + By y + Bu u + Ba a, x̂ = S z + Sy y (6,), outputs C z + Dy y + Dr r (o,).

    u is the command decided after the outputs and a the one applied. Raises `InvalidController` for matrices that do
    not fit each other.
    """

    A: Array
    By: Array
    Bu: Array
    Ba: Array
    S: Array
    Sy: Array
    C: Array
    Dy: Array
    Dr: Array

    def __post_init__(self) -> None:
        n, m, o = len(self.A), np.shape(self.By)[1], len(self.C)
        shapes = ((n, n), (n, m), (n, 2), (n, 2), (6, n), (6, m), (o, n), (o, m), (o, 6))
        for name, shape in zip(MATRICES, shapes, strict=True):
            setattr(self, name, finite_matrix(getattr(self, name), name, shape))
        self._stack()
        self.reset()

    def _stack(self) -> None:
        """One matrix from [p, x̂, outputs, u, a, y, r] to [p, x̂, outputs], with p = z − Bu u − Ba a.

        Both commands thus join at the next step. The product writes where the next step reads.
        """
        n, o = len(self.A), len(self.C)
        states, readings = np.vstack([self.A, self.S, self.C]), np.vstack([self.By, self.Sy, self.Dy])
        references, idle = np.vstack([np.zeros((n + 6, 6)), self.Dr]), np.zeros((n + 6 + o, 6 + o))
        stacked = np.hstack([states, idle, states @ self.Bu, states @ self.Ba, readings, references])
        self._dot = np.ascontiguousarray(stacked).dot
        self._memory = np.zeros((2, stacked.shape[1]))
        top = n + 6 + o
        first, second = self._memory
        self._turns = [
            (w, w[top + 4 : -6], w[-6:], other[:top], other[n + 6 : top], w[top : top + 4], w[n : n + 6])
            for w, other in ((first, second), (second, first))
        ]

    def reset(self) -> None:
        self._memory[:] = 0.0
        self._now, self._next = self._turns

    def step(self, measurement: Array, reference: Array) -> Array:
        """The outputs, in memory that is written again two steps later."""
        w, y, r, result, outputs, _, _ = self._now
        y[:] = measurement
        r[:] = reference
        self._dot(w, result)
        self._now, self._next = self._next, self._now
        return outputs

    def decided(self, left: float, right: float) -> None:
        """The command; it counts as applied until `applied` says otherwise."""
        commands = self._now[5]
        commands[0] = commands[2] = left
        commands[1] = commands[3] = right

    def applied(self, command: Sequence[float]) -> None:
        commands = self._now[5]
        commands[2], commands[3] = command

    def estimate(self) -> Sequence[float]:
        return self._now[6].tolist()

    def to_json(self) -> dict[str, Any]:
        return {name: getattr(self, name).tolist() for name in MATRICES}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> Recursion:
        """The inverse of `to_json`."""
        return cls(**{name: np.array(data[name], dtype=np.float64) for name in MATRICES})

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies are made anew: what a step writes to and reads from is one memory."""
        return _remade, ({name: getattr(self, name) for name in MATRICES},)


def _remade(matrices: dict[str, Array]) -> Recursion:
    return Recursion(**matrices)


def recursion(watch: Observer, G: Array, g: Array, H: Array) -> Recursion:
    """The recursion whose outputs are G ξ + g F + H r of the observer's state ξ and push F and the reference r."""
    C, Dy = G @ watch.X + np.outer(g, watch.f), G @ watch.Xy + np.outer(g, watch.fy)
    S, Sy = watch.X[:6], watch.Xy[:6]
    return Recursion(A=watch.A, By=watch.By, Bu=watch.Bu, Ba=watch.Ba, S=S, Sy=Sy, C=C, Dy=Dy, Dr=H)
