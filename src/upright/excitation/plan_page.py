"""The page of an excitation plan: which parameters it should measure, at what risk, and what to add to the commands."""

from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING

import numpy as np

from upright.calibration.estimate import BOUNDED, CLOSE, MEASURED, NOT_VISIBLE, headed, known_to
from upright.excitation.planned import VISIBLE, PlannedRun, Predicted
from upright.pages import Block, Column, Fold, Items, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.terms import term

if TYPE_CHECKING:
    from matplotlib.figure import Figure

KINDS = {
    MEASURED: Verdict(Say("measured"), "good"),
    BOUNDED: Verdict(Say("bounded"), "info"),
    NOT_VISIBLE: Verdict(Say("little better"), "unknown"),
}
WAYS = {
    "combination": Say("Sines, random steps, drives and turns"),
    "multisine": Say("Sines"),
    "random binary dither": Say("Random steps"),
    "drive and turn": Say("Drives and turns"),
}
NAMED = 4  # parameters that the first screen names


def plan_page(plan: PlannedRun) -> Page:
    """The page of a planned run."""
    own = _best_first(plan)
    measured = [p for p in own if p.kind == MEASURED]
    title = Say(
        "A run of {time} should measure {n} of {all} parameters of {robot}",
        time=Quantity(plan.seconds, "s"), n=len(measured), all=len(own), robot=plan.robot,
    )  # fmt: skip
    law = plan.controller
    lead = [
        Say("{way} are added to the commands while {controller} balances the robot.",
            way=WAYS.get(plan.way) or Say("Signals"), controller=law)
    ]  # fmt: skip
    if len(measured) > NAMED:
        more = Say("{n} more", n=len(measured) - NAMED)
        lead.append(Say("To be measured: {names}.", names=[*(_name(p) for p in measured[:NAMED]), more]))
    elif measured:
        lead.append(Say("To be measured: {names}.", names=[_name(p) for p in measured]))
    halved = sum(p.kind != NOT_VISIBLE for p in own)
    claim = Say("The run should halve the uncertainty of {n} of {all} parameters, or better", n=halved, all=len(own))
    folds = [
        Fold(Say("Beside random steps"), [_dithers(plan)]),
        Fold(Say("Other ways of exciting"), [_tried(plan)]),
    ]
    return Page(
        title, verdict=_verdict(plan), lead=lead, numbers=_numbers(plan),
        picture=Picture(claim, functools.partial(uncertainty_left, plan)), next=_next(plan),
        blocks=[_parameters(own), _over_time(plan), *_notes(plan), *folds],
        origin={
            "robot": plan.robot, "kit": plan.kit, "controller": f"{plan.controller} {plan.hash[:12]}".strip(),
            "seed": str(plan.seed),
        },
    )  # fmt: skip


def _best_first(plan: PlannedRun) -> list[Predicted]:
    return sorted(plan.own, key=lambda p: (list(KINDS).index(p.kind), p.after / p.before))


def _verdict(plan: PlannedRun) -> Verdict:
    if plan.check():
        return Verdict(Say("breaks its limits"), "bad")
    meant = [p for p in plan.predicted if p.name in plan.focus] or plan.own
    if all(p.kind == NOT_VISIBLE for p in meant):
        return Verdict(Say("tells almost nothing"), "warn")
    return Verdict(Say("within all limits"), "good")


def _numbers(plan: PlannedRun) -> list[KeyNumber]:
    c, limits = plan.checked, plan.limits
    falls = Say(
        "fall (95 % confidence): {fell} of {n} did; allowed {limit}",
        fell=c.fell, n=c.samples, limit=Quantity(limits.falls, "fraction", digits=2),
    )  # fmt: skip
    travel = Say("how far 95 % of robots roll at most; allowed {limit}", limit=Quantity(limits.travel, "m", digits=2))
    return [
        KeyNumber(Quantity(None, "fraction", high=c.bound, digits=2), falls),
        KeyNumber(Quantity(c.travel, "m", digits=2), travel),
        KeyNumber(Quantity(c.peak, "rad", digits=2), Say("how far 95 % of the robots lean at most")),
    ]


def _next(plan: PlannedRun) -> list[Next]:
    if not plan.saved:
        why = Say("It saves the plan, which your robot, or `upright simulate`, adds to the commands.")
        return [Next("excite", robot=plan.robot, output="plan.json", why=why)]
    why = Say("So it runs on a simulated robot; on yours, add its rows to the commands. Then calibrate from the log.")
    return [
        Next("simulate", robot=plan.robot, controller=plan.controller, excite=plan.saved, output="run.csv", why=why)
    ]


def _parameters(own: list[Predicted]) -> Table:
    """The parameters of the robot, with half of each interval in per cent of the value."""
    rows = [
        [
            headed(p.name, p.unit),
            KINDS[p.kind].text if p.kind == NOT_VISIBLE else KINDS[p.kind],
            _known(p, p.after),
            _known(p, p.before),
            Quantity(p.value, "1"),
        ]
        for p in own
    ]
    columns = [
        Column(Say("parameter")), Column(Say("this run")), Column(Say("known after")), Column(Say("known before")),
        Column(Say("value")),
    ]  # fmt: skip
    caption = Say("Measured: to {close} or better; bounded: at least halved", close=Quantity(CLOSE, "fraction"))
    return Table(columns, rows, caption)


