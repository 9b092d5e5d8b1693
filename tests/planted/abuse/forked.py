"""A call in a child of its own, with limits: what it returned, or how it ended, and the most memory it took."""

from __future__ import annotations

import os
import pickle
import resource
import signal
import sys
import time
import traceback
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from upright.streams import guard

SECONDS = 30.0
"""[s] of a processor's time after which a call hangs; on the wall eight times as long, for a busy machine."""

ROOM = 6 << 30
"""[bytes] of addresses beyond what is mapped already, so that a runaway ends in MemoryError, not in a dead machine."""


@dataclass(frozen=True)
class Ended:
    """`value` is what the call returned; `how` is "", or "unexpected …", "killed by …" or "hangs"; `peak` [MB] is the
    most memory that it took beyond what was loaded before; `text` is what it printed to stdout and stderr."""

    value: Any
    how: str
    peak: float
    text: str


def forked(work: Callable[[], Any], scratch: Path) -> Ended:
    """Run `work` in a forked child whose stdout and stderr go to a file in `scratch`."""
    answer, printed = scratch / "answer", scratch / "printed"
    answer.unlink(missing_ok=True)
    held = int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize() / 2**20
    child = os.fork()
    if child == 0:
        _child(work, answer, printed)
    how, deadline = "", time.monotonic() + 8 * SECONDS
    while True:
        done, status, usage = os.wait4(child, os.WNOHANG)
        if done:
            break
        if time.monotonic() > deadline:
            os.kill(child, signal.SIGKILL)
            how = "hangs"
        time.sleep(0.002)
    if os.WIFSIGNALED(status) and not how:
        number = os.WTERMSIG(status)
        how = "hangs" if number == signal.SIGXCPU else f"killed by {signal.Signals(number).name}"
    value: Any = None
    if answer.exists():
        value, error = pickle.loads(answer.read_bytes())
        how = how or error
    text = printed.read_text("utf-8", "replace") if printed.exists() else ""
    return Ended(value, how, max(usage.ru_maxrss / 1024 - held, 0.0), text)


def _child(work: Callable[[], Any], answer: Path, printed: Path) -> None:
    out = os.open(printed, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    nothing = os.open(os.devnull, os.O_RDONLY)
    os.dup2(nothing, 0)
    os.dup2(out, 1)
    os.dup2(out, 2)
    sys.stdin = os.fdopen(0, "r", closefd=False)
    guard()  # as the program prints
    resource.setrlimit(resource.RLIMIT_CPU, (int(SECONDS) + 1, int(SECONDS) + 5))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    mapped = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (mapped + ROOM, mapped + ROOM))
    value, error = None, ""
    try:
        value = work()
    except BaseException as raised:
        last = traceback.extract_tb(raised.__traceback__)[-1]
        error = f"unexpected {type(raised).__name__} at {Path(last.filename).name}:{last.lineno}: {str(raised)[:120]}"
    sys.stdout.flush()
    sys.stderr.flush()
    answer.write_bytes(pickle.dumps((value, error)))
    os._exit(0)
