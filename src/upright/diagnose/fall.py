"""Whether and when a robot fell, and how it stood in the seconds before: lean, saturation, dropped readings, swings."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.control.delay import rolling
from upright.control.mpc import largest_command
from upright.diagnose.path import Track
from upright.doctor.finding import Record
from upright.doctor.segments import fall as tipped
from upright.physics.linear import linearise
from upright.robots import Kit, Robot
from upright.signals import Log

Array = NDArray[np.float64]
Mask = NDArray[np.bool_]

FELL = 0.8  # [rad] lean at the end of a log that only falling robots have, unless they swung as far before
LEANING = 0.7  # [rad] up to which the seconds before are looked at
GAP = 1.5  # periods between two rows from which one is missing


@dataclass(frozen=True)
class Fall:
    """When the robot's lean passed `LEANING` for the last time, `at` [s], and which way it `went` (±1)."""

    at: float
    went: int


def fall(found: Track) -> Fall | None:
    """The fall in which the log ends, or after which the robot lies; None where there is none.

    Either the gyro's sum turns farther than ever before and never back, or the filter's pitch ends beyond `FELL`.
    """
    t, rate = found.log.t, gyro(found.log)
    turned = tipped(_record(found.log))
    if turned and turned[0].span:
        start = turned[0].span[0]
        first = int(np.searchsorted(t, start))
        angle = np.concatenate([[0.0], np.cumsum(rate[first:-1] * np.diff(t[first:]))])
        lean = angle + _lean_at(found, start)
        out = np.flatnonzero(np.abs(lean) > LEANING)
        last = first + int(out[0]) if len(out) else len(t) - 1
        return Fall(float(t[last]), int(np.sign(angle[-1])) or 1)
    pitch = found.after[:, 0]
    lost = found.then[-1] < t[-1] - 0.2
    if abs(pitch[-1]) < FELL and not lost:
        return None
    upright = np.flatnonzero(np.abs(pitch) < LEANING)
    return Fall(float(found.then[upright[-1]]), int(np.sign(pitch[-1])))


def gyro(log: Log) -> Array:
    """The gyro without its usual offset [rad/s], missing readings filled in."""
    rate = log["sensor/gyro"]
    there = np.isfinite(rate)
    return np.interp(log.t, log.t[there], rate[there]) - float(np.median(rate[there]))


def _lean_at(found: Track, t: float) -> float:
    """The filter's pitch at t, where it is plausible."""
    i = min(int(np.searchsorted(found.then, t)), len(found.then) - 1)
    return float(np.clip(found.after[i, 0], -0.4, 0.4))


def _record(log: Log) -> Record:
    """What the doctor's check of falls reads; angles of wheels whose rates alone were logged are their sums."""
    steps = np.diff(log.t, prepend=log.t[0])
    channels = dict(log.channels)
    for side in ("left", "right"):
        rate = f"sensor/encoder_rate_{side}"
        if rate in log:
            channels[f"sensor/encoder_{side}"] = np.cumsum(np.nan_to_num(log[rate]) * steps)
    return Record(log.t, channels, log.units)


def before(found: Track, end: float, seconds: float) -> Track:
    """The part of a track that ends at `end` [s] and is at most `seconds` long."""
    keep = (found.then >= end - seconds) & (found.then <= end)
    names = ("then", "row", "sample", "e", "s", "gains", "before", "after", "command")
    return replace(found, **{name: getattr(found, name)[keep] for name in names})


@dataclass(frozen=True)
class Falling:
    """The robot's falling mode ξ = wᵀx with ξ̇ = λ ξ + b (u_l + u_r)/2: `pole` λ [1/s], `w` (6,), and `b`."""

    pole: float
    w: Array
    b: float


def falling(robot: Robot) -> Falling:
    """The falling mode, in which pitch counts one."""
    model = linearise(rolling(robot))
    values, vectors = np.linalg.eig(model.A.T)
    index = int(np.argmax(np.real(values)))
    w = np.real(vectors)[:, index]
    w = w / w[model.states.index("pitch")]
    whole = np.zeros(6)
    names = ("pitch", "pitch_rate", "wheel", "wheel_rate", "yaw", "yaw_rate")
    for name, value in zip(model.states, w, strict=True):
        whole[names.index(name)] = value
    return Falling(float(np.real(values)[index]), whole, float((w @ model.B).sum()))


@dataclass(frozen=True, eq=False)
class Motion:
    """By sample up to the fall: time, command's mean over its limit, the falling mode over what the motors can still
    bring back (`reserve`; 1 is lost), how far the motors `help` (1: all they can, −1: the wrong way), and states."""

    t: Array
    command: Array
    reserve: Array
    help: Array
    states: Array


def motion(found: Track) -> Motion:
    """What the robot and its motors did."""
    commands = found.row < 0
    states = found.after[commands][:, :6]
    sample = found.sample[commands]
    mode, most = falling(found.robot), limit(found.robot, found.kit, found.asked)
    command = found.asked[sample].mean(axis=1) / most
    xi = states @ mode.w
    reserve = np.abs(xi) * mode.pole / (abs(mode.b) * most)
    helped = -np.sign(xi) * np.sign(mode.b) * np.clip(command, -1, 1)
    return Motion(found.then[commands], command, reserve, helped, states)


def limit(robot: Robot, kit: Kit, asked: Array) -> float:
    """The largest command: the kit's, or the largest that was asked where the kit has no end."""
    most = largest_command(robot, kit)
    return most if math.isfinite(most) else float(np.abs(asked).max())


def lost_rows(log: Log, period: float, start: float, stop: float) -> float:
    """The share of periods between two times [s] in which the loop did not run."""
    t = log.t[(log.t >= start) & (log.t <= stop)]
    if len(t) < 3:
        return 0.0
    missing = np.maximum(np.round(np.diff(t) / period) - 1, 0.0)
    return float(missing.sum() / (missing.sum() + len(t) - 1))


def stale_rows(log: Log) -> Mask:
    """Rows in which every sensor says exactly what it said before."""
    names = [n for n in log.channels if n.startswith("sensor/") and "battery" not in n]
    readings = np.column_stack([log[n] for n in names])
    return np.concatenate([[False], (np.diff(readings, axis=0) == 0).all(axis=1)])


def frozen_rows(found: Track) -> Mask:
    """Stale rows in which the wheels turned by two grains or more: no sensor repeats itself then."""
    log, stale = found.log, stale_rows(found.log)
    commands = found.row < 0
    turned = np.zeros(len(log))
    turned[found.sample[commands]] = np.abs(found.after[commands, 3] - found.after[commands, 1]) * log.period
    grain = max((s.quantum for n, s in found.kit.sensors.items() if "encoder" in n), default=0.0)
    return stale & (turned > 2 * grain)


def without(log: Log, rows: Mask) -> Log:
    """The log with the readings of some rows taken out; its commands stay."""
    channels = {n: np.where(rows, np.nan, v) if n.startswith("sensor/") else v for n, v in log.channels.items()}
    return Log(log.t, channels, log.units, log.origin)
