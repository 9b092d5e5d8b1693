"""Whether a push, a blow or a wall felled the robot."""

from __future__ import annotations

import math

from upright.checkup.finding import instant
from upright.diagnose.causes import CANNOT_TELL, LOAD, NAMES, PUSH, STUCK, WALL
from upright.diagnose.chances import (
    FITS_BADLY,
    PUSH_SCORE,
    PUSH_SCORE_WIDTH,
    best_of,
    explains_the_start,
    holds,
    sound_until,
    step,
    surer,
    toppled,
    worth,
)
from upright.diagnose.evidence import Evidence
from upright.diagnose.facts import TEMPER, Answer
from upright.diagnose.fall import blocked
from upright.diagnose.fault_fits import PushEstimate
from upright.diagnose.sizes import possible, slight
from upright.diagnose.thrown import FEW
from upright.diagnose.words import blow, of_fault, of_push, of_throw
from upright.pages import Quantity, Say

LIKELY = 0.95  # most probability of a demand or a steady load, PUSHED of a push: a fault may look like either
PUSHED = 0.97
HELPED = 0.1
"""Probability that something else took part in a fall that one cause explains: what is known of the log is that it does
not show it, and what is known of the robot is not that this cause alone fells it. Of ten pairs of faults neither of
which fells the robot, three do not show in their logs (docs/post-mortem.md); where pairs are a quarter of all falls,
that is one fall in ten."""

WALL_HEIGHT, WALL_HOLDS = 0.6, 2.0
"""Where a wall holds a robot, over the height of its centre of mass, and what it takes, over the robot's momentum: the
motors go on driving."""

FAILED, BRIEFLY = 0.25, 0.8
"""Of a blow's probability, that its gyro failed where nothing else shows it, and what is left of it at a log's end."""

MOST_SHARED, SHOWN = 0.45, 0.1
"""Of a push's probability, that a load beside it gets at most where both explain as much as the push alone, since one
cause is likelier than two; and from which part on the evidence says so."""

TOPPLED = 0.9  # probability that a push topples, from which its model is trusted


def driven_into(evidence: Evidence) -> list[Answer]:
    """Whether a push that shows was something that the robot drove into."""
    log, robot = evidence.run.log, evidence.run.robot
    mass = robot.body_mass + 2 * robot.wheel_mass
    for push in sorted(evidence.pushes_only.pushes, key=lambda push: push.start):
        wall = blocked(log, robot, push.start, push.impulse)
        low = push.height < WALL_HEIGHT * robot.com_height  # the wheels touch first
        if wall is not None and low and abs(push.impulse) > WALL_HOLDS * mass * abs(wall.speed):
            sure = step(push.score - PUSH_SCORE, PUSH_SCORE_WIDTH)
            others = [fit for fit in evidence.fits if fit.fault in NAMES and possible(fit, evidence.fell_at)]
            # a fault that explains much more than all pushes is no wall, though it need not be the whole cause
            free = 1 - max((max(holds(evidence, fit), surer(evidence, fit)) for fit in others), default=0.0)
            slip = max((fit.score for fit in others if fit.fault == "slip"), default=-math.inf)
            free *= step(evidence.pushes_only.score - slip, TEMPER)  # wheels that slip go no further either
            text = Say(
                "At {time} the wheels stopped within {distance} from {speed}.",
                time=instant(wall.start),
                distance=Quantity(max(wall.further, 0.0), "m", digits=2),
                speed=Quantity(wall.speed, "m/s", digits=2),
                impulse=Quantity(abs(push.impulse), "N s"),
            )
            return [Answer(LIKELY * sure * free, WALL, wall.start, text)]
    return []


def thrown_over(evidence: Evidence) -> list[Answer]:
    """Whether a blow threw the robot over, by its readings alone: no filter follows wheels that slide and lift off. A
    gyro that fails at the end of its range looks like it where the wheels show nothing."""
    throw = evidence.throw
    if throw is None or throw.start > evidence.slid:  # wheels that slide throw a body over as well
        return []
    by_model, _, _ = toppled(evidence)
    if by_model > TOPPLED and evidence.pushes_only.nis < FITS_BADLY * evidence.calm:
        return []  # the push is known better by what it did
    best = best_of(evidence)
    before = sound_until(evidence, throw.start)
    if best.fault in NAMES and before < 0.5 and best.nis < FITS_BADLY * evidence.calm:
        return []  # so are a fault that showed before, and the push beside it
    wall = sum(answer.probability for answer in driven_into(evidence))
    text = of_throw(throw)
    failed = 0.0 if throw.wheels or not throw.clipped else FAILED
    sure = (1 - wall) * (1 - HELPED) * (BRIEFLY if throw.rows < FEW else PUSHED)
    answers = [Answer((1 - failed) * sure, PUSH, throw.start, text)]
    if failed:
        at = instant(throw.start)
        other = Say("From {time} on the gyro stands at the end of its range; the wheels do not show why.", time=at)
        answers.append(Answer(failed * sure, STUCK, throw.start, other))
    if throw.rows < FEW:
        brief = Say("The log ends {left} after the blow.", left=Quantity(throw.left, "s", digits=2))
        answers.append(Answer(1 - sure, CANNOT_TELL, math.nan, brief))
    return answers


def pushed_already(evidence: Evidence) -> list[Answer]:
    """Whether pushes explain all until nothing could save the robot, whatever came on the way to the floor."""
    if thrown_over(evidence) or not explains_the_start(evidence):
        return []
    lean, push = worth(evidence, evidence.pushes_only.pushes)
    if push is None:
        return []
    return _with_load(evidence, PUSHED * (1 - HELPED), push, lean)


def _with_load(evidence: Evidence, chance: float, push: PushEstimate, lean: float) -> list[Answer]:
    """A push that felled the robot, which shares its probability with a load that came or went beside it, as far as
    that explains as much: a load hardly shows beside a push."""
    numbers = blow(evidence, push, lean)
    text = of_push(numbers)
    none = evidence.pushes_only
    loads = [fit for fit in evidence.fits if fit.fault == "payload" and fit.pushes and not slight(fit)]
    loads = [fit for fit in loads if possible(fit, evidence.fell_at)]
    if not loads:
        return [Answer(chance, PUSH, push.start, text, numbers)]
    load = max(loads, key=evidence.nats)
    part = min(step(evidence.nats(load) - evidence.nats(none), TEMPER), MOST_SHARED)
    if part > SHOWN:
        text = Say("{push} A load beside it explains about as much.", push=text)
    other = Say("{load} The push alone explains about as much.", load=of_fault(evidence, load))
    return [
        Answer((1 - part) * chance, PUSH, push.start, text, numbers),
        Answer(part * chance, f"{LOAD} and {PUSH}", min(load.onset, push.start), other),
    ]


def pushed(evidence: Evidence) -> list[Answer]:
    """Whether a push in the last excursion is worth a lean that topples: for the robot as it should be, so that a load
    that went, or a slope, may have helped it."""
    chance, lean, push = toppled(evidence)
    if push is None or thrown_over(evidence) or explains_the_start(evidence):
        return []
    return _with_load(evidence, PUSHED * (1 - HELPED) * chance, push, lean)
