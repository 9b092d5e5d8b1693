"""Pages of what a check found: a `Diagnosis` of a log, a `Parity` of a program, the `LinearModel` of a robot."""

from __future__ import annotations

import math
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from upright.doctor import delays, motion, segments, sensors, time, units
from upright.doctor.doctor import Diagnosis
from upright.doctor.finding import GYRO, LEFT, Finding, Record
from upright.doctor.physics import LEAST_ROWS
from upright.logs import outliers
from upright.parity.parity import Parity
from upright.physics.linear import Complex, LinearModel
from upright.plotting import AXIS, COLOURS, PANEL, bars, legend, number, numbered, panels, plane, points
from upright.report.figure import Figure
from upright.report.page import Cell, Page, Section, Table, Verdict, cell_text
from upright.robots import Robot
from upright.tables import sentence


def page_of(result: Diagnosis | Parity | LinearModel) -> Page:
    """The page, not yet written."""
    if isinstance(result, Diagnosis):
        return _diagnosis(result)
    return _parity(result) if isinstance(result, Parity) else _linear(result)


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
NAMED = 3  # faults in the title


def _diagnosis(result: Diagnosis) -> Page:
    faults = sum(f.severity != "note" for f in result.findings)
    remarks = len(result.findings) - faults
    level = {"error": "bad", "warning": "warn", "note": "info"}
    rows: list[list[Cell]] = [
        [Verdict(f.severity, level[f.severity]), _channel(f), sentence(f.evidence), f.repair] for f in result.findings
    ]
    columns: list[list[Cell]] = [[name, source.column] for name, source in result.mapping.channels.items()]
    renamed = any(name != column for name, column in columns)
    drawn = result.plot()
    poses = ", then ".join(dict.fromkeys(segment.kind for segment in result.segments))
    kinds = list(dict.fromkeys(_check_of(f) for f in result.findings if f.severity != "note"))
    of = ", ".join([*(FAULTS.get(kind, kind) for kind in kinds[:NAMED]), *(["…"] if len(kinds) > NAMED else [])])
    counted = f"{faults} fault{'' if faults == 1 else 's'} ({of})" if faults else "no fault found"
    checks, values, limits = _checks(result), _values(result), _limits(result)
    checked_rows: list[list[Cell]] = [[*c, values.get(c[0], ""), limits[c[0]]] for c in checks]
    passed = sum(verdict.level in ("good", "info") for _, verdict in checks)
    return Page(
        f"{result.source or 'Log'}: {counted}",
        [
            Section("Findings", [Table(["kind", "channel", "evidence", "what to do"], rows)]),
            Section("Checks", [_FINDING_FROM, Table(["check", "result", "measured", "a finding from"], checked_rows)],
                    folded=True),
            *([Section("Columns of the log", [Table(["channel", "column"], columns)], folded=True)] if renamed else []),
        ],
        _advice(result, faults),
        {"columns read as": _mapped(result.mapping.name), "rows": str(result.rows)}, False,
        verdict=Verdict("healthy: can be used as it is", "good") if result.healthy else Verdict(
            "to repair", "bad" if any(f.severity == "error" for f in result.findings) else "warn"),
        picture=Figure(f"The readings of the log{poses and f'; the robot was {poses}'}", drawn) if drawn else None,
        numbers=[
            (f"{passed} of {len(checks)}", "checks passed, from time stamps to falls; all are listed below"),
            (f"{result.seconds:.4g} s", f"length: {result.rows} rows, one every {result.period * 1e3:.4g} ms"),
            (str(remarks), "remark, which is no fault" if remarks == 1 else "remarks, which are no faults"),
        ],
    )  # fmt: skip


def _checks(result: Diagnosis) -> list[tuple[str, Verdict]]:
    """Each check with the gravest of its findings."""
    worst: dict[str, str] = {}
    for finding in result.findings:  # the worst come first
        worst.setdefault(_check_of(finding), finding.severity)
    words = {"": ("ok", "good"), "note": ("ok, with a remark", "info"), "warning": ("warning", "warn"),
             "error": ("error", "bad")}  # fmt: skip
    return [(name, Verdict(*words[worst.get(name, "")])) for name in CHECKS]


def _check_of(finding: Finding) -> str:
    return next((n for n, heads in CHECKS.items() if finding.code.startswith(heads)), "readings")


def _mapped(name: str) -> str:
    return "the names of upright" if name == "ours" else f"those of '{name}'"


def _channel(finding: Finding) -> str:
    if "both encoders" in finding.evidence:
        return "encoders"
    kind, _, side = finding.channel.rpartition("/")
    if side in ("left", "right") and kind in ("applied", "command"):
        return f"{side} {'motor' if kind == 'applied' else 'command'}"
    return finding.channel.removeprefix("sensor/").replace("_", " ")


_FINDING_FROM = "A finding from: how large what is measured must be for a warning or a remark."


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


