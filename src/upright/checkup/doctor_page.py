"""The page of a diagnosis: whether the log is usable, what is wrong where, and what repairs it."""

from __future__ import annotations

import functools
import math
from pathlib import Path
from typing import TYPE_CHECKING

from upright.checkup import sensors
from upright.checkup.finding import (
    BALANCING,
    CONTRADICTORY,
    GYRO,
    LEFT,
    ON_WHEELS,
    RIGHT,
    STANDING,
    Finding,
    Segment,
    instant,
)
from upright.checkup.titles import CHANNELS, CHECKS, POSES, check_of, place_of, title_of
from upright.logs.mapping import GUESS, Source
from upright.pages import (
    MOST_NUMBERS,
    Block,
    Column,
    Fold,
    KeyNumber,
    Next,
    Page,
    Picture,
    Quantity,
    Say,
    Table,
    Verdict,
)
from upright.pages.words import shown_in
from upright.robots import offered

if TYPE_CHECKING:
    from collections.abc import Sequence

    from matplotlib.figure import Figure

    from upright.checkup.examined import LogExamined

SHOWN = 2  # titles of notes in one number
PUSHED, QUIET, FALL = "delay/untold", "motion/quiet", "segment/fall"
MAPPED = ("units/", "columns/", "command/", "time/unit")
"""How the codes begin of what a mapping states."""
KINDS = {
    "error": Verdict(Say("error"), "bad"), "warning": Verdict(Say("warning"), "warn"),
    "note": Verdict(Say("note"), "info"),
}  # fmt: skip


def doctor_page(result: LogExamined) -> Page:
    """The page of a diagnosis."""
    faults = result.faults
    name = Path(result.source).name or Say("in memory")
    title = Say("Log {name}: no fault found", name=name)
    if len(faults) == 1:
        title = Say("Log {name} has one fault: {what}, {where}", name=name, what=title_of(faults[0]),
                    where=place_of(faults[0]))  # fmt: skip
    elif faults:
        title = Say("Log {name} has {n} faults", name=name, n=len(faults))
    blocks: list[Block] = [_findings(result)] if result.findings else []
    guessed = result.mapping.name == GUESS or any(code.startswith("columns/") for code in result.codes())
    if guessed:
        blocks.append(_columns(result))
    blocks.append(Fold(Say("Evidence"), [_evidence(result)]))
    blocks.append(Fold(Say("Checks"), [_checks(result)]))
    if result.segments:
        blocks.append(Fold(Say("Poses"), [_poses(result)]))
    if not guessed and result.mapping.name != "ours":
        blocks.append(Fold(Say("Columns of the log"), [_columns(result)]))
    return Page(
        title, verdict=_verdict(result), lead=_lead(result), numbers=_numbers(result),
        picture=_picture(result), next=_next(result), blocks=blocks,
        origin={} if result.mapping.name == "ours" else {"columns read as": result.mapping.name},
    )  # fmt: skip


def _has(result: LogExamined, code: str) -> bool:
    return code in result.codes()


def _repairable(result: LogExamined) -> list[Finding]:
    """The faults that the fixes remove: their own, or the cut that leaves their time out."""
    away = result.cut_away()
    return [f for f in result.faults if f.fixes or f in away]


def _wrong(result: LogExamined) -> list[Finding]:
    """The faults to which a fit bends its numbers, and which no fix removes."""
    left = [f for f in result.faults if f not in _repairable(result)]
    codes = (*CONTRADICTORY, "columns/", "segment/none")
    return [f for f in left if f.severity == "error" or f.code.startswith(codes)]


def _verdict(result: LogExamined) -> Verdict:
    wrong = _wrong(result)
    if wrong and all(finding.code.startswith(MAPPED) for finding in wrong):
        return Verdict(Say("complete its mapping first"), "bad")
    if wrong:
        return Verdict(Say("not usable for a model"), "bad")
    if _repairable(result):
        grave = any(f.severity == "error" for f in result.faults)
        return Verdict(Say("repair it first"), "bad" if grave else "warn")
    if result.faults or _has(result, PUSHED):
        return Verdict(Say("usable with care"), "warn")
    if _has(result, QUIET):
        return Verdict(Say("sound, but too quiet for a model"), "warn")
    return Verdict(Say("usable as it is"), "good")


