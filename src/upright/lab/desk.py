"""Work that takes longer than a frame runs at a desk: in processes of its own, which can be killed.

One clerk serves quick requests, of which the latest of each key wins; every other job has a process to itself. Whose
job was done longest ago comes first, and no session has two processes: however much one asks for, the others have their
turn. What nobody pressed a button for gives way to what somebody did, and begins again afterwards.
"""

from __future__ import annotations

import multiprocessing
import os
import pickle
import sys
import threading
import time
import warnings
from collections import deque
from collections.abc import Callable
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from pathlib import Path
from queue import SimpleQueue
from typing import Any

from upright.errors import UprightError
from upright.interrupts import without_ctrl_c
from upright.lab.spoken import parts_of
from upright.pages import Quantity, Say
from upright.reading import limit_memory

Key = tuple[str, str]
Word = tuple[Key, str, Any]

PATIENCE = 600.0  # [s] of computing after which a job is killed
CROWDED = 120.0  # [s] the same while another session's job waits for its place
BRIEF = 30.0  # [s] the same for what the one clerk does
BUSY = 5.0  # times as long a job may last by the clock, on a machine where others compute too
MOST_ALONE = 2  # jobs at a time, since the loop has the first claim on the machine
REST = 2.0  # [s] between the beginnings of two such jobs of one session: each takes a process
MODEST = 15  # of nice in a class: three jobs together leave nine tenths to the loop
# tasks nobody presses a button for, whose results are kept, and how many of them
LASTING = ("light",)
REMEMBERED = 64
READY = ["upright.lab.tasks", "upright.certification"]
"""What most jobs load, for a second: on Linux clerks are copies of a process that has, and that ends with this one."""
MEMORY = 4 << 30  # [bytes] of addresses for one job: a hostile file must not take the machine


class InlineDesk:
    """A desk that does everything when it is asked to, for tests and scripts."""

    def __init__(self) -> None:
        self._asked: list[tuple[Key, str, tuple[Any, ...]]] = []

    def submit(self, key: Key, task: str, args: tuple[Any, ...], alone: bool = False) -> None:  # noqa: ARG002
        self._asked = [job for job in self._asked if job[0] != key] + [(key, task, args)]

    def cancel(self, key: Key) -> None:
        self._asked = [job for job in self._asked if job[0] != key]

    def poll(self) -> list[Word]:
        """Do all that was submitted, and say what came of it."""
        asked = self._asked
        self._asked = []
        return [(key, *_done(task, args, lambda *_: None)) for key, task, args in asked]


