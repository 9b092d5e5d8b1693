"""What stands between a controller and the physics: sensors, motors, battery, and time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path

from upright.errors import InvalidRobot, SpecMismatch
from upright.pages import Say
from upright.robots import toml
from upright.robots.drives import COMMAND_UNITS, DRIVES
from upright.robots.toml import quantity
from upright.robots.wiring import BoardWiring
from upright.signals.signal import FUSED, SENSORS

PRESETS = "kits"
_CHANNELS = {signal.name.removeprefix("sensor/"): signal for signal in (*SENSORS, *FUSED)}
_COMMAND = " or ".join(COMMAND_UNITS.values())
"""Unit of a command, by the drive that the kit serves."""

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

    quantum: float = quantity("{}", 0.0, "step between two readings")
    noise: float = quantity("{}", 0.0, "standard deviation of white noise, each sample")
    bias: float = quantity("{}", 0.0, "standard deviation of the constant offset, drawn at reset")
    bias_walk: float = quantity("{}/√s", 0.0, "standard deviation of the offset's random walk, per √s")
    range: float = quantity("{}", math.inf, "largest absolute reading")
    delay: float = quantity("s", 0.0, "from the physics to the reading")
    period: float = quantity("s", 0.0, "between two fresh readings, held between")
    resonance: float = quantity(
        "Hz", 0.0, "where it swings against the frame, or its filter ends; 0 for neither", only="sensor/gyro"
    )
    damping: float = quantity("1", 0.7, "of that resonance: little of what swings, 0.7 of a filter", only="sensor/gyro")
    gain: float = quantity("1", 1.0, "reading over what is measured; 1 but for a scale error")
    misalignment: float = quantity(
        "1", 0.0, "part of the yaw rate that it reads, since it is tilted", only="sensor/gyro"
    )
    offset: float = quantity("{}", 0.0, "what it reads where the truth is zero: an angle's error of mounting")
    time_constant: float = quantity(
        "s", 0.0, "of the filter that makes a fused angle; 0 for the angle itself", only="sensor/pitch"
    )

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

    limit: float = quantity(_COMMAND, math.inf, "largest command that the driver gives")
    dead_zone: float = quantity(_COMMAND, 0.0, "commands up to this size do nothing")
    quantum: float = quantity(_COMMAND, 0.0, "step between two commands")
    drop: float = quantity("V", 0.0, "what the driver keeps of each command, as bridges of bipolar transistors do")
    backlash: float = quantity("rad", 0.0, "play between wheel and encoder")
    left: float = quantity("1", 1.0, "part of a command that the left motor turns into torque")
    right: float = quantity("1", 1.0, "the same of the right motor")

    def __post_init__(self) -> None:
        for f in fields(self):
            _check_size(f"motor {f.name}", getattr(self, f.name))


@dataclass(frozen=True, kw_only=True)
class Battery:
    """Open-circuit `voltage` [V] and the `sag` [V per V commanded to both motors together]."""

    voltage: float = quantity("V", math.inf, "at rest")
    sag: float = quantity("1", 0.0, "volts lost for each volt commanded to both motors")

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
    kit. `drive` is "voltage", "torque" or "speed" where the motor's numbers are for one of them, "" where the kit suits
    all.
    `wiring` is for generated sketches alone: it changes nothing of what is simulated.
    """

    name: str
    drive: str = ""
    sensors: dict[str, Sensor] = field(default_factory=dict)
    motor: Motor = Motor()
    battery: Battery = Battery()
    period: float = quantity("s", 0.01, "of the control loop")
    delay: float = quantity("s", 0.0, "from a command to the motor")
    jitter: float = quantity("s", 0.0, "width of the delay's random addition")
    wiring: BoardWiring = field(default_factory=BoardWiring)

    def __post_init__(self) -> None:
        object.__setattr__(self, "name", toml.checked_name(self.name, "kit"))
        if self.drive not in ("", *COMMAND_UNITS):
            expected = f"{', '.join(map(repr, COMMAND_UNITS))} or nothing"
            raise InvalidRobot(f"kit '{self.name}': drive is '{self.drive}'", expected=expected)
        if self.drive not in ("", "voltage") and self.motor.drop:
            raise InvalidRobot(f"kit '{self.name}': motor.drop is {self.motor.drop:g} V with a {self.drive} drive",
                               expected="no drop, which only a voltage drive has")  # fmt: skip
        _check_size("kit delay", self.delay)
        _check_size("kit jitter", self.jitter)
        if not 0 < self.period < 1:
            raise InvalidRobot(f"kit period is {self.period:g} s", expected="between 0 and 1 s", likely="milliseconds")

    def check_drive(self, drive: str) -> None:
        """Raise `SpecMismatch` for a robot whose motors are driven by something else: a key of `COMMAND_UNITS`."""
        if self.drive and self.drive != drive:
            came = Say("kit {name} drives by {drive}", name=self.name, drive=DRIVES[self.drive])
            raise SpecMismatch(came, expected=Say("{drive}, as the robot", drive=DRIVES[drive]))
        if self.motor.drop and drive != "voltage":
            raise SpecMismatch(f"kit '{self.name}' has a drop of {self.motor.drop:g} V", expected="a voltage drive",
                               hint="a kit without motor.drop")  # fmt: skip

    def most(self, unit: str) -> float:
        """The largest command in this `unit` that the motors get: the driver's limit or, in volts, the battery's."""
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
        parts = [toml.part_text(getattr(self, name), prefix + name) for name in _PARTS]
        for channel, sensor in self.sensors.items():
            name = channel.removeprefix("sensor/")
            called = f"{prefix}sensors.{name}"
            text = toml.part_text(sensor, called, _CHANNELS[name])
            parts.append(text or f"\n[{called}]\n")
        return "".join([toml.part_text(self, table), *parts])


