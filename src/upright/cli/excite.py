"""`upright excite`: the next experiment, whose log identifies the robot best."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from upright.cli.options import (
    JsonOption,
    KernelOption,
    KitOption,
    KnownOption,
    OutputOption,
    PosteriorOption,
    ReportOption,
    RobotOption,
    SamplesOption,
    SeedOption,
)
from upright.cli.output import check_targets, finish, progress


def excite(
    *,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    controller: KernelOption = "lqg",
    seconds: Annotated[float, typer.Option("--seconds", "-s", help="Length of the run [s].")] = 20.0,
    focus: Annotated[
        str | None, typer.Option(metavar="NAME,…", help="Parameters to identify, such as com_height (default: all).")
    ] = None,
    known: KnownOption = None,
    posterior: PosteriorOption = None,
    falls: Annotated[float, typer.Option(help="Largest probability of a fall, with 95 % confidence.")] = 0.01,
    saturated: Annotated[float, typer.Option(help="Largest fraction of periods with a saturated motor.")] = 0.05,
    travel: Annotated[float, typer.Option(help="Largest distance from the start [m].")] = 0.5,
    enough: Annotated[
        float, typer.Option(help="Factor on the narrowest intervals, in exchange for less energy; 1: the narrowest.")
    ] = 1.1,
    samples: SamplesOption = 600,
    seed: SeedOption = 0,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Design an excitation for the most informative log.

    Then run it (`upright simulate --controller … --excite plan.json -o run.csv`, or the robot) and calibrate from the
    log.
    """
    from upright.excitation import excite as design
    from upright.excitation.planned import Limits

    check_targets(output, report)
    names = [name.strip() for name in focus.split(",")] if focus else []
    with progress("designing") as show:
        plan = design(
            controller, robot, kit, seconds=seconds, focus=names, limits=Limits(falls, saturated, travel),
            enough=enough, known=known or (), posterior=posterior, samples=samples, seed=seed, progress=show,
        )  # fmt: skip
    finish(replace(plan, saved=str(output or "")), as_json, output=output, page=report)
