"""Hostile students: what one of them sends ends in a message to it, and costs the others nothing."""

from __future__ import annotations

import asyncio
import json
import os
import signal
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from multiprocessing.process import BaseProcess
from pathlib import Path
from types import SimpleNamespace
from typing import Any, ClassVar

import pytest

from conftest import PATIENCE
from test_lab_server import MODEL, Room, heard, kinds
from upright.lab import desk as desk_module
from upright.lab import display, stage_process
from upright.lab import session as session_module
from upright.lab.classroom import MOST_STUDENTS, Door
from upright.lab.codec import encode
from upright.lab.desk import InlineDesk, ProcessDesk
from upright.lab.hub import FORGOTTEN, SOON, Client, Entry, Hub
from upright.lab.mailbox import Mailbox
from upright.lab.messages import VERSION, Ack, Change, Drag, Hello, Play, Save, Setup, Step, Strike
from upright.lab.seat import BURDEN, LARGEST_CREDIT, Seat, paid
from upright.lab.stage import Options, Stage

HOSTILE = {
    "gear": Setup(numbers={"gear_ratio": 7630376392.0}),
    "wheel": Setup(numbers={"wheel_radius": 5e-324}),
    "stiction": Setup(numbers={"stiction_rate": 5e-324}),
    "sliding": Setup(controller="sliding", largest=(1e12, 1e-12, 5e-324, 1e12, 1e-300, 1e12, 5e-324)),
    "weights": Setup(controller="lqg", largest=(5e-324,) * 7),
    "mass": Setup(numbers={"body_mass": 1e12, "pitch_inertia": 5e-324}),
}


@pytest.fixture
def classroom() -> Iterator[Room]:
    made = Room(Door("students", "teacher"))
    yield made
    made.hub.close()


def student(room: Room, name: str, **hello: Any) -> Any:
    return room.page(name, token="students", name=name, setup=hello.pop("setup", MODEL), **hello)


def shown(messages: list[dict[str, Any]]) -> list[dict[str, Any]]:
    return [m for m in messages if m["kind"] == "Snapshot"]


def goes_on(room: Room, client: Any) -> bool:
    """Whether the client's robot moves on in time."""
    times: list[float] = []
    for _ in range(4):
        room.stage.pump(0.04)
        times += [m["t"] for m in shown(heard(client))]
        room.hub.receive(client, encode(Ack(0)))
    return times[-1] > times[0]


@pytest.mark.parametrize("setup", HOSTILE.values(), ids=HOSTILE)
def test_numbers_that_nobody_has_end_in_a_message_to_their_sender(classroom, setup):
    """Before, an exception that was not ours ended the process with everybody's robots."""
    ana, ben = student(classroom, "Ana"), student(classroom, "Ben")
    heard(ana), heard(ben)
    classroom.hub.receive(ana, encode(Change(replace(setup, bodies=("nonlinear", "linear")))))
    for _ in range(25):
        classroom.stage.pump(0.04)
    said = heard(ana)
    assert [m["level"] for m in said if m["kind"] == "Notice"], kinds(said)
    assert "Notice" not in kinds(heard(ben))
    classroom.hub.receive(ana, encode(Ack(0)))
    assert goes_on(classroom, ana)


@pytest.mark.parametrize("where", ["handle", "advance", "snapshot", "events"])
def test_a_fault_in_one_session_sets_it_back_and_says_so(classroom, monkeypatch, where):
    """A planted fault, wherever it strikes: that robot stands up again with a set-up that runs."""
    ana, ben = student(classroom, "Ana"), student(classroom, "Ben")
    whole = getattr(session_module.Session, where)

    def faulty(self: Any, *args: Any) -> Any:
        if self.setup.payload == 0.25 or any(getattr(getattr(a, "setup", None), "payload", 0) == 0.25 for a in args):
            raise ZeroDivisionError("planted")
        return whole(self, *args)

    monkeypatch.setattr(session_module.Session, where, faulty)
    heard(ana), heard(ben)
    classroom.hub.receive(ana, encode(Change(replace(MODEL, payload=0.25))))
    for _ in range(3):
        classroom.stage.pump(0.04)
    said = heard(ana)
    (notice,) = [m for m in said if m["kind"] == "Notice"]
    assert notice["level"] == "error"
    assert notice["key"] == "setBack"  # which the page has in both languages
    assert [m["setup"]["payload"] for m in said if m["kind"] == "Changed"][-1] == 0
    assert goes_on(classroom, ben)
    classroom.hub.receive(ana, encode(Ack(0)))
    assert goes_on(classroom, ana)


