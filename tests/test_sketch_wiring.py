"""A sketch counts, drives and measures what its kit says of encoders, driver and battery: encoders are discs here,
whose two channels switch as the wheel turns, and what a motor gets is read from the levels of its driver's pins."""

from __future__ import annotations

import json
import math
import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from firmware_cases import GOLDEN, NXT, ROBOT, STILL, brief, frozen
from planted.uno import HUNG, LED, level, pwm, run_for
from upright.bodies import Electronics, make_body
from upright.cli.main import USER_ERROR, main
from upright.control import lqg
from upright.control.controller import Controller
from upright.errors import InvalidRobot, SpecMismatch
from upright.execution.execute_sketch import BUTTON, CONDITION, CORE, LEFT, RIGHT, SketchExecutor
from upright.execution.executed import Executed, Readings
from upright.execution.executor import Values
from upright.experiment import Impulse, run
from upright.firmware import Firmware, generate, trace
from upright.firmware.setup import SENSOR_FAILED
from upright.firmware.sketch_wiring import sketch_wiring
from upright.robots import Battery, BoardWiring, Kit, Robot, Sensor
from upright.robots.facts import kit_facts

on_an_uno = pytest.mark.needs("avr-gcc", "simavr", "module:elftools", str(CORE))

PULSES = 374  # of one channel in a turn of the wheel: 11 of the motor's magnet, geared by 34
EDGES = 4 * PULSES
DRIVERS = {  # every pin that can make a motor turn
    "one-pin": (5, 6, 9, 10),
    "two-pin": (5, 6, 9, 10, 11, 12),
    "pwm-enable": (5, 6, 9, 10, 12),
}
SKETCHES = pytest.mark.parametrize("driver", DRIVERS)


def counting(counts: float, **wiring: object) -> Kit:
    """NXT's electronics with encoders of that many counts a turn."""
    sensors = {n: replace(s, quantum=math.tau / counts) if "encoder" in n else s for n, s in NXT.sensors.items()}
    return replace(NXT, name="own", sensors=sensors, wiring=BoardWiring(**wiring))  # type: ignore[arg-type]


def sketch(folder: Path, kit: Kit, *edits: tuple[str, str]) -> tuple[SketchExecutor, Firmware]:
    source, made = brief(folder, "arduino", kit)
    text = source.read_text("utf-8")
    for old, new in edits:
        assert text.count(old) == 1, old
        text = text.replace(old, new)
    source.write_text(text, "utf-8")
    return SketchExecutor(source, made.program, made.number), made


def counts(executor: SketchExecutor) -> list[int]:
    return [executor.read(executor.symbols[f"encoder_{side}"], "i")[0] for side in ("left", "right")]


@on_an_uno
@pytest.mark.parametrize("decoding", [1, 2, 4])
def test_an_angle_is_counted_as_that_angle(tmp_path: Path, decoding: int) -> None:
    """Forwards and back, the two wheels apart: within one count of the angle, and exactly back where it began."""
    executor, made = sketch(tmp_path, counting(decoding * PULSES, decoding=decoding))
    scales = [made.program.scales[f"raw_encoder_{side}"] for side in ("left", "right")]
    for left, right in ((1.0, -0.3), (3.0, -2.0), (-0.7, 1.1), (-0.701, 1.101), (0.0, 0.0)):  # [rad]
        for what, angle in ((LEFT, left), (RIGHT, right)):
            executor.set_input(what, math.floor(angle / math.tau * EDGES))
        run_for(executor, 0.08)  # an edge each 1000 cycles of 16 MHz: 1280, for at most 883
        for count, scale, angle in zip(counts(executor), scales, (left, right), strict=True):
            assert abs(count * scale - angle) <= math.tau / (decoding * PULSES)
    assert counts(executor) == [0, 0]
    executor.close()


