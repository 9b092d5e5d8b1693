"""`upright identify`: linear models from a log, by one method or by all."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.options import (
    AfterOption,
    BeforeOption,
    HeldOutOption,
    JsonOption,
    KitOption,
    LogArgument,
    MappingOption,
    ModelOutputOption,
    ReportOption,
    RobotOption,
    SeedOption,
    completed,
    part_of_log,
)
from upright.cli.output import check_targets, finish, progress
from upright.errors import UprightError


def _methods() -> list[str]:
    from upright.identification.methods import IDENTIFIERS

    return [*IDENTIFIERS, "all"]


MethodOption = Annotated[
    str,
    typer.Option(
        help="least-squares, total-least-squares, instrumental, subspace, calibrate, or all.",
        autocompletion=completed(_methods),
    ),
]


def identify(
    log: LogArgument,
    *,
    method: MethodOption = "subspace",
    robot: RobotOption = "nxtway-gs",
    kit: KitOption = None,
    mapping: MappingOption = None,
    start: AfterOption = None,
    until: BeforeOption = None,
    states: Annotated[bool, typer.Option("--states", help="Use the true states of a twin's log.")] = False,
    delay: Annotated[float | None, typer.Option(help="Delay from command to sensors [s] (default: estimated).")] = None,
    order: Annotated[
        int | None, typer.Option(max=50, help="States of pitch and wheels, 4 or more (default: chosen).")
    ] = None,
    held_out: HeldOutOption = 0.25,
    repeats: Annotated[int, typer.Option(min=0, max=10_000, help="Simulated logs for intervals and bias.")] = 40,
    seed: SeedOption = 0,
    output: ModelOutputOption = None,
    controller: Annotated[
        Path | None, typer.Option("--controller", "-c", help="Write a regulator of the model as JSON.")
    ] = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Identify a linear model from a log.

    Prints the unstable pole with its interval and the bias of the method. --method all compares the methods, and tests
    a regulator designed on each model.
    """
    from upright.control import write_controller
    from upright.identification.identified import Identified
    from upright.identification.identify import ALL, identify_all, identify_one, study_of
    from upright.identification.judge import regulator
    from upright.robots import find_kit, find_robot

    _check_method(method, output or controller)
    check_targets(output, controller, report, logs=[log])
    study = study_of(
        part_of_log(log, mapping, start, until), find_robot(robot), find_kit(kit) if kit else None,
        source="states" if states else "sensors", delay=delay, order=order, held_out=held_out, runs=repeats, seed=seed,
    )  # fmt: skip
    with progress("identifying") as show:
        result = identify_all(study, progress=show) if method == ALL else identify_one(study, method)
    if isinstance(result, Identified):
        if controller:  # designed before any file is written, so that its failure leaves none
            write_controller(regulator(study.samples, result.halves), controller)
        if output:
            result.save(output)
    finish(result, as_json, page=report, written=(output, controller))


def _check_method(method: str, target: Path | None) -> None:
    """Raises `UnknownName` for an unknown method, `UprightError` where `target` would hold the models of all."""
    from upright.identification.identify import ALL
    from upright.identification.methods import find_identifier

    if method != ALL:
        find_identifier(method)
    elif target:
        raise UprightError(f"{target.name} holds one model", expected="one method", hint="name it, --method subspace")
