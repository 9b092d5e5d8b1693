"""The nominal robot's steady Kalman filter along a log, and how likely it makes the log."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np

from upright.arrays import Array, Mask
from upright.calibration.knocks import SETTLED, at_motors, first_state, moved_by, pushed, recorded
from upright.control.delay import MOST_PERIODS, RAW, SampledRobot, sampled
from upright.control.kalman import DISTURBED, Disturbed, Filter, filtered, kalman_filter
from upright.likelihood.assumptions import Assumptions, loaded
from upright.logs.recording import commanded
from upright.physics.dynamics import turn_ratio
from upright.physics.linear import LinearModel, linearise_rolling
from upright.physics.sensing import sensor_matrix
from upright.robots import Kit, Robot, Sensor
from upright.robots.kit import Motor
from upright.signals import Log

FREEDOM = 4.0  # of Student's distribution, under which a push costs little
SCALES = (0.15, 0.2, 0.28, 0.4, 0.55, 0.75, 1.0, 1.3, 1.7, 2.2, 3.0, 4.0, 5.5)
FINER = 4  # parts of a step of these, in which the likeliest is looked for at last
DISTURBANCES = (0.1, 0.18, 0.32, 0.56, 1.0, 1.8, 3.2)  # times the usual noise of forces and torques
ZOOMS = 2  # of the search for a dead zone or a drop: a hundredth of it more or less swallows other commands
AT_ONCE = 12  # signatures in memory
ROUNDING = 1e-9  # [s] of times


@dataclass(frozen=True, eq=False)
class FollowedLog:
    """The nominal filter along a log: its `states` (n, states), the readings `predicted` (n, sensors), the weights of
    its whitened innovations, these, `errors` (rows·sensors,), of the rows in `keep`, and `raw` innovations (n, sensors)
    of all."""

    estimator: Filter
    states: Array
    predicted: Array
    whiten: Array
    keep: Mask
    raw: Array
    errors: Array

    @classmethod
    def of(cls, estimator: Filter, readings: Array, motors: Array) -> FollowedLog:
        model = estimator.sampled
        linear = model.linear
        start = first_state(model, readings[0])
        states, errors = filtered(linear.A, linear.C, estimator.L, readings, moved_by(model, motors), start)
        whiten = 1 / np.sqrt(np.diag(estimator.innovation_covariance))
        keep: Mask = np.isfinite(errors).all(axis=1) & (np.arange(len(errors)) >= SETTLED / model.dt)
        keep &= ~pushed(errors, model.dt)
        whitened = (errors * whiten)[keep].ravel()
        return cls(estimator, states, np.nan_to_num(readings - errors), whiten, keep, errors, whitened)

    def answer(self, readings: Array, moved: Array) -> Array:
        """What more of `readings` (n, 3, k), and of what commands add, `moved` (n, states, k), adds to the whitened
        innovations (rows·sensors, k)."""
        return (self._answer(readings, moved) * self.whiten[:, None])[self.keep].reshape(-1, moved.shape[2])

    def _answer(self, readings: Array, moved: Array) -> Array:
        linear = self.estimator.sampled.linear
        k = moved.shape[2]
        return filtered(linear.A, linear.C, self.estimator.L, readings, moved, np.zeros((len(linear.A), k)))[1]

    def unknown(self, motors: Sequence[Array]) -> Array:
        """The signature (rows·sensors, k) of commands (n, 2) that reached the motors besides those that are known."""
        moved = np.stack([moved_by(self.estimator.sampled, more) for more in motors], axis=2)
        return -self.answer(np.zeros((len(moved), 3, moved.shape[2])), moved)

    def surprises(self, motors: Sequence[Array]) -> list[float]:
        """`surprise` of as many logs, whose motors made these (n, 2) besides what is known."""
        model = self.estimator.sampled
        result = list[float]()
        for first in range(0, len(motors), AT_ONCE):
            moved = np.stack([moved_by(model, more) for more in motors[first : first + AT_ONCE]], axis=2)
            errors = self.raw[:, :, None] + self._answer(np.zeros((len(moved), 3, moved.shape[2])), moved)
            result += [_surprise(self.estimator, errors[:, :, k]) for k in range(errors.shape[2])]
        return result


def filtered_log(log: Log, setup: Assumptions, kit: Kit | None = None) -> tuple[FollowedLog, Array, Array]:
    """The filter of the nominal robot with a `kit` (None: that of the setup) along the log, the commands that were
    sent and what the motors make of them (n, 2)."""
    robot = setup.actual_robot
    kit = kit or setup.actual_kit
    estimator = _estimator(robot, kit, log.period, setup.disturbed)
    readings, sent = recorded(log, estimator.sampled.delay)
    motors = at_motors(sent, kit, robot.command_unit, sent=commanded(log) == "command")
    return FollowedLog.of(estimator, readings, motors), sent, motors


def _estimator(robot: Robot, kit: Kit, period: float, disturbed: float) -> Filter:
    return _designed(robot, period, kit.delay, kit.jitter, tuple(kit.sensors.items()), disturbed)


class White(Disturbed):
    """Disturbances that are white between two samples too.

    Held over a period, as a regulator may think of them, they would be known for the rest of it by a reading from
    between two samples: delays of 0.8 of a period would be the likeliest, 2 ms off.
    """

    def noise(self, model: SampledRobot) -> Array:
        """W (n, n) as that of `Disturbed`, whose force and torques are other ones in each part of a period that a
        reading divides."""
        robot = model.robot
        names = list(model.linear.states)
        dt = model.dt
        C = sensor_matrix(model.reads, turn_ratio(robot), model.kit.sensors)
        waits = [model.kit.sensors[name].delay % dt if f"{name}@1" in names else 0.0 for name in model.reads]
        inside = [dt - wait if dt > wait + ROUNDING and wait > ROUNDING else 0.0 for wait in waits]
        linear = linearise_rolling(robot)
        edges = sorted({0.0, dt, *inside})
        columns = list[Array]()
        for start, end in pairwise(edges):
            held = linear.c2d(end - start)
            push = (held.E[:, 0] + robot.com_height * held.E[:, 1]) * self.push_size(robot)
            entering = np.column_stack([push, held.B * self.motor_size(robot)]) * math.sqrt(dt / (end - start))
            column = np.zeros((len(names), 3))
            column[:6] = _flown(linear, dt - end) @ entering
            for name, c, h in zip(model.reads, C, inside, strict=True):
                if h >= end > 0:
                    column[names.index(f"{name}@1")] = c @ _flown(linear, h - end) @ entering
            columns.append(column)
        walks = Disturbed(push=0.0, motor=0.0, push_walk=self.push_walk, bias_walk=self.bias_walk)
        whole = np.concatenate(columns, axis=1)
        return whole @ whole.T + walks.noise(replace(model, robot=robot.without_dry_friction()))


def _flown(linear: LinearModel, h: float) -> Array:
    """How the six states go on by themselves for h [s]."""
    return linear.c2d(h).A if h > ROUNDING else np.eye(6)


@lru_cache(maxsize=256)  # most numbers that a log is asked for are of motors and battery, which no filter knows
def _designed(
    robot: Robot, period: float, delay: float, jitter: float, sensors: tuple[tuple[str, Sensor], ...], disturbed: float
) -> Filter:
    kit = Kit(name="sensors", sensors=dict(sensors), delay=delay, jitter=jitter)
    noise = White(push=disturbed * DISTURBED.push, motor=disturbed * DISTURBED.motor)
    return kalman_filter(sampled(robot, kit, period, longest=MOST_PERIODS), noise)


def surprise(path: FollowedLog) -> float:
    """−2 log likelihood, but for a constant, of the innovations under Student's distribution, which bears pushes."""
    return _surprise(path.estimator, path.raw)


