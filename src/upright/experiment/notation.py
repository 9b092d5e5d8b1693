"""What is typed as `KIND:NUMBER,name=NUMBER`: pushes, references, states and ranges."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping, Sequence
from typing import Any

from upright.errors import InvalidScenario, UnknownName, check_within
from upright.experiment.pushes import Hold, Impulse, Push, Slope
from upright.experiment.references import Drive, Turn
from upright.signals import STATE_NAMES


def listed(text: str | None) -> list[str]:
    """The names of `NAME,NAME`, without spaces; none of nothing."""
    return [name.strip() for name in text.split(",")] if text else []


def number(text: str, where: str) -> float:
    """A finite number, or `InvalidScenario` naming the option."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise InvalidScenario(f"{where}: '{text.strip()}'", expected="a finite number")
    return value


def named_numbers(text: str, names: Sequence[str], option: str, bare: str = "") -> dict[str, float]:
    """`name=NUMBER,name=NUMBER` as a dictionary; a first number without a name belongs to `bare`."""
    values: dict[str, float] = {}
    for index, part in enumerate(text.split(",")):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not equals and bare and index == 0:
            name, value = bare, name
        elif not equals:
            raise InvalidScenario(f"{option}: '{part}'", expected=f"name=NUMBER, with a name of {', '.join(names)}")
        if name not in names:
            raise UnknownName(f"entry of {option}", name, names)
        if name in values:
            raise InvalidScenario(f"{option}: {name} is given twice", expected="each name once")
        values[name] = number(value, f"{option} {name}")
    return values


def named_values(text: str, option: str) -> dict[str, float | str]:
    """`name=VALUE,name=VALUE` as a dictionary, numbers as such and other words as text."""
    values: dict[str, float | str] = {}
    for part in text.split(","):
        name, equals, value = (piece.strip() for piece in part.partition("="))
        if not (equals and name and value):
            raise InvalidScenario(f"{option}: '{part}'", expected="name=VALUE")
        if name in values:
            raise InvalidScenario(f"{option}: {name} is given twice", expected="each name once")
        try:
            values[name] = float(value)
        except ValueError:
            values[name] = value
    return values


def is_number(value: Any) -> bool:
    """Whether what a file holds is a finite number."""
    return isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)


def _numbers(given: str | Mapping[str, Any], names: Sequence[str], option: str, bare: str = "") -> dict[str, float]:
    """Numbers by name, as they are typed or as a file holds them."""
    if isinstance(given, str):
        return named_numbers(given, names, option, bare)
    for name, value in given.items():
        if name not in names:
            raise UnknownName(f"entry of {option}", name, names)
        if not is_number(value):
            raise InvalidScenario(f"{option} {name}: {value!r}", expected="a finite number")
    return {name: float(value) for name, value in given.items()}


def vector(given: str | Mapping[str, Any], names: Sequence[str], option: str) -> list[float]:
    """`name=NUMBER,…`, or a mapping, as one number for each of `names`; the others are zero."""
    numbers = _numbers(given, names, option) if given else {}
    return [numbers.get(name, 0.0) for name in names]


def first_state(given: str | Mapping[str, Any], option: str) -> tuple[float, ...]:
    """The state (6,) at which a run starts, as in `vector`: at most lying."""
    state = dict(zip(STATE_NAMES, vector(given, STATE_NAMES, option), strict=True))
    check_within(f"rad of pitch in {option}", state["pitch"], -math.pi / 2, math.pi / 2)
    return tuple(state.values())


def programme(kind: Any, given: str | Mapping[str, Any], option: str) -> Any:
    """A push or reference from `NUMBER,name=NUMBER,…`, or a mapping, whose names are the fields of the dataclass
    `kind`."""
    fields = dataclasses.fields(kind)
    names = [f.name for f in fields]
    values = _numbers(given, names, option, bare=names[0])
    absent = [f.name for f in fields if f.default is dataclasses.MISSING and f.name not in values]
    if absent:
        raise InvalidScenario(f"{option} lacks {', '.join(absent)}", expected=f"{absent[0]}=NUMBER as well")
    return kind(**values)


def pushes_and_references(
    pushed: Sequence[str] | None, drive: str | None, turn: str | None, slope: str | None = None
) -> tuple[list[Any], list[Any]]:
    """The pushes and references of a command's options."""
    pushes = [push(text) for text in pushed or ()] + ([programme(Slope, slope, "--slope")] if slope else [])
    asked = ((Drive, drive, "--drive"), (Turn, turn, "--turn"))
    return pushes, [programme(kind, text, option) for kind, text, option in asked if text]


def push(text: str) -> Any:
    """A push from `KIND:NUMBER,name=NUMBER,…`, where KIND is hold, force or impulse."""
    kinds = {"hold": Hold, "force": Push, "impulse": Impulse}
    kind, colon, rest = text.partition(":")
    if not colon:
        raise InvalidScenario(
            f"--push '{text}'", expected="KIND:NUMBER,name=NUMBER", hint="for example hold:0.1,until=1"
        )
    if kind.strip() not in kinds:
        raise UnknownName("push", kind.strip(), kinds)
    return programme(kinds[kind.strip()], rest, f"--push {kind.strip()}")


def limits(text: str, option: str) -> tuple[float, float]:
    """LOW..HIGH as two numbers."""
    low, dots, high = text.partition("..")
    if not dots:
        raise InvalidScenario(f"{option} '{text}'", expected="LOW..HIGH, such as 0..0.1")
    return number(low, option), number(high, option)
