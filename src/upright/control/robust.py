"""One output feedback for a whole family of robots: by scenarios, and by linear matrix inequalities beside them.

Both work in the pitch plane on the state that the nominal robot's filter estimates, dead time included (`family`).

- Scenarios (Calafiore and Campi 2006): four gains and the filter's process noise minimise the cost of the worst of many
  drawn robots. The search is the simplex of Nelder and Mead (1965), from the best of several regulators.
- Inequalities (`guaranteed`): one gain and one Lyapunov function for all robots, as if their states were measured.

The one with the smaller worst cost on sensors is used; heading keeps the plain regulator's gains.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.atomic import finite
from upright.control.delay import RAW, SampledRobot, sampled, sent
from upright.control.design import Design
from upright.control.family import LoopFamily, Plane, family, half, halves, plane
from upright.control.guaranteed import Guaranteed, guaranteed
from upright.control.kalman import RECOVERED, Disturbed, Filter, kalman_filter
from upright.control.linear_controller import LinearController
from upright.control.lqr import lqr_state
from upright.control.observer import output_feedback
from upright.control.riccati import LARGEST_COMMAND, LARGEST_STATE, bryson
from upright.errors import DesignFailed, require
from upright.pages import Quantity, Say
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.robots.uncertainty import Uncertainty, draw
from upright.signals import STATE_NAMES

DRAWN = 200
WORTH = 0.01
"""A worst case that is better by less than this fraction counts as no better."""

PRICES = (0.1, 1.0, 10.0)  # of the command, against Bryson's, of the regulators to begin from
TRUSTS = (0.02, 0.1, 0.2)  # fractions of the command that the initial filters take as noise
MOST = RECOVERED.motor  # a filter that trusts its model less estimates a lean too slowly for motors as weak as ev3way's
STARTS = 2
STEPS = 150
_FELL = 1e3  # what an unstable robot costs: more than any other


@dataclass(frozen=True)
class Costs:
    """E[xᵀWx + uᵀRu] in a period for the nominal robot and the worst of `tried`, and how many of those are unstable.

    Deviations of Bryson's size cost one; infinite where unstable.
    """

    nominal: float
    worst: float
    fell: int
    tried: int

    def below(self, other: Costs) -> bool:
        """Whether fewer fall, or as few at a lower worst cost."""
        return (self.fell, self.worst) < (other.fell, other.worst)


@dataclass(frozen=True, eq=False, kw_only=True)
class Robust(Design):
    """The gain k (m,) on the filter's pitch plane, found by `method`, beside plain LQR on the same sensors.

    Costs are over draws that no design has seen; `inequalities` are those of the other method, or None with `why`.
    """

    filter: Filter
    k: Array
    W: Array
    price: float
    method: str
    own: Costs
    plain: Costs
    proof: Guaranteed | None
    inequalities: Costs | None
    why: str = ""

    def check(self) -> float:
        """The largest of three relative errors [1]: the filter's Riccati residual, the excess of the inequalities, and
        the difference of the nominal cost from that of the covariance solved directly."""
        model = self.filter.sampled
        direct = family([plane(model)], self.filter).direct(self.k, self.W, self.price)
        return max(self.filter.check(), self.proof.check() if self.proof else 0.0, abs(self.own.nominal / direct - 1))

    def verdict(self) -> Say:
        """Whether it was worth it, in one sentence."""
        own, plain = self.own, self.plain
        facts = {"fell": own.fell, "n": own.tried, "other": plain.fell}
        if own.fell < plain.fell:
            return Say("Better: {fell} of {n} drawn robots are unstable, under plain LQR {other}.", **facts)
        if own.fell > plain.fell:
            return Say("No better: {fell} of {n} drawn robots are unstable, under plain LQR {other}.", **facts)
        gain = 1 - own.worst / plain.worst if math.isfinite(plain.worst) else 0.0
        loss = Quantity(own.nominal / plain.nominal - 1, "fraction")
        if not gain >= WORTH:
            return Say("No better than plain LQR: the worst cost changes by {worst}, the nominal by {nominal}.",
                       worst=Quantity(-gain, "fraction"), nominal=loss)  # fmt: skip
        return Say("Better: the worst cost is {worst} lower than under plain LQR, the nominal changes by {nominal}.",
                   worst=Quantity(gain, "fraction"), nominal=loss)  # fmt: skip

    def words(self) -> list[Say]:
        """The verdict, and what became of the inequalities."""
        other = self.inequalities
        if other is None:
            return [self.verdict(), Say("Linear matrix inequalities prove nothing: {why}.", why=self.why)]
        return [
            self.verdict(),
            Say("Linear matrix inequalities prove a gain of the true state; on sensors {fell} of {n} are unstable.",
                fell=other.fell, n=other.tried),
        ]  # fmt: skip

    def to_json(self) -> dict[str, Any]:
        """Plain numbers; None for what is infinite."""
        costs = {"own": self.own, "plain": self.plain, "inequalities": self.inequalities}
        numbers = {name: {k: finite(v) for k, v in asdict(c).items()} if c else None for name, c in costs.items()}
        return {"method": self.method, "k": self.k.tolist(), **numbers}


def robust(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    *,
    robots: Sequence[Robot] | None = None,
    uncertainty: Uncertainty | None = None,
    largest: Sequence[float] = LARGEST_STATE,
    command: float | None = None,
    tried: int = DRAWN,
    seed: int = 0,
) -> LinearController:
    """One controller on the sensors of `kit` for `robot` and for every one of `robots` (None: `tried` draws).

    Draws are from the `uncertainty` (None: what the robot's sources leave open). Bryson's rule gives the weights:
    `largest` accepted state (6,), largest `command` of each motor. The verdict is over as many draws again that the
    design does not know. Raises `DesignFailed` where no gain stabilises the nominal robot, `MissingTool` without cvxpy.
    """
    require("design robust", "cvxpy")
    robot, kit = find_robot(robot), find_kit(kit)
    near = draw(robot, tried, seed, uncertainty) if robots is None else list(robots)
    fresh = draw(robot, tried, seed + 1, uncertainty) if robots is None else near
    model, *others = [sampled(each, kit, dt, RAW) for each in (robot, *near)]
    task = _Task(robot, model, [plane(other) for other in others], bryson(largest), command)
    best = min((_descended(task, *start) for start in _starts(task)), key=lambda result: result[0])
    unseen = task.over([plane(sampled(each, kit, dt, RAW)) for each in fresh])
    return _chosen(unseen, best[1], [model, *others])


class _Task:
    """What is minimised: the nominal robot first, then the drawn ones."""

    def __init__(
        self, robot: Robot, model: SampledRobot, planes: Sequence[Plane], weight: Array, command: float | None
    ) -> None:
        self.robot, self.sampled, self.weight = robot, model, weight
        self.planes = [plane(model), *planes]
        self.size = command or LARGEST_COMMAND[robot.command_unit]
        self.W = weight[:4, :4]
        self.price = 2 / self.size**2
        self.spread, self.gather = halves([*STATE_NAMES, *sent(model.history)])

    def over(self, planes: Sequence[Plane]) -> _Task:
        """The same over other robots."""
        return _Task(self.robot, self.sampled, planes, self.weight, self.size)

    def loops(self, trust: float) -> tuple[Filter, LoopFamily]:
        """The filter with `trust` [1] times the command as noise, and all loops with it."""
        result = kalman_filter(self.sampled, Disturbed(motor=trust))
        return result, family(self.planes, result)

    def regulator(self, price: float = 1.0) -> Array:
        """Plain LQR (2, 6) at that price of the command."""
        R = price * bryson([self.size] * 2)
        return lqr_state(self.robot, self.sampled.dt, self.weight, R).gain

    def ahead(self, four: Array) -> Array:
        """k (m,) on the filter's plane from four gains on the state when the command arrives."""
        return np.concatenate([four, [0.0, 0.0]]) @ self.sampled.ahead @ self.spread

    def costs(self, k: Array, loops: LoopFamily) -> Costs:
        """The first loop is the nominal robot's."""
        result = loops.costs(k, self.W, self.price)
        return Costs(float(result[0]), float(result.max()), int(np.isinf(result[1:]).sum()), len(result) - 1)


def _starts(task: _Task) -> list[tuple[Array, float]]:
    """The best of several regulators behind several filters, the plain one among them."""
    tried = list(itertools.product(PRICES, TRUSTS))
    made = [(task.regulator(price)[0, :4], trust) for price, trust in tried]
    worst = [_objective(task, four, trust) for four, trust in made]
    return [made[i] for i in np.argsort(worst)[:STARTS]]


def _objective(task: _Task, four: Array, trust: float) -> float:
    try:
        _, loops = task.loops(trust)
    except DesignFailed:
        return math.inf
    k = task.ahead(four)
    result = loops.costs(k, task.W, task.price)
    unstable = np.isinf(result)
    if not unstable.any():
        return float(result.max())
    beyond = np.maximum(loops.some(np.flatnonzero(unstable).tolist()).radii(k) - 1, 0.0)
    stable = float(result[~unstable].max()) if not unstable.all() else 0.0
    return _FELL * float(unstable.sum() + beyond.sum() + _FELL * unstable[0]) + stable


def _descended(task: _Task, four: Array, trust: float) -> tuple[float, tuple[Array, float]]:
    """Nelder and Mead in the logarithms of four gains and the filter's trust."""
    from scipy.optimize import minimize

    def unpacked(z: Array) -> tuple[Array, float]:
        return four * np.exp(z[:4]), float(np.clip(trust * np.exp(z[4]), 1e-3, MOST))

    corners = np.vstack([np.zeros(5), np.diag([0.2, 0.2, 0.3, 0.3, 0.7])])
    options = {"maxfev": STEPS, "initial_simplex": corners, "xatol": 1e-3, "fatol": 1e-9}

    def cost(z: Array) -> float:
        return _objective(task, *unpacked(z))

    result: Any = minimize(cost, np.zeros(5), method="Nelder-Mead", options=options)
    return float(result.fun), unpacked(result.x)


def _chosen(task: _Task, result: tuple[Array, float], near: Sequence[SampledRobot]) -> LinearController:
    """The better of both methods, on robots that neither used."""
    estimator, loops = task.loops(result[1])
    k = task.ahead(result[0])
    method = "scenarios"
    recovered, others = task.loops(RECOVERED.motor)
    own = task.costs(k, loops)
    plain = task.costs(task.ahead(task.regulator()[0, :4]), others)
    proof, other, why = None, None, ""
    try:
        proof = _inequalities(task, near)
        other = task.costs(proof.k, others)
        if other.below(own):
            estimator = recovered
            k = proof.k
            method = "inequalities"
            own = other
    except DesignFailed as error:
        why = str(error).split(";")[0]
    design = Robust(
        filter=estimator, k=k, W=task.W, price=task.price, method=method, own=own, plain=plain, proof=proof,
        inequalities=other, why=why,
    )  # fmt: skip
    return output_feedback(estimator, _both(task, k), "robust", design)


def _inequalities(task: _Task, near: Sequence[SampledRobot]) -> Guaranteed:
    halves_of = [half(each.plant) for each in near]
    models = [(one.A, one.B) for one in halves_of]
    n = len(models[0][0])
    W = np.zeros((n, n))
    start = np.full(n, 0.1 * task.size)
    W[:4, :4], start[:4] = task.W, 1 / np.sqrt(np.diag(task.W))
    return guaranteed(models, W, task.price, start)


def _both(task: _Task, k: Array) -> Array:
    """K (2, 6 + earlier commands): `k` on the pitch plane, plain LQR on the heading."""
    out, into = halves([*STATE_NAMES, *sent(task.sampled.history)], -1.0)
    return np.tile(k @ task.gather, (2, 1)) + task.regulator() @ task.sampled.ahead @ out @ into
