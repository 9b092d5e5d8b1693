"""What a session says: how it stands, and what its desk has found, as events."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.atomic import finite
from upright.errors import InvalidLog, UprightError
from upright.lab.messages import (
    VERSION,
    Analysed,
    Catalogue,
    Change,
    Changed,
    Equations,
    Keep,
    Look,
    Made,
    Notice,
    Progress,
    RobotInfo,
    Start,
    Welcome,
)  # fmt: skip
from upright.lab.plant import families
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain, yaw_swing
from upright.physics.linear import linearise
from upright.robots import PARAMETERS, Robot, kit_names, preset_names

if TYPE_CHECKING:
    from upright.lab.session import Session

SUFFIX: dict[Keep, str] = {
    "csv": "run.csv", "parquet": "run.parquet", "report": "report.html", "replay": "replay.html",
    "controller": "controller.json", "robot": "robot.toml",
}  # fmt: skip


@cache
def catalogue() -> Catalogue:
    """What there is to choose."""
    from upright.control.lqr import LARGEST_COMMAND, LARGEST_STATE

    robots = tuple(_info(Robot.preset(name)) for name in preset_names())
    units = {name: unit for name, (unit, _) in PARAMETERS.items()}
    symbols = {name: symbol for name, (_, symbol) in PARAMETERS.items()}
    return Catalogue(robots, kit_names(), families(), units, symbols, LARGEST_STATE, dict(LARGEST_COMMAND))


def _info(robot: Robot) -> RobotInfo:
    return RobotInfo(robot.name, robot.title, robot.kit, robot.drive, robot.numbers())


def changed(session: Session, busy: bool) -> Changed:
    """The set-up, what to draw and what the kit really is."""
    robot, kit, main = session.plant.robot, session.plant.kit, session.lanes[0]
    limit, setup = main.body.spec.limit, session.setup
    look = Look(
        wheel_radius=robot.wheel_radius, track=robot.track, body_height=robot.body_height, body_depth=robot.body_depth,
        com_height=robot.com_height, payload=setup.payload, payload_height=setup.payload_height,
        command_unit=robot.command_unit, limit=finite(limit), weight=robot.body_mass * robot.gravity,
    )  # fmt: skip
    voltage = kit.battery.voltage
    numbers = {"delay": kit.delay, "dead_zone": kit.motor.dead_zone, "voltage": voltage if voltage < 1e6 else -1.0}
    spec = main.controller.spec
    names = tuple(lane.name for lane in session.lanes)
    return Changed(
        setup=setup, look=look, bodies=names, period=kit.period, controller=spec.kind, truth=spec.reads_truth,
        kit=numbers, busy=busy,
    )  # fmt: skip


def standing(session: Session) -> list[Any]:
    """The equations of the robot that stands there."""
    robot = session.plant.robot
    model = linearise(robot)
    poles = tuple((round(float(p.real), 3), round(float(p.imag), 3)) for p in model.poles())
    equations = Equations(
        inertias=tuple(float(a) for a in mass_matrix(1.0, 0.0, robot)), alpha=float(motor_gain(robot)),
        beta=float(motor_damping(robot)), weight=robot.body_mass * robot.gravity * robot.com_height,
        lever=robot.body_mass * robot.com_height * robot.wheel_radius, swing=float(yaw_swing(robot, "complete")),
        half_track=robot.track / (2 * robot.wheel_radius), A=_rows(model.A), B=_rows(model.B), poles=poles,
    )  # fmt: skip
    return [equations]


def _rows(matrix: Any) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(f"{v:.5g}") for v in row) for row in matrix.tolist())


def task_of(session: Session, message: Start) -> tuple[str, tuple[Any, ...]]:
    """The task and its arguments for a job that a page starts."""
    robot = session.plant.nominal
    if message.job in ("certify", "design"):
        extra = (False,) if message.job == "design" else ()
        return message.job, (session.setup, *extra)
    source = session.upload(message.file) if message.file else _recorded(session)
    return message.job, (source, robot) if message.job == "doctor" else (source, robot, session.plant.kit)


def keeping(session: Session, what: Keep) -> tuple[str, tuple[Any, ...]]:
    """The task and its arguments for a file to be downloaded."""
    path = session.folder / SUFFIX[what]
    if what == "controller":
        return f"keep {what}", (session.setup, path)
    if what == "robot":
        return f"keep {what}", (session.calibrated or session.plant.nominal, path)
    if what == "replay":
        events = [Welcome(VERSION, "", "alone", ""), catalogue(), *session.standing_events()]
        return f"keep {what}", ([*events, *session.moments()], path)
    logs = session.logs()
    if not logs:
        raise InvalidLog("nothing was recorded yet", hint="let it run for a moment")
    return f"keep {what}", (logs if what == "report" else next(iter(logs.values())), path)


def _recorded(session: Session) -> Any:
    logs = session.logs()
    if not logs:
        raise InvalidLog("nothing was recorded yet", hint="let it run for a moment")
    return next(iter(logs.values()))


def _designed(session: Session, result: Any) -> list[Any]:
    controller, analysis = result
    events: list[Any] = [analysis]
    if controller is not None:
        try:
            session.designed(controller)
        except UprightError as error:
            return [Notice("error", str(error))]
        events.append(session.changed())
    if isinstance(analysis, Analysed):
        events += session.follow()
    return events


def _lit(session: Session, result: Any) -> list[Any]:  # noqa: ARG001
    return [result]


def _certified(session: Session, result: Any) -> list[Any]:  # noqa: ARG001
    return [*result, Progress("certify", 1.0)]


def _examined(session: Session, result: Any) -> list[Any]:  # noqa: ARG001
    return [result, Progress("doctor", 1.0)]


def _calibrated(session: Session, result: Any) -> list[Any]:
    robot, table = result
    session.calibrated = robot
    names = tuple(dict.fromkeys((*session.setup.bodies, "calibrated")))
    session.handle(Change(replace(session.setup, bodies=names)))
    return [table, Progress("calibrate", 1.0)]


def _read(session: Session, result: Any) -> list[Any]:
    kit = result.kit if result.kit in kit_names() else session.setup.kit
    setup = replace(session.setup, robot=result.name, numbers=result.numbers(), drive=result.drive, kit=kit)
    session.handle(Change(replace(setup, largest=(), gains=())))
    return [Notice("info", f"{result.name}: read")]


def _made(session: Session, result: Any) -> list[Any]:  # noqa: ARG001
    name = Path(result).name
    return [Made(name.rpartition(".")[2], name, name)]


ANSWERS: dict[str, Callable[[Session, Any], list[Any]]] = {
    "design": _designed, "light": _lit, "certify": _certified, "doctor": _examined, "calibrate": _calibrated,
    "robot": _read, **{f"keep {what}": _made for what in SUFFIX},
}  # fmt: skip
"""What is said when a job is done, by its name."""
