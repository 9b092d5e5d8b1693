"""What stands between a controller and the physics: sensors, motors, battery, and time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from upright.errors import InvalidRobot, SpecMismatch
from upright.robots import toml
from upright.robots.wiring import UNITS as WIRING_UNITS
from upright.robots.wiring import BoardWiring, wiring_of
from upright.signals.signal import FUSED, SENSORS

PRESETS = "kits"
_TIMING = ("period", "delay", "jitter")
_MOTOR_UNITS = {
    "limit": "V", "dead_zone": "V", "quantum": "V", "drop": "V", "backlash": "rad", "left": "1", "right": "1",
}  # fmt: skip
_BATTERY_UNITS = {"voltage": ("V",), "sag": ("1",)}
_KEYS = ("name", "title", "period", "delay", "jitter", "drive", "battery", "motor", "sensors", "wiring")
_SENSOR_UNITS = {signal.name.removeprefix("sensor/"): signal.unit for signal in (*SENSORS, *FUSED)}


LONGEST_DELAY = 1.0
"""[s] of a dead time, a jitter or a sensor's period: what comes a second late balances nothing."""

SMALLEST_QUANTUM = 1e-9
"""Step of a reading or a command, where there is one: a smaller one is below the rounding of what is computed."""


def _check_size(name: str, value: float) -> None:
    """Raise `InvalidRobot` for a size that no part has, by the last word of its `name`."""
    last = name.rpartition(" ")[2]
    if not value >= 0:
        raise InvalidRobot(f"{name} is {value:g}", expected="zero or more")
    if last in ("delay", "jitter", "period") and value > LONGEST_DELAY:
        raise InvalidRobot(f"{name} is {value:g} s", expected="at most 1 s", likely="milliseconds")
    if last == "quantum" and 0 < value < SMALLEST_QUANTUM:
        raise InvalidRobot(f"{name} is {value:g}", expected=f"zero for none, or at least {SMALLEST_QUANTUM:g}")
    if value == math.inf and last not in ("limit", "range"):
        raise InvalidRobot(f"{name} is infinite", expected="a number")


STOP = 0.8
"""Lean [rad], 46°, at which every program stops the motors: few have the torque to come back from there, and the wheels
of a robot that lies would spin on. So it is the lean at which a robot under any controller has fallen."""


@dataclass(frozen=True, kw_only=True)
class Sensor:
    """One sensor's faults, in the unit of its channel (rad, rad/s, m/s², V).

    The defaults mean ideal: no quantum, no noise, no bias, unlimited range, no delay, sampled at every step.
    """

    quantum: float = 0.0  # step between two readings
    noise: float = 0.0  # standard deviation of white noise, each sample
    bias: float = 0.0  # standard deviation of the constant offset, drawn at reset
    bias_walk: float = 0.0  # standard deviation of the offset's random walk, per √s
    range: float = math.inf  # largest absolute reading
    delay: float = 0.0  # [s] from the physics to the reading
    period: float = 0.0  # [s] between two fresh readings, held between
    resonance: float = 0.0  # [Hz] where it swings against the frame, or its filter ends; 0 for neither
    damping: float = 0.7  # [1] of that resonance: little of what swings, 0.7 of a filter
    gain: float = 1.0  # reading over what is measured; 1 but for a scale error
    misalignment: float = 0.0  # [1] part of the yaw rate that a gyro reads beside the pitch rate: it is tilted
    offset: float = 0.0  # what it reads where the truth is zero: an angle's error of mounting
    time_constant: float = 0.0  # [s] of the filter that makes a fused angle; 0 for the angle itself

    def __post_init__(self) -> None:
        for f in fields(self):
            size = getattr(self, f.name)
            _check_size(f"sensor {f.name}", abs(size) if f.name in ("misalignment", "offset") else size)
        if abs(self.misalignment) > 1:
            raise InvalidRobot(f"sensor misalignment is {self.misalignment:g}", expected="-1 to 1",
                               likely="degrees instead of their sine")  # fmt: skip
        if self.resonance and not self.damping:
            raise InvalidRobot("sensor damping is 0", expected="more than zero, as of every resonance")


