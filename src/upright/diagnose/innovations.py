"""The last seconds of a log through the predictor, and how each possible fault would have shown in its innovations.

The filter of `calibrate` follows the log with the robot without faults. A fault enters the robot at one place: a
command that does not arrive, a force, a shift of a reading. What it does to the innovations follows from a small one
sent through the same filter, linearised along its path (Willsky and Jones 1976).
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from types import SimpleNamespace
from typing import Any

import numpy as np

from upright.arrays import Array, Mask
from upright.calibration.filter_log import NEVER_STIFF, FilteredLog, Follower, known
from upright.calibration.knocks import Arrays
from upright.compiled.generated import constants
from upright.errors import InvalidLog
from upright.logs.recording import FEWEST, Recording
from upright.physics import electronics
from upright.physics.integrate import PREDICTED
from upright.physics.steps import steps_of
from upright.robots import PARAMETERS, Kit, Robot
from upright.signals import Log

PROCESS_NOISE = 0.03
"""Standard deviation of the process noise over the rms command, and over 1 N for a robot of 0.6 kg: what a robot known
from its sources needs."""

DRY_FRICTION_NOISE = 0.1
"""The same over the dry friction, which the sources know to a fifth and which varies along a wheel's turn."""

FULL_RANGE = 0.98  # of a sensor's range: a reading beyond it is clipped and says nothing of the motion

INPUTS = ("left", "right", "force", "moment")
"""What can enter between two events: command errors of both motors, a force at the axle [N], a moment [N m]."""

OFFSET = 6  # the place of the gyro's offset in the filter's state
USUAL_OFFSET, TURNED = 0.35, 1.0
"""[rad/s] of a gyro, 20 degrees per second as the MPU-6050's data sheet has its zero-rate output, and [rad] that a body
turns in a log in which it falls."""

AT_ONCE, FIRST_ROWS = 0.1, 10  # [s] from the first row, and how many rows that far apart are tried as the first
IN_TIME = (math.inf, 0.0, 0.0)
"""No commands and no readings that are late."""

_STEP = 1e-4  # [SI] of a finite difference: truncation and rounding both near 1e-8 of it
_SPREAD_STEP = 0.01  # of its spread, by which a parameter is moved for a finite difference


@dataclass(frozen=True, eq=False, kw_only=True)
class FilterRun(FilteredLog):
    """The filter of a `robot` in its `kit` along a log, whose controller `asked` for commands (samples, 2), by the
    `follower` that gave it, which read the sensors in the rows of the times `kept` [s] alone (None: in all). The log
    has each event at the time of its `clock` [s], which differs from its own where
    readings came late. From a time on [s] the left and the right motor are `stiff` by more dry friction [command
    unit]."""

    robot: Robot
    kit: Kit
    log: Log
    asked: Array
    follower: Follower
    clock: Array
    kept: Array | None
    stiff: tuple[float, float, float] = NEVER_STIFF

    def driven(self, charge: float | Array = 1.0, *, pwm: bool = True) -> Array:
        """What the kit's driver makes of the commands (samples, 2) with the fraction `charge` of the battery."""
        return driven(self.asked, self.kit, self.robot.command_unit, charge, pwm=pwm)

    @property
    def spans(self) -> Array:
        """Time [s] that ends with each event."""
        return np.diff(self.t, prepend=self.t[0])

    @property
    def dry(self) -> Array:
        """The dry friction beyond the robot's over each span (events, 2) [command unit]."""
        since, *sides = self.stiff
        return np.where((self.t > since)[:, None], sides, 0.0)

    @property
    def readings(self) -> Mask:
        """Which events are readings that the filter used."""
        return (self.row >= 0) & np.isfinite(self.variance)

    @property
    def whitened(self) -> Array:
        """Innovations of the readings over their standard deviations."""
        return self.innovation[self.readings] / np.sqrt(self.variance[self.readings])

    def between(self, start: float, end: float) -> FilterRun:
        """The events that the log has from `start` to `end` [s]."""
        return self.only((self.clock >= start) & (self.clock <= end))

    def reaches(self, end: float) -> bool:
        """Whether the filter has not lost the robot before `end` [s]."""
        return float(self.clock[-1]) >= end

    def only(self, keep: Mask | slice) -> FilterRun:
        """Some of the events."""
        names = ("t", "row", "sample", "innovation", "variance", "gains", "before", "after", "command", "clock")
        return replace(self, **{name: getattr(self, name)[keep] for name in names})

    def corrected(self, i: int, error: Array) -> Array | float:
        """What errors (states, faults) of the state add to the whitened innovation of event i; `error` is corrected in
        place, as the filter does."""
        if self.row[i] < 0 or not np.isfinite(self.variance[i]):
            return 0.0
        innovation = -(self.reads[self.row[i]] @ error)
        error += self.gains[i][:, None] * innovation
        return innovation / math.sqrt(self.variance[i])

    def again(
        self,
        commands: Array | None,
        log: Log | None = None,
        delayed: tuple[float, float, float] = IN_TIME,
        stiff: tuple[float, float, float] = NEVER_STIFF,
    ) -> FilterRun:
        """The run of the same log with these commands (samples, 2) at the motors (None: those of the log), or of a
        `log` with other readings in the same rows; from a time on [s], all commands, and all readings, are `delayed` by
        more time [s] than the kit has it, and the left and the right motor `stiff` by more dry friction
        [command unit]."""
        own = self.follower.recording
        if commands is not None and len(own.commands) > len(commands):
            more = len(own.commands) - len(commands)
            commands = np.vstack([commands, np.repeat(commands[-1:], more, axis=0)])
        values = own.value if log is None else _read(self.follower, log, self.kit)
        return _run(
            self.follower,
            self.kit,
            log or self.log,
            self.asked,
            commands,
            values=values,
            delayed=delayed,
            stiff=stiff,
            kept=self.kept,
        )

    @cached_property
    def tangent(self) -> Tangent:
        """The flow between events, linearised along the path."""
        return tangent(self)


