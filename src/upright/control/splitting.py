"""The operator splitting of a predictive controller: a fixed number of iterations within its limits."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.compiled.program import INFINITY
from upright.compiled.tracer import Form, Tracer
from upright.control.law import dot
from upright.control.linear_controller import Nonlinearity, finite_matrix
from upright.errors import InvalidController
from upright.signals import SIDES

MOST_ITERATIONS = 100
ROUNDING = 1e-13  # relative: what a product of matrices leaves of a zero
NOTHING = 1e-30  # below any difference of two floats that are not equal near 1


@dataclass(frozen=True, eq=False)
class Splitting(Nonlinearity):
    """`iterations` of an operator splitting over m quantities, each as a fraction of its own limit or bound.

    The first two are the commands over `limit`. Let g (m,) be what they reach under the regulator alone, and
    z = prox(v) = sat(v) + `ease` (v − sat(v)), with an ease of 0 for a limit. One iteration of the alternating
    direction method of multipliers (Boyd et al. 2011, chapter 3; v is z and the scaled multiplier) is

        v ← v + g − z + Π (2 z − v − g),   Π = `projection` = G (H + GᵀρG)⁻¹ Gᵀρ.

    Where nothing in g exceeds 1, v = g is the minimum. Otherwise the first v is g + `shift` (v − g), with the v − g of
    the period before.
    Raises `InvalidController` for sizes that do not fit each other.
    """

    projection: Array
    shift: Array
    ease: Array
    limit: float
    iterations: int
    _step: Array = field(init=False, repr=False)
    _rest: Array = field(init=False, repr=False)

    def __post_init__(self) -> None:
        m = len(self.ease)
        for name in ("projection", "shift"):
            object.__setattr__(self, name, finite_matrix(getattr(self, name), name, (m, m)))
        object.__setattr__(self, "ease", finite_matrix([self.ease], "ease", (1, m))[0])
        if m < 2 or not (0 < self.limit < math.inf and self.iterations in range(1, MOST_ITERATIONS + 1)):
            raise InvalidController(
                f"a limit of {self.limit} and {self.iterations} iterations over {m} quantities",
                expected=f"a positive limit, 1 to {MOST_ITERATIONS} iterations, two commands",
            )
        # v ← [stay, turn] (v, sat(v)) + (I − Π) g
        one = np.eye(m)
        keep = 1 - self.ease
        stay = one - np.diag(self.ease) + self.projection @ np.diag(2 * self.ease - 1)
        turn = 2 * self.projection @ np.diag(keep) - np.diag(keep)
        object.__setattr__(self, "_step", np.hstack([stay, turn]))
        object.__setattr__(self, "_rest", one - self.projection)

    def iterated(self, free: Array, pull: Array, times: int = 0) -> tuple[Array, float]:
        """v (m,) from g = `free` and the last v − g, and by how much the last iteration moved a command, over `limit`;
        `times` are by default the `iterations`."""
        m = len(free)
        rest = self._rest @ free
        both = np.concatenate([free + self.shift @ pull, np.zeros(m)])
        v = both[:m]
        inside = both[m:]
        before = np.zeros(2)
        for _ in range(times or self.iterations):
            np.clip(v, -1.0, 1.0, out=inside)
            before[:] = inside[:2]
            np.add(self._step @ both, rest, out=v)
        return v, float(np.abs(np.clip(v[:2], -1.0, 1.0) - before).max())

    @property
    def slope(self) -> Array:
        """None: where nothing is limited, the command is the linear one."""
        return np.zeros((2, len(self.ease)))

    def forms(self, t: Tracer, _linear: Sequence[Form], s: Sequence[Form], /) -> tuple[list[Form], list[Form]]:
        """The first commands; `residual` says by how much the last iteration moved them, over the limit.

        Π acts on sums and differences of both motors' quantities, between which it is zero where the motors are alike.
        """
        every = range(len(s))
        free = [t.let(f"free{i}", form, "1") for i, form in enumerate(s)]
        inside = [t.limit(form, -1.0, 1.0, f"inside{i}") for i, form in enumerate(free)]
        beyond = [t.absolute(t.let(f"over{i}", free[i] - inside[i], "1"), f"beyond{i}") for i in every]
        any_beyond = t.let("beyond", sum(beyond, Form()), "1")
        pull = [t.state(f"pull{i}", "1", INFINITY) for i in every]
        warm = [t.let(f"warm{i}", free[i] + dot(self.shift[i], pull), "1") for i in every]
        v = [t.choose(any_beyond, NOTHING, free[i], warm[i], f"v{i}") for i in every]
        before = [t.let(f"before_{side}", 0.0, "1") for side in SIDES]
        to, inner, back = _sums_and_differences(self)

        def iteration() -> list[Form]:
            at = [t.limit(v[i], -1.0, 1.0, f"at{i}") for i in every]
            out = [t.let(f"out{i}", v[i] - at[i], "1") for i in every]
            twice = [at[i] + out[i] * (2 * float(self.ease[i]) - 1) - free[i] for i in every]
            mixed = [t.let(f"mixed{i}", dot(to[i], twice), "1") for i in every]
            moved = [t.let(f"moved{i}", dot(inner[i], mixed), "1") for i in every]
            after = [out[i] * (1 - float(self.ease[i])) + free[i] + dot(back[i], moved) for i in every]
            return [*at[:2], *(t.let(f"next{i}", form, "1") for i, form in enumerate(after))]

        t.repeat(self.iterations, [*before, *v], iteration)
        first = [t.limit(v[i], -1.0, 1.0, f"first_{side}") for i, side in enumerate(SIDES)]
        change = [t.let(f"change_{side}", first[i] - before[i], "1") for i, side in enumerate(SIDES)]
        sizes = [t.absolute(form, f"changed_{side}") for form, side in zip(change, SIDES, strict=True)]
        t.choose(sizes[0], sizes[1], sizes[1], sizes[0], "residual", output=True)
        for i in every:
            t.commit(pull[i], t.let(f"next_pull{i}", v[i] - free[i], "1"))
        return [form * self.limit for form in first], []

    def to_json(self) -> dict[str, Any]:
        """Every number."""
        matrices = {"projection": self.projection, "shift": self.shift, "ease": self.ease}
        return {k: m.tolist() for k, m in matrices.items()} | {"limit": self.limit, "iterations": self.iterations}


def _sums_and_differences(part: Splitting) -> tuple[Array, Array, Array]:
    """T, S and U with Π = U S T, where T and U take sums and differences of both motors' commands."""
    n = int((part.ease == 0).sum())
    m = len(part.ease)
    to = np.eye(m)
    to[:n, :n] = np.kron(np.eye(n // 2), [[1.0, 1.0], [-1.0, 1.0]])
    inner = np.linalg.solve(to.T, part.projection) @ np.linalg.inv(to)
    return to, np.where(np.abs(inner) > ROUNDING * np.abs(inner).max(), inner, 0.0), to.T