class ProcessDesk:
    """A desk of processes, `modest` by so much of nice; `poll` says what they have done since."""

    def __init__(self, modest: int = MODEST) -> None:
        self._modest = modest
        self._quick: _Clerk | None = None
        self._waiting: dict[Key, tuple[str, tuple[Any, ...]]] = {}
        self._alone: dict[Key, _Clerk] = {}
        self._queue: dict[Key, tuple[str, tuple[Any, ...]]] = {}
        self._known: dict[bytes, Any] = {}  # results of `LASTING`, the latest last
        self._served: dict[str, float] = {}  # when a session's job was begun last
        self._rested: dict[str, float] = {}  # from when on it may begin another process

    def submit(self, key: Key, task: str, args: tuple[Any, ...], alone: bool = False) -> None:
        self.cancel(key)
        (self._queue if alone else self._waiting)[key] = (task, args)
        if alone and task not in LASTING:
            self._give_way(key[0])

    def _give_way(self, session: str) -> None:
        """Let what the session has done of itself wait until the rest of its queue is done."""
        begun = {key: clerk.job for key, clerk in self._alone.items() if key[0] == session}
        for key, job in [*begun.items(), *self._queue.items()]:
            if key[0] == session and job[0] in LASTING:
                self.cancel(key)
                self._queue[key] = job

    def cancel(self, key: Key) -> None:
        self._waiting.pop(key, None)
        self._queue.pop(key, None)
        if self._quick:
            self._quick.forget(key)
        if key in self._alone:
            self._alone.pop(key).kill()

    def forget(self, session: str) -> None:
        """Drop everything of a session that has ended."""
        for key in [*self._waiting, *self._queue, *self._alone]:
            if key[0] == session:
                self.cancel(key)
        self._served.pop(session, None)
        self._rested.pop(session, None)

    def poll(self) -> list[Word]:
        """What was done since, in order, without waiting; begins what can begin."""
        words = self._polled(self._quick, BRIEF) if self._quick else []
        for key, clerk in list(self._alone.items()):
            waiting = any(other[0] != key[0] for other in self._queue)
            new = self._polled(clerk, CROWDED if waiting else PATIENCE)
            if clerk.idle:
                self._alone.pop(key).kill()
                self._remember(clerk, new)
            words += new
        words += self._recalled()
        self._begin()
        return words

    def close(self) -> None:
        """Kill every clerk."""
        for clerk in [*self._alone.values(), *([self._quick] if self._quick else [])]:
            clerk.kill()
        self._alone = {}
        self._quick = None

    def _remember(self, clerk: _Clerk, new: list[Word]) -> None:
        """Keep what a clerk has found out, where the same request has always the same answer."""
        if clerk.job[0] in LASTING and new and new[-1][1] == "done":
            self._known[pickle.dumps(clerk.job)] = new[-1][2]
            if len(self._known) > REMEMBERED:
                self._known.pop(next(iter(self._known)))

    def _recalled(self) -> list[Word]:
        """The answers to requests that wait and were answered before: they cost no process."""
        words = list[Word]()
        for key, job in list(self._queue.items()):
            asked = pickle.dumps(job) if job[0] in LASTING else b""
            if asked in self._known:
                del self._queue[key]
                self._known[asked] = self._known.pop(asked)
                words.append((key, "done", self._known[asked]))
        return words

    def _begin(self) -> None:
        if self._waiting and (self._quick is None or self._quick.idle):
            self._quick = self._quick or _Clerk(self._modest)
            self._give(self._quick, self._waiting, list(self._waiting))
        while len(self._alone) < MOST_ALONE:
            busy = {session for session, _ in self._alone}
            now = time.monotonic()
            free = [key for key in self._queue if key[0] not in busy and self._rested.get(key[0], 0.0) <= now]
            if not free:
                return
            clerk = _Clerk(self._modest)
            key = self._give(clerk, self._queue, free)
            self._alone[key], self._rested[key[0]] = clerk, now + REST

    def _give(self, clerk: _Clerk, jobs: dict[Key, tuple[str, tuple[Any, ...]]], keys: list[Key]) -> Key:
        """Give the clerk the job of whoever was served longest ago."""
        key = min(keys, key=lambda key: self._served.get(key[0], 0.0))
        self._served[key[0]] = time.monotonic()
        clerk.give(key, *jobs.pop(key))
        return key

    def _polled(self, clerk: _Clerk, patience: float) -> list[Word]:
        words = clerk.poll(patience)
        if clerk.dead and clerk is self._quick:
            self._quick = None
        return words


Desk = InlineDesk | ProcessDesk
"""Takes jobs by (session, name); its owner reports the results to the session."""


