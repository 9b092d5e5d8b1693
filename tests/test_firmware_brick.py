"""The virtual NXT brick: it computes as a brick does, nxt-python drives it as it comes, and faults are survived."""

from __future__ import annotations

import math
import re
import struct
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from conftest import PATIENCE
from firmware_cases import frozen, steering, written
from upright.bricks.brick import Hardware, set_readings
from upright.bricks.lcp import VirtualBrick
from upright.bricks.line import Line
from upright.bricks.rxe import InvalidProgram, read_rxe
from upright.bricks.virtual_robot import VirtualFlight, virtual_flight
from upright.bricks.vm import Machine
from upright.compiled.program import Program
from upright.control import CONTROLLERS
from upright.errors import InvalidLog
from upright.execution.execute_nxc import compile_nxc
from upright.experiment import Hold
from upright.firmware import generate
from upright.firmware.targets import COMPASS
from upright.firmware.tools import ExecutionFailed
from upright.flight.flight import Flight, FlightRefused
from upright.flight.fly_nxt import fetch_log, fetch_nxt, fly_nxt
from upright.flight.program_logs import read_brick_log
from upright.links.brick import BrickLost, BrickRefused, Connection
from upright.robots import Kit, Robot

pytestmark = pytest.mark.needs("nbc")

ROBOT, KIT = Robot.preset("nxtway-gs"), Kit.preset("nxt")


def run_nxc(text: str, folder: Path, hardware: Hardware | None = None) -> Hardware:
    """What a program leaves of the brick around it."""
    source = folder / "try.nxc"
    source.write_text(text)
    around = Hardware() if hardware is None else hardware
    machine = Machine(read_rxe(compile_nxc(source, folder)), around, cost=1)
    machine.run(10_000_000)
    assert machine.ended
    return around


def saved(folder: Path, declarations: str, body: str, value: str, hardware: Hardware | None = None) -> bytes:
    """The bytes of `value` as a program writes them into a file."""
    task = f'CreateFile("x.dat", 100, handle); {body} Write(handle, {value});'
    text = f"{declarations} byte handle; task main() {{ {task} }}"
    return bytes(run_nxc(text, folder, hardware).flash.files["x.dat"])


ARITHMETIC = [
    ("float", "", "asm { mov k, 1\n mov w, 3\n div NAME, k, w }", "f", 1 / 3),
    ("long", "", "NAME = 2147483647; NAME += 1;", "i", -(2**31)),  # 32 bits wrap
    ("byte", "", "NAME = 250; NAME += 10;", "B", 4),  # 260 − 256
    ("int", "", "NAME = -7; NAME /= 2;", "h", -3),  # C divides towards zero
    ("unsigned int", "", "NAME = 0; NAME -= 1;", "H", 65535),
    ("int", "byte s[];", "ArrayInit(s, 7, 3); NAME = s[1] + 100 * ArrayLen(s);", "h", 307),
]
"""Type, what else is declared, statements, layout and value of what they leave."""


def test_arithmetic_is_that_of_the_types(tmp_path: Path) -> None:
    """All in one program, since the compiler takes a second for any."""
    names = [f"v{k}" for k in range(len(ARITHMETIC))]
    declared = "".join(f"{kind} {n}; {more} " for n, (kind, more, *_) in zip(names, ARITHMETIC, strict=True))
    body = " ".join(text.replace("NAME", n) for n, (_, _, text, *_) in zip(names, ARITHMETIC, strict=True))
    body += "".join(f" Write(handle, {n});" for n in names[:-1])
    written_bytes = saved(tmp_path, f"float k, w; {declared}", body, names[-1])
    found = struct.unpack("<" + "".join(layout for *_, layout, _ in ARITHMETIC), written_bytes)
    # single precision: 2⁻²⁴ = 6e-8
    assert found == pytest.approx([expected for *_, expected in ARITHMETIC], rel=1e-7)


