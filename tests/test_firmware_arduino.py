"""A sketch with Arduino's own core on a simulated Uno: whatever becomes of its sensor, its bus or its processor, the
motors do not run on."""

from __future__ import annotations

import binascii
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

from firmware_cases import NXT, STILL, brief
from planted.uno import ABSENT, HUNG, LED, PRESENT, level, output, pwm, run_for
from upright.control import lqg
from upright.errors import SpecMismatch
from upright.execution.execute_sketch import BUTTON, CONDITION, CORE, GYRO, IDENTITY, POWER, SketchExecutor
from upright.execution.executed import Readings
from upright.firmware import Firmware, generate
from upright.firmware.setup import SENSOR_FAILED
from upright.robots import Kit, Robot

pytestmark = pytest.mark.needs("avr-gcc", "simavr", "module:elftools", str(CORE))

PERIOD = 160_000  # [cycles] of 10 ms
LATEST = 0.1  # [s] until the motors are off: ten periods


@pytest.fixture(scope="module")
def sketch(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Firmware]:
    return brief(tmp_path_factory.mktemp("sketch"), "arduino")


def edited(sketch: tuple[Path, Firmware], folder: Path, old: str, new: str) -> tuple[Path, Firmware]:
    text = sketch[0].read_text("utf-8")
    assert text.count(old) == 1, old
    path = folder / "edited.ino"
    path.write_text(text.replace(old, new), "utf-8")
    return path, sketch[1]


def balancing(sketch: tuple[Path, Firmware]) -> SketchExecutor:
    """A sketch whose motors run: calibrated, leaning, its time not leapt over from then on."""
    source, made = sketch
    executor, readings = SketchExecutor(source, made.program, made.number), Readings(made.program, NXT)
    for raw in readings.still(STILL):
        executor.step(raw)
    for k in range(1, 6):
        executor.step(readings.raw({"sensor/encoder_left": 0.02 * k, "sensor/encoder_right": 0.02 * k}))
    assert executor.results()["status"] == 0
    assert level(executor, LED)
    assert all(pwm(executor))
    executor.real = True
    return executor


def last_words(executor: SketchExecutor) -> str:
    """The last line, without the check that the standard library agrees with."""
    run_for(executor, 0.02)
    text, _, crc = output(executor)[-1].rpartition("*")
    assert int(crc, 16) == binascii.crc_hqx(text.encode(), 0xFFFF)
    return text


@pytest.mark.parametrize(("what", "value"), [(CONDITION, ABSENT), (CONDITION, HUNG), (IDENTITY, 0xFF)])
def test_a_missing_sensor_never_balances(sketch: tuple[Path, Firmware], what: int, value: int) -> None:
    """Nothing at its address, a bus that never answers, or something else that says ones for everything."""
    executor = SketchExecutor(sketch[0], sketch[1].program, sketch[1].number, real=True)
    executor.set_input(what, value)
    executor.set_input(GYRO, -1)
    run_for(executor, 0.4)  # more than a start takes
    assert not level(executor, LED)
    assert pwm(executor) == [0, 0]
    assert last_words(executor) == f"E {SENSOR_FAILED}"
    executor.set_input(what, 0x68 if what == IDENTITY else PRESENT)
    run_for(executor, 0.4)
    assert not level(executor, LED)  # until somebody presses RESET
    executor.close()


@pytest.mark.parametrize(
    ("what", "value"), [(CONDITION, HUNG), (CONDITION, ABSENT), (POWER, 0)], ids=["hung", "absent", "reset"]
)
def test_a_sensor_lost_in_a_run_stops_the_motors_or_is_started_anew(
    sketch: tuple[Path, Firmware], what: int, value: int
) -> None:
    executor = balancing(sketch)
    executor.set_input(what, value)
    run_for(executor, LATEST)
    if what == POWER:  # it answers, but sleeps until it has its settings again
        assert level(executor, LED)
        assert executor.results()["status"] == 0
    else:
        assert pwm(executor) == [0, 0]
        assert not level(executor, LED)
        assert last_words(executor) == f"E {SENSOR_FAILED}"
        executor.set_input(CONDITION, PRESENT)
        run_for(executor, LATEST)
        assert pwm(executor) == [0, 0]
    executor.close()


def test_every_line_of_telemetry_has_its_own_time(sketch: tuple[Path, Firmware]) -> None:
    """Ten periods of 10 ms from one to the next, by the cycles of the simulated processor."""
    executor = balancing(sketch)
    run_for(executor, 0.45)
    lines = [line.partition("*")[0].split() for line in output(executor) if line.startswith("T")]
    assert all(len(words) == 7 for words in lines)
    assert len(lines) >= 3
    periods = {(int(b[1]) - int(a[1])) * 10 - (int(b[-1]) - int(a[-1])) for a, b in pairwise(lines)}
    assert periods <= {-1, 0, 1}  # [ms]
    executor.close()


def test_a_bus_that_hangs_for_a_moment_is_survived(sketch: tuple[Path, Firmware]) -> None:
    """Two periods without a reading, less than the three that are allowed."""
    executor = balancing(sketch)
    executor.set_input(CONDITION, HUNG)
    run_for(executor, 0.02)
    executor.set_input(CONDITION, PRESENT)
    run_for(executor, LATEST)
    assert executor.results()["status"] == 0
    assert level(executor, LED)
    executor.close()


