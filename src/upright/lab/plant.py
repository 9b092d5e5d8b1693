"""From a set-up to what runs: the robot that the controller knows, the one that stands there, kit and controller."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

from upright.bodies import Body, Electronics, LinearBody, NonlinearBody, Sample
from upright.bodies.body import REST
from upright.control import CONTROLLERS, Controller, ControllerSpec, Method
from upright.control.observed import by_gain
from upright.errors import InvalidController, InvalidPlugin, InvalidRobot, UnknownName, UprightError
from upright.lab.messages import FamilyInfo, Setup
from upright.physics.dynamics import CALM, Disturbance, drives_speed, motor_gain
from upright.physics.linear import linearise, linearise_rolling
from upright.robots import PARAMETERS, Kit, Robot, kit_names

EXPORTED, FINE, COARSE = 0.001, 0.002, 0.01
"""[s] that one step of a body takes: in a page without Python as in `NonlinearBody`, alone, and in a class of thirty on
one machine; a kit's times round to it."""

QUICKEST = 20_000
"""Steps of RK4 a second, at 20 to 40 µs each, that one body may take; those of the presets take up to 1000."""

TWIN_STEP = 0.0005
"""[s] of MuJoCo's own step: pitch keeps to 0.25 % of its peak (docs/model.md), less than a page can draw, at two
thirds of the usual twin's cost, which is half of the loop's."""


@dataclass(frozen=True)
class Plant:
    """`nominal` is what the controller is designed for; `robot` is what stands there, with its payload."""

    nominal: Robot
    robot: Robot
    kit: Kit


def plant_of(setup: Setup) -> Plant:
    """The robots and kit of a set-up; raises an `UprightError` for what cannot be."""
    nominal = _nominal(setup)
    return Plant(nominal, loaded(nominal, setup.payload, setup.payload_height), _kit(setup))


def _nominal(setup: Setup) -> Robot:
    strangers = [name for name in setup.numbers if name not in PARAMETERS]
    if strangers:
        raise UnknownName("parameter", strangers[0], PARAMETERS)
    complete = setup.drive and len(setup.numbers) == len(PARAMETERS)
    if complete:
        numbers: dict[str, Any] = dict(setup.numbers)
        return Robot(name=setup.robot, drive=setup.drive, kit=setup.kit, **numbers)
    preset = _preset(setup.robot)
    return preset.replace(**setup.numbers) if setup.numbers else preset


@cache
def _preset(name: str) -> Robot:
    return Robot.preset(name)


@cache
def _kit_preset(name: str) -> Kit:
    return Kit.preset(name)


def setup_of(robot: Robot, setup: Setup) -> Setup:
    """The set-up with this robot, of a file, in the place of its own."""
    kit = robot.kit_name if robot.kit_name in kit_names() else setup.kit
    changed = replace(setup, robot=robot.name, numbers=robot.numbers(), drive=robot.drive, kit=kit)
    return replace(changed, largest=(), gains=())


LOAD = (0.3, 0.3)
"""The one payload of a page without Python, and of the worksheet: mass [kg], and height above the axle [m]."""


def loaded(robot: Robot, payload: float, height: float) -> Robot:
    """The robot with a point mass [kg] on its body, `height` [m] above the axle (parallel axes)."""
    if not payload:
        return robot
    mass = robot.body_mass + payload
    centre = (robot.body_mass * robot.com_height + payload * height) / mass
    moved = robot.body_mass * (centre - robot.com_height) ** 2 + payload * (height - centre) ** 2
    return robot.replace(
        body_mass=mass, com_height=centre, pitch_inertia=robot.pitch_inertia + moved,
        roll_inertia=robot.roll_inertia + moved,
    )  # fmt: skip


def _kit(setup: Setup) -> Kit:
    kit = _kit_preset(setup.kit)
    scale = setup.noise
    sensors = {
        name: replace(s, quantum=s.quantum * scale, noise=s.noise * scale, bias=s.bias * scale)
        for name, s in kit.sensors.items()
    }
    motor = replace(kit.motor, dead_zone=_own(setup.dead_zone, kit.motor.dead_zone))
    battery = replace(kit.battery, voltage=max(_own(setup.voltage, kit.battery.voltage), 0.1))
    return replace(kit, sensors=sensors, motor=motor, battery=battery, delay=_own(setup.delay, kit.delay))


def _own(asked: float, own: float) -> float:
    return own if asked < 0 else asked


def design_part(setup: Setup) -> Setup:
    """Only what a controller's design depends on."""
    return replace(setup, bodies=("twin",), payload=0.0, payload_height=0.0, slope=0.0, grip=10.0, seed=0)


class Off:
    """No controller: both commands stay zero. It reads nothing."""

    def __init__(self, period: float, unit: str) -> None:
        self.spec = ControllerSpec("off", (), period, unit)

    def reset(self) -> None:
        """Nothing is remembered."""

    def step(self, measurement: Any, reference: Any) -> tuple[float, float]:  # noqa: ARG002 (whatever they are)
        return 0.0, 0.0

    def estimate(self) -> tuple[float, ...]:
        return ()

    def applied(self, command: Any) -> None:
        """Nothing was asked for."""

    def to_json(self) -> dict[str, Any]:
        return {"kind": "off", "period": self.spec.period, "command_unit": self.spec.command_unit}


BY_HAND, OFF = "gains", "off"
"""Families of the page that are no methods of design: six gains by hand, and no controller at all."""