def _lead(result: LogExamined) -> list[Say]:
    lead: list[Say] = []
    balanced = _balanced(result)
    facts = {"balanced": Quantity(balanced, "s"), "seconds": Quantity(result.seconds, "s")}
    if balanced and result.fell_at:
        lead.append(Say("The robot balances for {balanced} and falls at {at}.", **facts, at=instant(result.fell_at[0])))
    elif balanced >= result.seconds:  # a part counts the period of its last row too
        lead.append(Say("The robot balances in the whole log, {seconds}.", **facts))
    elif result.segments:
        lead.append(Say("The robot balances for {balanced} of {seconds}.", **facts))
    n = len(_repairable(result))
    if n == len(result.faults) == 1:
        lead.append(Say("A repair removes the fault."))
    elif n:
        lead.append(Say("A repair removes {n} of {m} faults.", n=n, m=len(result.faults)))
    elif _has(result, PUSHED) and "push/force" in result.read:
        lead.append(Say("Pushes bend a model of it."))
    elif _has(result, PUSHED):
        lead.append(Say("Pushes that the log does not name bend a model of it."))
    return lead


def _balanced(result: LogExamined) -> float:
    """How long it balances [s], in the time that a repair keeps."""
    start, stop = result.kept or (-float("inf"), float("inf"))
    spans = ((max(s.start, start), min(s.stop, stop)) for s in result.segments if s.kind == BALANCING)
    return sum(max(0.0, b - a) for a, b in spans)


def _numbers(result: LogExamined) -> list[KeyNumber]:
    failed = {check_of(finding) for finding in result.faults}
    passed = Say("{n} of {m}", n=len(CHECKS) - len(failed), m=len(CHECKS))
    numbers = [KeyNumber(passed, Say("checks passed"))]
    if result.kept:
        kept = Quantity(result.kept[1] - result.kept[0], "s")
        numbers.append(KeyNumber(kept, Say("of {seconds} a repair keeps", seconds=Quantity(result.seconds, "s"))))
    period = Quantity(result.period, "s", digits=4)
    numbers.append(KeyNumber(period, Say("from row to row; rows: {n}", n=result.rows)))
    notes = [
        Say("{what} ({where})", what=title_of(f), where=place_of(f)) for f in _listed(result) if f.severity == "note"
    ]
    if notes and len(numbers) < MOST_NUMBERS:
        meaning = Say("found, but no fault: {what}", what=_shortened(notes))
        numbers.append(KeyNumber(len(notes), meaning))
    return numbers


def _shortened(titles: Sequence[Say]) -> list[Say | str]:
    several = [*dict.fromkeys(titles)]
    return [*several[:SHOWN], *(["…"] if len(several) > SHOWN else [])]


def _listed(result: LogExamined) -> list[Finding]:
    return [f for f in result.findings if f.code != "segment/cut"]  # what a repair keeps is a number above


def _findings(result: LogExamined) -> Table:
    rows = [[KINDS[f.severity], title_of(f), place_of(f), f.repair] for f in _listed(result)]
    names = (Say("severity"), Say("what"), Say("where"), Say("what to do"))
    caption = Say("An error makes the log wrong; a model must allow for a warning")
    return Table([Column(name) for name in names], rows, caption if result.faults else None)


def _evidence(result: LogExamined) -> Table:
    names = (Say("what"), Say("where"), Say("evidence"))
    rows = [[title_of(f), place_of(f), f.evidence] for f in result.findings]
    return Table([Column(name) for name in names], rows)


def _checks(result: LogExamined) -> Table:
    worst = {check_of(f): f.severity for f in reversed(result.findings)}  # the worst come first
    numbers = result.measured
    rows = [
        [
            title,
            KINDS[worst[name]] if name in worst else Verdict(Say("passed"), "good"),
            *((Quantity(n.value, n.unit), Quantity(n.limit, n.unit)) if (n := numbers.get(name)) else (None, None)),
        ]
        for name, (title, _) in CHECKS.items()
    ]
    names = (Say("check"), Say("result"), Say("measured"), Say("limit"))
    return Table([Column(name) for name in names], rows)


def _poses(result: LogExamined) -> Table:
    rows = [[POSES.get(s.kind, s.kind), s.start, s.stop, s.lean] for s in result.segments]
    columns = [
        Column(Say("pose")), Column(Say("from"), "s", digits=4), Column(Say("to"), "s", digits=4),
        Column(Say("lean"), "rad", digits=2),
    ]  # fmt: skip
    return Table(columns, rows)


def _columns(result: LogExamined) -> Table:
    """Which column was taken for which channel, and which for none."""
    mapping = result.mapping
    rows = [[CHANNELS["t"], *_source(mapping.time)]] if mapping.time.column else []
    rows += [[CHANNELS.get(name, name), *_source(source)] for name, source in mapping.channels.items()]
    rows += [[Say("not used"), column, None, None] for column in result.ignored]
    return Table([Column(name) for name in (Say("channel"), Say("column"), Say("unit"), Say("sign"))], rows)


def _source(source: Source) -> list[str | None]:
    return [source.column, source.unit or None, source.direction or ("−" if source.sign < 0 else None)]


