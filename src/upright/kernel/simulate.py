"""Thousands of robots at once: `simulate` runs the loop of `experiment.run` for a whole batch in compiled code.

A robot's result is the same bits whatever batch, order or number of threads it is computed in.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.compiled.generated import LANES
from upright.control import Controller
from upright.errors import InvalidScenario, SpecMismatch
from upright.kernel.batch import NAMES, FleetBatch, FleetResult, Selection
from upright.kernel.work import Order, Outcome, run_piece
from upright.physics.dynamics import derivative
from upright.physics.integrate import substeps
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

STATE = tuple(f"truth/{name}" for name in STATE_NAMES)
FOREVER = (math.inf, math.inf, math.inf)

_TINY = 1e-100

PIECE = 8192
"""Most robots whose tables are made at once: few enough to stay near the processor, and to bound the memory."""

_PARTS = 8  # pieces for each thread: where robots fall early, their thread takes another piece

VARIANTS = ("smooth", "coulomb", "rolling", "slope", "coulomb_slope", "rolling_slope")


def simulate(
    batch: FleetBatch,
    seconds: float = 10.0,
    *,
    record: int = 0,
    channels: Sequence[str] = STATE,
    bands: Sequence[float] = FOREVER,
    dtype: Any = np.float64,
    threads: int | None = None,
    called: Controller | None = None,
) -> FleetResult:
    """Every robot of `batch` for `seconds`, or until it falls.

    `channels` are recorded every `record` periods (0: not at all): truth/…, reference/…, command/…, applied/…,
    push/force, the sensor/… that the controller reads, and command/residual of a predictive one. `bands` are |pitch|,
    |wheel|, |yaw| [rad] inside which a robot counts as settled. `dtype` is float64 or float32; `threads` is by default
    the number of processors.
    The controller `called` acts in place of the batch's own, which is then `batch.silent(called)`: any controller, in
    Python for one robot after another, in float64 and one thread.

    Raises `InvalidScenario` for an impossible time, `SpecMismatch` for unknown channels and periods that do not fit.
    """
    stride, periods = _times(batch.period, batch.form.period, seconds)
    steps = batch.substeps or substeps_for(batch.parameters, batch.model, batch.period)
    order = Order(
        periods=periods, stride=stride, substeps=steps, record=record, channels=tuple(channels if record else ()),
        bands=tuple(bands), dtype=np.dtype(dtype), called=called,
    )  # fmt: skip
    out = Outcome.room(batch.n, order)
    workers = 1 if called else max(1, threads or os.cpu_count() or 1)
    pieces = _pieces(batch, workers)
    alone = min(workers, len(pieces)) == 1 or batch.n <= PIECE

    def work(piece: tuple[str, Selection]) -> None:
        run_piece(batch, piece[1], piece[0], order, out, workers if alone else 1)

    if alone:
        for piece in pieces:
            work(piece)
    else:
        with ThreadPoolExecutor(workers) as pool:
            list(pool.map(work, pieces))
    return out.result(order, batch.period)


def _pieces(batch: FleetBatch, workers: int) -> list[tuple[str, Selection]]:
    """Robots with the same terms in their equations, and the variant of the step for them: the arithmetic of a robot
    does not depend on the others."""
    even = max(PIECE // _PARTS, batch.n // (_PARTS * workers))
    size = batch.n if batch.n <= PIECE else min(PIECE, -(-even // LANES) * LANES)
    slips, rolls = (batch.parameters[:, NAMES.index(f"{name}_friction")] != 0 for name in ("coulomb", "rolling"))
    kinds = np.where(rolls, 2, slips) + 3 * (batch.slope[:, 0] != 0)
    if len(kinds) == 1 or (kinds == kinds[0]).all():
        starts = range(0, batch.n, size)
        return [(VARIANTS[int(kinds[0])], slice(start, min(batch.n, start + size))) for start in starts]
    groups = [(VARIANTS[k], np.flatnonzero(kinds == k)) for k in np.unique(kinds).tolist()]
    return [(name, rows[start : start + size]) for name, rows in groups for start in range(0, len(rows), size)]


def substeps_for(parameters: Array, model: str | Sequence[str], period: float) -> int:
    """Runge–Kutta steps in a body's `period` [s] that follow the fastest pole of the fastest robot."""
    p = SimpleNamespace(**dict(zip(NAMES, parameters.T, strict=True)))
    models = {model} if isinstance(model, str) else set(model)
    fastest = np.max([_fastest(p, name, len(parameters)) for name in models], axis=0)
    stiffest = int(np.argmax(fastest))
    numbers = dict(zip(NAMES, parameters[stiffest].tolist(), strict=True))
    return substeps(period, float(fastest[stiffest]), numbers=numbers)


def _fastest(p: Any, model: str, n: int) -> Array:
    """Largest |pole| (n,) [1/s] standing upright; by complex steps of the dynamics, for all robots together."""
    jacobian = np.zeros((n, 4, 4))
    at = (0, 1, 3, 5)  # wheel angle and heading move nothing
    for column, state in enumerate(at):
        x = [np.full(n, 1j * _TINY if k == state else 0j) for k in range(6)]
        slopes = derivative(x, (0.0, 0.0), p, xp=np, model=model)
        for row, k in enumerate(at):
            jacobian[:, row, column] = np.imag(slopes[k]) / _TINY
    return np.abs(np.linalg.eigvals(jacobian)).max(axis=1)


def _times(step: float, period: float, seconds: float) -> tuple[int, int]:
    stride = round(period / step)
    if stride < 1 or not math.isclose(stride * step, period, rel_tol=1e-9):
        raise SpecMismatch(
            f"the controller's period {period:g} s is not a multiple of the body's {step:g} s",
            expected="a period that divides it",
            hint="change one of the two periods",
        )
    if not (math.isfinite(seconds) and seconds > 0):
        raise InvalidScenario(f"a run of {seconds:g} s", expected="more than zero")
    return stride, round(seconds / period)
