"""The virtual Pybricks hub: pybricksdev drives it as it comes, MicroPython runs its program, faults are survived."""

from __future__ import annotations

import asyncio
import binascii
import math
import re
import shlex
import shutil
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest

from conftest import PATIENCE
from interpreter import Interpreter
from upright.bricks.hub import COMMANDS, CommandRefused, VirtualHub
from upright.bricks.virtual_robot import virtual_hub
from upright.cli.main import main
from upright.cli.output import AGAINST
from upright.compiled.program import Program
from upright.control import CONTROLLERS, write_controller
from upright.errors import UprightError
from upright.experiment import Hold
from upright.firmware import generate
from upright.flight.flight import Flight, FlightRefused
from upright.flight.fly_hub import fetch_hub, fly_hub
from upright.flight.follow import follow_hub
from upright.flight.program_logs import read_lines
from upright.links.hub import HubLost, HubRefused, linked
from upright.robots import Kit, Robot

pytestmark = pytest.mark.needs("module:pybricksdev", "module:micropython_unix")

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("spike")


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Program]:
    """A balancing program for a SPIKE Prime hub, as text and as what it was printed from."""
    return program("lqg", tmp_path_factory.mktemp("pybricks"))


def program(controller: str, folder: Path, seconds: int | None = None) -> tuple[Path, Program]:
    firmware = generate(CONTROLLERS[controller](ROBOT, KIT, KIT.period), ROBOT, KIT, "pybricks", seconds=seconds)
    source = folder / "balance.py"
    source.write_text(firmware.text)
    return source, firmware.program


@pytest.fixture
def hub() -> Iterator[VirtualHub]:
    with virtual_hub(ROBOT, KIT, [Hold(pitch=0.1, until=1.0)]) as found:
        yield found


def flown(
    made: tuple[Path, Program],
    hub: VirtualHub,
    seconds: float = 3.0,
    after: Callable[[float], object] | None = None,
    patience: float = PATIENCE,
) -> Flight:
    """A flight whose clock is the hub's; `after` is told that clock [s] while it flies."""
    hub.until = seconds
    watch = (lambda _: after(hub.seconds)) if after else None
    return fly_hub(*made, hub, seconds, progress=watch, clock=lambda: hub.seconds, patience=patience)


def at_rest(hub: VirtualHub) -> bool:
    return not hub.running and hub.duties == (0.0, 0.0)


def test_a_flight_brings_its_stamped_log_home(made: tuple[Path, Program], hub: VirtualHub) -> None:
    flight = flown(made, hub, 2.5)
    assert flight.log is not None
    assert (flight.notes, flight.lost, flight.log.ended) == ([], False, "balancing")
    log = flight.log.log
    assert log.origin["controller"]["hash"] == made[1].hash
    assert log.origin["robot"]["name"] == ROBOT.name
    assert log.t[-1] == pytest.approx(2.5 - 1.0, abs=0.05)  # a second of it is the still start
    assert 0.05 < np.abs(log["estimate/pitch"]).max() < 0.3  # a hold at 0.1 rad, overshot by half
    assert not hub.world.fallen
    assert at_rest(hub)


def test_a_hub_out_of_reach_keeps_its_telemetry_here_and_its_log_there(
    made: tuple[Path, Program], hub: VirtualHub
) -> None:
    """It balances on; whoever comes back stops it and gets its log, and its button stops it as well."""
    flight = flown(made, hub, 6.0, lambda now: now > 2.0 and hub.cut())
    assert flight.lost
    assert flight.notes[0].startswith("motors may be running: ")
    assert "--fetch" in flight.notes[0]
    assert flight.log is not None
    assert "sensor/gyro" not in flight.log.log  # telemetry has none
    assert len(flight.log.log) >= 5  # every tenth of a second from the first to the second second
    assert hub.running
    later = fetch_hub(made[1], hub, patience=PATIENCE)
    assert later.log is not None
    assert len(later.log.log) > 90
    assert at_rest(hub)
    with pytest.raises(FlightRefused, match="no program runs"):
        fetch_hub(made[1], hub, patience=PATIENCE)


