"""Targets: languages and bricks, the raw units of their sensors and the steps of their motors."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace

from upright.compiled.program import Program
from upright.errors import InvalidController, SpecMismatch, UnknownName
from upright.firmware.sketch_wiring import PIN_VOLTS, STEPS, battery_divider, encoder_step
from upright.robots import Kit, Robot

DEGREE = math.pi / 180

ENCODERS = ("sensor/encoder_left", "sensor/encoder_right")
GYRO, COMPASS, BATTERY, PITCH = "sensor/gyro", "sensor/compass", "sensor/battery", "sensor/pitch"
SI = {**dict.fromkeys(ENCODERS, "rad"), GYRO: "rad/s", COMPASS: "rad", BATTERY: "V", PITCH: "rad"}
"""Channel → the unit that controllers read it in."""
OFFSET = math.radians(3.0)  # [rad/s] of the gyro at rest, which the program has to find


@dataclass(frozen=True)
class Raw:
    """A sensor as a target gives it: one raw `unit` is `scale` of the SI unit, 0 where the kit says it; `whole` for
    integers."""

    unit: str
    scale: float
    whole: bool = False


_SI_RAW = {channel: Raw(unit, 1.0) for channel, unit in SI.items()}
_LEGO = {**dict.fromkeys(ENCODERS, Raw("deg", DEGREE, True)), GYRO: Raw("deg/s", DEGREE, True)}
_MILLIVOLTS = {BATTERY: Raw("mV", 0.001, True)}


@dataclass(frozen=True)
class Target:
    """A language and a brick: `full` is its largest duty (0: the kit's own steps), `raw` the sensors it has by channel.

    A `numeric` target commands any robot; the others drive motors by duty, so that they need a battery, or, where they
    make `steps`, steppers by their speed.
    """

    name: str
    suffix: str
    full: int
    raw: Mapping[str, Raw]
    numeric: bool = False
    numbers: tuple[str, ...] = ("float",)
    steps: bool = False

    def sensor(self, channel: str, kit: Kit) -> Raw:
        """How this target gives that channel of `kit`; `InvalidController` for one it does not have."""
        if channel not in self.raw:
            raise InvalidController(f"target {self.name} has no {channel}", expected=", ".join(self.raw))
        raw = self.raw[channel]
        if raw.scale:
            return raw
        if channel == BATTERY:
            full = PIN_VOLTS * battery_divider(kit)
            return replace(raw, unit=f"{full:g} V/{STEPS}", scale=full / STEPS)
        return replace(raw, scale=encoder_step(kit, channel))


_IMU = {GYRO: Raw("deg/s", DEGREE)}  # a hub's inertial unit gives fractions of a degree
_MPU = {GYRO: Raw("1/65.5 deg/s", DEGREE / 65.5, True)}  # MPU-6050 data sheet, ±500 °/s: 65.5 steps for 1 °/s
_FUSED = {PITCH: Raw("1/10000 rad", 1e-4, True)}  # the sketch's own filter: finer than an accelerometer's noise
_COUNTS = dict.fromkeys(ENCODERS, Raw("count", 0.0, True))
_DIVIDER = {BATTERY: Raw("", 0.0, True)}
_BOARD = {**_COUNTS, **_MPU, **_FUSED, **_DIVIDER}

TARGETS = {
    target.name: target
    for target in (
        Target("c", ".c", 0, _SI_RAW, True, ("float", "double", "fixed")),
        Target(
            "arduino", ".ino", 255, {**_COUNTS, **_MPU, **_FUSED, **_DIVIDER}, numbers=("float", "fixed"), steps=True
        ),
        Target("pybricks", ".py", 100, {**_LEGO, **_IMU, **_MILLIVOLTS}),
        Target("ev3dev", ".py", 100, {**_LEGO, **_MILLIVOLTS}),
        Target("nxc", ".nxc", 100, {**_LEGO, COMPASS: Raw("deg", DEGREE, True), **_MILLIVOLTS}),
    )
}
"""Name → target; a new one is one line here and one file of templates."""


def find_target(name: str) -> Target:
    """The target of that name; `UnknownName` lists them."""
    if name not in TARGETS:
        raise UnknownName("target", name, TARGETS)
    return TARGETS[name]


@dataclass(frozen=True, kw_only=True)
class Driver:
    """How a command becomes what the motors get, in the command's unit.

    Commands up to `dead_zone` do nothing, none exceeds `limit`, and motors get `drop` less; `full` is the largest duty,
    0 for none, and the battery [V] stands between `lowest` and `highest`; nothing starts below `empty`.
    """

    unit: str
    full: int
    dead_zone: float
    drop: float
    limit: float
    lowest: float
    highest: float
    empty: float


PRODUCT = {"arduino": 17.7e-6, "avr": 17.7e-6, "nxc": 33e-6, "pybricks": 16e-6}
"""[s] of one product and its sum in float, of an LQG in the table of docs/firmware.md; C on 32 bits is quicker."""


def computing_time(products: int, where: str) -> float:
    """About how long a period's `products` take on a target [s]; 0 where that is not known."""
    return products * PRODUCT.get(where, 0.0)


def check_time(program: Program, where: str) -> None:
    """Raise `InvalidController` for a program whose products alone take `where` it runs longer than its period."""
    time = computing_time(program.operations(), where)
    if time > program.period:
        raise InvalidController(
            f"this {program.kind} takes about {time * 1e3:.0f} ms a period on {where}: {program.operations()} products",
            expected=f"at most its period, {program.period * 1e3:g} ms", hint="target c on a 32-bit processor",
        )  # fmt: skip


FINE = 1000  # steps of duty where the kit states none
FLAT, EMPTY, FRESH = 0.6, 0.85, 1.5
"""Battery voltage over the kit's: the lowest under load, the lowest to start with (bricks switch themselves off at 0.8
of a pack of lithium cells), the highest of freshly charged cells."""


def driver(robot: Robot, kit: Kit, target: Target) -> Driver:
    """What stands between program and motors; raises `SpecMismatch` where target and robot do not fit."""
    unit = robot.command_unit
    volts = kit.battery.voltage
    motor = kit.motor
    powered = unit == "V" and math.isfinite(volts)
    if not powered and not target.numeric and not (target.steps and robot.drive == "speed"):
        why = f"'{robot.name}' is commanded in {unit}" if unit != "V" else f"kit '{kit.name}' has no battery"
        raise SpecMismatch(f"{target.name}: {why}", expected="a battery and motors driven by its voltage", hint="use c")
    kit.check_drive(robot.drive)
    if motor.drop and not powered:
        raise SpecMismatch(f"kit '{kit.name}' has a drop and no battery", expected="the battery's voltage",
                           hint="[battery.voltage] in the kit's file")  # fmt: skip
    steps = target.full or (round(volts / motor.quantum) if motor.quantum else FINE)
    lowest, highest, empty = (FLAT * volts, FRESH * volts, EMPTY * volts) if powered else (1.0, 1.0, 1.0)
    return Driver(
        unit=unit, full=steps if powered else 0, dead_zone=motor.dead_zone, drop=motor.drop, limit=motor.limit,
        lowest=lowest, highest=highest, empty=empty,
    )  # fmt: skip


def largest(kit: Kit, channel: str, travel: float) -> float:
    """The largest reading of that channel [SI] a program believes: `travel` [rad] of an encoder, else the sensor's own.

    Raises `InvalidController` for a channel that no program knows.
    """
    if channel in ENCODERS:
        return travel
    if channel not in SI or channel not in kit.sensors:
        raise InvalidController(f"no program reads {channel}", expected="some of " + ", ".join(SI))
    # [rad/s] ±2000 °/s, as the widest gyros; [rad] of a compass
    widest = {GYRO: 35.0, PITCH: math.pi}.get(channel, 4 * math.pi)
    return min(kit.sensors[channel].range, widest)
