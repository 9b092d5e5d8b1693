"""The physical parameters of a two-wheeled balancing robot."""

from __future__ import annotations

import dataclasses
import functools
import math
import operator
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from upright.atomic import write_text
from upright.errors import InvalidRobot
from upright.pages import Page, Result
from upright.reading import read_json, understood
from upright.robots import toml
from upright.robots.drives import COMMAND_UNITS, UNUSED
from upright.robots.kit import Kit, kit_of
from upright.robots.sections import Conditions, FittedLog, TunedWeights, sections
from upright.robots.toml import Provenance

PRESETS = "presets"


def _number(unit: str, symbol: str, default: float | None = None) -> Any:
    return toml.quantity(unit, default, symbol=symbol)


@dataclass(frozen=True, kw_only=True, repr=False)
class Robot(Result):
    """Parameters of one robot, in SI units. Symbols are those of Herrera et al. (2015) and Yamamoto (2008).

    `pitch_inertia`, `yaw_inertia` and `roll_inertia` are those of the body about its centre of mass. The yaw and
    roll inertias include the two wheels' small inertias about their own diameters. With `drive="torque"`
    the command is each motor's torque [N m], of which `gear_ratio` times acts on its wheel, and the electrical
    parameters are not used. With `drive="speed"` it is the speed of each wheel against the body [rad/s], which the
    drive follows within `speed_lag`, at most at `acceleration_limit` and with `slip_torque` on the wheel.
    `coulomb_friction` acts between body and wheel, `rolling_friction` between wheel and floor; both are those of one
    wheel, smoothed over `stiction_rate`. `correlation` holds the correlation of the errors of pairs of parameters
    [−1 to 1], as a calibration estimates them. `kit` is the name of a kit or its file, or the kit itself, with the
    delays and motors of this very robot. `conditions` are the batteries and floors
    that it is to meet, `weights` those of methods that were tuned for it, which are then their defaults. `noise` holds
    the standard deviations with which a filter of it predicts the next reading, where a calibration learnt them, and
    `fitted` the logs of that calibration.

    Raises `InvalidRobot` for a robot that cannot exist or that has nothing to balance.
    """

    name: str
    wheel_mass: float = _number("kg", "m")
    wheel_radius: float = _number("m", "R")
    wheel_inertia: float = _number("kg m²", "J_w")
    body_mass: float = _number("kg", "M")
    track: float = _number("m", "W")
    com_height: float = _number("m", "L")
    pitch_inertia: float = _number("kg m²", "J_ψ")
    yaw_inertia: float = _number("kg m²", "J_φ")
    roll_inertia: float = _number("kg m²", "J_ρ")
    rotor_inertia: float = _number("kg m²", "J_m")
    gear_ratio: float = _number("1", "n", 1.0)
    motor_resistance: float = _number("Ω", "R_m", 1.0)
    back_emf: float = _number("V s/rad", "K_b", 0.0)
    torque_constant: float = _number("N m/A", "K_t", 1.0)
    motor_friction: float = _number("N m s/rad", "f_m", 0.0)
    wheel_friction: float = _number("N m s/rad", "f_w", 0.0)
    coulomb_friction: float = _number("N m", "τ_c", 0.0)
    rolling_friction: float = _number("N m", "τ_w", 0.0)
    stiction_rate: float = _number("rad/s", "ω_c", 0.2)
    gravity: float = _number("m/s²", "g", 9.81)
    body_depth: float = _number("m", "D", 0.05)
    body_height: float = _number("m", "H", 0.15)
    speed_lag: float = _number("s", "T_v", 0.0)
    acceleration_limit: float = _number("rad/s²", "α_max", 1e5)
    slip_torque: float = _number("N m", "τ_max", 1e5)
    title: str = field(default="", compare=False)
    drive: str = "voltage"
    kit: str | Kit = field(default="ideal", hash=False)
    conditions: Conditions = field(default_factory=Conditions)
    weights: Mapping[str, TunedWeights] = field(default_factory=dict, compare=False, repr=False)
    provenance: Mapping[str, Provenance] = field(default_factory=dict, compare=False, repr=False)
    correlation: Mapping[tuple[str, str], float] = field(default_factory=dict, compare=False, repr=False)
    noise: Mapping[str, float] = field(default_factory=dict, compare=False, repr=False)
    fitted: tuple[FittedLog, ...] = field(default=(), compare=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "name", toml.checked_name(self.name, "robot"))
        _check_numbers(self)
        for rule in _RULES:
            if not rule.holds(self):
                raise rule.error(self)

    @classmethod
    def preset(cls, name: str) -> Robot:
        """The robot of that name among the presets; `UnknownName` lists them."""
        return robot_of(*toml.shipped("robot", PRESETS, name))

    @classmethod
    def load(cls, path: str | Path) -> Robot:
        """A robot from a TOML file (docs/add-a-robot.md); raises `InvalidRobot` for a file without a valid robot. A
        kit's file may lie beside the robot's file, or where the command runs."""
        robot = robot_of(*toml.read("robot", path))
        beside = _folder(path) / robot.kit_file
        return robot.replace(kit=str(beside)) if robot.kit_file and beside.is_file() else robot

    def save(self, path: str | Path) -> Path:
        """Write as TOML with units, sources and spreads; `load` gives back an equal robot with equal provenance, whose
        kit is the same also where its file lies elsewhere.

        Raises `UprightError` where the file cannot be written.
        """
        there = self.kit_file and Path(self.kit_file).is_file()
        robot = self.replace(kit=os.path.relpath(self.kit_file, _folder(path))) if there else self
        return write_text(path, robot.to_toml())

    def to_toml(self) -> str:
        """The text that `load` reads back."""
        parts = [toml.part_text(self, sources=self.provenance)]
        for name, section in _SECTIONS.items():
            parts += [toml.rows(head, entries) for head, entries in section.rows(getattr(self, name))]
        if isinstance(self.kit, Kit):
            parts.append(f"\n{self.kit.to_toml('kit').lstrip()}")
        return "".join(parts)

    @property
    def kit_file(self) -> str:
        """The file of its electronics; "" where that is a preset or the kit itself."""
        return self.kit if isinstance(self.kit, str) and self.kit.endswith(".toml") else ""

    @property
    def kit_name(self) -> str:
        """What its electronics are called."""
        return self.kit if isinstance(self.kit, str) else self.kit.name

    def replace(self, **changes: Any) -> Robot:
        """The same robot with some parameters changed, checked again: they lose their source, a new name the title."""
        kept = {name: source for name, source in self.provenance.items() if name not in changes}
        pairs = {pair: value for pair, value in self.correlation.items() if not changes.keys() & set(pair)}
        title = "" if "name" in changes else self.title
        return dataclasses.replace(self, **({"provenance": kept, "correlation": pairs, "title": title} | changes))

    def without_dry_friction(self) -> Robot:
        """The same robot as it moves while its wheels turn: its tangent at rest would take dry friction for a brake."""
        return self.replace(coulomb_friction=0.0, rolling_friction=0.0)

    def rolling(self, rate: float = 3.0) -> Robot:
        """The robot with its dry friction replaced by the damping that brakes alike at `rate` [rad/s].

        At rest a smoothed dry friction has its steepest slope, which would pass for a brake that no moving robot has: a
        linear model of the robot in motion, for a design or as a body, is the tangent of this one.
        """
        if not (self.coulomb_friction or self.rolling_friction):
            return self
        alike = math.hypot(rate, self.stiction_rate)
        return self.without_dry_friction().replace(
            motor_friction=self.motor_friction + self.coulomb_friction / alike,
            wheel_friction=self.wheel_friction + self.rolling_friction / alike,
        )

    @property
    def command_unit(self) -> str:
        """Unit of the two commands, by the drive: 'V', 'N m' or 'rad/s'."""
        return COMMAND_UNITS[self.drive]

    @property
    def mass(self) -> float:
        """Of the body and both wheels [kg]."""
        return self.body_mass + 2 * self.wheel_mass

    def __repr__(self) -> str:
        return f"Robot({self.name!r}: {self.mass:.3g} kg, centre of mass {self.com_height:.3g} m above the axle)"

    def page(self) -> Page:
        """Its numbers for people."""
        from upright.robots.robot_page import robot_page

        return robot_page(self)

    def to_json(self) -> dict[str, Any]:
        """Plain values: what it is, and every parameter."""
        facts = {name: getattr(self, name) for name in ("name", "title", "mass", "wheel_radius", "com_height", "drive")}
        return {"schema": "upright/robots/1", **facts, "kit": self.kit_name, "parameters": self.parameters()}

    def parameters(self) -> list[dict[str, Any]]:
        """Name, symbol, value, unit, source and spread of every parameter that its drive has, or whose source is
        stated; a spread of None is a guess."""
        rows: list[dict[str, Any]] = []
        for name, (unit, symbol) in PARAMETERS.items():
            if name in UNUSED[self.drive] and name not in self.provenance:
                continue
            origin = self.provenance.get(name, Provenance("not stated"))
            rows.append({"name": name, "symbol": symbol, "value": getattr(self, name), "unit": unit, **vars(origin)})
        return rows

    def numbers(self) -> dict[str, float]:
        """Every physical parameter by field name, in SI units."""
        return {name: float(getattr(self, name)) for name in PARAMETERS}


