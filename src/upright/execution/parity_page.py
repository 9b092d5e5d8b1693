"""The page of a `Parity`: whether a program does what was designed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from upright.pages import Column, KeyNumber, Page, Picture, Quantity, Say, Table, Verdict
from upright.plotting import bars

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Parity = Any  # that of `parity.py`, which imports this file


def parity_page(parity: Parity) -> Page:
    """The page of a program's parity with its design."""
    where, numbers = parity.where, parity.numbers
    lead = [
        Say("Executed: {target} program for {robot}, on {where}, in {numbers}.", target=parity.target,
            robot=parity.robot, where=where, numbers=numbers)
    ]  # fmt: skip
    if not parity.as_generated:
        lead.append(Say("The file differs from what `upright firmware` generates here."))
    tolerance = Quantity(parity.tolerance, parity.unit)
    rows = [[push.push, Say("stood") if push.stood else push.outcome, push.peak] for push in parity.pushes]
    columns = [Column(Say("push")), Column(Say("outcome")), Column(Say("largest pitch"), "rad")]
    return Page(
        _title(parity),
        verdict=Verdict(Say("equal"), "good") if parity.passed else Verdict(Say("not equal"), "bad"),
        lead=lead,
        numbers=[
            KeyNumber(Quantity(parity.worst, parity.unit),
                      Say("largest difference of a command, {tolerance} allowed", tolerance=tolerance)),
            KeyNumber(Say("{steps} of {periods}", steps=parity.steps, periods=parity.periods), Say("periods compared")),
            KeyNumber(parity.duties, Say("duties that do not follow from their commands")),
        ],
        picture=Picture(Say("The commands' largest difference beside what is allowed"), parity.plot),
        blocks=[Table(columns, rows)], origin={"controller": parity.hash[:12]},
    )  # fmt: skip


def _title(parity: Parity) -> Say:
    if parity.passed:
        return Say("The program commands what was designed")
    if parity.worst > parity.tolerance:
        return Say("The program's commands differ from the design's")
    if parity.duties:
        return Say("The program sets duties that do not follow from its commands")
    return Say("The robot falls under the program")


def draw_difference(worst: float, tolerance: float, unit: str) -> Figure:
    """The largest difference, and what is allowed."""
    names = [str(Say("difference")), str(Say("tolerance"))]
    return bars(names, [worst, tolerance], f"{Say('command')} [{unit}]", "")