def _surprise(estimator: Filter, innovations: Array) -> float:
    model = estimator.sampled
    S = estimator.innovation_covariance
    there = np.isfinite(innovations).all(axis=1) & (np.arange(len(innovations)) >= SETTLED / model.dt)
    e = innovations[there]
    squared = np.einsum("ij,jk,ik->i", e, np.linalg.inv(S), e)
    return float((FREEDOM + e.shape[1]) * np.log1p(squared / FREEDOM).sum() + len(e) * np.linalg.slogdet(S)[1])


def gyro_scale(log: Log, setup: Assumptions) -> float:
    """The gyro's scale over the kit's with which the log is likeliest; a signature's would be drawn towards one by the
    noise of what the filter predicts."""
    kit = setup.actual_kit
    gyro = setup.actual_kit.sensors[RAW[2]]

    def scaled(scale: float) -> tuple[Robot, Kit]:
        return setup.actual_robot, replace(kit, sensors={**kit.sensors, RAW[2]: replace(gyro, gain=scale * gyro.gain)})

    return _likeliest(log, scaled, setup.disturbed)


def body_load(log: Log, setup: Assumptions) -> float:
    """The body's mass over the nominal one with which the log is likeliest; beside what the spreads explain, a
    signature's would be lost: a lighter body looks like a lower one."""
    return _likeliest(log, lambda factor: (loaded(setup.actual_robot, factor), setup.actual_kit), setup.disturbed)


