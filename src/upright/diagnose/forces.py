"""Pushes, slopes, loads and slippery floors by the equations of motion: where a robot falls, they are not small.

The bank's signatures are linear, on a grid of times and heights. From the best of them on, the numbers of all forces
are searched by an observer: the equations with these forces, corrected by the gains that the filter had.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Protocol

import numpy as np

from upright.arrays import Array
from upright.compiled.generated import constants
from upright.diagnose.changes import with_mass
from upright.diagnose.fault_fits import (
    PUSH_NUMBERS,
    VISIBLE_SLIP,
    FaultFit,
    PushEstimate,
    numbers_of,
    score_of,
    with_pushes,
)
from upright.diagnose.innovations import FilterRun
from upright.diagnose.remedy import Window
from upright.diagnose.signatures import YOUNGEST, Bank, beside, pushing, unknown_parameters
from upright.physics.dynamics import motor_damping, motor_gain
from upright.physics.integrate import PREDICTED
from upright.physics.steps import steps_of
from upright.robots import PARAMETERS, Robot

FORCED = {"ramp": 3, "load": 3, "radius": 2, "payload": 4, "slip": 1}
"""Faults that are forces or another robot, and how many numbers they have: onset [s], rise [s] and size; onset and the
lost part of the radius; onset, mass and height over those of the body, and the torque of its weight [N m]; the friction
coefficient of a floor."""

SUBSTEP = 0.001  # [s] of the motion of wheels that slip, which lose their load within milliseconds
GRIPS = np.geomspace(0.003, 0.3, 20)  # friction coefficients that are tried first
SINCE = 0.5  # [s] between the times from which the floor is tried
ROUNDS, ENOUGH = 12, 0.003  # most steps of a search, and the fraction of the squares from which it goes on
DAMPINGS = (1e-3, 1e-1, 1.0, 10.0)  # of a step, over its curvature (Levenberg and Marquardt)
SHORTEST, HIGHEST = 0.004, 2.2  # [s] of a push, and its height over that of the centre of mass
SLOWEST = 3.0  # [s] in which a slope or a load grows
BEHIND = 100.0  # nats behind the likeliest, up to which a hypothesis is searched
MOST = 6  # hypotheses that are searched
LEAVES = 1.2  # of the usual NIS, up to which the likeliest leaves nothing for a slip to explain
LITTLE = 0.5  # of the squares, that the floor by itself leaves where there may be a slip
STARTS = 3  # times from which the floor is slippery, from which a search starts
LOADS, APART = 3, 0.15  # onsets from which a load beside pushes is searched, and how far apart they are [s]
CHANGED = ((0.0, 0.0, 0.0), (0.0, 0.0, 0.1), (0.01, 0.0, 0.0), (0.0, 0.01, 0.0))
"""A push, and one that is higher [m], later [s] or longer [s]: what changes of it do lies between them."""
AGAIN = 2  # most times that pushes are looked for beside a slip
LOST = 1e6  # standard deviations that stand for an innovation of a robot that fell over


def sliding(p: Robot) -> Array:
    """The numbers of a robot's sums of forces on wheels that slip, in the order of `propagation.slide`."""
    total = p.body_mass + 2 * p.wheel_mass
    lever = p.body_mass * p.com_height
    rotors = p.gear_ratio**2 * p.rotor_inertia
    inertia = lever * p.com_height + p.pitch_inertia + 2 * rotors
    wheel = 2 * p.wheel_inertia + 2 * rotors
    numbers = (
        total, lever, inertia, wheel, 2 * rotors, p.wheel_radius, motor_gain(p), 2 * motor_damping(p),
        2 * p.wheel_friction, 2 * p.coulomb_friction, 2 * p.rolling_friction, max(p.stiction_rate, 1e-6), p.gravity,
    )  # fmt: skip
    return np.array(numbers)


