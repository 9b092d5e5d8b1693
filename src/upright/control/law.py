"""What a controller computes in each period, written once: the statements that the kernel and every brick run.

    u = C z + Dy y + Dr r − reach · sat(s / layer),   s = C_s z + Dy_s y + Dr_s r,
    z⁺ = A z + By y + Br r + Bu u + Ba a

The part with s and Bu is that of a sliding mode alone. For a predictive controller s is what it limits, and u the first
command of its `Splitting`. a is the command that was really applied.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from typing import Any

import numpy as np

from upright.arrays import Array
from upright.compiled.program import INFINITY, Block, Program
from upright.compiled.tracer import Form, Tracer
from upright.control.controller import Controller
from upright.control.linear_controller import LinearController, as_linear
from upright.control.mpc import PredictiveController, Splitting
from upright.control.sliding import SlidingMode
from upright.errors import InvalidController
from upright.signals import SIDES, STATE_NAMES

ROUNDING = 1e-13  # relative: what a product of matrices leaves of a zero


NOTHING = 1e-30  # below any difference of two floats that are not equal near 1


@dataclass(frozen=True, eq=False)
class Switching:
    """u loses `reach` · sat(s / `layer`), s (2,)."""

    reach: float
    layer: float


@dataclass(frozen=True, eq=False)
class Nonlinear:
    """s = C z + Dy y + Dr r, and what is made of it: the `part` of a law that is not linear.

    The memory is driven by Bu u as well, u being the command before the motors' limits.
    """

    C: Array
    Dy: Array
    Dr: Array
    Bu: Array
    part: Switching | Splitting


@dataclass(frozen=True, eq=False)
class Law:
    """A controller as fixed sums of products; `nonlinear` is None for a linear one."""

    linear: LinearController
    nonlinear: Nonlinear | None = None

    @property
    def period(self) -> float:
        return self.linear.period

    def with_period(self, period: float) -> Law:
        """The same numbers every `period` [s]."""
        return replace(self, linear=replace(self.linear, period=period))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Law) and self._numbers() == other._numbers()

    def __hash__(self) -> int:
        return hash(self._numbers())

    def _numbers(self) -> tuple[Any, ...]:
        """All that decides the statements."""
        one, two = self.linear, self.nonlinear
        facts = [
            one.reads,
            one.period,
            one.command_unit,
            one.kind,
            one.A,
            one.By,
            one.Br,
            one.Ba,
            one.C,
            one.Dy,
            one.Dr,
        ]
        facts += [two.C, two.Dy, two.Dr, two.Bu, *vars(two.part).values()] if two else []
        return tuple(fact.tobytes() if isinstance(fact, np.ndarray) else fact for fact in facts)


def as_law(controller: Controller | Law) -> Law:
    """The law of a linear, sliding or predictive controller; raises `InvalidController` for any other."""
    if isinstance(controller, Law):
        return controller
    if isinstance(controller, SlidingMode):
        return _behind(controller.memory, slice(2), np.eye(2, 4, 2), Switching(controller.reach, controller.layer))
    if isinstance(controller, PredictiveController):
        m, part = controller.memory, controller.splitting
        return _behind(m, slice(None), part.limit * np.eye(2, len(m.C)), part)
    try:
        return Law(as_linear(controller))
    except InvalidController:
        raise InvalidController(
            f"a {type(controller).__name__} is no fixed sum of products",
            expected="a linear controller (lqr, lqi, lqg, pid, hinf, robust), sliding or mpc",
            hint="upright certify or upright bench-controllers, which run any controller",
        ) from None


def _behind(m: LinearController, rows: slice, linear: Array, part: Switching | Splitting) -> Law:
    """The law whose s are those `rows` of the memory's outputs, and whose linear command is `linear` (2, outputs)
    times them."""
    alone = replace(m, C=linear @ m.C, Dy=linear @ m.Dy, Dr=linear @ m.Dr, Bu=np.zeros((0, 0)))
    return Law(alone, Nonlinear(m.C[rows], m.Dy[rows], m.Dr[rows], m.Bu, part))


def program(law: Law, referred: int = 6) -> Program:
    """The law alone in SI units, without ranges: the inputs are the channels it reads, `reference_…` for the first
    `referred` states and `applied_…`; the outputs `command_…`."""
    linear = law.linear
    t = Tracer()
    block = Block("calibrate", ())
    inputs = {name.replace("/", "_"): name for name in linear.reads}
    z = [t.state(f"z{i}", "1", INFINITY) for i in range(len(linear.A))]
    y = [t.input(name, "1", INFINITY) for name in inputs]
    r = [t.input(f"reference_{name}", "1", INFINITY) for name in STATE_NAMES[:referred]]
    r += [Form()] * (len(STATE_NAMES) - referred)
    u = command_forms(t, law, z, y, r, unit=linear.command_unit)
    command = t.block("command")
    a = [t.input(f"applied_{side}", linear.command_unit, INFINITY) for side in SIDES]
    for state, row in zip(z, memory_forms(law, z=z, y=y, r=r, u=u, a=a), strict=True):
        t.commit(state, t.let(f"next_{state.name}", row, "1"))
    return Program(
        robot="any", kit="any", kind=linear.kind, hash="", target="law", period=linear.period,
        version=version("upright"), command_unit=linear.command_unit, full=0, proven=False, lag=0, channels=inputs,
        scales=dict.fromkeys(inputs, 1.0), variables=t.variables, calibrate=block, command=command,
        update=t.block("update"),
    )  # fmt: skip


def command_forms(
    t: Tracer, law: Law, z: Sequence[Form], y: Sequence[Form], r: Sequence[Form], *, unit: str, most: float = INFINITY
) -> list[Form]:
    """The command to each motor within ±`most`."""
    linear, rest = law.linear, law.nonlinear
    rows = [dot(linear.C[i], z) + dot(linear.Dy[i], y) + dot(linear.Dr[i], r) for i in range(2)]
    if rest:
        s = [dot(C, z) + dot(Dy, y) + dot(Dr, r) for C, Dy, Dr in zip(rest.C, rest.Dy, rest.Dr, strict=True)]
        rows = _switched(t, rest.part, rows, s) if isinstance(rest.part, Switching) else _planned(t, rest.part, s)
    return [t.let(f"command_{side}", row, unit, most, output=True) for side, row in zip(SIDES, rows, strict=True)]


def _switched(t: Tracer, part: Switching, rows: Sequence[Form], s: Sequence[Form]) -> list[Form]:
    bounded = [t.let(f"surface_{side}", form * (1 / part.layer), "1", 1.0) for side, form in zip(SIDES, s, strict=True)]
    return [row - surface * part.reach for row, surface in zip(rows, bounded, strict=True)]


def _planned(t: Tracer, part: Splitting, s: Sequence[Form]) -> list[Form]:
    """The first commands of the splitting; `residual` says by how much its last iteration moved them, over the limit.

    Π acts on sums and differences of both motors' quantities, between which it is zero where the motors are alike.
    """
    every = range(len(s))
    free = [t.let(f"free{i}", form, "1") for i, form in enumerate(s)]
    inside = [t.limit(f"inside{i}", form, -1.0, 1.0, "1") for i, form in enumerate(free)]
    beyond = [t.absolute(f"beyond{i}", t.let(f"over{i}", free[i] - inside[i], "1"), "1") for i in every]
    any_beyond = t.let("beyond", sum(beyond, Form()), "1")
    pull = [t.state(f"pull{i}", "1", INFINITY) for i in every]
    warm = [t.let(f"warm{i}", free[i] + dot(part.shift[i], pull), "1") for i in every]
    v = [t.choose(f"v{i}", any_beyond, NOTHING, free[i], warm[i], "1") for i in every]
    before = [t.let(f"before_{side}", 0.0, "1") for side in SIDES]
    to, inner, back = _sums_and_differences(part)

    def iteration() -> list[Form]:
        at = [t.limit(f"at{i}", v[i], -1.0, 1.0, "1") for i in every]
        out = [t.let(f"out{i}", v[i] - at[i], "1") for i in every]
        twice = [at[i] + out[i] * (2 * float(part.ease[i]) - 1) - free[i] for i in every]
        mixed = [t.let(f"mixed{i}", dot(to[i], twice), "1") for i in every]
        moved = [t.let(f"moved{i}", dot(inner[i], mixed), "1") for i in every]
        after = [out[i] * (1 - float(part.ease[i])) + free[i] + dot(back[i], moved) for i in every]
        return [*at[:2], *(t.let(f"next{i}", form, "1") for i, form in enumerate(after))]

    t.repeat(part.iterations, [*before, *v], iteration)
    first = [t.limit(f"first_{side}", v[i], -1.0, 1.0, "1") for i, side in enumerate(SIDES)]
    change = [t.let(f"change_{side}", first[i] - before[i], "1") for i, side in enumerate(SIDES)]
    sizes = [t.absolute(f"changed_{side}", form, "1") for form, side in zip(change, SIDES, strict=True)]
    t.choose("residual", sizes[0], sizes[1], sizes[1], sizes[0], "1", output=True)
    for i in every:
        t.commit(pull[i], t.let(f"next_pull{i}", v[i] - free[i], "1"))
    return [form * part.limit for form in first]


def _sums_and_differences(part: Splitting) -> tuple[Array, Array, Array]:
    """T, S and U with Π = U S T, where T and U take sums and differences of both motors' commands."""
    n = int((part.ease == 0).sum())
    m = len(part.ease)
    to = np.eye(m)
    to[:n, :n] = np.kron(np.eye(n // 2), [[1.0, 1.0], [-1.0, 1.0]])
    inner = np.linalg.solve(to.T, part.projection) @ np.linalg.inv(to)
    return to, np.where(np.abs(inner) > ROUNDING * np.abs(inner).max(), inner, 0.0), to.T


def memory_forms(
    law: Law, *, z: Sequence[Form], y: Sequence[Form], r: Sequence[Form], u: Sequence[Form], a: Sequence[Form]
) -> list[Form]:
    """The rows of the memory's update."""
    linear, rest = law.linear, law.nonlinear
    pairs: list[tuple[Array, Sequence[Form]]] = [(linear.A, z), (linear.By, y), (linear.Br, r)]
    pairs += [(rest.Bu, u)] if rest else []
    pairs.append((linear.Ba, a))
    return [sum((dot(M[i], v) for M, v in pairs), Form()) for i in range(len(z))]


def dot(row: Array, values: Sequence[Form]) -> Form:
    """Σ row_i values_i as one form."""
    return sum((value * k for k, value in zip(row.tolist(), values, strict=True) if k), Form())
