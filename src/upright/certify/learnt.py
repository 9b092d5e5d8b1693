"""What a calibration hands to a certificate: the robot, how far from it the truth may be, and its dead times."""

from __future__ import annotations

from dataclasses import dataclass, replace

from upright.calibrate.calibrate import calibrate
from upright.calibrate.calibration import HELD, Calibration
from upright.calibrate.knocks import unpushed
from upright.certify.checks import Course
from upright.certify.logged import LOADED
from upright.certify.support import LOAD_KNOWN, Support
from upright.certify.taking import as_logged
from upright.errors import InvalidLog
from upright.logs.recording import SENSOR
from upright.progress import Progress
from upright.robots import PARAMETERS, Kit, Robot
from upright.robots.robot import MAY_BE_ZERO
from upright.robots.uncertainty import Spread, Uncertainty
from upright.signals import Log


@dataclass(frozen=True, eq=False)
class Learnt:
    """A robot with its kit, and the posterior of its parameters."""

    robot: Robot
    kit: Kit
    uncertainty: Uncertainty


def calibrated(log: Log, course: Course, progress: Progress | None = None) -> tuple[Learnt, tuple[Support, ...]]:
    """The robot of `course` calibrated from `log`, and what its file and its kit had wrong, beside what they say.

    A calibration doubts no scale, no weighed mass and little of the electronics: where these are wrong it bends other
    numbers. So the log is first compared with the file, and what it contradicts is corrected. Raises `InvalidLog` where
    the calibration is refused.
    """
    met, _, taken = as_logged(log, course)
    if taken:
        calm = unpushed(log, met.met_robot, met.met_kit)
        calibration = calibrate(calm, _weighed(met), met.met_kit, progress=progress)
        if not calibration.refused:
            return learnt(calibration, course.kit), taken
    calibration = calibrate(unpushed(log, course.robot, course.kit), course.robot, course.kit, progress=progress)
    if calibration.refused:
        raise InvalidLog(
            f"the log does not describe {course.robot.name}: {calibration.refused[0]}",
            hint="upright doctor LOG; or certify without the log, or with the robot that it is of",
        )
    return learnt(calibration, course.kit), ()


def _weighed(met: Course) -> Robot:
    """The robot with the load that the log shows, whose mass and inertias are then known as well as that."""
    robot = met.met_robot
    if robot is met.robot:
        return robot
    known = {name: replace(source, spread=max(source.spread or 0.0, LOAD_KNOWN * getattr(robot, name)))
             for name, source in robot.provenance.items() if name in LOADED and source.spread is not None}  # fmt: skip
    return robot.replace(provenance={**robot.provenance, **known})


def learnt(calibration: Calibration, kit: Kit) -> Learnt:
    """The calibrated robot with the posterior of its parameters, on `kit` with the sensor delays of the log.

    Where the log's dead times are shorter, those of the kit stay. A log of applied commands does not show all dead
    time.
    """
    rows = [i for i, name in enumerate(calibration.names) if name in PARAMETERS]
    names = [calibration.names[i] for i in rows]
    mean = [getattr(calibration.robot, name) for name in names]
    normal = Uncertainty.joint(names, mean, calibration.covariance[rows][:, rows])
    positive = [s if s.name in MAY_BE_ZERO or s.low <= 0 else _lognormal(s) for s in normal.spreads]
    uncertainty = Uncertainty(tuple(positive), normal.correlation)
    delays = {e.name.removeprefix("delay/"): e.value for e in calibration.delays if e.verdict != HELD}
    dead_time = kit.delay + kit.jitter / 2
    sensors = {
        name: replace(sensor, delay=max(sensor.delay, delays.get(SENSOR.get(name, ""), 0.0) - dead_time))
        for name, sensor in kit.sensors.items()
    }
    return Learnt(calibration.robot, replace(kit, sensors=sensors), uncertainty)


def _lognormal(s: Spread) -> Spread:
    """As a calibration takes what must be positive: its logarithm is normal."""
    return Spread(s.name, "lognormal", s.low, s.high / s.low)
