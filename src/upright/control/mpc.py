"""Model predictive control as a fixed number of iterations, the same statements on every machine.

Let ξ be the regulator's state (six states and the commands on their way) and F the push that the filter estimates. Let
ξ_s and u_s be the steady motion at the reference under that push, so that no offset is left. The controller minimises

    Σ_{i<N} (ξ_i − ξ_s)ᵀQ(ξ_i − ξ_s) + (u_i − u_s)ᵀR(u_i − u_s) + (ξ_N − ξ_s)ᵀP(ξ_N − ξ_s),   ξ⁺ = A ξ + B u,

within |u| ≤ limit, and, softly, |pitch| ≤ `pitch` and R|θ − θ_r| ≤ `travel` (Rawlings, Mayne and Diehl 2017, sections
1.3 and 1.5). K and P are the regulator's, and u_i − u_s = −K (ξ_i − ξ_s) + c_i, so that Σ c_iᵀ(R + BᵀPB)c_i is to be
minimised, and c = 0 is its minimum where no limit is reached (Rossiter, Kouvaritakis and Rice 1998).

Nothing here is exact. c is constant in blocks of 1, 1, 2, 4, … periods (Cagienard et al. 2007); limits count at the
start of each block, bounds at its end, for all of its periods. `Splitting` then iterates a fixed number of times. Six
iterations, where a limit or a bound counts: on nxtway-gs 96 % of the commands are within 1 % of the limit of the exact
minimum by DAQP, the worst is 3 % off; on twipr, where the bound of pitch counts, 63 % and 8 % (`benchmarks/mpc.py`,
docs/extend.md). At the limit of iterations the command is that of the last one: it is always within its
limit, and `residual` is by how much that iteration still moved it. A period takes some 2700 products.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from upright.arrays import Array
from upright.control.delay import sampled
from upright.control.kalman import Disturbed, kalman_filter, offset_free
from upright.control.linear_controller import Law, LinearController, Remembering
from upright.control.lqg import Lqg, regulated
from upright.control.observer import memory, steady_push, steady_state
from upright.control.reach import largest_command
from upright.control.splitting import MOST_ITERATIONS, Splitting
from upright.errors import DesignFailed, InvalidController
from upright.robots import Kit, Robot, find_kit, find_robot
from upright.signals import STATE_NAMES

HORIZON = 30  # periods
UNLIMITED = 1e9  # [V or N m] in place of no limit: more than any driver gives
SOFTNESS = 3e-3  # breaking a bound by all of it costs 1/(2 · SOFTNESS) a period
BOUND_WEIGHT = 0.2  # weight of a bound in the splitting, over that of breaking it


@dataclass(eq=False, repr=False)
class PredictiveController(Remembering):
    """The `splitting` behind its filter: the outputs of `memory` are g (m,), what it limits under the regulator alone.

    `residual` [1] is by how much a last iteration has moved a command at most since the reset, as a fraction of the
    limit; 0 where nothing was limited. It is no bound of the distance to the exact minimum.
    """

    form: ClassVar[str] = "mpc"
    memory: LinearController
    splitting: Splitting
    design: Lqg | None = field(default=None, repr=False)
    residual: float = field(default=0.0, init=False)

    def __post_init__(self) -> None:
        m = len(self.splitting.ease)
        if len(self.memory.C) != m:
            raise InvalidController(f"{len(self.memory.C)} outputs of the memory", expected=f"{m}, as in the splitting")
        self._none = np.zeros(m)
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._pull = self._none
        self.residual = 0.0

    def step(self, measurement: Array, reference: Array) -> tuple[float, float]:
        free = self.memory.outputs(measurement, reference)
        limit = self.splitting.limit
        v, self._pull, pull = free, self._none, self._pull
        if max(free.max(), -free.min()) > 1:
            v, moved = self.splitting.iterated(free, pull)
            self._pull, self.residual = v - free, max(self.residual, moved)
        left, right = (min(max(limit * u, -limit), limit) for u in v[:2].tolist())
        self.memory.decided(left, right)
        return left, right

    @property
    def limited(self) -> bool:
        """Whether a limit or a bound counted in the last step."""
        return self._pull is not self._none

    def check(self) -> float:
        """The largest of the design's residual and of what is left after `MOST_ITERATIONS` squared, far from rest."""
        s = self.splitting
        signs = np.where(np.arange(len(s.ease)) % 2, -2.0, 2.0)
        left = max(s.iterated(g, self._none, MOST_ITERATIONS**2)[1] for g in (signs, np.abs(signs)))
        return max(super().check(), left)

    def law(self) -> Law:
        m = self.memory
        return m.law_with(self.splitting, self.splitting.limit * np.eye(2, len(m.C)), slice(None))

    def to_json(self) -> dict[str, Any]:
        return self.memory.facts() | {"splitting": self.splitting.to_json(), "memory": self.memory.matrices()}

    @classmethod
    def from_json(cls, data: dict[str, Any]) -> PredictiveController:
        """The inverse of `to_json`; the design's record stays behind. A file of before the splitting is refused."""
        if "splitting" not in data:
            raise InvalidController("an mpc of an earlier version", expected="its splitting", hint="design it again")
        s = data["splitting"]
        splitting = Splitting(s["projection"], s["shift"], np.array(s["ease"]), s["limit"], s["iterations"])
        return cls(LinearController.memory_from_json(data), splitting)

    def __reduce__(self) -> tuple[Any, ...]:
        """Copies begin anew."""
        return PredictiveController, (self.memory, self.splitting, self.design)


