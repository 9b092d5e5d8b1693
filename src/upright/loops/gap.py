"""The distance of two robots for feedback, Vinnicombe's ν-gap, and the gap that a loop tolerates, b(P, C).

If C stabilises P₁ and δ_ν(P₁, P₂) < b(P₁, C), then C stabilises P₂ too (Vinnicombe 1993, "Frequency domain uncertainty
and the graph topology"; Zhou and Doyle 1998, chapter 17). Everything is computed in continuous time. A discrete system
is mapped by z = (1 + s)/(1 − s): the unit circle becomes the imaginary axis, and both numbers stay the same. Scale
inputs and outputs to comparable size first, since both numbers depend on their units.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from upright.arrays import Array, Complex
from upright.control.state_space import continuous
from upright.errors import DesignFailed, InvalidModel
from upright.loops.loop import Loop
from upright.loops.margins import peak
from upright.physics.linear import LinearModel

GRID = 1500
"""Frequencies looked at, before the peak is refined and the winding is followed."""

_TOUCHES = 1e-7  # a determinant as small as this against its largest is zero: the gap is one
HIDDEN = 1e-12  # of a singular value of co-inner factors, which are at most 1: rounding
_INFINITE = 1e6  # times the highest frequency of the grid: there only D is left


@dataclass(frozen=True, eq=False)
class Graph:
    """The normalised graph symbols of a system: [N; M] with P = N M⁻¹, and [−M̃, Ñ] with P = M̃⁻¹ Ñ.

    X and Z solve the control and the filter Riccati equation.
    """

    right: LinearModel
    left: LinearModel
    X: Array
    Z: Array

    @property
    def best_margin(self) -> float:
        """The largest b(P, C) of any controller: 1/√(1 + λ_max(X Z)) (Glover and McFarlane 1989)."""
        return 1 / math.sqrt(1 + float(np.abs(np.linalg.eigvals(self.X @ self.Z)).max(initial=0.0)))


@lru_cache(maxsize=2)  # one system is compared with many
def graph(system: LinearModel) -> Graph:
    """Normalised coprime factors (Zhou and Doyle 1998, theorem 13.22); `DesignFailed` for a hidden unstable mode."""
    P = continuous(system)
    A, B, C, D = P.A, P.B, P.C, P.D
    p, m = D.shape
    R = np.eye(m) + D.T @ D
    S = np.eye(p) + D @ D.T
    drift = A - B @ np.linalg.solve(R, D.T @ C)
    X = _care(drift, B, C.T @ np.linalg.solve(S, C), R)
    Z = _care(drift.T, C.T, B @ np.linalg.solve(R, B.T), S)
    F = -np.asarray(np.linalg.solve(R, B.T @ X + D.T @ C), dtype=np.float64)
    H = -np.asarray(np.linalg.solve(S, C @ Z + D @ B.T), dtype=np.float64).T
    scale, row = _inverse_root(R), _inverse_root(S)
    right = LinearModel(A + B @ F, B @ scale, np.vstack([C + D @ F, F]), np.vstack([D @ scale, scale]))
    left = LinearModel(A + H @ C, np.hstack([H, -(B + H @ D)]), -row @ C, np.hstack([-row, row @ D]))
    return Graph(right, left, X, Z)


def nu_gap(first: LinearModel, second: LinearModel) -> float:
    """δ_ν between two systems with the same inputs and outputs and the same period: 0 for equal ones, 1 at most.

    Raises `InvalidModel` for systems that cannot be compared.
    """
    if first.D.shape != second.D.shape or first.dt != second.dt:
        raise InvalidModel(
            f"systems of {first.D.shape} at {first.dt} s and {second.D.shape} at {second.dt} s",
            expected="as many inputs and outputs and the same period",
        )
    one, two = graph(first), graph(second)

    def overlap(w: Array) -> Complex:
        return np.linalg.det(_dagger(two.right.matrices(w)) @ one.right.matrices(w))

    def chordal(w: Array) -> Array:
        return np.linalg.norm(two.left.matrices(w) @ one.right.matrices(w), 2, axis=(1, 2))

    grid = _grid(first, second)
    if _winding(overlap, grid) != 0:
        return 1.0
    return min(1.0, peak(chordal, grid))


def stability_margin(loop: Loop) -> float:
    """b(P, C) of u = K y round P: 1/‖[P; I](I − K P)⁻¹[−K, I]‖∞, zero where the loop is unstable.

    Above about 0.3 it is generous, below 0.1 it is thin.
    """
    if not loop.stable:
        return 0.0
    P, K = continuous(loop.plant), continuous(loop.controller)
    one, other = graph(P), graph(K)
    m = P.D.shape[1]

    def size(w: Array) -> Array:
        plant = one.right.matrices(w)
        back = np.roll(other.left.matrices(w), -m, axis=2)  # [Ñ, −M̃] of the controller meets [y; u] of the plant
        least = np.linalg.svd(back @ plant, compute_uv=False)[:, -1]
        hidden = (w == 0) & (least < HIDDEN)  # a mode at rest that no reading shows has a zero there, not the loop
        return np.where(hidden, 0.0, 1 / np.where(hidden, 1.0, least))

    return 1 / peak(size, _grid(loop.plant, loop.controller))


def _care(A: Array, B: Array, Q: Array, R: Array) -> Array:
    from scipy.linalg import LinAlgError, solve_continuous_are

    if not len(A):
        return A
    try:
        return solve_continuous_are(A, B, (Q + Q.T) / 2, R)
    except (LinAlgError, ValueError):
        raise DesignFailed(
            "no normalised coprime factors", expected="unstable modes that the inputs reach and the outputs show"
        ) from None


def _inverse_root(R: Array) -> Array:
    values, vectors = np.linalg.eigh(R)
    return np.asarray((vectors / np.sqrt(values)) @ vectors.T, dtype=np.float64)


def _dagger(matrices: Complex) -> Complex:
    return np.conj(np.swapaxes(matrices, 1, 2))


def _grid(*systems: LinearModel) -> Array:
    """Frequencies of the mapped axis: round every pole's size, and far beyond the slowest and the fastest."""
    poles = np.abs(np.concatenate([continuous(s).poles() for s in systems]))
    poles = poles[poles > 1e-9]
    low, high = poles.min(initial=1.0) * 1e-3, poles.max(initial=1.0) * 1e3
    return np.union1d(np.geomspace(low, high, GRID), [0.0, *poles, high * _INFINITE])


def _winding(f: Callable[[Array], Complex], grid: Array) -> int | None:
    """How often f(jω) turns round zero for ω from −∞ to ∞; None where it passes through zero.

    f(−jω) is the conjugate of f(jω), so half the way tells; steps of more than a sixth of a turn are halved.
    """
    w = grid[grid > 0]
    values = f(w)
    for _ in range(30):
        turns = np.abs(np.angle(values[1:] / values[:-1])) > math.pi / 3
        if np.abs(values).min() < _TOUCHES * np.abs(values).max():
            return None
        if not turns.any():
            break
        between = np.sqrt(w[1:] * w[:-1])[turns]
        w = np.concatenate([w, between])
        values = np.concatenate([values, f(between)])
        order = np.argsort(w)
        w, values = w[order], values[order]
    return round(float(np.angle(values[1:] / values[:-1]).sum()) / math.pi)
