"""What a command prints, whatever takes it: nobody, a program that stops reading, a full disk, another alphabet."""

from __future__ import annotations

import io
import os
import sys
from typing import Any, TextIO


class Sink(io.RawIOBase):
    """The open stream number `descriptor`, to which writing never fails: the first `error` is kept, and what comes
    after it goes nowhere. A reader that has gone is no error: it has what it asked for."""

    def __init__(self, descriptor: int) -> None:
        self._descriptor = descriptor
        self._broken = False
        self.error: OSError | None = None

    def writable(self) -> bool:
        return True

    def fileno(self) -> int:
        return self._descriptor

    def isatty(self) -> bool:
        return os.isatty(self._descriptor)

    def write(self, data: Any, /) -> int:
        size = memoryview(data).nbytes
        if self._broken:
            return size
        try:
            return os.write(self._descriptor, data)
        except OSError as error:
            self._broken = True
            self.error = None if isinstance(error, BrokenPipeError) else error
            return size


def guard() -> Sink:
    """Print through sinks from now on; returns that of stdout.

    A closed stream becomes one that goes nowhere, lest the next file that is opened takes its number. A character that
    the stream's alphabet lacks is printed as "?".
    """
    for descriptor in range(3):
        try:
            os.fstat(descriptor)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest free number, which is this one
    out, err = Sink(1), Sink(2)
    sys.stdout, sys.stderr = _text(out, sys.stdout), _text(err, sys.stderr)
    if sys.stdin is None:
        sys.stdin = os.fdopen(0, closefd=False)
    return out


def _text(sink: Sink, before: TextIO | None) -> io.TextIOWrapper:
    encoding, error = before.encoding if before else "utf-8", sink.fileno() == 2
    return io.TextIOWrapper(
        io.BufferedWriter(sink), encoding=encoding, errors="backslashreplace" if error else "replace",
        line_buffering=error or sink.isatty(),
    )  # fmt: skip