def _known(p: Predicted, width: float) -> Say:
    """What is known of a number by an interval of this width; no number of a robot is below zero."""
    return known_to(p.value, max(p.value - width / 2, 0.0), p.value + width / 2)


def _name(p: Predicted) -> Say:
    return term(p.name)


def uncertainty_left(plan: PlannedRun) -> Figure:
    """Widths of the intervals over those before, a bar for each parameter of the robot."""
    from upright.pages.drawing import PAPER
    from upright.plotting import AXIS, COLOURS, INK, SMALL, legend, rows_of

    own = _best_first(plan)
    figure, ax = rows_of([str(_name(p)) for p in own], str(Say("uncertainty left after the run [%]")), "")
    rows = np.arange(len(own))
    left = np.array([100 * p.after / p.before for p in own])
    for kind, colour in zip(KINDS, (COLOURS[2], COLOURS[0], INK), strict=True):
        kept = np.array([p.kind == kind for p in own])
        if kept.any():
            ax.barh(rows[kept], left[kept], height=0.6, color=colour, label=str(KINDS[kind].text))
    for row, p in enumerate(own):
        if p.kind == MEASURED:
            change = Say("{before} → {after}", before=_known(p, p.before), after=_known(p, p.after))
            ax.annotate(str(change), (left[row], row), (4, 0), textcoords="offset points", va="center", fontsize=SMALL,
                        bbox={"facecolor": PAPER, "edgecolor": "none", "pad": 0.5})  # fmt: skip
    ax.axvline(100 * VISIBLE, linestyle="--", linewidth=1, color=AXIS, zorder=0)
    ax.annotate(str(Say("half")), (100 * VISIBLE, -0.6), (3, -3), textcoords="offset points", fontsize=SMALL)
    ax.set(xlim=(0, 103), xticks=range(0, 101, 25))
    return legend(figure)


def _notes(plan: PlannedRun) -> list[Block]:
    notes = list(plan.notes)
    if plan.checked.dropped:
        notes.append(
            Say("Left out, since they fall without an excitation: {n} of the robots drawn.", n=plan.checked.dropped)
        )
    return [Items(notes)] if notes else []


def _over_time(plan: PlannedRun) -> Picture:
    note = Say("The mean of both motors drives the robot, half of their difference turns it.")
    most = Quantity(float(np.abs(plan.excitation).max()), plan.unit, digits=2)
    return Picture(
        Say("At most {most} is added to a command", most=most), functools.partial(_draw_over_time, plan), note
    )


def _draw_over_time(plan: PlannedRun) -> Figure:
    from upright.plotting import line, panels

    t = np.arange(len(plan.excitation)) * plan.hold * plan.period
    left, right = plan.excitation.T
    labels = [Say("driving [{unit}]", unit=plan.unit), Say("turning [{unit}]", unit=plan.unit)]
    figure, axes = panels([*map(str, labels)])
    for style, (ax, wave) in enumerate(zip(axes, ((left + right) / 2, (right - left) / 2), strict=True)):
        line(ax, "_wave", t, wave, step=True, solid=True, style=style)
    return figure


def _energy(plan: PlannedRun, energy: float) -> Quantity:
    return Quantity(energy, f"({plan.unit})² s" if " " in plan.unit else f"{plan.unit}² s")


def _dithers(plan: PlannedRun) -> Table:
    """Half widths, those first of which the plan tells most beside a dither."""
    rows = [
        [_name(p), *(Quantity(width / 2, p.unit, digits=2) for width in (p.after, p.dither, p.held, p.least))]
        for p in sorted(plan.predicted, key=lambda p: p.after / p.dither)
    ]
    columns = [
        Column(Say("parameter")), Column(Say("this run")), Column(Say("steps each period")),
        Column(Say("steps of {time}", time=Quantity(0.04, "s"))), Column(Say("100 such runs")),
    ]  # fmt: skip
    return Table(columns, rows, Say("Half of each 95 % interval; random steps of the same energy"))


def _tried(plan: PlannedRun) -> Table:
    known = [(WAYS[t.name], t.energy, t.shrinks) for t in plan.tried]
    ways = [*known, (Say("this plan"), plan.energy, plan.shrinks)]
    rows = [
        [way, _energy(plan, energy), Quantity(left, "fraction")]
        for way, energy, left in sorted(ways, key=lambda way: math.inf if math.isnan(way[2]) else way[2])
    ]
    columns = [Column(Say("excitation")), Column(Say("energy at the motors")), Column(Say("uncertainty left"))]
    return Table(columns, rows, Say("Each as large as the limits allow; the plan takes hardly less, with less energy"))
