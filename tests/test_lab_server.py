"""The lab's server: who may come in, what passes, and that nobody can stop it or trouble another."""

from __future__ import annotations

import asyncio
import json
import random
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from conftest import PATIENCE
from test_lab_messages import hostile
from upright.cli.main import main
from upright.errors import UprightError
from upright.lab.classroom import MOST_STUDENTS, Door, token
from upright.lab.codec import encode
from upright.lab.hub import BURST, Client, Hub
from upright.lab.mailbox import AHEAD, MOST_EVENTS, Mailbox
from upright.lab.messages import VERSION, Ack, Broadcast, Change, Drag, Hello, Setup
from upright.lab.server import Lab, listening
from upright.lab.stage import Options, Stage
from upright.lab.uploads import LARGEST, UploadRefused, receive, safe_name

EVIL: Any = "http://evil.example"
MODEL = Setup(bodies=("nonlinear",))
PERIOD = 0.01  # [s] of the kit nxt


class HereStage:
    """A stage within the test: what it is told it does at once, and `pump` lets time pass."""

    def __init__(self) -> None:
        self.now, self.heard = 100.0, lambda words: None
        self.stage = Stage(Options(rate=30.0, certified=False), lambda: self.now, lambda: self.now)

    def listen(self, loop: Any, heard: Callable[[Any], None], lost: Callable[[str], None]) -> None:
        self.heard = heard

    def check(self) -> None:
        """It is alive."""

    def say(self, *word: Any) -> None:
        self.stage.take(word, self.now)

    def close(self) -> None:
        self.stage.close()

    def pump(self, seconds: float = 0.0) -> None:
        self.now += seconds
        self.tick(self.now)

    def tick(self, due: float) -> None:
        self.heard(self.stage.tick(self.now, due))


class Room:
    """A hub with one stage, and pages that come in."""

    def __init__(self, door: Door | None = None) -> None:
        self.stage = HereStage()
        self.hub = Hub(door or Door(), [self.stage])
        self.stage.listen(None, self.hub.on_words, lambda culprit: None)

    def page(self, key: str, **hello: Any) -> Client:
        client = Client(key, Mailbox())
        self.hub.receive(client, encode(Hello(**{"version": VERSION, "setup": MODEL} | hello)))
        self.stage.pump()
        return client


@pytest.fixture
def room() -> Iterator[Room]:
    made = Room()
    yield made
    made.hub.close()


@pytest.fixture
def classroom() -> Iterator[Room]:
    made = Room(Door("students", "teacher"))
    yield made
    made.hub.close()


LOOP = asyncio.new_event_loop()
"""One for every `heard`: to make one takes longer than what is done in it."""


def heard(client: Client) -> list[dict[str, Any]]:
    """Everything that waits for a client, as it would read it."""
    found: list[str] = []

    async def take() -> None:
        async def send(text: str) -> None:
            found.append(text)

        task = asyncio.create_task(client.box.deliver(send))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        task.cancel()

    LOOP.run_until_complete(take())
    return [json.loads(text) for text in found]


def kinds(messages: list[dict[str, Any]]) -> list[str]:
    return [message["kind"] for message in messages]


def test_a_page_is_welcomed_and_told_what_stands_there(room):
    client = room.page("a")
    said = heard(client)
    assert kinds(said)[:3] == ["Welcome", "Catalogue", "Changed"]
    assert {"Equations", "History", "Snapshot"} <= set(kinds(said))
    assert said[0]["role"] == "alone"


def test_another_version_is_refused_with_what_to_do(room):
    client = room.page("a", version=VERSION + 1)
    (said,) = heard(client)
    assert said["kind"] == "Refused"
    assert "reload the page" in said["reason"]
    assert client.closed


def test_nothing_passes_before_hello(room):
    client = Client("a", Mailbox())
    room.hub.receive(client, encode(Drag(1.0, 0.0)))
    assert kinds(heard(client)) == ["Refused"]


