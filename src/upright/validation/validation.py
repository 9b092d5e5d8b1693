"""What a validation says: how well what is known predicts each log, where it breaks, and what would have to move."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.atomic import finite
from upright.calibration.calibration import GOOD, PREDICTED, Segments
from upright.calibration.own_run import RunEffect
from upright.tables import Shown, joined, short
from upright.tables import least as least_of
from upright.validation.loop import FreeLoop

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PREDICTS, PARTLY, DOES_NOT = "predicts", "predicts in part", "does not predict"
JUDGED = "predicts what could be judged"
SHOWN = 3  # shifts in a report


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
    of its fit. `dead` are sensors that never change, which nothing is judged by;
    `estimates` are what the law reads of a filter in the program, in whose place the loop has the true states."""

    source: str
    fitted: float | None
    samples: int
    seconds: float
    half_seconds: tuple[ChannelFit, ...]
    own_run: tuple[ChannelFit, ...]
    effects: tuple[RunEffect, ...]
    law: str
    estimates: tuple[str, ...]
    dead: tuple[str, ...]
    loop: tuple[ChannelFit, ...]
    shifts: tuple[Shift, ...]
    notes: tuple[str, ...]
    segments: Segments
    simulated: FreeLoop | None

    @property
    def worst(self) -> ChannelFit:
        """The gyro or encoder that is predicted worst; a compass turns with what no model here knows."""
        return least(self.half_seconds)

    @property
    def no_test(self) -> str:
        """Why this log tests nothing, in words; '' where it does, or where nobody knows."""
        if not self.fitted:
            return ""
        return f"the robot was fitted to about {100 * self.fitted:.0f} % of the rows of {self.source}"

    @property
    def caution(self) -> str:
        """Why the free closed loop is not that of the program, in words; '' where it is."""
        if not (self.loop and self.estimates):
            return ""
        return (
            f"This law reads {joined(self.estimates)}, which the program's own filter estimated. The simulated loop "
            "has the true state instead. So its commands are not the program's, and its R² does not judge the robot: "
            "--controller FILE gives the filter too."
        )

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
            "closed_loop": {"law": self.law, "estimates": list(self.estimates), "channels": loop},
            "shifts": plain(self.shifts), "notes": list(self.notes),
        }  # fmt: skip

    def lines(self) -> list[str]:
        """This log in words."""
        lines = [f"{self.source}: {self.samples} samples, {self.seconds:.4g} s"]
        lines += [f"  No test: {self.no_test}"] if self.no_test else []
        lines += ["  Half seconds, from a fitted state:"]
        lines += [_line(c) for c in self.half_seconds]
        if self.own_run:
            lines += [f"  The same with {len(self.effects)} numbers of this run, fitted to this log:"]
            lines += [_line(c) for c in self.own_run]
            moved = ", ".join(
                f"{e.name} {e.known:.3g} → {e.here:.3g}{'' if e.unit == '1' else f' {e.unit}'}" for e in self.effects
            )
            lines += [f"    {line}" for line in textwrap.wrap(moved, 116)]
        lines += [f"  Closed loop, from the first state, {self.law}" + (":" if self.loop else "")]
        lines += [f"    {line}" for line in textwrap.wrap(self.caution, 116)] + [_line(c) for c in self.loop]
        for shift in self.shifts[:SHOWN]:
            off = round(shift.deviations, 1) or 0.0  # and no −0.0
            lines.append(
                f"  Would have to move: {shift.name} from {shift.value:.4g} to {shift.proposed:.4g} {shift.unit} "
                f"({off:+.1f} deviations), which removes {shift.explains:.0%} of what half seconds leave"
            )
        return [*lines, *(f"  {note}" for note in self.notes)]


def least(channels: Sequence[ChannelFit]) -> ChannelFit:
    """The gyro or encoder with the smallest R²."""
    return min((c for c in channels if c.name in PREDICTED), key=lambda c: c.r2)


