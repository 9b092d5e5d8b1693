"""One log under one method: the models of both halves, and their uncertainty from repeated logs.

Every method is run again on simulated logs of the loop of the subspace model and the feedback law, whose pole is known.
The scatter of the estimates gives the method's 95 % intervals, their median its bias.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.calibration.calibration import Calibration
from upright.errors import InvalidLog, InvalidModel
from upright.identification.coordinates import growth_rate, physical
from upright.identification.joint import repeated
from upright.identification.order import OrderChoice, choose_order
from upright.identification.samples import Part, Samples
from upright.pages import Say
from upright.physics.linear import LinearModel

PartFit = Callable[[Part, "Study"], LinearModel]

NORMAL = 1.96  # deviations either side that hold 95 % of a normal distribution
QUARTILES = 1.349  # deviations of a normal distribution between its quartiles, which a few outliers do not move
MEDIAN_ERROR = 1.25  # standard error of a normal sample's median, over that of its mean
FEWEST = 8  # repetitions that must succeed before their scatter is called an interval


@dataclass(frozen=True)
class Pole:
    """The unstable pole [1/s] with its 95 % interval, NaN where there is none; `bias` of the method on such logs and
    the standard error of that bias. `how` says where the interval comes from. Dry friction counts as damping;
    `without_friction` is the pole without it, and its interval, where there is such friction and a method knows it."""

    value: float
    low: float = np.nan
    high: float = np.nan
    bias: float = np.nan
    bias_error: float = np.nan
    how: str = "none"
    without_friction: tuple[float, float, float] | None = None

    @property
    def within(self) -> float:
        """Half the interval, as a part of the value."""
        return 0.5 * (self.high - self.low) / self.value if self.value else np.nan

    @property
    def corrected(self) -> float:
        """The value less its bias."""
        return self.value - self.bias

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; unknown ones are null."""
        names = ("value", "low", "high", "within", "bias", "bias_error", "corrected")
        numbers = {name: getattr(self, name) for name in names}
        return {name: finite(value) for name, value in numbers.items()} | {
            "how": self.how, "friction": "counted as damping", "without_friction": self.without_friction
        }  # fmt: skip


@dataclass(frozen=True, eq=False)
class MethodFit:
    """A method's result: a model of each half, the unstable pole, and one standard deviation of each entry of A and B
    by half (empty where there is no interval)."""

    halves: Mapping[str, LinearModel]
    pole: Pole
    deviations: Mapping[str, tuple[Array, Array]] = field(default_factory=dict[str, tuple[Array, Array]])
    notes: tuple[Say, ...] = ()


@dataclass(frozen=True, eq=False)
class Study:
    """A log's `samples` with the `order` of pitch and wheels (None: by BIC), and `runs` repeated logs of a `seed`."""

    samples: Samples
    order: int | None = None
    runs: int = 40
    seed: int = 0

    @cached_property
    def orders(self) -> Mapping[str, OrderChoice]:
        """The order of each half."""
        asked = {"pitch": self.order}
        return {part.name: choose_order(part, asked.get(part.name)) for part in self.samples.training()}

    @cached_property
    def again(self) -> Mapping[str, list[Part]]:
        """The repeated logs of each half; none where model and law make no stable loop."""
        if self.runs < 1:
            return {}
        training = self.samples.training()
        drawn = {p.name: repeated(p, self.orders[p.name].model, self.runs, self.seed) for p in training}
        return {name: parts for name, parts in drawn.items() if parts is not None}

    @cached_property
    def calibration(self) -> Calibration:
        """The robot calibrated from the same log; raises `InvalidLog` or `DesignFailed` where there is none."""
        from upright.calibration.calibrate import calibrate

        data = self.samples
        if data.source != "sensors":
            raise InvalidLog("calibration reads sensors", expected="the source 'sensors'", hint="leave --states out")
        return calibrate(data.log, data.robot, data.kit, held_out=data.held_out)

    @property
    def known_pole(self) -> float:
        """The pole [1/s] of the model behind the repeated logs."""
        part = self.samples.parts[0]
        model = self.orders["pitch"].model
        return growth_rate(physical(part.name, model.plant))


def by_part(fit: PartFit, study: Study) -> MethodFit:
    """`fit` on both halves, and on the repeated logs."""
    halves = {part.name: fit(part, study) for part in study.samples.training()}
    several = {name: _repeated(fit, study, name) for name in halves}
    deviations = {
        name: (_spread([m.A for m in same]), _spread([m.B for m in same]))
        for name, model in halves.items()
        if len(same := [m for m in several[name] if m.states == model.states]) >= FEWEST
    }
    pole = _pole(halves["pitch"], [growth_rate(m) for m in several["pitch"]], study)
    runs = len(study.again.get("pitch", ()))
    models = len(several["pitch"])
    notes: list[Say] = []
    if study.runs and not runs:
        notes.append(Say("No interval: the subspace model and the log's feedback law make no stable loop to repeat."))
    elif runs and models < FEWEST:
        notes.append(Say("No interval: {n} repeated logs; at least {least} are needed.", n=models, least=FEWEST))
    elif models < 0.9 * runs:
        notes.append(Say("The method gave no model on {n} of {all} repeated logs.", n=runs - models, all=runs))
    return MethodFit(halves, pole, deviations, tuple(notes))


def _repeated(fit: PartFit, study: Study, name: str) -> list[LinearModel]:
    models: list[LinearModel] = []
    for part in study.again.get(name, ()):
        with suppress(InvalidModel, np.linalg.LinAlgError):
            models.append(fit(part, study))
    return models


def _spread(values: list[Array]) -> Array:
    """One deviation of each entry, from its quartiles."""
    low, high = np.percentile(np.array(values), [25, 75], axis=0)
    return np.asarray((high - low) / QUARTILES, dtype=np.float64)


def _pole(model: LinearModel, poles: list[float], study: Study) -> Pole:
    value = growth_rate(model)
    if len(poles) < FEWEST:
        return Pole(value)
    low, middle, high = (float(v) for v in np.percentile(poles, [25, 50, 75]))
    spread = (high - low) / QUARTILES
    error = MEDIAN_ERROR * spread / float(np.sqrt(len(poles)))
    how = f"scatter over {len(poles)} repeated logs with new innovations"
    return Pole(value, value - NORMAL * spread, value + NORMAL * spread, middle - study.known_pole, error, how)
