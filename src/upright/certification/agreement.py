"""Whether a log agrees with the assumptions of a certificate: its innovations against those of the drawn robots.

The steady Kalman filter of the nominal robot predicts each reading of the log from the applied commands. Its noise is
that of the kit. The same filter predicts drawn robots in the nonlinear model with the kit's faults, under the
controller and the standard pushes. The log agrees where its innovations are not larger than theirs. Sizes are medians,
so a single push or lost sample, which the model does not have, has no effect.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from upright.arrays import Array
from upright.calibration.knocks import SETTLED, at_motors, first_state, recorded
from upright.certification.checks import TrialSetup, watched
from upright.certification.logged import NOISED
from upright.control.delay import RAW, sampled
from upright.control.kalman import Filter, filtered, kalman_filter
from upright.errors import SpecMismatch
from upright.logs.recording import commanded
from upright.signals import Log

AMBER, RED = "amber", "red"

DRAWN = 12
"""Number of robots with which the log is compared: the largest of 12 is near the 92 % quantile of all."""

LARGER = 2.0  # times the largest of the drawn robots: amber, since noise or model err by more than what was drawn
FAR_LARGER = 5.0  # red: what was certified is another robot
APPLIED = ("applied/left", "applied/right")


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

    def __str__(self) -> str:
        return f"{self.sensor} innovations {self.ratio:.2f} times those expected"


def disagreements(agreements: Sequence[Agreement], light: str) -> list[str]:
    """The sensors of a log whose innovations ask for this light, the largest first, as sentences."""
    low, high = (FAR_LARGER, np.inf) if light == RED else (LARGER, FAR_LARGER)
    beyond = sorted((a for a in agreements if low < a.ratio <= high), key=lambda a: -a.ratio)
    return [
        f"the log's {a.sensor} innovations are {a.ratio:.1f} times the largest of any drawn robot; the limit is {low:g}"
        for a in beyond
    ]


def agreement(log: Log, setup: TrialSetup) -> tuple[Agreement, ...]:
    """Each sensor of `log`, recorded on the robot of `setup`, against the first `DRAWN` of its drawn robots.

    Robots that fall are left out. Raises `InvalidLog` where the log lacks encoders, gyro or commands, is uneven, or too
    short; `SpecMismatch` for a kit without these sensors.
    """
    robot = setup.actual_robot
    kit = setup.actual_kit
    period = setup.controller.law.period
    followed = sampled(robot, kit, log.period)
    readings, commands = recorded(log, followed.delay)
    applied = at_motors(commands, kit, robot.command_unit, sent=commanded(log) == "command")
    measured = innovation_size(kalman_filter(followed), readings[None], applied[None])[0]
    estimator = kalman_filter(sampled(robot, kit, period))
    agreements = list[Array]()
    sides = [kit.motor.left, kit.motor.right]
    reads = setup.controller.law.linear.reads
    if not set(RAW) <= set(reads):
        raise SpecMismatch(f"the controller reads {', '.join(reads)}", expected="both encoders and the gyro")
    logged = setup.logged  # its kit has the noise that the filter needs: a motion that the model lacks counts as noise
    if logged:
        logged = replace(logged, changes={name: drawn for name, drawn in logged.changes.items() if name != NOISED})
    some = replace(setup, robots=setup.robots[:DRAWN], progress=None, logged=logged)
    for number, standard in enumerate(some.pushes().values()):
        result = watched(some, standard.push, number, (*RAW, *APPLIED))
        readings, moved = np.split(result.trace[~result.fell], [3], axis=2)
        agreements.append(innovation_size(estimator, readings, moved * sides))
    standing = np.concatenate(agreements)
    largest = standing.max(axis=0) if len(standing) else np.ones(3)
    return tuple(
        Agreement(name.removeprefix("sensor/"), float(own), float(most))
        for name, own, most in zip(RAW, measured, largest, strict=True)
    )


def innovation_size(estimator: Filter, readings: Array, applied: Array) -> Array:
    """Size of the innovations (robots, 3), over the standard deviation that the filter predicts [1].

    The size is 1.48 times the median of |e|, for readings (robots, n, 3) and commands (robots, n, 2). Missing readings
    (NaN) and the first `SETTLED` seconds are left out.
    """
    model = estimator.sampled
    linear = estimator.sampled.linear
    start = first_state(model, readings[:, 0].T)
    commands = np.moveaxis(applied, 0, 2)
    before = np.concatenate([np.zeros_like(commands[:1]), commands[:-1]])
    moved = model.before @ before + model.now @ commands
    _, errors = filtered(linear.A, linear.C, estimator.L, np.moveaxis(readings, 0, 2), moved, start)
    predicted = np.sqrt(np.diag(linear.C @ estimator.P @ linear.C.T + model.noise))
    return 1.4826 * np.nanmedian(np.abs(errors[round(SETTLED / model.dt) :]), axis=0).T / predicted
