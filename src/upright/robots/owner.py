"""What the owner of a robot is asked, in an owner's terms, and the numbers of its files that come from the answers."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import KW_ONLY, dataclass
from pathlib import Path
from typing import Any

from upright.errors import InvalidRobot, UnknownName
from upright.languages import translated
from upright.reading import parse_toml
from upright.robots import toml
from upright.robots.drives import COMMAND_UNITS
from upright.robots.kit import kit_of, quantity_of
from upright.robots.measures import RATIO, G, meant_unit, number_of, units_like
from upright.robots.robot import PARAMETERS, Robot, robot_of

NONE = "none"
A_GUESS = ", a guess"
DRIVERS = {"L298N": ("two-pin", 1.8), "TB6612": ("two-pin", 0.0), "BTS7960": ("pwm-enable", 0.0), "other": ("", 0.0)}
"""How a sketch drives each chip (`robots.wiring`), and the volts that it keeps: the data sheet's, at part load."""


@dataclass(frozen=True)
class OwnerQuestion:
    """A question in the owner's terms, and its `usual` answer, which is a guess.

    `choices` are all that may be answered. A number without a unit is in `unit`, and one with a unit is of the same
    `quantity`, named by its SI unit; both are "" of a count. It lies `within` what a robot can have that fits between a
    palm and a carrier of people. The answer may be none where the robot `may_lack` the part; then the question that
    `needs` the other's part is not asked.
    """

    text: str
    usual: str
    unit: str = ""
    quantity: str = ""
    within: tuple[float, float] = (0.0, math.inf)
    _: KW_ONLY
    choices: tuple[str, ...] = ()
    may_lack: bool = False
    needs: str = ""

    @property
    def asked(self) -> str:
        """The question with its unit."""
        return f"{self.text} [{self.unit}]" if self.quantity else self.text

    def number(self, answer: str) -> float:
        """The answer in `unit`; raises `InvalidRobot` for none, and for one that no robot can have."""
        lacking = ", or none" * self.may_lack
        try:
            number, unit = number_of(answer, self.unit, self.quantity)
        except InvalidRobot as error:
            raise InvalidRobot(f"{self.asked}: {error}{lacking}") from None
        least, most = self.within
        value = number * units_like(self.unit, self.quantity)[unit]
        if least <= value <= most:
            return value
        behind = f" {self.unit}" if self.quantity else ""
        meant = meant_unit(number, self.unit, self.quantity, least, most)
        raise InvalidRobot(
            f"{self.asked}: '{answer.strip()[:40]}'",
            expected=f"{least:g} to {most:g}{behind}{lacking}",
            hint=f"did you mean {meant}?" if meant else "",
        )

    def check(self, answer: str) -> None:
        """Raise an `UprightError` for an answer that cannot be."""
        answer = plain(answer)
        if self.choices:
            if answer not in self.choices:
                raise UnknownName("choice", answer, self.choices)
        elif not (self.may_lack and answer == NONE):
            self.number(answer)


