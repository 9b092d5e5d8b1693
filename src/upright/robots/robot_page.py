"""The page of a `Robot`: its numbers as its file has them, how well each is known, and a drawing to scale."""

from __future__ import annotations

from typing import Any

from upright.languages import translated
from upright.pages import Column, KeyNumber, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.terms import term

Robot = Any  # that of `robot.py`, which imports this file

COMMANDS = {"voltage": Say("voltage"), "torque": Say("torque"), "speed": Say("speed of a wheel")}


def robot_page(robot: Robot) -> Page:
    """The page of a robot."""
    from upright.robots.drawing import labelled

    rows = robot.parameters()
    guesses = [row["source"] for row in rows if row["spread"] is None]
    absent = guesses.count("not stated")
    facts = {"n": len(guesses) - absent, "absent": absent}
    lead = [Say("{name}", name=translated(robot.title))] if robot.title else []
    lead.append(Say("Command of each motor: {what}. Kit: {kit}.", what=COMMANDS[robot.drive], kit=robot.kit_name))
    verdict = Verdict(Say("numbers guessed: {n}, not stated: {absent}", **facts), "unknown")
    if not guesses:
        verdict = Verdict(Say("no number is a guess"), "good")
    return Page(
        Say("The robot {name}", name=robot.name), verdict=verdict, lead=lead,
        numbers=[
            KeyNumber(Quantity(robot.mass, "kg"), Say("mass of body and wheels")),
            KeyNumber(Quantity(robot.com_height, "m"), Say("from the axle up to the centre of mass")),
            KeyNumber(Quantity(robot.wheel_radius, "m"), Say("wheel radius")),
        ],
        picture=Picture(Say("The robot to scale, with the symbols of its numbers"), lambda: labelled(robot)),
        blocks=[_values(rows), _sources(rows)],
    )  # fmt: skip


def _values(rows: list[dict[str, Any]]) -> Table:
    columns = [Column(Say("number")), Column(Say("value"), digits=4), Column(Say("unit")), Column(Say("spread")),
               Column(Say("meaning"))]  # fmt: skip
    cells = [[row["name"], row["value"], row["unit"], _spread(row), term(row["name"])] for row in rows]
    return Table(columns, cells)


def _spread(row: dict[str, Any]) -> Say:
    """One standard deviation, as part of the value where that is not zero."""
    if row["spread"] is None:
        return Say("guess")
    if not row["value"]:
        return Say("± {size}", size=Quantity(row["spread"], digits=2))
    return Say("± {size}", size=Quantity(row["spread"] / abs(row["value"]), "fraction", digits=2))


def _sources(rows: list[dict[str, Any]]) -> Table:
    columns = [Column(Say("number")), Column(Say("source"))]
    return Table(columns, [[row["name"], translated(row["source"])] for row in rows])