def _advice(result: Diagnosis, faults: int) -> str:
    """The first finding with its repair, and what to run next."""
    name = result.source or "LOG"
    first = next(iter(result.findings), None)
    of = f" {_channel(first)}: {first.evidence.rstrip('.')}." if first else ""
    more = f" {len(result.findings) - 1} more below." if len(result.findings) > 1 else ""
    remark = f" One remark, on the {of.strip().partition(':')[0]}: {first.repair.rstrip('.')}." if first else ""
    text = f"Worst,{of}" if faults else f"All checks pass.{remark}{more}"
    text += f" {sentence(first.repair)}" if faults and first and first.repair else ""
    fixes = any(f.fixes for f in result.findings)
    repaired = sum(bool(f.fixes) for f in result.findings if f.severity != "note")
    which = f", which repairs {repaired} of the {faults} faults" if faults and repaired else ""
    next_one = (
        f"`upright doctor {name} --fix repaired.csv`{which}" if fixes else f"`upright calibrate {name} --robot ROBOT`"
    )
    return f"{text} Next: {next_one}.".strip()


def _parity(result: Parity) -> Page:
    rows: list[list[Cell]] = [[p.push, p.outcome, p.peak] for p in result.pushes]
    figure = bars(["difference", "tolerance"], [result.worst, result.tolerance], f"command [{result.unit}]", "largest")
    difference = f"{cell_text(result.worst, 3)} {result.unit}"
    within = "within" if result.worst <= result.tolerance else "beyond"
    return Page(
        f"{result.target} program of {result.robot}: {'equal to' if result.passed else 'not equal to'} its design",
        [Section("Pushes", [Table(["push", "outcome", "largest pitch [rad]"], rows)])],
        "" if result.as_generated else "The file differs from what `upright firmware` generates here.",
        {"controller": result.hash[:12], "numbers": result.numbers, "where": result.where}, True,
        verdict=Verdict("equal", "good") if result.passed else Verdict("not equal", "bad"),
        picture=Figure(f"Commands differ by {difference}, {within} the tolerance", figure),
        numbers=[
            (f"{result.steps} of {result.periods}", "periods compared"),
            (str(result.duties), "duties that do not follow from their commands"),
        ],
    )  # fmt: skip


SYMBOLS = {"pitch": "ψ", "pitch_rate": "ψ̇", "wheel": "θ", "wheel_rate": "θ̇", "yaw": "φ", "yaw_rate": "φ̇"}
_SYMBOLS = (
    "ψ pitch, positive forward; θ wheel angle against the floor; φ yaw, anticlockwise [rad]. With a dot: their rates "
    "[rad/s]. Commands are in {unit}."
)


def linear_page(model: LinearModel, robot: Robot) -> Page:
    """The page of the linear model of a `robot`, which is named on it."""
    page = _linear(model, robot.command_unit)
    return replace(page, title=linear_title(model, robot.name), provenance={"robot": robot.name})


def linear_title(model: LinearModel, robot: str = "the robot") -> str:
    """Whether a robot falls without a controller, and how fast."""
    fastest = _fastest(model)
    if fastest <= 0:
        return "No pole is unstable"
    return f"Without a controller {robot} falls: a lean doubles every {_doubling(fastest)}"


def _unstable(model: LinearModel) -> list[complex]:
    return [p for p in model.poles().tolist() if (p.real > 1e-9 if model.continuous else abs(p) > 1 + 1e-9)]


def _fastest(model: LinearModel) -> float:
    """The largest rate of growth [1/s], 0 where nothing grows."""
    return max((p.real if model.continuous else math.log(abs(p)) / model.dt for p in _unstable(model)), default=0.0)


def _doubling(rate: float) -> str:
    seconds = math.log(2) / rate
    return f"{cell_text(1e3 * seconds, 2)} ms" if seconds < 1 else f"{cell_text(seconds, 2)} s"


def _linear(model: LinearModel, unit_of_command: str = "V, or in N m for a robot with a torque drive") -> Page:
    poles = model.poles()
    unit = "1/s" if model.continuous else "1"
    unstable = _unstable(model)
    motions = _motions(model, poles)
    rows: list[list[Cell]] = [[p.real, p.imag, of] for p, of in zip(poles.tolist(), motions, strict=True)]
    named = [SYMBOLS.get(state, state) for state in model.states]
    rates = [f"d{name}/dt" if model.continuous else f"next {name}" for name in named]
    matrices = [
        Table(["", *names], [[state, *row] for state, row in zip(rates, matrix.tolist(), strict=True)], caption, 3)
        for caption, names, matrix in (
            ("A: from each state (column) to the rates of change (rows)", named, model.A) if model.continuous else
            ("A: from each state (column) to the next state (rows)", named, model.A),
            ("B: from each command (column)", [f"{name} command" for name in model.inputs], model.B),
        )
    ]  # fmt: skip
    legend_of = [_SYMBOLS.format(unit=unit_of_command)] if set(model.states) <= set(SYMBOLS) else []
    count = f"{len(unstable)} of {len(poles)} poles {'is' if len(unstable) == 1 else 'are'} unstable"
    fastest = _fastest(model)
    doubles = _doubling(fastest) if unstable else ""
    equation = (
        "ẋ\u00a0=\u00a0A\u00a0x\u00a0+\u00a0B\u00a0u" if model.continuous else f"x⁺ = A x + B u, every {model.dt:g} s"
    )
    numbers = [
        *(
            (f"{cell_text(p.real, 3)}{' 1/s' if model.continuous else ''}", _POLE[model.continuous])
            for p in unstable[:1]
        ),
        *([(doubles, "in which a small lean doubles")] if unstable else []),
        *_others(poles.tolist(), model.continuous),
    ]
    return Page(
        linear_title(model),
        [
            Section("Matrices", [*legend_of, *matrices]),
            Section("Poles", [Table([f"real part [{unit}]", f"imaginary part [{unit}]", "motion"], rows)]),
        ],
        f"The linear model near the upright rest with motors at zero command, {equation}. {count}. "
        "Next: `upright design` a controller.", {}, False,
        verdict=Verdict("unstable without control" if unstable else "stable", "info"),
        picture=_pole_figure(poles, model.continuous, count, motions), numbers=numbers,
    )  # fmt: skip


