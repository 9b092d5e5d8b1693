"""Summary of a campaign: probability of a fall and moments of the outcomes of each case, merged chunk by chunk."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import Any, NamedTuple, Self

import numpy as np

from upright.arrays import Array
from upright.fleets.binomial import Interval, clopper_pearson
from upright.fleets.ensemble import OUTCOMES
from upright.pages import Quantity, Say
from upright.pages.terms import term


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
        own = float(values.mean())
        more = len(values)
        n = self.n + more
        step = own - self.mean
        squares = self.squares + float(((values - own) ** 2).sum()) + step * step * self.n * more / n
        least, most = min(self.least, float(values.min())), max(self.most, float(values.max()))
        return Moments(n, self.mean + step * more / n, squares, least, most)


@dataclass(frozen=True)
class CaseSummary:
    """Results of one case of `n` robots: how many fell, the probability with its bounds (None where a campaign
    does not keep `fell`), and the moments of each outcome over the robots that stood. `ends` has for each drawn number
    how many fell of the robots with its least and its largest values, and how many robots each of the two parts has."""

    labels: Mapping[str, str | float]
    n: int
    fell: int | None
    chance: Interval | None
    outcomes: Mapping[str, Moments]
    ends: Mapping[str, tuple[int, int, int]] = field(default_factory=dict[str, tuple[int, int, int]])

    def mean(self, outcome: str) -> float | None:
        """The mean over the robots that stood; None where none did, or where the campaign does not keep it."""
        moments = self.outcomes.get(outcome, Moments())
        return moments.mean if moments.n else None


class Tally(tuple[CaseSummary, ...]):
    """The summaries of a campaign, in the order of its plan, whose `origins` are those of its cases. `spreads` (what
    varies) are those of the first case; `units` are those of labels and of what varies. After Ctrl-C
    `unfinished` are its `robots` `of` all."""

    origins: Sequence[Mapping[str, Any]] = ()
    spreads: Sequence[Mapping[str, Any]] = ()
    units: Mapping[str, str] = MappingProxyType({})
    unfinished: Mapping[str, int] | None = None

    def varied(self) -> dict[str, list[str | float]]:
        """The labels that differ between the cases, each with its values."""
        labels = {name: [case.labels.get(name, "") for case in self] for case in self for name in case.labels}
        return {name: kept for name, values in labels.items() if len(kept := list(dict.fromkeys(values))) > 1}

    def name(self, case: CaseSummary) -> Say:
        """What tells a case from the others."""
        differ = self.varied() or case.labels
        return Say("{labels}", labels=[self.labelled(name, case.labels.get(name, "")) for name in differ])

    def labelled(self, name: str, value: str | float) -> str | Say:
        """A label of a case in words, with its unit; the name of a controller or a robot speaks for itself."""
        unit = self.units.get(name, "")
        return value if isinstance(value, str) else Say("{name} {value}", name=term(name), value=Quantity(value, unit))

    def effects(self) -> dict[str, dict[str | float, Interval]]:
        """For each label that differs the fraction that fell at each of its values, in all cases together, with its
        bounds; the label with the largest effect first. They count each robot once: the cases of one
        robot's name have the same drawn robots."""
        effects: dict[str, dict[str | float, Interval]] = {}
        for name, values in self.varied().items():
            groups = {v: [c for c in self.worst_first() if c.labels.get(name, "") == v] for v in values}
            effects[name] = {v: _chance(together({}, cases)) for v, cases in groups.items() if cases}
        return dict(sorted(effects.items(), key=lambda item: -_reach(item[1])))

    def drawn(self) -> dict[str, tuple[CaseSummary, float, float]]:
        """For each drawn number the case in which it matters most, and the fractions that fell of the robots with its
        least and its largest values; the number with the largest effect first. Those that chance explains are left
        out."""
        strongest: dict[str, tuple[CaseSummary, float, float]] = {}
        for case in self:
            for name, (least, most, n) in case.ends.items():
                low, high = sorted((clopper_pearson(least, n), clopper_pearson(most, n)))
                known = strongest.get(name)
                size = abs(most - least) / n
                if low.high < high.low and (known is None or size > abs(known[2] - known[1])):
                    strongest[name] = (case, least / n, most / n)
        return dict(sorted(strongest.items(), key=lambda item: -abs(item[1][2] - item[1][1])))

    def worst_first(self) -> list[CaseSummary]:
        """The cases whose falls are counted, the largest fraction that fell first; equal ones in the order of the
        plan."""
        return sorted((c for c in self if c.chance), key=lambda c: -_chance(c).value)

    def alike(self) -> list[str]:
        """The labels that change no case's falls: no two cases that differ in one alone have intervals apart."""
        changing: set[str] = set()
        for name in self.varied():
            for cases in self._groups([name]).values():
                if any(_chance(a).low > _chance(b).high for a in cases for b in cases):
                    changing.add(name)
        return [name for name in self.varied() if name not in changing]

    def merged(self, without: Collection[str]) -> Self:
        """The same campaign with the cases together that differ in the labels `without` alone. It has no outcomes but
        the falls."""
        whole = type(self)(together(dict(labels), cases) for labels, cases in self._groups(without).items())
        whole.units = self.units
        return whole

    def _groups(self, without: Collection[str]) -> dict[tuple[tuple[str, str | float], ...], list[CaseSummary]]:
        groups: dict[tuple[tuple[str, str | float], ...], list[CaseSummary]] = {}
        for case in self.worst_first():
            groups.setdefault(tuple(item for item in case.labels.items() if item[0] not in without), []).append(case)
        return groups

    def decisive(self) -> tuple[str, dict[str | float, Interval]] | None:
        """The label with the largest effect on the falls, whose best and worst value have intervals apart, with the
        fraction at each of its values, the worst first; None where chance explains them all."""
        for name, levels in self.effects().items():
            ranked = dict(sorted(levels.items(), key=lambda item: -item[1].value))
            chances = list(ranked.values())
            if chances and chances[-1].high < chances[0].low:
                return name, ranked
        return None

    def numbers(self) -> dict[str, Any]:
        """Each case, what each label does to the falls, and the drawn numbers that decide them."""
        effects = {
            name: [{"value": value, "fell": chance._asdict()} for value, chance in levels.items()]
            for name, levels in self.effects().items()
        }
        drawn = {
            name: {"case": self.index(case), "least": least, "most": most}
            for name, (case, least, most) in self.drawn().items()
        }
        cases = [_plain(case) for case in self]
        return {"unfinished": self.unfinished, "cases": cases, "effects": effects, "drawn": drawn}


