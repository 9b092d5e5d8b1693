"""`upright simulate`: a robot under a controller and pushes; its log and metrics."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from upright.cli import options
from upright.cli.output import check_targets, finish, progress, warn_of
from upright.errors import InvalidController

if TYPE_CHECKING:
    from upright.control import Controller
    from upright.robots import Kit, Robot


def simulate(
    *,
    robot: options.RobotOption = "nxtway-gs",
    body: options.BodyOption = "nonlinear",
    kit: options.IdealKitOption = None,
    controller: Annotated[
        str | None,
        typer.Option(
            "--controller",
            "-c",
            help=f"{options.CONTROLLER_HELP} (default: lqg; lqr-state with --kit ideal).",
            autocompletion=options.complete_controller,
        ),
    ] = None,
    gains: Annotated[
        str | None, typer.Option(help="State feedback u = −Kx: six gains 'k1,…,k6', or a JSON file with a 2×6 'gain'.")
    ] = None,
    period: options.PeriodOption = None,
    push: options.PushOption = None,
    slope: Annotated[str | None, typer.Option(metavar="RAD[,start=S]", help="Slope of the floor.")] = None,
    drive: options.DriveOption = None,
    turn: options.TurnOption = None,
    excite: Annotated[Path | None, typer.Option(help="Plan by `upright excite`, added to the commands.")] = None,
    start: options.StartOption = "",
    lying: Annotated[float | None, typer.Option(metavar="RAD", help="Start lying at this pitch, and stand up.")] = None,
    seconds: Annotated[
        float | None, typer.Option("--seconds", "-s", help="Length of the run [s] (default: 10, or the plan's).")
    ] = None,
    seed: options.SeedOption = 0,
    output: options.LogOutputOption = None,
    report: options.ReportOption = None,
    as_json: options.JsonOption = False,
) -> None:
    """Simulate a robot under a controller and pushes.

    Prints whether it fell, its largest pitch, its travel, and the effort of the motors.
    """
    from upright.comparison.simulate import simulate as simulated
    from upright.robots import find_kit, find_robot
    from upright.signals import STATE_NAMES

    pushes, references = options.pushes_and_references(push, drive, turn, slope)
    first = options.vector(start, STATE_NAMES, "--start")
    check_targets(output, report)
    chosen = find_robot(robot)
    warn_of(chosen)
    parts = find_kit(kit or chosen.kit)
    design = _controller(controller, gains, chosen, parts, period)
    design, planned = _excited(design, excite) if excite else (design, 10.0)
    length = planned if seconds is None else seconds
    if lying is not None:
        design = _standing_up(design, chosen, parts, lying, start)
        first = [lying, *[0.0] * 5]
    with progress("simulating") as show:
        result = simulated(
            chosen, design, parts, body=body, push=pushes, reference=references, seconds=length, seed=seed, start=first,
            progress=show,
        )  # fmt: skip
    written = result.log.save(output) if output else None
    finish(result, as_json, page=report, written=[written], log=str(written) if written else None)


def _controller(name: str | None, gains: str | None, robot: Robot, kit: Kit, period: float | None) -> Controller:
    """The controller of the options."""
    from upright.comparison.simulate import controller_for

    if gains is not None and name is not None:
        raise InvalidController("both --controller and --gains", expected="one of them")
    return controller_for(name, robot, kit, period, gains)


def _excited(controller: Controller, path: Path) -> tuple[Controller, float]:
    """The controller with a plan's excitation, and the plan's length [s]; warns of a plan for another controller."""
    from upright.excitation.plan import read_plan

    plan = read_plan(path)
    if why := plan.differs(controller):
        typer.echo(f"{path} was checked with {why}; its limits do not hold for this run", err=True)
    return plan.excited(controller), plan.seconds


def _standing_up(controller: Controller, robot: Robot, kit: Kit, pitch: float, start: str) -> Controller:
    """The controller behind a lift from that pitch."""
    from upright.experiment.standup import standing_up

    if start:
        raise InvalidController("both --start and --lying", expected="one of them: a lift begins at rest")
    return standing_up(controller, robot, kit, pitch)