@on_an_uno
@pytest.mark.parametrize("decoding", [1, 2, 4])
def test_a_wheel_that_rocks_over_one_edge_does_not_count_up(tmp_path: Path, decoding: int) -> None:
    """As every standing robot does; over each of the four edges of a pulse."""
    executor, _ = sketch(tmp_path, counting(decoding * PULSES, decoding=decoding))
    for place in range(4):
        for k in range(12):
            executor.set_input(LEFT, place + k % 2)
            run_for(executor, 0.001)
        assert abs(counts(executor)[0] * 4 / decoding - place) <= 4  # within a pulse
    executor.set_input(LEFT, 0)
    run_for(executor, 0.001)
    assert counts(executor)[0] == 0
    executor.close()


class Disc(SketchExecutor):
    """A sketch whose wheels carry discs of `PULSES`, whatever the sketch says of them."""

    step_of_kit = math.tau / EDGES  # [rad] of a raw count of the kit's

    def set_input(self, what: int, value: int) -> None:
        if what in (LEFT, RIGHT):
            value = round(self._counts[what] * self.step_of_kit / math.tau * EDGES)
        super().set_input(what, value)

    def step(self, raw: Values) -> Values:
        self._counts = {LEFT: raw["raw_encoder_left"], RIGHT: raw["raw_encoder_right"]}
        return super().step(raw)


def knocked(robot: Robot, kit: Kit, controller: Controller) -> float:
    """Largest pitch [rad] after a knock of 0.05 N s."""
    plant = Electronics(make_body("nonlinear", robot), kit)
    log = run(plant, controller, [Impulse(impulse=0.05, start=0.1)], seconds=0.8, seed=1)
    plant.close()
    return float(np.abs(log["truth/pitch"]).max())


@on_an_uno
@pytest.mark.needs("shared/cases/hand-pushed")
def test_the_sketch_of_an_own_robot_answers_a_knock_as_its_design(tmp_path: Path) -> None:
    """With half the angle the pitch peaks a third higher; with the angle itself only duties round, to 1/255."""
    cases = Path(__file__).parents[2] / "shared" / "cases" / "hand-pushed"
    for name in ("nano.toml", "mine2.toml"):
        shutil.copy(cases / name, tmp_path / name)
    robot = Robot.load(tmp_path / "mine2.toml")
    kit = Kit.load(tmp_path / "nano.toml")
    design = lqg(robot, kit)
    made = generate(design, robot, kit, "arduino")
    executor = Disc(made.write(tmp_path / "balance.ino")[0], made.program, made.number)
    peak = knocked(robot, kit, Executed(executor, made.program, kit, design))
    executor.close()
    assert peak == pytest.approx(knocked(robot, kit, lqg(robot, kit)), rel=0.1)


def balancing(executor: SketchExecutor, made: Firmware, kit: Kit, turn: float = 0.02) -> None:
    """Calibrated, and leaning so that both motors run."""
    readings = Readings(made.program, kit)
    for raw in readings.still(STILL):
        executor.step(raw)
    for k in range(1, 6):
        executor.step(readings.raw({"sensor/encoder_left": turn * k, "sensor/encoder_right": turn * k}))
    assert level(executor, LED)


@on_an_uno
@SKETCHES
@pytest.mark.parametrize("turn", [0.02, -0.02])
def test_a_driver_turns_its_motors_as_the_program_commands(tmp_path: Path, driver: str, turn: float) -> None:
    kit = counting(360, driver=driver)
    executor, made = sketch(tmp_path, kit)
    balancing(executor, made, kit, turn)
    out = executor.results()
    assert out["duty_left"]
    assert pwm(executor) == [out["duty_left"], out["duty_right"]]
    executor.close()


SHORTER = (("count == SECONDS * 1000000", "count == SECONDS * 1333"),)  # of 60 s: eight periods
STOPS = {
    "button": ((), BUTTON, 1),
    "sensor": ((), CONDITION, HUNG),
    "hangs": ((("        count++;\n", "        if (++count == 8) for (;;) ;\n"),), LEFT, 0),
    "time": (SHORTER, LEFT, 0),
}


