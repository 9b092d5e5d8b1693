"""What is said: whole sentences with facts, and quantities; both are text in the language that was chosen.

A sentence stands where it is said, in English, as a template with places: `Say("{n} of {m} robots fell", n=3, m=100)`.
The template is the key of its translation in `es.json`. No sentence is put together from pieces, and none is read.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from upright.atomic import finite
from upright.languages import ENGLISH, chosen, number, speaking, translated
from upright.messages import in_language


class Say:
    """A whole sentence, heading or label: a `template` with its `facts`.

    A fact is another `Say`, a `Quantity`, a whole number, a name (a string, which is never translated), or a sequence
    of these, which becomes a list with commas. A float is none: it has a unit, and is a `Quantity`.

    >>> print(Say("{n} of {m} robots fell", n=3, m=100))
    3 of 100 robots fell
    """

    __slots__ = ("facts", "template")

    def __init__(self, template: str, /, **facts: Fact) -> None:
        wrong = [name for name, fact in facts.items() if isinstance(fact, float)]
        if wrong:
            raise TypeError(f"{wrong} of '{template}': a float has a unit; say Quantity(value, unit)")
        self.template = template
        self.facts = facts

    def about(self, **facts: Fact) -> Say:
        """The same sentence with these facts, for one that stands in a table."""
        return type(self)(self.template, **self.facts | facts)

    def __str__(self) -> str:
        return translated(self.template).format(**{name: text_of(fact) for name, fact in self.facts.items()})

    def __repr__(self) -> str:
        return f"Say({str(self)!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Say) and (self.template, self.facts) == (other.template, other.facts)

    def __hash__(self) -> int:
        return hash(self.template)  # the same in all languages


class Message(Say):
    """A line such as an error as a sentence of a page: shown as the command line shows it.

    >>> print(Message("period is -1 s; expected a positive number"))
    period is -1 s; expected a positive number
    """

    __slots__ = ()

    def __init__(self, line: object, /) -> None:
        super().__init__(str(line))

    def __str__(self) -> str:
        return in_language(self.template)


Fact = Any  # Say | Quantity | int | str | Sequence[Fact]


def text_of(fact: Fact) -> str:
    """A fact as text."""
    if isinstance(fact, Sequence) and not isinstance(fact, str):
        # beside decimal commas a comma separates nothing
        decimals = chosen() != ENGLISH and any(isinstance(one, Quantity) for one in fact)
        return ("; " if decimals else ", ").join(map(text_of, fact))
    return str(fact)


def english(sentence: Say) -> str:
    """A sentence as programs read it: in English, with plain spaces."""
    with speaking(ENGLISH):
        return str(sentence).replace("\u00a0", " ")


def data_of(fact: Fact) -> Any:
    """A fact as data: a number in SI, an interval as two, a name, or English words, "text" beside their facts."""
    if isinstance(fact, Quantity):
        return [fact.low, fact.high] if fact.value is None else finite(fact.value)
    if isinstance(fact, Sequence) and not isinstance(fact, str):
        return [data_of(one) for one in fact]
    if isinstance(fact, Say):
        return {"text": english(fact), **facts_of(fact)} if fact.facts else english(fact)
    return fact


def facts_of(sentence: Say) -> dict[str, Any]:
    """The facts of a sentence as data, also those that it does not show."""
    return {name: data_of(fact) for name, fact in sentence.facts.items()}


class Quantity:
    """A `value` in `unit` (SI), perhaps with its interval `low` to `high`, as text for people.

    Angles are shown in degrees, a "fraction" in per cent, lengths below 1 m in cm, times below 0.1 s in ms. Without a
    value the interval stands alone; with one end alone it is a bound, which is never rounded to the safe side.

    >>> print(Quantity(0.0312, "m"), Quantity(math.pi / 2, "rad"), Quantity(None, "N s", low=0.1897))
    3.12 cm 90° at least 0.189 N s
    """

    __slots__ = ("digits", "high", "low", "unit", "value")

    def __init__(
        self, value: float | None, unit: str = "", *, low: float | None = None, high: float | None = None,
        digits: int = 3,
    ) -> None:  # fmt: skip
        self.value = value
        self.unit = unit
        self.low = low
        self.high = high
        self.digits = digits

    def __str__(self) -> str:
        ends = [end for end in (self.value, self.low, self.high) if end is not None]
        factor, unit = shown_in(self.unit, max(map(abs, ends), default=math.nan))
        parts = {
            name: number(factor * end, self.digits, toward)
            for name, end, toward in (("value", self.value, 0), ("low", self.low, -1), ("high", self.high, 1))
            if end is not None
        }
        form = _FORMS[frozenset(parts)]
        return with_unit(translated(form).format(**parts), unit)

    def __repr__(self) -> str:
        return f"Quantity({str(self)!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Quantity) and all(getattr(self, n) == getattr(other, n) for n in self.__slots__)

    def __hash__(self) -> int:
        return hash((self.value, self.unit, self.low, self.high))


_FORMS = {
    frozenset(): "–",
    frozenset({"value"}): "{value}",
    frozenset({"low"}): "at least {low}",
    frozenset({"high"}): "at most {high}",
    frozenset({"low", "high"}): "{low} to {high}",
    frozenset({"value", "low", "high"}): "{value} ({low} to {high})",
    frozenset({"value", "low"}): "{value} (at least {low})",
    frozenset({"value", "high"}): "{value} (at most {high})",
}
"""What of a quantity is known → how it is said."""

_PEOPLE = {"rad": (180 / math.pi, "°"), "rad/s": (180 / math.pi, "°/s"), "fraction": (100.0, "%")}
"""Unit of data → factor and unit for people."""

SHORT_LENGTH = 0.995  # [m]: from here on two digits of centimetres would make 100 cm
SHORT_TIME = 0.0995  # [s]


def shown_in(unit: str, largest: float) -> tuple[float, str]:
    """Factor and unit in which people read values as large as `largest`."""
    if unit == "m" and largest < SHORT_LENGTH:
        return 100.0, "cm"
    if unit == "s" and 0 < largest < SHORT_TIME:
        return 1000.0, "ms"
    if unit == "1":
        return 1.0, ""
    return _PEOPLE.get(unit, (1.0, unit))


def with_unit(text: str, unit: str) -> str:
    """A number with its unit, between which no line breaks."""
    if not unit or text == "–":
        return text
    whole = unit.replace(" ", "\u00a0")
    return f"{text}{whole}" if unit[0] == "°" else f"{text}\u00a0{whole}"
