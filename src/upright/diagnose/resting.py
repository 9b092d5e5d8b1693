"""How likely single faults are beside each other: a wheel that rests is jammed, or its motor is dead."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np

from upright.diagnose.chances import SURE
from upright.diagnose.evidence import Evidence
from upright.diagnose.facts import IDLE, TEMPER
from upright.diagnose.fault_fits import FaultFit

RESTS = 0.1
"""[rad] that a wheel turns against the body at most where it rests: play and a few steps of an encoder. Where a motor
without torque lets it go, it turns by more before the body lies."""


def weighed(evidence: Evidence, best: Mapping[str, FaultFit], *, held: bool) -> dict[str, float]:
    """The part of the probability of each fault, of those that are the `best` of their kind, by their likelihoods. A
    wheel that is `held` is jammed, or the friction of a motor without torque holds it: which of both explains a little
    more follows from how little it creeps, and no model of friction knows that."""
    top = max((evidence.nats(fit) for fit in best.values()), default=0.0)
    weights = {name: math.exp(max((evidence.nats(fit) - top) / TEMPER, -50.0)) for name, fit in best.items()}
    total = sum(weights.values())
    weights = {name: weight / total for name, weight in weights.items()}
    if held:
        both = weights["motor"] + weights["friction"]
        weights |= {"motor": IDLE * both, "friction": (1 - IDLE) * both}
    return weights


def held_wheel(evidence: Evidence, best: Mapping[str, FaultFit]) -> str:
    """The wheel that rests, "left" or "right", where a jam and a dead motor explain that about as well; else ""."""
    dead, jam = best.get("motor"), best.get("friction")
    if dead is None or jam is None or jam.way not in dead.way or abs(evidence.nats(dead) - evidence.nats(jam)) > SURE:
        return ""
    log = evidence.run.log
    name = f"sensor/encoder_{jam.way}"
    if name not in log:
        return ""
    angle = log[name][(log.t >= max(dead.onset, jam.onset)) & (log.t <= evidence.fell_at)]
    return jam.way if len(angle) and float(np.nanmax(angle) - np.nanmin(angle)) < RESTS else ""
