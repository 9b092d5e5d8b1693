"""The numbers of faults, and of the forces beside them, all at once: each alone stays where the others' errors led it.

Steps that change one number after the other do not reach the bottom of a narrow valley: an onset, a size and a push
make up for each other. So the filter runs again for a small change of each number of the faults, the observer of
`forces` for those of the forces, and all of them move together (Gauss-Newton).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from upright.arrays import Array
from upright.diagnose.fault_fits import FaultFit, gainable, score_of
from upright.diagnose.forces import FORCED, LOST, ForceSearch, Observer, least_squares, refined
from upright.diagnose.innovations import FilterRun
from upright.diagnose.pairs import CONTRIBUTES, RIVALS, Pair, together
from upright.diagnose.remedy import (
    FADE,
    FREED,
    LONGEST,
    ONSET_STEP,
    READING_FAULTS,
    STRONGEST,
    WEAKEST,
    Window,
    exact,
    followed,
    lately,
    priced,
    remedied,
)
from upright.diagnose.signatures import YOUNGEST, Bank, beside, unknown_parameters
from upright.diagnose.sizes import ALL
from upright.diagnose.usual import quiet_of

CHANGES = {"bias": 0.01, "scale": 0.01, "weak": 0.04, "delay": 0.02, "friction": 0.02}
"""A small change of each fault's size, in its own unit: of a battery more, since a driver's duty has steps."""

FADING_CHANGE = 0.04  # [s] of a battery's onset and of the time in which it breaks down
SLOWER = 0.6  # of the time in which a battery breaks down, by which other starts differ
OTHER_DELAYS = (0.5, 2.0)  # of a delay, by which other starts differ
OTHER_ONSETS = (-0.5, -0.25, 0.25, 0.5)  # of the step between the first onsets: the same of a stiff wheel
SHORTEST_RISE = 0.02  # [s] in which a battery breaks down
TAKE_TORQUE = ("weak", "friction", "motor")  # faults that act alike
LEAST_DELAY = 0.05  # periods
DAMPINGS = (1e-6, 1e-3, 1e-1)  # of a step, over its curvature
STRIDES = (2.0, 4.0)  # of a step: a narrow valley is long
MOST, BEHIND = 3, 150.0  # faults whose numbers are moved together, and their nats behind the likeliest
ALIKE = 5.0  # nats behind, up to which a pair with pushes that were looked for again is searched again
WORTH = 15.0  # nats that a pair must still be able to gain, for its faults to be tried in other ways


def _names(fit: FaultFit) -> tuple[str, ...]:
    if fit.fault == "motor":
        return ("onset",)
    return ("onset", "size", "rise") if fit.rise > 0 else ("onset", "size")


def _scales(fit: FaultFit) -> tuple[float, float]:
    """Fractions of a reading that may be too much: without all of it nothing is left to follow."""
    return (-math.inf, ALL) if fit.size < 1 else (2 - ALL, math.inf)


@dataclass(frozen=True, eq=False)
class _Joint:
    """Faults that a log can be freed of, and the forces of a `fit` beside them."""

    recent: FilterRun
    window: Window
    several: tuple[FaultFit, ...]
    fit: FaultFit
    basis: Array
    searches: dict[tuple[float, ...], ForceSearch | None] = field(default_factory=dict)

    @property
    def count(self) -> int:
        """How many numbers the faults have."""
        return sum(len(_names(fit)) for fit in self.several)

    def first(self) -> Array:
        """Where the search begins."""
        own = [float(getattr(fit, name)) for fit in self.several for name in _names(fit)]
        search = self.search(np.array(own))
        return np.array(own) if search is None else np.concatenate([own, search.inside(search.first())])

    def faults(self, x: Array) -> list[FaultFit]:
        """The faults by their numbers."""
        numbers = iter(x[: self.count].tolist())
        return [replace(fit, **{name: next(numbers) for name in _names(fit)}) for fit in self.several]

    def search(self, x: Array) -> ForceSearch | None:
        """That of the forces where the log is freed of faults with these numbers; None where the filter is lost."""
        key = tuple(x[: self.count].tolist())
        if key not in self.searches:
            freed = remedied(self.recent, *self.faults(x))
            part = None if freed is None else self.window.of(freed)
            here = part is not None and int(part.readings.sum()) + self.basis.shape[1] == len(self.basis)
            left = beside(self.basis, part.whitened) if part is not None and here else None
            self.searches[key] = (
                ForceSearch(Observer(part), self.fit, left, self.basis) if part and left is not None else None
            )
        return self.searches[key]

    def changes(self, x: Array) -> Array:
        """A small change of each number."""
        own: list[float] = []
        for fit in self.several:
            seconds = FADING_CHANGE if fit.rise > 0 else self.recent.log.period
            own += [CHANGES[fit.fault] if name == "size" else seconds for name in _names(fit)]
        search = self.search(x)
        assert search is not None, "the search begins where the filter follows"
        return np.concatenate([own, search.steps(len(x) - len(own))])

    def inside(self, x: Array) -> Array:
        """The nearest numbers that a robot meets."""
        x = x.copy()
        limits = list[tuple[float, float]]()
        for fit in self.several:
            whole = {"weak": (WEAKEST, STRONGEST), "delay": (LEAST_DELAY, LONGEST), "scale": _scales(fit)}
            whole |= {"friction": (0.0, math.inf)}
            known = {
                "onset": (float(self.recent.log.t[0]), self.window.end - YOUNGEST),
                "size": whole.get(fit.fault, (-math.inf, math.inf)), "rise": (SHORTEST_RISE, math.inf),
            }  # fmt: skip
            limits += [known[name] for name in _names(fit)]
        x[: len(limits)] = np.clip(x[: len(limits)], *np.array(limits).T)
        search = self.search(x)
        return x if search is None else np.concatenate([x[: len(limits)], search.inside(x[len(limits) :])])

    def rest(self, *several: Array) -> Array:
        """What numbers leave of the innovations (readings, lanes)."""
        left = np.full((len(self.basis), len(several)), LOST)
        keys = [tuple(x[: self.count].tolist()) for x in several]
        for key in dict.fromkeys(keys):
            lanes = [i for i, one in enumerate(keys) if one == key]
            search = self.search(several[lanes[0]])
            if search is not None:
                left[:, lanes] = search.rest(*(several[i][self.count :] for i in lanes))
        return left


def jointly(
    run: FilterRun, several: Sequence[FaultFit], fit: FaultFit, window: Window, bank: Bank
) -> tuple[list[FaultFit], FaultFit]:
    """Faults that a log can be freed of, and a fit with the forces beside them, of all numbers that leave least."""
    usual = list(several), fit
    if fit.run is None:
        return usual
    joint = _Joint(lately(run, window), window, tuple(several), fit, unknown_parameters(window.of(fit.run), fit.nis))
    x = joint.first()
    if joint.search(x) is None:
        return usual
    x = least_squares(joint, x, joint.changes(x), DAMPINGS, STRIDES)
    search, faults = joint.search(x), joint.faults(x)
    freed = followed(run, window.end, *faults)
    if search is None or freed is None:
        return usual
    start = replace(search.placed(x[joint.count :]), run=freed, score=-math.inf)
    moved = refined(run, start, window, bank)
    return (faults, moved) if moved.score > fit.score else usual


def settled(run: FilterRun, fits: Sequence[FaultFit], window: Window, bank: Bank) -> list[FaultFit]:
    """All fits, the likeliest of those that a log can be freed of with all of their numbers moved together; the
    likeliest first."""
    several = list(fits)
    moved = dict[str, int]()
    top = max(fit.score for fit in fits)
    for i, fit in enumerate(fits):
        free = fit.run is not None and fit.fault in FREED
        if free and fit.fault not in moved and len(moved) < MOST and fit.score > top - BEHIND:
            moved[fit.fault] = i
            several[i] = _one(run, fit, _starts(fit), window, bank)
    for i in moved.values():
        several[i] = _one(run, several[i], _as_another(several[i], several), window, bank)
    return sorted(several, key=lambda fit: -fit.score)


def _as_another(fit: FaultFit, fits: Sequence[FaultFit]) -> list[FaultFit]:
    """The fault from where the likeliest other one that takes torque away was found, beside its pushes: a search that
    ended in another valley says that the lesser cause explains more."""
    if fit.fault not in TAKE_TORQUE:
        return []
    others = [one for one in fits if one.fault in TAKE_TORQUE and one.fault != fit.fault and one.run is not None]
    best = max(others, key=lambda one: one.score, default=fit)
    return [replace(fit, onset=best.onset, pushes=best.pushes)]


def _one(run: FilterRun, fit: FaultFit, starts: Sequence[FaultFit], window: Window, bank: Bank) -> FaultFit:
    """A fault by all of its numbers, from several starts."""
    best = fit
    price = score_of(bank, fit.rest, fit.spent) - fit.score
    for start in starts:
        freed = fit.run if start is fit else followed(run, window.end, start)
        if freed is None:
            continue
        (fault,), moved = jointly(run, [start], replace(start, run=freed, score=-math.inf), window, bank)
        moved = replace(moved, score=moved.score - price, **{name: getattr(fault, name) for name in _names(fit)})
        best = max(best, moved, key=lambda one: one.score)
    return best


def _starts(fit: FaultFit) -> list[FaultFit]:
    """The fault, a delay of other sizes, a stiff wheel since other times, and beside a push a battery that breaks down
    within another time, about the same middle: it has a narrow valley."""
    if fit.fault == "friction":
        return [fit, *(replace(fit, onset=fit.onset + part * ONSET_STEP) for part in OTHER_ONSETS)]
    if fit.fault == "delay":
        return [fit, *(replace(fit, size=min(part * fit.size, LONGEST)) for part in OTHER_DELAYS)]
    if fit.rise == 0 or not fit.pushes:
        return [fit]
    rises = [(1 + part) * fit.rise for part in (-SLOWER, SLOWER)]
    return [fit, *(replace(fit, rise=rise, onset=fit.onset - (rise - fit.rise) / 2) for rise in rises)]


def pair_settled(run: FilterRun, pair: Pair, window: Window, bank: Bank) -> Pair:
    """The pair with all of its numbers moved together, where the log was freed of one of both or of both."""
    first, second = pair.first, pair.second
    if second.run is None or second.fault == "slip":
        return pair
    free = [fit for fit in (first, second) if fit.fault in FREED]
    if first not in free or (second not in free and second.fault not in FORCED):
        return pair
    faults, best = jointly(run, free, replace(second, score=-math.inf), window, bank)
    if second in free:
        best = replace(best, **{name: getattr(faults[1], name) for name in _names(second)})
    moved = replace(pair, first=faults[0], second=best)
    return moved if moved.score > pair.score else pair


def pairs_settled(run: FilterRun, pairs: Sequence[Pair], single: float, window: Window, bank: Bank) -> list[Pair]:
    """All pairs, those that may be the likeliest with all of their numbers moved together; and the likeliest of all,
    with each rival, in their other ways where these could explain more; `single` is the score of the best fault."""
    moved = list[Pair]()
    quiet = quiet_of(run, window)

    def may_reach(pair: Pair) -> float:
        return pair.score + gainable(bank, pair.second.nis, quiet) if len(pair.second.rest) else pair.score

    for pair in sorted(pairs, key=lambda pair: -pair.score):
        top = max((one.score for one in moved), default=single + CONTRIBUTES)
        moved.append(pair_settled(run, pair, window, bank) if may_reach(pair) > top else pair)
    top = max((pair.score for pair in moved), default=0.0)
    tried = set[frozenset[str]]()
    for pair in sorted(moved, key=lambda pair: -pair.score):
        kinds = frozenset((pair.first.fault, pair.second.fault))
        if kinds in tried or pair.score < top - RIVALS or may_reach(pair) < max(pair.score, single) + WORTH:
            continue
        tried.add(kinds)
        firsts, seconds = ([fit, *_otherwise(fit, window.end)] for fit in (pair.first, pair.second))
        others = [(first, second) for first in firsts for second in seconds][1:]
        moved += [_again(run, first, second, top - BEHIND, window, bank) for first, second in others]
    return moved


def each_alone(run: FilterRun, pairs: Sequence[Pair], single: float, window: Window, bank: Bank) -> list[FaultFit]:
    """Each fault of the likeliest pair alone, from the numbers that it has there: a search that ended elsewhere made a
    second fault necessary. Only those that have more than the best `single` one, and no wrong reading from before the
    window: the robot stood with it."""
    several = list[FaultFit]()
    best = max(pairs, key=lambda pair: pair.score, default=None)
    for fit in (best.first, best.second) if best is not None and best.score > single else ():
        stood = fit.fault in READING_FAULTS and fit.onset < bank.then[0]
        if fit.fault in FREED and not stood:
            one = exact(run, replace(fit, score=-math.inf, pushes=(), run=None), window, bank)
            if len(one.rest) and one.score > single - BEHIND:
                several.append(priced(_one(run, one, _starts(one), window, bank), bank))
    return [fit for fit in several if fit.score > single]


def _again(run: FilterRun, first: FaultFit, second: FaultFit, least: float, window: Window, bank: Bank) -> Pair:
    """A pair with all of its numbers moved together, and once more beside the pushes that it then needs, where it has
    `least` [nats]."""
    pair = pair_settled(run, together(run, first, second, window, bank), window, bank)
    if pair.score < least:
        return pair
    again = together(run, pair.first, pair.second, window, bank)
    return pair_settled(run, again, window, bank) if again.score > pair.score - ALIKE else pair


def _otherwise(fit: FaultFit, end: float) -> list[FaultFit]:
    """The same fault in other ways, or one that acts alike, up to a time `end` [s]."""
    if fit.fault == "weak":
        return [replace(fit, way="limit" if fit.way == "pwm" else "pwm")]
    if fit.fault == "bias":  # as large in the middle
        half = (end - fit.onset) / 2
        if fit.way == "ramp":
            return [replace(fit, way="step", size=fit.size * half, onset=fit.onset + half / 2)]
        return [replace(fit, way="ramp", size=fit.size / half)]
    if fit.fault == "delay":
        return [replace(fit, way="" if fit.way == "readings" else "readings")]
    if fit.fault == "motor" and "both" in fit.way:
        weak = replace(fit, fault="weak", size=WEAKEST, rise=FADE, onset=fit.onset - FADE / 2)
        return [replace(weak, way=way) for way in ("limit", "pwm")]
    return []
