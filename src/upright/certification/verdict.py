"""The light of a certificate, and its reasons in words and numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import KW_ONLY, dataclass

from upright.certification.checks import CONFIDENCE, MOST_CYCLE, MOST_FALLS, PushTrial, red
from upright.certification.narrowing import MOST_NAMES, Guessed, Narrowing
from upright.certification.standing import UNTRIED, Standing
from upright.control.controller import Controller
from upright.errors import InvalidController
from upright.fleets.binomial import upper_bound
from upright.likelihood.agreement import Agreement
from upright.likelihood.support import Support, contradictions
from upright.loops.analysis import INPUTS, ROUNDED, instability, loop_margins, unseen_in_words
from upright.loops.loop import robot_loop
from upright.loops.margins import Margins, margins
from upright.robots import Kit, Robot
from upright.tables import joined

GREEN, AMBER, RED, UNKNOWN = "green", "amber", "red", "unknown"

LARGER = 2.0  # times the largest of the drawn robots: amber, since noise or model err by more than what was drawn
FAR_LARGER = 5.0  # red: what was certified is another robot

LEAST_GAIN = 0.04  # amber below: copper that warms by 10 K takes 4 % of the motor's gain
LEAST_DELAY = 0.25  # [periods] amber below: a loop that runs in time still jitters by a tenth or two of its period
MOST_SATURATED = 0.25  # amber above: a motor at its end this often is no longer the one the design assumed
MOST_TRAVEL = 1.0  # [m] amber above: it leaves the table

CLOSE = 0.5
"""Distance of the Nyquist curve from −1 below which margins are small: the usual rule, Ms at most 2."""
PHASE, WEAK, STRONG = 30.0, 0.5, 2.0
"""Usual targets: phase margin [°], and the gain of the motors as a factor: 6 dB either side."""


@dataclass(frozen=True)
class LinearMargins:
    """The nominal loop: its largest |pole| `radius`, and the smallest margins of all places where it can be broken.

    It stays stable for gain factors from `gain_low` to `gain_high` [1], and for up to `delay` [s] of further delay, at
    any one motor or reading, or at both motors. Three names say where each of these is the smallest; older
    certificates, which looked at both motors only, leave them empty. So many of the usual targets are `met` (None: not
    computed). What no reading shows of a stable loop is `unseen`, in words.
    """

    radius: float
    gain_low: float
    gain_high: float
    delay: float
    low_at: str = ""
    high_at: str = ""
    delay_at: str = ""
    _: KW_ONLY
    met: int | None = None
    unseen: str = ""

    @property
    def stable(self) -> bool:
        """Whether the nominal loop is."""
        return self.radius < 1 - ROUNDED

    @property
    def free(self) -> bool:
        """Whether a place is: a pole at 1, but for rounding, and none beyond, or one that no reading shows."""
        return bool(self.unseen) or abs(self.radius - 1) <= ROUNDED


def reached(both: Margins, delay: float, period: float) -> dict[str, float]:
    """The part of its usual target that each margin reaches, of both motors and of the least delay of all places: the
    one judgement of margins, in a design, a certificate and the lab."""
    return {
        "distance from −1": 1 / both.Ms / CLOSE,
        "phase margin": math.degrees(both.phase) / PHASE,
        "motors stronger": (both.gain_high - 1) / (STRONG - 1),
        "motors weaker": (1 - both.gain_low) / (1 - WEAK),
        "delay margin": delay / period,
    }


def linear_margins(controller: Controller, robot: Robot, kit: Kit, *, usual: bool = False) -> LinearMargins | None:
    """The nominal loop's near rest, zero where it is unstable; None where nothing linear is known of the controller.
    With how many `usual` targets are met where asked."""
    try:
        loop = robot_loop(controller, robot, kit)
    except InvalidController:
        return None
    radius = float(abs(loop.poles()[0]))
    if radius >= 1 - ROUNDED:
        return LinearMargins(radius, 1.0, 1.0, 0.0)
    every = loop_margins(loop, peaks=False)
    low, high = max(every, key=lambda m: m.gain_low), min(every, key=lambda m: m.gain_high)
    first = min(every, key=lambda m: m.delay)
    at = (low.channel, high.channel, first.channel)
    met = None
    if usual:
        both = margins(loop.at_input, INPUTS["both motors"])
        met = sum(part >= 1 for part in reached(both, first.delay, controller.spec.period).values())
    unseen = unseen_in_words(loop.hidden)
    return LinearMargins(radius, low.gain_low, high.gain_high, first.delay, *at, met=met, unseen=unseen)


@dataclass(frozen=True)
class Examined:
    """What the light is judged by: `fell` of `samples` robots fell in at least one of the `trials`, `beyond` of them
    only where no controller could help. The `linear` loop is that every `period` [s] (None: not linear even near rest).

    `agreement` compares the innovations of a log with what is assumed, `support` what the log shows of each number that
    is taken as given; what was `taken` from it, and tried, stands beside what had been assumed. Left alone, robots
    stand or fall as in `standing`; `guessed` counts falls with the guesses as the file has them, and `narrowing` says
    what would have to be known better. None: not examined.
    """

    samples: int
    fell: int
    linear: LinearMargins | None
    trials: tuple[PushTrial, ...]
    period: float
    agreement: tuple[Agreement, ...] = ()
    support: tuple[Support, ...] = ()
    _: KW_ONLY
    beyond: int = 0
    taken: tuple[Support, ...] = ()
    standing: Standing = UNTRIED
    guessed: Guessed | None = None
    narrowing: Narrowing | None = None


def judge(e: Examined) -> tuple[str, tuple[str, ...]]:
    """The light and its one or two reasons, the gravest first.

    Numbers that were taken from the log, outside what was assumed, are a reason besides: they are a fault to mend, or
    to be measured, so that the light is amber at most. Falls leave it unknown where, with the guesses as the file has
    them, not surely too many fall; else what is said first is that these do.
    """
    linear = e.linear
    logged = [f"tried as the log shows it: {s}" for s in sorted(e.taken, key=lambda s: -s.excess) if s.excess > 0]
    free = list[str]()
    unstable = list[str]()
    if linear and linear.free:
        free = [linear.unseen or instability(linear.radius, e.period)]
    elif linear and not linear.stable:
        unstable = [instability(linear.radius, e.period)]
    drawn = _drawn(e)
    open_guesses = False
    if drawn and e.guessed and e.guessed.runs:
        fell, runs = e.guessed.fell, e.guessed.runs
        open_guesses = 1 - upper_bound(runs - fell, runs, CONFIDENCE) <= MOST_FALLS  # not surely too many
        known = f"with the guesses as the file has them {fell} of {runs} robots fall"
        drawn = [f"{drawn[0]}; {known}"] if open_guesses else [known, drawn[-1]]
    certain = unstable + _file(e.standing) + disagreements(e.agreement, RED)
    grave = certain + ([] if open_guesses else drawn + _weak(e)[: len(drawn)])
    if grave:
        return RED, tuple((grave[:1] + logged[:1] + grave[1:] + free)[:2])
    if drawn and e.guessed:
        narrowed = str(e.narrowing) if e.narrowing and e.narrowing.spreads else ""
        return UNKNOWN, (drawn[0], narrowed or f"measure {joined(e.guessed.names[:MOST_NAMES])}")
    thin = free or (_thin(linear, e.period) if linear else [])
    amber = disagreements(e.agreement, AMBER) + contradictions(e.support) + thin + _weak(e) + _laborious(e.trials)
    if amber or logged:
        return AMBER, tuple((amber[:1] + logged[:1] + amber[1:])[:2])
    chance = _per_cent(upper_bound(e.fell, e.samples, CONFIDENCE))
    message = f"{e.fell} of {e.samples} robots fell: the probability of a fall is below {chance}"
    if linear is None:
        return GREEN, (message, "no linear margins are known")
    delay = "with any delay" if math.isinf(linear.delay) else f"up to {linear.delay * 1e3:.1f} ms more delay"
    met = "" if linear.met is None else f"; {linear.met} of 5 margins reach the usual targets"
    return GREEN, (message, f"stable {delay}{placed(linear.delay_at)}{met}")


def disagreements(agreements: Sequence[Agreement], light: str) -> list[str]:
    """The sensors of a log whose innovations ask for this light, the largest first, as sentences."""
    low, high = (FAR_LARGER, math.inf) if light == RED else (LARGER, FAR_LARGER)
    beyond = sorted((a for a in agreements if low < a.ratio <= high), key=lambda a: -a.ratio)
    return [
        f"the log's {a.sensor} innovations are {a.ratio:.1f} times the largest of any drawn robot; the limit is {low:g}"
        for a in beyond
    ]


def _file(standing: Standing) -> list[str]:
    """That the file's robot falls by itself."""
    if standing.fell is None:
        return []
    return [f"left alone, the robot of the file falls after {standing.fell:.2g} s"]


