"""The page of an `Analysis`: whether the loop is stable, which margin is the thinnest, and where it is broken."""

from __future__ import annotations

import functools
import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from upright.loops.margins import disk_gain, disk_phase
from upright.loops.places import delay_of, place_of
from upright.loops.targets import CLOSE, LEAST_DELAY, LEAST_GAIN, PHASE, STRONG, WEAK
from upright.pages import Block, Column, Fold, KeyNumber, Next, Page, Picture, Quantity, Say, Table, Verdict

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.loops.margins import Margins

Analysis = Any  # that of `analysis.py`, which imports this file

ROOMY = "hinf"
"""The method that is made for margins: its gain and phase margins are larger than those of lqg on every preset but
twipr."""
BY_HAND = "pid-angle"  # searches its gains where none are given
TARGETS = 5  # margins with a usual target of textbooks
MOST_GAIN = 11.0  # from here on it is not said how large a gain may be: no motor is so much stronger
SLOW = 6  # poles near 1 that are drawn enlarged: as many as the robot has states


def analysis_page(analysis: Analysis, first: Picture | None = None) -> Page:
    """The page of a controller's loop, with a picture of the robot let go where there is one, `first`."""
    facts = {"controller": analysis.controller, "robot": analysis.robot, "hash": analysis.hash[:12]}
    if not analysis.stable:
        return Page(
            _unheld(analysis), verdict=_verdict(analysis), lead=_drawn(analysis), picture=first or _poles(analysis),
            next=[_next(analysis)], blocks=[Fold(Say("All margins"), [_whole(analysis)])], origin=facts,
        )  # fmt: skip
    bode = _bode(analysis)
    frequency = Fold(Say("Frequency response"), [bode, _nyquist(analysis), *_alone(analysis)])
    near = Picture(Say("The {n} slowest poles, near 1", n=SLOW), functools.partial(analysis.plot_poles, slow=SLOW))
    return Page(
        _title(analysis), verdict=_verdict(analysis), lead=_lead(analysis), numbers=_numbers(analysis),
        picture=_reached(analysis), next=[_next(analysis)],
        blocks=[
            _targets(analysis), *([first] if first else []), frequency,
            Fold(Say("All margins"), [_places(analysis), _whole(analysis)]),
            Fold(Say("Closed-loop poles"), [_poles(analysis), near]),
        ],
        origin=facts,
    )  # fmt: skip


def _title(analysis: Analysis) -> Say:
    """That it holds, and whom not; or what reaches least of its usual target."""
    facts = {"controller": analysis.controller, "robot": analysis.robot}
    if analysis.fell:
        return Say(
            "{controller} holds {robot}, but not {fell} of {n} similar robots",
            fell=analysis.fell,
            n=len(analysis.radii),
            **facts,
        )
    if _met(analysis) == TARGETS:
        return Say("{controller} holds {robot} with room to spare", **facts)
    least = min(analysis.reached, key=lambda name: analysis.reached[name])
    place = place_of(analysis.weakest.channel)
    return TITLES[least].about(**facts, size=_five(analysis)[least].value, place=place)


TITLES = {
    "motors stronger": Say("{controller} holds {robot}, unless its motors are {size} stronger"),
    "motors weaker": Say("{controller} holds {robot}, unless its motors are {size} weaker"),
    "delay margin": Say("{controller} holds {robot}, unless {place} is {size} later"),
    "phase margin": Say("{controller} holds {robot}, with a phase margin of {size}"),
    "distance from −1": Say("{controller} holds {robot}; its Nyquist curve is {size} from −1"),
}
"""The margin that reaches least of its usual target → the title of a loop that holds."""


def _drawn(analysis: Analysis) -> list[Say]:
    """How many of the robots that the file allows are held too."""
    n = len(analysis.radii)
    if not n:
        return []
    if analysis.fell:
        return [Say("It does not hold {fell} of {n} similar robots.", n=n, fell=analysis.fell)]
    return [Say("It holds all of {n} similar robots.", n=n)]


def _lead(analysis: Analysis) -> list[Say]:
    """Which margin is too thin for a certificate, or how many are usual; and who else is held, but for the title."""
    least = analysis.thinnest
    met = _met(analysis)
    n = len(analysis.radii)
    others = [] if analysis.fell else _drawn(analysis)
    if least.thin and least.kind != "delay":  # that of a delay is among the numbers
        facts = {"change": Quantity(least.size, "fraction", digits=2), "place": place_of(least.channel)}
        thin = Say("The thinnest margin: a gain {change} lower at {place} makes the loop unstable.", **facts)
        if least.kind == "stronger":
            thin = Say("The thinnest margin: a gain {change} higher at {place} makes the loop unstable.", **facts)
        return [thin, *others]
    if n and met < TARGETS and not analysis.fell:
        return [Say("{met} of 5 margins at their usual target, yet all of {n} similar robots are held.", met=met, n=n)]
    return [Say("{met} of 5 margins at their usual target.", met=met), *others]