class _Clerk:
    """One process that does one job at a time, and a thread that waits for it: the loop does not, however long the
    process takes to start, to read what it is given, to answer or to end."""

    def __init__(self, modest: int = MODEST) -> None:
        self._modest = modest
        self.idle = True
        self.dead = False
        self._key = ("", "")
        self._since = 0.0
        self._before = 0.0
        self.job: tuple[str, tuple[Any, ...]] = ("", ())
        self._given: SimpleQueue[tuple[str, tuple[Any, ...]] | None] = SimpleQueue()
        self._words: deque[tuple[str, Any]] = deque()
        self._process: BaseProcess | None = None
        self._ended = False
        threading.Thread(target=self._attend, daemon=True).start()

    def forget(self, key: Key) -> None:
        """Say nothing more of the job of that key."""
        self._key = ("", "") if key == self._key else self._key

    def give(self, key: Key, task: str, args: tuple[Any, ...]) -> None:
        self.idle, self._key, self._since, self._before = False, key, time.monotonic(), self._computed()
        self.job = task, args
        self._given.put(self.job)

    def poll(self, patience: float) -> list[Word]:
        words: list[Word] = []
        while self._words and not self.idle:
            status, result = self._words.popleft()
            if status == "gone":
                return [*words, self._gone(Say("the process that computed it died, perhaps of too large a file"))]
            words.append((self._key, status, result))
            self.idle = status != "progress"
        if not self.idle and self._overdue(patience):
            overdue = Say("it took longer than {time} and was stopped", time=Quantity(patience, "s"))
            return [*words, self._gone(overdue)]
        return words

    def kill(self) -> None:
        self._ended = True
        self._given.put(None)
        if self._process:
            self._process.kill()

    def _attend(self) -> None:
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # a copy has no threads of its library
        context: Any = multiprocessing.get_context("forkserver" if sys.platform == "linux" else "spawn")
        context.set_forkserver_preload(READY)
        pipe, theirs = context.Pipe()
        process = context.Process(target=_work, args=(theirs,), daemon=True)
        try:
            with without_ctrl_c():
                process.start()
            self._process = process
            theirs.close()
            if hasattr(os, "setpriority") and process.pid:
                os.setpriority(os.PRIO_PROCESS, process.pid, self._modest)
            while not self._ended and (job := self._given.get()):
                pipe.send(job)
                status = "progress"
                while status == "progress":
                    status, result = pipe.recv()
                    self._words.append((status, result))
        except (EOFError, OSError):
            self._words.append(("gone", None))
        if self._process:
            process.kill()
            process.join()
        pipe.close()

    def _overdue(self, patience: float) -> bool:
        elapsed = time.monotonic() - self._since
        return elapsed > BUSY * patience or (elapsed > patience and self._computed() - self._before > patience)

    def _computed(self) -> float:
        """Seconds that the process has computed, or of the clock where the system does not say."""
        if self._process is None:
            return 0.0
        try:
            fields = Path(f"/proc/{self._process.pid}/stat").read_text("utf-8").rpartition(")")[2].split()
        except OSError:
            return time.monotonic()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")  # its own time, and the kernel's for it

    def _gone(self, why: Say) -> Word:
        self.kill()
        self.idle = self.dead = True
        return (self._key, "failed", parts_of(why))


def _work(pipe: Connection) -> None:
    """The clerk's own loop: it ends when the pipe does."""

    shown = [-1.0]

    def report(fraction: float, runs: int = 0) -> None:
        if round(fraction, 2) != shown[0]:
            shown[0] = round(fraction, 2)
            pipe.send(("progress", (fraction, runs)))

    warnings.simplefilter("ignore")  # of a student's numbers: the result says what is wrong
    limit_memory(MEMORY)
    while True:
        try:
            task, args = pipe.recv()
            shown[0] = -1.0
            status, result = _done(task, args, report)
            pipe.send((status, result))
        except (EOFError, OSError, KeyboardInterrupt):
            return


def _done(task: str, args: tuple[Any, ...], report: Callable[..., None]) -> tuple[str, Any]:
    from upright.lab.tasks import TASKS

    try:
        return "done", TASKS[task](report, *args)
    except UprightError as error:
        return "failed", parts_of(error)
    except Exception as error:  # whatever a file or a design did, the session goes on
        return "failed", parts_of(Say("unexpected {kind}: {text}", kind=type(error).__name__, text=str(error)[:200]))