def mpc(
    robot: Robot | str,
    kit: Kit | str,
    dt: float | None = None,
    Q: ArrayLike | None = None,
    R: ArrayLike | None = None,
    *,
    horizon: int = HORIZON,
    limit: float | None = None,
    pitch: float = 0.3,
    travel: float = 1.0,
    iterations: int = 6,
    blocks: Sequence[int] | None = None,
    reads: tuple[str, ...] | None = None,
    disturbed: Disturbed | None = None,
) -> PredictiveController:
    """The predictive controller of `robot` on the sensors of `kit`, over `horizon` periods.

    Q and R as in `lqg`; `limit` of each command (None: what the kit gives), `pitch` [rad] and `travel` [m] from the
    reference, both soft, the latter only where encoders show it; the `iterations` in a period; `blocks` [periods],
    which sum to the horizon, by default `doubling`; `disturbed` is by default `offset_free`. Raises `DesignFailed`
    like `lqg`, or for bounds that are not positive.
    """
    robot, kit = find_robot(robot), find_kit(kit)
    if horizon not in range(1, 201):
        raise DesignFailed(f"a horizon of {horizon}", expected="between 1 and 200 periods", likely="seconds")
    if iterations not in range(1, MOST_ITERATIONS + 1):
        raise DesignFailed(f"{iterations} iterations", expected=f"1 to {MOST_ITERATIONS}")
    lengths = doubling(horizon) if blocks is None else tuple(blocks)
    if min(lengths, default=0) < 1 or sum(lengths) != horizon:
        raise DesignFailed(f"blocks of {lengths} periods", expected=f"whole numbers that sum to {horizon}")
    most = largest_command(robot, kit) if limit is None else limit
    for name, bound in (("limit", most), ("pitch", pitch), ("travel", travel)):
        if not bound > 0:
            raise DesignFailed(f"{name} is {bound}", expected="a positive bound")
    model = sampled(robot, kit, dt, reads)
    design = regulated(kalman_filter(model, disturbed or offset_free(model)), Q, R)
    bounds = {"pitch": pitch, "wheel": travel / robot.wheel_radius}
    bounds = {name: bound for name, bound in bounds.items() if name not in model.hidden}
    return _split(design, lengths, bounds, limit=min(most, UNLIMITED), iterations=iterations)