def test_a_fault_in_the_first_setup_gives_the_usual_robot(classroom, monkeypatch):
    class Broken(session_module.Session):
        def __init__(self, setup: Setup, *args: Any, **options: Any) -> None:
            if setup.payload:
                raise RuntimeError("planted")
            super().__init__(setup, *args, **options)

    monkeypatch.setattr(session_module, "Session", Broken)
    ana = student(classroom, "Ana", setup=replace(MODEL, payload=0.5))
    said = heard(ana)
    assert any(m["kind"] == "Notice" and m["key"] == "setBack" for m in said)
    assert goes_on(classroom, ana)


def test_everybody_hears_of_a_stage_that_died_and_who_ended_it_gets_the_usual_robot(classroom):
    ana, ben = student(classroom, "Ana", setup=replace(MODEL, payload=0.25)), student(classroom, "Ben")
    for client in (ana, ben):
        classroom.hub.receive(client, encode(Change(replace(MODEL, payload=0.5))))
    for _ in range(3):
        classroom.stage.pump(0.04)
    heard(ana), heard(ben)
    classroom.stage.stage = Stage(Options(rate=30.0, certified=False))
    classroom.hub.on_lost(0, ana.session)
    classroom.stage.pump(0.04)
    for client, key, payload in ((ana, "ended", 0.0), (ben, "restarted", 0.5)):
        messages = heard(client)
        assert [m["key"] for m in messages if m["kind"] == "Notice"] == [key]
        assert [m["setup"]["payload"] for m in messages if m["kind"] == "Changed"] == [payload]
        assert "History" in kinds(messages)  # the page's traces begin anew
        classroom.hub.receive(client, encode(Ack(0)))
        assert goes_on(classroom, client)


def test_a_stage_that_is_killed_or_hangs_is_replaced(monkeypatch):
    """Stopped, as by an endless computation outside Python; then killed by the system, as for want of memory. How
    soon, within a second on a quiet machine, is measured by `benchmarks/abuse.py lab`.

    Linux gives each session an equal part of the machine: in one of its own, a job's `nice` would count beside its
    stage alone. Its group is its own, so that Ctrl-C is the server's and its jobs end with it.
    """
    monkeypatch.setattr(stage_process, "SILENT", 1)
    link = stage_process.StageProcess(Options(rate=30.0, coarse=True, certified=False))
    hub = Hub(Door("students", "teacher"), [link])
    client = Client("a", Mailbox())

    async def until(kind: str, meanwhile: Callable[[], None] = lambda: None) -> None:
        end, found = time.monotonic() + PATIENCE, list[str]()

        async def send(text: str) -> None:
            found.append(json.loads(text)["kind"])
            client.box.acknowledged()

        sending = asyncio.create_task(client.box.deliver(send))
        while kind not in found:
            assert time.monotonic() < end, f"no {kind}"
            meanwhile()
            await asyncio.sleep(0.3)
        sending.cancel()

    def strike(number: signal.Signals) -> None:
        assert link._process.pid  # 0 would be all of this test's own processes
        os.kill(link._process.pid, number)

    async def story() -> None:
        hub.begin()
        hub.receive(client, encode(Hello(VERSION, token="students", name="Ana", setup=MODEL)))
        await until("Snapshot")
        pid = link._process.pid or 0
        assert os.getsid(pid) == os.getsid(0)
        assert os.getpgid(pid) == pid
        strike(signal.SIGSTOP)
        await until("Notice", hub.check)
        while link._process.pid in (None, pid):
            await asyncio.sleep(0.02)
        strike(signal.SIGKILL)  # the next one, while it still begins: that costs nothing
        await until("Notice")
        await until("Snapshot")

    try:
        asyncio.run(story())
    finally:
        hub.close()