def test_the_known_fault_of_the_compiler_is_seen_by_running_what_it_made(tmp_path: Path) -> None:
    """After a function that returns a float nbc 1.2.1 loses the battery in `float w = BatteryLevel()/1000.0`, without a
    word; typed temporaries keep it."""
    other = "float r; float f() { float v = 2.0; return v; }"
    lost = "r = f(); float w = BatteryLevel()/1000.0; Write(handle, w);"
    divided = "r = f(); mv = BatteryLevel(); asm { mov v, mv\n mov k, 1000\n div v, v, k }"
    both = saved(tmp_path, f"{other} int mv; float v, k;", lost + divided, "v", charged())
    assert struct.unpack("<ff", both) == pytest.approx((0.002, 7.9), rel=1e-6)  # first what f left behind, over 1000


def charged() -> Hardware:
    hardware = Hardware()
    hardware.battery = 7900  # [mV]
    return hardware


def test_what_the_manual_leaves_open_stops_the_machine(tmp_path: Path) -> None:
    text = """
        float f, g; int a, b; long c; byte s[];
        task main() {
            switch (BatteryLevel()) {
                case 1: a = 5; b = 0; a = a / b; break;
                case 2: asm { mov f, 1\n mov g, 2\n div f, f, g\n mov c, f } break;
                case 3: ArrayInit(s, 0, 3); a = s[4]; break;
            }
        }
    """
    (tmp_path / "try.nxc").write_text(text)
    program = read_rxe(compile_nxc(tmp_path / "try.nxc", tmp_path))
    for battery, says in enumerate(("", "divides 5 by zero", "stored as an integer", "element 4 of 3")):
        hardware = Hardware()
        hardware.battery = battery
        machine = Machine(program, hardware, cost=1)
        if says:
            with pytest.raises(InvalidProgram, match=says):
                machine.run(10_000_000)
        else:
            machine.run(10_000_000)
            assert machine.ended


@pytest.mark.parametrize("data", [b"", b"MZ" + bytes(100), b"MindstormsNXT\0\0\6" + bytes(10)])
def test_what_is_no_program_is_refused_in_one_line(data: bytes) -> None:
    with pytest.raises(InvalidProgram, match=r"not a program|cut short") as caught:
        read_rxe(data)
    assert "\n" not in str(caught.value)


def test_every_truncation_of_a_program_is_refused_or_harmless(tmp_path: Path) -> None:
    source = tmp_path / "a.nxc"
    source.write_text("task main() { int a; a = 3; PlayTone(440, a); }")
    whole = compile_nxc(source, tmp_path).read_bytes()
    for length in range(len(whole)):
        with pytest.raises(InvalidProgram):
            read_rxe(whole[:length])


@pytest.mark.needs("module:nxt")
def test_nxt_python_as_it_comes_keeps_files_and_runs_programs(tmp_path: Path) -> None:
    source = tmp_path / "tone.nxc"
    source.write_text('task main() { byte h; CreateFile("out.txt", 3, h); long v; v = 77; fputc(v, h); Wait(500); }')
    binary = compile_nxc(source, tmp_path).read_bytes()
    brick = VirtualBrick()
    with Line(brick) as line, Connection(line.path) as found:
        found.upload("tone.rxe", binary)
        assert found.fetch("tone.rxe") == binary
        assert found.ask("files") == [["tone.rxe", len(binary)]]
        assert found.ask("battery") == brick.hardware.battery
        found.ask("start", name="tone.rxe")
        while found.ask("running"):
            pass
        assert found.fetch("out.txt") == b"M"  # 77
        with pytest.raises(BrickRefused, match="not found"):
            found.fetch("nothing.txt")
        with pytest.raises(BrickRefused, match="start"):
            found.ask("start", name="nothing.rxe")


READ_COMPASS = """
import sys, nxt.locator, nxt.sensor, nxt.sensor.hitechnic
brick = nxt.locator.find(config=None, backends=["devfile"], filename=sys.argv[1])
print(nxt.sensor.hitechnic.Compass(brick, nxt.sensor.Port.S2, False).get_heading())
"""


@pytest.mark.needs("module:nxt")
@pytest.mark.parametrize("heading", [0, 1, 258, 359])
def test_nxt_python_s_own_compass_reads_the_virtual_one(heading: int) -> None:
    """What HiTechnic's registers hold is taken from nxt-python here, and not from this project."""
    brick = VirtualBrick()
    resting = {"sensor/encoder_left": 0.0, "sensor/encoder_right": 0.0, "sensor/gyro": 0.0, "sensor/battery": 8000.0}
    set_readings(brick.hardware, resting | {COMPASS: float(heading)})
    with Line(brick) as line:
        command = [sys.executable, "-c", READ_COMPASS, line.path]
        said = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE)
    assert said.stdout.strip() == str(heading), said.stderr


