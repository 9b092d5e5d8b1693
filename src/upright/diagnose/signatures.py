"""What each possible fault adds to the innovations: a bank of signatures, each with its size and its onset.

Every fault is a signal with few free numbers that enters the filter of `innovations` at one place. The likelihood
ratio is that of Willsky and Jones (1976), with the noise's scale unknown, so that a filter whose robot is a little
wrong proves no fault by that, and with a penalty for each free number (Schwarz 1978).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from upright.arrays import Array, Whole
from upright.diagnose.changes import commands, free_steps, frictions, motors, payloads, placed, radii, scales
from upright.diagnose.fall import pace
from upright.diagnose.innovations import FilterRun, Signature, answer, misfits, propagated
from upright.diagnose.slip import slipping
from upright.robots import Robot
from upright.robots.uncertainty import deviations

ONSET_STEP = 0.06  # [s] of a quick robot between the onsets of the grid
PUSH_STEP = 0.03  # [s] of a quick robot between the edges of pushes
PUSH_LENGTHS = (1, 2, 3, 5, 7, 10)  # of pushes, in steps of `PUSH_STEP`
YOUNGEST = 0.12  # [s] before the lean passes `LEANING`: what comes later is too late to be a cause
GRIPS = (0.003, 0.006, 0.01, 0.015, 0.02, 0.025, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.15, 0.2)  # friction coefficients
HEIGHTS = (0.0, 1.0, 2.0)  # of a push above the axle, over that of the centre of mass
FINE_STEP, FINE_STEPS = 0.006, 4  # [s] between the edges of pushes near one that was found, and how many to both sides
FINE_HEIGHTS = (0.0, 0.5, 1.0, 1.5, 2.0)
RISES = (0.1, 0.3, 1.0)  # [s] in which a steady load grows to its size
VISIBLE = (
    "wheel_mass", "wheel_radius", "wheel_inertia", "body_mass", "com_height", "pitch_inertia", "rotor_inertia",
    "motor_resistance", "back_emf", "motor_friction", "coulomb_friction",
)  # fmt: skip
"""Parameters that a filter in pitch may have wrong."""

SPREAD_FRACTION = 0.5
"""Of the sources' spreads, by which the robot may differ from the nominal one (see `verdict`)."""

LARGEST_SPREAD = 0.08
"""Most that a parameter may be off, as a fraction of its value; settled likewise."""


@dataclass(frozen=True, eq=False)
class Forces:
    """What a newton between two times does to the innovations, for many forces: differences of the `steps` (readings,
    2n) that a newton from each of the n times on gives, and then a newton metre. Each force is from place `first` among
    the times to place `last`, an `arm` [m] above the axle."""

    steps: Array
    first: Whole
    last: Whole
    arm: Array

    def dots(self, y: Array) -> Array:
        """The product of each (forces,) with the innovations y."""
        force, moment = np.split(y @ self.steps, 2)
        return force[self.first] - force[self.last] + self.arm * (moment[self.first] - moment[self.last])

    @cached_property
    def squares(self) -> Array:
        """The sum of squares of each (forces,)."""
        i = self.first
        j = self.last
        n = self.steps.shape[1] // 2
        products = self.steps.T @ self.steps

        def of(a: int, b: int) -> Array:
            p, q, r, s = a * n + i, a * n + j, b * n + i, b * n + j
            return products[p, r] - products[p, s] - products[q, r] + products[q, s]

        return np.maximum(of(0, 0) + 2 * self.arm * of(0, 1) + self.arm**2 * of(1, 1), 1e-12)

    def values(self, i: int | Whole) -> Array:
        """Force i (readings,), or forces i (readings, many)."""
        n = self.steps.shape[1] // 2
        first, last = self.first[i], self.last[i]
        force = self.steps[:, first] - self.steps[:, last]
        return force + self.arm[i] * (self.steps[:, n + first] - self.steps[:, n + last])


