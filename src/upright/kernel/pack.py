"""From a batch to the arrays of the compiled loop: one column of common numbers, and a table of those that differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array, Whole
from upright.compiled import generated as g
from upright.control.linear_controller import LinearController
from upright.errors import SpecMismatch
from upright.kernel import rows as b
from upright.kernel.batch import NAMES, FleetBatch
from upright.kernel.functions import CompiledLaw, compiled
from upright.kernel.kit import KitTables
from upright.kernel.rows import Rows
from upright.signals import STATE_NAMES

RESIDUAL = "command/residual"
"""By how much the last iteration of a predictive controller moved its command, over the limit [1]."""

_SAME_TIME = 1e-9  # [s] as in `experiment.pushes`


@dataclass(eq=False, kw_only=True)
class Packed:
    """`common` (r,) holds each row of a block as all robots have it; `rows` (v,) are overwritten by the rows of
    `table` (v, n). `truth` and `sensors` are those of `run.entry`; what is applied stands in rows from `applied` on.
    `alike`: all robots have one dead time, without jitter."""

    at: Rows
    common: Array
    rows: Whole
    table: Array
    truth: Whole
    sensors: Whole
    program: CompiledLaw
    applied: int
    alike: bool


class _Block:
    """Rows of a block, taken one after another, and their initial values."""

    def __init__(self) -> None:
        self.end = 0
        self._given: list[tuple[int, Array]] = []

    def take(self, rows: int, values: Array | None = None) -> int:
        """The first of `rows` new rows, which start as `values` (·, rows), or as zeros."""
        first = self.end
        self.end += rows
        if values is not None:
            self._given.append((first, values.reshape(len(values), rows)))
        return first

    def pack(self) -> tuple[Array, Whole, Array]:
        """`common`, `rows` and `table` of `Packed`."""
        common = np.zeros(self.end)
        rows = list[int]()
        columns = list[Array]()
        for first, values in self._given:
            if len(values) == 1:
                common[first : first + values.shape[1]] = values[0]
            else:
                rows += range(first, first + values.shape[1])
                columns.append(values.T)
        table = np.concatenate(columns) if columns else np.zeros((0, 1))
        return common, np.array(rows, dtype=np.int64), np.ascontiguousarray(table)


def pack(batch: FleetBatch, kit: KitTables, h: float) -> Packed:
    """The batch in the form from which blocks are filled."""
    controller = batch.form
    block = _Block()
    block.take(6, batch.start)
    block.take(2, np.array([[h, 0.0]]))
    block.take(6, np.array([[0.0, 0.0, 0.0, 0.0, 0.0, 1.0]]))  # nothing commanded, no push, a level floor
    block.take(len(g.Constants._fields), constants(batch))
    block.take(g.WORK_ROWS)
    block.take(b.KIT_SIZE, kit.motor)
    block.take(b.COUNTED, np.where(np.arange(b.COUNTS, b.REFERENCE) == b.OUTSIDE, -1.0, 0.0)[None])
    block.take(b.DEAD_TIME - b.REFERENCE)
    block.take(3, kit.dead_time.astype(np.float64))
    block.take(b.FLOOR - b.NOISE)
    block.take(3, _floor(batch))
    block.take(b.FIXED - b.APPLIED)
    assert block.end == b.FIXED, f"{block.end} rows are packed where the layout of `rows` has {b.FIXED}"
    pushes, ramps = pushes_of(batch), _ramps(batch)
    excitation = batch.excitation.reshape(len(batch.excitation), -1)
    # a reference that is zero all the time takes no products
    applied = b.APPLIED if kit.unequal else g.LEFT
    program = compiled(batch.law, len(STATE_NAMES) if ramps.shape[1] else 0, applied)
    slots = int(kit.dead_time[:, 0].max()) + 4 if kit.dead_time.any() else 0
    at = Rows(
        pushes=block.take(pushes.shape[1], pushes), push_count=pushes.shape[1] // 4,
        ramps=block.take(ramps.shape[1], ramps), ramp_count=ramps.shape[1] // 4,
        excitation=block.take(excitation.shape[1], excitation), excitation_count=excitation.shape[1] // 2,
        excitation_hold=batch.excitation_hold,
        reading=block.take(program.rows),
        ring=block.take(2 * slots), slots=slots,
    )  # fmt: skip
    sensors = _sensors(controller, kit, at, block)
    common, rows, table = block.pack()
    truth = [(g.PITCH + _state(name), at.reading + i) for i, name in enumerate(controller.reads) if "truth/" in name]
    return Packed(
        at=at, common=common, rows=rows, table=table, truth=np.array(truth, dtype=np.int64).reshape(-1, 2),
        sensors=sensors, program=program, applied=applied,
        alike=len(kit.dead_time) == 1 and not kit.dead_time[0, 2],
    )  # fmt: skip


def constants(batch: FleetBatch) -> Array:
    """(·, constants): each robot's constants of the traced dynamics."""
    complete = float(batch.model == "complete")
    if len(batch.parameters) == 1:  # one robot's numbers are quicker by themselves than as arrays of one
        return np.array([g.constants(batch.parameters[0].tolist(), complete)])
    return np.stack(np.broadcast_arrays(*g.constants(batch.parameters.T, complete))).T


