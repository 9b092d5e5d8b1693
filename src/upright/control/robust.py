"""One state feedback for a whole family of robots, by linear matrix inequalities.

For sampled robots (Aᵢ, Bᵢ) of the family, find Q ≻ 0 and Y so that K = −Y Q⁻¹ guarantees the cost of one Lyapunov
function P = Q⁻¹ for all of them (Kothare, Balakrishnan and Morari 1996; Boyd et al. 1994, chapter 7):

    ⎡ Q   (Aᵢ Q + Bᵢ Y)ᵀ   Q W½   Yᵀ R½ ⎤
    ⎢ ·         Q            0       0   ⎥ ⪰ 0   for every i,        J = Σ xᵀWx + uᵀRu ≤ x₀ᵀ P x₀
    ⎢ ·         ·            I       0   ⎥
    ⎣ ·         ·            ·       I   ⎦

and minimise tr(P X₀). The robots are found by scenarios (Calafiore and Campi 2006): the nominal one and a few draws at
first, then the worst of many draws under the gain found, until the worst is in the list.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.control.delay import rolling
from upright.control.feedback import StateFeedback
from upright.control.lqr import LARGEST_COMMAND, LARGEST_STATE, bryson, lqr
from upright.errors import DesignFailed, InvalidRobot, UnknownName
from upright.physics.linear import linearise
from upright.robots import PARAMETERS, Robot

Array = NDArray[np.float64]

GUESSED = 0.2
"""Relative standard deviation of a parameter that its preset calls a guess, or gives no source for."""

FARTHEST = 2.0  # standard deviations: draws beyond are drawn again, as the ends of a robot's parameters are known

_PITCH, _YAW = [0, 1, 2, 3], [4, 5]
_STRICT = 1e-6


def spreads(robot: Robot, guessed: float = GUESSED) -> dict[str, float]:
    """One standard deviation of each uncertain parameter, in its own unit: the preset's, or `guessed` of its value.

    A parameter that is zero by a guess stays zero, since a share of it says nothing.
    """
    found = {
        name: known.spread if known.spread is not None else guessed * abs(value)
        for name, value in robot.numbers().items()
        if (known := robot.provenance.get(name)) and name not in ("body_depth", "body_height", "stiction_rate")
    }
    return {name: size for name, size in found.items() if size > 0}


def draw(
    robot: Robot, count: int, seed: int = 0, sizes: Mapping[str, float] | None = None, covariance: Array | None = None
) -> list[Robot]:
    """`count` robots round `robot`: normal in the parameters named by `sizes` (None: the preset's `spreads`), cut at
    `FARTHEST` deviations. `covariance` (n, n) in the order of `sizes` replaces their squares.

    What no robot can be (`InvalidRobot`) is drawn again. Raises `DesignFailed` where nearly nothing can be.
    """
    chosen = dict(spreads(robot) if sizes is None else sizes)
    for name in chosen:
        if name not in PARAMETERS:
            raise UnknownName("parameter", name, PARAMETERS)
    rng = np.random.Generator(np.random.Philox(seed))
    root = np.diag(list(chosen.values())) if covariance is None else _root(covariance, len(chosen))
    centre = np.array([getattr(robot, name) for name in chosen])
    found: list[Robot] = []
    for _ in range(50 * count + 50):
        if len(found) == count:
            return found
        normal = rng.standard_normal(len(chosen))
        if np.abs(normal).max(initial=0.0) > FARTHEST:
            continue
        drawn = _made(robot, dict(zip(chosen, (centre + root @ normal).tolist(), strict=True)))
        found += [drawn] if drawn else []
    raise DesignFailed(
        f"of {50 * count} draws only {len(found)} are robots", expected="spreads well below the values",
        mend="name smaller spreads",
    )  # fmt: skip


def _root(covariance: Array, size: int) -> Array:
    values, vectors = np.linalg.eigh(np.asarray(covariance, dtype=np.float64))
    if len(values) != size or values[0] < -1e-9 * max(values[-1], 0.0):
        raise DesignFailed("the covariance is not one", expected=f"a symmetric, non-negative ({size}, {size}) matrix")
    return vectors * np.sqrt(np.maximum(values, 0.0))


def _made(robot: Robot, changes: dict[str, float]) -> Robot | None:
    try:
        return robot.replace(**changes)
    except InvalidRobot:
        return None


@dataclass(frozen=True, eq=False)
class Robust(StateFeedback):
    """A gain for all of `robots`, with the Lyapunov matrix P (6, 6) that proves it, beside the plain LQR of the first.

    `models` holds each robot's (A, B). Costs are tr(P X₀) for initial deviations of Bryson's size, infinite where the
    loop is unstable, over `tried` draws that the design has not seen: `nominal`, `worst` and `fell` (how many of them
    are unstable) for this gain and for `plain`.
    """

    models: Sequence[tuple[Array, Array]] = field(kw_only=True)
    P: Array = field(kw_only=True)
    W: Array = field(kw_only=True)
    R: Array = field(kw_only=True)
    own: Costs = field(kw_only=True)
    plain: Costs = field(kw_only=True)

    def check(self) -> float:
        """By how much the largest eigenvalue of (A − BK)ᵀP(A − BK) − P + W + KᵀRK exceeds zero, relative to P's
        largest.

        Zero or less proves stability and the cost for every robot of the list under one Lyapunov function.
        """
        K = self.gain
        price = self.W + K.T @ self.R @ K - self.P
        sums = [(A - B @ K).T @ self.P @ (A - B @ K) + price for A, B in self.models]
        largest = max(float(np.linalg.eigvalsh((S + S.T) / 2)[-1]) for S in sums)
        return max(0.0, largest / float(np.linalg.eigvalsh(self.P)[-1]))

    def verdict(self) -> str:
        """Whether it was worth it, in one sentence."""
        if self.own.fell < self.plain.fell:
            fell, other = self.own.fell, self.plain.fell
            return f"Better: {fell} of {self.own.tried} drawn robots are unstable, under plain LQR {other}."
        gain = 1 - self.own.worst / self.plain.worst if math.isfinite(self.plain.worst) else 0.0
        loss = self.own.nominal / self.plain.nominal - 1
        if gain < WORTH:
            return f"No better than plain LQR: the worst cost changes by {-gain:+.1%}, the nominal by {loss:+.1%}."
        return f"Better: the worst cost is {gain:.1%} lower than under plain LQR, the nominal {loss:.1%} higher."


WORTH = 0.01
"""A worst case that is better by less than this share counts as no better."""


@dataclass(frozen=True)
class Costs:
    """Cost for the nominal robot, for the worst of `tried`, and how many of those are unstable."""

    nominal: float
    worst: float
    fell: int
    tried: int


def robust(
    robot: Robot,
    dt: float = 0.01,
    *,
    robots: Sequence[Robot] | None = None,
    largest: Sequence[float] = LARGEST_STATE,
    command: float | None = None,
    tried: int = 200,
    seed: int = 0,
) -> Robust:
    """One gain for `robot` and for every one of `robots` (None: `tried` draws from its spreads), held over `dt` [s].

    Bryson's rule gives the weights: `largest` accepted state (6,), largest `command` of each motor. The verdict is over
    as many draws again that the design has not seen. Raises `DesignFailed` where no gain serves them all.
    """
    family = [robot, *(draw(robot, tried, seed) if robots is None else robots)]
    fresh = draw(robot, tried, seed + 1) if robots is None else list(robots)
    W = bryson(largest)
    R = bryson([command or LARGEST_COMMAND[robot.command_unit]] * 2)
    models = [_model(each, dt) for each in family]
    gain, P, chosen = _scenarios(models, W, R)
    plain = lqr(rolling(robot), dt, W, R).gain
    unseen = [models[0], *(_model(each, dt) for each in fresh)]
    own, other = (_costs(unseen, K, W, R) for K in (gain, plain))
    listed = [models[i] for i in chosen]
    return Robust(
        gain, dt, robot.command_unit, "robust", models=listed, P=P, W=W, R=R, own=own, plain=other
    )  # fmt: skip


def _model(robot: Robot, dt: float) -> tuple[Array, Array]:
    model = linearise(rolling(robot)).c2d(dt)
    return model.A, model.B


def _scenarios(models: Sequence[tuple[Array, Array]], W: Array, R: Array) -> tuple[Array, Array, list[int]]:
    """The gain, its Lyapunov matrix, and which robots were needed to find it."""
    chosen = list(range(min(_FIRST, len(models))))
    for last in range(_ROUNDS, -1, -1):
        gain, P = _one_gain([models[i] for i in chosen], W, R)
        excess = np.array([_excess(A, B, gain, P, W, R) for A, B in models])
        if excess[chosen].max() > _STRICT:
            raise _no_gain("Clarabel's gain breaks its own inequalities", len(chosen))
        worst = [int(i) for i in np.argsort(-excess)[:_ADDED] if excess[i] > _STRICT and i not in chosen]
        if not worst or not last:
            return gain, P, chosen
        chosen += worst
    raise AssertionError


def _excess(A: Array, B: Array, K: Array, P: Array, W: Array, R: Array) -> float:
    closed = A - B @ K
    return float(np.linalg.eigvalsh(closed.T @ P @ closed - P + W + K.T @ R @ K)[-1] / np.linalg.eigvalsh(P)[-1])


_FIRST, _ADDED, _ROUNDS = 12, 8, 8


def _one_gain(models: Sequence[tuple[Array, Array]], W: Array, R: Array) -> tuple[Array, Array]:
    """Pitch under both motors alike and yaw under both opposed are two problems, since the robot is symmetric."""
    gain, P = np.zeros((2, 6)), np.zeros((6, 6))
    for states, sides in ((_PITCH, np.array([1.0, 1.0])), (_YAW, np.array([-1.0, 1.0]))):
        block = np.ix_(states, states)
        parts = [(A[block], B[states] @ sides[:, None]) for A, B in models]
        k, p = _guaranteed(parts, W[block], float(sides @ R @ sides))
        gain[:, states], P[block] = np.outer(sides, k), p
    return gain, P


def _guaranteed(models: Sequence[tuple[Array, Array]], W: Array, price: float) -> tuple[Array, Array]:
    """k (n,) and P (n, n) of least tr(P X₀) for one input, where the first robot's own P is made the identity."""
    import cvxpy as cp
    from cvxpy.error import SolverError
    from scipy.linalg import solve_discrete_are

    n, size = len(W), 1 / math.sqrt(price)
    T = np.linalg.cholesky(solve_discrete_are(*models[0], W, np.array([[price]]))).T
    back = np.linalg.inv(T)
    deviation = np.diag(np.sqrt(np.diag(W))) @ back
    start = T @ np.diag(1 / np.sqrt(np.diag(W)))
    Q, Y, Z = cp.Variable((n, n), symmetric=True), cp.Variable((1, n)), cp.Variable((n, n), symmetric=True)
    rules: list[Any] = [cp.bmat([[Z, start.T], [start, Q]]) >> 0]
    for A, B in models:
        after = (T @ A @ back) @ Q + (T @ B * size) @ Y
        none, column = np.zeros((n, n)), np.zeros((n, 1))
        rows = [
            [Q, after.T, Q @ deviation.T, Y.T],
            [after, Q, none, column],
            [deviation @ Q, none, np.eye(n), column],
            [Y, column.T, column.T, np.eye(1)],
        ]
        rules.append(cp.bmat(rows) >> 0)
    problem = cp.Problem(cp.Minimize(cp.trace(Z) / float(np.sum(start**2))), rules)
    try:
        with warnings.catch_warnings():  # what is inaccurate is measured by whoever uses it
            warnings.simplefilter("ignore", UserWarning)
            problem.solve(solver=cp.CLARABEL, tol_gap_abs=1e-7, tol_gap_rel=1e-7, tol_feas=1e-9)
    except SolverError:
        raise _no_gain("Clarabel gave up", len(models)) from None
    if problem.status not in ("optimal", "optimal_inaccurate") or Q.value is None or Y.value is None:
        raise _no_gain(f"Clarabel says: {problem.status}", len(models))
    P = np.linalg.inv((Q.value + Q.value.T) / 2)
    return -(Y.value @ P @ T)[0] * size, T.T @ P @ T


def _no_gain(why: str, count: int) -> DesignFailed:
    return DesignFailed(
        f"no one gain is found for {count} robots ({why})", expected="robots near enough to each other",
        likely="spreads too wide for quadratic stability", mend="narrow the spreads, or shorten the period",
    )  # fmt: skip


def _costs(models: Sequence[tuple[Array, Array]], K: Array, W: Array, R: Array) -> Costs:
    """The nominal robot is the first."""
    costs = [_cost(A - B @ K, W + K.T @ R @ K, W) for A, B in models]
    return Costs(costs[0], max(costs), sum(math.isinf(c) for c in costs[1:]), len(costs) - 1)


def _cost(closed: Array, price: Array, W: Array) -> float:
    from scipy.linalg import solve_discrete_lyapunov

    if np.abs(np.linalg.eigvals(closed)).max() >= 1:
        return math.inf
    P = solve_discrete_lyapunov(closed.T, price)
    return float(np.trace(P @ np.diag(1 / np.diag(W))))
