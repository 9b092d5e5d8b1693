"""The page of a certificate: its light, the number that decides, answers to three questions, and what to do next."""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from upright.certification.measured import Measurements
from upright.certification.narrowing import BY_HAND, by_run
from upright.certification.next_step import next_step
from upright.certification.pushes import RELEASE
from upright.certification.recovery import KNOCK_DURATION
from upright.certification.standing import LEAN, Swept, stands
from upright.certification.verdict import AMBER, GREEN, MOST_FALLS, RED, UNKNOWN, LinearMargins
from upright.languages import number
from upright.likelihood.assumptions import BATTERIES
from upright.loops.places import delay_of, place_of
from upright.pages import (
    Block,
    Column,
    Fold,
    Items,
    KeyNumber,
    Page,
    Picture,
    Quantity,
    Say,
    Table,
    Verdict,
)
from upright.pages.blocks import Level
from upright.pages.terms import term

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from upright.certification.checks import PushTrial

LEVELS: dict[str, Level] = {GREEN: "good", AMBER: "warn", RED: "bad", UNKNOWN: "unknown"}
LIMIT = Quantity(MOST_FALLS, "fraction")


def certificate_page(c: Measurements) -> Page:
    """The page of a certificate."""
    weighed = {"weighed": str(Quantity(c.weighed, "kg"))} if c.weighed else {}
    facts = {"robot": c.robot, "kit": c.kit, "controller": f"{c.controller} {c.hash[:12]}", "seed": str(c.seed)}
    blocks: list[Block] = [_questions(c)]
    if c.to_measure():
        blocks.append(_to_measure(c))
    if reservations := _reservations(c):
        blocks.append(Items(reservations))
    return Page(
        _title(c), verdict=_verdict(c), lead=_lead(c), numbers=_numbers(c),
        picture=_picture(c), next=[next_step(c)], blocks=[*blocks, *_folds(c)], origin=facts | weighed,
    )  # fmt: skip


def _lead(c: Measurements) -> list[Say]:
    """The reasons, but for what the table of measurements says, or the number of the delay."""
    again = c.light == UNKNOWN or (c.light == GREEN and c.linear and math.isfinite(c.linear.delay))
    return [reason.message for reason in c.reasons[: 1 if again else 2]]


def _title(c: Measurements) -> Say:
    if c.light == GREEN:
        return Say("The controller {controller} may drive {robot}", controller=c.controller, robot=c.robot)
    if c.light == AMBER:
        return Say("The controller {controller} may drive {robot}, with care", controller=c.controller, robot=c.robot)
    if c.light == RED:
        return Say("The controller {controller} must not drive {robot}", controller=c.controller, robot=c.robot)
    return Say("Too little is known of {robot} for the controller {controller}", controller=c.controller, robot=c.robot)


def _verdict(c: Measurements) -> Verdict:
    decides = c.reasons[0].decides
    if c.light == GREEN:
        text = Say("Green: {decides}", decides=decides)
    elif c.light == AMBER:
        text = Say("Amber: {decides}", decides=decides)
    elif c.light == RED:
        text = Say("Red: {decides}", decides=decides)
    else:
        text = Say("Unknown: {decides}", decides=decides)
    return Verdict(text, LEVELS[c.light])


def _numbers(c: Measurements) -> list[KeyNumber]:
    if c.fell > MOST_FALLS * c.samples:
        counted = Say("similar robots fall under at least one push; the limit is {limit}", limit=LIMIT)
        numbers = [KeyNumber(Say("{fell} of {n}", fell=c.fell, n=c.samples), counted)]
    else:
        bound = Quantity(None, "fraction", high=c.bound, digits=2)
        numbers = [KeyNumber(bound, Say("of similar robots fall (95 % confidence); the limit is {limit}", limit=LIMIT))]
    for endured in c.endured:
        if endured.kind == "knock":
            size, *_ = endured.sizes
            numbers.append(KeyNumber(size, Say("largest knock at the centre of mass that it survives")))
    if c.linear and c.linear.stable and math.isfinite(c.linear.delay):
        unstable = Say("more delay at {place} makes the loop unstable", place=place_of(c.linear.delay_at))
        return [*numbers, KeyNumber(delay_of(c.linear.delay), unstable)]
    if c.light == RED:  # where how far the others rolled decides nothing
        return numbers
    stood = [t.travel for t in c.trials if t.fell < t.runs]
    travel = Say("95 % of those that stood roll less far, in the worst push")
    return [*numbers, *([KeyNumber(Quantity(max(stood), "m"), travel)] if stood else [])]


