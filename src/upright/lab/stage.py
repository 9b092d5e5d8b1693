"""The process on which sessions run: it keeps simulated time to wall time and never waits for a browser.

It speaks with the server over a pipe that the server drains in a thread of its own, whatever its clients do. No session
can trouble another: each has its own part of the computing time, and what fails in it ends in a message to it.
"""

from __future__ import annotations

import contextlib
import gc
import os
import time
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from multiprocessing.connection import Connection
from pathlib import Path
from typing import TYPE_CHECKING, Any

from upright.errors import UprightError
from upright.lab.classroom import CLASS_SETUP
from upright.lab.codec import encode
from upright.lab.desk import ProcessDesk
from upright.lab.messages import Notice, Setup, Step
from upright.lab.seat import AWHILE, Seat, paid, within
from upright.lab.spoken import parts_of
from upright.reading import give_back

if TYPE_CHECKING:
    from upright.lab.session import Session

BEHIND = 0.25  # [s] of schedule that are given up where the machine cannot keep it
HURRIED = 0.2  # [s] that are run in one tick: a machine that is too slow lags, but it does not stutter
HASTE = 2.0  # times wall time, at most, while a session makes good what a busy machine kept from it
FORGIVEN = 5.0  # [s] beyond which a session makes nothing good: the machine has slept
SCORED = 0.25  # [s] between two boards
SPENT = 0.8  # part of the wall time that all sessions may compute; the rest is for words and the desk
RELIEF = 3.0  # times as long as such a session overran a tick it waits for its next turn
SCANT = 0.15  # of it that one session may have in a tick whose time has run out
AT_ONCE, PIECE = 5, 0.02  # periods of a `Step`, and [s] of simulated time, between two looks at the clock


@dataclass(frozen=True)
class Options:
    """How a stage runs: ticks a second, whether bodies take coarse steps, whether the light follows every change, the
    processor time [s] after which a message of a session is given up, and how `modest` jobs are (of nice): beside one
    user's loop they may take a part of a busy machine."""

    rate: float = 50.0
    coarse: bool = False
    certified: bool = True
    longest: float = 5.0
    modest: int = 5


