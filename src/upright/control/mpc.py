"""Model predictive control: a condensed quadratic programme for DAQP, solved each period from the last active set.

Let ξ be the regulator's state (six states and the commands on their way) and F the push that the filter estimates. Let
ξ_s and u_s be the steady motion at the reference under that push, so that no offset is left. The controller minimises

    Σ_{i<N} (ξ_i − ξ_s)ᵀQ(ξ_i − ξ_s) + (u_i − u_s)ᵀR(u_i − u_s) + (ξ_N − ξ_s)ᵀP(ξ_N − ξ_s),   ξ⁺ = A ξ + B u,

over u_0 … u_{N−1} within |u| ≤ limit, and, softly, |pitch| ≤ `pitch` and R|θ − θ_r| ≤ `travel`. P is the regulator's
cost, so that without active limits this is the regulator (Rawlings, Mayne and Diehl 2017, sections 1.3 and 1.5).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from importlib import import_module
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from upright.control.controller import ControllerSpec, ShortRepr
from upright.control.delay import RAW, sampled
from upright.control.kalman import Disturbed, kalman_filter, offset_free
from upright.control.linear_controller import LinearController
from upright.control.lqg import Lqg, regulated
from upright.control.observer import memory, steady_push, steady_state
from upright.errors import DesignFailed, InvalidController
from upright.physics.linear import LinearModel
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

NO_LIMIT = 1e30  # what DAQP takes for infinity
SOFT, HARD = 8, 0  # DAQP's names for a constraint that may and one that may not be broken
BOUNDED = 10  # instants of the horizon, evenly spread, at which pitch and travel are bounded


@dataclass(frozen=True, eq=False)
class QuadraticProgram:
    """min ½ UᵀH U + fᵀU over |U| ≤ limit, |rows U + c| ≤ 1, with f and c new in each period.

    U (2N,) holds the commands from now on; `rows` pitch and travel as shares of their bounds, `soft` or not. What
    breaking a soft one by its whole bound costs is 1/(2 softness).
    """

    H: Array
    rows: Array
    limit: float
    soft: bool = True
    softness: float = 1e-3

    def kkt(self, U: Array, f: Array, c: Array, multipliers: Array) -> float:
        """Largest violation of stationarity, relative to f's largest, and of the bounds, by a solution of DAQP.

        A soft row may exceed its bound by `softness` times its multiplier, neither more nor less.
        """
        n = len(self.H)
        gradient = self.H @ U + f + multipliers[:n] + self.rows.T @ multipliers[n:]
        over = np.abs(U).max() / self.limit - 1
        slack = self.softness * np.abs(multipliers[n:]) if self.soft else np.zeros(len(c))
        beyond = np.maximum(np.abs(self.rows @ U + c) - 1, 0.0) - slack
        return float(max(np.abs(gradient).max() / max(np.abs(f).max(), 1.0), over, np.abs(beyond).max(initial=0.0)))


@dataclass(eq=False, repr=False)
class PredictiveController(ShortRepr):
    """The programme with its filter: outputs of `memory` are [f (2N), c, u of the unlimited regulator (2)].

    DAQP may give no solution: a hard limit that cannot be kept, or too many iterations. Then the regulator's command,
    cut at the limit, is used instead, and `failures` counts it.
    """

    memory: LinearController
    programme: QuadraticProgram
    design: Lqg | None = field(default=None, repr=False)
    failures: int = field(default=0, init=False)

    def __post_init__(self) -> None:
        p = self.programme
        n, rows = len(p.H), len(p.rows)
        if p.H.shape != (n, n) or p.rows.shape != (rows, n) or len(self.memory.C) != n + rows + 2:
            raise InvalidController(
                f"H {p.H.shape}, rows {p.rows.shape} and {len(self.memory.C)} outputs do not fit each other",
                expected=f"{n + rows + 2} outputs",
            )
        self._n, self._limit = n, p.limit if math.isfinite(p.limit) else NO_LIMIT
        self._upper = np.concatenate([np.full(n, self._limit), np.ones(rows)])
        self._lower = -self._upper
        self._free = self._upper[n:], self._lower[n:]
        self._ones = np.ones(rows), -np.ones(rows)
        self.reset()

    @property
    def spec(self) -> ControllerSpec:
        return self.memory.spec

    def reset(self) -> None:
        self.memory.reset()
        self.failures = 0
        self._solver = solver(self.programme, self._upper, self._lower)

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        n, outputs = self._n, self.memory.outputs(measurement, reference)
        np.subtract(self._ones[0], outputs[n:-2], self._free[0])
        np.subtract(self._ones[1], outputs[n:-2], self._free[1])
        self._solver.update(f=outputs[:n], bupper=self._upper, blower=self._lower)
        U, _, flag, _ = self._solver.solve()
        if flag > 0:
            left, right = U[:2].tolist()
        else:
            self.failures += 1
            left, right = (min(max(u, -self._limit), self._limit) for u in outputs[-2:].tolist())
        self.memory.decided(left, right)
        return left, right

    def estimate(self) -> Sequence[float]:
        return self.memory.estimate()

    def applied(self, command: Sequence[float]) -> None:
        self.memory.applied(command)

    def solve(self, f: Array, c: Array) -> tuple[Array, float]:
        """U (2N,) and its KKT residual for one f and c, from a fresh start; `DesignFailed` where none is."""
        n = self._n
        upper, lower = np.append(self._upper[:n], 1 - c), np.append(self._lower[:n], -1 - c)
        fresh = solver(self.programme, upper, lower, f)
        U, _, flag, info = fresh.solve()
        if flag <= 0:
            raise DesignFailed(f"DAQP gives no solution (flag {flag})", expected="limits that can be kept")
        return U, self.programme.kkt(U, f, c, info["lam"])

    def check(self) -> float:
        """The largest of the design's residual and the KKT residuals of the programme at rest and far from it."""
        rows = len(self.programme.rows)
        far = self.programme.H @ np.full(self._n, 2 * min(self._limit, 1.0))
        residuals = [self.solve(f, np.zeros(rows))[1] for f in (np.zeros(self._n), far)]
        return max(0.0 if self.design is None else self.design.check(), *residuals)

    def to_json(self) -> dict[str, Any]:
        p = self.programme
        limit = p.limit if math.isfinite(p.limit) else None
        bounds = {"limit": limit, "soft": p.soft, "softness": p.softness}
        matrices = {"H": p.H.tolist(), "rows": p.rows.tolist(), "memory": self.memory.matrices()}
        return self.memory.facts() | bounds | matrices

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> PredictiveController:
        """The inverse of `to_json`; the design's record stays behind."""
        limit = math.inf if data["limit"] is None else data["limit"]
        programme = QuadraticProgram(np.array(data["H"]), np.array(data["rows"]), limit, data["soft"], data["softness"])
        return cls(LinearController.memory_from_json(data), programme)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies get a solver of their own."""
        return PredictiveController, (self.memory, self.programme, self.design)


def solver(programme: QuadraticProgram, upper: Array, lower: Array, f: Array | None = None) -> Any:
    """A DAQP workspace set up for the programme; `DesignFailed` when DAQP refuses it."""
    daqp: Any = import_module("daqp")  # compiled and untyped: `Any` says so to the type checker
    model = daqp.Model()
    n, rows = len(programme.H), len(programme.rows)
    sense = np.array([HARD] * n + [SOFT if programme.soft else HARD] * rows, dtype=np.int32)
    start = np.zeros(n) if f is None else np.array(f)
    flag, _ = model.setup(programme.H, start, programme.rows, upper, lower, sense)
    if flag < 0:
        raise DesignFailed(
            f"DAQP refuses the programme (flag {flag})", expected="a positive definite H", hint="raise R"
        )
    if rows:
        # DAQP would scale the setting rho_soft with the length of each row; weights by constraint mean what they say
        weights = np.full(n + rows, programme.softness)
        model.soft_weights(rho_l=weights, rho_u=weights)
    return model


def mpc(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    horizon: int = 30,
    limit: float | None = None,
    pitch: float = 0.3,
    travel: float = 1.0,
    soft: bool = True,
    reads: tuple[str, ...] = RAW,
    disturbed: Disturbed | None = None,
) -> PredictiveController:
    """The predictive controller of `robot` on the sensors of `kit`, over `horizon` periods.

    Q and R as in `lqg`; `limit` of each command (None: what the kit gives), `pitch` [rad] and `travel` [m] from the
    reference, both soft unless said otherwise; `disturbed` is by default `offset_free`. Raises
    `DesignFailed` like `lqg`, or for bounds that are not positive.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    if horizon not in range(1, 201):
        raise DesignFailed(f"a horizon of {horizon}", expected="between 1 and 200 periods", likely="seconds")
    most = largest_command(robot, kit) if limit is None else limit
    for name, bound in (("limit", most), ("pitch", pitch), ("travel", travel)):
        if not bound > 0:
            raise DesignFailed(f"{name} is {bound}", expected="a positive bound")
    model = sampled(robot, kit, dt, reads)
    design = regulated(kalman_filter(model, disturbed or offset_free(model)), Q, R)
    recursion, H, rows = _condensed(design, horizon, {"pitch": pitch, "wheel": travel / robot.wheel_radius})
    return PredictiveController(recursion, QuadraticProgram(H, rows, most, soft), design)


