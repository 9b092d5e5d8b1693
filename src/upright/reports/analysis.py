"""The page of an `Analysis`: margins in words and numbers, Bode and Nyquist of the broken loop, poles."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.arrays import Array
from upright.certification.design import Designed
from upright.certification.verdict import CLOSE, PHASE, STRONG, WEAK, reached
from upright.control import AnglePid
from upright.errors import InvalidController
from upright.loops.analysis import ROUNDED, Analysis, instability
from upright.loops.margins import Margins
from upright.plotting import AXIS, COLOURS, legend, rows_of
from upright.reports.designed import controller_section, let_go, tile
from upright.reports.figure import Figure
from upright.reports.page import Cell, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import joined


def page_of(result: Analysis | Designed) -> Page:
    """The page of an analysis, or of a design's; raises `InvalidController` for a design without one."""
    if isinstance(result, Analysis):
        return _page(result, [], [])
    if not result.analysis:
        raise InvalidController(f"no report: {result.remark}", expected="a controller that is linear near rest")
    if not result.analysis.stable:
        return _page(result.analysis, [], [controller_section(result)])
    run = result.let_go()
    return _page(result.analysis, [let_go(run)], [controller_section(result)], [tile(run)])


def _page(
    analysis: Analysis, before: Sequence[Section], after: Sequence[Section], more: Sequence[tuple[str, str]] = ()
) -> Page:
    """The page with sections `before` and `after` the frequency response, and `more` numbers."""
    words = analysis.words()
    margins = [*words[2:3], *_margins(analysis)] if analysis.stable else _margins(analysis)
    sections = [*after, Section("All margins", margins, folded=analysis.stable)]
    if analysis.stable:
        bode = Figure(_bode_title(analysis), analysis.plot(), _bode_note(analysis))
        drawn = [_nyquist(analysis), bode, *_where(analysis)]
        first_lost = _delayed_first(analysis)
        sections = [*([Section("The loop at one sensor", first_lost, folded=True)] if first_lost else []), *sections]
        sections = [*before, Section("Frequency response", drawn), *sections]
        near = Figure(f"The {SLOW} slowest poles, near 1", analysis.plot_poles(slow=SLOW), _NEAR)
        sections += [Section("Closed-loop poles", [_poles(analysis), near], folded=True)]
    facts = {"controller": analysis.hash[:12], "period": f"{analysis.period * 1e3:g} ms"}
    return Page(
        _title(analysis), sections, _lead(analysis), facts, False, verdict=_verdict(analysis),
        picture=_against_targets(analysis) if analysis.stable else _poles(analysis),
        numbers=[*_numbers(analysis), *more],
    )  # fmt: skip


def _title(analysis: Analysis) -> str:
    who = f"{analysis.controller} on {analysis.robot}"
    if not analysis.stable:
        return f"{who}: {instability(analysis.radius, analysis.period)}"
    small = ", with small margins" if 1 / analysis.both().Ms < CLOSE else ""
    return f"{who} is stable{small}: {_lost(analysis)}"


def _lost(analysis: Analysis) -> str:
    """The change that makes the loop unstable and reaches least of its target."""
    both = analysis.both()
    worst = next(name for name, *_ in _targets(analysis) if not name.startswith("distance"))
    if worst.startswith("phase"):
        return f"{_lead_or_lag(both)} makes it unstable"
    if worst.startswith("motors"):
        gain, way = (both.gain_high, "stronger") if "stronger" in worst else (both.gain_low, "weaker")
        return f"motors {_change(gain)} {way} make it unstable"
    return f"{_delay(analysis)} more delay at {_place(analysis)} makes it unstable"


def _lead_or_lag(both: Margins) -> str:
    return f"{cell_text(math.degrees(both.phase), 2)}° more {'lead' if both.leads else 'lag'}"


def _change(gain: float) -> str:
    """A gain's difference from 1 [%], which is said only so far."""
    return f"{abs(100 * (gain - 1)):.0f} %" if gain < MOST_GAIN else f"> {100 * (MOST_GAIN - 1):.0f} %"


MOST_GAIN = 11.0
"""A gain from which on it is not said how large: no motor is so much stronger."""


def _verdict(analysis: Analysis) -> Verdict:
    if not analysis.stable:
        return Verdict("position free", "warn") if analysis.radius <= 1 + ROUNDED else Verdict("unstable", "bad")
    near = 1 / analysis.both().Ms < CLOSE
    return Verdict("stable, small margins", "warn") if near else Verdict("stable", "good")


