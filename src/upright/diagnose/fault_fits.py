"""How well each signature of a bank explains the innovations, and which pushes it needs beside it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from upright.arrays import Array
from upright.diagnose.changes import PART, scales
from upright.diagnose.innovations import FilterRun, Signature
from upright.diagnose.signatures import Bank, beside, biases, unknown_parameters

VISIBLE_SLIP = 3.0  # standard deviations of a reading, from which a slip shows
MOST_PUSHES = 5  # that may come beside a fault
PUSH_GAP = 0.1  # [s] between two pushes: several at once, up and down, would follow whatever is wrong with the model
SUDDEN = {"step": 0.12, "ramp": 0.4}  # [s] after its onset in which an offset shows, before the filter loses the robot
LATEST = 0.05  # [s] by which a reading may be later than what it shows
FIRST_PART, FIRST_SHOWS = 0.6, 20.0
"""Of the squared innovations after its onset, and so many times the usual ones, that the first offset explains: what
comes later is larger, where the robot falls by it."""
SEARCHED = ("weak", "delay", "motor")  # faults that are not small: the filter itself searches for them
NEAR_BEST = 60.0  # nats behind the likeliest, up to which a fault of the commands beside pushes is examined
TRIED = 3  # signatures of each kind, by their squares alone, that are tried with pushes beside them
LEAST_GAIN = 3.0  # nats that a push must add to the score beyond the price of its numbers
FAULT_NUMBERS, PUSH_NUMBERS = 2, 3  # free numbers: size and onset; size, start and length
MORE_NUMBERS = {"payload": 2}  # height and place before the axle
CORRELATED = 3.0  # readings of one sample share what is wrong with the model, and count as one


@dataclass(frozen=True)
class PushEstimate:
    """A push from `start` to `stop` [s] of `impulse` [N s] at `height` [m] above the axle, and the `score` it adds."""

    start: float
    stop: float
    impulse: float
    height: float
    score: float


@dataclass(frozen=True, eq=False, kw_only=True)
class FaultFit:
    """A fault (or "none") that explains the innovations by `score`, the log likelihood ratio [nats] less the penalty.

    `size` is in the fault's own unit from `onset` [s] on, which a battery reaches after the `rise` [s]; `more` are a
    load's height over that of the body and the torque of its weight [N m], or what a gyro of another scale shows at
    rest [rad/s]. `pushes` stand beside it. `explained` is the fraction of the squares that it explains, `nis` the mean
    square that it leaves, `rest` the innovations themselves that it leaves. `values` is what it took from them, `run`
    the log's run without it, where there is one.
    """

    fault: str
    way: str = ""
    onset: float = math.nan
    size: float = 0.0
    rise: float = 0.0
    more: tuple[float, ...] = ()
    score: float = -math.inf
    pushes: tuple[PushEstimate, ...] = ()
    explained: float = math.nan
    nis: float = math.nan
    spent: float = 0.0
    rest: Array = field(default_factory=lambda: np.zeros(0), repr=False)
    values: Array = field(default_factory=lambda: np.zeros(0), repr=False)
    run: FilterRun | None = field(default=None, repr=False)


def fits(bank: Bank) -> list[FaultFit]:
    """The best of each kind of fault that the filter itself does not search for, and of none, each with the pushes that
    it needs; the likeliest first."""
    best = [with_pushes(bank)]
    kinds = [(one.fault, one.way) for one in bank.faults if one.fault not in SEARCHED]
    for kind in dict.fromkeys(kinds):
        some = [one for one in bank.faults if (one.fault, one.way) == kind]
        some.sort(key=lambda one: least_squares(bank.y, one)[1])
        best.append(max((with_pushes(bank, one) for one in some[:TRIED]), key=lambda f: f.score))
    best += [fit for way in SUDDEN if any(one.way == way for one in bank.faults) for fit in _sudden(bank, way)]
    return sorted(best, key=lambda f: -f.score)


def with_commands(bank: Bank, fits: Sequence[FaultFit]) -> list[FaultFit]:
    """Faults of the commands beside pushes: the filter's own search knows of no push, and takes it for part of them."""
    pushed = next(fit for fit in fits if fit.fault == "none")
    several: list[FaultFit] = []
    for kind in dict.fromkeys((one.fault, one.way) for one in bank.faults if one.fault in SEARCHED):
        places = [i for i, one in enumerate(bank.faults) if (one.fault, one.way) == kind]
        i = min(places, key=lambda i: least_squares(pushed.rest, bank.faults[i])[1])
        size = least_squares(pushed.rest, bank.faults[i])[0]
        beside = with_pushes(bank, bank.faults[i])
        several.append(replace(beside, way=(fit := as_fit(bank, i, size)).way, size=fit.size))
    return [fit for fit in several if fit.score > fits[0].score - NEAR_BEST]


