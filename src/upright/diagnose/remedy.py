"""The log with a fault taken out of it: what the filter then gives is exact, where the bank is linear."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.diagnose.fall import without
from upright.diagnose.fault_fits import FaultFit, remaining_bias, with_pushes
from upright.diagnose.innovations import FilterRun, driven, follow
from upright.diagnose.signatures import YOUNGEST, Bank, bank
from upright.signals import Log

Array = NDArray[np.float64]
GYRO = "sensor/gyro"

COMMAND_FAULTS = ("weak", "delay")
"""Faults of the commands, which are not small where the robot falls: the filter itself searches for them."""

CHARGES = (0.05, 0.15, 0.3, 0.5, 0.7)  # fractions of the battery's voltage that are tried first
DELAYS = (1.0, 2.0, 3.5, 5.0, 7.0, 10.0)  # periods that are tried first
ONSET_STEP = 0.4  # [s] between onsets that are tried first
WARM_UP = 2.0  # [s] that the filter has to find the robot before the part of the log that is judged
HALVINGS = 4  # of the steps in size and onset, round the best
BIAS_ROUNDS = 2  # most times that a gyro's offset is estimated again on the log freed of it
BEHIND = 150.0  # nats behind the likeliest, from which a gyro's offset is not examined again
MOST_BIASES = 4  # that are examined again
SHORT = 0.1  # [s] before the window's end: a filter that stops earlier has lost the robot


def remedied(run: FilterRun, fit: FaultFit) -> FilterRun | None:
    """The run of the log without the fault; None for a fault that no log can be freed of."""
    log, kit, robot = run.log, run.kit, run.robot
    if fit.fault in COMMAND_FAULTS:
        return follow(log, robot, kit, _sent(run, fit))
    if fit.fault == "bias":
        elapsed = log.t - fit.onset
        shift = fit.size * np.where(elapsed >= 0, 1.0 if fit.way == "step" else elapsed, 0.0)
        return follow(Log(log.t, {**log.channels, GYRO: log[GYRO] - shift}, log.units, log.origin), robot, kit)
    return None


def _sent(run: FilterRun, fit: FaultFit) -> Array:
    """The commands at the motors (samples, 2) with a fault of them from its onset on."""
    kit, unit = run.kit, run.robot.command_unit
    usual = driven(run.asked, kit, unit)
    faulty = (
        _delayed(usual, fit.size)
        if fit.fault == "delay"
        else driven(run.asked, kit, unit, fit.size, pwm=fit.way == "pwm")
    )
    return np.where((run.log.t >= fit.onset)[:, None], faulty, usual)


def _delayed(commands: Array, periods: float) -> Array:
    """Commands (samples, 2) so many periods later, a fraction of one as the mean of two."""
    whole = math.floor(periods)
    part = periods - whole
    nearer = np.vstack([np.repeat(commands[:1], whole, axis=0), commands[: len(commands) - whole]])
    return (1 - part) * nearer + part * np.vstack([nearer[:1], nearer[:-1]])


@dataclass(frozen=True)
class Window:
    """The part of a log that is judged: it `end`s then [s], is at most so many `seconds` long, and `usual` is the scale
    of its innovations before."""

    end: float
    seconds: float
    usual: float

    def of(self, run: FilterRun) -> FilterRun:
        """This part of a run."""
        return run.between(self.end - self.seconds, self.end)

    def bank(self, run: FilterRun, *, pushes_only: bool = True) -> Bank:
        """The bank of hypotheses on this part of a run."""
        return bank(self.of(run), self.usual, pushes_only=pushes_only)


def searched(run: FilterRun, window: Window) -> list[FaultFit]:
    """A weak battery of either kind and a longer delay, each of the size and onset with the smallest innovations; their
    scores are not yet exact."""
    recent = follow(run.log.between(window.end - window.seconds - WARM_UP, math.inf), run.robot, run.kit)
    faults = ((FaultFit(fault="weak", way="pwm"), CHARGES), (FaultFit(fault="weak", way="limit"), CHARGES))
    return [_searched(recent, window, *fault) for fault in (*faults, (FaultFit(fault="delay"), DELAYS))]


def _searched(recent: FilterRun, window: Window, fault: FaultFit, sizes: tuple[float, ...]) -> FaultFit:
    """By a grid in size and onset, then by steps that are halved; sizes move by factors."""

    def squares(onset: float, size: float) -> float:
        sent = _sent(recent, replace(fault, onset=onset, size=size))
        freed = follow(recent.log, recent.robot, recent.kit, sent)
        if freed.t[-1] < recent.t[-1] - SHORT:
            return math.inf
        return float((window.of(freed).whitened ** 2).sum())

    onsets = np.arange(window.end - window.seconds, window.end - YOUNGEST, ONSET_STEP).tolist()
    least, onset, size = min((squares(t, x), t, x) for t in onsets for x in sizes)
    step, factor = ONSET_STEP / 2, math.sqrt(sizes[1] / sizes[0])
    for _ in range(HALVINGS):
        near = [(onset + i * step, size * factor**j) for i, j in ((-1, 0), (1, 0), (0, -1), (0, 1))]
        tried = min((squares(t, x), t, x) for t, x in near if fault.fault == "delay" or x < 1)
        least, onset, size = min(tried, (least, onset, size))
        step, factor = step / 2, math.sqrt(factor)
    return replace(fault, onset=onset, size=size)


def exact(run: FilterRun, fit: FaultFit, window: Window, against: Bank) -> FaultFit:
    """The fit's score where its fault is taken out of the log; the size of a gyro's offset is estimated again."""
    best = fit
    for _ in range(BIAS_ROUNDS if fit.fault == "bias" else 1):
        freed = remedied(run, fit)
        if freed is None or freed.t[-1] < window.end - SHORT:
            return best
        again = with_pushes(window.bank(freed), against=against)
        now = replace(again, fault=fit.fault, way=fit.way, onset=fit.onset, size=fit.size)
        if now.score <= best.score and best is not fit:
            return best
        best = now if now.score > best.score else best
        if fit.fault == "bias":
            fit = replace(fit, size=fit.size + remaining_bias(window.of(freed), fit))
    return best


def dropped(run: FilterRun, frozen: NDArray[np.bool_], window: Window, against: Bank) -> FaultFit:
    """The fit of a robot whose sensors gave no reading in the `frozen` rows."""
    freed = follow(without(run.log, frozen), run.robot, run.kit)
    again = with_pushes(window.bank(freed), against=against)
    first = int(np.argmax(frozen & (run.log.t > window.end - window.seconds)))
    return replace(
        again, fault="dropped", way="frozen", onset=float(run.log.t[first]), size=float(frozen[first:].mean())
    )


def sharpened(run: FilterRun, fits: Sequence[FaultFit], window: Window, against: Bank) -> list[FaultFit]:
    """All fits, the likeliest of each fault that a log can be freed of by their exact score, the likeliest first."""
    biases = [fit for fit in fits if fit.fault == "bias" and fit.score > fits[0].score - BEHIND][:MOST_BIASES]
    exact_ones = [*biases, *(fit for fit in fits if fit.fault in COMMAND_FAULTS)]
    rest = [fit for fit in fits if not any(fit is one for one in exact_ones)]
    return sorted([*(exact(run, fit, window, against) for fit in exact_ones), *rest], key=lambda f: -f.score)
