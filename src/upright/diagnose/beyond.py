"""What no known cause explains: a disturbance of any shape, by the channel that it enters by."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.diagnose.fall import StuckSensor, without
from upright.diagnose.fault_fits import (
    FaultFit,
    score_of,
    with_pushes,
)
from upright.diagnose.innovations import FilterRun, follow
from upright.diagnose.remedy import Window
from upright.diagnose.signatures import Bank

RAPID = 0.75  # of the NIS, that slow steps leave where a disturbance is too rapid for them
SHOWS = 4.0  # standard deviations of an innovation, from which a disturbance shows: its steps may begin before
LOUD, BLOCK = 0.5, 0.2  # squared innovations over their mean, in blocks of so many seconds, from which they show
BEYOND = 0.9  # of the time, in which the body turns faster than its gyro shows
STEP_COST = 0.5  # of a step of a disturbance of any shape, over that of a number that is chosen among many onsets


@dataclass(frozen=True, eq=False, kw_only=True)
class Leftover:
    """The disturbance of any shape that explains best what a hypothesis leaves: it enters by the `channel` from `onset`
    [s] on with the `values` at the times `t`, or with none where it is too rapid for steps; together they have the
    `score` and leave `rest` of the innovations, of this `nis`."""

    channel: str
    onset: float
    t: Array
    values: Array
    score: float
    nis: float
    rest: Array


def jam_or_stuck(run: FilterRun, stuck: StuckSensor, window: Window, bank: Bank) -> tuple[float, float, float]:
    """How well a wheel that is held, by any torque, and an encoder that tells nothing explain a constant encoder: both
    scores [nats], and the NIS that the better one leaves."""
    side = "left" if stuck.channel.endswith("left") else "right"
    nothing = replace(with_pushes(bank), rest=bank.y, spent=2)
    held = _of_channel(f"{side} motor", nothing, bank, bank, since=max(stuck.start, float(bank.steps[0])))
    blind = without(run.log, run.log.t > stuck.start, stuck.channel)
    dumb = with_pushes(window.bank(follow(blind, run.robot, run.kit, run.kept)), against=bank)
    return held.score, dumb.score, held.nis if held.score > dumb.score else dumb.nis


def goes_beyond(run: FilterRun, stuck: StuckSensor, end: float) -> bool:
    """Whether the body turns faster, the same way, than a gyro that stands still shows, as the other sensors have it up
    to `end` [s]: then it is at the end of its range. Of one that is stuck the rate has any size and sign; and what a
    gyro showed before is within its range."""
    before = run.log[stuck.channel][run.log.t < stuck.start]
    if (np.sign(stuck.reading) * before > abs(stuck.reading)).any():
        return False
    blind = follow(without(run.log, run.log.t >= stuck.start, stuck.channel), run.robot, run.kit)
    rate = blind.after[(blind.t > stuck.start) & (blind.t <= end) & (blind.row >= 0), 1]
    return len(rate) > 0 and bool(np.mean(np.sign(stuck.reading) * rate > abs(stuck.reading)) > BEYOND)


def leftover(fits: Sequence[FaultFit], window: Window, bank: Bank) -> Leftover | None:
    """What the likeliest hypothesis leaves, or pushes alone, as a disturbance of any shape by the one channel that
    explains most of it."""
    bases = {fits[0].fault: fits[0], "none": next(fit for fit in fits if fit.fault == "none")}
    left = [one for fit in bases.values() if (one := _beyond(fit, window, bank)) is not None]
    best = max(left, key=lambda one: one.score, default=None)
    if best is None:
        return None
    loud = (np.abs(bank.y[: len(bank.then)]) > SHOWS * np.sqrt(bank.scale)) & (bank.then >= best.onset)
    return replace(best, onset=float(bank.then[np.argmax(loud)])) if loud.any() else best


def _beyond(fit: FaultFit, window: Window, bank: Bank) -> Leftover | None:
    here = window.channels(fit, bank)
    if not len(here.steps):
        return None
    best = max((_of_channel(channel, fit, here, bank) for channel in here.free), key=lambda one: one.score)
    if best.nis < RAPID * fit.nis:
        return best
    squares = fit.rest[: len(here.then)] ** 2
    blocks = np.floor((here.then - here.then[0]) / BLOCK)
    loud = next(k for k in np.unique(blocks) if squares[blocks == k].mean() >= LOUD * squares.mean())
    return replace(best, onset=float(here.then[0] + BLOCK * loud), t=np.zeros(0), values=np.zeros(0))


def _of_channel(channel: str, fit: FaultFit, here: Bank, bank: Bank, since: float | None = None) -> Leftover:
    """Steps from each onset on, or from `since` [s] on, are columns; from the last to the first, each adds what it
    alone explains."""
    steps = here.free[channel][:, ::-1]
    y = fit.rest
    Q, R = np.linalg.qr(steps)
    dots = Q.T @ y
    left = np.maximum(float(y @ y) - np.cumsum(dots**2), 0.0)
    count = 1 + np.arange(len(left))
    scores = [
        _scored(bank, len(y), squares, fit.spent + 1 + STEP_COST * k) for squares, k in zip(left, count, strict=True)
    ]
    if since is not None:  # no earlier and no later
        scores = [-np.inf if k != (here.steps >= since - 1e-9).sum() else s for s, k in zip(scores, count, strict=True)]
    best = int(np.argmax(scores))
    size = np.asarray(np.linalg.lstsq(R[: best + 1, : best + 1], dots[: best + 1], rcond=1e-6)[0], dtype=np.float64)[
        ::-1
    ]
    onsets = here.steps[len(left) - best - 1 :]
    return Leftover(
        channel=channel, onset=float(onsets[0]), t=onsets, values=-np.cumsum(size), score=scores[best],
        nis=float(left[best]) / len(y), rest=y - Q[:, : best + 1] @ dots[: best + 1],
    )  # fmt: skip


def _scored(bank: Bank, count: int, squares: float, spent: float) -> float:
    return score_of(bank, np.full(count, np.sqrt(squares / count)), spent)
