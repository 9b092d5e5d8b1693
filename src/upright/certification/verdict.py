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
from upright.loops.analysis import INPUTS, ROUNDED, loop_margins
from upright.loops.loop import robot_loop
from upright.loops.margins import margins
from upright.loops.places import delay_of, place_of
from upright.loops.targets import LEAST_DELAY, LEAST_GAIN, reached
from upright.pages import Quantity, Say
from upright.pages.terms import term
from upright.robots import Kit, Robot

GREEN, AMBER, RED, UNKNOWN = "green", "amber", "red", "unknown"

LARGER = 2.0  # times the largest of the drawn robots: amber, since noise or model err by more than what was drawn
FAR_LARGER = 5.0  # red: what was certified is another robot

MOST_SATURATED = 0.25  # amber above: a motor at its end this often is no longer the one the design assumed
MOST_TRAVEL = 1.0  # [m] amber above: it leaves the table


@dataclass(frozen=True)
class LinearMargins:
    """The nominal loop: its largest |pole| `radius`, and the smallest margins of all places where it can be broken.

    It stays stable for gain factors from `gain_low` to `gain_high` [1], and for up to `delay` [s] of further delay, at
    any one motor or reading, or at both motors. Three names say where each of these is the smallest; older
    certificates, which looked at both motors only, leave them empty. So many of the usual targets are `met` (None: not
    computed). What no reading shows of a stable loop is `unseen`: its state "wheel" or "yaw".
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
    unseen = next((name for name in ("wheel", "yaw") if name in loop.hidden), "")
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


@dataclass(frozen=True)
class Reason:
    """Why a light is what it is: a sentence, its `message`, and in a few words what `decides`. Its `kind` tells what
    would mend it: the "loop", the robot left "alone", robots of the "spread", the "log", "weak" motors, a "free" place,
    a "gain", a "delay", "saturated" motors, "travel", "sway", what to "measure", or nothing ("good")."""

    kind: str
    message: Say
    decides: Say

    def __str__(self) -> str:
        return str(self.message)


def judge(e: Examined) -> tuple[str, tuple[Reason, ...]]:
    """The light and its one or two reasons, the gravest first.

    Numbers that were taken from the log, outside what was assumed, are a reason besides: they are a fault to mend, or
    to be measured, so that the light is amber at most. Falls leave it unknown where, with the guesses as the file has
    them, not surely too many fall; else what is said first is that these do.
    """
    linear = e.linear
    logged = [_tried(s) for s in sorted(e.taken, key=lambda s: -s.excess) if s.excess > 0]
    free = [_free(linear)] if linear and linear.free else []
    unstable = [_unstable(linear.radius, e.period)] if linear and not (linear.free or linear.stable) else []
    drawn = _drawn(e)
    open_guesses = False
    if drawn and e.guessed and e.guessed.runs:
        fell, runs = e.guessed.fell, e.guessed.runs
        open_guesses = 1 - upper_bound(runs - fell, runs, CONFIDENCE) <= MOST_FALLS  # not surely too many
        drawn = [_open(drawn[0], e.guessed)] if open_guesses else [drawn[-1], _known(e.guessed)]
    certain = unstable + _file(e.standing) + disagreements(e.agreement, RED)
    grave = certain + ([] if open_guesses else drawn + _weak(e)[: len(drawn)])
    if grave:
        return RED, tuple((grave[:1] + logged[:1] + free + grave[1:])[:2])
    if drawn and e.guessed:
        return UNKNOWN, (drawn[0], _measure(e.guessed, e.narrowing))
    thin = free or (_thin(linear, e.period) if linear else [])
    contradicted = [_contradicted(s) for s in contradictions(e.support)]
    amber = disagreements(e.agreement, AMBER) + contradicted + thin + _weak(e) + _laborious(e.trials)
    if amber or logged:
        return AMBER, tuple((amber[:1] + logged[:1] + amber[1:])[:2])
    return GREEN, (_few(e), _stable(linear))


def _few(e: Examined) -> Reason:
    bound = Quantity(None, "fraction", high=upper_bound(e.fell, e.samples, CONFIDENCE), digits=2)
    message = Say("Of {n} simulated robots that were held, let go and knocked, {fell} fell.", n=e.samples, fell=e.fell)
    return Reason("good", message, Say("{bound} fall", bound=bound))


def _stable(linear: LinearMargins | None) -> Reason:
    if linear is None:
        message = Say("No linear margins are known.")
    elif math.isinf(linear.delay):
        message = Say("The loop is stable with any delay.")
    else:
        message = Say("The loop is stable up to {delay} more delay at {place}.", delay=delay_of(linear.delay),
                   place=place_of(linear.delay_at))  # fmt: skip
    return Reason("good", message, Say("stable"))


def _unstable(radius: float, period: float) -> Reason:
    doubled = Quantity(period * math.log(2) / math.log(radius), "s", digits=2)
    message = Say("The nominal loop is unstable: a deviation doubles every {time} (|z| = {radius}).", time=doubled,
               radius=Quantity(radius, "1", digits=5))  # fmt: skip
    return Reason("loop", message, Say("the loop is unstable"))


def _free(linear: LinearMargins) -> Reason:
    if linear.unseen == "wheel":
        message = Say("Nothing holds the wheels where they are: the robot stands, and may roll away.")
    elif linear.unseen:
        message = Say("Nothing holds its heading: the robot may turn away.")
    else:
        message = Say("Nothing holds its position or its heading: it may roll or turn away.")
    return Reason("free", message, Say("it may roll or turn away"))


def _tried(s: Support) -> Reason:
    """A number that was taken from the log."""
    return Reason("log", Say("Tried as the log shows it: {number}.", number=s.message), _strange(s))


def _contradicted(s: Support) -> Reason:
    """A number that the log shows outside of what was assumed, or leaves open."""
    if not s.left_open:
        return Reason("log", Say("The log contradicts what was assumed: {number}.", number=s.message), _strange(s))
    interval = Quantity(None, s.unit, low=s.low, high=s.high, digits=2)
    message = Say("The log leaves {name} open, {interval}.", name=s.named, interval=interval)
    if not s.low <= (s.least + s.most) / 2 <= s.high:
        # an interval without the number that was assumed is no better known
        message = Say("The log leaves {name} open.", name=s.named)
    return Reason("log", message, Say("{name} is open", name=s.named))


def _strange(s: Support) -> Say:
    return Say("{name} is {value}", name=s.named, value=Quantity(s.value, s.unit))


def disagreements(agreements: Sequence[Agreement], light: str) -> list[Reason]:
    """The sensors of a log whose innovations ask for this light, the largest first."""
    low, high = (FAR_LARGER, math.inf) if light == RED else (LARGER, FAR_LARGER)
    beyond = sorted((a for a in agreements if low < a.ratio <= high), key=lambda a: -a.ratio)
    return [_disagrees(a, low) for a in beyond]


def _disagrees(a: Agreement, limit: float) -> Reason:
    ratio, sensor = Quantity(a.ratio, "1", digits=2), place_of(a.sensor)
    message = Say(
        "The log's innovations of {sensor} are {ratio} times the largest of any drawn robot; the limit is {limit}.",
        sensor=sensor,
        ratio=ratio,
        limit=Quantity(limit, "1"),
    )
    return Reason("log", message, Say("the log disagrees {ratio} times", ratio=ratio))


def _file(standing: Standing) -> list[Reason]:
    """That the file's robot falls by itself."""
    if standing.fell_at is None:
        return []
    time = Quantity(standing.fell_at, "s", digits=2)
    message = Say("Left alone, the robot of the file falls after {time}.", time=time)
    return [Reason("alone", message, Say("it falls after {time}", time=time))]


