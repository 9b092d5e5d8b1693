"""Logs of the same experiment, what each shows, and how far each is from a reference."""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.comparison import metrics, resting, swaying
from upright.pages import Say
from upright.signals import Log

NEGLIGIBLE = {"yaw": math.radians(1.0), "yaw_rate": math.radians(1.0)}
"""[rad], [rad/s] A compass of an NXT resolves one degree: where the reference turns less than that, its yaw is noise,
and nothing is fitted to it."""

DIVERGED = -100.0
"""[%] of fit: the error is twice the reference's own deviation. Nothing is scored below: how far a run is that went
another way is chance."""

CONSTANT = 1e-9
"""[rad], [rad/s] of a reference that only rounding moves: nothing can be fitted to it."""

CLOSE, FAIR = 80.0, 50.0
"""[%] of fit, from where two runs agree well, and at all."""


def _number(unit: str, label: Say) -> Any:
    return field(metadata={"unit": unit, "label": label})


@dataclass(frozen=True, kw_only=True)
class Metrics:
    """What one log shows; times count from the release of the push, NaN where a log cannot say.

    Settling and overshoot are of pitch about zero; `wheel_travel` is the largest |θ − θ(first sample)|, `rolled` that
    times the wheels' radius, NaN where the log's origin has none. A run that
    leaves the band in the last quarter after the release too has no settling time. One that swings further on the far
    side than on the side of the release has no overshoot: it was struck, and let go before it leaned.
    `fell` is the run's own outcome, None where a log from elsewhere has none (`experiment.outcome_of`).
    """

    fell: bool | None = _number("", Say("fell"))
    pitch_peak: float = _number("rad", Say("largest pitch"))
    rolled: float = _number("m", Say("furthest from the start"))
    saturated: float = _number("1", Say("motors at limit"))
    effort: float = _number("u² s", Say("effort"))
    overshoot: float = _number("1", Say("overshoot"))
    doubling: float = _number("s", Say("swing doubles in"))
    settling_2: float = _number("s", Say("settling 2 %"))
    settling_5: float = _number("s", Say("settling 5 %"))
    pitch_rms: float = _number("rad", Say("RMS pitch"))
    wheel_travel: float = _number("rad", Say("largest turn of the wheels"))


