"""What a check reads (a record) and returns (findings, with the fixes that repair the record)."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.arrays import Array, Mask
from upright.pages import Quantity, Say, english, facts_of

SEVERITIES = ("error", "warning", "note")
"""error: the log is wrong; warning: a fit must account for it; note: information."""

CONTRADICTORY = ("motion/", "units/", "channel/stuck", "command/unsigned", "columns/copied")
"""How the codes begin of findings that a fit bends its numbers to: signs, sides, kinds, units, sensors that stopped."""

GAP = 5.0
"""[periods] A longer step is a pause of the recording; shorter ones are dropped rows or jitter."""

FEWEST = 20
"""Fewest rows from which a motion can be judged."""

LEFT, RIGHT, GYRO = "sensor/encoder_left", "sensor/encoder_right", "sensor/gyro"
BATTERY, COMPASS, PITCH = "sensor/battery", "sensor/compass", "estimate/pitch"
FORWARD, UP = "sensor/accel_forward", "sensor/accel_up"

BALANCING, STANDING, LYING, OVER = "balancing", "standing still", "lying", "upside down"
RISING, FALLING, FALLEN, MOVED, HELD = "standing up", "falling", "fallen", "moved", "held"
OFF = "motors off"
ON_WHEELS = (BALANCING, STANDING)
LEANING = (STANDING, LYING, OVER, FALLEN)
"""Poses on the wheels, in which the equations of motion hold, and those with one lean."""


def moment(t: float, digits: int = 3) -> str:
    """A time [s] in words: three digits, or hundredths where a clock counts from long ago."""
    return f"{t:.{digits}g}" if abs(t) < 10**digits else f"{t:.2f}"


def instant(t: float) -> Quantity:
    """A time [s] of a log: three digits, or hundredths where a clock counts from long ago."""
    return Quantity(t, "s", digits=max(3, len(f"{abs(t):.0f}") + 2))


def during(start: float, stop: float) -> str:
    """From when to when [s] in words; of what begins and ends at the same time in words, that time."""
    one, other = moment(start), moment(stop)
    return f"at {one} s" if one == other else f"from {one} to {other} s"


@dataclass(frozen=True)
class Segment:
    """A part of a log by its pose (`kind`), from `start` to `stop` [s], and the median `lean` [rad]."""

    kind: str
    start: float
    stop: float
    lean: float

    def to_json(self) -> dict[str, Any]:
        """As plain data."""
        return {"kind": self.kind, "from": self.start, "until": self.stop, "lean": self.lean}


SPEED = "a speed"


@dataclass(frozen=True, eq=False)
class Record:
    """A log before validation: time [s] may repeat or run backwards, channels may hold anything.

    It never contains `truth/…`: the doctor reads only what a real robot measures. `segments` are the poses, where they
    are known: the equations of motion hold only on the wheels. `read` are the units in which the columns of the
    channels were taken to be: `SPEED` where a rate was summed of which nothing says the unit. The columns of those that
    are `summed` are rates.
    """

    t: Array
    channels: Mapping[str, Array]
    units: Mapping[str, str] = field(default_factory=dict[str, str])
    segments: tuple[Segment, ...] = ()
    read: Mapping[str, str] = field(default_factory=dict[str, str])
    summed: frozenset[str] = frozenset()

    def __contains__(self, name: str) -> bool:
        return name in self.channels

    def __getitem__(self, name: str) -> Array:
        return self.channels[name]

    @property
    def period(self) -> float:
        """Median time between rows [s]."""
        return float(np.median(np.diff(self.t)))

    def on_wheels(self, t: Array) -> Mask:
        """Which of the times `t` [s] are in a pose in which the equations of motion hold; all where none is known."""
        if not self.segments:
            return np.ones(len(t), dtype=bool)
        starts = np.array([segment.start for segment in self.segments])
        on = np.array([segment.kind in ON_WHEELS for segment in self.segments])
        return on[np.maximum(np.searchsorted(starts, t + 1e-9, side="right") - 1, 0)]

    @property
    def commands(self) -> tuple[str, str] | None:
        """The command channels: `applied/…` where logged, else `command/…`."""
        for prefix in ("applied", "command"):
            if f"{prefix}/left" in self and f"{prefix}/right" in self:
                return f"{prefix}/left", f"{prefix}/right"
        return None

    @property
    def torque_driven(self) -> bool:
        """Whether the commands are torques."""
        return self.commands is not None and self.units.get(self.commands[0]) == "N m"

    @property
    def unnamed(self) -> bool:
        """Whether nothing says in what unit the commands are."""
        return self.commands is not None and not self.units.get(self.commands[0], "V")

    def changed(self, changes: Mapping[str, Array]) -> Record:
        """The same record with some channels replaced."""
        return replace(self, channels={**self.channels, **changes})

    def rows(self, keep: NDArray[Any], t: Array | None = None) -> Record:
        """Only these rows (a mask or indices), at their own times or at `t`."""
        channels = {name: values[keep] for name, values in self.channels.items()}
        return replace(self, t=self.t[keep] if t is None else t, channels=channels)


@dataclass(frozen=True)
class Fix:
    """One repair: its `kind` (see `fixes.FIXES`), its channels and its numbers."""

    kind: str
    channels: tuple[str, ...] = ()
    numbers: tuple[float, ...] = ()


@dataclass(frozen=True)
class Finding:
    """One fault: `code` (family/name), `severity`, `channel`, the `evidence` as a sentence with what decides, the
    `repair` as one, the `fixes` that do it, and its `span` [s] where it does not concern the whole log."""

    code: str
    severity: str
    channel: str
    evidence: Say
    repair: Say | None = None
    fixes: tuple[Fix, ...] = ()
    span: tuple[float, float] | None = None

    @property
    def facts(self) -> dict[str, Any]:
        """The facts of both sentences as data."""
        return facts_of(self.evidence) | (facts_of(self.repair) if self.repair else {})

    def to_json(self) -> dict[str, Any]:
        """As plain data, with the sentences in English."""
        data: dict[str, Any] = {"code": self.code, "severity": self.severity, "channel": self.channel}
        data |= {"evidence": english(self.evidence), "repair": english(self.repair) if self.repair else ""}
        return data | {"facts": self.facts} | ({"from": self.span[0], "until": self.span[1]} if self.span else {})


def in_a_line(finding: Finding) -> str:
    """Where something is wrong and its evidence, for an error's one line."""
    return f"{finding.channel}: {english(finding.evidence).rstrip('.')}"


Span = tuple[float, float]


def error(code: str, channel: str, evidence: Say, repair: Say | None, *fixes: Fix) -> Finding:
    """A finding of severity `error`."""
    return Finding(code, "error", channel, evidence, repair, fixes)


def warning(
    code: str, channel: str, evidence: Say, repair: Say | None, *fixes: Fix, span: Span | None = None
) -> Finding:
    """A finding of severity `warning`."""
    return Finding(code, "warning", channel, evidence, repair, fixes, span)


def note(code: str, channel: str, evidence: Say, repair: Say | None, *, span: Span | None = None) -> Finding:
    """A finding of severity `note`."""
    return Finding(code, "note", channel, evidence, repair, (), span)


STATE = Say("State the true unit and scale in a mapping: `--write-mapping MINE.toml`.")
LEAVE_OUT = Say("Leave these rows out of a fit.")
INTERPOLATE = Say("Interpolate these readings.")


def plain(value: float, digits: int = 3) -> Quantity:
    """A ratio, or a number whose unit nobody knows."""
    return Quantity(value, "1", digits=digits)