@on_an_uno
@pytest.mark.parametrize(
    ("stop", "driver"), [*((stop, "one-pin") for stop in STOPS), ("time", "two-pin"), ("time", "pwm-enable")]
)
def test_every_stop_leaves_every_pin_of_a_driver_low(tmp_path: Path, driver: str, stop: str) -> None:
    edits, what, value = STOPS[stop]
    kit = counting(360, driver=driver)
    executor, made = sketch(tmp_path, kit, *edits)
    balancing(executor, made, kit)
    assert any(pwm(executor))
    executor.real = True
    if value:
        executor.set_input(what, value)
    run_for(executor, 0.1)  # ten periods
    assert pwm(executor) == [0, 0]
    assert not any(level(executor, pin) for pin in DRIVERS[driver])
    assert not level(executor, LED)
    assert stop != "sensor" or executor.results()["status"] == SENSOR_FAILED
    executor.close()


def test_the_battery_is_measured_by_the_divider_of_the_kit() -> None:
    for divider, steps in ((3.2, 16.0 / 1023), (2.0, 10.0 / 1023), (0.0, 15.0 / 1023)):  # ten bits of 5 V; 3 assumed
        made = trace(frozen(), ROBOT, replace(NXT, wiring=BoardWiring(battery_divider=divider)), "arduino")
        assert made.scales["raw_battery"] == pytest.approx(steps)


@pytest.mark.parametrize(("volts", "divider"), [(14.8, 0.0), (14.8, 3.0), (7.4, 1.0)])
def test_a_full_battery_never_puts_more_on_a_pin_than_it_stands(volts: float, divider: float) -> None:
    """Four lithium cells are 16.8 V when full: 5.6 V behind a divider by 3, where the data sheet has 5 V."""
    kit = replace(NXT, battery=Battery(voltage=volts), wiring=BoardWiring(battery_divider=divider))
    with pytest.raises(SpecMismatch, match=r"at most 5 V"):
        generate(frozen(), ROBOT, kit, "arduino")
    assert generate(frozen(), ROBOT, kit, "nxc")  # which has no such pin


def test_what_the_kit_does_not_say_is_told_as_an_assumption() -> None:
    def table(**wiring: object) -> str:
        return generate(frozen(), ROBOT, counting(EDGES, **wiring), "arduino").wiring

    silent = table()
    assert silent.count("ASSUMED") == 3
    assert f"x4: {EDGES} edges of A and B in a turn" in silent
    assert f"{PULSES} pulses a turn" in silent
    stated = table(driver="one-pin", decoding=2, battery_divider=3.2)
    assert "ASSUMED" not in stated
    assert f"x2: {EDGES} edges of A in a turn" in stated
    assert "22 k to battery +, 10 k to ground" in stated  # (22 + 10) / 10 = 3.2


@pytest.mark.parametrize("edges", [1, 2, 4])
def test_pulses_alone_tell_the_decoding(edges: int) -> None:
    assert sketch_wiring(counting(edges * PULSES, pulses_per_turn=PULSES))["decoding"] == edges


def test_pulses_that_contradict_the_step_are_refused() -> None:
    with pytest.raises(InvalidRobot, match=r"0.00419999 rad; expected 0.00839998 \(x2\) of 374 pulses"):
        sketch_wiring(counting(EDGES, pulses_per_turn=PULSES, decoding=2))
    with pytest.raises(InvalidRobot, match=r"\(x1\) or .* \(x4\) of 500 pulses"):
        sketch_wiring(counting(EDGES, pulses_per_turn=500.0))


