"""The page of an `Analysis`: margins in words and numbers, Bode and Nyquist of the broken loop, poles."""

from __future__ import annotations

import math

import numpy as np

from upright.certify.analysis import Analysis
from upright.certify.design import Designed
from upright.certify.margins import Margins
from upright.errors import InvalidController
from upright.plotting import AXIS, COLOURS, legend, rows_of
from upright.report.figure import Figure
from upright.report.page import Cell, Item, Page, Section, Table, Verdict, cell_text
from upright.tables import sentence


def page_of(result: Analysis | Designed) -> Page:
    """The page of an analysis, or of a design's; raises `InvalidController` for a design without one."""
    if isinstance(result, Designed):
        if not result.analysis:
            raise InvalidController(f"no report: {result.remark}", expected="a controller that is linear near rest")
        return page_of(result.analysis)
    analysis = result
    words = analysis.words()
    first = sentence(words[0], "")
    margins = [*words[2:3], *_margins(analysis)] if analysis.stable else _margins(analysis)
    sections = [Section("All margins", margins, folded=analysis.stable)]
    if analysis.stable:
        both = analysis.both()
        last = f"Bode diagram: beyond {both.crossover:.3g} rad/s the gain stays below 1, the dashed line"
        bode = Figure(last, analysis.plot(), _BODE)
        drawn = [_nyquist(analysis), bode, *_where(analysis)]
        first_lost = _delayed_first(analysis)
        sections = [*([Section("The loop at one sensor", first_lost, folded=True)] if first_lost else []), *sections]
        sections = [Section("Frequency response", drawn), *sections]
        near = Figure(f"The {SLOW} slowest poles, near 1", analysis.plot_poles(slow=SLOW), _NEAR)
        sections += [Section("Closed-loop poles", [_poles(analysis), near], folded=True)]
    facts = {"controller": analysis.hash[:12], "period": f"{analysis.period * 1e3:g} ms"}
    return Page(
        _title(analysis), sections, _lead(analysis, first), facts, False, verdict=_verdict(analysis),
        picture=_against_targets(analysis) if analysis.stable else _poles(analysis), numbers=_numbers(analysis),
    )  # fmt: skip


CLOSE = 0.5
"""Distance of the Nyquist curve from −1 below which margins are small: the usual rule, Ms at most 2."""
PHASE, WEAK, STRONG = 30.0, 0.5, 2.0
"""Usual targets: phase margin [°], and the gain of the motors as a factor: 6 dB either side."""


def _title(analysis: Analysis) -> str:
    who = f"{analysis.controller} on {analysis.robot}"
    if not analysis.stable:
        return f"{who}: unstable"
    small = ", with small margins" if 1 / analysis.both().Ms < CLOSE else ""
    return f"{who} is stable{small}: {_lost(analysis)}"


def _lost(analysis: Analysis) -> str:
    """The change that makes the loop unstable and reaches least of its target."""
    both = analysis.both()
    worst = next(name for name, *_ in _targets(analysis) if not name.startswith("distance"))
    if worst.startswith("phase"):
        lead = "lead" if both.leads else "lag"
        return f"a phase {lead} of {cell_text(math.degrees(both.phase), 2)}° tips it over"
    if worst.startswith("motors"):
        gain, way = (both.gain_high, "stronger") if "stronger" in worst else (both.gain_low, "weaker")
        return f"motors {_change(gain)} {way} tip it over"
    return f"{_delay(analysis)} more delay at the {_weakest(analysis)} tips it over"


def _change(gain: float) -> str:
    return f"{abs(100 * (gain - 1)):.0f} %" if gain < MOST_GAIN else f"{gain:.0f} times"


MOST_GAIN = 3.0
"""A gain from which on it is said in times, not in per cent."""


def _verdict(analysis: Analysis) -> Verdict:
    if not analysis.stable:
        return Verdict("unstable", "bad")
    near = 1 / analysis.both().Ms < CLOSE
    return Verdict("stable, small margins", "warn") if near else Verdict("stable", "good")


def _weakest(analysis: Analysis) -> str:
    """The loop that a delay makes unstable first; all loops at once are those of the motors."""
    return analysis.weakest.channel if analysis.weakest.delay <= analysis.delay else "motors"


def _delay(analysis: Analysis) -> str:
    return _milliseconds(min(analysis.delay, analysis.weakest.delay))


def _lead(analysis: Analysis, first: str) -> str:
    """What is small, and what to run next."""
    if not analysis.stable:
        return sentence(first, "")
    targets = _targets(analysis)
    short = [name for name, _, _, part in targets if part < 1]
    unstable = int((analysis.radii >= 1).sum())
    of = (
        f" Of {len(analysis.radii)} simulated robots, as different as the robot's file allows, {unstable or 'none'} "
        f"{'is' if unstable <= 1 else 'are'} unstable."
        if len(analysis.radii)
        else ""
    )
    below = f"Below the usual target: {', '.join(short)}." if short else "All margins reach the usual targets."
    if len(short) == len(targets):
        below = f"All {len(targets)} margins are below the usual targets."
    here = f"--robot {analysis.robot}"
    after = f"`upright certify {analysis.controller} {here}` pushes such robots and counts falls."
    if 1 / analysis.both().Ms < CLOSE and analysis.controller != ROOMY:
        after = f"`upright design {ROOMY} {here}` often has larger margins; or keep this one: {after}"
    return f"{below}{of} Next: {after}"


ROOMY = "hinf"
"""The method that is made for margins: its gain and phase margins are larger than those of lqg on every preset but
twipr."""


