"""Messages that describe a set-up: what there is to choose, how it stands, and the numbers of its equations."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import Any

from upright.atomic import finite
from upright.lab.lane import Lane
from upright.lab.messages import Catalogue, Changed, Equations, Look, RobotInfo, Setup
from upright.lab.plant import Plant, families
from upright.lab.spoken import in_each
from upright.languages import translated
from upright.pages.terms import term
from upright.physics.dynamics import mass_matrix, motor_damping, motor_gain, turn_ratio, yaw_swing
from upright.physics.linear import linearise_rolling
from upright.robots import PARAMETERS, Robot, kit_names, preset_names


@cache
def catalogue() -> Catalogue:
    """What there is to choose."""
    from upright.control.riccati import LARGEST_COMMAND, LARGEST_STATE

    robots = tuple(robot_info(Robot.preset(name)) for name in preset_names())
    units = {name: unit for name, (unit, _) in PARAMETERS.items()}
    symbols = {name: symbol for name, (_, symbol) in PARAMETERS.items()}
    names = in_each(lambda: {name: str(term(name)) for name in PARAMETERS})
    return Catalogue(robots, kit_names(), families(), units, symbols, names, LARGEST_STATE, dict(LARGEST_COMMAND))


def robot_info(robot: Robot) -> RobotInfo:
    """A robot to choose."""
    return RobotInfo(robot.name, titles_of(robot), robot.kit_name, robot.numbers())


def titles_of(robot: Robot) -> dict[str, str]:
    """A robot's title by language: of the presets there are translations."""
    return in_each(lambda: translated(robot.title))


def changed(setup: Setup, plant: Plant, lanes: Sequence[Lane], busy: bool) -> Changed:
    """The set-up, what to draw and what the kit really is."""
    robot = plant.robot
    kit = plant.kit
    voltage = kit.battery.voltage
    numbers = {"delay": kit.delay, "dead_zone": kit.motor.dead_zone, "voltage": voltage if voltage < 1e6 else -1.0}
    names = tuple(lane.name for lane in lanes)
    look = look_of(robot, setup, lanes[0].body.spec.limit)
    return Changed(setup=setup, look=look, bodies=names, period=kit.period, kit=numbers, busy=busy)


def look_of(robot: Robot, setup: Setup, limit: float) -> Look:
    """What the page draws the robot from; `limit` is the largest command."""
    return Look(
        wheel_radius=robot.wheel_radius, track=robot.track, body_height=robot.body_height, body_depth=robot.body_depth,
        com_height=robot.com_height, payload=setup.payload, payload_height=setup.payload_height,
        command_unit=robot.command_unit, limit=finite(limit), weight=robot.body_mass * robot.gravity,
    )  # fmt: skip


def equations(robot: Robot) -> Equations:
    """The equations of a robot, in numbers."""
    model = linearise_rolling(robot)
    poles = tuple((round(float(p.real), 3), round(float(p.imag), 3)) for p in model.poles())
    return Equations(
        inertias=tuple(float(a) for a in mass_matrix(1.0, 0.0, robot)), alpha=float(motor_gain(robot)),
        beta=float(motor_damping(robot)), weight=robot.body_mass * robot.gravity * robot.com_height,
        lever=robot.body_mass * robot.com_height * robot.wheel_radius, swing=float(yaw_swing(robot, "complete")),
        half_track=turn_ratio(robot), A=_rows(model.A), B=_rows(model.B), poles=poles,
    )  # fmt: skip


def _rows(matrix: Any) -> tuple[tuple[float, ...], ...]:
    return tuple(tuple(float(f"{v:.5g}") for v in row) for row in matrix.tolist())