@dataclass(frozen=True, kw_only=True)
class Motor:
    """What a motor and its driver do to a command, besides the physics in `Robot`."""

    limit: float = math.inf  # largest command the driver gives (V or N m)
    dead_zone: float = 0.0  # commands up to this size do nothing (V or N m)
    quantum: float = 0.0  # step between two commands (V or N m)
    drop: float = 0.0  # [V] that the driver keeps of each command, as bridges of bipolar transistors do
    backlash: float = 0.0  # [rad] play between wheel and encoder
    left: float = 1.0  # [1] fraction of a command that the left motor turns into torque
    right: float = 1.0  # [1] the same of the right motor

    def __post_init__(self) -> None:
        for f in fields(self):
            _check_size(f"motor {f.name}", getattr(self, f.name))


@dataclass(frozen=True, kw_only=True)
class Battery:
    """Open-circuit `voltage` [V] and the `sag` [V per V commanded to both motors together]."""

    voltage: float = math.inf
    sag: float = 0.0

    def __post_init__(self) -> None:
        _check_size("battery sag", self.sag)
        if not self.voltage > 0:
            raise InvalidRobot(f"battery voltage is {self.voltage:g} V", expected="more than zero")

    def volts(self, duties: Sequence[float]) -> tuple[float, float]:
        """Voltages [V] at two motors driven by duty (−1 to 1) of the loaded battery: V = voltage − sag V Σ|duty|."""
        left, right = duties
        loaded = self.voltage / (1 + self.sag * (abs(left) + abs(right)))
        return left * loaded, right * loaded


@dataclass(frozen=True, kw_only=True)
class Kit:
    """Sensors by channel, motors, battery, and the timing of the control loop.

    `period` [s] is the loop period that the kit is meant for. `delay` [s] is the dead time from a command to the motor,
    and `jitter` [s] the width of its uniform random addition. A channel that is not in `sensors` does not exist on this
    kit. `drive` is "voltage" or "torque" where the motor's numbers are for one of them, "" where the kit suits both.
    `wiring` is for generated sketches alone: it changes nothing of what is simulated.
    """

    name: str
    drive: str = ""
    sensors: dict[str, Sensor] = field(default_factory=dict)
    motor: Motor = Motor()
    battery: Battery = Battery()
    period: float = 0.01
    delay: float = 0.0
    jitter: float = 0.0
    wiring: BoardWiring = field(default_factory=BoardWiring)

    def __post_init__(self) -> None:
        object.__setattr__(self, "name", toml.checked_name(self.name, "kit"))
        if self.drive not in ("", "voltage", "torque"):
            raise InvalidRobot(f"kit '{self.name}': drive is '{self.drive}'", expected="'voltage', 'torque' or nothing")
        if self.drive == "torque" and self.motor.drop:
            raise InvalidRobot(f"kit '{self.name}': motor.drop is {self.motor.drop:g} V with a torque drive",
                               expected="no drop, which only a voltage drive has")  # fmt: skip
        _check_size("kit delay", self.delay)
        _check_size("kit jitter", self.jitter)
        if not 0 < self.period < 1:
            raise InvalidRobot(f"kit period is {self.period:g} s", expected="between 0 and 1 s", likely="milliseconds")

    def check_drive(self, drive: str) -> None:
        """Raise `SpecMismatch` for a robot whose motors are driven by something else: "voltage" or "torque"."""
        if self.drive and self.drive != drive:
            raise SpecMismatch(f"kit '{self.name}' drives by {self.drive}", expected=f"{drive}, as the robot")
        if self.motor.drop and drive != "voltage":
            raise SpecMismatch(f"kit '{self.name}' has a drop of {self.motor.drop:g} V", expected="a voltage drive",
                               hint="a kit without motor.drop")  # fmt: skip

    def most(self, unit: str) -> float:
        """The largest command in this `unit` that the motors get, "V" or "N m": the driver's limit, or the battery."""
        return min(self.motor.limit, self.battery.voltage if unit == "V" else math.inf)

    @classmethod
    def preset(cls, name: str) -> Kit:
        """The kit of that name among the presets; `UnknownName` lists them."""
        return kit_of(*toml.shipped("kit", PRESETS, name))

    @classmethod
    def load(cls, path: str | Path) -> Kit:
        """A kit from a TOML file written like the presets; raises `InvalidRobot` for a file without a valid kit."""
        return kit_of(*toml.read("kit", path))

    def to_toml(self, table: str = "") -> str:
        """The text that `load` reads back as this kit, or the part of a robot's file in the `table` of this name."""
        prefix = f"{table}." if table else ""
        head = [f"[{table}]\n"] if table else []
        head += [f"{key} = {toml.quoted(getattr(self, key))}\n" for key in ("name", "drive") if getattr(self, key)]
        parts: list[tuple[str, Any, Mapping[str, str]]] = [
            ("", self, dict.fromkeys(_TIMING, "s")), ("motor.", self.motor, _MOTOR_UNITS),
            ("battery.", self.battery, {name: units[0] for name, units in _BATTERY_UNITS.items()}),
            ("wiring.", self.wiring, dict.fromkeys(WIRING_UNITS, "1")),
        ]  # fmt: skip
        for name, sensor in self.sensors.items():
            units = {key: several[0] for key, several in _sensor_units(name.removeprefix("sensor/")).items()}
            parts.append((f"sensors.{name.removeprefix('sensor/')}.", sensor, units))
        tables = [text for where, part, units in parts for text in _numbers(f"{prefix}{where}", part, units)]
        empty = [f"\n[{prefix}sensors.{n.removeprefix('sensor/')}]\n" for n, s in self.sensors.items() if s == Sensor()]
        driver = f"\n[{prefix}wiring]\ndriver = {toml.quoted(self.wiring.driver)}\n" if self.wiring.driver else ""
        return "".join([*head, *tables, *empty, driver])


