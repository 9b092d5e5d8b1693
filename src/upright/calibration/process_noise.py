"""Process noise: what disturbs a robot between two readings, as variances a second, before any is learnt."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from upright.calibration.fitting import JITTER, STICKING, Problem
from upright.calibration.parameters import most_friction
from upright.logs.readers import DECIMATION
from upright.logs.recording import Recording
from upright.physics.dynamics import motor_gain
from upright.robots import Kit, Robot
from upright.signals import Log

NOISE_TIME = 0.01  # [s] period for which fractions of the commands are meant
FRICTION_NOISE = 0.01  # [1] first noise of sticking wheels, as a fraction of the largest friction, where none is known
BIAS_WALK = 1e-7  # [(rad/s)²/s] random walk of the gyro's bias: a few hundredths of a degree a second each second


def arrival(kit: Kit, logs: Sequence[Log]) -> dict[str, float]:
    """Log-variance [s²] of the moments at which commands arrive: of the kit's jitter, and of commands that were not
    logged, where the file says that one row in n was.

    Between two logged commands the others are a random walk from one to the other. Their mean over the period T is off
    from the middle of both by T²(1 − 1/n²)/12 in variance, for a change of one: as a command is that arrives so much
    earlier or later. (The middle itself is a dead time.)
    """
    left_out = [log.period**2 * (1 - 1 / float(log.origin.get(DECIMATION, 1)) ** 2) for log in logs]
    variance = (kit.jitter**2 + float(np.mean(left_out))) / 12
    return {JITTER: float(np.log(variance))} if variance else {}


def process(recordings: Sequence[Recording], robot: Robot, fraction: float) -> dict[str, float]:
    """Log-variances a second of process noise: a `fraction` of the commands (rms), and of 1 N for a robot of 0.6 kg;
    while a wheel sticks, the friction that holds it, or where none is known, a hundredth of the largest plausible."""
    rms = np.sqrt(np.mean([np.mean(r.commands**2) for r in recordings]))
    dry = (robot.coulomb_friction or FRICTION_NOISE * most_friction(robot)) / motor_gain(robot)
    sizes = {"motor": fraction * max(rms, 1e-9), "push": fraction * robot.body_mass / 0.6, STICKING: max(dry, 1e-9)}
    return {name: float(np.log(size**2 * NOISE_TIME)) for name, size in sizes.items()} | {
        "gyro_bias": float(np.log(BIAS_WALK))
    }


def with_process(problem: Problem, fraction: float) -> Problem:
    """The same problem with that `process` noise."""
    return problem.with_noise(process(problem.recordings, problem.robot, fraction))
