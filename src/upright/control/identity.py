"""Which controller this is: what it was designed from, and the numbers that came out.

A design is the same on every processor, its numbers are not: matrix routines of different processors round differently
(docs/certificate.md says how much). So two controllers are one where their numbers are equal, or where they were
designed from the same and command alike within `TOLERANCE`.
"""

from __future__ import annotations

import hashlib
import json
import math
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np

from upright.control.controller import Controller, controller_hash
from upright.robots import Kit, Robot
from upright.robots.facts import kit_facts, robot_facts

TOLERANCE = 1e-6
"""Largest difference of two commands, over the largest: a thousand times what the kernels of OpenBLAS for Nehalem,
Prescott, Sandybridge and Haswell make of one design (7e-10 for H∞, below 2e-11 for all others), and a ten-thousandth
of a motor's step of duty."""
STEPS = 40  # periods of readings that a controller is tried on: a second or two, in which an unstable one does not grow
NUMBERS = 6  # into which their commands are summed up
SIZE = 0.01  # [unit of the channel] of a reading: near rest

C = TypeVar("C", bound=Controller)


@dataclass(frozen=True)
class Identity:
    """`hash` of the numbers, hash of what was `asked` ("" where not known), and the `response` to fixed readings."""

    hash: str
    asked: str = ""
    response: tuple[float, ...] = ()

    def differs(self, other: Identity) -> str:
        """Why this is not that controller, as part of a sentence; empty where it is."""
        if self.hash == other.hash:
            return ""
        if not (self.asked and other.asked):
            return f"another controller, {self.hash[:12]} instead of {other.hash[:12]}"
        if self.asked != other.asked:
            return "another controller: other robot, kit, period, method or weights were asked for"
        if (apart := _apart(self.response, other.response)) > TOLERANCE:
            return f"the same design, but its commands differ by {apart:.1g} of the largest: another version or an edit"
        return ""


def identity(controller: Controller) -> Identity:
    """Of that controller, which forgets what it remembers of a run."""
    return Identity(controller_hash(controller), asked_of(controller), _response(controller))


def asked_of(controller: Controller) -> str:
    """The hash of what a controller was designed from; "" for one that was changed, or made in another way."""
    return getattr(controller, "_asked", "")


def designed_from(controller: C, asked: str) -> C:
    """The controller, which remembers the hash of what was `asked`; a copy by `dataclasses.replace` does not."""
    with suppress(AttributeError):  # one of a plug-in that cannot remember: its numbers alone identify it
        object.__setattr__(controller, "_asked", asked)
    return controller


def request_hash(method: str, robot: Robot, kit: Kit, dt: float, **weights: Any) -> str:
    """SHA-256 of what a design is asked for: the same on every processor."""
    request = {"method": method, "robot": robot_facts(robot), "kit": kit_facts(kit), "dt": dt, **weights}
    return hashlib.sha256(json.dumps(request, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


def _response(controller: Controller) -> tuple[float, ...]:
    """Its commands on fixed readings near rest, summed up with fixed weights; empty where they are not finite."""
    rng = np.random.Generator(np.random.Philox(2015))
    readings = SIZE * rng.standard_normal((STEPS, len(controller.spec.reads)))
    weights = rng.standard_normal((NUMBERS, 2 * STEPS))
    controller.reset()
    commands = list[float]()
    for row in readings:
        command = controller.step(row, np.zeros(6))
        controller.applied(command)
        commands += [float(u) for u in command]
    controller.reset()
    # exact sums, since the order of a processor's own would count
    sums = [math.fsum(w * u for w, u in zip(row, commands, strict=True)) for row in weights.tolist()]
    return tuple(sums) if all(map(math.isfinite, sums)) else ()


def _apart(one: tuple[float, ...], two: tuple[float, ...]) -> float:
    if not one or len(one) != len(two):
        return math.inf
    largest = max(map(abs, (*one, *two))) or 1.0
    return max(abs(a - b) for a, b in zip(one, two, strict=True)) / largest