def kit_names() -> tuple[str, ...]:
    """Names of the kits that come with the package, sorted."""
    return toml.names(PRESETS)


def find_kit(kit: Kit | str | Path) -> Kit:
    """The kit itself, the one in the file where this is a path to `.toml`, else the preset of that name."""
    if isinstance(kit, Kit):
        return kit
    return Kit.load(kit) if toml.is_path(kit) else Kit.preset(str(kit))


def kit_of(table: toml.Table, where: str) -> Kit:
    """The kit in a table of TOML, which messages call `where`; raises `InvalidRobot`."""
    toml.check_keys(table, _KEYS, where)
    if "name" not in table:
        raise InvalidRobot(f"{where} lacks name", expected="the kit's name", hint='name = "my-kit"')
    timing = {key: toml.number(table[key], key, ("s",), where) for key in _TIMING if key in table}
    battery = toml.numbers(table, "battery", _BATTERY_UNITS, where)
    command = ("V", "N m")  # a kit serves voltage and torque drives alike
    units = {key: command if unit == "V" and key != "drop" else (unit,) for key, unit in _MOTOR_UNITS.items()}
    motor = toml.numbers(table, "motor", units, where)
    listed = toml.subtable(table, "sensors", where)
    toml.check_keys(listed, _SENSOR_UNITS, where, "sensors.")
    sensors = {f"sensor/{name}": Sensor(**_sensor(listed, name, where)) for name in _SENSOR_UNITS if name in listed}
    name = toml.word(table, "name", where)
    drive = toml.word(table, "drive", where) if "drive" in table else ""
    kit = Kit(
        name=name, drive=drive, sensors=sensors, motor=Motor(**motor), battery=Battery(**battery),
        wiring=wiring_of(table, where), **timing,
    )  # fmt: skip
    for side in ("encoder_left", "encoder_right"):
        if (encoder := sensors.get(f"sensor/{side}")) is not None:
            kit.wiring.edges(encoder.quantum, f"{where}: sensors.{side}")
    drop = kit.motor.drop
    most = kit.most("V")
    if drop and drop >= most:
        raise InvalidRobot(f"{where}: motor.drop is {drop:g} V", expected=f"less than the {most:g} V of the motors",
                           likely="millivolts")  # fmt: skip
    return kit


def _sensor(listed: toml.Table, name: str, where: str) -> dict[str, float]:
    return toml.numbers(listed, name, _sensor_units(name), where, "sensors.")


def _sensor_units(name: str) -> dict[str, tuple[str, ...]]:
    unit = _SENSOR_UNITS[name]
    units = dict.fromkeys(("quantum", "noise", "bias", "range", "offset"), (unit,))
    return (
        units
        | {"bias_walk": (f"{unit}/√s",), "delay": ("s",), "period": ("s",), "gain": ("1",)}
        | ({"resonance": ("Hz",), "damping": ("1",), "misalignment": ("1",)} if name == "gyro" else {})
        | ({"time_constant": ("s",)} if name == "pitch" else {})
    )


def _numbers(where: str, part: Any, units: Mapping[str, str]) -> Iterator[str]:
    """The numbers of a part that differ from its default, each as a table of TOML."""
    default = {f.name: f.default for f in fields(part)}
    for key, unit in units.items():
        value = float(getattr(part, key))
        if value != default[key] and math.isfinite(value):
            yield f"\n[{where}{key}]\nvalue = {value!r}\nunit = {toml.quoted(unit)}\n"
