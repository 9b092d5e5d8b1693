"""Calibration as one more linear model: the calibrated robot's tangent, on the log's clock, with its dead time."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from upright.arrays import Array
from upright.calibration.calibration import Calibration
from upright.identification.coordinates import COMMANDS, PHYSICAL, growth_rate, half_model, with_sent
from upright.identification.samples import Part
from upright.identification.study import MethodFit, Pole, Study
from upright.pages import Say
from upright.physics.linear import LinearModel, linearise_rolling
from upright.robots import Kit, Robot, Sensor
from upright.signals import STATE_NAMES


def calibrated(study: Study) -> MethodFit:
    """The log's robot by maximum likelihood (see `calibrate`); raises `InvalidLog` where it was not read from sensors.

    The model is that of the robot rolling: dry friction becomes the damping with the same braking.
    """
    result = study.calibration
    pole = result["unstable_pole"]
    halves = {p.name: tangent(result.robot, p, fractional_delay(result, p)) for p in study.samples.parts}
    value = growth_rate(halves["pitch"])
    scale = value / pole.value  # one but for rounding where no dry friction brakes
    how = "curvature of the likelihood"
    free = (pole.value, pole.low, pole.high) if scale < 0.999 else None
    uneven = [result.uneven] if result.uneven else []
    refused = [Say("Not to be trusted: {reason}", reason=reason) for reason in result.refused]
    notes = [*(refused or [*result.check(), *uneven]), *result.notes]
    alike = Pole(value, pole.low * scale, pole.high * scale, how=how, without_friction=free)
    return MethodFit(halves, alike, notes=tuple(notes))


def _delays(calibration: Calibration) -> dict[str, float]:
    """The calibrated dead times [s] by sensor."""
    return {e.name.removeprefix("delay/"): e.value for e in calibration.delays}


def fractional_delay(calibration: Calibration, part: Part) -> float:
    """What the calibrated dead times leave of a period [s] when the whole periods of the half are taken out."""
    delays = _delays(calibration)
    names = [{"gyro": "gyro", "pitch": ""}.get(output, "encoder") for output in part.outputs]
    rest = [delays[name] - count * part.dt for name, count in zip(names, part.delays, strict=True) if name in delays]
    return float(np.clip(np.mean(rest), 0.0, 0.99 * part.dt)) if rest else 0.0


def tangent(robot: Robot, part: Part, delay: float = 0.0) -> LinearModel:
    """The linearised robot's half over the period of `part`, whose command waits for `delay` [s], under a period."""
    axes = [STATE_NAMES.index(name) for name in PHYSICAL[part.name]]
    model = linearise_rolling(robot)
    sides = 2 * np.array(COMMANDS[part.name])

    def held(seconds: float) -> tuple[Array, Array]:
        if seconds <= 0:
            return np.eye(len(axes)), np.zeros(len(axes))
        whole = model.c2d(seconds)
        return whole.A[np.ix_(axes, axes)], whole.B[axes] @ sides

    phi, now = held(part.dt - delay)
    first, old = held(delay)
    half = half_model(part.name, phi @ first, now, part.dt)
    return half if delay <= 0 else with_sent(part.name, half, phi @ old)


def calibrated_kit(calibration: Calibration, kit: Kit) -> Kit:
    """`kit` with the calibrated dead times: all of it with the sensors, none of it with the command."""
    delays = _delays(calibration)
    sensors: dict[str, Sensor] = {}
    for name, sensor in kit.sensors.items():
        kind = next((k for k in delays if k in name), "")
        sensors[name] = replace(sensor, delay=max(delays[kind], 0.0)) if kind else sensor
    return replace(kit, sensors=sensors, delay=0.0, jitter=0.0)
