"""Foreign logs as tables of numbers: CSV in its dialects, Parquet, MCAP, MAT and JSON of columns."""

from __future__ import annotations

import io
import re
import subprocess
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from os import PathLike
from pathlib import Path
from typing import Any, cast

import numpy as np

from upright.arrays import Array, floats_of
from upright.errors import InvalidLog, one_line
from upright.logs.layout import Layout, bare, cells_of, is_number, layout, padded
from upright.reading import parse_json, read_text
from upright.signals import Log, parquet
from upright.signals.files import existing
from upright.signals.header import TIME, check_lines, understand

_NOTE = "# upright-log: "
DECIMATION = "one_in"
"""In a log's origin: of how many rows its file has one, where the file says that others were left out."""
GAINS = "stated_gains"
"""In a log's origin: the gains that the lines before its header state, by their words."""
_GAIN = re.compile(r"\b(?:gain|k)(?:\s*[=:]\s*|\s+(?:of\s+)?)(\d{1,2}(?:\.\d+)?)(?![\w.])", re.IGNORECASE)
MOST_GAINS = 3  # that a file may state: where it lists more, they are those of a controller
LARGEST_GAIN = 10.0  # [1] either way, of commands
_DECIMATED = re.compile(r"\bdecim(?:at\w*)?\s*[=:]\s*(\d{1,4})\b", re.IGNORECASE)

MAT_READER = [sys.executable, "-m", "upright.logs.mat_process"]
"""The program that reads MAT files, since damaged ones crash SciPy's parser and the process that it runs in."""

MAT_SECONDS = 120


