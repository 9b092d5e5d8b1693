"""The numbers of a kit as tables of the kernel: one row for all robots, or one for each."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np

from upright.arrays import Array, Whole
from upright.compiled.counter import KINDS, walk_steps
from upright.compiled.electronics import GYRO_NUMBERS, SENSOR_NUMBERS, resonance_numbers
from upright.errors import InvalidScenario, SpecMismatch, UnknownName
from upright.kernel.batch import FleetBatch
from upright.kernel.rows import FUSED, PLAIN, SENSOR_SIZE, SLACK, SWUNG
from upright.physics.sensing import FUSED_OF
from upright.robots import Kit, Sensor
from upright.robots.drives import drive_of

BARE = Kit(name="bare")
READ = KINDS[:-1]
"""Sensors that a controller can read here."""

_MOTOR = (
    "motor.limit", "motor.dead_zone", "motor.quantum", "motor.drop", "battery.voltage", "battery.sag", "motor.left",
    "motor.right",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class KitTables:
    """`motor` (·, 8) and `sensor` (·, s, numbers) as in `block`; `dead_time` (·, 3) as in `block.arrive`;
    `times` (s, 7): of each sensor its kind, its delay, its period and that of its walk [steps], how it senses, in which
    steps, and in which of them an angle is made of it. Before a fused angle stand the three that it is made of, beside
    those that the controller reads itself: what is drawn depends on the time alone, so that both copies read the same.
    """

    motor: Array
    dead_time: Whole
    sensor: Array
    times: Whole

    @property
    def unequal(self) -> bool:
        """Whether some motor makes more or less of what is applied to it."""
        return bool((self.motor[:, -2:] != 1).any())


def kit_tables(batch: FleetBatch, stride: int) -> KitTables:
    """The tables for the sensors that the batch's controller reads, in that order, and those of a fused angle.

    Raises `SpecMismatch` for a sensor that the kit does not have or a drive that it is not for, `UnknownName` for a
    change of an unknown number, `InvalidScenario` for a jitter longer than a period.
    """
    kit = batch.kit or BARE
    controller = batch.form
    voltage = controller.command_unit == "V"
    if batch.kit is None and not batch.kit_changes and not any(name.startswith("sensor/") for name in controller.reads):
        return _bare(voltage)
    kit.check_drive(drive_of(controller.command_unit))
    numbers = _Numbers(kit, batch.kit_changes)
    ideal = {"battery.voltage": math.inf, "battery.sag": 0.0, "motor.drop": 0.0}
    motor = _stack([numbers[n] if voltage or n not in ideal else np.array([ideal[n]]) for n in _MOTOR])
    reads = list[tuple[str, Sensor, int]]()
    for name in controller.reads:
        if not name.startswith("sensor/"):
            continue
        sensor = _sensor(batch.kit, name)
        if sensor.time_constant:
            spell = max(1, round(sensor.period / batch.period))
            reads += [(source, kit.sensors.get(source, Sensor()), spell) for source in FUSED_OF]
        reads.append((name, sensor, 0))
    rows = list[Array]()
    times = list[tuple[int, ...]]()
    for name, sensor, spell in reads:
        every = max(1, round(sensor.period / batch.period))
        walks = walk_steps(every, kit.period / batch.period)
        own, senses, pace = _own(numbers, name, sensor, every, batch.period)
        own += [np.zeros(1)] * (len(GYRO_NUMBERS) - len(own))
        rows.append(_stack([*(numbers[f"sensors.{name[7:]}.{f}"] for f in SENSOR_NUMBERS), *own]))
        times.append((KINDS.index(name), round(sensor.delay / batch.period), every, walks, senses, pace, spell))
    table = _stack(rows) if rows else np.zeros((1, 0, SENSOR_SIZE))
    dead_time = _dead_time(numbers, batch.period, stride)
    numbers.check()
    return KitTables(motor, dead_time, table, np.array(times, dtype=np.int64).reshape(-1, 7))


@cache
def _bare(voltage: bool) -> KitTables:
    """The tables without a kit, made once: they would take half of the time to start a single robot."""
    motor = [[BARE.motor.limit, 0.0, 0.0, 0.0, BARE.battery.voltage if voltage else math.inf, 0.0, 1.0, 1.0]]
    dead_time, times = np.zeros((1, 3), dtype=np.int64), np.zeros((0, 7), dtype=np.int64)
    return KitTables(np.array(motor), dead_time, np.zeros((1, 0, SENSOR_SIZE)), times)


class _Numbers:
    """The kit's numbers by dotted name, with the changes in place."""

    def __init__(self, kit: Kit, changes: Mapping[str, Any]) -> None:
        self._kit = kit
        self._changes = changes
        self._used = set[str]()

    def __getitem__(self, name: str) -> Array:
        self._used.add(name)
        if name in self._changes:
            return self._changes[name]
        owner, _, number = name.rpartition(".")
        if owner.startswith("sensors."):
            sensor = self._kit.sensors.get(f"sensor/{owner[8:]}", Sensor())
            return np.array([float(getattr(sensor, number))])
        return np.array([float(getattr(getattr(self._kit, owner) if owner else self._kit, number))])

    def check(self) -> None:
        """Refuses changes of numbers that no table here holds."""
        for name in self._changes:
            if name not in self._used:
                raise UnknownName("number of this kit with this controller", name, self._used)


def _stack(columns: list[Array]) -> Array:
    n = max(len(column) for column in columns)
    return np.stack([np.broadcast_to(column, (n, *column.shape[1:])) for column in columns], axis=1)


def _own(numbers: _Numbers, name: str, sensor: Sensor, every: int, step: float) -> tuple[list[Array], int, int]:
    """The numbers (·,) of a sensor that only its kind has, how it senses, and in which of the steps of `step` [s]."""
    if "encoder" in name:
        play = numbers["motor.backlash"] / 2
        slack = bool(play.any())
        return [play], SLACK if slack else PLAIN, int(slack)
    if name == "sensor/gyro":
        tilt = numbers["sensors.gyro.misalignment"] / numbers["sensors.gyro.gain"]
        swing = [np.array([n]) for n in resonance_numbers(sensor.resonance, sensor.damping, step)]
        return [tilt, *swing], SWUNG if sensor.resonance or tilt.any() else PLAIN, int(sensor.resonance > 0)
    if name == "sensor/pitch" and sensor.time_constant:
        return [np.array([sensor.time_constant]), np.array([every * step])], FUSED, every
    return [], PLAIN, 0


def _sensor(kit: Kit | None, name: str) -> Sensor:
    if name not in READ:
        raise SpecMismatch(f"the controller reads {name}", expected="one of " + ", ".join(READ))
    if kit is None:
        return Sensor()
    if name not in kit.sensors:
        raise SpecMismatch(f"kit '{kit.name}' has no {name}", expected=f"one of {', '.join(kit.sensors)}")
    return kit.sensors[name]


def _dead_time(numbers: _Numbers, period: float, stride: int) -> Whole:
    steps, jitter = (np.rint(numbers[name] / period).astype(np.int64) for name in ("delay", "jitter"))
    if jitter.max() > stride:
        raise InvalidScenario(
            f"a jitter of {jitter.max() * period:g} s",
            expected=f"at most the controller's period, {stride * period:g} s",
        )
    rows = np.broadcast_arrays(steps // stride, steps % stride, jitter)
    return np.ascontiguousarray(np.stack(rows, axis=1))
