"""`upright tune`: weights found on a fleet's verdict."""

from __future__ import annotations

from typing import Annotated

import typer

from upright.cli.options import (
    ControllerOutputOption,
    JsonOption,
    KitOption,
    ReportOption,
    RobotOption,
    SamplesOption,
    SeedOption,
    complete_tunable,
)
from upright.cli.output import check_targets, finish, progress, write_page


def tune(
    method: Annotated[
        str,
        typer.Argument(help="Method: lqr, lqi, lqg, pid, hinf, mpc or sliding.", autocompletion=complete_tunable),
    ],
    *,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    budget: Annotated[int, typer.Option(help="Number of candidates tried.")] = 400,
    seconds: Annotated[
        float | None, typer.Option("--seconds", "-s", help="Stop the search after this time [s] (default: never).")
    ] = None,
    samples: SamplesOption = 1000,
    seed: SeedOption = 0,
    output: ControllerOutputOption = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on with the search that -o was stopped in.")] = False,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Tune a controller's weights on many robots.

    Searches for fewer falls, then for a larger knock, with no margin smaller than the default's. Compares both on
    robots that the search never saw. Ctrl-C leaves the search beside the output, for --resume.
    """
    from upright.tuning.tune import tune as search

    check_targets(output, report)
    state = output.with_name(f"{output.name}.search") if output else None
    try:
        with progress("tuning") as show:
            result = search(
                method, robot, kit, budget=budget, seconds=seconds, samples=samples, seed=seed, state=state,
                resume=resume, progress=show,
            )  # fmt: skip
    except KeyboardInterrupt:
        if state and state.exists():
            typer.echo(f"the search is kept in {state}: the same command with --resume goes on", err=True)
        raise
    write_page(result, report)  # before the controller's file, so that a result without a page leaves none
    written = result.save(output) if output else None
    finish(result, as_json, written=(written, report), file=str(written) if written else None)
