"""The clock of a log that is filtered: stamps that scatter more than the program did, and rows that are closer together
than the robot moves.

A stamp that is 0.2 ms off moves a wheel's angle at 10 rad/s by several steps of an encoder, which no fault explains.
"""

from __future__ import annotations

import numpy as np

from upright.diagnose.fall import falling
from upright.diagnose.innovations import FilterRun, follow
from upright.errors import InvalidLog
from upright.logs.recording import FEWEST
from upright.signals import Log

LEAST = 1e-3  # of a period, by which stamps scatter round an even clock: less does not show
MOST = 0.25  # of a period, by which they scatter at most: beyond, the program itself was uneven
DRIFT = 0.5  # [s] before and after, over which a clock keeps its pace
BETTER = 5.0  # nats by which an even clock must predict the readings better
COUNTED_AS_ONE = 3.0  # readings of one sample
CLOSE = 0.09  # of the time in which the robot falls e-fold: readings need not be closer
FEWEST_LEFT = 3 * FEWEST  # rows


def on_even_clock(run: FilterRun) -> FilterRun:
    """The run of the same log with its stamps as an even clock would have them, where that predicts the readings
    better; else `run` itself."""
    log = evened(run.log)
    if log is None:
        return run
    try:
        even = follow(log, run.robot, run.kit)
    except InvalidLog:
        return run
    return even if _scatter(run) - _scatter(even) > BETTER else run


def _scatter(run: FilterRun) -> float:
    """What of the innovations changes from row to row [nats], as wrong stamps do, and robots with faults less so."""
    sensors = (run.whitened[run.row[run.readings] == i] for i in range(len(run.rows)))
    changes = np.concatenate([np.diff(one, 2) for one in sensors]) / np.sqrt(6.0)
    return float(np.log1p(changes**2).sum()) / 2 / COUNTED_AS_ONE


def evened(log: Log) -> Log | None:
    """The log with its stamps on a clock that ticks evenly about them, whole periods apart; None where they do so
    already, or where they are too uneven for any."""
    periods = np.maximum(np.rint(np.diff(log.t) / log.period), 1.0)
    ticks = np.concatenate([[0.0], np.cumsum(periods)])
    if len(log) < 3:
        return None
    slope, first = np.polyfit(ticks, log.t, 1)
    off = log.t - (first + slope * ticks)
    half = min(round(DRIFT / log.period), (len(log) - 1) // 2)
    window = np.ones(2 * half + 1)
    drift = np.convolve(off, window, "same") / np.convolve(np.ones(len(off)), window, "same")
    scatter = float(np.std(off - drift))
    t = log.t - (off - drift)
    if not LEAST * log.period < scatter < MOST * log.period or (np.diff(t) <= 0).any():
        return None
    return Log(t, log.channels, log.units, log.origin)


def thinned(run: FilterRun) -> FilterRun:
    """The run by the readings of one row in several that are closer than the robot moves; `run` itself where they are
    not. Its commands stay."""
    many = int(CLOSE / (falling(run.robot).pole * run.log.period))
    if many < 2 or len(run.log) < many * FEWEST_LEFT:
        return run
    ticks = np.rint((run.log.t - run.log.t[0]) / run.log.period) // many
    try:
        return follow(run.log, run.robot, run.kit, run.log.t[np.diff(ticks, prepend=-1.0) > 0])
    except InvalidLog:
        return run
