"""The page of a `Certificate`: its light and reasons, every push, and the effect of more delay and other periods."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby

from upright.certification.certificate import Certificate
from upright.certification.checks import PushTrial
from upright.certification.pushes import HELD, KNOCKED, RELEASE
from upright.certification.recovery import KNOCK_DURATION
from upright.certification.standing import Swept
from upright.certification.verdict import AMBER, GREEN, MOST_FALLS, RED, UNKNOWN, LinearMargins, placed
from upright.likelihood.assumptions import BATTERIES
from upright.plotting import AXIS, line, number, panels
from upright.reports.figure import Figure
from upright.reports.page import Cell, Details, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import in_degrees, joined, sentence

LEVEL = {GREEN: "good", AMBER: "warn", RED: "bad", UNKNOWN: "warn"}
HEADINGS = {
    GREEN: "{0} may drive {1}", RED: "{0} must not drive {1}",
    UNKNOWN: "{1} is not known well enough for {0}",
}  # fmt: skip
"""What a light means; amber: it may, if somebody has read the reasons."""


def page_of(certificate: Certificate) -> Page:
    """The certificate's page, not yet written."""
    light = certificate.light
    verdict = Verdict(light if light == UNKNOWN else f"{light} light", LEVEL.get(light, "info"))
    green = certificate.light == GREEN
    reasons = Section("Reasons", [*(sentence(in_degrees(reason)) for reason in certificate.reasons)], folded=green)
    sections = [Section("Three questions", certificate.answers()), reasons]
    learn = certificate.to_learn()
    if learn:
        sections.append(Section("What would have to be known better", learn))
    sections += [
        Section("Pushes", [_trials(certificate), Details("How this was tried", [_intro(certificate)])]),
    ]
    if green and certificate.linear:
        sections.append(Section("Why small margins are no contradiction", [_USUAL], folded=True))
    if certificate.linear and certificate.linear.stable:
        sections.append(Section("Nominal loop", [_linear(certificate.linear)], folded=True))
    if certificate.delayed or certificate.slower:
        sections.append(Section("Other delays and periods", _sweeps(certificate)))
    if certificate.support:
        sections.append(Section("What the log shows", [_support(certificate)]))
    c = certificate
    facts = {"controller": c.hash[:12], "seed": str(c.seed), "kit": c.kit}
    facts |= {"on the scale": f"{c.weighed:.3g} kg"} if c.weighed else {}
    lead = f"{sentence(c.designed)} " if c.designed else ""
    lead += (
        f"{c.samples} simulated robots, each within the uncertainty of {c.robot}, were held leaning, let go, and "
        f"knocked at the centre of mass{_above(c)}: {c.fell} fell."
    )
    if c.beyond:
        lead += f" Of the {c.fell}, {c.beyond} {'was' if c.beyond == 1 else 'were'} beyond any controller."
    if c.taken:
        lead += f" The log's own numbers were tried: {', '.join(s.name for s in c.taken)}."
    if c.light == GREEN:
        to = PROGRAMS.get(c.kit, "--target c -o balance.c")
        lead += f" Next: `upright firmware {c.given or c.controller} --robot {c.robot} {to}` writes its program."
    elif c.asks:
        lead += f" Next: {sentence(c.asks).replace('--weighed KG', '`--weighed KG`')}"
    title = HEADINGS.get(c.light, "{0} may drive {1}, with reservations").format(c.controller, c.robot)
    return Page(
        title, sections, lead, facts, False, verdict=verdict,
        picture=_falls(c), numbers=_numbers(c),
    )  # fmt: skip


_USUAL = (
    "Margins below the usual targets, as `upright design` may say, do not contradict this: here all numbers of robot, "
    "delay and battery were varied at once, as far as the file says that they may differ."
)


PROGRAMS = {
    "nxt": "--target nxc -o balance.nxc", "spike": "--target pybricks -o balance.py",
    "ev3": "--target ev3dev -o balance.py",
}  # fmt: skip
"""Kit → the language of its brick, and a file for the program."""


def _above(c: Certificate) -> str:
    """How high the centre of mass is."""
    height = c.subject["robot"].get("com_height")
    return f" ({number(float(height), 2)} m above the axle)" if height else ""


def _numbers(c: Certificate) -> list[tuple[str, str]]:
    bound = f"of such robots fall, with 95 % confidence; the limit is {100 * MOST_FALLS:g} %"
    numbers = [(f"≤ {number(100 * c.bound, 2)} %", bound)]
    if c.linear and c.linear.stable:
        numbers += [
            (
                f"{cell_text(c.linear.delay * 1e3, 2)} ms",
                f"more delay{placed(c.linear.delay_at)} alone makes the nominal loop unstable",
            ),
            *_command_delay(c),
        ]
    if periods := _periods(c):
        return [*numbers, periods]
    stood = [t.travel for t in c.trials if t.fell < t.runs]
    return [
        *numbers,
        *(
            [(f"{cell_text(max(stood), 3)} m", "95 % of those that stood travel less, under the worst push")]
            if stood
            else []
        ),
    ]