def _weakest(analysis: Analysis) -> str:
    """The loop that a delay makes unstable first; all loops at once are those of the motors."""
    return analysis.weakest.channel if analysis.weakest.delay <= analysis.delay else "motors"


def _place(analysis: Analysis) -> str:
    name = _weakest(analysis)
    return name if name == "both motors" else f"the {name}"


def _delay(analysis: Analysis) -> str:
    return _milliseconds(min(analysis.delay, analysis.weakest.delay))


def _lead(analysis: Analysis) -> str:
    """What is small, whether it matters, and what to run next."""
    if not analysis.stable:
        return f"{_drawn(analysis, []).strip()} Next: {_instead(analysis)}"
    targets = _targets(analysis)
    short = [name for name, _, _, part in targets if part < 1]
    below = f"Below the usual target: {', '.join(short)}." if short else "All margins reach the usual targets."
    if len(short) == len(targets):
        below = f"All {len(targets)} margins are below the usual targets."
    return f"{below}{_drawn(analysis, short)} Next: {_next(analysis)}"


def _drawn(analysis: Analysis, short: Sequence[str]) -> str:
    """How many of the drawn robots are unstable, and how much their motors differ where that is why."""
    count = len(analysis.radii)
    both = analysis.both()
    if not count:
        return ""
    unstable = bool(analysis.fell)
    usual = float(np.quantile(np.abs(analysis.strengths - 1), 0.95))
    words = f" {'Yet of' if short and not unstable else 'Of'} {count} simulated robots {analysis.lost}"
    motors = any(name.startswith("motors") for name in short)
    if unstable or not motors or not 0 < usual < min(both.gain_high - 1, 1 - both.gain_low):
        return f"{words}."
    return f"{words}: the motors of 95 % of them differ by at most {100 * usual:.0f} %."


def _next(analysis: Analysis) -> str:
    here = f"--robot {analysis.robot}"
    decides = f"`upright certify {analysis.controller} {here}`"
    roomy = f"`upright design {ROOMY} {here}`"
    small = 1 / analysis.both().Ms < CLOSE or analysis.fell
    if not small or analysis.controller == ROOMY:
        return f"Let {decides} decide: it pushes such robots and counts falls."
    if analysis.fell:
        return f"Try {roomy}: its margins are often larger. `upright certify` decides on either."
    return f"Keep it if {decides} is green. If not, try {roomy}: its margins are often larger."


def _instead(analysis: Analysis) -> str:
    """What would hold the robot."""
    if analysis.controller == AnglePid.form:
        return "Leave `--gains` out: gains that hold it are then searched."
    return f"`upright design lqg --robot {analysis.robot}` designs a controller that holds it."


ROOMY = "hinf"
"""The method that is made for margins: its gain and phase margins are larger than those of lqg on every preset but
twipr."""


def _targets(analysis: Analysis) -> list[tuple[str, str, str, float]]:
    """Name, value, usual target, and the part of the target that is reached, the least first."""
    both = analysis.both()
    delay = min(analysis.delay, analysis.weakest.delay)
    shown = {
        "distance from −1": (cell_text(1 / both.Ms, 2), f"{CLOSE:g}"),
        "phase margin": (f"{cell_text(math.degrees(both.phase), 2)}°", f"{PHASE:g}°"),
        "motors stronger": (_change(both.gain_high), _change(STRONG)),
        "motors weaker": (_change(both.gain_low), _change(WEAK)),
        "delay margin": (_delay(analysis), f"{1e3 * analysis.period:g} ms"),
    }
    place = f" ({_weakest(analysis).removeprefix('both ')})"
    targets = [
        (f"{name}{place if name == 'delay margin' else ''}", *shown[name], part)
        for name, part in reached(both, delay, analysis.period).items()
    ]
    return sorted(targets, key=lambda target: target[-1])