def as_fit(bank: Bank, i: int, size: float) -> FaultFit:
    """A signature of the bank as a fault; of a part of the commands, the fault that the filter itself looks for."""
    one = bank.faults[i]
    fit = FaultFit(
        fault=one.fault, way=one.way, onset=one.onset, size=float(size) * (one.size or 1.0) if one.free else one.size,
        values=size * one.values,
    )  # fmt: skip
    if one.way == PART and one.fault == "weak":
        return replace(fit, way="pwm", size=float(np.clip(1 - size, 0.03, 0.97)))
    return replace(fit, way="") if one.way == PART else fit


def _sudden(bank: Bank, way: str) -> list[FaultFit]:
    """The gyro's offset that explains most of what follows within `SUDDEN` of its onset, before the filter is lost; of
    sudden ones also that of what shows first."""
    offsets = [one for one in bank.faults if (one.fault, one.way) == ("bias", way)]
    onsets = np.array([one.onset for one in offsets])
    inside = (bank.then[:, None] >= onsets - LATEST) & (bank.then[:, None] < onsets + SUDDEN[way])
    A = np.column_stack([one.values[: len(inside)] for one in offsets]) * inside
    y = bank.y[: len(inside)]
    dots = A.T @ y
    squares = np.maximum((A**2).sum(axis=0), 1e-12)
    explains = dots**2 / squares
    there = (y**2) @ inside
    places = {int(np.argmax(explains))}
    shows = np.flatnonzero((explains > FIRST_PART * there) & (explains > FIRST_SHOWS * bank.scale))
    if way == "step" and len(shows):
        first = onsets[shows[0]]
        places.add(int(np.argmax(np.where((onsets >= first) & (onsets < first + SUDDEN[way]), explains, 0.0))))
    return [with_pushes(bank, offsets[i], amplitude=-float(dots[i] / squares[i])) for i in places]


def least_squares(y: Array, signature: Signature) -> tuple[float, float]:
    """The amplitude of least squares, and the squares that it leaves."""
    a = signature.values
    amplitude = -float(a @ y) / max(float(a @ a), 1e-12) if signature.free else 1.0
    return amplitude, float(((y + amplitude * a) ** 2).sum())


def with_pushes(
    bank: Bank,
    signature: Signature | None = None,
    *,
    against: Bank | None = None,
    amplitude: float | None = None,
    beside: Array | None = None,
) -> FaultFit:
    """A hypothesis (None: no fault, or one that the bank's run was freed of before, `against` the bank of the run as it
    was) with the pushes that it needs beside it; with `beside`, the innovations that another fault leaves, the second
    of two."""
    y = bank.y if beside is None else beside
    size = 0.0
    spent = FAULT_NUMBERS * (bool(against or signature) + (beside is not None))
    spent += MORE_NUMBERS.get(signature.fault, 0) if signature else 0
    values = np.zeros(len(y))
    if signature is not None:
        size = least_squares(y, signature)[0] if amplitude is None else amplitude
        values = size * signature.values
        y = y + values
    first = against or bank
    best = score_of(first, y, spent)
    pushes = list[PushEstimate]()
    free = np.ones(len(bank.pushes), dtype=np.bool_)
    for _ in range(MOST_PUSHES if len(bank.pushes) else 0):
        dots = bank.dots(y)
        i = int(np.argmax(np.where(free, dots**2 / bank.squares, 0.0)))
        force = -float(dots[i] / bank.squares[i])
        after = y + force * bank.push(i)
        score = score_of(first, after, spent + PUSH_NUMBERS)
        if score < best + LEAST_GAIN:
            break
        start, stop, height = bank.pushes[i].tolist()
        pushes.append(PushEstimate(start, stop, force * (stop - start), height, score - best))
        y = after
        best = score
        spent = spent + PUSH_NUMBERS
        free &= (bank.pushes[:, 0] > stop + PUSH_GAP) | (bank.pushes[:, 1] < start - PUSH_GAP)
    nis = float(y @ y) / len(y)
    explained = 1 - nis / max(float(first.y @ first.y) / len(first.y), 1e-12)
    fit = FaultFit(
        fault="none", score=best, pushes=tuple(pushes), explained=explained, nis=nis, spent=spent, rest=y, values=values
    )
    if signature is None:
        return fit
    onset = _first_slip(bank, signature) if signature.fault == "slip" else signature.onset
    size = size * (signature.size or 1.0) if signature.free else signature.size
    return replace(fit, fault=signature.fault, way=signature.way, onset=onset, size=size)


