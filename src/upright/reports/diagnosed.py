"""The page of a `Diagnosis`: the faults of a log, its readings, what a repair does, and every check."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.checkup import delays, motion, segments, sensors, swings, time, units
from upright.checkup.doctor import CONTRADICTORY, Diagnosis
from upright.checkup.finding import BALANCING, GYRO, LEFT, RIGHT, STANDING, Finding, Record, moment
from upright.checkup.physics import LEAST_ROWS
from upright.logs import outliers
from upright.reports.figure import Figure
from upright.reports.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.tables import joined, sentence

CHECKS = {
    "time stamps": ("time/",), "rows": ("samples/", "columns/"), "units": ("units/",),
    "signs and sides": ("motion/flipped", "motion/swapped", "motion/contra"),
    "rates and angles": ("motion/int", "motion/diff"),
    "delays": ("delay/",), "gyro's bias": ("gyro/",), "readings": ("channel/", "estimate/", "encoder/wrapped"),
    "encoder's resolution": ("encoder/",), "limits of motors and gyro": ("saturation",),
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
    "segment/slip": "a slip", "segment/still": "at rest",
    "saturation": "motors at their limit",
    "samples/controller": "rows left out", "samples/repeated": "repeated rows",
}  # fmt: skip
"""The same for single codes, where that says more."""
_PUSHED = "delay/untold"
NAMED = 4  # faults in the title
ALIKE = 0.9  # of the rows: both sides that are equal there lie on each other
THINNEST = 0.01  # of the largest value: a smaller difference is narrower than a line


def page_of(result: Diagnosis) -> Page:
    """The page, not yet written."""
    faults = result.faults
    rows: list[list[Cell]] = [
        [_kind(f), _channel(f), sentence(_evidence(result, f)), _repair(f) or "nothing"]
        for f in result.findings
        if f.code != "segment/cut"  # that is a number of the first screen
    ]
    columns: list[list[Cell]] = [[name, source.column] for name, source in result.mapping.channels.items()]
    renamed = any(name != column for name, column in columns)
    checks, values, limits = _checks(result), _values(result), _limits(result)
    checked_rows: list[list[Cell]] = [[*c, values.get(c[0], ""), limits[c[0]]] for c in checks]
    meaning = f"{_FAULT}{_RED if any(f.severity == 'error' for f in faults) else ''}{_REMARK}"
    return Page(
        _title(result, faults),
        [
            Section("Faults and remarks", [meaning, Table(["", "channel", "evidence", "what to do"], rows)]),
            Section("Checks", [_FINDING_FROM, Table(["check", "result", "measured", "a finding from"], checked_rows)],
                    folded=True),
            *([Section("Columns of the log", [Table(["channel", "column"], columns)], folded=True)] if renamed else []),
        ],
        _advice(result, faults),
        {"columns read as": _mapped(result.mapping.name), "rows": str(result.rows)}, False,
        verdict=_verdict(result, faults), picture=_picture(result),
        numbers=[
            _counted(faults, sum(verdict.level not in ("good", "info") for _, verdict in checks), len(checks)),
            _usable(result),
            (f"{result.period * 1e3:.4g} ms", f"from one row to the next; {result.rows} rows"),
        ],
    )  # fmt: skip


_KINDS = {"error": Verdict("fault", "bad"), "warning": Verdict("fault", "warn"), "note": Verdict("remark", "info")}
_FAULT = "A fault must be repaired, or allowed for, before a model is fitted. "
_RED = "Where it is red, the log is wrong. "
_REMARK = "A remark is no error of the log, but says what it is not good for."


def _kind(finding: Finding) -> Verdict:
    """Fault or remark, and which."""
    kind = _KINDS[finding.severity]
    return Verdict(f"{kind.text}: {_in_words(finding)}", kind.level)


def _counted(faults: list[Finding], failed: int, checks: int) -> tuple[str, str]:
    """How many faults there are, and which."""
    if not failed:
        return f"{checks} of {checks}", "checks passed, from time stamps to falls; open “Checks” for all"
    kinds = list(dict.fromkeys(_in_words(f) for f in faults))
    named = joined(kinds if len(kinds) <= NAMED else [*kinds[: NAMED - 1], "others"])
    count = f"{len(faults)} fault{'' if len(faults) == 1 else 's'}"
    return count, named


def _title(result: Diagnosis, faults: list[Finding]) -> str:
    name = result.source or "Log"
    if not faults:
        return f"{name}: no fault found"
    if result.kept and _one_cut(result):
        start, stop = result.kept
        falls = [f.span[0] for f in faults if f.code == "segment/fall" and f.span and f.span[0] >= stop]
        balanced = sum(b - a for a, b in _within(result, BALANCING, start, stop))
        if falls and balanced:
            return f"{name}: it balances, then falls at about {min(falls):.1f} s"
        begins = f"from {moment(start)} to " if start > result.read.t[0] else "up to "
        return f"{name}: usable {begins}{moment(stop)} s{', then the robot falls' if falls else ''}"
    kinds = list(dict.fromkeys(_in_words(f) for f in faults))
    more = len(kinds) - NAMED
    named = [*kinds[: NAMED - 1], f"{more + 1} more kinds"] if more > 0 else kinds
    return f"{name} has {len(faults)} fault{'' if len(faults) == 1 else 's'}: {joined(named)}"


def _in_words(finding: Finding) -> str:
    if finding.code.startswith("delay/sensor"):
        return f"a late {_channel(finding)}"
    if finding.code == "saturation" and finding.channel == GYRO:
        return "the gyro at its range"
    check = _check_of(finding)
    return WORDS.get(finding.code, FAULTS.get(check, check))


def _verdict(result: Diagnosis, faults: list[Finding]) -> Verdict:
    if not faults and _has(result, _PUSHED):
        return Verdict("sound, but pushes bend a model of it", "warn")
    if not faults:
        return Verdict("healthy: can be used as it is", "good")
    level = "bad" if any(f.severity == "error" for f in faults) else "warn"
    count = len(_repairable(result))
    if _one_cut(result) and len(faults) > 1:
        return Verdict(
            "cut it; too quiet for a model"
            if _has(result, "motion/quiet")
            else f"one cut removes all {len(faults)} faults",
            level,
        )
    if len(faults) == 1:
        return Verdict("it can be repaired" if count else "it cannot be repaired", level)
    return Verdict(f"{count or 'none'} of the {len(faults)} can be repaired", level)


def _one_cut(result: Diagnosis) -> bool:
    """Whether every fault lies outside the time that a repair keeps."""
    return bool(result.faults) and len(result.cut_away()) == len(result.faults)


def _repairable(result: Diagnosis) -> list[Finding]:
    """The faults that the fixes remove: their own, or the cut that leaves their time out."""
    away = result.cut_away()
    return [f for f in result.faults if f.fixes or f in away]


def _usable(result: Diagnosis) -> tuple[str, str]:
    """How long it balances in the time that a repair keeps, and how long it stands still there."""
    if result.kept is None:
        return f"{result.seconds:.4g} s", "length of the log"
    start, stop = result.kept
    spans = {kind: _within(result, kind, start, stop) for kind in (BALANCING, STANDING)}
    long = {kind: sum(b - a for a, b in several) for kind, several in spans.items()}
    where = " and ".join(f"{moment(a)} to {moment(b)} s" for a, b in spans[BALANCING][:2])
    more = " and later" if len(spans[BALANCING]) > 2 else ""
    rest = f"; {long[STANDING]:.3g} s at rest give only the gyro's noise" if long[STANDING] > 0 else ""
    if _one_cut(result):
        return f"{long[BALANCING]:.3g} s", f"of balancing are left by the cut: {where}{more}{rest}"
    return f"{long[BALANCING]:.3g} s", f"of {result.seconds:.3g} s it balances: {where}{more}{rest}"


def _within(result: Diagnosis, kind: str, start: float, stop: float) -> list[tuple[float, float]]:
    """The times [s] in this pose, from `start` to `stop`."""
    several = [(max(s.start, start), min(s.stop, stop)) for s in result.segments if s.kind == kind]
    return [(a, b) for a, b in several if a < b]


def _picture(result: Diagnosis) -> Figure | None:
    drawn = result.plot()
    if drawn is None:
        return None
    poses = ", then ".join(dict.fromkeys(segment.kind for segment in result.segments))
    pairs = {"encoders": (LEFT, RIGHT), "commands": result.read.commands or ()}
    same = [what for what, names in pairs.items() if _alike(result.read, names)]
    note = f"Left lies under right in the {joined(same)}." if same else ""
    if any(f.code == "segment/fall" for f in result.findings):
        note += (
            f" The shade of a fall begins up to {cell_text(4 * result.period, 2)} s early, since the gyro is smoothed."
        )
    return Figure(f"The readings of the log{poses and f'; the robot was {poses}'}", drawn, note.lstrip())


def _alike(record: Record, names: Sequence[str]) -> bool:
    """Whether a left and a right channel are equal in nearly all rows, to what a figure shows."""
    if len(names) < 2 or any(name not in record for name in names):
        return False
    left, right = (record[name] for name in names)
    return float(np.mean(np.abs(left - right) <= THINNEST * np.nanmax(np.abs(right), initial=0.0))) >= ALIKE


def _evidence(result: Diagnosis, finding: Finding) -> str:
    """The evidence without the peak of a smoothed rate, which the figure does not show; steps with their unit."""
    text = re.sub(r" at up to [\d.]+ rad/s", "", finding.evidence)
    unit = result.read.units.get(finding.channel, "")
    return re.sub(r"(steps of [\d.]+):", rf"\1 {unit}:", text) if unit not in ("", "1") else text


def _repair(finding: Finding) -> str:
    """The repair, with commands as code; of a rest also what it is good for."""
    use = "; they give the gyro's noise" if finding.code == "segment/still" else ""
    return re.sub(r"\b(upright [a-z-]+)", r"`\1`", finding.repair) + use


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
    return "upright's own names" if name == "ours" else f"those of '{name}'"


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
        "limits of motors and gyro": f"{100 * outliers.PILED:g} % of the rows at the largest",
        "motion": f"an amplitude of the pitch below {swings.QUIET:g} rad",
        "falls and slips": f"a fall; {segments.FAR:g} standard deviations off the pendulum equation",
    }  # fmt: skip


def _sound(result: Diagnosis) -> Record | None:
    """The log with its poses, where its units and kinds are right as they were read."""
    wrong = any(f.code.startswith(("units/", "motion/int", "motion/diff", "time/")) for f in result.findings)
    return None if wrong else replace(result.read, segments=result.segments)


def _drift(result: Diagnosis) -> tuple[float, float, float] | None:
    record = _sound(result)
    return swings.drift(record) if record is not None else None


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
    if (sound := _sound(result)) is not None and (swing := swings.amplitude(sound)):
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
        values["limits of motors and gyro"] = f"{cell_text(100 * at, 2)} % of the rows at the largest, {top}"
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
    if _one_cut(result):
        return f"{_events(result)} Next: {_next(result, faults)}"
    first, *others = result.findings
    if not faults:
        remark = f" One remark, on the {_channel(first)}: {_evidence(result, first).rstrip('.')}."
        more = f" {len(others)} more below." if others else ""
        return f"All checks pass.{remark}{more} Next: {_next(result, faults)}"
    do = f" {sentence(_repair(first))}" if _repair(first) else ""
    worst = "Worst, " if others else ""
    text = sentence(f"{worst}{_channel(first)}: {_evidence(result, first)}")
    return f"{text}{do} Next: {_next(result, faults)}"


def _events(result: Diagnosis) -> str:
    """What happens outside the time that is kept, in the order of time."""
    assert result.kept
    first = {_in_words(f): f.span[0] for f in sorted(result.faults, key=lambda f: -(f.span or (0.0,))[0]) if f.span}
    events = [f"{name} from {moment(at)} s" for name, at in sorted(first.items(), key=lambda event: event[1])]
    start, stop = map(moment, result.kept)
    what = joined(events)
    if events[0].startswith(WORDS["segment/fall"]):
        falls = events[0].replace(WORDS["segment/fall"], "the robot falls")
        what = f"{falls} on{', with ' if events[1:] else ''}{joined(events[1:])}"
    fell = [f.span[0] for f in result.faults if f.code == "segment/fall" and f.span]
    before = min((at - result.kept[1] for at in fell if at >= result.kept[1]), default=0.0)
    ahead = f", {cell_text(before, 2)} s before the fall" if before else ""
    text = f"{sentence(what)} No fault lies between {start} and {stop} s{ahead}"
    swing = swings.amplitude(sound) if _has(result, "motion/quiet") and (sound := _sound(result)) else 0.0
    return (
        f"{text}; there it swings by only {cell_text(math.degrees(swing), 2)}°, {_TOO_QUIET}." if swing else f"{text}."
    )


def _next(result: Diagnosis, faults: list[Finding]) -> str:
    """The repair, with what it does and what it leaves; else the calibration."""
    name = result.source or "LOG"
    fixed = [f for f in result.findings if f.fixes]
    done = [f"{_channel(f)}, {f.repair}" for f in fixed if f.code != "segment/cut"]
    repairs = [f"repairs: {'; '.join(done)}"] if done else []
    if result.kept:
        start, stop = map(moment, result.kept)
        gone = ", without the faults" if _one_cut(result) else ""
        repairs.append(f"{'It ' if done else ''}keeps {start} ≤ t < {stop} s{gone}")
    fell = any(f.code == "segment/fall" for f in faults)
    why = f"`upright post-mortem {name} --robot ROBOT` finds why it fell." if fell else ""
    if not fixed:
        if wrong := next((f for f in faults if f.severity == "error" or f.code.startswith(CONTRADICTORY)), None):
            return f"{sentence(_repair(wrong))} Then ask `upright doctor` again."
        if why and _has(result, "segment/none"):  # nothing to calibrate from
            return why
        return _EXCITED if _has(result, _PUSHED) else f"`upright calibrate {name} --robot ROBOT -o robot.toml`."
    kept = [_in_words(f) for f in faults if f not in _repairable(result)]
    left = f" It leaves {joined(list(dict.fromkeys(kept)))}." if kept else ""
    log = f" {_EXCITED}" if _has(result, "motion/quiet") else ""
    return f"{f'{why} ' if why else ''}`upright doctor {name} --fix repaired.csv` {'. '.join(repairs)}.{left}{log}"


_TOO_QUIET = "too little for a model"
_EXCITED = "For a model log a new run with the signal that `upright excite --robot ROBOT -o plan.json` designs."


def _has(result: Diagnosis, code: str) -> bool:
    """Whether there is a finding of that code, such as that the robot swings too little for a model."""
    return any(f.code == code for f in result.findings)
