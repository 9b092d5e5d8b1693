"""Bounds on the structured singular value over a robot's parameter intervals.

The sampled robot is approximated as affine in its parameters: M(δ) = M₀ + Σ δᵢ Mᵢ with M = [A B; C D]. At the ends of
each interval |δᵢ| = 1. The Mᵢ are central differences, and the error of the approximation is measured. Let Mᵢ = Lᵢ Rᵢ,
of the rank of Mᵢ. The loop is stable for every δ in the box if μ of the transfer from w = δ z to z stays below one on
the unit circle (Packard and Doyle 1993). Upper bound: `scaling`, where each parameter is a repeated real number. Lower
bound: the smallest box with an unstable corner, among random corners and those along the slope of the largest pole.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from upright.arrays import Array, Complex
from upright.errors import InvalidModel, InvalidRobot
from upright.loops.loop import Loop, RobotLoop
from upright.loops.margins import SLOWEST
from upright.loops.scaling import Block, Scaling, balanced, best_scaling
from upright.physics.interconnect import lft
from upright.physics.linear import LinearModel
from upright.robots.uncertainty import deviations

POINTS = 100

REACH = 2.0
"""Standard deviations from the middle of an interval to its ends: 95 % of a normal distribution."""

_SMALL = 1e-6  # a parameter that moves no entry of M by more than this fraction of the largest move does not count
_RANK = 1e-3  # singular values below this fraction of a parameter's largest are left out
_REFINED = 30  # frequencies at which the quick bound is replaced by the best, at most
_CORNERS = 200
_CLIMBS = 8  # times that the corner is corrected by the slope at its own edge of stability, at most
_FAR = 64.0  # the largest multiple of the box that is looked into


@dataclass(frozen=True)
class Mu:
    """`lower` ≤ μ ≤ `upper` over all frequencies, in units of the given intervals [1].

    The loop is stable for every robot within 1/upper of the intervals. It is unstable for the robot `worst` (parameter
    → value) at 1/lower of them. `ranks` is the rank of each parameter's Mᵢ. `curvature` [1] is the distance of the
    robots at the ends of single intervals from the affine model, over their distance from the nominal robot.
    """

    lower: float
    upper: float
    frequency: float
    ranks: Mapping[str, int]
    worst: Mapping[str, float]
    curvature: float

    def words(self) -> str:
        """One sentence."""
        sure = f"is stable within {1 / self.upper:.2f} of the intervals" if self.upper else "is always stable"
        fails = (
            f"unstable at {1 / self.lower:.2f} of them" if self.lower else f"no unstable robot up to {_FAR:g} of them"
        )
        return f"{sure}; {fails}."

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        numbers = {"lower": self.lower, "upper": self.upper, "frequency": self.frequency, "curvature": self.curvature}
        return numbers | {"ranks": dict(self.ranks), "worst": dict(self.worst)}


def parameter_mu(loop: RobotLoop, intervals: Mapping[str, float] | None = None, points: int = POINTS) -> Mu:
    """μ of the loop over `intervals`, half-widths by parameter (None: `REACH` standard deviations).

    Infinite bounds where the nominal loop is unstable.
    """
    chosen = dict(intervals or {name: REACH * size for name, size in deviations(loop.robot).items()})
    slopes, curvature = _slopes(loop, chosen)
    factors = {name: _factors(slope) for name, slope in slopes.items()}
    ranks = {name: L.shape[1] for name, (L, _) in factors.items()}
    if not loop.stable:
        return Mu(math.inf, math.inf, 0.0, ranks, {}, curvature)
    N = _uncertain(loop, list(factors.values()))
    blocks = [(rank, True) for rank in ranks.values()]
    lower, signs = _lower(loop, slopes)
    fastest = math.pi / loop.plant.dt
    crossing = _crossing(loop, slopes, signs, lower) if lower else 0.0
    grid = np.array([0.0, *np.geomspace(SLOWEST, fastest, points), crossing])  # μ of real numbers may jump at z = ±1
    upper, at = _peak(N.matrices(grid), blocks)
    nominal = loop.robot
    worst = {n: getattr(nominal, n) + sign * chosen[n] / lower for n, sign in signs.items()} if lower else {}
    return Mu(lower, max(upper, lower), float(grid[at]), ranks, worst, curvature)


def _peak(matrices: Complex, blocks: Sequence[Block]) -> tuple[float, int]:
    """The largest bound over all frequencies and where. The largest is refined until it has been; what a scaling proves
    at one frequency it is tried for at all."""
    bounds = balanced(matrices, blocks)[0]
    refined = dict[int, Scaling]()
    while (at := int(np.argmax(bounds))) not in refined and len(refined) < _REFINED:
        near = min(refined, key=lambda i: abs(i - at), default=None)
        refined[at] = best_scaling(matrices[at], blocks, refined[near] if near is not None else None)
        bounds = np.minimum(bounds, refined[at].bounds(matrices))
    return float(bounds[at]), at


def _slopes(loop: RobotLoop, chosen: Mapping[str, float]) -> tuple[dict[str, Array], float]:
    """Mᵢ of each parameter that counts, and the largest fraction of curvature."""
    result: dict[str, Array] = {}
    curvature = 0.0
    centre = _stacked(loop.plant)
    for name, width in chosen.items():
        high, low, fraction = _ends(loop, name, width)
        result[name], bend = (high - low) / (2 * fraction), ((high + low) / 2 - centre) / fraction**2
        scale = np.linalg.norm(result[name])
        curvature = max(curvature, float(np.linalg.norm(bend) / scale) if scale > 0 else 0.0)
    largest = max((np.abs(slope).max() for slope in result.values()), default=0.0)
    return {name: slope for name, slope in result.items() if np.abs(slope).max() > _SMALL * largest}, curvature


def _ends(loop: RobotLoop, name: str, width: float) -> tuple[Array, Array, float]:
    """The robot at both ends of an interval, or of the share of it whose ends are robots."""
    value = getattr(loop.robot, name)
    for fraction in (1.0, 0.5, 0.25, 0.1, 0.01):
        try:
            ends = [loop.on(loop.robot.replace(**{name: value + sign * fraction * width})) for sign in (1.0, -1.0)]
            high, low = (_stacked(end.plant) for end in ends)
        except InvalidRobot:
            continue
        return high, low, fraction
    raise InvalidModel(
        f"{name} = {value:g} ± {width:g} leaves what a robot can be", hint=f"narrow the interval of {name}"
    )


def _stacked(system: LinearModel) -> Array:
    return np.block([[system.A, system.B], [system.C, system.D]])


def _factors(slope: Array) -> tuple[Array, Array]:
    """L (·, r) and R (r, ·) with L R = `slope` and r its rank."""
    U, s, V = np.linalg.svd(slope)
    rank = int((s > _RANK * s[0]).sum())
    root = np.sqrt(s[:rank])
    return U[:, :rank] * root, root[:, None] * V[:rank]


def _uncertain(loop: Loop, factors: Sequence[tuple[Array, Array]]) -> LinearModel:
    """From w to z with the loop closed: x⁺ = A x + B u + L₁ w, y = C x + L₂ w, z = R₁ x + R₂ u, u = K y (D = 0)."""
    P = loop.plant
    n = len(P.A)
    L, R = np.hstack([left for left, _ in factors]), np.vstack([right for _, right in factors])
    B = np.hstack([L[:n], P.B])
    C = np.vstack([R[:, :n], P.C])
    D = np.block([[np.zeros((len(R), L.shape[1])), R[:, n:]], [L[n:], P.D]])
    return lft(LinearModel(P.A, B, C, D, P.dt), loop.controller)


def _lower(loop: Loop, slopes: Mapping[str, Array]) -> tuple[float, dict[str, float]]:
    """1/k of the smallest corner k·δ, δ = ±1 each, found unstable, and its signs; zero where none is up to `_FAR`."""
    names = list(slopes)
    stack = np.array(list(slopes.values()))
    rng = np.random.Generator(np.random.Philox(0))
    signs = rng.choice([-1.0, 1.0], size=(_CORNERS, len(names)))
    closer = _FAR
    best = np.zeros(len(names))
    for corner in [*signs, *_uphill(loop, stack, np.zeros(len(names)))]:
        closer, best = _nearer(loop, stack, corner, closer, best)
    for _ in range(_CLIMBS):
        before = closer
        for corner in _uphill(loop, stack, closer * best):
            closer, best = _nearer(loop, stack, corner, closer, best)
        if closer > before * (1 - 1e-3):
            break
    result = bool(best.any())
    return (1 / closer, dict(zip(names, best.tolist(), strict=True))) if result else (0.0, {})


def _nearer(loop: Loop, stack: Array, corner: Array, closer: float, best: Array) -> tuple[float, Array]:
    """The size at which a corner turns unstable, and the corner, where that is below `closer`."""
    move = np.tensordot(corner, stack, 1)
    if abs(_worst_pole(loop, closer * move)) < 1:
        return closer, best
    low = 0.0
    high = closer
    for _ in range(24):
        middle = (low + high) / 2
        low, high = (middle, high) if abs(_worst_pole(loop, middle * move)) < 1 else (low, middle)
    return high, corner


def _uphill(loop: Loop, stack: Array, here: Array) -> list[Array]:
    """The corner towards which the spectral radius grows from `here` (parameters,), and its opposite."""
    at = np.tensordot(here, stack, 1)
    step = 1e-3
    ends = [[abs(_worst_pole(loop, at + sign * step * slope)) for sign in (1.0, -1.0)] for slope in stack]
    uphill = np.array([1.0 if up >= down else -1.0 for up, down in ends])
    return [uphill, -uphill]


def _crossing(loop: Loop, slopes: Mapping[str, Array], signs: Mapping[str, float], lower: float) -> float:
    """The frequency [rad/s] at which the worst corner's pole leaves the unit circle."""
    move = sum(signs[name] / lower * slope for name, slope in slopes.items())
    return float(abs(np.angle(_worst_pole(loop, np.asarray(move)))) / loop.plant.dt)


def _worst_pole(loop: Loop, move: Array) -> complex:
    """Of the loop whose plant [A B; C D] is changed by `move`: the pole of the largest size."""
    P = loop.plant
    n = len(P.A)
    M = _stacked(P) + move
    changed = LinearModel(M[:n, :n], M[:n, n:], M[n:, :n], M[n:, n:], P.dt)
    return complex(Loop(changed, loop.controller).poles()[0])
