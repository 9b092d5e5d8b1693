"""Random numbers by counting: what a robot draws depends on seed, index, period and purpose, and on nothing else.

Philox 4×32-10 (Salmon et al. 2011) turns a counter into four independent words; Box and Muller (1958) turn two words
into two normal numbers. No state is kept, so order, batch size and number of threads do not matter.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from upright.compiled.jit import RobotBlock, bits, fma, from_bits, inlined, item, njit, put, sqrt
from upright.compiled.lane_math import sincos_any

_LOW = np.uint64(0xFFFFFFFF)
_SHIFT = np.uint64(32)
_M0, _M1 = np.uint64(0xD2511F53), np.uint64(0xCD9E8D57)  # multipliers and Weyl steps of Salmon et al. (2011), table 2
_W0, _W1 = np.uint64(0x9E3779B9), np.uint64(0xBB67AE85)
_WORD = 2.0**-32
_PI = 3.141592653589793
_LN2 = 0.6931471805599453
_MANTISSA = (1 << 52) - 1
_SQRT2 = 1.4142135623730951


@inlined
def _two_rounds(c0: Any, c1: Any, c2: Any, c3: Any, k0: Any, k1: Any) -> Any:
    """Counter and key two rounds on."""
    p0, p1 = _M0 * c0, _M1 * c2
    c0 = (p1 >> _SHIFT) ^ c1 ^ k0
    c1 = p1 & _LOW
    c2 = (p0 >> _SHIFT) ^ c3 ^ k1
    c3 = p0 & _LOW
    k0, k1 = (k0 + _W0) & _LOW, (k1 + _W1) & _LOW
    p0, p1 = _M0 * c0, _M1 * c2
    c0 = (p1 >> _SHIFT) ^ c1 ^ k0
    c1 = p1 & _LOW
    c2 = (p0 >> _SHIFT) ^ c3 ^ k1
    c3 = p0 & _LOW
    return c0, c1, c2, c3, (k0 + _W0) & _LOW, (k1 + _W1) & _LOW


@inlined
def philox(c0: Any, c1: Any, c2: Any, c3: Any, k0: Any, k1: Any) -> Any:
    """Four words of 32 bits, each in 64, from four words of counter and two of key.

    Its ten rounds are written out, since a loop inside would keep the loop over robots from being vectorised.
    """
    c0, c1, c2, c3, k0, k1 = _two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, k0, k1 = _two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, k0, k1 = _two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, k0, k1 = _two_rounds(c0, c1, c2, c3, k0, k1)
    c0, c1, c2, c3, _, _ = _two_rounds(c0, c1, c2, c3, k0, k1)
    return c0, c1, c2, c3


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
    k0 = key & _LOW
    k1 = key >> _SHIFT
    second = half > 0
    for i in range(block.robots):
        robot = item(block.index, block.first + i)
        r0, r1, r2, r3 = philox(c0, robot & _LOW, robot >> _SHIFT, c3, k0, k1)
        a, b = normal_pair(r2 if second else r0, r3 if second else r1)
        put(block.w, out, i, a)
        put(block.w, out + 1, i, b)


@inlined
def whole(index: Any, time: int, purpose: int, seed: Any, below: int) -> Any:
    """A whole number from 0 to `below` − 1 for robot `index`, evenly to within 2⁻³² of each."""
    time_word, purpose_word, key = np.uint64(time), np.uint64(purpose), np.uint64(seed)
    word = philox(time_word, index & _LOW, index >> _SHIFT, purpose_word, key & _LOW, key >> _SHIFT)[0]
    return np.int64((word * np.uint64(below)) >> _SHIFT)
