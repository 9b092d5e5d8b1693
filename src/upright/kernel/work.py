"""One piece of a batch through the compiled loop: makes its tables, distributes its blocks, writes its results, and
calls controllers that no law describes, one copy for each robot of a block."""

from __future__ import annotations

import copy
import ctypes
import math
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cache
from typing import Any, NamedTuple

import numpy as np

from upright.arrays import Array
from upright.compiled.generated import LANES, ROW, H
from upright.control import Controller
from upright.errors import SpecMismatch
from upright.kernel import rows as b
from upright.kernel.batch import FleetBatch, FleetResult, Selection
from upright.kernel.functions import electronics
from upright.kernel.kit import kit_tables
from upright.kernel.pack import Packed, pack, recorded
from upright.kernel.rows import Plan, Sizes, Times
from upright.kernel.store import address_of, call
from upright.robots.kit import STOP

_PARTS = 8  # parts of the work for each thread: where robots fall early, their thread takes another part

MOTION = "compiled.generated_motion"


@dataclass(frozen=True, eq=False, kw_only=True)
class Order:
    """Settings of a run, the same for all robots."""

    periods: int
    stride: int  # steps of a body in a period
    record: int  # periods from one recorded row to the next, 0: none
    channels: tuple[str, ...]
    bands: tuple[float, ...]


class Piece(NamedTuple):
    """Robots of a batch that one `variant` of the step moves, in as many steps of Runge and Kutta."""

    rows: Selection
    variant: str
    substeps: int


class Outcome(NamedTuple):
    """Arrays that the compiled loop writes."""

    final: Array
    lived: Array
    counted: Array
    trace: Array

    @classmethod
    def room(cls, n: int, order: Order) -> Outcome:
        kept = -(-order.periods // order.record) if order.record else 0
        trace = np.full((n, kept, len(order.channels)), np.nan)
        return cls(np.zeros((n, 6)), np.zeros(n), np.zeros((n, b.COUNTED)), trace)

    def part(self, rows: Selection) -> Outcome:
        """Some robots: a view for a slice, else a copy."""
        return Outcome(*(array[rows] for array in self))

    def take(self, rows: Selection, part: Outcome) -> None:
        """Writes back a copied part."""
        for array, values in zip(self, part, strict=True):
            array[rows] = values

    def result(self, order: Order, step: float) -> FleetResult:
        period = order.stride * step
        end = order.periods * period
        fell = ~(np.abs(self.final[:, 0]) <= STOP)
        counted = self.counted
        periods = np.maximum(1, np.ceil(self.lived / period - 1e-6))
        outside = counted[:, b.OUTSIDE - b.COUNTS]
        never = fell | (outside > end - 1.5 * period)
        return FleetResult(
            final=self.final,
            fell=fell,
            lived=self.lived,
            peak=counted[:, :3],
            settled=np.where(never, np.nan, np.where(outside < 0, 0.0, outside + period)),
            rms_pitch=np.sqrt(counted[:, b.SQUARE - b.COUNTS] / periods),
            effort=counted[:, b.EFFORT - b.COUNTS] * period,
            saturated=counted[:, b.SATURATED - b.COUNTS] / periods,
            t=np.arange(self.trace.shape[1]) * period * order.record,
            channels=recorded_order(order.channels),
            trace=self.trace,
        )


def recorded_order(channels: tuple[str, ...]) -> tuple[str, ...]:
    """The channels as they stand in a trace: first those of a period's start, then those of its end."""
    return tuple(sorted(channels, key=lambda name: name.startswith(("applied/", "push/"))))


def run_piece(batch: FleetBatch, piece: Piece, order: Order, out: Outcome, threads: int) -> None:
    """The robots of one piece of the batch, into the same rows of `out`.

    Raises `SpecMismatch` for what the kit or the channels do not have, `InvalidScenario` for impossible times.
    """
    rows, _, substeps = piece
    whole = isinstance(rows, slice) and rows.stop - rows.start == batch.n
    some = batch if whole else batch.part(rows)
    h = batch.period / substeps
    packed = pack(some, kit_tables(some, order.stride), h)
    before, after = recorded(order.channels, packed, some.form)
    lanes = Lanes(batch.called, packed) if batch.called else None
    move = "step" if batch.n == 1 else "advance"
    plan = planned(some, piece, packed, order, move, lanes.address if lanes else 0)
    here = out if whole else out.part(rows)
    extra = (np.array(order.bands), before, after)
    _run(some, packed, plan, Times(batch.period, h, STOP), extra, here, threads)
    if lanes:
        lanes.check()
    if not isinstance(rows, slice):
        out.take(rows, here)


_CALLED = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64)


