"""Faults with a push beside them, searched together: alone, a fault takes up a part of the push, and stays where that
led it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.diagnose.changes import scaled_sensors
from upright.diagnose.fault_fits import FAULT_NUMBERS, PUSH_NUMBERS, FaultFit, score_of
from upright.diagnose.forces import refined
from upright.diagnose.innovations import FilterRun
from upright.diagnose.remedy import (
    BATTERY_OR_DELAY,
    ONSET_STEP,
    Window,
    beside_pushes,
    descended,
    exact,
    followed,
    lately,
    least_of,
)
from upright.diagnose.signatures import YOUNGEST, Bank, beside

SCALES = (-1.0, -0.4, 0.25, 0.5, 0.7)  # fractions of a reading that are too much, which are tried first
FINE_STEP, ROUND = 2, 4  # periods between onsets at which readings jump, and how many stand for those about one
JUMPS = 3  # of these onsets, that are examined
BESIDE = 2  # pushes that explain most beside a fault
STARTS = 2  # sizes from which the steps begin
ROUNDS = 2  # of steps of one length
LEAVES = 1.3  # NIS over the calm one, up to which a hypothesis leaves only noise
BEHIND, MOST = 100.0, 6  # nats behind the best, up to which a start is examined, and how many are
LOST = 1e12  # squares that stand for a filter that lost the robot


def with_sudden_pushes(run: FilterRun, window: Window, against: Bank, known: float) -> list[FaultFit]:
    """A weak battery of either kind, a longer delay and sensors of another scale, each of the size and onset that
    leaves least beside the two pushes that then explain most; none that is far behind the best, or behind what is
    `known` [nats]."""
    recent = lately(run, window)
    faults = (*BATTERY_OR_DELAY, *((FaultFit(fault="scale", way=way), SCALES) for way in scaled_sensors(run)))
    tried = (_least(recent, window, against, fault, sizes) for fault, sizes in faults)
    best = [(_promise(recent, window, against, one), one) for one in tried if one is not None]
    least = max([known, *(promise for promise, _ in best)]) - BEHIND
    best = [one for one in best if one[0] > least]
    jumping = [(promise, replace(one, way="readings")) for promise, one in best if one.fault == "delay"]
    jumping += sorted(((promise, one) for promise, one in best if "encoder" in one.way), key=lambda one: -one[0])[:1]
    for _, one in jumping:
        best += [(_promise(recent, window, against, fit), fit) for fit in _jumps(recent, window, against, one)]
    best.sort(key=lambda one: -one[0])
    several: list[FaultFit] = []
    for promise, one in best[:MOST]:
        fit = exact(run, one, window, against) if promise > best[0][0] - BEHIND else one
        if len(fit.rest):
            fit = beside_pushes(run, fit, window, against) if fit.pushes else fit
            several.append(refined(run, fit, window, against))
    return several


def _promise(recent: FilterRun, window: Window, bank: Bank, fit: FaultFit) -> float:
    """The score [nats] of a fault and of two pushes by what they leave."""
    squares = _squares(recent, window, bank, fit)
    rest = np.full(len(bank.y), math.sqrt(min(squares, LOST) / len(bank.y)))
    return score_of(bank, rest, FAULT_NUMBERS + BESIDE * PUSH_NUMBERS)


def _squares(recent: FilterRun, window: Window, bank: Bank, *fits: FaultFit) -> float:
    """What faults, and the pushes that explain most beside them, leave (sum of squares)."""
    freed = followed(recent, float(recent.t[-1]), *fits)
    return math.inf if freed is None else left(window.of(freed).whitened, bank)


def _jumps(recent: FilterRun, window: Window, bank: Bank, fit: FaultFit) -> list[FaultFit]:
    """A fault since the times that leave least, at which its readings jump wherever it does not begin: late ones jump
    back, and an angle of another scale begins where it was."""
    onsets = np.arange(window.end - window.seconds, window.end - YOUNGEST, FINE_STEP * recent.log.period)

    def squares(onset: float) -> float:
        return _squares(recent, window, bank, replace(fit, onset=onset))

    by_onset = np.array([squares(float(t)) for t in onsets])
    around = [by_onset[max(i - ROUND, 0) : i + ROUND + 1] for i in range(len(onsets))]
    depth = [
        one / np.median(near) if np.isfinite(one) else math.inf for one, near in zip(by_onset, around, strict=True)
    ]
    shifts = recent.log.period * np.array([-1.0, 0.0, 1.0])
    return [
        replace(fit, onset=min((onsets[i] + shifts).tolist(), key=squares)) for i in np.argsort(depth)[:JUMPS].tolist()
    ]


def _least(recent: FilterRun, window: Window, bank: Bank, fault: FaultFit, sizes: Sequence[float]) -> FaultFit | None:
    """By a grid in size and onset, then from the best sizes of it."""

    def squares(tried: Sequence[FaultFit]) -> float:
        return _squares(recent, window, bank, *tried)

    latest = window.end - YOUNGEST
    onsets = np.arange(window.end - window.seconds, latest, ONSET_STEP).tolist()
    starts: list[tuple[float, FaultFit]] = []  # the best of each size
    for size in sizes:
        tries = [replace(fault, onset=t, size=size) for t in onsets]
        starts.append(least_of(lambda one: squares([one]), tries))
    starts.sort(key=lambda one: one[0])
    best = [(least, one) for least, one in starts[:STARTS] if math.isfinite(least)]
    lowest = [descended(squares, least, [one], latest, ROUNDS) for least, one in best]
    return min(lowest, key=lambda one: one[0])[1][0] if lowest else None


def left(whitened: Array, bank: Bank) -> float:
    """What innovations are left (sum of squares) by the pushes that explain most of them."""
    if len(whitened) + bank.basis.shape[1] != len(bank.y):  # the filter lost a reading
        return math.inf
    y = beside(bank.basis, whitened)
    for _ in range(BESIDE if len(bank.pushes) else 0):
        dots = bank.dots(y)
        i = int(np.argmax(dots**2 / bank.squares))
        y = y - dots[i] / bank.squares[i] * bank.push(i)
    return float(y @ y)
