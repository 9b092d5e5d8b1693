"""`upright robots new`: what an owner tells becomes the numbers of two files, and what nobody tells is a guess."""

from __future__ import annotations

import io
import math
import tomllib
from pathlib import Path
from typing import Any

import pytest

from upright.cli.main import main
from upright.errors import InvalidRobot
from upright.robots import Kit, Robot, find_robot
from upright.robots.drives import COMMAND_UNITS, UNUSED
from upright.robots.motor import makes_energy
from upright.robots.owner import Answers, file_numbers, questions
from upright.signals import Log

TOLD = {
    "wheel": "80", "wheel-mass": "40", "body-mass": "900", "track": "160", "com": "70", "height": "180", "depth": "50",
    "gear": "34", "motor-voltage": "12", "no-load": "250", "stall-current": "1.5", "stall-torque": "4", "battery": "11",
    "full-duty": "1023", "driver": "L298N", "encoder": "374", "decoding": "4", "gyro": "500", "accelerometer": "4",
    "fused": "0.49", "mounting": "-2", "divider": "3.2", "loop-period": "5",
}  # fmt: skip


@pytest.fixture(autouse=True)
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


def new(name: str, **told: str) -> int:
    return main(["robots", "new", name, *(f"--{key}={value}" for key, value in told.items())])


def test_every_answer_becomes_its_number() -> None:
    """By hand: a turn of 374 pulses of four edges, 1.5 A at 12 V, 4 kg cm at 9.81 N/kg, ±500 degree/s, …"""
    assert new("mine", **TOLD) == 0
    robot, kit = Robot.load("mine.toml"), Kit.load("mine-kit.toml")
    assert robot.kit == "mine-kit.toml"
    n = pytest.approx
    assert (robot.wheel_radius, robot.wheel_mass, robot.body_mass) == (0.04, 0.04, 0.9)
    assert (robot.track, robot.com_height, robot.body_height, robot.body_depth) == (0.16, 0.07, 0.18, 0.05)
    assert robot.wheel_inertia == n(0.04 * 0.04**2 / 2)
    assert robot.pitch_inertia == n(0.9 * (0.18**2 + 0.05**2) / 12, rel=1e-5)  # six digits
    assert robot.yaw_inertia == n(0.9 * (0.16**2 + 0.05**2) / 12, rel=1e-5)
    assert (robot.gear_ratio, robot.motor_resistance) == (34, 8)
    assert robot.back_emf == n(12 / (250 * 2 * math.pi / 60), rel=1e-5)
    assert 34 * robot.torque_constant * 1.5 == n(0.04 * 9.81, rel=1e-5)
    assert makes_energy(robot) == ""
    assert (kit.battery.voltage, kit.motor.drop, kit.period, kit.wiring.driver) == (11, 1.8, 0.005, "two-pin")
    assert kit.motor.quantum == n(11 / 1023, rel=1e-5)
    assert (kit.wiring.pulses_per_turn, kit.wiring.decoding, kit.wiring.battery_divider) == (374, 4, 3.2)
    left, gyro, up, pitch = (kit.sensors[f"sensor/{name}"] for name in ("encoder_left", "gyro", "accel_up", "pitch"))
    assert left.quantum == n(2 * math.pi / (374 * 4), rel=1e-5)
    assert (gyro.range, gyro.quantum) == (n(math.radians(500), rel=1e-5), n(math.radians(500) / 32768, rel=1e-5))
    assert up.range == n(4 * 9.81)
    assert (pitch.time_constant, pitch.offset) == (0.49, n(math.radians(-2), rel=1e-5))


def numbers(path: str) -> dict[str, dict[str, Any]]:
    def inner(table: dict[str, Any], name: str) -> dict[str, dict[str, Any]]:
        found: dict[str, dict[str, Any]] = {}
        for key, value in table.items():
            if isinstance(value, dict):
                found |= {name + key: value} if "value" in value else inner(value, f"{name}{key}.")
        return found

    return inner(tomllib.loads(Path(path).read_text("utf-8")), "")


def test_what_nobody_tells_is_a_guess_and_each_number_is_explained() -> None:
    assert new("mine", gear="34", encoder="none", battery="11.1") == 0
    assert {k for k, v in numbers("mine.toml").items() if v["spread"] != "guess"} == {"gear_ratio"}
    kit = numbers("mine-kit.toml")
    assert {k for k, v in kit.items() if v["spread"] != "guess"} == {"battery.voltage"}
    assert not any("encoder" in key or key.startswith("wiring.") for key in kit)  # of what the robot lacks
    lines = Path("mine.toml").read_text("utf-8").splitlines() + Path("mine-kit.toml").read_text("utf-8").splitlines()
    tables = [i for i, line in enumerate(lines) if line.startswith("[")]
    assert len(tables) > 20
    assert all(lines[i - 1].startswith("# ") for i in tables)
    assert "# Gear, turns of the motor in one of the wheel: 34" in lines


