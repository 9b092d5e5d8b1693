"""The head of a result: verdict, at most three numbers and what to run next; the same on page, terminal and in JSON."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Sequence
from dataclasses import dataclass

from upright.errors import UnknownName

LEVELS = ("good", "warn", "bad", "info")
MOST = 3  # numbers that are read before the rest is skipped
WIDTH = 80  # columns of a plain terminal


@dataclass(frozen=True)
class Verdict:
    """A badge: a short `text` and its `level`: "good" (green: it holds), "warn" (amber: take care), "bad" (red: it does
    not hold) or "info" (blue: neither)."""

    text: str
    level: str = "info"

    def __post_init__(self) -> None:
        if self.level not in LEVELS:
            raise UnknownName("level of a verdict", self.level, LEVELS)


@dataclass(frozen=True)
class Head:
    """What comes first: the `verdict`, the `title` that says what was found, `numbers` each with what it is, and what
    to run `next`."""

    title: str
    verdict: Verdict | None
    numbers: Sequence[tuple[str, str]]
    next: str

    def text(self, width: int = WIDTH) -> str:
        """The head for a terminal, the verdict as its first line."""
        wide = max((len(value) for value, _ in self.numbers), default=0)
        numbers = [f"  {value:<{wide}}  {meaning}" for value, meaning in self.numbers]
        lines = [
            self.verdict and f"Verdict: {self.verdict.text}",
            self.title,
            *numbers,
            self.next and f"Next: {self.next}",
        ]
        most = max(40, min(width, WIDTH))
        return "\n".join(_wrapped(line, most, wide + 4 if line in numbers else 2) for line in lines if line)


def _wrapped(line: str, width: int, indent: int) -> str:
    """The line in `width` columns; a command that fits into a line of its own stays whole, to be copied."""
    room = width - indent
    whole = re.sub(r"`[^`]*`\S?", lambda m: m[0].replace(" ", "\0") if len(m[0]) <= room else m[0], line)
    lines = textwrap.wrap(whole, width, subsequent_indent=" " * indent, break_on_hyphens=False, break_long_words=False)
    return "\n".join(lines).replace("\0", " ")
