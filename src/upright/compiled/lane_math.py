"""Sine and cosine as polynomials, which vectorise where a library's functions do not.

Chebyshev interpolation in x² on |x| ≤ 1.6 rad: beyond a fallen robot's 1.4 rad by what a step can add. Error of the
polynomials alone: sine 1.0e-15, cosine 8.7e-17; with the rounding of the arithmetic at most 1.3e-15.
"""

from __future__ import annotations

from typing import Any

from upright.compiled.jit import fma, inlined, rint

REACH = 1.6  # [rad] where the polynomials hold
_HALF_TURNS = 1 / 3.141592653589793
# π in three parts, the first two of so few bits that a multiple of them is exact (Cody and Waite 1980)
_PI_1, _PI_2, _PI_3 = 3.140625, 0.0009675025939941406, 1.5099579909783765e-07


@inlined
def sincos(x: Any) -> Any:
    """sin x and cos x for |x| ≤ `REACH`."""
    z = x * x
    s = fma(z, fma(z, -7.399223452318581e-13, 1.605036165533037e-10), -2.5051957219467882e-08)
    s = fma(z, fma(z, fma(z, s, 2.7557317871404647e-06), -0.00019841269835503347), 0.008333333333324111)
    c = fma(z, fma(z, 4.641514219343068e-14, -1.1465911985580485e-11), 2.0876672808453326e-09)
    c = fma(z, fma(z, fma(z, c, -2.755731847067295e-07), 2.480158729837543e-05), -0.0013888888888883752)
    s = fma(z, s, -0.16666666666666644)
    c = fma(z, fma(z, c, 0.04166666666666665), -0.5)
    return fma(x * z, s, x), fma(z, c, 1.0)


@inlined
def sincos_any(x: Any) -> Any:
    """sin x and cos x of any angle up to 10⁶ rad: x − kπ is small, and an odd k changes both signs."""
    k = rint(x * _HALF_TURNS)
    r = fma(k, -_PI_3, fma(k, -_PI_2, fma(k, -_PI_1, x)))
    odd = fma(rint(k * 0.5), -2.0, k)  # 0 for an even k, ±1 for an odd one
    sign = fma(odd * odd, -2.0, 1.0)
    s, c = sincos(r)
    return s * sign, c * sign
