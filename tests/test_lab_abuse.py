"""Hostile students: what one of them sends ends in a message to it, and costs the others nothing that they would see."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import pytest

from test_lab_server import MODEL, Room, heard, kinds
from upright.lab import session as session_module
from upright.lab.classroom import CLASS_SETUP, Door
from upright.lab.codec import encode
from upright.lab.messages import Ack, Change, Drag, Play, Save, Setup, Step

HOSTILE = {
    "gear": Setup(numbers={"gear_ratio": 7630376392.0}),
    "wheel": Setup(numbers={"wheel_radius": 5e-324}),
    "stiction": Setup(numbers={"stiction_rate": 5e-324}),
    "sliding": Setup(controller="sliding", largest=(1e12, 1e-12, 5e-324, 1e12, 1e-300, 1e12, 5e-324)),
    "weights": Setup(controller="lqg", largest=(5e-324,) * 7),
    "gains": Setup(controller="gains", gains=(1e12,) * 6, kit="ideal"),
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
    assert "planted" in notice["text"]
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
    assert any(m["kind"] == "Notice" and "planted" in m["text"] for m in said)
    assert goes_on(classroom, ana)


class Work:
    """A session's period costs `seconds` of the stage's own clock, as on a slow machine."""

    def __init__(self, room: Room, monkeypatch: Any, seconds: float) -> None:
        self.room, period = room, session_module.Session._period

        def slow(session: Any) -> None:
            room.stage.now += seconds
            period(session)

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
    """Twelve who send Step(1000) as often as they may leave the others 25 pictures a second, and at once when they
    stop: what waits of theirs is bounded and has their own part of the time."""
    honest = [student(classroom, f"H{i}") for i in range(3)]
    hostile = [student(classroom, f"X{i}") for i in range(12)]
    work = Work(classroom, monkeypatch, 0.0004)  # with 15 robots at 100 Hz, 0.6 of the time without any hostility

    def attack() -> None:
        for client in hostile:
            for _ in range(6):
                classroom.hub.receive(client, encode(Step(1000)))

    work.second(honest)
    for _ in range(3):
        assert min(work.second(honest, attack).values()) >= 25
    classroom.hub.receive(honest[0], encode(Drag(0.5, 0.1)))
    assert min(work.second(honest).values()) >= 25
    seats = classroom.stage.stage._seats
    assert seats[honest[0].session].session.lanes[0].state()[0] != 0  # it was pushed within that second
    assert sum(len(seat.words) for seat in seats.values()) < 12 * 40


def test_a_robot_that_is_too_heavy_runs_slower_and_alone(classroom, monkeypatch):
    """At four times wall time a heavy robot asks for more than there is: it lags, the others do not."""
    honest, heavy = student(classroom, "Ana"), [student(classroom, f"X{i}") for i in range(6)]
    work = Work(classroom, monkeypatch, 0.0015)  # six at 400 periods a second: 3.6 times what there is
    for client in heavy:
        classroom.hub.receive(client, encode(Play(False, 4.0)))
    work.second([honest])
    assert work.second([honest])["Ana"] >= 25
    seats = classroom.stage.stage._seats
    before = seats[honest.session].session.t, seats[heavy[0].session].session.t
    work.second([honest])
    assert seats[honest.session].session.t - before[0] == pytest.approx(1.0, abs=0.15)
    assert 0 < seats[heavy[0].session].session.t - before[1] < 2.0


def test_what_waits_for_a_session_is_bounded_and_said(classroom):
    ana = student(classroom, "Ana")
    heard(ana)
    for i in range(300):
        classroom.hub.receive(ana, encode(Drag(0.0, 0.0) if i % 2 else Save("csv")))
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
    assert "longer than" in notice["text"]
    assert goes_on(classroom, ana)