_PARTS = {"motor": Motor, "battery": Battery, "wiring": BoardWiring}


def kit_names() -> tuple[str, ...]:
    """Names of the kits that come with the package, sorted."""
    return toml.names(PRESETS)


def find_kit(kit: Kit | str | Path) -> Kit:
    """The kit itself, the one in the file where this is a path to `.toml`, else the preset of that name."""
    if isinstance(kit, Kit):
        return kit
    return Kit.load(kit) if toml.is_path(kit) else Kit.preset(str(kit))


def quantity_of(number: str) -> toml.Meaning:
    """Unit and meaning of a `number` as a kit's file names it, such as `motor.limit` or `sensors.gyro.noise`."""
    *place, name = number.split(".")
    if place[:1] == ["sensors"]:
        return toml.quantities(Sensor, _CHANNELS[place[1]])[name]
    return toml.quantities(_PARTS[place[0]] if place else Kit)[name]


def kit_of(table: toml.Table, where: str) -> Kit:
    """The kit in a table of TOML, which messages call `where`; raises `InvalidRobot`."""
    given, _ = toml.read_part(Kit, table, where, others=("title", "sensors", *_PARTS))
    for name, kind in _PARTS.items():
        numbers, _ = toml.read_part(kind, toml.as_table(table.get(name, {}), name, where), where, f"{name}.")
        given[name] = kind(**numbers)
    listed = toml.as_table(table.get("sensors", {}), "sensors", where)
    toml.check_keys(listed, _CHANNELS, where, "sensors.")
    sensors: dict[str, Sensor] = {}
    for name, signal in _CHANNELS.items():
        if name in listed:
            own = toml.as_table(listed[name], f"sensors.{name}", where)
            numbers, _ = toml.read_part(Sensor, own, where, f"sensors.{name}.", signal=signal)
            sensors[signal.name] = Sensor(**numbers)
    kit = Kit(**given, sensors=sensors)
    for side in ("encoder_left", "encoder_right"):
        if (encoder := sensors.get(f"sensor/{side}")) is not None:
            kit.wiring.edges(encoder.quantum, f"{where}: sensors.{side}")
    drop = kit.motor.drop
    most = kit.most("V")
    if drop and drop >= most:
        raise InvalidRobot(f"{where}: motor.drop is {drop:g} V", expected=f"less than the {most:g} V of the motors",
                           likely="millivolts")  # fmt: skip
    return kit