def test_a_hub_out_of_reach_stops_by_itself_and_keeps_its_whole_log(hub: VirtualHub, tmp_path: Path) -> None:
    """Nobody touches the hub: its longest run ends it, and whoever comes back gets everything."""
    made = program("lqg", tmp_path, seconds=3)
    flight = flown(made, hub, 3.0, lambda now: now > 2.0 and hub.cut())
    assert flight.lost
    assert "stops after 3 s at most; it keeps its log" in flight.notes[0]
    hub.until = math.inf
    hub.run(2.0)  # the still start took one second, and one is over
    assert hub.duties == (0.0, 0.0)
    later = fetch_hub(made[1], hub, patience=PATIENCE)
    assert later.notes == ["the program stopped by itself: time is over"]
    assert later.log is not None
    assert later.log.log.t == pytest.approx(0.01 * np.arange(len(later.log.log)))
    assert len(later.log.log) in (300, 301)  # 3 s of 10 ms, and one more where the clock was read before its end
    assert at_rest(hub)


@pytest.mark.parametrize("connected", [pytest.param(True, marks=pytest.mark.evidence), False])
def test_a_hub_that_falls_keeps_its_log_until_somebody_comes(
    made: tuple[Path, Program], tmp_path: Path, connected: bool
) -> None:
    """Its left motor is told to run the other way, so that it falls at once."""
    source = tmp_path / "balance.py"
    source.write_text(made[0].read_text().replace("left.dc(duty_left)", "left.dc(-duty_left)"))
    with virtual_hub(ROBOT, KIT, [Hold(pitch=0.1, until=1.0)]) as hub:
        flight = flown((source, made[1]), hub, 9.0, lambda now: not connected and now > 1.1 and hub.cut())
        if not connected:
            hub.run(9.0)
            assert hub.duties == (0.0, 0.0)
            flight = fetch_hub(made[1], hub, patience=PATIENCE)
        assert any("stopped by itself: " in note for note in flight.notes)
        assert flight.log is not None
        assert flight.log.ended == "fallen"
        assert flight.log.log.t[0] == 0.0
        assert at_rest(hub)


def test_its_button_stops_a_hub_out_of_reach(made: tuple[Path, Program], hub: VirtualHub) -> None:
    flown(made, hub, 6.0, lambda now: now > 2.0 and hub.cut())
    hub.press()
    assert at_rest(hub)


@pytest.mark.evidence
def test_a_silent_hub_is_given_up_and_what_it_said_is_kept(made: tuple[Path, Program]) -> None:
    """It answers for two seconds of its own, and no more."""
    for brief in (1.0, 6.0, 36.0):  # [s] it is waited for five times; a busy machine may not fly in the first of them
        with virtual_hub(ROBOT, KIT, [Hold(pitch=0.1, until=1.0)]) as hub, suppress(HubLost):
            flight = flown(made, hub, 60.0, lambda now, hub=hub: setattr(hub, "silent", now > 2.0), brief)
            if not hub.silent:
                continue
            assert flight.lost
            assert flight.notes[0].startswith("motors may be running: ")
            assert flight.log is not None
            with pytest.raises(HubLost, match="does not answer"):
                flown(made, hub, patience=brief)
            hub.press()
            assert at_rest(hub)
            return
    raise AssertionError("it did not come to its second second")


def test_a_torn_log_keeps_its_whole_rows(made: tuple[Path, Program], hub: VirtualHub) -> None:
    pieces: list[bytes] = []

    def torn(piece: bytes) -> bytes:  # nothing comes through after the fortieth piece of the log
        pieces.extend([piece] if hub.seconds >= 3.0 else [])
        return piece if len(pieces) < 40 else b""

    hub.garbled = torn
    flight = flown(made, hub)
    assert flight.log is not None
    assert 40 < len(flight.log.log) < 200
    assert any("rows did not arrive" in note for note in flight.notes)
    assert at_rest(hub)


