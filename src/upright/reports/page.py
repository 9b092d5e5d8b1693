"""One self-contained HTML page of sections: prose, tables, figures, verdicts. It shows numbers and computes none."""

from __future__ import annotations

import functools
import math
import re
import unicodedata
from collections.abc import Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, field
from html import escape
from importlib import resources
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar
from xml.etree import ElementTree

from upright.atomic import write_text
from upright.errors import UprightError
from upright.reports.figure import Figure
from upright.reports.head import MOST, Head, Verdict
from upright.reports.terms import explained
from upright.tables import HALF_UP, power_of_ten

if TYPE_CHECKING:
    from jinja2 import Template

NEXT = " Next: "  # in a lead: what follows stands in a frame of its own
PHONE, WRAPPED, BRIEF = 44, 20, 21  # letters of a row on a phone, of a text that it breaks, of half a row with its name


_MINUS = re.compile(r"(?<!\S)-(?=\d)")
Cell = str | float | bool | Verdict | None


@dataclass(frozen=True)
class Table:
    """Rows under `header`; numbers are right-aligned and shown to `digits` significant digits, NaN and None as '–'.

    A `Verdict` as a cell has its colour. With `even` the numbers of a column have as many decimals as its largest. On a
    phone the rows of a `narrow` table stay rows, since its names and heads wrap.
    """

    header: Sequence[str]
    rows: Sequence[Sequence[Cell]]
    caption: str = ""
    digits: int = 4
    even: bool = False
    narrow: bool = False
    kind: ClassVar[str] = "table"

    def __post_init__(self) -> None:
        for row in self.rows:
            if len(row) != len(self.header):
                raise UprightError(
                    f"a row of table '{self.caption}' has {len(row)} cells",
                    expected=f"{len(self.header)}, as its header",
                )

    def cells(self) -> list[list[tuple[str, str]]]:
        """The cells as text, each with its class in the style sheet."""
        places = [_decimals(column, self.digits) if self.even else None for column in zip(*self.rows, strict=True)]
        return [
            [(_with_decimals(cell, self.digits, n), _class_of(cell)) for cell, n in zip(row, places, strict=True)]
            for row in self.rows
        ]

    @property
    def stacked(self) -> bool:
        """Whether a phone shows each row as a card, since the columns do not fit beside each other."""
        columns = zip(*([(name, "") for name in self.header], *self.cells()), strict=True)
        widths = [[min(len(text), 99 if kind == "number" else WRAPPED) for text, kind in cells] for cells in columns]
        broken = any(len(text) > 2 * WRAPPED for row in self.cells() for text, _ in row[1:])
        wide = len(self.header) > 3 and sum(max(column) + 1 for column in widths) > PHONE
        return len(self.header) > 2 and (broken or wide) and not self.narrow

    def brief(self) -> list[bool]:
        """For each column whether name and cells are short, so that two of them stand beside each other on a card."""
        columns = zip(self.header, zip(*self.cells(), strict=True), strict=True)
        return [max(len(text) for text, _ in cells) + len(name) <= BRIEF for name, cells in columns]


@dataclass(frozen=True)
class Formula:
    """A formula: plain text with its line breaks kept, or a <math> element (MathML), which must parse as XML."""

    text: str
    kind: ClassVar[str] = "maths"

    def __post_init__(self) -> None:
        if not self.is_mathml:
            return
        try:
            ElementTree.fromstring(self.text)
        except ElementTree.ParseError as error:
            raise UprightError(f"MathML does not parse: {error}", expected="one well-formed <math> element") from None

    @property
    def is_mathml(self) -> bool:
        """Whether this is markup rather than text."""
        return self.text.lstrip().startswith("<math")


@dataclass(frozen=True)
class Details:
    """Items behind a `heading` that is pressed to show them; on paper they are shown where they are `printed`."""

    heading: str
    items: Sequence[Item]
    printed: bool = True
    kind: ClassVar[str] = "details"

    def parts(self) -> list[tuple[str, Any]]:
        """The items, each with the name of its template."""
        return _parts(self.items)


Item = str | Table | Formula | Figure | Details


def _parts(items: Sequence[Item]) -> list[tuple[str, Item]]:
    return [("text" if isinstance(item, str) else getattr(item, "kind", "figure"), item) for item in items]


