"""The page of a validation: which readings are predicted, where the closed loop leaves the log, what to doubt."""

from __future__ import annotations

import functools
from collections.abc import Sequence
from pathlib import Path

from upright.calibration.calibrated_robot import GOOD, PREDICTED
from upright.calibration.calibration_page import r2_of
from upright.pages import Block, Column, Fold, Items, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict
from upright.pages.terms import term
from upright.validation.drawn import half_second_figure, loop_figure, reading
from upright.validation.fits import DOES_NOT, JUDGED, PARTLY, PREDICTS, WORTH, ChannelFit, LogJudged, RobotJudged, least

VERDICTS = {
    PREDICTS: Verdict(Say("predicts the log"), "good"),
    JUDGED: Verdict(Say("predicts what could be judged"), "warn"),
    PARTLY: Verdict(Say("predicts the log in part"), "warn"),
    DOES_NOT: Verdict(Say("does not predict the log"), "bad"),
}


def validation_page(result: RobotJudged) -> Page:
    """The page of a robot judged on logs."""
    worst = result.worst
    used = any(log.fitted for log in result.logs)
    verdict = VERDICTS[result.verdict]
    if used and verdict.level == "good":
        verdict = Verdict(Say("no test: fitted to this log"), "warn")
    dead = sorted({name for log in result.logs for name in log.dead})
    lead = [_tested(result)]
    if not used or worst.worst.r2 < GOOD:
        lead.insert(0, _enough(result))
    blocks: list[Block] = [_half_seconds(result.logs)]
    if dead:
        never = Say("Not judged, since it never changes: {sensors}.", sensors=[reading(name) for name in dead])
        blocks.insert(0, Items([never]))
    logs = ", ".join(Path(log.source).name for log in result.logs)
    folds = [
        Fold(Say("The whole run in closed loop"), [block for log in result.logs for block in _whole_run(log)]),
        Fold(Say("Parameters to doubt"), [_shifts(result)]),
    ]
    if own := [_own_run(log) for log in result.logs if log.own_run]:
        folds.append(Fold(Say("Fitted to this run"), own))
    if notes := [note for log in result.logs for note in _notes(log)]:
        folds.append(Fold(Say("Notes"), [Items(notes)]))
    return Page(
        _title(result), verdict=verdict, lead=lead, numbers=_numbers(result), picture=_picture(worst),
        next=_next(result, used), blocks=[*blocks, *folds],
        origin={"robot": result.robot, "kit": result.kit, "logs": logs},
    )  # fmt: skip


def _title(result: RobotJudged) -> Say:
    """Which readings are predicted, and which are not."""
    facts = {"robot": result.robot, "log": Say("{n} logs", n=len(result.logs))}
    if len(result.logs) == 1:
        facts["log"] = Path(result.logs[0].source).name
    fits = [c for log in result.logs for c in log.half_seconds if c.name in PREDICTED]
    poor = {c.name for c in fits if c.r2 < GOOD}
    good = {c.name for c in fits} - poor
    if not poor:
        return Say("{robot} predicts {log}", **facts)
    if not good:
        return Say("{robot} does not predict {log}", **facts)
    missed = [reading(name) for name in sorted(poor)]
    return Say("{robot} predicts {log}, but not: {missed}", **facts, missed=missed)


def _enough(result: RobotJudged) -> Say:
    """Whether the worst reading is predicted well enough, and by which bar."""
    needed = Quantity(GOOD, "1")
    missed = [reading(c.name) for c in result.worst.half_seconds if c.name in PREDICTED and c.r2 < GOOD]
    if missed:
        return Say("Not enough to design with: over half a second R² is below {needed} for {missed}.", needed=needed,
                   missed=missed)  # fmt: skip
    return Say("Enough to design with: over half a second each judged R² is at least {needed}.", needed=needed)


def _tested(result: RobotJudged) -> Say:
    """Whether these logs test the robot: only what it was not fitted to does."""
    facts = {"robot": result.robot, "seconds": Quantity(sum(log.seconds for log in result.logs), "s")}
    if any(log.fitted is None for log in result.logs):
        return Say("These {seconds} are a test only if {robot} was not fitted to them: its file names no log.", **facts)
    used = [log for log in result.logs if log.fitted]
    if not used:
        return Say("A test: none of these {seconds} served to fit {robot}.", **facts)
    most = max(used, key=lambda log: log.fitted or 0.0)
    part = Quantity(most.fitted, "fraction", digits=2)
    return Say(
        "No test: {part} of the rows of {log} served to fit {robot}.",
        part=part, log=Path(most.source).name, robot=result.robot,
    )  # fmt: skip