def pushes_of(batch: FleetBatch) -> Array:
    """(·, 4p): force, moment, first and last step of each push."""
    if batch.pushes.shape[1] == 0:
        return np.zeros((1, 0))
    force, height, start, duration = np.moveaxis(batch.pushes, -1, 0)
    if np.isnan(height).any():
        height = np.where(np.isnan(height), batch.parameters[:, NAMES.index("com_height"), None], height)
    columns = (force, force * height, _step(start, batch.period), _step(start + duration, batch.period))
    return _flat(columns)


def _ramps(batch: FleetBatch) -> Array:
    """(·, 4q): wheel rate, yaw rate, start and end of each part of the reference."""
    if batch.reference.shape[1] == 0:
        return np.zeros((1, 0))
    speed, turn, start, until = np.moveaxis(batch.reference, -1, 0)
    rate = speed / batch.parameters[:, NAMES.index("wheel_radius"), None]
    return _flat((rate, turn, start, until))


def _floor(batch: FleetBatch) -> Array:
    angle, start = batch.slope.T
    return np.stack([np.sin(angle), np.cos(angle), _step(start, batch.period)], axis=1)


def _flat(columns: Sequence[Array]) -> Array:
    stacked = np.stack(np.broadcast_arrays(*columns), axis=-1)
    return stacked.reshape(len(stacked), stacked.shape[1] * len(columns))


def _step(t: Array, period: float) -> Array:
    """The first step at or after `t` [s], but for rounding."""
    return np.ceil((t - _SAME_TIME) / period)


def _sensors(controller: LinearController, kit: KitTables, at: Rows, block: _Block) -> Whole:
    """The table of sensors of `run.entry`, their rows taken from the block."""
    readings = iter([at.reading + i for i, name in enumerate(controller.reads) if name.startswith("sensor/")])
    table = list[tuple[int, ...]]()
    for s, times in enumerate(kit.times.tolist()):
        _, delay, every, *_, spell = times
        places = delay // every + 3
        row = block.take(b.SENSOR_SIZE, kit.sensor[:, s])
        reading = row + b.S_VALUE if spell else next(readings)
        block.take(b.S_LINE - b.SENSOR_SIZE + places)
        random = ((b.S_NOISE, b.LOUD_NOISE), (b.S_WALK, b.LOUD_WALK), (b.S_BIAS, b.LOUD_BIAS))
        loud = sum(sign for column, sign in random if kit.sensor[:, s, column].any())
        table.append((*times, row, places, reading, loud))
    return np.array(table, dtype=np.int64).reshape(-1, b.SENSOR_COLUMNS)


def _state(name: str) -> int:
    names = [f"truth/{state}" for state in STATE_NAMES]
    if name not in names:
        raise SpecMismatch(f"the controller reads {name}", expected="sensors or one of " + ", ".join(names))
    return names.index(name)


def recorded(channels: Sequence[str], packed: Packed, controller: LinearController) -> tuple[Whole, Whole]:
    """Rows to be recorded at the start and at the end of a period."""
    at = packed.at
    residual = packed.program.residual
    start = {f"truth/{name}": g.PITCH + i for i, name in enumerate(STATE_NAMES)}
    start |= {f"reference/{name}": b.REFERENCE + i for i, name in enumerate(STATE_NAMES)}
    start |= {"command/left": b.COMMAND, "command/right": b.COMMAND + 1}
    start |= {name: at.reading + i for i, name in enumerate(controller.reads) if name.startswith("sensor/")}
    start |= {RESIDUAL: at.reading + residual} if residual else {}
    end = {"applied/left": packed.applied, "applied/right": packed.applied + 1, "push/force": g.FORCE}
    for name in channels:
        if name not in start | end:
            raise SpecMismatch(f"no channel '{name}' in this fleet", expected="some of " + ", ".join(start | end))
    before, after = ([table[name] for name in channels if name in table] for table in (start, end))
    return np.array(before, dtype=np.int64), np.array(after, dtype=np.int64)
