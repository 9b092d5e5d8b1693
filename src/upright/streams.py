"""What a command prints, whatever takes it: nobody, a program that stops reading, a full disk, another alphabet."""

from __future__ import annotations

import io
import os
import sys
from typing import Any


class Sink(io.FileIO):
    """An open stream, to which writing never fails: after the first `error` it leads nowhere. A reader that has gone is
    no error: it has what it asked for."""

    error: OSError | None = None

    def write(self, data: Any, /) -> int:
        try:
            return os.write(self.fileno(), data)
        except OSError as error:
            self.error = None if isinstance(error, BrokenPipeError) else error
            os.dup2(os.open(os.devnull, os.O_WRONLY), self.fileno())
            return memoryview(data).nbytes


def guard() -> Sink:
    """Print through sinks from now on; returns that of stdout.

    A closed stream becomes one that goes nowhere, lest the next file that is opened takes its number. A character that
    the stream's alphabet lacks is printed as "?".
    """
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest free number, which is this one
    sys.stdin = sys.stdin or os.fdopen(0, closefd=False)
    out, err = (Sink(number, "w", closefd=False) for number in (1, 2))
    sys.stdout = _text(out, sys.stdout, "replace", out.isatty())
    sys.stderr = _text(err, sys.stderr, "backslashreplace", True)
    return out


def _text(sink: Sink, before: Any, errors: str, by_line: bool) -> io.TextIOWrapper:
    encoding = before.encoding if before else "utf-8"
    return io.TextIOWrapper(io.BufferedWriter(sink), encoding, errors, line_buffering=by_line)
