"""What margins are held against: the limits of a certificate, and the usual targets of textbooks."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from upright.loops.margins import Margins

ROUNDED = 1e-6  # an integrator's pole, which is at 1 but for rounding, is not unstable

LEAST_GAIN = 0.04  # amber below: copper that warms by 10 K takes 4 % of the motor's gain
LEAST_DELAY = 0.25  # [periods] amber below: a loop that runs in time still jitters by a tenth or two of its period

CLOSE = 0.5
"""Distance of the Nyquist curve from −1 below which margins are small: the usual rule, Ms at most 2."""
PHASE, WEAK, STRONG = 30.0, 0.5, 2.0
"""Usual targets: phase margin [°], and the gain of the motors as a factor: 6 dB either side."""


@dataclass(frozen=True)
class Thinnest:
    """The margin that comes nearest to its limit of a certificate: of which `kind`, its `size` [s, or 1 of a gain], the
    `channel` where it is so small, and the `part` [1] of the limit that it has: below 1 the light is amber."""

    kind: Literal["delay", "stronger", "weaker"]
    size: float
    channel: str
    part: float

    @property
    def thin(self) -> bool:
        """Whether a certificate is amber for it."""
        return self.part < 1


def thinnest(every: Sequence[Margins], period: float) -> Thinnest:
    """Of the margins of `every` place of a stable loop that runs each `period` [s]."""
    slow = min(every, key=lambda m: m.delay)
    up = min(every, key=lambda m: m.gain_high)
    down = max(every, key=lambda m: m.gain_low)
    kinds = (
        Thinnest("delay", slow.delay, slow.channel, slow.delay / (LEAST_DELAY * period)),
        Thinnest("stronger", up.gain_high - 1, up.channel, (up.gain_high - 1) / LEAST_GAIN),
        Thinnest("weaker", 1 - down.gain_low, down.channel, (1 - down.gain_low) / LEAST_GAIN),
    )
    return min(kinds, key=lambda kind: kind.part)


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
