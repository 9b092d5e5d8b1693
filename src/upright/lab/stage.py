"""The process on which sessions run: it keeps simulated time to wall time and never waits for a browser.

It speaks with the server over a pipe that the server drains in a thread of its own, whatever its clients do.
"""

from __future__ import annotations

import contextlib
import time
from collections import deque
from dataclasses import dataclass
from importlib import import_module
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.errors import UprightError
from upright.lab.codec import encode
from upright.lab.desk import ProcessDesk
from upright.lab.messages import Notice, Setup

if TYPE_CHECKING:
    from upright.lab.session import Session

BEHIND = 0.25  # [s] of schedule that are given up where the machine cannot keep it
HURRIED = 0.2  # [s] that are run in one tick: a machine that is too slow lags, but it does not stutter
HASTE = 2.0  # times wall time, at most, while a session makes good what a busy machine kept from it
FORGIVEN = 5.0  # [s] beyond which a session makes nothing good: the machine has slept
REMEMBERED = 6000  # ticks whose lateness is kept, to be asked for
SCORED = 0.25  # [s] between two boards


@dataclass(frozen=True)
class Options:
    """How a stage runs: ticks a second, whether bodies take coarse steps, whether the light follows every change."""

    rate: float = 50.0
    coarse: bool = False
    certified: bool = True


@dataclass
class _Seat:
    """A session, the wall time up to which it was run, that of its last tick, and how many pages watch it."""

    session: Session
    at: float
    last: float
    watched: int = 0
    shown: tuple[Any, ...] = ()


class Stage:
    """Sessions by name. `take` handles a word of the server, `tick` runs everything up to the wall time `now` [s]."""

    def __init__(self, options: Options) -> None:
        self._options, self._desk = options, ProcessDesk()
        self._seats: dict[str, _Seat] = {}
        self._out: list[tuple[str, str, Any]] = []
        self._scored, self._delays = 0.0, deque[float](maxlen=REMEMBERED)

    def take(self, word: tuple[Any, ...], now: float) -> None:
        """One word of the server: open, close, watch or message, each of a session, or stats."""
        kind, name, *rest = word
        if kind == "quit":
            raise EOFError
        if kind == "open":
            self._open(name, now, *rest)
        elif kind == "stats":
            self._out.append(("stats", "", self._stats()))
        elif name in self._seats:
            self._to_session(kind, name, rest, now)

    def tick(self, now: float, due: float) -> list[tuple[str, str, Any]]:
        """Run every watched session up to `now`, which should have been `due`; what there is to say."""
        self._delays.append(now - due)
        for (name, job), status, result in self._desk.poll():
            if name in self._seats:
                self._seats[name].session.reported(job, status, result)
        for name, seat in self._seats.items():
            self._run(name, seat, now)
        if now - self._scored >= SCORED:
            self._scored = now
            self._out.append(("scores", "", [self._score(name, seat) for name, seat in self._seats.items()]))
        out, self._out = self._out, []
        return out

    def close(self) -> None:
        """End every session and every job."""
        self._desk.close()
        for seat in self._seats.values():
            seat.session.close()

    def _open(self, name: str, now: float, folder: str, setup: Setup) -> None:
        from upright.lab.plant import COARSE, FINE
        from upright.lab.session import Session

        fine = COARSE if self._options.coarse else FINE
        options: dict[str, Any] = {"name": name, "fine": fine, "certified": self._options.certified}
        try:
            session = Session(setup, self._desk, Path(folder), **options)
        except UprightError as error:
            self._out.append(("event", name, encode(Notice("error", str(error)))))
            session = Session(Setup(bodies=setup.bodies or ("nonlinear",)), self._desk, Path(folder), **options)
        self._seats[name] = _Seat(session, now, now)

    def _to_session(self, kind: str, name: str, rest: list[Any], now: float) -> None:
        seat = self._seats[name]
        if kind == "message":
            seat.session.handle(rest[0])
        elif kind == "watch":
            client, count = rest
            seat.at, seat.watched, seat.shown = (now if not seat.watched else seat.at), count, ()
            if client:
                welcome = [encode(event) for event in seat.session.welcome()]
                self._out.append(("welcome", name, (client, welcome)))
        elif kind == "close":
            self._desk.forget(name)
            self._seats.pop(name).session.close()

    def _run(self, name: str, seat: _Seat, now: float) -> None:
        session, since = seat.session, now - seat.last
        seat.last = now
        seat.at = max(seat.at, now - FORGIVEN) if seat.watched else now
        span = min(now - seat.at, HASTE * since, HURRIED)
        seat.at += span
        session.advance(span * session.speed)
        self._out += [("event", name, encode(event)) for event in session.events()]
        if seat.watched and (moment := session.moment()) != seat.shown:
            seat.shown = moment
            self._out.append(("snapshot", name, encode(session.snapshot())))

    def _score(self, name: str, seat: _Seat) -> tuple[str, float, bool, float, float, str]:
        main, score = seat.session.lanes[0], seat.session.score
        kind = seat.session.setup.controller
        return name, round(main.state()[0], 3), main.fallen, round(score.best, 4), round(score.effort, 1), kind

    def _stats(self) -> dict[str, Any]:
        simulated = {name: seat.session.t for name, seat in self._seats.items()}
        return {"late": list(self._delays), "simulated": simulated, "cpu": time.process_time()}


def perform(pipe: Connection, options: Options) -> None:
    """The process's own loop: a tick every 1/rate seconds, words in between; it ends when the pipe does."""
    for slow in ("upright.bodies.twin", "upright.lab.session"):
        import_module(slow)  # before the first page asks for them
    stage = Stage(options)
    period, due = 1.0 / options.rate, time.monotonic()
    with contextlib.suppress(EOFError, OSError, KeyboardInterrupt):
        while True:
            due += period
            _listen(pipe, stage, due)
            now = time.monotonic()
            if words := stage.tick(now, due):
                pipe.send(words)
            due = due if now - due < BEHIND else now
    stage.close()


def _listen(pipe: Connection, stage: Stage, until: float) -> None:
    """Take words until the time of the next tick."""
    while (left := until - time.monotonic()) > 0:
        if pipe.poll(left):
            stage.take(pipe.recv(), time.monotonic())
    for _ in range(100):  # behind schedule words are still read, but a limited number
        if not pipe.poll(0):
            return
        stage.take(pipe.recv(), time.monotonic())