def test_a_client_gets_a_few_snapshots_until_it_acknowledges_and_then_the_latest(room):
    client = room.page("a")
    first = [m for m in heard(client) if m["kind"] == "Snapshot"]
    assert len(first) == 1
    for _ in range(AHEAD - 1):
        room.stage.pump(0.02)
        first += [m for m in heard(client) if m["kind"] == "Snapshot"]
    assert len(first) == AHEAD
    for _ in range(5):
        room.stage.pump(0.02)
    assert "Snapshot" not in kinds(heard(client))
    room.hub.receive(client, encode(Ack(first[0]["n"])))
    (latest,) = [m for m in heard(client) if m["kind"] == "Snapshot"]
    assert latest["t"] == pytest.approx(first[-1]["t"] + 0.1)  # five ticks later, not the first of the five


def test_events_are_in_order_and_never_dropped():
    box = Mailbox()
    client = Client("a", box)
    for i in range(MOST_EVENTS):
        box.event(json.dumps({"kind": "Notice", "n": i}))
    assert [m["n"] for m in heard(client)] == list(range(MOST_EVENTS))
    for i in range(MOST_EVENTS + 1):
        box.event(json.dumps({"kind": "Notice", "n": i}))
    assert heard(client) == []  # it is let go rather than told half
    assert box.overflown.is_set()


def test_simulated_time_keeps_to_wall_time_through_a_busy_machine(room):
    """What was missed is made good at double speed, up to 0.2 s a tick; a machine that slept makes good 5 s of it."""
    room.page("a")
    (seat,) = room.stage.stage._seats.values()
    begin = room.stage.now - seat.session.t

    def behind(ticks: int) -> float:
        for _ in range(ticks):
            room.stage.pump(0.02)
        return room.stage.now - begin - seat.session.t

    assert behind(10) == pytest.approx(0.0, abs=PERIOD)
    room.stage.pump(1.0)
    assert behind(10) == pytest.approx(1.0 - 0.2 - 10 * 0.02, abs=2 * PERIOD)
    assert behind(40) == pytest.approx(0.0, abs=PERIOD)
    room.stage.pump(60.0)
    assert behind(300) == pytest.approx(55.0, abs=PERIOD)


def waiting(client):
    """How many messages wait for it."""
    return len(client.box._events) + len(client.box._latest)


def test_a_stalled_client_delays_nobody_and_costs_no_memory(room):
    stalled, live = room.page("a"), room.page("b")
    session = live.session
    before = waiting(stalled)
    for _ in range(100):
        room.stage.pump(0.02)
        room.hub.receive(live, encode(Ack(0)))
        heard(live)
    assert room.stage.stage._seats[session].session.t == pytest.approx(2.0, abs=0.03)  # 100 ticks of 20 ms
    # the latest snapshot, and what jobs find when they are done, but none of the snapshots of 100 ticks
    assert waiting(stalled) <= before + 10


def test_a_thousand_hostile_messages_stop_nothing_and_reach_nobody(room):
    """Their sender gets sentences, at most; the neighbour's session does what it would have done alone."""
    neighbour = room.page("b")
    heard(neighbour)
    session = room.stage.stage._seats[neighbour.session].session
    alone = Room()
    same = alone.page("b")
    twin = alone.stage.stage._seats[same.session].session
    rng = random.Random(7)
    client = room.page("a")
    for i in range(1000):
        if i % 250 == 0:  # a client that only sends nonsense is let go; it comes back
            room.hub.leave(client)
            client = room.page(f"a{i}")
        room.hub.receive(client, hostile(rng))
        if i % 100 == 0:
            heard(client)
            for each in (room, alone):
                each.stage.pump(0.02)
    of_its_own = ("Snapshot", "Analysed", "Light", "Progress")  # its controller's analysis may end meanwhile
    extra = [m for m in heard(neighbour) if m["kind"] not in of_its_own]
    assert extra == []
    assert session.snapshot().x == twin.snapshot().x
    assert session.setup == MODEL
    fresh = room.page("c")
    assert "Welcome" in kinds(heard(fresh))
    alone.hub.close()


def test_a_flood_is_let_go(room):
    client = room.page("a")
    for _ in range(int(BURST) + 50):
        room.hub.receive(client, encode(Drag(0.0, 0.0)))
    assert client.closed.startswith("too many messages")