def test_a_hub_lost_while_it_tells_its_log_leaves_what_it_told(
    made: tuple[Path, Program], hub: VirtualHub, monkeypatch: pytest.MonkeyPatch
) -> None:
    told, flush = list[float](), hub.flush

    def breaking() -> bool:
        told.extend([] if hub.running or hub.seconds < 3.0 else [hub.seconds])
        if len(told) > 8:  # of the 13 times five pieces that two seconds of log take
            hub.cut()
        return flush()

    monkeypatch.setattr(hub, "flush", breaking)
    flight = flown(made, hub)
    assert flight.lost
    assert flight.log is not None
    assert 80 < len(flight.log.log) < 200
    assert "was lost while it sent its log" in flight.notes[0]
    assert any("rows did not arrive" in note for note in flight.notes)
    assert at_rest(hub)


def test_damaged_lines_are_counted_and_the_others_kept(made: tuple[Path, Program], hub: VirtualHub) -> None:
    """One character of every log line of rows 20 and 21, 120 and 121 is not what was sent."""
    hub.garbled = lambda piece: piece.replace(b"D 20 ", b"D 21 ").replace(b"D 120 ", b"D 121 ")
    flight = flown(made, hub)
    assert flight.log is not None
    log = flight.log.log
    damaged = round((1.0 - len(log) / 201) * 201)  # [rows] of the 201 that two seconds make
    assert damaged in (2, 4)  # a piece may end inside the number, and then the line stays whole
    assert flight.notes == [f"{damaged // 2} damaged lines were left out", f"{damaged} of 201 rows did not arrive"]
    assert np.diff(log.t).max() == pytest.approx(0.03)  # the others stand at their own times


@pytest.mark.parametrize(
    ("fault", "said"),
    [
        ({"battery": 6000.0}, "battery of the hub virtual is low"),
        ({"protocol": "1.0.0"}, "Unsupported Pybricks protocol version"),
        ({"protocol": "1.1.0", "firmware": "3.1.0"}, r"firmware 3\.1\.0 of the hub virtual is too old"),
        ({"protocol": "2.0.0"}, "Unsupported Pybricks protocol version"),
        ({"capable": 0}, "not compatible"),
    ],
)
def test_a_hub_that_is_not_ready_is_not_driven(
    made: tuple[Path, Program], hub: VirtualHub, fault: dict[str, object], said: str
) -> None:
    for name, value in fault.items():
        setattr(hub, name, value)
    with pytest.raises(UprightError, match=said) as caught:
        flown(made, hub)
    assert "\n" not in str(caught.value)
    assert at_rest(hub)
    assert not hub.world.released


@pytest.mark.parametrize("port", ["A", pytest.param("B", marks=pytest.mark.evidence)])
def test_a_motor_in_another_port_is_reported(made: tuple[Path, Program], port: str) -> None:
    with virtual_hub(ROBOT, KIT, absent=[port]) as hub:
        with pytest.raises(FlightRefused, match="not in the port that the program uses"):
            flown(made, hub)
        assert at_rest(hub)
        assert not hub.world.released


def test_a_gyro_in_another_port_is_reported(tmp_path: Path) -> None:
    kit = Kit.preset("ev3")  # whose gyro has a cable; a hub's is built in
    firmware = generate(CONTROLLERS["lqg"](ROBOT, kit, kit.period), ROBOT, kit, "pybricks", hub="ev3")
    source = tmp_path / "balance.py"
    source.write_text(firmware.text)
    with virtual_hub(ROBOT, kit, absent=["S2"]) as hub:
        with pytest.raises(FlightRefused, match="not in the port that the program uses"):
            flown((source, firmware.program), hub)
        assert at_rest(hub)
        assert not hub.world.released


def test_text_that_does_not_compile_is_one_line(made: tuple[Path, Program], hub: VirtualHub, tmp_path: Path) -> None:
    source = tmp_path / "bad.py"
    source.write_text("def (:")
    with pytest.raises(HubRefused, match=r"bad\.py does not compile: SyntaxError") as caught:
        flown((source, made[1]), hub)
    assert "\n" not in str(caught.value)


