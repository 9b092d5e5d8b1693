"""Calibration as one more linear model: the calibrated robot's tangent, on the log's clock, with its dead time."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.calibration import Calibration
from upright.control.delay import rolling
from upright.identify.coordinates import PHYSICAL, PartModel
from upright.identify.samples import Part
from upright.identify.study import Fit, Pole, Study
from upright.physics.linear import linearise
from upright.robots import Kit, Robot, Sensor

Array = NDArray[np.float64]

_AXES = {"pitch": ((0, 1, 2, 3), (1.0, 1.0)), "yaw": ((4, 5), (-1.0, 1.0))}
"""States of each half in the order of `LinearModel`, and how its command divides among left and right."""


def calibrated(study: Study) -> Fit:
    """The log's robot by maximum likelihood (see `calibrate`); raises `InvalidLog` where it was not read from sensors.

    The model is that of the robot rolling: dry friction is the damping that brakes alike.
    """
    data = study.samples
    found = study.calibration
    pole = found["unstable_pole"]
    parts = tuple(tangent(found.robot, part, late_of(found, part)) for part in data.parts)
    how = "curvature of the likelihood"
    scale = parts[0].pole / pole.value  # one where no dry friction brakes
    return Fit(parts, Pole(parts[0].pole, pole.low * scale, pole.high * scale, np.nan, np.nan, how), notes=found.notes)


def late_of(found: Calibration, part: Part) -> float:
    """What the calibrated dead times leave of a period [s] when the whole periods of the half are taken out."""
    late = {e.name.removeprefix("delay/"): e.value for e in found.delays}
    names = [{"gyro": "gyro", "pitch": ""}.get(output, "encoder") for output in part.outputs]
    rest = [late[name] - shift * part.dt for name, shift in zip(names, part.late, strict=True) if name in late]
    return float(np.clip(np.mean(rest), 0.0, 0.99 * part.dt)) if rest else 0.0


def tangent(robot: Robot, part: Part, dead: float = 0.0) -> PartModel:
    """The linearised robot's half over the period of `part`, whose command arrives `dead` [s] late (under a period)."""
    axes, share = _AXES[part.name]
    model = linearise(rolling(robot))
    names = PHYSICAL[part.name]

    def held(seconds: float) -> tuple[Array, Array]:
        if seconds <= 0:
            return np.eye(len(axes)), np.zeros(len(axes))
        whole = model.c2d(seconds)
        return whole.A[np.ix_(axes, axes)], whole.B[list(axes)] @ np.array(share)

    phi, now = held(part.dt - dead)
    first, old = held(dead)
    if dead <= 0:
        return PartModel(part.name, phi, now, names, part.dt)
    n = len(axes)
    A = np.zeros((n + 1, n + 1))
    A[:n, :n], A[:n, n] = phi @ first, phi @ old
    return PartModel(part.name, A, np.append(now, 1.0), (*names, f"{part.name}_sent"), part.dt)


def kit_as_found(found: Calibration, kit: Kit) -> Kit:
    """`kit` with the calibrated dead times: all of it with the sensors, none of it with the command."""
    late = {e.name.removeprefix("delay/"): max(e.value, 0.0) for e in found.delays}
    sensors: dict[str, Sensor] = {}
    for name, sensor in kit.sensors.items():
        kind = next((k for k in late if k in name), "")
        sensors[name] = replace(sensor, delay=late[kind]) if kind else sensor
    return replace(kit, sensors=sensors, delay=0.0, jitter=0.0)
