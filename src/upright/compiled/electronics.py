"""The formulas of `physics.electronics`, recorded once: blocks for every printer, and functions of Python's floats."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, fields
from functools import cache
from types import SimpleNamespace
from typing import Any

from upright.compiled.print_python import PythonStatements
from upright.compiled.program import Block
from upright.compiled.tracer import FormulaTracer
from upright.physics.electronics import (
    awake,
    driven,
    fused,
    largest,
    loaded,
    measured,
    settled,
    slackened,
    swung,
    tilted,
    turned,
    walked,
)
from upright.robots import Sensor

_NOT_COMPILED = ("delay", "period", "resonance", "damping", "misalignment", "time_constant")
SENSOR_NUMBERS = tuple(f.name for f in fields(Sensor) if f.name not in _NOT_COMPILED)
"""What formulas know of every sensor, in this order."""

GYRO_NUMBERS, FUSED_NUMBERS = ("tilt", "b0", "b1", "b2", "a1", "a2"), ("time_constant", "spell")
"""What they know besides of a gyro, and of a fused angle."""


@cache
def resonance_numbers(frequency: float, damping: float, step: float) -> tuple[float, ...]:
    """b0, b1, b2, a1, a2 of `physics.electronics.swung` for a resonance [Hz, 1], 0 for none, in steps of `step` [s]."""
    if not frequency:
        return 1.0, 0.0, 0.0, 0.0, 0.0
    from scipy.signal import cont2discrete

    omega = 2 * math.pi * frequency
    transfer = [omega**2], [1.0, 2 * damping * omega, omega**2]
    discrete: Any = cont2discrete(transfer, step, method="foh")  # its type says less than it gives
    (b,), (_, a1, a2) = discrete[:2]
    return *b.tolist(), -float(a1), -float(a2)


def gyro_numbers(sensor: Sensor, step: float) -> tuple[float, ...]:
    """`GYRO_NUMBERS` in steps of `step` [s]. The gain does not act on the part of the yaw rate, as a calibration finds
    it."""
    return sensor.misalignment / (sensor.gain or 1.0), *resonance_numbers(sensor.resonance, sensor.damping, step)


@dataclass(frozen=True)
class TracedFormula:
    """Statements over the variables `inputs`; the variables that the block commits are what it gives."""

    inputs: tuple[str, ...]
    block: Block

    @property
    def name(self) -> str:
        return self.block.name

    def function(self) -> Callable[..., tuple[float, ...]]:
        """What it gives, in order, as a function of the inputs, in order."""
        lines = [line for statement in self.block.statements for line in PythonStatements().statement(statement)]
        results = ", ".join(value for _, value in self.block.commit)
        words: dict[str, Any] = {"nearest": _nearest}
        code = [f"def {self.name}({', '.join(self.inputs)}):", *lines, f"return {results},"]
        exec("\n ".join(code), words)  # our own formulas
        return words[self.name]


def formulas(*, volts: bool = True) -> dict[str, TracedFormula]:
    """By name: what reaches the motors (`drive`; commands in `volts` end at the battery's voltage) and 1 where that is
    less than was commanded, what motors make of it (`turn`), a sensor's play (`slacken`), its reading (`measure`), what
    a gyro senses that swings or is tilted (`swing`; `settle` where its motion begins), and a fused angle (`fuse`)."""

    def drive(t: FormulaTracer, v: Any) -> dict[str, Any]:
        command = v.command_left, v.command_right
        left, right = driven(command, v, v, t, volts=volts)
        commands = [awake(u, v, t) for u in command]
        supply = loaded(commands, v, t)
        one, other = (t.absolute(u) for u in commands)
        beyond = t.choose(largest(supply, v, t, volts=volts), t.choose(one, other, other, one), 1.0, 0.0)
        return {"applied_left": left, "applied_right": right, "loaded": supply, "beyond": beyond}

    return {
        name: recorded(name, inputs, record)
        for name, inputs, record in (
            ("drive", "command_left command_right limit dead_zone quantum drop voltage sag", drive),
            ("turn", "applied_left applied_right left right", _turn),
            ("slacken", "touch wheel play", _slacken),
            ("measure", f"ideal drift normal step {' '.join(SENSOR_NUMBERS)}", _measure),
            ("settle", f"rate yaw_rate {' '.join(GYRO_NUMBERS)}", _settle),
            ("swing", f"rate yaw_rate first second {' '.join(GYRO_NUMBERS)}", _swing),
            ("fuse", f"angle cosine sine rate forward up gravity {' '.join(FUSED_NUMBERS)}", _fuse),
        )
    }


def _turn(_: FormulaTracer, v: Any) -> dict[str, Any]:
    left, right = turned((v.applied_left, v.applied_right), v)
    return {"motor_left": left, "motor_right": right}


def _slacken(t: FormulaTracer, v: Any) -> dict[str, Any]:
    return {"touch": slackened(v.touch, v.wheel, v.play, t)}


def _measure(t: FormulaTracer, v: Any) -> dict[str, Any]:
    drift = walked(v.drift, v.step, v)
    return {"reading": measured(v.ideal, drift, v.normal, v, t), "drift": drift}


def _settle(_: FormulaTracer, v: Any) -> dict[str, Any]:
    first, second = settled(v.rate, v)
    return {"sensed": tilted(v.rate, v.yaw_rate, v), "first": first, "second": second}


def _swing(_: FormulaTracer, v: Any) -> dict[str, Any]:
    z, first, second = swung(v.rate, v.first, v.second, v)
    return {"sensed": tilted(z, v.yaw_rate, v), "first": first, "second": second}


def _fuse(_: FormulaTracer, v: Any) -> dict[str, Any]:
    return {"angle": fused(v.angle, (v.cosine, v.sine), (v.rate, v.forward, v.up), v.gravity, v)}


def recorded(name: str, inputs: str, record: Callable[[FormulaTracer, Any], dict[str, Any]]) -> TracedFormula:
    """What `record` gives by name, of a tracer and of what has the `inputs`, between spaces, as its fields."""
    t = FormulaTracer()
    names = inputs.split()
    return TracedFormula(tuple(names), t.block(name, record(t, SimpleNamespace(**{n: t.number(n) for n in names}))))


def _nearest(value: float) -> float:
    return round(value) if math.isfinite(value) else value
