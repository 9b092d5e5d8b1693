"""How likely a fault, or a push, is a cause at all."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from upright.arrays import Array
from upright.diagnose.causes import DEAD, NAMES, PUSH, REVERSED
from upright.diagnose.evidence import Evidence
from upright.diagnose.fall import LEANING, authority, pace
from upright.diagnose.fault_fits import CORRELATED, FaultFit, PushEstimate
from upright.diagnose.sizes import possible, turned
from upright.diagnose.usual import CALMER
from upright.diagnose.words import gained

SURE, SURE_WIDTH = 15.0, 3.0
"""Nats by which a fault must explain more than pushes alone to be as likely as not, and the width of that step."""

EXPLAINED, LIKE_A_PUSH, EXPLAINED_WIDTH, ONLY_NOISE = 0.55, 0.74, 0.03, 1.1
"""Most NIS that a fault may leave over what pushes alone leave, that a slip may leave beside a push that topples, the
width of both steps, and the NIS over the calm one that is noise, where the likelihood alone decides."""

FITS_BADLY, FITS_WIDTH, DOUBT = 1.45, 0.05, 0.75
"""NIS over the calm one beyond which a hypothesis leaves something, the width of that step, and the probability that
something else took part then: so it was in most of such falls (docs/post-mortem.md)."""

OF_WHAT_IT_DID, BY_MODEL = 0.05, 0.8
"""Of what a robot did, what errors of its parameters may leave, and of the calm NIS the most of it, since small changes
of them are beside every hypothesis already."""

BY_TIMES = 0.03
"""Of the NIS without any fault, that late readings and repeated ones leave: delays between whole periods, and those of
readings, are only near to those of commands, and not every repeated row is one."""

EMPTY = 0.02  # of its voltage: less is no supply, or a driver that is off
TOPPLES = 0.3  # [rad] lean that a push must be worth to topple, or
TOPPLES_OF_LARGEST = 0.4  # of the largest lean that the motors bring back
LIMIT_WIDTH = 0.1  # of these limits: the width of their steps
NO_RETURN = 1.3  # times the largest lean that the motors bring back, from which nothing saves a robot
FELLS = 0.8  # of the lean that no motors bring back, from which a push fells a robot however long that takes
EARLIER = 0.6
"""Of a push's probability, where it came before the last excursion and the robot never came to rest since: a gain that
is too low answers it in the same way, and without the controller's file the log does not show which."""
PEGGED = 0.95  # fraction of the last second at the limit, where commands that never change are full ones
BEGINS, WITH_EASE = 0.1, 0.5  # [s] of a log, and of the largest command, what saves a robot that was let go there
RESTED = 0.4  # [s] of a quick robot at rest, by its lean over the largest that its motors bring back:
AT_REST, RESTLESS = 0.03, 4.0  # below this, or below so many times what it has in calmer times
PUSH_SCORE, PUSH_SCORE_WIDTH = 8.0, 2.0  # nats that a push must add to be one


def step(x: float, width: float) -> float:
    """From 0 to 1 round x = 0 over some `width`s (logistic)."""
    return 1 / (1 + math.exp(-min(max(x / width, -50.0), 50.0)))


def best_of(evidence: Evidence) -> FaultFit:
    """The likeliest of single faults that hold, and of pushes alone."""
    held = (
        fit
        for fit in evidence.fits
        if fit.fault in NAMES and possible(fit, evidence.fell_at) and holds(evidence, fit) > 0.5
    )
    return max([evidence.pushes_only, *held], key=evidence.nats)


def holds(evidence: Evidence, fit: FaultFit) -> float:
    """How likely a fault is a cause at all: it explains much more than pushes alone, and most of what those leave, or
    all of it where they leave more than noise; a slip, which looks like a push, has to leave less where a push would
    topple by itself."""
    sure = surer(evidence, fit)
    if fit.fault != "slip":
        noise = step(ONLY_NOISE - fit.nis / evidence.calm, EXPLAINED_WIDTH)
        noise *= step(evidence.pushes_only.nis / evidence.calm - ONLY_NOISE, EXPLAINED_WIDTH)
        return max(sure * max(enough(evidence, fit, EXPLAINED), noise), _by_own_noise(evidence, fit))
    like = enough(evidence, fit, LIKE_A_PUSH)
    return sure * like * (1 - toppled(evidence)[0] * (1 - like))


