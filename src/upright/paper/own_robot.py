"""What comes of `upright reproduce --log`: one's own robot beside the paper's models, and what must be adjusted."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from upright.atomic import finite
from upright.comparison import Comparison
from upright.comparison.comparison_page import fit_verdict
from upright.comparison.drawing import state_words
from upright.comparison.runs import DIVERGED
from upright.experiment.described import facts_of
from upright.languages import ENGLISH, speaking
from upright.logs.raw import named
from upright.pages import (
    Block,
    Cell,
    Column,
    Fold,
    Items,
    KeyNumber,
    Next,
    Page,
    Picture,
    Quantity,
    Result,
    Say,
    Table,
    Verdict,
)  # fmt: skip
from upright.pages.blocks import MOST_NUMBERS
from upright.pages.terms import term
from upright.paper.claim import shown_of
from upright.paper.own_trial import CALIBRATED, LINEAR, NONLINEAR, WIDEST
from upright.paper.pushes import FIGURES_AGAIN
from upright.robots import Robot


class LearntNumber(NamedTuple):
    """A number of the robot's file that was learnt: stated and learnt, its 95 % interval, and by how many deviations of
    the file it moved."""

    name: str
    unit: str
    stated: float
    value: float
    low: float
    high: float
    moved: float


@dataclass(frozen=True, kw_only=True)
class Adjustment:
    """What is put right in the model, on top of those before it: a `number` of the robot's file, or its electronics
    where that is None. Pitch then settles in `settling` [s], and fits the log round the push by `fit` [%]."""

    number: LearntNumber | None
    settling: float
    fit: float

    @property
    def name(self) -> str:
        """What is put right."""
        return self.number.name if self.number else "electronics"

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        number = self.number._asdict() if self.number else {}
        return {"name": self.name} | number | {"settling": finite(self.settling), "fit": finite(self.fit)}


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class OwnRobot(Result):
    """A robot's log compared with its models: `law` and `push` in words; what is `adjusted`, in the order in which it
    counts; `notes` say what could not be done. `settling` [s] of each run is the time until pitch stays within `band`
    (fraction) of its largest deviation from where it comes to rest: 5 %, or what the resting robot swings, if more."""

    robot: Robot
    comparison: Comparison
    law: Say
    push: Say
    side: str
    band: float
    settling: Mapping[str, float]
    fits: Mapping[str, float]
    adjusted: tuple[Adjustment, ...]
    notes: tuple[Say, ...]

    @property
    def settles(self) -> bool:
        """Whether the robot comes to rest, so that settling times say something."""
        return self.band <= WIDEST

    def page(self) -> Page:
        """The robot beside its models, for people."""
        return _page(self)

    def to_json(self) -> dict[str, Any]:
        """Plain numbers."""
        with speaking(ENGLISH):
            return {
                "schema": "upright/reproduce-log/1",
                "robot": self.robot.name,
                "law": str(self.law),
                "push": str(self.push),
                "side": self.side,
                "band": self.band,
                "settling": {name: finite(value) for name, value in self.settling.items()},
                "fits": {name: finite(value) for name, value in self.fits.items()},
                "comparison": self.comparison.to_json(),
                "adjusted": [one.to_json() for one in self.adjusted],
                "notes": [str(note) for note in self.notes],
            }


def _page(result: OwnRobot) -> Page:
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
    verdict = fit_verdict(state_words("pitch"), min(result.fits[NONLINEAR], result.fits[LINEAR]))
    numbers = _numbers(result)
    answer = [_answer(result)]
    if not comparison.pushed:  # the models lack what moved the robot: their settling and their fit say nothing
        verdict = Verdict(Say("push unknown"), "unknown")
        numbers = []
        answer = []
    return Page(
        _title(result),
        verdict=verdict,
        lead=[Say("Law: {law}; {push}.", law=result.law, push=result.push), *answer],
        numbers=numbers,
        picture=picture,
        blocks=[*blocks, *folds],
        next=[_next(result, named(log))],
        origin=facts_of(log.origin),
    )


def _title(result: OwnRobot) -> Say:
    """When the robot settles, and its model, where both do."""
    robot = result.robot.name
    times = [result.settling[run] for run in (result.comparison.reference, NONLINEAR)]
    if not result.comparison.pushed:
        return Say("{robot}: the log does not say what pushed it", robot=robot)
    if any(map(math.isnan, times)):
        return Say("{robot} beside the models of Herrera et al. (2015)", robot=robot)
    one, other = (Quantity(time, "s") for time in times)
    return Say("{robot} settles in {one}, its nonlinear model in {other}", robot=robot, one=one, other=other)


def _next(result: OwnRobot, log: str) -> Next:
    """To say the push, or to learn the robot: from this log, or from one that can tell."""
    robot = result.robot.name
    if not result.comparison.pushed:
        why = Say("Say when your robot was pushed, and how hard.")
        return Next("reproduce", log=log, robot=robot, push="impulse:SIZE,start=TIME", why=why)
    if CALIBRATED in result.comparison.logs:
        why = Say("It learns the robot of this log.")
        return Next("calibrate", log, robot=robot, output="robot.toml", why=why)
    return Next("excite", robot=robot, why=Say("It plans a log from which the robot can be learnt."))


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
            KeyNumber(
                Quantity(fit / 100, "fraction", digits=2) if fit > DIVERGED else Say("diverges"),
                Say("{run}: fit of pitch to the robot", run=run),
            )
            for run, fit in result.fits.items()
            if run != result.comparison.reference
        ]
    return numbers[:MOST_NUMBERS]


def _adjusted(result: OwnRobot) -> Table:
    columns = [
        Column(Say("put right")),
        Column(Say("in the file")),
        Column(Say("learnt")),
        Column(Say("settles in")),
        Column(Say("fit of pitch"), "%"),
    ]
    caption = Say("Put right one on top of the other, what helps most first")
    return Table(columns, [_row(one) for one in result.adjusted], caption)


def _row(one: Adjustment) -> list[Cell]:
    number = one.number
    stated = number and Quantity(number.stated, number.unit)
    learnt = number and Quantity(number.value, number.unit, low=number.low, high=number.high)
    return [term(one.name), stated, learnt, _time(one.settling), one.fit]


def _method(result: OwnRobot) -> list[Say]:
    settled = Say(
        "Settled: within {band} of the largest deviation from where pitch comes to rest.",
        band=Quantity(result.band, "fraction", digits=2),
    )
    if not result.settles:
        settled = Say("The robot swings at the end as much as after a push: no settling time is given.")
    return [
        Say("The models start from the first state of the log, with its push and its law, and get no reading."),
        Say("They have the numbers of the robot's file, ideal sensors and no dead time, like the paper's."),
        Say("The last run has what was learnt, if anything, and the robot's electronics."),
        settled,
    ]
