"""What the fields of messages may hold, and what makes a class a message."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated, Any, Literal, TypeVar, dataclass_transform

from annotated_types import Interval, MaxLen, Predicate

from upright.pages.blocks import Level

LONGEST_TEXT = 200
MOST_ITEMS = 64


Text = Annotated[str, MaxLen(LONGEST_TEXT), Predicate(str.isprintable)]
Number = Annotated[float, Interval(ge=-1e12, le=1e12)]
Whole = Annotated[int, Interval(ge=-(2**53), le=2**53)]
Numbers = Annotated[tuple[Number, ...], MaxLen(MOST_ITEMS)]
NamedNumbers = Annotated[dict[Text, Number], MaxLen(MOST_ITEMS)]

STRICT = {"extra": "forbid", "strict": True, "allow_inf_nan": False}
"""How pydantic reads these classes: nothing unknown, nothing converted, no NaN."""

Job = Literal["certify", "doctor", "calibrate", "design"]
Work = Literal[Job, "light"]
"""What is computed beside the loop: jobs that a page can start, and the light that follows every change."""

T = TypeVar("T")


@dataclass_transform(frozen_default=True)
def message(cls: type[T]) -> type[T]:
    """A frozen dataclass with a last field `kind`, the class's name, by which JSON tells messages apart."""
    name: Any = cls.__name__
    cls.__annotations__["kind"] = Literal[name]
    cls.kind, cls.__pydantic_config__ = name, STRICT  # type: ignore[attr-defined]
    return dataclass(frozen=True)(cls)


@message
class Acted:
    """The last `Strike` or `StandUp` acts from `t` [s] on."""

    t: float


@message
class Progress:
    """How far work is, from 0 to 1, and how many `runs` it has; 0 where it does not count them."""

    job: Work
    fraction: float
    runs: int = 0


@dataclass(frozen=True)
class Head:
    """The first screen of a page in one language: its title, its verdict and that one's level, the sentences of its
    lead, and its numbers, each with what it is."""

    title: str
    verdict: str = ""
    level: Level = "info"
    lead: tuple[str, ...] = ()
    numbers: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class ErrorParts:
    """An error in one language by its parts: what came, what was expected, what is likely, and what to try, a command
    of this `verb` or words."""

    came: str
    expected: str = ""
    likely: str = ""
    hint: str = ""
    verb: str = ""


@dataclass(frozen=True)
class FamilyInfo:
    """A controller family, and whether `largest` means anything to it."""

    name: str
    weights: bool


@dataclass(frozen=True)
class RobotInfo:
    """A robot to choose: its title by language, its own kit, and its numbers."""

    name: str
    title: dict[str, str]
    kit: str
    numbers: dict[str, float]


@dataclass(frozen=True)
class Student:
    """One line of the board: lean of the robot [rad], largest recovered push [N s], effort of the whole run [u² s]."""

    name: str
    pitch: float
    fallen: bool
    best: float
    effort: float
    here: bool
    controller: str
