"""Robots that a blow throws over within a few rows: no filter follows them, but the readings themselves show it.

After a blow of many times what a controller survives, wheels slide and lift off, a gyro stands at the end of its range,
and a log may end before it shows any lean. What remains is a jump of the body's rate that neither gravity nor the
motors, by the commands that had been given, can make in so short a time.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from upright.arrays import Array
from upright.control.reach import largest_command
from upright.diagnose.fall import LEANING, falling, gyro, limit, pace
from upright.diagnose.innovations import FULL_RANGE, asked_of
from upright.logs.raw import RATES
from upright.physics.linear import linearise
from upright.robots import Kit, Robot
from upright.signals import Log

ROWS = 3  # in which a blow has done what it does, or a good part of it
RECENT = 0.3  # [s] of a quick robot before the end of what is judged, in which a blow throws a robot over
CALM_SECONDS, LOUDER = 1.0, 3.0  # [s] before a blow, and how many times larger than any jump there it is
SUDDEN = 0.6  # of the lean from which nothing comes back, that a blow's jump of the rate is worth at least
LOST = 1.5  # of that lean, that it is worth where no motor brings the robot back
FAILS = 4.0  # [rad/s] up to which a jump that the gyro alone shows may be its own
FEW = 3  # rows after a blow, below which a log shows little of it
STANDING_LEAN = 0.3  # [rad] that a robot leans by, at most, while it still balances


@dataclass(frozen=True, kw_only=True)
class Throw:
    """A blow at `start` [s]: the body turns at `after` [rad/s] within `seconds`, `clipped` at the
    end of the gyro's range; `wheels` says whether the encoders show it too, `lost` whether no motor brings the robot
    back, and `left` how long the log goes on [s], in so many `rows`. The jump is so many `times` what they stop."""

    start: float
    after: float
    seconds: float
    clipped: bool
    wheels: bool
    lost: bool
    left: float
    rows: int
    times: float


def thrown(log: Log, robot: Robot, kit: Kit, end: float) -> Throw | None:
    """The blow that threw a robot over within the last `RECENT` seconds before `end` [s], if the log shows one."""
    if "sensor/gyro" not in log or not np.isfinite(log["sensor/gyro"]).any():
        return None
    rate = gyro(log)
    asked = _asked(log, robot, kit)
    model, mode = linearise(robot), falling(robot)
    topples = min(abs(mode.b) * limit(robot, kit, asked) / mode.pole, LEANING) * mode.pole
    gravity = STANDING_LEAN * abs(float(model.A[1, 0]))
    driven = asked @ model.B[1]
    recent = np.flatnonzero((log.t > end - RECENT * pace(robot)) & (log.t <= end + 1e-9)).tolist()
    for count in range(1, ROWS + 1):
        for k in recent[:-count]:
            stop = k + count
            jump = float(rate[k + count] - rate[k])
            helped = [max(0.0, float((np.sign(jump) * driven[max(i - ROWS, 0) : i + 1]).max())) for i in range(k, stop)]
            by_itself = float(((gravity + np.array(helped)) * np.diff(log.t[k : stop + 1])).sum())
            sudden = abs(jump) - by_itself > SUDDEN * topples
            if not sudden or not _stays(rate, k, stop) or not _alone(log, rate, k, jump):
                continue
            jump = float(max(rate[stop : stop + ROWS] - rate[k], key=abs))  # a blow may last longer
            start = float(log.t[k]) - (kit.sensors["sensor/gyro"].delay if "sensor/gyro" in kit.sensors else 0.0)
            clipped = _clipped(log, kit, stop)
            wheels = _wheels_too(log, robot, kit, asked, start)
            if not wheels and not clipped and abs(jump) < FAILS:
                return None
            return Throw(
                start=start, after=float(rate[k]) + jump, seconds=float(log.t[stop] - log.t[k]),
                clipped=clipped, wheels=wheels, lost=clipped or abs(jump) > LOST * topples,
                left=float(log.t[-1]) - start, rows=len(log) - 1 - k, times=abs(jump) / topples,
            )  # fmt: skip
    return None


def _asked(log: Log, robot: Robot, kit: Kit) -> Array:
    """The commands (rows, 2) within the limits of the kit."""
    most = largest_command(robot, kit)
    return np.nan_to_num(np.clip(np.column_stack([log[name] for name in asked_of(log)]), -most, most))


def _stays(rate: Array, k: int, stop: int) -> bool:
    """Whether the body goes on turning: a spike comes back at once."""
    jump = rate[stop] - rate[k]
    return bool((np.sign(jump) * (rate[stop : stop + ROWS] - rate[k]) > abs(jump) / 2).all())


def _alone(log: Log, rate: Array, k: int, jump: float) -> bool:
    """Whether nothing like it came in the calm before it, in rows that all are there and are no repetition."""
    rows = np.flatnonzero(log.t >= log.t[k] - CALM_SECONDS)[0]
    before = rate[rows : k + 1]
    steps = np.diff(log.t[max(k - ROWS, 0) : k + 1 + ROWS])
    whole = not len(steps) or float(steps.max()) < 1.5 * log.period
    largest = float(np.abs(np.diff(before)).max()) if len(before) > ROWS else math.inf
    return whole and abs(jump) > LOUDER * max(largest, float(np.ptp(before)) / 2)


def _clipped(log: Log, kit: Kit, row: int) -> bool:
    sensor = kit.sensors.get("sensor/gyro")
    return sensor is not None and abs(float(log["sensor/gyro"][row])) >= FULL_RANGE * sensor.range


def _wheels_too(log: Log, robot: Robot, kit: Kit, asked: Array, start: float) -> bool:
    """Whether both wheels, against the body, leave their way by more than gravity and motors explain."""
    k = int(np.searchsorted(log.t, start + 1e-9)) - 1
    names = [name for pair in RATES.items() for name in pair if name in log]
    if not names or k < 2:
        return False
    name = names[0]
    model = linearise(robot)
    rates = "rate" in name
    row = model.A[3] - model.A[1]
    motors = np.abs(model.B[3] - model.B[1])
    values = np.mean([log[n] for n in names if ("rate" in n) == rates], axis=0)
    t = log.t
    grain = max((kit.sensors[n].quantum for n in names if n in kit.sensors), default=0.0)
    delay = max((kit.sensors[n].delay for n in names if n in kit.sensors), default=0.0)
    for j in range(k + 1, min(k + 2 + ROWS + round(delay / log.period), len(t))):
        seconds = float(t[j] - t[k])
        pull = STANDING_LEAN * abs(row[0]) + float((np.abs(asked[max(k - ROWS, 0) : j]).max(axis=0) * motors).sum())
        speed = float(values[k] - values[k - 2]) / float(t[k] - t[k - 2])
        if rates:
            beyond = abs(float(values[j] - values[k])) - pull * seconds
        else:
            slow = abs(float(row[3])) * abs(speed) * seconds
            beyond = abs(float(values[j] - values[k]) - speed * seconds) - (pull + slow) * seconds**2 / 2 - 2.5 * grain
        if beyond > 0:
            return True
    return False