END = 0.2  # [1] of the robots: those with the least, or the largest, values of a drawn number


def _chance(case: CaseSummary) -> Interval:
    return case.chance or Interval(np.nan, np.nan, np.nan)


def together(labels: Mapping[str, str | float], cases: Sequence[CaseSummary]) -> CaseSummary:
    """Several cases as one with as many robots as differ, since the cases of one robot have the same drawn robots."""
    robots: dict[str | float, int] = {}
    for case in cases:
        robots[case.labels.get("robot", "")] = max(case.n, robots.get(case.labels.get("robot", ""), 0))
    n = sum(robots.values())
    part = sum(case.fell or 0 for case in cases) / sum(case.n for case in cases)
    fell = round(part * n)
    return CaseSummary(labels, n, fell, clopper_pearson(fell, n)._replace(value=part), {})


def _reach(levels: Mapping[str | float, Interval]) -> float:
    values = [chance.value for chance in levels.values()]
    return max(values) - min(values) if values else 0.0


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

    counted = False
    fell = 0
    merged = dict[str, Moments]()
    ends = dict[str, Any]()
    for path in paths:
        with pq.ParquetFile(path) as file:
            table = file.read()
        names = set(table.column_names)
        counted = "fell" in names
        down = np.asarray(table.column("fell").to_numpy()) > 0 if counted else np.zeros(len(table), dtype=bool)
        fell += int(down.sum())
        for name in names - set(OUTCOMES) - {"robot"} if counted else ():
            values = np.asarray(table.column(name).to_numpy())
            part = int(END * len(values))
            if part and np.ptp(values) > 0:
                order = np.argsort(values, kind="stable")
                new = int(down[order[:part]].sum()), int(down[order[-part:]].sum()), part
                ends[name] = tuple(a + b for a, b in zip(ends.get(name, (0, 0, 0)), new, strict=True))
        for name in names & set(OUTCOMES) - {"fell", "lived"}:
            values = np.asarray(table.column(name).to_numpy())[~down]
            merged[name] = merged.get(name, Moments()).with_values(values[np.isfinite(values)])
    outcomes = {name: merged[name] for name in OUTCOMES if name in merged}
    chance = clopper_pearson(fell, n) if counted else None
    return CaseSummary(labels, n, fell if counted else None, chance, outcomes, ends)
