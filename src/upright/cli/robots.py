"""`upright robots`: the robots that come with the package, every number of one, and one of one's own."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import ROBOT_HELP, JsonOption, complete_robot
from upright.cli.output import check_targets, print_json, print_table
from upright.cli.robots_new import new

if TYPE_CHECKING:
    from upright.robots import Robot

robots = typer.Typer(add_completion=False, rich_markup_mode=None)
robots.command()(new)


@robots.callback(invoke_without_command=True)
def every(context: typer.Context, *, as_json: JsonOption = False) -> None:
    """List the robots, `show` the parameters of one, or write a `new` one."""
    if context.invoked_subcommand is None:
        listing(as_json=as_json)


@robots.command("list")
def listing(*, as_json: JsonOption = False) -> None:
    """List the robots, as `upright robots` does."""
    from upright.robots import Robot, preset_names

    entries = [_summary(Robot.preset(name)) for name in preset_names()]
    if as_json:
        print_json(entries)
        return
    header = ("robot", "mass [kg]", "wheel radius [m]", "pole [1/s]", "drive", "kit")
    shown = ("name", "mass", "wheel_radius", "unstable_pole", "drive", "kit")
    print_table(
        header, [[f"{e[k]:.3g}" if isinstance(e[k], float) else e[k] for k in shown] for e in entries],
        numbers=header[1:4],
    )  # fmt: skip
    typer.echo("What each is: upright robots show NAME")


@robots.command()
def show(
    name: Annotated[str, typer.Argument(help=f"{ROBOT_HELP}.", autocompletion=complete_robot)],
    *,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the robot as a file (.toml), to be changed.")
    ] = None,
    as_json: JsonOption = False,
) -> None:
    """Print every parameter of a robot, with source and spread."""
    from upright.robots import find_robot

    robot = find_robot(name)
    if output:
        check_targets(output)
        robot.replace(name=output.stem).save(output)
    if as_json:
        print_json({**_summary(robot), "parameters": robot.parameters()})
    else:
        title = f"{robot.title}\n" if robot.title else ""
        typer.echo(f"{title}{robot.name}: {robot.drive} drive, kit {robot.kit_name}\n")
        table = robot.listing()
        print_table(table.header, table.rows, table.numbers)
        if output:
            typer.echo(f"wrote {output}: change its numbers, and use it as --robot {output}")


def _summary(robot: Robot) -> dict[str, Any]:
    from upright.physics.linear import unstable_pole

    return {
        "name": robot.name,
        "title": robot.title,
        "mass": robot.body_mass + 2 * robot.wheel_mass,
        "wheel_radius": robot.wheel_radius,
        "com_height": robot.com_height,
        "unstable_pole": unstable_pole(robot),
        "drive": robot.drive,
        "kit": robot.kit_name,
    }