_BODY = {
    "wheel": OwnerQuestion("Wheel with its tyre, across", "65", "mm", "m", (10, 1000)),
    "wheel_mass": OwnerQuestion("One wheel on the scales", "35", "g", "kg", (1, 20e3)),
    "body_mass": OwnerQuestion("All but the wheels, with battery, on the scales", "700", "g", "kg", (20, 300e3)),
    "track": OwnerQuestion("From the middle of one tyre to that of the other", "150", "mm", "m", (20, 2000)),
    "com": OwnerQuestion(
        "Centre of mass above the axle: wheels off, balance the body on an edge", "50", "mm", "m", (1, 2000)
    ),
    "height": OwnerQuestion("Height of the body", "140", "mm", "m", (10, 3000)),
    "depth": OwnerQuestion("Depth of the body, from front to back", "60", "mm", "m", (5, 2000)),
}
_GEAR = "Gear, turns of the motor in one of the wheel"
_ENCODER = {
    "encoder": OwnerQuestion(
        "Pulses of one encoder channel in a turn of the wheel, the motor's times the gear; or none",
        "330",
        within=(1, 1e6),
        may_lack=True,
    ),
    "decoding": OwnerQuestion(
        "Edges of a pulse that count: 1, 2 (one channel, CHANGE) or 4 (both)",
        "2",
        choices=("1", "2", "4"),
        needs="encoder",
    ),
}
_MOTORS = {
    "voltage": {
        "gear": OwnerQuestion(_GEAR, "30", RATIO, "", (0.1, 2000)),
        "motor_voltage": OwnerQuestion(
            "Voltage at which the next three numbers of the motor hold", "7.4", "V", "V", (1, 100)
        ),
        "no_load": OwnerQuestion("Turns of the lifted wheel a minute", "350", "rpm", "rad/s", (5, 5000)),
        "stall_current": OwnerQuestion("Current of the motor, held", "0.75", "A", "A", (0.02, 500)),
        "stall_torque": OwnerQuestion("Torque of the wheel, held", "0.85", "kg cm", "N m", (0.02, 5000)),
        "battery": OwnerQuestion("Battery in use", "7.4", "V", "V", (1, 100)),
        "full_duty": OwnerQuestion(
            "What the program writes for full duty (analogWrite: 255)", "255", within=(1, 65535)
        ),
        "driver": OwnerQuestion(
            f"Chip that drives the motors ({', '.join(DRIVERS)})", "TB6612", choices=tuple(DRIVERS)
        ),
        **_ENCODER,
        "divider": OwnerQuestion(
            "Battery's voltage over that at the pin that measures it, or none", NONE, RATIO, "", (1, 100), may_lack=True
        ),
    },
    "torque": {
        "gear": OwnerQuestion(_GEAR, "1", RATIO, "", (0.1, 2000)),
        "torque_limit": OwnerQuestion("Largest torque of a motor, before the gear", "0.3", "N m", "N m", (1e-3, 500)),
        **_ENCODER,
    },
    "speed": {
        "gear": OwnerQuestion(_GEAR, "1", RATIO, "", (0.1, 2000)),
        "steps": OwnerQuestion("Microsteps in a turn of the wheel, with the gear", "3200", within=(4, 1e7)),
        "top_speed": OwnerQuestion("Fastest turning of a wheel that is commanded", "190", "rpm", "rad/s", (5, 5000)),
        "ramp": OwnerQuestion(
            "Steepest ramp of a wheel's speed, or none", "200", "rad/s²", "rad/s²", (1, 1e5), may_lack=True
        ),
        "slip_torque": OwnerQuestion(
            "Torque of a wheel that loses steps, about half of what holds the shaft", "0.25", "N m", "N m", (1e-3, 500)
        ),
    },
}
"""Drive → what is asked of the motors."""
DRIVES = tuple(_MOTORS)
DRIVE = OwnerQuestion(
    "Motors get a voltage (PWM), a torque (a current loop), or a speed (steppers)", "voltage", choices=DRIVES
)
_BOARD = {
    "gyro": OwnerQuestion("Range of the gyro", "250", "deg/s", "rad/s", (50, 20e3)),
    "accelerometer": OwnerQuestion("Range of the accelerometer, or none", "2", "g", "m/s²", (1, 400), may_lack=True),
    "fused": OwnerQuestion(
        "Time of the filter that makes an angle of both, of a complementary one αT/(1 − α); or none",
        NONE,
        "s",
        "s",
        (0, 100),
        may_lack=True,
        needs="accelerometer",
    ),
    "mounting": OwnerQuestion(
        "What that angle reads where the robot is balanced", "0", "deg", "rad", (-45, 45), needs="fused"
    ),
    "loop_period": OwnerQuestion("Period of the control loop", "10", "ms", "s", (0.1, 200)),
}


def questions(drive: str) -> dict[str, OwnerQuestion]:
    """What is asked of a robot with this drive, in this order, by the name of its option."""
    return {**_BODY, **_MOTORS[drive], **_BOARD}


class Answers:
    """The answers as numbers, or as the word for a chip, and the names of those that were `read`."""

    def __init__(self, answers: Mapping[str, str], asked: Mapping[str, OwnerQuestion]) -> None:
        self.read: dict[str, str] = {}
        self._answers = answers
        self._asked = asked

    def __getattr__(self, name: str) -> Any:
        self.read[name] = self._answers[name]
        answer = plain(self._answers[name])
        return answer if answer in DRIVERS else math.nan if answer == NONE else self._asked[name].number(answer)


@dataclass(frozen=True)
class FileNumber:
    """A number of a file as a `formula` of the answers, or a guess of ours.

    `error` is the relative spread that usual tools leave, and `why` says what the formula is. A robot without the part
    of a question has no number that is from its answer, or that `needs` it.
    """

    formula: Callable[[Answers], float | str] | float
    error: float = 0.05
    why: str = ""
    needs: str = ""


