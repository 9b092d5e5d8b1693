"""How an interrupted run ends: within a second, without a result, whatever computes at that moment.

Python hands a signal to the main thread, between two steps of its own: never while compiled code runs there; and the
exception it raises is lost, and printed, where C called Python, as it does for a finalizer. So a thread waits for
signals as well. It notes that the run is interrupted, after which no file appears (`check`), and ends the process where
the exception does not.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from typing import NoReturn

GRACE = 0.5  # [s] for the exception to end the run

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
STOPPED = "stopped; no incomplete file is left\n"


class _Run:
    """The state of this process: the `number` of the signal that came, whether this is how the run usually ends
    (`lasting`), how many wait for motors to stop (`patience`), whether it is complete (`closing`), and what removes
    unfinished files at its `end`."""

    number = 0
    lasting = False
    patience = 0
    closing = False
    end: list[Callable[[], None]] = []  # noqa: RUF012 (there is one run)


def watch() -> None:
    """From now on signals end this process; those that its parent had it ignore stay ignored."""
    for number in SIGNALS:
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, _interrupt)
    sys.unraisablehook = _lost
    reader, writer = os.pipe()
    if hasattr(os, "set_blocking"):
        os.set_blocking(writer, False)
    signal.set_wakeup_fd(writer, warn_on_full_buffer=False)
    threading.Thread(target=_wait, args=(reader,), daemon=True, name="interrupts").start()


def interrupted() -> bool:
    """Whether a signal ends this run."""
    return bool(_Run.number) and not _Run.lasting


def check() -> None:
    """Raise `KeyboardInterrupt` in an interrupted run."""
    if interrupted():
        raise KeyboardInterrupt


def exit_code() -> int:
    """128 and the signal's number, as shells count."""
    return 128 + (_Run.number or signal.SIGINT)


def last(lasting: bool) -> None:
    """Say whether a signal is how this run usually ends: then it takes its time, and writes what it has."""
    _Run.lasting = lasting


def lasts() -> bool:
    """Whether a signal is how this run usually ends."""
    return _Run.lasting


@contextmanager
def patience() -> Generator[None]:
    """What has to be left in order before the process ends: a motor that runs."""
    _Run.patience += 1
    try:
        yield
    finally:
        _Run.patience -= 1


def close() -> None:
    """Say that the run is complete: a signal that comes now comes too late. Raises `KeyboardInterrupt` after one that
    came before."""
    if threading.current_thread() is threading.main_thread() and signal.getsignal(signal.SIGINT) == _interrupt:
        for number in SIGNALS:
            signal.signal(number, signal.SIG_IGN)
    check()
    _Run.closing = True


def at_end(clean: Callable[[], None]) -> None:
    """Have `clean` called where the process ends at once."""
    _Run.end.append(clean)


def leave(code: int) -> NoReturn:
    """End the process with this exit code, at once where it is interrupted: nothing is waited for."""
    if interrupted():
        _end()
    sys.exit(code)


def _interrupt(number: int, frame: object) -> None:  # noqa: ARG001 (as Python calls it)
    _Run.number = number
    raise KeyboardInterrupt


def _lost(what: sys.UnraisableHookArgs) -> None:
    """Nothing is said of an interrupt's exception that is lost: the thread that waits ends the run, and says so."""
    if not (_Run.number and issubclass(what.exc_type, KeyboardInterrupt)):
        sys.__unraisablehook__(what)


def _wait(reader: int) -> None:
    while True:
        for number in os.read(reader, 64):
            if number not in SIGNALS or _Run.closing:
                continue
            _Run.number = number
            if not _Run.lasting:
                time.sleep(GRACE)
                while _Run.patience:
                    time.sleep(GRACE)
                if not _Run.closing:
                    with suppress(OSError):
                        os.write(2, STOPPED.encode())
                    _end()


def _end() -> NoReturn:
    for clean in _Run.end:
        with suppress(Exception):
            clean()
    os._exit(exit_code())
