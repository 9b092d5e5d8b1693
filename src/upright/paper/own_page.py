"""The page of `upright reproduce --log`: a robot of one's own beside the paper's models, and what must be adjusted."""

from __future__ import annotations

import math

from upright.comparison.comparison_page import fit_verdict
from upright.comparison.drawing import state_words
from upright.comparison.runs import DIVERGED
from upright.experiment.described import facts_of
from upright.logs.raw import named
from upright.pages import Block, Cell, Column, Fold, Items, KeyNumber, Next, Page, Picture, Quantity, Say, Table
from upright.pages.blocks import MOST_NUMBERS
from upright.pages.terms import term
from upright.paper.claim import shown_of
from upright.paper.own_log import LINEAR, Adjustment, OwnRobot
from upright.paper.own_trial import NONLINEAR
from upright.paper.pushes import FIGURES_AGAIN


def own_page(result: OwnRobot) -> Page:
    """The page of a robot of one's own."""
    comparison = result.comparison
    log = comparison.logs[comparison.reference]
    picture, *tables = shown_of(comparison)
    assert isinstance(picture, Picture)
    blocks: list[Block] = [_adjusted(result)] if result.adjusted else []
    if result.notes:
        blocks.append(Items(result.notes))
    states = Picture(Say("Every state that moves"), comparison.plot)
    folds = [
        Fold(FIGURES_AGAIN[result.side], [states]),
        Fold(Say("Numbers of each run"), tables),
        Fold(Say("How this was done"), [Items(_method(result))]),
    ]
    why = Say("It learns the robot of this log.")
    return Page(
        Say("{robot} in the experiment of Herrera et al. (2015)", robot=result.robot.name),
        verdict=fit_verdict(state_words("pitch"), min(result.fits[NONLINEAR], result.fits[LINEAR])),
        lead=[Say("Law: {law}; {push}.", law=result.law, push=result.push), _answer(result)],
        numbers=_numbers(result), picture=picture, blocks=[*blocks, *folds],
        next=[Next("calibrate", named(log), robot=result.robot.name, output="robot.toml", why=why)],
        origin=facts_of(log.origin),
    )  # fmt: skip


def _answer(result: OwnRobot) -> Say:
    """What must be adjusted, in a sentence."""
    if not result.adjusted:
        return Say("Nothing that was tried brings the nonlinear model nearer to the robot.")
    last = result.adjusted[-1]
    names = [term(one.name) for one in result.adjusted]
    if math.isnan(result.settling[result.comparison.reference]):
        fit = Quantity(last.fit / 100, "fraction", digits=2)
        return Say("With its {names} put right, the nonlinear model fits the robot to {fit}.", names=names, fit=fit)
    return Say(
        "With its {names} put right, the nonlinear model settles in {time}.", names=names, time=_time(last.settling)
    )


def _time(seconds: float) -> Quantity | Say:
    return Say("no time (never)") if math.isnan(seconds) else Quantity(seconds, "s")


def _numbers(result: OwnRobot) -> list[KeyNumber]:
    """The settling times of the robot and its models; of a robot that swings on, the fits of pitch."""
    if result.settles:
        within = Quantity(result.band, "fraction", digits=2)
        numbers = [
            KeyNumber(_time(time), Say("{run}: settles to {within}", run=run, within=within))
            for run, time in result.settling.items()
        ]
    else:
        numbers = [
            KeyNumber(Quantity(fit / 100, "fraction", digits=2) if fit > DIVERGED else Say("diverges"),
                      Say("{run}: fit of pitch to the robot", run=run))
            for run, fit in result.fits.items() if run != result.comparison.reference
        ]  # fmt: skip
    return numbers[:MOST_NUMBERS]


def _adjusted(result: OwnRobot) -> Table:
    columns = [
        Column(Say("put right")), Column(Say("in the file")), Column(Say("learnt")), Column(Say("settles in")),
        Column(Say("fit of pitch"), "%"),
    ]  # fmt: skip
    caption = Say("Put right one on top of the other, what helps most first")
    return Table(columns, [_row(one) for one in result.adjusted], caption)


def _row(one: Adjustment) -> list[Cell]:
    number = one.number
    stated = number and Quantity(number.stated, number.unit)
    learnt = number and Quantity(number.value, number.unit, low=number.low, high=number.high)
    return [term(one.name), stated, learnt, _time(one.settling), one.fit]


def _method(result: OwnRobot) -> list[Say]:
    settled = Say("Settled: within {band} of the largest deviation from where pitch comes to rest.",
                  band=Quantity(result.band, "fraction", digits=2))  # fmt: skip
    if not result.settles:
        settled = Say("The robot swings at the end as much as after a push: no settling time is given.")
    return [
        Say("The models start from the first state of the log, with its push and its law, and get no reading."),
        Say("They have the numbers of the robot's file, ideal sensors and no dead time, like the paper's."),
        Say("The last run has what was learnt, if anything, and the robot's electronics."),
        settled,
    ]