class Work:
    """A session's period costs `seconds` of the stage's own clock, as on a slow machine."""

    def __init__(self, room: Room, monkeypatch: Any, seconds: float) -> None:
        self.room, period = room, session_module.Session._period

        def slow(session: Any) -> None:
            room.stage.now += seconds
            if session.name in self.only_cost:
                session._periods += 1
            else:
                period(session)

        self.only_cost: set[str] = set()  # sessions whose robots need not move
        monkeypatch.setattr(session_module.Session, "_period", slow)

    def second(self, clients: list[Any], hostile: Any = lambda: None) -> dict[str, int]:
        """Pictures that each client got in a second of 30 ticks, if the machine kept to them."""
        stage, counts, due = self.room.stage, dict.fromkeys((c.key for c in clients), 0), self.room.stage.now
        end = due + 1.0
        while due < end:
            hostile()
            due += 1 / 30
            stage.now = max(stage.now, due)
            stage.tick(due)
            for client in clients:
                counts[client.key] += len(shown(heard(client)))
                self.room.hub.receive(client, encode(Ack(0)))
            due = due if stage.now - due < 0.25 else stage.now
        return counts


def test_thousand_steps_of_hostile_students_starve_nobody(classroom, monkeypatch):
    """Those who send Step(1000) as often as they may leave the others 25 pictures a second, and when they stop too:
    what waits of theirs is bounded and has their own part of the time."""
    honest = [student(classroom, f"H{i}") for i in range(3)]
    hostile = [student(classroom, f"X{i}") for i in range(6)]
    work = Work(classroom, monkeypatch, 0.0006)  # nine robots at 100 Hz take 0.54 of the time without any hostility

    work.only_cost = {client.session for client in hostile}

    def attack() -> None:
        for client in hostile:
            for _ in range(6):
                classroom.hub.receive(client, encode(Step(1000)))

    work.second(honest)
    assert min(work.second(honest, attack).values()) >= 25
    classroom.hub.receive(honest[0], encode(Drag(0.5, 0.1)))
    assert min(work.second(honest).values()) >= 25
    seats = classroom.stage.stage._seats
    assert seats[honest[0].session].session.lanes[0].state()[0] != 0  # it was pushed within that second
    assert sum(len(seat.words) for seat in seats.values()) < 6 * 40


def test_a_robot_that_is_too_heavy_runs_slower_and_alone(classroom, monkeypatch):
    """At four times wall time a heavy robot asks for more than there is: it lags, the others do not."""
    honest, heavy = student(classroom, "Ana"), [student(classroom, f"X{i}") for i in range(6)]
    work = Work(classroom, monkeypatch, 0.0008)  # six at 400 periods a second: twice what there is
    work.only_cost = {client.session for client in heavy}
    for client in heavy:
        classroom.hub.receive(client, encode(Play(False, 4.0)))
    work.second([honest])
    assert work.second([honest])["Ana"] >= 25
    seats = classroom.stage.stage._seats
    before = seats[honest.session].session.t, seats[heavy[0].session].session.t
    work.second([honest])
    assert seats[honest.session].session.t - before[0] == pytest.approx(1.0, abs=0.15)
    assert 0 < seats[heavy[0].session].session.t - before[1] < 3.0


