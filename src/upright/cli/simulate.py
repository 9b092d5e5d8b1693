"""`upright simulate`: a robot under a controller and pushes; its log and metrics."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from upright.cli.destination import Destination
from upright.cli.output import tell, warn_of
from upright.errors import InvalidController
from upright.progress import progress

if TYPE_CHECKING:
    from upright.control import Controller


def simulate(
    *,
    robot: str = "nxtway-gs",
    body: str = "nonlinear",
    kit: Annotated[str | None, "Electronics by name or TOML file; ideal for none (default: the robot's)."] = None,
    controller: Annotated[
        str | None,
        "Controller by name, controller.json or my.py:Name (default: lqg; lqr-state with --kit ideal).",
    ] = None,
    feedback: str | None = None,
    period: float | None = None,
    push: list[str] | None = None,
    slope: str | None = None,
    drive: str | None = None,
    turn: str | None = None,
    excite: Path | None = None,
    start: str = "",
    lying: float | None = None,
    seconds: Annotated[float | None, "Length of the run [s] (default: 10, or the plan's)."] = None,
    seed: int = 0,
    output: Annotated[Path | None, "Write the log: .parquet, .csv or .mcap."] = None,
    out: Destination,
) -> None:
    """Simulate a robot under a controller and pushes.

    Prints whether it fell, its largest pitch, its travel, and the effort of the motors.
    """
    from upright.comparison.simulate import controller_for
    from upright.comparison.simulate import simulate as simulated
    from upright.experiment.notation import first_state, pushes_and_references
    from upright.experiment.standup import standing_up
    from upright.robots import find_kit, find_robot
    from upright.signals.files import check_format

    if feedback is not None and controller is not None:
        raise InvalidController("both --controller and --feedback", expected="one of them", hint="leave one out")
    if lying is not None and start:
        raise InvalidController("both --start and --lying", expected="one of them: a lift begins at rest")
    pushes, references = pushes_and_references(push, drive, turn, slope)
    first = first_state(start, "--start")
    out.check(output)
    check_format(output)
    chosen = find_robot(robot)
    warn_of(chosen)
    parts = find_kit(kit or chosen.kit)
    design = controller_for(controller, chosen, parts, period, feedback)
    length = 10.0
    if excite:
        design, length = _excited(design, excite)
    if lying is not None:
        design = standing_up(design, chosen, parts, lying)
        first = (lying, *[0.0] * 5)
    run: dict[str, Any] = {"seconds": length if seconds is None else seconds, "seed": seed, "start": first}
    with progress("simulating") as show:
        result = simulated(chosen, design, parts, body=body, push=pushes, reference=references, progress=show, **run)
    out.finish(result, output and result.log.save(output))


def _excited(controller: Controller, path: Path) -> tuple[Controller, float]:
    """The controller with a plan's excitation, and the plan's length [s]; warns of a plan for another controller."""
    from upright.excitation.plan import read_plan

    plan = read_plan(path)
    if why := plan.differs(controller):
        tell(f"{path} was checked with {why}; its limits do not hold for this run", err=True)
    return plan.excited(controller), plan.seconds