def _unheld(analysis: Analysis) -> Say:
    """Why the loop has no margins."""
    if analysis.free:
        return Say("Nothing holds its position or its heading")
    doubled = analysis.period * math.log(2) / math.log(analysis.radius)
    return Say("Unstable: a small deviation doubles every {time}", time=Quantity(doubled, "s", digits=2))


def _verdict(analysis: Analysis) -> Verdict:  # noqa: PLR0911
    """By what a certificate asks of the nominal loop, and the drawn robots."""
    if analysis.free:
        return Verdict(Say("it may roll or turn away"), "warn")
    if not analysis.stable:
        return Verdict(Say("unstable"), "bad")
    if analysis.loop.hidden:
        rolls = "wheel" in analysis.loop.hidden
        return Verdict(Say("stable, but may roll away") if rolls else Say("stable, but may turn away"), "warn")
    if analysis.fell:
        return Verdict(Say("stable, but not every robot"), "warn")
    if analysis.thinnest.thin:
        return Verdict(Say("stable, a margin is thin"), "warn")
    if _met(analysis) < TARGETS:
        return Verdict(Say("stable, with small margins"), "warn")
    return Verdict(Say("stable, with usual margins"), "good")


def _next(analysis: Analysis) -> Next:
    unstable = not (analysis.stable or analysis.free)
    if unstable and analysis.controller == BY_HAND:
        why = Say("Without --gains, gains that hold it are searched.")
        return Next("design", BY_HAND, robot=analysis.robot, why=why)
    if unstable:
        return Next("design", "lqg", robot=analysis.robot, why=Say("This method holds the robot."))
    if analysis.stable and (analysis.fell or analysis.thinnest.thin) and analysis.controller != ROOMY:
        return Next("design", ROOMY, robot=analysis.robot, why=Say("Its margins are often larger."))
    why = Say("It pushes similar robots: their falls decide.")
    if _met(analysis) < TARGETS and analysis.controller != ROOMY:
        larger = Next("design", ROOMY, robot=analysis.robot)
        why = Say("It pushes similar robots: their falls decide. If too many fall: `{larger}`.", larger=larger.command)
    return Next("certify", analysis.controller, robot=analysis.robot, why=why)


def _gains(low: float, high: float) -> Quantity:
    """Whole per cent, never more than there is."""
    most = math.floor(100 * high) / 100 if high < MOST_GAIN else None
    return Quantity(None, "fraction", low=math.ceil(100 * low) / 100, high=most)


def _numbers(analysis: Analysis) -> list[KeyNumber]:
    both = analysis.both()
    first = analysis.weakest
    usual = Quantity(analysis.period, "s")
    delay = Say("more delay at {place} makes it unstable; usual: {usual}", place=place_of(first.channel), usual=usual)
    strength = Say("of the motors' strength keep it stable; usual: {usual}", usual=_gains(WEAK, STRONG))
    phase = Say("phase margin at both motors; usual: {usual}", usual=Quantity(math.radians(PHASE), "rad"))
    return [
        KeyNumber(_gains(both.gain_low, both.gain_high), strength),
        KeyNumber(delay_of(first.delay), delay),
        KeyNumber(Quantity(both.phase, "rad", digits=2), phase),
    ]


def _reached(analysis: Analysis) -> Picture:
    """Each margin over its usual target."""
    claim = Say("{met} of 5 margins at their usual target", met=_met(analysis))
    note = Say("Orange: below the target. The motors are those of both sides together.")
    return Picture(claim, functools.partial(_draw_reached, analysis), note)


def _draw_reached(analysis: Analysis) -> Figure:
    from upright.plotting import COLOURS, bars

    parts = sorted(analysis.reached.items(), key=lambda item: item[1])
    known = [_five(analysis)[name] for name, _ in parts]
    names = [str(Say("{margin}, usual {target}", margin=m.name, target=m.target)) for m in known]
    lengths = [100 * min(part, FAR) for _, part in parts]
    figure = bars(names, lengths, str(Say("part of the usual target [%]")), str(Say("margin")), limit=100.0)
    ax = figure.axes[0]
    texts: list[Any] = [*ax.texts]
    *values, limit = texts
    limit.set_text(str(Say("usual")))
    for margin, length, bar, text in zip(known, lengths, ax.patches, values, strict=True):
        bar.set_facecolor(COLOURS[1 if length < 100 else 2])
        text.set_text(str(margin.value))
        text.xy = (max(length, 100.0), text.xy[1])  # not across the line
    ax.set_xlim(0, 1.3 * max(100.0, *lengths))
    return figure


FAR = 1.5  # times a target: how far beyond matters no more


@dataclass(frozen=True)
class _Margin:
    """One of the five, with its usual `target`, and what a certificate asks for."""

    name: Say
    value: Quantity
    certificate: Quantity | None
    target: Quantity