@dataclass(frozen=True)
class Section:
    """A heading, perhaps a verdict, and what follows in order; a plain string is a paragraph.

    A `folded` section shows its heading, below it what is `brief`, and the rest when that is pressed. `name` is what
    the contents call it, where that is shorter than its heading.
    """

    heading: str
    items: Sequence[Item] = ()
    verdict: Verdict | None = None
    folded: bool = False
    name: str = ""
    brief: str = ""

    def parts(self) -> list[tuple[str, Item]]:
        """The items, each with the name of its template."""
        return _parts(self.items)


@dataclass(frozen=True)
class Page:
    """A page under `title`. Its first screen has the answer: a `verdict`, the `lead` in a sentence, the `picture` that
    shows it and the `numbers` that matter, each with what it is; a `Verdict` among them has its colour. `provenance`
    (versions, seeds, hashes) is its foot."""

    title: str
    sections: Sequence[Section]
    lead: str = ""
    provenance: Mapping[str, str] = field(default_factory=dict[str, str])
    twin_note: bool = True
    _: KW_ONLY
    verdict: Verdict | None = None
    picture: Figure | None = None
    numbers: Sequence[tuple[str | Verdict, str]] = ()

    @property
    def answer(self) -> str:
        """The lead without what to run next."""
        return self.lead.partition(NEXT)[0]

    @property
    def head(self) -> Head:
        """What the page, the terminal and JSON begin with."""
        numbers = [(n.text if isinstance(n, Verdict) else n, meaning) for n, meaning in self.numbers[:MOST]]
        return Head(self.title, self.verdict, numbers, self.lead.partition(NEXT)[2])

    def made(self) -> list[tuple[str, str]]:
        """What the page came from, its command first and as code."""
        facts = {name: value for name, value in self.provenance.items() if name != "command"}
        command = self.provenance.get("command", "")
        return [*([("command", f"`{command}`")] if command else []), *facts.items()]

    @property
    def columns(self) -> int:
        """Numbers beside each other, so that rows are full where that can be."""
        n = len(self.numbers)
        return n if n <= 5 else 3 if n % 3 == 0 else 4

    def html(self) -> str:
        """The whole page: style, script and drawings inside, nothing fetched."""
        return _template().render(
            page=self,
            anchors=_anchors([section.heading for section in self.sections]),
            style=_read("style.css"),
            hover=resources.files("upright.pages").joinpath("hover.js").read_text(encoding="utf-8"),
            explained=explained,
        )

    def write(self, path: str | Path) -> Path:
        """Write the page as UTF-8, whole or not at all; raises `UprightError` where that cannot be done."""
        return write_text(path, self.html())


def _class_of(cell: Cell) -> str:
    if isinstance(cell, Verdict):
        return f"said {cell.level}"
    return "" if isinstance(cell, str) else "number"


def distance_text(metres: float) -> str:
    """A distance in the unit that people say it in.

    >>> distance_text(0.0312), distance_text(2.68), distance_text(123.0)
    ('3.1 cm', '2.7 m', '123 m')
    """
    if abs(metres) >= 10:
        return f"{metres:.0f} m".replace("-", "−")
    if abs(metres) >= 0.995:  # two digits would make 100 cm of it
        return f"{cell_text(metres, 2)} m"
    return f"{cell_text(100 * metres, 2)} cm"


def cell_text(cell: Cell, digits: int = 4) -> str:
    """A table's cell as text: a true minus sign, '–' for what is not known."""
    if isinstance(cell, Verdict):
        return cell.text
    if isinstance(cell, str):
        return _MINUS.sub("−", cell)
    if isinstance(cell, bool):
        return "yes" if cell else "no"
    if isinstance(cell, int):
        return str(cell).replace("-", "−")
    if cell is None or math.isnan(cell):
        return "–"
    mantissa, e, power = f"{cell * HALF_UP:.{digits}g}".partition("e")
    return (f"{mantissa} · {power_of_ten(int(power))}" if e else mantissa).replace("-", "−").replace("inf", "∞")


def _decimals(cells: Sequence[Cell], digits: int) -> int | None:
    """The decimals that the largest number of a column has with as many digits, if any number needs them; at least one
    beside numbers below 10, so that 2.8 of 100 is not 3."""
    sizes = [abs(cell) for cell in cells if isinstance(cell, float) and math.isfinite(cell)]
    if not any(sizes) or max(sizes) >= 10**digits or max(sizes) < 10**-digits:
        return None
    least = int(any(0 < size < 10 for size in sizes))
    most = max(least, digits - 1 - math.floor(math.log10(max(sizes))))
    return min(most, max(len(f"{size:.{digits}g}".partition(".")[2]) for size in sizes))


