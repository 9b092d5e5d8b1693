"""The log doctor: faults of a log, their size, and their repair.

Checks run in stages. Each stage reads the record as repaired by the stages before it: a delay is measured on radians,
not on degrees.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from upright.checkup import (
    columns,
    delays,
    estimates,
    motion,
    plausible,
    poses,
    rates,
    segments,
    sensors,
    speeds,
    swings,
    time,
    units,
    volts,
)
from upright.checkup.copies import copies
from upright.checkup.counts import distances
from upright.checkup.examined import LogExamined
from upright.checkup.finding import (
    CONTRADICTORY,
    FALLING,
    FEWEST,
    LEFT,
    PITCH,
    RIGHT,
    SEVERITIES,
    SPEED,
    Finding,
    Record,
    note,
    warning,
)
from upright.checkup.fixes import repaired
from upright.checkup.scale import against_robot
from upright.checkup.titles import place_of, title_of
from upright.checkup.wheels import passed_stop, record_of
from upright.checkup.wrapped import wrapped
from upright.errors import InvalidLog
from upright.logs.mapping import GUESS, Mapping, Source, channels_of, find_mapping, propose
from upright.logs.readers import RawTable, read_table, table_of
from upright.pages import Page, Result, Say, english
from upright.progress import Progress, unwatched
from upright.robots import Robot, find_robot
from upright.signals import Log

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Check = Callable[[Record], list[Finding]]


class Diagnosis(LogExamined, Result):
    """What was found on a log, for people, as data and as a picture, and the log with every repair applied."""

    def repaired(self) -> Log:
        """The log with every repair applied, in the order of the stages; raises `InvalidLog` if the result is no "
        "valid log."""
        in_order = sorted(self.findings, key=lambda finding: _STAGE_OF.get(finding.code, 0))
        record = _repaired(self._raw, in_order)
        repairs = [f"{f.code} {f.channel}: {english(f.repair)}" for f in self.findings if f.fixes and f.repair]
        return Log(record.t, record.channels, record.units, {**self._origin, "repaired": repairs})

    def plot(self) -> Figure | None:
        """Gyro, encoders and commands as they were read, with poses and a repair's cuts; None without any."""
        picture = self.page().picture
        return picture and picture.draw()

    def page(self) -> Page:
        """The diagnosis for people."""
        from upright.checkup.doctor_page import doctor_page

        return doctor_page(self)


def doctor(
    source: str | Path | RawTable | Log,
    robot: Robot | str | Path | None = None,
    *,
    mapping: Mapping | str | Path | None = None,
    progress: Progress = unwatched,
) -> Diagnosis:
    """Examine a log, a table or the file of any program: units, signs, sides, time, delays, saturation, bias, falls.

    `robot` and `mapping` may be names or files. A known robot sharpens the checks of units; without a mapping
    `logs.mapping.propose` chooses one. `progress` is called with the fraction done. Raises `InvalidLog` where the
    source is no log, `UnknownName` for an unknown name.
    """
    table = (
        table_of(source) if isinstance(source, Log) else source if isinstance(source, RawTable) else read_table(source)
    )
    chosen, assumed = (find_mapping(mapping), []) if mapping else proposed(table)
    known = find_robot(robot) if robot else None
    raw = _record(table, chosen)
    findings, last = _examine(raw, known, progress)
    if misnamed := columns.another_gyro(chosen, table, findings):
        findings, last = misnamed, replace(last, segments=())
    findings += assumed + rates.stated(table.decimation, findings) + rates.skipped(table.skipped)
    findings += time.paced(raw.t, table.origin) + speeds.against_angles(chosen, table) + volts.assumed(chosen, table)
    order = {severity: i for i, severity in enumerate(SEVERITIES)}
    ranked = tuple(sorted(findings, key=lambda finding: order[finding.severity]))
    origin = dict(table.origin) | ({"file": table.source, "mapping": chosen.name} if table.source else {})
    seconds = float(last.t[-1] - last.t[0])
    fell_at = tuple(passed_stop(last, segment) for segment in last.segments if segment.kind == FALLING)
    given = str(source) if isinstance(source, str | Path) else table.source
    return Diagnosis(
        source=given, mapping=chosen, findings=ranked, rows=len(raw.t), seconds=seconds, period=last.period,
        segments=last.segments, fell_at=fell_at, ignored=tuple(chosen.ignored(table)), _raw=raw, _origin=origin,
    )  # fmt: skip


