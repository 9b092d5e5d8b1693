"""Several logs of the same experiment side by side, as numbers."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.atomic import finite
from upright.certification.verdict import MOST_TRAVEL
from upright.comparison import metrics, resting, swaying
from upright.errors import InvalidLog, UnknownName
from upright.experiment import motionless, outcome_of, undisturbed
from upright.logs.recording import commanded
from upright.signals import STATE_NAMES, Log
from upright.tables import Listing, Shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NEAR_LIMIT = 0.8
"""Fraction of its limit below which no command was cut: a battery that sags gives way by less than the rest."""

NEGLIGIBLE = {"yaw": math.radians(1.0), "yaw_rate": math.radians(1.0)}
"""[rad], [rad/s] A compass of an NXT resolves one degree: where the reference turns less than that, its yaw is noise,
and nothing is fitted to it."""

DIVERGED = -100.0
"""[%] of fit: the error is twice the reference's own deviation. Nothing is scored below: how far a run is that went
another way is chance."""

CONSTANT = 1e-9
"""[rad], [rad/s] of a reference that only rounding moves: nothing can be fitted to it."""


def _number(unit: str, label: str) -> Any:
    return field(metadata={"unit": unit, "label": label})


@dataclass(frozen=True, kw_only=True)
class Metrics:
    """What one log shows; times count from the release of the push, NaN where a log cannot say.

    Settling and overshoot are of pitch about zero, and `wheel_travel` is the largest |θ − θ(first sample)|. A run that
    leaves the band in the last quarter after the release too has no settling time. One that swings further on the far
    side than on the side of the release has no overshoot: it was struck, and let go before it leaned.
    `fell` is the run's own outcome, None where a log from elsewhere has none (`experiment.outcome_of`).
    """

    settling_2: float = _number("s", "settling 2 %")
    settling_5: float = _number("s", "settling 5 %")
    overshoot: float = _number("1", "overshoot")
    pitch_peak: float = _number("rad", "peak pitch")
    pitch_rms: float = _number("rad", "RMS pitch")
    doubling: float = _number("s", "swing doubles in")
    wheel_travel: float = _number("rad", "wheel travel")
    effort: float = _number("u² s", "effort")
    saturated: float = _number("1", "saturated")
    fell: bool | None = _number("", "fell")


METRICS: dict[str, tuple[str, str]] = {
    f.name: (f.metadata["unit"], f.metadata["label"]) for f in dataclasses.fields(Metrics)
}
"""Field name → (unit, label) of every metric, in order; the effort's u is `Comparison.command_unit`."""


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Comparison(Shown):
    """Logs under their labels, the metrics of each, and how well each fits the reference.

    `fits[label][signal]` is the NRMSE fit [%] to the log labelled `reference`. `sources` says whether a log's
    states are its `truth` or its `estimate`; `releases` when its push ended [s] (inf: never); `kinds` what body
    it is of. `release` is what the caller asked for, None for each log's own.
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
    fits: Mapping[str, Mapping[str, float]]

    def check(self) -> bool:
        """Whether comparing the logs kept here again gives these very numbers."""
        again = compare(self.logs, reference=self.reference, signals=self.signals, release=self.release)
        return again.to_json() == self.to_json()

    def unit(self, metric: str) -> str:
        """Unit of a metric, '1' for a fraction, '' for yes or no."""
        squared = f"({self.command_unit})²" if not self.command_unit.isalpha() else f"{self.command_unit}²"
        return METRICS[metric][0].replace("u²", squared)

    def to_json(self) -> dict[str, Any]:
        """Everything but the logs as plain values, None for what is not a finite number."""
        return {
            "reference": self.reference,
            "signals": list(self.signals),
            "release": self.release,
            "command_unit": self.command_unit,
            "logs": {label: self._log_json(label) for label in self.logs},
        }

    def _log_json(self, label: str) -> dict[str, Any]:
        numbers = {name: finite(value) for name, value in dataclasses.asdict(self.metrics[label]).items()}
        fits = {name: finite(value) for name, value in self.fits.get(label, {}).items()}
        seconds, within = self.at_rest(label)
        numbers |= {"settled": finite(seconds), "settled_within": finite(within)} if self.pushed else {}
        where = {"kind": self.kinds[label], "source": self.sources[label], "release": finite(self.releases[label])}
        return where | {"metrics": numbers, "fit": fits}

    def ended(self, label: str) -> str:
        """How a run ended, in words, also that its swing grows, that it rolled far, or why it never moved."""
        log, numbers = self.logs[label], self.metrics[label]
        ended = str(outcome_of(log))
        rolled = log.origin.get("robot", {}).get("wheel_radius", 0) * numbers.wheel_travel
        if math.isfinite(numbers.doubling):
            ended += f", but its swing doubled every {numbers.doubling:.2g} s"
        if rolled > MOST_TRAVEL:
            ended += f", and rolled {rolled:.2g} m"
        still = motionless(log) if undisturbed(log) else ""
        return f"{ended}. {still}" if still else ended

    def plot(self, *signals: str) -> Figure:
        """States of all logs over time (default: all that are compared), one panel each; the push is shaded."""
        names = signals or self.signals
        source = self.sources[self.reference]
        titles = [f"{n.replace('_', ' ')} [{self.logs[self.reference].unit(f'{source}/{n}')}]" for n in names]
        return self._drawn(titles, {label: [f"{of}/{name}" for name in names] for label, of in self.sources.items()})

    def plot_commands(self) -> Figure | None:
        """Both commands of the logs that have them, applied ones first; None where no log has any."""
        drawn = {label: [f"{p}/left", f"{p}/right"] for label, log in self.logs.items() if (p := commanded(log))}
        titles = [f"{side} command [{self.command_unit}]" for side in ("left", "right")]
        return self._drawn(titles, drawn, step=True) if drawn else None

    def _drawn(self, titles: Sequence[str], channels: Mapping[str, Sequence[str]], *, step: bool = False) -> Figure:
        """Those channels of each log, one panel each, and when the push acts."""
        from upright.plotting import legend, line, panels, span

        figure, axes = panels(titles)
        for style, (label, log) in enumerate(self.logs.items()):
            for ax, name in zip(axes, channels.get(label, ()), strict=False):
                line(ax, label, log.t, log[name], step=step, style=style)
        end = max(float(log.t[-1]) for log in self.logs.values())
        for start, stop in self.pushed:
            span(axes, start, min(stop, end), "push acts")
        return legend(figure)

    @property
    def pushed(self) -> tuple[tuple[float, float], ...]:
        """From when to when [s] a push acts, by the reference's log or the first that has pushes."""
        logs = (self.logs[self.reference], *self.logs.values())
        log = next((log for log in logs if "push/force" in log), None)
        return () if log is None else metrics.active_intervals(log.t, log["push/force"])

    def released(self, label: str) -> resting.Released:
        """|pitch| of a run from the release on; empty where it fell, or is pushed to its end."""
        log, release = self.logs[label], self.releases[label]
        ends = self.metrics[label].fell or not release <= log.t[-1]
        after = log.between(release, math.inf) if not ends else None
        name = f"{self.sources[label]}/pitch"
        none = np.zeros(0)
        return (
            resting.Released(after.t, np.abs(after[name])) if after and name in after else resting.Released(none, none)
        )

    def at_rest(self, label: str) -> tuple[float, float]:
        """How long after the release until pitch stays near zero [s], and what near means for all runs [rad]:
        `resting.at_rest`; where the run never rests NaN and 5 % of its largest pitch."""
        seconds, within = resting.at_rest({name: self.released(name) for name in self.logs}, label)
        return seconds, 0.05 * abs(self.metrics[label].pitch_peak) if math.isnan(seconds) else within

    def answer(self, label: str, name: str = "pitch") -> swaying.Answered | None:
        """How a run and the reference answer the pushes until both are at rest: `swaying.answer`."""
        one = self.logs[self.reference]
        log = self.logs[label]
        t = one.t[(one.t >= log.t[0]) & (one.t <= log.t[-1])]
        names = (f"{self.sources[self.reference]}/{name}", f"{self.sources[label]}/{name}")
        rest = max(self.at_rest(each)[0] for each in (self.reference, label))
        return swaying.answer(
            t, one[names[0]][np.isin(one.t, t)], np.interp(t, log.t, log[names[1]]), self.pushed, rest
        )

    def listing(self) -> Listing:
        """Metrics and fits, one column for each log."""
        labels = list(self.logs)
        rows: list[list[str]] = []
        if self.pushed:
            calm = [self.at_rest(label) for label in labels]
            within = f"{math.degrees(max(limit for _, limit in calm)):.3g}°"
            rows.append([f"settling ±{within}", "s", *(_cell(seconds) for seconds, _ in calm)])
        for name, (_, text) in METRICS.items():
            rows.append([text, self.unit(name), *(_cell(getattr(self.metrics[label], name)) for label in labels)])
        for name in self.signals if self.fits else ():
            cells = (fit_cell(self.fits[label][name]) if label in self.fits else "reference" for label in labels)
            rows.append([f"fit of {name}", "%", *cells])
        rows.append(["states from", "", *(self.sources[label] for label in labels)])
        return Listing(("", "unit", *labels), rows, labels)

    def __str__(self) -> str:
        return str(self.listing())


