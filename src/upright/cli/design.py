"""`upright design` and `upright bench-controllers`: controllers by name, into a file, or all of them side by side."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json, print_table, progress
from upright.errors import InvalidController, SpecMismatch

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
    posterior: Annotated[
        Path | None,
        typer.Option(help="For robust: what is known of the robot, as by `upright calibrate --save`."),
    ] = None,
    output: Annotated[Path | None, typer.Option("--output", "-o", help="Write the controller as JSON.")] = None,
    report: Annotated[
        Path | None, typer.Option(help="Write a page with Bode, Nyquist, poles and margins: .html.")
    ] = None,
    as_json: JsonOption = False,
) -> None:
    """Design a controller for a robot.

    Says what it reads, how exactly its equations are solved, and the margins of its loop; -o keeps it.
    """
    from upright.control import controller_hash, write_controller

    for target in (output, report):
        if target:
            check_folder(target)
    chosen, parts = _found(robot, kit)
    dt = parts.period if period is None else period
    chosen, controller = _designed(method, chosen, parts, dt, posterior)
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
    if report:
        _write_page(analysis, report)
    record = getattr(controller, "design", None)
    words: list[str] = record.words() if hasattr(record, "words") else []  # type: ignore[union-attr]
    if as_json:
        said = analysis.to_json() if hasattr(analysis, "to_json") else str(analysis)
        own = record.to_json() if hasattr(record, "to_json") else None  # type: ignore[union-attr]
        print_json(facts | {"design": own, "analysis": said})
        return
    said = {name: ", ".join(v) if isinstance(v, list) else v for name, v in facts.items() if v is not None}
    typer.echo("\n".join(f"{name:<10}{value}" for name, value in said.items()))
    typer.echo("\n".join(["", *words, "", str(analysis), *([f"wrote {report}"] if report else [])]))


def _designed(method: str, robot: Robot, kit: Kit, dt: float, posterior: Path | None) -> tuple[Robot, Controller]:
    """The controller, and the robot that it is for: the middle of the posterior where one is given."""
    from upright.control import make_controller, robust

    if posterior is None:
        return robot, make_controller(method, robot, kit, dt)
    if method != "robust":
        raise InvalidController(f"--posterior with {method}", expected="the method robust, which alone asks for it")
    from upright.fleet.vary import known

    middle, sizes, covariance = known(robot, posterior)
    return middle, robust(middle, kit, dt, sizes=sizes, covariance=covariance)


def _write_page(analysis: Any, path: Path) -> None:
    from upright.certify import Analysis
    from upright.report.analysis import analysis_page

    if not isinstance(analysis, Analysis):
        raise InvalidController(
            f"no page without margins: {analysis}", expected="a controller that is linear near rest"
        )
    analysis_page(analysis, path)


def bench_controllers(
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    body: Annotated[str, typer.Option("--body", "-b", help="nonlinear or twin (MuJoCo).")] = "twin",
    seed: Annotated[int, typer.Option(help="Seed of all noise.")] = 1,
    as_json: JsonOption = False,
) -> None:
    """All controllers under the same pushes, in one table.

    Each holds the robot on its kit's sensors through both pushes of Herrera et al. (2015): held at 0.1 rad and at
    −0.12 rad, and released; and is knocked ever harder, from the same side, for the largest impulse that it recovers
    from. Linear ones also meet 200 robots drawn from the spreads of this one's sources. Takes a minute.
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
        "largest knock [N s]",
        "of 200 drawn fall",
        "holds",
    )
    cells = [
        (
            r.controller,
            r.push,
            r.peak,
            r.settling,
            r.travel,
            r.effort,
            r.saturated,
            r.impulse,
            _share(r.spread),
            r.outcome,
        )
        for r in rows
    ]
    print_table(header, [[_cell(value) for value in row] for row in cells], header[2:9])


def _found(robot: str, kit: str | None) -> tuple[Robot, Kit]:
    from upright.robots import find_kit, find_robot

    chosen = find_robot(robot)
    return chosen, find_kit(kit or chosen.kit)


def _analysed(controller: Controller, robot: Robot, kit: Kit) -> Any:
    """The analysis of the linear loop, or one line where there is none to analyse."""
    from upright.certify import analyse

    try:
        return analyse(controller=controller, robot=robot, kit=kit)
    except (InvalidController, SpecMismatch) as error:
        return f"no margins: {error}"


def _share(value: float | None) -> str | None:
    return None if value is None else f"{value:.1%}"


def _cell(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.3g}"
    return "–" if value is None else str(value)