@dataclass(frozen=True, eq=False)
class Observer:
    """The window's `part` of a run under forces that the run does not know of, and where its wheels `slip` in steps as
    short as that needs."""

    part: FilterRun
    slip: bool = False

    @cached_property
    def _followed(self) -> tuple[int, tuple[Array, ...]]:
        part = self.part
        longest = float(part.spans.max())
        steps = steps_of(part.robot, longest, PREDICTED)
        reads, error = part.reads[part.row], np.nan_to_num(part.innovation)
        reading = error + (reads * (part.after - part.gains * error[:, None])).sum(axis=1)
        deviation = np.where(part.readings, np.sqrt(part.variance), np.nan)
        arrays = (part.before[0], part.t, part.command, part.spans, reads, part.gains, reading, deviation, part.dry)
        contiguous = tuple(np.ascontiguousarray(one, dtype=np.float64) for one in arrays)
        return max(steps, math.ceil(longest / SUBSTEP)) if self.slip else steps, contiguous

    @cached_property
    def usual(self) -> Array:
        """The constants of the robot as it should be."""
        return self.constants({})

    def constants(self, changes: Mapping[str, float]) -> Array:
        """The constants of the robot with parameters that are larger by these amounts."""
        numbers = self.part.robot.numbers()
        values = [numbers[name] + changes.get(name, 0.0) for name in PARAMETERS]
        return np.array([float(np.ravel(one)[0]) for one in constants(values, 1.0)])

    @cached_property
    def _floor(self) -> Array:
        return sliding(self.part.robot)

    @cached_property
    def _unforced(self) -> Array:
        nothing = np.zeros((1, len(self.part.t), 2)), np.zeros((1, 2))
        return self._innovations(self.usual[None], np.full(1, np.inf), *nothing)[0]

    def _innovations(self, robots: Array, onsets: Array, forces: Array, floors: Array) -> Array:
        from upright.diagnose.propagation import observe

        steps, followed = self._followed
        robots = np.vstack([robots, self.usual])
        whitened = observe(steps, followed, self._floor, robots, onsets, forces, floors)[:, self.part.readings]
        return np.clip(np.nan_to_num(whitened, nan=LOST), -LOST, LOST)

    def added(self, robots: Array, onsets: Array, forces: Array, floors: Array) -> Array:
        """What `robots` by their constants (lanes, constants) from the onsets (lanes,) [s] on, `forces` [N] and moments
        [N m], (lanes, events, 2), and `floors` (lanes, 2) that hold no more than a fraction of the weight (0: any) from
        a time [s] on, add to the whitened innovations (readings, lanes)."""
        return (self._innovations(robots, onsets, forces, floors) - self._unforced).T

    def since(self, start: float, rise: float = 0.0) -> Array:
        """How much of a force that begins at `start` [s], and grows within a time [s], acts in each span (events,)."""
        t, spans = self.part.t, np.maximum(self.part.spans, 1e-9)
        return np.clip((t - spans / 2 - start) / rise if rise > 0 else (t - start) / spans, 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class ForceSearch:
    """The numbers of a fault (`FORCED`; of a floor `since` a time [s]), and of the pushes beside it by start, stop [s],
    impulse [N s] and height [m]; without them `left` (readings,) are the innovations."""

    observer: Observer
    fit: FaultFit
    left: Array
    basis: Array
    since: float = 0.0

    @property
    def own(self) -> int:
        """How many numbers the fault has."""
        return FORCED.get(self.fit.fault, 0)

    def first(self) -> Array:
        """Where the search begins."""
        fit = self.fit
        pushes = [x for push in fit.pushes for x in (push.start, push.stop, push.impulse, push.height)]
        own = {
            0: [], 1: [fit.size], 2: [fit.onset, fit.size],
            4: [fit.onset, fit.size, *(fit.more or (1.0, 0.0))],
        }  # fmt: skip
        own[3] = [fit.onset, float(fit.way.split()[1]), fit.size] if self.own == 3 else []
        return np.array([*own[self.own], *pushes])

    def placed(self, x: Array) -> FaultFit:
        """The fit with these numbers."""
        fit, own = self.fit, x[: self.own].tolist()
        pushes = tuple(
            PushEstimate(start, stop, impulse, height, 0.0)
            for start, stop, impulse, height in x[self.own :].reshape(-1, 4).tolist()
        )
        fit = replace(fit, pushes=pushes)
        if self.own == 1:
            return replace(fit, size=own[0])
        if self.own == 3:
            return replace(fit, onset=own[0], way=f"within {own[1]:.2g} s", size=own[2])
        if not own:
            return fit
        way = fit.way if self.own == 2 else "added" if own[1] > 0 else "dropped"
        return replace(fit, onset=own[0], way=way, size=own[1], more=tuple(own[2:]))

    def steps(self, count: int) -> Array:
        """A small change of each number."""
        p = self.observer.part.robot
        mass, torque = p.body_mass + 2 * p.wheel_mass, 1e-3 * p.body_mass * p.gravity * p.com_height
        own = ([], [1e-4], [2e-3, 1e-3], [2e-3, 1e-2, 1e-3], [2e-3, 1e-2, 2e-2, torque])[self.own]
        return np.array(own + [1e-3, 1e-3, 1e-3 * mass, 0.02 * p.com_height] * ((count - self.own) // 4))

    def inside(self, x: Array) -> Array:
        """The nearest numbers that a robot meets."""
        x, t = x.copy(), self.observer.part.t
        if self.own == 1:
            x[0] = np.clip(x[0], GRIPS[0], 1.0)
        if self.own > 1:
            x[0] = np.clip(x[0], t[0], t[-1])
            x[1] = np.clip(x[1], *{2: (0.01, 0.85), 3: (0.02, SLOWEST), 4: (-0.95, 5.0)}[self.own])
        if self.own == 4:
            x[2] = np.clip(x[2], 0.0, HIGHEST)
        for push in x[self.own :].reshape(-1, 4):
            push[0] = np.clip(push[0], t[0], t[-1] - SHORTEST)
            push[1] = max(push[1], push[0] + SHORTEST)
            push[3] = np.clip(push[3], 0.0, HIGHEST * self.observer.part.robot.com_height)
        return x

    def rest(self, *several: Array) -> Array:
        """What numbers leave of the innovations (readings, lanes)."""
        observer, p, lanes = self.observer, self.observer.part.robot, len(several)
        if not len(several[0]):  # no force at all
            return np.repeat(self.left[:, None], lanes, axis=1)
        forces, floors = np.zeros((lanes, len(observer.part.t), 2)), np.zeros((lanes, 2))
        robots, onsets = np.repeat(observer.usual[None], lanes, axis=0), np.full(lanes, np.inf)
        slope = (-(p.body_mass + 2 * p.wheel_mass) * p.gravity, -p.body_mass * p.com_height * p.gravity)
        both = np.array(slope if self.fit.fault == "ramp" else (1.0, 0.0))
        for lane, x in enumerate(several):
            if self.own == 1:
                floors[lane] = self.since, x[0]
            if self.own == 2:
                onsets[lane], robots[lane] = x[0], observer.constants({"wheel_radius": -x[1] * p.wheel_radius})
            if self.own == 3:
                forces[lane] += observer.since(x[0], x[1])[:, None] * both * x[2]
            if self.own == 4:
                heavier = with_mass(p, x[1] * p.body_mass, x[2] * p.com_height)
                onsets[lane], robots[lane] = x[0], observer.constants(heavier)
                forces[lane, :, 1] += observer.since(x[0]) * x[3]
            for start, stop, impulse, height in x[self.own :].reshape(-1, 4):
                on = observer.since(start) - observer.since(stop)
                forces[lane] += on[:, None] * (np.array([1.0, height]) * impulse / (stop - start))
        return self.left[:, None] + beside(self.basis, observer.added(robots, onsets, forces, floors))

    def least(self) -> Array:
        """The numbers of least squares near the first."""
        x = self.inside(self.first())
        return least_squares(self, x, self.steps(len(x))) if len(x) else x


class Residuals(Protocol):
    """What some numbers leave (readings, lanes), and the nearest numbers that a robot meets."""

    def rest(self, *several: Array) -> Array: ...

    def inside(self, x: Array) -> Array: ...


def least_squares(
    of: Residuals, x: Array, change: Array, dampings: Sequence[float] = DAMPINGS, strides: Sequence[float] = ()
) -> Array:
    """The numbers of least squares near x, by steps of Gauss and Newton whose slopes are those of a small `change` of
    each, the best of several `dampings`, and farther the same way by `strides`."""
    for _ in range(ROUNDS):
        y = of.rest(x, *(x + row for row in np.diag(change)))
        J = (y[:, 1:] - y[:, :1]) / change
        curvature, slope, squares = J.T @ J, J.T @ y[:, 0], float(y[:, 0] @ y[:, 0])
        size = np.diag(np.maximum(np.diag(curvature), 1e-9 * np.diag(curvature).max() + 1e-30))
        steps = [np.linalg.solve(curvature + d * size, slope) for d in dampings]
        tried = [of.inside(x - step) for step in steps]
        left = (of.rest(*tried) ** 2).sum(axis=0)
        step = steps[int(np.argmin(left))]
        if strides:
            strided = [of.inside(x - stride * step) for stride in strides]
            tried, left = tried + strided, np.concatenate([left, (of.rest(*strided) ** 2).sum(axis=0)])
        i = int(np.argmin(left))
        if not left[i] < squares:
            break
        x = tried[i]
        if left[i] > (1 - ENOUGH) * squares:
            break
    return x


def forced(run: FilterRun, fits: Sequence[FaultFit], window: Window, bank: Bank) -> list[FaultFit]:
    """All fits, the likeliest of those with forces by the equations of motion themselves; the likeliest first."""
    top = max(fit.score for fit in fits)
    searched = set[tuple[str, str]]()
    several = list(fits)
    for i, fit in enumerate(fits):
        kind = (fit.fault, "" if fit.fault in FORCED else fit.way)
        moves = (fit.pushes or fit.fault in FORCED) and fit.fault != "slip" and kind not in searched
        if moves and (fit.fault == "none" or (fit.score > top - BEHIND and len(searched) < MOST)):
            searched.add(kind)
            several[i] = refined(run, fit, window, bank)
    slip = next((fit for fit in several if fit.fault == "slip"), None)
    if slip is not None and max(several, key=lambda fit: fit.score).nis > LEAVES * bank.scale:
        several.append(slipped(run, slip, window, bank))
    none = next(fit for fit in several if fit.fault == "none")
    if none.pushes and none.score > top - BEHIND and "moment" in bank.free:
        several.append(loaded(run, none, window, bank))
    return sorted(several, key=lambda fit: -fit.score)


def loaded(run: FilterRun, fit: FaultFit, window: Window, bank: Bank) -> FaultFit:
    """A mass that comes or goes beside the pushes of a fit: alone, they take up a part of what it does. Searched from
    the signatures that explain most beside changes of these pushes, some of a mass that comes and some of one that
    goes."""
    start = replace(fit, fault="payload", spent=fit.spent + numbers_of("payload"), score=-math.inf)
    loads = [one for one in bank.faults if one.fault == "payload"]
    if not loads:
        return start
    part = window.of(run)
    edges = [(p.start + a, p.stop + b, p.height + h) for p in fit.pushes for a, b, h in CHANGED]
    Q = np.linalg.qr(beside(bank.basis, pushing(part, edges)))[0]
    values = np.array([one.values for one in loads])
    own = np.maximum((values**2).sum(axis=1) - ((values @ Q) ** 2).sum(axis=1), 1e-12)
    dots = values @ (fit.rest - Q @ (Q.T @ fit.rest))
    explained = dots**2 / own
    chosen = list[int]()
    for i in np.argsort(-explained).tolist():
        mass = -float(dots[i] / own[i]) * loads[i].size
        near = [k for k in chosen if abs(loads[k].onset - loads[i].onset) < APART]
        if mass * loads[i].size > 0 and not near and len(chosen) < LOADS:
            chosen.append(i)
    tries = [
        replace(start, onset=loads[i].onset, size=-float(dots[i] / own[i]) * loads[i].size, more=(1.0, 0.0))
        for i in chosen
    ]
    return max((refined(run, one, window, bank) for one in tries), key=lambda one: one.score, default=start)


def slipped(run: FilterRun, fit: FaultFit, window: Window, bank: Bank) -> FaultFit:
    """A slip on the floor that leaves the smallest innovations by the equations of motion, and the pushes beside it."""
    part = window.of(run)
    basis = unknown_parameters(part)
    left = beside(basis, part.whitened)
    search = ForceSearch(Observer(part, slip=True), replace(fit, pushes=()), left, basis)
    times = np.arange(part.t[0], part.t[-1] - YOUNGEST, SINCE)
    if not len(times):
        return fit
    left_by = np.array([(replace(search, since=float(t)).rest(*GRIPS[:, None]) ** 2).sum(axis=0) for t in times])
    if left_by.min() > LITTLE * float(left @ left):
        return fit
    best = replace(fit, score=-math.inf)
    for part_of in np.array_split(np.arange(len(times)), min(STARTS, len(times))):
        i, j = np.unravel_index(int(np.argmin(left_by[part_of])), left_by[part_of].shape)
        start = replace(search, since=float(times[part_of][i]))
        best = max(best, _with_pushes(start, float(GRIPS[j]), bank), key=lambda one: one.score)
    shows = np.flatnonzero(np.abs(best.values[: len(bank.then)]) > VISIBLE_SLIP)
    best = replace(best, onset=float(bank.then[shows[0]])) if len(shows) else best
    return best if best.score > fit.score else fit


def _with_pushes(search: ForceSearch, grip: float, bank: Bank) -> FaultFit:
    """The slip on a floor near one that was tried, and the pushes beside it, looked for again where it moved."""
    best = replace(search.fit, size=grip, score=-math.inf)
    for _ in range(AGAIN):
        bare = replace(search, fit=best).rest(np.array([best.size]))[:, 0]
        pushed = with_pushes(bank, beside=bare)
        again = replace(best, pushes=pushed.pushes, spent=pushed.spent)
        again = _lessened(_best_fit(replace(search, fit=again), bank), search, bank)
        if again.score <= best.score:
            break
        best = again
    return best


def refined(run: FilterRun, fit: FaultFit, window: Window, bank: Bank) -> FaultFit:
    """The fit with the numbers of its forces that leave the smallest innovations, and without pushes that add less than
    their price; as it was where the search finds nothing better."""
    part = window.of(fit.run if fit.run is not None else run)
    basis = unknown_parameters(part, fit.nis)
    left = beside(basis, part.whitened)
    if fit.run is None and fit.fault not in (*FORCED, "none"):
        if len(fit.values) != len(left):
            return fit
        left = left + fit.values
    search = ForceSearch(Observer(part), fit, left, basis)
    best = _lessened(_best_fit(search, bank), search, bank)
    return best if best.score > fit.score else fit


def _lessened(fit: FaultFit, search: ForceSearch, bank: Bank) -> FaultFit:
    """The fit without pushes that add less than their price."""
    while fit.pushes:
        weakest = min(fit.pushes, key=lambda push: push.score)
        kept = tuple(push for push in fit.pushes if push is not weakest)
        fewer = _best_fit(replace(search, fit=replace(fit, pushes=kept, spent=fit.spent - PUSH_NUMBERS)), bank)
        if fewer.score < fit.score:
            break
        fit = fewer
    return fit


def _best_fit(search: ForceSearch, bank: Bank) -> FaultFit:
    """The fit of the least squares of a search; a push's score is what the others miss without it."""
    fit = search.fit
    own = search.own
    x = search.least()
    pushes = x[own:].reshape(-1, 4).tolist()
    spent = search.fit.spent
    rest = search.rest(x)[:, 0]
    score = score_of(bank, rest, spent)
    lacking = [np.delete(x, slice(own + 4 * i, own + 4 * i + 4)) for i in range(len(pushes))]
    lesser = [score_of(bank, one, spent - PUSH_NUMBERS) for one in (search.rest(x)[:, 0] for x in lacking)]
    estimates = tuple(
        PushEstimate(start, stop, impulse, height, score - one)
        for (start, stop, impulse, height), one in zip(pushes, lesser, strict=True)
    )
    nis = float(rest @ rest) / len(rest)
    explained = 1 - nis / max(float(bank.y @ bank.y) / len(bank.y), 1e-12)
    fit = replace(search.placed(x), score=score, pushes=estimates, explained=explained, nis=nis, rest=rest)
    return replace(fit, values=search.rest(x[:own])[:, 0] - search.left) if own else fit