def test_it_runs_and_is_never_written_over(capsys: pytest.CaptureFixture[str]) -> None:
    assert new("mine") == 0
    assert "guessed" in capsys.readouterr().out
    assert main(["simulate", "--robot", "mine.toml", "--seconds", "2", "-o", "run.csv"]) == 0
    assert Log.load("run.csv").t[-1] > 1.9
    capsys.readouterr()
    before = Path("mine.toml").read_bytes()
    assert new("mine", gear="50") == 2
    assert "exists already" in capsys.readouterr().err
    assert Path("mine.toml").read_bytes() == before


@pytest.mark.parametrize(
    ("told", "word"),
    [
        ({"gear": "x"}, "'x'; expected a number, such as 48 or 48:1"),
        ({"gear": "40:24"}, "expected a number, such as 48 or 48:1"),
        ({"encoder": "0"}, "expected 1 to 1e+06, or none"),
        ({"mounting": "nan", "fused": "0.5"}, "expected a number"),
        ({"mounting": "1"}, "without fused"),
        ({"fused": "0.5", "accelerometer": "none"}, "--fused without accelerometer"),
        ({"driver": "L29N"}, "did you mean 'L298N'"),
        ({"decoding": "3"}, "one of 1, 2, 4"),
        ({"motors": "servo"}, "one of speed, torque, voltage"),
        ({"motors": "speed", "stall-torque": "1"}, "--stall-torque with a speed drive; try: --motors voltage"),
        ({"wheel": "65 g"}, "expected a number in mm, "),
        ({"body-mass": "1,500"}, "expected 1500, or 1.500"),
    ],
)
def test_an_answer_that_cannot_be_is_named_and_nothing_is_written(
    told: dict[str, str], word: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert new("mine", **told) == 2
    assert word in capsys.readouterr().err
    assert list(folder.iterdir()) == []


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ({"wheel": "65 m"}, "10 to 1000 mm; try: did you mean 65 mm?"),
        ({"wheel": "0.065"}, "10 to 1000 mm; try: did you mean 0.065 m?"),
        ({"body-mass": "0.9"}, "did you mean 0.9 kg?"),
        ({"com": "7 m"}, "did you mean 7 cm?"),
        ({"loop-period": "0.01"}, "0.1 to 200 ms; try: did you mean 0.01 s?"),
        ({"battery": "7400"}, "did you mean 7400 mV?"),
        ({"stall-current": "750"}, "did you mean 750 mA?"),
        ({"gyro": "4.36"}, "did you mean 4.36 rad/s?"),
        ({"no-load": "1e999"}, "5 to 5000 rpm"),
        ({"track": "-160"}, "20 to 2000 mm"),
    ],
)
def test_a_size_that_no_robot_has_is_refused_with_the_unit_that_was_meant(
    told: dict[str, str], expected: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert new("mine", **told) == 2
    assert expected in capsys.readouterr().err
    assert list(folder.iterdir()) == []


WRITTEN = [
    ("wheel", "65 mm", "wheel_radius", 0.0325), ("wheel", "6.5 cm", "wheel_radius", 0.0325),
    ("wheel", "6,5cm", "wheel_radius", 0.0325), ("wheel", "0,065 m", "wheel_radius", 0.0325),
    ("wheel", '2.5"', "wheel_radius", 0.03175), ("wheel_mass", "0.04 KG", "wheel_mass", 0.04),
    ("body_mass", "2 lb", "body_mass", 0.9072), ("gear", "1:48", "gear_ratio", 48), ("gear", "48:1", "gear_ratio", 48),
    ("gear", "1/48", "gear_ratio", 48), ("gear", "9,7 : 1", "gear_ratio", 9.7), ("gear", "1:1", "gear_ratio", 1),
    ("battery", "7.4 V", "battery.voltage", 7.4), ("battery", "7400mV", "battery.voltage", 7.4),
    ("loop_period", "20 ms", "period", 0.02), ("loop_period", "0.02 s", "period", 0.02),
    ("loop_period", "2000 µs", "period", 0.002),
    ("gyro", "±250 °/s", "sensors.gyro.range", 4.36332), ("gyro", "250dps", "sensors.gyro.range", 4.36332),
    ("accelerometer", "19.62 m/s^2", "sensors.accel_up.range", 19.62), ("stall_current", "750 mA", "motor_resistance",
    7.4 / 0.75),
]  # fmt: skip
"""Option, what owners write, and the number of the files that it makes, in SI units by hand."""


@pytest.mark.parametrize(("option", "text", "number", "value"), WRITTEN)
def test_a_number_is_taken_as_owners_write_it(option: str, text: str, number: str, value: float) -> None:
    asked = questions("voltage")
    answers = {name: question.usual for name, question in asked.items()} | {option: text}
    asked[option].check(text)
    formula = file_numbers("voltage")[number].formula
    assert callable(formula)
    # scales and data sheets: 9.81 N/kg here, 9.80665 m/s² where a sensor's range is converted
    assert formula(Answers(answers, asked)) == pytest.approx(value, rel=4e-4)


@pytest.mark.parametrize("unit", ["2.55 kg cm", "2.55kg·cm", "2.55 kgf.cm", "0.25 N m", "0.25Nm", "250 mNm", "25 Ncm"])
def test_a_torque_has_the_units_of_data_sheets(unit: str) -> None:
    """2.55 kg cm · 9.81 N/kg = 0.250 N m."""
    asked = questions("speed")["slip_torque"]
    assert asked.number(unit) == pytest.approx(0.25, rel=2e-3)


@pytest.mark.parametrize("drive", COMMAND_UNITS)
def test_every_drive_makes_a_robot_that_stands_and_has_only_its_own_numbers(drive: str) -> None:
    assert new("mine", motors=drive) == 0
    robot = Robot.load("mine.toml")
    assert robot.drive == drive
    assert not set(UNUSED[drive]) & set(numbers("mine.toml"))
    assert main(["simulate", "--robot", "mine.toml", "--seconds", "2", "-o", "run.csv"]) == 0
    assert Log.load("run.csv").t[-1] > 1.9


def test_a_stepper_is_told_by_its_steps_its_speed_and_its_ramp() -> None:
    """By hand: 3200 steps a turn, 2 turns a second; without a ramp the wheels take any step of speed."""
    told = {"steps": "3200", "top-speed": "120 rpm", "ramp": "none", "slip-torque": "25 N cm"}
    assert new("mine", motors="speed", **told) == 0
    robot, kit = Robot.load("mine.toml"), Kit.load("mine-kit.toml")
    assert robot.slip_torque == 0.25
    assert robot.acceleration_limit == Robot.acceleration_limit
    assert kit.motor.limit == pytest.approx(4 * math.pi, rel=1e-5)
    assert kit.sensors["sensor/encoder_left"].quantum == pytest.approx(2 * math.pi / 3200, rel=1e-5)


@pytest.mark.parametrize("name", ["tumbller", "nxtway-gs.toml", "sub/EV3way", "stepper"])
def test_a_name_that_is_a_preset_is_refused_in_a_line(
    name: str, folder: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert new(name) == 2
    error = capsys.readouterr().err.strip()
    assert "comes with upright" in error
    assert "\n" not in error
    assert list(folder.iterdir()) == []


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_at_a_terminal_it_asks_one_question_a_line(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Enter takes the guess; what cannot be is asked again; what hangs on an absent part is not asked."""
    told = {"wheel": "abc\n70", "encoder": "none"}
    asked = ["motors", *(name for name in questions("voltage") if name not in ("gear", "decoding", "mounting"))]
    lines = [told.get(name, "") for name in asked]
    monkeypatch.setattr("sys.stdin", Terminal("\n".join(lines) + "\n"))
    assert new("mine", gear="20") == 0
    said = capsys.readouterr().out
    assert "Wheel with its tyre, across [mm] [65, a guess]: " in said
    assert "expected a number" in said
    assert "Gear" not in said
    robot = Robot.load("mine.toml")
    assert (robot.wheel_radius, robot.gear_ratio) == (0.035, 20)
    assert robot.provenance["wheel_radius"].spread == pytest.approx(0.00035)  # 1 % of a ruler
    assert robot.provenance["body_mass"].spread is None
    monkeypatch.setattr("sys.stdin", Terminal("70\n"))
    assert new("other") == 2
    assert "no more answers" in capsys.readouterr().err


def test_a_robot_whose_file_lies_here_is_named_with_its_ending(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["robots", "new", "mine"]) == 0
    with pytest.raises(InvalidRobot, match=r"try: the file, mine\.toml"):
        find_robot("mine")
