"""A controller as a program runs it: its memory counted from where the positions are, and how large it can grow."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from decimal import Decimal, localcontext

import numpy as np

from upright.arrays import Array
from upright.control.controller import Controller
from upright.control.law import as_law
from upright.control.linear_controller import Law, LinearController
from upright.errors import InvalidController
from upright.physics.linear import FADING, impulse_norm

ROUNDING = 1e-11  # relative to the numbers it is computed from: a smaller result is rounding
DIGITS = 50
SPARE = 1.01  # margin for the truncated tail of a response and for rounding


@dataclass(frozen=True, eq=False)
class Incremental:
    """A `law` with its memory z = w − X Δ; its estimate is x̂ = S z + Sy y.

    Δ (m,) is the change of each reading since the period before. X (n, m) = (I − A)⁻¹ By takes positions out of the
    memory: they grow without end, and in single precision a memory of them would hold the difference of two large
    numbers.
    """

    law: Law
    X: Array

    @property
    def linear(self) -> LinearController:
        """The law's matrices."""
        return self.law.linear

    def bounds(self, *, change: Array, y: Array, r: Array, u: Array, a: Array) -> Array | None:
        """Bound of each |w| while Δ, y, r, u and a stay within the sizes given, from w = 0.

        The exact bound, Σ_k |A^k B| s for inputs of size s (the l1 norm of the impulse response); None for a memory
        that grows by itself, as that of a controller may that is unstable without its robot.
        """
        linear = self.linear
        rest = self.law.nonlinear
        Bu = np.zeros((len(linear.A), 2)) if rest is None else rest.Bu
        if np.abs(np.linalg.eigvals(linear.A)).max(initial=0.0) > FADING:
            return None
        entering = np.hstack([linear.A @ self.X, linear.By, linear.Br, Bu, linear.Ba])
        return _rounded_up(impulse_norm(linear.A, entering) @ np.concatenate([change, y, r, u, a]) * SPARE)


def incremental(controller: Controller, channels: Sequence[str]) -> Incremental:
    """A controller that `as_law` knows, with the readings of `channels` taken out of its memory.

    Raises `InvalidController` for any other, with the reason.
    """
    law = _law(controller)
    linear, rest = law.linear, law.nonlinear
    positions = np.array([name in channels for name in linear.reads])
    steady = _solved(linear.A, linear.By * positions)
    X = _clean(_floats(steady), np.ones(linear.By.shape))

    def direct(C: Array, D: Array) -> Array:
        return _clean(_added(C, D, steady), np.abs(C) @ np.abs(X) + np.abs(D))

    Sy = direct(linear.S, linear.Sy) if len(linear.S) else linear.Sy
    changed = replace(linear, By=linear.By * ~positions, Dy=direct(linear.C, linear.Dy), Sy=Sy)
    return Incremental(Law(changed, rest and replace(rest, Dy=direct(rest.C, rest.Dy))), X)


def _law(controller: Controller) -> Law:
    spec = controller.spec
    if spec.reads_truth:
        raise InvalidController(
            f"a {spec.kind} reads the true state, which no robot measures", hint="put an estimator in front of it"
        )
    try:
        return as_law(controller)
    except InvalidController:
        raise InvalidController(
            f"a {spec.kind} cannot become a program: its step is not a fixed sum of products",
            expected="lqr behind a Kalman filter, lqi, lqg, pid, hinf, robust, sliding, pid-angle or mpc",
        ) from None


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