PARAMETERS: dict[str, tuple[str, str]] = {
    f.name: (f.metadata["unit"], f.metadata["symbol"]) for f in dataclasses.fields(Robot) if f.metadata
}
"""Field name → (unit, symbol) of every physical parameter, in order."""

_SECTIONS = sections(PARAMETERS)
_LOSSES = ("motor_friction", "wheel_friction", "coulomb_friction", "rolling_friction")
MAY_BE_ZERO = ("rotor_inertia", "back_emf", *_LOSSES, "speed_lag")
_LARGEST = 3.0  # [m] no balancing robot is larger
LEAST, _MOST = 1e-12, 1e6  # every number that is not zero, in SI units: products of them neither vanish nor overflow
_UNUSUAL = 30.0  # times beyond those of the shipped robots, a number is worth a look


def preset_names() -> tuple[str, ...]:
    """Names of the robots that come with the package, sorted."""
    return toml.names(PRESETS)


def find_robot(robot: Robot | str | Path) -> Robot:
    """The robot itself, the one in the file where this is a path to `.toml`, or to the `.json` of a
    calibration, else the preset of that name."""
    if isinstance(robot, Robot):
        return robot
    if str(robot).endswith(".json"):
        return _calibrated(Path(robot))
    if toml.is_path(robot):
        return Robot.load(robot)
    file = Path(f"{robot}.toml")
    if robot not in preset_names() and file.is_file():
        raise InvalidRobot(f"no preset is called '{robot}'", hint=f"the file, {file}")
    return Robot.preset(str(robot))


