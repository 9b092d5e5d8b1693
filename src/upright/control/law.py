"""What a controller computes in each period, written once: the statements that the kernel and every brick run.

    u, v = part(C z + Dy y + Dr r, s),   s = C_s z + Dy_s y + Dr_s r,
    z⁺ = A z + By y + Br r + Bu [u, v] + Ba a

A linear law has no part, no s and no Bu. A part is the layer of a sliding mode, the `Splitting` of a predictive
controller, or dead band and limits of a PID on the angle. a is the command that was really applied.
"""

from __future__ import annotations

from collections.abc import Sequence
from importlib.metadata import version
from typing import Any

from upright.arrays import Array
from upright.compiled.program import INFINITY, Block, Program
from upright.compiled.tracer import Form, Tracer
from upright.control.controller import Controller
from upright.control.linear_controller import Law, LinearController
from upright.errors import InvalidController
from upright.signals import SIDES, STATE_NAMES


def as_law(controller: Controller | Law) -> Law:
    """What the controller says of itself; raises `InvalidController` for one without a `law()`, or that has none."""
    try:
        return _own(controller, "law")
    except InvalidController:
        raise InvalidController(
            f"a {type(controller).__name__} is no fixed sum of products",
            expected="a linear controller (lqr, lqi, lqg, pid, hinf, robust), sliding, pid-angle or mpc",
            hint="upright simulate, certify or fleet, which run any controller",
        ) from None


def as_linear(controller: Controller) -> LinearController:
    """The same commands from one state-space system: of a linear controller, in any form.

    Raises `InvalidController` for a controller that is not linear or whose form is not known here.
    """
    law: Law = _own(controller, "law")
    if law.nonlinear:
        raise _no_linear_form(controller)
    return law.linear


def near_rest(controller: Controller | Law) -> LinearController:
    """The controller itself where it is linear, else what it is while nothing about it is at a limit.

    Raises `InvalidController` for one that does not say.
    """
    return _own(controller, "linearised")


def _own(controller: Any, name: str) -> Any:
    """What the controller's method of that name says; a class with a step of its own has a law of its own, or none."""
    method = getattr(controller, name, None)
    decides = next((c for c in type(controller).__mro__ if vars(c).keys() & {"step", "law"}), object)
    if not callable(method) or "law" not in vars(decides):
        raise _no_linear_form(controller)
    return method()


def _no_linear_form(controller: Controller) -> InvalidController:
    return InvalidController(f"a {controller.spec.kind} has no known linear form", expected="a linear controller")


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
    """The command to each motor within ±`most`, then what else drives the memory."""
    linear, rest = law.linear, law.nonlinear
    rows = [dot(linear.C[i], z) + dot(linear.Dy[i], y) + dot(linear.Dr[i], r) for i in range(2)]
    further = list[Form]()
    if rest:
        s = [dot(C, z) + dot(Dy, y) + dot(Dr, r) for C, Dy, Dr in zip(rest.C, rest.Dy, rest.Dr, strict=True)]
        rows, further = rest.part.forms(t, rows, s)
    u = [t.let(f"command_{side}", row, unit, most, output=True) for side, row in zip(SIDES, rows, strict=True)]
    return u + further


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