@dataclass(frozen=True, eq=False, kw_only=True)
class Bank:
    """The window's whitened innovations `y` at the times `then`, the `scale` of ordinary ones, the signatures of all
    faults, onset [s], stop [s] and height [m] of all `pushes` (pushes, 3), and what a newton of each does by `forces`.
    `free` are steps at all onsets by the channel that they enter by: together a disturbance of any shape. `basis` is
    that of the unknown parameters, which all of these are beside."""

    y: Array
    then: Array
    scale: float
    faults: list[Signature]
    pushes: Array
    forces: tuple[Forces, ...]
    free: Mapping[str, Array]
    steps: Array
    basis: Array

    def dots(self, y: Array) -> Array:
        """The product of what each push does (pushes,) with the innovations y."""
        return np.concatenate([one.dots(y) for one in self.forces])

    @cached_property
    def squares(self) -> Array:
        """The sum of squares of what each push does (pushes,)."""
        return np.concatenate([one.squares for one in self.forces])

    def push(self, i: int) -> Array:
        """What a newton of push i does (readings,)."""
        for one in self.forces:
            if i < len(one.arm):
                return one.values(i)
            i -= len(one.arm)
        raise IndexError(i)


EARLIER = {0: 0.05, 1: 0.3, 3: 1.0, 5: 0.3}
"""Errors of the state by its place, of pitch [rad], pitch rate, wheel rate and yaw rate [rad/s], that a knock of what
robots meet leaves in the filter."""


def bank(run: FilterRun, scale: float, *, pushes_only: bool = False, beside_it: str = "") -> Bank:
    """All hypotheses on a part of a run, or `pushes_only` where the fault was taken out of the log, with the signatures
    of the fault `beside_it`."""
    basis = unknown_parameters(run)
    use = run.readings
    start = float(run.t[0])
    last = float(run.t[-1]) - YOUNGEST
    slow = pace(run.robot)
    onsets = np.arange(start, last, ONSET_STEP * slow)
    faults = list[Signature]()
    free = dict[str, Array]()
    if not pushes_only:
        faults = [
            *biases(run, _rows(run, start, last)), *_loads(run, onsets), *_slips(run, onsets),
            *scales(run, onsets), *motors(run, onsets), *payloads(run, onsets), *commands(run, onsets),
            *frictions(run, onsets), *radii(run, onsets),
        ]  # fmt: skip
        free = {channel: beside(basis, values) for channel, values in free_steps(run, onsets).items()}
    elif beside_it:
        faults = signatures_of(run, beside_it, onsets)
        free = {"moment": beside(basis, free_steps(run, onsets)["moment"])} if beside_it == "payload" else {}
    left = beside(basis, np.array([one.values for one in faults]).reshape(len(faults), int(use.sum())).T).T
    faults = [replace(one, values=values) for one, values in zip(faults, left, strict=True)]
    pushes, forces = _pushes(run, np.arange(start, float(run.t[-1]), PUSH_STEP * slow), last)
    forces = replace(forces, steps=beside(basis, forces.steps))
    y = beside(basis, run.whitened)
    if faults and free:
        loads = [one for one in faults if one.fault == "payload"]
        faults = [one for one in faults if one.fault != "payload"] + placed(loads, y, free["moment"], onsets)
    return Bank(
        y=y, then=run.t[use], scale=scale, faults=faults, pushes=pushes, forces=(forces,), free=free, steps=onsets,
        basis=basis,
    )  # fmt: skip


def _rows(run: FilterRun, start: float, last: float) -> Array:
    """The times from `start` to the `last` [s] at which the filter read its sensors."""
    rows = run.log.t if run.kept is None else run.kept
    return rows[(rows >= start) & (rows < last)]


