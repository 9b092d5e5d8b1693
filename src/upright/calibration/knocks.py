"""The steady Kalman filter of a known robot along a log, and when somebody pushed the robot.

A calibration knows of no pushes: what a knock moves, it takes for the robot's own motion.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from upright.arrays import Array, Mask, Whole
from upright.control.delay import MOST_PERIODS, RAW, SampledRobot, sampled
from upright.control.kalman import filtered, kalman_filter
from upright.errors import InvalidLog, UprightError
from upright.logs.outliers import bridged, single
from upright.logs.raw import RATES
from upright.logs.recording import commanded
from upright.pages import Quantity, Say
from upright.physics.dynamics import turn_ratio
from upright.physics.electronics import driven
from upright.physics.linear import linearise
from upright.robots import Kit, Robot
from upright.signals import Log

SETTLED = 1.0  # [s] in which the filter finds the first state
LEAST = 2.0  # [s] of log after that
UNEVEN = 0.02  # fraction of steps that may be half a period off
MOST_LOST = 10  # periods without a row over which a filter goes on
FAR = 5.0  # usual sizes of an innovation beyond which a push is taken for its cause
PUSHED = 0.3  # [s] after it that are left out, in which the filter finds the state again
MOST_PUSHED = 0.5  # of a log that may be left out; where more would be, it is no push
KNOCK = 10.0  # usual sizes of an innovation: on real logs without a push they reach 7, after a knock 20 to 35
LEAST_CALM = 2.0  # [s] without a push, from which a calibration learns
LEAST_MOVED = 0.05  # of how far the wheels turn in the part in which they turn most: a part that stands tells no motion
MOST_NAMED = 4  # times of knocks in a sentence


class Knocks(NamedTuple):
    """`times` [s] of a log of `length` [s] at which somebody seems to have pushed; of which `used` [s] are left, where
    these times were cut out, None elsewhere; and whether `enough` would be left."""

    times: tuple[float, ...]
    length: float
    used: float | None
    enough: bool

    @property
    def remark(self) -> Say:
        """What they do to the fit, for people."""
        when = [Quantity(t, "s") for t in self.times[:MOST_NAMED]]
        if not self.enough:
            return Say("What looks like a push at {times} bends the numbers; too little lies between.", times=when)
        if self.used is None:
            return Say("What looks like a push at {times} bends the numbers; try --between-knocks.", times=when)
        return Say(
            "What looks like a push at {times} is left out: {used} of {length} are used.",
            times=when,
            used=Quantity(self.used, "s"),
            length=Quantity(self.length, "s"),
        )


def periods_of(log: Log) -> Whole:
    """The period, counted from the first row, in which each row of the log stands: where rows are lost, some have none.
    A pause of more than `MOST_LOST` periods counts as one: after it a filter begins anew in any case."""
    steps = np.maximum(1, np.rint(np.diff(log.t) / log.period)).astype(np.int64)
    return np.concatenate([[0], np.cumsum(np.where(steps > MOST_LOST, 1, steps))])


def recorded(log: Log, delay: int) -> tuple[Array, Array]:
    """Readings (n, 3) of both encoders and the gyro in every period of the log, NaN where its row is lost, and applied
    commands (n, 2), which stay over a lost row.

    Where the log has only commands as sent, they are delayed by `delay` periods.
    """
    steps = np.diff(log.t)
    if np.mean(np.abs(steps - log.period) > log.period / 2) > UNEVEN:
        raise InvalidLog("the log is uneven", expected=f"steps near {log.period:g} s", likely="dropped samples",
                         hint="cut the log with --from and --until, or ask `upright doctor`")  # fmt: skip
    if log.t[-1] - log.t[0] < SETTLED + LEAST:
        raise InvalidLog(f"what can be followed of the log lasts {log.t[-1] - log.t[0]:.1f} s",
                         expected=f"{SETTLED + LEAST:g} s or more with the robot on its wheels")  # fmt: skip
    at = periods_of(log)
    readings = np.full((at[-1] + 1, len(RAW)), np.nan)
    readings[at] = np.column_stack([_reading(log, name) for name in RAW])
    prefix = commanded(log)
    if not prefix:
        raise InvalidLog("the log has no commands", expected="channels applied/left and applied/right")
    last = np.searchsorted(at, np.arange(len(readings)), side="right") - 1
    commands = np.column_stack([log[f"{prefix}/left"], log[f"{prefix}/right"]])[last]
    periods = delay if prefix == "command" else 0
    return readings, np.vstack([np.zeros((periods, 2)), commands])[: len(readings)]


def at_motors(commands: Array, kit: Kit, unit: str, *, sent: bool = True) -> Array:
    """What both motors make (n, 2) of commands that were `sent`, or that the driver has applied already."""
    applied = (
        np.stack(driven([*commands.T], kit.motor, kit.battery, Arrays, volts=unit == "V"), 1) if sent else commands
    )
    return applied * [kit.motor.left, kit.motor.right]


class Arrays:
    """The namespace of `physics.electronics` for arrays."""

    absolute, whole, nearest, limit = np.abs, np.trunc, np.rint, np.clip

    @staticmethod
    def choose(left: Any, right: Any, then: Any, other: Any) -> Any:
        return np.where(left < right, then, other)


def _reading(log: Log, name: str) -> Array:
    """The channel, without single readings far from their neighbours; the integral of the rate for an encoder that was
    logged as a rate."""
    rate = RATES.get(name, "")
    values = np.cumsum(log[rate]) * log.period if name not in log and rate in log else log[name]
    return bridged(log.t, values, single(log.t, values))


def first_state(model: SampledRobot, readings: Array) -> Array:
    """The state (states, …) at rest with these first readings (sensors, …)."""
    first = np.nan_to_num(readings)
    start = np.zeros((len(model.linear.A), *first.shape[1:]))
    start[2], start[4] = (first[0] + first[1]) / 2, (first[1] - first[0]) / (2 * turn_ratio(model.robot))
    for place, name in enumerate(model.linear.states):
        start[place] += first[RAW.index(name.partition("@")[0])] if "@" in name else 0.0
    return start


def pushed(errors: Array, period: float, far: float = FAR) -> Mask:
    """Rows (n,) at and after innovations (n, sensors) `far` beyond their usual size: somebody pushed the robot."""
    there, usual = _usual(errors, period)
    beyond = (np.abs(np.nan_to_num(errors)) > far * usual).any(axis=1) & there
    after: Mask = np.convolve(beyond, np.ones(max(1, round(PUSHED / period))))[: len(errors)] > 0
    return after if there.any() and after[there].mean() < MOST_PUSHED else np.zeros(len(errors), dtype=np.bool_)


def _usual(errors: Array, period: float) -> tuple[Mask, Array]:
    """Which rows of innovations (n, sensors) count, and their usual sizes (sensors,) there."""
    there = np.isfinite(errors).all(axis=1) & (np.arange(len(errors)) >= SETTLED / period)
    return there, 1.4826 * np.median(np.abs(errors[there]), axis=0) if there.any() else np.ones(errors.shape[1])


def moved_by(model: SampledRobot, commands: Array) -> Array:
    """What commands (n, 2) add to the states in each period (n, states)."""
    before = np.concatenate([np.zeros((1, 2)), commands[:-1]])
    return before @ model.before.T + commands @ model.now.T


def innovations(log: Log, robot: Robot, kit: Kit) -> Array:
    """What each reading of the log (n, 3) is beside the one predicted by the steady filter of `robot` on `kit`; NaN
    after a lost row, whose command nobody knows, until that has reached the readings."""
    model = sampled(robot, kit, log.period, longest=MOST_PERIODS)
    readings, sent = recorded(log, model.delay)
    moved = moved_by(model, at_motors(sent, kit, robot.command_unit, sent=commanded(log) == "command"))
    A = model.linear.A
    C = model.linear.C
    L = kalman_filter(model).L
    errors = filtered(A, C, L, readings, moved, first_state(model, readings[0]))[1]
    latest = kit.delay + kit.jitter + max(sensor.delay for sensor in kit.sensors.values())
    reached = np.ones(2 + math.ceil(latest / log.period))
    errors[np.convolve(np.isnan(readings).any(axis=1), reached)[: len(errors)] > 0] = np.nan
    return errors[periods_of(log)]


def traces(log: Log, robot: Robot, kit: Kit) -> Array:
    """How much a push at the centre of mass in each row of the log (n, 1) explains of the innovations of the steady
    filter of `robot` in the 0.3 s after it, by least squares (Willsky and Jones 1976): a hand pushes too softly to
    show in single readings."""
    model = sampled(robot, kit, log.period, longest=MOST_PERIODS)
    errors = innovations(log, robot, kit)
    A = model.linear.A
    C = model.linear.C
    L = kalman_filter(model).L
    E = linearise(robot).E
    state = np.zeros(len(A))
    left = list[Array]()
    state[: len(E)] = E[:, 0] + robot.com_height * E[:, 1]
    for _ in range(round(PUSHED / log.period)):
        left.append(C @ state)
        state = A @ (state - L @ left[-1])
    usual = np.maximum(_usual(errors, log.period)[1], 1e-12)  # of a reading that never changes too
    white = np.nan_to_num(errors / usual)
    shape = np.array(left) / usual
    parts = [np.correlate(white[:, i], trace, "full")[len(shape) - 1 :] for i, trace in enumerate(shape.T)]
    return np.sum(parts, axis=0)[:, None]


def unpushed(log: Log, robot: Robot, kit: Kit) -> list[Log]:
    """The log without the times at which somebody pushed the robot, which a calibration does not know of: a knock made
    a body of 0.34 kg one of 0.48 ± 0.06. The whole log where little would be left."""
    return _calm(log, pushed(traces(log, robot, kit), log.period, KNOCK))


def _calm(log: Log, there: Mask) -> list[Log]:
    """The parts of the log that lie outside the rows `there` (n,), or the whole log where little would be left."""
    rows = np.flatnonzero(~there)
    several = np.split(rows, np.flatnonzero(np.diff(rows) > 1) + 1)
    long = [log.t[part[[0, -1]]] for part in several if len(part) * log.period > LEAST_CALM]
    calm = [one for one in (log.between(*ends) for ends in long) if all(np.ptp(one[n]) > 0 for n in RAW if n in one)]
    moved = [max((np.ptp(one[n]) for n in RAW[:2] if n in one), default=0.0) for one in calm]
    least = LEAST_MOVED * max(moved, default=0.0)
    calm = [one for one, far in zip(calm, moved, strict=True) if far >= least]
    return calm if sum(map(len, calm)) > len(log) / 2 else [log]


def without_knocks(logs: Sequence[Log], robot: Robot, kit: Kit, *, cut: bool) -> tuple[list[Log], list[Knocks]]:
    """The logs, where asked (`cut`) in parts without knocks, and the knocks in them."""
    parts = list[Log]()
    knocks = list[Knocks]()
    for log in logs:
        try:
            trace = traces(log, robot, kit)
        except UprightError:  # the filter cannot follow the log
            trace = np.zeros((len(log), 1))
        there = pushed(trace, log.period, KNOCK)
        starts, stops = (np.flatnonzero(np.diff(there.astype(int), prepend=0, append=0) == side) for side in (1, -1))
        calm = _calm(log, there) if len(starts) else [log]
        enough = calm != [log]
        own = calm if cut else [log]
        parts += own
        if len(starts):
            times = [float(log.t[a + np.argmax(np.abs(trace[a:b]))]) for a, b in zip(starts, stops, strict=True)]
            used = sum(map(len, own)) * log.period if cut and enough else None
            knocks.append(Knocks(tuple(times), len(log) * log.period, used, enough))
    return parts, knocks