def asked_of(log: Log) -> tuple[str, str]:
    """The channels of what the controller asked for: the commands, or what was applied where only that was logged."""
    for prefix in ("command", "applied"):
        if f"{prefix}/left" in log and f"{prefix}/right" in log:
            return f"{prefix}/left", f"{prefix}/right"
    raise InvalidLog("the log has no commands", expected="channels command/left and command/right")


def driven(asked: Array, kit: Kit, unit: str, charge: float | Array = 1.0, *, pwm: bool = True) -> Array:
    """What the kit's driver makes of commands (n, 2) with the fraction `charge` (n,) of the battery's voltage; with
    `pwm` a command is a duty, so that it shrinks with the battery, else only the limit does."""
    scale = charge if pwm else 1.0
    motor = SimpleNamespace(**vars(kit.motor) | {"limit": charge * kit.motor.limit})
    battery = SimpleNamespace(**vars(kit.battery) | {"voltage": charge * kit.battery.voltage})
    return np.stack(electronics.driven([scale * u for u in asked.T], motor, battery, Arrays, volts=unit == "V"), axis=1)


def follow(log: Log, robot: Robot, kit: Kit, kept: Array | None = None) -> FilterRun:
    """The nominal robot's filter along the whole of `log`, with what the kit makes of its commands, and the readings of
    all rows or of those at the times `kept` [s]; raises `InvalidLog` where it cannot follow."""
    names = asked_of(log)
    asked = np.column_stack([log[n] for n in names])
    others = {n: v for n, v in log.channels.items() if not n.startswith(("applied/", "truth/", "command/"))}
    sent = dict(zip(names, driven(asked, kit, robot.command_unit).T, strict=True))
    use = True if kept is None else np.isin(log.t, kept)
    channels = {n: np.where(use, _inside(v, kit, n), np.nan) for n, v in others.items()} | sent
    long = _long_enough(Log(log.t, channels, {n: log.unit(n) for n in channels}), names)
    problem = known(long, robot, kit, _dead_time(names[0], kit))
    begun = _begun(problem.recordings[0], float(log.t[-1] - log.t[0]))
    follower = Follower(replace(problem, recordings=(begun,)), PROCESS_NOISE, DRY_FRICTION_NOISE)
    return _run(follower, kit, log, asked, kept=kept)


