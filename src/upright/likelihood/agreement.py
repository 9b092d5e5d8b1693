"""Whether a log agrees with the assumptions of a certificate: its innovations against those of the drawn robots.

The steady Kalman filter of the nominal robot predicts each reading of the log from the applied commands. Its noise is
that of the kit. The same filter predicts drawn robots in the nonlinear model with the kit's faults, under the
controller and the standard pushes. The log agrees where its innovations are not larger than theirs. Sizes are medians,
so a single push or lost sample, which the model does not have, has no effect.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from upright.arrays import Array
from upright.calibration.knocks import SETTLED, at_motors, first_state, recorded
from upright.control.delay import RAW, sampled
from upright.control.kalman import Filter, filtered, kalman_filter
from upright.likelihood.assumptions import Assumptions
from upright.logs.recording import commanded
from upright.signals import Log


class DrawnRuns(NamedTuple):
    """Readings (robots, n, 3) of encoders and gyro, and what both motors make of the commands (robots, n, 2)."""

    readings: Array
    motors: Array


@dataclass(frozen=True)
class Agreement:
    """One sensor: `measured`, the size of the log's innovations, and `expected`, the largest of the drawn robots.

    Both are multiples of the standard deviation that the filter predicts [1].
    """

    sensor: str
    measured: float
    expected: float

    @property
    def ratio(self) -> float:
        """The log's innovations over the largest of the drawn robots."""
        return self.measured / self.expected


def agreement(log: Log, assumed: Assumptions, drawn: Sequence[DrawnRuns], period: float) -> tuple[Agreement, ...]:
    """Each sensor of `log` against what robots that were `drawn` show of it every `period` [s].

    Raises `InvalidLog` where the log lacks encoders, gyro or commands, is uneven, or too short; `SpecMismatch` for a
    kit without these sensors.
    """
    robot, kit = assumed.actual_robot, assumed.actual_kit
    followed = sampled(robot, kit, log.period)
    readings, commands = recorded(log, followed.delay)
    motors = at_motors(commands, kit, robot.command_unit, sent=commanded(log) == "command")
    measured = innovation_size(kalman_filter(followed), DrawnRuns(readings[None], motors[None]))[0]
    estimator = kalman_filter(sampled(robot, kit, period))
    standing = np.concatenate([innovation_size(estimator, runs) for runs in drawn])
    largest = standing.max(axis=0) if len(standing) else np.ones(3)
    return tuple(
        Agreement(name.removeprefix("sensor/"), float(own), float(most))
        for name, own, most in zip(RAW, measured, largest, strict=True)
    )


def innovation_size(estimator: Filter, runs: DrawnRuns) -> Array:
    """Size of the innovations (robots, 3), over the standard deviation that the filter predicts [1].

    The size is 1.48 times the median of |e|. Missing readings (NaN) and the first `SETTLED` seconds are left out.
    """
    readings, motors = runs
    model = estimator.sampled
    linear = estimator.sampled.linear
    start = first_state(model, readings[:, 0].T)
    commands = np.moveaxis(motors, 0, 2)
    before = np.concatenate([np.zeros_like(commands[:1]), commands[:-1]])
    moved = model.before @ before + model.now @ commands
    _, errors = filtered(linear.A, linear.C, estimator.L, np.moveaxis(readings, 0, 2), moved, start)
    predicted = np.sqrt(np.diag(estimator.innovation_covariance))
    return 1.4826 * np.nanmedian(np.abs(errors[round(SETTLED / model.dt) :]), axis=0).T / predicted
