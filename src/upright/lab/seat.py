"""A session's place on a stage: the words that wait for it, and the computing time that it may use."""

from __future__ import annotations

import contextlib
import signal
import threading
from collections import deque
from collections.abc import Generator, Sequence
from dataclasses import KW_ONLY, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.lab.messages import Broadcast, Change, Drag, Play, Recall, Scrub, Setup, StandUp, Steer, Step

if TYPE_CHECKING:
    from upright.lab.session import Session

MOST_WAITING = 32  # words; a page that is served at all never has so many
LARGEST_CREDIT = 0.2  # [s] of computing that a session saves up, so that a change of its robot is made at once
QUIET = 0.15  # [s] of credit that say that a session has used little of late
BURDEN, AWHILE = 0.05, 60.0  # [s] of computing for its own wishes that halve a session's part, forgotten in this time
LONGEST_STEP = 1000  # periods that wait at most
LATEST = (Broadcast, Change, Drag, Play, Recall, Scrub, StandUp, Steer)
"""Of two such messages in a row, the first need not be done."""


@dataclass
class Seat:
    """`good` is the set-up to which the session is set back; `credit` [s] is the computing time that it may use; `at`
    is the wall time up to which it was run, `last` that of its last turn; `watched` is how many pages show it. `burden`
    [s] is the computing time that it took of late for more than to run as fast as the clock: where time is short, who
    only watches comes before who asks for much."""

    folder: Path
    good: Setup
    _: KW_ONLY
    session: Session | None = None
    credit: float = LARGEST_CREDIT
    at: float = 0.0
    last: float = 0.0
    watched: int = 0
    burden: float = 0.0
    shown: tuple[Any, ...] = ()
    words: deque[tuple[str, Any]] = field(default_factory=deque[tuple[str, Any]])
    _full: bool = False

    @property
    def quiet(self) -> bool:
        """Whether it has used little of late."""
        return self.credit > QUIET and self.burden < BURDEN

    def put(self, kind: str, content: Any) -> bool:
        """Let a word wait for the session's turn; False where it is the first for which there is no room."""
        last = self.words[-1][1] if self.words else None
        self._full &= len(self.words) >= MOST_WAITING
        if isinstance(content, LATEST) and type(content) is type(last):
            self.words[-1] = (kind, content)
        elif isinstance(content, Step) and isinstance(last, Step):
            self.words[-1] = (kind, Step(min(last.periods + content.periods, LONGEST_STEP)))
        elif kind != "message" or len(self.words) < MOST_WAITING:
            self.words.append((kind, content))
        else:
            first = not self._full
            self._full = True
            return not first
        return True

    def close(self) -> None:
        """Free what the session holds, and forget what waits for it."""
        session = self.session
        self.session = None
        self.shown = ()
        self.words.clear()
        with contextlib.suppress(Exception):
            if session:
                session.close()


def paid(seats: Sequence[Seat], seconds: float) -> None:
    """Share `seconds` of computing among those who have used some, by weight: who needs less leaves more for the
    others."""
    weights = {id(seat): 1 / (1 + seat.burden / BURDEN) for seat in seats}
    left = sum(weights.values())
    for seat in sorted(seats, key=lambda seat: (LARGEST_CREDIT - seat.credit) / weights[id(seat)]):
        part = min(LARGEST_CREDIT - seat.credit, seconds * weights[id(seat)] / left)
        seat.credit, seconds, left = seat.credit + part, seconds - part, left - weights[id(seat)]


class TookTooLong(Exception):
    """What a session was computing took more than its time."""


@contextlib.contextmanager
def within(seconds: float) -> Generator[None]:
    """Raise `TookTooLong` in what is inside once it has used so much processor time; where the system has no such timer
    and outside the main thread, nothing is limited."""
    if not hasattr(signal, "setitimer") or threading.current_thread() is not threading.main_thread():
        yield
        return

    def stop(*_: Any) -> None:
        raise TookTooLong(f"it took longer than {seconds:g} s")

    before = signal.signal(signal.SIGVTALRM, stop)
    signal.setitimer(signal.ITIMER_VIRTUAL, seconds, seconds / 4)  # again, where something swallows the first
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)
        signal.signal(signal.SIGVTALRM, before)
