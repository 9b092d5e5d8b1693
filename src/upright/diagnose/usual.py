"""How large innovations usually are: over the log before the fall, and in its calmer seconds."""

from __future__ import annotations

import numpy as np

from upright.arrays import Array
from upright.diagnose.fall import pace
from upright.diagnose.innovations import FilterRun
from upright.diagnose.remedy import Window
from upright.logs.recording import FEWEST

SECONDS = 4.0  # [s] of a quick robot before the fall that are judged: a fault that shows earlier has not made it fall
LONGEST = 8.0  # [s] of them, where the trouble in which a robot fell began before: a tall one may swing for long
BLOCK, LOUD = 0.5, 4.0  # [s] of innovations, and their NIS over the calm one, that show such trouble
ORDINARY_END = 1.0  # [s] before the fall up to which innovations count as ordinary
CALMER = 0.3  # of the seconds before the fall, that are calmer than what counts as calm
MEDIAN = 0.455  # of χ² with one degree of freedom, by which the median of squares becomes their scale
FOREIGN = 20.0  # ordinary NIS from which the robot is not the one that was given
FITTED = 3.0  # NIS of calmer seconds, up to which the robot is the given one: its trouble lasts longer than they do


def window_of(run: FilterRun, end: float) -> Window:
    """The part of a run that is judged for a fall at `end` [s], with the usual scale of its innovations: up to where
    the filter loses the robot, since what each hypothesis leaves is of the same readings."""
    end = min(end, float(run.clock[-1]))
    readings = run.readings & (run.t <= end)  # what the floor does is not usual
    seconds = SECONDS * pace(run.robot)
    early = readings & (run.t < end - _ordinary_end(run))
    part = early if early.sum() > 100 else readings
    if len(run.log) < FEWEST:  # all of it may be trouble: the noise is what the kit says
        return Window(end, seconds, 1.0)
    usual = max(1.0, float(np.median(run.innovation[part] ** 2 / run.variance[part])) / MEDIAN)
    window = Window(end, seconds, usual)
    calm = calm_of(run, window)
    if usual >= FOREIGN and calm > FITTED:
        return window
    return Window(end, _since(run, end, calm), calm if usual >= FOREIGN else usual)


def _since(run: FilterRun, end: float, calm: float) -> float:
    """How many seconds before the `end` [s] the trouble lasted in which the usual window begins; `SECONDS` where it
    begins calmly, or where no beginning shows."""
    t = run.t[run.readings]
    squares = run.whitened**2
    slow = pace(run.robot)

    def loud(start: float) -> bool:
        block = squares[(t >= start) & (t < start + BLOCK)]
        return len(block) > 0 and float(block.mean()) > LOUD * calm

    start = end - SECONDS * slow
    while loud(start) and start > max(end - LONGEST * slow, float(run.t[0])):
        start -= BLOCK
    return end - start if not loud(start) and start > run.t[0] else SECONDS * slow


def _ordinary_end(run: FilterRun) -> float:
    return ORDINARY_END * pace(run.robot)


def calm_of(run: FilterRun, window: Window) -> float:
    """The scale of the innovations in the calmer seconds before the fall: trouble may last longer than calm."""
    blocks = [float(np.median(squares)) for squares in _seconds(run, window)]
    return min(window.usual, max(1.0, float(np.quantile(blocks, CALMER)) / MEDIAN)) if blocks else window.usual


def quiet_of(run: FilterRun, window: Window) -> float:
    """The NIS of a calmer second before the fall, at most that of such ones as the filter expects it: it is below 1
    where the robot is better known than that."""
    blocks = [float(np.mean(squares)) for squares in _seconds(run, window)]
    return min([calm_of(run, window), *([float(np.quantile(blocks, CALMER))] if blocks else [])])


def _seconds(run: FilterRun, window: Window) -> list[Array]:
    """The squares of the whitened innovations in each second up to a while before the fall."""
    use = run.readings & (run.t < window.end - _ordinary_end(run))
    t = run.t[use]
    squares = run.innovation[use] ** 2 / run.variance[use]
    seconds = np.floor(t - run.t[0])
    return [squares[seconds == k] for k in np.unique(seconds) if (seconds == k).sum() > FEWEST / 2]