def _by_own_noise(evidence: Evidence, fit: FaultFit) -> float:
    """The same by the noise of this log, whose sensors may have less than the kit says: it leaves only that, and pushes
    alone clearly more, since that noise is the least that any of all hypotheses leaves. By the kit's noise it has to
    explain as much more: what a file that is a little wrong leaves of a violent push is above the log's noise too."""
    none, noise = evidence.pushes_only, evidence.noise
    if noise >= evidence.calm:
        return 0.0
    sure = step(min(evidence.nats(fit) - evidence.nats(none), gained(evidence, fit)) - SURE, SURE_WIDTH)
    left = step(ONLY_NOISE - evidence.misfit(fit) / noise, EXPLAINED_WIDTH)
    return sure * left * step(evidence.misfit(none) / noise - FITS_BADLY, FITS_WIDTH)


def surer(evidence: Evidence, fit: FaultFit) -> float:
    """Whether it explains much more than pushes alone."""
    return step(gained(evidence, fit) - SURE, SURE_WIDTH)


def enough(evidence: Evidence, fit: FaultFit, most: float) -> float:
    """Whether it leaves at most such a fraction of the NIS that pushes alone leave."""
    return step(most - fit.nis / evidence.pushes_only.nis, EXPLAINED_WIDTH)


def name_of(fit: FaultFit) -> str:
    """The cause that a fit stands for; a battery that gives nothing at all is no weak one: it also feeds the logger."""
    if fit.fault == "weak" and fit.size < EMPTY:
        return DEAD
    return REVERSED if turned(fit) else NAMES.get(fit.fault, PUSH)


def toppled(evidence: Evidence) -> tuple[float, float, PushEstimate | None]:
    """How likely pushes topple, in the last excursion or by far before, the lean [rad] that they are worth, and the
    largest. Earlier ones, since which the robot has not come to rest, may have: a slow fall takes longer than that."""
    none = evidence.pushes_only
    fells = FELLS * min(evidence.toppling.largest, LEANING)
    if evidence.motors.stuck and evidence.motors.pegged > PEGGED:  # they gave all they had since a push
        fells = toppling_lean(evidence)
    restless = unsettled(evidence, none)
    far = [one.start for one in none.pushes if one.stop > restless and abs(evidence.toppling.lean(one)) > fells]
    since = min([evidence.fell_at - evidence.excursion, *far])
    recent, earlier = (_toppled_since(evidence, start) for start in (since, restless))
    return recent if recent[0] >= EARLIER * earlier[0] else (EARLIER * earlier[0], *earlier[1:])


def toppling_lean(evidence: Evidence) -> float:
    """The lean [rad] that pushes must be worth to topple."""
    return min(TOPPLES, TOPPLES_OF_LARGEST * evidence.toppling.largest)


def _toppled_since(evidence: Evidence, since: float) -> tuple[float, float, PushEstimate | None]:
    """The same of pushes `since` a time [s]."""
    lean, largest = worth(evidence, evidence.pushes_only.pushes, since)
    if largest is None:
        return 0.0, 0.0, None
    chance = step(lean / toppling_lean(evidence) - 1, LIMIT_WIDTH)
    return chance * step(largest.score - PUSH_SCORE, PUSH_SCORE_WIDTH), lean, largest


def unexplained(evidence: Evidence, nis: float, fault: str = "") -> float:
    """How likely something else took part, or was the cause, where a hypothesis leaves such a NIS."""
    return DOUBT * fits_badly(evidence, nis, fault)


def fits_badly(evidence: Evidence, nis: float, fault: str = "") -> float:
    """From 0 to 1: how clearly a hypothesis that leaves such a NIS leaves something."""
    by_model = OF_WHAT_IT_DID**2 * evidence.nis / evidence.calm
    if fault != "friction":  # which varies along a wheel's turn, and no small change of the robot is like that
        by_model = min(by_model, BY_MODEL)
    if fault in ("delay", "dropped"):
        by_model = BY_TIMES * evidence.nis / evidence.calm
    return step(nis / evidence.calm - FITS_BADLY - by_model, FITS_WIDTH)


