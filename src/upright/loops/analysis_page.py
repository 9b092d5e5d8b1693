"""The page of an `Analysis`: whether the loop is stable, which margin is the thinnest, and where it is broken."""

from __future__ import annotations

import functools
import math
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
TARGETS = 5  # margins that textbooks ask for
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
        Say("{controller} holds {robot} near rest", controller=analysis.controller, robot=analysis.robot),
        verdict=_verdict(analysis), lead=[_margins(analysis), *_drawn(analysis)], numbers=_numbers(analysis),
        picture=_reached(analysis), next=[_next(analysis)],
        blocks=[
            *([first] if first else []), _targets(analysis), frequency,
            Fold(Say("All margins"), [_places(analysis), _whole(analysis)]),
            Fold(Say("Closed-loop poles"), [_poles(analysis), near]),
        ],
        origin=facts,
    )  # fmt: skip


def _drawn(analysis: Analysis) -> list[Say]:
    """How many of the robots that the file allows are held too."""
    n = len(analysis.radii)
    if not n:
        return []
    if analysis.fell:
        return [Say("Of {n} similar robots {fell} are not held.", n=n, fell=analysis.fell)]
    return [Say("It holds all of {n} similar robots.", n=n)]


def _margins(analysis: Analysis) -> Say:
    """Which margin comes nearest to its limit; where that is the delay, which is shown anyway, how many are usual."""
    least = analysis.thinnest
    place = place_of(least.channel)
    if least.kind == "delay" and math.isinf(least.size):
        return Say("Any delay and any gain leave it stable.")
    if least.kind == "delay":
        if _met(analysis) == TARGETS:
            return Say("All margins reach what textbooks ask.")
        return Say("{met} of 5 margins reach what textbooks ask. A certificate asks less: it decides by falls.",
                   met=_met(analysis))  # fmt: skip
    change = Quantity(least.size, "fraction", digits=2)
    if least.kind == "stronger":
        return Say("The thinnest margin: a signal {change} stronger at {place}.", change=change, place=place)
    return Say("The thinnest margin: a signal {change} weaker at {place}.", change=change, place=place)


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
    why = Say("It pushes similar robots, and counts falls.")
    if _met(analysis) < TARGETS and analysis.controller != ROOMY:
        why = Say("It counts falls of similar robots. If too many fall, `upright design hinf` has larger margins.")
    return Next("certify", analysis.controller, robot=analysis.robot, why=why)


def _gains(low: float, high: float) -> Quantity:
    """Whole per cent, never more than there is."""
    most = math.floor(100 * high) / 100 if high < MOST_GAIN else None
    return Quantity(None, "fraction", low=math.ceil(100 * low) / 100, high=most)


def _numbers(analysis: Analysis) -> list[KeyNumber]:
    both = analysis.both()
    first = analysis.weakest
    return [
        KeyNumber(delay_of(first.delay), Say("more delay at {place} makes it unstable", place=place_of(first.channel))),
        KeyNumber(_gains(both.gain_low, both.gain_high), Say("of the motors' strength keep it stable")),
        KeyNumber(Quantity(both.phase, "rad", digits=2), Say("phase margin at both motors")),
    ]


def _reached(analysis: Analysis) -> Picture:
    """Each margin over what textbooks ask of it."""
    claim = Say("{met} of 5 margins reach what textbooks ask", met=_met(analysis))
    note = Say("A stable loop with less is easily upset; a certificate counts how often.")
    return Picture(claim, functools.partial(_draw_reached, analysis), note)


def _draw_reached(analysis: Analysis) -> Figure:
    from upright.plotting import bars

    parts: dict[str, float] = analysis.reached
    most = [100 * min(part, FAR) for part in parts.values()]
    names = [str(REACHED[name]) for name in parts]
    figure = bars(names, most, str(Say("of what textbooks ask [%]")), str(Say("margin")), limit=100.0, digits=2)
    figure.axes[0].texts[-1].set_text(str(Say("textbooks")))
    return figure


FAR = 3.0  # times a target: how far beyond matters no more
REACHED = {
    "distance from −1": Say("distance from −1"), "phase margin": Say("phase margin"),
    "motors stronger": Say("motors stronger"), "motors weaker": Say("motors weaker"),
    "delay margin": Say("delay margin"),
}  # fmt: skip


def _targets(analysis: Analysis) -> Table:
    """Each margin beside what a certificate asks for, and what textbooks do."""
    both = analysis.both()
    first = analysis.weakest
    enough = Quantity(LEAST_GAIN, "fraction")
    rows = [
        [Say("delay at {place}", place=place_of(first.channel)), delay_of(first.delay),
         Quantity(LEAST_DELAY * analysis.period, "s"), Quantity(analysis.period, "s")],
        [Say("motors stronger"), _change(both.gain_high - 1), enough, Quantity(STRONG - 1, "fraction")],
        [Say("motors weaker"), _change(1 - both.gain_low), enough, Quantity(1 - WEAK, "fraction")],
        [Say("phase margin"), Quantity(both.phase, "rad", digits=2), None, Quantity(math.radians(PHASE), "rad")],
        [Say("distance of the Nyquist curve from −1"), Quantity(1 / both.Ms, "1", digits=2), None,
         Quantity(CLOSE, "1")],
    ]  # fmt: skip
    columns = [
        Column(Say("margin")),
        Column(Say("value")),
        Column(Say("certificate asks")),
        Column(Say("textbooks ask")),
    ]
    return Table(columns, rows)


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
