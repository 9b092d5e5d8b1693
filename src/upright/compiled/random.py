"""The random numbers of `counter` in compiled code, for many robots at once: order, batch size and number of threads do
not matter."""

from __future__ import annotations

from typing import Any

import numpy as np

from upright.compiled import counter
from upright.compiled.counter import LOW, SHIFT
from upright.compiled.jit import RobotBlock, bits, fma, from_bits, inlined, item, njit, put, sqrt, taken
from upright.compiled.lane_math import sincos_any

_WORD = 2.0**-32
_PI = 3.141592653589793
_LN2 = 0.6931471805599453
_MANTISSA = (1 << 52) - 1
_SQRT2 = 1.4142135623730951

taken(counter.two_rounds)
philox = taken(counter.philox)
taken(counter.words)
whole = taken(counter.whole)


@inlined
def log(u: Any) -> Any:
    """ln u of a normal positive double: ln 2ᵉm = e ln 2 + 2 artanh((m − 1)/(m + 1)), to 2e-16 of it or of 1."""
    word = bits(u)
    e = (word >> 52) - 1023
    m = from_bits((word & _MANTISSA) | (1023 << 52))
    high = m > _SQRT2
    m = m * 0.5 if high else m
    e = e + 1 if high else e
    t = (m - 1.0) / (m + 1.0)
    z = t * t
    p = fma(z, fma(z, 0.07308439459514911, 0.07665843434319214), 0.09091445085156985)
    p = fma(z, fma(z, fma(z, p, 0.11111105560224649), 0.1428571431303169), 0.19999999999949655)
    p = fma(z, p, 0.3333333333333335)
    return fma(float(e), _LN2, 2.0 * fma(t * z, p, t))


@inlined
def normal_pair(first: Any, second: Any) -> Any:
    """Two independent standard normal numbers from two words; at most 6.8 in size."""
    u = (float(first) + 0.5) * _WORD
    radius = sqrt(-2.0 * log(u))
    s, c = sincos_any(_PI * fma(float(second), 2.0 * _WORD, -1.0))
    return radius * c, radius * s


@njit
def fill_normals(block: RobotBlock, out: int, time: int, purpose: int, half: int, seed: int) -> None:
    """Rows `out` and `out` + 1 of a block: two normal numbers for each robot, at whole `time`. Of the four that a
    purpose has, `half` 0 gives the first two and 1 the others."""
    c0, c3, key = np.uint64(time), np.uint64(purpose), np.uint64(seed)
    k0 = key & LOW
    k1 = key >> SHIFT
    second = half > 0
    for i in range(block.robots):
        robot = item(block.index, block.first + i)
        r0, r1, r2, r3 = philox(c0, robot & LOW, robot >> SHIFT, c3, k0, k1)
        a, b = normal_pair(r2 if second else r0, r3 if second else r1)
        put(block.w, out, i, a)
        put(block.w, out + 1, i, b)
