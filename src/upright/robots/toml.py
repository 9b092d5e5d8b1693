"""Tables in TOML whose numbers carry a unit, a source, and a spread or the word "guess"; robots and kits are such."""

from __future__ import annotations

import json
import math
import unicodedata
from collections.abc import Callable, Iterable, Mapping
from dataclasses import MISSING, dataclass, field, fields
from importlib import resources
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple, cast

from upright.errors import InvalidRobot, UnknownName, meant
from upright.reading import parse_toml, read_toml
from upright.signals.signal import Signal

Table = Mapping[str, Any]

NONE: Mapping[str, Any] = MappingProxyType({})
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


def quantity(unit: str, default: float | None = None, meaning: str = "", *, only: str = "", symbol: str = "") -> Any:
    """A field of a part, whose number a file states as a table in this `unit`, or in another one of "V or N m".

    A number without `default` is required. "{}" in the unit is that of the sensor's channel, and `only` the one sensor
    that has this number. `meaning` says what the number is, and is written above it in a file for its owner.
    """
    metadata = {"unit": unit, "meaning": meaning, "only": only, "symbol": symbol}
    return field(metadata=metadata) if default is None else field(default=default, metadata=metadata)


class Meaning(NamedTuple):
    """The units in which a number may be stated, the first when it is written, and what it means."""

    units: tuple[str, ...]
    meaning: str


def quantities(kind: Any, signal: Signal | None = None) -> dict[str, Meaning]:
    """The numbers of a part by name; of a sensor, those that there are of its `signal`."""
    channel, unit = (signal.name, signal.unit) if signal else ("", "")
    return {
        f.name: Meaning(tuple(f.metadata["unit"].format(unit).split(" or ")), f.metadata["meaning"])
        for f in fields(kind)
        if f.metadata and f.metadata["only"] in ("", channel)
    }


def read_part(
    kind: Any,
    table: Table,
    where: str,
    prefix: str = "",
    *,
    signal: Signal | None = None,
    others: Iterable[str] = (),
) -> tuple[dict[str, Any], dict[str, Provenance]]:
    """The words and numbers of a part by name, as its `table` states them, and where the numbers come from.

    `prefix` is what messages put before a name. The part has the `quantities` of its class, and its words are the
    fields that may be text; the table may have keys that somebody else reads, the `others`. Raises `InvalidRobot`.
    """
    numbers = quantities(kind, signal)
    words = [f.name for f in fields(kind) if f.type.startswith("str") and f.name not in others]
    check_keys(table, (*words, *numbers, *others), where, prefix)
    required = {f.name for f in fields(kind) if f.default is f.default_factory is MISSING}
    if missing := sorted(required - table.keys()):
        first = missing[0]
        hint = f'[{first}] value = …, unit = "{numbers[first].units[0]}"' if first in numbers else f'{first} = "my-own"'
        raise InvalidRobot(f"{where} lacks {', '.join(missing)}", expected="every required entry", hint=hint)
    values: dict[str, Any] = {key: _entry(table[key], TEXT, prefix + key, where) for key in words if key in table}
    sources: dict[str, Provenance] = {}
    for key, (units, _) in numbers.items():
        if key in table:
            values[key] = number(table[key], prefix + key, units, where)
            source = provenance(table[key], prefix + key, where)
            if source:
                sources[key] = source
    return values, sources


def part_text(part: Any, name: str = "", signal: Signal | None = None, sources: Mapping[str, Provenance] = NONE) -> str:
    """The text of which `read_part` makes this part, as the table `name`: its words, and the numbers that differ from
    their defaults or have a source."""
    words = {f.name: getattr(part, f.name) for f in fields(part) if isinstance(getattr(part, f.name), str)}
    text = rows(f"[{name}]" if name else "", {key: value for key, value in words.items() if value})
    defaults = {f.name: f.default for f in fields(part)}
    for key, (units, _) in quantities(part, signal).items():
        value = getattr(part, key)
        if value != defaults[key] or key in sources:
            text += number_text(f"{name}.{key}" if name else key, value, units[0], sources.get(key))
    return text


def number_text(name: str, value: float, unit: str, source: Provenance | None = None) -> str:
    """One number as a table."""
    entries: dict[str, Any] = {"value": float(value), "unit": unit}
    if source is not None:
        entries |= {"source": source.source, "spread": "guess" if source.spread is None else float(source.spread)}
    return rows(f"[{name}]", entries)


