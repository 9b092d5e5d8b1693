"""The page of a `Diagnosis`: the faults of a log, its readings, what a repair does, and every check."""

from __future__ import annotations

import math
import re
from dataclasses import replace

import numpy as np

from upright.doctor import delays, motion, segments, sensors, time, units
from upright.doctor.doctor import Diagnosis
from upright.doctor.finding import GYRO, LEFT, Finding, Record
from upright.doctor.physics import LEAST_ROWS
from upright.logs import outliers
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import joined, sentence

CHECKS = {
    "time stamps": ("time/",), "rows": ("samples/", "columns/"), "units": ("units/",),
    "signs and sides": ("motion/flipped", "motion/swapped"), "rates and angles": ("motion/int", "motion/diff"),
    "delays": ("delay/",), "gyro's bias": ("gyro/",), "readings": ("channel/", "estimate/", "encoder/wrapped"),
    "encoder's resolution": ("encoder/",), "motors at their limit": ("saturation",),
    "motion": ("motion/quiet", "segment/still", "segment/none"), "falls and slips": ("segment/",),
}  # fmt: skip
"""What is checked → how the codes of its findings begin; a code counts for the first that fits."""
FAULTS = {
    "rows": "rows that miss or repeat", "units": "a unit", "signs and sides": "a sign or side",
    "rates and angles": "a rate taken for an angle", "delays": "a delay", "gyro's bias": "bias of the gyro",
    "readings": "odd readings", "encoder's resolution": "coarse encoders", "motion": "too little motion",
    "falls and slips": "a fall or slip",
}  # fmt: skip
"""What is wrong where a check finds something, for the title."""
WORDS = {
    "delay/sensor": "a late sensor", "delay/command": "late commands", "segment/fall": "a fall",
    "segment/slip": "a slip",
    "samples/controller": "rows left out", "samples/repeated": "repeated rows",
}  # fmt: skip
"""The same for single codes, where that says more."""
NAMED = 4  # faults in the title
ALIKE = 0.9  # of the rows: commands of both motors that are equal there lie on each other


def page_of(result: Diagnosis) -> Page:
    """The page, not yet written."""
    faults = [f for f in result.findings if f.severity != "note"]
    rows: list[list[Cell]] = [
        [_KINDS[f.severity], _channel(f), sentence(_evidence(result, f)), _repair(f) or "nothing"]
        for f in result.findings
    ]
    columns: list[list[Cell]] = [[name, source.column] for name, source in result.mapping.channels.items()]
    renamed = any(name != column for name, column in columns)
    checks, values, limits = _checks(result), _values(result), _limits(result)
    checked_rows: list[list[Cell]] = [[*c, values.get(c[0], ""), limits[c[0]]] for c in checks]
    passed = sum(verdict.level in ("good", "info") for _, verdict in checks)
    return Page(
        _title(result, faults),
        [
            Section("Faults and remarks", [_LEVELS, Table(["", "channel", "evidence", "what to do"], rows)]),
            Section("Checks", [_FINDING_FROM, Table(["check", "result", "measured", "a finding from"], checked_rows)],
                    folded=True),
            *([Section("Columns of the log", [Table(["channel", "column"], columns)], folded=True)] if renamed else []),
        ],
        _advice(result, faults),
        {"columns read as": _mapped(result.mapping.name), "rows": str(result.rows)}, False,
        verdict=_verdict(result, faults), picture=_picture(result),
        numbers=[
            (f"{passed} of {len(checks)}", "checks passed, from time stamps to falls; all are listed below"),
            _usable(result),
            (f"{result.period * 1e3:.4g} ms", f"from one row to the next; {result.rows} rows"),
        ],
    )  # fmt: skip


_KINDS = {"error": Verdict("fault", "bad"), "warning": Verdict("fault", "warn"), "note": Verdict("remark", "info")}
_LEVELS = (
    "A fault must be repaired, or allowed for, before a model is fitted. Where it is red, the log is wrong. "
    "A remark needs nothing."
)


def _title(result: Diagnosis, faults: list[Finding]) -> str:
    name = result.source or "Log"
    if not faults:
        return f"{name}: no fault found"
    kinds = list(dict.fromkeys(_in_words(f) for f in faults))
    more = len(kinds) - NAMED
    named = [*kinds[: NAMED - 1], f"{more + 1} more kinds"] if more > 0 else kinds
    return f"{name}: {len(faults)} fault{'' if len(faults) == 1 else 's'}: {joined(named)}"


def _in_words(finding: Finding) -> str:
    if finding.code.startswith("delay/sensor"):
        return f"a late {_channel(finding)}"
    check = _check_of(finding)
    return WORDS.get(finding.code, FAULTS.get(check, check))


def _verdict(result: Diagnosis, faults: list[Finding]) -> Verdict:
    if not faults:
        return Verdict("healthy: can be used as it is", "good")
    level = "bad" if any(f.severity == "error" for f in faults) else "warn"
    count = len(_repairable(result))
    if len(faults) == 1:
        return Verdict("it can be repaired" if count else "it cannot be repaired", level)
    return Verdict(f"{count or 'none'} of the {len(faults)} can be repaired", level)


