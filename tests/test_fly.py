"""Before a robot drives: `upright fly` shows what it is about to do, asks, and refuses a red certificate."""

from __future__ import annotations

import io
import math
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from upright.bricks.world import World
from upright.cli.main import main
from upright.control import controller_hash, make_controller, read_controller, write_controller
from upright.flight import Flight
from upright.flight.fly import fly as virtual
from upright.flight.program_logs import ProgramLog
from upright.robots import Kit, Robot
from upright.signals import Log

KITS = {"nxc": ("nxt", "balance.nxc", "/dev/rfcomm0"), "pybricks": ("spike", "balance.py", "ble:Hub")}


class Red:
    """A certificate of a controller under which every robot fell."""

    def refuses(self, controller: object = None, robot: object = None, kit: object = None) -> str:
        return "red: 100 of 100 robots fell"


def write_design(method: str, kit: str, path: Path) -> None:
    """As `upright design` writes it, without its analysis, which takes longer."""
    parts = Kit.preset(kit)
    write_controller(make_controller(method, Robot.preset("nxtway-gs"), parts, parts.period), path)


@pytest.fixture(scope="module", params=KITS)
def designed(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path, Path, str]:
    """A target, its program and controller as the commands make them, and the port of a real robot."""
    kit, name, port = KITS[request.param]
    folder = tmp_path_factory.mktemp(request.param)
    controller, program = folder / "controller.json", folder / name
    write_design("lqg", kit, controller)
    options = ["--target", request.param, "--kit", kit, "-o", str(program)]
    assert main(["firmware", str(controller), *options]) == 0
    return request.param, program, controller, port


