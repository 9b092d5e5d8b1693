"""A linear model from a log: both halves as one `LinearModel`, how sure it is, and how it reads the sensors."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.identification.coordinates import COMMANDS
from upright.identification.order import OrderChoice
from upright.identification.study import Pole
from upright.pages import Fold, Items, KeyNumber, Next, Page, Picture, Quantity, Result, Say, Verdict, english
from upright.physics.linear import INPUTS, LinearModel
from upright.signals import STATE_NAMES

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Identified(Result):
    """`model` x⁺ = A x + B u of one log by one `method`, with one standard deviation of each entry in `a_deviation` and
    `b_deviation` (NaN where there is none).

    Its states are the robot's, in the order of conventions, then what else the method estimates. They stand in the
    robot's own time: an output reads them `delays` periods after the command. `halves` are the models of pitch and yaw,
    `fits` [%] those of `prediction_fits`, `log` is the file.
    """

    method: str
    model: LinearModel
    a_deviation: Array
    b_deviation: Array
    pole: Pole
    delays: Mapping[str, int]
    orders: Mapping[str, OrderChoice]
    source: str
    samples: int
    halves: Mapping[str, LinearModel]
    fits: Mapping[str, Mapping[str, float]]
    notes: tuple[Say, ...] = ()
    log: str = "LOG"

    def check(self) -> float:
        """Largest difference of an eigenvalue of the whole from those of its halves, zero but for rounding."""
        whole = np.sort(np.abs(np.linalg.eigvals(self.model.A)))
        halves = np.sort(np.abs(np.concatenate([half.poles() for half in self.halves.values()])))
        return float(np.abs(whole - halves).max())

    def save(self, path: str | Path) -> Path:
        """Write as JSON: a file of a linear model, with what else is known of it."""
        from upright.atomic import write_json

        return write_json(Path(path), self.to_json())

    def to_json(self) -> dict[str, Any]:
        """The model as `LinearModel.from_json` reads it, and beside it method, pole, delays, orders and fits."""
        deviations = {"A": _plain(self.a_deviation), "B": _plain(self.b_deviation)}
        fits = {h: {n: finite(v) for n, v in row.items()} for h, row in self.fits.items()}
        return {
            **self.model.to_json(), "schema": "upright/identify/1",
            "method": self.method, "source": self.source, "samples": self.samples,
            "unstable_pole": self.pole.to_json(), "deviations": deviations, "delays": dict(self.delays),
            "orders": {name: order.to_json() for name, order in self.orders.items()}, "fits": fits,
            "notes": [english(note) for note in self.notes],
        }  # fmt: skip

    def plot(self) -> Figure:
        """The skill of predictions of each output on the held-out part, over their horizon on a logarithmic axis."""
        from upright.plotting import legend, line, panels

        figure, (ax,) = panels([str(Say("skill [%]"))], str(Say("samples predicted ahead")), "log")
        ahead = [float(h) for h in self.fits]
        for name in next(iter(self.fits.values()), {}):
            line(ax, str(OUTPUTS[name]), ahead, [fit.get(name, np.nan) for fit in self.fits.values()])
        return legend(figure)

    def page(self) -> Page:
        """The model for people."""
        verdict = Verdict(Say("not yet tried in a loop"))
        if np.isfinite(self.pole.low):
            verdict = Verdict(Say("pole known to ±{part}", part=Quantity(self.pole.within, "fraction", digits=2)))
        title = Say("By {method}, a lean doubles in {time}", method=self.method, time=doubling(self.pole))
        if self.pole.value <= 0:
            verdict = Verdict(Say("wrong: a stable model"), "bad")
            title = Say("By {method} the robot does not fall", method=self.method)
        lead = [
            Say("A regulator of this model may still fall: none was tried."),
            Say("Dry friction is counted as damping."),
        ]
        if self.pole.without_friction:
            value, low, high = self.pole.without_friction
            free = Quantity(value, "1/s", low=low, high=high)
            lead[1] = Say("Dry friction is counted as damping; without it, the unstable pole is {pole}.", pole=free)
        meaning = Say("unstable pole, with its 95 % interval")
        if not np.isfinite(self.pole.low):
            meaning = Say("unstable pole; its interval needs more repeated logs")
        numbers = [KeyNumber(known_pole(self.pole), meaning)]
        if np.isfinite(self.pole.bias):
            numbers.append(
                KeyNumber(known_bias(self.pole), Say("error of the method on simulated logs whose pole is known"))
            )
        folds: list[Fold] = []
        if self.notes:
            folds.append(Fold(Say("Notes"), [Items(self.notes)]))
        why = Say("It compares the methods, and tries a regulator of each model.")
        return Page(
            title, verdict=verdict, lead=lead, numbers=numbers,
            picture=Picture(Say("How well it predicts the part of the log that was not fitted"), self.plot, SKILL),
            next=[Next("identify", self.log, method="all", why=why)], blocks=folds,
            origin={"log": self.log, "method": self.method},
        )  # fmt: skip


SKILL = Say("100 %: the prediction is exact. 0 %: to predict no motion would be as good.")
OUTPUTS = {"gyro": Say("gyro"), "wheel": Say("wheels"), "turn": Say("turn"), "pitch": Say("pitch"),
           "pitch_rate": Say("pitch rate"), "wheel_rate": Say("wheel rate"), "yaw": Say("yaw"),
           "yaw_rate": Say("yaw rate")}  # fmt: skip
"""What a model predicts, in words."""


def known_pole(pole: Pole, unit: str = "1/s") -> Quantity:
    """The pole with its interval, where there is one."""
    if not np.isfinite(pole.low):
        return Quantity(pole.value, unit)
    return Quantity(pole.value, unit, low=pole.low, high=pole.high)


def known_bias(pole: Pole) -> Quantity:
    """The bias with its interval of two standard errors."""
    return Quantity(
        pole.bias, "1/s", low=pole.bias - 2 * pole.bias_error, high=pole.bias + 2 * pole.bias_error, digits=2
    )


def doubling(pole: Pole) -> Quantity:
    """The time in which a lean doubles."""
    return Quantity(math.log(2) / pole.value if pole.value > 0 else math.inf, "s", digits=2)


def assembled(
    halves: Mapping[str, LinearModel], deviations: Mapping[str, tuple[Array, Array]]
) -> tuple[LinearModel, Array, Array]:
    """Both halves as one model of left and right command, and the deviations of its A and B."""
    states = [name for half in halves.values() for name in half.states]
    names = sorted(states, key=lambda name: STATE_NAMES.index(name) if name in STATE_NAMES else len(STATE_NAMES))
    A = np.zeros((len(names),) * 2)
    B = np.zeros((len(names), 2))
    dA, dB = np.full_like(A, np.nan), np.full_like(B, np.nan)
    for half, model in halves.items():
        at = [names.index(name) for name in model.states]
        sides = np.array([COMMANDS[half]])
        A[np.ix_(at, at)], B[at] = model.A, model.B @ sides
        if half in deviations:
            spread, enters = deviations[half]
            dA[np.ix_(at, at)], dB[at] = spread, enters @ np.abs(sides)
    for array in (dA, dB):
        array.setflags(write=False)
    dt = next(iter(halves.values())).dt
    return LinearModel(A, B, dt=dt, states=tuple(names), inputs=INPUTS), dA, dB


def reading(output: str, states: Sequence[str], *, known: bool = False) -> Array:
    """How an output reads a half's `states` (states,), which are `known` where they are the outputs themselves;
    otherwise "wheel" is relative to the body."""
    row = np.zeros(len(states))
    if output in states and (known or output != "wheel"):
        row[states.index(output)] = 1.0
    elif output in ("gyro", "turn"):
        row[states.index({"gyro": "pitch_rate", "turn": "yaw"}[output])] = 1.0
    else:
        row[states.index("wheel")], row[states.index("pitch")] = 1.0, -1.0
    return row


def _plain(values: Array) -> list[list[float | None]]:
    return [[finite(v) for v in row] for row in values.tolist()]
