"""Foreign logs as tables of numbers: CSV in its dialects, Parquet, MCAP, MAT and JSON of columns."""

from __future__ import annotations

import csv
import io
import re
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from pathlib import Path
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from upright.errors import InvalidLog
from upright.reading import expanded, read_json
from upright.signals import Log, parquet
from upright.signals.header import TIME, check_lines, understand

Array = NDArray[np.float64]

_NOTE = "# upright-log: "

MAT_READER = [sys.executable, "-m", "upright.logs.mat_process"]
"""The program that reads MAT files, since damaged ones crash SciPy's parser and the process that it runs in."""

MAT_SECONDS = 120


@dataclass(frozen=True, eq=False)
class RawTable:
    """`columns` of equal length by name, as they stand in the file `source`.

    `units` holds the units that the file states; `text` names the columns without numbers, each with an example;
    `comments` are the lines before the header; `origin` is the origin of one of our own logs.
    """

    columns: Mapping[str, Array]
    units: Mapping[str, str] = field(default_factory=dict[str, str])
    text: Mapping[str, str] = field(default_factory=dict[str, str])
    comments: tuple[str, ...] = ()
    source: str = ""
    origin: Mapping[str, Any] = field(default_factory=dict[str, Any])

    def __len__(self) -> int:
        return len(next(iter(self.columns.values()), ()))

    def column(self, name: str) -> Array:
        """One column; raises `InvalidLog` for one that is missing or holds text."""
        if name in self.text:
            raise InvalidLog(f"column '{name}' holds {self.text[name]}", expected="numbers", hint="correct that cell")
        if name not in self.columns:
            raise InvalidLog(f"there is no column '{name}'", expected=f"one of {', '.join(self.columns)}")
        return self.columns[name]


def read_table(path: str | PathLike[str]) -> RawTable:
    """Read a log of any program: .csv, .txt, .log, .tsv, .dat, .json, .mat, .parquet or .mcap.

    A text file may have comment lines with # or %, commas, semicolons, tabs or spaces between its columns, decimal
    commas beside semicolons, and no header: columns are then called c1, c2, …. Raises `InvalidLog`.
    """
    source = expanded(Path(path), InvalidLog)
    if not source.is_file():
        raise InvalidLog(f"there is no file {source}", hint="check the path")
    try:
        if source.stat().st_size == 0:
            raise InvalidLog("the file is empty", likely="a recording that was never closed")
        table = READERS.get(source.suffix.lower(), _text)(source)
        if not len(table):
            raise InvalidLog("there are no rows of numbers", likely="an empty recording")
    except InvalidLog as error:
        raise InvalidLog(f"{source.name}: {error}") from None
    except OSError as error:
        raise InvalidLog(f"{source} cannot be read: {error.strerror or error}") from None
    return RawTable(table.columns, table.units, table.text, table.comments, source.name, table.origin)


def table_of(log: Log) -> RawTable:
    """A log as a table with the columns `t` and its channels."""
    return RawTable({TIME: log.t, **log.channels}, {TIME: "s", **log.units}, origin=log.origin)


@dataclass(frozen=True)
class _Dialect:
    """Layout of a text file: separator, column names, and the first line of numbers (from 0)."""

    separator: str
    names: Sequence[str]
    first: int
    comments: tuple[str, ...]
    decimal: str


def _text(path: Path) -> RawTable:
    check_lines(path, 1)
    raw = path.read_bytes()
    if raw.lstrip()[:1] in (b"{", b"["):
        return _json(path)
    try:
        head = raw[: 1 << 16].decode("utf-8-sig", errors="strict" if len(raw) <= 1 << 16 else "ignore")
    except UnicodeDecodeError:
        head = "\0"
    if "\0" in head:
        raise InvalidLog("the file is not text", likely="a binary file under this name", hint="export it as CSV")
    dialect = _dialect([line.rstrip("\r") for line in head.split("\n")])
    note = next((line for line in dialect.comments if line.startswith(_NOTE)), "")
    units, origin = understand(note.removeprefix(_NOTE)) if note else ({}, {})
    check_lines(path, len(dialect.names))
    columns, text = _parse(raw, dialect)
    return RawTable(columns, units, text, dialect.comments, origin=origin)


def _dialect(lines: Sequence[str]) -> _Dialect:
    comments, first = [], 0
    for first, line in enumerate(lines):  # noqa: B007 (the number of the first line of the table)
        if line.strip() and not line.lstrip().startswith(("#", "%", "//")):
            break
        comments += [line] if line.strip() else []
    else:
        raise InvalidLog("there are no rows of numbers", likely="an empty recording")
    head = lines[first]
    separator = next((mark for mark in (";", "\t", ",") if mark in head), " ")
    cells = _cells(head, separator)
    decimal = "," if separator != "," and re.search(r"\d,\d", " ".join(lines[first + 1 : first + 3])) else "."
    if any(_is_number(cell.replace(decimal, ".")) for cell in cells):
        return _Dialect(separator, [f"c{i + 1}" for i in range(len(cells))], first, tuple(comments), decimal)
    names = [cell.strip() for cell in cells]
    twice = [name for i, name in enumerate(names) if name in names[:i]]
    if twice:
        raise InvalidLog(f"column '{twice[0]}' appears twice", hint="rename or drop one")
    return _Dialect(separator, names, first + 1, tuple(comments), decimal)


