"""`upright robots`: the robots that come with the package, every number of one, and one of one's own."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from upright.cli.command import spoken
from upright.cli.destination import Destination
from upright.cli.output import print_json, print_page
from upright.cli.robots_new import new

if TYPE_CHECKING:
    from upright.pages import Page
    from upright.robots import Robot

robots = typer.Typer(add_completion=False, rich_markup_mode=None)
robots.command("new")(new)


@robots.callback(invoke_without_command=True)
@spoken
def every(context: typer.Context, *, json: bool = False) -> None:
    """List the robots, `show` every number of one, or write a `new` one."""
    if context.invoked_subcommand is None:
        listing(json=json)


@robots.command("list")
@spoken
def listing(*, json: bool = False) -> None:
    """List the robots, as `upright robots` does."""
    from upright.robots import Robot, preset_names

    entries = [_summary(Robot.preset(name)) for name in preset_names()]
    if json:
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


@robots.command("show")
@spoken
def show(
    robot: str,
    *,
    output: Annotated[Path | None, "Write the robot as a file (.toml), to be changed."] = None,
    out: Destination,
) -> None:
    """Print every parameter of a robot, with source and spread."""
    from upright.pages import Say
    from upright.physics.linear import unstable_pole
    from upright.robots import find_robot

    chosen = find_robot(robot)
    out.check(output)
    if output:
        chosen.replace(name=output.stem).save(output)
    out.finish(chosen, unstable_pole=unstable_pole(chosen))
    if output and not out.json:
        typer.echo(str(Say("wrote {file}: change its numbers, and use it as --robot {file}", file=str(output))))


def _summary(robot: Robot) -> dict[str, Any]:
    from upright.physics.linear import unstable_pole

    facts = {name: value for name, value in robot.to_json().items() if name not in ("schema", "parameters")}
    return facts | {"unstable_pole": unstable_pole(robot)}
