"""The same log with a fault taken out of it: what the filter says then is exact, where the bank is linear."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.diagnose.fall import before, without
from upright.diagnose.faults import YOUNGEST, Bank, plain_bank
from upright.diagnose.fits import Fit, bias_left, with_pushes
from upright.diagnose.path import Track, driven, tangent, track
from upright.signals import Log

Array = NDArray[np.float64]
GYRO = "sensor/gyro"
FAR, MOST = 150.0, 4
"""Nats behind the likeliest from which a gyro's offset is not looked at again, and how many are at most."""

DRIVEN = ("weak", "late")
"""Faults of the commands, which are not small where the robot falls: they are searched by the filter itself."""

SHARES = (0.05, 0.15, 0.3, 0.5, 0.7)  # of the battery's voltage that are tried first
DELAYS = (1.0, 2.0, 3.5, 5.0, 7.0, 10.0)  # periods
APART = 0.4  # [s] between onsets that are tried first
WARM = 2.0  # [s] that the filter has to find the robot before the part of the log that is judged
HALVED = 4
"""Times that the steps in size and onset are halved round the best."""

ROUNDS = 2
"""Most times that the size of a gyro's offset is found again on the log freed of it."""


def mended(found: Track, fit: Fit) -> Track | None:
    """The track of the log without the fault; None for a fault that no log can be freed of."""
    log, kit, robot = found.log, found.kit, found.robot
    if fit.fault in DRIVEN:
        return track(log, robot, kit, _sent(found, fit.fault, fit.way, fit.onset, fit.size))
    if fit.fault == "bias":
        later = log.t - fit.onset
        shift = fit.size * np.where(later >= 0, 1.0 if fit.way == "step" else later, 0.0)
        return track(Log(log.t, {**log.channels, GYRO: log[GYRO] - shift}, log.units, log.origin), robot, kit)
    return None


def _sent(found: Track, fault: str, way: str, onset: float, size: float) -> Array:
    """The commands at the motors (samples, 2) with a fault of them from `onset` [s] on."""
    kit, unit = found.kit, found.robot.command_unit
    usual = driven(found.asked, kit, unit)
    other = _later(usual, size) if fault == "late" else driven(found.asked, kit, unit, size, weak=way == "pwm")
    return np.where((found.log.t >= onset)[:, None], other, usual)


def _later(commands: Array, periods: float) -> Array:
    """Commands (samples, 2) that come so many periods later, a part of one as the mean of two."""
    whole = math.floor(periods)
    part = periods - whole
    early = np.vstack([np.repeat(commands[:1], whole, axis=0), commands[: len(commands) - whole]])
    earlier = np.vstack([early[:1], early[:-1]])
    return (1 - part) * early + part * earlier


@dataclass(frozen=True)
class Window:
    """The part of a log that is judged: it `end`s then [s], is at most so many `seconds` long, and `usual` is the scale
    of its innovations before."""

    end: float
    seconds: float
    usual: float

    def bank(self, found: Track) -> Bank:
        """The bank of pushes alone on this part of a track."""
        part = before(found, self.end, self.seconds)
        use = (part.row >= 0) & np.isfinite(part.s)
        return plain_bank(part, tangent(part), use, self.usual)


def searched(found: Track, window: Window) -> list[Fit]:
    """A weak battery of either kind and later commands, each of the size and onset at which the filter is surprised
    least; their scores are not yet exact."""
    recent = track(found.log.between(window.end - window.seconds - WARM, math.inf), found.robot, found.kit)
    ways = (("weak", "pwm", SHARES), ("weak", "limit", SHARES), ("late", "", DELAYS))
    return [_searched(recent, window, *way) for way in ways]


def _searched(recent: Track, window: Window, fault: str, way: str, sizes: tuple[float, ...]) -> Fit:
    """By a grid in size and onset, then by steps that are halved; sizes move by factors."""

    def surprise(onset: float, size: float) -> float:
        freed = track(recent.log, recent.robot, recent.kit, _sent(recent, fault, way, onset, size))
        if freed.then[-1] < recent.then[-1] - 0.1:
            return math.inf
        part = before(freed, window.end, window.seconds)
        use = (part.row >= 0) & np.isfinite(part.s)
        return float((part.e[use] ** 2 / part.s[use]).sum())

    onsets = np.arange(window.end - window.seconds, window.end - YOUNGEST, APART).tolist()
    least, onset, size = min((surprise(t, x), t, x) for t in onsets for x in sizes)
    step, factor = APART / 2, math.sqrt(sizes[1] / sizes[0])
    for _ in range(HALVED):
        near = [(onset + i * step, size * factor**j) for i, j in ((-1, 0), (1, 0), (0, -1), (0, 1))]
        tried = min((surprise(t, x), t, x) for t, x in near if fault == "late" or x < 1)
        least, onset, size = min(tried, (least, onset, size))
        step, factor = step / 2, math.sqrt(factor)
    return Fit(fault, way, -math.inf, math.nan, onset, size, (), math.nan)


def exact(found: Track, fit: Fit, window: Window, against: Bank) -> Fit:
    """The fit's score where its fault is taken out of the log; the size of a gyro's offset is found again."""
    best = fit
    for _ in range(ROUNDS if fit.fault == "bias" else 1):
        freed = mended(found, fit)
        if freed is None or freed.then[-1] < window.end - 0.1:
            return best
        again = with_pushes(window.bank(freed), against=against)
        now = replace(again, fault=fit.fault, way=fit.way, onset=fit.onset, size=fit.size)
        if now.score <= best.score and best is not fit:
            return best
        best = now if now.score > best.score else best
        if fit.fault == "bias":
            fit = replace(fit, size=fit.size + _more_bias(freed, fit, window))
    return best


def _more_bias(freed: Track, fit: Fit, window: Window) -> float:
    """By how much the offset is larger than what was taken out."""
    part = before(freed, window.end, window.seconds)
    return bias_left(part, tangent(part), fit)


def dropped(found: Track, frozen: NDArray[np.bool_], window: Window, against: Bank) -> Fit:
    """The fit of a robot whose sensors said nothing in the `frozen` rows."""
    freed = track(without(found.log, frozen), found.robot, found.kit)
    again = with_pushes(window.bank(freed), against=against)
    first = np.flatnonzero(frozen & (found.log.t > window.end - window.seconds))
    onset = float(found.log.t[first[0]]) if len(first) else math.nan
    return replace(again, fault="dropped", way="frozen", onset=onset, size=float(frozen[first[0] :].mean()))


def sharpened(found: Track, fits: Sequence[Fit], window: Window, against: Bank) -> list[Fit]:
    """All fits, the likeliest of each fault that a log can be freed of by their exact score, the likeliest first."""
    biases = [fit for fit in fits if fit.fault == "bias" and fit.score > fits[0].score - FAR][:MOST]
    worth = [*biases, *(fit for fit in fits if fit.fault in DRIVEN)]
    rest = [fit for fit in fits if not any(fit is one for one in worth)]
    return sorted([*(exact(found, fit, window, against) for fit in worth), *rest], key=lambda f: -f.score)