def test_what_waits_for_a_session_is_bounded_and_reported(classroom):
    ana = student(classroom, "Ana")
    heard(ana)
    for i in range(300):
        classroom.hub.receive(ana, encode(Drag(0.0, 0.0) if i % 2 else Strike("impulse", 0.0)))
    (seat,) = classroom.stage.stage._seats.values()
    assert len(seat.words) <= 40
    classroom.stage.pump(0.04)
    assert [m["key"] for m in heard(ana) if m["kind"] == "Notice"] == ["tooMany"]


def test_the_last_of_a_slider_s_many_changes_arrives(classroom):
    ana = student(classroom, "Ana")
    for i in range(200):
        classroom.hub.receive(ana, encode(Change(replace(MODEL, payload=i / 1000))))
    classroom.stage.pump(0.04)
    (seat,) = classroom.stage.stage._seats.values()
    assert seat.session.setup.payload == 0.199


def test_a_setup_that_computes_for_ever_is_stopped(classroom, monkeypatch):
    """A planted endless loop ends in a message, when its computing time has run out."""
    ana = student(classroom, "Ana")
    stage = classroom.stage.stage
    monkeypatch.setattr(stage, "_options", replace(stage._options, longest=0.25))
    change = session_module.Session._change

    def endless(self: Any, message: Any) -> None:
        while message.setup.payload:
            pass
        change(self, message)

    monkeypatch.setattr(session_module.Session, "_change", endless)
    heard(ana)
    classroom.hub.receive(ana, encode(Change(replace(MODEL, payload=0.5))))
    classroom.stage.pump(0.04)
    (notice,) = [m for m in heard(ana) if m["kind"] == "Notice"]
    assert notice["key"] == "setBack"
    monkeypatch.undo()  # what follows has as much time as a busy machine needs
    assert goes_on(classroom, ana)


@pytest.mark.parametrize("numbers", [{"torque_constant": 7750.0}, {"torque_constant": 31.7}, {"coulomb_friction": 9.0}])
def test_a_robot_too_stiff_for_the_page_is_refused_with_its_pole(classroom, numbers):
    """A slip of a decimal point: it blocked the stage for minutes and took 4.9 GB. The robot before goes on."""
    ana = student(classroom, "Ana")
    heard(ana)
    classroom.hub.receive(ana, encode(Change(replace(MODEL, numbers=numbers))))
    classroom.stage.pump(0.04)
    (notice,) = [m for m in heard(ana) if m["kind"] == "Notice"]
    assert "a pole of" in notice["parts"]["en"]["came"]
    assert not notice["key"]  # its own session said so, and nothing was set back
    classroom.hub.receive(ana, encode(Ack(0)))
    assert goes_on(classroom, ana)


def test_a_replay_is_made_at_the_desk_and_not_in_the_loop(tmp_path, monkeypatch):
    """Three thousand pictures are not made while everybody waits."""
    desk = InlineDesk()
    session = session_module.Session(MODEL, desk, tmp_path, fine=0.01, certified=False)
    session.advance(1.0)
    made: list[int] = []
    monkeypatch.setattr(display, "Snapshot", lambda **fields: made.append(1))
    session.handle(Save("replay"))
    assert not made


class FakeClerk:
    """A process that has done its job when it is asked."""

    done: ClassVar[list[tuple[str, str]]] = []

    def __init__(self, modest: int) -> None:
        assert modest
        self.idle, self.dead, self._key = True, False, ("", "")
        self.job: tuple[str, tuple[Any, ...]] = ("", ())

    def give(self, key: Any, task: str, args: Any) -> None:
        self.idle, self._key, self.job = False, key, (task, args)

    def forget(self, key: Any) -> None:
        self._key = ("", "") if key == self._key else self._key

    def poll(self, patience: float) -> list[Any]:
        self.idle = True
        FakeClerk.done.append(self._key)
        return [(self._key, "done", None)]

    def kill(self) -> None:
        """It is gone."""


