"""`upright tune`: weights found on a fleet's verdict."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from upright.cli.destination import Destination
from upright.cli.output import goes_on_from
from upright.cli.vocabulary import complete_tunable
from upright.progress import progress


def tune(
    method: Annotated[
        str,
        typer.Argument(
            help="Method: lqr, lqi, lqg, pid, pid-angle, hinf, mpc or sliding.", autocompletion=complete_tunable
        ),
    ],
    *,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    budget: int = 400,
    time_limit: Annotated[float | None, "Stop the search after this time [s] (default: never)."] = None,
    samples: int = 1000,
    seed: int = 0,
    output: Annotated[Path | None, "Write the controller as JSON."] = None,
    resume: bool = False,
    out: Destination,
) -> None:
    """Tune a controller's weights on many robots.

    Searches for fewer falls, then for a larger knock, with no margin smaller than the default's. Compares both on
    robots that the search never saw. Ctrl-C leaves the search beside the output, for --resume.
    """
    from upright.tuning.tune import tune as search

    out.check(output)
    state = output.with_name(f"{output.name}.search") if output else None
    kept = f"the search is kept in {state}: the same command with --resume goes on"
    with goes_on_from(state, kept), progress("tuning") as show:
        result = search(
            method,
            robot,
            kit,
            budget=budget,
            seconds=time_limit,
            samples=samples,
            seed=seed,
            state=state,
            resume=resume,
            progress=show,
        )
    out.finish(result, output and result.save(output))