def _command_delay(c: Certificate) -> list[tuple[str, str]]:
    """Where a sensor alone bears less than commands do: how much later the commands may come."""
    borne = [s.value for s in c.delayed if s.fell <= MOST_FALLS * s.runs]
    if not (c.linear and c.linear.delay_at and borne and max(borne) > c.linear.delay):
        return []
    most = max(borne)
    end = "the longest tried" if most == max(s.value for s in c.delayed) else "of those tried"
    words = f"later may the motors' commands come ({end}): at most {100 * MOST_FALLS:g} % fall"
    return [(f"{number(1e3 * most, 3)} ms", words)]


def _periods(c: Certificate) -> tuple[str, str] | None:
    """The periods tried round the designed one at which few fall, and how many do at those beside them."""
    rows = sorted(c.slower, key=lambda s: s.value)
    near = [k for k, s in enumerate(rows) if c.period and math.isclose(s.value, c.period)]
    if not near or rows[near[0]].fell > MOST_FALLS * rows[near[0]].runs:
        return None
    first = last = near[0]
    while first > 0 and rows[first - 1].fell <= MOST_FALLS * rows[first - 1].runs:
        first -= 1
    while last < len(rows) - 1 and rows[last + 1].fell <= MOST_FALLS * rows[last + 1].runs:
        last += 1
    beside = [rows[k] for k in (first - 1, last + 1) if 0 <= k < len(rows)]
    ends = " to ".join(dict.fromkeys(number(1e3 * rows[k].value, 3) for k in (first, last)))
    falls = ", ".join(f"at {number(1e3 * s.value, 3)} ms {number(100 * s.fell / s.runs, 2)} %" for s in beside)
    words = f"period of the loop at which at most {100 * MOST_FALLS:g} % fall{f'; {falls}' if falls else ''}"
    return f"{ends} ms", words


def _falls(c: Certificate) -> Figure:
    allowed = f"{100 * MOST_FALLS:g} %"
    most = max(c.trials, key=lambda t: t.fell / t.runs)
    if most.fell:
        percent = number(100 * most.fell / most.runs, 3)
        alike = [t for t in c.trials if t.fell * most.runs == most.fell * t.runs and t.battery == most.battery]
        pushes = joined([in_degrees(t.push) for t in alike[:2]]).replace(" and hold at ", " and ")
        worst = f"worst: {pushes}, {most.battery} battery, {percent} %"
        limit = f"Every push is below the limit of {allowed}" if c.bound <= MOST_FALLS else f"The limit is {allowed}"
        return Figure(f"{limit}; {worst}", c.plot())
    return Figure(f"No robot fell in {sum(t.runs for t in c.trials)} trials: how far 95 % of them rolled", c.plot())


def _intro(c: Certificate) -> str:
    moved = max((t.residual for t in c.trials), default=0.0)
    last = (
        f" The last iteration of a period moved a command by {100 * moved:.2g} % of its limit at most." if moved else ""
    )
    return (
        f"{c.samples} robots drawn from the uncertainty of {c.robot}, in the nonlinear model with kit {c.kit}. "
        f"{c.fell} fell in at least one trial: with 95 % confidence the probability is below {100 * c.bound:.2g} %. "
        f"{_pushes(c)} "
        "“Limit of the best controller”: the largest such push that any controller could survive with that battery, "
        "in the nonlinear model and with a command one period late (`upright basin` marks the linear model's). "
        f"Holds are {100 * HELD:g} % of it, knocks {100 * KNOCKED:g} %. “Beyond every controller”: so many of those "
        "that fell. "
        f"The last four columns are 95 % quantiles of the robots that stood. Sway is half of pitch's "
        f"range in the last seconds.{last}"
    )


def _pushes(c: Certificate) -> str:
    """How long the standard pushes last, and where they act."""
    numbers = c.subject["robot"]
    height = sum(float(value) for name in ("wheel_radius", "com_height") if (value := numbers.get(name)))
    return (
        f"A hold leans the robot by a force for {RELEASE:g} s, then lets go. A knock lasts "
        f"{1e3 * KNOCK_DURATION:g} ms. Both act at the centre of mass, {1e3 * height:.0f} mm above the floor."
    )


def _trials(c: Certificate) -> Table:
    rows: list[list[Cell]] = [
        [
            in_degrees(t.push),
            _volts(c, t.battery),
            t.fell,
            t.beyond,
            _recoverable(t),
            *(_quantiles(t) if t.fell < t.runs else [None] * 4),
        ]
        for t in c.worst_first()
    ]
    header = [
        "push", "battery", "fell", "beyond every controller", "limit of the best controller",
        "saturated [%]", "travel [m]", "pitch [°]",
        "sway at rest [°]",
    ]  # fmt: skip
    caption = f"Standard pushes with full and low battery, {c.samples} robots each; last four columns: 95 % are below"
    return Table(header, rows, caption, 3)


def _volts(c: Certificate, battery: str) -> str:
    """A battery with its voltage, where that is known: "low, 6.4 V"."""
    if battery not in BATTERIES:
        return battery
    nominal = c.subject["kit"].get("battery/voltage")
    end = "low" if battery == "low" else "high"
    volts = c.subject["robot"].get(f"conditions/battery/{end}")
    if volts is None and isinstance(nominal, float):
        volts = BATTERIES[battery] * nominal
    return f"{battery}, {number(volts, 3)}\u00a0V" if isinstance(volts, float) else battery


