"""`upright simulate`: a body under a controller, pushed; the log and its numbers."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli import options
from upright.cli.options import JsonOption, RobotOption
from upright.cli.output import check_folder, print_json, progress
from upright.errors import InvalidController

if TYPE_CHECKING:
    from upright.control import Controller
    from upright.robots import Kit, Robot
    from upright.signals import Log

IDEAL = "ideal"
"""The kit that hides nothing: no electronics round the body, and controllers may read the true state."""

SECONDS = 10.0


def simulate(
    *,
    robot: RobotOption = "nxtway-gs",
    body: Annotated[
        str, typer.Option("--body", "-b", help="nonlinear, published, linear or twin (MuJoCo).")
    ] = "nonlinear",
    kit: Annotated[
        str | None, typer.Option(help="Electronics by name or TOML file; ideal for none (default: the robot's own).")
    ] = None,
    controller: Annotated[
        str | None,
        typer.Option("--controller", "-c", help="By name or JSON file (default: lqg, or lqr-state with --kit ideal)."),
    ] = None,
    gains: Annotated[
        str | None,
        typer.Option(help="u = −Kx instead: the left motor's six gains 'k1,…,k6', or a JSON file with a 2×6 'gain'."),
    ] = None,
    period: Annotated[float | None, typer.Option(help="Controller's period [s] (default: the kit's).")] = None,
    push: Annotated[
        list[str] | None, typer.Option("--push", "-p", metavar="KIND:NUMBER,...", help=options.PUSH_HELP)
    ] = None,
    slope: Annotated[str | None, typer.Option(metavar="RAD[,start=S]", help="A floor that climbs.")] = None,
    drive: Annotated[str | None, typer.Option(metavar="M/S[,start=S,until=S]", help="Roll at a speed.")] = None,
    turn: Annotated[
        str | None, typer.Option(metavar="RAD/S[,start=S,until=S]", help="Turn, anticlockwise positive.")
    ] = None,
    excite: Annotated[
        Path | None, typer.Option(help="Add the excitation of a plan by `upright excite` to the commands.")
    ] = None,
    start: Annotated[str, typer.Option(help="First state, such as pitch=0.05; zero where not said.")] = "",
    lying: Annotated[float | None, typer.Option(metavar="RAD", help="Lie at this pitch, then stand up.")] = None,
    seconds: Annotated[float | None, typer.Option("--seconds", "-s", help="How long [s] (10, or as the plan).")] = None,
    seed: Annotated[int, typer.Option(help="Seed of all noise.")] = 0,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the log: .parquet, .csv or .mcap.")
    ] = None,
    as_json: JsonOption = False,
) -> None:
    """Run a model or the twin under a controller, pushed.

    Prints whether it fell, the peak of its pitch, how far it rolled, and what the motors did; -o keeps the log.
    """
    from upright.experiment import run
    from upright.robots import find_robot
    from upright.signals import STATE_NAMES

    pushes, references = _programmes(push or [], slope, drive, turn)
    first = options.vector(start, STATE_NAMES, "--start")
    if output:
        check_folder(output)
    chosen = find_robot(robot)
    plant, brain = _fitted(chosen, body=body, kit=kit or chosen.kit, controller=controller, gains=gains, period=period)
    brain, planned = _excited(brain, excite) if excite else (brain, SECONDS)
    lasts = planned if seconds is None else seconds
    if lying is not None:
        brain, first = _standing_up(brain, chosen, kit or chosen.kit, lying, start), [lying, *[0.0] * 5]
    with progress("simulating") as share:
        log = run(plant, brain, pushes, reference=references, seconds=lasts, seed=seed, start=first, progress=share)
    plant.close()
    _say(log, body, log.save(output) if output else None, as_json)


def _fitted(
    robot: Robot, *, body: str, kit: str, controller: str | None, gains: str | None, period: float | None
) -> tuple[Any, Controller]:
    """The body inside its electronics and a controller that can read what it offers."""
    from upright.bodies import Electronics, make_body
    from upright.control import find_controller
    from upright.robots import find_kit

    bare, parts = make_body(body, robot), find_kit(kit)
    ideal = parts.name == IDEAL
    plant = bare if ideal else Electronics(bare, parts)
    dt = parts.period if period is None else period
    if gains is not None and controller is not None:
        raise InvalidController("both --controller and --gains", expected="one of them")
    if gains is not None:
        return plant, _state_feedback(gains, robot, None if ideal else parts, dt)
    return plant, find_controller(controller or ("lqr-state" if ideal else "lqg"), robot, parts, dt)


def _excited(controller: Controller, path: Path) -> tuple[Controller, float]:
    """The controller with a plan's excitation, and how long this lasts [s]; says where it was made with another one."""
    from upright.control import controller_hash
    from upright.excite.plan import read_plan

    plan = read_plan(path)
    if controller_hash(controller) != plan.hash:
        typer.echo(f"{path} was checked with another {plan.controller}: its limits are not those of this run", err=True)
    return plan.excited(controller), plan.seconds


def _standing_up(controller: Controller, robot: Robot, kit: str, pitch: float, start: str) -> Controller:
    """The controller behind a lift from that pitch."""
    if start:
        raise InvalidController("both --start and --lying", expected="one of them: a lift begins at rest")
    from upright.control.standup import StandUp, lift
    from upright.robots import find_kit

    parts = find_kit(kit)
    return StandUp(lift(robot, parts, pitch, controller.spec.period), controller, parts)


def _state_feedback(gains: str, robot: Robot, kit: Kit | None, dt: float) -> Controller:
    """u = −Kx on the true state, or behind a Kalman filter where there is a kit."""
    from upright.control import StateFeedback, observed

    if gains.endswith(".json"):
        feedback = StateFeedback(_read_gain(Path(gains)), dt, robot.command_unit)
    else:
        row = [options.number(text, "--gains") for text in gains.split(",")]
        feedback = StateFeedback.symmetric(row, dt, command_unit=robot.command_unit)
    return feedback if kit is None else observed(feedback, robot, kit)


def _read_gain(path: Path) -> Any:
    import numpy as np

    try:
        return np.array(json.loads(path.read_text(encoding="utf-8"))["gain"], dtype=np.float64)
    except (ValueError, KeyError, TypeError) as error:
        raise InvalidController(
            f"{path} holds no gain ({type(error).__name__}: {error})", expected='JSON such as {"gain": [[six], [six]]}'
        ) from None


def _programmes(push: list[str], slope: str | None, drive: str | None, turn: str | None) -> tuple[list[Any], list[Any]]:
    from upright.experiment import Drive, Slope, Turn

    pushes = [options.push(text) for text in push]
    pushes += [options.programme(Slope, slope, "--slope")] if slope else []
    wanted = [(Drive, drive, "--drive"), (Turn, turn, "--turn")]
    return pushes, [options.programme(kind, text, option) for kind, text, option in wanted if text]


def _say(log: Log, label: str, written: Path | None, as_json: bool) -> None:
    from upright.comparison import compare
    from upright.experiment import outcome_of

    numbers = compare({label: log})
    outcome = outcome_of(log)
    if as_json:
        facts = {"outcome": outcome.to_json(), "origin": log.origin, "log": str(written) if written else None}
        print_json(facts | numbers.to_json())
        return
    typer.echo(f"{outcome}\n\n{numbers}")
    if written:
        typer.echo(f"\nwrote {written}")