def _next(result: LogExamined) -> list[Next]:
    """The repair; why it fell; then a calibration, or what to log for one."""
    log, robot = result.source or "LOG", offered(result.robot)
    fell = _has(result, FALL)
    wrong = _wrong(result)
    if result.saved:
        return [Next("doctor", result.saved, why=Say("It examines the repaired log."))]
    if any(finding.code.startswith(MAPPED) for finding in wrong):
        if result.mapped:
            return [Next("doctor", log, mapping=result.mapped, why=Say("Complete that file first, as the table says."))]
        why = Say("State there what the table asks for, then repeat with `--mapping`.")
        return [Next("doctor", log, write_mapping="mine.toml", why=why)]
    if wrong and (not fell or any(finding.severity == "error" for finding in wrong)):
        return [Next("doctor", "LOG", why=Say("Do what the table says, take a new log, and examine that."))]
    steps: list[Next] = []
    if any(f.fixes for f in result.findings):
        steps.append(Next("doctor", log, fix="repaired.csv", why=Say("It writes the repaired log.")))
    if fell:
        steps.append(Next("post_mortem", log, robot=robot, why=Say("It finds why the robot fell.")))
    elif _by_speed(result):
        why = Say("Nothing is learnt yet from a log of a speed drive: a model simulates it.")
        steps.append(Next("simulate", robot=robot, why=why))
    elif _has(result, QUIET) or _has(result, PUSHED):
        steps.append(Next("excite", robot=robot, output="plan.json", why=Say("It designs the signal to log next.")))
    learns = Say("It estimates the numbers of this robot from the log.")
    if result.robot:
        learns = Say("It estimates the numbers of {robot}, which the log names.", robot=robot)
    return steps or [Next("calibrate", log, robot=robot, output="robot.toml", why=learns)]


def _by_speed(result: LogExamined) -> bool:
    """Whether the log is of a speed drive, from whose logs nothing is learnt yet."""
    record = result.read
    return bool(record.commands) and record.units.get(record.commands[0]) == "rad/s"


def _picture(result: LogExamined) -> Picture | None:
    record = result.read
    groups = (
        (CHANNELS[GYRO], (GYRO,)),
        (Say("encoders"), (LEFT, RIGHT)),
        (Say("commands"), record.commands or ()),
    )
    several = [(title, [n for n in names if n in record]) for title, names in groups]
    several = [(title, names) for title, names in several if names]
    if not several:
        return None
    claim = Say("The readings of the log")
    if any(segment.kind != BALANCING for segment in result.segments):
        claim = Say("The readings of the log, shaded where the robot does not balance")
    note = Say("Dots: values at the limit.") if _has(result, "saturation") else None
    return Picture(claim, functools.partial(_draw, result, several), note)


def _draw(result: LogExamined, several: Sequence[tuple[Say, Sequence[str]]]) -> Figure:
    """Channels as they were read, with poses and a repair's cuts."""
    from upright.plotting import COLOURS, INK, SPAN, legend, line, panels, span

    record = result.read
    sides = {"left": (0, str(Say("left"))), "right": (1, str(Say("right")))}
    limited = {f.channel for f in result.findings if f.code == "saturation"}
    shown = [shown_in(record.units.get(names[0], "1"), math.inf) for _, names in several]
    figure, axes = panels([f"{title} [{unit or 1}]" for (title, _), (_, unit) in zip(several, shown, strict=True)])
    for ax, (title, names), (factor, _) in zip(axes, several, shown, strict=True):
        for name in names:
            colour, side = sides.get(name.replace("_", "/").rpartition("/")[2], (4, str(title)))
            step = name in (record.commands or ())
            line(ax, side, record.t, factor * record[name], step=step, style=colour, solid=True)
        if limited & {*names}:
            at = sensors.limited(record, names)
            for name, rows in zip(names, at, strict=True):
                ax.plot(
                    record.t[rows], factor * record[name][rows], "o", color=COLOURS[3], markersize=2.5, label="_limit"
                )
    off = dict.fromkeys(str(POSES.get(s.kind, s.kind)) for s in result.segments if s.kind not in ON_WHEELS)

    def shade(segment: Segment, name: str, colour: str) -> None:
        span(axes[:1], segment.start, segment.stop, name, colour)
        span(axes[1:], segment.start, segment.stop, "_named above", colour)

    for segment in result.segments:
        if segment.kind == STANDING:
            shade(segment, str(POSES[STANDING]), COLOURS[0])
        elif segment.kind != BALANCING:
            shade(segment, ", ".join(off), SPAN)
    for at in result.kept or ():
        for row, ax in enumerate(axes if record.t[0] < at < record.t[-1] else ()):
            name = "_named above" if row else str(Say("cut"))
            ax.axvline(at, linestyle="--", linewidth=1.2, color=INK, label=name)
    return legend(figure)
