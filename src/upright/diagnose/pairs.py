"""Two causes at once: which second fault explains most of what a first one leaves, while the first one gives way to it.

A fault that is fitted alone takes up part of another one, and what it leaves then misleads. So each second fault is
judged beside changes of the first one's onset and size (a Gauss-Newton step for all signatures at once). The likeliest
pairs are then searched by the filter itself.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.diagnose.fault_fits import (
    FAULT_NUMBERS,
    PUSH_NUMBERS,
    FaultFit,
    as_fit,
    dearer,
    exceeding,
    freed_of,
    gainable,
    least_squares,
    numbers_of,
    score_of,
    with_pushes,
)
from upright.diagnose.innovations import FilterRun, Signature
from upright.diagnose.remedy import (
    FADE_PRICE,
    FREED,
    RARE,
    Window,
    exact,
    faded,
    followed,
    lately,
    moved,
    remedied,
)
from upright.diagnose.signatures import Bank, beside, pushing
from upright.diagnose.sizes import natural
from upright.diagnose.usual import quiet_of

BESIDE = ("ramp", "payload", "radius")  # faults whose signature may stand beside one that a log was freed of
MOST_PAIRS = 4  # that the filter itself searches
MORE = 2  # faults, besides the likeliest, beside which another one is looked for
UNLIKELY = 150.0  # nats behind the likeliest, from which no second fault is looked for
TRIED = 3  # signatures of the second kind that are tried with pushes beside them
CONTRIBUTES = 10.0  # nats that each of both must explain beyond the other one to be one of two
BEHIND = 10.0  # nats behind the likeliest, that a start must promise to be searched where that one leaves only noise
FAR_BEHIND = 100.0  # most of it where it leaves more: the search gains as much where it begins at the right kinds
RIVALS = 20.0  # nats behind the likeliest, up to which another pair may be the right one
NEAR = 8  # signatures of one kind round its onset, one of which stands for it while the other one is searched
ALIKE = 0.02  # of a signature's squares, that must be left beside the first fault's changes
ROUNDS = 2  # most times that the one is searched beside the other's signature where it then is
ONSET_CHANGE, SIZE_CHANGE, RISE_CHANGE = 0.06, 1.15, 0.1  # [s], a factor, [s]: changes that give the slopes
MOST_CHANGES = 3.0  # of these changes, by which a first fault is moved before the filter searches


@dataclass(frozen=True, eq=False, kw_only=True)
class Pair:
    """Two faults that explain the innovations together, by the `score` of both, and by `beyond` [nats] more than either
    of them as it is here."""

    first: FaultFit
    second: FaultFit
    beyond: float = math.inf

    @property
    def score(self) -> float:
        """Log likelihood ratio [nats] of both, less the penalty."""
        return self.second.score - RARE * _rare(self.first, self.second)

    @property
    def both(self) -> FaultFit:
        """What both leave, with the score of both."""
        return replace(self.second, score=self.score)


def _rare(*fits: FaultFit) -> int:
    """How many of some faults follow the motion, so that they take up a part of whatever else is wrong."""
    return sum(fit.fault in ("scale", "radius", "friction") and not natural(fit) for fit in fits)


@dataclass(frozen=True, eq=False, kw_only=True)
class _Start:
    """Where the search for a pair begins: the first fault as it was alone and as the second one `changed` it,
    signatures of which one stands for the other fault, those of `pushes` beside both (readings, signatures), the
    `basis` of unknown parameters, and the score that both promise."""

    first: FaultFit
    changed: FaultFit
    second: FaultFit
    near: Array
    pushes: Array
    basis: Array
    promise: float


def paired(run: FilterRun, fits: Sequence[FaultFit], window: Window, bank: Bank) -> list[Pair]:
    """Two faults at once, the likeliest first."""
    best: dict[tuple[str, str], FaultFit] = {}
    for fit in fits:
        if fit.fault not in ("none", "dropped"):  # a battery that limits the commands leaves small ones as they are
            best.setdefault((fit.fault, fit.way if fit.fault == "weak" else ""), fit)
    several = list(best.values())
    likely = [fit for fit in several[1:] if fit.score > several[0].score - UNLIKELY]
    forces = [fit for fit in likely if fit.fault in BESIDE and fit.run is None]
    firsts = several[:1] + forces + [fit for fit in likely if fit.run is not None][:MORE]
    firsts += [fit for fit in likely if fit.fault == "weak" and not any(fit is one for one in firsts)]
    starts: dict[frozenset[str], _Start] = {}
    for one in firsts:
        for start in _starts(run, one, window, bank):
            kinds = frozenset((_kind(one), _kind(start.second)))
            if kinds not in starts or start.promise > starts[kinds].promise:
                starts[kinds] = start
    pairs = list[Pair]()
    quiet = quiet_of(run, window)
    order = sorted(starts.values(), key=lambda one: -one.promise)
    moving = [start for start in order if _movable(start.first, start.second)[0]][:MOST_PAIRS]
    for start in (start for start in order[:MOST_PAIRS] if start not in moving):
        pairs += _searched(run, start, window, bank)
    for start in moving:
        top = max(pairs, key=lambda pair: pair.score, default=None)
        more = 0.0 if top is None else gainable(bank, top.second.nis, quiet)
        if top is None or start.promise > top.score - min(BEHIND + more, FAR_BEHIND):
            pairs += _searched(run, start, window, bank)
    return sorted(pairs, key=lambda pair: -pair.score)


def _kind(fault: FaultFit | Signature) -> str:
    """What is searched as one: a gyro's offset that grows and one that stays are none, nor are a battery's two ways."""
    return f"{fault.fault} {fault.way}" if fault.fault in ("bias", "weak") else fault.fault


def contributing(run: FilterRun, pairs: Sequence[Pair], single: float, window: Window, bank: Bank) -> list[Pair]:
    """The likeliest pair of which neither fault, as the pair has it, explains as much alone, and others that explain
    nearly as much, one of each two faults; the likeliest first, and none that is far behind the best `single` fault's
    score."""
    kept: dict[frozenset[str], Pair] = {}
    for pair in sorted(pairs, key=lambda pair: -pair.score):
        kinds = frozenset((pair.first.fault, pair.second.fault))
        least = max([single, *(one.score for one in kept.values())]) - RIVALS
        if kinds not in kept and pair.score > least:
            judged = replace(pair, beyond=_beyond(run, pair, window, bank))
            if judged.beyond > CONTRIBUTES:
                kept[kinds] = judged
    return list(kept.values())


def _beyond(run: FilterRun, pair: Pair, window: Window, bank: Bank) -> float:
    """How many nats more both have than either fault with the size and onset that it has in the pair."""
    more = [math.inf]
    quiet = quiet_of(run, window)
    for fit in (pair.first, pair.second):
        if fit.fault in FREED:
            one = exact(run, replace(fit, score=-math.inf, run=None), window, bank)
            if len(one.rest):  # else the filter loses the robot
                one = replace(one, score=one.score - RARE * _rare(fit))
                more.append(exceeding(pair.both, one, bank.scale, quiet))
    return min(more)


def _starts(run: FilterRun, first: FaultFit, window: Window, bank: Bank) -> list[_Start]:
    """For each kind of second fault the signature that explains most beside changes of the first one, and beside the
    pushes before it or all of its pushes."""
    here = window.beside(first, bank)
    y = bank.y + first.values if first.run is None else here.y
    others = [i for i, one in enumerate(here.faults) if one.fault != first.fault]
    if not others or len(y) != len(here.y):
        return []
    matrix = np.array([here.faults[i].values for i in others])
    names, slopes = _slopes(run, first, window, here)
    part = window.of(first.run or run)
    starts: list[_Start] = []
    for pushes in {tuple(push for push in first.pushes if push.start < first.onset), first.pushes}:
        edges = [(push.start, push.stop, push.height) for push in pushes]
        beyond = beside(here.basis, pushing(part, edges)) if edges else np.zeros((len(y), 0))
        known = np.column_stack([slopes, beyond])
        spent = numbers_of(first.fault) + FADE_PRICE * (first.rise > 0) + PUSH_NUMBERS * len(edges)
        for i, size, rest, step in _explained(here, y, matrix, others, known):
            second = as_fit(here, i, size)
            promise = score_of(bank, rest, spent + numbers_of(second.fault)) - RARE * _rare(first, second)
            changed = _changed(first, names, step[: len(names)])
            starts.append(
                _Start(
                    first=first, changed=changed, second=second, near=_near(here, i) if names else slopes,
                    pushes=beyond, basis=here.basis, promise=promise,
                )
            )  # fmt: skip
    return starts


def _explained(
    here: Bank, y: Array, matrix: Array, others: Sequence[int], known: Array
) -> list[tuple[int, float, Array, Array]]:
    """For each kind of fault among the signatures `others` of a bank (their values are the rows of `matrix`), the one
    that explains most of y beside `known` changes (readings, changes): its place, size, what it leaves, and how large
    those changes are."""
    Q = np.linalg.qr(known)[0]
    left = y - Q @ (Q.T @ y)
    squares = np.maximum((matrix**2).sum(axis=1), 1e-12)
    dots = matrix @ left
    own = np.maximum(squares - ((matrix @ Q) ** 2).sum(axis=1), ALIKE * squares)
    free = np.array([here.faults[i].free for i in others])
    size = np.where(free, -dots / own, 1.0)
    explained = -(2 * size * dots + size**2 * own)
    kinds = np.array([_kind(here.faults[i]) for i in others])
    chosen: list[tuple[int, float, Array, Array]] = []
    for kind in dict.fromkeys(kinds.tolist()):
        k = int(np.argmax(np.where(kinds == kind, explained, -np.inf)))
        both = y + size[k] * matrix[k]
        step = -np.linalg.lstsq(known, both, rcond=1e-6)[0]
        chosen.append((others[k], float(size[k]), both + known @ step, step))
    return chosen


def _near(here: Bank, i: int) -> Array:
    """The signatures of one kind whose onsets are nearest to that of signature i (readings, signatures)."""
    one = here.faults[i]
    same = [o for o in here.faults if o.fault == one.fault]
    same.sort(key=lambda o: (abs(o.onset - one.onset), o.way != one.way))
    return np.column_stack([o.values for o in same[:NEAR]])


def _slopes(run: FilterRun, first: FaultFit, window: Window, here: Bank) -> tuple[list[str], Array]:
    """What changes of a fault's onset, size and rise do to the innovations that it leaves (readings, changes); of a
    fault that is only known by its signature, those with nearby onsets."""
    if first.run is None or first.fault not in FREED:
        same = [one for one in here.faults if (one.fault, one.way) == (first.fault, first.way)]
        same.sort(key=lambda one: abs(one.onset - first.onset))
        return [], np.column_stack([one.values for one in same[:NEAR]] or [np.zeros(len(here.y))])
    recent = lately(run, window)

    def left(fit: FaultFit) -> Array:
        freed = remedied(recent, fit)
        return np.zeros(0) if freed is None else window.of(freed).whitened

    usual = left(first)
    names = list[str]()
    columns = list[Array]()
    for name in ("onset", "size", "rise"):
        for way in (1.0, -1.0):  # a sensor at the end of its range may lose readings by the one
            changed = _changed(first, [name], np.array([way]))
            if changed is not first and len(values := left(changed)) == len(usual) == len(here.then):
                names.append(name)
                columns.append(way * (values - usual))
                break
    if not columns:
        return [], np.zeros((len(here.y), 1))
    return names, beside(here.basis, np.column_stack(columns))


def _changed(fit: FaultFit, names: Sequence[str], step: Array) -> FaultFit:
    """A fault with its onset, size and rise changed by so many times the changes that give their slopes."""
    for name, change in zip(names, np.clip(step, -MOST_CHANGES, MOST_CHANGES).tolist(), strict=True):
        if name == "onset":
            fit = replace(fit, onset=fit.onset + change * ONSET_CHANGE)
        elif name == "size" and fit.fault == "scale":
            fit = replace(fit, size=fit.size + 0.1 * change)
        elif name == "size" and fit.fault != "motor":
            size = fit.size * SIZE_CHANGE**change
            fit = replace(fit, size=min(size, 0.97) if fit.fault == "weak" else size)
        elif name == "rise" and fit.fault == "weak":
            fit = replace(fit, rise=max(0.0, fit.rise + change * RISE_CHANGE))
    return fit


def _searched(run: FilterRun, start: _Start, window: Window, bank: Bank) -> list[Pair]:
    """The pair that the filter itself finds from a start; of two signatures, as they are."""
    several, other = _movable(start.first, start.second)
    if not several:
        return [together(run, start.first, start.second, window, bank)]
    if other is not None:
        tries = [[start.first], [start.changed]] if other is start.second else [[one] for one in faded(start.second)]
        pairs: list[Pair] = []
        near = start.near
        while len(near) == len(start.pushes) and len(pairs) < ROUNDS:
            columns = [np.column_stack([start.pushes, one]) for one in near.T]
            searched = moved(run, tries, window, start.basis, columns)
            pair, near = _beside_signature(run, searched, other, window, bank)
            pairs.append(pair)
            tries = [[pair.first]]
        return pairs
    tries = [[one, two] for one in (start.first, start.changed) for two in faded(start.second)]
    first, second = moved(run, tries, window, start.basis, [start.pushes] if start.pushes.size else [])
    return [together(run, first, second, window, bank)]


def _movable(first: FaultFit, second: FaultFit) -> tuple[list[FaultFit], FaultFit | None]:
    """Which of both a log can be freed of, where all or the other's signature can be searched, and that other one."""
    fits = (first, second)
    several = [fit for fit in fits if fit.fault in FREED]
    other = next((fit for fit in fits if fit.fault in BESIDE), None)
    return (several if len(several) == 2 or other else []), other