def _numbers(result: RobotJudged) -> list[KeyNumber]:
    worst = result.worst.worst
    meaning = Say("R² of the worst prediction, {sensor}; a design needs at least {needed}", sensor=reading(worst.name),
                  needed=Quantity(GOOD, "1"))  # fmt: skip
    numbers = [KeyNumber(r2_of(worst.r2), meaning)]
    if own := result.worst.own_run:
        numbers.append(KeyNumber(r2_of(least(own).r2), Say("R² with friction, battery and delays fitted to this run")))
    if shift := result.doubted:
        meaning = Say("of the squared error goes if only this changes: {name}", name=term(shift.name))
        numbers.append(KeyNumber(Quantity(shift.explains, "fraction", digits=2), meaning))
    if lost := result.lost:
        meaning = Say("until the simulated closed loop leaves the log: {sensor}", sensor=reading(lost.name))
        if any(log.simulated and log.simulated.pushes for log in result.logs):
            meaning = Say("until the closed loop, simulated without pushes, leaves the log")
        numbers.append(KeyNumber(Quantity(lost.breaks, "s", digits=2), meaning))
    elif loop := result.worst.loop:
        numbers.append(
            KeyNumber(
                r2_of(least(loop).r2), Say("R² of the whole run in one piece; not judged, since small errors grow")
            )
        )
    if not result.doubted:
        meaning = Say("of the parameters, changed alone, removes {part} of the squared error",
                      part=Quantity(WORTH, "fraction"))  # fmt: skip
        numbers.append(KeyNumber(Say("none"), meaning))
    return numbers[:3]


def _picture(log: LogJudged) -> Picture:
    claim = Say("Half a second at a time, the prediction lies on the readings")
    if log.worst.r2 < GOOD:
        claim = Say("Half a second at a time, the prediction misses the {sensor}", sensor=reading(log.worst.name))
    note = Say("Each half second starts from a state fitted to it, and gets only the logged commands.")
    return Picture(claim, functools.partial(half_second_figure, log), note)


def _next(result: RobotJudged, used: bool) -> list[Next]:
    if used:
        return [Next("validate", result.robot, "LOG", why=Say("A log of another run is a test."))]
    if result.worst.worst.r2 < GOOD:
        return [
            Next("calibrate", result.worst.source, robot=result.robot, why=Say("It moves all parameters together."))
        ]
    why = Say("It designs a controller for these numbers.")
    return [Next("design", "lqg", robot=result.robot, output="lqg.json", why=why)]


def _half_seconds(logs: Sequence[LogJudged]) -> Table:
    rows = [
        [reading(c.name), r2_of(c.r2), _judged(c), c.breaks, Path(log.source).name]
        for log in logs
        for c in log.half_seconds
    ]
    needed = Say("at least {needed}", needed=Quantity(GOOD, "1"))
    columns = [Column(Say("sensor")), Column(Say("R², half seconds")), Column(needed),
               Column(Say("first missed at"), "s"), Column(Say("log"))]  # fmt: skip
    kept = 5 if len(logs) > 1 else 4
    return Table(columns[:kept], [row[:kept] for row in rows])


def _judged(c: ChannelFit) -> Verdict | Say:
    if c.name not in PREDICTED:
        return Say("not judged: iron nearby disturbs it")
    if c.r2 < GOOD:
        return Verdict(Say("no"), "bad")
    return Verdict(Say("yes"), "good")


def _whole_run(log: LogJudged) -> list[Block]:
    loop = log.simulated
    if not loop or not log.law:
        explained = Quantity(log.explained, "fraction", digits=2)
        return [
            Say("Not simulated: the controller is unknown. `--controller` names it."),
            Say("The best linear law of the readings explains {part} of the commands.", part=explained),
        ]
    remarks = [
        Say("Law: {law}.", law=log.law),
        Say("It starts from the first state and gets no reading and no push: small errors grow."),
    ]
    if log.estimates:
        remarks.append(Say("The program's filter is unknown, so this does not judge the robot: {estimates}.",
                        estimates=[reading(name) for name in log.estimates]))  # fmt: skip
    if loop.fell_at is not None:
        remarks.append(Say("The simulated robot falls at {time}.", time=Quantity(loop.fell_at, "s")))
    columns = [Column(Say("sensor")), Column(Say("R²")), Column(Say("lost after"), "s")]
    claim = Say("The closed loop, simulated from the first row of {log}", log=Path(log.source).name)
    return [
        Picture(claim, functools.partial(loop_figure, loop)),
        Table(columns, [[reading(c.name), r2_of(c.r2), c.breaks] for c in log.loop]),
        Items(remarks),
    ]


def _shifts(result: RobotJudged) -> Block:
    rows = [
        [term(s.name), Quantity(s.value, s.unit), Quantity(s.proposed, s.unit), s.deviations,
         Quantity(s.explains, "fraction", digits=2)]
        for log in result.logs for s in log.shifts
    ]  # fmt: skip
    if not rows:
        return Say("No parameter, changed alone, removes a tenth of the squared error.")
    columns = [Column(Say("parameter")), Column(Say("value")), Column(Say("fits better")),
               Column(Say("step [standard deviations]"), "1", digits=2), Column(Say("error removed"))]  # fmt: skip
    return Table(columns, rows, Say("Each parameter changed alone, all others as they are"))


def _own_run(log: LogJudged) -> Table:
    effects = [[term(e.name), Quantity(e.known, e.unit), Quantity(e.here, e.unit)] for e in log.effects]
    return Table([Column(Say("parameter")), Column(Say("known")), Column(Say("in this run"))], effects)


def _notes(log: LogJudged) -> list[Say]:
    notes = list(log.notes)
    if log.pushed == log.halves:
        notes.append(Say("Every half second was pushed, which no prediction knows."))
    elif log.pushed:
        notes.append(Say("{n} of {all} half seconds are left out, since the log records a push in them.",
                         n=log.pushed, all=log.halves))  # fmt: skip
    if log.dead:
        notes.append(Say("Look at plug and port of what never changes."))
    return notes
