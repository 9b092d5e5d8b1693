"""The kernel one period at a time, under commands from outside: robots of a batch, begun anew one by one."""

from __future__ import annotations

from typing import Any

import numpy as np

from upright.arrays import Array, Whole
from upright.compiled.generated import LANES, PITCH, ROW
from upright.errors import SpecMismatch
from upright.kernel.batch import FleetBatch
from upright.kernel.kit import kit_tables
from upright.kernel.pack import pack
from upright.kernel.rows import COMMAND, Sizes, Times
from upright.kernel.simulate import stride_of, undivided
from upright.kernel.store import address_of, call
from upright.kernel.work import Order, aligned, planned
from upright.robots.kit import STOP

_KINDS = ("*float64", "int64", "*int64", "*int64", "*float64", "*int64", "*uint64")
"""Of the arguments of both functions of `period`."""


class Stepped:
    """`count` places, each with a robot of the batch `pool`: any robot can stand in any place, more than once.

    As in `simulate` the robots move to the last bit, but all in as many steps of Runge and Kutta as the stiffest of the
    pool. The places keep one time: a sensor slower than the controller, in a place begun anew, gives its next sample
    when those of the others do. Raises as `simulate` does.
    """

    def __init__(self, pool: FleetBatch, count: int) -> None:
        stride = stride_of(pool.period, pool.form.period)
        piece = undivided(pool)
        h = pool.period / piece.substeps
        order = Order(periods=0, stride=stride, record=0, channels=(), bands=())
        self._packed = pack(pool, kit_tables(pool, stride), h)
        plan = planned(pool, piece, self._packed, order, "advance")
        self._rows = len(self._packed.common)
        sizes = Sizes(count, self._rows, 0, 0, 0, len(self._packed.sensors), 0, 0)
        self._numbers = np.array([*self._packed.at, *plan, *sizes], dtype=np.int64)
        self._times = np.array(Times(pool.period, h, STOP))
        self._index = np.zeros(count, np.uint64)
        self._clock = np.zeros(2, np.int64)
        self._count = count
        self._block, self._lane = np.divmod(np.arange(count), LANES)
        self._memory = self._blocks(-(-count // LANES))

    def begin(self, places: Whole, robots: Whole, index: Whole, start: Array) -> None:
        """Robots number `robots` (m,) of the pool in the `places` (m,), at rest in the states `start` (m, 6).

        `index` (m,) numbers them for their random numbers, as in a batch.
        """
        packed = self._packed
        self._index[places] = index
        for first in range(0, len(places), LANES):
            some = slice(first, first + LANES)
            block, lane = np.divmod(places[some], LANES)
            fresh = self._blocks(1)
            rows = fresh[0, :, : len(lane)]
            rows[:] = packed.common[:, None]
            rows[packed.rows] = packed.table[:, robots[some]]
            rows[PITCH : PITCH + 6] = start[some].T
            self._call("begin", fresh, len(lane), np.asarray(index[some], dtype=np.uint64))
            self._memory[block, :, lane] = rows.T

    def step(self, commands: Array) -> None:
        """One period under the `commands` (count, 2); raises `SpecMismatch` for others, and where one is not finite."""
        if commands.shape != (self._count, 2) or not np.isfinite(commands).all():
            came = f"commands of shape {commands.shape}, {int((~np.isfinite(commands)).sum())} of them not finite"
            raise SpecMismatch(came, expected=f"shape ({self._count}, 2), all finite")
        self._memory[self._block, COMMAND : COMMAND + 2, self._lane] = commands
        self._call("advance", self._memory, self._count, self._index)

    @property
    def readings(self) -> Array:
        """What the controller's sensors read (count, channels)."""
        return self._values(self._packed.at.reading, len(self._packed.sensors))

    @property
    def state(self) -> Array:
        """The true state (count, 6); that at its fall of a robot that fell."""
        return self._values(PITCH, 6)

    @property
    def applied(self) -> Array:
        """The commands that the motors got at the end of the last period (count, 2)."""
        return self._values(self._packed.applied, 2)

    def _values(self, row: int, size: int) -> Array:
        return self._memory[self._block, row : row + size, self._lane]

    def _blocks(self, count: int) -> Array:
        return aligned(count * self._rows * ROW).reshape(count, self._rows, ROW)

    def _call(self, function: str, memory: Array, count: int, index: Any) -> None:
        tables = (self._clock, self._numbers, self._times, self._packed.sensors, index)
        addresses = [array.ctypes.data for array in tables]
        call(address_of("kernel.period", function, _KINDS), [memory.ctypes.data, count, *addresses])