def test_encoders_without_a_step_are_refused_rather_than_given_a_degree() -> None:
    sensors = {n: Sensor() if "encoder" in n else s for n, s in NXT.sensors.items()}
    with pytest.raises(SpecMismatch, match=r"no sensors.encoder_left.quantum"):
        generate(frozen(), ROBOT, replace(NXT, sensors=sensors), "arduino")


def test_two_encoders_are_decoded_alike_or_refused() -> None:
    kit = counting(EDGES, pulses_per_turn=PULSES)
    kit.sensors["sensor/encoder_right"] = replace(kit.sensors["sensor/encoder_right"], quantum=math.tau / (2 * PULSES))
    with pytest.raises(InvalidRobot, match=r"encoder_right.*x4.*374 pulses"):
        sketch_wiring(kit)


def test_a_kit_s_file_keeps_its_wiring_and_may_lack_it(tmp_path: Path) -> None:
    kit = counting(EDGES, driver="pwm-enable", pulses_per_turn=PULSES, decoding=4, battery_divider=3.2)
    path = tmp_path / "own.toml"
    path.write_text(kit.to_toml(), "utf-8")
    assert Kit.load(path).wiring == kit.wiring
    assert kit_facts(kit) == kit_facts(replace(kit, wiring=BoardWiring()))  # a certificate holds for either
    assert "wiring" not in replace(kit, wiring=BoardWiring()).to_toml()


@pytest.mark.parametrize(
    ("wiring", "message"),
    [
        ('driver = "L298N"', "one-pin or two-pin or pwm-enable"),
        ('decoding = { value = 3, unit = "1" }', "1, 2 or 4"),
        ('battery_divider = { value = 0.33, unit = "1" }', "its inverse"),
        ('pulses_per_turn = { value = 360, unit = "1" }\ndecoding = { value = 4, unit = "1" }', "of 360 pulses"),
        ('divider = { value = 3, unit = "1" }', "unknown key"),
    ],
)
def test_a_wiring_that_cannot_be_is_one_line(tmp_path: Path, wiring: str, message: str) -> None:
    path = tmp_path / "own.toml"
    path.write_text(NXT.to_toml() + f"\n[wiring]\n{wiring}\n", "utf-8")
    with pytest.raises(InvalidRobot, match=message) as caught:
        Kit.load(path)
    assert "\n" not in str(caught.value)


@SKETCHES
def test_the_command_prints_how_to_wire(tmp_path: Path, capsys: pytest.CaptureFixture[str], driver: str) -> None:
    """Every pin that the sketch names, in lines of a terminal; without a file the table is in the sketch itself."""
    kit = tmp_path / "own.toml"
    kit.write_text(counting(EDGES, driver=driver).to_toml(), "utf-8")
    command = ["firmware", str(GOLDEN / "controller.json"), "--kit", str(kit), "--target", "arduino"]
    assert main([*command, "-o", str(tmp_path / "own.ino")]) == 0
    table = capsys.readouterr().out.split("wrote")[0].splitlines()
    assert max(map(len, table)) <= 80
    text = (tmp_path / "own.ino").read_text("utf-8")
    pins = {line.split()[0] for line in table}
    assert pins >= {str(pin) for pin in DRIVERS[driver]} | {"2", "7", "3", "8", "4", "A0", "A4", "A5", "5V", "GND"}
    assert all(line.split("  ")[-1] in text for line in table)
    assert main([*command, "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["wiring"].splitlines() == table[: len(table)]


def test_a_contradiction_is_told_by_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    kit = tmp_path / "own.toml"
    text = counting(EDGES).to_toml() + '\n[wiring.pulses_per_turn]\nvalue = 748\nunit = "1"\n'
    kit.write_text(text + '\n[wiring.decoding]\nvalue = 4\nunit = "1"\n', "utf-8")
    command = ["firmware", str(GOLDEN / "controller.json"), "--kit", str(kit), "--target", "arduino"]
    assert main(command) == USER_ERROR
    assert "x4) of 748 pulses" in capsys.readouterr().err
