"""`upright certify`: may this controller drive this robot?"""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import (
    ControllerArgument,
    JsonOption,
    KitOption,
    MappingOption,
    OutputOption,
    PeriodOption,
    PosteriorOption,
    ReportOption,
    RobotOption,
    SamplesOption,
    SeedOption,
)
from upright.cli.output import AGAINST, check_targets, finish, progress


def certify(
    controller: ControllerArgument,
    *,
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    log: Annotated[
        Path | None, typer.Option(help="Raw log of this robot: calibrates it first and tests the assumptions.")
    ] = None,
    mapping: MappingOption = None,
    posterior: PosteriorOption = None,
    weighed: Annotated[
        float | None, typer.Option(help="What the robot weighs on a scale [kg]: no log is asked the mass then.")
    ] = None,
    period: PeriodOption = None,
    samples: SamplesOption = 1000,
    seed: SeedOption = 0,
    output: OutputOption = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Certify a controller for a robot: green, amber, red or unknown.

    Does it stand? How hard may I push it? Which of its numbers are guesses, and which decides? Exit code 0 for green
    and amber, 3 for red and unknown.
    """
    from upright.certification.certificate import certify as examine

    check_targets(output, report)
    with progress("certifying") as show:
        certificate = examine(
            controller, robot, kit, log=log, mapping=mapping, posterior=posterior, weighed=weighed, period=period,
            samples=samples, seed=seed, progress=show,
        )  # fmt: skip
    finish(certificate, as_json, output=output, page=report)
    if certificate.light in ("red", "unknown"):
        raise typer.Exit(AGAINST)
