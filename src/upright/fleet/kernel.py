"""Thousands of robots at once: `simulate` runs the loop of `experiment.run` for a whole batch in compiled code.

A robot's result is the same bits whatever batch, order or number of threads it is computed in.
"""

from __future__ import annotations

import math
import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from upright.bodies.body import FALLEN
from upright.errors import InvalidScenario, SpecMismatch
from upright.fleet import kernel_rows as b
from upright.fleet.generated import LANES, ROW
from upright.fleet.kernel_batch import NAMES, FleetBatch, FleetResult
from upright.fleet.kernel_kit import kit_tables
from upright.fleet.kernel_pack import Packed, pack, recorded
from upright.fleet.kernel_rows import Plan
from upright.fleet.kernel_store import address_of, call
from upright.physics.dynamics import derivative
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

STATE = tuple(f"truth/{name}" for name in STATE_NAMES)
FOREVER = (math.inf, math.inf, math.inf)

_STIFF = 0.5  # largest |pole|·h, as in `bodies.models`
_TINY = 1e-100
_SHARES = 8  # shares of the work for each thread, so that one that falls early leaves its thread more


def simulate(
    batch: FleetBatch,
    seconds: float = 10.0,
    *,
    record: int = 0,
    channels: Sequence[str] = STATE,
    bands: Sequence[float] = FOREVER,
    dtype: Any = np.float64,
    threads: int | None = None,
) -> FleetResult:
    """Every robot of `batch` for `seconds`, or until it falls.

    `channels` are recorded every `record` periods (0: not at all): truth/…, reference/…, command/…, applied/…,
    push/force and the sensor/… that the controller reads. `bands` are |pitch|, |wheel|, |yaw| [rad] inside
    which a robot counts as settled. `dtype` is float64 or float32; `threads` is by default the number of processors.

    Raises `InvalidScenario` for times that make no sense, `SpecMismatch` for channels that are not there.
    """
    stride, periods = _times(batch.period, batch.gains.period, seconds)
    substeps = batch.substeps or substeps_for(batch.parameters, batch.model, batch.period)
    h = batch.period / substeps
    kit = kit_tables(batch, stride)
    packed = pack(batch, kit, h, dtype)
    before, after, names = recorded(channels if record else (), packed.at, batch.gains)
    advance, feel = _motion(batch, dtype)
    plan = Plan(
        periods, stride, substeps, record, int(len(batch.gains.C) > 1), int(batch.slope[:, 0].any()),
        int(len(kit.late) == 1 and not kit.late[0, 2]), advance, feel, batch.seed, batch.period, h, FALLEN,
    )  # fmt: skip
    out = Outcome.room(batch.n, -(-periods // record) if record else 0, len(names), dtype)
    _run(batch, packed, plan, (np.array(bands, dtype), before, after), out, threads)
    return out.result(names, plan)


def substeps_for(parameters: Array, model: str | Sequence[str], period: float) -> int:
    """Runge–Kutta steps in a body's `period` [s] that follow the fastest pole of the fastest robot."""
    p = SimpleNamespace(**dict(zip(NAMES, parameters.T, strict=True)))
    models = {model} if isinstance(model, str) else set(model)
    fastest = max(float(_fastest(p, name, len(parameters)).max()) for name in models)
    return max(1, math.ceil(fastest * period / _STIFF))


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
            mend="change one of the two periods",
        )
    if not (math.isfinite(seconds) and seconds > 0):
        raise InvalidScenario(f"a run of {seconds:g} s", expected="more than zero")
    return stride, round(seconds / period)


def _motion(batch: FleetBatch, dtype: Any) -> tuple[int, int]:
    """Addresses of the compiled step and, where it is read, of the accelerometer (else 0)."""
    rough, floor = batch.parameters[:, NAMES.index("coulomb_friction")].any(), batch.slope[:, 0].any()
    variant = {(0, 0): "smooth", (1, 0): "coulomb", (0, 1): "slope", (1, 1): "coulomb_slope"}[int(rough), int(floor)]
    number = np.dtype(dtype).name
    advance = address_of("generated_motion", f"advance_{variant}", (f"*{number}", "int64", number, number))
    if not any("accel" in name for name in batch.gains.reads):
        return advance, 0
    return advance, address_of("generated_motion", f"specific_force_{variant}", (f"*{number}", "int64", "int64"))


class Outcome(NamedTuple):
    """Where the compiled loop writes."""

    final: NDArray[Any]
    lived: NDArray[Any]
    counted: NDArray[Any]
    trace: NDArray[Any]

    @classmethod
    def room(cls, n: int, rows: int, channels: int, dtype: Any) -> Outcome:
        sizes = ((n, 6), (n,), (n, b.COUNTED))
        final, lived, counted = (np.zeros(size, dtype) for size in sizes)
        return cls(final, lived, counted, np.full((n, rows, channels), np.nan, dtype))

    def result(self, channels: tuple[str, ...], plan: Plan) -> FleetResult:
        period = plan.stride * plan.step
        end = plan.periods * period
        fell = ~(np.abs(self.final[:, 0]) <= plan.fallen)
        lived, counted = self.lived.astype(np.float64), self.counted.astype(np.float64)
        periods = np.maximum(1, np.ceil(lived / period - 1e-6))
        outside = counted[:, b.OUTSIDE]
        return FleetResult(
            final=self.final,
            fell=fell,
            lived=lived,
            peak=counted[:, b.PEAK_PITCH : b.PEAK_YAW + 1],
            settled=np.where(
                fell | (outside > end - 1.5 * period), np.nan, np.where(outside < 0, 0.0, outside + period)
            ),
            rms_pitch=np.sqrt(counted[:, b.SQUARE] / periods),
            effort=counted[:, b.EFFORT] * period,
            saturated=counted[:, b.SATURATED] / periods,
            t=np.arange(self.trace.shape[1]) * period * plan.every,
            channels=channels,
            trace=self.trace,
            substeps=plan.substeps,
        )


def _run(batch: FleetBatch, packed: Packed, plan: Plan, rows: Sequence[Any], out: Outcome, threads: int | None) -> None:
    """Shares the blocks out; each thread has its own working memory, which starts at a cache line."""
    number, size = packed.common.dtype.name, len(packed.common)
    p, w = "*int64", f"*{number}"
    kinds = (w, "int64", "int64", p, "*float64", w, p, w, "*uint64", p, p, p, p, w, p, p, w, w, w, w)
    entry = address_of("kernel_run", "entry", kinds)
    index = np.arange(batch.n, dtype=np.uint64) if batch.index is None else np.array(batch.index, dtype=np.uint64)
    sizes = [
        batch.n,
        size,
        len(packed.rows),
        out.trace.shape[1],
        *map(len, (packed.truth, packed.sensors, packed.command, packed.memory)),
        len(rows[1]),
        len(rows[2]),
    ]
    numbers = np.array([*packed.at, *plan[:10], *sizes], dtype=np.int64)
    times = np.array(plan[10:], dtype=np.float64)
    arrays = (
        numbers, times, packed.common, packed.rows, packed.table, index, packed.truth, packed.sensors, packed.command,
        packed.memory, *rows, *out,
    )  # fmt: skip
    addresses = [array.ctypes.data for array in arrays]
    workers = max(1, threads or os.cpu_count() or 1)
    blocks = -(-batch.n // LANES)
    share = LANES * max(1, -(-blocks // (workers * _SHARES)))

    def work(start: int) -> None:
        memory = _aligned(size * ROW, packed.common.dtype)
        call(entry, [memory.ctypes.data, start, min(batch.n, start + share), *addresses])

    starts = range(0, batch.n, share)
    if min(workers, len(starts)) == 1:
        for start in starts:
            work(start)
        return
    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(work, starts))


def _aligned(size: int, dtype: Any) -> NDArray[Any]:
    raw = np.empty(size * dtype.itemsize + 64, np.uint8)
    skip = -raw.ctypes.data % 64
    return raw[skip : skip + size * dtype.itemsize].view(dtype)