def _begun(recording: Recording, seconds: float) -> Recording:
    """The recording with a gyro's offset that its fall did not make: the mean of a log's readings is the offset and,
    over its `seconds`, what the body turned. Its first rate is what the gyro reads less that offset."""
    turned = (TURNED / seconds) ** 2
    part = USUAL_OFFSET**2 / (USUAL_OFFSET**2 + turned)
    first, P0 = recording.first.copy(), recording.P0.copy()
    first[1] += (1 - part) * first[OFFSET]
    first[OFFSET] *= part
    P0[np.ix_([1, OFFSET], [1, OFFSET])] += part * turned * np.array([[1, -1], [-1, 1]])
    return replace(recording, first=first, P0=P0)


def followed_on(log: Log, robot: Robot, kit: Kit) -> FilterRun:
    """`follow`, from later on where the filter loses at once a robot that does not fall: how fast it moves in its first
    row is not known."""
    run = follow(log, robot, kit)
    for _ in range(FIRST_ROWS):
        rest = log.between(log.t[0] + AT_ONCE, math.inf)
        if run.t[-1] >= rest.t[0] or len(rest) < FEWEST:
            break
        log = rest
        run = follow(rest, robot, kit)
    return run


def _read(follower: Follower, log: Log, kit: Kit) -> Array:
    """The values of all events (events,) where the readings are those of another log, NaN where that has none; a
    compass stays as it is."""
    recording = follower.recording
    values = recording.value.copy()
    for row, name in enumerate(recording.rows):
        if name != "sensor/compass":
            mine = recording.kind == row
            values[mine] = _inside(log[name], kit, name)[follower.samples[mine]]
    return values


def _run(
    follower: Follower, kit: Kit, log: Log, asked: Array, commands: Array | None = None, *,
    values: Array | None = None, delayed: tuple[float, float, float] = IN_TIME,
    stiff: tuple[float, float, float] = NEVER_STIFF, kept: Array | None = None,
) -> FilterRun:  # fmt: skip
    recording, (since, commanded, readings), when = follower.recording, delayed, None
    if commanded or readings:
        shift = np.where(recording.kind < 0, commanded, -readings)
        when = recording.when + np.where(recording.when >= since - 1e-9, shift, 0.0)
    path = follower.along(commands, values, when, stiff)
    # a command stands in the log with the readings of its time
    on = recording.when[recording.kind < 0][path.sample] >= since - 1e-9
    run = FilterRun(
        **vars(path),
        robot=follower.problem.robot,
        kit=kit,
        log=log,
        asked=asked,
        follower=follower,
        clock=path.t + readings * on,
        kept=kept,
        stiff=stiff,
    )
    return run.only(run.sample < len(log)) if len(log) < FEWEST else run


def _long_enough(log: Log, commands: Sequence[str]) -> Log:
    """The log with rows after its end that hold the last commands and no reading, where it is too short to filter."""
    more = FEWEST - len(log)
    if more <= 0:
        return log
    t = np.concatenate([log.t, log.t[-1] + log.period * np.arange(1, more + 1)])
    last = {n: v[-1] if n in commands else math.nan for n, v in log.channels.items()}
    return Log(t, {n: np.concatenate([v, np.full(more, last[n])]) for n, v in log.channels.items()}, log.units)


def _dead_time(name: str, kit: Kit) -> float:
    """From a command in the channel `name` to the motor [s]; what was applied had waited its whole periods before."""
    waited = 0 if name.startswith("command/") else math.floor(kit.delay / kit.period + 1e-9)
    return kit.delay - waited * kit.period + kit.jitter / 2


def _inside(values: Array, kit: Kit, name: str) -> Array:
    """Readings at the end of a sensor's range say nothing more."""
    sensor = kit.sensors.get(name)
    if sensor is None or not math.isfinite(sensor.range):
        return values
    return np.where(np.abs(values) < FULL_RANGE * sensor.range, values, np.nan)


@dataclass(frozen=True, eq=False, kw_only=True)
class Signature:
    """What one fault adds to the whitened innovations, `values` (readings,), `free` in amplitude or of fixed `size`."""

    fault: str
    onset: float
    values: Array
    way: str = ""
    size: float = 0.0
    free: bool = True
    stop: float = math.inf


@dataclass(frozen=True, eq=False)
class Tangent:
    """How the state after each span answers the state before it, `phi` (n, 6, 6), and what enters during the span,
    `gamma` (n, 6, 4), in the order of `INPUTS`."""

    phi: Array
    gamma: Array