def _recoverable(t: PushTrial) -> str:
    """The largest push of this kind that any controller could survive, with its unit."""
    if t.bound is None or not math.isfinite(t.bound):
        return cell_text(t.bound)
    return f"{cell_text(t.bound, 3)} N s" if "N s" in t.push else f"{math.degrees(t.bound):.2g}°"


def _quantiles(t: PushTrial) -> list[float]:
    """Of the robots that stood: saturated periods [%], travel [m], peak pitch [°] and sway [°]."""
    return [100 * t.saturated, t.travel, math.degrees(t.peak), round(math.degrees(t.cycle), 2)]


def _linear(margins: LinearMargins) -> Table:
    rows: list[list[Cell]] = [
        ["largest |pole|", margins.radius],
        ["gain margin, from", margins.gain_low],
        ["gain margin, to", margins.gain_high],
        ["delay margin [ms]", margins.delay * 1e3],
    ]
    return Table(
        ["", "value"], rows, "Each the smallest of all places where the loop can be opened: motors, sensors", 4
    )


def _support(c: Certificate) -> Table:
    taken = {s.name for s in c.taken}
    judged = [(s, "tried as logged") for s in c.taken]
    judged += [
        (s, "left open" if s.left_open else "outside" if s.outside else "")
        for s in c.support
        if s.outside or s.name not in taken
    ]
    rows: list[list[Cell]] = [
        [s.name, s.unit, *(round(v, 9) for v in (s.value, s.low, s.high, s.least, s.most)), word] for s, word in judged
    ]
    header = ["number", "unit", "value", "from", "to", "assumed from", "assumed to", ""]
    return Table(header, rows, "Numbers of the log with 95 % intervals, beside what was assumed", 3)


_ANEW = "Gains are made for one period: design anew for another."


def _sweeps(c: Certificate) -> list[Item]:
    apart = "Late commands delay both motors at once."
    if c.linear and "gyro" in c.linear.delay_at:
        apart += f" The {cell_text(c.linear.delay * 1e3, 2)} ms above are for the gyro alone, whose loop is quicker."
    none = [replace(s, value=0.0) for s in c.slower if c.period and math.isclose(s.value, c.period)]
    sweeps = (
        ("additional delay of the commands", [*none[:1], *c.delayed], "Commands that come later", apart, None),
        ("period", c.slower, "The same gains at another period", _ANEW, c.period),
    )
    return [_figure(name, swept, title, note, at) for name, swept, title, note, at in sweeps if len(swept) > 1]


def _figure(name: str, swept: Sequence[Swept], title: str, note: str, designed: float | None) -> Figure:
    milliseconds = [1e3 * s.value for s in swept]
    parts = [100 * s.fell / s.runs for s in swept]
    figure, (ax,) = panels(["fell [%]"], f"{name} [ms]")
    line(ax, "fell", milliseconds, parts)
    ax.lines[-1].set_marker("o")
    if designed:
        ax.axvline(1e3 * designed, linestyle="--", linewidth=1, color=AXIS)
        ax.annotate(
            "designed for",
            (1e3 * designed, 0.86),
            (4, 0),
            xycoords=("data", "axes fraction"),
            textcoords="offset points",
        )
    top = min(105.0, max(10.0, 1.3 * max(parts)))
    ax.set_ylim(-0.05 * top, top)
    ax.axhline(100 * MOST_FALLS, linestyle="--", linewidth=1, color=AXIS)
    ax.annotate(
        f"limit, {100 * MOST_FALLS:g} %", (1, 100 * MOST_FALLS), (-4, 4), xycoords=("axes fraction", "data"),
        ha="right", textcoords="offset points",
    )  # fmt: skip
    runs = f"{swept[0].runs} runs each: some of the robots, left alone, the nominal battery."
    return Figure(
        f"{title}: {fallen(milliseconds, parts)}",
        figure,
        f"{runs} {note}".strip(),
    )


def fallen(values: Sequence[float], parts: Sequence[float]) -> str:
    """Where more than the limit fall, in words: `parts` [%] at `values` [ms], which ascend."""
    limit = 100 * MOST_FALLS
    if max(parts) <= limit:
        return f"at most {number(max(parts), 2)} % fall, up to {number(values[-1], 3)} ms"
    groups = [[*rows] for over, rows in groupby(range(len(parts)), lambda k: parts[k] > limit) if over]
    return f"more than {limit:g} % fall {joined([_span(values, rows) for rows in groups])}"


def _span(values: Sequence[float], rows: Sequence[int]) -> str:
    """These rows of the values [ms] in words."""
    first, last = (number(values[k], 3) for k in (rows[0], rows[-1]))
    if rows[0] == 0:
        return f"up to {last} ms" if rows[-1] < len(values) - 1 else "everywhere"
    if rows[-1] == len(values) - 1:
        return f"from {first} ms on"
    return f"at {first} ms" if first == last else f"from {first} to {last} ms"