def families() -> tuple[FamilyInfo, ...]:
    """Every controller family of the page: the registered methods that can be made here and need no numbers of a
    program's own, then the page's own two."""
    methods = {name: _loadable(name) for name in CONTROLLERS}
    known = [FamilyInfo(name, m.weighted) for name, m in methods.items() if m and not (m.lacks or m.own)]
    return (*known, FamilyInfo(BY_HAND, False), FamilyInfo(OFF, False))


def is_slow(family: str) -> bool:
    """Whether a design takes longer than a few frames, so that it is made beside the loop."""
    method = _loadable(family) if family in CONTROLLERS else None
    return method is not None and method.slow


def _loadable(name: str) -> Method | None:
    try:
        return CONTROLLERS[name]
    except InvalidPlugin:
        return None


def design(setup: Setup, robot: Robot, kit: Kit) -> Controller:
    """The set-up's controller for `robot`; raises an `UprightError` where it has none."""
    family = setup.controller
    if family == OFF:
        return Off(kit.period, robot.command_unit)
    if family == BY_HAND:
        return by_gain(setup.gains or _usual(robot, kit), robot, kit, kit.period)
    if family not in CONTROLLERS:  # a page must not name a file, whose code would run here
        raise UnknownName("controller", family, [*CONTROLLERS, BY_HAND, OFF])
    method = CONTROLLERS[family]
    weights = _weights(setup)
    return method(robot, kit, kit.period, **(weights if method.weighted else {}))


def stand_in(setup: Setup, plant: Plant) -> Controller:
    """What stands in for a controller that is still being designed."""
    try:
        return design(replace(setup, controller="lqg", largest=()), plant.nominal, plant.kit)
    except UprightError:
        return Off(plant.kit.period, plant.nominal.command_unit)


def _weights(setup: Setup) -> dict[str, Any]:
    """The set-up's largest deviations, by the names that a weighted method takes; none for its defaults."""
    if not setup.largest:
        return {}
    if len(setup.largest) != 7:
        raise InvalidController(f"{len(setup.largest)} largest deviations", expected="7 (6 states, 1 command), or none")
    return {"largest": setup.largest[:6], "command": setup.largest[6]}


def _usual(robot: Robot, kit: Kit) -> tuple[float, ...]:
    """The left motor's gains of the regulator, where gains by hand begin after a controller that has none."""
    from upright.control import gain_of

    K = gain_of(CONTROLLERS["lqr-state"](robot, kit, kit.period))
    return tuple(K[0].tolist()) if K is not None else (0.0,) * 6


class Pulled:
    """`body` whose wheels can be pulled at the ends of the axle.

    A horizontal force F there is that force on the axle and a moment ∓F W/2 about the vertical, which opposed commands
    of F R/(2α) give exactly, and which wheels that hold their speed bear. The commands it reports are those it was
    given.
    """

    def __init__(self, body: Body) -> None:
        self.body = body
        self.spec = body.spec
        robot = body.spec.robot
        self._turn = 0.0 if drives_speed(robot) else robot.wheel_radius / (2 * motor_gain(robot))
        self.twist = 0.0

    def pull(self, force: float) -> None:
        """Pull the left end with `force` [N], or the right one with minus that, until the next call."""
        self.twist = force * self._turn

    def reset(self, start: Any = REST, seed: int = 0) -> Sample:
        return self.body.reset(start, seed)

    def step(self, command: Any, disturbance: Disturbance = CALM) -> Sample:
        if not self.twist:
            return self.body.step(command, disturbance)
        result = self.body.step((command[0] + self.twist, command[1] - self.twist), disturbance)
        return result._replace(applied=(float(command[0]), float(command[1])))

    def close(self) -> None:
        self.body.close()


def body_of(name: str, plant: Plant, setup: Setup, fine: float, calibrated: Robot | None = None) -> Pulled:
    """The body of that name, not yet behind its electronics, whose period is at most `fine` [s] and divides the kit's.
    Raises `InvalidRobot` for a robot so stiff that it cannot be simulated while it is watched."""
    period = plant.kit.period / math.ceil(plant.kit.period / fine * (1 - 1e-9))
    if name == "twin":
        from upright.bodies.twin import Twin

        return Pulled(Twin(plant.robot, period, timestep=TWIN_STEP, contact_time=2 * TWIN_STEP, grip=setup.grip))
    if name == "linear":
        # The linear model is of what the controller knows: no payload, no other floor.
        return Pulled(LinearBody(linearise_rolling(plant.nominal), plant.nominal, period))
    robot = calibrated if name == "calibrated" and calibrated else plant.robot
    body = NonlinearBody(robot, "published" if name == "published" else "complete", period)
    if body.substeps > QUICKEST * period:
        fastest = max(abs(linearise(robot).poles()))
        raise InvalidRobot(
            f"{robot.name}: a pole of {fastest:.2g} 1/s needs {body.substeps / period:.2g} steps a second",
            expected=f"at most {QUICKEST} on this page", likely="a slip of the decimal point",
            hint="upright simulate, which need not keep to the time",
        )  # fmt: skip
    return Pulled(body)


def behind(body: Pulled, kit: Kit) -> Body:
    """The body behind its kit's electronics."""
    return Electronics(body, kit)


def is_bare(kit: Kit) -> bool:
    """Whether nothing stands between controller and motors."""
    taken = kit.motor.dead_zone + kit.motor.drop
    return kit.name == "ideal" and kit.delay == 0 and taken == 0 and math.isinf(kit.battery.voltage)
