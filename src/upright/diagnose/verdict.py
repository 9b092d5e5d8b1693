"""From evidence to ranked causes: what is asked first, and in which words the answer is given.

The order is that of cause and effect. Commands that were changed by an exact number and a loop that did not run are
plain facts. A robot, sensor or floor that changed comes before pushes and demands, which a good one survives; what is
left is the gain, or saturation, in which every fall ends. Each question takes its part of the probability and leaves
the rest to the next. Numbers without a reason of their own were settled on the tuning runs of
`benchmarks/postmortem.py` (seeds 1000 to 1005 and 9000 to 9005).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import replace

from upright.diagnose.blows import HELPED, LIKELY, driven_into, pushed, pushed_already, thrown_over
from upright.diagnose.causes import (
    AND,
    BATTERY,
    CANNOT_TELL,
    HIGH,
    LOW,
    NAMES,
    NONE,
    PUSH,
    REVERSED,
    SATURATION,
    Cause,
)
from upright.diagnose.chances import (
    DOUBT,
    EXPLAINED_WIDTH,
    FITS_BADLY,
    FITS_WIDTH,
    LIMIT_WIDTH,
    PUSH_SCORE_WIDTH,
    SURE,
    best_of,
    holds,
    let_go,
    name_of,
    step,
    toppling_lean,
    unexplained,
    unsettled,
    worth,
)
from upright.diagnose.evidence import FOREIGN, Evidence
from upright.diagnose.facts import FACT, TEMPER, Answer, changed_gain, lost_rows, stuck, stuck_sensor, switched_off
from upright.diagnose.fault_fits import FaultFit, PushEstimate
from upright.diagnose.measured import SLOWLY
from upright.diagnose.pairs import Pair
from upright.diagnose.remedy import acts_from
from upright.diagnose.resting import held_wheel, weighed
from upright.diagnose.sizes import possible, slight
from upright.diagnose.usual import SECONDS
from upright.diagnose.words import (
    began,
    blow,
    nothing,
    of_demand,
    of_fault,
    of_high,
    of_leftover,
    of_low,
    of_pegged,
    of_push,
    percent,
)
from upright.pages import Quantity, Say

TWO = SURE
TWO_WIDTH = 5.0
TWO_LEAVE = 0.75
"""Nats by which two faults must explain more than one, as one more than none, the width of that step, and the most NIS
beyond the calm one that they may leave over what one leaves."""

UNKNOWN = (-5.0, 29.0)
UNKNOWN_LEAVES = (0.65, 0.8)
UNKNOWN_WIDTH, UNKNOWN_LEAVES_WIDTH = 3.0, 0.03
"""The same of a disturbance of any shape: it explains far more for nearly as many nats, or more for many nats."""

UNSOUND, UNSOUND_WIDTH, UNSOUND_LEAVES = 2.5, 0.2, 0.1
"""NIS that the likeliest fault may leave over that of calmer seconds, the width of that step in its logarithm, and what
it may leave besides, over the NIS without any fault: beyond both, nothing explains the fall."""

ODD = 15.0  # nats by which a size that no robot meets must explain more than the likeliest: something acts like it
SLIPPERY = 0.3  # of the probability of something unknown that is left where a slip explains most
PUSH_LEAVES = 0.065  # of the NIS without any fault, that a fault and a push beside it may leave
LITTLE = 0.3  # of the calm NIS beyond it, which pushes beside one fault leave where it stands for two
NOISE = 0.1  # of the calm NIS, that counts as nothing left
FITS_TWO = 2.7  # NIS over the calm one, that two faults may leave
STOOD = 0.1  # [s] after the beginning of what is judged: a fault that shows earlier was there before
HALF = 0.8  # of the lean that topples, from which a push beside a fault is a cause of its own

KNOCK = 0.1  # [rad] lean that a push is worth, below which it is a knock as robots meet them

JUMP = 0.22  # [m/s] sudden change of the reference speed that asks too much, or
JUMP_OF_TOP = 0.6  # of the speed at which the motors have no torque left
PUSH_BESIDE = 30.0  # nats that a push must add beside a fault to be a cause of its own
SATURATED = 0.3  # fraction of the last excursion at the limit from which it counts as saturated
FOREIGN_PEGGED, FOREIGN_WIDTH = 0.4, 0.04  # fraction of the last second, for another robot, and the
FOREIGN_MOST = 0.45  # most that it shows: motors come to their limit in every fall, whatever its cause
SWINGS = 7.0  # changes of the command's sign a second from which a robot falls by swinging
SAME_GAIN = 0.1  # of one: a gain that the file confirms
GAIN_WITHOUT_FILE, GAIN_WITH_FILE, AT_LIMIT = 0.8, 0.9, 0.5  # probability that is left to the gain, or to saturation
HIDDEN = 0.5  # the same where another cause hides: in the noise of a calibration, or for want of references
IN_PART = 0.3  # of it where the log begins within the last excursion
NO_TORQUE, NO_TORQUE_WIDTH = 0.85, 0.02  # [1] of the speed without torque: what is left of it stops no fall
BROKEN_DOWN, BROKEN_DOWN_WIDTH = 0.6, 0.03  # [1] of the voltage before: what stalled motors leave of a sound battery
CLEAR = 0.9  # of it for the gain that the fall's shape shows
BORNE_OUT = {PUSH: 0.67, BATTERY: 0.67, NONE: 0.5}
PAIR = 0.57
"""The most that is said of a push, a weak battery, none of these and two causes, as falls of two simulators that are
not ours bear it out (docs/post-mortem.md, "How often a number is right")."""
UNFINISHED, PLAIN = 0.5, 0.95  # the same of a search without time, and from which on a verdict is a fact
LEAST = 1e-4  # of a likelihood, below which a cause is left out


def ranked(evidence: Evidence) -> tuple[Cause, ...]:
    """All causes that have some likelihood, the likeliest first."""
    left = 1.0
    odds = dict[str, float]()
    best = dict[str, Answer]()
    foreign = evidence.ordinary > FOREIGN
    for question in QUESTIONS:
        if foreign and question in OF_THE_MODEL:
            continue
        answers = question(evidence)
        for answer in answers:
            odds[answer.name] = (before := odds.get(answer.name, 0.0)) + left * answer.probability
            if left * answer.probability > before or answer.name not in best:
                best[answer.name] = answer
        left *= 1 - min(sum(answer.probability for answer in answers), 1.0)
    odds[CANNOT_TELL] = odds.get(CANNOT_TELL, 0.0) + left
    if CANNOT_TELL not in best or left > best[CANNOT_TELL].probability:
        best[CANNOT_TELL] = Answer(left, CANNOT_TELL, math.nan, nothing(evidence))
    order = sorted((name for name in odds if odds[name] > LEAST), key=lambda name: -odds[name])
    total = sum(odds[name] for name in order)
    return tuple(
        Cause(
            name,
            odds[name] / total,
            max(min(answer.onset, evidence.fell_at), evidence.run.log.t[0]),  # it may have been falling by then
            answer.evidence,
            answer.push,
        )
        for name, answer in ((name, best[name]) for name in order)
    )


def stated(causes: tuple[Cause, ...], *, unfinished: bool) -> tuple[Cause, ...]:
    """The causes, the first by no more than verdicts of its kind bear out, the others by what that leaves: of an
    `unfinished` search all but plain facts."""
    first, *rest = causes
    most = PAIR if len(first.parts) > 1 else BORNE_OUT.get(first.name, 1.0)
    most = min(most, UNFINISHED) if unfinished and first.likelihood < PLAIN else most
    if first.likelihood <= most or not rest:
        return causes
    part = (1 - most) / sum(one.likelihood for one in rest)
    return replace(first, likelihood=most), *(replace(one, likelihood=part * one.likelihood) for one in rest)


def reversed_causes(evidence: Say | None, onset: float) -> tuple[Cause, ...]:
    """The causes of a fall in which something worked against its purpose, by what `fall.against` says of it."""
    if evidence is None:
        return ()
    unsure = Cause(CANNOT_TELL, 1 - LIKELY, onset, Say("Too few rows to tell it from a push."))
    return Cause(REVERSED, LIKELY, onset, evidence), unsure


def _changed_robot(evidence: Evidence) -> list[Answer]:
    """Whether a fault of robot, sensors or floor explains the innovations better than pushes alone."""
    best: dict[str, FaultFit] = {}
    for fit in evidence.fits:
        if fit.fault in NAMES and possible(fit, evidence.fell_at):
            best[fit.fault] = max(best.get(fit.fault, fit), fit, key=evidence.nats)
    side = held_wheel(evidence, best)
    weights = weighed(evidence, best, held=bool(side))
    answers: list[Answer] = []
    for name, fit in best.items():
        chance = FACT * weights[name] * holds(evidence, fit)
        answers.append(Answer((1 - HELPED) * chance, name_of(fit), fit.onset, of_fault(evidence, fit)))
        helped = Say("A second cause need not show beside the likeliest one.")
        answers.append(Answer(HELPED * chance, CANNOT_TELL, fit.onset, helped))
    return answers


def _two(evidence: Evidence) -> list[Answer]:
    """Whether two faults at once explain the innovations, and neither alone; a push that goes far to topple is one."""
    pushed = _fault_and_push(evidence)
    top = max((evidence.nats(pair.both) for pair in evidence.pairs), default=0.0)
    several = [
        (answer, math.exp((evidence.nats(pair.both) - top) / TEMPER))
        for pair in evidence.pairs
        if (answer := _two_faults(evidence, pair, pushed)) is not None
    ]
    total = sum(weight for _, weight in several)
    answers = [replace(answer, probability=answer.probability * weight / total) for answer, weight in several]
    left = 1 - sum(one.probability for one in answers)
    return [*answers, *(replace(answer, probability=left * answer.probability) for answer in pushed)]


def _two_faults(evidence: Evidence, pair: Pair, pushed: Sequence[Answer]) -> Answer | None:
    """Whether a pair explains what neither of both does alone, and what a fault and a push do not; where these are two
    causes as well, as `pushed` has it, the likelihood alone decides."""
    best = best_of(evidence)
    names = [name_of(fit) for fit in (pair.first, pair.second)]
    first = min(evidence.fell_at - SECONDS, float(evidence.then[0]))
    if min(acts_from(evidence.run, fit) for fit in (pair.first, pair.second)) < first + STOOD:
        return None  # the robot stood with it
    if names[0] == names[1] or not all(possible(fit, evidence.fell_at) for fit in (pair.first, pair.second)):
        return None
    if any(slight(fit) for fit in (pair.first, pair.second)):
        return None
    more = TWO
    if not _topples(evidence, pair.second.pushes, pair.second):  # else it is a third cause
        more *= 1 - max((answer.probability for answer in pushed), default=0.0)
    more_nats = evidence.nats(pair.both) - evidence.nats(best)
    chance = step(min(more_nats - more, pair.beyond - TWO), TWO_WIDTH)
    leaves, one_leaves = (_beyond_noise(evidence, nis) for nis in (pair.second.nis, best.nis))
    if one_leaves > LITTLE * evidence.calm:  # else the likelihood alone decides
        chance *= step(TWO_LEAVE - leaves / one_leaves, EXPLAINED_WIDTH)
    if evidence.left is not None:  # one unknown cause rather than two that are known
        chance *= step(evidence.nats(pair.both) - evidence.nats(evidence.left), TWO_WIDTH)
    chance *= step(FITS_TWO - pair.second.nis / evidence.calm, FITS_WIDTH)
    text = Say("{one} {other}", one=of_fault(evidence, pair.first), other=of_fault(evidence, pair.second))
    began_at = min(pair.first.onset, pair.second.onset)
    return Answer((1 - HELPED) * FACT * chance, AND.join(names), began_at, text)


def _topples(evidence: Evidence, pushes: Sequence[PushEstimate], fit: FaultFit) -> bool:
    """Whether pushes beside a fault go far to topple the robot."""
    lean, push = worth(evidence, pushes, unsettled(evidence, fit))
    return push is not None and lean > HALF * toppling_lean(evidence)


def _fault_and_push(evidence: Evidence) -> list[Answer]:
    """Whether a push beside the likeliest fault goes far to topple the robot."""
    best = best_of(evidence)
    if best.fault not in NAMES or best.fault == "slip":  # a slip and a push look alike
        return []
    lean, push = worth(evidence, best.pushes, unsettled(evidence, best))
    if push is None:
        return []
    limit = toppling_lean(evidence)
    beyond = lean / limit
    if best.fault == "weak":  # these motors bring back less
        weak = max(limit * best.size, min(KNOCK, limit))
        beyond = max(beyond, abs(evidence.toppling.lean(push)) / weak)
    chance = step(beyond - HALF, LIMIT_WIDTH) * holds(evidence, best)
    chance *= step(push.score - PUSH_BESIDE, PUSH_SCORE_WIDTH)
    chance *= step(PUSH_LEAVES - (best.nis - evidence.calm) / evidence.nis, PUSH_LEAVES / 6)
    chance *= 1 - unexplained(evidence, best.nis, best.fault)
    text = Say("{one} {other}", one=of_fault(evidence, best), other=of_push(blow(evidence, push, lean)))
    name = AND.join((name_of(best), PUSH))
    return [Answer((1 - HELPED) * FACT * chance, name, min(best.onset, push.start), text)]


def _beyond_noise(evidence: Evidence, nis: float) -> float:
    """What a hypothesis leaves, over what nothing explains."""
    return max(nis - evidence.calm, NOISE * evidence.calm)


def _none(evidence: Evidence) -> list[Answer]:
    """Whether what the likeliest leaves follows a disturbance of some other shape, or is far too much; where it is a
    little too much, something else keeps a small part of the probability."""
    left = evidence.left
    best = best_of(evidence)
    if left is None:
        return []
    leaves = left.nis / max(best.nis, 1e-9)
    gained = left.score - best.score
    shaped = max(
        step(gained - nats, UNKNOWN_WIDTH) * step(fraction - leaves, UNKNOWN_LEAVES_WIDTH)
        for nats, fraction in zip(UNKNOWN, UNKNOWN_LEAVES, strict=True)
    )
    badly = unexplained(evidence, best.nis, best.fault)
    if best.fault == "slip":  # of a coarse grid of floors
        shaped *= SLIPPERY
        badly *= SLIPPERY
    shaped *= step(best.nis / evidence.calm - FITS_BADLY, FITS_WIDTH)
    wild = step(math.log(max(best.nis, 1e-9) / (UNSOUND * evidence.calm)), UNSOUND_WIDTH)
    wild *= step(best.nis / evidence.nis - UNSOUND_LEAVES, EXPLAINED_WIDTH)
    answers = [Answer(FACT * max(shaped, wild, badly), NONE, left.onset, of_leftover(left, evidence.run.robot))]
    several = [fit for fit in evidence.fits if fit.fault in NAMES and not slight(fit)]
    odd = max(several, key=lambda fit: fit.score, default=best)
    if odd is not best and not possible(odd, evidence.fell_at):
        chance = step(odd.score - best.score - ODD, TEMPER) * (1 - unexplained(evidence, odd.nis, odd.fault) / DOUBT)
        text = Say("Something acts like this, though no robot meets so much: {fault}", fault=of_fault(evidence, odd))
        answers.append(Answer(FACT * (1 - answers[0].probability) * chance, NONE, odd.onset, text))
    return answers


def _demanded(evidence: Evidence) -> list[Answer]:
    """Whether the reference asked for more than the motors have."""
    demand = evidence.demand
    if demand is None:
        return []
    limit = min(JUMP, JUMP_OF_TOP * demand.top_speed)
    chance = LIKELY * step(demand.jump / limit - 1, LIMIT_WIDTH)
    return [Answer(chance, SATURATION, demand.at, of_demand(evidence, demand, limit))]


def _out_of_speed(evidence: Evidence) -> list[Answer]:
    """Whether the wheels turned, while the robot was upright, as fast as its motors can: no gain gives torque there.
    Not in a log that begins while it falls, since a push may have been before, nor where the references ask for less:
    motors that give too little run after the fall until they are as fast."""
    speed = evidence.motors.speed
    since = began(evidence)
    demand = evidence.demand
    slow = demand is not None and demand.fastest < JUMP_OF_TOP * demand.top_speed
    if since < evidence.run.log.t[0] or slow:
        return []
    part = percent(min(speed, 1.0))
    text = Say("Upright, the wheels reached {part} of the speed at which motors give no torque.", part=part)
    lags = demand is None and 0.0 < evidence.motors.help < 1.0  # so does a low gain, and only references tell the two
    sure = HIDDEN if evidence.run.robot.noise or lags else CLEAR
    return [Answer(sure * step(speed - NO_TORQUE, NO_TORQUE_WIDTH), SATURATION, since, text)]


def _run_down(evidence: Evidence) -> list[Answer]:
    """Whether the battery's own channel shows that it broke down: commands that are scaled by it are only small then,
    and motors that turn at full duty make none lose so much."""
    before, last = evidence.battery
    if not math.isfinite(last + before) or before <= 0:
        return []
    chance = CLEAR * step(BROKEN_DOWN - last / before, BROKEN_DOWN_WIDTH)
    shown = {"last": Quantity(last, "V"), "before": Quantity(before, "V")}
    text = Say("The battery shows {last}, before {before}: commands that are scaled by it are small.", **shown)
    return [Answer(chance, BATTERY, began(evidence), text)]


def _weak_or_wild(evidence: Evidence) -> list[Answer]:
    """What is left: the gain, by how the robot fell, unless the file shows that it is right."""
    motors = evidence.motors
    match = evidence.match
    since = began(evidence)
    pegged = FOREIGN_MOST * step(motors.pegged - FOREIGN_PEGGED, FOREIGN_WIDTH)
    if evidence.ordinary > FOREIGN:
        return [Answer(pegged, SATURATION, since, of_pegged(evidence))]
    if match is not None and match.known and abs(match.gain - 1) < SAME_GAIN and evidence.stable is not False:
        saturated = percent(motors.saturated)
        text = Say(
            "The commands are the file's; the motors were at their limit for {part} of the fall.", part=saturated
        )
        return [Answer(AT_LIMIT, SATURATION, since, text)] if motors.saturated > SATURATED else []
    large = motors.saturated > 0 and not 0.0 < motors.help < 1.0  # as the commands of a gain that is too high are
    wild = (large or motors.swings >= SWINGS) and not motors.half_swing > SLOWLY
    low = 1 - CLEAR if wild or math.isfinite(evidence.slid) else CLEAR
    gain = GAIN_WITHOUT_FILE if match is None else GAIN_WITH_FILE
    if since < evidence.run.log.t[0] and not let_go(evidence):  # neither swings nor what came before show
        gain *= IN_PART
    answers: list[Answer] = []
    if evidence.run.robot.noise:  # it hides faults, so that what is left need not be the gain
        answers = [Answer(pegged, SATURATION, since, of_pegged(evidence))]
        gain = (1 - pegged) * HIDDEN
    return [
        *answers,
        Answer(gain * low, LOW, since, of_low(evidence)),
        Answer(gain * (1 - low), HIGH, since, of_high(evidence, SWINGS)),
    ]


QUESTIONS: tuple[Callable[[Evidence], list[Answer]], ...] = (
    switched_off, stuck, stuck_sensor, changed_gain, lost_rows, thrown_over, pushed_already, _two, driven_into, _none,
    _changed_robot, pushed, _demanded, _out_of_speed, _run_down, _weak_or_wild,
)  # fmt: skip

OF_THE_MODEL = {pushed_already, _two, driven_into, _none, _changed_robot, pushed, _out_of_speed}
"""Questions to the innovations of a model that describes the robot. Those of another robot's model are largest where
the robot moves most, so in the fall, and look like whatever grows with the motion."""