@pytest.fixture
def desk(monkeypatch: pytest.MonkeyPatch) -> ProcessDesk:
    """A desk of such clerks, whose jobs need not rest in between."""
    monkeypatch.setattr(desk_module, "_Clerk", FakeClerk)
    monkeypatch.setattr(desk_module, "REST", 0.0)
    monkeypatch.setattr(FakeClerk, "done", [])
    return ProcessDesk()


def test_what_a_job_finds_for_a_controller_that_is_gone_is_reported_to_nobody(desk):
    """It is being analysed when another is chosen, and its process cannot be stopped: what it finds has no receiver."""
    desk.submit(("a", "design"), "design", ("old",))
    desk.poll()  # it has begun
    desk.submit(("a", "design"), "design", ("new",))
    keys = [key for _ in range(2) for key, _, _ in desk.poll()]
    assert keys == [("", ""), ("a", "design")]  # the first is of no session, the second of the new controller


@pytest.mark.parametrize("alone", [False, True])
def test_at_the_desk_each_session_has_its_turn(desk, alone):
    """However many jobs one submits, another's waits for one of them at each of the desk's places, no more."""
    for i in range(20):
        desk.submit(("hostile", f"job {i}"), "design", (), alone)
    desk.poll()
    desk.submit(("honest", "mine"), "design", (), alone)
    for _ in range(3):
        desk.poll()
    assert ("honest", "mine") in FakeClerk.done[:3]
    assert len(FakeClerk.done) >= 3


@pytest.mark.parametrize("begun", [False, True])
def test_a_job_that_somebody_asked_for_comes_before_the_light(desk, begun):
    """The doctor, who takes two seconds, waited 13 to 35 s for a certificate of which nobody had asked anything."""
    desk.submit(("a", "light"), "light", (), alone=True)
    if begun:
        desk.poll()
    desk.submit(("a", "doctor"), "doctor", (), alone=True)
    said = [key for _ in range(4) for key, _, _ in desk.poll()]
    assert said == FakeClerk.done == [("a", "doctor"), ("a", "light")]


def test_who_asks_again_and_again_does_not_begin_a_process_each_time(desk, monkeypatch):
    """Each takes the machine a third of a second, whatever becomes of it."""
    monkeypatch.setattr(desk_module, "REST", PATIENCE)
    for _ in range(20):
        desk.submit(("hostile", "design"), "design", (), alone=True)
        desk.poll()
        desk.poll()
    assert FakeClerk.done == [("hostile", "design")]
    monkeypatch.setattr(desk, "_rested", {})  # when that is over
    desk.poll()
    desk.poll()
    assert len(FakeClerk.done) == 2


def test_where_time_is_short_who_only_watches_comes_before_who_asks_for_much():
    """By weight: four times the burden of half the weight is a fifth of it."""
    watching, asking = (Seat(Path(), MODEL, credit=0.0, burden=burden) for burden in (0.0, 4 * BURDEN))
    paid([asking, watching], 0.06)
    assert (watching.credit, asking.credit) == pytest.approx((0.05, 0.01))
    paid([asking, watching], 1.0)  # where there is enough, nobody is short
    assert (watching.credit, asking.credit) == pytest.approx((LARGEST_CREDIT, LARGEST_CREDIT))
    assert watching.quiet
    assert not asking.quiet


def test_one_address_has_no_more_new_robots_than_two_classes(classroom, monkeypatch):
    """Whoever comes and goes all the time would have the others wait while robots are made."""
    monkeypatch.setattr("upright.lab.hub.OPENING", 0.0)  # however long this takes
    said: list[str] = []
    for i in range(2 * MOST_STUDENTS + 1):
        client = Client(f"k{i}", Mailbox(), "10.0.0.9")
        classroom.hub.receive(client, encode(Hello(VERSION, token="students", name="X")))
        said += [m["reason"] for m in heard(client) if m["kind"] == "Refused"]
        classroom.hub.leave(client)
    assert [text for text in said if "too many new robots" in text] == said
    assert said
    assert goes_on(classroom, classroom.page("elsewhere", token="students", name="Ana"))