def _picture(c: Measurements) -> Picture:
    worst = max(c.trials, key=lambda t: t.fell / t.runs)
    draw = functools.partial(bars_of, c)
    if not worst.fell:
        claim = Say("No robot fell in {n} trials; 95 % rolled no further than this", n=sum(t.runs for t in c.trials))
        return Picture(claim, draw)
    claim = Say("The worst push fells {part}: {push}, {battery}", part=Quantity(worst.fell / worst.runs, "fraction"),
                push=worst.message, battery=worst.supply)  # fmt: skip
    return Picture(claim, draw)


def bars_of(c: Measurements) -> Figure:
    """A bar for every push at every battery: falls [%], under the bound of all, or travel [m] where nothing fell."""
    from upright.plotting import COLOURS, bars

    fell = any(t.fell for t in c.trials)
    each = {
        str(Say("{push}, {battery}", push=t.message, battery=t.supply)): 100 * t.fell / t.runs if fell else t.travel
        for t in worst_first(c)
    }
    push = str(Say("push, battery"))
    if not fell:
        return bars([*each], [*each.values()], str(Say("travel [m]")), push)
    each = {str(Say("all pushes, at most")): 100 * c.bound} | each
    figure = bars([*each], [*each.values()], str(Say("robots that fell [%]")), push, limit=100 * MOST_FALLS)
    # a bound is no count
    figure.axes[0].patches[0].set(facecolor="none", edgecolor=COLOURS[0], hatch="///")
    figure.axes[0].texts[0].set_text(number(100 * c.bound, 2, toward=1))
    return figure


def worst_first(c: Measurements) -> list[PushTrial]:
    """The trials, those with most falls first, or with the longest travel where nothing fell."""
    fell = any(t.fell for t in c.trials)
    return sorted(c.trials, key=lambda t: -t.fell / t.runs if fell else -t.travel)


def _questions(c: Measurements) -> Table:
    radius = c.linear.radius if c.linear else 1.0
    rows: list[list[Say]] = [[Say("Does it stand?"), stands(c.standing, radius, c.period, c.trials)]]
    if c.endured:
        pushes = Say("{pushes}", pushes=[endured.message for endured in c.endured])
        rows.append([Say("How hard may I push it?"), pushes])
    if c.strength:
        weak = Say("too weak for {beyond} of {runs} robots, of which {fell} fell; {what}", beyond=c.beyond,
                   runs=c.samples, fell=c.fell, what=c.strength.message)  # fmt: skip
        rows.append([Say("Are its motors strong enough?"), weak])
    rows.append([Say("Which numbers of the file are guesses?"), _guesses(c)])
    return Table([Column(Say("question")), Column(Say("answer"))], rows)


def _guesses(c: Measurements) -> Say:
    if not c.guessed:
        return Say("none")
    first, *others = [term(name) for name in c.guessed.names]
    if c.light != UNKNOWN:
        return Say("{names}; none of them changes the light", names=[first, *others])
    if others:
        return Say("{first} decides most; then {others}", first=first, others=others)
    return Say("{first}, which decides", first=first)


def _to_measure(c: Measurements) -> Table:
    """What would have to be known better, how well, and how it is measured."""
    needed = {spread.name: spread for spread in c.narrowing.spreads} if c.narrowing else {}
    logged = by_run(c.to_measure(), str(c.subject["robot"]["drive"]))
    rows = [
        [
            term(name),
            Quantity(needed[name].spread, needed[name].unit, digits=2) if name in needed else None,
            Quantity(needed[name].needed, needed[name].unit, digits=2) if name in needed else None,
            BY_HAND.get(name) or (Say("a run tells it") if name in logged else Say("measure it")),
        ]
        for name in c.to_measure()
    ]
    if not (c.narrowing and needed):
        rows = [[name, how] for name, *_, how in rows]
        return Table([Column(Say("measure")), Column(Say("how"))], rows)
    columns = [Column(Say("measure")), Column(Say("known to ±")), Column(Say("needed ±")), Column(Say("how"))]
    return Table(columns, rows, c.narrowing.message)