def test_a_page_comes_back_to_its_session_and_to_its_setup_elsewhere(room):
    client = room.page("a")
    room.hub.receive(client, encode(Drag(0.5, 0.05)))
    room.stage.pump(0.1)
    room.hub.leave(client)
    room.stage.pump(5.0)
    again = room.page("b", session=client.session)
    assert again.session == client.session
    shot = next(m for m in heard(again) if m["kind"] == "Snapshot")
    assert shot["t"] == pytest.approx(0.1)  # nobody watched, so nothing went on
    assert len(next(m for m in heard_history(room, again))["t"]) > 1
    other = room.page("c", session="of another server", setup=Setup(bodies=("linear",)))
    assert next(m for m in heard(other) if m["kind"] == "Changed")["bodies"] == ["linear"]


def heard_history(room: Room, client: Client) -> list[dict[str, Any]]:
    fresh = room.page("h", session=client.session)
    return [m for m in heard(fresh) if m["kind"] == "History"]


def test_a_setup_that_cannot_be_is_reported_and_another_stands_there(room):
    client = room.page("a", setup=Setup(robot="nobody"))
    said = heard(client)
    assert any(m["kind"] == "Notice" and "nobody" in m["parts"]["en"]["came"] for m in said)
    assert "Changed" in kinds(said)


def test_a_class_needs_its_token_and_a_name(classroom):
    assert kinds(heard(classroom.page("a"))) == ["Refused"]
    assert kinds(heard(classroom.page("b", token="guess", name="Ana"))) == ["Refused"]
    assert kinds(heard(classroom.page("c", token="students"))) == ["Refused"]
    (refused,) = heard(classroom.page("c2", token="students", name="   "))  # blanks alone are no name
    assert "your name is missing" in refused["reason"]
    assert heard(classroom.page("d", token="students", name="Ana"))[0]["role"] == "student"
    assert heard(classroom.page("e", token="teacher"))[0]["role"] == "teacher"
    assert len(token()) == 8
    assert token() != token()


def test_a_student_has_a_robot_of_its_own_and_no_twin(classroom):
    ana = classroom.page("a", token="students", name="Ana", setup=Setup())
    ben = classroom.page("b", token="students", name="Ben", setup=MODEL)
    seats = classroom.stage.stage._seats
    assert seats[ana.session].session.setup.bodies == ("nonlinear", "linear")
    classroom.hub.receive(ana, encode(Change(Setup())))
    assert "twin" not in seats[ana.session].session.setup.bodies
    classroom.hub.receive(ana, encode(Drag(1.0, 0.07)))
    classroom.stage.pump(0.05)
    assert seats[ana.session].session.lanes[0].state()[0] > 0.001
    assert abs(seats[ben.session].session.lanes[0].state()[0]) < 0.001


def test_only_the_teacher_gives_everyone_a_setup(classroom):
    teacher = classroom.page("t", token="teacher")
    ana = classroom.page("a", token="students", name="Ana")
    seats = classroom.stage.stage._seats
    classroom.hub.receive(ana, encode(Broadcast(Setup(controller="off"))))
    assert seats[teacher.session].session.setup.controller == "lqg"
    classroom.hub.receive(teacher, encode(Broadcast(Setup(controller="lqi"))))
    for _ in range(100):  # a busy machine may not have handed on every message at the first turn
        classroom.stage.pump(0.04)
        given = {seat.session.setup.controller for seat in seats.values()}
        if given == {"lqi"}:
            break
        time.sleep(0.02)
    assert given == {"lqi"}
    late = classroom.page("l", token="students", name="Late", setup=None)
    assert seats[late.session].session.setup.controller == "lqi"


def test_the_board_ranks_by_largest_recovered_push(classroom):
    teacher = classroom.page("t", token="teacher")
    ana = classroom.page("a", token="students", name="Ana")
    ben = classroom.page("b", token="students", name="Ben")
    seats = classroom.stage.stage._seats
    seats[ben.session].session.score.best = 0.05
    classroom.hub.leave(ana)
    classroom.stage.pump(0.3)
    boards = [m for m in heard(teacher) if m["kind"] == "Board"]
    assert [(s["name"], s["best"], s["here"]) for s in boards[-1]["students"]] == [
        ("Ben", 0.05, True),
        ("Ana", 0, False),
    ]


