"""A linear model from a log: both halves as one `LinearModel`, how sure it is, and how it reads the sensors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.atomic import finite
from upright.identify.coordinates import PHYSICAL, PartModel
from upright.identify.order import Order
from upright.identify.study import Pole
from upright.physics.linear import INPUTS, LinearModel
from upright.signals import STATE_NAMES
from upright.tables import Shown

Array = NDArray[np.float64]

SHARES = {"pitch": (0.5, 0.5), "yaw": (-0.5, 0.5)}
"""How left and right make up the command of a half: their mean, and half their difference."""


@dataclass(frozen=True, eq=False, repr=False)
class Identified(Shown):
    """`model` x⁺ = A x + B u of one log by one `method`, with one standard deviation of each entry in `a_deviation` and
    `b_deviation` (NaN where there is none).

    Its states are the robot's, in the order of conventions, then what else the method found. They stand in the robot's
    own time: an output reads them `late` periods after the command. `fits` [%] are those of `foretell`.
    """

    method: str
    model: LinearModel
    a_deviation: Array
    b_deviation: Array
    pole: Pole
    late: Mapping[str, int]
    orders: Mapping[str, Order]
    source: str
    samples: int
    parts: tuple[PartModel, ...]
    fits: Mapping[str, Mapping[str, float]]
    notes: tuple[str, ...] = ()

    def check(self) -> float:
        """Largest difference of an eigenvalue of the whole from those of its halves, zero but for rounding."""
        whole = np.sort(np.abs(np.linalg.eigvals(self.model.A)))
        halves = np.sort(np.abs(np.concatenate([np.linalg.eigvals(part.A) for part in self.parts])))
        return float(np.abs(whole - halves).max())

    def save(self, path: str | Path) -> Path:
        """Write as JSON: a file of a linear model, with what else is known of it."""
        from upright.atomic import write_json

        return write_json(Path(path), self.to_json())

    def to_json(self) -> dict[str, Any]:
        """The model as `LinearModel.from_json` reads it, and beside it method, pole, lateness, orders and fits."""
        deviations = {"A": _plain(self.a_deviation), "B": _plain(self.b_deviation)}
        fits = {h: {n: finite(v) for n, v in row.items()} for h, row in self.fits.items()}
        return {
            **self.model.to_json(), "method": self.method, "source": self.source, "samples": self.samples,
            "unstable_pole": self.pole.to_json(), "deviations": deviations, "late": dict(self.late),
            "orders": {name: order.to_json() for name, order in self.orders.items()}, "fits": fits,
            "notes": list(self.notes),
        }  # fmt: skip

    def __str__(self) -> str:
        p = self.pole
        lines = [
            f"{self.method} from {self.samples} samples of {self.source}: unstable pole {p.value:.3g} 1/s {interval(p)}"
        ]
        if np.isfinite(p.bias):
            lines.append(f"bias on such logs {p.bias:+.2g} ± {2 * p.bias_error:.1g} 1/s")
        return "\n".join([*lines, *self.notes])


def interval(pole: Pole) -> str:
    """The 95 % interval in words."""
    return f"({pole.low:.3g} to {pole.high:.3g})" if np.isfinite(pole.low) else "(no interval)"


def assembled(
    parts: Sequence[PartModel], deviations: Mapping[str, tuple[Array, Array]]
) -> tuple[LinearModel, Array, Array]:
    """Both halves as one model of left and right command, and the deviations of its A and B."""
    known = [name for name in STATE_NAMES if any(name in part.states for part in parts)]
    extra = [name for part in parts for name in part.states if name not in known]
    names = [*known, *extra]
    A, B = np.zeros((len(names),) * 2), np.zeros((len(names), 2))
    dA, dB = np.full_like(A, np.nan), np.full_like(B, np.nan)
    for part in parts:
        at = [names.index(name) for name in part.states]
        A[np.ix_(at, at)], B[at] = part.A, np.outer(part.b, SHARES[part.name])
        if part.name in deviations:
            spread, enters = deviations[part.name]
            dA[np.ix_(at, at)], dB[at] = spread, np.outer(enters, np.abs(SHARES[part.name]))
    model = LinearModel(A, B, dt=parts[0].dt, states=tuple(names), inputs=INPUTS)
    for array in (dA, dB):
        array.setflags(write=False)
    return model, dA, dB


def reading(name: str, part: PartModel) -> Array:
    """How an output reads the half's states (states,): "wheel" is relative to the body."""
    row = np.zeros(len(part.states))
    at = {state: i for i, state in enumerate(part.states)}
    if name in at and name != "wheel":
        row[at[name]] = 1.0
    elif name == "gyro":
        row[at["pitch_rate"]] = 1.0
    elif name == "turn":
        row[at["yaw"]] = 1.0
    else:
        row[at["wheel"]], row[at["pitch"]] = 1.0, -1.0
    return row


def physical_names(parts: Sequence[PartModel]) -> tuple[str, ...]:
    """The robot's states that the halves hold."""
    return tuple(name for part in parts for name in PHYSICAL[part.name])


def _plain(values: Array) -> list[list[float | None]]:
    return [[finite(v) for v in row] for row in values.tolist()]
