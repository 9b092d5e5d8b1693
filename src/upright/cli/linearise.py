"""`upright linearise`: the tangent of the dynamics at an operating point."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.atomic import write_json
from upright.cli.options import JsonOption, RobotOption, vector
from upright.cli.output import print_json
from upright.errors import UnknownName

if TYPE_CHECKING:
    from upright.physics.linear import LinearModel

DRIFT = 1e-9
"""Rates of change up to this [rad/s, rad/s²] are rounding, since those that matter are of order 1 to 1000."""

STEADY = ("wheel", "yaw")
"""What may move by itself in a steady motion: nothing on a level floor depends on it."""


def linearise(
    *,
    robot: RobotOption = "nxtway-gs",
    at: Annotated[
        str, typer.Option(help="Operating point, such as pitch=0,wheel_rate=4,left=1,right=1; zero where not said.")
    ] = "",
    period: Annotated[float | None, typer.Option(help="Hold commands over this [s]: a discrete model.")] = None,
    model: Annotated[str, typer.Option(help="complete (rolling without slip) or published.")] = "complete",
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the model as JSON.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Linearise a robot: A, B and poles.

    Continuous, or with --period discrete under held commands. Says so where the operating point is no equilibrium.
    """
    from upright.physics.dynamics import MODELS
    from upright.physics.linear import INPUTS
    from upright.physics.linear import linearise as tangent
    from upright.robots import find_robot
    from upright.signals import STATE_NAMES

    if model not in MODELS:
        raise UnknownName("model", model, MODELS)
    point = vector(at, [*STATE_NAMES, *INPUTS], "--at")
    linear = tangent(find_robot(robot), point[:6], point[6:], model)
    rates = zip(linear.states, linear.f0.tolist(), strict=True)
    drift = {name: rate for name, rate in rates if abs(rate) > DRIFT and name not in STEADY}
    linear = linear if period is None else linear.c2d(period)
    if output:
        write_json(output, linear.to_json())
    if as_json:
        print_json(linear.to_json())
    else:
        _print(linear, drift)


def _print(model: LinearModel, drift: dict[str, float]) -> None:
    kind = "ẋ = A x + B u" if model.continuous else f"x⁺ = A x + B u, every {model.dt:g} s"
    typer.echo(f"{kind}\n\n{_matrix('A', model.states, model.states, model.A)}")
    typer.echo(f"\n{_matrix('B', model.states, model.inputs, model.B)}\n\npoles")
    for pole in model.poles():
        typer.echo(f"  {pole.real:12.6g}" + (f" {pole.imag:+.6g}j" if pole.imag else ""))
    if drift:
        rates = ", ".join(f"{name} {rate:+.4g}" for name, rate in drift.items())
        typer.echo(f"\nnot an equilibrium: here the state moves by itself, per second: {rates}")


def _matrix(name: str, rows: Sequence[str], columns: Sequence[str], values: Any) -> str:
    width = max(len(row) for row in rows)
    lines = [f"{name:<{width}}" + "".join(f"{column:>13}" for column in columns)]
    rounding = 1e-14 * abs(values).max()  # what arithmetic leaves of a zero
    for row, numbers in zip(rows, values.tolist(), strict=True):
        lines.append(
            f"{row:<{width}}"
            + "".join(f"{number:13.6g}" for number in (0.0 if abs(n) < rounding else n for n in numbers))
        )
    return "\n".join(lines)