_COUNT = FileNumber(lambda a: math.tau / (a.encoder * a.decoding), 0.0, "a turn over its counts")
_STEP = FileNumber(lambda a: math.tau / a.steps, 0.0, "a turn over its steps, which are counted")
_ACCEL_RANGE = FileNumber(lambda a: a.accelerometer * G, 0.0)
_ACCEL_STEP = FileNumber(lambda a: a.accelerometer * G / 2**15, 0.0, "16 bits with sign")
_ACCEL_NOISE = FileNumber(0.04, why="of an MPU-6050", needs="accelerometer")
_SHAKEN = FileNumber(0.2, why="steppers shake the board by more than the sensor's own 0.04", needs="accelerometer")

_OF_ALL = {
    "wheel_radius": FileNumber(lambda a: a.wheel / 2000, 0.01, "half of it"),
    "wheel_mass": FileNumber(lambda a: a.wheel_mass / 1000, 0.03),
    "wheel_inertia": FileNumber(lambda a: a.wheel_mass * a.wheel**2 / 8e9, 0.2, "a disc; a ring has twice it"),
    "body_mass": FileNumber(lambda a: a.body_mass / 1000, 0.01),
    "track": FileNumber(lambda a: a.track / 1000, 0.01),
    "com_height": FileNumber(lambda a: a.com / 1000),
    "pitch_inertia": FileNumber(
        lambda a: a.body_mass * (a.height**2 + a.depth**2) / 12e9,
        0.25,
        "a box; swinging it by its axle tells it to 3 %",
    ),
    "yaw_inertia": FileNumber(lambda a: a.body_mass * (a.depth**2 + a.track**2) / 12e9, 0.25, "a box"),
    "roll_inertia": FileNumber(lambda a: a.body_mass * (a.height**2 + a.track**2) / 12e9, 0.25, "a box"),
    "body_height": FileNumber(lambda a: a.height / 1000),
    "body_depth": FileNumber(lambda a: a.depth / 1000),
    "gear_ratio": FileNumber(lambda a: a.gear, 0.0),
    "period": FileNumber(lambda a: a.loop_period / 1000, 0.0),
    "delay": FileNumber(0.002, why="from reading the sensors to the new duty"),
    "sensors.gyro.range": FileNumber(lambda a: math.radians(a.gyro), 0.0),
    "sensors.gyro.quantum": FileNumber(lambda a: math.radians(a.gyro) / 2**15, 0.0, "16 bits with sign"),
    "sensors.gyro.noise": FileNumber(
        0.002, why="of an MPU-6050; measured: the standard deviation of ten still seconds"
    ),
    "sensors.gyro.bias": FileNumber(0.0035, why="0.2 degree/s, what the mean of a still second leaves"),
    "sensors.accel_forward.range": _ACCEL_RANGE,
    "sensors.accel_forward.quantum": _ACCEL_STEP,
    "sensors.accel_forward.noise": _ACCEL_NOISE,
    "sensors.accel_up.range": _ACCEL_RANGE,
    "sensors.accel_up.quantum": _ACCEL_STEP,
    "sensors.accel_up.noise": _ACCEL_NOISE,
    "sensors.pitch.time_constant": FileNumber(lambda a: a.fused, 0.0),
    "sensors.pitch.offset": FileNumber(lambda a: math.radians(a.mounting)),
}
_COUNTED = {
    "sensors.encoder_left.quantum": _COUNT,
    "sensors.encoder_right.quantum": _COUNT,
    "wiring.pulses_per_turn": FileNumber(lambda a: a.encoder, 0.0),
    "wiring.decoding": FileNumber(lambda a: a.decoding, 0.0),
}
_OF_DRIVE: dict[str, dict[str, FileNumber]] = {
    "voltage": {
        "rotor_inertia": FileNumber(5e-7, why="a rotor of 20 g and 7 mm, before the gear"),
        "back_emf": FileNumber(lambda a: a.motor_voltage / (a.no_load * math.tau / 60), 0.1, "voltage over speed"),
        "motor_resistance": FileNumber(lambda a: a.motor_voltage / a.stall_current, 0.1, "voltage over current"),
        "torque_constant": FileNumber(
            lambda a: a.stall_torque * G / 100 / (a.stall_current * a.gear), 0.1, "torque over current, before the gear"
        ),
        "battery.voltage": FileNumber(lambda a: a.battery),
        "motor.quantum": FileNumber(lambda a: a.battery / a.full_duty, why="one step of the duty"),
        "motor.drop": FileNumber(
            lambda a: DRIVERS[a.driver][1], 0.2, "volts that the chip keeps, as its data sheet says"
        ),
        "sensors.battery.quantum": FileNumber(lambda a: a.divider * 5 / 1023, 0.02, "a step of 5 V in 10 bits"),
        "wiring.driver": FileNumber(lambda a: DRIVERS[a.driver][0]),
        **_COUNTED,
        "wiring.battery_divider": FileNumber(lambda a: a.divider, 0.02),
    },
    "torque": {
        "rotor_inertia": FileNumber(1e-5, why="a rotor of 50 g and 20 mm, before the gear"),
        "motor.limit": FileNumber(lambda a: a.torque_limit),
        **_COUNTED,
    },
    "speed": {
        "rotor_inertia": FileNumber(5.4e-6, why="54 g cm², of a NEMA 17 of 40 mm"),
        "speed_lag": FileNumber(0.002, why="a step and a part of the rotor's swing in its field"),
        "acceleration_limit": FileNumber(lambda a: a.ramp, 0.0),
        "slip_torque": FileNumber(lambda a: a.slip_torque, 0.2),
        "motor.limit": FileNumber(lambda a: a.top_speed * math.tau / 60, 0.0),
        "sensors.encoder_left.quantum": _STEP,
        "sensors.encoder_right.quantum": _STEP,
        "sensors.accel_forward.noise": _SHAKEN,
        "sensors.accel_up.noise": _SHAKEN,
    },
}


