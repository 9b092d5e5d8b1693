"""What no single cause explains: two causes at once, or none that is known, and what is left then."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from upright.diagnose.fall import StuckSensor
from upright.diagnose.fault_fits import (
    FAULT_NUMBERS,
    TRIED,
    FaultFit,
    as_fit,
    dearer,
    least_squares,
    score_of,
    with_pushes,
)
from upright.diagnose.innovations import FilterRun, follow
from upright.diagnose.remedy import COMMAND_FAULTS, FADE_PRICE, RARE, READING_FAULTS, SHORT, Window, moved, remedied
from upright.diagnose.signatures import Bank, signatures_of
from upright.signals import Log

Array = NDArray[np.float64]

MOST_PAIRS = 3  # that are examined by the filter itself, of those whose signatures explain most
BESIDE = ("ramp", "payload")  # faults whose signature may stand beside one that a log was freed of
NEAR = 0.12  # [s] before and after their onset, that are tried while the other one is searched
MORE = 2  # faults, besides the likeliest, beside which another one is looked for
SECONDS = 2  # kinds of a second fault that are tried with pushes beside them
RAPID = 0.75  # of the NIS, that slow steps leave where a disturbance is too rapid for them
LOUD, BLOCK = 0.5, 0.2  # squared innovations over their mean, in blocks of so many seconds, from which they show
STEP_COST = 0.5  # of a step of a disturbance of any shape, over that of a number that is chosen among many onsets


@dataclass(frozen=True, eq=False, kw_only=True)
class Pair:
    """Two faults that explain the innovations together, by the `score` of both."""

    first: FaultFit
    second: FaultFit

    @property
    def score(self) -> float:
        """Log likelihood ratio [nats] of both, less the penalty."""
        rare = sum(fit.fault == "scale" for fit in (self.first, self.second))
        return self.second.score - RARE * rare


@dataclass(frozen=True, eq=False, kw_only=True)
class Leftover:
    """The disturbance of any shape that explains best what a hypothesis leaves: it enters by the `channel` from `onset`
    [s] on with the `values` at the times `t`, or with none where it is too rapid for steps; together they have the
    `score` and leave `nis`."""

    channel: str
    onset: float
    t: Array
    values: Array
    score: float
    nis: float


def jam_or_stuck(run: FilterRun, stuck: StuckSensor, window: Window, bank: Bank) -> tuple[float, float]:
    """How well a wheel that is held, by any torque, and an encoder that tells nothing explain a constant encoder: both
    scores [nats]."""
    side = "left" if stuck.channel.endswith("left") else "right"
    nothing = replace(with_pushes(bank), rest=bank.y, spent=2)
    held = _of_channel(f"{side} motor", nothing, bank, bank, since=max(stuck.start, float(bank.steps[0])))
    values = np.where(run.log.t > stuck.start, np.nan, run.log[stuck.channel])
    blind = Log(run.log.t, {**run.log.channels, stuck.channel: values}, run.log.units, run.log.origin)
    return held.score, with_pushes(window.bank(follow(blind, run.robot, run.kit)), against=bank).score


def paired(run: FilterRun, fits: Sequence[FaultFit], window: Window, bank: Bank) -> list[Pair]:
    """Two faults at once, the likeliest first: those that explain most together, and beside the likeliest faults alone
    what explains most of the rest."""
    best: dict[str, FaultFit] = {}
    for fit in fits:
        if fit.fault not in ("none", "dropped"):
            best.setdefault(fit.fault, fit)
    several = list(best.values())
    firsts = several[:1] + [fit for fit in several[1:] if fit.run is not None][:MORE]
    pairs = [
        Pair(first=one, second=second) for one in firsts for second in _seconds(one, window.beside(one, bank), bank)
    ]
    pairs += [_together(run, pair.first, pair.second, window, bank) for pair in pairs if _movable(pair)[0]]
    pairs += [_together(run, first, second, window, bank) for first, second in _linear(bank)]
    return sorted(pairs, key=lambda pair: -pair.score)


def _movable(pair: Pair) -> tuple[list[FaultFit], FaultFit | None]:
    """Which of both a log can be freed of, where all or the other's signature can be searched, and that other one."""
    fits = (pair.first, pair.second)
    several = [fit for fit in fits if fit.fault in READING_FAULTS + COMMAND_FAULTS]
    other = next((fit for fit in fits if fit.fault in BESIDE), None)
    return (several if len(several) == 2 or other else []), other


def _linear(bank: Bank) -> list[tuple[FaultFit, FaultFit]]:
    """The pairs of faults whose signatures leave least of the innovations together."""
    if not bank.faults:
        return []
    faults = [one for one in bank.faults if one.way != "both"]  # two dead motors are a battery without charge
    bank = replace(bank, faults=faults)
    kinds = np.array([one.fault for one in bank.faults])
    matrix = np.array([one.values for one in bank.faults])
    free = np.array([one.free for one in bank.faults])
    squares = np.maximum((matrix**2).sum(axis=1), 1e-12)

    def gain(y: Array) -> tuple[Array, Array]:
        dots = matrix @ y
        size = np.where(free, -dots / squares, 1.0)
        return size, -(2 * size * dots + size**2 * squares)

    size, explained = gain(bank.y)
    tried: dict[frozenset[str], tuple[float, FaultFit, FaultFit]] = {}
    for kind in dict.fromkeys(kinds):
        i = int(np.argmax(np.where(kinds == kind, explained, -np.inf)))
        sizes, more = gain(bank.y + size[i] * matrix[i])
        for other in dict.fromkeys(kinds):
            j = int(np.argmax(np.where(kinds == other, more, -np.inf)))
            names = frozenset((kind, other))
            total = explained[i] + more[j]
            if kind != other and total > tried.get(names, (-np.inf,))[0]:
                tried[names] = (total, as_fit(bank, i, size[i]), as_fit(bank, j, sizes[j]))
    return [pair[1:] for pair in sorted(tried.values(), key=lambda pair: -pair[0])[:MOST_PAIRS]]