METRICS: dict[str, tuple[str, Say]] = {
    f.name: (f.metadata["unit"], f.metadata["label"]) for f in dataclasses.fields(Metrics)
}
"""Field name → (unit, label) of every metric, in order; the effort's u is `Comparison.command_unit`."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Compared:
    """Logs under their labels, the metrics of each, and how well each fits the reference.

    `sources` says whether a log's states are its `truth` or its `estimate`; `releases` when its push ended [s] (inf:
    never); `kinds` what body it is of. `release` is what the caller asked for, None for each log's own.
    """

    logs: Mapping[str, Log]
    reference: str
    signals: tuple[str, ...]
    release: float | None
    sources: Mapping[str, str]
    releases: Mapping[str, float]
    kinds: Mapping[str, str]
    command_unit: str
    metrics: Mapping[str, Metrics]

    def __post_init__(self) -> None:
        for name in ("logs", "sources", "releases", "kinds", "metrics"):
            object.__setattr__(self, name, MappingProxyType(dict(getattr(self, name))))

    def unit(self, metric: str) -> str:
        """Unit of a metric, '1' for a fraction, '' for yes or no."""
        squared = f"({self.command_unit})²" if not self.command_unit.isalpha() else f"{self.command_unit}²"
        return METRICS[metric][0].replace("u²", squared)

    def state(self, label: str, name: str) -> Array:
        """A state of a log over its time."""
        return self.logs[label][f"{self.sources[label]}/{name}"]

    @property
    def moving(self) -> tuple[str, ...]:
        """The states in which a log moves by more than what counts as noise; all where there are none."""
        moved: list[str] = []
        for name in self.signals:
            ranges = [np.ptp(self.state(label, name)) for label in self.logs]
            if max(ranges) > negligible(name):
                moved.append(name)
        return tuple(moved) or self.signals

    @property
    def pushed(self) -> tuple[tuple[float, float], ...]:
        """From when to when [s] a push acts, by the reference's log or the first that has pushes."""
        logs = (self.logs[self.reference], *self.logs.values())
        log = next((log for log in logs if "push/force" in log), None)
        return () if log is None else metrics.active_intervals(log.t, log["push/force"])

    def released(self, label: str) -> resting.Released:
        """|pitch| of a run from the release on; empty where it fell, or is pushed to its end."""
        log, release = self.logs[label], self.releases[label]
        name = f"{self.sources[label]}/pitch"
        if self.metrics[label].fell or not release <= log.t[-1] or name not in log:
            return resting.Released(np.zeros(0), np.zeros(0))
        after = log.between(release, math.inf)
        return resting.Released(after.t, np.abs(after[name]))

    def at_rest(self, label: str) -> tuple[float, float]:
        """How long after the release until pitch stays near zero [s], and what near means for all runs [rad]:
        `resting.at_rest`; where the run never rests NaN and 5 % of its largest pitch."""
        seconds, within = resting.at_rest({name: self.released(name) for name in self.logs}, label)
        return seconds, 0.05 * abs(self.metrics[label].pitch_peak) if math.isnan(seconds) else within

    def both(self, label: str, name: str) -> tuple[Array, Array, Array]:
        """Times [s], a state of the reference, and that of a log at these times, while both last."""
        one = self.logs[self.reference]
        log = self.logs[label]
        shared = (one.t >= log.t[0]) & (one.t <= log.t[-1])
        t = one.t[shared]
        return t, self.state(self.reference, name)[shared], np.interp(t, log.t, self.state(label, name))

    @functools.cached_property
    def fits(self) -> Mapping[str, Mapping[str, float]]:
        """The NRMSE fit [%] of each log but the reference to that, by signal; NaN where the reference hardly moves."""
        return MappingProxyType({label: self._fit(label) for label in self.logs if label != self.reference})

    def _fit(self, label: str) -> Mapping[str, float]:
        fits: dict[str, float] = {}
        for name in self.signals:
            _, one, other = self.both(label, name)
            fits[name] = math.nan if np.ptp(one) <= negligible(name) else metrics.nrmse_fit(one, other)
        return MappingProxyType(fits)

    def apart(self, label: str, name: str = "pitch") -> float:
        """The largest difference of a state from the reference's, in the unit of the state."""
        _, one, other = self.both(label, name)
        return float(np.nanmax(np.abs(one - other), initial=0.0))

    def answer(self, label: str, name: str = "pitch") -> swaying.Answered | None:
        """How a run and the reference answer the pushes until both are at rest: `swaying.answer`."""
        rest = max(self.at_rest(each)[0] for each in (self.reference, label))
        return swaying.answer(*self.both(label, name), self.pushed, rest)

    @functools.cached_property
    def answered(self) -> Mapping[str, Mapping[str, float]]:
        """The fits [%] while the pushes are answered, where those of whole runs are poor only since each sways by
        itself at rest; none where that is not so."""
        fits = {label: fit.get("pitch", math.nan) for label, fit in self.fits.items()}
        answers = {label: self.answer(label) for label, fit in fits.items() if math.isfinite(fit)}
        if not any(fit < FAIR for fit in fits.values()) or not all(a and a.sway_only for a in answers.values()):
            return {}
        return {label: {name: self._answered(label, name) for name in self.signals} for label in fits}

    def _answered(self, label: str, name: str) -> float:
        answer = self.answer(label, name)
        return answer.fit if answer else math.nan


def negligible(name: str) -> float:
    """The range within which a state counts as not moving."""
    return max(NEGLIGIBLE.get(name, 0.0), CONSTANT)