def compare(
    logs: Mapping[str, Log | str | Path] | Sequence[Log | str | Path] | Log | str | Path,
    *,
    reference: str | None = None,
    signals: Sequence[str] = STATE_NAMES,
    release: float | None = None,
) -> Comparison:
    """Metrics of each log, or file of one, and its fit to the `reference` log (default: the first, normally the twin).

    Logs without labels are called 1, 2, ….
    A log on another time base is interpolated linearly onto the reference's times inside the interval both
    share. States are `truth/…` if all logs have them, else each log's `estimate/…`, or its `truth/…` where it has
    no estimate. `release` [s] is when the push ends; by default each log's own `push/force` says so, or the
    reference's for a log without one; without any push it is the first sample. The log of a twin is
    labelled a twin: "robot" or "real" becomes "twin", any other label gets "(twin)".

    Raises `InvalidLog` for no logs, missing states, or no common time; `UnknownName` for an unknown reference.
    """
    if not isinstance(logs, Mapping):
        several = [logs] if isinstance(logs, Log | str | Path) else logs
        logs = {str(number): log for number, log in enumerate(several, start=1)}
    if not logs:
        raise InvalidLog("no logs to compare", expected="a mapping of labels to logs")
    first = next(iter(logs)) if reference is None else reference
    if first not in logs:
        raise UnknownName("log", first, logs)
    read = {label: log if isinstance(log, Log) else Log.load(log) for label, log in logs.items()}
    labels = _labels(read)
    named = {labels[label]: log for label, log in read.items()}
    anchor = named[labels[first]]
    sources = _sources(named, signals)
    releases = {label: _release(log, anchor) if release is None else release for label, log in named.items()}
    unit = _command_unit(anchor)
    numbers = {label: _measure(log, sources[label], releases[label], unit) for label, log in named.items()}
    states = {label: {name: f"{sources[label]}/{name}" for name in signals} for label in named}
    fits = {
        label: MappingProxyType(_fit(anchor, log, states[labels[first]], states[label], label))
        for label, log in named.items()
        if label != labels[first]
    }
    return Comparison(
        logs=MappingProxyType(named),
        reference=labels[first],
        signals=tuple(signals),
        release=release,
        sources=MappingProxyType(sources),
        releases=MappingProxyType(releases),
        kinds=MappingProxyType({label: body_kind(log) for label, log in named.items()}),
        command_unit=unit,
        metrics=MappingProxyType(numbers),
        fits=MappingProxyType(fits),
    )


