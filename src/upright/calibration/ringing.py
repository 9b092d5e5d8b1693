"""What a gyro reads of the pitch rate r through a resonance of second order: g̈ + 2ζω ġ + ω² g = ω² r.

Two states, g and p = ġ/ω, are moved with the robot, step by step. Over a step r is the parabola through its first and
last value whose mean is the change of the pitch over the step. Under a parabola their power series has no other error
than its end.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from upright.calibration.motion import INSTANT, SPAN, START, begun, inlined, njit, step
from upright.compiled.generated import PITCH, PITCH_RATE
from upright.compiled.jit import get

SWINGS = 2
"""States of a resonance."""
TERMS = 12  # of the power series: the next is 1/13! of what goes in, a part in 10¹⁰
INVERSE = (0.0, *(1 / term for term in range(1, TERMS + 1)))  # a processor multiplies ten times faster than it divides
FASTEST = 1e4  # [rad] of phase between two events: beyond it nothing is computed


@inlined
def rung(g: Any, p: Any, first: Any, last: Any, mean: Any, phase: Any, damping: Any) -> Any:
    """g and p after the `phase` ω h, while the pitch rate goes from `first` to `last` with this `mean`."""
    if not abs(phase) * (1 + 2 * damping) < FASTEST:
        return np.nan, np.nan
    pieces = max(1, math.ceil(abs(phase) * (1 + 2 * damping)))
    part = 1.0 / pieces
    bend = 6 * mean - 3 * (first + last)
    slope = last - first + bend
    turn = phase * part
    for piece in range(pieces):
        at = piece * part
        rate_0 = first + (slope - bend * at) * at
        rate_1 = (slope - 2 * bend * at) * part
        rate_2 = -bend * part * part
        a = turn * p
        b = turn * (rate_0 - g - 2 * damping * p)
        g, p = g + a, p + b
        half, third = turn * INVERSE[2], turn * INVERSE[3]
        a, b = half * b, half * (rate_1 - a - 2 * damping * b)
        g, p = g + a, p + b
        a, b = third * b, third * (rate_2 - a - 2 * damping * b)
        g, p = g + a, p + b
        for term in range(4, TERMS + 1):
            a, b = turn * INVERSE[term] * b, -turn * INVERSE[term] * (a + 2 * damping * b)
            g, p = g + a, p + b
    return g, p


@njit
def moved(w: Any, u: Any, start: Any, stop: Any, longest: Any, swing: Any, offsets: Any) -> None:
    """As `move`, and with it the two states of a resonance, the last of `offsets` (offsets, lanes); `swing` (2, lanes)
    is ω [rad/s] and ζ, or nothing where there is none. The parabola is of one step of the motion, not of the whole."""
    count = len(start)
    steps, rolls = begun(w, count, u, start, stop, longest)
    for _ in range(steps):
        step(w, count, steps, rolls)
        if len(swing):
            _ring(w, count, steps, swing, offsets)


@njit
def _ring(w: Any, count: Any, steps: Any, swing: Any, offsets: Any) -> None:
    """The two states of a resonance over the step that the robots have just done."""
    tail = len(offsets) - SWINGS
    for i in range(count):
        h = get(w, SPAN, i) / steps
        if abs(h) > INSTANT / steps:
            mean = (get(w, PITCH, i) - get(w, START, i)) / h
            offsets[tail, i], offsets[tail + 1, i] = rung(
                offsets[tail, i], offsets[tail + 1, i], get(w, START + 1, i), get(w, PITCH_RATE, i), mean,
                swing[0, i] * h, swing[1, i],
            )  # fmt: skip


@njit
def undriven(span: Any, swing: Any, whole: Any) -> None:
    """∂(g, p)(stop)/∂(g, p)(start) over the `span` [s], into the corner of `whole` (s, s)."""
    tail = len(whole) - SWINGS
    phase = swing[0, 0] * span
    damping = swing[1, 0]
    whole[tail, tail], whole[tail + 1, tail] = rung(1.0, 0.0, 0.0, 0.0, 0.0, phase, damping)
    whole[tail, tail + 1], whole[tail + 1, tail + 1] = rung(0.0, 1.0, 0.0, 0.0, 0.0, phase, damping)
