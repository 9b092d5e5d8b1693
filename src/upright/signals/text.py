"""Logs as CSV: a comment with units and origin, a row of names, and numbers that lose nothing."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from upright.arrays import floats_of
from upright.errors import InvalidLog
from upright.signals.header import TIME, Columns, assemble, check_lines, check_names, describe, understand

_NOTE = "# upright-log: "
_ROWS_AT_ONCE = 50_000  # bounds the memory for text to some tens of megabytes


@dataclass(frozen=True)
class _Head:
    """What stands above the numbers: the names, our note or '', and how many lines they take."""

    names: list[str]
    note: str
    lines: int


def write(log: Columns, stream: BinaryIO) -> None:
    """Write `# upright-log: {…}`, the names, and the rows with `repr`, the shortest text that reads back the same."""
    columns = log.table()
    names = io.StringIO()
    csv.writer(names, lineterminator="\n").writerow(columns)
    stream.write(f"{_NOTE}{describe(log)}\n{names.getvalue()}".encode())
    for start in range(0, len(log.t), _ROWS_AT_ONCE):
        texts = [map(repr, values[start : start + _ROWS_AT_ONCE].tolist()) for values in columns.values()]
        stream.write(("\n".join(map(",".join, zip(*texts, strict=True))) + "\n").encode())


def read(path: Path) -> Columns:
    """Read a CSV of numbers in UTF-8 with a header row; lines before it that start with `#` are comments.

    Empty cells, NaN, NA and null are NaN. Raises `InvalidLog`.
    """
    with path.open("rb") as stream:
        head = _head(stream)
        check_names(head.names)
        check_lines(path, len(head.names))
        table = _table(path, stream, head)
    columns = {name: floats_of(table.column(i)) for i, name in enumerate(head.names)}
    units, origin = understand(head.note) if head.note else ({}, {})
    return assemble(columns, units, origin)


def _head(stream: BinaryIO) -> _Head:
    note = ""
    for lines, raw in enumerate(stream, start=1):
        line = _decoded(raw, "utf-8-sig" if lines == 1 else "utf-8")
        if line.startswith(_NOTE):
            note = line.removeprefix(_NOTE)
        elif line.strip() and not line.startswith("#"):
            names = _cells(line)
            # Ours are written without spaces around them; in other files ", " is a habit, not part of the name.
            return _Head(names if note else [name.strip() for name in names], note, lines)
    raise InvalidLog("the CSV has no header row", expected="a row of names such as t,sensor/gyro")


def _decoded(raw: bytes, encoding: str) -> str:
    try:
        line = raw.decode(encoding)
    except UnicodeDecodeError:
        line = "\0"
    if "\0" in line:
        raise InvalidLog(
            "the file is not text in UTF-8",
            likely="a binary file called .csv, or a table saved in another encoding",
            hint="save it as CSV in UTF-8",
        )
    return line


def _cells(line: str) -> list[str]:
    try:
        return next(csv.reader([line]))
    except csv.Error as error:
        raise InvalidLog(f"the header row cannot be read ({error})") from None


def _table(path: Path, stream: BinaryIO, head: _Head) -> Any:
    import pyarrow as pa
    import pyarrow.csv as pc

    options = pc.ConvertOptions(column_types=dict.fromkeys(head.names, pa.float64()))
    try:
        table = pc.read_csv(stream, read_options=pc.ReadOptions(column_names=head.names), convert_options=options)
    except pa.ArrowInvalid as error:
        _explain(path, head, set(options.null_values))
        raise InvalidLog(f"the CSV cannot be read ({error})") from None
    return table


def _explain(path: Path, head: _Head, blanks: set[str]) -> None:
    """Find the first row that is at fault, slowly, and raise `InvalidLog` about it."""
    row = -1
    for row, (line, cells) in enumerate(_rows(path, head.lines)):
        _check_row(head.names, cells, f"row {row} (line {line} of the file)", blanks)
    if row < 0:
        raise InvalidLog("there are no rows below the header", expected="at least one", likely="an empty recording")


def _rows(path: Path, skip: int) -> Iterator[tuple[int, list[str]]]:
    with path.open("rb") as stream:
        for line, raw in enumerate(islice(stream, skip, None), start=skip + 1):
            text = raw.decode(errors="backslashreplace").replace("\0", "\\0")
            if text.strip():
                yield line, _cells(text)


def _check_row(names: Sequence[str], cells: Sequence[str], where: str, blanks: set[str]) -> None:
    if len(cells) != len(names):
        raise InvalidLog(
            f"{where} has {len(cells)} values",
            expected=f"{len(names)}, as in the header",
            likely="a row that was cut off, or a comma for the decimal point",
        )
    for name, cell in zip(names, cells, strict=True):
        if cell.strip() not in blanks and not _is_number(cell):
            shown = cell if len(cell) <= 40 else cell[:40] + "…"
            raise InvalidLog(
                f"column '{name}' holds the text '{shown}' at {where}",
                expected="numbers" if name != TIME else "seconds",
                hint="correct that cell, or drop the column",
            )


def _is_number(cell: str) -> bool:
    try:
        return bool(np.isreal(float(cell))) and "_" not in cell
    except ValueError:
        return False