def test_thirty_students_and_no_more(classroom, monkeypatch):
    """Here four, whose robots are made in less time."""
    assert MOST_STUDENTS == 30
    monkeypatch.setattr("upright.lab.hub.MOST_STUDENTS", 4)
    pages = [classroom.page(str(i), token="students", name=f"S{i}") for i in range(4)]
    assert all(page.session for page in pages)
    assert "every place is taken" in classroom.page("x", token="students", name="X").closed
    classroom.hub.leave(pages[0])
    assert not classroom.page("y", token="students", name="Y").closed  # in the place of the one who left


@pytest.mark.parametrize(
    ("name", "safe"),
    [
        ("run.csv", "in-run.csv"), ("../../etc/run.csv", "in-run.csv"), ("C:\\logs\\My Run.CSV", "in-My_Run.csv"),
        ("…/ä ö.parquet", None), (".csv", None), ("run.exe", None), ("run", None),
        ("a" * 200 + ".csv", "in-" + "a" * 56 + ".csv"),
    ],
)  # fmt: skip
def test_an_uploaded_file_gets_a_safe_name(name, safe):
    if safe is None:
        with pytest.raises(UploadRefused):
            safe_name(name, "log")
    else:
        assert safe_name(name, "log") == safe


def test_an_upload_that_is_too_large_leaves_nothing(tmp_path):
    async def chunks(size: int) -> Any:
        for _ in range(size >> 20):
            yield bytes(1 << 20)

    path = asyncio.run(receive(chunks(1 << 20), tmp_path, "small.csv", "log"))
    assert path.parent == tmp_path
    with pytest.raises(UploadRefused):
        asyncio.run(receive(chunks(LARGEST + (2 << 20)), tmp_path, "large.csv", "log"))
    assert [p.name for p in tmp_path.iterdir()] == ["in-small.csv"]


def test_foreign_names_and_origins_are_known():
    lab = Lab(port=8765)
    assert not lab.foreign("127.0.0.1:8765", None)
    assert not lab.foreign("localhost:8765", "http://localhost:8765")
    for host, origin in [
        ("evil.example:8765", None), ("127.0.0.1:8765", "http://evil.example"), ("127.0.0.1:8765", "null"),
        ("127.0.0.1:8765", "http://127.0.0.1:9999"), ("127.0.0.1:8765", "https://127.0.0.1:8765"), (None, None),
    ]:  # fmt: skip
        assert lab.foreign(host, origin)


def test_a_port_in_use_is_reported_in_one_line(capsys):
    taken = Lab(port=0)
    sock = listening(taken)
    sock.listen()
    with pytest.raises(UprightError) as said:
        listening(Lab(port=taken.port))
    assert f"--port {taken.port + 1}" in str(said.value)
    sock.close()
    assert main(["lab", "--class", "--host", "0.0.0.0", "--no-browser"]) == 2
    assert "--host ADDRESS" in capsys.readouterr().err
    assert main(["lab", "--host", "10.0.0.1", "--no-browser"]) == 2


PLAIN = """import sys
from upright.cli.main import main
from upright.lab import server
server.ALONE = server.Options(rate=20.0, coarse=True, certified=False)
sys.exit(main())"""
"""`upright lab` with coarser steps and without a certificate for which nobody waits."""


@pytest.fixture(scope="module")
def served() -> Iterator[str]:
    """A lab of its own process; its address."""
    with _started("-c", PLAIN) as address:
        yield address


@contextmanager
def _started(*program: str) -> Iterator[str]:
    command = [sys.executable, *program, "lab", "--port", "0", "--no-browser"]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout
    address = process.stdout.readline().split()[-1]
    yield address
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 0
    assert said == ""  # whatever was thrown at it


def test_pages_are_served_to_this_site_alone(served):
    import httpx

    http = httpx.Client(timeout=PATIENCE)
    page = http.get(served)
    assert page.status_code == 200
    assert "default-src 'self'" in page.headers["content-security-policy"]
    assert http.get(served + "assets/lab.js").headers["content-type"].startswith("text/javascript")
    assert http.get(served, headers={"Host": "evil.example"}).status_code == 403
    assert http.get(served, headers={"Origin": "http://evil.example"}).status_code == 403
    for path in ("assets/..%2f..%2fserver.py", "assets/%2e%2e/server.py", "files/x/run.csv", "docs", "openapi.json"):
        assert http.get(served + path).status_code == 404, path
    assert "Open the lab" in http.get(served + "nowhere").text


