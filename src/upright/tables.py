"""Tables as aligned text and as HTML, for whatever prints itself; sentences and powers as text."""

from __future__ import annotations

import math
import re
import textwrap
import unicodedata
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from html import escape

from upright.languages import translated


@dataclass(frozen=True)
class Listing:
    """Rows of text under `header`; the columns named in `numbers` are set to the right.

    >>> print(Listing(("robot", "mass"), [("nxt", "0.66")], ("mass",)))
    robot  mass
    nxt    0.66
    """

    header: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: Collection[str] = ()

    def text(self, width: int | None = None) -> str:
        """Aligned columns; in a terminal of `width` columns the last one is wrapped."""
        table = [self.header, *self.rows]
        widths = [max(length(row[i]) for row in table) for i in range(len(self.header) - 1)]
        left = sum(widths) + 2 * len(widths)
        return "\n".join(line for row in table for line in self._lines(row, widths, left, width))

    def __str__(self) -> str:
        return self.text()

    def html(self, title: str = "") -> str:
        """The table as HTML under a `title`, in the chosen language; the first column holds names, and stays."""
        body = ([first, *map(translated, rest)] for first, *rest in self.rows)
        rows = [_html_row("th", [*map(translated, self.header)]), *(_html_row("td", row) for row in body)]
        return f"<table><caption>{escape(translated(title))}</caption>{''.join(rows)}</table>"

    def _lines(self, row: Sequence[str], widths: Sequence[int], left: int, width: int | None) -> list[str]:
        right = [name in self.numbers for name in self.header]
        cells = [padded(cell, size, side) for cell, size, side in zip(row, widths, right, strict=False)]
        last = row[-1]
        if right[-1]:
            last = padded(last, max(length(r[-1]) for r in (self.header, *self.rows)), True)
        wrapped = textwrap.wrap(last, max(width - left, 20)) if width and not right[-1] else [last]
        first, *rest = wrapped or [""]
        return ["  ".join([*cells, first]).rstrip(), *(" " * left + line for line in rest)]


def sentence(text: str, end: str = ".") -> str:
    """`text` with its first letter upper, and with an `end`."""
    return f"{text[:1].upper()}{text[1:]}{end}"


def short(channel: str) -> str:
    """`sensor/encoder_left` as `encoder left`."""
    return channel.removeprefix("sensor/").removeprefix("estimate/").replace("_", " ")


CHANNELS = {
    "truth": "{} (truth)", "estimate": "{} (estimate)", "sensor": "{}", "command": "{} command",
    "applied": "{} command (applied)",
}  # fmt: skip


def called(channel: str) -> str:
    """A channel of a log in words: `truth/pitch_rate` as pitch rate (truth); one of another kind as it is."""
    kind, _, name = channel.partition("/")
    return CHANNELS[kind].format(name.replace("_", " ")) if kind in CHANNELS else channel


SPOKEN = {
    "com_height": "centre of mass height", "asymmetry": "motor asymmetry", "constant_command": "command offset",
    "coulomb_friction": "Coulomb friction", "weight_moment/a22": "weight moment/a22",
}  # fmt: skip
"""Names of numbers that need other words, for readers."""


def spoken(name: str) -> str:
    """The name of a parameter in words: "com_height" as centre of mass height, "delay/gyro" as gyro delay."""
    if name in SPOKEN:
        return SPOKEN[name]
    match = re.fullmatch(r"(?:[a-z_]+\.)*([a-z_]+)(?:/(.+))?", name)
    if not match:
        return name.replace("_", " ")
    kind = match[1]
    of = (match[2] or "").replace("_", " ")
    return f"{of} {kind}" if of else SPOKEN.get(kind, kind.replace("_", " "))


_RADIANS = re.compile(r"([+−-]?)(\d+\.\d+) rad\b(?!/)")


def in_degrees(text: str) -> str:
    """The same words with angles in degrees: "hold at +0.19 rad" as hold at +11°."""
    return _RADIANS.sub(lambda m: f"{m[1]}{math.degrees(float(m[2])):.2g}°".replace("-", "−"), text)


HALF_UP = 1 + 1e-12
"""A number times this is rounded as readers round: Python takes a half to the even neighbour, 58.5 to 58."""


def superscript(number: int) -> str:
    """A whole number as an exponent: −3 as ⁻³."""
    return str(number).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def power_of_ten(exponent: int) -> str:
    """10 with its exponent raised: 10⁻³."""
    return f"10{superscript(exponent)}"


def length(text: str) -> int:
    """Columns that the text takes: a combining accent, as in θ̇, takes none."""
    return sum(not unicodedata.combining(letter) for letter in text)


def padded(text: str, width: int, right: bool = False) -> str:
    """The text in `width` columns, on their left or on their right."""
    space = " " * (width - length(text))
    return space + text if right else text + space


def _html_row(tag: str, cells: Sequence[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"
