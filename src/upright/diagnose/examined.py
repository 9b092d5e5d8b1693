"""What a post-mortem found, as data."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from typing import Any, Self

from upright.atomic import finite
from upright.diagnose.causes import CANNOT_TELL, NO_FALL, Blow, Cause
from upright.diagnose.series import Series
from upright.errors import InvalidLog

KIND, VERSION = "upright post-mortem", 1


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class FallExamined:
    """Why a robot fell: the `verdict` is the likeliest of `causes`, "it did not fall" or "cannot tell".

    `fell_at` is when its lean passed 0.7 rad for good, `onset` when the trouble began [s] (NaN where there is none);
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
    missing: tuple[str, ...]
    notes: tuple[str, ...]
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
        numbers = {k: finite(v) for k, v in asdict(self).items() if k not in ("causes", "series")}
        causes = [_plain(asdict(c)) | {"repair": [words.template for words in c.repairs]} for c in self.causes]
        return {"file": KIND, "version": VERSION} | numbers | {"causes": causes, "series": self.series.to_json()}

    @classmethod
    def from_json(cls, data: Mapping[str, Any]) -> Self:
        """The inverse of `to_json`; raises `InvalidLog` for what is no post-mortem or contradicts itself."""
        try:
            given = dict(data)
            if (given.pop("file"), given.pop("version")) != (KIND, VERSION):
                raise ValueError(f"it is no '{KIND}' of version {VERSION}")
            listed: list[dict[str, Any]] = given.pop("causes")
            causes = tuple(_cause(one) for one in listed)
            times: dict[str, Any] = {name: _number(given.pop(name)) for name in ("fell_at", "onset", "misfit")}
            lists: dict[str, Any] = {name: tuple(given.pop(name)) for name in ("missing", "notes")}
            result = cls(causes=causes, series=Series.from_json(given.pop("series")), **times, **lists, **given)
            if wrong := result.check():
                raise ValueError(wrong[0])
        except (KeyError, TypeError, ValueError, AttributeError) as error:
            raise InvalidLog(
                f"this is no post-mortem ({type(error).__name__}: {error})", expected="JSON by upright post-mortem"
            ) from None
        return result


def _plain(data: dict[str, Any]) -> dict[str, Any]:
    return {k: finite(v) for k, v in data.items()} | ({"push": _plain(data["push"])} if data.get("push") else {})


def _cause(data: dict[str, Any]) -> Cause:
    push: dict[str, Any] | None = data.get("push")
    blow = Blow(**{name: value for name, value in push.items() if value is not None}) if push else None
    names = ("name", "likelihood", "evidence")
    return Cause(**{name: data[name] for name in names}, onset=_number(data["onset"]), push=blow)


def _number(value: float | None) -> float:
    return math.nan if value is None else float(value)
