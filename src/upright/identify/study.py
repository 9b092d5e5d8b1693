"""One log under one method: the models of both halves, and how sure they are, from logs that might have been.

Every method is run again on logs of the loop of the subspace model and the law, whose pole is known because it was put
in. The scatter of what the method says of them gives its 95 % intervals, the mean its bias.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.calibration import Calibration
from upright.errors import InvalidLog, InvalidModel
from upright.identify.coordinates import PartModel, physical
from upright.identify.joint import might_have_been
from upright.identify.order import Order, choose_order
from upright.identify.samples import Part, Samples

Array = NDArray[np.float64]
Progress = Callable[[float], None]
PartFit = Callable[[Part, "Study"], PartModel]

NORMAL = 1.96  # deviations that hold 95 % of a normal distribution
QUARTILES = 1.349  # deviations of a normal distribution between its quartiles, which a few wild repetitions do not move
FEWEST = 8
"""Repetitions that must succeed before their scatter is called an interval."""


@dataclass(frozen=True)
class Pole:
    """The unstable pole [1/s] with its 95 % interval, NaN where there is none; `bias` of the method on such logs and
    the standard error of that bias. `how` says where the interval comes from."""

    value: float
    low: float
    high: float
    bias: float
    bias_error: float
    how: str

    @property
    def corrected(self) -> float:
        """The value less its bias."""
        return self.value - self.bias

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; what is not known is null."""
        numbers = {name: getattr(self, name) for name in ("value", "low", "high", "bias", "bias_error", "corrected")}
        return {**{n: float(v) if np.isfinite(v) else None for n, v in numbers.items()}, "how": self.how}


@dataclass(frozen=True, eq=False)
class Fit:
    """What a method says: a model of each half, the unstable pole, and one standard deviation of each entry of A and b
    by half (empty where there is no interval)."""

    parts: tuple[PartModel, ...]
    pole: Pole
    deviations: Mapping[str, tuple[Array, Array]] = field(default_factory=dict[str, tuple[Array, Array]])
    notes: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Study:
    """A log's `samples` with the order of each half, and `runs` logs that might have been, drawn from `seed`."""

    samples: Samples
    order: int | None = None
    runs: int = 40
    seed: int = 0

    @cached_property
    def orders(self) -> Mapping[str, Order]:
        """The order of each half; the one asked for is that of the pitch half."""
        asked = {"pitch": self.order}
        return {part.name: choose_order(part, asked.get(part.name)) for part in self.samples.training()}

    @cached_property
    def again(self) -> Mapping[str, list[Part]]:
        """For each half the logs that might have been; none where model and law make no stable loop."""
        if self.runs < 1:
            return {}
        training = self.samples.training()
        drawn = {p.name: might_have_been(p, self.orders[p.name].model, self.runs, self.seed) for p in training}
        return {name: parts for name, parts in drawn.items() if parts is not None}

    @cached_property
    def calibration(self) -> Calibration:
        """The robot calibrated from the same log; raises `InvalidLog` or `DesignFailed` where there is none."""
        from upright.calibrate.calibrate import calibrate

        data = self.samples
        if data.source != "sensors":
            raise InvalidLog("calibration reads sensors", expected="the source 'sensors'", hint="leave --states out")
        return calibrate(data.log, data.robot, data.kit, held_out=data.held_out)

    @property
    def known_pole(self) -> float:
        """The pole [1/s] of the model behind those logs."""
        part, model = self.samples.parts[0], self.orders["pitch"].model
        return physical(part.name, part.outputs, model.A, model.b, model.C, part.dt).pole


def by_part(fit: PartFit, study: Study) -> Fit:
    """`fit` on both halves, and on the logs that might have been."""
    training = study.samples.training()
    models = tuple(fit(part, study) for part in training)
    repeated = {part.name: _repeated(fit, study, part.name) for part in training}
    deviations = {
        model.name: (_spread([m.A for m in same]), _spread([m.b for m in same]))
        for model in models
        if len(same := [m for m in repeated[model.name] if m.states == model.states]) >= FEWEST
    }
    pole = _pole(models[0], [m.pole for m in repeated["pitch"]], study)
    tried = len(study.again.get("pitch", ()))
    notes: list[str] = []
    if study.runs and not tried:
        notes.append("No interval: the subspace model and the law of the log make no stable loop to repeat.")
    elif len(repeated["pitch"]) < 0.9 * tried:
        notes.append(f"On {tried - len(repeated['pitch'])} of {tried} repeated logs the method gave no model.")
    return Fit(models, pole, deviations, tuple(notes))


def _repeated(fit: PartFit, study: Study, name: str) -> list[PartModel]:
    found: list[PartModel] = []
    for part in study.again.get(name, ()):
        try:
            found.append(fit(part, study))
        except (InvalidModel, np.linalg.LinAlgError):
            continue
    return found


def _spread(values: list[Array]) -> Array:
    """One deviation of each entry, from its quartiles."""
    low, high = np.percentile(np.array(values), [25, 75], axis=0)
    return np.asarray((high - low) / QUARTILES, dtype=np.float64)


def _pole(model: PartModel, poles: list[float], study: Study) -> Pole:
    value = model.pole
    if len(poles) < FEWEST:
        return Pole(value, np.nan, np.nan, np.nan, np.nan, "none")
    low, middle, high = (float(v) for v in np.percentile(poles, [25, 50, 75]))
    spread, bias = (high - low) / QUARTILES, middle - study.known_pole
    how = f"scatter over {len(poles)} logs of the loop with its innovations drawn anew"
    return Pole(
        value, value - NORMAL * spread, value + NORMAL * spread, bias, 1.25 * spread / float(np.sqrt(len(poles))), how
    )  # fmt: skip