def file_numbers(drive: str) -> dict[str, FileNumber]:
    """Where the answers go: the numbers of the files of a robot with this drive."""
    return _OF_ALL | _OF_DRIVE[drive]


def plain(answer: str) -> str:
    """An answer without the mark of a guess; "none" also where it is in the chosen language."""
    bare = answer.removesuffix(A_GUESS)
    return NONE if bare == translated(NONE) else bare


def owners_files(path: Path, kit_path: Path, drive: str, answers: Mapping[str, str]) -> tuple[str, str, Robot]:
    """The texts of the files of a robot and its kit, every number under the question that it is from, and the robot.

    Raises `InvalidRobot` for answers that make no robot.
    """
    robot = toml.rows("", {"name": path.stem, "title": "As its owner says.", "drive": drive, "kit": kit_path.name})
    kit = toml.rows("", {"name": path.stem, "drive": drive})
    for number, row in file_numbers(drive).items():
        entry = _entry(number, row, answers, drive)
        if number in PARAMETERS:
            robot += entry
        else:
            kit += entry
    kit_of(parse_toml(kit, str(kit_path), InvalidRobot, "a kit"), str(kit_path))
    made = robot_of(parse_toml(robot, str(path), InvalidRobot, "a robot"), str(path))
    return robot, kit, made


def _entry(number: str, row: FileNumber, answers: Mapping[str, str], drive: str) -> str:
    """The number as its file has it, under the questions that it is from; nothing where the robot lacks the part."""
    asked = questions(drive)
    used = Answers(answers, asked)
    value = row.formula(used) if callable(row.formula) else row.formula
    if NONE in map(plain, (*used.read.values(), answers.get(row.needs, ""))):
        return ""
    comments = [f"{asked[key].asked}: {answer}" for key, answer in used.read.items()] or [f"A guess: {row.why}"]
    if isinstance(value, str):
        table, _, key = number.rpartition(".")
        return f"\n# {comments[0]}" + toml.rows(f"[{table}]", {key: value}) if value else ""
    if number in PARAMETERS:
        unit = PARAMETERS[number][0]
    else:
        units, meaning = quantity_of(number)
        unit = COMMAND_UNITS[drive] if COMMAND_UNITS[drive] in units else units[0]
        comments.insert(0, f"{number}: {meaning}")
    guessed = not used.read or any(answer.endswith(A_GUESS) for answer in used.read.values())
    source = ": ".join(filter(None, ("a guess" if guessed else "as its owner says", row.why)))
    spread = None if guessed else float(f"{row.error * abs(value):.2g}")
    entry = toml.number_text(number, float(f"{value:.6g}"), unit, toml.Provenance(source, spread))
    return "".join(f"\n# {comment}" for comment in comments) + entry