def _drawn(e: Examined) -> list[Reason]:
    """The falls of drawn robots that the controller could have avoided."""
    alone = e.standing
    lost: list[Reason] = []
    if alone.runs and alone.fell_at is None and red(alone.lost, alone.runs):
        message = Say("Left alone, {lost} of {runs} robots within the uncertainty of the file fall.", lost=alone.lost,
                   runs=alone.runs)  # fmt: skip
        lost = [Reason("spread", message, Say("{lost} of {runs} fall alone", lost=alone.lost, runs=alone.runs))]
    if not red(e.fell - e.beyond, e.samples):
        return lost
    facts = {"fell": e.fell, "n": e.samples, "limit": Quantity(MOST_FALLS, "fraction")}
    if e.fell > MOST_FALLS * e.samples:
        message = Say("{fell} of {n} similar robots fell under at least one push; the limit is {limit}.", **facts)
        return [*lost, Reason("spread", message, Say("{fell} of {n} fall", fell=e.fell, n=e.samples))]
    bound = Quantity(None, "fraction", high=upper_bound(e.fell, e.samples, CONFIDENCE), digits=2)
    message = Say("{fell} of {n} similar robots fell: of all such robots {bound}, and the limit is {limit}.",
                  bound=bound, **facts)  # fmt: skip
    return [*lost, Reason("spread", message, Say("{bound} fall", bound=bound))]