def _together(run: FilterRun, first: FaultFit, second: FaultFit, window: Window, bank: Bank) -> Pair:
    """A pair with what it leaves: of the log without both where it can be freed of them, else of the log without one
    beside the other's signature, or by the signatures of both."""
    several, other = _movable(Pair(first=first, second=second))
    if several:
        around = partial(_around, other) if other else None
        several = moved(run, several, window, around)
        freed = remedied(run, *several)
        if freed is not None and freed.t[-1] > window.end - SHORT:
            fades = FADE_PRICE * sum(fit.rise > 0 for fit in several)
            here = window.bank(freed, beside_it=other.fault if other else "")
            if other is None:
                last = several[1]
                again = with_pushes(here, against=bank, beside=here.y)
                again = replace(again, fault=last.fault, way=last.way, onset=last.onset, size=last.size, rise=last.rise)
            else:
                some = sorted(here.faults, key=lambda one: least_squares(here.y, one)[1])[:TRIED]
                tried = [with_pushes(here, one, against=bank, beside=here.y) for one in some]
                again = max(tried, key=lambda fit: fit.score)
            return Pair(first=several[0], second=replace(dearer(again, fades, bank), run=freed))
    if not len(first.values) == len(second.values) == len(bank.y):  # found on a run of fewer readings
        return Pair(first=first, second=second)
    again = dearer(with_pushes(bank, beside=bank.y + first.values + second.values), FAULT_NUMBERS, bank)
    return Pair(
        first=first, second=replace(again, fault=second.fault, way=second.way, onset=second.onset, size=second.size)
    )


def _around(fit: FaultFit, run: FilterRun) -> Array:
    """The signature of a fault that a log cannot be freed of, near its onset, that explains most."""
    onsets = fit.onset + NEAR * np.array([-1.0, 0.0, 1.0])
    some = signatures_of(run, fit.fault, onsets)
    best = min(some, key=lambda one: least_squares(run.whitened, one)[1])
    return best.values[:, None]


def _seconds(first: FaultFit, here: Bank, bank: Bank) -> list[FaultFit]:
    """What explains most of what a fault leaves."""
    y = bank.y + first.values if first.run is None else here.y
    best: dict[str, tuple[float, int]] = {}
    for i, one in enumerate(here.faults):
        left = least_squares(y, one)[1]
        if one.fault != first.fault and left < best.get(one.fault, (np.inf, 0))[0]:
            best[one.fault] = (left, i)
    several: list[FaultFit] = []
    for _, i in sorted(best.values())[:SECONDS]:
        plain = as_fit(here, i, least_squares(y, here.faults[i])[0])
        fit = with_pushes(here, here.faults[i], against=bank, beside=y)
        several.append(replace(fit, way=plain.way, size=plain.size))
    return several


def leftover(fits: Sequence[FaultFit], window: Window, bank: Bank) -> Leftover | None:
    """What the likeliest hypothesis leaves, or pushes alone, as a disturbance of any shape by the one channel that
    explains most of it."""
    bases = {fits[0].fault: fits[0], "none": next(fit for fit in fits if fit.fault == "none")}
    left = [one for fit in bases.values() if (one := _beyond(fit, window, bank)) is not None]
    return max(left, key=lambda one: one.score, default=None)


def _beyond(fit: FaultFit, window: Window, bank: Bank) -> Leftover | None:
    here = window.beside(fit, bank)
    if not len(here.steps):
        return None
    best = max((_of_channel(channel, fit, here, bank) for channel in here.free), key=lambda one: one.score)
    if best.nis < RAPID * fit.nis:
        return best
    squares, blocks = fit.rest[: len(here.then)] ** 2, np.floor((here.then - here.then[0]) / BLOCK)
    loud = next(k for k in np.unique(blocks) if squares[blocks == k].mean() >= LOUD * squares.mean())
    return replace(best, onset=float(here.then[0] + BLOCK * loud), t=np.zeros(0), values=np.zeros(0))


def _of_channel(channel: str, fit: FaultFit, here: Bank, bank: Bank, since: float | None = None) -> Leftover:
    """Steps from each onset on, or from `since` [s] on, are columns; from the last to the first, each adds what it
    alone explains."""
    steps, y = here.free[channel][:, ::-1], fit.rest
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
        nis=float(left[best]) / len(y),
    )  # fmt: skip


def _scored(bank: Bank, count: int, squares: float, spent: float) -> float:
    return score_of(bank, np.full(count, np.sqrt(squares / count)), spent)