def _drawn(e: Examined) -> list[str]:
    """The falls of drawn robots that the controller could have avoided."""
    lost = []
    if e.standing.runs and e.standing.fell is None and red(e.standing.lost, e.standing.runs):
        lost = [f"left alone, {e.standing.lost} of {e.standing.runs} robots fall within the uncertainty of the file"]
    if not red(e.fell - e.beyond, e.samples):
        return lost
    bound = upper_bound(e.fell, e.samples, CONFIDENCE)
    worst = max(e.trials, key=lambda t: t.fell)
    where = f", {worst.fell} of them after a {worst.push} at {worst.battery} battery" if e.fell else ""
    message = f"the probability of a fall may be {_per_cent(bound)}, more than {100 * MOST_FALLS:g} %"
    return [*lost, f"{e.fell} of {e.samples} robots fell{where}: {message}"]


def _weak(e: Examined) -> list[str]:
    """That motors are too weak for what the standard pushes ask: a property of the robot, not of its controller."""
    if not red(e.fell, e.samples) or e.beyond <= MOST_FALLS * e.samples:
        return []
    hardest = max(e.trials, key=lambda t: t.beyond)
    where = f"{hardest.beyond} of them for a {hardest.push} at {hardest.battery} battery"
    return [f"no controller could: {e.beyond} of {e.samples} robots have motors too weak, {where}"]


