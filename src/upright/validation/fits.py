"""How well what is known predicts one log, where it breaks, and what would have to move."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from upright.atomic import finite
from upright.calibration.calibrated_robot import GOOD, PREDICTED, Segments
from upright.calibration.own_run import RunEffect
from upright.pages import Say, english
from upright.validation.loop import FreeLoop

COMPASS = "sensor/compass"
PREDICTS, PARTLY, DOES_NOT = "predicts", "predicts in part", "does not predict"
JUDGED = "predicts what could be judged"
WORTH = 0.1  # [1] of what half seconds leave: what a step must remove of it


@dataclass(frozen=True, kw_only=True)
class ChannelFit:
    """One reading: R², and fit 100 (1 − rms error / standard deviation) [%]; `breaks` is the time [s] from which the
    prediction misses by more than the reading varies, None where it never does."""

    name: str
    r2: float
    breaks: float | None

    @property
    def fit(self) -> float:
        return 100 * (1 - math.sqrt(max(1 - self.r2, 0.0)))


@dataclass(frozen=True, kw_only=True)
class Shift:
    """A parameter that, moved alone by one Gauss–Newton step from `value` to `proposed`, would remove the fraction
    `explains` of what half seconds leave; `deviations` is the step in standard deviations of what is known."""

    name: str
    unit: str
    value: float
    proposed: float
    deviations: float
    explains: float


@dataclass(frozen=True, eq=False, kw_only=True)
class LogJudged:
    """One log: predictions over half seconds, each from a fitted state; the same with the `effects` of its run, fitted
    to this log, where that is better; the free closed loop where the law is known; the shifts that would help, greatest
    first. `fitted` is the fraction of its rows that the robot was fitted to, None where the robot's file names no logs
    of its fit. Of the `halves`, half seconds, those `pushed` are left out, unless all are. `dead` are sensors that
    never change, which nothing is judged by. `law` says what drove the log, None where it is unknown; the best linear
    law of the readings has `explained` so much of the commands. `estimates` are what the law reads of a filter in the
    program, in whose place the loop has the true states."""

    source: str
    fitted: float | None
    samples: int
    seconds: float
    half_seconds: tuple[ChannelFit, ...]
    own_run: tuple[ChannelFit, ...]
    effects: tuple[RunEffect, ...]
    halves: int
    pushed: int
    law: Say | None
    explained: float
    estimates: tuple[str, ...]
    dead: tuple[str, ...]
    loop: tuple[ChannelFit, ...]
    shifts: tuple[Shift, ...]
    notes: tuple[Say, ...]
    segments: Segments
    simulated: FreeLoop | None

    @property
    def worst(self) -> ChannelFit:
        """The gyro or encoder that is predicted worst; a compass turns with what no model here knows."""
        return least(self.half_seconds)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""

        def plain(items: Sequence[Any]) -> list[dict[str, Any]]:
            return [{k: finite(v) for k, v in asdict(item).items()} for item in items]

        half, own, loop = ([{**c, "fit": finite(x.fit)} for c, x in zip(plain(xs), xs, strict=True)]
                           for xs in (self.half_seconds, self.own_run, self.loop))  # fmt: skip
        return {
            "source": self.source, "fitted": self.fitted, "samples": self.samples, "seconds": self.seconds,
            "half_seconds": half,
            "own_run": {"half_seconds": own, "effects": plain(self.effects)}, "dead": list(self.dead),
            "halves": self.halves, "pushed": self.pushed,
            "closed_loop": {
                "law": english(self.law) if self.law else None, "explained": finite(self.explained),
                "estimates": list(self.estimates), "channels": loop,
                "fell_at": self.simulated.fell_at if self.simulated else None,
            },
            "shifts": plain(self.shifts), "notes": [english(note) for note in self.notes],
        }  # fmt: skip


def least(channels: Sequence[ChannelFit]) -> ChannelFit:
    """The gyro or encoder with the smallest R²."""
    return min((c for c in channels if c.name in PREDICTED), key=lambda c: c.r2)


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class RobotJudged:
    """What is known of `robot` with `kit`, judged on `logs`."""

    robot: str
    kit: str
    logs: tuple[LogJudged, ...]

    @property
    def worst(self) -> LogJudged:
        """The log that is predicted worst over half seconds."""
        return min(self.logs, key=lambda log: log.worst.r2)

    @property
    def verdict(self) -> str:
        """`PREDICTS` where every channel of every log is predicted over half seconds, `JUDGED` where a sensor of one is
        dead, `DOES_NOT` where one is predicted worse than by its mean."""
        worst = self.worst.worst.r2
        good = JUDGED if any(log.dead for log in self.logs) else PREDICTS
        return good if worst >= GOOD else PARTLY if worst >= 0 else DOES_NOT

    @property
    def doubted(self) -> Shift | None:
        """The parameter that, changed alone, would remove most of the error."""
        return max((s for log in self.logs for s in log.shifts), key=lambda s: s.explains, default=None)

    @property
    def lost(self) -> ChannelFit | None:
        """The reading by which a simulated closed loop first leaves its log; a compass does so by itself, and a law of
        a filter that is not known is not judged."""
        broken = [
            c for log in self.logs if not log.estimates
            for c in log.loop if c.breaks is not None and c.name != COMPASS
        ]  # fmt: skip
        return min(broken, key=lambda c: c.breaks or 0.0, default=None)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; what is not finite is null."""
        logs = [log.to_json() for log in self.logs]
        names = {"robot": self.robot, "kit": self.kit, "verdict": self.verdict}
        bars = {"r2": GOOD, "error_removed": WORTH}
        return {"schema": "upright/validate/1"} | names | {"bars": bars, "logs": logs}


def channels_of(parts: Segments) -> tuple[ChannelFit, ...]:
    """Each reading over half seconds, and when a half second first is predicted worse than the whole log's mean."""
    channels: list[ChannelFit] = []
    for i, name in enumerate(parts.rows):
        at = parts.row == i
        missed = np.where(np.isfinite(parts.predicted[at]), (parts.measured - parts.predicted)[at] ** 2, np.inf)
        count = np.bincount(parts.segment[at])
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = np.bincount(parts.segment[at], missed) / count
        beyond = np.flatnonzero(mean > parts.measured[at].var())
        when = float(parts.when[at][parts.segment[at] == beyond[0]].min()) if len(beyond) else None
        channels.append(ChannelFit(name=name, r2=parts.r_squared(name), breaks=when))
    return tuple(channels)


SMOOTH = 0.25  # [s] over which a miss counts


def loop_channels(loop: FreeLoop) -> tuple[ChannelFit, ...]:
    """Each reading in the free closed loop; what lies beyond a simulated fall counts as missed by twice the deviation
    of the reading."""
    channels: list[ChannelFit] = []
    window = max(1, round(SMOOTH / float(np.median(np.diff(loop.t)))))
    for i, name in enumerate(loop.names):
        there = np.isfinite(loop.measured[:, i])
        y = loop.measured[there, i]
        simulated = loop.simulated[there, i]
        t = loop.t[there]
        first = int(np.isfinite(simulated).argmax())
        y, simulated, t = y[first:], simulated[first:], t[first:]
        variance = max(float(y.var()), 1e-30)
        missed = np.where(np.isfinite(simulated), (y - simulated) ** 2, 4 * variance)
        mean = np.convolve(missed, np.ones(window) / window, "full")[: len(missed)]
        beyond = np.flatnonzero(mean > variance)
        when = float(t[beyond[0]]) if len(beyond) else None
        channels.append(ChannelFit(name=name, r2=1 - float(missed.mean()) / variance, breaks=when))
    return tuple(channels)