def proposed(table: RawTable) -> tuple[Mapping, list[Finding]]:
    """The mapping by the columns' names, or where these do not say enough, by how the columns move, and what to tell of
    that."""
    by_name: set[tuple[str, Source]] = set()
    try:
        mapping = named = propose(table)
    except InvalidLog:
        mapping = columns.by_physics(table)
        if mapping is None or not mapping.time.column:  # nobody knows how fast rows without a clock follow each other
            raise
    else:
        if named.name != GUESS:
            return named, []
        by_name = set(named.channels.items())
        if lacking := columns.lacking(named):
            mapping = columns.by_physics(table, named) if columns.spare(named, table) else None
        if mapping is None or not mapping.time.column or columns.lacking(mapping):
            mapping = columns.with_gyro(named, table)
            text = Say("No column is recognised as {what}: what rests on them is not judged.", what=lacking)
            if not {LEFT, RIGHT} <= named.channels.keys():
                text = Say("No column is recognised as {what}: “balancing” means only near upright.", what=lacking)
            repair = Say("Name their columns in a mapping: `--write-mapping MINE.toml`.")
            missing = warning("columns/missing", named.time.column, text, repair)
            return mapping, [missing, *_unnamed(mapping, by_name)]
    mapping = columns.with_tilt(mapping, table)
    return mapping, _unnamed(mapping, by_name)


def _unnamed(mapping: Mapping, by_name: set[tuple[str, Source]]) -> list[Finding]:
    """The columns that were not taken by their names."""
    taken = {source.column: name for name, source in mapping.channels.items() if (name, source) not in by_name}
    text = Say("Taken for what they move like, since no name tells: {columns}.", columns=[*taken])
    check = Say("Check them, and keep them: `--write-mapping MINE.toml`.")
    return [note("columns/unnamed", mapping.time.column, text, check)] if taken else []


def _record(table: RawTable, mapping: Mapping) -> Record:
    t, channels, units = channels_of(mapping, table)
    measured = {name: values for name, values in channels.items() if not name.startswith("truth/")}
    record = Record(
        t, measured, units | {name: unit for name, unit in table.units.items() if name in measured},
        read={n: s.unit or SPEED * s.integrate for n, s in mapping.channels.items() if s.scale == 1},
        summed=frozenset(n for n, s in mapping.channels.items() if s.integrate),
    )  # fmt: skip
    if len(t) < FEWEST:
        raise InvalidLog(
            f"the log has {len(t)} row{'' if len(t) == 1 else 's'}", expected=f"at least {FEWEST} to judge a motion"
        )
    if not np.isfinite(t).sum() >= FEWEST:
        raise InvalidLog(
            f"the time, column '{mapping.time.column}', holds no numbers", likely="another column is the time"
        )
    if not np.ptp(t[np.isfinite(t)]) > 0:
        raise InvalidLog(
            f"the time, column '{mapping.time.column}', never changes",
            likely="another column is the time, or none is",
            hint="upright doctor LOG --write-mapping m.toml, and state its column there, or period = 0.01 (s a row)",
        )
    if not any(np.isfinite(x).any() for n, x in measured.items() if n.startswith("sensor/") or n == PITCH):
        read = ", ".join(dict.fromkeys(mapping.channels[n].column for n in measured if n in mapping.channels))
        raise InvalidLog(
            f"no sensor holds a number, in what is read: {read}", expected="wheel angles, a pitch rate or a tilt",
            hint="--write-mapping MINE.toml, and name their columns",
        )  # fmt: skip
    return record


def _stages(robot: Robot | None) -> list[list[Check]]:
    return [
        [time.order],
        [time.order],
        [time.unit],
        [time.jump],
        [wrapped, sensors.joined, copies],
        [sensors.dead, sensors.outliers, plausible.repeated, time.steps],
        [sensors.stuck, plausible.constants],
        [motion.kinds, sensors.unsigned],
        [motion.signs],
        [motion.sides, sensors.unequal, partial(distances, robot=robot)],
        [partial(units.scales, robot=robot)],
        [plausible.speeds],
        [partial(volts.commands, robot=robot)],
        [estimates.estimates, partial(against_robot, robot=robot)],
        [segments.zero],
        [swings.bias, sensors.saturation, sensors.grain, swings.quiet],
        [delays.delays],
        [
            sensors.contaminated,
            rates.faster_controller,
            segments.still,
            segments.slips,
            segments.fall,
            segments.aside,
            segments.short,
        ],
    ]


