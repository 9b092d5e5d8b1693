"""An executed program as a controller of the twin, compared with its design in every step."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.bodies.electronics import drive
from upright.compiled.counter import FOR_STILL, KINDS, normals
from upright.compiled.fixed import fractions, memory
from upright.compiled.program import Kind, Program
from upright.control.controller import Controller, ControllerSpec
from upright.control.estimators import ACCELEROMETER
from upright.execution.executor import Executor, Values
from upright.firmware.setup import CALIBRATION_TIME
from upright.firmware.targets import BATTERY, COMPASS, GYRO, OFFSET, PITCH
from upright.firmware.tools import ExecutionFailed
from upright.pages import english
from upright.robots import Battery, Kit
from upright.signals import SIDES, STATE_NAMES

TOLERANCE = {"double": 1e-6, "float": 1e-4}
"""The largest difference of a command [V or N m] from the design's, by arithmetic; fixed point states its own."""

ROUNDED = {"double": 1e-14, "float": 1e-6}
"""Rounding of a command [V or N m] in one period, by arithmetic."""
SLACK = {"double": 1e-9, "float": 1e-4, "fixed": 1e-3}
"""Rounding of a command [V or N m] before it becomes a duty, by arithmetic."""


class Readings:
    """A program's raw readings from channels in SI units, as its target's sensors give them, in words of the
    arithmetic `numbers`."""

    def __init__(self, program: Program, kit: Kit, numbers: str = "double") -> None:
        self._program = program
        self._kit = kit
        bits = fractions(program) if numbers == "fixed" else {}
        self._steps = {name: 2.0 ** -bits[name] for name in program.channels if name in bits}
        self.channels = dict(program.channels)
        gyro = next(name for name, channel in self.channels.items() if channel == GYRO)
        offset = OFFSET / program.scales[gyro]
        self.gyro = gyro
        self.offset = round(offset) if program.variables[gyro].whole else offset

    def raw(self, channels: Mapping[str, float], offset: float = 0.0) -> dict[str, float]:
        """`channels` by name [SI] as raw readings by input; `offset` [raw] is added to the gyro's."""
        idle = {v.name: 0.0 for v in self._program.of(Kind.INPUT)}  # the reference, where it is an input
        return idle | {name: self._one(name, channel, channels, offset) for name, channel in self.channels.items()}

    def still(self, count: int, seed: int = 0) -> Iterator[dict[str, float]]:
        """Readings of a robot held still, with the gyro's own noise round its offset."""
        size = self._kit.sensors[GYRO].noise
        resting = {channel: 0.0 for channel in self.channels.values() if channel != BATTERY}
        for normal in normals(np.arange(count), FOR_STILL, KINDS.index(GYRO), seed).tolist():
            yield self.raw(resting | {GYRO: size * normal}, self.offset)

    def si(self, channel: str, channels: Mapping[str, float], raw: Values, offset: float) -> float:
        """The channel as the program computes it [SI], with the gyro's `offset` [raw] of its calibration."""
        name = next(n for n, c in self.channels.items() if c == channel)
        scale = self._program.scales[name]
        if channel == COMPASS:  # the program follows it over its wrap
            return round(channels[channel] / scale) * scale
        value = (raw[name] - (offset if channel == GYRO else 0.0)) * scale
        bound = self._program.variables[channel.removeprefix("sensor/")]
        return min(max(value, bound.low), bound.high)

    def _one(self, name: str, channel: str, channels: Mapping[str, float], offset: float) -> float:
        variable, scale = self._program.variables[name], self._program.scales[name]
        resting = self._kit.battery.voltage if channel == BATTERY else 0.0
        value = channels.get(channel, resting) / scale + (offset if channel == GYRO else 0.0)
        if channel == COMPASS:
            return float(-round(value) % 360)
        step = 1.0 if variable.whole else self._steps.get(name)
        return round(value / step) * step if step else value


def calibrated(executor: Executor, readings: Readings, period: float) -> float:
    """Run the program's calibration; the gyro's offset [raw] that it must come to."""
    count = round(CALIBRATION_TIME / period)
    executor.start()
    readings_of_gyro: list[float] = []
    for raw in readings.still(count):
        if executor.step(raw):
            raise ExecutionFailed("the program balances before its gyro is calibrated")
        readings_of_gyro.append(raw[readings.gyro])
    return float(np.mean(readings_of_gyro))