def together(run: FilterRun, first: FaultFit, second: FaultFit, window: Window, bank: Bank) -> Pair:
    """A pair with what it leaves: of the log without both where it can be freed of them, else of the log without one
    beside the other's signature, or by the signatures of both."""
    several, other = _movable(first, second)
    if several and other is not None:
        return _beside_signature(run, several, other, window, bank)[0]
    if several and (freed := followed(run, window.end, *several)) is not None:
        here = window.bank(freed)
        last = several[1]
        again = freed_of(with_pushes(here, against=bank, beside=here.y), last)
        return Pair(first=first, second=replace(_priced(again, several, bank), run=freed))
    if not len(first.values) == len(second.values) == len(bank.y):  # made on a run of fewer readings
        return Pair(first=first, second=second)
    again = with_pushes(bank, against=bank, beside=bank.y + first.values + second.values)
    return Pair(
        first=first,
        second=replace(
            _priced(again, [first, second], bank), fault=second.fault, way=second.way, onset=second.onset,
            size=second.size,
        ),
    )  # fmt: skip


def _beside_signature(
    run: FilterRun, several: Sequence[FaultFit], other: FaultFit, window: Window, bank: Bank
) -> tuple[Pair, Array]:
    """A fault that the log is freed of, and the signature of the `other` that explains most of the rest, with those
    near it (readings, signatures)."""
    freed = followed(run, window.end, *several)
    lost = Pair(first=several[0], second=other)
    if freed is None:
        return lost, np.zeros((0, 0))
    here = window.bank(freed, beside_it=other.fault)
    some = sorted(range(len(here.faults)), key=lambda i: least_squares(here.y, here.faults[i])[1])[:TRIED]
    if not some:
        return lost, np.zeros((0, 0))
    tried = [(with_pushes(here, here.faults[i], against=bank, beside=here.y), i) for i in some]
    again, i = max(tried, key=lambda one: one[0].score)
    second = replace(_priced(again, [*several, other], bank), run=freed)
    return Pair(first=several[0], second=second), _near(here, i)


def _priced(fit: FaultFit, several: Sequence[FaultFit], bank: Bank) -> FaultFit:
    """The fit of two faults with the price of the numbers that these have beyond onset and size."""
    more = sum(numbers_of(one.fault) for one in several) - FAULT_NUMBERS - numbers_of(fit.fault)  # which its price has
    return dearer(fit, more + FADE_PRICE * sum(one.rise > 0 for one in several), bank)
