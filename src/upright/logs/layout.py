"""The layout of a log in text: its separator, names, units and comments, and what firmware prints round its numbers."""

from __future__ import annotations

import csv
import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

from upright.errors import InvalidLog
from upright.signals.units import unit_of

SAMPLE = 200  # lines from which a layout is read

_NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
_CLOCK = r"(?:\d{1,2}:\d\d:\d\d(?:[.,]\d+)?\s*->\s*)?"
_TAGGED = re.compile(rf"^\s*({_CLOCK}(?:\[\w+\]\s*|[IWEDV] \(\d+\)\s*)(?:[A-Za-z_]\w*:\s+)?)")
_LABELLED = re.compile(rf"^\s*((?:\d{{1,2}}:\d\d:\d\d(?:[.,]\d+)?\s*->\s*|[A-Za-z_]\w*:\s+))(?={_NUMBER}\s*[,;\t ])")
_STAMPED = re.compile(rf"^\s*\[\s*({_NUMBER})\s*\]\s*")
_UNIT = r"(?:°|%|[A-Za-zµ]{1,4})(?:/s(?:ec)?)?"
_PAIR = re.compile(rf"([A-Za-z_][\w./]*)\s*[:=]\s*({_NUMBER}|nan|inf)({_UNIT})?(?=[\s,;]|$)")


@dataclass(frozen=True)
class Layout:
    """Separator, column names, the first line of numbers (from 0), comment lines, decimal mark, and units by column."""

    separator: str
    names: Sequence[str]
    first: int
    comments: tuple[str, ...]
    decimal: str
    units: Mapping[str, str]


def bare(lines: Sequence[str]) -> list[str] | None:
    """The rows without what a program prints before or between their numbers; None where the lines are plain.

    A tag as in `[INF] MODEL: 1, 2` or the clock of a serial monitor goes, with the lines of other tags; that of a
    logger in brackets stays; `a: 1  b: 2` becomes a row of a table, and the units of `a: 1°` a row of units.
    """
    rows = _unbracketed(lines)
    sample = [line for line in rows[:SAMPLE] if line.strip()]
    for pattern in (_TAGGED, *(() if sum(len(_PAIR.findall(line)) > 1 for line in sample) else (_LABELLED,))):
        tags = Counter(re.sub(r"[\d:.,()]+", "", m[1]) for line in sample if (m := pattern.match(line)))
        if sum(tags.values()) > len(sample) / 2:
            tag = tags.most_common(1)[0][0]
            kept = [(line, m) for line in rows if (m := pattern.match(line))]
            rows = [line[m.end() :] for line, m in kept if re.sub(r"[\d:.,()]+", "", m[1]) == tag]
            sample = rows[:SAMPLE]
    names = Counter(tuple(name for name, *_ in _PAIR.findall(line)) for line in sample)
    keys, count = names.most_common(1)[0] if names else ((), 0)
    if len(keys) > 1 and count > len(sample) / 2:
        pairs = [p for p in (_PAIR.findall(line) for line in rows) if tuple(k for k, *_ in p) == keys]
        units = [",".join(unit for *_, unit in pairs[-1])] if any(unit_of(unit) for *_, unit in pairs[-1]) else []
        rows = [",".join(keys), *units] + [",".join(value for _, value, _ in p) for p in pairs]
    return rows if rows != list(lines) else None


def _unbracketed(lines: Sequence[str]) -> list[str]:
    """The lines with the clock of a logger, the number in brackets at the beginning of most, as a value like others:
    `[0.005] a=1` is `t=0.005 a=1`, and `[0.005] 1, 2` is `0.005, 1, 2`."""
    sample = [line for line in lines[:SAMPLE] if line.strip()]
    if sum(bool(_STAMPED.match(line)) for line in sample) <= len(sample) / 2:
        return list(lines)
    paired = sum(bool(_PAIR.search(line)) for line in sample) > len(sample) / 2
    return [_STAMPED.sub(r"t=\1 " if paired else rf"\g<1>{_separator(sample)}", line) for line in lines]