def test_hostile_telegrams_never_stop_the_brick() -> None:
    brick, rng = VirtualBrick(), np.random.Generator(np.random.Philox(3))
    for _ in range(5000):
        reply = brick.telegram(rng.bytes(int(rng.integers(0, 40))))
        assert reply == b"" or reply[0] == 2
    assert brick.telegram(bytes([0, 0x0B]))[2] == 0  # it still tells its battery


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Program]:
    """A balancing program for the NXT, as text and as what it was printed from."""
    controller = CONTROLLERS["lqg"](ROBOT, KIT, KIT.period)
    firmware = generate(controller, ROBOT, KIT, "nxc")
    source = tmp_path_factory.mktemp("nxc") / "balance.nxc"
    source.write_text(firmware.text)
    return source, firmware.program


@pytest.fixture
def virtual(made: tuple[Path, Program]) -> Iterator[VirtualFlight]:
    with virtual_flight(ROBOT, KIT, [Hold(pitch=0.1, until=1.0)]) as found:
        yield found


@pytest.mark.needs("module:nxt")
def test_a_flight_brings_its_log_home(made: tuple[Path, Program], virtual: VirtualFlight) -> None:
    virtual.line.until = 2.5
    flight = fly_nxt(*made, virtual.path, 2.5, clock=virtual.clock)
    assert flight.log is not None
    log, pitch = flight.log.log, flight.log.log["estimate/pitch"]
    assert flight.notes == []
    assert log.origin["controller"]["hash"] == made[1].hash
    assert log.t[-1] == pytest.approx(2.5 - 1.0, abs=0.1)  # a second of it is the still start
    assert 0.05 < np.abs(pitch).max() < 0.3  # a hold at 0.1 rad, overshot by half
    assert not virtual.robot.world.fallen
    assert motors_are_off(virtual)


@pytest.mark.needs("module:nxt")
@pytest.mark.parametrize("gain", [pytest.param(0.0, marks=pytest.mark.evidence), 2.0])
def test_the_compass_steers_the_robot(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, gain: float) -> None:
    """North moves by 40° while it stands, as beside a magnet; a robot that steers by the compass turns after it."""
    source, made = written(tmp_path, "nxc", controller=steering(gain))
    with virtual_flight(ROBOT, KIT) as found:
        world, truly = found.robot.world, found.robot.world.raw
        bent = lambda: {**(raw := truly()), COMPASS: (raw[COMPASS] + 40 * (found.clock() > 1.5)) % 360}  # noqa: E731
        monkeypatch.setattr(world, "raw", bent)
        found.line.until = 3.0
        flight = fly_nxt(source, made.program, found.path, 3.0, clock=found.clock)
        assert flight.notes == []
        assert not world.fallen
        if gain:
            assert world.yaw > 0.1  # the compass says 40° clockwise, so it turns anticlockwise until encoders hold it
        else:
            assert abs(world.yaw) < 0.02


@pytest.mark.needs("module:nxt")
def test_a_pulled_cable_ends_with_the_motors_off_and_a_whole_log(tmp_path: Path, virtual: VirtualFlight) -> None:
    """Nobody touches the brick: its longest run ends it, and the next connection brings everything."""
    source, made = written(tmp_path, "nxc", seconds=1)
    virtual.line.until = 1.7
    flight = fly_nxt(source, made.program, virtual.path, 2.0, progress=pull_after(virtual, 1.4), clock=virtual.clock)
    assert flight.lost
    assert flight.notes[0].startswith("motors may be running: ")
    assert "stops after 1 s at most" in flight.notes[0]
    assert "--fetch" in flight.notes[-1]
    assert not motors_are_off(virtual)
    virtual.line.until = math.inf
    goes_on(virtual)
    assert motors_are_off(virtual)
    later = fetched(virtual, (source, made.program))
    assert later.log is not None
    assert (later.log.ended, later.log.flaws) == ("time is over", ())
    # its own clock, which counts milliseconds
    assert later.log.log.t == pytest.approx(0.01 * np.arange(len(later.log.log)), abs=0.00101)
    assert len(later.log.log) in (100, 101)  # 1 s of 10 ms, and one more where the clock was read before its end


