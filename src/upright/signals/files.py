"""Logs as files: Parquet to keep, CSV to look at, MCAP to plot; the suffix chooses."""

from __future__ import annotations

import difflib
import os
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, TypeVar

from upright.atomic import writing
from upright.errors import InvalidLog, UprightError, require
from upright.reading import expanded
from upright.signals.header import Columns, check_writable


@dataclass(frozen=True)
class _Format:
    """How one kind of file is written to a stream and read from a path."""

    write: Callable[[Columns, BinaryIO], None]
    read: Callable[[Path], Columns]


def _parquet() -> _Format:
    from upright.signals import parquet

    return _Format(parquet.write, parquet.read)


def _csv() -> _Format:
    from upright.signals import text

    return _Format(text.write, text.read)


def _mcap() -> _Format:
    require("a log as .mcap", "mcap")
    from upright.signals import mcap

    return _Format(mcap.write, mcap.read)


T = TypeVar("T")

FORMATS: dict[str, Callable[[], _Format]] = {".parquet": _parquet, ".csv": _csv, ".mcap": _mcap}
"""Suffix → the format, whose packages are loaded only when it is asked for."""


def write(log: Columns, path: str | Path) -> Path:
    """Write a log as Parquet, CSV or MCAP by the suffix of `path`, and return that path with `~` expanded.

    One log always gives the same bytes. The file appears whole or not at all. Raises `InvalidLog` for an unknown
    suffix, a place that cannot be written, or a channel name that no column can have.
    """
    target = expanded(path, InvalidLog)
    form = _format(target)
    check_writable(log.channels)
    try:
        with writing(target) as stream:
            form.write(log, stream)
    except InvalidLog as error:
        raise InvalidLog(f"{target}: {error}") from None
    except UprightError as error:
        raise InvalidLog(str(error)) from None
    return target


def read(path: str | Path, make: Callable[[Columns], T]) -> T:
    """What `make` builds from the columns in a file of `write`, or in any CSV or Parquet with a column `t` [s].

    Cells that are empty or say NaN are NaN. Raises `InvalidLog` with the file's name, also for what `make` refuses.
    """
    source = existing(path)
    form = _format(source)
    try:
        if source.stat().st_size == 0:
            raise InvalidLog("the file is empty", likely="a recording that was never closed")
        return make(form.read(source))
    except OSError as error:
        raise InvalidLog(f"{source} cannot be read: {error.strerror or error}") from None
    except InvalidLog as error:
        raise InvalidLog(f"{source}: {error}") from None


def check_format(path: Path | None) -> None:
    """Refuse, before the work, a name by whose suffix no log can be written here: `InvalidLog`, `MissingTool`."""
    if path:
        _format(path)


def existing(path: str | Path) -> Path:
    """The file of a log; raises `InvalidLog` for a folder, and where there is none, with the name that may be meant."""
    source = expanded(path, InvalidLog)
    if source.is_dir():
        raise InvalidLog(f"{source} is a folder", expected="the file of a log")
    if not source.exists():
        raise InvalidLog(f"there is no file {source}", hint=_similar(source))
    return source


def _format(path: Path) -> _Format:
    suffix = path.suffix.lower()
    if suffix not in FORMATS:
        raise InvalidLog(f"{path} has the suffix '{path.suffix}'", expected="one of " + ", ".join(FORMATS))
    return FORMATS[suffix]()


def _similar(path: Path) -> str:
    if not path.parent.is_dir():
        return f"there is no folder {path.parent} either"
    close = difflib.get_close_matches(path.name, sorted(os.listdir(path.parent)), n=1)
    return f"did you mean '{close[0]}'?" if close else "look at the path again"
