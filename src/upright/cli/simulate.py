"""`upright simulate`: a robot under a controller and pushes; its log and metrics."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli import options
from upright.cli.output import check_targets, finish, progress, warn_of, write_page
from upright.errors import InvalidController
from upright.interrupts import MOTORS
from upright.reading import read_json, understood

if TYPE_CHECKING:
    from upright.control import Controller
    from upright.robots import Kit, Robot
    from upright.signals import Log


def simulate(
    *,
    robot: options.RobotOption = "nxtway-gs",
    body: options.BodyOption = "nonlinear",
    kit: options.IdealKitOption = None,
    controller: Annotated[
        str | None,
        typer.Option(
            "--controller",
            "-c",
            help=f"{options.CONTROLLER_HELP} (default: lqg; lqr-state with --kit ideal).",
            autocompletion=options.complete_controller,
        ),
    ] = None,
    gains: Annotated[
        str | None, typer.Option(help="State feedback u = −Kx: six gains 'k1,…,k6', or a JSON file with a 2×6 'gain'.")
    ] = None,
    period: options.PeriodOption = None,
    push: options.PushOption = None,
    slope: Annotated[str | None, typer.Option(metavar="RAD[,start=S]", help="Slope of the floor.")] = None,
    drive: options.DriveOption = None,
    turn: options.TurnOption = None,
    excite: Annotated[Path | None, typer.Option(help="Plan by `upright excite`, added to the commands.")] = None,
    start: options.StartOption = "",
    lying: Annotated[float | None, typer.Option(metavar="RAD", help="Start lying at this pitch, and stand up.")] = None,
    seconds: Annotated[
        float | None, typer.Option("--seconds", "-s", help="Length of the run [s] (default: 10, or the plan's).")
    ] = None,
    seed: options.SeedOption = 0,
    output: options.LogOutputOption = None,
    report: options.ReportOption = None,
    as_json: options.JsonOption = False,
) -> None:
    """Simulate a robot under a controller and pushes.

    Prints whether it fell, its largest pitch, its travel, and the effort of the motors.
    """
    from upright.experiment import run
    from upright.robots import find_robot
    from upright.signals import STATE_NAMES

    pushes, references = options.pushes_and_references(push, drive, turn, slope)
    first = options.vector(start, STATE_NAMES, "--start")
    check_targets(output, report)
    chosen = find_robot(robot)
    warn_of(chosen)
    plant, design = _fitted(chosen, body=body, kit=kit or chosen.kit, controller=controller, gains=gains, period=period)
    design, planned = _excited(design, excite) if excite else (design, 10.0)
    length = planned if seconds is None else seconds
    if lying is not None:
        design = _standing_up(design, chosen, kit or chosen.kit, lying, start)
        first = [lying, *[0.0] * 5]
    with MOTORS, closing(plant), progress("simulating") as show:  # hardware is stopped however this ends
        log = run(plant, design, pushes, reference=references, seconds=length, seed=seed, start=first, progress=show)
    written = log.save(output) if output else None
    _show(log, body=body, written=written, report=report, as_json=as_json)


def _show(log: Log, *, body: str, written: Path | None, report: Path | None, as_json: bool) -> None:
    """Prints the outcome and the metrics of a run, and writes its page."""
    from upright.comparison import compare
    from upright.experiment import motionless, outcome_of, undisturbed
    from upright.experiment.outcome import PUSHED

    numbers = compare({body: log})
    write_page(numbers, report)
    calm = [f"nothing disturbs the robot; try: {PUSHED}", motionless(log)] * undisturbed(log)
    text = "\n".join(filter(None, [*calm, numbers.ended(numbers.reference)]))
    finish(
        numbers, as_json, written=(written, report), text=text, outcome=outcome_of(log).to_json(), origin=log.origin,
        log=str(written) if written else None,
    )  # fmt: skip


def _fitted(
    robot: Robot, *, body: str, kit: Kit | str, controller: str | None, gains: str | None, period: float | None
) -> tuple[Any, Controller]:
    """The body inside its electronics and a controller that can read what it offers."""
    from upright.bodies import Electronics, make_body
    from upright.bodies.electronics import without_missing
    from upright.control import find_controller
    from upright.robots import find_kit

    parts = find_kit(kit)
    ideal = parts.name == "ideal"
    bare = make_body(body, robot)
    plant = Electronics(bare, without_missing(parts, bare) if ideal else parts)  # ideal: whatever the body has
    dt = parts.period if period is None else period
    if gains is not None and controller is not None:
        raise InvalidController("both --controller and --gains", expected="one of them")
    if gains is not None:
        return plant, _state_feedback(gains, robot, None if ideal else parts, dt)
    return plant, find_controller(controller or ("lqr-state" if ideal else "lqg"), robot, parts, dt)


def _excited(controller: Controller, path: Path) -> tuple[Controller, float]:
    """The controller with a plan's excitation, and the plan's length [s]; warns of a plan for another controller."""
    from upright.excitation.plan import read_plan

    plan = read_plan(path)
    if why := plan.differs(controller):
        typer.echo(f"{path} was checked with {why}; its limits do not hold for this run", err=True)
    return plan.excited(controller), plan.seconds


def _standing_up(controller: Controller, robot: Robot, kit: Kit | str, pitch: float, start: str) -> Controller:
    """The controller behind a lift from that pitch."""
    if start:
        raise InvalidController("both --start and --lying", expected="one of them: a lift begins at rest")
    from upright.experiment.standup import StandUpController, lift
    from upright.robots import find_kit

    parts = find_kit(kit)
    return StandUpController(lift(robot, parts, pitch, controller.spec.period), controller, parts)


def _state_feedback(gains: str, robot: Robot, kit: Kit | None, dt: float) -> Controller:
    """u = −Kx on the true state, or behind a Kalman filter where there is a kit."""
    from upright.control import StateFeedback, observed

    if gains.endswith(".json"):
        expected = 'JSON such as {"gain": [[six], [six]]}'
        data = read_json(Path(gains), InvalidController, expected)
        with understood(f"the gain in {gains}", InvalidController, expected):
            feedback = StateFeedback(data["gain"], dt, robot.command_unit)
    else:
        row = [options.number(text, "--gains") for text in gains.split(",")]
        feedback = StateFeedback.symmetric(row, dt, command_unit=robot.command_unit)
    return feedback if kit is None else observed(feedback, robot, kit)