def channels(run: FilterRun, scale: float) -> Bank:
    """A bank of disturbances of any shape alone, by the channels that they enter by."""
    basis = unknown_parameters(run)
    steps = np.arange(float(run.t[0]), float(run.t[-1]) - YOUNGEST, ONSET_STEP * pace(run.robot))
    free = {channel: beside(basis, values) for channel, values in free_steps(run, steps).items()}
    return Bank(
        y=beside(basis, run.whitened), then=run.t[run.readings], scale=scale, faults=[], pushes=np.zeros((0, 3)),
        forces=(), free=free, steps=steps, basis=basis,
    )  # fmt: skip


def signatures_of(run: FilterRun, fault: str, onsets: Array) -> list[Signature]:
    """The signatures of one kind of fault that a log cannot be freed of."""
    makers = {"ramp": _loads, "load": _loads, "payload": payloads, "radius": radii, "slip": _slips}
    return [one for one in makers[fault](run, onsets) if one.fault == fault]


def pushing(run: FilterRun, pushes: Sequence[tuple[float, float, float]]) -> Array:
    """What a newton of each of some pushes, by (start [s], stop [s], height [m]), does to the innovations (readings,
    pushes)."""
    times = np.array([push[:2] for push in pushes]).ravel()
    many = np.arange(len(pushes))
    return Forces(_steps(run, times), 2 * many, 2 * many + 1, np.array([push[2] for push in pushes])).values(many)


def unknown_parameters(run: FilterRun, nis: float = math.nan) -> Array:
    """An orthonormal basis of what parameters that differ within their spreads do, and errors that the filter has when
    the part begins, of a knock before it for instance; below it one row for each.

    A row weighs as much as what a hypothesis leaves is larger than it should be, by its `nis`, or as the innovations
    are: beside noise of that scale no parameter is known worse than its spread says.
    """
    known = spreads(run.robot)
    entered = np.zeros((len(run.t), 6, len(known) + len(EARLIER)))
    entered[:, :, : len(known)] = misfits(run, known)
    for i, (state, error) in enumerate(EARLIER.items(), len(known)):
        entered[0, state, i] = error
    wrong = propagated(run, entered)[run.readings]
    scale = math.sqrt(max(1.0, nis if math.isfinite(nis) else float(np.mean(run.whitened**2))))
    return np.linalg.qr(np.vstack([wrong, scale * np.eye(wrong.shape[1])]))[0]


def spreads(robot: Robot) -> dict[str, float]:
    """Standard deviations of the parameters that a balancing robot shows, as its sources have them, within limits."""
    known = deviations(robot)
    values = robot.numbers()
    return {
        n: min(SPREAD_FRACTION * known[n], LARGEST_SPREAD * values[n]) for n in VISIBLE if known.get(n) and values[n]
    }


def beside(basis: Array, values: Array) -> Array:
    """What is left of innovations (readings, …) when the robot may differ from the nominal one within its spreads: a
    ridge regression, written as one more row for each parameter."""
    n = len(values)
    explained = basis[:n].T @ values  # the rows of the parameters are zero
    left = np.empty((len(basis), *values.shape[1:]))
    np.subtract(values, basis[:n] @ explained, out=left[:n])
    left[n:] = -basis[n:] @ explained
    return left


def _pushes(run: FilterRun, onsets: Array, latest: float) -> tuple[Array, Forces]:
    """Forces of some time at some heights, free in size, that begin before the `latest` [s]; none where the window is
    shorter than the shortest."""
    starts = int((onsets < latest).sum())
    edges = [(i, i + d) for i in range(starts) for d in PUSH_LENGTHS if i + d < len(onsets)]
    return _forces(run, onsets, edges, HEIGHTS)


def finer(run: FilterRun, known: Bank, pushes: Sequence[tuple[float, float]]) -> Bank:
    """The bank with more pushes whose edges lie near those of some, by (start, stop) [s]."""
    if not pushes:
        return known
    near: Array = np.arange(-FINE_STEPS, FINE_STEPS + 1, dtype=np.float64) * FINE_STEP
    onsets: Array = np.unique(np.concatenate([edge + near for push in pushes for edge in push]).round(6))
    place = {float(t): i for i, t in enumerate(onsets)}
    edges = [
        (place[float(i)], place[float(j)])
        for start, stop in pushes
        for i in (start + near).round(6)
        for j in (stop + near).round(6)
        if j >= i + FINE_STEP
    ]
    more, forces = _forces(run, onsets, list(dict.fromkeys(edges)), FINE_HEIGHTS)
    forces = replace(forces, steps=beside(known.basis, forces.steps))
    return replace(known, pushes=np.concatenate([known.pushes, more]), forces=(*known.forces, forces))


