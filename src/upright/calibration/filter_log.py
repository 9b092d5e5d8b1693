"""A known robot's extended Kalman filter along a log: the calibration's predictor with nothing to estimate."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from upright.arrays import Array, Whole
from upright.calibration.electronics import ASYMMETRY, BATTERY, DROP, MISALIGNED, electronics_of
from upright.calibration.fitting import STICKING, Problem, objective
from upright.calibration.noise import learn_noise
from upright.calibration.parameters import Parameter
from upright.calibration.process_noise import NOISE_TIME, process
from upright.logs.recording import SENSOR, Recording, first_noise, record
from upright.physics.dynamics import motor_gain
from upright.robots import Kit, Robot
from upright.signals import Log

if TYPE_CHECKING:
    from upright.calibration.predictor import Followed, Noise, RobotLanes

KNOWN_WELL = 0.03  # of the commands: process noise from which that of a log is learnt
MOST = 1e6  # of a variance, over the one from which it is learnt
NEVER_STIFF = (math.inf, 0.0, 0.0)  # [s], and of the left and the right motor [command unit]
NO_STICKING = {STICKING: -math.inf}  # the motors' noise holds it


@dataclass(frozen=True, eq=False, kw_only=True)
class FilteredLog:
    """The filter along the n events of a log, in the order of the command's time, up to where it lost the robot.

    An event is a command (`row` −1) or a reading of the sensor `rows[row]`. The filter's s states are the robot's six
    and the offsets of gyro and compass.
    """

    rows: tuple[str, ...]
    t: Array  # (n,) [s] in the command's time: a reading's time less its sensor's delay
    row: Whole  # (n,)
    sample: Whole  # (n,) row of the log
    innovation: Array  # (n,) NaN for commands
    variance: Array  # (n,) of the innovation, NaN for commands
    gains: Array  # (n, s) Kalman gain, zero for commands
    before: Array  # (n, s) state after the event before this one
    after: Array  # (n, s) state after the event
    command: Array  # (n, 2) what the motors held up to the event [command unit]
    reads: Array  # (rows, s) how each sensor reads the state


def filter_log(
    log: Log, robot: Robot, kit: Kit, *, delay: float, disturbance: float, friction: float = 0.0
) -> FilteredLog:
    """The filter of `robot` along the whole of `log`, with the sensors' delays and noise of `kit`.

    `delay` [s] is from a logged command to the motor. Process noise is `disturbance`, as a fraction of the commands
    (rms) and of 1 N on a robot of 0.6 kg, and `friction`, as a fraction of the dry friction; where the robot has noise
    of its own, from a calibration, that is the filter's. Raises `InvalidLog` for a log without commands, without two
    sensors that move, or with too few samples.
    """
    return filtered(known(log, robot, kit, delay), disturbance=disturbance, friction=friction)


def filtered(problem: Problem, *, disturbance: float, friction: float) -> FilteredLog:
    """The same of a log that is `known` already."""
    return Follower(problem, disturbance, friction).along()


@dataclass(frozen=True, eq=False)
class _Order:
    """The events of a recording in an order: which (n,), their times [s], rows, samples, and the command that each
    holds."""

    events: Whole
    t: Array
    row: Whole
    sample: Whole
    command: Whole


@dataclass(frozen=True, eq=False)
class Follower:
    """The filter of a known robot along the one recording of a `problem`, any number of times: what does not depend on
    commands and readings is made once. `disturbance` and `friction` are those of `filter_log`."""

    problem: Problem
    disturbance: float
    friction: float

    @property
    def recording(self) -> Recording:
        """The recording that is followed."""
        return self.problem.recordings[0]

    @cached_property
    def samples(self) -> Whole:
        """The row of the log (events,) of each event in the recording's order."""
        when = self.recording.when
        return np.searchsorted(when[self.recording.kind < 0], when - 1e-9)

    @cached_property
    def _delays(self) -> Array:
        return self.problem.own_delays(self.recording, self._none)

    @cached_property
    def _none(self) -> Array:
        return np.zeros(len(self.problem.parameters))

    @cached_property
    def _robot(self) -> tuple[RobotLanes, Array]:
        """What the predictor takes of the robot, and how each sensor reads the state."""
        from upright.calibration.predictor import WIDE

        lanes = self.problem.lanes(self.recording, np.repeat(self._none[:, None], WIDE, axis=1))
        return lanes, lanes.reads[:, :, 0]

    @cached_property
    def _usual(self) -> _Order:
        return self._ordered(self.recording.when)

    def _ordered(self, when: Array) -> _Order:
        kind = self.recording.kind
        then = when - self._delays
        events = np.lexsort((kind, then)).astype(np.int64)
        row = kind[events]
        latest = np.maximum.accumulate(np.where(row < 0, np.arange(len(events)), 0))
        command = self.recording.value[events][latest].astype(np.int64)
        command[: int((row < 0).argmax())] = 0
        return _Order(events, then[events], row, self.samples[events], np.concatenate([command[:1], command[:-1]]))

    @cached_property
    def _noise(self) -> Noise:
        """That of the sensors and the process; of the commands as the recording has them, whichever are sent."""
        from upright.calibration.predictor import Noise

        problem = self.problem
        robot = self.problem.robot
        dry = self.friction * robot.coulomb_friction / motor_gain(robot)
        noise = {**problem.noise, **process(problem.recordings, robot, self.disturbance)}
        noise["motor"] = math.log(math.exp(noise["motor"]) + dry**2 * NOISE_TIME)
        noise |= NO_STICKING | {name: 2 * math.log(size) for name, size in robot.noise.items() if name in noise}
        readings = np.exp([noise[SENSOR[row]] for row in self.recording.rows])
        whole = problem.with_noise(noise).process(self.recording)
        return Noise(self.recording.P0, whole, 0.0, readings, problem.restart)

    @cached_property
    def _path(self) -> Followed:
        """What the filter leaves of the recording as it is."""
        from upright.calibration.predictor import Events, Followed, kalman_along

        recording = self.recording
        n = len(self.recording.kind)
        size = len(self.recording.first)
        path = Followed(
            np.full(n, np.nan), np.full(n, np.nan), np.zeros((n, size)), np.zeros((n, size)), np.zeros((n, size, size))
        )
        events = Events(self._usual.events, recording.kind, recording.when, recording.value, recording.commands)
        kalman_along(events, self._robot[0], recording.first, self._noise, self.problem.longest, path)
        return path

    def along(
        self,
        commands: Array | None = None,
        values: Array | None = None,
        when: Array | None = None,
        stiff: tuple[float, float, float] = NEVER_STIFF,
    ) -> FilteredLog:
        """The filter along the recording, or one with these `commands` (rows, 2), `values` (events,) of its readings,
        NaN of those that say nothing, and times `when` (events,) [s] of its events, of a robot that from a time [s] on
        is `stiff` by so much more dry friction in its left and its right motor [command unit]."""
        recording, (_, reads) = self.recording, self._robot
        commands = recording.commands if commands is None else np.ascontiguousarray(commands)
        order = self._usual if when is None else self._ordered(when)
        values = recording.value if values is None else values
        path = self._again(order, commands, values, recording.when if when is None else when, stiff)
        e, after = path.e[order.events], path.states[order.events]
        end = _lost(order.row, e, after)
        return FilteredLog(
            rows=recording.rows, t=order.t[:end], row=order.row[:end], sample=order.sample[:end], innovation=e[:end],
            variance=path.s[order.events][:end], gains=path.gains[order.events][:end],
            before=np.vstack([recording.first, after[:-1]])[:end], after=after[:end],
            command=commands[order.command][:end],  # the one held until the event
            reads=reads,
        )  # fmt: skip

    def _again(
        self, order: _Order, commands: Array, values: Array, when: Array, stiff: tuple[float, float, float]
    ) -> Followed:
        """What the filter leaves of events of other commands, readings and times: it begins where these first differ
        from the recording's."""
        from upright.calibration.predictor import Events, Followed, kalman_along

        recording, before, usual = self.recording, self._path, self._usual
        events, row = usual.events, usual.row
        other = (commands != recording.commands).any(axis=1)[np.where(row < 0, recording.value[events].astype(int), 0)]
        differs = (order.events != events) | ((row < 0) & other)
        differs |= (values != recording.value)[events] | (when != recording.when)[events]
        differs |= when[events] >= stiff[0]
        first = int(differs.argmax()) if differs.any() else len(events)
        if first == len(events):
            return before
        held = np.flatnonzero((row[:first] < 0) & before.states[events[:first]].any(axis=1))
        e, s, gains, states = (one.copy() for one in before[:4])
        path = Followed(e, s, gains, states, before.covariances[:0])
        start = 0
        state = recording.first
        noise = self._noise
        if len(held):  # a command, which changes neither the state nor what is known of it
            start = int(held[-1])
            state = states[events[start]].copy()
            noise = noise._replace(start=before.covariances[events[start]])
        for one, nothing in ((e, np.nan), (s, np.nan), (gains, 0.0), (states, 0.0)):
            one[events[start:]] = nothing
        several = Events(order.events[start:], recording.kind, when, values, commands)
        lanes = self._robot[0]._replace(stiff=np.array(stiff))
        kalman_along(several, lanes, state, noise, self.problem.longest, path)
        return path


