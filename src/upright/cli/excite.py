"""`upright excite`: the next experiment, whose log identifies the robot best."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

from upright.atomic import write_json
from upright.cli.destination import Destination
from upright.progress import progress


def excite(
    *,
    robot: str = "nxtway-gs",
    kit: str | None = None,
    controller: str = "lqg",
    seconds: float = 20.0,
    focus: str | None = None,
    known: list[str] | None = None,
    posterior: Path | None = None,
    falls: float = 0.01,
    saturated: float = 0.05,
    travel: float = 0.5,
    enough: float = 1.1,
    samples: int = 600,
    seed: int = 0,
    output: Annotated[Path | None, "Write the plan as JSON."] = None,
    out: Destination,
) -> None:
    """Design an excitation for the most informative log.

    Then run it (`upright simulate --controller … --excite plan.json -o run.csv`, or the robot) and calibrate from the
    log.
    """
    from upright.excitation import excite as design
    from upright.excitation.planned import Limits
    from upright.experiment.notation import listed

    out.check(output)
    with progress("designing") as show:
        plan = design(
            controller,
            robot,
            kit,
            seconds=seconds,
            focus=listed(focus),
            limits=Limits(falls, saturated, travel),
            enough=enough,
            known=known or (),
            posterior=posterior,
            samples=samples,
            seed=seed,
            progress=show,
        )
    written = output and write_json(output, plan.to_json())
    out.finish(replace(plan, saved=str(output or "")), written)
