"""Between browsers and stages: who watches which session, and what may pass."""

from __future__ import annotations

import asyncio
import secrets
import shutil
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import KW_ONLY, dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from upright.atomic import TemporaryFolder
from upright.errors import UprightError
from upright.lab.classroom import CLASS_SETUP, MOST_ALONE, MOST_STUDENTS, Door, NotAdmitted, Role, Scores
from upright.lab.codec import InvalidMessage, decode, encode
from upright.lab.connections import Bucket
from upright.lab.mailbox import Mailbox
from upright.lab.messages import VERSION, Ack, Board, Broadcast, Change, Hello, Notice, Refused, Setup, Welcome
from upright.lab.spoken import parts_of
from upright.lab.stage_process import StageProcess, Words
from upright.pages import Say
from upright.reading import give_back

BURST, STEADY = 300.0, 130.0  # messages of `SHORT` characters at once, and a second, from one client
# robots that one address may have made at once, and a second
OPENED = 2.0 * MOST_STUDENTS
OPENING = 0.2
SHORT = 1000  # characters: a longer message counts as several
MOST_PAGES = 6  # that show one robot
PATIENCE = 100  # messages that are none, after which a client is let go
RESTARTED = Notice("error", key="restarted")
ENDED = Notice("error", key="ended")
SOON, FORGOTTEN = 60.0, 900.0  # [s] that a session is kept at least, and at most, without anybody watching it


@dataclass
class Client:
    """One page, at the address `host`. `session` is empty until its `Hello`; `closed` is why it was disconnected."""

    key: str
    box: Mailbox
    host: str = ""
    _: KW_ONLY
    session: str = ""
    role: Role = "alone"
    closed: str = ""
    wrong: int = 0
    pace: Bucket = field(default_factory=lambda: Bucket(BURST, STEADY))


@dataclass
class Entry:
    """A session, the stage on which it runs, its folder (made with its first file), the set-up that last ran well, and
    its clients."""

    stage: int
    folder: Path
    setup: Setup
    clients: dict[str, Client] = field(default_factory=dict[str, Client])
    left: float = 0.0
    came: float = field(default_factory=time.monotonic)

    @property
    def kept(self) -> float:
        """Seconds that it is kept when all have left: as long as it was used, within limits."""
        return min(max(self.left - self.came, SOON), FORGOTTEN)


