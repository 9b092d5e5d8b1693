"""How an interrupted run ends: within a second, without a result, whatever computes at that moment.

Python hands a signal to the main thread, between two steps of its own: never while compiled code runs there; and the
exception it raises is lost, and printed, where C called Python, as it does for a finalizer. So a thread waits for
signals as well, and ends the process where the exception does not.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from typing import Any, NoReturn

GRACE = 0.5  # [s] for the exception to end the run

SIGNALS = tuple(getattr(signal, name) for name in ("SIGINT", "SIGTERM", "SIGHUP") if hasattr(signal, name))
STOPPED = "stopped; no incomplete file is left\n"
MOTORS = threading.Lock()
"""Held while motors run: the process does not end before they are stopped."""


class Stopped(KeyboardInterrupt):
    """Ctrl-C in work of which a part is worth something: the `result` of what was done before."""

    def __init__(self, result: Any) -> None:
        super().__init__()
        self.result = result


class Run:
    """The state of this process: the `number` of the signal that came (0: none), the `message` then, whether a signal
    is how this run usually ends (`lasting`: then it takes its time, and writes what it has), what is done at a first
    one that leaves it time (`keeps`), whether a part of its result has been `kept`, whether it is `complete`, and what
    removes unfinished files at its `end`."""

    number = 0
    message = STOPPED
    lasting = False
    keeps: tuple[Callable[[], None], ...] = ()
    kept = False
    complete = False
    end: tuple[Callable[[], None], ...] = ()


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


def reset() -> None:
    """A run begins, maybe not the first of this process: no signal has come to it, and it has kept nothing."""
    Run.number = 0
    Run.keeps = ()
    Run.lasting = Run.kept = Run.complete = False


def interrupted() -> bool:
    """Whether a signal ends this run."""
    return bool(Run.number) and not (Run.lasting or Run.kept)


def check() -> None:
    """Raise `KeyboardInterrupt` in an interrupted run."""
    if interrupted():
        raise KeyboardInterrupt


def complete() -> None:
    """Say that the run is complete: a signal that comes now comes too late. Raises as `check`."""
    check()
    Run.complete = True


@contextmanager
def keeping(first: Callable[[], None]) -> Generator[None]:
    """In here the `first` signal, at which that is called, leaves the run the time to raise `Stopped` with what it has;
    a second one ends it."""
    Run.keeps = (first,)
    try:
        yield
    except Stopped:
        Run.kept = True
        raise
    finally:
        Run.keeps = ()


@contextmanager
def without_ctrl_c() -> Generator[None]:
    """Threads and processes that start here never get SIGINT: a terminal sends Ctrl-C to all, and a process that is
    just importing would print a traceback. This process gets it by another thread, and ends them."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    _begin_tracker()
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _begin_tracker() -> None:
    """Start the process that removes what this one leaves of its locks: else the first process that is spawned starts
    it, and then unblocks signals. That an interrupted run has left some is no news to anybody."""
    from multiprocessing import resource_tracker

    given = os.environ.get("PYTHONWARNINGS", "")
    os.environ["PYTHONWARNINGS"] = f"{given},ignore::UserWarning:multiprocessing.resource_tracker"
    try:
        resource_tracker.ensure_running()
    finally:
        os.environ["PYTHONWARNINGS"] = given


def exit_code() -> int:
    """128 and the signal's number, as shells count."""
    return 128 + (Run.number or signal.SIGINT)


def leave(code: int) -> NoReturn:
    """End the process with this exit code, at once where it is interrupted: nothing is waited for."""
    if Run.kept or interrupted():
        _end()
    sys.exit(code)


def _interrupt(number: int, frame: object) -> None:  # noqa: ARG001 (as Python calls it)
    if not Run.complete:
        Run.number = number
        raise KeyboardInterrupt


def _lost(what: sys.UnraisableHookArgs) -> None:
    """Nothing is said of an interrupt's exception that is lost: the thread that waits ends the run, and says so."""
    if not (Run.number and issubclass(what.exc_type, KeyboardInterrupt)):
        sys.__unraisablehook__(what)


def _wait(reader: int) -> None:
    while True:
        number = os.read(reader, 1)[0]
        if number not in SIGNALS or Run.lasting:
            continue
        keeps, Run.keeps = Run.keeps, ()  # at once: the main thread may take them away meanwhile
        for first in keeps:
            with suppress(Exception):  # of a closed terminal: this thread is the only one that waits
                first()
        if keeps:
            continue
        time.sleep(GRACE)
        with MOTORS:
            if not Run.complete:
                Run.number = number
                with suppress(OSError):
                    os.write(2, Run.message.encode())
                _end()


def _end() -> NoReturn:
    for clean in Run.end:
        with suppress(Exception):
            clean()
    os._exit(exit_code())
