"""The whole loop simulated freely: a calibrated robot under the law that drove the real one, from the excitation."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.calibration import Calibration
from upright.errors import InvalidLog
from upright.physics.dynamics import derivative
from upright.physics.integrate import rk4_step
from upright.physics.linear import linearise
from upright.robots import Robot
from upright.signals import Log

Array = NDArray[np.float64]

STEP = 0.001  # [s] of the simulation; shorter where the robot's fastest pole asks for it
STIFF = 0.5


@dataclass(frozen=True, kw_only=True)
class Law:
    """u = wheel_speed · v + pitch · ψ + pitch_rate · ψ̇ ∓ yaw_rate · φ̇ + excitation, in the command's unit.

    v = R (θ̇_l + θ̇_r)/2 is the wheels' rate relative to the body over the floor [m/s]; the left motor takes the yaw
    rate φ̇ = R (right − left)/W with the upper sign. Every reading is as late as its sensor.
    """

    wheel_speed: float = 0.0
    pitch: float = 0.0
    pitch_rate: float = 0.0
    yaw_rate: float = 0.0


def closed_loop(found: Calibration, log: Log, law: Law) -> dict[str, float]:
    """R² of pitch (against `estimate/pitch`) and of the mean wheel rate relative to the body, over the whole log.

    The log gives the excitation (`excitation/left`, `excitation/right`) and the sampling times, nothing else; the robot
    starts at rest. Raises `InvalidLog` where the excitation was not logged.
    """
    if "excitation/left" not in log or "excitation/right" not in log:
        raise InvalidLog("the log has no excitation", expected="channels excitation/left and excitation/right")
    late = {e.name.removeprefix("delay/"): max(e.value, 0.0) for e in found.delays}
    dither = np.column_stack([log["excitation/left"], log["excitation/right"]])
    states = simulated(found.robot, late, law, log.t, dither)
    said = _readings(states, late, log.t)
    measured = {"pitch": log["estimate/pitch"]} if "estimate/pitch" in log else {}
    measured["wheel rate"] = _wheel_rate(log)
    return {name: _r_squared(values, said[name]) for name, values in measured.items()}


def simulated(robot: Robot, late: Mapping[str, float], law: Law, t: Array, dither: Array) -> Array:
    """The states (n, 6) every `STEP` seconds from t[0] on."""
    count = round(float(t[-1] - t[0]) / STEP) + 1
    states = np.zeros((count, 6))
    substeps = max(1, math.ceil(float(np.abs(linearise(robot).poles()).max()) * STEP / STIFF))
    when = np.round((t - t[0]) / STEP).astype(int)
    row, u = -1, (0.0, 0.0)
    x: tuple[float, ...] = (0.0,) * 6
    for k in range(count - 1):
        if row + 1 < len(when) and when[row + 1] <= k:
            row += 1
            u = _commanded(states[: k + 1], robot, late, law, dither[row])
        for _ in range(substeps):
            x = rk4_step(lambda s, u=u: derivative(s, u, robot), x, STEP / substeps)
        if not abs(x[0]) < math.pi:
            states[k + 1 :] = np.nan
            break
        states[k + 1] = x
    return states


def _commanded(past: Array, robot: Robot, late: Mapping[str, float], law: Law, extra: Array) -> tuple[float, float]:
    gyro, wheels = _ago(past, late["gyro"]), _ago(past, late["encoder"])
    speed = robot.wheel_radius * (wheels[3] - wheels[1])
    both = law.wheel_speed * speed + law.pitch * gyro[0] + law.pitch_rate * gyro[1]
    turn = law.yaw_rate * wheels[5]
    return float(both - turn + extra[0]), float(both + turn + extra[1])


def _ago(past: Array, seconds: float) -> Array:
    """The state that long ago, between two steps; the first one before the beginning."""
    back = len(past) - 1 - seconds / STEP
    if back <= 0:
        return past[0]
    low = int(back)
    share = back - low
    return (1 - share) * past[low] + share * past[min(low + 1, len(past) - 1)]


def _readings(states: Array, late: Mapping[str, float], t: Array) -> dict[str, Array]:
    grid = t[0] + STEP * np.arange(len(states))

    def at(column: Array, delay: float) -> Array:
        return np.interp(t - delay, grid, column)

    return {
        "pitch": at(states[:, 0], late["gyro"]),
        "wheel rate": at(states[:, 3] - states[:, 1], late["encoder"]),
    }


def _wheel_rate(log: Log) -> Array:
    if "sensor/encoder_rate_left" in log:
        return (log["sensor/encoder_rate_left"] + log["sensor/encoder_rate_right"]) / 2
    mean = (log["sensor/encoder_left"] + log["sensor/encoder_right"]) / 2
    return np.gradient(mean, log.t)


def _r_squared(y: Array, said: Array) -> float:
    if not np.isfinite(said).all():
        return -math.inf
    return 1 - float(((y - said) ** 2).sum() / ((y - y.mean()) ** 2).sum())