@pytest.fixture
def flown(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The ports that were flown at: nothing is, in these tests."""
    ports = list[str]()

    def pretend(source: Path, program: object, port: str, seconds: float, **rest: object) -> Flight:
        ports.append(port)
        return Flight()

    room = import_module("upright.flight.fly")
    monkeypatch.setattr(room, "fly_nxt", pretend)
    monkeypatch.setattr(room, "fly_hub", pretend)
    return ports


def fly(designed: tuple[str, Path, Path, str], *options: str) -> int:
    _, program, controller, port = designed
    return main(["fly", str(program), str(controller), "--link", port, *options])


@pytest.mark.parametrize(("answer", "flights"), [("n\n", 0), ("", 0), ("y\n", 1)])
def test_it_shows_what_it_is_about_to_do_and_asks(
    designed: tuple[str, Path, Path, str],
    flown: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    answer: str,
    flights: int,
) -> None:
    monkeypatch.setattr("sys.stdin", io.StringIO(answer))
    code = fly(designed)
    said = capsys.readouterr().err
    assert (code == 0, len(flown)) == (bool(flights), flights)
    kit = KITS[designed[0]][0]
    assert f"robot       nxtway-gs on {kit}, at {designed[3]}" in said
    assert f"controller  lqg {controller_hash(read_controller(designed[2]))[:12]}" in said
    assert "certificate not certified" in said


def test_a_red_certificate_is_refused_unless_somebody_insists(
    designed: tuple[str, Path, Path, str],
    flown: list[str],
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(sys.modules["upright.certification"], "read_certificate", lambda path: Red())
    assert fly(designed, "--certificate", "red.json", "--yes") != 0
    said = capsys.readouterr().err
    assert "may not drive this robot: red: 100 of 100 robots fell" in said
    assert len(said.strip().splitlines()) == 1
    assert not flown
    assert fly(designed, "--certificate", "red.json", "--yes", "--anyway") == 0
    assert flown == [designed[3]]


def test_a_program_of_another_controller_is_refused(
    designed: tuple[str, Path, Path, str], flown: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target, program, _, port = designed
    other = tmp_path / "other.json"
    write_design("pid", KITS[target][0], other)
    capsys.readouterr()
    assert fly((target, program, other, port), "--yes") != 0
    assert "holds another controller" in capsys.readouterr().err
    assert not flown


def test_it_may_be_said_for_which_robot_or_brick_it_is(
    designed: tuple[str, Path, Path, str], flown: list[str], tmp_path: Path
) -> None:
    brick = {"nxc": "nxt", "pybricks": "spike"}[designed[0]]
    own = Robot.preset("nxtway-gs").save(tmp_path / "mine.toml")
    for name in (brick, "nxtway-gs", str(own)):
        assert fly(designed, "--robot", name, "--yes") == 0
    assert flown == [designed[3]] * 3


def test_a_program_for_another_robot_or_brick_is_refused(
    designed: tuple[str, Path, Path, str], flown: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    brick, other = {"nxc": ("nxt", "spike"), "pybricks": ("spike", "nxt")}[designed[0]]
    for name in (other, "ev3way"):
        assert fly(designed, "--robot", name, "--yes") != 0
        said = capsys.readouterr().err
        assert f"was made for nxtway-gs on the brick {brick}; expected a program for {name}" in said
        assert len(said.strip().splitlines()) == 1
    assert not flown


def test_a_flight_longer_than_its_program_drives_is_refused(
    designed: tuple[str, Path, Path, str], flown: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    target, program, controller, port = designed
    short = tmp_path / program.name
    options = ["--target", target, "--kit", KITS[target][0], "-o", str(short), "--seconds", "9"]
    assert main(["firmware", str(controller), *options]) == 0
    capsys.readouterr()
    assert fly((target, short, controller, port), "--yes", "--seconds", "10") != 0
    assert (
        "stops by itself after 9 s; expected at most 9; try: upright firmware --seconds 10" in capsys.readouterr().err
    )
    assert fly((target, short, controller, port), "--yes", "--seconds", "9") == 0
    assert flown == [port]


@pytest.mark.parametrize(
    "options",
    [
        ("--push", "hold:0.1"),
        ("--seconds", "inf"),
        ("--seconds", "601"),
        ("--seconds", "61"),  # the program stops after 60
        ("--robot", "ev3"),
        ("--robot", "ev3way"),
        ("--robot", "nobody"),
    ],
)
def test_what_cannot_be_flown_is_one_line(
    designed: tuple[str, Path, Path, str],
    flown: list[str],
    capsys: pytest.CaptureFixture[str],
    options: tuple[str, str],
) -> None:
    assert fly(designed, "--yes", *options) != 0
    assert len(capsys.readouterr().err.strip().splitlines()) == 1
    assert not flown


@pytest.mark.parametrize("name", ["run.xyz", "folder.csv", "nowhere/run.csv"])
def test_a_log_that_could_not_be_written_is_refused_before_the_robot_moves(
    designed: tuple[str, Path, Path, str],
    flown: list[str],
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    name: str,
) -> None:
    (tmp_path / "folder.csv").mkdir()
    assert fly(designed, "--yes", "-o", str(tmp_path / name)) == 2
    assert len(capsys.readouterr().err.strip().splitlines()) == 1
    assert not flown


@pytest.mark.parametrize("what", ["the folder is gone", "a folder has its name"])
def test_the_log_of_a_flight_survives_a_target_that_vanishes(
    designed: tuple[str, Path, Path, str],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    what: str,
) -> None:
    from upright.flight.program_logs import ProgramLog
    from upright.signals import Log

    target, here = tmp_path / "logs" / "run.csv", tmp_path / "here"
    target.parent.mkdir()
    here.mkdir()
    monkeypatch.chdir(here)
    flown = Log([0.0, 0.1], {"estimate/pitch": [0.0, 0.02]})

    def pretend(*_: object, **__: object) -> Flight:
        target.parent.rmdir() if what == "the folder is gone" else target.mkdir()
        return Flight(log=ProgramLog(flown, {}, ""))

    for name in ("fly_nxt", "fly_hub"):
        monkeypatch.setattr(import_module("upright.flight.fly"), name, pretend)
    assert fly(designed, "--yes", "-o", str(target)) == 2
    said = capsys.readouterr().err
    assert len(said.strip().splitlines()) == 1
    place = Path(said.rpartition("the log is in ")[2].strip())
    assert place.parent == (here if what == "the folder is gone" else target.parent)
    assert Log.load(place) == flown


@pytest.mark.parametrize("seed", range(2))
def test_a_virtual_robot_is_let_go_off_the_vertical(seed: int) -> None:
    # its encoders read zero, as where a program starts; not driven, it falls within some of its time constants
    robot = Robot.preset("nxtway-gs")
    world = World("pybricks", robot, Kit.preset("spike"), seed=seed)
    before = world.raw()
    assert before["sensor/encoder_left"] == 0
    world.step((0.0, 0.0), driven=True)
    truth = dict(zip(world._names, world._now.values.tolist(), strict=True))
    assert 1.9 < abs(math.degrees(truth["truth/pitch"])) < 3.1
    assert abs(world.raw()["sensor/encoder_left"]) <= 1
    for _ in range(round(3 / world.period)):
        world.step((0.0, 0.0), driven=True)
    assert world.fallen


def flown_log(duty: float, *, rows: int = 1100) -> Flight:
    t, zero = np.arange(rows) * 0.01, np.zeros(rows)
    channels = {"applied/left": zero + duty, "applied/right": zero + duty, "estimate/pitch": zero}
    return Flight(log=ProgramLog(Log(t, channels), {"hash": "0"}, "balancing"), robot="nxtway-gs", where="a hub")


def test_a_flight_without_any_duty_did_not_balance() -> None:
    assert "did not balance: no motor was driven in 11.0 s" in str(flown_log(0.0))
    assert "balanced for 11.0 s" in str(flown_log(0.5))
    assert flown_log(0.0).to_json()["drove"] is False
    fell = flown_log(0.5)
    fell.fell = True
    assert "balanced" not in str(fell)
    assert "fell" in str(fell)


GYRO = "GYRO_SIGN * hub.imu.angular_velocity(AXIS)"
MOUNTED = {"right": GYRO, "wrong axis": GYRO.replace("AXIS)", "Axis.X)"), "wrong sign": f"-{GYRO}"}


@pytest.mark.needs("module:micropython_unix")
@pytest.mark.parametrize("mounted", ["right", pytest.param("wrong axis", marks=pytest.mark.evidence), "wrong sign"])
def test_a_program_that_reads_its_gyro_wrongly_falls(tmp_path: Path, mounted: str) -> None:
    controller, program = tmp_path / "controller.json", tmp_path / "balance.py"
    write_design("lqg", "spike", controller)
    assert main(["firmware", str(controller), "--target", "pybricks", "--kit", "spike", "-o", str(program)]) == 0
    program.write_text(program.read_text().replace(GYRO, MOUNTED[mounted]))
    flight = virtual(program, controller, seconds=4.0)
    assert flight.balanced is (mounted == "right"), str(flight)
    assert ("balanced" in str(flight)) is (mounted == "right")
