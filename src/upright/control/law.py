"""What a controller computes in each period, written once: the statements that the kernel and every brick run.

    u = C z + Dy y + Dr r − reach · sat(s / layer),   s = C_s z + Dy_s y + Dr_s r,
    z⁺ = A z + By y + Br r + Bu u + Ba a

The part with s and Bu is that of a sliding mode alone. a is the command that was really applied.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from importlib.metadata import version
from typing import Any

import numpy as np
from numpy.typing import NDArray

from upright.compiled.program import INFINITY, Block, Program
from upright.compiled.tracer import Form, Tracer
from upright.control.controller import Controller
from upright.control.linear_controller import LinearController, as_linear
from upright.control.sliding import SlidingMode
from upright.errors import InvalidController
from upright.signals import STATE_NAMES

Array = NDArray[np.float64]

SIDES = ("left", "right")


@dataclass(frozen=True, eq=False)
class Switching:
    """The part of a sliding mode that is not linear: u loses `reach` · sat(s / `layer`), s = C z + Dy y + Dr r (2,).

    The memory is driven by Bu u as well, u being the command before the motors' limits.
    """

    C: Array
    Dy: Array
    Dr: Array
    Bu: Array
    reach: float
    layer: float


@dataclass(frozen=True, eq=False)
class Law:
    """A controller as fixed sums of products; `switching` is None for a linear one."""

    linear: LinearController
    switching: Switching | None = None

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
        one, two = self.linear, self.switching
        facts = one.reads, one.period, one.command_unit, one.kind
        matrices = [one.A, one.By, one.Br, one.Ba, one.C, one.Dy, one.Dr]
        matrices += [two.C, two.Dy, two.Dr, two.Bu] if two else []
        return *facts, *((two.reach, two.layer) if two else ()), *(matrix.tobytes() for matrix in matrices)


def as_law(controller: Controller | Law) -> Law:
    """The law of a linear or sliding controller; raises `InvalidController` for any other."""
    if isinstance(controller, Law):
        return controller
    if isinstance(controller, SlidingMode):
        m = controller.memory
        linear = replace(m, C=m.C[2:], Dy=m.Dy[2:], Dr=m.Dr[2:], Bu=np.zeros((0, 0)))
        return Law(linear, Switching(m.C[:2], m.Dy[:2], m.Dr[:2], m.Bu, controller.reach, controller.layer))
    try:
        return Law(as_linear(controller))
    except InvalidController:
        raise InvalidController(
            f"a {controller.spec.kind} is no fixed sum of products",
            expected="a linear controller (lqr, lqi, lqg, pid, hinf, robust) or sliding",
        ) from None


def program(law: Law, referred: int = 6) -> Program:
    """The law alone in SI units, without ranges: the inputs are the channels it reads, `reference_…` for the first
    `referred` states and `applied_…`; the outputs `command_…`."""
    linear, t, block = law.linear, Tracer(), Block("calibrate", ())
    inputs = {name.replace("/", "_"): name for name in linear.reads}
    z = [t.state(f"z{i}", "1", INFINITY) for i in range(len(linear.A))]
    y = [t.input(name, "1", INFINITY) for name in inputs]
    r = [t.input(f"reference_{name}", "1", INFINITY) for name in STATE_NAMES[:referred]]
    r += [Form()] * (len(STATE_NAMES) - referred)
    u = commanded(t, law, z, y, r, unit=linear.command_unit)
    command = t.block("command")
    a = [t.input(f"applied_{side}", linear.command_unit, INFINITY) for side in SIDES]
    for state, row in zip(z, remembered(law, z=z, y=y, r=r, u=u, a=a), strict=True):
        t.commit(state, t.let(f"next_{state.name}", row, "1"))
    return Program(
        robot="any", kit="any", kind=linear.kind, hash="", target="law", period=linear.period,
        version=version("upright"), command_unit=linear.command_unit, full=0, proven=False, lag=0, channels=inputs,
        scales=dict.fromkeys(inputs, 1.0), variables=t.variables, calibrate=block, command=command,
        update=t.block("update"),
    )  # fmt: skip


def commanded(
    t: Tracer, law: Law, z: Sequence[Form], y: Sequence[Form], r: Sequence[Form], *, unit: str, most: float = INFINITY
) -> list[Form]:
    """The command to each motor within ±`most`."""
    linear, switching, u = law.linear, law.switching, list[Form]()
    for i, side in enumerate(SIDES):
        row = dot(linear.C[i], z) + dot(linear.Dy[i], y) + dot(linear.Dr[i], r)
        if switching:
            surface = dot(switching.C[i], z) + dot(switching.Dy[i], y) + dot(switching.Dr[i], r)
            row -= t.let(f"surface_{side}", surface * (1 / switching.layer), "1", 1.0) * switching.reach
        u.append(t.let(f"command_{side}", row, unit, most, output=True))
    return u


def remembered(
    law: Law, *, z: Sequence[Form], y: Sequence[Form], r: Sequence[Form], u: Sequence[Form], a: Sequence[Form]
) -> list[Form]:
    """The rows of the memory's update."""
    linear, switching = law.linear, law.switching
    pairs: list[tuple[Array, Sequence[Form]]] = [(linear.A, z), (linear.By, y), (linear.Br, r)]
    pairs += [(switching.Bu, u)] if switching else []
    pairs.append((linear.Ba, a))
    return [sum((dot(M[i], v) for M, v in pairs), Form()) for i in range(len(z))]


def dot(row: Array, values: Sequence[Form]) -> Form:
    """Σ row_i values_i as one form."""
    return sum((value * k for k, value in zip(row.tolist(), values, strict=True) if k), Form())