_MOVED = (0, 1, 3, 5)  # the states on which the motion depends


def tangent(run: FilterRun) -> Tangent:
    """The flow between events, linearised along the path by finite differences."""
    n = len(run.t)
    count = len(_MOVED)
    x = np.repeat(run.before[None, :, :6], 1 + count + len(INPUTS), axis=0)
    u = np.repeat(run.command[None], len(x), axis=0)
    w = np.zeros((len(x), n, 2))
    for i, state in enumerate(_MOVED):
        x[1 + i, :, state] += _STEP
    for i in range(2):
        u[1 + count + i, :, i] += _STEP
        w[3 + count + i, :, i] += _STEP
    end = _flown(run, run.robot, x, u, w)
    slopes = (end[1:] - end[0]) / _STEP
    phi = np.zeros((n, 6, 6))
    phi[:, 2, 2] = phi[:, 4, 4] = 1.0
    for i, state in enumerate(_MOVED):
        phi[:, :, state] = slopes[i]
    return Tangent(phi, np.ascontiguousarray(np.moveaxis(slopes[count:], 0, 2)))


def misfits(run: FilterRun, spreads: Mapping[str, float]) -> Array:
    """What enters the state over each span (events, 6, parameters) where a parameter is larger by its spread."""
    return entering(run, [{name: _SPREAD_STEP * size} for name, size in spreads.items()]) / _SPREAD_STEP


def entering(run: FilterRun, changes: Sequence[Mapping[str, float]]) -> Array:
    """What enters the state over each span (events, 6, changes) where parameters are larger by these amounts."""
    x = run.before[None, :, :6]
    u = run.command[None]
    w = np.zeros((1, len(run.t), 2))
    usual = _flown(run, run.robot, x, u, w)[0]
    numbers: dict[str, Any] = run.robot.numbers()
    for name in {name for change in changes for name in change}:  # all changes at once
        numbers[name] = np.array([[numbers[name] + change.get(name, 0.0)] for change in changes])
    x, u, w = (np.broadcast_to(one, (len(changes), *one.shape[1:])) for one in (x, u, w))
    return np.moveaxis(_flown(run, SimpleNamespace(**numbers), x, u, w) - usual, 0, 2)


def _flown(run: FilterRun, p: Any, x: Array, u: Array, w: Array) -> Array:
    """States (lanes, n, 6) of parameters `p` after the spans of a run under commands u (lanes, n, 2), forces and
    moments w (lanes, n, 2), in steps that are short enough for its robot."""
    from upright.diagnose.propagation import fly

    robot, spans = run.robot, run.spans
    steps = steps_of(robot, float(spans.max()), PREDICTED)
    lanes = np.ones(len(x))
    coefficients = [np.ravel(one) * lanes for one in constants([getattr(p, name) for name in PARAMETERS], 1.0)]
    arrays = (np.array(coefficients), x, u, w, spans)
    dry = np.ascontiguousarray(run.dry, dtype=np.float64)
    return fly(*(np.ascontiguousarray(array, dtype=np.float64) for array in arrays), steps, dry)


def answer(run: FilterRun, entered: Array, shifted: Array | None = None) -> Array:
    """What faults add to the innovations, over their standard deviations (events, faults).

    `entered` (events, 4, faults) is what enters during each span in the order of `INPUTS`, `shifted` (events, faults)
    what the fault adds to a reading. An innovation under the fault is the one of the run plus this.
    """
    return propagated(run, run.tangent.gamma @ entered, shifted)


def propagated(run: FilterRun, pushed: Array | None, shifted: Array | None = None) -> Array:
    """The same for what a fault adds to the state over each span, `pushed` (events, 6, faults)."""
    from upright.diagnose.propagation import propagate

    given = shifted if pushed is None else pushed
    assert given is not None, "a fault enters the state, readings, or both"
    into = np.zeros((1, 6, given.shape[-1])) if pushed is None else pushed
    onto = np.zeros((1, given.shape[-1])) if shifted is None else shifted
    deviation = np.where(run.readings, np.sqrt(run.variance), np.nan)
    arrays = (run.tangent.phi, into, onto, run.reads[run.row], run.gains, deviation)
    return propagate(*(np.ascontiguousarray(array, dtype=np.float64) for array in arrays))