def _targets(analysis: Analysis) -> list[tuple[str, str, str, float]]:
    """Name, value, usual target, and the part of the target that is reached, the least first; gains are compared in
    decibels."""
    both, delay = analysis.both(), min(analysis.delay, analysis.weakest.delay)
    low, high = (20 * math.log10(max(gain, 1e-3)) for gain in (both.gain_low, both.gain_high))
    least, most = 20 * math.log10(WEAK), 20 * math.log10(STRONG)
    targets = [
        ("distance from −1", cell_text(1 / both.Ms, 2), f"{CLOSE:g}", 1 / both.Ms / CLOSE),
        ("phase margin", f"{cell_text(math.degrees(both.phase), 2)}°", f"{PHASE:g}°", math.degrees(both.phase) / PHASE),
        (f"motors stronger, {_change(both.gain_high)}", _decibels(high), f"{_decibels(most)} dB", high / most),
        (f"motors weaker, {_change(both.gain_low)}", _decibels(low), f"{_decibels(least)} dB", low / least),
        (f"delay margin, {_weakest(analysis)}", _delay(analysis), f"{1e3 * analysis.period:g} ms",
         delay / analysis.period),
    ]  # fmt: skip
    return sorted(targets, key=lambda target: target[-1])


def _decibels(gain: float) -> str:
    """A gain [dB], cut where no robot reaches it."""
    return cell_text(gain, 2) if abs(gain) < MOST_DECIBELS else "> 40"


MOST_DECIBELS = 40.0


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
    return Figure(f"{met} of {len(parts)} margins reach the usual target", legend(figure), _DECIBELS)


_DECIBELS = "Both motors together: 6 dB is twice as strong, −6 dB half. Distance from −1: in the Nyquist diagram."
_BODE = (
    "The loop is broken at both motors at once. The coloured lines are the margins, each at the frequency that sets it."
)
_NEAR = "The part of the diagram above that decides how slowly the robot comes to rest."
SLOW = 6  # poles near 1 that are drawn enlarged: as many as the robot has states


def _where(analysis: Analysis) -> list[Item]:
    """Each margin of both motors with the frequency that sets it, and why a sensor alone bears less delay."""
    both, first, lead = analysis.both(), analysis.weakest, "lead" if analysis.both().leads else "lag"
    rows: list[list[Cell]] = [
        ["motors weaker, to [%]", 100 * both.gain_low, both.gain_low_at],
        ["motors stronger, to [%]", 100 * both.gain_high, both.gain_high_at],
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
    first, name = analysis.weakest, _weakest(analysis)
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
    both, first = analysis.both(), analysis.weakest
    gains = (
        f"{100 * both.gain_low:.0f} to {100 * both.gain_high:.0f} %",
        f"strength of the motors that stays stable; the target is {100 * WEAK:.0f} to {100 * STRONG:.0f} %",
    )
    if "stronger" in _lost(analysis):  # which the title says
        gains = (_change(both.gain_low), f"weaker motors tip it over too; the target is {100 * WEAK:.0f} %")
    more = f"more delay at the {_weakest(analysis)} tips it over; a period is {1e3 * analysis.period:g} ms"
    if first.delay < analysis.delay:
        more = f"more delay at the {first.channel} tips it over, {_milliseconds(both.delay)} at both motors; "
        more += f"the target is {1e3 * analysis.period:g} ms"
    return [
        gains,
        (f"{cell_text(math.degrees(both.phase), 2)}°", _phase(both)),
        (_delay(analysis), more),
    ]


def _milliseconds(seconds: float) -> str:
    return f"{cell_text(1e3 * seconds, 3)} ms"


def _phase(both: Margins) -> str:
    return f"phase margin, until more {'lead' if both.leads else 'lag'} tips it over; the target is {PHASE:g}°"


def _margins(analysis: Analysis) -> list[Item]:
    rows: list[list[Cell]] = [_row(m) for m in (*analysis.inputs, *analysis.outputs)]
    header = ["broken at", "gain from", "gain to", "phase [°]", "delay [ms]", "disk α", "Ms", "Mt"]
    numbers: list[list[Cell]] = [
        ["disk α of both motors at once", analysis.disk],
        ["b(P, C), stability margin of the normalised coprime factors", analysis.coprime],
        ["largest ν-gap of the drawn robots", analysis.gap],
        ["largest |pole|", float(np.abs(analysis.poles).max())],
        ["largest |pole| of the drawn robots", float(analysis.radii.max()) if len(analysis.radii) else math.nan],
    ]
    if analysis.mu:
        numbers.append(["μ over the parameters, at least", analysis.mu.lower])
        numbers.append(["μ over the parameters, at most", analysis.mu.upper])
    return [
        Table(header, rows, "One loop broken, all others closed", 3),
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
    title = f"Nyquist diagram: the least distance from −1 is {1 / analysis.both().Ms:.2f}; the target is {CLOSE:g}"
    turns = analysis.turns()
    often = {1: "once", 2: "twice"}.get(turns, f"{turns} times")
    poles = f"{turns} unstable pole{'' if turns == 1 else 's'}"
    count = (
        f" Broken there it has {poles}. Closed it is stable, since both halves together go round −1 {often}, "
        "anticlockwise."
    )
    note = "The loop is broken at both motors at once. Solid and dotted half meet far out, at lower frequencies."
    return Figure(title, analysis.plot_nyquist(), note + (count if turns else ""))


def _poles(analysis: Analysis) -> Figure:
    unstable = int((analysis.radii >= 1).sum())
    inside = "All poles lie inside the circle" if analysis.stable else "A pole lies outside the circle"
    return Figure(f"{inside}; {unstable} of {len(analysis.radii)} drawn robots are unstable", analysis.plot_poles())
