"""The page of a `Validation`: measured against predicted, and what would have to move."""

from __future__ import annotations

from collections.abc import Sequence

from upright.report.figure import Figure
from upright.report.page import Cell, Item, Page, Section, Table, Verdict, cell_text
from upright.validate.validation import (
    DOES_NOT,
    GOOD,
    JUDGED,
    PREDICTS,
    ChannelFit,
    LogJudged,
    Validation,
    half_second_figure,
    least,
    loop_figure,
    short,
)

_HALF = (
    "Each half second starts from a state that is fitted to it, and gets only the logged commands. R² counts what the "
    "prediction misses against what the reading varies. Fit is 100 (1 − rms error / standard deviation)."
)
_OWN = (
    "Friction, winding, supply, floor and dead times differ from run to run of one robot. Here they are fitted to this "
    "log, about what is known, with the spreads that runs usually have. The robot's other numbers stay."
)
_LOOP = (
    "The closed loop starts from the first state of the log. It gets the law, what was added to it, and no reading. "
    "A push that the log does not hold makes it leave the log at that time, whatever the robot."
)
_SHIFTS = (
    "Each parameter is moved alone by one Gauss–Newton step. Listed are those after which half seconds are predicted "
    "better by a tenth of what they leave. Steps are in standard deviations of what is known."
)


def page_of(result: Validation) -> Page:
    """The validation's page, not yet written."""
    worst = result.worst
    level = {PREDICTS: "good", DOES_NOT: "bad"}.get(result.verdict, "warn")
    verdict = Verdict(f"{result.verdict} the log" if result.verdict != JUDGED else result.verdict, level)
    sections = [section for log in result.logs for section in _sections(log, len(result.logs) > 1)]
    of = " of" if result.verdict == JUDGED else ""
    logs = result.logs[0].source or "the log" if len(result.logs) == 1 else f"{len(result.logs)} logs"
    title = (
        f"{result.robot} {result.verdict}{of} {logs}: R² of gyro and encoders at least {cell_text(worst.worst.r2, 3)}"
    )
    lowest = "Half a second at a time: measured, and predicted from the commands alone"
    lead = _lead(result) if result.verdict == PREDICTS else f"{result.sentence}. {_lead(result)}"
    return Page(
        title, sections, lead, {"kit": result.kit, "logs": ", ".join(x.source for x in result.logs)},
        False, verdict=verdict, picture=Figure(lowest, half_second_figure(worst)), numbers=_numbers(result),
    )  # fmt: skip


def _lead(result: Validation) -> str:
    """What was done, what passes, and what to run next."""
    seconds = sum(log.seconds for log in result.logs)
    then = "`upright design` a controller" if result.worst.worst.r2 >= GOOD else "`upright calibrate` with this log"
    compass = any(c.name.endswith("compass") for log in result.logs for c in log.half_seconds)
    aside = " The compass is shown, not judged: it also turns with iron and motors nearby." if compass else ""
    return (
        f"{seconds:.3g} s of log, which the robot's file has not used, against the model of {result.robot}. "
        f"A sensor passes from R² {GOOD:g} up.{aside} Next: {then}."
    )


def _numbers(result: Validation) -> list[tuple[str, str]]:
    worst = result.worst.worst
    numbers = [(cell_text(worst.r2, 3), f"smallest R² of half seconds ({short(worst.name)}); passes from {GOOD:g}")]
    if own := result.worst.own_run:
        numbers.append((cell_text(least(own).r2, 3), "with what belongs to its run, fitted to this log"))
    loops = [c for log in result.logs if not log.caution for c in log.loop]
    if loops:
        lowest = min(loops, key=lambda c: c.r2)
        if lowest.r2 < 0 and lowest.breaks is not None:
            followed = "of the whole run are followed from its first row alone; an unknown push ends that"
            numbers.append((f"{lowest.breaks:.3g} s", followed))
        else:
            whole = f"R² of the whole run from its first row alone ({short(lowest.name)})"
            numbers.append((cell_text(lowest.r2, 3), whole))
    shifts = [s for log in result.logs for s in log.shifts]
    if shifts:
        first = max(shifts, key=lambda s: s.explains)
        numbers.append((f"{first.name.replace('_', ' ')}", "is the parameter to doubt first"))
    return numbers


def _sections(log: LogJudged, several: bool) -> list[Section]:
    """What the page says of one log."""
    name = f" of {log.source}" if several else ""
    loop: list[Item] = [_LOOP, f"Law {log.law.removeprefix('law')}".replace("  ", " ")]
    loop += [log.caution] if log.caution else []
    if log.simulated is not None:
        loop += [
            _table(log.loop),
            Figure("Measured, and the whole run simulated from its first row", loop_figure(log.simulated)),
        ]
    rows: list[list[Cell]] = [
        [s.name.replace("_", " "), s.unit, s.value, s.proposed, s.deviations, s.explains] for s in log.shifts
    ]
    moves: list[Item] = [_SHIFTS, Table(["", "unit", "value", "proposed", "step", "removes"], rows, digits=3)]
    half: list[Item] = [*log.notes, _HALF, _table(log.half_seconds)]
    if log.own_run:
        effects: list[list[Cell]] = [[e.name.replace("_", " "), e.unit, e.known, e.here] for e in log.effects]
        half += [_OWN, _table(log.own_run), Table(["", "unit", "known", "this run"], effects, digits=3)]
    return [
        Section(f"Half a second at a time{name}", half),
        Section(f"The whole run from its first row{name}", loop),
        Section(f"Parameters to doubt{name}", moves if rows else ["No parameter alone."]),
    ]


def _table(channels: Sequence[ChannelFit]) -> Table:
    rows: list[list[Cell]] = [
        [short(c.name) + (" (not judged)" if c.name.endswith("compass") else ""), c.r2, c.fit, c.breaks]
        for c in channels
    ]
    return Table(["", "R²", "fit [%]", "breaks at [s]"], rows)
