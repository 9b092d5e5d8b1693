"""Tables in TOML whose numbers carry a unit, a source, and a spread or the word "guess"; robots and kits are such."""

from __future__ import annotations

import json
import math
import unicodedata
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from importlib import resources
from pathlib import Path
from typing import Any, NoReturn, cast

from upright.errors import InvalidRobot, UnknownName, meant
from upright.reading import parse_toml, read_toml

Table = Mapping[str, Any]

LONGEST_NAME = 40

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
_SPELLINGS = {"**2": "²", "^2": "²", "m2": "m²", "*": " ", "·": " ", "Nm": "N m", "sqrt(s)": "√s"}


@dataclass(frozen=True)
class Provenance:
    """Where a number comes from: `source` in words, and `spread`, one standard deviation in the number's unit.

    A `spread` of None marks a guess.
    """

    source: str
    spread: float | None = None


def names(folder: str) -> tuple[str, ...]:
    """Names of the files in a folder of this room, sorted."""
    files = (entry.name for entry in resources.files("upright.robots").joinpath(folder).iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in files if name.endswith(".toml")))


def shipped(kind: str, folder: str, name: str) -> tuple[Table, str]:
    """The table of that preset and what messages call it; raises `UnknownName`."""
    if name not in names(folder):
        raise UnknownName(kind, name, names(folder))
    text = resources.files("upright.robots").joinpath(folder, f"{name}.toml").read_text(encoding="utf-8")
    where = f"{kind} preset {name}"
    return parse_toml(text, where, InvalidRobot, "tables like [wheel_radius] value = 0.04"), where


def read(kind: str, path: str | Path) -> tuple[Table, str]:
    """The table in the file `path` and what messages call it; raises `InvalidRobot` for a file that cannot be read."""
    return read_toml(path, InvalidRobot, f"a {kind} file in TOML"), str(path)


def is_path(name_or_path: str | Path) -> bool:
    """Whether this is a path to a TOML file; raises `InvalidRobot` for another path."""
    if isinstance(name_or_path, Path) or name_or_path.endswith(".toml"):
        return True
    if "/" in name_or_path or "\\" in name_or_path:
        raise InvalidRobot(f"'{name_or_path}' is no preset", expected="a preset's name or a path that ends in .toml")
    return False


def numbers(
    table: Table, name: str, units: Mapping[str, tuple[str, ...]], where: str, prefix: str = ""
) -> dict[str, float]:
    """The numbers of the table `name` by key; `units` has every possible key with its units."""
    inner = subtable(table, name, where)
    check_keys(inner, units, where, f"{prefix}{name}.")
    for key in inner:
        provenance(inner[key], f"{prefix}{name}.{key}", where)
    return {key: number(inner[key], f"{prefix}{name}.{key}", units[key], where) for key in inner}


def subtable(table: Table, name: str, where: str) -> Table:
    """The table `name` inside a table; empty where there is none."""
    inner = table.get(name, {})
    if not isinstance(inner, dict):
        raise InvalidRobot(f"{where}: {name} is {inner!r}", expected=f"a table [{name}]")
    return cast(Table, inner)


def word(table: Table, key: str, where: str) -> str:
    """The text under `key`."""
    if not isinstance(table[key], str):
        raise InvalidRobot(f"{where}: {key} is {table[key]!r}", expected="text in quotes")
    return table[key]


def checked_name(name: Any, kind: str) -> str:
    """The `name` of a robot or a kit, in NFC: 1 to `LONGEST_NAME` letters and digits of any script, blanks and `-_.`.

    Raises `InvalidRobot` for others, which could not be used unchanged in programs, file names and pages.
    """
    text = unicodedata.normalize("NFC", name) if isinstance(name, str) else ""
    plain = all(c in "-_. " or unicodedata.category(c)[0] in "LMN" for c in text)
    if not (plain and 0 < len(text) <= LONGEST_NAME and text == text.strip()):
        expected = f"1 to {LONGEST_NAME} letters, digits, blanks and -_. in it"
        raise InvalidRobot(f"the name of a {kind} is {name!a:.60}", expected=expected, hint=f'name = "my-{kind}"')
    return text


def number(table: Any, name: str, units: tuple[str, ...], where: str) -> float:
    """The value of one number's table, which must state one of `units`."""
    expected = " or ".join(f"[{unit}]" for unit in units)
    if not isinstance(table, dict):
        hint = f'[{name}] value = {table}, unit = "{units[0]}"'
        raise InvalidRobot(
            f"{where}: {name} is {table!r}", expected=f"a table with value and unit {expected}", hint=hint
        )
    entry = cast(Table, table)
    check_keys(entry, _ONE_NUMBER, where, f"{name}.")
    for key in ("value", "unit"):
        if key not in entry:
            raise InvalidRobot(f"{where}: {name} has no {key}", expected=f"value and unit {expected}")
    if not isinstance(entry["unit"], str) or _spelt(entry["unit"]) not in units:
        _wrong_unit(entry["unit"], f"{where}: {name}", expected)
    if not is_number(entry["value"]) or math.isnan(entry["value"]):
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
    for other, ours in _SPELLINGS.items():
        unit = unit.replace(other, ours)
    return "Ω" if unit.lower() in ("ohm", "ohms") else unit


def provenance(table: Any, name: str, where: str) -> Provenance | None:
    """Source and spread of a number, or None where the file says neither."""
    entry = cast(Table, table) if isinstance(table, dict) else {}
    if "source" not in entry and "spread" not in entry:
        return None
    source, spread = entry.get("source", ""), entry.get("spread", "guess")
    if not isinstance(source, str):
        raise InvalidRobot(f"{where}: the source of {name} is {source!r}", expected="text in quotes")
    if spread == "guess":
        return Provenance(source)
    if not is_number(spread) or not 0 <= spread < math.inf:
        expected = 'one standard deviation in the unit of the value, or "guess"'
        raise InvalidRobot(f"{where}: the spread of {name} is {spread!r}", expected=expected)
    return Provenance(source, float(spread))


def is_number(value: Any) -> bool:
    """Whether a value of TOML is a number and not a truth value."""
    return isinstance(value, int | float) and not isinstance(value, bool)


def check_keys(table: Table, known: Iterable[str], where: str, prefix: str = "") -> None:
    """Raise `InvalidRobot` for a key that is not `known`."""
    keys = sorted(known)
    for key in table:
        if key not in keys:
            hint = meant(key, keys, f"{prefix}{{}}")
            expected = "one of " + ", ".join(keys)
            raise InvalidRobot(f"{where}: unknown key '{prefix}{key:.80}'", expected=expected, hint=hint)


def quoted(text: str) -> str:
    """The text as TOML writes it."""
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
