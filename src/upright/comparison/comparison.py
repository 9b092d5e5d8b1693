"""Several logs of the same experiment side by side, as numbers."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.comparison import metrics
from upright.comparison.runs import Compared, Metrics
from upright.errors import InvalidLog, UnknownName
from upright.experiment import outcome_of
from upright.logs.recording import commanded
from upright.pages import Page, Result
from upright.signals import STATE_NAMES, Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

NEAR_LIMIT = 0.8
"""Fraction of its limit below which no command was cut: a battery that sags gives way by less than the rest."""


class Comparison(Compared, Result):
    """Runs beside each other as a result: pages, figures and data."""

    def check(self) -> bool:
        """Whether comparing the logs kept here again gives these very numbers."""
        again = compare(self.logs, reference=self.reference, signals=self.signals, release=self.release)
        return again.to_json() == self.to_json()

    def to_json(self) -> dict[str, Any]:
        """Everything but the logs as plain values, None for what is not a finite number."""
        return {
            "schema": "upright/compare/1",
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
        numbers["settled"] = finite(seconds) if self.pushed else None
        numbers["settled_within"] = finite(within) if self.pushed else None
        return {
            "kind": self.kinds[label],
            "source": self.sources[label],
            "release": finite(self.releases[label]),
            "metrics": numbers,
            "fit": fits,
            "fit_answered": {name: finite(value) for name, value in self.answered.get(label, {}).items()},
            "pitch_apart": finite(self.apart(label)) if "pitch" in fits else None,
        }

    def page(self) -> Page:
        """The comparison for people; of a single log what its robot did."""
        from upright.comparison.comparison_page import comparison_page
        from upright.comparison.run_page import run_page

        return run_page(self) if len(self.logs) == 1 else comparison_page(self)

    def plot(self, *signals: str) -> Figure:
        """States of all logs over time (default: those that move), one panel each, in degrees; the push is shaded."""
        from upright.comparison.drawing import draw_states

        return draw_states(self, signals or self.moving)

    def plot_commands(self) -> Figure | None:
        """Both commands of the logs that have them, applied ones first; None where no log has any."""
        from upright.comparison.drawing import draw_commands

        return draw_commands(self) if any(map(commanded, self.logs.values())) else None


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
    for label, log in named.items():
        if label != labels[first]:
            _check_common(anchor, log, label)
    return Comparison(
        logs=named,
        reference=labels[first],
        signals=tuple(signals),
        release=release,
        sources=sources,
        releases=releases,
        kinds={label: body_kind(log) for label, log in named.items()},
        command_unit=unit,
        metrics=numbers,
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
    pitch = _channel(log, f"{source}/pitch")
    wheel = _channel(log, f"{source}/wheel")
    radius = log.origin.get("robot", {}).get("wheel_radius")
    turn = abs(metrics.peak(log.t, wheel, float(wheel[0])).value)
    after = pitch[log.t >= release]
    fell = outcome_of(log).fell
    return Metrics(
        settling_2=metrics.settled(log.t, pitch, band=0.02, start=release),
        settling_5=metrics.settled(log.t, pitch, band=0.05, start=release),
        overshoot=swing if (swing := metrics.overshoot(after)) <= 1 else math.nan,
        pitch_peak=metrics.peak(log.t, pitch).value,
        pitch_rms=metrics.rms(pitch),
        doubling=math.nan if fell else metrics.doubling(log.t, pitch, start=release),
        wheel_travel=turn,
        rolled=turn * radius if radius else math.nan,
        effort=_effort(log, unit),
        saturated=_saturated(log),
        fell=fell,
    )


def _channel(log: Log, name: str) -> Array:
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


def _check_common(anchor: Log, log: Log, label: str) -> None:
    """Raise `InvalidLog` for a log that shares no time with the reference."""
    if np.count_nonzero((anchor.t >= log.t[0]) & (anchor.t <= log.t[-1])) < 2:
        raise InvalidLog(
            f"log '{label}' runs from {log.t[0]:g} to {log.t[-1]:g} s, the reference from {anchor.t[0]:g} to "
            f"{anchor.t[-1]:g} s",
            expected="at least two samples of the reference inside both",
        )