@pytest.mark.needs("module:nxt")
def test_who_fetches_the_log_of_a_program_that_still_runs_stops_it(
    made: tuple[Path, Program], virtual: VirtualFlight, tmp_path: Path
) -> None:
    virtual.line.until = 1.5
    with Connection(virtual.path) as brick:
        brick.upload("balance.rxe", compile_nxc(made[0], tmp_path).read_bytes())
        brick.ask("start", name="balance.rxe")
        while virtual.clock() < virtual.line.until:
            time.sleep(0.01)
    assert not motors_are_off(virtual)
    found = fetch_nxt(*made, virtual.path)
    assert motors_are_off(virtual)
    assert found.notes == ["the program still ran; it was stopped"]
    assert found.log is not None
    assert found.log.log.t[-1] == pytest.approx(0.5, abs=0.05)  # of the 1.5 s one is the still start


@pytest.mark.needs("module:nxt")
def test_its_button_ends_a_run_without_a_cable(made: tuple[Path, Program], virtual: VirtualFlight) -> None:
    fly_nxt(*made, virtual.path, 30.0, progress=pull_after(virtual, 1.3), clock=virtual.clock)
    press_button(virtual)
    assert motors_are_off(virtual)
    assert fetched(virtual, made).log is not None


@pytest.mark.needs("module:nxt")
def test_a_silent_brick_is_given_up(virtual: VirtualFlight) -> None:
    with Connection(virtual.path) as brick:
        assert brick.ask("battery") > 0
        virtual.brick.silent = True
        brick._patience = 0.2  # pyright: ignore[reportPrivateUsage]
        with pytest.raises(BrickLost, match="does not answer"):
            brick.ask("battery")


@pytest.mark.needs("module:nxt")
@pytest.mark.parametrize(
    ("fault", "said"),
    [("flat", "the battery gives 5.5 V"), ("unplugged", "input 1 reads 1023"), ("firmware", "firmware is 1.5")],
)
def test_what_is_not_ready_is_not_driven(
    made: tuple[Path, Program], virtual: VirtualFlight, monkeypatch: pytest.MonkeyPatch, fault: str, said: str
) -> None:
    hardware = virtual.brick.hardware
    hardware.world = None  # nothing moves before the start
    if fault == "flat":
        hardware.battery = 5500
    elif fault == "unplugged":
        hardware.inputs[0].raw = 1023
    else:
        monkeypatch.setattr("upright.bricks.lcp.FIRMWARE", (5, 1))
    with pytest.raises(FlightRefused, match=said):
        fly_nxt(*made, virtual.path, 3.0, clock=virtual.clock)
    assert virtual.brick.machine is None
    assert motors_are_off(virtual)


@pytest.mark.evidence
@pytest.mark.needs("module:nxt")
def test_a_log_that_does_not_fit_is_reported_before_the_start(tmp_path: Path, virtual: VirtualFlight) -> None:
    """60 s are 6000 rows of 8 integers and a head; the hint fits, and what the last log takes counts as free."""
    source, made = written(tmp_path, "nxc", seconds=60)
    flash = virtual.brick.hardware.flash
    program = len(compile_nxc(source, tmp_path).read_bytes())
    flash.capacity = 50_000 + program
    flash.create("music.rso", 10_000)
    with pytest.raises(FlightRefused, match=r"6000 rows, 96200 bytes, and the brick has 40000 free") as caught:
        fly_nxt(source, made.program, virtual.path, 1.0, clock=virtual.clock)
    assert "\n" not in str(caught.value)
    assert "upright firmware --seconds 24" in str(caught.value)  # 24 s · 100 rows/s · 16 bytes + 200 = 38600
    assert virtual.brick.machine is None
    assert motors_are_off(virtual)
    flash.create("balance.log", 39_400)
    with pytest.raises(FlightRefused, match="40000 free"):
        fly_nxt(source, made.program, virtual.path, 1.0, clock=virtual.clock)
    shorter, made = written(tmp_path, "nxc", seconds=24)
    virtual.line.until = 1.5
    assert fly_nxt(shorter, made.program, virtual.path, 1.5, clock=virtual.clock).log is not None


