"""`upright identify`: linear models from a log, by one method or by all."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.destination import Destination
from upright.cli.logs import LogPart
from upright.cli.vocabulary import complete_identifier
from upright.errors import UprightError
from upright.progress import progress


def identify(
    log: Path,
    *,
    method: Annotated[
        str | None,
        typer.Option(
            help="Method: least-squares, total-least-squares, instrumental, subspace, calibrate, or all (default: all; "
            "of a file subspace).",
            autocompletion=complete_identifier,
        ),
    ] = None,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    part: LogPart,
    states: bool = False,
    delay: float | None = None,
    order: int | None = None,
    held_out: float = 0.25,
    repeats: int = 40,
    seed: int = 0,
    output: Annotated[Path | None, "Write the model as JSON."] = None,
    regulator: Path | None = None,
    out: Destination,
) -> None:
    """Identify a linear model from a log.

    Prints the unstable pole with its interval. Compares all methods, and tests a regulator designed on each model,
    unless one is named, or one model is to be written.
    """
    from upright.control import write_controller
    from upright.identification.identified import Identified
    from upright.identification.identify import ALL, identify_all, identify_one, study_of
    from upright.identification.judge import regulator as designed
    from upright.robots import find_kit, find_robot

    method = method or ("subspace" if output or regulator else ALL)
    _check_method(method, output or regulator)
    out.check(output, regulator, logs=[log])
    (read,) = part.read([log])
    study = study_of(
        read,
        find_robot(robot),
        find_kit(kit) if kit else None,
        source="states" if states else "sensors",
        delay=delay,
        order=order,
        held_out=held_out,
        runs=repeats,
        seed=seed,
    )
    with progress("identifying") as show:
        result = identify_all(study, progress=show) if method == ALL else identify_one(study, method)
    if isinstance(result, Identified):
        if regulator:  # designed before any file is written, so that its failure leaves none
            write_controller(designed(study.samples, result.halves), regulator)
        if output:
            result.save(output)
    out.finish(result, output, regulator)


def _check_method(method: str, target: Path | None) -> None:
    """Raises `UnknownName` for an unknown method, `UprightError` where `target` would hold the models of all."""
    from upright.identification.identify import ALL
    from upright.identification.methods import find_identifier

    if method != ALL:
        find_identifier(method)
    elif target:
        raise UprightError(f"{target.name} holds one model", expected="one method", hint="name it, --method subspace")