def _against_targets(analysis: Analysis) -> Figure:
    """Each margin as a part of its usual target."""
    targets = _targets(analysis)
    names = [f"{name}: {value} of {target}" for name, value, target, _ in targets]
    figure, ax = rows_of(names, "part of the usual target [%]", "margin")
    parts = np.array([100 * min(part, 2.0) for *_, part in targets])
    for label, kept, colour in (("reaches the target", parts >= 100, 2), ("too small", parts < 100, 1)):
        if kept.any():
            ax.barh(np.flatnonzero(kept), parts[kept], height=0.6, color=COLOURS[colour], label=label)
    ax.axvline(100, linestyle="--", linewidth=1.2, color=AXIS, label="usual target")
    ax.set_xlim(0, max(110.0, 1.05 * parts.max()))
    met = int((parts >= 100).sum())
    return Figure(f"{met} of {len(parts)} margins reach the usual target", legend(figure), _BOTH)


_BOTH = "Motors: both together. Distance from −1: in the Nyquist diagram."


def _bode_title(analysis: Analysis) -> str:
    """The two margins that reach least of their targets, among those of gain and phase."""
    both = analysis.both()
    turns = f"{_lead_or_lag(both)} at {cell_text(both.phase_at, 3)} rad/s"
    changes = {
        "phase margin": (both.phase_at, turns),
        "motors stronger": (both.gain_high_at, _gain(both.gain_high, "more", both.gain_high_at)),
        "motors weaker": (both.gain_low_at, _gain(both.gain_low, "less", both.gain_low_at)),
    }
    named = [changes[name] for name, *_ in _targets(analysis) if name in changes]
    small = [words for at, words in named if at > 0][:2]
    return f"Bode diagram: {' or '.join(small)} makes it unstable" if small else "Bode diagram"


def _gain(gain: float, way: str, at: float) -> str:
    return f"{_change(gain)} {way} gain at {cell_text(at, 3)} rad/s"


def _bode_note(analysis: Analysis) -> str:
    both = analysis.both()
    note = "The loop is broken at both motors at once. The coloured lines are the margins, each at its frequency."
    if both.gain_high_at < ROLLS:
        swing = cell_text(2 * math.pi / both.gain_high_at, 2)
        note += f" With motors stronger than that it rolls to and fro ever wider, every {swing} s."
    return note


ROLLS = 1.0
"""[rad/s] Below it a swing is mostly one of the wheels: at rest on average, they roll ψ g/ω², 17 cm or more for 1°."""
_NEAR = "The part of the diagram above that decides how slowly the robot comes to rest."
SLOW = 6  # poles near 1 that are drawn enlarged: as many as the robot has states


def _where(analysis: Analysis) -> list[Item]:
    """Each margin of both motors with the frequency that sets it, and why a sensor alone bears less delay."""
    both = analysis.both()
    first = analysis.weakest
    lead = "lead" if analysis.both().leads else "lag"
    rows: list[list[Cell]] = [
        ["motors weaker by [%]", 100 * (1 - both.gain_low), both.gain_low_at],
        ["motors stronger by [%]", 100 * (both.gain_high - 1), both.gain_high_at],
        [f"phase margin, by a {lead} [°]", math.degrees(both.phase), both.phase_at],
        ["delay of both motors' commands [ms]", 1e3 * both.delay, both.delay_at],
    ]
    words: list[Item] = []
    if first in analysis.outputs and first.delay < both.delay:
        rows.append([f"delay of the {first.channel} alone [ms]", 1e3 * first.delay, first.delay_at])
        if first.delay_at > both.delay_at:
            words = [
                f"The loop through the {first.channel} alone is quicker ({cell_text(first.delay_at, 3)} rad/s) than "
                f"that through both motors ({cell_text(both.delay_at, 3)} rad/s): a quicker loop bears less delay."
            ]
    return [Table(["margin", "value", "at [rad/s]"], rows, "What sets each margin", 3), *words]


def _delayed_first(analysis: Analysis) -> list[Figure]:
    """The loop that a delay makes unstable first, where that is a sensor's."""
    first = analysis.weakest
    name = _weakest(analysis)
    if first not in analysis.outputs or name != first.channel or not first.delay_at > 0:
        return []
    title = f"{_delay(analysis)} more delay at the {name} makes the loop unstable"
    rule = first.phase / first.phase_at
    note = (
        f"The loop is broken at the {name} alone. A delay there uses up the phase margin of "
        f"{cell_text(math.degrees(first.phase), 3)}° at {cell_text(first.phase_at, 3)} rad/s: "
        f"{cell_text(1e3 * rule, 3)} ms if it were a lag of phase alone."
    )
    if first.delay < 0.97 * rule:
        note += f" In the sampled loop a part of a period does more than that, so {_delay(analysis)} are enough."
    return [Figure(title, analysis.plot(name), note)]


