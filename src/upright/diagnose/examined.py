"""What a post-mortem found, as data."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass, field, fields
from typing import Any

from upright.atomic import finite
from upright.diagnose.causes import CANNOT_TELL, NO_FALL, Cause
from upright.diagnose.series import Series
from upright.pages import Say, english, facts_of

SCHEMA = "upright/post-mortem/2"


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class FallExamined:
    """Why a robot fell: the `verdict` is the likeliest of `causes`, "it did not fall" or "cannot tell".

    `fell_at` is when its lean passed `STOP` for good, `onset` when the trouble began [s] (NaN where there is none);
    `missing` names what the log would have to hold for more. `misfit` is the size of the innovations before the fall
    over that which the given robot's model expects (NaN: unknown). `series` are the last seconds, for drawing.
    """

    verdict: str
    causes: tuple[Cause, ...]
    robot: str
    kit: str
    controller: str
    hash: str
    fell_at: float
    onset: float
    rows: int
    missing: tuple[Say, ...]
    notes: tuple[Say, ...]
    series: Series = field(repr=False)
    misfit: float = math.nan
    source: str = ""

    @property
    def fell(self) -> bool:
        """Whether the robot fell."""
        return math.isfinite(self.fell_at)

    def check(self) -> list[str]:
        """What in the result contradicts itself, in words; empty where nothing does."""
        odds = [cause.likelihood for cause in self.causes]
        first = self.causes[0].name if self.causes else CANNOT_TELL if self.missing else NO_FALL
        wrong = [f"the verdict is '{self.verdict}' but the likeliest is '{first}'"] if self.verdict != first else []
        wrong += ["the causes are not in order"] if odds != sorted(odds, reverse=True) else []
        wrong += [f"the likelihoods sum to {sum(odds):.3f}"] if odds and abs(sum(odds) - 1) > 1e-6 else []
        wrong += ["a cause stands beside no fall"] if self.causes and not self.fell else []
        after = self.fell and self.onset > self.fell_at
        return wrong + ([f"the trouble begins at {self.onset:g} s, after the fall"] if after else [])

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; None for what is not known."""
        numbers = {f.name: finite(getattr(self, f.name)) for f in fields(self) if f.name not in _SENTENCES}
        sentences = {"missing": [*map(english, self.missing)], "notes": [*map(english, self.notes)]}
        causes = [_cause(cause) for cause in self.causes]
        return {"schema": SCHEMA} | numbers | sentences | {"causes": causes, "series": self.series.to_json()}


_SENTENCES = ("causes", "series", "missing", "notes")


def _cause(cause: Cause) -> dict[str, Any]:
    """With its evidence and repairs in English, and the facts of the evidence."""
    return {
        "name": cause.name,
        "likelihood": cause.likelihood,
        "onset": finite(cause.onset),
        "evidence": english(cause.evidence),
        "facts": facts_of(cause.evidence),
        "push": cause.push and {name: finite(value) for name, value in asdict(cause.push).items()},
        "repair": [english(one) for one in cause.repairs],
    }