def _repairable(result: Diagnosis) -> list[Finding]:
    """The faults that the fixes remove: their own, or the cut that leaves their time out."""
    cuts = [fix.numbers for f in result.findings for fix in f.fixes if fix.kind == "cut"]
    return [
        f for f in result.findings
        if f.severity != "note"
        and (f.fixes or (f.span and any(f.span[0] >= stop or f.span[1] <= start for start, stop in cuts)))
    ]  # fmt: skip


def _usable(result: Diagnosis) -> tuple[str, str]:
    """The longest time on the wheels, which a repair keeps."""
    cut = next((fix.numbers for f in result.findings for fix in f.fixes if fix.kind == "cut"), None)
    if cut is None:
        return f"{result.seconds:.4g} s", "length of the log"
    start, stop = cut
    return (
        f"{stop - start:.3g} s",
        f"of {result.seconds:.4g} s can be used, from {start:.3g} to {stop:.3g} s: the robot is on its wheels",
    )


def _picture(result: Diagnosis) -> Figure | None:
    drawn = result.plot()
    if drawn is None:
        return None
    poses = ", then ".join(dict.fromkeys(segment.kind for segment in result.segments))
    record, note = result.read, ""
    if record.commands:
        left, right = (record[name] for name in record.commands)
        if float(np.mean(np.abs(left - right) <= 1e-3 * np.nanmax(np.abs(right), initial=0.0))) >= ALIKE:
            note = "Both motors get the same command: left lies under right."
    return Figure(f"The readings of the log{poses and f'; the robot was {poses}'}", drawn, note)


def _evidence(result: Diagnosis, finding: Finding) -> str:
    """The evidence without the peak of a smoothed rate, which the figure does not show; steps with their unit."""
    text = re.sub(r" at up to [\d.]+ rad/s", "", finding.evidence)
    unit = result.read.units.get(finding.channel, "")
    return re.sub(r"(steps of [\d.]+):", rf"\1 {unit}:", text) if unit not in ("", "1") else text


def _repair(finding: Finding) -> str:
    return finding.repair.replace("linear fit", "linear regression")


def _checks(result: Diagnosis) -> list[tuple[str, Verdict]]:
    """Each check with the gravest of its findings."""
    worst: dict[str, str] = {}
    for finding in result.findings:  # the worst come first
        worst.setdefault(_check_of(finding), finding.severity)
    words = {"": ("ok", "good"), "note": ("ok, with a remark", "info"), "warning": ("fault", "warn"),
             "error": ("fault", "bad")}  # fmt: skip
    return [(name, Verdict(*words[worst.get(name, "")])) for name in CHECKS]


def _check_of(finding: Finding) -> str:
    return next((n for n, heads in CHECKS.items() if finding.code.startswith(heads)), "readings")


def _mapped(name: str) -> str:
    return "the names of upright" if name == "ours" else f"those of '{name}'"


def _channel(finding: Finding) -> str:
    if "both encoders" in finding.evidence:
        return "encoders"
    if finding.code == "saturation" and finding.channel.endswith("left"):
        return "motors"  # their commands are judged together
    if finding.channel in _NAMES:
        return _NAMES[finding.channel]
    kind, _, side = finding.channel.rpartition("/")
    if side in ("left", "right") and kind in ("applied", "command"):
        return f"{side} {'motor' if kind == 'applied' else 'command'}"
    return finding.channel.removeprefix("sensor/").replace("_", " ")


_NAMES = {"t": "time", "estimate/pitch": "estimated pitch"}
_FINDING_FROM = "A finding from: how large what is measured must be for a fault or a remark."


def _limits(result: Diagnosis) -> dict[str, str]:
    """From what on each check finds something, in words with its numbers."""
    period, bias = result.period, _drift(result)
    apart, behind = (f"{1e3 * limit:.3g} ms" for limit in delays.shortest(period))
    return {
        "time stamps": f"jitter of {1e3 * time.JITTER * period:.2g} ms, a step of {1e3 * time.MISSED * period:.3g} ms",
        "rows": f"{100 * sensors.REPEATED:g} % that repeat in motion; fewer than {LEAST_ROWS} on the wheels",
        "units": f"another unit {round(math.exp(units.FAULT), -2):.0f} times likelier",
        "signs and sides": f"R² of {motion.TRUSTED:g}, {motion.MARGIN:g} better than as logged; t of {motion.SURE:g}",
        "rates and angles": f"R² better by {motion.MARGIN:g} than as logged",
        "delays": f"{apart} between gyro and wheels, {behind} behind the command",
        "gyro's bias": f"a mean of {cell_text(bias[1], 2)} rad/s" if bias else "",
        "readings": f"one value for {sensors.STUCK:g} s while others move; a hole; a single odd one",
        "encoder's resolution": f"steps of {sensors.COARSE_ENCODER:g} rad, or as coarse as the motion",
        "motors at their limit": f"{100 * outliers.PILED:g} % of the rows at the largest",
        "motion": f"an amplitude of the pitch below {sensors.QUIET:g} rad",
        "falls and slips": f"a fall; {segments.FAR:g} standard deviations off the pendulum equation",
    }  # fmt: skip