def freed_of(fit: FaultFit, fault: FaultFit) -> FaultFit:
    """`fit` as that of a log freed of `fault`, whose numbers it has."""
    return replace(
        fit, fault=fault.fault, way=fault.way, onset=fault.onset, size=fault.size, rise=fault.rise, more=fault.more
    )


def _first_slip(bank: Bank, slip: Signature) -> float:
    """When a slip first shows in a reading by more than its noise: a floor may be slippery long before."""
    shows = np.flatnonzero(np.abs(slip.values[: len(bank.then)]) > VISIBLE_SLIP)
    return float(bank.then[shows[0]]) if len(shows) else slip.onset


def score_of(bank: Bank, rest: Array, spent: float) -> float:
    """Log likelihood [nats] against nothing at all, of readings whose noise has any scale from the usual one up, less
    the penalty for `spent` free numbers."""
    size = len(bank.y)
    n = size / CORRELATED
    floor = size * bank.scale
    squares = (rest @ rest) * size / len(rest)
    return n / 2 * math.log((bank.y @ bank.y + floor) / (squares + floor)) - spent * math.log(n)


def sharper(size: int, nis: float, scale: float, noise: float) -> float:
    """What the score of a hypothesis that leaves `nis` of so many readings, whose noise has a `scale` or more, gains
    [nats, up to a constant of the log] where the `noise` of the log (NIS) is known.

    Quiet seconds show it as well as so many readings more (inverse gamma prior, Student's t), and a filter that
    expects more noise than there is hides in it what a second fault does.
    """
    return size / CORRELATED * (math.log(nis + scale) / 2 - math.log(nis + noise))


def exceeding(two: FaultFit, one: FaultFit, scale: float, quiet: float) -> float:
    """How many nats more `two` has than `one` by the noise that it leaves, or by that of `quiet` seconds (NIS)."""
    noise = max(quiet, two.nis)
    more, lesser = (fit.score + sharper(len(two.rest), fit.nis, scale, noise) for fit in (two, one))
    return more - lesser


def gainable(bank: Bank, nis: float, quiet: float) -> float:
    """How many nats more than one that leaves `nis` a hypothesis has, before it pays for its numbers, that leaves no
    more than `quiet` seconds do."""
    return len(bank.y) / CORRELATED * math.log((max(nis, quiet) + quiet) / (2 * quiet))


def spared(bank: Bank, spent: float) -> float:
    """How many nats cheaper two faults of an onset and a size each are than so many free numbers."""
    return (spent - 2 * FAULT_NUMBERS) * math.log(len(bank.y) / CORRELATED)


def numbers_of(fault: str) -> int:
    """How many free numbers a fault has."""
    return FAULT_NUMBERS + MORE_NUMBERS.get(fault, 0)


def dearer(fit: FaultFit, numbers: float, bank: Bank) -> FaultFit:
    """The fit with the price of more free `numbers`."""
    spent = fit.spent + numbers
    return replace(fit, spent=spent, score=score_of(bank, fit.rest, spent))


def remaining(run: FilterRun, fit: FaultFit) -> float:
    """The gyro's offset, or the wrong scale of a sensor, that a run still has from the onset of `fit` on, by least
    squares."""
    some = (scales if fit.fault == "scale" else biases)(run, np.array([fit.onset]))
    offset = next(one for one in some if one.way == fit.way)
    basis = unknown_parameters(run)
    y = beside(basis, run.whitened)
    return least_squares(y, replace(offset, values=beside(basis, offset.values)))[0]