def _reservations(c: Measurements) -> list[Say]:
    """What the light does not count."""
    items: list[Say] = []
    if c.agreement and c.given and not c.given.endswith(".json"):
        items.append(
            Say("Certified is `upright design {name}`: if another controller flew, certify its file.", name=c.given)
        )
    if c.narrowing and not c.narrowing.spreads:
        items.append(c.narrowing.message)
    play = c.subject["kit"].get("motor/backlash")
    if play:
        angle = Quantity(float(play), "rad", digits=2)
        items.append(
            Say("Of {angle} of play only the encoders know here: a real robot sways more, and may fall.", angle=angle)
        )
    return items


def _folds(c: Measurements) -> list[Fold]:
    folds = [Fold(Say("Every push"), [_trials(c), Items(_tried(c))])]
    if c.linear and c.linear.stable:
        folds.append(Fold(Say("Margins"), _margins(c.linear)))
    if c.delayed or c.slower:
        folds.append(Fold(Say("More delay, other periods"), _sweeps(c)))
    if c.support or c.agreement:
        folds.append(Fold(Say("What the log shows"), _logged(c)))
    return folds


def _trials(c: Measurements) -> Table:
    rows = []
    for t in worst_first(c):
        best = Quantity(t.bound, "N s" if t.kind == "knock" else "rad", digits=2)
        stood = [t.saturated, t.travel, t.peak, t.cycle] if t.fell < t.runs else [None] * 4
        rows.append([t.message, _supplied(c, t), t.fell, t.beyond, best, *stood])
    columns = [
        Column(Say("push")), Column(Say("battery")), Column(Say("fell")), Column(Say("beyond any controller")),
        Column(Say("largest that any controller survives")), Column(Say("saturated"), "fraction", digits=2),
        Column(Say("travel"), "m"), Column(Say("largest pitch"), "rad"), Column(Say("sway at rest"), "rad", digits=2),
    ]  # fmt: skip
    caption = Say("{n} robots each. Saturation, travel, pitch and sway: 95 % of the robots that stood stay below.",
                  n=c.samples)  # fmt: skip
    return Table(columns, rows, caption)


def _supplied(c: Measurements, t: PushTrial) -> Say | str:
    """A battery with its voltage, where that is known."""
    nominal = c.subject["kit"].get("battery/voltage")
    if t.battery not in BATTERIES:
        return t.battery
    volts = c.subject["robot"].get("conditions/battery/low" if t.battery == "low" else "conditions/battery/high")
    if volts is None and isinstance(nominal, float):
        volts = BATTERIES[t.battery] * nominal
    if not isinstance(volts, float):
        return t.supply
    return (
        Say("low, {volts}", volts=Quantity(volts, "V"))
        if t.battery == "low"
        else Say("full, {volts}", volts=Quantity(volts, "V"))
    )


def _tried(c: Measurements) -> list[Say]:
    """How the pushes were tried."""
    items = [
        Say("A hold leans the robot for {time}, then lets go. A knock lasts {short}. Both act at the centre of mass.",
            time=Quantity(RELEASE, "s"), short=Quantity(KNOCK_DURATION, "s")),
        Say("The model is nonlinear, with noise, delays and limits of the kit {kit}.", kit=c.kit),
    ]  # fmt: skip
    moved = max((t.residual for t in c.trials), default=0.0)
    if moved:
        items.append(Say("The last iteration of a period moved a command by up to {part} of its limit.",
                         part=Quantity(moved, "fraction", digits=2)))  # fmt: skip
    return items


