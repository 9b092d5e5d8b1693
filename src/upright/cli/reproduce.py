"""`upright reproduce`: Herrera et al. (2015) again, from its equations to its comparison, or with one's own log."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from upright.atomic import make_folder
from upright.cli.command import flag
from upright.cli.destination import Destination
from upright.cli.logs import LogPart
from upright.cli.typed import GIVEN
from upright.errors import InvalidScenario
from upright.progress import progress


def reproduce(
    *,
    output: Annotated[Path, "Write the page, the logs and the numbers into this folder."] = Path("herrera2015"),
    log: Annotated[Path | None, "Log of this robot, put into the paper's figures."] = None,
    robot: Annotated[str | None, "Robot by name (see `upright robots`) or TOML file, of the log."] = None,
    calibrated: str | None = None,
    kit: str | None = None,
    controller: Annotated[
        str | None, "Controller by name, controller.json or my.py:Name, of the log (default: read from it)."
    ] = None,
    push: list[str] | None = None,
    part: LogPart,
    json: bool = False,
) -> None:
    """Reproduce the paper of Herrera and others (2015).

    Its model, fit, regulator and pushes beside the printed numbers, and the errata of the text. With --log and --robot:
    your robot in its figures, beside both models under the same push and law, and what must be adjusted.
    """
    if log is None:
        of_a_log = [flag(name) for name in GIVEN.get() if name not in ("output", "json")]
        if of_a_log:
            raise InvalidScenario(f"{', '.join(of_a_log)} without a log", expected="--log FILE --robot ROBOT")
        from upright.paper.reproduce import reproduce as reproduce_paper

        with progress("reproducing") as show:
            done = reproduce_paper(output, show)
        Destination(json=json).finish(done, output / "report.html", output / "results.json", output / "logs")
        return
    if robot is None:
        raise InvalidScenario("--log without a robot", expected="--robot NAME or FILE", hint="upright robots")
    from upright.experiment.notation import push as push_of
    from upright.paper.own_log import compare_own

    (read,) = part.read([log])
    logs = make_folder(output / "logs")
    with progress("reproducing") as show:
        result = compare_own(
            read,
            robot,
            kit,
            controller=controller,
            push=[push_of(text) for text in push or ()],
            learnt=calibrated,
            progress=show,
        )
    for label, one in result.comparison.logs.items():
        one.save(logs / f"{label.replace(' ', '-')}.parquet")
    Destination(report=output / "report.html", save=output / "results.json", json=json).finish(result, logs)
