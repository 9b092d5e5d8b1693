"""The score of a candidate during the search: quick, on the same robots and noise for all, and margins by two tests."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace

import numpy as np

from upright.arrays import Array, Complex
from upright.certification.checks import TrialSetup, kernel_controller
from upright.certification.verdict import MOST_CYCLE, MOST_SATURATED, MOST_TRAVEL, LinearMargins
from upright.control.controller import Controller
from upright.control.methods import Method
from upright.errors import UprightError
from upright.loops.analysis import INPUTS
from upright.loops.loop import LATEST, Loop, RobotLoop, delayed_kit, robot_loop
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot
from upright.tuning.figures import knock, pushed, slack

GRID = 300  # frequencies of modulus and phase, from 0.1 rad/s to Nyquist's: a resonance is wider than a step of 3 %
SLACK = 1.01
"""A candidate has to keep margins so much larger than the default's: they are tested at their ends and on a grid."""
SHORT = 0.05  # what a delay margin of zero counts as, in the excess
LEAST = 1e-3  # [1] of what is compared as a ratio: a knock of zero has no logarithm


@dataclass(frozen=True, kw_only=True)
class CandidateScore:
    """One candidate in the search: the fraction of robots that `fell` and of the time that is `down` [1], `knock`
    [N s], `settling` [s], `effort`, how far `over` the amber limits of a certificate saturation, travel and sway are
    [1], the `modulus` margin min |1 + L| [1], and the `excess` of the largest |pole| over one where every margin is
    used up that the default has [1]."""

    fell: float
    down: float
    knock: float
    settling: float
    effort: float
    over: float
    modulus: float
    excess: float

    @property
    def stable(self) -> bool:
        """Whether the nominal loop is."""
        return self.modulus > 0


NONE = CandidateScore(
    fell=1.0, down=1.0, knock=0.0, settling=math.inf, effort=math.inf, over=math.inf, modulus=0.0, excess=math.inf
)
"""Of weights without a design."""


class Scorer:
    """Scores candidates of one `method` for `robot` on `kit`, all on the same `robots` and noise of `seed`.

    Falls, and the time on the floor, are counted among the `hard` ones too. `floor` are the margins that no candidate
    may have less of; None where nothing linear is known.
    """

    def __init__(
        self, method: Method, robot: Robot, kit: Kit, robots: Sequence[Robot], *,
        period: float, seed: int, threads: int | None, floor: LinearMargins | None, hard: Sequence[Robot] = (),
    ) -> None:  # fmt: skip
        self.method, self.robot, self.kit, self.robots = method, robot, kit, robots
        self.period, self.seed, self.threads, self.floor, self.hard = period, seed, threads, floor, hard
        self._delayed: list[LinearModel] = []

    def __call__(self, weights: Mapping[str, float]) -> CandidateScore:
        try:
            controller = self.method.tuned(self.robot, self.kit, self.period, weights)
            modulus, excess = self._margins(controller)
        except UprightError:  # no design, or one that no linear loop is made of
            return NONE
        if not modulus > 0:
            return replace(NONE, excess=excess)
        kernel = kernel_controller(controller, self.robot, self.kit)
        setup = TrialSetup(self.robot, self.robots, self.kit, self.seed, controller=kernel, threads=self.threads)
        groups = [(pushed(replace(setup, robots=some)), len(some)) for some in (self.robots, self.hard) if some]
        count, (runs, _), over = sum(n for _, n in groups), groups[0], 0.0
        for trial in runs.trials:
            used = (trial.saturated / MOST_SATURATED, trial.travel / MOST_TRAVEL, trial.cycle / MOST_CYCLE)
            over = max(over, *(size - 1 for size in used))
        return CandidateScore(
            fell=sum(len(group.fallen) for group, _ in groups) / count,
            down=sum(group.down * n for group, n in groups) / count,
            knock=knock(setup), settling=runs.settling, effort=runs.effort, over=over, modulus=modulus, excess=excess,
        )  # fmt: skip

    def _margins(self, controller: Controller) -> tuple[float, float]:
        """The modulus margin, and the excess where every margin of the floor is used up; 1 and 0 without a loop."""
        if self.floor is None:
            return 1.0, 0.0
        loop = robot_loop(controller, self.robot, self.kit)
        radius = float(abs(loop.poles()[0]))
        if radius >= 1:
            return 0.0, radius - 1
        worst = max(_radius(changed) for changed in self._changed(loop))
        modulus, delay = modulus_and_delay(loop)
        short = 1 - delay / (SLACK * self.floor.delay) if 0 < self.floor.delay < math.inf else 0.0
        return modulus, max(0.0, worst - 1) + SHORT * max(0.0, short)

    def _changed(self, loop: RobotLoop) -> list[Loop]:
        """The loop with each gain and each delay of the floor, at each place where it can be broken."""
        assert self.floor is not None
        change = SLACK * slack(self.floor)
        if self.floor.radius >= 1:
            return [loop]
        K = loop.controller
        changed = list[Loop]()
        for factor in (1 - change, 1 + change):
            for direction in INPUTS.values():
                gains = _gains(np.array(direction), factor)
                changed.append(Loop(loop.plant, LinearModel(K.A, K.B, gains @ K.C, gains @ K.D, K.dt)))
            for row in np.eye(len(loop.plant.C)):
                gains = _gains(row, factor)
                changed.append(Loop(loop.plant, LinearModel(K.A, K.B @ gains, K.C, K.D @ gains, K.dt)))
        return changed + [Loop(plant, K) for plant in self._slowed(loop)]

    def _slowed(self, loop: RobotLoop) -> list[LinearModel]:
        """The robot with the floor's delay in its commands, or in one sensor."""
        assert self.floor is not None
        if not self._delayed:
            more = min(self.floor.delay * SLACK, LATEST)
            places = ["", *(name for name in loop.linear.reads if name in self.kit.sensors)]
            self._delayed = [loop.on(kit=delayed_kit(self.kit, more, at)).plant for at in places]
        return self._delayed


