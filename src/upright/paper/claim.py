"""The result of reproducing one claim of the paper."""

from __future__ import annotations

import itertools
import textwrap
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field
from typing import Any

from upright.reports import Details, Figure, Section, Table, Verdict
from upright.reports.page import Item
from upright.signals import Log
from upright.tables import sentence

REPRODUCED = "reproduced"
NOT_AS_PRINTED = "not as printed"
BEYOND = "beyond the paper"

SHORT = 6  # rows of a table that is shown without being asked for

IN_PART = "reproduced in part"  # some of what the claim says holds, or all of it with an aside

LEVEL_OF = {REPRODUCED: "good", IN_PART: "warn", NOT_AS_PRINTED: "bad", BEYOND: "info"}


def judged(holds: Iterable[bool]) -> str:
    """The verdict on a claim that says several things, by which of them hold: all, some, or none.

    >>> judged([True, False])
    'reproduced in part'
    """
    every = set(holds)
    return REPRODUCED if False not in every else IN_PART if True in every else NOT_AS_PRINTED


@dataclass(frozen=True, eq=False)
class Claim:
    """One claim: `part` of the paper, `title`, `verdict`, a `summary` with its numbers, and the evidence.

    `numbers` are plain JSON; `items` the figures and tables of the page;
    `logs` the runs behind it, by file name without suffix. `aside` says what holds of a claim that holds in part.
    """

    part: str
    title: str
    verdict: str
    summary: str
    numbers: Mapping[str, Any]
    items: Sequence[Item] = ()
    logs: Mapping[str, Log] = field(default_factory=dict[str, Log])
    _: KW_ONLY
    aside: str = ""

    @property
    def badge(self) -> Verdict:
        """The verdict as a page shows it."""
        return Verdict(self.says, LEVEL_OF[self.says])

    @property
    def says(self) -> str:
        """The verdict in words, the same on the page and in the terminal."""
        return IN_PART if self.aside and self.verdict == REPRODUCED else self.verdict

    @property
    def first(self) -> str:
        """What holds of a claim that holds in part, and the first sentence of the summary."""
        return " ".join([*self._aside(), f"{self.summary.partition('. ')[0].rstrip('.')}."])

    def _aside(self) -> list[str]:
        return [sentence(self.aside)] if self.aside and self.says == IN_PART else []

    def why(self, width: int) -> str:
        """The first sentence of the summary, indented and wrapped to `width` columns."""
        return textwrap.fill(self.first, width, initial_indent="    ", subsequent_indent="    ")

    def section(self, name: str = "") -> Section:
        """The claim as a folded section of the page, by its `name` in the contents, with its `first` sentence under the
        heading: the figures that come first, or else the first, or a short table; the rest is folded once more."""
        figures = [item for item in self.items if isinstance(item, Figure)]
        short = [item for item in self.items[:1] if isinstance(item, Table) and len(item.rows) <= SHORT]
        leading = itertools.takewhile(lambda item: isinstance(item, Figure), self.items)
        shown = list(leading) or figures[:1] or short
        rest = [item for item in self.items if item not in shown]
        folded = [Details("Tables, figures and derivations", rest, printed=False)] if rest else []
        more = self.summary.partition(". ")[2]
        items = [*([more] if more else []), *shown, *folded]
        named = f"{self.part} {name}".rstrip()
        return Section(f"{self.part} {self.title}", items, self.badge, folded=True, name=named, brief=self.first)

    def to_json(self) -> dict[str, Any]:
        named = {"part": self.part, "title": self.title, "verdict": self.says, "aside": self.aside}
        return {**named, "summary": self.summary, "numbers": dict(self.numbers), "logs": sorted(self.logs)}
