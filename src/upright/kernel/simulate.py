"""Thousands of robots at once: `simulate` runs the loop of `experiment.run` for a whole batch in compiled code.

A robot's result is the same bits whatever batch, order or number of threads it is computed in.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace

import numpy as np

from upright.arrays import Array, Whole
from upright.compiled.generated import LANES
from upright.errors import InvalidScenario, SpecMismatch
from upright.kernel.batch import NAMES, FleetBatch, FleetResult, Selection
from upright.kernel.work import Order, Outcome, Piece, run_piece
from upright.physics.dynamics import derivative
from upright.physics.integrate import SIMULATED
from upright.physics.steps import substeps
from upright.signals import TRUE_STATE

FOREVER = (math.inf, math.inf, math.inf)

_TINY = 1e-100
_PACE = 20.0  # [1/s] as which a pitch is counted as a rate: some multiple of the pole that falls

PIECE = 8192
"""Most robots whose tables are made at once: few enough to stay near the processor, and to bound the memory."""

CALLED = 128
"""Robots of a piece whose controller is called for each of them: as many copies of it, about a second of work."""

_PARTS = 8  # pieces for each thread: where robots fall early, their thread takes another piece

VARIANTS = ("smooth", "coulomb", "rolling", "speed", "slope", "coulomb_slope", "rolling_slope", "speed_slope")


def simulate(
    batch: FleetBatch,
    seconds: float = 10.0,
    *,
    record: int = 0,
    channels: Sequence[str] = TRUE_STATE,
    bands: Sequence[float] = FOREVER,
    threads: int | None = None,
) -> FleetResult:
    """Every robot of `batch` for `seconds`, or until it falls.

    `channels` are recorded every `record` periods (0: not at all): truth/…, reference/…, command/…, applied/…,
    push/force, the sensor/… that the controller reads, and command/residual of a predictive one. `bands` are |pitch|,
    |wheel|, |yaw| [rad] inside which a robot counts as settled. `threads` is by default the number of processors. A
    controller that is called runs in one thread.

    Raises `InvalidScenario` for an impossible time, `SpecMismatch` for unknown channels and periods that do not fit.
    """
    stride, periods = _times(batch.period, batch.form.period, seconds)
    order = Order(
        periods=periods, stride=stride, record=record, channels=tuple(channels if record else ()),
        bands=tuple(bands),
    )  # fmt: skip
    out = Outcome.room(batch.n, order)
    workers = 1 if batch.called else max(1, threads or os.cpu_count() or 1)
    pieces = _pieces(batch, workers)
    alone = min(workers, len(pieces)) == 1

    def work(piece: Piece) -> None:
        run_piece(batch, piece, order, out, workers if alone or batch.n <= PIECE else 1)

    if alone:
        for piece in pieces:
            work(piece)
    else:
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(work, pieces))
    return out.result(order, batch.period)


def _pieces(batch: FleetBatch, workers: int) -> list[Piece]:
    """Robots with the same terms in their equations and the same steps: the arithmetic of a robot does not depend on
    the others."""
    even = max(PIECE // _PARTS, batch.n // (_PARTS * workers))
    size = CALLED if batch.called else batch.n if batch.n <= PIECE else min(PIECE, -(-even // LANES) * LANES)
    kinds = _terms(batch) + len(VARIANTS) * (steps_of(batch) - 1)
    if len(kinds) == 1 or (kinds == kinds[0]).all():
        starts = range(0, batch.n, size)
        return [_piece(int(kinds[0]), slice(start, min(batch.n, start + size))) for start in starts]
    groups = [(k, np.flatnonzero(kinds == k)) for k in np.unique(kinds).tolist()]
    return [_piece(k, rows[start : start + size]) for k, rows in groups for start in range(0, len(rows), size)]


def _terms(batch: FleetBatch) -> Whole:
    """The number in `VARIANTS` (·,) of the terms that the equations of each robot have."""
    names = ("coulomb_friction", "rolling_friction", "speed_lag")
    slips, rolls, speeds = (batch.parameters[:, NAMES.index(name)] != 0 for name in names)
    return np.where(speeds, 3, np.where(rolls, 2, slips)) + 4 * (batch.slope[:, 0] != 0)


def undivided(batch: FleetBatch) -> Piece:
    """All robots as one piece, with the terms and the steps of the one that needs most."""
    return Piece(slice(0, batch.n), VARIANTS[int(_terms(batch).max())], int(steps_of(batch).max()))


def _piece(kind: int, rows: Selection) -> Piece:
    return Piece(rows, VARIANTS[kind % len(VARIANTS)], 1 + kind // len(VARIANTS))


def steps_of(batch: FleetBatch) -> Whole:
    """Runge–Kutta steps (·,) in a body's period that follow the fastest pole of each robot, as `NonlinearBody` does."""
    if batch.substeps:
        return np.array([batch.substeps])
    parameters = batch.parameters
    period = batch.period
    jacobian = _jacobian(parameters, batch.model)
    steps = np.ones(len(parameters), dtype=np.int64)
    stiff = np.flatnonzero(~(_bound(jacobian) * period <= SIMULATED))
    for i, poles in zip(stiff.tolist(), np.abs(np.linalg.eigvals(jacobian[stiff])), strict=True):
        numbers = dict(zip(NAMES, parameters[i].tolist(), strict=True))
        steps[i] = substeps(period, float(poles.max()), numbers=numbers)
    return steps


def _bound(jacobian: Array) -> Array:
    """No |pole| (n,) [1/s] is larger: the largest sum of a column, with pitch counted as a rate. It is near the fastest
    pole, which the torque between body and wheels makes."""
    sizes = np.abs(jacobian)
    sizes[:, :, 0] /= _PACE
    sizes[:, 0] *= _PACE
    return sizes.sum(axis=1).max(axis=1)


def _jacobian(parameters: Array, model: str) -> Array:
    """∂ẋ/∂x (n, 4, 4) standing upright, without wheel angle and heading, which move nothing; by complex steps of the
    dynamics, for all robots together."""
    p = SimpleNamespace(**dict(zip(NAMES, parameters.T, strict=True)))
    n = len(parameters)
    jacobian = np.zeros((n, 4, 4))
    at = (0, 1, 3, 5)
    for column, state in enumerate(at):
        x = [np.full(n, 1j * _TINY if k == state else 0j) for k in range(6)]
        slopes = derivative(x, (0.0, 0.0), p, xp=np, model=model)
        for row, k in enumerate(at):
            jacobian[:, row, column] = np.imag(slopes[k]) / _TINY
    return jacobian


def _times(step: float, period: float, seconds: float) -> tuple[int, int]:
    stride = stride_of(step, period)
    if not (math.isfinite(seconds) and seconds > 0.5 * period):
        raise InvalidScenario(f"a run of {seconds:g} s", expected=f"a period of the controller, {period:g} s, or more")
    return stride, round(seconds / period)


def stride_of(step: float, period: float) -> int:
    """How many of a body's steps [s] make a controller's `period` [s]; raises `SpecMismatch`."""
    stride = round(period / step)
    if stride < 1 or not math.isclose(stride * step, period, rel_tol=1e-9):
        raise SpecMismatch(
            f"the controller's period {period:g} s is not a multiple of the body's {step:g} s",
            expected="a period that divides it",
            hint="change one of the two periods",
        )
    return stride