def _thin(linear: LinearMargins, period: float) -> list[str]:
    up = linear.gain_high - 1
    down = 1 - linear.gain_low
    slack, way, at = (up, "stronger", linear.high_at) if up < down else (down, "weaker", linear.low_at)
    changed = (
        f"a signal {100 * slack:.1f} % {way}{placed(at)} makes" if at else f"motors {100 * slack:.1f} % {way} make"
    )
    thin = [f"{changed} the loop unstable"] if slack < LEAST_GAIN else []
    if linear.delay >= LEAST_DELAY * period:
        return thin
    more = f"{linear.delay * 1e3:.1f} ms more delay{placed(linear.delay_at)}"
    return [*thin, f"{more} ({linear.delay / period:.2f} of a period) make the loop unstable"]


def placed(channel: str) -> str:
    return f" at {'' if channel in ('both motors', 'steering') else 'the '}{channel}" if channel else ""


def _laborious(runs: Sequence[PushTrial]) -> list[str]:
    limits = {"saturated": MOST_SATURATED, "travel": MOST_TRAVEL, "cycle": MOST_CYCLE}
    words = {
        "saturated": "a motor is at its limit for {:.0%} of the time",
        "travel": "the robot rolls {:.2f} m away",
        "cycle": "at rest the robot sways by ±{:.2f} rad",
    }
    reasons: list[str] = []
    for name, limit in limits.items():
        worst = max(runs, key=lambda t: getattr(t, name))
        if getattr(worst, name) > limit:
            reasons.append(
                f"{words[name].format(getattr(worst, name))} after a {worst.push} at {worst.battery} battery"
            )
    return reasons


def _per_cent(probability: float) -> str:
    """Two significant digits."""
    return f"{100 * probability:.2g} %" if probability < 0.1 else f"{100 * probability:.0f} %"
