"""What each sensor reads, without its faults; generic over the maths namespace like `dynamics`."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import reduce
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.errors import SpecMismatch
from upright.physics.dynamics import CALM, Disturbance, accelerations, turn_ratio
from upright.physics.electronics import response
from upright.physics.interconnect import append
from upright.physics.linear import LinearModel
from upright.robots import Sensor
from upright.signals import STATE_NAMES, TRUE_STATE

PITCH, GYRO, FORWARD, UP = "sensor/pitch", "sensor/gyro", "sensor/accel_forward", "sensor/accel_up"
FUSED_OF = (GYRO, FORWARD, UP)
"""Of whose readings an angle is fused, in the order of `physics.electronics.fused`."""

_DIRECTLY = LinearModel.gain(np.eye(1))
_DIRECT = {PITCH: "pitch", GYRO: "pitch_rate", "sensor/compass": "yaw"}


def sensor_matrix(names: Sequence[str], turn: ArrayLike, sensors: Mapping[str, Any] = MappingProxyType({})) -> Array:
    """C (len(names), 6) from the state to the readings of the named channels, for W/(2R) = `turn` (see `turn_ratio`).

    `turn` (k,) of k robots gives C (len(names), 6, k). Readings are without noise, bias and delay; those of `sensors`
    have their response and misalignment, others are ideal. The true states are channels too. Raises `SpecMismatch` for
    a channel that no matrix gives, such as an accelerometer, which reads accelerations too (`sensed`).
    """
    ratio = np.asarray(turn, dtype=np.float64)
    C = np.zeros((len(names), 6, *ratio.shape))
    for row, name in zip(C, names, strict=True):
        kind = name.removeprefix("sensor/")
        rate = int("_rate" in name)
        if name in TRUE_STATE:
            row[TRUE_STATE.index(name)] = 1.0
        elif name in _DIRECT:
            row[STATE_NAMES.index(_DIRECT[name])] = 1.0
        elif kind.removeprefix("encoder_").removeprefix("rate_") in ("left", "right"):
            row[rate], row[2 + rate], row[4 + rate] = -1.0, 1.0, -ratio if kind.endswith("left") else ratio
        else:
            raise SpecMismatch(
                f"no linear row for {name}", expected="an encoder, gyro, compass, fused angle, or a true state"
            )
        if name in sensors:
            row[:] = response(row, sensors[name])
        if name == GYRO and name in sensors:  # the gain does not act on this part, as a calibration finds it
            row[STATE_NAMES.index("yaw_rate")] = sensors[name].misalignment
    return C


def sensed(
    robot: LinearModel, names: Sequence[str], p: Any, sensors: Mapping[str, Any] = MappingProxyType({})
) -> tuple[LinearModel, Array]:
    """The continuous model of a `robot` with parameters `p`, on the sensors `names`: its readings y = C x + D u + F w,
    and F (len(names), disturbances).

    After the six states come those that sensors have of their own, as readings. A fused angle follows the gyro's
    reading and is drawn to α, the pitch that an accelerometer shows, in its time constant τ. A resonance of ω = 2π f
    and damping ζ lies between the pitch rate and what a gyro reads beside its part of the yaw rate:

        ẋ_f = z + (α − x_f)/τ,   α = ψ − R θ̈/g − γ          z̈ = ω² (ψ̇ − z) − 2ζω ż

    with z = ψ̇ of a gyro without resonance, and each reading with its gain. What the gyro's and the accelerometer's own
    delays do to a fused angle is left out.
    """
    n = len(robot.states)
    m = len(robot.inputs)
    moves = np.hstack([robot.A, robot.B, robot.E])  # ẋ from [x, u, w]
    pitch_rate = np.eye(1, moves.shape[1], STATE_NAMES.index("pitch_rate"))[0]
    forward = p.wheel_radius * moves[STATE_NAMES.index("wheel_rate")]  # force along the body, R θ̈ − g (ψ − γ)
    forward[STATE_NAMES.index("pitch")] -= p.gravity
    forward[n + m + robot.disturbances.index("slope")] += p.gravity
    rows = list[Array]()  # what the filters take, one or two for each reading
    unfiltered = np.zeros((len(names), n))
    filters = [_filter(name, sensors) for name in names]
    for i, name in enumerate(names):
        sensor = sensors.get(name, Sensor())
        if name == FORWARD:
            rows.append(response(forward, sensor))
        elif name == PITCH and filters[i].states:
            drawn = -response(forward, sensors.get(FORWARD, Sensor())) / (p.gravity * sensor.time_constant)
            drawn[STATE_NAMES.index("yaw_rate")] += sensors.get(GYRO, Sensor()).misalignment
            rows += [pitch_rate, drawn]
        elif filters[i].states:
            rows.append(response(pitch_rate, sensor))
            unfiltered[i, STATE_NAMES.index("yaw_rate")] = sensor.misalignment
        else:
            rows.append(np.pad(sensor_matrix([name], turn_ratio(p), sensors)[0], (0, moves.shape[1] - n)))
    own = [f"{name}@{state}" for name, part in zip(names, filters, strict=True) for state in part.states]
    taken = np.array(rows).reshape(-1, moves.shape[1])
    whole = LinearModel(robot.A, moves[:, n:], taken[:, :n], taken[:, n:])
    if own:
        whole = reduce(append, filters) * whole
    order = np.roll(np.arange(n + len(own)), n)  # the robot's states first
    B, E = np.split(whole.B[order], [m], axis=1)
    D, F = np.split(whole.D, [m], axis=1)
    C = whole.C[:, order]
    C[:, :n] += unfiltered
    labels: dict[str, Any] = {"states": (*robot.states, *own), "inputs": robot.inputs, "outputs": tuple(names)}
    A = whole.A[np.ix_(order, order)]
    model = LinearModel(A, B, C, D, E=E, disturbances=robot.disturbances, **labels)
    return model, F


def _filter(name: str, sensors: Mapping[str, Any]) -> LinearModel:
    """From what a sensor would read at once to what it reads; of a fused angle from the pitch rate and from what else
    moves it."""
    sensor = sensors.get(name, Sensor())
    if name == PITCH and sensor.time_constant:
        gyro = sensors.get(GYRO, Sensor())
        swing = _filter(GYRO, sensors)
        lag = sensors.get(UP, Sensor()).gain / sensor.time_constant
        none = np.zeros((len(swing.A), 1))
        A = np.block([[-np.eye(1) * lag, swing.C], [none, swing.A]])
        B = np.block([[response(swing.D, gyro), np.eye(1)], [response(swing.B, gyro), none]])
        C = response(np.eye(1, len(A)), sensor)
        return LinearModel(A, B, C, states=("fused", *(f"fused_{state}" for state in swing.states)))
    if name == GYRO and sensor.resonance:
        omega = 2 * math.pi * sensor.resonance
        swings = np.array([[0.0, 1.0], [-(omega**2), -2 * sensor.damping * omega]])
        return LinearModel(swings, np.array([[0.0], [omega**2]]), np.eye(1, 2), states=("swing", "swing_rate"))
    return _DIRECTLY


def wheel_angles(x: Sequence[Any], p: Any) -> tuple[Any, Any]:
    """θ_l and θ_r [rad]: the mean wheel angle minus and plus W φ / (2R)."""
    turn = turn_ratio(p) * x[4]
    return x[2] - turn, x[2] + turn


def encoders(x: Sequence[Any], p: Any) -> tuple[Any, Any]:
    """Encoders on the body read θ_l − ψ and θ_r − ψ [rad]."""
    left, right = wheel_angles(x, p)
    return left - x[0], right - x[0]


def accelerometer(x: Sequence[Any], wheel_acc: Any, p: Any, slope: Any = 0.0, xp: Any = math) -> tuple[Any, Any]:
    """Specific force [m/s²] at the middle of the axle along the body's forward and up axes.

    At rest and upright it reads (0, +g). `wheel_acc` is θ̈ [rad/s²].
    """
    cos, sin = xp.cos(x[0]), xp.sin(x[0])
    forward = p.wheel_radius * wheel_acc + p.gravity * xp.sin(slope) * xp.cos(x[4])
    up = p.gravity * xp.cos(slope)
    return forward * cos - up * sin, forward * sin + up * cos


def readings(x: Sequence[Any], wheel_acc: Any, p: Any, slope: Any = 0.0, xp: Any = math) -> tuple[Any, ...]:
    """All ideal sensors but the battery, in the order of `signals.signal.SENSORS`."""
    left, right = encoders(x, p)
    forward, up = accelerometer(x, wheel_acc, p, slope, xp)
    return left, right, x[1], x[4], forward, up


def readings_under(
    u: Sequence[Any], x: Sequence[Any], p: Any, w: Disturbance = CALM, xp: Any = math, model: str = "complete"
) -> tuple[Any, ...]:
    """The `readings` in state `x` while the command `u` and the disturbance `w` act."""
    return readings(x, accelerations(x, u, p, w, xp, model)[1], p, w.slope, xp)