def test_a_robot_is_kept_as_long_as_it_was_used(classroom, monkeypatch):
    """A reload finds it; whoever only looked in leaves nothing behind for a quarter of an hour."""
    now = time.monotonic()
    monkeypatch.setattr("upright.lab.hub.time", SimpleNamespace(monotonic=lambda: now))
    ana = classroom.page("a", token="students", name="Ana")
    entry = classroom.hub.entries[ana.session]
    classroom.hub.leave(ana)
    entry.came = entry.left - 5.0
    entry.left -= SOON - 1
    classroom.hub.sweep()
    assert ana.session in classroom.hub.entries  # a reload within a minute
    entry.left -= 2.0
    classroom.hub.sweep()
    assert ana.session not in classroom.hub.entries
    assert Entry(0, Path(), MODEL, left=entry.came + 300.0, came=entry.came).kept == pytest.approx(300.0)
    assert Entry(0, Path(), MODEL, left=entry.came + 1e5, came=entry.came).kept == FORGOTTEN


def test_a_clerk_that_starts_or_reads_slowly_holds_up_nobody(monkeypatch):
    """A job's process starts modestly, and a log of a minute does not fit into its pipe: the loop waits for neither."""
    ready = threading.Event()
    start = BaseProcess.start
    monkeypatch.setattr(BaseProcess, "start", lambda process: (ready.wait(PATIENCE), start(process)))
    clerk = desk_module._Clerk()
    try:
        clerk.give(("ana", "keep csv"), "keep", ("csv", bytes(10 << 20), Path()))
        assert clerk.poll(PATIENCE) == []  # we are here, and its process has not started
        ready.set()
        end = time.monotonic() + PATIENCE
        while not (words := clerk.poll(PATIENCE)):
            assert time.monotonic() < end
            time.sleep(0.01)
        assert words[0][:2] == (("ana", "keep csv"), "failed")  # ten megabytes of nothing are no log
    finally:
        ready.set()
        clerk.kill()


def test_a_job_has_its_seconds_of_computing_on_a_busy_machine_too(monkeypatch):
    """What another program takes of the machine is not the job's: by the clock it may last five times as long."""
    clerk = desk_module._Clerk()
    try:
        clerk._key, clerk.idle, clerk._before = ("ana", "design"), False, 0.0
        monkeypatch.setattr(clerk, "_computed", lambda: 10.0)
        for elapsed, ended in ((29.0, False), (140.0, False), (151.0, True)):
            clerk._since = time.monotonic() - elapsed
            assert clerk._overdue(30.0) is ended
        monkeypatch.setattr(clerk, "_computed", lambda: 31.0)
        clerk._since = time.monotonic() - 32.0
        ((_, status, why),) = clerk.poll(30.0)
        assert (status, why["en"].came) == ("failed", "it took longer than 30\u00a0s and was stopped")
    finally:
        clerk.kill()


@pytest.mark.evidence
def test_a_class_with_hostile_students_in_it_goes_on(monkeypatch):
    """A short `benchmarks/abuse.py lab`, whose rates are for a quiet machine and are not tested: one of each kind of
    hostile student, whom no stage dies of and the teacher reads nothing of, while the others get pictures."""
    from planted.abuse import lab as abuse_lab

    monkeypatch.setattr(abuse_lab, "SETTLED", 4.0)
    monkeypatch.setattr(abuse_lab, "KEPT", 5.0)  # memory at the end, for which it waits up to 40 s, is not tested
    rows = {row[0]: row for row in abuse_lab.measure(3, minutes=0.07, watchers=2, hostile=len(abuse_lab.WAYS))}
    assert int(rows["messages and connections of the hostile"][1]) > 0
    assert float(rows["pictures a second of the others, median"][1]) > 0
    assert rows["stages alive"][3]
    assert rows["lines on the teacher's terminal"][1] == "0"
