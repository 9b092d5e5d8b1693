"""Summary of a campaign: probability of a fall and moments of the outcomes of each case, merged chunk by chunk."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from upright.fleet.binomial import Interval, clopper_pearson
from upright.fleet.ensemble import OUTCOMES
from upright.tables import Listing, Shown

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = NDArray[np.float64]


class Moments(NamedTuple):
    """Mean, sum of squared deviations from it, minimum and maximum of `n` values."""

    n: int = 0
    mean: float = 0.0
    squares: float = 0.0
    least: float = np.inf
    most: float = -np.inf

    @property
    def deviation(self) -> float:
        """Standard deviation; NaN for less than two values."""
        return float(np.sqrt(self.squares / (self.n - 1))) if self.n > 1 else np.nan

    def with_values(self, values: Array) -> Moments:
        """With more values; merged as by Chan, Golub and LeVeque (1979)."""
        if not len(values):
            return self
        own, more = float(values.mean()), len(values)
        n, step = self.n + more, own - self.mean
        squares = self.squares + float(((values - own) ** 2).sum()) + step * step * self.n * more / n
        least, most = min(self.least, float(values.min())), max(self.most, float(values.max()))
        return Moments(n, self.mean + step * more / n, squares, least, most)


@dataclass(frozen=True)
class CaseSummary:
    """Results of one case of `n` robots: how many fell, the probability with its 95 % interval (None where a campaign
    does not keep `fell`), and the moments of each outcome over the robots that stood."""

    labels: Mapping[str, str | float]
    n: int
    fell: int | None
    chance: Interval | None
    outcomes: Mapping[str, Moments]

    def mean(self, outcome: str) -> float | None:
        """The mean over the robots that stood; None where none did, or where the campaign does not keep it."""
        moments = self.outcomes.get(outcome, Moments())
        return moments.mean if moments.n else None


class Cases(Shown, tuple[CaseSummary, ...]):
    """The summaries of a campaign, in the order of its plan."""

    def shown(self) -> list[str]:
        """The outcomes of a table, as far as this campaign keeps them."""
        return [name for name in ("peak_pitch", "settling", "effort") if any(name in c.outcomes for c in self)]

    def names(self) -> list[str]:
        """What tells each case from the others."""
        labels = {name: {case.labels.get(name) for case in self} for case in self for name in case.labels}
        differ = [name for name, values in labels.items() if len(values) > 1] or list(labels)
        return [", ".join(_short(case.labels.get(name, "")) for name in differ) for case in self]

    def worst_first(self) -> list[CaseSummary]:
        """The cases whose falls are counted, the largest fraction that fell first."""
        return sorted((c for c in self if c.fell is not None), key=lambda c: -(c.fell or 0) / c.n)

    def plot(self) -> Figure:
        """The fraction that fell in each case [%] with its 95 % interval, the `DRAWN` worst first."""
        from upright.plotting import intervals, legend

        names, worst = self.names(), self.worst_first()[:DRAWN]
        chances = [c.chance or Interval(np.nan, np.nan, np.nan) for c in worst]
        rows = [names[self.index(case)] for case in worst]
        percent = 100 * np.array([(c.value, c.low, c.high) for c in chances]).reshape(-1, 3)
        return legend(intervals(rows, percent[:, 0], percent[:, 1:], "robots that fell [%]", "case"))

    def listing(self) -> Listing:
        """All cases, one row each."""
        names = list(dict.fromkeys(name for case in self for name in case.labels))
        rows: list[list[str]] = []
        for case in self:
            chance = case.chance
            fell = f"{case.fell} ({chance.low:.2g} … {chance.high:.2g})" if chance else "–"
            labels = [_short(case.labels.get(name, "")) for name in names]
            means = ["–" if (mean := case.mean(o)) is None else f"{mean:.4g}" for o in self.shown()]
            rows.append([*labels, str(case.n), fell, *means])
        numbers = ["robots", "fell (95 %)", *self.shown()]
        return Listing([*names, *numbers], rows, numbers)

    def __str__(self) -> str:
        return str(self.listing())

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        return {"cases": [_plain(case) for case in self]}


DRAWN = 40  # cases at most in a figure


def _short(value: Any) -> str:
    return value if isinstance(value, str) else f"{value:.4g}"


def _plain(case: CaseSummary) -> dict[str, Any]:
    outcomes = {
        name: {"mean": m.mean, "deviation": m.deviation if m.n > 1 else None, "least": m.least, "most": m.most}
        for name, m in case.outcomes.items() if m.n
    }  # fmt: skip
    chance = case.chance._asdict() if case.chance else None
    return {"labels": dict(case.labels), "n": case.n, "fell": case.fell, "chance": chance, "outcomes": outcomes}


def tally(labels: Mapping[str, str | float], n: int, paths: Sequence[Path]) -> CaseSummary:
    """The summary of a case whose chunks are at `paths`; no more than one is in memory at a time."""
    import pyarrow.parquet as pq

    counted, fell, merged = False, 0, dict[str, Moments]()
    for path in paths:
        with pq.ParquetFile(path) as file:
            table = file.read()
        names = set(table.column_names)
        counted = "fell" in names
        down = np.asarray(table.column("fell").to_numpy()) > 0 if counted else np.zeros(len(table), dtype=bool)
        fell += int(down.sum())
        for name in names & set(OUTCOMES) - {"fell", "lived"}:
            values = np.asarray(table.column(name).to_numpy())[~down]
            merged[name] = merged.get(name, Moments()).with_values(values[np.isfinite(values)])
    outcomes = {name: merged[name] for name in OUTCOMES if name in merged}
    return CaseSummary(labels, n, fell if counted else None, clopper_pearson(fell, n) if counted else None, outcomes)