def _calibrated(path: Path) -> Robot:
    """The robot in a posterior by `upright calibrate --save`; raises `InvalidRobot` where it holds none."""
    expected = "a posterior by upright calibrate --save"
    data = read_json(path, InvalidRobot, expected)
    with understood(f"the posterior {path}", InvalidRobot, expected):
        refuse_misfit(data, path)
        text = data["toml"]
    return robot_of(toml.parse_toml(text, str(path), InvalidRobot, expected), str(path))


def refuse_misfit(posterior: Mapping[str, Any], path: Path) -> None:
    """Raise `InvalidRobot` for the posterior of a fit that was refused."""
    if refused := posterior.get("refused"):
        why = f"{path} is of a fit that does not describe its robot: {str(refused[0])[:300]}"
        raise InvalidRobot(why, hint="calibrate from another log, or with the robot that the log is of")


def possible(p: Any) -> Any:
    """Whether `Robot` accepts the numbers of `p`, which has the fields of `Robot`, all finite.

    A bool, or an array (n,) where the fields are arrays over n robots.
    """
    return functools.reduce(operator.and_, (rule.holds(p) for rule in _RULES))


class _Rule(NamedTuple):
    """What holds of every robot, of one number or of arrays of them, and the error where it does not."""

    holds: Callable[[Any], Any]
    error: Callable[[Robot], InvalidRobot]


def unusual(numbers: Mapping[str, float]) -> str:
    """The number that lies furthest from those of the shipped robots, with theirs; "" where none is far off."""
    shipped = [Robot.preset(name).numbers() for name in preset_names()]
    far: dict[float, str] = {}
    for name, value in numbers.items():
        usual = sorted(robot[name] for robot in shipped if robot[name] > 0)
        if usual and value > 0:
            words = f"{name} = {value:g} {PARAMETERS[name][0]} (shipped: {usual[0]:.3g} to {usual[-1]:.3g})"
            far[max(value / usual[-1], usual[0] / value)] = words
    return far[max(far)] if far and max(far) > _UNUSUAL else ""


def _sign(name: str) -> _Rule:
    unit = PARAMETERS[name][0]
    zero = name in MAY_BE_ZERO
    lower = "zero or more" if zero else "more than zero"

    def holds(p: Any) -> Any:
        value = getattr(p, name)
        return (value <= _MOST) & ((value >= LEAST) | (value == 0) if zero else value >= LEAST)

    def error(robot: Robot) -> InvalidRobot:
        value = getattr(robot, name)
        wrong_sign = value < 0 or (value == 0 and not zero)
        return InvalidRobot(
            f"{robot.name}: {name} is {value:g} {unit}",
            expected=lower if wrong_sign else f"{'zero, or ' if zero else ''}{LEAST:g} to {_MOST:g}",
            likely="a slip of the sign" if wrong_sign else "a slip of the exponent",
        )

    return _Rule(holds, error)