def known(log: Log, robot: Robot, kit: Kit, delay: float) -> Problem:
    """A log of a known robot, with the noise that its kit has and none between readings."""
    delays = {name: sensor.delay for name, sensor in kit.sensors.items() if name in SENSOR}
    recording = record(log, robot, kit, skip=kit.delay + max(delays.values(), default=0.0) + 0.02, held_out=0.0)
    after_command = {
        s: delay + max((d for n, d in delays.items() if SENSOR[n] == s), default=0.0) for s in recording.sensors
    }
    noise = {s: math.log(variance) for s, variance in first_noise(recording).items()}
    return Problem(
        recordings=(recording,), robot=robot, parameters=_of_kit(robot, kit, log), delays=after_command, noise=noise
    )


def one_step_noise(log: Log, robot: Robot, kit: Kit, *, delay: float) -> dict[str, float]:
    """Standard deviations of the noise with which a filter of `robot` predicts each next reading of `log` as it is:
    of the sensors [rad, rad/s], motors [command √s] and pushes [N √s]. {} where it cannot follow.

    What the equations leave out is in it: the noise of a calibration is that of half seconds, or bounded.
    """
    drop = [p for p in electronics_of(robot, kit, [log]) if p.name == DROP]
    problem = known(log, robot, kit, delay)
    problem = replace(problem, parameters=(*problem.parameters, *drop))  # the kit's, as the log has what was commanded
    first = process(problem.recordings, robot, KNOWN_WELL)
    bounds = {name: (value / 4, value * MOST) for name, value in ((s, math.exp(v)) for s, v in problem.noise.items())}
    bounds |= {name: (math.exp(first[name]) / MOST, math.exp(first[name]) * MOST) for name in ("motor", "push")}
    problem = problem.with_noise({**first, **NO_STICKING})
    z = np.zeros(len(problem.parameters))
    if not np.isfinite(objective(problem, z)[0]):
        return {}
    learnt = learn_noise(problem, z, bounds, iterations=8).noise
    return {name: math.exp(0.5 * learnt[name]) for name in bounds}


def _of_kit(robot: Robot, kit: Kit, log: Log) -> tuple[Parameter, ...]:
    """The strengths of two motors, where the kit has some of its own, and the tilt of its gyro."""
    names = {MISALIGNED} if kit.motor.left == kit.motor.right == 1 else {MISALIGNED, ASYMMETRY, BATTERY}
    return tuple(p for p in electronics_of(robot, kit, [log]) if p.name in names)


def _lost(row: Whole, e: Array, after: Array) -> int:
    """The event at which the filter lost the robot, or how many there are."""
    lost = ~np.isfinite(after).all(axis=1) | ((row >= 0) & ~np.isfinite(e))
    first = int((row >= 0).argmax())
    lost[first:] |= ~after[first:].any(axis=1)  # the filter stopped where the robot toppled
    return int(lost.argmax()) if lost.any() else len(row)
