"""A robot and its controllers as JavaScript and numbers, for a page that has no Python behind it."""

from __future__ import annotations

import math
import sys
from collections.abc import Mapping
from typing import Any

from upright.atomic import finite
from upright.bodies import NonlinearBody
from upright.bodies.electronics import ANGLE
from upright.bodies.models import CHANNELS
from upright.compiled.counter import KINDS, walk_steps
from upright.compiled.electronics import GYRO_NUMBERS, SENSOR_NUMBERS, gyro_numbers
from upright.compiled.print_javascript import JavaScriptPrinter, motion
from upright.control import Controller
from upright.control.delay import RAW
from upright.control.law import as_law, program
from upright.errors import InvalidController
from upright.lab.plant import EXPORTED, is_bare
from upright.physics.dynamics import turn_ratio
from upright.physics.linear import linearise_rolling
from upright.physics.sensing import FUSED_OF, GYRO, sensor_matrix
from upright.robots import Kit, Robot, Sensor
from upright.signals.signal import TRUTH

_IDEAL = [*(signal.name for signal in CHANNELS[len(TRUTH) :]), ANGLE]


def printed_robot(robot: Robot, kit: Kit, period: float = EXPORTED) -> tuple[str, dict[str, Any]]:
    """Its motion as JavaScript, and what `simulator.js` needs beside it; raises an `UprightError` for a robot that
    cannot be simulated."""
    text = motion(robot, "complete", period, NonlinearBody(robot, period=period).substeps)
    model = linearise_rolling(robot).c2d(period)
    linear = {name: getattr(model, name).tolist() for name in "ABE"}
    linear |= {"turn": turn_ratio(robot), "radius": robot.wheel_radius, "gravity": robot.gravity, "period": period}
    facts = {"period": period, "gravity": robot.gravity, "kit": kit_numbers(kit, robot, period), "linear": linear}
    return text, facts


def kit_numbers(kit: Kit, robot: Robot, period: float) -> dict[str, Any] | None:
    """The electronics as `simulator.js` takes them, times in steps of `period` [s]; None where there are none."""
    if is_bare(kit):
        return None
    m = kit.motor
    sensors = [_sensor_numbers(name, kit, period) for name in kit.sensors]
    return {
        "limit": finite(m.limit), "dead_zone": m.dead_zone, "quantum": m.quantum, "drop": m.drop,
        "left": m.left, "right": m.right,
        "voltage": finite(kit.battery.voltage), "sag": kit.battery.sag, "volts": robot.command_unit == "V",
        "delay": round(kit.delay / period), "jitter": round(kit.jitter / period), "sensors": sensors,
    }  # fmt: skip


def _sensor_numbers(name: str, kit: Kit, period: float) -> dict[str, Any]:
    """Those of one sensor, an ideal one where the kit has none; of a fused angle with those that it is made of."""
    s = kit.sensors.get(name, Sensor())
    every = max(1, round(s.period / period))
    walks = walk_steps(every, kit.period / period)
    numbers = {number: min(getattr(s, number), sys.float_info.max) for number in SENSOR_NUMBERS}
    numbers |= {
        "from": _IDEAL.index(name) if name in _IDEAL else -1,
        "kind": KINDS.index(name),
        "play": kit.motor.backlash / 2 if "encoder" in name else 0.0,
        "delay": round(s.delay / period),
        "every": every,
        "walks": walks,
        "bias_walk": s.bias_walk * math.sqrt(period * walks),
    }
    if name == GYRO and (s.resonance or s.misalignment):
        return numbers | dict(zip(GYRO_NUMBERS, gyro_numbers(s, period), strict=True))
    if s.time_constant:
        sources = [_sensor_numbers(source, kit, period) for source in FUSED_OF]
        return numbers | {"time_constant": s.time_constant, "spell": every * period, "sources": sources}
    return numbers


def linear_plant(robot: Robot, kit: Kit) -> dict[str, Any]:
    """The robot about upright as `margins.js` takes it, read by `RAW` sensors, with its delays [s]."""
    model = linearise_rolling(robot)
    sensors = [kit.sensors[name] for name in RAW]
    C = sensor_matrix(RAW, turn_ratio(robot), kit.sensors)
    times = {"dead": kit.delay + kit.jitter / 2, "delays": [s.delay for s in sensors], "period": kit.period}
    return {"A": model.A.tolist(), "B": model.B.tolist(), "C": C.tolist(), **times}


def printed_law(controller: Controller, kit: Kit, period: float = EXPORTED) -> tuple[str, dict[str, Any]]:
    """Its program as JavaScript, and where it reads; raises `InvalidController` for one that is no fixed sum of
    products."""
    law = as_law(controller)
    linear = law.linear
    facts = reading(linear.reads, linear.period, kit, period)
    opinion = {name: _rounded(getattr(linear, name)) for name in ("S", "Sy")} if linear.S.size else {}
    return JavaScriptPrinter(program(law)).text(), {**facts, "kind": controller.spec.kind, **opinion}


def reading(reads: tuple[str, ...], every: float, kit: Kit, period: float = EXPORTED) -> Mapping[str, Any]:
    """Where the channels stand among the true states and the kit's sensors, and the body's steps in a period."""
    names = [*(s.name for s in TRUTH), *(_IDEAL if is_bare(kit) else kit.sensors)]
    stride = round(every / period)
    if stride < 1 or not math.isclose(stride * period, every, rel_tol=1e-9):
        raise InvalidController(f"a period of {every:g} s", expected=f"a multiple of {period:g} s in a page")
    return {"reads": [names.index(name) for name in reads], "stride": stride}


def _rounded(matrix: Any) -> list[list[float]]:
    """To what a page draws."""
    return [[float(f"{value:.6g}") for value in row] for row in matrix.tolist()]