def largest_command(robot: Robot, kit: Kit) -> float:
    """What the motors are sure to get: the driver's limit, and for volts the battery under both motors at full."""
    full = kit.battery.voltage
    battery = full * (1 - 2 * kit.battery.sag) if robot.command_unit == "V" and math.isfinite(full) else math.inf
    return min(kit.motor.limit, battery)


def predicted(plant: LinearModel, horizon: int) -> tuple[Array, Array]:
    """Φ (N, n, n) and Γ (N, n, 2N) with ξ_i = Φ_i ξ_0 + Γ_i U for i = 1 … N."""
    n, m = plant.B.shape
    free: Array = np.zeros((horizon, n, n))
    forced: Array = np.zeros((horizon, n, m * horizon))
    for i in range(horizon):
        free[i] = plant.A @ free[i - 1] if i else plant.A
        forced[i] = plant.A @ forced[i - 1] if i else 0.0
        forced[i, :, m * i : m * (i + 1)] = plant.B
    return free, forced


def _condensed(design: Lqg, horizon: int, bounds: dict[str, float]) -> tuple[LinearController, Array, Array]:
    """The memory with outputs [f, c, u], H and the rows of the bounds, all in the commands themselves."""
    model = design.filter.sampled
    plant = model.plant
    free, forced = predicted(plant, horizon)
    weights = np.repeat(design.Q[None], horizon, axis=0)
    weights[-1] = design.P
    weighed = weights @ forced
    H: Array = np.tensordot(forced, weighed, ((0, 1), (0, 1))).astype(np.float64) + np.kron(np.eye(horizon), design.R)
    gradient: Array = np.tensordot(weighed, free, ((0, 1), (0, 1))).astype(np.float64)
    (xi_r, u_r), (xi_push, u_push) = steady_state(model), steady_push(model)
    every = np.tile(np.eye(2), (horizon, 1))
    when = np.unique(np.linspace(0, horizon - 1, min(BOUNDED, horizon)).round().astype(int))
    picked = [(STATE_NAMES.index(name), bound) for name, bound in bounds.items()]
    rows = np.vstack([forced[when, index] / bound for index, bound in picked])
    drift = np.vstack([free[when, index] / bound for index, bound in picked])
    lean = np.concatenate([np.full(len(when), float(index == 0)) / bound for index, bound in picked])

    G = np.vstack([gradient, drift, -design.K])
    steady_f, steady_c, steady_u = -H @ every, -rows @ every, np.eye(2)

    def outputs(xi_s: Array, u_s: Array) -> Array:
        offset = np.vstack([steady_f @ u_s, steady_c @ u_s + np.outer(lean, xi_s[0]), steady_u @ u_s])
        return np.asarray(offset - G @ xi_s, dtype=np.float64)

    g = outputs(xi_push[:, None], u_push[:, None])[:, 0]
    return memory(design.filter, G, g, outputs(xi_r, u_r), kind="mpc"), (H + H.T) / 2, rows
