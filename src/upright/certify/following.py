"""The nominal robot's steady Kalman filter along a log, and how likely it makes the log."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from upright.certify.agreement import SETTLED, at_motors, recorded
from upright.certify.checks import Course
from upright.control.delay import MOST_PERIODS, RAW, SampledRobot, sampled
from upright.control.kalman import Filter, filtered, kalman_filter
from upright.logs.recording import commanded
from upright.physics.dynamics import turn_ratio
from upright.robots import Kit
from upright.signals import Log

Array = NDArray[np.float64]

FAR = 5.0  # usual sizes of an innovation beyond which a push is taken for its cause
PUSHED = 0.3  # [s] after it that are left out, in which the filter finds the state again
MOST_PUSHED = 0.5  # of a log that may be left out; where more would be, it is no push
FREEDOM = 4.0  # of Student's distribution, under which a push costs little
SCALES = (0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.25, 1.4, 1.6, 1.8, 2.1, 2.5, 3.0, 4.0, 5.0)
FINER = 4  # parts of a step of these, in which the likeliest is looked for at last


@dataclass(frozen=True, eq=False)
class FollowedLog:
    """The nominal filter along a log: its `states` (n, states), the readings `predicted` (n, sensors), the weights of
    its whitened innovations, these, `errors` (rows·sensors,), of the rows in `keep`, and `raw` innovations (n, sensors)
    of all."""

    estimator: Filter
    states: Array
    predicted: Array
    whiten: Array
    keep: NDArray[np.bool_]
    raw: Array
    errors: Array

    @classmethod
    def of(cls, estimator: Filter, readings: Array, motors: Array) -> FollowedLog:
        model = estimator.sampled
        linear = model.linear
        first, turn = np.nan_to_num(readings[0]), turn_ratio(model.robot)
        start = np.zeros(len(linear.A))
        start[2], start[4] = (first[0] + first[1]) / 2, (first[1] - first[0]) / (2 * turn)
        for place, name in enumerate(linear.states):
            start[place] += first[RAW.index(name[:-2])] if "@" in name else 0.0
        states, errors = filtered(linear.A, linear.C, estimator.L, readings, moved_by(model, motors), start)
        whiten = 1 / np.sqrt(np.diag(linear.C @ estimator.P @ linear.C.T + model.noise))
        keep: NDArray[np.bool_] = np.isfinite(errors).all(axis=1) & (np.arange(len(errors)) >= SETTLED / model.dt)
        keep &= ~pushed(errors, model.dt)
        whitened = (errors * whiten)[keep].ravel()
        return cls(estimator, states, np.nan_to_num(readings - errors), whiten, keep, errors, whitened)

    def answer(self, readings: Array, moved: Array) -> Array:
        """What more of `readings` (n, 3, k), and of what commands add, `moved` (n, states, k), adds to the whitened
        innovations (rows·sensors, k)."""
        linear, k = self.estimator.sampled.linear, moved.shape[2]
        _, errors = filtered(linear.A, linear.C, self.estimator.L, readings, moved, np.zeros((len(linear.A), k)))
        return (errors * self.whiten[:, None])[self.keep].reshape(-1, k)

    def unknown(self, motors: Sequence[Array]) -> Array:
        """The signature (rows·sensors, k) of commands (n, 2) that reached the motors besides those that are known."""
        moved = np.stack([moved_by(self.estimator.sampled, more) for more in motors], axis=2)
        return -self.answer(np.zeros((len(moved), 3, moved.shape[2])), moved)


def pushed(errors: Array, period: float) -> NDArray[np.bool_]:
    """Rows (n,) at and after innovations (n, sensors) far beyond their usual size: somebody pushed the robot."""
    there = np.isfinite(errors).all(axis=1) & (np.arange(len(errors)) >= SETTLED / period)
    usual = 1.4826 * np.median(np.abs(errors[there]), axis=0) if there.any() else np.ones(errors.shape[1])
    far = (np.abs(np.nan_to_num(errors)) > FAR * usual).any(axis=1)
    after: NDArray[np.bool_] = np.convolve(far, np.ones(max(1, round(PUSHED / period))))[: len(errors)] > 0
    return after if after[there].mean() < MOST_PUSHED else np.zeros(len(errors), dtype=np.bool_)


def moved_by(model: SampledRobot, commands: Array) -> Array:
    """What commands (n, 2) add to the states in each period (n, states)."""
    before = np.concatenate([np.zeros((1, 2)), commands[:-1]])
    return before @ model.before.T + commands @ model.now.T


def filtered_log(log: Log, course: Course, kit: Kit | None = None) -> tuple[FollowedLog, Array, Array]:
    """The filter of the nominal robot with a `kit` (None: that of the course) along the log, the commands that were
    sent and what the motors make of them (n, 2)."""
    robot, kit = course.met_robot, kit or course.met_kit
    model = sampled(robot, kit, log.period, longest=MOST_PERIODS)
    readings, sent = recorded(log, model.delay)
    motors = at_motors(sent, kit, robot.command_unit, sent=commanded(log) == "command")
    return FollowedLog.of(kalman_filter(model), readings, motors), sent, motors


def surprise(path: FollowedLog) -> float:
    """−2 log likelihood, but for a constant, of the innovations under Student's distribution, which bears pushes."""
    model = path.estimator.sampled
    S = model.linear.C @ path.estimator.P @ model.linear.C.T + model.noise
    there = np.isfinite(path.raw).all(axis=1) & (np.arange(len(path.raw)) >= SETTLED / model.dt)
    e = path.raw[there]
    squared = np.einsum("ij,jk,ik->i", e, np.linalg.inv(S), e)
    return float((FREEDOM + e.shape[1]) * np.log1p(squared / FREEDOM).sum() + len(e) * np.linalg.slogdet(S)[1])


def gyro_scale(log: Log, course: Course) -> float:
    """The gyro's scale over the kit's with which the log is likeliest; a signature's would be drawn towards one by the
    noise of what the filter foretells."""
    kit, gyro = course.met_kit, course.met_kit.sensors[RAW[2]]

    def cost(scale: float) -> float:
        sensors = {**kit.sensors, RAW[2]: replace(gyro, gain=scale * gyro.gain)}
        return surprise(filtered_log(log, course, replace(kit, sensors=sensors))[0])

    costs = [cost(scale) for scale in SCALES]
    best = int(np.argmin(costs))
    ends = SCALES[max(best - 1, 0)], SCALES[min(best + 1, len(SCALES) - 1)]
    near = np.linspace(*ends, 2 * FINER + 1).tolist()
    return near[int(np.argmin([cost(scale) for scale in near]))]
