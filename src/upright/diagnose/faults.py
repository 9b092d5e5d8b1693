"""Which fault of the robot explains the innovations: a bank of hypotheses, each with its size and its onset.

Every fault is a signal with few free numbers that enters the filter of `path` at one place. The likelihood
ratio is that of Willsky and Jones (1976), with the noise's scale unknown, so that a filter whose robot is a little
wrong proves no fault by that, and with a penalty for each free number (Schwarz 1978).
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.certify.certificate import uncertainty
from upright.diagnose.path import Tangent, Track, answer, carried, misfits
from upright.diagnose.slip import slipping
from upright.robots import Robot

Array = NDArray[np.float64]

GRID = 0.06  # [s] between onsets that are tried first
FINE = 0.03  # [s] between edges of pushes
LENGTHS = (1, 2, 3, 5, 7, 10)  # of pushes, in those
YOUNGEST = 0.12  # [s] before the lean is `LEANING`; what comes later is too late to be a cause
GRIPS = (0.003, 0.006, 0.01, 0.015, 0.02, 0.025, 0.03, 0.04, 0.05, 0.06, 0.08, 0.1, 0.15, 0.2)
HEIGHTS = (0.0, 1.0, 2.0)  # of a push, over that of the centre of mass
SHOWN = (
    "wheel_mass", "wheel_radius", "wheel_inertia", "body_mass", "com_height", "pitch_inertia", "rotor_inertia",
    "motor_resistance", "back_emf", "motor_friction", "coulomb_friction",
)  # fmt: skip
"""Parameters that a filter in pitch may have wrong."""

HOW_WELL = 0.5
"""Share of the sources' spreads by which the robot may differ from the nominal one."""

MOST_OFF = 0.08
"""No parameter is thought to be farther off than by this share of itself."""


@dataclass(frozen=True, eq=False)
class Column:
    """What one hypothesis adds to the innovations (whitened), free in amplitude or not."""

    fault: str
    way: str
    onset: float
    size: float
    values: Array
    free: bool
    stop: float = math.inf


@dataclass(frozen=True, eq=False)
class Bank:
    """The window's whitened innovations `y` (readings,), the `scale` of what is usual, and all columns."""

    y: Array
    then: Array
    scale: float
    columns: list[Column]
    pulses: list[Column]
    matrix: Array
    squares: Array


def bank(found: Track, flow: Tangent, use: NDArray[np.bool_], usual: float) -> Bank:
    """All hypotheses on the part of a track; `use` (events,) marks the readings that count."""
    basis = unknown(found, flow, use)
    y = beside(basis, found.e[use] / np.sqrt(found.s[use]))
    last = found.then[-1] - YOUNGEST
    onsets = np.arange(float(found.then[0]), float(last), GRID)
    shared = (found, flow, use)
    columns = [*biases(*shared, np.arange(found.then[0], last, found.log.period)), *_loads(*shared, onsets)]
    columns += _slips(*shared, onsets)
    pulses = _pulses(*shared, np.arange(found.then[0], last, FINE))
    return _bank(y, found.then[use], basis, usual, columns, pulses)


def plain_bank(found: Track, flow: Tangent, use: NDArray[np.bool_], usual: float) -> Bank:
    """A bank of pushes alone, for a track whose fault was taken out."""
    basis = unknown(found, flow, use)
    last = found.then[-1] - YOUNGEST
    y = beside(basis, found.e[use] / np.sqrt(found.s[use]))
    return _bank(y, found.then[use], basis, usual, [], _pulses(found, flow, use, np.arange(found.then[0], last, FINE)))


def _bank(y: Array, then: Array, basis: Array, usual: float, columns: list[Column], pulses: list[Column]) -> Bank:
    freed = [replace(c, values=beside(basis, c.values)) for c in columns]
    matrix = np.column_stack([c.values for c in pulses])
    matrix = np.vstack([matrix, np.zeros((basis.shape[1], matrix.shape[1]))])
    matrix -= basis @ (basis.T @ matrix)
    return Bank(y, then, usual, freed, pulses, matrix, np.maximum((matrix**2).sum(axis=0), 1e-12))