class Stage:
    """Sessions by name. `take` handles a word of the server, `tick` runs everything up to the wall time `now` [s].

    `used` [s] is the processor's clock, by which sessions pay, and `wall` [s] the one on the wall; `at_work` is told
    which session is being computed.
    """

    def __init__(
        self,
        options: Options,
        used: Callable[[], float] = time.thread_time,
        wall: Callable[[], float] = time.monotonic,
        at_work: Callable[[str], None] = lambda name: None,  # noqa: ARG005
    ) -> None:
        self._options = options
        self._at_work = at_work
        self._desk = ProcessDesk(options.modest)
        self._used, self._wall = used, wall
        self._seats: dict[str, Seat] = {}
        self._door = Seat(Path(), CLASS_SETUP)  # who comes in pays from here: new sessions cannot be had for nothing
        self._out: list[tuple[str, str, Any]] = []
        self._heavy = 0.0  # wall time from which on sessions that ask for much have their turn again
        self._scored = 0.0

    def take(self, word: tuple[Any, ...], now: float) -> None:
        """One word of the server: open, close, watch or message, each of a session. It costs next to nothing: what it
        asks for waits for the session's turn."""
        kind, name, *rest = word
        if kind == "quit":
            raise EOFError
        if kind == "open":
            folder, setup = rest
            self._seats[name] = seat = Seat(Path(folder), CLASS_SETUP, at=now, last=now)
            seat.put("open", setup)
        elif seat := self._seats.get(name):
            self._to_seat(seat, kind, name, rest, now)

    def tick(self, now: float, due: float) -> list[tuple[str, str, Any]]:
        """Run every watched session up to `now`, which should have been `due`; what there is to say."""
        for (name, job), status, result in self._desk.poll():
            if name in self._seats:
                self._seats[name].put("report", (job, status, result))
        span = SPENT / self._options.rate
        everybody = [self._door, *self._seats.values()]
        for seat in everybody:
            seat.burden *= 1 - 1 / (AWHILE * self._options.rate)
        paid(everybody, span)
        turns = [(name, seat, seat if seat.session else self._door) for name, seat in self._seats.items()]
        turns = [turn for turn in turns if turn[1].session or turn[1].watched]  # who has gone again is not let in
        turns.sort(key=lambda turn: (not turn[2].quiet, -turn[1].credit))
        spare = True
        others = bool(turns and turns[0][2].quiet)
        for name, seat, payer in turns:
            light = payer.quiet  # who used little has its turn first, and in every tick
            if payer.credit > 0 and (light or (spare and now >= self._heavy)):
                self._turn(name, seat, payer, now, min(payer.credit, span if spare else SCANT * span))
                over = self._wall() - due - span
                spare = over < 0
                if others and not light and over > 0:
                    self._heavy = now + RELIEF * over
        self._at_work("")
        if now - self._scored >= SCORED:
            self._scored = now
            scores = [self._score(name, seat.session) for name, seat in self._seats.items() if seat.session]
            self._out.append(("scores", "", scores))
        out = self._out
        self._out = []
        return out

    def close(self) -> None:
        """End every session and every job."""
        self._desk.close()
        for seat in self._seats.values():
            seat.close()

    def _to_seat(self, seat: Seat, kind: str, name: str, rest: list[Any], now: float) -> None:
        if kind == "close":
            self._desk.forget(name)
            self._seats.pop(name).close()
            give_back()
        elif kind == "watch":
            client, count = rest
            seat.at, seat.watched, seat.shown = (now if not seat.watched else seat.at), count, ()
            if client:
                seat.put("welcome", client)
        elif not seat.put(kind, rest[0]):
            self._say(name, Notice("error", key="tooMany"))

    def _turn(self, name: str, seat: Seat, payer: Seat, now: float, most: float) -> None:
        """A session's turn, of at most so much computing time [s] but for the last thing that it does."""
        began = self._used()
        self._at_work(name)
        try:
            with within(self._options.longest):
                self._served(name, seat, payer, now, began + most)
        except Exception as error:  # whatever it was, the others go on
            self._set_back(name, seat, error)
        payer.credit -= self._used() - began

    def _served(self, name: str, seat: Seat, payer: Seat, now: float, end: float) -> None:
        standing = seat.session.setup if seat.session else None
        began = self._used()
        try:
            while seat.words and self._used() < end:
                self._word(name, seat, *seat.words.popleft())
        finally:
            payer.burden += self._used() - began
        if seat.session is None:
            return
        began = self._used()
        self._run(seat, seat.session, now, end)
        payer.burden += (self._used() - began) * max(0.0, 1 - 1 / seat.session.speed)
        for event in seat.session.events():
            self._say(name, event)
        if seat.watched and (moment := seat.session.moment()) != seat.shown:
            seat.shown = moment
            self._out.append(("snapshot", name, encode(seat.session.snapshot())))
        if standing and standing is not seat.good and seat.session.setup is standing:  # a whole turn went well
            seat.good = standing
            self._out.append(("setup", name, standing))

    def _word(self, name: str, seat: Seat, kind: str, content: Any) -> None:
        session = seat.session
        if kind == "open" or session is None:
            seat.session = self._session(name, seat, content if kind == "open" else seat.good)
        elif kind == "welcome":
            self._out.append(("welcome", name, (content, [encode(event) for event in session.welcome()])))
        elif kind == "report":
            session.reported(*content)
        elif isinstance(content, Step) and content.periods > AT_ONCE:
            session.handle(Step(AT_ONCE))
            seat.words.appendleft((kind, Step(content.periods - AT_ONCE)))
        else:
            session.handle(content)

    def _run(self, seat: Seat, session: Session, now: float, end: float) -> None:
        """Run up to `now`, no further than the time lasts."""
        since, seat.last = now - seat.last, now
        seat.at = max(seat.at, now - FORGIVEN) if seat.watched else now
        span = min(now - seat.at, HASTE * since, HURRIED)
        while span > 1e-9 and self._used() < end:
            piece = min(span, PIECE)
            session.advance(piece * session.speed)
            seat.at, span = seat.at + piece, span - piece

    def _session(self, name: str, seat: Seat, setup: Setup) -> Session:
        from upright.lab.plant import COARSE, FINE
        from upright.lab.session import Session

        fine = COARSE if self._options.coarse else FINE
        return Session(setup, self._desk, seat.folder, name=name, fine=fine, certified=self._options.certified)

    def _set_back(self, name: str, seat: Seat, error: Exception) -> None:
        """What stands there again after a fault: the set-up that ran, or where that is what failed, the usual one."""
        failed = seat.session and seat.session.setup
        seat.close()
        if isinstance(error, UprightError):
            self._say(name, Notice("error", parts_of(error)))
        else:
            self._say(name, Notice("error", key="setBack"))
        if failed == seat.good:
            seat.good = CLASS_SETUP
        with contextlib.suppress(Exception):
            seat.session = self._session(name, seat, seat.good)
            for event in seat.session.welcome():
                self._say(name, event)

    def _say(self, name: str, event: Any) -> None:
        self._out.append(("event", name, encode(event)))

    def _score(self, name: str, session: Session) -> tuple[str, float, bool, float, float, str]:
        main = session.lanes[0]
        score = session.score
        kind = session.setup.controller
        return name, round(main.state()[0], 3), main.fallen, round(score.best, 4), round(score.effort, 1), kind


def perform(pipe: Connection, options: Options, at_work: Any) -> None:
    """The process's own loop: a tick every 1/rate seconds, words in between; it ends when the pipe does.

    `at_work` is memory that outlives the process: its `value` is the name of the session that is being computed.
    """
    if hasattr(os, "setpgid"):
        os.setpgid(0, 0)  # Ctrl-C is the server's, and its jobs end with the stage; no session of its own: Linux gives
        # each session an equal part of the machine, so a job's `nice` would count beside its stage alone
    warnings.simplefilter("ignore")  # of numbers that students ask for: what comes of them is said to the page
    for slow in ("upright.bodies.twin", "upright.lab.session"):
        import_module(slow)  # before the first page asks for them
    gc.freeze()  # what is there now stays: a search among all of it takes as long as three pictures

    def note(name: str) -> None:
        at_work.value = name.encode()

    stage = Stage(options, at_work=note)
    period = 1.0 / options.rate
    due = time.monotonic()
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
    for _ in range(1000):  # behind schedule words are still read, but a limited number
        if not pipe.poll(0):
            return
        stage.take(pipe.recv(), time.monotonic())
