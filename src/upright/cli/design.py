"""`upright design` and `upright bench-controllers`: one controller into a file, or all of them in one table."""

from __future__ import annotations

from typing import Annotated

import typer

from upright.cli.options import (
    BodyOption,
    ControllerOutputOption,
    JsonOption,
    KitOption,
    OutputOption,
    PeriodOption,
    PosteriorOption,
    ReportOption,
    RobotOption,
    SeedOption,
    complete_method,
    named_values,
)
from upright.cli.output import check_targets, finish, progress, warn_of, write_page


def design(
    method: Annotated[
        str,
        typer.Argument(
            help="Method: lqr, lqi, lqg, pid, pid-angle, hinf, mpc, sliding, robust or my.py:Name.",
            autocompletion=complete_method,
        ),
    ],
    *,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    period: PeriodOption = None,
    gains: Annotated[
        str | None,
        typer.Option(
            "--gains",
            metavar="NAME=VALUE,...",
            help="Of pid-angle, the program's own: kp=50,ki=60,kd=1.4,unit=deg,output=pwm.",
        ),
    ] = None,
    posterior: PosteriorOption = None,
    output: ControllerOutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Design a controller for a robot.

    Prints its inputs, the residual of its equations, and the margins of its loop.
    """
    from upright.certification.design import design as design_controller
    from upright.robots import find_robot

    check_targets(output, report)
    warn_of(find_robot(robot))
    own = named_values(gains, "--gains") if gains else None
    result = design_controller(method, robot, kit, period=period, own=own, posterior=posterior)
    write_page(result, report)  # before the controller's file, so that a design without a page leaves none
    written = result.save(output) if output else None
    finish(result, as_json, written=(written, report), file=str(written) if written else None)


def bench_controllers(
    *,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    controller: Annotated[
        list[str] | None,
        typer.Option("--controller", "-c", metavar="METHOD", autocompletion=complete_method,
                     help="Controller by name or my.py:Name (repeatable; default: all)."),
    ] = None,
    body: BodyOption = "twin",
    seed: SeedOption = 1,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:  # fmt: skip
    """Compare all controllers under the same pushes.

    Tests: both pushes of Herrera et al. (2015), and the largest impulse that the robot recovers from. Linear
    controllers are also tested on 200 robots drawn from the spreads. Takes a minute.
    """
    from upright.comparison.bench import bench_controllers as bench

    check_targets(output, report)
    with progress("simulating") as show:
        result = bench(robot, kit, body, seed=seed, methods=controller or (), progress=show)
    finish(result, as_json, output=output, page=report)
