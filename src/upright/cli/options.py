"""What several commands parse alike: options, and the small language `KIND:NUMBER,name=NUMBER`."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any

import typer

from upright.errors import InvalidController, InvalidScenario, UnknownName

RobotOption = Annotated[str, typer.Option("--robot", "-r", help="A robot by name (see `upright robots`) or TOML file.")]
JsonOption = Annotated[bool, typer.Option("--json", help="Print JSON for programs.")]

PUSH_HELP = (
    "What pushes the robot, repeatable; they add up. hold:RAD,until=S keeps the pitch and lets go; "
    "force:N,start=S,duration=S pushes; impulse:NS,start=S knocks. Each takes height=M above the axle "
    "(default: the centre of mass)."
)


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


def vector(text: str, names: Sequence[str], option: str) -> list[float]:
    """`name=NUMBER,…` as one number for each of `names`, zero where it is not given."""
    given = named_numbers(text, names, option) if text else {}
    return [given.get(name, 0.0) for name in names]


def programme(kind: Any, text: str, option: str) -> Any:
    """A push or reference from `NUMBER,name=NUMBER,…`, whose names are the fields of the dataclass `kind`."""
    fields = dataclasses.fields(kind)
    values = named_numbers(text, [f.name for f in fields], option, bare=fields[0].name)
    absent = [f.name for f in fields if f.default is dataclasses.MISSING and f.name not in values]
    if absent:
        raise InvalidScenario(f"{option}: '{text}' lacks {', '.join(absent)}", expected=f"{absent[0]}=NUMBER as well")
    return kind(**values)


def push(text: str) -> Any:
    """A push from `KIND:NUMBER,name=NUMBER,…`, where KIND is hold, force or impulse."""
    from upright.experiment import Hold, Impulse, Push

    kinds = {"hold": Hold, "force": Push, "impulse": Impulse}
    kind, colon, rest = text.partition(":")
    if not colon:
        raise InvalidScenario(
            f"--push '{text}'", expected="KIND:NUMBER,name=NUMBER", hint="for example hold:0.1,until=1"
        )
    if kind.strip() not in kinds:
        raise UnknownName("push", kind.strip(), kinds)
    rest = rest.replace("at_time=", "start=")  # what an impulse's start was called in older scripts
    return programme(kinds[kind.strip()], rest, f"--push {kind.strip()}")


def program_text(path: Path) -> str:
    """A program that upright firmware wrote, refused with `InvalidController` where it is no text."""
    try:
        return path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        raise InvalidController(f"{path} is no text", expected="a program by upright firmware") from None
