"""What a controller is judged by: falls of a fleet, the largest knock, settling, effort and margins."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.certification.checks import SECONDS, PushTrial, TrialSetup, kernel_controller, tried
from upright.certification.recovery import KNOCK_DURATION
from upright.certification.verdict import AMBER, GREEN, RED, Examined, LinearMargins, judge
from upright.control.controller import Controller
from upright.fleets.ensemble import release
from upright.kernel.batch import FleetBatch, parameters_of
from upright.kernel.simulate import simulate
from upright.robots import Kit, Robot
from upright.robots.uncertainty import draw

KNOCKED, WATCHED = 0.5, 3.0  # [s] when a knock comes, and how long the robot has to stand after it
SOFTEST, HARDEST = 0.02, 5.0  # [m/s] of the whole robot: the knocks that are tried
COARSE, FINE = 32, 16
"""Sizes that are tried, between both ends and between two of these: 1.2 % from one to the next."""
ALIKE = 0.02
"""Knocks that differ by less, relatively, count as equal: twice what the sizes that are tried resolve."""
LEVEL = 0.05
"""Falls differ where chance alone would show as large a difference less often: the 95 % of a certificate's bound."""
LIGHTS = (GREEN, AMBER, RED)
"""The better ones first."""
STREAMS = 2
"""Times that each size is tried from each side, with other noise: it is survived where all of them are."""


@dataclass(frozen=True)
class Runs:
    """The standard pushes on a fleet: its `trials`, the numbers of the robots that fell in any of them (`fallen`), how
    many of these no controller could save (`beyond`), the fraction of the time `down` that the runs of fallen robots
    lack [1], and the means of those that stood: `settling` [s] after the last push, `effort` [V² s, or N² m² s]."""

    trials: tuple[PushTrial, ...]
    fallen: tuple[int, ...]
    beyond: int
    down: float
    settling: float
    effort: float


def pushed(setup: TrialSetup, *, blamed: bool = False) -> Runs:
    """The standard pushes at every battery on all robots of `setup`. A robot that never settles counts to the end.

    Which robots no controller could save is found out only where the controller is `blamed` for all others.
    """
    fell, beyond = (np.zeros(len(setup.robots), dtype=np.bool_) for _ in range(2))
    trials = list[PushTrial]()
    lived, settling, effort = list[float](), list[Array](), list[Array]()
    for one in tried(setup):
        run = one.run
        stood = ~one.run.fell
        trials.append(one.counted if blamed else one.trial)
        fell |= run.fell
        beyond |= one.beyond if blamed else False
        lived.append(float(np.sum(run.lived)))
        settling.append(np.maximum(np.nan_to_num(run.settled[stood], nan=SECONDS) - release(one.planned.push), 0.0))
        effort.append(np.asarray(run.effort[stood], dtype=np.float64))
    count = len(trials) * len(setup.robots)
    return Runs(
        tuple(trials),
        tuple(np.flatnonzero(fell).tolist()),
        int(beyond.sum()),
        1 - sum(lived) / (SECONDS * count),
        _mean(settling, SECONDS),
        _mean(effort, 0.0),
    )


def hardest(setup: TrialSetup) -> list[int]:
    """The numbers of the robots of `setup`, first the one that leans farthest in the standard pushes, all together."""
    lean = np.sum([one.run.peak[:, 0] for one in tried(setup)], axis=0)
    return np.argsort(-lean, kind="stable").tolist()


def _mean(parts: Sequence[Array], none: float) -> float:
    values = np.concatenate(parts)
    return float(values.mean()) if len(values) else none


def knock(setup: TrialSetup) -> float:
    """The largest impulse [N s] at the centre of mass that the nominal robot survives from both sides, in
    `KNOCK_DURATION`.

    Every smaller one that was tried is survived too; the battery is the kit's.
    """
    robot = setup.robot
    mass = robot.body_mass + 2 * robot.wheel_mass
    sizes = mass * np.geomspace(SOFTEST, HARDEST, COARSE)
    first = _first_fall(setup, sizes)
    if first in (0, COARSE):
        return float(sizes[-1]) if first else 0.0
    finer = np.geomspace(sizes[first - 1], sizes[first], FINE + 1)
    return float(finer[_first_fall(setup, finer[1:-1])])


def _first_fall(setup: TrialSetup, sizes: Array) -> int:
    """The number of the least of `sizes` [N s] that fells the robot from either side; their count where none does.

    Of one size all runs stand together, so that the kernel is soon done with the sizes that nothing survives."""
    ways = np.tile([1.0, -1.0], STREAMS)
    pushes = np.array(
        [[way * size / KNOCK_DURATION, np.nan, KNOCKED, KNOCK_DURATION] for size in sizes for way in ways]
    )
    noise = np.tile(np.arange(len(ways), dtype=np.uint64), len(sizes))  # the same for every size
    law, called = setup.controller
    batch = FleetBatch(
        parameters=parameters_of(setup.robot), controller=law, called=called, kit=setup.kit, seed=setup.seed,
        pushes=pushes[:, None], index=noise,
    )  # fmt: skip
    result = simulate(batch, KNOCKED + KNOCK_DURATION + WATCHED, threads=setup.threads)
    fell = result.fell.reshape(len(sizes), len(ways)).any(axis=1)
    return int(np.argmax(fell)) if fell.any() else len(sizes)


def slack(linear: LinearMargins) -> float:
    """By which fraction [1] every signal may become stronger or weaker, one at a time: what a certificate goes by."""
    return min(linear.gain_high - 1, 1 - linear.gain_low)


