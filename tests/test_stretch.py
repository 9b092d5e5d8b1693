"""A log begins anywhere: its stretches are simulated from first states that are fitted to their readings."""

from __future__ import annotations

import numpy as np
import pytest

from upright.bodies import NonlinearBody
from upright.calibration.calibrate import prepared
from upright.calibration.calibrated_robot import Segments
from upright.calibration.validate import segments
from upright.control import lqr_state
from upright.experiment import run
from upright.robots import Kit, Robot
from upright.signals import Log

ROBOT, IDEAL = Robot.preset("nxtway-gs"), Kit.preset("ideal")


def simulated(log: Log, robot: Robot, kit: Kit) -> Segments:
    problem, _ = prepared([log], robot, kit, (), 0.0)
    return segments(problem, problem.recordings[0], np.zeros(len(problem.parameters)))


@pytest.mark.parametrize(("pitch", "rate"), [(-0.25, 0.0), (0.2, 1.0)])
def test_a_log_that_begins_in_motion_is_followed_from_its_first_row(pitch: float, rate: float) -> None:
    """The model's own log and parameters: what is off is the first state alone, whose pitch no sensor tells."""
    start = (pitch, rate, 0.0, 3.0, 0.0, 0.5)
    log = run(NonlinearBody(ROBOT.replace(coulomb_friction=0.0)), lqr_state(ROBOT, 0.01), seconds=1.5, start=start)
    raw = Log(log.t, {n: v for n, v in log.channels.items() if not n.startswith("truth/")}, log.units, log.origin)
    found = simulated(raw, ROBOT.replace(coulomb_friction=0.0), IDEAL)
    assert found.lost == 0.0
    assert min(found.r_squared(name) for name in found.rows) > 0.99  # the bias of the gyro is the filter's own


@pytest.mark.parametrize(
    ("start", "factors"),
    [
        ((0.296, -0.468, 0.0, 1.17, 0.0, 0.0), (1.04, 0.72, 1.08)),
        ((0.24, 0.0, 0.0, -0.7, 0.0, 0.0), (1.63, 1.27, 1.15)),
    ],
)
def test_a_stretch_that_falls_in_simulation_is_begun_where_it_falls_as_the_readings_do(
    start: tuple[float, ...], factors: tuple[float, float, float]
) -> None:
    """A robot of other numbers than the log's stays near its readings for half a second from some first state, whose
    error has a minimum for each way to fall. From the wrong one the gyro of these was predicted at −0.4 and −0.6."""
    smooth = ROBOT.replace(coulomb_friction=0.0)
    height, back_emf, radius = factors
    other = smooth.replace(
        com_height=height * ROBOT.com_height, back_emf=back_emf * ROBOT.back_emf,
        wheel_radius=radius * ROBOT.wheel_radius,
    )  # fmt: skip
    log = run(NonlinearBody(smooth), lqr_state(ROBOT, 0.01), seconds=1.0, start=start)
    raw = Log(log.t, {n: v for n, v in log.channels.items() if not n.startswith("truth/")}, log.units, log.origin)
    assert simulated(raw, other, IDEAL).r_squared("sensor/gyro") > 0.9