class Hub:
    """All sessions and clients of one server. `stages` run the sessions; everything here runs on the event loop."""

    def __init__(self, door: Door, stages: Sequence[StageProcess]) -> None:
        self.door = door
        self.scores = Scores()
        self._folder = TemporaryFolder()
        self.root = self._folder.path
        self._removing = ThreadPoolExecutor(1)  # of files: a disk may be slow, and the event loop waits for none
        self.entries: dict[str, Entry] = {}
        self._stages = list(stages)
        self._setup = CLASS_SETUP if door.is_class else Setup()
        self._opened: dict[str, Bucket] = {}

    def begin(self) -> None:
        """Listen to the stages, from within the running event loop."""
        loop = asyncio.get_running_loop()
        for i, stage in enumerate(self._stages):
            stage.listen(loop, self.on_words, partial(self.on_lost, i))

    def close(self) -> None:
        """Stop the stages and remove every session's folder."""
        for stage in self._stages:
            stage.close()
        self._removing.shutdown(cancel_futures=True)
        self._folder.cleanup()

    def receive(self, client: Client, text: str) -> None:
        """One message of a client. Whatever it is, nothing is raised and nobody else is troubled."""
        if client.closed:
            return
        if not client.pace.take(1 + len(text) // SHORT):
            why = Say("too many messages")
            self._let_go(client, NotAdmitted(why, hint=Say("wait a moment and reload the page")))
            return
        try:
            self._act(client, decode(text))
        except (InvalidMessage, NotAdmitted) as error:
            self._wrong(client, error)
        except UprightError as error:
            client.box.event(encode(Notice("error", parts_of(error))))

    def leave(self, client: Client) -> None:
        """The page is gone; its session is kept for a while."""
        entry = self.entries.get(client.session)
        if entry and entry.clients.pop(client.key, None):
            entry.left = time.monotonic()
            self._stages[entry.stage].say("watch", client.session, "", len(entry.clients))
            if not entry.clients:
                self.scores.here.discard(client.session)

    def folder(self, session: str) -> Path | None:
        """Where a session's files lie, None where there is no such session."""
        entry = self.entries.get(session)
        return entry.folder if entry else None

    def pass_on(self, session: str, message: Any) -> None:
        """A message to a session."""
        if entry := self.entries.get(session):
            self._stages[entry.stage].say("message", session, message)

    def check(self) -> None:
        """To be called every second: see whether every stage is alive."""
        for stage in self._stages:
            stage.check()

    def sweep(self) -> None:
        """Forget sessions that nobody has watched for long."""
        now = time.monotonic()
        self._opened = {host: bucket for host, bucket in self._opened.items() if not bucket.full()}
        for name, entry in list(self.entries.items()):
            if not entry.clients and now - entry.left > entry.kept:
                self._end(name)

    def _act(self, client: Client, message: Any) -> None:
        if isinstance(message, Hello):
            self._greet(client, message)
        elif not client.session:
            raise NotAdmitted("the first message must be Hello", hint="reload the page")
        elif isinstance(message, Ack):
            client.box.acknowledged()
        elif isinstance(message, Broadcast):
            self._broadcast(client, message)
        elif isinstance(message, Change) and client.role == "student":
            self.pass_on(client.session, Change(_light(message.setup)))
        else:
            self.pass_on(client.session, message)

    def _greet(self, client: Client, hello: Hello) -> None:
        if client.session:
            raise InvalidMessage("a second Hello", expected="one")
        if hello.version != VERSION:
            raise NotAdmitted(
                f"this page speaks version {hello.version}", expected=f"version {VERSION}", likely="an old page",
                hint="reload the page (Ctrl+Shift+R), or restart upright lab",
            )  # fmt: skip
        client.role = self.door.role(hello)
        known = hello.session in self.entries
        if not known and not self._opened.setdefault(client.host, Bucket(OPENED, OPENING)).take(1.0):
            raise NotAdmitted(
                Say("too many new robots from this address"), hint=Say("wait a minute and reload the page")
            )
        client.session = hello.session if known else self._open(client.role, hello)
        entry = self.entries[client.session]
        if len(entry.clients) >= MOST_PAGES:
            raise NotAdmitted(
                Say("this robot is shown on {n} pages already", n=MOST_PAGES), hint=Say("close one of them")
            )
        entry.clients[client.key] = client
        if client.role == "student":
            self.scores.names[client.session] = hello.name.strip()[:40]
            self.scores.here.add(client.session)
        invite = self.door.students if client.role == "teacher" else ""
        client.box.event(encode(Welcome(VERSION, client.session, client.role, f"files/{client.session}/", invite)))
        self._stages[entry.stage].say("watch", client.session, client.key, len(entry.clients))

    def _open(self, role: Role, hello: Hello) -> str:
        self._make_room(role)
        name = secrets.token_hex(16)
        folder = self.root / name
        stage = min(range(len(self._stages)), key=lambda i: sum(e.stage == i for e in self.entries.values()))
        setup = hello.setup or self._setup
        if role == "student":
            setup = _light(setup)
        self.entries[name] = Entry(stage, folder, setup)
        self._stages[stage].say("open", name, str(folder), setup)
        return name

    def _make_room(self, role: Role) -> None:
        idle = sorted((e.left, n) for n, e in self.entries.items() if not e.clients)
        while self._full(role) and idle:
            self._end(idle.pop(0)[1])
        if self._full(role):
            raise NotAdmitted(Say("every place is taken"), hint=Say("close another page of the lab first"))

    def _full(self, role: Role) -> bool:
        students = sum(name in self.scores.names for name in self.entries)
        most = MOST_STUDENTS + 2 if self.door.is_class else MOST_ALONE
        return len(self.entries) >= most or (role == "student" and students >= MOST_STUDENTS)

    def _end(self, name: str) -> None:
        entry = self.entries.pop(name)
        self.scores.forget(name)
        self._stages[entry.stage].say("close", name)
        self._removing.submit(_removed, entry.folder)

    def _broadcast(self, client: Client, message: Broadcast) -> None:
        if client.role != "teacher":
            raise InvalidMessage("a set-up for everyone", expected="it from the teacher alone")
        self._setup = message.setup
        for name in self.entries:
            own = name == client.session
            self.pass_on(name, Broadcast(message.setup if own else _light(message.setup)))

    def _wrong(self, client: Client, error: UprightError) -> None:
        client.wrong += 1
        if isinstance(error, NotAdmitted) or client.wrong > PATIENCE:
            self._let_go(client, error)
        else:
            client.box.event(encode(Notice("error", parts_of(error))))

    def _let_go(self, client: Client, why: UprightError) -> None:
        client.closed = str(why)
        client.box.event(encode(Refused(client.closed, parts_of(why))))

    def on_words(self, words: Words) -> None:
        """What a stage reports."""
        for kind, name, content in words:
            entry = self.entries.get(name)
            if kind == "snapshot" and entry:
                for client in entry.clients.values():
                    client.box.snapshot(content)
            elif kind == "event" and entry:
                for client in entry.clients.values():
                    client.box.event(content)
            elif kind == "welcome" and entry:
                key, texts = content
                for text in texts if key in entry.clients else ():
                    entry.clients[key].box.event(text)
            elif kind == "setup" and entry:
                entry.setup = content
            elif kind == "scores" and self.door.is_class:
                self.scores.update(content)
                self._show(self.scores.board())

    def on_lost(self, stage: int, culprit: str) -> None:
        """A stage died at the session `culprit`, and another took its place: everybody stands up again there."""
        for name, entry in self.entries.items():
            if entry.stage != stage:
                continue
            entry.setup = CLASS_SETUP if name == culprit else entry.setup
            self._stages[stage].say("open", name, str(entry.folder), entry.setup)
            for client in entry.clients.values():
                client.box.event(encode(ENDED if name == culprit else RESTARTED))
                self._stages[stage].say("watch", name, client.key, len(entry.clients))

    def _show(self, board: Board) -> None:
        text = encode(board)
        for entry in self.entries.values():
            for client in entry.clients.values():
                client.box.board(text)


def _removed(folder: Path) -> None:
    """Of a session that has ended: nothing is left, neither of its files nor of its messages."""
    shutil.rmtree(folder, ignore_errors=True)
    give_back()


def _light(setup: Setup) -> Setup:
    """A student's set-up: without the twin, which thirty of would be too heavy for the machine."""
    return replace(setup, bodies=tuple(b for b in setup.bodies if b != "twin") or CLASS_SETUP.bodies)