def rows(head: str, entries: Mapping[str, Any]) -> str:
    """A table with this `head`, "" for the file's own begin; nothing where it has no entries."""
    lines = [f"{key} = {quoted(v) if isinstance(v, str) else repr(v)}\n" for key, v in entries.items()]
    return "".join([f"\n{head}\n" if head else "", *lines]) if lines else ""


@dataclass(frozen=True)
class BareEntry:
    """What a bare entry of a table has to be, in words and as a test."""

    expected: str
    fits: Callable[[Any], bool]


def is_number(value: Any) -> bool:
    """Whether a value of TOML is a number and not a truth value."""
    return isinstance(value, int | float) and not isinstance(value, bool)


TEXT = BareEntry("text in quotes", lambda value: isinstance(value, str))
NUMBER = BareEntry("a finite number", lambda value: is_number(value) and math.isfinite(value))
POSITIVE = BareEntry("a positive number", lambda value: is_number(value) and 0 < value < math.inf)


def row(
    table: Any,
    name: str,
    where: str,
    entries: Mapping[str, BareEntry],
    rest: BareEntry | None = None,
    complete: str = "",
) -> dict[str, Any]:
    """The bare entries of the table `name`: what `entries` says, and any others as `rest` does.

    None of the `entries` may be absent where `complete` says in words what is expected. Raises `InvalidRobot`.
    """
    inner = as_table(table, name, where)
    if rest is None:
        check_keys(inner, entries, where, f"{name}.")
    missing = [key for key in entries if key not in inner]
    if missing and complete:
        raise InvalidRobot(f"{where}: {name} lacks {', '.join(missing)}", expected=complete)
    return {key: _entry(value, entries.get(key, rest), f"{name}.{key}", where) for key, value in inner.items()}


def _entry(value: Any, entry: BareEntry | None, name: str, where: str) -> Any:
    if entry is not None and not entry.fits(value):
        raise InvalidRobot(f"{where}: {name} is {value!r:.80}", expected=entry.expected)
    return float(value) if is_number(value) else value


def as_table(value: Any, name: str, where: str) -> Table:
    """The value of the name, which has to be a table."""
    if not isinstance(value, dict):
        raise InvalidRobot(f"{where}: {name} is {value!r:.80}", expected=f"a table [{name}]")
    return cast(Table, value)


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
    check_unit(entry["unit"], units, f"{where}: {name}")
    if not is_number(entry["value"]) or math.isnan(entry["value"]):
        raise InvalidRobot(f"{where}: {name} is {entry['value']!r}", expected=f"a number {expected}")
    return float(entry["value"])


def check_unit(unit: Any, units: tuple[str, ...], subject: str) -> None:
    """Raise `InvalidRobot` for a `unit` that is no spelling of one of the `units`."""
    spelt = _spelt(unit) if isinstance(unit, str) else ""
    if spelt not in units:
        expected = " or ".join(f"[{one}]" for one in units)
        hint = "convert the value by hand"
        raise InvalidRobot(f"{subject} has unit {unit!r}", expected=expected, likely=_LIKELY.get(spelt, ""), hint=hint)


def _spelt(unit: str) -> str:
    """The unit as this package writes it: m^2, N*m, Nm and ohm are other spellings, not other units."""
    unit = unicodedata.normalize("NFC", " ".join(unit.split()))
    for other, ours in _SPELLINGS.items():
        unit = unit.replace(other, ours)
    return "Ω" if unit.lower() in ("ohm", "ohms") else unit


def provenance(entry: Table, name: str, where: str) -> Provenance | None:
    """Source and spread of a number, or None where the file says neither."""
    if "source" not in entry and "spread" not in entry:
        return None
    source, spread = entry.get("source", ""), entry.get("spread", "guess")
    _entry(source, TEXT, f"the source of {name}", where)
    if spread == "guess":
        return Provenance(source)
    if not is_number(spread) or not 0 <= spread < math.inf:
        expected = 'one standard deviation in the unit of the value, or "guess"'
        raise InvalidRobot(f"{where}: the spread of {name} is {spread!r}", expected=expected)
    return Provenance(source, float(spread))


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