def _with_decimals(cell: Cell, digits: int, decimals: int | None) -> str:
    if decimals is None or not isinstance(cell, float) or not math.isfinite(cell):
        return cell_text(cell, digits)
    return f"{cell * HALF_UP:.{decimals}f}".replace("-", "−")


def bound(markup: str) -> str:
    """HTML in whose text no line breaks between a number and its unit, a sign and its number, or inside a unit.

    Drawings, code and tags stay as they are.
    """
    parts = _VERBATIM.split(markup)
    return "".join(part if i % 3 else _UNIT.sub(_unbroken, part) for i, part in enumerate(parts) if i % 3 != 2)


def _unbroken(match: re.Match[str]) -> str:
    return match[0].replace(" ", "\u00a0")


_VERBATIM = re.compile(r"(<(svg|code|script|style|math|pre)\b.*?</\2>|<[^>]*>)", re.DOTALL)
_ATOM = r"(?:[kmµ]?(?:rad|Pa|Hz|Ω|[gmsNVAWJ])[²³]?|1(?=/)|[%°])(?!\w)"
_JOINT = r"(?: / |/| · | )"
_UNIT = re.compile(
    rf" · 10|(?<=\d) ± (?=\d)|[±≤≥] (?=[\d−])"
    rf"|(?<=[\d∞⁰¹²³⁴-⁹]) {_ATOM}(?:{_JOINT}{_ATOM})*|(?<![\w/]){_ATOM}(?:{_JOINT}{_ATOM})+"
)
"""A power of ten, a sign before a number, a unit after a number, or a unit of several parts."""


def symbols(text: str) -> str:
    """Text as HTML: a letter with an index, such as J_ψ, gets a subscript, and a name in backticks is code."""
    parts = _CODE.split(escape(text))  # prose and code by turns
    return "".join(_code(p) if i % 2 else _INDEX.sub(r"\1<sub>\2</sub>", _prose(p)) for i, p in enumerate(parts))


def _prose(text: str) -> str:
    """A true minus sign, and a space before a per cent sign."""
    return _PERCENT.sub(r"\1 %", _MINUS.sub("−", text))


_PERCENT = re.compile(r"(\d)%(?!\d)")


def _code(text: str) -> str:
    """A command, whose lines break between its words alone."""
    return f"<code>{' '.join(f'<span>{word}</span>' if '-' in word else word for word in text.split(' '))}</code>"


def whole_in_prose(markup: str) -> str:
    """HTML in whose text, but not in code or tags, no line breaks inside a name with a hyphen."""
    parts = _VERBATIM.split(markup)
    whole = r'<span class="unit">\g<0></span>'
    return "".join(part if i % 3 else _HYPHENED.sub(whole, part) for i, part in enumerate(parts) if i % 3 != 2)


def whole_names(text: str) -> str:
    """Text as HTML, in which no line breaks inside a name with a hyphen, such as nxtway-gs."""
    return _HYPHENED.sub(r'<span class="unit">\g<0></span>', escape(text))


_HYPHENED = re.compile(r"(?<![\w-])(?=[\w-]{3,24}(?![\w-]))\w+(?:-\w+)+")  # a longer one may not fit on a phone


def united(name: str) -> str:
    """A column's name as HTML; its unit may stand on a line of its own, but is never broken."""
    head, bracket, unit = name.rpartition(" [")
    return f'{symbols(head)} <span class="unit">[{symbols(unit)}</span>' if bracket else symbols(name)


_INDEX = re.compile(r"\b([A-Za-zα-ωΔ]\u0307?)_(\w)\b")
_CODE = re.compile(r"`([^`]+)`")


def _anchors(headings: Sequence[str]) -> list[str]:
    plain = (unicodedata.normalize("NFKD", heading).encode("ascii", "ignore").decode().lower() for heading in headings)
    return [f"{row}-{re.sub(r'[^a-z0-9]+', '-', text).strip('-')}".strip("-") for row, text in enumerate(plain, 1)]


def _read(name: str) -> str:
    return resources.files("upright.reports").joinpath(name).read_text(encoding="utf-8")


@functools.cache
def _template() -> Template:
    from jinja2 import Environment, FunctionLoader, StrictUndefined

    loader = FunctionLoader(lambda name: _read(f"templates/{name}"))
    environment = Environment(
        loader=loader, autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    environment.filters["symbols"] = symbols
    environment.filters["bound"] = bound
    environment.filters["united"] = united
    environment.filters["whole_names"] = whole_names
    environment.filters["whole_in_prose"] = whole_in_prose
    return environment.get_template("page.html")