def test_a_foreign_socket_is_refused(served):
    from websockets.exceptions import InvalidStatus
    from websockets.sync.client import connect

    with pytest.raises(InvalidStatus) as refused, connect(served.replace("http", "ws") + "ws", origin=EVIL):
        raise AssertionError("it let another site in")
    assert refused.value.response.status_code == 403


def test_a_log_is_sent_examined_and_fetched_over_the_wire(served, tmp_path):
    import httpx

    http = httpx.Client(timeout=PATIENCE)
    with _page(served) as (socket, welcome):
        _send(socket, {"kind": "Drag", "force": 0.6, "height": 0.07})
        _until(socket, lambda m: m["kind"] == "Snapshot" and m["t"] > 0.5)
        _send(socket, {"kind": "Save", "what": "csv"})
        made = _until(socket, lambda m: m["kind"] == "Made")
        found = http.get(served + welcome["files"] + made["url"])
        assert found.headers["content-disposition"].startswith("attachment")
        address = f"{served}upload/{welcome['session']}"
        sent = http.post(address, params={"what": "log", "name": "../../mine.csv"}, content=found.content)
        assert sent.json() == {"name": "in-mine.csv"}
        assert _until(socket, lambda m: m["kind"] in ("JobResult", "Notice"))["kind"] == "JobResult"
        assert http.post(address, params={"what": "log", "name": "x.exe"}, content=b"x").status_code == 400
        assert http.post(f"{served}upload/none", params={"name": "x.csv"}, content=b"x").status_code == 404
        assert http.get(f"{served}files/{'0' * 32}/run.csv").status_code == 404


@pytest.mark.evidence
def test_the_light_of_a_certificate_follows_over_the_wire():
    """Computed by a process of its own, of which nobody had asked anything, in a lab as a user starts it."""
    with _started("-m", "upright") as address, _page(address) as (socket, _):
        lit = _until(socket, lambda m: m["kind"] == "Light" and m["light"] != "none")
    assert lit["light"] == "green"
    assert lit["heads"]["es"]["verdict"]


def test_huge_binary_and_broken_frames_close_only_their_own_line(served):
    from websockets.exceptions import ConnectionClosed

    with _page(served) as (live, _):
        with _page(served) as (huge, _), pytest.raises(ConnectionClosed):  # noqa: PT012 (perhaps before all is sent)
            huge.send("x" * 1_000_000)
            _until(huge, lambda m: False)
        with _page(served) as (binary, _):
            for _ in range(50):
                binary.send(random.Random(1).randbytes(500))
            assert _until(binary, lambda m: m["kind"] == "Notice")["level"] == "error"
        shot = _until(live, lambda m: m["kind"] == "Snapshot")
        assert shot["x"]


@contextmanager
def _page(address: str) -> Iterator[tuple[Any, dict[str, Any]]]:
    """A page that has said hello, over the wire."""
    from websockets.sync.client import connect

    with connect(address.replace("http", "ws") + "ws", max_size=None, open_timeout=PATIENCE, close_timeout=1) as socket:
        _send(socket, {"kind": "Hello", "version": VERSION, "setup": json.loads(encode(Change(MODEL)))["setup"]})
        yield socket, _until(socket, lambda m: m["kind"] == "Welcome")


def _send(socket: Any, message: dict[str, Any]) -> None:
    socket.send(json.dumps(message))


def _until(socket: Any, wanted: Callable[[dict[str, Any]], bool], seconds: float = PATIENCE) -> dict[str, Any]:
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        message = json.loads(socket.recv(timeout=seconds))
        if message["kind"] == "Snapshot":
            _send(socket, {"kind": "Ack", "n": message["n"]})
        if wanted(message):
            return message
    raise AssertionError("it never came")


def test_the_session_folders_go_with_the_hub():
    made = Room()
    client = made.page("a")
    folder = made.hub.folder(client.session)
    assert folder is not None
    assert not folder.exists()  # until there is a file to keep
    folder.mkdir()
    (folder / "in-run.csv").write_text("t\n", encoding="utf-8")
    made.hub.close()
    assert not Path(folder).exists()
