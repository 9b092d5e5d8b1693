"""`upright design` and `upright bench-controllers`: controllers by name, into a file, or all of them side by side."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import print_json, print_table, progress
from upright.errors import SpecMismatch

if TYPE_CHECKING:
    from upright.control import Controller
    from upright.robots import Kit, Robot

KitOption = Annotated[str | None, typer.Option(help="Electronics by name or TOML file (default: the robot's own).")]
PeriodOption = Annotated[float | None, typer.Option(help="Controller's period [s] (default: the kit's).")]


def design(
    method: Annotated[
        str, typer.Argument(help="lqr, lqi, lqg, pid, hinf, mpc, sliding, robust or any registered name.")
    ],
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    period: PeriodOption = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the controller as JSON.")] = None,
    as_json: JsonOption = False,
) -> None:
    """Design a controller for a robot.

    Says what it reads, how exactly its equations are solved, and the margins of its loop; -o keeps it.
    """
    from upright.control import controller_hash, make_controller, write_controller

    chosen, parts = _found(robot, kit)
    controller = make_controller(method, chosen, parts, parts.period if period is None else period)
    written = write_controller(controller, output) if output else None
    facts: dict[str, Any] = {
        "method": method,
        "robot": chosen.name,
        "kit": parts.name,
        "period": controller.spec.period,
        "reads": list(controller.spec.reads),
        "residual": float(controller.check()) if hasattr(controller, "check") else None,  # type: ignore[attr-defined]
        "hash": controller_hash(controller),
        "file": str(written) if written else None,
    }
    analysis = _analysed(controller, chosen, parts)
    if as_json:
        print_json(facts | {"analysis": analysis.to_json() if hasattr(analysis, "to_json") else str(analysis)})
        return
    said = {name: ", ".join(v) if isinstance(v, list) else v for name, v in facts.items() if v is not None}
    typer.echo("\n".join(f"{name:<10}{value}" for name, value in said.items()))
    typer.echo(f"\n{analysis}")


def bench_controllers(
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    body: Annotated[str, typer.Option("--body", "-b", help="nonlinear or twin (MuJoCo).")] = "twin",
    seed: Annotated[int, typer.Option(help="Seed of all noise.")] = 1,
    as_json: JsonOption = False,
) -> None:
    """All controllers under the same pushes, in one table.

    Each holds the robot on its kit's sensors through both pushes of Herrera et al. (2015): held at 0.1 rad and at
    −0.12 rad, and released.
    """
    from upright.comparison.bench import bench_controllers as bench
    from upright.comparison.bench import bench_json

    chosen, parts = _found(robot, kit)
    with progress("pushing") as share:
        rows = bench(chosen, parts, body, seed, progress=share)
    if as_json:
        print_json({"robot": chosen.name, "kit": parts.name, "body": body, "seed": seed, "rows": bench_json(rows)})
        return
    header = (
        "controller",
        "push",
        "peak pitch [rad]",
        "settling 5 % [s]",
        "travel [rad]",
        "effort",
        "saturated",
        "holds",
    )
    cells = [(r.controller, r.push, r.peak, r.settling, r.travel, r.effort, r.saturated, r.outcome) for r in rows]
    print_table(header, [[_cell(value) for value in row] for row in cells], header[2:7])


def _found(robot: str, kit: str | None) -> tuple[Robot, Kit]:
    from upright.robots.files import find_kit, find_robot

    chosen = find_robot(robot)
    return chosen, find_kit(kit or chosen.kit)


def _analysed(controller: Controller, robot: Robot, kit: Kit) -> Any:
    """The analysis of the linear loop, or one line where there is none to analyse."""
    from upright.certify import analyse
    from upright.errors import InvalidController

    try:
        return analyse(controller=controller, robot=robot, kit=kit)
    except (InvalidController, SpecMismatch) as error:
        return f"no margins: {error}"


def _cell(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.3g}"
    return "–" if value is None else str(value)
