"""`upright robots`: the robots that come with the package, and every number of one."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import JsonOption
from upright.cli.output import print_json, print_table

if TYPE_CHECKING:
    from upright.robots import Robot

robots = typer.Typer(rich_markup_mode=None)


@robots.callback(invoke_without_command=True)
def every(context: typer.Context, as_json: JsonOption = False) -> None:
    """List the robots; `robots show NAME` prints every number of one."""
    if context.invoked_subcommand is not None:
        return
    from upright.robots import Robot, preset_names

    entries = [_summary(Robot.preset(name)) for name in preset_names()]
    if as_json:
        print_json(entries)
        return
    header = ("robot", "mass [kg]", "com height [m]", "falls at [1/s]", "drive", "kit")
    rows = [
        (e["name"], f"{e['mass']:.3g}", f"{e['com_height']:.3g}", f"{e['unstable_pole']:.2f}", e["drive"], e["kit"])
        for e in entries
    ]
    print_table(header, rows, numbers=header[1:4])


@robots.command()
def show(
    name: Annotated[str, typer.Argument(help="A robot by name, or a TOML file.")], as_json: JsonOption = False
) -> None:
    """Print every parameter of one robot with unit, symbol, source and spread."""
    from upright.robots import find_robot

    robot = find_robot(name)
    entries = _parameters(robot)
    if as_json:
        print_json({**_summary(robot), "parameters": entries})
        return
    typer.echo(f"{robot.name}: {robot.drive} drive, kit {robot.kit}\n")
    header = ("parameter", "symbol", "value", "spread", "unit", "source")
    rows = [
        (e["name"], e["symbol"], f"{e['value']:.5g}", _spread(e["spread"]), e["unit"], e["source"]) for e in entries
    ]
    print_table(header, rows, numbers=("value", "spread"))


def _summary(robot: Robot) -> dict[str, Any]:
    from upright.physics.linear import unstable_pole

    return {
        "name": robot.name,
        "mass": robot.body_mass + 2 * robot.wheel_mass,
        "com_height": robot.com_height,
        "unstable_pole": unstable_pole(robot),
        "drive": robot.drive,
        "kit": robot.kit,
    }


def _parameters(robot: Robot) -> list[dict[str, Any]]:
    from upright.robots import PARAMETERS, Provenance

    unsaid = Provenance("not said")
    entries: list[dict[str, Any]] = []
    for name, (unit, symbol) in PARAMETERS.items():
        origin = robot.provenance.get(name, unsaid)
        value = getattr(robot, name)
        entries.append(
            {
                "name": name,
                "symbol": symbol,
                "value": value,
                "unit": unit,
                "source": origin.source,
                "spread": origin.spread,
            }
        )
    return entries


def _spread(spread: float | None) -> str:
    return "guess" if spread is None else f"± {spread:.2g}"
