"""Robots and kits as TOML files: every number with its unit, its source, and its spread or the word "guess"."""

from __future__ import annotations

import dataclasses
import difflib
import json
import math
import tomllib
import unicodedata
from collections.abc import Iterable, Mapping
from importlib import resources
from pathlib import Path
from typing import Any, NoReturn, cast

from upright.atomic import write_text
from upright.errors import InvalidRobot, UnknownName
from upright.robots.kit import Battery, Kit, Motor, Sensor
from upright.robots.robot import PARAMETERS, Provenance, Robot
from upright.signals.signal import SENSORS

Table = Mapping[str, Any]

_ELECTRICAL = ("motor_resistance", "back_emf", "torque_constant")
_SENSOR_UNITS = {signal.name.removeprefix("sensor/"): signal.unit for signal in SENSORS}
_ONE_NUMBER = {"value", "unit", "source", "spread"}
_LIKELY = {
    "mm": "millimetres; 1 mm is 0.001 m",
    "cm": "centimetres; 1 cm is 0.01 m",
    "g": "grams; 1 g is 0.001 kg",
    "g cm²": "a CAD program's unit; 1 g cm² is 1e-7 kg m²",
    "kg mm²": "a CAD program's unit; 1 kg mm² is 1e-6 kg m²",
    "g mm²": "a CAD program's unit; 1 g mm² is 1e-9 kg m²",
    "ms": "milliseconds; 1 ms is 0.001 s",
    "deg": "degrees; 1 degree is 0.0174533 rad",
    "°": "degrees; 1 degree is 0.0174533 rad",
    "deg/s": "degrees; 1 deg/s is 0.0174533 rad/s",
    "°/s": "degrees; 1 °/s is 0.0174533 rad/s",
    "rpm": "revolutions; 1 rpm is 0.104720 rad/s",
    "mN m": "millinewtons; 1 mN m is 0.001 N m",
    "mV": "millivolts; 1 mV is 0.001 V",
}


def preset_names() -> tuple[str, ...]:
    """Names of the robots that come with the package, sorted."""
    return _names("presets")


def kit_names() -> tuple[str, ...]:
    """Names of the kits that come with the package, sorted."""
    return _names("kits")


def load_preset(name: str) -> Robot:
    """The robot preset of that name; raises `UnknownName`."""
    if name not in preset_names():
        raise UnknownName("robot", name, preset_names())
    return _robot(_parse(_shipped("presets", name), f"robot preset {name}"), f"robot preset {name}")


def load_kit(name: str) -> Kit:
    """The kit preset of that name; raises `UnknownName`."""
    if name not in kit_names():
        raise UnknownName("kit", name, kit_names())
    return _kit(_parse(_shipped("kits", name), f"kit preset {name}"), f"kit preset {name}")


def read_robot(path: str | Path) -> Robot:
    """A robot from a TOML file; raises `InvalidRobot` for what is not one (see docs/add-a-robot.md)."""
    return _robot(_parse(_text(Path(path), "robot"), str(path)), str(path))


def read_kit(path: str | Path) -> Kit:
    """A kit from a TOML file; raises `InvalidRobot` for what is not one."""
    return _kit(_parse(_text(Path(path), "kit"), str(path)), str(path))


def find_robot(name_or_path: str | Path) -> Robot:
    """The preset of that name, or the robot in the file of that path if it ends in `.toml`."""
    return read_robot(name_or_path) if _is_path(name_or_path) else load_preset(str(name_or_path))


def find_kit(name_or_path: str | Path) -> Kit:
    """The kit preset of that name, or the kit in the file of that path if it ends in `.toml`."""
    return read_kit(name_or_path) if _is_path(name_or_path) else load_kit(str(name_or_path))


def write_robot(robot: Robot, path: str | Path) -> Path:
    """Write `robot` as TOML; `read_robot` gives back an equal robot with equal provenance.

    Raises `UprightError` where the file cannot be written.
    """
    head = [f"{key} = {_quoted(getattr(robot, key))}" for key in ("name", "title", "drive", "kit")]
    idle = set(_ELECTRICAL) - robot.provenance.keys() if robot.drive == "torque" else set[str]()
    tables = [_written(name, robot) for name in PARAMETERS if name not in idle]
    return write_text(path, "\n".join(head) + "\n" + "".join(tables) + _pairs(robot))


def _pairs(robot: Robot) -> str:
    """A table of each parameter's correlations with others."""
    firsts = dict.fromkeys(first for first, _ in robot.correlation)
    rows = {f: [f"{b} = {r!r}" for (a, b), r in robot.correlation.items() if a == f] for f in firsts}
    return "".join(f"\n[correlation.{first}]\n" + "\n".join(lines) + "\n" for first, lines in rows.items())