def _five(analysis: Analysis) -> dict[str, _Margin]:
    """The five margins, by their names in `reached`."""
    both = analysis.both()
    first = analysis.weakest
    enough = Quantity(LEAST_GAIN, "fraction")
    return {
        "delay margin": _Margin(
            Say("delay at {place}", place=place_of(first.channel)), delay_of(first.delay),
            Quantity(LEAST_DELAY * analysis.period, "s"), Quantity(analysis.period, "s"),
        ),
        "motors stronger": _Margin(
            Say("motors stronger"), _change(both.gain_high - 1), enough, Quantity(STRONG - 1, "fraction")
        ),
        "motors weaker": _Margin(
            Say("motors weaker"), _change(1 - both.gain_low), enough, Quantity(1 - WEAK, "fraction")
        ),
        "phase margin": _Margin(
            Say("phase margin"), Quantity(both.phase, "rad", digits=2), None, Quantity(math.radians(PHASE), "rad")
        ),
        "distance from −1": _Margin(
            Say("distance from −1 (Nyquist)"), Quantity(1 / both.Ms, "1", digits=2), None, Quantity(CLOSE, "1")
        ),
    }  # fmt: skip


def _targets(analysis: Analysis) -> Table:
    """Each margin beside what a certificate asks for, and its usual target."""
    columns = [
        Column(Say("margin")), Column(Say("value")), Column(Say("certificate asks")),
        Column(Say("usual target")),
    ]  # fmt: skip
    return Table(columns, [[m.name, m.value, m.certificate, m.target] for m in _five(analysis).values()])


def _met(analysis: Analysis) -> int:
    return sum(part >= 1 for part in analysis.reached.values())


def _change(size: float) -> Quantity:
    """Whole per cent, never more than there is."""
    if size < MOST_GAIN - 1:
        return Quantity(math.floor(100 * size) / 100, "fraction")
    return Quantity(None, "fraction", low=MOST_GAIN - 1, digits=2)


def _bode(analysis: Analysis) -> Picture:
    """The loop broken at both motors, with its margins."""
    both = analysis.both()
    claim = Say("Bode diagram at both motors: {phase} of phase margin, gains of {gains}",
                phase=Quantity(both.phase, "rad", digits=2), gains=_gains(both.gain_low, both.gain_high))  # fmt: skip
    return Picture(claim, analysis.plot, Say("Each coloured line is a margin, at the frequency that sets it."))


def _nyquist(analysis: Analysis) -> Picture:
    """The same loop, with how near it comes to −1."""
    near = Quantity(1 / analysis.both().Ms, "1", digits=2)
    claim = Say("The Nyquist curve at both motors comes as near to −1 as {near}", near=near)
    turns = analysis.turns()
    note = Say("Unstable poles of the opened loop, and turns round −1 of a stable one: {turns}", turns=turns)
    return Picture(claim, analysis.plot_nyquist, note)


def _alone(analysis: Analysis) -> list[Block]:
    """The loop that a delay makes unstable first, where that is a sensor's."""
    first = analysis.weakest
    if first not in analysis.outputs:
        return []
    claim = Say(
        "{delay} more delay at {place} alone makes the loop unstable",
        delay=delay_of(first.delay),
        place=place_of(first.channel),
    )
    return [Picture(claim, functools.partial(analysis.plot, first.channel))]


def _places(analysis: Analysis) -> Table:
    columns = [
        Column(Say("broken at")), Column(Say("delay"), "s", 4), Column(Say("weakest"), "fraction"),
        Column(Say("strongest"), "fraction"), Column(Say("phase"), "rad"), Column(Say("disk α"), "1"),
        Column(Say("Ms"), "1"), Column(Say("Mt"), "1"),
    ]  # fmt: skip
    rows = [_row(m) for m in (*analysis.inputs, *analysis.outputs)]
    return Table(columns, rows, Say("One loop broken, all others closed"))


def _row(m: Margins) -> list[Say | str | float]:
    return [place_of(m.channel), m.delay, m.gain_low, m.gain_high, m.phase, m.disk, m.Ms, m.Mt]


def _whole(analysis: Analysis) -> Table:
    rows = [
        [Say("disk α of both motors at once"), analysis.disk],
        [Say("gains of both motors at once"), _gains(*disk_gain(analysis.disk))],
        [Say("phases of both motors at once"), Quantity(None, "rad", high=disk_phase(analysis.disk), digits=2)],
        [Say("b(P, C), stability margin of the normalised coprime factors"), analysis.coprime],
        [Say("largest ν-gap of the drawn robots; those below b(P, C) are stable"), analysis.gap],
        [Say("largest |pole|"), analysis.radius],
        [Say("largest |pole| of the drawn robots"), float(np.max(analysis.radii, initial=0.0))],
    ]
    return Table([Column(Say("the whole loop")), Column(Say("value"), "1", 4)], rows)


def _poles(analysis: Analysis) -> Picture:
    many = len(analysis.radii)
    claim = Say("Poles of the nominal loop, and of {n} drawn robots", n=many)
    return Picture(claim, analysis.plot_poles)