def _forces(
    run: FilterRun, onsets: Array, edges: Sequence[tuple[int, int]], heights: Sequence[float]
) -> tuple[Array, Forces]:
    """Forces between two of the `onsets` each, at heights over that of the centre of mass, as `Bank` has them."""
    first, last = (np.tile(one, len(heights)) for one in np.array(edges, dtype=np.int64).reshape(-1, 2).T)
    arm = np.repeat(np.array(heights) * run.robot.com_height, len(edges))
    if not edges:
        onsets = onsets[:0]
    return np.column_stack([onsets[first], onsets[last], arm]), Forces(_steps(run, onsets), first, last, arm)


def _steps(run: FilterRun, onsets: Array) -> Array:
    """What a newton at the axle, and a newton metre, from each of the times on do (readings, 2 × onsets)."""
    on = np.clip((run.t[:, None] - onsets) / np.maximum(run.spans, 1e-9)[:, None], 0.0, 1.0)
    gamma = run.tangent.gamma[:, :, 2:]
    steps = propagated(run, np.concatenate([one * on[:, None] for one in np.split(gamma, 2, axis=2)], axis=2))
    return steps[run.readings]


def _loads(run: FilterRun, onsets: Array) -> list[Signature]:
    """A force at the axle, and a slope by its sine, that grow from the onset on and stay."""
    middle = (run.t - run.spans / 2)[:, None]
    p = run.robot
    slope = (-(p.body_mass + 2 * p.wheel_mass) * p.gravity, -p.body_mass * p.com_height * p.gravity)
    loads: list[Signature] = []
    for rise in RISES:
        for fault, force, moment in (("load", 1.0, 0.0), ("ramp", *slope)):
            entered = np.zeros((len(run.t), 4, len(onsets)))
            entered[:, 2] = force * np.clip((middle - onsets) / rise, 0.0, 1.0)
            entered[:, 3] = moment * np.clip((middle - onsets) / rise, 0.0, 1.0)
            response = answer(run, entered)[run.readings].T
            loads += [
                Signature(fault=fault, way=f"within {rise:g} s", onset=float(t), values=one)
                for t, one in zip(onsets, response, strict=True)
            ]
    return loads


def biases(run: FilterRun, onsets: Array) -> list[Signature]:
    """An offset of the gyro, as a step or as a ramp, from each onset on."""
    gyro = (run.row == run.rows.index("sensor/gyro"))[:, None]
    elapsed = run.log.t[run.sample][:, None] - onsets  # by a reading's own time, as in `remedied`
    offsets: list[Signature] = []
    for way, shift in (("step", (elapsed >= 0) * 1.0), ("ramp", np.maximum(elapsed, 0.0))):
        response = propagated(run, None, shift * gyro)[run.readings].T
        offsets += [
            Signature(fault="bias", way=way, onset=float(t), values=one)
            for t, one in zip(onsets, response, strict=True)
        ]
    return offsets


def _slips(run: FilterRun, onsets: Array) -> list[Signature]:
    """Wheels that slip wherever the floor would have to hold them by more than `grip` times the weight."""
    onset, grip = (grid.ravel() for grid in np.meshgrid(onsets[::2], GRIPS))
    response, slipped = slipping(run, onset, grip)
    values = response[run.readings].T
    return [
        Signature(fault="slip", onset=float(onset[i]), size=float(grip[i]), values=values[i], free=False)
        for i in np.flatnonzero(slipped)
    ]
