"""A page as text for a terminal: what decides first, in as many columns as there are."""

from __future__ import annotations

import re
import textwrap
import unicodedata
from collections.abc import Iterator, Sequence

from upright.pages.blocks import Block, Fold, Items, KeyNumber, Page, Picture, Table
from upright.pages.cells import Text, columns_of
from upright.pages.words import Say

WIDTH = 80  # columns of a plain terminal
LIGHTS = {"good": "32", "warn": "33", "bad": "31", "unknown": "34"}
"""Level of a verdict → colour of ANSI terminals."""


def text(page: Page, width: int = WIDTH, *, colour: bool = False, wide: bool = False) -> str:
    """Verdict, title, lead, numbers, what to do next, then what is not folded.

    `wide` shows all columns of a table, also those that do not fit into `width`.
    """
    parts = ["\n".join(_head(page, width, colour)), *_blocks(page.blocks, width, wide)]
    return "\n\n".join(part for part in parts if part).replace("\u00a0", " ")


def _head(page: Page, width: int, colour: bool) -> Iterator[str]:
    if page.verdict:
        verdict = str(page.verdict.text)
        light = LIGHTS.get(page.verdict.level) if colour else None
        yield f"\033[1;{light}m{verdict}\033[0m" if light else verdict
    yield wrapped(str(page.title), width)
    yield from (wrapped(str(sentence), width) for sentence in page.lead)
    yield from _numbers(page.numbers, width)
    for step in page.next:
        yield wrapped(str(Say("Next: `{command}`", command=step.command)), width, indent=2)
        if step.why:
            yield wrapped(f"  {step.why}", width, indent=2)


def _numbers(numbers: Sequence[KeyNumber], width: int) -> Iterator[str]:
    values = [str(number.value) for number in numbers]
    wide = max(map(length, values), default=0)
    for value, number in zip(values, numbers, strict=True):
        yield wrapped(f"  {padded(value, wide)}  {number.meaning}", width, indent=wide + 4)


def _blocks(blocks: Sequence[Block], width: int, wide: bool) -> Iterator[str]:
    for block in blocks:
        if isinstance(block, Say):
            yield wrapped(str(block), width)
        elif isinstance(block, Items):
            yield "\n".join(wrapped(f"- {item}", width, indent=2) for item in block.items)
        elif isinstance(block, Table):
            yield table_text(block, width, wide=wide)
        else:
            assert isinstance(block, Fold | Picture)  # these are for a screen with a pointer


def table_text(table: Table, width: int = WIDTH, *, wide: bool = False) -> str:
    """Caption and aligned columns; the last ones are left out, and counted, where they do not fit into `width`."""
    columns = [[Text(name, all(cell.is_number for cell in cells)), *cells] for name, cells in columns_of(table)]
    sizes = [max(length(cell.text) for cell in column) for column in columns]
    shown = len(columns) if wide else _fitting(sizes, width)
    if not wide:
        sizes[shown - 1] = min(sizes[shown - 1], max(width - sum(sizes[: shown - 1]) - 2 * (shown - 1), 12))
    lines = [wrapped(str(table.caption), width)] if table.caption else []
    for row in zip(*columns[:shown], strict=True):
        lines += _row(row, sizes[:shown])
    if hidden := len(columns) - shown:
        lines.append(str(Say("Columns left out: {n}; --wide shows them.", n=hidden)))
    return "\n".join(lines)


def _fitting(sizes: Sequence[int], width: int) -> int:
    """How many columns fit; the last one may break its texts, but not below `LAST` letters."""
    used = 0
    for k, size in enumerate(sizes):
        if k and used + min(size, LAST) > width:
            return k
        used += size + 2
    return len(sizes)


LAST = 24  # letters of a text that a row breaks


def _row(row: Sequence[Text], sizes: Sequence[int]) -> Iterator[str]:
    cells = [padded(cell.text, size, cell.is_number) for cell, size in zip(row[:-1], sizes, strict=False)]
    left = sum(sizes[:-1]) + 2 * len(cells)
    *_, last = row
    fits = length(last.text) <= sizes[-1]
    first, *rest = [padded(last.text, sizes[-1], last.is_number)] if fits else textwrap.wrap(last.text, sizes[-1])
    yield "  ".join([*cells, first]).rstrip()
    yield from (" " * left + line for line in rest)


def wrapped(line: str, width: int = WIDTH, indent: int = 0) -> str:
    """A line in `width` columns; a command in backticks stays whole, however long, so that its copy is one command."""
    room = max(width, 40)
    spared = re.sub(r"`[^`]*`", lambda m: m[0].replace(" ", "\0"), line)
    lead = " " * (len(line) - len(line.lstrip()))
    lines = textwrap.wrap(
        spared.strip(), room, initial_indent=lead, subsequent_indent=" " * indent, break_on_hyphens=False,
        break_long_words=False,
    )  # fmt: skip
    return "\n".join(lines).replace("\0", " ")


def length(text: str) -> int:
    """Columns that the text takes: a combining accent, as in θ̇, takes none."""
    return sum(not unicodedata.combining(letter) for letter in text)


def padded(text: str, width: int, right: bool = False) -> str:
    """The text in `width` columns, on their left or on their right."""
    space = " " * (width - length(text))
    return space + text if right else text + space