@pytest.mark.needs("module:nxt")
@pytest.mark.parametrize(
    "name",
    [*(pytest.param(n, marks=pytest.mark.evidence) for n in ("nxtway-gs-measured", "x" * 40)), "Ñandú verde 2.0 ñññ"],
)
def test_the_log_has_a_name_that_a_brick_keeps_whatever_the_robot_is_called(
    tmp_path: Path, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A brick's names are 15.3 characters of ASCII (LEGO, "NXT Communication Protocol", appendix 1)."""
    monkeypatch.setattr("upright.firmware.readings.CALIBRATION_TIME", 0.1)  # it balances sooner
    firmware = generate(frozen(), ROBOT.replace(name=name), KIT, "nxc")
    source = firmware.write(tmp_path / "a program with a long name.nxc")[0]
    brick = VirtualBrick()
    brick.hardware.inputs[0].raw = 600
    with Line(brick) as line:
        flight = fly_nxt(source, firmware.program, line.path, 0.4, clock=lambda: brick.seconds)
    assert all(re.fullmatch(r"[\w-]{1,15}\.\w{1,3}", stored, re.ASCII) for stored in brick.hardware.flash.files)
    assert flight.log is not None
    assert flight.log.log.origin["robot"]["name"] == name


def test_a_brick_refuses_a_name_that_does_not_fit() -> None:
    """Status 0x92, "illegal file name"."""
    assert VirtualBrick().telegram(b"\x01\x81" + b"sixteen-letters-.log".ljust(20, b"\0") + bytes(4))[2] == 0x92


def test_a_brick_that_is_not_there_is_one_line() -> None:
    with pytest.raises(BrickLost, match=r"no brick at /dev/nothing") as caught:
        Connection("/dev/nothing")
    assert "\n" not in str(caught.value)


def test_a_program_that_goes_wrong_ends_with_its_motors_off(tmp_path: Path) -> None:
    source = tmp_path / "bad.nxc"
    source.write_text("task main() { int a, b; OnFwd(OUT_B, 50); a = 1; b = 0; Wait(10); a = a / b; }")
    brick = VirtualBrick()
    brick.hardware.flash.create("bad.rxe", 4000)
    brick.hardware.flash.files["bad.rxe"] += compile_nxc(source, tmp_path).read_bytes()
    brick.start("bad.rxe")
    brick.run(0.005)
    assert brick.hardware.motors[1].duty == 50
    brick.run(1.0)
    assert "by zero" in brick.failure
    assert [m.duty for m in brick.hardware.motors] == [0, 0, 0]


HEAD = b"robot=nxtway-gs;kit=nxt;hash=00;period=0.01;every=1\r\n"


def test_a_log_that_breaks_off_keeps_its_whole_rows() -> None:
    rows = b"".join(struct.pack("<8h", k, k, 1000, 0, 8000, 50, -50, 12 * k) for k in range(10))
    found = read_brick_log(HEAD + rows[:-5])
    assert (len(found.log), found.ended) == (9, "")
    assert found.flaws[0] == "the log breaks off in a row; its 9 whole rows are kept"
    assert found.log.t == pytest.approx(0.012 * np.arange(9))  # the brick's own clock, not row × period
    assert "8 of 8 rows came late" in found.flaws[1]
    assert found.log["sensor/gyro"][0] == 1.0  # 1000 mrad/s
    assert found.log["applied/left"][0] == 4.0  # half of 8 V
    assert found.log["sensor/encoder_left"][3] == pytest.approx(math.radians(3))


def test_encoder_counts_go_on_beyond_their_sixteen_bits() -> None:
    counts = [32766, 32767, -32768, -32767]
    data = HEAD + b"".join(struct.pack("<8h", c, c, 0, 0, 8000, 0, 0, 10 * k) for k, c in enumerate(counts))
    assert np.diff(read_brick_log(data).log["sensor/encoder_left"]) == pytest.approx([math.radians(1)] * 3)


def test_a_clock_of_sixteen_bits_goes_on_after_its_end() -> None:
    stamps = [65516, 65526, 0, 10]
    data = HEAD + b"".join(struct.pack("<7hH", 0, 0, 0, 0, 8000, 0, 0, stamp) for stamp in stamps)
    assert np.diff(read_brick_log(data).log.t) == pytest.approx([0.01] * 3)


def test_rows_of_one_millisecond_follow_each_other_within_it() -> None:
    """A row that is a period late is followed at once by the next."""
    data = HEAD + b"".join(struct.pack("<7hH", 0, 0, 0, 0, 8000, 0, 0, stamp) for stamp in (0, 10, 30, 30, 40))
    assert read_brick_log(data).log.t == pytest.approx([0, 0.01, 0.03, 0.0305, 0.04])


@pytest.mark.parametrize("data", [b"", b"garbage", HEAD, HEAD + bytes(16), bytes(1000)])
def test_what_is_no_log_is_one_line(data: bytes) -> None:
    with pytest.raises(InvalidLog) as caught:
        read_brick_log(data)
    assert "\n" not in str(caught.value)


def test_a_log_of_another_controller_is_noted(made: tuple[Path, Program]) -> None:
    class Brick:
        def ask(self, request: str) -> list[list[object]]:
            assert request == "files"
            return [["balance.log", 1]]

        def fetch(self, name: str) -> bytes:
            return HEAD + b"".join(struct.pack("<8h", 0, 0, 0, 0, 8000, 0, 0, 10 * k) for k in range(3))

    flight = Flight()
    fetch_log(Brick(), made[0].read_text(), made[1], flight)  # type: ignore[arg-type]
    assert "another controller" in flight.notes[0]
    assert flight.log is not None  # kept all the same


def test_text_that_does_not_compile_is_one_line(tmp_path: Path, made: tuple[Path, Program]) -> None:
    source = tmp_path / "bad.nxc"
    source.write_text("task main() { nonsense }")
    with pytest.raises(ExecutionFailed, match="nbc cannot build"):
        fly_nxt(source, made[1], "usb", 1.0)


def test_the_library_under_the_gpl_is_loaded_by_its_own_process_only() -> None:
    code = "import sys, upright.flight.fly_nxt, upright.cli.fly; sys.exit('nxt' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


def motors_are_off(virtual: VirtualFlight) -> bool:
    return all(motor.mode == 0 for motor in virtual.brick.hardware.motors)


def pull_after(virtual: VirtualFlight, seconds: float) -> object:
    """Progress that pulls the cable when the brick's clock passes `seconds`."""

    def progress(share: float) -> None:
        if virtual.clock() > seconds:
            virtual.line.cut()

    return progress


def fetched(virtual: VirtualFlight, made: tuple[Path, Program]) -> Flight:
    """What a new connection to that brick brings home."""
    flight = Flight()
    with Line(virtual.brick) as line, Connection(line.path) as brick:
        fetch_log(brick, made[0].read_text(), made[1], flight)
    return flight


def press_button(virtual: VirtualFlight) -> None:
    """The orange one in the middle."""
    virtual.brick.hardware.buttons.add(3)
    goes_on(virtual)


def goes_on(virtual: VirtualFlight) -> None:
    """Until the brick's program has ended by itself."""
    while virtual.brick.machine is not None:
        time.sleep(0.01)


def test_without_pseudo_terminals_a_virtual_brick_says_so_in_one_line(monkeypatch):
    """As on Windows, which lacks the modules."""
    from upright.bricks.lcp import VirtualBrick
    from upright.bricks.line import Line
    from upright.errors import MissingTool

    monkeypatch.setitem(sys.modules, "pty", None)  # which an import takes for a module that is not there
    with pytest.raises(MissingTool, match=r"pseudo-terminal.*try: .*parity"):
        Line(object.__new__(VirtualBrick))


def test_a_limit_of_memory_that_the_system_refuses_is_no_error(monkeypatch):
    import resource

    from upright.reading import limit_memory

    def refuse(*_: object) -> None:
        raise ValueError("current limit exceeds maximum limit")  # what macOS says

    monkeypatch.setattr(resource, "setrlimit", refuse)
    limit_memory(1 << 30)
