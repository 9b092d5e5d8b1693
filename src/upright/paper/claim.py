"""The result of reproducing one claim of the paper."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field
from typing import Any

from upright.pages import Block, Cell, Fold, Result, Say, Verdict
from upright.signals import Log

REPRODUCED = "reproduced"
IN_PART = "reproduced in part"
NOT_AS_PRINTED = "not as printed"
UNKNOWN = "unknown"
BEYOND = "beyond the paper"

BADGES = {
    REPRODUCED: Verdict(Say("reproduced"), "good"),
    IN_PART: Verdict(Say("in part"), "warn"),
    NOT_AS_PRINTED: Verdict(Say("not as printed"), "bad"),
    UNKNOWN: Verdict(Say("unknown"), "unknown"),
    BEYOND: Verdict(Say("beyond the paper")),
}


def agreed(holds: Iterable[bool | None]) -> bool | None:
    """Whether something holds in repeated runs: None where it does in some only, so that their noise decides, or where
    that is unknown of one."""
    every = set(holds)
    return every.pop() if len(every) == 1 else None


def judged(holds: Iterable[bool | None]) -> str:
    """The verdict on a claim that says several things, by which of them hold: all, some, or none; None is unknown.

    >>> judged([True, False, None]), judged([True, None])
    ('reproduced in part', 'unknown')
    """
    every = set(holds)
    if every >= {True, False}:
        return IN_PART
    if None in every:
        return UNKNOWN
    return REPRODUCED if True in every else NOT_AS_PRINTED


@dataclass(frozen=True, eq=False)
class Claim:
    """One claim: `part` of the paper, `title`, `verdict`, a `summary`, and the evidence.

    `numbers` are plain JSON; `blocks` what the page shows of them; `logs` the runs behind it, by file name without
    suffix; `result` stands beside the verdict in the table of claims, in two or three words.
    """

    part: str
    title: Say
    verdict: str
    summary: Say
    numbers: Mapping[str, Any]
    blocks: Sequence[Block] = ()
    logs: Mapping[str, Log] = field(default_factory=dict[str, Log])
    _: KW_ONLY
    result: Cell = None

    def to_json(self) -> dict[str, Any]:
        """Everything but what the page shows; of the logs their names."""
        named = {"part": self.part, "title": str(self.title), "verdict": self.verdict, "summary": str(self.summary)}
        return {**named, "numbers": dict(self.numbers), "logs": sorted(self.logs)}


def shown_of(result: Result) -> list[Block]:
    """What the page of another result shows below its head: its picture and what is not folded."""
    page = result.page()
    picture = [page.picture] if page.picture else []
    return [*picture, *(block for block in page.blocks if not isinstance(block, Fold))]