def _size(name: str) -> _Rule:
    def holds(p: Any) -> Any:
        return getattr(p, name) <= _LARGEST

    def error(robot: Robot) -> InvalidRobot:
        value = f"{name} is {getattr(robot, name):g} m"
        return InvalidRobot(f"{robot.name}: {value}", expected=f"at most {_LARGEST:g} m", likely="millimetres")

    return _Rule(holds, error)


def _triangle(p: Any) -> Any:
    """No inertia exceeds the sum of the other two, but for rounding."""
    pitch, yaw, roll = p.pitch_inertia, p.yaw_inertia, p.roll_inertia
    most = 1 + 1e-9
    return (pitch <= (yaw + roll) * most) & (yaw <= (pitch + roll) * most) & (roll <= (pitch + yaw) * most)


def _not_rigid(robot: Robot) -> InvalidRobot:
    inertias = {axis: getattr(robot, f"{axis}_inertia") for axis in ("pitch", "yaw", "roll")}
    largest = max(inertias, key=lambda axis: inertias[axis])
    others = sum(inertias.values()) - inertias[largest]
    return InvalidRobot(
        f"{robot.name}: {largest}_inertia {inertias[largest]:g} kg m² exceeds the sum of the other two, {others:g}",
        expected="principal inertias that obey the triangle inequality, as those of any rigid body do",
        likely="an inertia about the axle given for one about the centre of mass",
    )


def _own_numbers(p: Any) -> Any:
    """No number of another drive."""
    return functools.reduce(operator.and_, (getattr(p, name) == getattr(Robot, name) for name in UNUSED[p.drive]))


def _of_another_drive(robot: Robot) -> InvalidRobot:
    names = [name for name in UNUSED[robot.drive] if getattr(robot, name) != getattr(Robot, name)]
    numbers = ", ".join(f"{name} = {getattr(robot, name):g}" for name in names)
    hint = f"leave {' and '.join(names)} out, or set another drive"
    return InvalidRobot(f"{robot.name}: a {robot.drive} drive with {numbers}", expected="none of these", hint=hint)


def _lags(p: Any) -> Any:
    return (p.speed_lag > 0) | (p.drive != "speed")


def _without_lag(robot: Robot) -> InvalidRobot:
    return InvalidRobot(
        f"{robot.name}: a speed drive without speed_lag",
        expected="the time [s] in which a wheel takes up its speed: 0.002 of a stepper, 0.02 of a wheel with encoder",
    )


def _stands(p: Any) -> Any:
    return p.com_height >= LEAST


def _hangs(robot: Robot) -> InvalidRobot:
    return InvalidRobot(
        f"{robot.name}: com_height is {robot.com_height:g} m, so the robot has no unstable pole",
        expected="a centre of mass above the axle",
        likely="a slip of the sign, or a hanging pendulum",
    )


_RULES = (
    *(_sign(name) for name in PARAMETERS if name != "com_height"),
    _Rule(_own_numbers, _of_another_drive),
    _Rule(_lags, _without_lag),
    *(_size(name) for name in ("wheel_radius", "track", "com_height")),
    _Rule(_triangle, _not_rigid),
    _Rule(_stands, _hangs),
)


def _check_numbers(robot: Robot) -> None:
    for name, (unit, _) in PARAMETERS.items():
        value = getattr(robot, name)
        if isinstance(value, bool) or not isinstance(value, int | float) or not math.isfinite(value):
            raise InvalidRobot(f"{robot.name}: {name} is {value!r}", expected=f"a finite number [{unit}]")
        object.__setattr__(robot, name, float(value))
    if robot.drive not in COMMAND_UNITS:
        raise InvalidRobot(f"{robot.name}: drive is '{robot.drive}'", expected=" or ".join(map(repr, COMMAND_UNITS)))
    if isinstance(robot.kit, Kit):
        robot.kit.check_drive(robot.drive)


def _folder(path: str | Path) -> Path:
    """The folder of a file; `~` of nobody stays as it is."""
    return Path(os.path.expanduser(path)).parent


def robot_of(table: toml.Table, where: str) -> Robot:
    """The robot in a table of TOML, which messages call `where`; raises `InvalidRobot`."""
    own = ["kit"] if isinstance(table.get("kit"), dict) else []
    given, sources = toml.read_part(Robot, table, where, others=(*_SECTIONS, *own))
    if own:
        given["kit"] = kit_of(table["kit"], f"{where}, kit")
    for name, section in _SECTIONS.items():
        if name in table:
            given[name] = section.read(table[name], where)
    return Robot(**given, provenance=sources)