def doubling(horizon: int) -> tuple[int, ...]:
    """Lengths 1, 1, 2, 4, … [periods] of blocks, the last one what is left of `horizon`."""
    lengths = [1]
    while (left := horizon - sum(lengths)) > 0:
        lengths.append(min(sum(lengths), left))
    return tuple(lengths)


def _split(
    design: Lqg, lengths: Sequence[int], bounds: dict[str, float], *, limit: float, iterations: int
) -> PredictiveController:
    """The controller from its regulator: g = Gx (ξ − ξ_s) + what the steady motion itself takes, and the splitting."""
    model = design.filter.sampled
    K = design.K
    plant = model.plant
    n = len(lengths)
    W = design.R + plant.B.T @ design.P @ plant.B
    starts = np.concatenate([[0], np.cumsum(lengths)[:-1]])
    ends = np.cumsum(lengths) - 1
    free, forced = predicted(plant.A - plant.B @ K, plant.B, lengths)
    chosen = np.kron(np.eye(n), np.eye(2)).reshape(n, 2, 2 * n)
    picked = [(STATE_NAMES.index(name), bound) for name, bound in bounds.items()]
    # limits at the starts of the blocks, then each bound at their ends
    G = np.vstack([*((chosen - K @ forced[starts]) / limit), *(forced[ends + 1, i] / b for i, b in picked)])
    Gx = np.vstack([*(-K @ free[starts] / limit), *(free[ends + 1, i] / b for i, b in picked)])
    steady_u = np.vstack([np.tile(np.eye(2) / limit, (n, 1)), np.zeros((len(bounds) * n, 2))])
    steady_pitch = np.concatenate([np.zeros(2 * n), *(np.full(n, (i == 0) / b) for i, b in picked)])

    def outputs(xi_s: Array, u_s: Array) -> Array:
        return np.asarray(steady_u @ u_s + np.outer(steady_pitch, xi_s[0]) - Gx @ xi_s, dtype=np.float64)

    (xi_r, u_r), (xi_push, u_push) = steady_state(model), steady_push(model)
    g = outputs(xi_push[:, None], u_push[:, None])[:, 0]
    H = np.kron(np.diag(lengths), W)
    soft = np.arange(len(G)) >= 2 * n
    rho = np.where(soft, BOUND_WEIGHT / SOFTNESS * np.tile(lengths, 2 + len(bounds)), limit**2 * np.trace(W))
    projection = np.asarray(G @ np.linalg.solve(H + G.T @ (rho[:, None] * G), G.T * rho), dtype=np.float64)
    shift = np.zeros_like(projection)
    shift[: 2 * n, : 2 * n] = np.kron(_shifted(starts, lengths[-1]), np.eye(2))
    for first in range(2 * n, len(G), n):
        rows = slice(first, first + n)
        shift[rows, rows] = _shifted(ends, lengths[-1])
    ease = np.where(soft, BOUND_WEIGHT / (1 + BOUND_WEIGHT), 0.0)
    recursion = memory(design.filter, Gx, g, outputs(xi_r, u_r), kind="mpc")
    return PredictiveController(recursion, Splitting(projection, shift, ease, limit, iterations), design)


def predicted(A: Array, B: Array, lengths: Sequence[int]) -> tuple[Array, Array]:
    """Φ (N + 1, n, n) and Γ (N + 1, n, 2 blocks) with ξ_i = Φ_i ξ_0 + Γ_i c, ξ⁺ = A ξ + B c, c constant in blocks."""
    free = [np.eye(len(A))]
    forced = [np.zeros((len(A), 2 * len(lengths)))]
    for block in np.repeat(np.arange(len(lengths)), lengths).tolist():
        free.append(A @ free[-1])
        forced.append(A @ forced[-1])
        forced[-1][:, 2 * block : 2 * block + 2] += B
    return np.array(free), np.array(forced)


def _shifted(times: Array, last: int) -> Array:
    """(k, k): what was planned at `times` [periods], read one period later; it ends `last` periods after the last."""
    gaps = 1 / np.append(np.diff(times), last)
    return np.diag(1 - gaps) + np.diag(gaps[:-1], 1)
