"""A controller as the numbers that a program needs: one linear recursion, and how large its memory can grow."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from decimal import Decimal, localcontext

import numpy as np
from numpy.typing import NDArray

from upright.control.controller import Controller, ControllerSpec
from upright.control.linear_controller import LinearController, as_linear
from upright.control.sliding import SlidingMode
from upright.errors import InvalidController
from upright.physics.linear import FADING, impulse_norm

Array = NDArray[np.float64]

ROUNDING = 1e-11  # of what a design computes with, beside which a number is none
DIGITS = 50
SPARE = 1.01  # what neither the rest of a response nor rounding exceeds


@dataclass(frozen=True, eq=False)
class Law:
    """z = w − X Δ, then w⁺ = A z + By y + Br r + Bu u + Ba a, outputs v = C z + Dy y + Dr r, pitch = S z + Sy y.

    Δ is what each reading y has moved by since the period before, and X (n, m) stays zero until `by_increments`.
    u = v (2,) for a linear controller; for a sliding one v = [s, u] (4,) and each u loses `reach` · sat(s / `layer`).
    S (n,) and Sy (m,) are None for a controller without an opinion of the pitch.
    """

    spec: ControllerSpec
    A: Array
    By: Array
    Br: Array
    Bu: Array
    Ba: Array
    C: Array
    Dy: Array
    Dr: Array
    S: Array | None
    Sy: Array | None
    X: Array
    reach: float = 0.0
    layer: float = 0.0

    @property
    def sliding(self) -> bool:
        return len(self.C) == 4

    def bounds(self, moved: Array, y: Array, r: Array, u: Array, a: Array) -> Array | None:
        """What each |w| stays below while Δ, y, r, u and a stay within the sizes given, from w = 0.

        The exact bound, Σ_k |A^k B| s for inputs of size s (the l1 norm of the impulse response); None for a memory
        that grows by itself, as a controller's may that is unstable without its robot.
        """
        if np.abs(np.linalg.eigvals(self.A)).max(initial=0.0) > FADING:
            return None
        entering = np.hstack([self.A @ self.X, self.By, self.Br, self.Bu, self.Ba])
        return _rounded_up(impulse_norm(self.A, entering) @ np.concatenate([moved, y, r, u, a]) * SPARE)

    def by_increments(self, channels: Sequence[str]) -> Law:
        """The same law with the memory counted from where the readings of `channels` would hold it, X y.

        X = (I − A)⁻¹ By takes the readings themselves out of the memory: positions grow without end, and in single
        precision the difference of two large ones is all that a memory of them would hold.
        """
        n, wanted = len(self.A), np.array([name in channels for name in self.spec.reads])
        steady = _solved(self.A, self.By * wanted)
        X = _clean(_floats(steady), np.ones(self.By.shape))
        pitch = (
            (np.zeros((0, n)), np.zeros((0, len(wanted))))
            if self.S is None or self.Sy is None
            else (self.S[None], self.Sy[None])
        )
        rows = np.vstack([self.C, pitch[0]]), np.vstack([self.Dy, pitch[1]])
        direct = _clean(_added(*rows, steady), np.abs(rows[0]) @ np.abs(X) + np.abs(rows[1]))
        outputs = len(self.C)
        Sy = None if self.Sy is None else direct[outputs]
        return replace(self, X=X, By=self.By * ~wanted, Dy=direct[:outputs], Sy=Sy)


def _rounded_up(values: Array) -> Array:
    """To the next number of three digits, so that rounding elsewhere does not show in a program."""
    return np.array([float(f"{v * 1.005:.2e}") for v in values.tolist()])


def _solved(A: Array, B: Array) -> list[list[Decimal]]:
    """(I − A)⁻¹ B to 50 digits by elimination, so that every machine prints the same program."""
    with localcontext() as context:
        context.prec = DIGITS
        n = len(A)
        rows = [[Decimal(v) for v in (*row, *right)] for row, right in zip(A.tolist(), B.tolist(), strict=True)]
        for i, row in enumerate(rows):
            row[:n] = [Decimal(int(i == j)) - v for j, v in enumerate(row[:n])]
        for i in range(n):
            best = max(range(i, n), key=lambda k: abs(rows[k][i]))
            rows[i], rows[best] = rows[best], rows[i]
            rows[i] = [v / rows[i][i] for v in rows[i]]
            for k in range(n):
                if k != i and rows[k][i]:
                    factor = rows[k][i]
                    rows[k] = [v - factor * w for v, w in zip(rows[k], rows[i], strict=True)]
        return [row[n:] for row in rows]


def _added(C: Array, D: Array, X: list[list[Decimal]]) -> Array:
    """C X + D, rounded once."""
    with localcontext() as context:
        context.prec = DIGITS
        columns = list(zip(*X, strict=True)) or [()] * D.shape[1]
        sums = [
            [sum((Decimal(c) * x for c, x in zip(row, column, strict=True)), Decimal(d))
             for d, column in zip(direct, columns, strict=True)]
            for row, direct in zip(C.tolist(), D.tolist(), strict=True)
        ]  # fmt: skip
        return _floats(sums)


def _floats(values: list[list[Decimal]]) -> Array:
    return np.array([[float(v) for v in row] for row in values])


def _clean(values: Array, size: Array) -> Array:
    """`values` without what is rounding beside numbers of that `size`."""
    return np.where(np.abs(values) > ROUNDING * size, values, 0.0)


def law_of(controller: Controller) -> Law:
    """The law of a linear or a sliding controller; `InvalidController` says why another has none."""
    spec = controller.spec
    if spec.reads_truth:
        raise InvalidController(
            f"a {spec.kind} reads the true state, which no robot offers", hint="put an estimator in front of it"
        )
    if isinstance(controller, SlidingMode):
        return _sliding(controller)
    try:
        return _linear(as_linear(controller))
    except InvalidController:
        raise InvalidController(
            f"a {spec.kind} cannot become a program: its step is not a fixed sum of products",
            expected="a linear controller (lqr behind a Kalman filter, lqi, lqg, pid, hinf, robust) or a sliding one",
        ) from None


def _linear(linear: LinearController) -> Law:
    n, opinion = len(linear.A), len(linear.S) > 0
    S, Sy = (linear.S[0], linear.Sy[0]) if opinion else (None, None)
    matrices = (linear.A, linear.By, linear.Br, np.zeros((n, 2)), linear.Ba, linear.C, linear.Dy, linear.Dr)
    return Law(linear.spec, *matrices, S, Sy, np.zeros_like(linear.By))


def _sliding(controller: SlidingMode) -> Law:
    m = controller.memory
    Br = np.zeros((len(m.A), 6))
    matrices = (m.A, m.By, Br, m.Bu, m.Ba, m.C, m.Dy, m.Dr, m.S[0], m.Sy[0])
    return Law(controller.spec, *matrices, np.zeros_like(m.By), controller.reach, controller.layer)