def modulus_and_delay(loop: Loop) -> tuple[float, float]:
    """min |1 + l| over frequencies, and the least delay [s] that turns some |l| = 1 to −1 (infinite where |l| is never
    1), of the loop broken at both motors or at any reading (Åström and Hägglund 2006, section 4.6)."""
    grid = np.geomspace(0.1, math.pi / loop.plant.dt, GRID)
    P, K = loop.plant.matrices(grid), loop.controller.matrices(grid)
    places = [(K @ P, np.array(INPUTS["both motors"]))] + [(P @ K, row) for row in np.eye(P.shape[1])]
    sums = [_one_plus(gain, v / np.linalg.norm(v)) for gain, v in places]
    return float(min(np.abs(one).min() for one in sums)), min(_delay(grid, one - 1) for one in sums)


def _one_plus(gain: Complex, v: Array) -> Complex:
    """1 + l (n,) where the loop u = `gain` u (n, m, m) is broken along the unit vector v (m,), and all else is closed
    (Maciejowski 1989, section 3.12)."""
    return 1 / (np.linalg.inv(np.eye(len(v)) - gain) @ v @ v)


def _delay(grid: Array, response: Complex) -> float:
    """The least delay [s] by the phase at each crossover, which is interpolated between two frequencies."""
    size, lag = np.log(np.abs(response)), np.unwrap(np.angle(response))
    at = np.flatnonzero(np.signbit(size[1:]) != np.signbit(size[:-1]))
    if not len(at):
        return math.inf
    part = size[at] / (size[at] - size[at + 1])
    omega = grid[at] * (grid[at + 1] / grid[at]) ** part
    phase = lag[at] + part * (lag[at + 1] - lag[at])
    return float((np.mod(phase + math.pi, 2 * math.pi) / omega).min())


def _gains(v: Array, factor: float) -> Array:
    unit = v / np.linalg.norm(v)
    return np.eye(len(v)) + (factor - 1) * np.outer(unit, unit)


def _radius(loop: Loop) -> float:
    return float(abs(loop.poles()[0]))


@dataclass(frozen=True)
class Emphasis:
    """Prices in the cost of a search: of a logarithm of the default's knock over the candidate's, of the modulus margin
    likewise, and of the candidate's settling and effort over the default's."""

    knock: float
    modulus: float
    settling: float = 0.05
    effort: float = 0.03


FALLS, KNOCK = Emphasis(0.3, 0.1), Emphasis(1.5, 0.3)
"""What the search asks for: first that fewer fall, then that a larger knock is survived."""

UNSTABLE = 100.0  # costs more than whatever a stable candidate does


def cost(score: CandidateScore, default: CandidateScore, emphasis: Emphasis) -> float:
    """What the search minimises: falls, margins below the default's, and by the `emphasis` the rest."""
    if not score.stable:
        return UNSTABLE * (1 + min(score.excess, 1.0))
    lost = 4 * score.fell + 2 * score.down + 0.5 * min(score.over, 4.0)
    missing = 0.2 * (score.excess > 0) + 30 * min(score.excess, 0.2)
    better = emphasis.knock * _ratio(default.knock, score.knock) + emphasis.modulus * _ratio(
        default.modulus, score.modulus
    )
    more = emphasis.settling * _ratio(score.settling, default.settling)
    return lost + missing + better + more + emphasis.effort * _ratio(score.effort, default.effort)


def _ratio(over: float, under: float) -> float:
    """ln(over / under), at most ± 5."""
    if math.isinf(over) or math.isinf(under):
        return 0.0 if over == under else math.copysign(5.0, over - under)
    return float(np.clip(math.log(max(over, LEAST) / max(under, LEAST)), -5.0, 5.0))


def score_from(row: Sequence[float | None]) -> CandidateScore:
    """The inverse of `row_of`."""
    if len(row) != len(asdict(NONE)):
        raise UprightError(f"a score of {len(row)} numbers", expected=f"{len(asdict(NONE))}")
    numbers = [math.inf if value is None else float(value) for value in row]
    return CandidateScore(**dict(zip(asdict(NONE), numbers, strict=True)))


def row_of(score: CandidateScore) -> list[float | None]:
    """Its numbers, None for what is infinite."""
    return [None if math.isinf(value) else value for value in asdict(score).values()]