@dataclass(frozen=True, kw_only=True)
class Figures:
    """Of `samples` robots those with the numbers `fallen` fell in a standard push; the largest `knock` [N s]; means of
    `settling` [s] and `effort` [V² s, or N² m² s]; 95 % quantiles in the worst trial of `saturated` [1], `travel` [m]
    and `sway` [rad]; the nominal loop's margins `linear`; the `light` that a certificate gives it, and its `reasons`.
    """

    samples: int
    fallen: tuple[int, ...]
    knock: float
    settling: float
    effort: float
    saturated: float
    travel: float
    sway: float
    linear: LinearMargins | None
    light: str
    reasons: tuple[str, ...]

    @property
    def fell(self) -> int:
        """How many robots fell."""
        return len(self.fallen)

    @property
    def falls(self) -> float:
        """The fraction of the robots that fell [1]."""
        return self.fell / self.samples

    @property
    def gain(self) -> float:
        """The `slack` [1] of the margins: infinite where they are not known."""
        return math.inf if self.linear is None else slack(self.linear)

    @property
    def delay(self) -> float:
        """The smallest delay margin [s] of all loops: infinite where it is not known."""
        return math.inf if self.linear is None else self.linear.delay

    def falls_more(self, other: Figures) -> bool:
        """Whether more of the same robots fell than in `other`, beyond what chance explains at the `LEVEL`."""
        return chance_of(*fell_once(self, other)) < LEVEL

    def light_beside(self, other: Figures) -> str:
        """Whether this light is "won" from the `other`, or "paid"; "" where they are one."""
        steps = LIGHTS.index(self.light) - LIGHTS.index(other.light)
        return "paid" if steps > 0 else "won" if steps < 0 else ""

    def worse(self, other: Figures) -> list[str]:
        """In which of falls, light, knock and margins this is worse than `other`, which flew the same robots with the
        same noise; of the knock by more than `ALIKE`."""
        worse = ["falls"] if self.falls_more(other) else []
        worse += ["light"] if self.light_beside(other) == "paid" else []
        worse += ["knock"] if self.knock < (1 - ALIKE) * other.knock else []
        if other.linear is None:
            return worse
        if self.linear is None or self.linear.radius >= 1 > other.linear.radius:
            return [*worse, "stability"]
        worse += ["gain margin"] if self.gain < other.gain else []
        return worse + (["delay margin"] if self.delay < other.delay else [])

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; None for what is unlimited."""
        linear = {k: finite(v) for k, v in asdict(self.linear).items()} if self.linear else None
        shown = {"fell": self.fell, "fallen": list(self.fallen), "linear": linear, "reasons": list(self.reasons)}
        return asdict(self) | shown


def fell_once(one: Figures, other: Figures) -> tuple[int, int]:
    """How many of the same robots fell in `one` only, and in `other` only."""
    here = set(one.fallen)
    there = set(other.fallen)
    return len(here - there), len(there - here)


def chance_of(here: int, there: int) -> float:
    """How likely [1] at least so many as `here` of `here` + `there` robots that fell once did so on one side, if both
    were equally likely: the exact test of paired counts (McNemar 1947), one-sided."""
    from scipy.special import betainc

    return float(betainc(here, there + 1, 0.5)) if here else 1.0  # P(X ≥ here), X binomial with 1/2


@dataclass(frozen=True)
class Measure:
    """A figure by `name` with its SI `unit`; `way` is 1 where less of it is better, −1 where more is."""

    name: str
    unit: str
    way: int
    of: Callable[[Figures], float]

    def change(self, before: Figures, after: Figures) -> str:
        """Whether it is "won" or "paid" by more than `ALIKE`, falls beyond what chance explains; else ""."""
        if self.name == "falls":
            return "paid" if after.falls_more(before) else "won" if before.falls_more(after) else ""
        old = self.of(before)
        new = self.of(after)
        if old == new or abs(new - old) <= ALIKE * abs(old):
            return ""
        return "paid" if self.way * (new - old) > 0 else "won"


MEASURES = (
    Measure("falls", "fraction", 1, lambda f: f.falls),
    Measure("knock", "N s", -1, lambda f: f.knock),
    Measure("delay", "s", -1, lambda f: f.delay),
    Measure("stronger", "fraction", -1, lambda f: f.linear.gain_high - 1 if f.linear else math.inf),
    Measure("weaker", "fraction", -1, lambda f: 1 - f.linear.gain_low if f.linear else math.inf),
    Measure("settling", "s", 1, lambda f: f.settling),
    Measure("effort", "1", 1, lambda f: f.effort),
    Measure("saturated", "fraction", 1, lambda f: f.saturated),
    Measure("travel", "m", 1, lambda f: f.travel),
    Measure("sway", "rad", 1, lambda f: f.sway),
)
"""What is told of a controller beside another one; the first four, with the smaller gain margin, are the rule's."""


def figures(
    controller: Controller, robot: Robot, kit: Kit, linear: LinearMargins | None, *,
    samples: int, seed: int, threads: int | None = None,
) -> Figures:  # fmt: skip
    """What a certificate measures of `controller`, with margins `linear`, on `samples` robots drawn from the spreads,
    and the largest knock."""
    robots = draw(robot, samples, seed)
    setup = TrialSetup(robot, robots, kit, seed, controller=kernel_controller(controller, robot, kit), threads=threads)
    runs = pushed(setup, blamed=True)
    light, reasons = judge(
        Examined(samples, len(runs.fallen), linear, runs.trials, controller.spec.period, beyond=runs.beyond)
    )
    return Figures(
        samples=samples, fallen=runs.fallen, knock=knock(setup), settling=runs.settling, effort=runs.effort,
        saturated=max(t.saturated for t in runs.trials), travel=max(t.travel for t in runs.trials),
        sway=max(t.cycle for t in runs.trials), linear=linear, light=light, reasons=tuple(map(str, reasons)),
    )  # fmt: skip
