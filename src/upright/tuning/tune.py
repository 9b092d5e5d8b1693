"""Weights of a method found on a fleet's own verdict, and judged beside the default on robots the search never saw.

Three sets of robots are drawn, each with a seed of its own. The search uses the first, the rule chooses on the second,
and the figures that are shown of the default and of the chosen controller are those of the third.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.atomic import place_of
from upright.certification.checks import FEWEST, TrialSetup, kernel_controller
from upright.certification.verdict import LinearMargins, linear_margins
from upright.control import CONTROLLERS, Controller, controller_hash, write_controller
from upright.control.identity import request_hash
from upright.control.methods import Method
from upright.control.tunable import UNITS
from upright.errors import InvalidController, InvalidScenario, check_within, require
from upright.pages import Result
from upright.progress import Progress, unwatched
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.uncertainty import draw
from upright.tuning.figures import (
    ALIKE,
    LEVEL,
    LIGHTS,
    MEASURES,
    Figures,
    chance_of,
    fell_once,
    figures,
    hardest,
)
from upright.tuning.parallel import working
from upright.tuning.score import CandidateScore, Scorer
from upright.tuning.search import Candidate, SearchRecord, search

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.pages import Page

SEARCHED, CHOSEN, JUDGED = (k * 2**61 for k in (1, 2, 3))
"""Added to the seed: the robots and the noise of the search, of the rule, and of the figures that are shown."""

ROBOTS = 48  # in the search
DRAWN = 400  # of which half of these are the hardest for the default: of 48 robots at random one or two decide
CHOICE = 400  # robots on which the rule chooses: a fraction of 1 % shows
BUDGET = 400
MOST_BUDGET, MOST_SAMPLES = 100_000, 100_000
FINALISTS = 10  # whose margins and falls are measured as a certificate does, which takes a second or two each


@dataclass(frozen=True)
class Point:
    """Weights by name, and their `figures` on the robots of the rule."""

    weights: Mapping[str, float]
    figures: Figures


@dataclass(frozen=True, eq=False, repr=False, kw_only=True)
class Tuned(Result):
    """The `controller` of `method` that the rule picks for `robot` with `kit`, and its `weights`.

    `default` and `chosen` are figures on `JUDGED` robots. The `front` are the candidates that no other one beats in
    falls, knock, effort and margins, on the robots of the rule, the default first. Where the default stays although the
    rule picked another one, `refused` are that one's figures on `JUDGED` robots, where it was worse. `evaluated`
    candidates of at most `budget` were tried.
    """

    method: str
    robot: str
    kit: str
    seed: int
    budget: int
    evaluated: int
    controller: Controller
    defaults: Mapping[str, float]
    weights: Mapping[str, float]
    default: Figures
    chosen: Figures
    front: tuple[Point, ...]
    picked: int
    refused: Figures | None = None

    @property
    def kept(self) -> bool:
        """Whether the default stays."""
        return self.picked == 0

    def save(self, path: str | Path) -> Path:
        """Write the controller as JSON, as every command takes it. Returns the path."""
        return write_controller(self.controller, path)

    def check(self) -> tuple[str, ...]:
        """What contradicts the result's own rule, as sentences; none where it is consistent."""
        worse = self.chosen.worse(self.default)
        changed = dict(self.weights) != dict(self.defaults)
        return (
            *([f"the chosen one is worse in {', '.join(worse)}"] if worse else []),
            *(["the default is kept, but its weights are not"] if self.kept and changed else []),
        )

    def called(self, number: int) -> str:
        """The name of a candidate of the front, but for the default: a letter."""
        return chr(ord("A") + number - 1)

    @property
    def tried(self) -> Figures:
        """The figures that stand beside the default's: of the refused candidate, or of the chosen one."""
        return self.refused or self.chosen

    def _paired(self) -> dict[str, float]:
        """The test of falls: robots that fell under one controller only, and how likely chance gives so many more."""
        here, there = fell_once(self.tried, self.default)
        return {
            "only_tried": here,
            "only_default": there,
            "level": LEVEL,
            "more_by_chance": chance_of(here, there),
            "fewer_by_chance": chance_of(there, here),
        }

    def plot(self) -> Figure:
        """By how much each figure of the chosen or refused weights differs from the default's [%]."""
        from upright.tuning.tune_page import draw_changes

        return draw_changes(self.default, self.tried)

    def page(self) -> Page:
        """The tuning for people."""
        from upright.tuning.tune_page import tune_page

        return tune_page(self)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; None for what is unlimited."""
        default = self.front[0].figures
        front = [
            {"weights": dict(p.weights), "figures": p.figures.to_json(), "worse": p.figures.worse(default)}
            for p in self.front
        ]
        return {
            "schema": "upright/tune/1",
            "method": self.method, "robot": self.robot, "kit": self.kit, "seed": self.seed, "budget": self.budget,
            "evaluated": self.evaluated, "kept": self.kept, "defaults": dict(self.defaults),
            "weights": dict(self.weights), "units": {name: UNITS.get(name, "1") for name in self.weights},
            "default": self.default.to_json(), "chosen": self.chosen.to_json(), "front": front,
            "refused": self.refused.to_json() if self.refused else None,
            "changes": {m.name: m.change(self.default, self.tried) for m in MEASURES}, "paired": self._paired(),
            "picked": self.picked, "hash": controller_hash(self.controller),
        }  # fmt: skip


def tune(
    method: str,
    robot: Robot | str,
    kit: Kit | str | None = None,
    *,
    budget: int = BUDGET,
    seconds: float | None = None,
    samples: int = 1000,
    seed: int = 0,
    state: str | Path | None = None,
    resume: bool = False,
    threads: int | None = None,
    progress: Progress | None = None,
) -> Tuned:
    """The weights of `method` for `robot` with `kit` (None: its own) that the rule picks of `budget` candidates.

    By the rule a candidate may have no worse light than the default, no knock smaller by over `ALIKE`, no smaller
    margin, and not more falls of the same robots, beyond what chance explains at the `LEVEL`. Of these the best light
    counts; of those whose falls cannot be told from the fewest then the largest knock, and the least effort.

    The search is by CMA-ES, on falls, knock, settling, effort and margins of a fleet drawn from the robot's spreads; it
    ends early after `seconds` (None: never), and is otherwise the same for the same `seed`. Default and chosen
    controller are compared on `samples` robots that it never saw; where the chosen one is worse by the same rule, the
    default is kept. `state` is a file that holds the search while it runs; with `resume` it goes on from
    there. `progress` receives the fraction done. Raises `UnknownName` for a method that is not registered,
    `InvalidController` for one without weights, `InvalidScenario` for a wrong number or file, `MissingTool` without the
    package cma.
    """
    require("upright tune", "cma")
    nominal = find_robot(robot)
    parts = find_kit(kit or nominal.kit)
    chosen = _method(method)
    check_within("candidates of a search", budget, 1, MOST_BUDGET)
    check_within("robots drawn", samples, FEWEST, MOST_SAMPLES)
    check_within("as a seed", seed, 0, 2**61 - 1)
    limit = math.inf if seconds is None else seconds
    if not limit > 0:
        raise InvalidScenario(f"a search of {limit:g} s", expected="more than zero")
    show = progress or unwatched
    task = _Task(chosen, nominal, parts, seed, threads or os.cpu_count() or 1)
    record = SearchRecord(task.request(budget), Path(state) if state else None)
    if record.path:
        place_of(record.path)
    record = record.resumed() if resume else record
    candidates = search(
        task.defaults, task.scorer(), budget, seed, record, seconds=limit, threads=task.threads,
        progress=lambda done: show(0.8 * done),
    )  # fmt: skip
    finalists = [one.weights for one in _finalists(candidates)]
    points = task.points(finalists, CHOICE, CHOSEN, lambda done: show(0.8 + 0.15 * done))
    result = _result(task, points, len(candidates), budget, samples)
    if record.path:
        record.path.unlink(missing_ok=True)
    show(1.0)
    return result


def _method(name: str) -> Method:
    method = CONTROLLERS[name]
    if method.tunable is None:
        able = ", ".join(n for n in CONTROLLERS if CONTROLLERS[n].tunable)
        raise InvalidController(f"{name} has no weights that are tuned", expected=f"one of {able}")
    return method


@dataclass(frozen=True)
class _Task:
    """What is tuned, for whom."""

    method: Method
    robot: Robot
    kit: Kit
    seed: int
    threads: int
    known: dict[str, LinearMargins | None] = field(default_factory=dict[str, "LinearMargins | None"])

    @cached_property
    def defaults(self) -> dict[str, float]:
        """The default weights."""
        return self.method.defaults(self.robot, self.kit, self.kit.period)

    def controller(self, weights: Mapping[str, float]) -> Controller:
        """The method's own controller under the defaults, or that under other weights."""
        if weights == self.defaults:
            return self.method(self.robot, self.kit, self.kit.period)
        return self.method.tuned(self.robot, self.kit, self.kit.period, weights)

    def scorer(self) -> Scorer:
        """What scores candidates in the search."""
        default = self.controller(self.defaults)
        seed = SEARCHED + self.seed
        drawn = draw(self.robot, DRAWN, seed)
        kernel = kernel_controller(default, self.robot, self.kit)
        order = hardest(TrialSetup(self.robot, drawn, self.kit, seed, controller=kernel, threads=self.threads))
        hard = order[: ROBOTS // 2]
        rest = sorted(order[ROBOTS // 2 :])
        return Scorer(
            self.method, self.robot, self.kit, [drawn[i] for i in rest[: ROBOTS - len(hard)]],
            hard=[drawn[i] for i in hard], period=self.kit.period, seed=seed, threads=1,
            floor=self.margins(default),
        )  # fmt: skip

    def margins(self, controller: Controller) -> LinearMargins | None:
        """Of the nominal loop, computed once."""
        key = controller_hash(controller)
        if key not in self.known:
            self.known[key] = linear_margins(controller, self.robot, self.kit)
        return self.known[key]

    def points(
        self, several: Sequence[Mapping[str, float]], samples: int, purpose: int, progress: Progress = unwatched
    ) -> list[Point]:
        """Figures under each of `several` weights, on robots and noise of that `purpose`."""
        each = max(1, self.threads // len(several))
        points = list[Point]()

        def measured(weights: Mapping[str, float]) -> Figures:
            controller = self.controller(weights)
            return figures(
                controller, self.robot, self.kit, self.margins(controller), samples=samples, seed=purpose + self.seed,
                threads=each,
            )  # fmt: skip

        with working(measured, self.threads) as all_of:
            for weights, one in zip(several, all_of(several), strict=True):
                points.append(Point(weights, one))
                progress(len(points) / len(several))
        return points

    def request(self, budget: int) -> str:
        """The hash of all that determines the scores of a search."""
        versions = {name: version(name) for name in ("upright", "cma", "numpy")}
        counts = {"budget": budget, "seed": self.seed, "robots": [ROBOTS, DRAWN]}
        weights = {**counts, "defaults": self.defaults, **versions}
        return request_hash(self.method.name, self.robot, self.kit, self.kit.period, **weights)


def _finalists(candidates: Sequence[Candidate]) -> list[Candidate]:
    """The default, and at most `FINALISTS`, or one of twenty candidates, that keep what the rule asks for:
    the best by the rule's order, then by knock, by margin and by effort in turn."""
    default, *others = candidates
    least = (1 - ALIKE) * default.score.knock
    kept = [
        c for c in others
        if c.score.stable and not c.score.excess and c.score.fell <= default.score.fell and c.score.knock >= least
    ]  # fmt: skip
    orders: list[Callable[[CandidateScore], Any]] = [
        _rank,
        lambda s: -s.knock,
        _rank,
        lambda s: -s.modulus,
        lambda s: s.effort,
    ]
    queues = [sorted(kept, key=lambda c, order=order: order(c.score)) for order in orders]
    best_first = list[Candidate]()
    most = max(1, min(FINALISTS, len(candidates) // 20))
    for turn in range(len(queues) * len(kept)):
        queue = queues[turn % len(queues)]
        best = next((c for c in queue if c not in best_first), None)
        if best is None or len(best_first) == most:
            break
        best_first.append(best)
    return [default, *best_first]


def _level(knock: float) -> int:
    """Which step of `ALIKE` a knock is on."""
    return round(math.log(max(knock, 1e-9)) / ALIKE)


def _rank(s: CandidateScore) -> tuple[bool, float, int, float]:
    """As the rule picks, by what the search knows of a candidate: the least comes first."""
    return s.over > 0, s.fell, -_level(s.knock), s.effort


def _picked(points: Sequence[Point]) -> Point:
    """What the rule picks among `points` that it allows; the first one where several are equal."""
    best = min(LIGHTS.index(p.figures.light) for p in points)
    lit = [p for p in points if LIGHTS.index(p.figures.light) == best]
    fewest = min(lit, key=lambda p: p.figures.fell).figures
    alike = [p for p in lit if not p.figures.falls_more(fewest)]
    return min(alike, key=lambda p: (-_level(p.figures.knock), p.figures.effort))


def _result(task: _Task, points: Sequence[Point], evaluated: int, budget: int, samples: int) -> Tuned:
    """The rule's choice among `points`, the default first, and both controllers on fresh robots."""
    default = points[0]
    fit = [p for p in points if p is default or not p.figures.worse(default.figures)]
    picked = _picked(fit)
    front = [default, *(p for p in points[1:] if p is picked or not any(_beats(q, p) for q in points))]
    both = [default.weights] if picked is default else [default.weights, picked.weights]
    judged = task.points(both, samples, JUDGED)
    base = judged[0].figures
    best = judged[-1].figures
    refused = best if best.worse(base) else None
    kept = picked is default or refused is not None
    weights = default.weights if kept else picked.weights
    return Tuned(
        method=task.method.name, robot=task.robot.name, kit=task.kit.name, seed=task.seed, budget=budget,
        evaluated=evaluated, controller=task.controller(weights), defaults=task.defaults, weights=weights,
        default=base, chosen=base if kept else best, front=tuple(front), picked=0 if kept else front.index(picked),
        refused=refused,
    )  # fmt: skip


def _beats(one: Point, other: Point) -> bool:
    """Whether `one` is nowhere worse than `other` in falls, knock, effort and margins, and somewhere better."""
    rows = [(f.falls, -f.knock, f.effort, -f.gain, -f.delay) for f in (one.figures, other.figures)]
    return all(a <= b for a, b in zip(*rows, strict=True)) and rows[0] != rows[1]
