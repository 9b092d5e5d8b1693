"""The upper bound of the structured singular value by D and G scalings (Fan, Tits and Doyle 1991; Young 1993).

For Δ of blocks δᵢ I with real δᵢ, and of full complex blocks, μ(M)² is no more than the largest eigenvalue of

    H = N*N + j (G N − N* G),    N = T M T⁻¹,

for any T that commutes with Δ, and any Hermitian G of the same blocks that is zero where Δ is complex. T has any
invertible block where Δ has δᵢ I, and a number where Δ is full. So every T and G gives a bound, the best or not. The
best is searched by quasi-Newton steps on a smooth maximum of the eigenvalues.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from upright.arrays import Array, Complex
from upright.errors import InvalidModel

Block = tuple[int, bool]
"""Size of one block of Δ, and whether it is a repeated real number rather than a full complex matrix."""

SHARPNESS = (15.0, 120.0)  # of the smooth maximum: log(n)/120, 3 % of the square, is what it is off by at last
STEPS = 40  # quasi-Newton steps at each


@dataclass(frozen=True, eq=False)
class Scaling:
    """T (n, n) and G (n, n)."""

    T: Complex
    G: Complex

    def bounds(self, matrices: Complex) -> Array:
        """What these scalings prove of each of the matrices (k, n, n)."""
        N = self.T @ matrices @ np.linalg.inv(self.T)
        across = np.conj(np.swapaxes(N, 1, 2))
        H = across @ N + 1j * (self.G @ N - across @ self.G)
        return np.sqrt(np.maximum(np.linalg.eigvalsh(H)[:, -1], 0.0))


def checked_blocks(size: int, blocks: Sequence[Block]) -> None:
    """Raises `InvalidModel` for blocks that do not add up to `size`."""
    if sum(n for n, _ in blocks) != size or any(n < 1 for n, _ in blocks):
        raise InvalidModel(f"blocks {list(blocks)} for a matrix of {size}", expected="sizes of one or more that add up")


def balanced(matrices: Complex, blocks: Sequence[Block]) -> tuple[Array, Array]:
    """σ_max(D M D⁻¹) of each of the matrices (k, n, n), D a number for each block by Osborne's iteration, and all D."""
    edges = np.cumsum([0, *(size for size, _ in blocks)])[:-1]
    power = np.add.reduceat(np.add.reduceat(np.abs(matrices) ** 2, edges, axis=1), edges, axis=2)
    power[:, range(len(blocks)), range(len(blocks))] = 0.0
    d = np.ones(power.shape[:2])
    for _ in range(30):
        for i in range(len(blocks)):
            out = (power[:, i] / d**2).sum(axis=1)
            into = (power[:, :, i] * d**2).sum(axis=1)
            d[:, i] = np.where((out > 0) & (into > 0), (into / np.where(out > 0, out, 1.0)) ** 0.25, d[:, i])
    wide = np.repeat(d, [size for size, _ in blocks], axis=1)
    return np.linalg.norm(wide[:, :, None] * matrices / wide[:, None, :], 2, axis=(1, 2)), wide


def best_scaling(matrix: Complex, blocks: Sequence[Block], start: Scaling | None = None) -> Scaling:
    """The scalings that prove the least bound of one matrix (n, n), looked for from `start` (None: a balanced D)."""
    from scipy.optimize import minimize

    checked_blocks(len(matrix), blocks)
    norms, d = balanced(matrix[None], blocks)
    first = start or Scaling(np.diag(d[0]).astype(complex), np.zeros_like(matrix))
    level = float(min(first.bounds(matrix[None])[0], norms[0]))
    if not level > 0:
        return first
    M = matrix / level
    z = _packed(first.T, first.G / level, blocks)
    for sharpness in SHARPNESS:

        def smooth(z: Array, sharpness: float = sharpness) -> tuple[float, Array]:
            return _smooth(M, z, blocks, sharpness)

        result: Any = minimize(smooth, z, jac=True, method="L-BFGS-B", options={"maxiter": STEPS})
        z = result.x
    best = _unpacked(z, blocks)
    last = Scaling(best.T, best.G * level)
    return last if last.bounds(matrix[None])[0] < first.bounds(matrix[None])[0] else first


def _smooth(M: Complex, z: Array, blocks: Sequence[Block], sharpness: float) -> tuple[float, Array]:
    """log Σ exp(s λ)/s of the eigenvalues λ of H, and its gradient."""
    at = _unpacked(z, blocks)
    inverse = np.linalg.inv(at.T)
    N = at.T @ M @ inverse
    H = N.conj().T @ N + 1j * (at.G @ N - N.conj().T @ at.G)
    values, V = np.linalg.eigh(H)
    weights = np.exp(sharpness * (values - values[-1]))
    value = float(values[-1] + np.log(weights.sum()) / sharpness)
    P = (V * (weights / weights.sum())) @ V.conj().T
    left = N @ P - 1j * at.G @ P  # Σ p a v*, with a = N v − j G v; dN = E N − N E for dT = E T
    E = 2 * (left @ N.conj().T - N.conj().T @ left)
    G = 1j * (N @ P - P @ N.conj().T)
    return value, _packed(E @ inverse.conj().T, G, blocks, slopes=True)


def _packed(T: Complex, G: Complex, blocks: Sequence[Block], *, slopes: bool = False) -> Array:
    """Real numbers: T and the G of each real block, the one number of a complex block. With `slopes` T and G are those
    of a function, and that number's slope is the sum of all that it stands for."""
    parts: list[Array] = []
    for (i, j), (_, real) in zip(pairwise(_edges(blocks)), blocks, strict=True):
        t, g = T[i:j, i:j], G[i:j, i:j]
        number = t.trace().real[None] if slopes else t[:1, 0].real
        parts += [t.real.ravel(), t.imag.ravel(), g.real.ravel(), g.imag.ravel()] if real else [number]
    return np.concatenate(parts)


def _unpacked(z: Array, blocks: Sequence[Block]) -> Scaling:
    edges = _edges(blocks)
    T, G = (np.zeros((edges[-1], edges[-1]), dtype=complex) for _ in range(2))
    place = 0
    for (i, j), (n, real) in zip(pairwise(edges), blocks, strict=True):
        if real:
            a, b, c, d = z[place : place + 4 * n * n].reshape(4, n, n)
            T[i:j, i:j], G[i:j, i:j] = a + 1j * b, (c + c.T + 1j * (d - d.T)) / 2
        else:
            T[i:j, i:j] = z[place] * np.eye(n)
        place += 4 * n * n if real else 1
    return Scaling(T, G)


def _edges(blocks: Sequence[Block]) -> list[int]:
    return np.cumsum([0, *(size for size, _ in blocks)]).tolist()
