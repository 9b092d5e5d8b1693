"""The last seconds of a log through the predictor, and how each possible fault would have shown in its innovations.

The filter of `identify` follows the log with the robot as it should be. A fault enters the robot at one place, as a
command that does not arrive, a force, a shift of a reading, and what it does to the innovations is found by sending a
small one through the same filter, linearised along its path (Willsky and Jones 1976).
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import SimpleNamespace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.bodies.electronics import drive
from upright.calibrate.filter_log import filter_log
from upright.errors import InvalidLog
from upright.physics.dynamics import Disturbance, derivative
from upright.physics.integrate import rk4_step
from upright.physics.linear import linearise
from upright.robots import Kit, Robot
from upright.signals import Log

Array = NDArray[np.float64]
Whole = NDArray[np.int64]

FREEDOM = 0.03
"""Process noise, as a share of the commands and of 1 N for 0.6 kg: what a robot known from its sources needs."""

DRY = 0.1
"""The same as a share of the dry friction, which its sources know to a fifth and which no revolution of a wheel has
twice."""

INPUTS = ("left", "right", "force", "moment")
"""What can enter between two events: command errors of both motors, a force at the axle [N], a moment [N m]."""

_SMALL = 1e-4  # a step of a finite difference: error and rounding both near 1e-8 of it
_SHARE = 0.01  # of its spread, by which a parameter is moved to see what it does
_STIFF = 0.7  # largest |pole| h of a Runge–Kutta step


@dataclass(frozen=True, eq=False)
class Track:
    """The filter along a log. Events are in its order: `then` [s] in the command's time, `row` (−1: a command),
    innovation `e` and its variance `s` (NaN for commands), the filter's gain, and the state and command up to it.
    """

    robot: Robot
    kit: Kit
    log: Log
    asked: Array
    rows: tuple[str, ...]
    then: Array
    row: Whole
    sample: Whole
    e: Array
    s: Array
    gains: Array
    before: Array
    after: Array
    command: Array
    reads: Array

    @property
    def spans(self) -> Array:
        """Time [s] that ends with each event."""
        return np.diff(self.then, prepend=self.then[0])

    @property
    def size(self) -> int:
        """How many states the filter has."""
        return self.gains.shape[1]


def asked_of(log: Log) -> tuple[str, str]:
    """The channels of what the controller asked for: the commands, or what was applied where only that was logged."""
    for prefix in ("command", "applied"):
        if f"{prefix}/left" in log and f"{prefix}/right" in log:
            return f"{prefix}/left", f"{prefix}/right"
    raise InvalidLog("the log has no commands", expected="channels command/left and command/right")


def driven(asked: Array, kit: Kit, unit: str, share: float = 1.0, *, weak: bool = True) -> Array:
    """What the kit's driver makes of commands (n, 2) when the battery has `share` of its voltage; with `weak` every
    command shrinks with the battery, as where a driver gives a share of it."""
    full = kit.battery.voltage
    scale = share if weak else 1.0
    motor = replace(kit.motor, limit=share * kit.motor.limit)
    weaker = replace(kit, motor=motor, battery=replace(kit.battery, voltage=share * full))
    return np.array([drive((scale * left, scale * right), weaker, unit)[0] for left, right in asked.tolist()])


def track(log: Log, robot: Robot, kit: Kit, sent: Array | None = None) -> Track:
    """The nominal robot's filter along the whole of `log`, with the commands `sent` (samples, 2) at its motors (None:
    what the kit makes of those asked for); raises `InvalidLog` where it cannot follow."""
    names = asked_of(log)
    asked = np.column_stack([log[n] for n in names])
    if sent is None:
        sent = driven(asked, kit, robot.command_unit)
    others = {n: v for n, v in log.channels.items() if not n.startswith(("applied/", "truth/", "command/"))}
    channels = {n: _inside(v, kit, n) for n, v in others.items()} | dict(zip(names, sent.T, strict=True))
    result = filter_log(
        Log(log.t, channels), robot, kit, delay=_dead_time(names[0], kit), disturbance=FREEDOM, friction=DRY
    )
    return Track(
        robot, kit, log, asked, result.rows, result.t, result.row, result.sample, result.innovation, result.variance,
        result.gains, result.before, result.after, result.command, result.reads,
    )  # fmt: skip


def _dead_time(name: str, kit: Kit) -> float:
    """From a command in the channel `name` to the motor [s]; what was applied had waited its whole periods before."""
    waited = 0 if name.startswith("command/") else math.floor(kit.delay / kit.period + 1e-9)
    return kit.delay - waited * kit.period + kit.jitter / 2


def _inside(values: Array, kit: Kit, name: str) -> Array:
    """Readings at the end of a sensor's range say nothing more."""
    sensor = kit.sensors.get(name)
    if sensor is None or not math.isfinite(sensor.range):
        return values
    return np.where(np.abs(values) < 0.98 * sensor.range, values, np.nan)


