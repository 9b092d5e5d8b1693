"""A known robot's extended Kalman filter along a log: the calibration's predictor with nothing to estimate."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.calibrate.electronics import ASYMMETRY, BATTERY, electronics_of
from upright.calibrate.fitting import STICKING, Path, Problem, objective
from upright.calibrate.noise import learn_noise
from upright.calibrate.parameters import Parameter
from upright.calibrate.process_noise import NOISE_TIME, process
from upright.logs.recording import SENSOR, first_noise, reading_matrix, record
from upright.physics.dynamics import motor_gain, turn_ratio
from upright.robots import Kit, Robot
from upright.signals import Log

KNOWN_WELL = 0.03  # of the commands: process noise from which that of a log is learnt
MOST = 1e6  # of a variance, over the one from which it is learnt
NO_STICKING = {STICKING: -math.inf}  # the motors' noise holds it

Array = NDArray[np.float64]
Whole = NDArray[np.int64]


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
    robot = problem.robot
    dry = friction * robot.coulomb_friction / motor_gain(robot)
    noise = {**problem.noise, **process(problem.recordings, robot, disturbance), **NO_STICKING}
    noise["motor"] = math.log(math.exp(noise["motor"]) + dry**2 * NOISE_TIME)
    noise |= {name: 2 * math.log(size) for name, size in robot.noise.items() if name in noise}
    problem = replace(problem, noise=noise)
    return _in_order(problem, problem.filtered(problem.recordings[0], np.zeros(len(problem.parameters)), keep=True))


def commanded_by(problem: Problem, commands: Array) -> Problem:
    """The same log with other `commands` (rows, 2) at the motors."""
    return replace(problem, recordings=(replace(problem.recordings[0], commands=np.ascontiguousarray(commands)),))


def known(log: Log, robot: Robot, kit: Kit, delay: float) -> Problem:
    """A log of a known robot, with the noise that its kit has and none between readings."""
    delays = {name: sensor.delay for name, sensor in kit.sensors.items() if name in SENSOR}
    recording = record(log, robot, kit, skip=kit.delay + max(delays.values(), default=0.0) + 0.02, held_out=0.0)
    after_command = {
        s: delay + max((d for n, d in delays.items() if SENSOR[n] == s), default=0.0) for s in recording.sensors
    }
    noise = {s: math.log(variance) for s, variance in first_noise(recording).items()}
    return Problem(
        recordings=(recording,), robot=robot, parameters=_motors(robot, kit, log), delays=after_command, noise=noise
    )


def one_step_noise(log: Log, robot: Robot, kit: Kit, *, delay: float) -> dict[str, float]:
    """Standard deviations of the noise with which a filter of `robot` predicts each next reading of `log` as it is:
    of the sensors [rad, rad/s], motors [command √s] and pushes [N √s]. {} where it cannot follow.

    What the equations leave out is in it: the noise of a calibration is that of half seconds, or bounded.
    """
    problem = known(log, robot, kit, delay)
    first = process(problem.recordings, robot, KNOWN_WELL)
    bounds = {name: (value / 4, value * MOST) for name, value in ((s, math.exp(v)) for s, v in problem.noise.items())}
    bounds |= {name: (math.exp(first[name]) / MOST, math.exp(first[name]) * MOST) for name in ("motor", "push")}
    problem = replace(problem, noise={**problem.noise, **first, **NO_STICKING})
    z = np.zeros(len(problem.parameters))
    if not np.isfinite(objective(problem, z)[0]):
        return {}
    learnt = learn_noise(problem, z, bounds, iterations=8).noise
    return {name: math.exp(0.5 * learnt[name]) for name in bounds}


def _motors(robot: Robot, kit: Kit, log: Log) -> tuple[Parameter, ...]:
    """The strengths of two motors, where the kit has some of its own."""
    if kit.motor.left == kit.motor.right == 1:
        return ()
    return tuple(p for p in electronics_of(robot, kit, [log]) if p.name in (ASYMMETRY, BATTERY))


def _in_order(problem: Problem, path: Path) -> FilteredLog:
    recording, z = problem.recordings[0], np.zeros(len(problem.parameters))
    order = problem.order(recording, z)
    row, after = recording.kind[order], path.states[order]
    latest = np.maximum.accumulate(np.where(row < 0, np.arange(len(order)), 0))
    command = recording.commands[recording.value[order][latest].astype(int)]
    command[: int((row < 0).argmax())] = recording.commands[0]
    turn = np.array([turn_ratio(problem.robot)])
    lost = ~np.isfinite(after).all(axis=1) | ((row >= 0) & ~np.isfinite(path.e[order]))
    first = int((row >= 0).argmax())
    lost[first:] |= ~after[first:].any(axis=1)  # the filter stopped where the robot toppled
    keep = slice(0, int(lost.argmax()) if lost.any() else len(order))
    return FilteredLog(
        rows=recording.rows,
        t=(recording.when - problem.own_delays(recording, z))[order][keep],
        row=row[keep],
        sample=np.searchsorted(recording.when[recording.kind < 0], recording.when[order] - 1e-9)[keep],
        innovation=path.e[order][keep],
        variance=path.s[order][keep],
        gains=path.gains[order][keep],
        before=np.vstack([recording.first, after[:-1]])[keep],
        after=after[keep],
        command=np.vstack([command[:1], command[:-1]])[keep],  # the one held until the event
        reads=reading_matrix(recording.rows, len(recording.first), turn, recording.parts)[:, :, 0],
    )