def test_the_button_works_while_the_bus_hangs(sketch: tuple[Path, Firmware], tmp_path: Path) -> None:
    patient = edited(sketch, tmp_path, "#define MISSES 3 ", "#define MISSES 200 ")
    executor = balancing(patient)
    executor.set_input(CONDITION, HUNG)
    run_for(executor, 0.03)
    assert level(executor, LED)
    executor.set_input(BUTTON, 1)
    run_for(executor, 0.03)
    assert pwm(executor) == [0, 0]
    executor.close()


def test_a_loop_that_hangs_is_ended_by_the_watchdog(sketch: tuple[Path, Firmware], tmp_path: Path) -> None:
    """With interrupts off as well the processor's next time-out is a reset, which simavr does not know."""
    executor = balancing(edited(sketch, tmp_path, "        count++;\n", "        if (++count == 8) for (;;) ;\n"))
    run_for(executor, 0.2)
    assert pwm(executor) == [0, 0]
    assert not level(executor, LED)
    executor.close()


def test_after_a_stall_no_period_is_shorter(sketch: tuple[Path, Firmware], tmp_path: Path) -> None:
    stalling = edited(sketch, tmp_path, "        count++;\n", "        if (++count == 8) delay(26);\n")
    executor = balancing(stalling)
    begun = [executor.period()[0] for _ in range(12)]
    periods = [(b - a) / PERIOD for a, b in pairwise(begun)]
    assert max(periods) > 2.5  # the stall
    assert min(periods) > 0.87  # a period later than an eighth begins anew
    assert periods[-1] == pytest.approx(1.0, abs=0.01)
    executor.close()


def test_a_sketch_is_executed_with_the_pins_that_it_names(sketch: tuple[Path, Firmware], tmp_path: Path) -> None:
    """Motors on other pins, encoders on each other's, a gyro the other way round: the same duties."""
    text = sketch[0].read_text("utf-8")
    pins = {"LEFT_ENCODER_A": 3, "RIGHT_ENCODER_A": 2, "LEFT_ENCODER_B": 12, "RIGHT_ENCODER_B": 17, "LEFT_PWM": 11}
    for name, pin in (pins | {"LEFT_BACK": 8, "LEFT_FORWARD": 5, "RIGHT_FORWARD": 7, "GYRO_SIGN": -1}).items():
        old = next(line for line in text.splitlines() if line.startswith(f"#define {name} "))
        text = text.replace(old, f"#define {name} {pin}")
    other = tmp_path / "other.ino"
    other.write_text(text, "utf-8")
    outputs: list[object] = []
    for path in (sketch[0], other):
        executor, readings = SketchExecutor(path, sketch[1].program, "float"), Readings(sketch[1].program, NXT)
        for raw in readings.still(STILL):
            executor.step(raw)
        turned = [readings.raw({"sensor/encoder_left": -0.02 * k, "sensor/gyro": 0.1}, 3.0) for k in range(12)]
        outputs.append([(dict(executor.step(raw)), pwm(executor)) for raw in turned])
        executor.close()
    assert outputs[0] == outputs[1]


def test_steppers_turn_as_they_are_commanded(tmp_path: Path) -> None:
    """Against the ramp of the preset, 200 rad/s², computed here from the commands that the sketch says it gave."""
    robot, kit = Robot.preset("stepper"), Kit.preset("stepper")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("upright.firmware.readings.CALIBRATION_TIME", 0.05)
        made = generate(lqg(robot, kit), robot, kit, "arduino", seconds=0)
    made.write(tmp_path / "steps.ino")
    executor = SketchExecutor(tmp_path / "steps.ino", made.program, made.number, real=True)
    step, enable, asked = 6.283185307 / 3200, 8, 0.0
    for _ in range(30):
        executor.period()
        if level(executor, LED):
            break
    assert level(executor, LED)
    executor.set_input(GYRO, round(0.02 * 65.5 * 57.29578))  # it falls forward with 0.02 rad/s, whatever it does
    expected, speed, now = 0.0, 0.0, 0
    for _ in range(60):
        began, took = executor.period()
        command = executor.results()["applied_left"]
        before = now or began + took
        now = began + took
        for _ in range(round((now - before) / 1600)):  # tenths of a millisecond
            speed += max(-0.02, min(0.02, asked - speed))
            expected += 0.0001 * speed
        asked = command
        left, right = (executor.read(executor.symbols[f"encoder_{side}"], "i")[0] for side in ("left", "right"))
        # up to 1 ms until the ramp's next tick, the tenths in which the time is counted here, and the step under way
        assert abs(left * step - expected) < 0.0015 * abs(speed) + 2 * step
        assert abs(left - right) <= 1
    assert speed == 20
    assert not level(executor, enable)  # LOW switches the drivers on
    executor.set_input(BUTTON, 1)
    run_for(executor, 0.02)
    assert level(executor, enable)
    executor.close()


def test_steps_faster_than_a_sketch_makes_them_are_refused() -> None:
    robot, kit = Robot.preset("stepper"), Kit.preset("stepper")
    finer = replace(kit, sensors={n: replace(s, quantum=s.quantum / 4) for n, s in kit.sensors.items()})
    with pytest.raises(SpecMismatch, match="20 rad/s are 40744 steps a second; expected at most 12500"):
        generate(lqg(robot, kit), robot, finer, "arduino")
    with pytest.raises(SpecMismatch, match="'stepper' is commanded in rad/s"):
        generate(lqg(robot, kit), robot, kit, "pybricks")
