"""Process noise: what disturbs a robot between two readings, as variances a second, before any is learnt."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from upright.calibrate.fitting import STICKING
from upright.calibrate.parameters import most_friction
from upright.logs.recording import Recording
from upright.physics.dynamics import motor_gain
from upright.robots import Robot

NOISE_TIME = 0.01  # [s] period for which fractions of the commands are meant
FRICTION_NOISE = 0.01  # [1] first noise of sticking wheels, as a fraction of the largest friction, where none is known
BIAS_WALK = 1e-7  # [(rad/s)²/s] random walk of the gyro's bias: a few hundredths of a degree a second each second


def process(recordings: Sequence[Recording], robot: Robot, fraction: float) -> dict[str, float]:
    """Log-variances a second of process noise: a `fraction` of the commands (rms), and of 1 N for a robot of 0.6 kg;
    while a wheel sticks, the friction that holds it, or where none is known, a hundredth of the largest plausible."""
    rms = np.sqrt(np.mean([np.mean(r.commands**2) for r in recordings]))
    dry = (robot.coulomb_friction or FRICTION_NOISE * most_friction(robot)) / motor_gain(robot)
    sizes = {"motor": fraction * max(rms, 1e-9), "push": fraction * robot.body_mass / 0.6, STICKING: max(dry, 1e-9)}
    return {name: float(np.log(size**2 * NOISE_TIME)) for name, size in sizes.items()} | {
        "gyro_bias": float(np.log(BIAS_WALK))
    }
