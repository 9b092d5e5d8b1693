"""What a calibration hands to a certificate: the robot, how far from it the truth may be, and its dead times."""

from __future__ import annotations

from dataclasses import dataclass, replace

from upright.calibrate.calibration import HELD, Calibration
from upright.logs.recording import SENSOR
from upright.robots import PARAMETERS, Kit, Robot
from upright.robots.uncertainty import Uncertainty


@dataclass(frozen=True, eq=False)
class Learnt:
    """A robot with its kit, and the posterior of its parameters."""

    robot: Robot
    kit: Kit
    uncertainty: Uncertainty


def learnt(calibration: Calibration, kit: Kit) -> Learnt:
    """The calibrated robot with the posterior of its parameters, on `kit` with the sensor delays of the log.

    Where the log's dead times are shorter, those of the kit stay. A log of applied commands does not show all dead
    time.
    """
    rows = [i for i, name in enumerate(calibration.names) if name in PARAMETERS]
    names = [calibration.names[i] for i in rows]
    mean = [getattr(calibration.robot, name) for name in names]
    uncertainty = Uncertainty.joint(names, mean, calibration.covariance[rows][:, rows])
    delays = {e.name.removeprefix("delay/"): e.value for e in calibration.delays if e.verdict != HELD}
    dead_time = kit.delay + kit.jitter / 2
    sensors = {
        name: replace(sensor, delay=max(sensor.delay, delays.get(SENSOR.get(name, ""), 0.0) - dead_time))
        for name, sensor in kit.sensors.items()
    }
    return Learnt(calibration.robot, replace(kit, sensors=sensors), uncertainty)