def body_kind(log: Log) -> str:
    """What kind of body the log's origin names, '' where it does not say."""
    body = log.origin.get("body", {})
    return str(body.get("kind", "")) if isinstance(body, Mapping) else ""


def _labels(logs: Mapping[str, Log]) -> dict[str, str]:
    labels: dict[str, str] = {}
    taken = {label for label, log in logs.items() if _honest(label, log)}
    for label, log in logs.items():
        honest = label
        if not _honest(label, log):
            stem = "twin" if re.search(r"robot|real", label, re.IGNORECASE) else f"{label} (twin)"
            numbered = (f"{stem} {number}" for number in range(2, len(logs) + 2))
            honest = next(name for name in (stem, *numbered) if name not in taken)
        taken.add(honest)
        labels[label] = honest
    return labels


def _honest(label: str, log: Log) -> bool:
    return "twin" not in body_kind(log).lower() or (
        "twin" in label.lower() and not re.search(r"robot|real", label, re.IGNORECASE)
    )


def _sources(logs: Mapping[str, Log], signals: Sequence[str]) -> dict[str, str]:
    complete = {label: [p for p in ("truth", "estimate") if _has(log, p, signals)] for label, log in logs.items()}
    for label, prefixes in complete.items():
        if not prefixes:
            have = ", ".join(sorted(logs[label].channels)) or "no channels"
            raise InvalidLog(
                f"log '{label}' has neither truth/… nor estimate/… of {', '.join(signals)}",
                expected=f"the states to be compared (it holds {have})",
                hint="run it with an estimator, or name fewer signals",
            )
    prefer = "truth" if all("truth" in prefixes for prefixes in complete.values()) else "estimate"
    return {label: prefer if prefer in prefixes else prefixes[0] for label, prefixes in complete.items()}