def since(found: Track, start: float) -> Track:
    """The part of the track from `start` [s] on."""
    keep = found.then >= start
    names = ("then", "row", "sample", "e", "s", "gains", "before", "after", "command")
    return replace(found, **{name: getattr(found, name)[keep] for name in names})


@dataclass(frozen=True, eq=False)
class Tangent:
    """How the state after each span answers the state before it, `phi` (n, 6, 6), and what enters during the span,
    `gamma` (n, 6, 4), in the order of `INPUTS`."""

    phi: Array
    gamma: Array


_MOVED = (0, 1, 3, 5)  # the states on which the motion depends


def tangent(found: Track) -> Tangent:
    """The flow between events, linearised along the path by finite differences."""
    n, count = len(found.then), len(_MOVED)
    x = np.repeat(found.before[None, :, :6], 1 + count + len(INPUTS), axis=0)
    u = np.repeat(found.command[None], len(x), axis=0)
    w = np.zeros((len(x), n, 2))
    for i, state in enumerate(_MOVED):
        x[1 + i, :, state] += _SMALL
    for i in range(2):
        u[1 + count + i, :, i] += _SMALL
        w[3 + count + i, :, i] += _SMALL
    end = _flown(found.robot, found.robot, x, u, w, found.spans)
    slopes = (end[1:] - end[0]) / _SMALL
    phi = np.zeros((n, 6, 6))
    phi[:, 2, 2] = phi[:, 4, 4] = 1.0
    for i, state in enumerate(_MOVED):
        phi[:, :, state] = slopes[i]
    return Tangent(phi, np.moveaxis(slopes[count:], 0, 2))


def misfits(found: Track, spreads: Mapping[str, float]) -> Array:
    """What enters the state over each span (events, 6, parameters) where a parameter is larger by its spread."""
    x, u, w = found.before[None, :, :6], found.command[None], np.zeros((1, len(found.then), 2))
    usual = _flown(found.robot, found.robot, x, u, w, found.spans)[0]
    numbers = found.robot.numbers()
    moved = [SimpleNamespace(**(numbers | {name: numbers[name] + _SHARE * size})) for name, size in spreads.items()]
    others = [(_flown(found.robot, p, x, u, w, found.spans)[0] - usual) / _SHARE for p in moved]
    return np.stack(others, axis=2)


def _flown(robot: Robot, p: Any, x: Array, u: Array, w: Array, spans: Array) -> Array:
    """States (lanes, n, 6) of parameters `p` after `spans` [s] under commands u (lanes, n, 2), forces and moments w
    (lanes, n, 2), in steps that are short enough for `robot`."""
    fastest = float(np.abs(linearise(robot).poles()).max())
    steps = max(1, math.ceil(float(spans.max()) * fastest / _STIFF))
    moment = np.divide(w[..., 1], 1.0)
    push = Disturbance(w[..., 0] + 1e-12, moment / (w[..., 0] + 1e-12))
    left, right = u[..., 0], u[..., 1]
    state = tuple(x[..., i] for i in range(6))
    for _ in range(steps):
        state = rk4_step(lambda s: derivative(s, (left, right), p, push, np), state, spans / steps)  # type: ignore[arg-type]
    return np.stack(state, axis=-1)


def answer(found: Track, flow: Tangent, entered: Array, shifted: Array) -> Array:
    """What faults add to the innovations, over their standard deviations (events, faults).

    `entered` (events, 4, faults) is what enters during each span in the order of `INPUTS`, `shifted` (events, faults)
    what the fault adds to a reading. An innovation under the fault is the one found plus this.
    """
    return carried(found, flow, np.einsum("nij,njm->nim", flow.gamma, entered), shifted)


def carried(found: Track, flow: Tangent, pushed: Array, shifted: Array | None = None) -> Array:
    """The same for what a fault adds to the state over each span, `pushed` (events, 6, faults)."""
    n, size = len(found.then), found.size
    delta = np.zeros((size, pushed.shape[2]))
    said = np.zeros((n, pushed.shape[2]))
    for i in range(n):
        delta[:6] = flow.phi[i] @ delta[:6] + pushed[i]
        row = found.row[i]
        if row >= 0 and np.isfinite(found.s[i]):
            error = -(found.reads[row] @ delta)
            if shifted is not None:
                error = error - shifted[i]
            delta += np.outer(found.gains[i], error)
            said[i] = error / math.sqrt(found.s[i])
    return said