def _numbers(analysis: Analysis) -> list[tuple[str, str]]:
    if not analysis.stable:
        return []
    both = analysis.both()
    gains = (
        f"−{_change(both.gain_low)} to +{_change(both.gain_high)}".replace(" %", "", 1).replace("+>", ">"),
        f"change of the motors' strength that it survives; target: −{_change(WEAK)} to +{_change(STRONG)}",
    )
    if "stronger" in _lost(analysis):  # which the title says
        gains = (_change(both.gain_low), f"weaker motors make it unstable too; target: {_change(WEAK)}")
    more = f"more delay at {_place(analysis)} makes it unstable; target: {1e3 * analysis.period:g} ms"
    return [
        gains,
        (f"{cell_text(math.degrees(both.phase), 2)}°", _phase(both)),
        (_delay(analysis), more),
    ]


def _milliseconds(seconds: float) -> str:
    return f"{cell_text(1e3 * seconds, 3)} ms"


def _phase(both: Margins) -> str:
    return f"phase margin: so much more {'lead' if both.leads else 'lag'} makes it unstable; target: {PHASE:g}°"


def _margins(analysis: Analysis) -> list[Item]:
    rows: list[list[Cell]] = [_row(m) for m in (*analysis.inputs, *analysis.outputs)] if analysis.stable else []
    header = ["broken at", "gain from", "gain to", "phase [°]", "delay [ms]", "disk α", "Ms", "Mt"]
    numbers: list[list[Cell]] = [
        ["disk α of both motors at once", analysis.disk],
        ["b(P, C), stability margin of the normalised coprime factors", analysis.coprime],
        ["largest ν-gap of the drawn robots", analysis.gap],
        ["largest |pole|", float(np.abs(analysis.poles).max())],
        ["largest |pole| of the drawn robots", float(analysis.radii.max()) if len(analysis.radii) else math.nan],
    ]
    return [
        *([Table(header, rows, "One loop broken, all others closed", 3)] if rows else ["Unstable: no margins."]),
        Table(["", "value"], numbers, "The whole loop", 3),
        *([_GAP] if analysis.gap >= analysis.coprime else []),
    ]


_GAP = (
    "Every robot with a ν-gap below b(P, C) is stable for certain; one with a larger gap may be stable or not. "
    "Here the largest gap is larger. So this rule does not decide, and the poles of the drawn robots do."
)


def _row(m: Margins) -> list[Cell]:
    return [m.channel, m.gain_low, m.gain_high, math.degrees(m.phase), m.delay * 1e3, m.disk, m.Ms, m.Mt]


def _nyquist(analysis: Analysis) -> Figure:
    near = f"{1 / analysis.both().Ms:.2f}"
    title = f"Nyquist diagram: the curve comes as near to −1 as {near}; the target is {CLOSE:g}"
    side = "right" if analysis.far() > 0 else "left"
    note = (
        f"The loop is broken at both motors at once. It is nearest to −1 at {cell_text(analysis.nearest_at(), 3)} "
        f"rad/s. Far out, at lower frequencies, both halves meet on the {side}. {_count(analysis)}"
    )
    return Figure(title, analysis.plot_nyquist(), note)


def _count(analysis: Analysis) -> str:
    """The unstable poles of the opened loop, whose they are, and how often a stable loop's curve goes round −1."""
    turns = analysis.turns()
    if not turns:
        return "So opened, it has no unstable pole. A stable loop then does not go round −1."
    often = {1: "once", 2: "twice"}.get(turns, f"{turns} times")
    names = ("the robot's", "the controller's own", "those of the loops left closed")
    owners = zip(names, analysis.unstable(), strict=True)
    whose = [f"{name} ({_rates(rates)} 1/s)" for name, rates in owners if len(rates)]
    many = "1 unstable pole" if turns == 1 else f"{turns} unstable poles"
    return (
        f"So opened, it has {many}: {joined(whose)}. "
        f"A stable loop then goes round −1 {often}, anticlockwise, as both halves together do."
    )


def _rates(rates: Array) -> str:
    return joined([cell_text(float(rate), 3) for rate in np.sort(rates)])


def _poles(analysis: Analysis) -> Figure:
    inside = "All poles lie inside the circle" if analysis.stable else "A pole lies outside the circle"
    return Figure(f"{inside}; of {len(analysis.radii)} simulated robots {analysis.lost}", analysis.plot_poles())