def layout(lines: Sequence[str]) -> Layout:
    """The layout of a table by its first lines; raises `InvalidLog` where it has none."""
    content = [(i, line) for i, line in enumerate(lines) if line.strip() and not _is_comment(line)][:SAMPLE]
    if not content:
        raise InvalidLog("there are no rows of numbers", likely="an empty recording")
    separator = _separator([line for _, line in content])
    rows = [(i, cells_of(line, separator)) for i, line in content]
    width = _width([cells for _, cells in rows])
    ended = rows[-1][1][-1].strip() == ""  # a separator at the end of each row
    head = next((k for k, (_, cells) in enumerate(rows) if len(cells) in (width, width - ended)), 0)
    comments = [line for line in lines[: rows[head][0]] if line.strip()]
    numbers = " ".join(line for _, line in content[head + 1 : head + 4])
    decimal = "," if separator != "," and re.search(r"\d,\d", numbers) else "."
    named = not _any_number(rows[head][1], decimal)
    names = [cell.strip() for cell in rows[head][1]] if named else _commented(comments, separator, width)
    body = head + named
    units: dict[str, str] = {}
    if named and body < len(rows) - 1 and len(rows[body][1]) == len(names) and not _any_number(rows[body][1], decimal):
        units = {name: unit_of(cell) for name, cell in zip(names, rows[body][1], strict=True)}
        body += any(units.values())
    if len(names) == width - 1:
        names = [*names, f"c{width}"]
    names = [name or f"c{i + 1}" for i, name in enumerate(names)]
    if twice := [name for name, count in Counter(names).items() if count > 1]:
        raise InvalidLog(f"column '{twice[0]}' appears twice", hint="rename or drop one")
    first = rows[body][0] if body < len(rows) else rows[-1][0] + 1
    return Layout(separator, names, first, tuple(comments), decimal, {n: u for n, u in units.items() if u})


def _width(rows: Sequence[Sequence[str]]) -> int:
    """How many cells most rows have, or how many names stand above rows that have fewer: a program may log some values
    only at times."""
    common = Counter(len(cells) for cells in rows[-50:]).most_common(1)[0][0]
    first = next((k for k, cells in enumerate(rows) if _any_number(cells, ".")), 0)
    if not first or any(len(cells) == common for cells in rows[:first]):
        return common
    named = len(rows[first - 1])
    return named if named > common > 1 and max(len(cells) for cells in rows[first:]) <= named else common


_PHASE = 5  # rows, on average, in which a program logs fewer values than in others


def padded(body: str, form: Layout) -> str:
    """The rows with nothing in the last cells of those that are shorter than the header; '' where some are longer, or
    single ones shorter, which were cut off."""
    rows = [line.rstrip("\r") for line in body.split("\n") if line.strip()]
    lacking = [len(form.names) - len(cells_of(line, form.separator)) for line in rows]
    starts = sum(a != b > 0 for a, b in pairwise([0, *lacking]))
    cut = min(lacking) < 0 or sum(n > 0 for n in lacking) < _PHASE * starts
    return "" if cut else "\n".join(line + n * form.separator for line, n in zip(rows, lacking, strict=True))


def _is_comment(line: str) -> bool:
    """Also where a spreadsheet has put the line in quotes."""
    return line.lstrip(" \t\"'").startswith(("#", "%", "//"))


def _separator(lines: Sequence[str]) -> str:
    return next((mark for mark in (";", "\t", ",") if sum(mark in line for line in lines) > len(lines) / 2), " ")


def cells_of(line: str, separator: str) -> list[str]:
    """The cells of a line; without a separator any number of spaces is one."""
    try:
        return line.split() if separator == " " else next(csv.reader([line], delimiter=separator))
    except csv.Error as error:
        raise InvalidLog(f"a row cannot be read ({error})") from None


def _commented(comments: Sequence[str], separator: str, width: int) -> list[str]:
    """Names in the comment above the numbers, or c1, c2, …"""
    plain = comments[-1].lstrip("#%/ ").strip() if comments else ""
    for mark in (separator, ",", " "):
        cells = [cell.strip() for cell in cells_of(plain, mark)] if plain else []
        if len(cells) == width > 1 and not _any_number(cells, ".") and all(cells):
            return cells
    return [f"c{i + 1}" for i in range(width)]


def _any_number(cells: Sequence[str], decimal: str) -> bool:
    return any(is_number(cell.replace(decimal, ".")) for cell in cells)


def is_number(text: str) -> bool:
    """Whether a cell holds a number."""
    try:
        float(text)
    except ValueError:
        return False
    return True