def taken(path: FollowedLog, motors: Array, made: Callable[[float], Array], tried: Sequence[float]) -> float:
    """The dead zone or drop with which the log is likeliest, of those `tried` and between: `motors` (n, 2) are what the
    filter of `path` counts with, `made` what the motors make with another one."""
    best = 0.0
    near = list(tried)
    for _ in range(1 + ZOOMS):
        place = int(np.argmin(path.surprises([made(zone) - motors for zone in near])))
        best = near[place]
        ends = (near[max(place - 1, 0)], near[min(place + 1, len(near) - 1)])
        near = np.linspace(*ends, 2 * FINER + 1).tolist()
    return best


def _likeliest(log: Log, changed: Callable[[float], tuple[Robot, Kit]], disturbed: float) -> float:
    """Of `SCALES`, and between two of them, the one with which the log surprises least."""
    place = int(np.argmin(surprises(log, [changed(value) for value in SCALES], disturbed)))
    near = np.linspace(SCALES[max(place - 1, 0)], SCALES[min(place + 1, len(SCALES) - 1)], 2 * FINER + 1).tolist()
    return near[int(np.argmin(surprises(log, [changed(value) for value in near], disturbed)))]


def as_disturbed(log: Log, setup: Assumptions) -> tuple[Assumptions, float]:
    """`setup` with the disturbances that make the log likeliest, and its surprise. With larger ones the filter expects
    larger innovations than there are, and whatever makes them smaller looks likely: a gyro that counts too little."""
    several = [replace(setup, disturbed=factor) for factor in DISTURBANCES]
    then = [surprise(filtered_log(log, one)[0]) for one in several]
    best = int(np.argmin(then))
    return several[best], then[best]


def surprises(log: Log, several: Sequence[tuple[Robot, Kit]], disturbed: float) -> list[float]:
    """`surprise` of the filters of several robots with the same dead times, which follow the log side by side; forces
    and torques are `disturbed` by so many times the usual noise."""
    estimators = [_estimator(*one, log.period, disturbed) for one in several]
    readings, sent = recorded(log, estimators[0].sampled.delay)
    raw = commanded(log) == "command"
    motors = dict[Motor, Array]()
    moved = list[Array]()
    for (robot, kit), estimator in zip(several, estimators, strict=True):
        if kit.motor not in motors:
            motors[kit.motor] = at_motors(sent, kit, robot.command_unit, sent=raw)
        moved.append(moved_by(estimator.sampled, motors[kit.motor]))
    A, C = (np.stack([getattr(e.sampled.linear, name) for e in estimators]) for name in ("A", "C"))
    z = np.stack([first_state(e.sampled, readings[0]) for e in estimators])[:, :, None]
    L = np.stack([e.L for e in estimators])
    added = np.stack(moved, axis=1)[:, :, :, None]
    there = np.isfinite(readings)
    errors = np.empty((len(readings), *C.shape[:2]))
    for i, reading in enumerate(readings[:, None, :, None]):
        error = reading - C @ z
        errors[i] = error[:, :, 0]
        z = A @ (z + L @ np.where(there[i][:, None], error, 0.0)) + added[i]
    return [_surprise(estimator, errors[:, k]) for k, estimator in enumerate(estimators)]