def _has(log: Log, prefix: str, signals: Sequence[str]) -> bool:
    return all(f"{prefix}/{name}" in log for name in signals)


def _release(log: Log, anchor: Log) -> float:
    for candidate in (log, anchor):
        pushes = metrics.active_intervals(candidate.t, candidate["push/force"]) if "push/force" in candidate else ()
        if pushes:
            return pushes[-1][1]
    return float(log.t[0])


def _command_unit(log: Log) -> str:
    prefix = commanded(log)
    return log.unit(f"{prefix}/left") if prefix else "V"


def _measure(log: Log, source: str, release: float, unit: str) -> Metrics:
    pitch, wheel = _channel(log, f"{source}/pitch"), _channel(log, f"{source}/wheel")
    after = pitch[log.t >= release]
    fell = outcome_of(log).fell
    return Metrics(
        settling_2=metrics.settled(log.t, pitch, band=0.02, start=release),
        settling_5=metrics.settled(log.t, pitch, band=0.05, start=release),
        overshoot=swing if (swing := metrics.overshoot(after)) <= 1 else math.nan,
        pitch_peak=metrics.peak(log.t, pitch).value,
        pitch_rms=metrics.rms(pitch),
        doubling=math.nan if fell else metrics.doubling(log.t, pitch, start=release),
        wheel_travel=abs(metrics.peak(log.t, wheel, float(wheel[0])).value),
        effort=_effort(log, unit),
        saturated=_saturated(log),
        fell=fell,
    )


def _channel(log: Log, name: str) -> metrics.Array:
    return log[name] if name in log else np.full(len(log), np.nan)


def _effort(log: Log, unit: str) -> float:
    prefix = commanded(log)
    if prefix and _command_unit(log) != unit:
        return np.nan  # volts and newton metres do not compare
    return metrics.effort(log.t, _channel(log, f"{prefix}/left"), _channel(log, f"{prefix}/right"))


def _saturated(log: Log) -> float:
    names = [f"{prefix}/{side}" for prefix in ("command", "applied") for side in ("left", "right")]
    if not all(name in log for name in names):
        return np.nan
    columns = [log[name] for name in names]
    held = max(map(metrics.held_fraction, columns[:2]))
    if max(float(np.abs(column).max()) for column in columns[2:]) < NEAR_LIMIT * _limit(log):
        return held
    return max(held, metrics.saturated_fraction(np.column_stack(columns[:2]), np.column_stack(columns[2:])))


def _limit(log: Log) -> float:
    """The largest command the body takes, as its log says; 0 where it does not say."""
    body = log.origin.get("body", {})
    limit = body.get("limit", 0.0) if isinstance(body, Mapping) else 0.0
    return math.inf if limit is None else float(limit)


def _fit(anchor: Log, log: Log, mine: Mapping[str, str], other: Mapping[str, str], label: str) -> dict[str, float]:
    keep = (anchor.t >= log.t[0]) & (anchor.t <= log.t[-1])
    if np.count_nonzero(keep) < 2:
        raise InvalidLog(
            f"log '{label}' runs from {log.t[0]:g} to {log.t[-1]:g} s, the reference from {anchor.t[0]:g} to "
            f"{anchor.t[-1]:g} s",
            expected="at least two samples of the reference inside both",
        )
    t = anchor.t[keep]
    pairs = {name: (anchor[mine[name]][keep], np.interp(t, log.t, log[other[name]])) for name in mine}
    return {
        name: math.nan
        if np.ptp(y) <= max(NEGLIGIBLE.get(name, 0.0), CONSTANT)
        else metrics.nrmse_fit(y, z)
        for name, (y, z) in pairs.items()
    }  # fmt: skip


def fit_cell(fit: float) -> str:
    """A fit [%] as it is shown."""
    return "diverges" if fit < DIVERGED else _cell(fit)


def _cell(value: float | bool | None) -> str:
    if isinstance(value, bool):
        return "yes" if value else "no"
    return "–" if value is None or math.isnan(value) else f"{value:.4g}"
