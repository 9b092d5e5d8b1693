"""`upright reproduce`: Herrera et al. (2015) again, from its equations to its comparison, or with one's own log."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.atomic import make_folder
from upright.cli import options
from upright.cli.output import finish, progress
from upright.errors import InvalidScenario


def reproduce(
    *,
    output: Annotated[
        Path, typer.Option("--output", "-o", help="Folder for the page, the logs and the numbers.")
    ] = Path("herrera2015"),
    log: Annotated[Path | None, typer.Option(help="Log of your own robot, put into the paper's figures.")] = None,
    robot: Annotated[
        str | None,
        typer.Option("--robot", "-r", help=f"{options.ROBOT_HELP}, of the log.", autocompletion=options.complete_robot),
    ] = None,
    calibrated: Annotated[
        str | None,
        typer.Option(help="The same robot as another log calibrated it (default: from this log).",
                     autocompletion=options.complete_robot),
    ] = None,
    kit: options.KitOption = None,
    controller: options.LawOption = None,
    push: options.PushOption = None,
    mapping: options.MappingOption = None,
    start: options.AfterOption = None,
    until: options.BeforeOption = None,
    as_json: options.JsonOption = False,
) -> None:  # fmt: skip
    """Reproduce the paper of Herrera and others (2015).

    Its model, fit, regulator and pushes beside the printed numbers, and the errata of the text. With --log and --robot:
    your robot in its figures, beside both models under the same push and law, and what must be adjusted.
    """
    if log is None:
        given = {"--robot": robot, "--calibrated": calibrated, "--kit": kit, "--controller": controller, "--push": push,
                 "--mapping": mapping, "--start": start, "--until": until}  # fmt: skip
        if named := [name for name, value in given.items() if value is not None]:
            raise InvalidScenario(f"{', '.join(named)} without a log", expected="--log FILE --robot ROBOT")
        from upright.paper.reproduce import reproduce as reproduce_paper

        with progress("reproducing") as show:
            done = reproduce_paper(output, show)
        finish(done, as_json, written=[output / "report.html", output / "results.json", output / "logs"])
        return
    if robot is None:
        raise InvalidScenario("--log without a robot", expected="--robot NAME or FILE", hint="upright robots")
    from upright.paper.own_log import compare_own

    pushes = [options.push(text) for text in push or ()]
    logs = make_folder(output / "logs")
    with progress("reproducing") as show:
        result = compare_own(
            options.part_of_log(log, mapping, start, until), robot, kit,
            controller=controller, push=pushes, learnt=calibrated, progress=show,
        )  # fmt: skip
    for label, one in result.comparison.logs.items():
        one.save(logs / f"{label.replace(' ', '-')}.parquet")
    finish(result, as_json, output=output / "results.json", page=output / "report.html", written=[logs])
