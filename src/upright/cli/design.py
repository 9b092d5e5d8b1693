"""`upright design` and `upright bench-controllers`: controllers by name, into a file, or all of them side by side."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import print_json, print_table, progress
from upright.errors import SpecMismatch, UprightError

if TYPE_CHECKING:
    from upright.control import Controller
    from upright.robots import Kit, Robot

KitOption = Annotated[str | None, typer.Option(help="Electronics by name or TOML file (default: the robot's own).")]
PeriodOption = Annotated[float | None, typer.Option(help="Controller's period [s] (default: the kit's).")]

BENCH = ("lqr", "lqi", "lqg", "pid", "hinf", "mpc", "sliding", "robust")
HOLD_UNTIL, SECONDS = 4.0, 8.0  # [s]
PUSHES = {"front": 0.1, "back": -0.12}  # [rad] Herrera et al. (2015), section 3.2


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
    chosen, parts = _found(robot, kit)
    rows: list[dict[str, Any]] = []
    with progress("pushing") as share:
        for done, method in enumerate(BENCH):
            rows += [_pushed(method, side, chosen, parts, body, seed) for side in PUSHES]
            share((done + 1) / len(BENCH))
    if as_json:
        print_json({"robot": chosen.name, "kit": parts.name, "body": body, "seed": seed, "rows": rows})
        return
    header = (
        "controller",
        "push",
        "holds",
        "peak pitch [rad]",
        "settling 5 % [s]",
        "travel [rad]",
        "effort",
        "saturated",
    )
    print_table(header, [[_cell(row[name]) for name in header] for row in rows], header[3:])


def _pushed(method: str, side: str, robot: Robot, kit: Kit, body: str, seed: int) -> dict[str, Any]:
    from upright.bodies import Electronics, make_body
    from upright.comparison import compare
    from upright.control import make_controller
    from upright.experiment import Hold, run

    row: dict[str, Any] = {"controller": method, "push": f"{side} {PUSHES[side]:+.2f}"}
    absent = dict.fromkeys(("peak pitch [rad]", "settling 5 % [s]", "travel [rad]", "effort", "saturated"))
    try:
        controller = make_controller(method, robot, kit, kit.period)
    except UprightError as error:
        return row | {"holds": f"no design: {str(error).split(';')[0]}"} | absent
    plant = Electronics(make_body(body, robot), kit)
    log = run(plant, controller, Hold(pitch=PUSHES[side], until=HOLD_UNTIL), seconds=SECONDS, seed=seed)
    plant.close()
    numbers = compare({body: log}).to_json()["logs"][body]["metrics"]
    outcome = log.origin["outcome"]
    return row | {
        "holds": f"fell at {outcome['seconds']:.1f} s" if outcome["fell"] else "yes",
        "peak pitch [rad]": numbers["pitch_peak"],
        "settling 5 % [s]": numbers["settling_5"],
        "travel [rad]": numbers["wheel_travel"],
        "effort": numbers["effort"],
        "saturated": numbers["saturated"],
    }


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