class Executed:
    """An executed program as a controller of the twin, with the design computed beside it.

    Its duty becomes volts at the battery's voltage under that load. The design gets the program's readings in SI units
    and the program's applied commands, so that every step is compared by itself: a controller of an unstable robot may
    itself be unstable, and then two separate runs diverge at the first duty that rounds differently.
    """

    def __init__(self, executor: Executor, program: Program, kit: Kit, design: Controller) -> None:
        self._executor = executor
        self._program = program
        self._kit = kit
        self._design = design
        self._readings = Readings(program, kit, executor.numbers)
        self._slack = SLACK[executor.numbers]
        self._longest = comparable(program, executor.numbers)
        fused = ACCELEROMETER if PITCH in program.channels.values() else ()  # of which a sketch makes its angle
        reads = tuple(c for c in (*program.channels.values(), *fused) if c in kit.sensors)
        kind = f"{program.kind} on {english(executor.where)}"
        self.spec = ControllerSpec(kind, reads, program.period, program.command_unit)

    def reset(self) -> None:
        self._offset = calibrated(self._executor, self._readings, self._program.period)
        self._design.reset()
        self._sent = deque([(0.0, 0.0)] * self._program.lag)
        self.status, self.steps, self.worst, self.wrong = 0, 0, 0.0, 0

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        if self.status:
            return 0.0, 0.0
        channels = dict(zip(self.spec.reads, measurement.tolist(), strict=True))
        raw = self._readings.raw(channels, self._readings.offset)
        states = {f"reference_{n}": float(v) for n, v in zip(STATE_NAMES, reference, strict=True)}
        given = {c: value for c, value in channels.items() if c in ACCELEROMETER}
        out = self._executor.step(raw | given | {n: v for n, v in states.items() if n in self._program.variables})
        if not out:
            raise ExecutionFailed("the program still calibrates after its calibration time")
        own = {name: out[name] for name in raw if name in out}  # what the program makes of its readings itself
        self._compare(channels, raw | own, out, reference)
        self.status = int(out["status"])
        return self._volts(out)

    def estimate(self) -> Sequence[float]:
        return ()

    def applied(self, command: Sequence[float]) -> None:
        """Nothing: the program computes the applied command itself."""

    def to_json(self) -> dict[str, Any]:
        return {"kind": self.spec.kind, "program": self._program.hash}

    def _compare(self, channels: Mapping[str, float], raw: Values, out: Values, reference: Array) -> None:
        reads = self._design.spec.reads
        y = np.array([self._readings.si(c, channels, raw, self._offset) for c in reads])
        typed = self._program.variables["command_left"].high
        expected = np.clip(self._design.step(y, reference), -typed, typed)
        self._sent.append((out["applied_left"], out["applied_right"]))
        self._design.applied(self._sent.popleft())
        self.wrong += not follows(self._program, self._kit, raw, out, self._slack)
        if self.steps < self._longest:
            self.worst = max(self.worst, float(np.abs(expected - (out["command_left"], out["command_right"])).max()))
            self.steps += 1

    def _volts(self, out: Values) -> tuple[float, float]:
        if not self._program.full:
            return out["applied_left"], out["applied_right"]
        return self._kit.battery.volts([out[f"duty_{side}"] / self._program.full for side in SIDES])


def comparable(program: Program, numbers: str) -> float:
    """Number of periods until rounding grows to a tenth of the tolerance; infinite where the memory is stable."""
    if program.proven:
        return math.inf
    growth = float(np.abs(np.linalg.eigvals(memory(program)[2])).max())
    factor = 0.1 * TOLERANCE[numbers] / ROUNDED[numbers]
    return max(1, math.floor(math.log(factor) / math.log(growth))) if growth > 1 else math.inf


def follows(program: Program, kit: Kit, raw: Values, out: Values, slack: float) -> bool:
    """Whether the applied command is that of the kit's electronics for the command, within a rounding of `slack`."""
    source, step = kit, slack
    if program.full:
        battery = program.variables["battery"]
        volts = min(max(raw["raw_battery"] * program.scales["raw_battery"], battery.low), battery.high)
        step = volts / program.full
        quantum = step * (1 - 1e-9)  # so that full voltage is all of the steps, and not one less by rounding
        source = replace(kit, motor=replace(kit.motor, quantum=quantum), battery=Battery(voltage=volts))
    command, applied = (np.array([out[f"{what}_{s}"] for s in SIDES]) for what in ("command", "applied"))
    nudged = [drive((command + n).tolist(), source, program.command_unit)[0] for n in (0.0, -slack, slack)]
    return all(min(abs(n[i] - applied[i]) for n in nudged) <= step * 0.01 + slack for i in range(2))
