"""`upright robots`: the robots that come with the package, every number of one, and one of one's own."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.options import ROBOT_HELP, JsonOption, ReportOption, complete_robot
from upright.cli.output import check_targets, finish, print_json, print_page
from upright.cli.robots_new import new

if TYPE_CHECKING:
    from upright.pages import Page
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
    else:
        print_page(_page(entries))


def _page(entries: list[dict[str, Any]]) -> Page:
    from upright.pages import Column, Next, Page, Say, Table
    from upright.robots.robot_page import COMMANDS

    columns = [
        Column(Say("robot")), Column(Say("mass"), "kg"), Column(Say("wheels"), "m"),
        Column(Say("pole"), "1/s"), Column(Say("drive")), Column(Say("kit")),
    ]  # fmt: skip
    shown = ("name", "mass", "wheel_radius", "unstable_pole")
    rows = [[*(entry[name] for name in shown), COMMANDS[entry["drive"]], entry["kit"]] for entry in entries]
    return Page(
        Say("{n} robots come with upright", n=len(rows)), next=[Next("robots", "show", entries[0]["name"])],
        blocks=[Table(columns, rows)],
    )  # fmt: skip


@robots.command()
def show(
    name: Annotated[str, typer.Argument(help=f"{ROBOT_HELP}.", autocompletion=complete_robot)],
    *,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Write the robot as a file (.toml), to be changed.")
    ] = None,
    report: ReportOption = None,
    as_json: JsonOption = False,
) -> None:
    """Print every parameter of a robot, with source and spread."""
    from upright.pages import Say
    from upright.physics.linear import unstable_pole
    from upright.robots import find_robot

    robot = find_robot(name)
    check_targets(output, report)
    if output:
        robot.replace(name=output.stem).save(output)
    finish(robot, as_json, page=report, unstable_pole=unstable_pole(robot))
    if output and not as_json:
        typer.echo(str(Say("wrote {file}: change its numbers, and use it as --robot {file}", file=str(output))))


def _summary(robot: Robot) -> dict[str, Any]:
    from upright.physics.linear import unstable_pole

    facts = robot.to_json()
    del facts["parameters"]
    return facts | {"unstable_pole": unstable_pole(robot)}