def unknown(found: Track, flow: Tangent, use: NDArray[np.bool_]) -> Array:
    """An orthonormal basis of what parameters that differ within their spreads do, below it one row for each.

    A row weighs as much as the innovations are larger than they should be: beside noise of that scale no parameter is
    known worse than its spread says.
    """
    known = spreads(found.robot)
    wrong = carried(found, flow, misfits(found, known))[use]
    scale = max(1.0, float(np.sqrt(np.mean(found.e[use] ** 2 / found.s[use]))))
    return np.linalg.qr(np.vstack([wrong, scale * np.eye(len(known))]))[0]


def spreads(robot: Robot) -> dict[str, float]:
    """What is not known of the robot, as its sources have it, among the numbers that its balance shows."""
    known = uncertainty(robot)
    values = robot.numbers()
    return {n: min(HOW_WELL * known[n], MOST_OFF * values[n]) for n in SHOWN if known.get(n) and values[n]}


def beside(basis: Array, values: Array) -> Array:
    """What is left of innovations when the robot may differ from the nominal one within its spreads: a ridge, written
    as one more row for each parameter."""
    whole = np.concatenate([values, np.zeros(basis.shape[1])])
    return whole - basis @ (basis.T @ whole)


def _steps(found: Track, onsets: Array) -> Array:
    """(events, onsets): 1 where a span lies after the onset."""
    middle = found.then - found.spans / 2
    return (middle[:, None] >= onsets[None]).astype(np.float64)


def _pulses(found: Track, flow: Tangent, use: NDArray[np.bool_], onsets: Array) -> list[Column]:
    """Forces of some time at some heights, free in size."""
    on, n = _steps(found, onsets), len(onsets)
    entered = np.zeros((len(found.then), 4, 2 * n))
    entered[:, 2, :n] = on
    entered[:, 3, n:] = on
    said = answer(found, flow, entered, np.zeros((len(found.then), 2 * n)))[use]
    first, last = np.array([(i, i + d) for i in range(n) for d in LENGTHS if i + d < n]).T
    force, moment = said[:, first] - said[:, last], said[:, n + first] - said[:, n + last]
    return [
        Column("push", "", float(onsets[i]), h, one, True, float(onsets[j]))
        for h in (height * found.robot.com_height for height in HEIGHTS)
        for i, j, one in zip(first, last, (force + h * moment).T, strict=True)
    ]


def _loads(found: Track, flow: Tangent, use: NDArray[np.bool_], onsets: Array) -> list[Column]:
    """A force at the axle that grows from the onset on, and stays."""
    middle = (found.then - found.spans / 2)[:, None]
    columns: list[Column] = []
    for rise in (0.1, 1.0):
        entered = np.zeros((len(found.then), 4, len(onsets)))
        entered[:, 2] = np.clip((middle - onsets[None]) / rise, 0.0, 1.0)
        said = answer(found, flow, entered, np.zeros((len(found.then), len(onsets))))[use]
        columns += [Column("load", f"within {rise:g} s", t, 0.0, said[:, i], True) for i, t in enumerate(onsets)]
    return columns


def biases(found: Track, flow: Tangent, use: NDArray[np.bool_], onsets: Array) -> list[Column]:
    gyro = (found.row == found.rows.index("sensor/gyro"))[:, None]
    later = np.maximum(found.then[:, None] - onsets[None], 0.0)
    none = np.zeros((len(found.then), 4, len(onsets)))
    columns: list[Column] = []
    for way, shift in (("step", (later > 0) * 1.0), ("ramp", later)):
        said = answer(found, flow, none, shift * gyro)[use]
        columns += [Column("bias", way, t, 0.0, said[:, i], True) for i, t in enumerate(onsets)]
    return columns


def _slips(found: Track, flow: Tangent, use: NDArray[np.bool_], onsets: Array) -> list[Column]:
    """Wheels that slip wherever the floor would have to hold them by more than `grip` times the weight."""
    some = onsets[::2]
    onset, grip = np.tile(some, len(GRIPS)), np.repeat(GRIPS, len(some))
    said, slipped = slipping(found, flow, onset, grip)
    return [Column("slip", "", onset[i], grip[i], said[use, i], False) for i in np.flatnonzero(slipped)]
