"""The grammar of a page: what every result is shown with, on a terminal, in a browser, a notebook and the lab."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field
from typing import TYPE_CHECKING, Any, Literal

from upright.pages.words import Quantity, Say

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Level = Literal["good", "warn", "bad", "unknown", "info"]

MOST_NUMBERS = 3  # that are read before the rest is skipped
MOST_LEAD = 2  # sentences
MOST_TITLES = 4  # headings below the first screen


@dataclass(frozen=True)
class Verdict:
    """What was found, in a few words, and its `level`: green, amber, red, unknown, or neither ("info")."""

    text: Say
    level: Level = "info"


@dataclass(frozen=True)
class KeyNumber:
    """One of the numbers that matter, and what it is."""

    value: Quantity | Say | int
    meaning: Say


@dataclass(frozen=True)
class Picture:
    """A drawing under the `claim` that it shows. `draw` is called for each rendering, so that its letters are in the
    language of the reader and its width is that of the screen (`upright.plotting.width`)."""

    claim: Say
    draw: Callable[[], Figure]
    note: Say | None = None


@dataclass(frozen=True)
class Column:
    """A column's `name`, and the SI `unit` of its floats, which are shown with equal decimals of `digits` digits."""

    name: Say
    unit: str = ""
    digits: int = 3


Cell = Say | Quantity | Verdict | str | float | int | bool | None


@dataclass(frozen=True)
class Table:
    """Rows under `columns`, the most important first: a terminal leaves out the last ones where they do not fit.

    A string is a name, and stays as it is. Raises `ValueError` for a row of another length.
    """

    columns: Sequence[Column]
    rows: Sequence[Sequence[Cell]]
    caption: Say | None = None

    def __post_init__(self) -> None:
        for row in self.rows:
            if len(row) != len(self.columns):
                raise ValueError(f"a row of {len(row)} cells under {len(self.columns)} columns: {row}")


@dataclass(frozen=True)
class Items:
    """Short reservations or findings, one line each."""

    items: Sequence[Say]


@dataclass(frozen=True)
class Fold:
    """Blocks behind a `heading` that is pressed to show them; a terminal leaves them out."""

    heading: Say
    blocks: Sequence[Block]


@dataclass(frozen=True)
class Next:
    """What to run next: a `verb`, what it takes first, and its options by the names of the library function.

    `Next("certify", "lqr.json", robot="mine.toml")` is `upright certify lqr.json --robot mine.toml`.
    """

    verb: str
    given: Sequence[str]
    options: Mapping[str, str]
    why: Say | None

    def __init__(self, verb: str, *given: str, why: Say | None = None, **options: object) -> None:
        object.__setattr__(self, "verb", verb)
        object.__setattr__(self, "given", given)
        object.__setattr__(self, "options", {name: str(value) for name, value in options.items() if value is not None})
        object.__setattr__(self, "why", why)

    def __str__(self) -> str:
        return f"`{self.command}`"

    @property
    def command(self) -> str:
        """The line to type."""
        words = ["upright", self.verb.replace("_", "-"), *map(shlex.quote, self.given)]
        for name, value in self.options.items():
            words += [f"--{name.replace('_', '-')}", *([shlex.quote(value)] if value != "True" else [])]
        return " ".join(words)


def is_placeholder(word: str) -> bool:
    """Whether a word of a command stands for what the reader has: LOG, MEASURED.toml."""
    return word.partition(".")[0].isupper()


Block = Say | Table | Picture | Items | Fold


@dataclass(frozen=True)
class Page:
    """A result for people. The first screen is verdict, title, lead, at most three numbers, a picture and what to do
    next; `blocks` follow. `origin` (robot, controller, seed, versions) is its foot.

    Raises `ValueError` where it says more than a reader takes in.
    """

    title: Say
    _: KW_ONLY
    verdict: Verdict | None = None
    lead: Sequence[Say] = ()
    numbers: Sequence[KeyNumber] = ()
    picture: Picture | None = None
    next: Sequence[Next] = ()
    blocks: Sequence[Block] = ()
    origin: Mapping[str, str] = field(default_factory=dict[str, str])

    def __post_init__(self) -> None:
        folds = [block for block in self.blocks if isinstance(block, Fold)]
        for what, count, most in (
            ("numbers", len(self.numbers), MOST_NUMBERS),
            ("sentences of its lead", len(self.lead), MOST_LEAD),
            ("folds", len(folds), MOST_TITLES),
        ):
            if count > most:
                raise ValueError(f"page '{self.title.template}' has {count} {what}; at most {most}")

    def head(self) -> dict[str, Any]:
        """What JSON begins with."""
        return {
            "title": str(self.title),
            "verdict": {"text": str(self.verdict.text), "level": self.verdict.level} if self.verdict else None,
            "numbers": [[str(number.value), str(number.meaning)] for number in self.numbers],
            "next": [step.command for step in self.next],
        }