_UNREAD = ("units/counts", "command/unsigned", "columns/copied")
"""Of a channel that no check can read, since it lacks a unit or a sign, or is another one."""
_TIMED = 5  # the stage after which time and readings are whole, and the poses can be read

_STAGE_OF = {
    "time/missing": 0, "time/backwards": 1, "time/repeated": 1, "time/coarse": 1, "time/unit": 2,
    "time/jump": 3, "time/gap": 3,
    "encoder/wrapped": 4, "encoder/jump": 4, "samples/repeated": 5, "channel/holes": 5, "channel/outliers": 5,
    "motion/integrated": 8, "motion/differentiated": 8, "motion/flipped": 9, "motion/swapped": 10, "units/scale": 11,
    "units/command": 12, "delay/sensor": 13, "delay/command": 13, "gyro/bias": 13, "estimate/zero": 13,
    "time/dropped": 20, "time/jitter": 20, "segment/cut": 21,
}  # fmt: skip
"""Order of the repairs. Those that change the rows come last, so that the times in the others stay valid."""


def contradictions(log: Log, robot: Robot | None = None, codes: tuple[str, ...] = CONTRADICTORY) -> list[Say]:
    """What is wrong in a log of ours that a fit reads as it stands, of the findings with these `codes`. A
    unit that is doubtful for robots in general, and not for `robot`, is none; only with a robot can commands be judged
    of which no name says the unit."""
    record = record_of(log)
    every, last = _examine(record, None, unwatched)
    findings = [f for f in every if f.severity == "error"]
    if robot is not None and any(f.code.startswith("units/") for f in findings):
        own = {(f.code, f.channel) for f in _examine(record, robot, unwatched)[0]}
        findings = [f for f in findings if not f.code.startswith("units/") or (f.code, f.channel) in own]
    if robot is not None and last.unnamed:
        findings += [f for f in volts.commands(last, robot) if f.severity == "error"]
    return [
        Say(
            "The log contradicts itself ({what}, {where}). {evidence}",
            what=title_of(f),
            where=place_of(f),
            evidence=f.evidence,
        )
        for f in findings
        if f.code.startswith(codes)
    ]


def _examine(raw: Record, robot: Robot | None, progress: Progress) -> tuple[list[Finding], Record]:
    """All findings, and the record with its repairs and poses, before anything is cut from it.

    The poses are read again after every repair, since those before it are of a gyro that may be in another unit.
    """
    record, findings = raw, list[Finding]()
    commands = raw.commands or ()
    stages = _stages(robot)
    done, total = 0, sum(len(stage) for stage in stages)
    for stage in stages:
        fresh: list[Finding] = []
        for check in stage:
            fresh += [finding for finding in check(record) if not _known(finding, findings)]
            done += 1
            progress(done / total)
        if stage is not stages[-1]:
            record = _without_empty(_repaired(record, fresh), fresh)
            changed = any(finding.fixes or finding.code in _UNREAD for finding in fresh)
            if stage is stages[_TIMED] or (record.segments and changed):
                record = replace(record, segments=poses.segments(record))
        findings += fresh
    if sensors.idle(raw):  # which a pose tells; wheels and commands that stay as they are follow from it
        findings = [f for f in findings if f.code != "channel/constant" or f.channel not in (LEFT, RIGHT, *commands)]
    return findings, record


def _known(finding: Finding, findings: Sequence[Finding]) -> bool:
    return any((finding.code, finding.channel) == (old.code, old.channel) for old in findings)


def _repaired(record: Record, findings: Sequence[Finding]) -> Record:
    for fix in (fix for finding in findings for fix in finding.fixes):
        record = repaired(record, fix)
    return record


def _without_empty(record: Record, findings: Sequence[Finding]) -> Record:
    """Without the channels that hold no number, unknown counts or no sign, and the sensors that never change: no
    physics is read into these."""
    empty = {f.channel for f in findings if f.code in ("channel/empty", *_UNREAD)}
    still = ("channel/constant", "channel/stuck")
    empty |= {f.channel for f in findings if f.code in still and f.channel.startswith("sensor/")}
    return replace(record, channels={n: x for n, x in record.channels.items() if n not in empty})