def _written(name: str, robot: Robot) -> str:
    lines = ["", f"[{name}]", f"value = {getattr(robot, name)!r}", f"unit = {_quoted(PARAMETERS[name][0])}"]
    if name in robot.provenance:
        known = robot.provenance[name]
        spread = '"guess"' if known.spread is None else repr(float(known.spread))
        lines += [f"source = {_quoted(known.source)}", f"spread = {spread}"]
    return "\n".join(lines) + "\n"


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def _folder(kind: str) -> Any:
    return resources.files("upright.robots").joinpath(kind)


def _names(kind: str) -> tuple[str, ...]:
    files = (entry.name for entry in _folder(kind).iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in files if name.endswith(".toml")))


def _shipped(kind: str, name: str) -> str:
    return _folder(kind).joinpath(f"{name}.toml").read_text(encoding="utf-8")


def _is_path(name_or_path: str | Path) -> bool:
    if isinstance(name_or_path, Path) or name_or_path.endswith(".toml"):
        return True
    if "/" in name_or_path or "\\" in name_or_path:
        raise InvalidRobot(f"'{name_or_path}' is no preset", expected="a preset's name or a path that ends in .toml")
    return False


def _text(path: Path, kind: str) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except FileNotFoundError as error:
        raise InvalidRobot(f"there is no file {path}", expected=f"a {kind} file in TOML") from error
    except IsADirectoryError as error:
        raise InvalidRobot(f"{path} is a folder", expected=f"a {kind} file in TOML") from error
    except UnicodeDecodeError as error:
        raise InvalidRobot(f"{path} is not text in UTF-8", expected=f"a {kind} file in TOML") from error
    except OSError as error:
        raise InvalidRobot(f"cannot read {path} ({error.strerror})", expected=f"a {kind} file in TOML") from error


def _parse(text: str, where: str) -> Table:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise InvalidRobot(
            f"{where} is broken TOML: {error}", expected="tables like [wheel_radius] value = 0.04"
        ) from error


def _robot(table: Table, where: str) -> Robot:
    _no_strangers(table, {"name", "title", "drive", "kit", "correlation", *PARAMETERS}, where)
    words = {key: _word(table, key, where) for key in ("name", "drive", "kit", "title") if key in table}
    required = {f.name for f in dataclasses.fields(Robot) if f.default is f.default_factory is dataclasses.MISSING}
    missing = sorted(required - table.keys())
    if missing:
        unit = PARAMETERS[missing[0]][0] if missing[0] in PARAMETERS else ""
        hint = f'[{missing[0]}] value = …, unit = "{unit}"' if unit else f'{missing[0]} = "my-robot"'
        raise InvalidRobot(f"{where} lacks {', '.join(missing)}", expected="every required parameter", hint=hint)
    given = [name for name in PARAMETERS if name in table]
    numbers = {name: _number(table[name], name, (PARAMETERS[name][0],), where) for name in given}
    sources = {name: _provenance(table[name], name, where) for name in given}
    provenance = {name: source for name, source in sources.items() if source is not None}
    pairs = _correlation(_subtable(table, "correlation", where), where)
    return Robot(
        **cast(dict[str, Any], words), **cast(dict[str, Any], numbers), provenance=provenance, correlation=pairs
    )


def _correlation(table: Table, where: str) -> dict[tuple[str, str], float]:
    """What `[correlation.one] other = 0.3` says of pairs of parameters."""
    pairs: dict[tuple[str, str], float] = {}
    for first in table:
        _no_strangers(table, PARAMETERS, where, "correlation.")
        row = _subtable(table, first, where)
        _no_strangers(row, PARAMETERS, where, f"correlation.{first}.")
        for second, value in row.items():
            if not _is_number(value) or not -1 <= value <= 1 or first == second:
                raise InvalidRobot(
                    f"{where}: correlation.{first}.{second} is {value!r}", expected="a number from −1 to 1 of two names"
                )
            pairs[first, second] = float(value)
    return pairs


def _kit(table: Table, where: str) -> Kit:
    _no_strangers(table, {"name", "title", "period", "delay", "jitter", "drive", "battery", "motor", "sensors"}, where)
    if "name" not in table:
        raise InvalidRobot(f"{where} lacks name", expected="the kit's name", hint='name = "my-kit"')
    timing = {key: _number(table[key], key, ("s",), where) for key in ("period", "delay", "jitter") if key in table}
    battery = _numbers(table, "battery", {"voltage": ("V",), "sag": ("1",)}, where)
    command = ("V", "N m")  # a kit serves voltage and torque drives alike
    units = {"limit": command, "dead_zone": command, "quantum": command, "backlash": ("rad",)}
    motor = _numbers(table, "motor", units, where)
    listed = _subtable(table, "sensors", where)
    _no_strangers(listed, _SENSOR_UNITS, where, "sensors.")
    sensors = {f"sensor/{name}": Sensor(**_sensor(listed, name, where)) for name in _SENSOR_UNITS if name in listed}
    name = _word(table, "name", where)
    drive = _word(table, "drive", where) if "drive" in table else ""
    return Kit(name=name, drive=drive, sensors=sensors, motor=Motor(**motor), battery=Battery(**battery), **timing)


