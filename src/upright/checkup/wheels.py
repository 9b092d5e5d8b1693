"""The part of a log in which a robot is on its wheels, where alone the equations of motion hold."""

from __future__ import annotations

from typing import Any

import numpy as np

from upright.checkup.body import bodily
from upright.checkup.finding import FALLING, FEWEST, LEANING, ON_WHEELS, Record, Segment, during, in_a_line, instant
from upright.checkup.poses import NEAR_FLOOR, lean_of, segments
from upright.checkup.time import unit
from upright.checkup.titles import POSES
from upright.checkup.wrapped import wrapped
from upright.errors import InvalidLog
from upright.logs.outliers import in_words
from upright.logs.raw import RATES
from upright.logs.recording import commanded
from upright.pages import Say
from upright.robots.kit import STOP
from upright.signals import SIDES, Log

FITTED = (*ON_WHEELS, FALLING)
"""Poses that the equations describe: until it reaches the floor, a robot that falls rolls on its wheels."""


def record_of(log: Log) -> Record:
    """What the doctor's poses read; wheel angles are summed where only rates were logged, and a gyro that was made of a
    pitch estimate is left out."""
    steps = np.diff(log.t, prepend=log.t[0])
    derived: Any = log.origin.get("derived", {})
    measured = (name for name in log.channels if name not in derived and not name.startswith("truth/"))
    channels = {name: log[name] for name in measured}
    for angle, rate in RATES.items():
        if rate in log:
            channels[angle] = np.cumsum(np.nan_to_num(log[rate]) * steps)
    return Record(log.t, channels, log.units)


def passed_stop(record: Record, fall: Segment) -> float:
    """When [s] in this `fall` the lean passed `STOP`, at which every program stops its motors; where the log shows no
    lean as far, almost the furthest that it shows."""
    m = bodily(record)
    assert m is not None
    rows = (m.t >= fall.start) & (m.t < fall.stop)
    size = np.abs(lean_of(record, m).angle[rows])
    return float(m.t[rows][np.argmax(size > min(STOP, NEAR_FLOOR * float(size.max())))])


def on_its_wheels(log: Log, *, falling: bool = True) -> tuple[Log, Say | None]:
    """The longest time of a log in which the robot balances, stands or (`falling`) falls, and what is left out (None
    where nothing is). A log that shows no poses is taken whole, but for a start with the motors off. Raises
    `InvalidLog` for a robot that is never on its wheels, for times that are no seconds, and for angles that begin
    again.
    """
    record = record_of(log)
    kinds = FITTED if falling else ON_WHEELS
    for wrong in unit(record):
        slow = wrong.severity == "warning"
        raise InvalidLog(
            in_a_line(wrong), expected="rows every 10 to 50 ms" if slow else "times in seconds",
            hint="" if slow else "upright doctor LOG --fix NEW.csv, or a mapping",
        )  # fmt: skip
    for wrong in wrapped(record):
        raise InvalidLog(
            in_a_line(wrong),
            expected="angles that count on",
            hint="upright doctor LOG --fix NEW.csv",
        )
    poses = segments(record)
    others = [pose for pose in poses if pose.kind not in kinds]
    spans: list[tuple[float, float]] = []
    for pose in (pose for pose in poses if pose.kind in kinds):
        first = spans.pop()[0] if spans and spans[-1][1] == pose.start else pose.start
        spans.append((first, pose.stop))
    if others and not spans:
        raise InvalidLog(
            f"the robot is never on its wheels in this log: {'; '.join(map(_in_words, others[:3]))}",
            expected="a robot that balances", hint="upright doctor shows the poses",
        )  # fmt: skip
    used: Log = log
    note: Say | None = None
    if others:
        start, stop = max(spans, key=lambda span: span[1] - span[0])
        used = log.between(start, stop)
        left = [*dict.fromkeys(POSES[pose.kind] for pose in others)]
        note = Say(
            "Used: {start} to {stop}, where the robot is on its wheels. Left out: {poses}.",
            start=instant(start),
            stop=instant(stop),
            poses=left,
        )
    used, held = _without_held(used)
    for one in (held, in_words(used)):
        note = Say("{one} {other}", one=note, other=one) if note and one else note or one
    return used, note


HELD = 0.1
"""[s] with the motors off at the start of a log, from which a hand, or the floor, must hold the robot."""


def _without_held(log: Log) -> tuple[Log, Say | None]:
    """The log from the moment at which its motors are switched on, and what that leaves out: no equation
    knows of the hand that holds a robot until then. Whole where the motors are on, or always off, and in logs of ours,
    where zero at a motor is its dead zone."""
    prefix = commanded(log) if log.origin.get("mapping", "ours") != "ours" else ""
    on = np.flatnonzero(np.abs(np.column_stack([log[f"{prefix}/{s}"] for s in SIDES])).max(axis=1)) if prefix else []
    first = int(on[0]) if len(on) else 0
    if log.t[first] - log.t[0] < HELD or len(log) - first < FEWEST:
        return log, None
    until = float(log.t[first])
    held = Say("Until {time} the motors are off, so that something holds the robot: left out.", time=instant(until))
    return log.between(until, float(log.t[-1]) + log.period), held


def _in_words(pose: Segment) -> str:
    lean = f" at {pose.lean:+.2f} rad" if pose.kind in LEANING else ""
    return f"{pose.kind}{lean} {during(pose.start, pose.stop)}"