def _cells(line: str, separator: str) -> list[str]:
    return line.split() if separator == " " else next(csv.reader([line], delimiter=separator))


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True


def _parse(raw: bytes, dialect: _Dialect) -> tuple[dict[str, Array], dict[str, str]]:
    import pyarrow as pa
    import pyarrow.csv as pc

    lines = raw.split(b"\n", dialect.first)
    body = lines[dialect.first] if len(lines) > dialect.first else b""
    if dialect.separator == " ":
        body = b"\n".join(b" ".join(line.split()) for line in body.splitlines())
    names = list(dialect.names)
    if not body.strip():
        raise InvalidLog("there are no rows below the header", likely="an empty recording")
    options = pc.ConvertOptions(decimal_point=dialect.decimal, strings_can_be_null=True)
    reading = pc.ReadOptions(column_names=names)
    parsing = pc.ParseOptions(delimiter=dialect.separator, ignore_empty_lines=True)
    try:
        table = pc.read_csv(io.BytesIO(body), read_options=reading, convert_options=options, parse_options=parsing)
    except pa.ArrowInvalid as error:
        reason = " ".join(str(error).split())[:160]
        raise InvalidLog(
            f"the rows cannot be read ({reason})",
            expected=f"{len(names)} values in each",
            likely="a row that was cut off",
        ) from None
    return _sorted({name: table.column(name) for name in names})


def _sorted(columns: Mapping[str, Any]) -> tuple[dict[str, Array], dict[str, str]]:
    """Numbers apart from text, from columns of Arrow."""
    import pyarrow as pa

    numbers: dict[str, Array] = {}
    text: dict[str, str] = {}
    kinds = pa.types
    for name, column in columns.items():
        kind = column.type
        if kinds.is_integer(kind) or kinds.is_floating(kind) or kinds.is_null(kind) or kinds.is_boolean(kind):
            cast_to = column.cast(pa.int8()) if kinds.is_boolean(kind) else column
            numbers[name] = np.asarray(cast_to.cast(pa.float64(), safe=False).to_numpy(), dtype=np.float64)
        else:
            text[name] = _first_text(column.to_pylist())
    return numbers, text


def _first_text(values: Sequence[Any]) -> str:
    for row, value in enumerate(values):
        if value is not None and not _is_number(str(value)):
            return f"the text '{str(value)[:40]}' at row {row}"
    return "text"


def _json(path: Path) -> RawTable:
    content = read_json(path, InvalidLog, '{"name": [numbers], …} or a list of such rows')
    if isinstance(content, list) and content and all(isinstance(row, dict) for row in cast("list[Any]", content)):
        rows = cast("list[dict[str, Any]]", content)
        content = {name: [row.get(name) for row in rows] for name in rows[0]}
    if not isinstance(content, dict):
        raise InvalidLog("the JSON holds no columns", expected='{"name": [numbers], …} or a list of such rows')
    lists = {name: value for name, value in cast("dict[str, Any]", content).items() if isinstance(value, list)}
    return _equal({name: _listed(cast("list[Any]", value)) for name, value in lists.items()})


def _listed(values: list[Any]) -> Array | str:
    try:
        return np.array([np.nan if value is None else value for value in values], dtype=np.float64)
    except (TypeError, ValueError):
        return _first_text(values)


def _equal(columns: Mapping[str, Array | str]) -> RawTable:
    numbers = {name: value for name, value in columns.items() if not isinstance(value, str) and value.ndim == 1}
    text = {name: value for name, value in columns.items() if isinstance(value, str)}
    lengths = sorted({len(value) for value in numbers.values()})
    if len(lengths) > 1:
        shown = ", ".join(f"{name} {len(value)}" for name, value in list(numbers.items())[:6])
        raise InvalidLog(f"columns of unequal lengths: {shown}", expected="one value for each sample")
    return RawTable(numbers, text=text)


def _mat(path: Path) -> RawTable:
    try:
        done = subprocess.run([*MAT_READER, str(path)], capture_output=True, check=False, timeout=MAT_SECONDS)
    except subprocess.TimeoutExpired:
        raise InvalidLog(f"the MAT file cannot be read in {MAT_SECONDS} s", hint="export it again") from None
    if done.returncode or not done.stdout:
        why = done.stderr.decode("utf-8", "replace").strip().splitlines()[-1:] or ["its parser crashed"]
        hint = "save it in MATLAB with '-v7'" if "HDF" in why[0] else "export it again"
        raise InvalidLog(f"the MAT file cannot be read ({' '.join(why[0].split())[:80]})", hint=hint)
    with np.load(io.BytesIO(done.stdout), allow_pickle=False) as stored:
        names = stored["names"].tolist()
        return RawTable({name: stored[f"column{i}"] for i, name in enumerate(names)})


def _parquet(path: Path) -> RawTable:
    table = parquet.table_of(path)
    note = (table.schema.metadata or {}).get(b"upright-log")
    units, origin = understand(note) if note is not None else ({}, {})
    columns, text = _sorted({name: table.column(name) for name in table.column_names})
    return RawTable(columns, units, text, origin=origin)


def _mcap(path: Path) -> RawTable:
    return table_of(Log.load(path))


READERS: dict[str, Callable[[Path], RawTable]] = {
    ".json": _json, ".mat": _mat, ".parquet": _parquet, ".mcap": _mcap,
}  # fmt: skip
"""Suffix → reader; every other suffix is read as text."""
