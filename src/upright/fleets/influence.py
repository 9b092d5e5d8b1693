"""Which varied number the outcomes of a fleet follow: rank correlations, and how large chance alone makes them."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from upright.fleets.ensemble import OUTCOMES

if TYPE_CHECKING:
    from xarray import Dataset

FEWEST = 3  # robots with an outcome: a correlation of two is always 1


@dataclass(frozen=True)
class Influence:
    """Spearman's rank correlation [1] of an `outcome` with each varied number, the strongest first, and the size that
    the largest of them exceeds by chance in 5 of 100 fleets (Bonferroni)."""

    outcome: str
    correlations: Mapping[str, float]
    chance: float

    @property
    def strongest(self) -> str | None:
        """The number that the outcome follows most, where by more than chance."""
        name = next(iter(self.correlations), None)
        return name if name and abs(self.correlations[name]) > self.chance else None


def influence(data: Dataset, outcome: str) -> Influence:
    """What an `outcome` follows: falls of all robots, any other outcome of those that stood."""
    from scipy.stats import norm, rankdata

    values = data[outcome].values.astype(np.float64)
    use = np.isfinite(values) & ((outcome == "fell") | (data["fell"].values == 0))
    varied = [str(name) for name in data.data_vars if str(name) not in OUTCOMES]
    sizes: dict[str, float] = {}
    if use.sum() >= FEWEST and np.ptp(values[use]) > 0:
        for name in varied:
            drawn = data[name].values[use]
            if np.ptp(drawn) > 0:
                sizes[name] = float(np.corrcoef(rankdata(drawn), rankdata(values[use]))[0, 1])
    ranked = dict(sorted(sizes.items(), key=lambda pair: -abs(pair[1])))
    chance = float(norm.ppf(1 - 0.025 / max(len(ranked), 1))) / math.sqrt(max(int(use.sum()) - 1, 1))
    return Influence(outcome, ranked, chance)