def test_the_program_itself_refuses_a_flat_battery(
    made: tuple[Path, Program], hub: VirtualHub, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("upright.bricks.hub.LOW_BATTERY", 0)  # a hub that does not warn
    hub.battery = 4000.0
    with pytest.raises(FlightRefused, match="battery too low"):
        flown(made, hub)
    assert not hub.world.released


def test_the_program_of_another_controller_is_noted(
    made: tuple[Path, Program], hub: VirtualHub, tmp_path: Path
) -> None:
    flown(program("pid", tmp_path), hub, 6.0, lambda now: now > 2.0 and hub.cut())
    with pytest.raises(FlightRefused, match="a program runs on the hub virtual already"):
        flown(made, hub)
    flight = fetch_hub(made[1], hub, patience=PATIENCE)
    assert "another controller" in flight.notes[0]
    assert flight.log is not None  # kept all the same
    assert at_rest(hub)


def test_ctrl_c_stops_the_motors_and_keeps_the_log(made: tuple[Path, Program], hub: VirtualHub) -> None:
    pressed: list[float] = []

    def press(now: float) -> None:
        if now > 2.0 and not pressed:
            pressed.append(now)
            signal.raise_signal(signal.SIGINT)

    flight = flown(made, hub, 60.0, press)
    assert flight.notes == ["stopped by Ctrl-C"]
    assert flight.log is not None
    assert len(flight.log.log) > 90  # from the first second to the second
    assert at_rest(hub)


def test_a_program_that_goes_wrong_ends_with_its_motors_off(
    made: tuple[Path, Program], hub: VirtualHub, tmp_path: Path
) -> None:
    source = tmp_path / "bad.py"
    source.write_text(made[0].read_text().replace("count += 1\n", "count += 1 // (count < 50)\n"))
    flight = flown((source, made[1]), hub)
    assert flight.log is not None
    assert len(flight.log.log) == 50  # the rows before it divides by zero
    assert at_rest(hub)


def test_a_hub_without_a_program_says_so(hub: VirtualHub) -> None:
    async def start() -> None:
        async with linked(hub, PATIENCE) as link:
            await link.start()

    with pytest.raises(HubRefused, match="refuses to start"):
        asyncio.run(start())


def test_hostile_commands_never_stop_the_hub(hub: VirtualHub) -> None:
    rng = np.random.Generator(np.random.Philox(3))
    for _ in range(3000):
        data = bytearray(rng.bytes(int(rng.integers(0, 40))))
        if data:
            data[0] %= 8
        with suppress(CommandRefused):
            hub.write(COMMANDS, bytes(data))
        hub.run(0.01)
    assert len(hub.read("c5f50003-8280-46da-89f4-6d8051e4aeef")) == 10  # it still tells what it can


@pytest.mark.parametrize(
    ("pace", "tells", "most"),
    [
        (0.15, False, 4),
        *(pytest.param(*how, marks=pytest.mark.evidence) for how in ((0.01, False, 0), (0.15, True, 0))),
    ],
)
def test_telemetry_never_holds_a_balancing_robot_up(
    made: tuple[Path, Program], pace: float, tells: bool, most: int
) -> None:
    """A hub's output goes through a ring of 40 bytes, a note of 19 every `pace` [s], and whoever prints into a full one
    waits: 300 ms for each line where one comes every 100 ms. Without a look at the room 13 periods of 300 are late;
    a firmware that does not tell is found out by one line or two that wait."""
    output: list[bytes] = []
    with virtual_hub(ROBOT, KIT, pace=pace, tells=tells) as hub:
        hub.garbled = lambda piece: (output.append(piece), piece)[1]
        flight = flown(made, hub, 4.0)
        assert flight.log is not None
        assert not hub.world.fallen
    text = b"".join(output).decode()
    log = flight.log.log
    assert log.origin["outcome"]["late"] == (np.diff(log.t) > 0.0115).sum() <= most  # each row has its own time
    assert len(re.findall("^T ", text, re.MULTILINE)) >= 5  # telemetry goes on all the same


def test_a_battery_that_is_nearly_empty_is_refused_before_the_hub_switches_off(
    made: tuple[Path, Program], hub: VirtualHub, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Pybricks switches a hub of two lithium cells off at 6.0 V (pbio/sys/battery.c)."""
    monkeypatch.setattr("upright.bricks.hub.LOW_BATTERY", 0)
    hub.battery = 6300.0
    with pytest.raises(FlightRefused, match="battery too low"):
        flown(made, hub)


@pytest.mark.parametrize("name", ["nxt", "spike", "ev3"])
@pytest.mark.parametrize("target", ["pybricks", "ev3dev", "nxc", "arduino"])
def test_every_program_refuses_a_battery_that_exists(name: str, target: str) -> None:
    """Six volts: an empty pack of two lithium cells or six alkaline ones, from which a brick still starts."""
    kit = Kit.preset(name)
    text = generate(CONTROLLERS["pid"](ROBOT, kit, kit.period), ROBOT, kit, target).program
    machine = Interpreter(text)
    raw = dict.fromkeys(text.channels, 0.0) | {"raw_battery": 6.0 / text.scales["raw_battery"]}
    assert machine.calibrate(raw)["start_status"] == 4


@pytest.mark.parametrize("firmware", ["3.2.0", "3.3.0"])
def test_a_firmware_without_what_the_program_calls_is_refused(
    made: tuple[Path, Program], hub: VirtualHub, firmware: str
) -> None:
    """Axis moved in 3.3.0b4, the buttons of every hub got one name in 3.4.0b5 (changelogs of pybricks-api)."""
    hub.firmware = firmware
    with pytest.raises(HubRefused, match=r"too old.*expected Pybricks 3\.4 or later"):
        flown(made, hub)
    assert at_rest(hub)
    assert not hub.world.released


def test_no_bluetooth_is_one_line(made: tuple[Path, Program], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("upright.links.hub.SEARCH", 0.2)
    with pytest.raises(HubLost, match="no hub nowhere was found") as caught:
        fly_hub(*made, "ble:nowhere", 3.0)
    assert "\n" not in str(caught.value)


def test_the_hub_s_library_is_loaded_when_a_hub_is_asked_for() -> None:
    code = "import sys, upright.flight.fly_hub, upright.cli.fly, upright.cli.monitor; "
    code += "sys.exit(bool({'pybricksdev', 'bleak'} & sys.modules.keys()))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.fixture(scope="module")
def written(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with controller.json and balance.py, as the commands make them, without the analysis of the design."""
    folder = tmp_path_factory.mktemp("commands")
    controller, source = folder / "controller.json", folder / "balance.py"
    write_controller(CONTROLLERS["lqg"](ROBOT, KIT, KIT.period), controller)
    assert main(["firmware", str(controller), "--target", "pybricks", "--kit", "spike", "-o", str(source)]) == 0
    return folder


@pytest.fixture
def designed(written: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(shutil.copytree(written, tmp_path / "here"))
    return Path.cwd()


def test_the_command_flies_a_hub_and_labels_the_twin(designed: Path, capsys: pytest.CaptureFixture[str]) -> None:
    capsys.readouterr()
    assert main(shlex.split("fly balance.py controller.json --yes --seconds 3 -o first.parquet")) == 0
    said = capsys.readouterr().out
    assert "a virtual hub with the twin round it" in said
    from upright.signals import Log

    assert "virtual hub" in Log.load(designed / "first.parquet").origin["body"]["kind"]


@pytest.mark.parametrize(
    ("options", "said"),
    [("--link usb", "expected ble, ble:NAME or virtual"), ("--fetch", "keeps no log"), ("--seconds 0", "more than 0")],
)
def test_what_cannot_be_flown_is_one_line(
    designed: Path, capsys: pytest.CaptureFixture[str], options: str, said: str
) -> None:
    assert main(shlex.split(f"fly balance.py controller.json --yes {options}")) != 0
    error = capsys.readouterr().err
    assert said in error
    assert len(error.strip().splitlines()) == 1


def test_the_exit_code_says_that_the_robot_was_lost(
    designed: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    lost = Flight(lost=True, notes=["the hub does not answer"])
    monkeypatch.setattr(import_module("upright.flight.fly"), "fly_hub", lambda *_, **__: lost)
    assert main(shlex.split("fly balance.py controller.json --yes --link ble")) == AGAINST
    assert "does not answer" in capsys.readouterr().out


def test_monitor_follows_a_hub_at_a_pace_that_can_be_read(designed: Path, capsys: pytest.CaptureFixture[str]) -> None:
    source = designed / "balance.py"
    source.write_text(source.read_text().replace("TELEMETRY = 10 ", "TELEMETRY = 1 "))  # a hundred lines a second
    capsys.readouterr()
    assert main(shlex.split("monitor virtual --program balance.py --seconds 2 -o run.parquet")) == 0
    lines = [line for line in capsys.readouterr().out.splitlines() if "pitch" in line]
    assert 2 < len(lines) <= 30  # a second of a hundred at 20 Hz at most; the computer may be slow, never fast
    assert Path("run.parquet").exists()


def test_monitor_says_why_a_program_stopped_by_itself(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    said = tmp_path / "said.txt"
    said.write_text("".join(f"S {n}*{binascii.crc_hqx(b'S %d' % n, 0xFFFF):04X}\n" for n in (1, 5)))
    assert main(["monitor", str(said)]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.partition(": ")[2] for line in lines if "by itself" in line] == [
        "fallen; its button gives its log",
        "time is over; its button gives its log",
    ]


def test_a_hub_is_followed_from_its_button_to_its_end(made: tuple[Path, Program], hub: VirtualHub) -> None:
    async def put() -> None:
        async with linked(hub, PATIENCE) as link:
            await link.upload(made[0])

    asyncio.run(put())
    looks, lines = list[float](), list[str]()

    def clock() -> float:
        """A clock that stands, and somebody who presses the button at the second look and again two seconds later."""
        looks.append(hub.seconds)
        if len(looks) == 2:
            hub.begin()
        elif hub.seconds > 2.0:
            hub.stop()
        return 0.0

    follow_hub(hub, lines.append, clock=clock, patience=PATIENCE)
    assert len(read_lines(lines).log) > 90  # from the first second to the second
    assert at_rest(hub)


def test_following_a_hub_out_of_reach_ends_in_one_line(made: tuple[Path, Program], hub: VirtualHub) -> None:
    with pytest.raises(HubLost, match="does not answer"):
        follow_hub(
            hub, lambda line: hub.cut(), program=made[0], seconds=5.0, clock=lambda: hub.seconds, patience=PATIENCE
        )
    hub.press()
    assert at_rest(hub)


def test_monitor_wants_to_know_what_a_virtual_hub_runs(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["monitor", "virtual"]) != 0
    assert "--program FILE" in capsys.readouterr().err


def test_a_virtual_flight_of_one_second_ends(designed: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Its still start takes all of it: there is no log, and the reason is said."""
    assert main(shlex.split("fly balance.py controller.json --yes --seconds 0.5")) == 2
    assert "before it balanced" in capsys.readouterr().err


def test_a_device_that_vanishes_is_one_line(tmp_path: Path) -> None:
    """A serial device is a pseudo terminal here; its other end closes, as a cable that is pulled out."""
    import os
    import pty

    ours, theirs = pty.openpty()
    command = [sys.executable, "-m", "upright", "monitor", os.ttyname(theirs)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        os.write(ours, b"hello\n")
        assert process.stdout
        assert process.stdout.readline() == "hello\n"
        os.close(theirs)
        os.close(ours)
        _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 2
    assert len(said.strip().splitlines()) == 1
    assert "is gone" in said
    assert "unexpected" not in said