class Lanes:
    """The function that `Plan.called` points to. Compiled code passes no exception on: an error is kept, commands are
    zero from then on, and `check` raises it after the run."""

    def __init__(self, controller: Controller, packed: Packed) -> None:
        at = packed.at
        self._applied = slice(packed.applied, packed.applied + 2)
        self._copies = [copy.deepcopy(controller) for _ in range(LANES)]
        self._reading = slice(at.reading, at.reading + len(controller.spec.reads))
        self._rows = max(at.reading + len(controller.spec.reads), b.COMMAND + 2, b.REFERENCE + 6)
        self._error: BaseException | None = None
        self._function: Any = _CALLED(self._decide)
        self.address = int(ctypes.cast(self._function, ctypes.c_void_p).value or 0)

    def check(self) -> None:
        """Raise the error of a controller, if there was one."""
        if self._error:
            raise self._error

    def _decide(self, block: int, count: int, k: int) -> None:
        numbers = (ctypes.c_double * (self._rows * ROW)).from_address(block)
        w: Array = np.ctypeslib.as_array(numbers).reshape(self._rows, ROW)[:, :count]
        try:
            if not self._error:
                self._command(w, k)
        except BaseException as error:  # a compiled caller would print it and go on, Ctrl-C included
            self._error = error
        if self._error:
            w[b.COMMAND : b.COMMAND + 2] = 0.0

    def _command(self, w: Array, k: int) -> None:
        readings = w[self._reading].T.copy()
        references = w[b.REFERENCE : b.REFERENCE + 6].T.copy()
        applied = w[self._applied].T.tolist()
        standing = w[H] > 0
        for i in np.flatnonzero(standing).tolist():
            one = self._copies[i]
            if k == 0:
                one.reset()
            else:
                one.applied(applied[i])
            left, right = one.step(readings[i], references[i])
            if not (math.isfinite(left) and math.isfinite(right)):
                raise SpecMismatch(f"command is [{left}, {right}]", expected="finite numbers")
            w[b.COMMAND : b.COMMAND + 2, i] = left, right


def planned(batch: FleetBatch, piece: Piece, packed: Packed, order: Order, move: str, called: int = 0) -> Plan:
    """What is common to the robots of a `piece`, which `move` moves: "advance", or "step" for a robot alone."""
    advance = address_of(MOTION, f"{move}_{piece.variant}", ("*float64", "int64", "float64", "float64"))
    accelerometer = 0
    if any("accel" in name or name == "sensor/pitch" for name in batch.form.reads):
        accelerometer = address_of(MOTION, f"specific_force_{piece.variant}", ("*float64", "int64", "int64"))
    return Plan(
        order.periods, order.stride, piece.substeps, order.record, packed.program.command, packed.program.update,
        int("slope" in piece.variant), int(packed.alike), advance, accelerometer,
        packed.applied, *electronics(), called, int(np.uint64(batch.seed).astype(np.int64)),
    )  # fmt: skip


def _run(
    batch: FleetBatch, packed: Packed, plan: Plan, times: Times, rows: tuple[Any, ...], out: Outcome, threads: int
) -> None:
    """Distributes the blocks; each thread has its own working memory, which starts at a cache line."""
    size = len(packed.common)
    entry = _entry()
    index = np.arange(batch.n, dtype=np.uint64) if batch.index is None else np.array(batch.index, dtype=np.uint64)
    held = (packed.truth, packed.sensors, rows[1], rows[2])
    sizes = Sizes(batch.n, size, len(packed.rows), out.trace.shape[1], *map(len, held))
    numbers = np.array([*packed.at, *plan, *sizes], dtype=np.int64)
    arrays = (
        numbers, np.array(times), packed.common, packed.rows, packed.table, index, packed.truth, packed.sensors,
        packed.program.constants, *rows, *out,
    )  # fmt: skip
    blocks = -(-batch.n // LANES)
    size_of_part = LANES * (blocks if threads == 1 else max(1, -(-blocks // (threads * _PARTS))))

    def work(start: int) -> None:
        memory = aligned(size * ROW)
        addresses = [array.ctypes.data for array in (memory, *arrays)]  # here, so that a thread alone keeps them alive
        call(entry, [addresses[0], start, min(batch.n, start + size_of_part), *addresses[1:]])

    starts = range(0, batch.n, size_of_part)
    if len(starts) == 1:
        work(0)
        return
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(work, starts))


@cache
def _entry() -> int:
    p = "*int64"
    w = "*float64"
    kinds = (w, "int64", "int64", p, w, w, p, w, "*uint64", p, p, w, w, p, p, w, w, w, w)
    return address_of("kernel.run", "entry", kinds)


def aligned(size: int) -> Array:
    """That many zeros, the first at a cache line."""
    raw = np.zeros(size + 7)
    skip = -raw.ctypes.data % 64 // 8
    return raw[skip : skip + size]
