"""Summary of a campaign: probability of a fall and moments of the outcomes of each case, merged chunk by chunk."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from upright.arrays import Array
from upright.fleets.binomial import Interval, clopper_pearson
from upright.fleets.ensemble import OUTCOMES
from upright.tables import Listing, Shown, spoken

if TYPE_CHECKING:
    from matplotlib.figure import Figure


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


class Cases(Shown, tuple[CaseSummary, ...]):
    """The summaries of a campaign, in the order of its plan, whose `origins` are those of its cases. `pushes` and
    `spreads` (what varies) are those of the first case; `units` are those of labels and of what varies."""

    origins: Sequence[Mapping[str, Any]] = ()
    pushes: Sequence[Mapping[str, Any]] = ()
    spreads: Sequence[Mapping[str, Any]] = ()
    units: Mapping[str, str] = MappingProxyType({})

    def shown(self) -> list[str]:
        """The outcomes of a table, as far as this campaign keeps them."""
        return [name for name in ("peak_pitch", "settling", "effort") if any(name in c.outcomes for c in self)]

    def varied(self) -> dict[str, list[str | float]]:
        """The labels that differ between the cases, each with its values."""
        labels = {name: [case.labels.get(name, "") for case in self] for case in self for name in case.labels}
        return {name: kept for name, values in labels.items() if len(kept := list(dict.fromkeys(values))) > 1}

    def names(self) -> list[str]:
        """What tells each case from the others."""
        differ = list(self.varied()) or list(dict.fromkeys(name for case in self for name in case.labels))
        return [", ".join(self.labelled(name, case.labels.get(name, "")) for name in differ) for case in self]

    def labelled(self, name: str, value: str | float) -> str:
        """A label of a case in words, with its unit; the name of a controller or a robot speaks for itself."""
        unit = self.units.get(name, "")
        return value if isinstance(value, str) else f"{spoken(name)} {_short(value)}{f' {unit}' if unit else ''}"

    def effects(self) -> dict[str, dict[str | float, Interval]]:
        """For each label that differs the fraction that fell at each of its values, in all cases together, with its
        bounds; the label with the largest effect first. They count each robot once: the cases of one
        robot's name have the same drawn robots."""
        effects: dict[str, dict[str | float, Interval]] = {}
        for name, values in self.varied().items():
            groups = {v: [c for c in self.worst_first() if c.labels.get(name, "") == v] for v in values}
            effects[name] = {
                v: together(cases) for v, cases in groups.items() if cases
            }  # fmt: skip
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

    def matters(self) -> dict[str, tuple[CaseSummary, CaseSummary]]:
        """The labels that change the falls, each with the worse and the better of two cases that differ in it alone
        and whose bounds are apart; of several such pairs the two that are furthest apart."""
        pairs: dict[str, tuple[CaseSummary, CaseSummary]] = {}
        for name in self.varied():
            alike: dict[tuple[tuple[str, str | float], ...], list[CaseSummary]] = {}
            for case in self.worst_first():
                alike.setdefault(tuple(item for item in case.labels.items() if item[0] != name), []).append(case)
            apart = [(c[0], c[-1]) for c in alike.values() if _chance(c[0]).low > _chance(c[-1]).high]
            if apart:
                pairs[name] = max(apart, key=lambda pair: _chance(pair[0]).value - _chance(pair[1]).value)
        return pairs

    def merged(self, without: Collection[str]) -> Cases:
        """The same campaign with the cases together that differ in the labels `without` alone, each with as many runs
        and the interval of as many robots as differ. It has names and falls, and no other outcomes."""
        groups: dict[tuple[tuple[str, str | float], ...], list[CaseSummary]] = {}
        for case in self:
            kept = tuple(item for item in case.labels.items() if item[0] not in without)
            groups.setdefault(kept, []).append(case)
        whole = Cases(
            CaseSummary(
                dict(labels), sum(c.n for c in cases), sum(c.fell or 0 for c in cases),
                together(cases) if all(c.chance for c in cases) else None, {},
            )
            for labels, cases in groups.items()
        )  # fmt: skip
        whole.units = self.units
        return whole

    def plot(self) -> Figure:
        """The fraction that fell in each case [%] as a bar, its bounds as a line, the `DRAWN` worst first; the
        label with the largest effect has the colours."""
        from upright.plotting import COLOURS, INK, legend, number, rows_of

        names = self.names()
        worst = self.worst_first()[:DRAWN]
        effects = self.effects()
        chances = [c.chance or Interval(np.nan, np.nan, np.nan) for c in worst]
        figure, ax = rows_of([names[self.index(case)] for case in worst], "robots that fell [%]", "case")
        percent = 100 * np.array([(c.value, c.low, c.high) for c in chances]).reshape(-1, 3)
        first, levels = next(iter(effects.items()), ("", {}))
        marks = [case.labels.get(first, "") for case in worst]
        for k, level in enumerate(levels if 1 < len(levels) < len(COLOURS) else [None]):
            rows = np.array([i for i, mark in enumerate(marks) if level is None or mark == level], dtype=int)
            name = "robots that fell" if level is None else self.labelled(first, level)
            name = name if level is None or percent[rows, 0].any() else "_"  # no bar, no line in the key
            ax.barh(rows, percent[rows, 0], height=0.6, color=COLOURS[k], label=name)
        ax.hlines(np.arange(len(worst)), percent[:, 1], percent[:, 2], linewidth=1.2, color=INK, zorder=3)
        for row, (value, _, high) in enumerate(percent.tolist()):
            ax.annotate(f"{number(value, 3)} %", (high, row), (4, 0), textcoords="offset points", va="center")
        ax.set_xlim(0, max(1.0, 1.3 * float(np.nanmax(percent, initial=0.0))))
        if ax.get_xlim()[1] > 100:  # room for the names, but no tick above 100 %
            ax.set_xticks(np.arange(0, 101, 25))
        return legend(figure)

    def listing(self) -> Listing:
        """All cases, one row each."""
        names = list(dict.fromkeys(name for case in self for name in case.labels))
        rows: list[list[str]] = []
        for case in self:
            chance = case.chance
            least = f"{chance.low:.2g} … " if chance and case.fell else "≤ "
            fell = f"{case.fell} ({least}{chance.high:.2g})" if chance else "–"
            labels = [_short(case.labels.get(name, "")) for name in names]
            means = ["–" if (mean := case.mean(o)) is None else f"{mean:.4g}" for o in self.shown()]
            rows.append([*labels, str(case.n), fell, *means])
        numbers = ["robots", "fell (each bound: 95 %)", *self.shown()]
        return Listing([*names, *numbers], rows, numbers)

    def __str__(self) -> str:
        return str(self.listing())

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        return {"cases": [_plain(case) for case in self]}


DRAWN = 40  # cases at most in a figure
END = 0.2  # [1] of the robots: those with the least, or the largest, values of a drawn number


def _chance(case: CaseSummary) -> Interval:
    return case.chance or Interval(np.nan, np.nan, np.nan)


def together(cases: Sequence[CaseSummary]) -> Interval:
    """The fraction that fell in several cases, with the interval of as many robots as differ."""
    fell = sum(c.fell or 0 for c in cases)
    runs = sum(c.n for c in cases)
    robots: dict[str | float, int] = {}
    for case in cases:
        robots[case.labels.get("robot", "")] = max(case.n, robots.get(case.labels.get("robot", ""), 0))
    differ = sum(robots.values())
    return clopper_pearson(round(fell / runs * differ), differ)._replace(value=fell / runs)


def _reach(levels: Mapping[str | float, Interval]) -> float:
    values = [chance.value for chance in levels.values()]
    return max(values) - min(values) if values else 0.0


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
