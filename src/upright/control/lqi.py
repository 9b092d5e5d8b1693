"""LQI: the servo regulator of NXTway-GS, with the integral of the wheel's position error as a state."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.control.delay import sampled
from upright.control.kalman import RECOVERED, Disturbed, kalman_filter
from upright.control.linear_controller import LinearController
from upright.control.lqg import regulated
from upright.control.observer import Extra, output_feedback
from upright.control.riccati import LARGEST_STATE
from upright.errors import DesignFailed
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import STATE_NAMES

LARGEST_INTEGRAL = 4.0  # [rad s] of the wheel: 4 rad off for a second
UNWINDING = 2.0  # [s] in which saturation is taken back out of the integral


def lqi(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed = RECOVERED,
    unwinding: float = UNWINDING,
) -> LinearController:
    """The servo regulator of Yamamoto (2008) in discrete time, for `robot` on the sensors of `kit`.

    The state is the robot's six, the commands on their way, and e⁺ = e + dt (θ − θ_r) [rad s]; the same regulator holds
    the heading. What saturation, dead zone and battery take from a command flows back into e within `unwinding` [s].
    Q (7, 7) or its diagonal, e last; R (2, 2) or (2,); without them Bryson's rule. Raises `DesignFailed` like `lqg`.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    if not unwinding > 0:
        raise DesignFailed(f"unwinding takes {unwinding} s", expected="a positive time")
    model = sampled(robot, kit, dt, reads)
    model.check_position("lqi")
    servo = with_integral(model.plant)
    largest = [*LARGEST_STATE, LARGEST_INTEGRAL]
    design = regulated(kalman_filter(model, disturbed), Q, R, servo=servo, largest=largest)
    by_integral = design.K[:, -1:]
    extra = Extra(np.eye(1), servo.A[-1:, :-1], by_integral, unwound(by_integral[:, 0], model.dt / unwinding))
    return output_feedback(design.filter, design.K[:, :-1], "lqi", design, extra)


def unwound(gain: Array, fraction: float) -> Array:
    """The row (1, 2) that takes `fraction` of what the motors withheld out of an integral acting with −gain (2,)."""
    return np.full((1, 2), -fraction / gain.sum())


def with_integral(plant: LinearModel) -> LinearModel:
    """The plant with e⁺ = e + dt θ as its last state."""
    n = len(plant.states)
    A = np.eye(n + 1)
    B = np.vstack([plant.B, np.zeros((1, 2))])
    A[:n, :n], A[n, STATE_NAMES.index("wheel")] = plant.A, plant.dt
    return LinearModel(A, B, dt=plant.dt, states=(*plant.states, "integral"), inputs=plant.inputs)
