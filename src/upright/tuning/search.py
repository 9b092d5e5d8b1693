"""The search for weights: CMA-ES (Hansen 2016, package `cma`) in their logarithms, and its state in a file.

The candidates of a seed follow from the scores before them. So a search that was stopped is resumed by asking again and
taking the known scores from its file: it then ends with the same bytes as one that never stopped.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.atomic import write_json
from upright.control.tunable import NARROWER, WIDTH
from upright.errors import InvalidScenario
from upright.progress import Progress
from upright.reading import read_json, understood
from upright.tuning.parallel import working
from upright.tuning.score import FALLS, KNOCK, CandidateScore, Emphasis, cost, row_of, score_from

KIND, VERSION = "upright search", 1
STEP, NARROWED = 0.6, 0.3
"""Standard deviation of the first candidates, in logarithms of the weights: a factor of 1.8; in the second search,
which starts from the best of the first, 1.35."""
FIRST = 0.6  # of the budget, for `FALLS`; the rest for `KNOCK`


@dataclass(frozen=True)
class Candidate:
    """Weights by name, and the `score` under them."""

    weights: dict[str, float]
    score: CandidateScore


@dataclass
class SearchRecord:
    """The scores of one search, in their order, and the file in which they are kept while it runs ("": nowhere).

    `asked` is a hash of all that determines the search; a file of another one is refused.
    """

    asked: str
    path: Path | None = None
    scores: list[CandidateScore] = field(default_factory=list[CandidateScore])

    def resumed(self) -> SearchRecord:
        """With the scores of the file; raises `InvalidScenario` where there is none, or of another search."""
        if self.path is None:
            raise InvalidScenario("a search is resumed without its file", expected="-o, as it was given before")
        if not self.path.exists():
            raise InvalidScenario(
                f"there is no search to resume: no file {self.path}", expected="one that was stopped",
                hint="leave --resume out, or give the same -o as before",
            )  # fmt: skip
        expected = "JSON that a stopped upright tune left"
        data = read_json(self.path, InvalidScenario, expected)
        with understood(str(self.path), InvalidScenario, expected):
            if data["file"] != KIND or data["version"] != VERSION:
                raise ValueError("it is of another kind")
            scores = [score_from(row) for row in data["scores"]]
            if data["asked"] != self.asked:
                raise InvalidScenario(
                    f"{self.path} is of another search", expected="the same method, robot, kit, seed and budget",
                    hint="give what was given before, or leave --resume out",
                )  # fmt: skip
        return SearchRecord(self.asked, self.path, scores)

    def keep(self) -> None:
        """Write the file, whole, at once."""
        if self.path:
            rows = [row_of(score) for score in self.scores]
            data = {"file": KIND, "version": VERSION, "asked": self.asked, "scores": rows}
            write_json(self.path, data, at_once=True)


def search(
    defaults: Mapping[str, float], score: Callable[[Mapping[str, float]], CandidateScore], budget: int, seed: int,
    record: SearchRecord, *, seconds: float = math.inf, threads: int = 1, progress: Progress | None = None,
) -> list[Candidate]:  # fmt: skip
    """At most `budget` candidates, the default first, or as many as `seconds` allow; each new score goes into `record`.

    The candidates of a generation are scored in `threads` threads, which changes nothing. The record's file is written
    after each generation.
    """
    with working(score, threads) as scored:
        return _searched(defaults, scored, budget, seed, record, end=time.monotonic() + seconds, progress=progress)


def _searched(
    defaults: Mapping[str, float], scored: Callable[[Sequence[dict[str, float]]], Iterable[CandidateScore]],
    budget: int, seed: int, record: SearchRecord, *, end: float, progress: Progress | None,
) -> list[Candidate]:  # fmt: skip
    done = list[Candidate]()

    def judged(several: Sequence[dict[str, float]]) -> list[CandidateScore]:
        first = len(done)
        known = record.scores[first : first + len(several)]
        for weights, score in zip(several, chain(known, scored(several[len(known) :])), strict=True):
            if len(done) == len(record.scores):
                record.scores.append(score)
            done.append(Candidate(weights, score))
            if progress:
                progress(len(done) / budget)
        return [one.score for one in done[first:]]

    (default,) = judged([dict(defaults)])
    plan: list[tuple[Emphasis, int, float]] = [
        (FALLS, max(1, round(FIRST * budget)), STEP), (KNOCK, budget, NARROWED)
    ]  # fmt: skip
    for number, (emphasis, until, step) in enumerate(plan):
        best = min(done, key=lambda one: cost(one.score, default, emphasis)).weights
        start = np.array([math.log(best[name] / defaults[name]) for name in defaults])
        strategy = _Strategy(list(defaults), start, step, (seed, number))
        while len(done) + strategy.size <= until and time.monotonic() < end:
            scores = judged([strategy.weights(x, defaults) for x in strategy.ask()])
            strategy.tell([cost(one, default, emphasis) for one in scores])
            record.keep()
    return done


class _Strategy:
    """CMA-ES in the logarithms of weights over their defaults."""

    def __init__(self, names: Sequence[str], start: Array, step: float, seed: tuple[int, int]) -> None:
        import cma

        rng = np.random.Generator(np.random.Philox(np.random.SeedSequence(seed)))
        self.names = names
        most = [math.log(NARROWER.get(name, WIDTH)) for name in names]

        def normal(*shape: int) -> Array:
            return rng.standard_normal(shape)

        options: dict[str, Any] = {
            "seed": math.nan, "randn": normal, "verbose": -9, "verb_log": 0,
            "bounds": [[-m for m in most], most], "signals_filename": "",
        }  # fmt: skip
        inside = np.clip(start, -0.99 * np.array(most), 0.99 * np.array(most))
        self._strategy: Any = cma.CMAEvolutionStrategy(inside.tolist(), step, options)
        self._asked: list[Array] = []
        self.size = int(self._strategy.popsize)

    def ask(self) -> Iterator[Array]:
        """The candidates of a generation."""
        self._asked = self._strategy.ask()
        return iter(self._asked)

    def tell(self, costs: Sequence[float]) -> None:
        """Their costs."""
        self._strategy.tell(self._asked, list(costs))

    def weights(self, x: Array, defaults: Mapping[str, float]) -> dict[str, float]:
        """The weights of a candidate."""
        return {name: float(defaults[name] * math.exp(value)) for name, value in zip(self.names, x, strict=True)}