def _sensor(listed: Table, name: str, where: str) -> dict[str, float]:
    unit = _SENSOR_UNITS[name]
    units = dict.fromkeys(("quantum", "noise", "bias", "range"), (unit,))
    units |= {"bias_walk": (f"{unit}/√s",), "delay": ("s",), "period": ("s",)}
    return _numbers(listed, name, units, where, "sensors.")


def _numbers(
    table: Table, name: str, units: Mapping[str, tuple[str, ...]], where: str, prefix: str = ""
) -> dict[str, float]:
    inner = _subtable(table, name, where)
    _no_strangers(inner, units, where, f"{prefix}{name}.")
    for key in inner:
        _provenance(inner[key], f"{prefix}{name}.{key}", where)
    return {key: _number(inner[key], f"{prefix}{name}.{key}", units[key], where) for key in inner}


def _subtable(table: Table, name: str, where: str) -> Table:
    inner = table.get(name, {})
    if not isinstance(inner, dict):
        raise InvalidRobot(f"{where}: {name} is {inner!r}", expected=f"a table [{name}]")
    return cast(Table, inner)


def _word(table: Table, key: str, where: str) -> str:
    if not isinstance(table[key], str):
        raise InvalidRobot(f"{where}: {key} is {table[key]!r}", expected="text in quotes")
    return table[key]


def _number(table: Any, name: str, units: tuple[str, ...], where: str) -> float:
    expected = " or ".join(f"[{unit}]" for unit in units)
    if not isinstance(table, dict):
        hint = f'[{name}] value = {table}, unit = "{units[0]}"'
        raise InvalidRobot(
            f"{where}: {name} is {table!r}", expected=f"a table with value and unit {expected}", hint=hint
        )
    entry = cast(Table, table)
    _no_strangers(entry, _ONE_NUMBER, where, f"{name}.")
    for key in ("value", "unit"):
        if key not in entry:
            raise InvalidRobot(f"{where}: {name} has no {key}", expected=f"value and unit {expected}")
    if not isinstance(entry["unit"], str) or _spelt(entry["unit"]) not in units:
        _wrong_unit(entry["unit"], f"{where}: {name}", expected)
    if not _is_number(entry["value"]) or math.isnan(entry["value"]):
        raise InvalidRobot(f"{where}: {name} is {entry['value']!r}", expected=f"a number {expected}")
    return float(entry["value"])


def _wrong_unit(unit: Any, subject: str, expected: str) -> NoReturn:
    likely = _LIKELY.get(_spelt(unit), "") if isinstance(unit, str) else ""
    raise InvalidRobot(
        f"{subject} has unit {unit!r}", expected=expected, likely=likely, hint="convert the value by hand"
    )


def _spelt(unit: str) -> str:
    """The unit as this package writes it: m^2, N*m, Nm and ohm are other spellings, not other units."""
    unit = unicodedata.normalize("NFC", " ".join(unit.split()))
    for other, ours in (
        ("**2", "²"),
        ("^2", "²"),
        ("m2", "m²"),
        ("*", " "),
        ("·", " "),
        ("Nm", "N m"),
        ("sqrt(s)", "√s"),
    ):
        unit = unit.replace(other, ours)
    return "Ω" if unit.lower() in ("ohm", "ohms") else unit


def _provenance(table: Any, name: str, where: str) -> Provenance | None:
    """Source and spread of a number, or None where the file says neither."""
    entry = cast(Table, table) if isinstance(table, dict) else {}
    if "source" not in entry and "spread" not in entry:
        return None
    source, spread = entry.get("source", ""), entry.get("spread", "guess")
    if not isinstance(source, str):
        raise InvalidRobot(f"{where}: the source of {name} is {source!r}", expected="text in quotes")
    if spread == "guess":
        return Provenance(source)
    if not _is_number(spread) or not 0 <= spread < math.inf:
        expected = 'one standard deviation in the unit of the value, or "guess"'
        raise InvalidRobot(f"{where}: the spread of {name} is {spread!r}", expected=expected)
    return Provenance(source, float(spread))


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _no_strangers(table: Table, known: Iterable[str], where: str, prefix: str = "") -> None:
    names = sorted(known)
    for key in table:
        if key not in names:
            close = difflib.get_close_matches(key, names, n=1, cutoff=0.5)
            hint = f"did you mean '{prefix}{close[0]}'?" if close else ""
            expected = "one of " + ", ".join(names)
            raise InvalidRobot(f"{where}: unknown key '{prefix}{key}'", expected=expected, hint=hint)