def _known(guessed: Guessed) -> Reason:
    """That too many fall with the guesses as they are."""
    message = Say("With every guess exactly as in the file, {fell} of {runs} robots fall too.", fell=guessed.fell,
                  runs=guessed.runs)  # fmt: skip
    return Reason("spread", message, Say("{fell} of {runs} fall", fell=guessed.fell, runs=guessed.runs))


def _open(falls: Reason, guessed: Guessed) -> Reason:
    """Falls that hang on guesses."""
    message = Say("{falls} With every guess exactly as in the file, it is {fell} of {runs}.", falls=falls.message,
               fell=guessed.fell, runs=guessed.runs)  # fmt: skip
    return Reason("measure", message, falls.decides)


def _measure(guessed: Guessed, narrowing: Narrowing | None) -> Reason:
    """What would have to be known better."""
    names = [term(name) for name in guessed.names[:MOST_NAMES]]
    message = narrowing.message if narrowing and narrowing.spreads else Say("Measure first: {names}.", names=names)
    return Reason("measure", message, Say("it hangs on guesses"))


def _weak(e: Examined) -> list[Reason]:
    """That motors are too weak for what the standard pushes ask: a property of the robot, not of its controller."""
    if not red(e.fell, e.samples) or e.beyond <= MOST_FALLS * e.samples:
        return []
    hardest = max(e.trials, key=lambda t: t.beyond)
    message = Say(
        "No controller could: {beyond} of {n} robots have motors too weak, most for this push: {push}, {battery}.",
        beyond=e.beyond,
        n=e.samples,
        push=hardest.message,
        battery=hardest.supply,
    )
    return [Reason("weak", message, Say("{beyond} of {n} have weak motors", beyond=e.beyond, n=e.samples))]


def _thin(linear: LinearMargins, period: float) -> list[Reason]:
    up = linear.gain_high - 1
    down = 1 - linear.gain_low
    thin: list[Reason] = []
    if min(up, down) < LEAST_GAIN:
        slack = Quantity(min(up, down), "fraction", digits=2)
        limit = Quantity(LEAST_GAIN, "fraction")
        if up < down:
            message = Say("A gain {slack} higher at {place} makes the loop unstable; the limit is {limit}.",
                       slack=slack, place=place_of(linear.high_at), limit=limit)  # fmt: skip
        else:
            message = Say("A gain {slack} lower at {place} makes the loop unstable; the limit is {limit}.",
                       slack=slack, place=place_of(linear.low_at), limit=limit)  # fmt: skip
        thin = [Reason("gain", message, Say("gain margin {slack}", slack=slack))]
    if linear.delay >= LEAST_DELAY * period:
        return thin
    delay = delay_of(linear.delay)
    message = Say("{delay} more delay at {place} makes the loop unstable; the limit is {limit}.", delay=delay,
               place=place_of(linear.delay_at), limit=Quantity(LEAST_DELAY * period, "s"))  # fmt: skip
    return [*thin, Reason("delay", message, Say("delay margin {delay}", delay=delay))]


def _laborious(runs: Sequence[PushTrial]) -> list[Reason]:
    """What is beyond its limit under the worst push."""
    reasons: list[Reason] = []
    for kind, name, limit, unit in LIMITS:
        worst = max(runs, key=lambda t: getattr(t, name))
        size = Quantity(getattr(worst, name), unit, digits=3)
        most = Quantity(limit, unit)
        after = {"push": worst.message, "battery": worst.supply, "limit": most, "size": size}
        if getattr(worst, name) <= limit:
            continue
        if kind == "saturated":
            message = Say("A motor is saturated {size} of the time ({push}, {battery}); {limit} are allowed.", **after)
            reasons.append(Reason(kind, message, Say("motors saturated {size}", size=size)))
        elif kind == "travel":
            message = Say("It rolls {size} away ({push}, {battery}); {limit} are allowed.", **after)
            reasons.append(Reason(kind, message, Say("it rolls {size} away", size=size)))
        else:
            message = Say("At rest it sways by ±{size} ({push}, {battery}); {limit} are allowed.", **after)
            reasons.append(Reason(kind, message, Say("it sways by ±{size}", size=size)))
    return reasons


LIMITS = (
    ("saturated", "saturated", MOST_SATURATED, "fraction"), ("travel", "travel", MOST_TRAVEL, "m"),
    ("sway", "cycle", MOST_CYCLE, "rad"),
)  # fmt: skip
"""What is laborious: its kind, its number of a trial, the most that is no reason, and its unit."""
