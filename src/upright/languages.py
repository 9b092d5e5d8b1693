"""The language of all that is shown: its words, from one catalogue, and its numbers."""

from __future__ import annotations

import functools
import json
import math
import os
import re
from collections.abc import Generator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from importlib import resources

from upright.errors import UnknownName

ENGLISH = "en"
LANGUAGES = (ENGLISH, "es")

_own: dict[str, str] = {}
_language: ContextVar[str | None] = ContextVar("language", default=None)


_SYSTEM = ("LANGUAGE", "LC_ALL", "LC_MESSAGES", "LANG")
"""What states the language of a system; of these gettext, too, asks the first that states one."""


def chosen() -> str:
    """The language of all text: that of `language` or `speaking`, else of UPRIGHT_LANG, of the system, else English."""
    asked = _language.get()
    stated = asked or next(filter(None, map(os.environ.get, ("UPRIGHT_LANG", *_SYSTEM))), "")
    languages = [re.split("[_.@-]", one)[0] for one in stated.split(":")]  # LANGUAGE may list several
    first = next((one for one in languages if one in (*LANGUAGES, "C")), ENGLISH)
    return first if first in LANGUAGES else ENGLISH


@contextmanager
def speaking(name: str) -> Generator[None]:
    """Text is in this language as long as the block runs; raises `UnknownName`."""
    before = _language.set(_known(name))
    try:
        yield
    finally:
        _language.reset(before)


def language(name: str = ENGLISH, words: Mapping[str, str] | None = None) -> None:
    """From now on text is in English ("en") or Spanish ("es"), with its decimal comma.

    `words` of your own, such as names of runs in figures, go from English to that language. Raises `UnknownName` for
    another language.
    """
    _language.set(_known(name))
    _own.clear()
    _own.update(words or {})


def _known(name: str) -> str:
    if name not in LANGUAGES:
        raise UnknownName("language", name, LANGUAGES)
    return name


@functools.cache
def catalogue(name: str) -> Mapping[str, str]:
    """English template → template in another language."""
    if name == ENGLISH:
        return {}
    return json.loads(resources.files("upright.pages").joinpath(f"{name}.json").read_text("utf-8"))


def translated(template: str) -> str:
    """A template or a name in the chosen language; one that is in no catalogue, as of a plug-in, stays as it is."""
    name = chosen()
    own = {} if name == ENGLISH else _own
    return own.get(template) or catalogue(name).get(template, template)


HALF_UP = 1 + 1e-12
"""A number times this is rounded as readers round: Python takes a half to the even neighbour, 58.5 to 58."""


def number(value: float, digits: int = 3, toward: int = 0) -> str:
    """A number as text: a true minus sign, a power of ten beyond 10⁵ or 10⁻⁴, the decimal sign of the language.

    `toward` −1 never rounds up, 1 never down, 0 rounds a half away from zero.
    """
    if math.isnan(value):
        return "–"
    if math.isinf(value):
        return "∞" if value > 0 else "−∞"
    rounded = _rounded(value, digits, toward)
    if rounded == 0 or 1e-4 <= abs(rounded) < max(1e5, 10.0**digits):
        decimals = max(0, digits - 1 - math.floor(math.log10(abs(rounded)))) if rounded else 0
        return localised(f"{rounded:.{decimals}f}".rstrip("0").rstrip(".") if decimals else f"{rounded:.0f}")
    exponent = math.floor(math.log10(abs(rounded)))
    mantissa = f"{rounded / 10**exponent:.{digits - 1}f}".rstrip("0").rstrip(".")
    head = {"1": "", "-1": "-"}.get(mantissa, f"{mantissa}\u00a0·\u00a0")
    return localised(f"{head}{power_of_ten(exponent)}")


def _rounded(value: float, digits: int, toward: int) -> float:
    if value == 0 or not toward:
        return float(f"{value * HALF_UP:.{digits}g}")
    step = 10.0 ** (math.floor(math.log10(abs(value))) - digits + 1)
    steps = value / step
    # a value that is whole up to its last bits stays
    whole = round(steps)
    if abs(steps - whole) > 1e-9 * abs(steps):
        whole = math.floor(steps) if toward < 0 else math.ceil(steps)
    return float(f"{whole * step:.{digits}g}")


def localised(text: str) -> str:
    """A number's text with a true minus sign and the decimal sign of the language."""
    text = text.replace("-", "−")
    return text.replace(".", ",") if chosen() == "es" else text


def superscript(number: int) -> str:
    """A whole number as an exponent: −3 as ⁻³."""
    return str(number).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def power_of_ten(exponent: int) -> str:
    """10 with its exponent raised: 10⁻³."""
    return f"10{superscript(exponent)}"


def sentence(text: str) -> str:
    """`text` with its first letter upper, and a full stop."""
    return f"{text[:1].upper()}{text[1:]}."