def _margins(margins: LinearMargins) -> list[Block]:
    rows = [
        [Say("delay"), delay_of(margins.delay), place_of(margins.delay_at)],
        [Say("gain, down to"), Quantity(margins.gain_low, "fraction"), place_of(margins.low_at)],
        [Say("gain, up to"), Quantity(margins.gain_high, "fraction"), place_of(margins.high_at)],
        [Say("largest |pole|"), Quantity(margins.radius, "1", digits=4), None],
    ]
    columns = [Column(Say("margin")), Column(Say("value")), Column(Say("smallest at"))]
    blocks: list[Block] = [Table(columns, rows)]
    if margins.met is not None:
        blocks.append(Say("{met} of 5 margins at their usual target; the light counts falls instead.", met=margins.met))
    return blocks


def _sweeps(c: Measurements) -> list[Block]:
    own = [s for s in c.slower if math.isclose(s.value, c.period)]
    further = [*(Swept(0.0, s.runs, s.fell) for s in own), *c.delayed]
    lean = Quantity(LEAN, "rad")
    pictures: list[Block] = []
    for swept, delayed in ((further, True), (c.slower, False)):
        if len(swept) < 2:
            continue
        at = 0.0 if delayed else c.period
        draw = functools.partial(_draw_swept, swept, at, delayed=delayed)
        note = Say("Of each {n} robots were left alone at {lean}.", n=swept[0].runs, lean=lean)
        pictures.append(Picture(_swept_claim(swept, at, delayed=delayed), draw, note))
    return pictures


def _swept_claim(swept: Sequence[Swept], at: float, *, delayed: bool) -> Say:
    """The delays or periods round the design, `at`, at which few robots fall."""
    rows = sorted(swept, key=lambda s: s.value)
    designed = min(range(len(rows)), key=lambda k: abs(rows[k].value - at))
    first = last = designed
    while first > 0 and _few(rows[first - 1]):
        first -= 1
    while last < len(rows) - 1 and _few(rows[last + 1]):
        last += 1
    if not _few(rows[designed]):
        return Say("As designed too many fall when left alone")
    low, high = rows[first].value, rows[last].value
    if delayed:
        return Say("Commands may come {time} later: few robots fall", time=Quantity(high, "s"))
    return Say("With the same gains few fall at periods of {range}", range=Quantity(None, "s", low=low, high=high))


def _few(s: Swept) -> bool:
    return s.fell <= MOST_FALLS * s.runs


def _draw_swept(swept: Sequence[Swept], at: float, *, delayed: bool) -> Figure:
    from upright.plotting import AXIS, line, panels

    parts = [100 * s.fell / s.runs for s in swept]
    name = Say("further delay of the commands [ms]") if delayed else Say("period [ms]")
    figure, (ax,) = panels([str(Say("robots that fell [%]"))], str(name))
    line(ax, str(Say("fell")), [1e3 * s.value for s in swept], parts, solid=True)
    ax.lines[-1].set_marker("o")
    ax.axhline(100 * MOST_FALLS, linestyle="--", linewidth=1, color=AXIS)
    if at:
        ax.axvline(1e3 * at, linestyle="--", linewidth=1, color=AXIS)
    ax.set_ylim(-2, max(10.0, 1.1 * max(parts)))
    return figure


def _logged(c: Measurements) -> list[Block]:
    taken = {s.name for s in c.taken}
    judged = [(s, Say("tried as logged")) for s in c.taken]
    for s in c.support:
        if s.left_open or s.outside:
            judged.append((s, Say("left open") if s.left_open else Say("outside")))
        elif s.name not in taken:
            judged.append((s, Say("as assumed")))
    rows = [[s.named, Quantity(s.value, s.unit, low=s.low, high=s.high), s.assumed, word] for s, word in judged]
    columns = [Column(Say("number")), Column(Say("in the log")), Column(Say("assumed")), Column(Say("so it was"))]
    sensors = [[place_of(a.sensor), Quantity(a.ratio, "1", digits=2)] for a in c.agreement]
    heads = [Column(Say("sensor")), Column(Say("innovations, over the largest of drawn robots"))]
    return [*([Table(columns, rows)] if rows else []), *([Table(heads, sensors)] if sensors else [])]