def _others(poles: Sequence[complex], continuous: bool) -> list[tuple[str, str]]:
    """How many poles keep what they have: nothing brings the robot back there."""
    still = sum(abs(p) < 1e-9 if continuous else abs(p - 1) < 1e-9 for p in poles)
    at = "at zero" if continuous else "at one"
    return [(f"{still} of {len(poles)}", f"poles {at}: where it has rolled or turned, it stays")] if still else []


_POLE = {
    True: "rate at which a lean grows: the unstable pole",
    False: "by which a lean grows every period: the unstable pole",
}
TURNING = ("yaw", "yaw_rate")


def _motions(model: LinearModel, poles: Complex) -> list[str]:
    """What moves with each pole, where the model keeps turning and balancing apart; '' where it does not."""
    turning = np.array([state in TURNING for state in model.states])
    if not turning.any() or turning.all() or model.A[np.ix_(turning, ~turning)].any() or (
        model.A[np.ix_(~turning, turning)].any()
    ):  # fmt: skip
        return [""] * len(poles)
    left = list(np.linalg.eigvals(model.A[np.ix_(turning, turning)]))
    motions: list[str] = []
    for pole in poles.tolist():
        near = min(range(len(left)), key=lambda k, p=pole: abs(left[k] - p), default=-1)
        turns = near >= 0 and abs(left[near] - pole) < 1e-6 * (1 + abs(pole))
        motions.append("yaw" if turns else "pitch and wheels")
        if turns:
            del left[near]
    return motions


def _pole_figure(poles: Complex, continuous: bool, count: str, motions: Sequence[str]) -> Figure:
    """The poles; of a continuous model over a real axis that is logarithmic away from zero, so that fast poles do not
    hide the slow ones, with a line at zero."""
    if not continuous:
        figure, ax = plane("real part [1]", "imaginary part [1]", circle=True)
        points(ax, "poles", poles.tolist())
        return Figure(f"{count}: outside the circle" if not count.startswith("0 ") else count, figure)
    figure, (ax,) = panels(
        ["imaginary part [1/s]"],
        "real part [1/s], in powers of ten on both sides of zero",
        height=0.9 if not poles.imag.any() else PANEL,
    )
    high = 1.5 * (float(np.abs(poles.imag).max()) or 1.0)
    reach = max(10.0, 3 * float(np.abs(poles.real).max()))
    ax.set(xscale="symlog", xlim=(-reach, reach), ylim=(-high, high))
    numbered(ax.xaxis)
    ax.axvline(0, color=AXIS, linewidth=1)
    if not poles.imag.any():
        ax.set_yticks([0], ["0"])
    kinds = {"stable": (-math.inf, -1e-9, 0), "neither (at zero)": (-1e-9, 1e-9, 4), "unstable": (1e-9, math.inf, 1)}
    for name, (low, top, colour) in kinds.items():
        kept = poles[(poles.real > low) & (poles.real <= top)]
        if len(kept):
            (marks,) = ax.plot(kept.real, kept.imag, "x", label=name, markersize=9, color=COLOURS[colour], zorder=3)
            marks.set_markeredgewidth(2.2)
    several = Counter(complex(round(p.real, 6), round(p.imag, 6)) for p in poles.tolist())
    for place, pole in enumerate(sorted(several, key=lambda p: p.real)):
        same = {of for p, of in zip(poles.tolist(), motions, strict=True) if abs(p - pole) < 1e-5}
        words = [f"{several[pole]} poles"] if several[pole] > 1 else ["yaw"] if same == {"yaw"} else []
        text = number(pole.real, 3) + "".join(f" ({word})" for word in words)
        beside = 6 if pole.real == 0 else 0  # not on the line at zero
        above = (beside, -22) if place % 2 else (beside, 9)  # neighbours do not overlap
        ax.annotate(text, (pole.real, pole.imag), above, textcoords="offset points", ha="left" if beside else "center")
    return Figure(f"{count}: right of the line" if not count.startswith("0 ") else count, legend(figure))