def lost_before(evidence: Evidence) -> float:
    """When [s] the robot leaned by so much more than its motors bring back that nothing later is a cause."""
    motors = authority(evidence.run)
    inside = motors.t <= evidence.fell_at
    saved = np.flatnonzero(motors.reserve[inside] < NO_RETURN)
    return float(motors.t[inside][saved[-1]]) if len(saved) else float(motors.t[0])


def let_go(evidence: Evidence) -> bool:
    """Whether the log begins with a robot that its motors would have saved with ease: no push before it is a cause."""
    motors = authority(evidence.run)
    return float(np.median(motors.reserve[motors.t < motors.t[0] + BEGINS])) < WITH_EASE


def explains_the_start(evidence: Evidence) -> bool:
    """Whether pushes that topple leave only noise, and no more than any fault leaves, up to where nothing saves the
    robot: what comes later, wheels that slide under a body on its way to the floor for instance, is no cause."""
    none = evidence.pushes_only
    lost = lost_before(evidence)
    pushes = [push for push in none.pushes if push.stop < lost]
    lean, largest = worth(evidence, pushes)
    if largest is None or lean < evidence.toppling.largest:
        return False
    nis, nats = left_until(evidence, lost)
    return nis <= FITS_BADLY * evidence.calm and nats < SURE


def left_until(evidence: Evidence, end: float, weights: Array | None = None) -> tuple[float, float]:
    """The NIS that pushes alone leave up to a time [s], and the nats by which some hypothesis explains more until then,
    by the `weights` of the readings (none: all count alike); NaN where nothing is read before."""
    none = evidence.pushes_only
    rows = np.flatnonzero(evidence.then < end)
    if not len(rows) or len(none.rest) < len(evidence.then):
        return math.nan, math.nan
    counts = np.ones(len(rows)) if weights is None else weights[rows]
    several = [float(counts @ fit.rest[rows] ** 2) for fit in evidence.fits if len(fit.rest) == len(none.rest)]
    mine = float(counts @ none.rest[rows] ** 2)
    floor = evidence.calm * float(counts.sum())
    return mine / float(counts.sum()), len(rows) / 2 / CORRELATED * math.log((mine + floor) / (min(several) + floor))


def sound_until(evidence: Evidence, end: float) -> float:
    """From 0 to 1: how likely robot and sensors were as they should be up to a time [s]. Pushes then leave no more than
    what the robot is known to, and no fault explains much more, unless they leave noise; nothing speaks against it
    where nothing was read."""
    nis, nats = left_until(evidence, end, evidence.weights)
    if math.isnan(nis):
        return 1.0
    changed = step(nats - SURE, SURE_WIDTH) * step(nis / evidence.calm - ONLY_NOISE, EXPLAINED_WIDTH)
    return step(FITS_BADLY - nis / evidence.calm, FITS_WIDTH) * (1 - changed)


def unsettled(evidence: Evidence, fit: FaultFit) -> float:
    """Since when [s] a robot with a fault has not come to rest: a loop that swings carries on what a push began."""
    motors = authority(fit.run or evidence.run)
    since = evidence.fell_at - evidence.excursion
    rested = RESTED * pace(evidence.run.robot)
    stops = np.arange(since, float(motors.t[0]) + rested, -rested)
    if not len(stops):
        return since
    leans = motors.reserve * max(1.0, evidence.toppling.largest / LEANING)  # over the largest that is no fall
    blocks = [leans[(motors.t > stop - rested) & (motors.t <= stop)] for stop in stops]
    largest = np.array([block.max() if len(block) else 0.0 for block in blocks])
    rests = largest < max(AT_REST, RESTLESS * float(np.quantile(largest, CALMER)))
    return since - rested * (int(np.argmax(rests)) if rests.any() else len(rests))


def worth(
    evidence: Evidence, several: Sequence[PushEstimate], since: float | None = None
) -> tuple[float, PushEstimate | None]:
    """The lean [rad] that pushes in the last excursion, or `since` a time [s], are worth, and the largest of them; one
    that still acts then is one of them."""
    toppling = evidence.toppling
    start = evidence.fell_at - evidence.excursion if since is None else since
    pushes = [push for push in several if push.stop > start]
    if not pushes:
        return 0.0, None
    largest = max(pushes, key=lambda push: abs(toppling.lean(push)))
    return abs(sum(one for push in pushes if (one := toppling.lean(push)) * toppling.lean(largest) > 0)), largest