def _sound(result: Diagnosis) -> Record | None:
    """The log with its poses, where its units and kinds are right as they were read."""
    wrong = any(f.code.startswith(("units/", "motion/int", "motion/diff", "time/")) for f in result.findings)
    return None if wrong else replace(result.read, segments=result.segments)


def _drift(result: Diagnosis) -> tuple[float, float, float] | None:
    record = _sound(result)
    return sensors.drift(record) if record is not None else None


AGREED = {
    "signs and sides": "commands, wheels and gyro agree", "rates and angles": "no rate is an angle, no angle a rate",
    "delays": "gyro, wheels and commands: none late",
}  # fmt: skip
"""What it means that a check without a number of its own found nothing."""


def _values(result: Diagnosis) -> dict[str, str]:
    """What was measured for a check, where that is a number or a word."""
    passed = {name: verdict.text for name, verdict in _checks(result)}
    record, values = result.read, dict[str, str]()
    steps = np.diff(record.t)
    ordinary = steps[(steps > 0) & (steps < time.MISSED * result.period)]
    if len(ordinary):
        jitter = 1e3 * float(ordinary.std())
        values["time stamps"] = f"jitter {cell_text(jitter, 2)} ms" if jitter > 1e-3 else "no jitter"
    values["rows"] = str(result.rows)
    values["readings"] = f"all numbers, in {len(record.channels)} columns" if passed["readings"] == "ok" else ""
    if GYRO in record:
        unit, gyro = record.units.get(GYRO, "1"), record[GYRO][np.isfinite(record[GYRO])]
        if len(gyro):
            values["units"] = f"gyro up to {cell_text(float(np.abs(gyro).max()), 2)} {unit}"
            bias = _drift(result)
            mean = bias[0] if bias else float(gyro.mean())
            values["gyro's bias"] = f"mean {cell_text(mean, 2)} {unit}"
            values["motion"] = f"gyro {cell_text(float(gyro.std()), 2)} {unit} rms"
    if (sound := _sound(result)) is not None and (swing := sensors.amplitude(sound)):
        values["motion"] = f"amplitude of the pitch {cell_text(swing, 2)} rad"
    moved = np.abs(np.diff(record[LEFT])) if LEFT in record else np.zeros(0)
    if (moved > 0).any():
        step = float(moved[moved > 0].min())
        values["encoder's resolution"] = f"steps of {cell_text(step, 3)} {record.units.get(LEFT, '1')}"
    if record.commands:
        sides = [record[name] for name in record.commands]
        largest = max(float(np.nanmax(np.abs(side), initial=0.0)) for side in sides)
        at, _ = sensors.at_limit(record, record.commands)
        top = f"{cell_text(largest, 2)} {record.units.get(record.commands[0], '')}"
        values["motors at their limit"] = f"{cell_text(100 * at, 2)} % of the rows at the largest, {top}"
    for check, agreed in AGREED.items():
        values[check] = agreed if passed[check] == "ok" else ""
    for finding in result.findings:  # the worst come first
        name = _check_of(finding)
        values[name] = values.get(name) or re.split("[,:;] ", finding.evidence)[0]
    values["falls and slips"] = ", ".join(dict.fromkeys(segment.kind for segment in result.segments))
    return values


def _advice(result: Diagnosis, faults: list[Finding]) -> str:
    """The first finding with its repair, and what to run next."""
    name = result.source or "LOG"
    if not result.findings:
        return f"All checks pass. Next: `upright calibrate {name} --robot ROBOT -o robot.toml`."
    first, *others = result.findings
    if not faults:
        remark = f" One remark, on the {_channel(first)}: {_evidence(result, first).rstrip('.')}."
        more = f" {len(others)} more below." if others else ""
        return f"All checks pass.{remark}{more} Next: {_next(result, faults)}"
    do = f" {sentence(_repair(first))}" if _repair(first) else ""
    worst = "Worst, " if others else ""
    text = sentence(f"{worst}{_channel(first)}: {_evidence(result, first)}")
    return f"{text}{do} Next: {_next(result, faults)}"


def _next(result: Diagnosis, faults: list[Finding]) -> str:
    """The repair, with what it does and what it leaves; else the calibration."""
    name = result.source or "LOG"
    done = [f"{_channel(f)}, {f.repair}" for f in result.findings if f.fixes]
    if not done:
        return f"`upright calibrate {name} --robot ROBOT -o robot.toml`."
    kept = [_in_words(f) for f in faults if f not in _repairable(result)]
    left = f" It leaves {joined(list(dict.fromkeys(kept)))}." if kept else ""
    return f"`upright doctor {name} --fix repaired.csv` repairs: {'; '.join(done)}.{left}"