def _line(c: ChannelFit) -> str:
    breaks = "" if c.breaks is None else f"   breaks at t = {c.breaks:.4g} s"
    return f"    {short(c.name):<20} R² {least_of(c.r2, 4):>7}   fit {c.fit:>5.1f} %{breaks}"


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Validation(Shown):
    """What is known of `robot` with `kit`, judged on `logs`. It prints as a short text, with its verdict first."""

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
    def sentence(self) -> str:
        """The verdict with the number that decides it, and what is not judged."""
        log = self.worst
        several = f" of {log.source}" if len(self.logs) > 1 else ""
        r2 = least_of(log.worst.r2, 4)
        dead = {short(name) for one in self.logs for name in one.dead}
        r2 += f" ({least_of(least(log.own_run).r2, 4)} with what belongs to its run)" if log.own_run else ""
        never = f"; {joined(sorted(dead))} never change{'s' if len(dead) == 1 else ''}" if dead else ""
        return (
            f"{self.robot} {self.says('this log' if len(self.logs) == 1 else f'these {len(self.logs)} logs')}: "
            f"over half seconds the {short(log.worst.name)}{several} has the smallest R² of gyro and encoders, "
            f"{r2}{never}" + "".join(f"; no test: {one.no_test}" for one in self.logs if one.no_test)
        )

    def says(self, logs: str) -> str:
        """The verdict on `logs`, in words."""
        if self.verdict == PARTLY:
            return f"predicts {logs} in part"
        return f"{self.verdict} {'of ' if self.verdict == JUDGED else ''}{logs}"

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; what is not finite is null."""
        return {"robot": self.robot, "kit": self.kit, "verdict": self.verdict, "logs": [x.to_json() for x in self.logs]}

    def __str__(self) -> str:
        return "\n".join([self.sentence, *(line for log in self.logs for line in log.lines())])

    def plot(self) -> Figure:
        """Readings of the worst log, measured and predicted for half a second at a time."""
        return half_second_figure(self.worst)


def half_second_figure(log: LogJudged) -> Figure:
    """Measured and predicted readings, half a second at a time; those that do not pass first, the worst of them."""
    from upright.plotting import legend, line, panels, span

    r2 = {c.name: min(c.r2, GOOD) for c in log.half_seconds}
    names = [name for name in log.segments.rows if name in PREDICTED] or list(log.segments.rows)
    names.sort(key=lambda name: r2.get(name, GOOD))
    lowest = log.worst.name if log.worst.name in names else names[0]
    figure, axes = panels([*map(_label, names), _label(lowest).replace(" [", ", measured − predicted [")])
    for ax, name in zip(axes, names, strict=False):
        t, measured, predicted = log.segments.series(name)
        line(ax, "measured", t, measured, style=4, below=True)
        line(ax, "predicted", t, predicted, style=1, solid=True)
    t, measured, predicted = log.segments.series(lowest)
    line(axes[-1], "_error", t, measured - predicted, style=0, solid=True)
    if log.simulated is not None and len(log.segments.when):
        width = NARROWEST * float(np.ptp(log.segments.when))
        for start, stop in log.simulated.pushes:
            span(axes, start, max(stop, start + width), "push")
    return legend(figure)


BEYOND = 0.5  # of the measured range, above and below it: a simulation that goes further is cut at the frame


def loop_figure(loop: FreeLoop) -> Figure:
    """Measured readings, and those of the free closed loop, with its pushes and when each reading is lost."""
    from upright.plotting import AXIS, legend, line, panels, span

    figure, axes = panels([_label(name) for name in loop.names])
    for i, ax in enumerate(axes):
        line(ax, "measured", loop.t, loop.measured[:, i], style=4, below=True)
        line(ax, "simulated freely", loop.t, loop.simulated[:, i], style=1, solid=True)
        low, high = np.nanmin(loop.measured[:, i]), np.nanmax(loop.measured[:, i])
        room = BEYOND * (high - low)
        if np.nanmax(loop.simulated[:, i]) > high + room or np.nanmin(loop.simulated[:, i]) < low - room:
            ax.set_ylim(low - room, high + room)
    least_width = NARROWEST * float(np.ptp(loop.t))
    for start, stop in loop.pushes:
        span(axes, start, max(stop, start + least_width), "push, not simulated")
    for ax, channel in zip(axes, loop_channels(loop), strict=True):
        if channel.breaks is not None and not channel.name.endswith("compass"):
            ax.axvline(channel.breaks, linestyle="--", linewidth=1, color=AXIS)
            ax.annotate("lost", (channel.breaks, 0.04), (4, 0), xycoords=("data", "axes fraction"),
                        textcoords="offset points")  # fmt: skip
    return legend(figure)


NARROWEST = 0.006  # of the time that is shown: a knock is shaded at least so long, to be seen


def _label(name: str) -> str:
    return f"{short(name)} [{PREDICTED.get(name, 'rad')}]"


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
