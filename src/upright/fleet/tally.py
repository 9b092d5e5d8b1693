"""Summary of a campaign: probability of a fall and moments of the outcomes of each case, merged chunk by chunk."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from upright.fleet.binomial import Interval, clopper_pearson
from upright.fleet.ensemble import OUTCOMES

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