@dataclass(frozen=True, eq=False)
class RawTable:
    """`columns` of equal length by name, as they stand in the file `source`.

    `units` holds the units that the file states; `text` names the columns without numbers, each with an example;
    `comments` are the lines before the header, `skipped` those among the rows that are no row, each with its number;
    `origin` is the origin of one of our own logs.
    """

    columns: Mapping[str, Array]
    units: Mapping[str, str] = field(default_factory=dict[str, str])
    text: Mapping[str, str] = field(default_factory=dict[str, str])
    comments: tuple[str, ...] = ()
    skipped: tuple[str, ...] = ()
    source: str = ""
    origin: Mapping[str, Any] = field(default_factory=dict[str, Any])

    def __len__(self) -> int:
        return len(next(iter(self.columns.values()), ()))

    @property
    def decimation(self) -> tuple[int, str]:
        """One row in how many was logged, as the file says, with its words: (2, "decim=2"); (1, "") without any."""
        words = [match for line in self.comments if (match := _DECIMATED.search(line)) and int(match[1]) > 1]
        return (int(words[0][1]), words[0][0]) if words else (1, "")

    @property
    def gains(self) -> dict[str, float]:
        """The gains other than one that the file states, by its words: {"gain=1.50": 1.5}; a list of many is that of a
        controller, and none."""
        stated = {
            m[0]: float(m[1]) for line in self.comments if _NOTE.strip() not in line for m in _GAIN.finditer(line)
        }
        usable = {w: g for w, g in stated.items() if g != 1 and 1 / LARGEST_GAIN <= g <= LARGEST_GAIN}
        return usable if len(usable) <= MOST_GAINS else {}

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
    commas beside semicolons, a row of units, tags or names printed before the numbers, and no header: columns are then
    called c1, c2, …. Raises `InvalidLog`.
    """
    source = existing(Path(path))
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
    return replace(_stamped(table), source=source.name)


def table_of(log: Log) -> RawTable:
    """A log as a table with the columns `t` and its channels."""
    return RawTable({TIME: log.t, **log.channels}, {TIME: "s", **log.units}, origin=log.origin)


def _text(path: Path) -> RawTable:
    check_lines(path, 1)
    raw = path.read_bytes()
    if re.match(rb"\s*(?:\{|\[\s*[\[{])", raw):  # a tag as in [INF] is no JSON
        return _json(path)
    text = _decoded(raw)
    lines = [line.rstrip("\r") for line in text.split("\n")]
    rows = bare(lines)
    if rows is not None:
        lines = rows
        text = "\n".join(rows)
    form = layout(lines[:HEAD])
    units, origin = _noted(form)
    check_lines(path, len(form.names))
    columns, words, clocks, skipped = _parse(text.encode(), form)
    units = {**form.units, **dict.fromkeys(clocks, "s"), **units}
    return RawTable(columns, units, words, form.comments, origin=origin, skipped=skipped)


HEAD = 5000  # lines, comments included, in which the numbers begin


def _decoded(raw: bytes) -> str:
    """The text in UTF-8, in UTF-16 with its mark, or else in the encoding of older spreadsheets."""
    if raw[:2] in (b"\xff\xfe", b"\xfe\xff"):
        text = raw.decode("utf-16", "replace")
    else:
        try:
            text = raw.decode("utf-8-sig")
        except UnicodeDecodeError:
            text = "\0" if re.search(rb"[\x00-\x08\x0e-\x1f]", raw[: 1 << 16]) else raw.decode("cp1252", "replace")
    if "\0" in text:
        raise InvalidLog("the file is not text", likely="a binary file under this name", hint="export it as CSV")
    return text


def _noted(form: Layout) -> tuple[Mapping[str, str], Mapping[str, Any]]:
    """Units and origin of one of our own logs. A spreadsheet may have split their line into quoted cells: what it
    cannot be joined from is left out."""
    line = next((line for line in form.comments if _NOTE.strip() in line), "")
    if line.startswith(_NOTE):
        try:
            return understand(line.removeprefix(_NOTE))
        except InvalidLog:
            if not line.rstrip().endswith(form.separator):
                raise
    joined = ",".join(cells_of(line, form.separator)).rstrip(", ") if line else ""
    try:
        return understand(joined.partition(_NOTE.strip())[2]) if joined else ({}, {})
    except InvalidLog:
        return {}, {}


def _parse(raw: bytes, form: Layout) -> tuple[dict[str, Array], dict[str, str], list[str], tuple[str, ...]]:
    """Numbers, words and clocks as of `_sorted`, and the lines that are no row."""
    import pyarrow as pa
    import pyarrow.csv as pc

    lines = raw.split(b"\n", form.first)
    body = lines[form.first] if len(lines) > form.first else b""
    if form.separator == " ":
        body = b"\n".join(b" ".join(line.split()) for line in body.splitlines())
    names = list(form.names)
    if not body.strip():
        raise InvalidLog("there are no rows below the header", likely="an empty recording")
    options = pc.ConvertOptions(decimal_point=form.decimal, strings_can_be_null=True)
    reading = pc.ReadOptions(column_names=names)
    parsing = pc.ParseOptions(delimiter=form.separator, ignore_empty_lines=True)

    def read(rows: bytes) -> Any:
        return pc.read_csv(io.BytesIO(rows), read_options=reading, convert_options=options, parse_options=parsing)

    wrong = ""
    try:
        table = read(body)
        plain = all(not pa.types.is_string(table.column(name).type) for name in names)
    except pa.ArrowInvalid as error:
        table = None
        plain = False
        wrong = one_line(error)
    skipped: tuple[str, ...] = ()
    if not plain:
        rows, skipped = _rows_alone(body.decode(), form)
        rows = rows if skipped or table is not None else padded(rows, form)
        table = read(rows.encode()) if skipped or (table is None and rows) else table
    if table is None:
        raise InvalidLog(
            f"the rows cannot be read ({wrong})",
            expected=f"{len(names)} values in each",
            likely="a row that was cut off",
        )
    return *_sorted({name: table.column(name) for name in names}), skipped


MOST_SKIPPED = 0.05  # [1] of the lines below the header: where more are no rows, the layout is misread


def _rows_alone(body: str, form: Layout) -> tuple[str, tuple[str, ...]]:
    """The lines that are rows, and the others: messages of a program, rows that were cut off, a header once more."""
    lines = body.split("\n")
    table = [[cell.strip() for cell in cells_of(line, form.separator)] if line.strip() else [] for line in lines]
    full = [cells for cells in table if len(cells) == len(form.names)]

    def numeric(cell: str) -> bool:
        return not cell or is_number(cell.replace(form.decimal, "."))

    held = [sum(numeric(cells[i]) for cells in full) >= (1 - MOST_SKIPPED) * len(full) for i in range(len(form.names))]
    good = [
        not cells
        or (len(cells) == len(held) and all(numeric(c) for c, is_held in zip(cells, held, strict=True) if is_held))
        for cells in table
    ]
    wrong = [i for i, is_row in enumerate(good) if not is_row]
    if not any(held) or len(wrong) > MOST_SKIPPED * len(lines):
        return body, ()
    kept = "\n".join(line for line, is_row in zip(lines, good, strict=True) if is_row)
    return kept, tuple(f"line {form.first + i + 1}: {lines[i].strip()[:60]}" for i in wrong)


_TIME_OF_DAY = re.compile(
    r"(?:\d{4}[-/.]\d{1,2}[-/.]\d{1,2}[ T])?(\d{1,2}):(\d\d):(\d\d(?:[.,]\d+)?)(?:Z|[-+]\d\d:?\d\d)?"
)
_DAY = 86400.0  # [s]


def _seconds(values: Sequence[Any]) -> Array | None:
    """Times of day as seconds, over midnight too; None where a value is none."""
    matches = [_TIME_OF_DAY.fullmatch(str(value).strip()) for value in values]
    if not matches or not all(matches):
        return None
    t = np.array([3600 * int(m[1]) + 60 * int(m[2]) + float(m[3].replace(",", ".")) for m in matches if m])
    return t + _DAY * np.cumsum(np.r_[0.0, np.diff(t) < -_DAY / 2])


def _sorted(columns: Mapping[str, Any]) -> tuple[dict[str, Array], dict[str, str], list[str]]:
    """Numbers apart from text, from columns of Arrow, and which of the numbers are clocks: times of day as seconds."""
    import pyarrow as pa

    numbers: dict[str, Array] = {}
    text: dict[str, str] = {}
    clocks: list[str] = []
    kinds = pa.types
    for name, column in columns.items():
        kind = column.type
        if kinds.is_integer(kind) or kinds.is_floating(kind) or kinds.is_null(kind) or kinds.is_boolean(kind):
            numbers[name] = floats_of(column.cast(pa.int8()) if kinds.is_boolean(kind) else column)
        elif (t := _seconds(column.to_pylist())) is not None:
            numbers[name] = t
            clocks.append(name)
        else:
            text[name] = _first_text(column.to_pylist())
    return numbers, text, clocks


def _first_text(values: Sequence[Any]) -> str:
    for row, value in enumerate(values):
        if value is not None and not is_number(str(value)):
            return f"the text '{str(value)[:40]}' at row {row}"
    return "text"


_PARAMETERS = 20  # numbers; a shorter list beside the columns holds what the program was set to
_JSON = '{"name": [numbers], …}, a list of such rows, or one row a line'


def _json(path: Path) -> RawTable:
    """An object of lists, a list of rows, or a row on each line; what is nested is named by `part.name`."""
    text = read_text(path, InvalidLog, _JSON)
    lines = [line for line in text.splitlines() if line.strip()]
    each = len(lines) > 1 and all(line.lstrip().startswith("{") and line.rstrip().endswith("}") for line in lines[:2])
    content: Any = [_row(line) for line in lines] if each else parse_json(text, str(path), InvalidLog, _JSON)
    if isinstance(content, dict):
        parts = cast("dict[str, Any]", content)
        content = next((part for part in parts.values() if _is_rows(part) or _is_matrix(part)), parts)
    if _is_matrix(content):
        matrix = np.array(content, dtype=np.float64)
        return RawTable({f"c{i + 1}": column for i, column in enumerate(matrix.T)})
    if _is_rows(content):
        rows = [_flat(row, "") for row in cast("list[dict[str, Any]]", content)]
        names = dict.fromkeys(name for row in rows for name in row)
        content = {name: [row.get(name) for row in rows] for name in names}
    if not isinstance(content, dict):
        raise InvalidLog("the JSON holds no columns", expected=_JSON)
    lists = {name: value for name, value in _flat(content, "", lists=False).items() if isinstance(value, list)}
    return _equal({name: _listed(cast("list[Any]", value)) for name, value in lists.items()})


def _row(line: str) -> Any:
    return parse_json(line, "a line of the file", InvalidLog, _JSON)


def _is_rows(content: Any) -> bool:
    return isinstance(content, list) and bool(content) and all(isinstance(r, dict) for r in cast("list[Any]", content))


def _is_matrix(content: Any) -> bool:
    """Whether these are rows of numbers without names."""
    if not isinstance(content, list) or len(cast("list[Any]", content)) < _PARAMETERS:
        return False
    rows = cast("list[Any]", content)
    return all(isinstance(row, list) and len(cast("list[Any]", row)) == len(rows[0]) > 1 for row in rows) and all(
        one is None or (isinstance(one, int | float) and not isinstance(one, bool)) for row in rows for one in row
    )


def _flat(row: Mapping[str, Any], before: str, *, lists: bool = True) -> dict[str, Any]:
    """Objects within objects as `part.name`, and `lists` of numbers as `part.0`, `part.1`, …"""
    flat: dict[str, Any] = {}
    for name, value in row.items():
        parts: Any = value
        if isinstance(value, list) and lists:
            parts = {str(i): one for i, one in enumerate(cast("list[Any]", value))}
        if isinstance(parts, dict):
            flat |= _flat(cast("dict[str, Any]", parts), f"{before}{name}.", lists=lists)
        else:
            flat[before + name] = value
    return flat


_SECONDS_OF = re.compile(r"((.*?)[./_ ]?)(?:secs?|seconds)", re.IGNORECASE)
_NANOSECONDS = ("nsecs", "nsec", "nanosec", "nanosecs", "nanoseconds")


def _stamped(table: RawTable) -> RawTable:
    """Seconds and nanoseconds in two columns, as ROS has them, as one column of seconds from the first on."""
    for name in table.columns:
        whole = _SECONDS_OF.fullmatch(name)
        twin = next((n for end in _NANOSECONDS if whole and (n := whole[1] + end) in table.columns), "")
        if whole and twin:
            seconds = table.columns[name] - table.columns[name][0] + 1e-9 * table.columns[twin]
            kept = {n: x for n, x in table.columns.items() if n not in (name, twin)}
            stem = whole[2] or "stamp"
            return replace(table, columns={stem: seconds, **kept}, units={**table.units, stem: "s"})
    return table


def _listed(values: list[Any]) -> Array | str:
    try:
        return np.array([np.nan if value is None else value for value in values], dtype=np.float64)
    except (TypeError, ValueError):
        return _first_text(values)


def _equal(columns: Mapping[str, Array | str]) -> RawTable:
    numbers = {name: value for name, value in columns.items() if not isinstance(value, str) and value.ndim == 1}
    text = {name: value for name, value in columns.items() if isinstance(value, str)}
    if any(len(value) >= _PARAMETERS for value in numbers.values()):
        numbers = {name: value for name, value in numbers.items() if len(value) >= _PARAMETERS}
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
    columns, text, _ = _sorted({name: table.column(name) for name in table.column_names})
    return RawTable(columns, units, text, origin=origin)


def _mcap(path: Path) -> RawTable:
    return table_of(Log.load(path))


READERS: dict[str, Callable[[Path], RawTable]] = {
    ".json": _json, ".mat": _mat, ".parquet": _parquet, ".mcap": _mcap,
}  # fmt: skip
"""Suffix → reader; every other suffix is read as text."""
